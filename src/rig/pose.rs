//! Where a wheel, its steer axis and its spring are, and how they move.

use super::line::{Line, Wheel};
use crate::model::{Axes, Side, Vehicle};
use crate::scalar::Scalar;
use crate::solve::Twist;

/// The vertical load of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelLoad<S> {
    /// Vertical force of the ground or the rig on the wheel (N), positive up.
    pub force: S,
    /// The derivative of the force by the travel of a wheel that is held, the wheel rate (N/m).
    pub rate: Option<S>,
}

/// How the parts of a corner move per unit (m) of a driver, relative to the chassis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<S> {
    /// The body of the wheel.
    pub wheel: Twist<S>,
    /// The velocities of the two points of the steer axis.
    pub steer_axis: Option<Line<S>>,
    /// The velocities of the two ends of the spring.
    pub spring: Option<Line<S>>,
}

/// The motions of a corner whose wheel is held at its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motions<S> {
    /// Per metre of the height that is driven, the rack held.
    pub travel: Motion<S>,
    /// Per metre of the rack, the height held; `None` where the suspension does not steer.
    pub rack: Option<Motion<S>>,
}

/// What a state is compared with: the design position, carried up and down with the chassis. Roll does
/// not turn it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design<S> {
    /// The wheel.
    pub wheel: Wheel<S>,
    /// The spring.
    pub spring: Option<Line<S>>,
}

/// One state of a corner, in ISO 8855 axes (x forward, y left, z up) of the ground, the chassis fixed,
/// on its slide or rolled by the rig: all that factors are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<S> {
    /// Change of the height of the wheel (m), positive in jounce; of a chassis that rolls, in its axes.
    pub travel: S,
    /// Displacement of the rack (m), positive along the y axis of the model's own axes; zero
    /// where the suspension does not steer.
    pub rack: S,
    /// The wheel.
    pub wheel: Wheel<S>,
    /// The rotation of the wheel's body from its design position.
    pub rotation: [[S; 3]; 3],
    /// The steer axis through two joints, where the architecture has one.
    pub steer_axis: Option<Line<S>>,
    /// The spring, where the model has one.
    pub spring: Option<Line<S>>,
    /// The design position.
    pub design: Design<S>,
    /// How the corner moves: as the joints allow where they determine the position, else along
    /// states of equilibrium. `None` where the wheel is free, and in a dead centre.
    pub motions: Option<Motions<S>>,
    /// The vertical load of the wheel, where the model has forces.
    pub load: Option<WheelLoad<S>>,
    /// The vehicle.
    pub vehicle: Vehicle,
    /// The side of the vehicle.
    pub side: Side,
    /// The axes of the model, in which coordinates are shown.
    pub axes: Axes,
}

impl<S: Scalar> Pose<S> {
    /// σ: +1 for a left wheel, −1 for a right one, the sign of y outboard.
    pub fn sigma(&self) -> S {
        S::from_f64(self.side.sign())
    }
}
