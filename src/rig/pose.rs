//! Where a wheel, its steer axis and its spring are, and how they move.

use super::line::{Line, Wheel};
use super::watch::Fastest;
use crate::model::{Axes, Side, Vehicle};
use crate::scalar::{Dual, Scalar};
use crate::solve::Twist;
use crate::solve::compliance::WRENCH;
use crate::vector::cross;

/// The vertical load of a wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelLoad<S> {
    /// Vertical force of the ground or the rig on the wheel (N), positive up.
    pub force: S,
    /// The derivative of the force by the travel of a wheel that is held, the wheel rate (N/m).
    pub rate: Option<S>,
}

/// The tyre of a wheel under its vertical load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TyreState<S> {
    /// Vertical stiffness (N/m).
    pub rate: S,
    /// How far the load presses it in (m).
    pub deflection: S,
}

/// How a wheel gives way to small loads: displacements (m) and rotations (rad) along and about the axes of
/// ISO 8855, row by row, per force (N) and moment (N·m) at the wheel centre. What held the wheel is
/// let go and stays on as a dead load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelCompliance<S> {
    /// Loads on the wheel itself.
    pub own: [[S; 6]; 6],
    /// Loads on the other wheel of the axle; zero for a corner, which is taken to be alone.
    pub across: [[S; 6]; 6],
}

/// What a wheel knows of the other one on its axle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherWheel<S> {
    /// The wheel.
    pub wheel: Wheel<S>,
    /// The wheel at the design position.
    pub design: Wheel<S>,
    /// The motion of its body per unit of its own height that is driven.
    pub travel: Option<Twist<S>>,
    /// The same per unit of the height of the wheel that knows of it.
    pub across: Option<Twist<S>>,
    /// The motion of its body per metre of the rack.
    pub rack: Option<Twist<S>>,
    /// Its vertical load.
    pub load: Option<WheelLoad<S>>,
    /// Its tyre.
    pub tyre: Option<TyreState<S>>,
    /// How it gives way.
    pub compliance: Option<WheelCompliance<S>>,
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
    /// The velocities of the two ends of the damper.
    pub damper: Option<Line<S>>,
    /// The fastest joint of the mechanism, where the driver is the height of the wheel.
    pub fastest: Option<Fastest>,
}

/// The motions of a corner. A free wheel is lifted by a vertical force where its height would be driven,
/// along states of equilibrium; that of another wheel of the axle is held at its height then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motions<S> {
    /// Per metre of the height that is driven, the rack held.
    pub travel: Motion<S>,
    /// Per metre of the rack, the height held; `None` where the suspension does not steer.
    pub rack: Option<Motion<S>>,
    /// The body of the wheel per metre of the height of the other wheel of the axle, the own
    /// height held; `None` for a corner.
    pub across: Option<Twist<S>>,
}

/// What a state is compared with: the design position, carried up and down with the chassis. Roll does
/// not turn it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design<S> {
    /// The wheel.
    pub wheel: Wheel<S>,
    /// The spring.
    pub spring: Option<Line<S>>,
    /// The damper.
    pub damper: Option<Line<S>>,
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
    /// The damper, where the model has one.
    pub damper: Option<Line<S>>,
    /// The design position.
    pub design: Design<S>,
    /// How the corner moves: as the joints allow where they determine the position, else along
    /// states of equilibrium. `None` in a dead centre, where equilibrium is not found, and for a free wheel
    /// under a chassis on its slide, which goes with it.
    pub motions: Option<Motions<S>>,
    /// The vertical load of the wheel, where the model has forces.
    pub load: Option<WheelLoad<S>>,
    /// The tyre, where the model has one and the load is known.
    pub tyre: Option<TyreState<S>>,
    /// How the wheel gives way, where that is measured.
    pub compliance: Option<WheelCompliance<S>>,
    /// The other wheel of an axle.
    pub other: Option<OtherWheel<S>>,
    /// The vehicle.
    pub vehicle: Vehicle,
    /// The side of the vehicle.
    pub side: Side,
    /// The axes of the model, in which coordinates are shown.
    pub axes: Axes,
}

impl<S: Copy> WheelCompliance<S> {
    /// The rows of one of so many wheels of a matrix, row by row, which it has alone or with the other.
    pub(super) fn of_wheel(wheel: usize, wheels: usize, matrix: &[S], zero: S) -> Self {
        let order = WRENCH * wheels;
        let block = |by: usize| {
            let entry = |i, j| matrix[(WRENCH * wheel + i) * order + WRENCH * by + j];
            std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
        };
        let other = (0..wheels).find(|&by| by != wheel);
        Self { own: block(wheel), across: other.map_or([[zero; WRENCH]; WRENCH], block) }
    }
}

impl<S: Scalar> Pose<S> {
    /// What the other wheel of the axle knows of this one.
    pub fn as_other(&self) -> OtherWheel<S> {
        OtherWheel {
            wheel: self.wheel,
            design: self.design.wheel,
            travel: self.motions.map(|motions| motions.travel.wheel),
            across: self.motions.and_then(|motions| motions.across),
            rack: self.motions.and_then(|motions| motions.rack).map(|rack| rack.wheel),
            load: self.load,
            tyre: self.tyre,
            compliance: self.compliance,
        }
    }

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
        let Design { wheel, spring, damper } = self.design;
        Pose {
            travel: still(self.travel),
            rack: still(self.rack),
            wheel: self.wheel.moving(&motion.wheel),
            rotation: std::array::from_fn(|row| std::array::from_fn(|column| turned(row, column))),
            steer_axis: moving_line(self.steer_axis, &motion.steer_axis),
            spring: moving_line(self.spring, &motion.spring),
            damper: moving_line(self.damper, &motion.damper),
            design: Design {
                wheel: Wheel {
                    center: wheel.center.map(still),
                    spin: wheel.spin.map(still),
                    radius: still(wheel.radius),
                },
                spring: spring.map(still_line),
                damper: damper.map(still_line),
            },
            motions: None,
            load: self
                .load
                .zip(load_rate)
                .map(|(load, rate)| WheelLoad { force: Dual::new(load.force, rate), rate: None }),
            tyre: None,
            compliance: None,
            other: None,
            vehicle: self.vehicle,
            side: self.side,
            axes: self.axes,
        }
    }
}
