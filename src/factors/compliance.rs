//! How wheels answer small loads: what all elastic factors are made of.

use super::quotient;
use super::travel::by_rise;
use super::wheel::{camber, toe};
use crate::rig::{Pose, TyreState, Wheel};
use crate::scalar::{Real, Scalar};
use crate::solve::Twist;
use crate::vector::{Vector, add, cross, scale, sub};

/// A stiffness (N/m or N·m/rad) above this is taken to be rigid.
const RIGID: f64 = 1e10;

/// The point of the wheel's body at which a force acts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    Center,
    /// The lowest point of the wheel at the loaded radius.
    Patch,
}

/// A unit load on a wheel, along or about one of the axes of ISO 8855.
#[derive(Clone, Copy)]
pub(super) enum Load {
    Force(usize, At),
    Moment(usize),
}

pub(super) const FORWARD: usize = 0;
pub(super) const LEFT: usize = 1;
pub(super) const UP: usize = 2;

/// Unit vertical forces at the wheel centres.
pub(super) const VERTICAL: Load = Load::Force(UP, At::Center);

/// What the other wheel of an axle is loaded with. A corner has none and is alone.
#[derive(Clone, Copy)]
pub(super) enum Pair {
    /// The same load in space.
    Parallel,
    /// The opposite one.
    Opposed,
}

impl Pair {
    fn sign<S: Scalar>(self) -> S {
        S::from_f64(match self {
            Self::Parallel => 1.0,
            Self::Opposed => -1.0,
        })
    }
}

/// The radius of a wheel (m), less the deflection of its tyre where that is known.
pub(super) fn loaded_radius<S: Scalar>(wheel: &Wheel<S>, tyre: Option<TyreState<S>>) -> S {
    tyre.map_or(wheel.radius, |tyre| wheel.radius - tyre.deflection)
}

/// From the wheel centre to the patch at the loaded radius.
fn arm<S: Scalar>(wheel: &Wheel<S>, tyre: Option<TyreState<S>>) -> Vector<S> {
    let radius = sub(wheel.contact_patch(), wheel.center);
    scale(loaded_radius(wheel, tyre) / wheel.radius, radius)
}

/// The point of a wheel's body at which forces act.
pub(super) fn place<S: Scalar>(wheel: &Wheel<S>, tyre: Option<TyreState<S>>, at: At) -> Vector<S> {
    match at {
        At::Center => wheel.center,
        At::Patch => add(wheel.center, arm(wheel, tyre)),
    }
}

impl Load {
    /// Force and moment at the wheel centre.
    fn wrench<S: Scalar>(self, wheel: &Wheel<S>, tyre: Option<TyreState<S>>) -> [S; 6] {
        let unit = |axis| std::array::from_fn(|k| S::from_f64(f64::from(u8::from(k == axis))));
        let none = [0.0; 3].map(S::from_f64);
        let (force, moment) = match self {
            Self::Force(axis, At::Center) => (unit(axis), none),
            Self::Force(axis, At::Patch) => (unit(axis), cross(arm(wheel, tyre), unit(axis))),
            Self::Moment(axis) => (none, unit(axis)),
        };
        [force[0], force[1], force[2], moment[0], moment[1], moment[2]]
    }
}

/// The motion of a body whose point at `center` has the displacements of a load.
fn motion<S: Scalar>(
    center: Vector<S>,
    [by_own, by_other]: [&[[S; 6]; 6]; 2],
    [own, other]: [[S; 6]; 2],
) -> Twist<S> {
    let row = |i: usize| {
        let zero = S::from_f64(0.0);
        (0..6).fold(zero, |sum, j| sum + by_own[i][j] * own[j] + by_other[i][j] * other[j])
    };
    let (velocity, rotation) = ([row(0), row(1), row(2)], [row(3), row(4), row(5)]);
    Twist { velocity: sub(velocity, cross(rotation, center)), rotation }
}

/// The loads on the own and on the other wheel; the latter is zero for a corner.
fn wrenches<S: Scalar>(pose: &Pose<S>, load: Load, pair: Pair) -> [[S; 6]; 2] {
    let own = load.wrench(&pose.wheel, pose.tyre);
    let other = pose.other.map_or([S::from_f64(0.0); 6], |other| {
        load.wrench(&other.wheel, other.tyre).map(|component| pair.sign::<S>() * component)
    });
    [own, other]
}

