//! What acts on a suspension: force elements, bushings, masses, the tyre.

use crate::mechanism::{BodyId, Force, Law, MassProperties, PointId};

pub use super::parts::TyreContact;

/// A vertical tyre on level ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Tyre {
    /// Where it touches the ground.
    pub contact: TyreContact,
    /// Radius without load (m).
    pub free_radius: f64,
    /// Height of the ground at the design position (m, ISO 8855 axes).
    pub ground: f64,
    /// λ by the height of the lowest point above the ground: −λ is the load (N, m).
    pub law: Law,
}

/// A bushing that stands for a rigid joint, or for a part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct JointBushing {
    /// The joint, by its place in the architecture.
    pub(crate) joint: usize,
    /// The bushing, between the bodies of the joint.
    pub force: Force,
    /// Whether a body that both sides have together has it on each side, such as a mount of the subframe.
    pub(crate) each_side: bool,
}

impl JointBushing {
    /// The section of the file that has it; empty for the only element of a fitting.
    pub(crate) fn section(&self) -> &'static str {
        match &*self.force.name {
            _ if self.each_side => "subframe.mounts",
            "hub_bearing" | "steering_gear" => "",
            _ => "bushings",
        }
    }
}

/// Half of an anti-roll bar: an arm that turns on the chassis about a line along y, and a drop link. A
/// torsion spring joins the arms of both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AntiRollBar {
    /// Torque by the angle between the two arms (N·m/rad).
    pub stiffness: f64,
    /// A point on the axis of the bar.
    pub pivot: PointId,
    /// The ends of the drop link: on the arm, on the body that carries it.
    pub link: [PointId; 2],
    /// The body that carries the drop link, by its number in the architecture.
    pub(crate) link_body: BodyId,
}

/// What acts on a suspension, in SI units and ISO 8855 axes. Bodies and points have the
/// numbers of the architecture and the model, so forces follow points that move.
#[derive(Clone, Debug, Default)]
pub(crate) struct Loads {
    /// Acceleration of gravity (m/s²), downward.
    pub(crate) gravity: f64,
    /// Mass (kg) of the chassis on its slide.
    pub(crate) sprung_mass: Option<f64>,
    /// Masses of the moving bodies, in the order of the architecture.
    pub(crate) masses: Vec<Option<MassProperties>>,
    pub(crate) tyre: Option<Tyre>,
    pub(crate) forces: Vec<Force>,
    pub(crate) bushings: Vec<JointBushing>,
    /// Forces between the two sides of an axle; bodies and points of the other side have the numbers behind
    /// those of this side.
    pub(crate) axle_forces: Vec<Force>,
    pub(crate) anti_roll_bar: Option<AntiRollBar>,
}

impl Loads {
    /// The mass of a moving body.
    pub(crate) fn mass(&self, body: BodyId) -> Option<MassProperties> {
        self.masses.get(body.0.wrapping_sub(1)).copied().flatten()
    }
}
