//! The working range of an axle: where it ends, where it comes near to a dead centre, and how near its
//! links come to each other.

mod rods;

use super::stage::StageError;
use crate::model::{Model, Setup};
use crate::rig::{Axle, LoadPoint, Warning, Watch};
use crate::solve::Stop;
use rods::Rods;

/// States on each side of the middle.
const STEPS: u32 = 16;

/// A state of the range (m).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Travel of both wheels.
    pub travel: f64,
    /// Displacement of the rack.
    pub rack: f64,
}

/// The fastest joint of a suspension.
#[derive(Clone, Debug, PartialEq)]
pub struct Fastest {
    /// The body that has it.
    pub body: String,
    /// The point.
    pub point: String,
    /// Its speed by that of the height of its wheel.
    pub ratio: f64,
    /// Where.
    pub at: Place,
}

/// How near the middle lines of two links come.
#[derive(Clone, Debug, PartialEq)]
pub struct Clearance {
    /// The links: bodies, rigid links, springs and dampers.
    pub links: [String; 2],
    /// The least distance (m); zero where they cross.
    pub distance: f64,
    /// Whether one passes through the other.
    pub crosses: bool,
    /// Where.
    pub at: Place,
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorkingRange {
    /// States reached.
    pub states: usize,
    /// Where it ends, with the state that was sought.
    pub stops: Vec<(Place, Stop)>,
    /// The fastest joint; near a dead centre it is faster than [`NEARLY_DEAD`](crate::rig::NEARLY_DEAD).
    pub fastest: Option<Fastest>,
    /// Dead centres that wheels came near to or passed.
    pub warnings: Vec<Warning<Place>>,
    /// The links that come nearest to each other, nearest first.
    pub clearances: Vec<Clearance>,
}

impl WorkingRange {
    /// Moves both wheels of a model to `travel` (m) up and down, at each of the racks (m).
    ///
    /// # Errors
    /// [`StageError`] where there is no axle to put on the rig.
    pub fn find(
        model: &Model,
        setup: &Setup,
        travel: f64,
        racks: &[f64],
    ) -> Result<Self, StageError> {
        let mut axle = Axle::with_loads(model, setup, LoadPoint::default())?;
        let mut rods = Rods::of(axle.suspension());
        let mut watch = Watch::default();
        let mut range = Self::default();
        for &rack in racks {
            for direction in [1.0, -1.0] {
                axle.reset();
                watch.restart();
                rods.restart();
                for step in 0..=STEPS {
                    let travel = direction * travel * f64::from(step) / f64::from(STEPS);
                    let at = Place { travel, rack };
                    if let Err(stop) = axle.move_to([travel; 2], rack) {
                        range.stops.push((at, stop));
                        break;
                    }
                    range.states += usize::from(step > 0 || direction > 0.0);
                    range.look(&mut axle, &mut watch, at);
                    rods.look(axle.stand().state(), at);
                }
            }
        }
        range.warnings = watch.warnings();
        range.clearances = rods.clearances();
        Ok(range)
    }

    /// Looks at how fast the joints are.
    fn look(&mut self, axle: &mut Axle, watch: &mut Watch<Place>, at: Place) {
        let poses = axle.poses();
        let mechanism = axle.stand().mechanism();
        watch.look(&poses, mechanism, &at);
        for fastest in poses.iter().filter_map(|pose| pose.motions?.travel.fastest) {
            if self.fastest.as_ref().is_none_or(|known| fastest.ratio > known.ratio) {
                let body = mechanism.bodies()[fastest.body.index()].name.clone();
                let point = mechanism.points()[fastest.point.index()].name.clone();
                self.fastest = Some(Fastest { body, point, ratio: fastest.ratio, at });
            }
        }
    }
}