/// How the wheel moves under a unit load.
pub(super) fn own<S: Real>(pose: &Pose<S>, load: Load, pair: Pair) -> Option<Twist<S>> {
    let matrix = pose.compliance?;
    let blocks = [&matrix.own, &matrix.across];
    Some(motion(pose.wheel.center, blocks, wrenches(pose, load, pair)))
}

/// How the other wheel moves under the same loads.
pub(super) fn other<S: Real>(pose: &Pose<S>, load: Load, pair: Pair) -> Option<Twist<S>> {
    let (other, [own, across]) = (pose.other?, wrenches(pose, load, pair));
    let matrix = other.compliance?;
    Some(motion(other.wheel.center, [&matrix.own, &matrix.across], [across, own]))
}

/// The motion under vertical forces at the wheel centres, per metre that the wheel centre rises.
pub(super) fn per_rise<S: Real>(pose: &Pose<S>, pair: Pair) -> Option<Twist<S>> {
    by_rise(&own(pose, VERTICAL, pair)?, pose.wheel.center)
}

/// Toe of a moving wheel by time.
pub(super) fn toe_rate<S: Real>(pose: &Pose<S>, twist: &Twist<S>) -> S {
    toe(pose.wheel.moving(twist).spin, pose.side).derivative
}

/// Camber of a moving wheel by time.
pub(super) fn camber_rate<S: Real>(pose: &Pose<S>, twist: &Twist<S>) -> S {
    camber(pose.wheel.moving(twist).spin).derivative
}

/// Caster of an axis that the wheel's body carries, by time: its turn about the axis across the
/// vehicle, the top rearward.
pub(super) fn caster_rate<S: Real>(twist: &Twist<S>) -> S {
    -twist.rotation[1]
}

/// The displacement of a point of the wheel's body along an axis.
pub(super) fn shift<S: Real>(pose: &Pose<S>, twist: &Twist<S>, at: At, axis: usize) -> S {
    twist.at(place(&pose.wheel, pose.tyre, at))[axis]
}

/// The stiffness against which something gives way; `None` where it does not.
pub(super) fn stiffness<S: Real>(compliance: S) -> Option<S> {
    quotient(S::from_f64(1.0), compliance, RIGID)
}

/// The matrix with the axes (x rearward, y right, z up), numbers and signs of Adams/Car, in m, rad, N and N·m.
pub(super) struct Adams<S> {
    own: [[S; 6]; 6],
    across: [[S; 6]; 6],
    sigma: S,
}

impl<S: Real> Adams<S> {
    pub(super) fn of(pose: &Pose<S>) -> Option<Self> {
        const TURNED: [f64; 6] = [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0];
        let turned = |block: &[[S; 6]; 6]| {
            let entry = |i: usize, j: usize| S::from_f64(TURNED[i] * TURNED[j]) * block[i][j];
            std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
        };
        let matrix = pose.compliance?;
        let (own, across) = (turned(&matrix.own), turned(&matrix.across));
        Some(Self { own, across, sigma: pose.sigma() })
    }

    /// The same of the other wheel.
    pub(super) fn of_other(pose: &Pose<S>) -> Option<Self> {
        let compliance = pose.other?.compliance;
        Self::of(&Pose { compliance, side: pose.side.other(), ..*pose })
    }

    /// C(i, j) + C(i, j + 6) of a left wheel, C(i + 6, j) + C(i + 6, j + 6) of a right one.
    pub(super) fn sum(&self, i: usize, j: usize) -> S {
        self.own[i - 1][j - 1] + self.across[i - 1][j - 1]
    }

    /// C(i, j) − C(i, j + 6) of a left wheel, C(i + 6, j) − C(i + 6, j + 6) of a right one: the
    /// left wheel is loaded by one, the right one by minus one.
    pub(super) fn difference(&self, i: usize, j: usize) -> S {
        self.sigma * (self.own[i - 1][j - 1] - self.across[i - 1][j - 1])
    }
}
