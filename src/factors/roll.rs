//! Both wheels of an axle in roll: roll centre, roll steer and camber.

use super::definition::{Factor, Scope, Subject, formula};
use super::need::Need;
use super::travel::per_travel;
use super::wheel::{camber, toe};
use super::{FARTHEST, NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::{OtherWheel, Pose, Wheel};
use crate::scalar::{Dual, Real, Scalar};
use crate::solve::Twist;
use crate::vector::{Vector, sub};

/// A line in front view: the points (y, z) with `across` y + `up` z = `size`.
pub(super) struct Normal<S> {
    across: S,
    up: S,
    size: S,
}

impl<S: Real> Normal<S> {
    /// The normal to the velocity of a point.
    pub(super) fn new(point: Vector<S>, velocity: Vector<S>) -> Self {
        let [_, across, up] = velocity;
        Self { across, up, size: across * point[1] + up * point[2] }
    }

    /// Where two normals meet (y, z).
    pub(super) fn meeting(&self, other: &Self) -> Option<[S; 2]> {
        let determinant = self.across * other.up - other.across * self.up;
        let y = self.size * other.up - other.size * self.up;
        let z = self.across * other.size - other.across * self.size;
        Some([quotient(y, determinant, FARTHEST)?, quotient(z, determinant, FARTHEST)?])
    }
}

/// Where the normals to the velocities of the bodies' points in both patches meet (y, z).
fn roll_center<S: Real>(pose: &Pose<S>) -> Option<[S; 2]> {
    let other = pose.other?;
    let (own, across) = (pose.wheel.contact_patch(), other.wheel.contact_patch());
    let normal = Normal::new(own, per_travel(pose)?.at(own));
    normal.meeting(&Normal::new(across, other.travel?.at(across)))
}

/// The front view is that through the wheel centres at design.
fn roll_center_x<S: Real>(pose: &Pose<S>) -> Option<S> {
    roll_center(pose)?;
    let zero = S::from_f64(0.0);
    let centers = [pose.design.wheel, pose.other?.design].map(|wheel| wheel.center[0]);
    let middle = S::from_f64(0.5) * (centers[0] + centers[1]);
    Some(pose.axes.from_iso([middle, zero, zero])[0])
}

/// The y of a point in the model's axes.
pub(super) fn in_model<S: Real>(pose: &Pose<S>, y: S) -> S {
    let zero = S::from_f64(0.0);
    pose.axes.from_iso([zero, y, zero])[1]
}

/// Height of a point (y, z) above the line through two points.
pub(super) fn above<S: Real>([own, other]: [Vector<S>; 2], [y, z]: [S; 2]) -> S {
    let slope = (other[2] - own[2]) / (other[1] - own[1]);
    z - own[2] - slope * (y - own[1])
}

fn roll_center_height<S: Real>(pose: &Pose<S>) -> Option<S> {
    let patches = [pose.wheel.contact_patch(), pose.other?.wheel.contact_patch()];
    Some(above(patches, roll_center(pose)?))
}

/// A twist of opposite travel: as much more on the own wheel as less on the other.
fn opposed<S: Real>(own: Twist<S>, across: Option<Twist<S>>) -> Twist<S> {
    match across {
        Some(across) => own.minus(&across),
        None => own,
    }
}

/// The wheel, and how fast the line through both patches turns, in opposite travel.
struct Rolling<S> {
    wheel: Wheel<Dual<S>>,
    rate: S,
}

/// Roll is positive with the right side of the body down: the right wheel in jounce.
fn rolling<S: Real>(pose: &Pose<S>) -> Option<Rolling<S>> {
    let (motions, other) = (pose.motions?, pose.other?);
    let wheel = pose.wheel.moving(&opposed(motions.travel.wheel, motions.across));
    // The other wheel moves against it.
    let OtherWheel { wheel: others, travel, across, .. } = other;
    let others = others.moving(&opposed(travel?, across).times(S::from_f64(-1.0)));
    Some(Rolling { wheel, rate: roll_rate(wheel.contact_patch(), others.contact_patch()) })
}

/// How fast the body rolls against the line through the moving patches.
pub(super) fn roll_rate<S: Real>(own: Vector<Dual<S>>, other: Vector<Dual<S>>) -> S {
    let distance = sub(other, own);
    let slope = distance[2] / distance[1];
    -slope.atan2(Dual::from_f64(1.0)).derivative
}

fn per_roll<S: Real>(pose: &Pose<S>, rate: impl Fn(Wheel<Dual<S>>) -> S) -> Option<S> {
    let Rolling { wheel, rate: roll } = rolling(pose)?;
    quotient(rate(wheel), roll, NEARLY_PARALLEL)
}

fn roll_toe<S: Real>(pose: &Pose<S>) -> Option<S> {
    per_roll(pose, |wheel| toe(wheel.spin, pose.side).derivative)
}

fn roll_camber<S: Real>(pose: &Pose<S>) -> Option<S> {
    per_roll(pose, |wheel| camber(wheel.spin).derivative)
}

const CENTER: Factor = Factor {
    subject: Subject::Roll,
    scope: Scope::Axle,
    needs: &[Need::Motion, Need::BothWheels],
    ..Factor::BLANK
};

const SLOPE: Factor = Factor { scope: Scope::Wheel, quantity: Quantity::Ratio, ..CENTER };

pub(super) const ROLL: &[Factor] = &[
    Factor {
        name: "roll_center_x",
        title: "roll centre along the vehicle",
        symbol: "x_R",
        sign: "+ along the model's +x",
        formula: "W_x at design, the mean of both wheels: where the front view is taken",
        source: "Lotus",
        value: formula!(roll_center_x),
        ..CENTER
    },
    Factor {
        name: "roll_center_y",
        title: "roll centre across the vehicle",
        symbol: "y_R",
        sign: "+ along the model's +y",
        formula: "where the normals to v_P of both wheels meet in front view, y in the model's axes",
        source: "Lotus",
        value: formula!(|pose| Some(in_model(pose, roll_center(pose)?[0]))),
        ..CENTER
    },
    Factor {
        name: "roll_center_z",
        title: "roll centre above the ground",
        symbol: "z_R",
        sign: "+ above the line through both patches",
        formula: "where the normals to v_P of both wheels meet in front view",
        source: "Lotus",
        value: formula!(roll_center_height),
        ..CENTER
    },
    Factor {
        name: "roll_steer",
        title: "roll steer",
        symbol: "dδ/dφ",
        sign: "+ to the left, by roll with the right side down",
        formula: "d steer_angle / dφ in opposite travel, φ the angle of the body to the line through both patches",
        source: "ISO 8855, Altair, Adams/Car",
        value: formula!(|pose| Some(-(pose.sigma() * roll_toe(pose)?))),
        ..SLOPE
    },
    Factor {
        name: "roll_camber",
        title: "roll camber against the body",
        symbol: "dγ/dφ",
        sign: "+ top outboard, by roll with the right side down",
        formula: "d camber / dφ in opposite travel, camber against the body",
        source: "Altair, Adams/Car",
        value: formula!(roll_camber),
        ..SLOPE
    },
    Factor {
        name: "roll_camber_ground",
        title: "roll camber against the ground",
        symbol: "dγ_g/dφ",
        sign: "+ top outboard, by roll with the right side down",
        formula: "roll_camber − σ: the body takes the wheel along",
        source: "MathWorks",
        value: formula!(|pose| Some(roll_camber(pose)? - pose.sigma())),
        ..SLOPE
    },
];
