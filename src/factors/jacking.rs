//! What links take up of forces on the ground, as a test rig with held heights feels it.

use super::compliance::{At, FORWARD, LEFT, Load, Pair, UP, other, own, place};
use super::definition::{Factor, Subject, formula};
use super::longitudinal::brake_point;
use super::need::Need;
use super::place::rearward_is_longer;
use super::{NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;

/// How fast the loaded points of the own and the other wheel rise under a load.
fn rises<S: Real>(pose: &Pose<S>, axis: usize, at: At, pair: Pair) -> Option<[S; 2]> {
    let load = Load::Force(axis, at);
    let rise = own(pose, load, pair)?.at(place(&pose.wheel, pose.tyre, at))[UP];
    let Some(across) = pose.other else { return Some([rise, S::from_f64(0.0)]) };
    let across = other(pose, load, pair)?.at(place(&across.wheel, across.tyre, at))[UP];
    Some([rise, across])
}

/// The vertical forces on the own and on the other wheel that keep the heights of the points at which unit
/// forces along an axis act on both.
pub(super) fn holding<S: Real>(pose: &Pose<S>, axis: usize, at: At) -> Option<[S; 2]> {
    let [a, b] = rises(pose, axis, at, Pair::Parallel)?;
    let [own, across] = rises(pose, UP, at, Pair::Parallel)?;
    if pose.other.is_none() {
        return Some([-quotient(a, own, NEARLY_PARALLEL)?, S::from_f64(0.0)]);
    }
    let [own_opposed, across_opposed] = rises(pose, UP, at, Pair::Opposed)?;
    // The forces are one part that is the same on both wheels and one that is opposed.
    let determinant = own * across_opposed - across * own_opposed;
    let same = quotient(b * own_opposed - a * across_opposed, determinant, NEARLY_PARALLEL)?;
    let opposed = quotient(a * across - b * own, determinant, NEARLY_PARALLEL)?;
    Some([same + opposed, same - opposed])
}

/// The vertical force on the own wheel.
fn jacking<S: Real>(pose: &Pose<S>, axis: usize, at: At) -> Option<S> {
    Some(holding(pose, axis, at)?[0])
}

fn braking<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(-jacking(pose, FORWARD, brake_point(pose))?)
}

fn traction<S: Real>(pose: &Pose<S>) -> Option<S> {
    jacking(pose, FORWARD, At::Center)
}

/// Of a support, the angle.
fn angle<S: Real>(support: S) -> S {
    support.atan2(S::from_f64(1.0))
}

const RATIO: Factor = Factor {
    subject: Subject::Jacking,
    quantity: Quantity::Ratio,
    needs: &[Need::Compliance],
    source: "Morse",
    ..Factor::BLANK
};

const ANGLE: Factor = Factor {
    quantity: Quantity::Angle,
    sign: "+ resists pitch",
    needs: &[Need::Compliance, Need::Axle],
    ..RATIO
};

pub(super) const JACKING: &[Factor] = &[
    Factor {
        name: "jacking_lateral",
        title: "jacking force by lateral force",
        symbol: "j_y",
        sign: "+ pushes the body up by force inboard",
        formula: "ΔF_z / F_y, F_y inboard at the patch and the same in space on the other wheel, ΔF_z holds the patches at their heights",
        value: formula!(|pose| Some(-(pose.sigma() * jacking(pose, LEFT, At::Patch)?))),
        ..RATIO
    },
    Factor {
        name: "jacking_braking",
        title: "jacking force by braking force",
        symbol: "j_b",
        sign: "+ pushes the body up by force rearward",
        formula: "ΔF_z / F_x, F_x rearward at both patches, ΔF_z holds them at their heights; at W with inboard brakes",
        value: formula!(braking),
        ..RATIO
    },
    Factor {
        name: "jacking_traction",
        title: "jacking force by driving force",
        symbol: "j_d",
        sign: "+ pushes the body up by force forward",
        formula: "ΔF_z / F_x, F_x forward at both wheel centres, ΔF_z holds them at their heights",
        value: formula!(traction),
        ..RATIO
    },
    Factor {
        name: "force_brake_angle",
        title: "force-based angle of support in braking",
        symbol: "φ_bF",
        formula: "atan(j_b) at the front, where it is the anti-dive angle, −atan(j_b) at the rear",
        value: formula!(|pose| Some(angle(-(rearward_is_longer(pose)? * braking(pose)?)))),
        ..ANGLE
    },
    Factor {
        name: "force_drive_angle",
        title: "force-based angle of support in driving",
        symbol: "φ_dF",
        formula: "−atan(j_d) at the front, atan(j_d) at the rear, where it is the anti-squat angle",
        value: formula!(|pose| Some(angle(rearward_is_longer(pose)? * traction(pose)?))),
        ..ANGLE
    },
];
