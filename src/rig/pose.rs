//! Where a wheel, its steer axis and its spring are, and how they move.

use super::line::{Line, Wheel};
use crate::model::{Axes, Side, Vehicle};
use crate::scalar::{Dual, Scalar};
use crate::solve::Twist;
use crate::vector::cross;

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

/// What a state is compared with: the design position, carried along with the chassis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design<S> {
    /// The wheel.
    pub wheel: Wheel<S>,
    /// The spring.
    pub spring: Option<Line<S>>,
}

/// One state of a corner, in ISO 8855 axes (x forward, y left, z up), the chassis fixed or on its
/// slide: all that factors are made of.
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

    /// The corner in a motion that leaves travel and rack as they are, with the rate of the wheel load. How
    /// the motions change is not known in it.
    pub(super) fn moving(&self, motion: &Motion<S>, load_rate: Option<S>) -> Pose<Dual<S>> {
        let still = |value: S| Dual::new(value, S::from_f64(0.0));
        let still_line =
            |line: Line<S>| Line { from: line.from.map(still), to: line.to.map(still) };
        let moving_line = |line: Option<Line<S>>, rates: &Option<Line<S>>| {
            line.zip(rates.as_ref()).map(|(line, rates)| line.moving(rates))
        };
        let turned = |row: usize, column: usize| {
            let turning = cross(motion.wheel.rotation, self.rotation.map(|row| row[column]));
            Dual::new(self.rotation[row][column], turning[row])
        };
        let Design { wheel, spring } = self.design;
        Pose {
            travel: still(self.travel),
            rack: still(self.rack),
            wheel: self.wheel.moving(&motion.wheel),
            rotation: std::array::from_fn(|row| std::array::from_fn(|column| turned(row, column))),
            steer_axis: moving_line(self.steer_axis, &motion.steer_axis),
            spring: moving_line(self.spring, &motion.spring),
            design: Design {
                wheel: Wheel {
                    center: wheel.center.map(still),
                    spin: wheel.spin.map(still),
                    radius: still(wheel.radius),
                },
                spring: spring.map(still_line),
            },
            motions: None,
            load: self
                .load
                .zip(load_rate)
                .map(|(load, rate)| WheelLoad { force: Dual::new(load.force, rate), rate: None }),
            vehicle: self.vehicle,
            side: self.side,
            axes: self.axes,
        }
    }
}
