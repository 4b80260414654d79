//! What of a suspension can be set, and the static state that it is set to.

mod read;
mod read_static;
mod statics;

use super::Model;
use crate::mechanism::{
    self, BodyId, Direction, DriverId, Force, Mechanism, MechanismError, Owner, PointId,
};

pub(super) use read::AdjustersFile;
pub use statics::{STATIC_FACTORS, StaticState, StaticTarget};

/// A dimension that the workshop sets: a shim, the length of a rod, the seat of a spring. All are zero
/// where the suspension is as its hard points say.
#[derive(Clone, Debug, PartialEq)]
pub struct Adjuster {
    /// The name that messages use.
    pub name: String,
    /// What it changes, in words.
    pub title: String,
    /// What a positive value means.
    pub sign: String,
    /// The value (m) from which the static state is sought, or that it keeps where no target asks for it.
    pub setting: f64,
    /// The least and the largest value (m).
    pub limits: [f64; 2],
    pub(crate) change: Change,
}

/// What an adjuster changes, in the numbers of the architecture and the model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Change {
    /// The places of joints on one of their bodies, along a direction fixed in it.
    Place { joints: Vec<(usize, End)>, along: Direction },
    /// The length of a link.
    Link { joint: usize },
    /// The free length of a spring, by its place among the forces of the model.
    FreeLength { force: usize },
}

/// One of the two bodies of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// Body *i*.
    I,
    /// Body *j*.
    J,
}

impl End {
    fn of(self, i: BodyId, j: BodyId) -> BodyId {
        match self {
            Self::I => i,
            Self::J => j,
        }
    }
}

/// How the mechanism calls what the model has: names, and the numbers of points and bodies.
pub(super) struct InMechanism<'a> {
    pub(super) name: &'a dyn Fn(&str) -> String,
    pub(super) body: &'a dyn Fn(BodyId) -> BodyId,
    pub(super) point: &'a dyn Fn(PointId) -> PointId,
    /// Whether joints are rigid, whatever bushings stand for them.
    pub(super) kinematic: bool,
}

impl Model {
    /// What of the suspension can be set.
    pub fn adjusters(&self) -> &[Adjuster] {
        &self.adjusters
    }

    /// The static state.
    pub fn static_state(&self) -> &StaticState {
        &self.static_state
    }

    /// Whether the suspension is set otherwise than its hard points say, or may be.
    pub fn is_adjusted(&self) -> bool {
        let StaticState { ride_height, targets } = &self.static_state;
        let set = self.adjusters.iter().any(|adjuster| adjuster.setting != 0.0);
        set || *ride_height != 0.0 || !targets.is_empty()
    }

    /// Adds the adjusters, in their order, to a mechanism that has the joints and forces already.
    pub(super) fn add_adjusters(
        &self,
        mechanism: &mut Mechanism,
        known: &InMechanism,
    ) -> Result<Vec<DriverId>, MechanismError> {
        let add = |adjuster: &Adjuster| {
            let change = match &adjuster.change {
                Change::Place { joints, along } => mechanism::Adjuster::Place {
                    of: self.places(mechanism, joints, known),
                    along: along.on_points(known.point),
                },
                Change::Link { joint } => {
                    let name = (known.name)(&self.architecture.joints[*joint].name);
                    let of = joint_named(mechanism, &name);
                    mechanism::Adjuster::Length { of: of.expect("the links are there") }
                }
                Change::FreeLength { force } => {
                    let name = (known.name)(&self.loads.forces[*force].name);
                    let force = mechanism.force_named(&name).expect("the forces are there");
                    mechanism::Adjuster::Length { of: Owner::Force(force) }
                }
            };
            mechanism.add_adjuster(&(known.name)(&adjuster.name), change)
        };
        self.adjusters.iter().map(add).collect()
    }

    /// Joints, or the bushings that stand for them, with the body on which their place moves.
    fn places(
        &self,
        mechanism: &Mechanism,
        joints: &[(usize, End)],
        known: &InMechanism,
    ) -> Vec<(Owner, BodyId)> {
        let mut places = vec![];
        for &(index, end) in joints {
            let joint = &self.architecture.joints[index];
            let body = (known.body)(end.of(joint.i, joint.j));
            let bushings = self.loads.bushings.iter().filter(|bushing| bushing.joint == index);
            let forces: Vec<&Force> = bushings.map(|bushing| &bushing.force).collect();
            if known.kinematic || forces.is_empty() {
                let joint = joint_named(mechanism, &(known.name)(&joint.name));
                places.extend(joint.map(|joint| (joint, body)));
                continue;
            }
            for force in forces {
                let force = mechanism.force_named(&(known.name)(&force.name));
                places.extend(force.map(|force| (Owner::Force(force), body)));
            }
        }
        places
    }
}

fn joint_named(mechanism: &Mechanism, name: &str) -> Option<Owner> {
    mechanism.joints().iter().position(|joint| joint.name == name).map(Owner::Joint)
}
