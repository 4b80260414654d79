//! One event of the programme.

use thiserror::Error;

use crate::factors::roll_axis;
use crate::model::{Chassis, Model, Quantity, Setup};
use crate::rig::{
    Axle, Event, Held, Hold, LoadPoint, RigError, Supports, Sweep, SweepPlan, Vertical,
};
use crate::solve::Stop;

/// What the body of the vehicle does in a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// It stays.
    Fixed,
    /// It rolls about the static roll centre, its height held.
    Rolls,
    /// It rolls, and heaves so that the load of the axle stays.
    RollsUnderLoad,
}

/// One event with its range and with what the rig holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// A word for files.
    pub name: &'static str,
    /// What happens, in words.
    pub title: &'static str,
    /// What changes.
    pub event: Event,
    /// The quantity of the value that changes.
    pub quantity: Quantity,
    /// The values (SI) go from `-range` to `range`.
    pub range: f64,
    /// Distance of the values (SI).
    pub step: f64,
    /// Where loads act.
    pub at: LoadPoint,
    /// What the body does.
    pub body: Body,
    /// Whether the wheels are held by the forces that they have at the beginning, not by their heights.
    pub under_load: bool,
    /// The displacements of the rack (m) at which the event is gone through.
    pub racks: Vec<f64>,
}

/// Why a stage did not begin.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StageError {
    /// The axle cannot be put on the rig.
    #[error(transparent)]
    Rig(#[from] RigError),
    /// The beginning was not reached.
    #[error("the event has not begun: {0}")]
    NotBegun(Box<Stop>),
    /// There is nothing to roll about.
    #[error(
        "the axle has no static roll centre to roll about: it is at infinity, or the wheels do not move; \
         see rc_height of `hardpoint factors`"
    )]
    NoRollCenter,
}

/// What came of a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// What was asked for; of several racks the first.
    pub plan: SweepPlan,
    /// What came of it.
    pub sweep: Sweep,
}

/// A chassis that rolls about the static roll centre of an axle.
///
/// # Errors
/// [`StageError`] where there is no axle or no such point.
pub fn rolling(model: &Model, setup: &Setup, at: LoadPoint) -> Result<Chassis, StageError> {
    let mut axle = Axle::with_loads(model, setup, at)?;
    axle.move_to([0.0; 2], 0.0).map_err(not_begun)?;
    let [left, right] = axle.poses();
    let axis = roll_axis([&left, &right]).ok_or(StageError::NoRollCenter)?;
    Ok(Chassis::Roll { axis })
}

fn not_begun(stop: Stop) -> StageError {
    StageError::NotBegun(Box::new(stop))
}

impl Stage {
    /// The number of states.
    pub fn states(&self) -> usize {
        self.plan(0.0).values().len() * self.racks.len()
    }

    fn plan(&self, rack: f64) -> SweepPlan {
        let held = Held { rack, ..Held::default() };
        SweepPlan { event: self.event, from: -self.range, to: self.range, step: self.step, held }
    }

    /// Goes through the event with both wheels of a model. `measures` says whether the compliance of
    /// every state is found, too; `progress` is told after each state how many are done.
    ///
    /// # Errors
    /// [`StageError`] where the event does not begin; a stop on the way is in the result.
    pub fn run(
        &self,
        model: &Model,
        setup: &Setup,
        measures: bool,
        progress: impl FnMut(usize),
    ) -> Result<Run, StageError> {
        let mut setup = *setup;
        if self.body != Body::Fixed {
            setup.chassis = rolling(model, &setup, self.at)?;
        }
        let mut axle = Axle::with_loads(model, &setup, self.at)?;
        axle.measure_compliance(measures);
        let mut plans = vec![];
        for &rack in &self.racks {
            let mut plan = self.plan(rack);
            if self.under_load || self.body == Body::RollsUnderLoad {
                let supports = Supports::find(&mut axle, &plan.held).map_err(not_begun)?;
                if self.under_load {
                    plan.held.vertical = Vertical::Force(supports.wheels);
                }
                if self.body == Body::RollsUnderLoad {
                    plan.held.heave = Hold::Force(supports.chassis);
                }
                axle.reset();
            }
            let length = model.units.length;
            // Nine digits hide the change of units.
            let shown = (length.from_metres(rack) * 1e9).round() / 1e9;
            plans.push((format!("rack {shown} {}", length.symbol()), plan));
        }
        let sweep = match plans.as_slice() {
            [(_, plan)] => Sweep::run(&mut axle, plan, progress),
            plans => Sweep::grid(&mut axle, plans, progress),
        };
        Ok(Run { plan: plans[0].1, sweep })
    }
}
