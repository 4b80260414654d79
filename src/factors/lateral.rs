//! How the wheel gives way to lateral forces and aligning torques.
//!
//! Both are counted as they act on the outer wheel of a turn or against it, so that both sides of a
//! symmetric axle have the same numbers: the force inboard, the torque towards toe-in.

use super::compliance::{Adams, At, LEFT, Load, Pair, UP, camber_rate, own, shift, toe_rate};
use super::definition::{Definition, Factor, Subject, formula};
use super::need::Need;
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;

const FORCE: Load = Load::Force(LEFT, At::Patch);
const TORQUE: Load = Load::Moment(UP);

/// How far a point of the wheel goes with the force.
fn deflection<S: Real>(pose: &Pose<S>, at: At, pair: Pair) -> Option<S> {
    Some(shift(pose, &own(pose, FORCE, pair)?, at, LEFT))
}

/// A force to the left goes outboard on the left wheel, and a torque about z turns it out.
fn steer<S: Real>(pose: &Pose<S>, load: Load, pair: Pair) -> Option<S> {
    Some(-(pose.sigma() * toe_rate(pose, &own(pose, load, pair)?)))
}

fn lean<S: Real>(pose: &Pose<S>, load: Load, pair: Pair) -> Option<S> {
    Some(-(pose.sigma() * camber_rate(pose, &own(pose, load, pair)?)))
}

const LATERAL: Factor = Factor {
    subject: Subject::Lateral,
    quantity: Quantity::AngleByForce,
    needs: &[Need::Compliance],
    ..Factor::BLANK
};

const BOTH: &[Need] = &[Need::Compliance, Need::BothWheels];

/// A factor under parallel loads, with Adams' definition where that differs, and under opposed ones.
macro_rules! in_both_ways {
    (
        $name:literal, $title:literal, $symbol:literal, $sign:literal, $formula:literal,
        $source:literal, $adams:expr, $value:expr, $base:expr
    ) => {
        [
            Factor {
                name: $name,
                title: concat!($title, ", parallel"),
                symbol: $symbol,
                sign: $sign,
                formula: concat!($formula, ", the same in space on the other wheel"),
                source: $source,
                value: formula!(|pose| $value(pose, Pair::Parallel)),
                adams: $adams,
                ..$base
            },
            Factor {
                name: concat!($name, "_opposed"),
                title: concat!($title, ", opposed"),
                symbol: concat!($symbol, "_o"),
                sign: $sign,
                formula: concat!($formula, ", its mirror image on the other wheel"),
                source: $source,
                value: formula!(|pose| pose.other.and_then(|_| $value(pose, Pair::Opposed))),
                needs: BOTH,
                ..$base
            },
        ]
    };
}

pub(super) const DEFLECTION: [Factor; 2] = in_both_ways!(
    "lateral_force_deflection",
    "lateral force deflection of the wheel centre",
    "c_y",
    "+ inboard by force inboard",
    "way of W across the vehicle by F_y at the patch",
    "Altair 70, Adams/Car",
    None,
    |pose, pair| deflection(pose, At::Center, pair),
    Factor { quantity: Quantity::LengthByForce, ..LATERAL }
);

pub(super) const PATCH_DEFLECTION: [Factor; 2] = in_both_ways!(
    "lateral_force_deflection_patch",
    "lateral force deflection of the patch",
    "c_Py",
    "+ inboard by force inboard",
    "way of the body's point in the patch across the vehicle by F_y at the patch, without the tyre",
    "MathWorks, Morse",
    None,
    |pose, pair| deflection(pose, At::Patch, pair),
    Factor { quantity: Quantity::LengthByForce, ..LATERAL }
);

pub(super) const STEER: [Factor; 2] = in_both_ways!(
    "lateral_force_steer",
    "lateral force steer",
    "c_δy",
    "+ toe-in by force inboard",
    "d toe by F_y at the patch",
    "Altair 80, Adams/Car",
    None,
    |pose, pair| steer(pose, FORCE, pair),
    LATERAL
);

pub(super) const CAMBER: [Factor; 2] = in_both_ways!(
    "lateral_force_camber",
    "lateral force camber",
    "c_γy",
    "+ top outboard by force inboard",
    "d camber by F_y at the patch",
    "Altair 90, Adams/Car",
    None,
    |pose, pair| lean(pose, FORCE, pair),
    LATERAL
);

pub(super) const TORQUE_STEER: [Factor; 2] = in_both_ways!(
    "aligning_torque_steer",
    "aligning torque steer",
    "c_δM",
    "+ toe-in by torque towards toe-in",
    "d toe by M_z, the rack held",
    "Altair 100, Adams/Car, MathWorks",
    Some(Definition {
        sign: "+ to the left by torque to the left",
        formula: "C66 + C6,12 left, C12,6 + C12,12 right",
        source: "Adams/Car (alt_steer_compliance)",
        value: formula!(|pose| Some(Adams::of(pose)?.sum(6, 6))),
    }),
    |pose, pair| steer(pose, TORQUE, pair),
    Factor { quantity: Quantity::AngleByTorque, ..LATERAL }
);

pub(super) const TORQUE_CAMBER: [Factor; 2] = in_both_ways!(
    "aligning_torque_camber",
    "aligning torque camber",
    "c_γM",
    "+ top outboard by torque towards toe-in",
    "d camber by M_z, the rack held",
    "Altair 110, Adams/Car",
    Some(Definition {
        sign: "+ top outboard by torque to the left",
        formula: "C46 + C4,12 left, −(C10,6 + C10,12) right; Adams' help lacks the bracket of the right one",
        source: "Adams/Car (alt_camber_compliance)",
        value: formula!(|pose| Some(pose.sigma() * Adams::of(pose)?.sum(4, 6))),
    }),
    |pose, pair| lean(pose, TORQUE, pair),
    Factor { quantity: Quantity::AngleByTorque, ..LATERAL }
);
