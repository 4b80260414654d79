//! Where a wheel and its steer axis are.

use crate::model::{Axes, Side};
use crate::scalar::Scalar;
use crate::vector::{Vector, add, dot, scale, sub, unit};

/// A straight line through two points, such as a steer axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axle<S> {
    /// The lower point (m).
    pub lower: Vector<S>,
    /// The upper point (m).
    pub upper: Vector<S>,
}

impl<S: Scalar> Axle<S> {
    /// The unit vector from the lower to the upper point.
    pub fn direction(&self) -> Vector<S> {
        unit(sub(self.upper, self.lower))
    }
}

/// A wheel: a disc normal to its spin axis, in ISO 8855 axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel<S> {
    /// Wheel centre W (m).
    pub center: Vector<S>,
    /// Unit spin axis s, pointing outboard.
    pub spin: Vector<S>,
    /// Rolling radius R (m).
    pub radius: S,
}

impl<S: Scalar> Wheel<S> {
    /// The contact patch P (m): the lowest point of the disc,
    /// P = W + R d/|d|, d = −e_z + s (s·e_z).
    pub fn contact_patch(&self) -> Vector<S> {
        let vertical = [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(1.0)];
        let down = sub(scale(dot(self.spin, vertical), self.spin), vertical);
        add(self.center, scale(self.radius, unit(down)))
    }
}

/// The vertical load of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelLoad<S> {
    /// Vertical force of the ground or the rig on the wheel (N), positive up.
    pub force: S,
    /// The derivative of the force by the travel of a wheel that is held, the wheel rate (N/m).
    pub rate: Option<S>,
}

/// One state of a corner, in ISO 8855 axes (x forward, y left, z up), the chassis fixed or on its slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<S> {
    /// Change of the height of the wheel (m), positive in jounce.
    pub travel: S,
    /// Displacement of the rack (m), positive along the y axis of the model's own axes; zero
    /// where the suspension does not steer.
    pub rack: S,
    /// The wheel.
    pub wheel: Wheel<S>,
    /// The rotation of the wheel's body from its design position.
    pub rotation: [[S; 3]; 3],
    /// The steer axis through two joints, where the architecture has one.
    pub steer_axis: Option<Axle<S>>,
    /// The vertical load of the wheel, where the model has forces.
    pub load: Option<WheelLoad<S>>,
    /// The side of the vehicle.
    pub side: Side,
    /// The axes of the model, in which coordinates are shown.
    pub axes: Axes,
}
