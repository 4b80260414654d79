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
struct Normal<S> {
    across: S,
    up: S,
    size: S,
}

/// The normal to the velocity of the body's point in the patch.
fn normal<S: Real>(patch: Vector<S>, velocity: Vector<S>) -> Normal<S> {
    let [_, across, up] = velocity;
    Normal { across, up, size: across * patch[1] + up * patch[2] }
}

/// Where the normals of both wheels meet (y, z) in ISO axes (m).
fn roll_center<S: Real>(pose: &Pose<S>) -> Option<[S; 2]> {
    let other = pose.other?;
    let patch = pose.wheel.contact_patch();
    let own = normal(patch, per_travel(pose)?.at(patch));
    let across = other.wheel.contact_patch();
    let others = normal(across, other.travel?.at(across));
    let determinant = own.across * others.up - others.across * own.up;
    let y = quotient(own.size * others.up - others.size * own.up, determinant, FARTHEST)?;
    let z = quotient(own.across * others.size - others.across * own.size, determinant, FARTHEST)?;
    Some([y, z])
}

fn roll_center_y<S: Real>(pose: &Pose<S>) -> Option<S> {
    let zero = S::from_f64(0.0);
    Some(pose.axes.from_iso([zero, roll_center(pose)?[0], zero])[1])
}

/// Height of the roll centre above the line through both patches.
fn roll_center_height<S: Real>(pose: &Pose<S>) -> Option<S> {
    let [y, z] = roll_center(pose)?;
    let (own, other) = (pose.wheel.contact_patch(), pose.other?.wheel.contact_patch());
    let slope = (other[2] - own[2]) / (other[1] - own[1]);
    Some(z - own[2] - slope * (y - own[1]))
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
    let distance = sub(others.contact_patch(), wheel.contact_patch());
    let slope = distance[2] / distance[1];
    let roll = slope.atan2(Dual::from_f64(1.0));
    // The body turns against the line through the patches.
    Some(Rolling { wheel, rate: -roll.derivative })
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
        name: "roll_center_y",
        title: "roll centre across the vehicle",
        symbol: "y_R",
        sign: "+ along the model's +y",
        formula: "where the normals to v_P of both wheels meet in front view, y in the model's axes",
        source: "Lotus",
        value: formula!(roll_center_y),
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
