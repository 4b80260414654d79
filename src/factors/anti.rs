//! Roll centre, and how the suspension takes up braking and driving forces.

use super::definition::{Definition, Factor, Subject, formula};
use super::need::Need;
use super::place::{patch_change, rearward_is_longer};
use super::travel::per_travel;
use super::{FARTHEST, NEARLY_PARALLEL, quotient};
use crate::model::{Axle, Brakes, Quantity};
use crate::rig::Pose;
use crate::scalar::Real;

/// Height of the roll centre above the ground: where the normal to the velocity of the body's point in
/// the patch meets the middle of the vehicle, both wheels at the same travel.
fn roll_center<S: Real>(pose: &Pose<S>) -> Option<S> {
    let patch = pose.wheel.contact_patch();
    let v = per_travel(pose)?.at(patch);
    quotient(patch[1] * v[1], v[2], FARTHEST)
}

/// Height (m) of the static roll centre of an axle in the coordinates of its points, about which its body
/// rolls: P_z + `rc_height`, the mean of both sides; `None` where one of them has none.
pub fn roll_axis(poses: [&Pose<f64>; 2]) -> Option<f64> {
    let [left, right] = poses.map(|pose| Some(pose.wheel.contact_patch()[2] + roll_center(pose)?));
    Some((left? + right?) / 2.0)
}

/// The same from the path of the lowest point.
fn roll_center_by_track<S: Real>(pose: &Pose<S>) -> Option<S> {
    let patch = pose.wheel.moving(&per_travel(pose)?).contact_patch();
    quotient(patch[1].value * patch[1].derivative, patch[2].derivative, FARTHEST)
}

const ROLL: Factor = Factor {
    subject: Subject::RollCenter,
    quantity: Quantity::Length,
    needs: &[Need::Motion],
    ..Factor::BLANK
};

pub(super) const ROLL_CENTER: &[Factor] = &[
    Factor {
        name: "rc_height",
        title: "roll-centre height",
        symbol: "h_R",
        sign: "+ above the ground",
        formula: "P_y v_Py / v_Pz, both wheels at the same travel",
        source: "Lotus",
        value: formula!(roll_center),
        ..ROLL
    },
    Factor {
        name: "rc_height_body",
        title: "roll-centre height above the ground at design",
        symbol: "h_RB",
        sign: "+ above",
        formula: "rc_height + P_z − P_z at design: in the axes of the body",
        source: "Lotus",
        value: formula!(|pose| Some(roll_center(pose)? + patch_change(pose)[2])),
        ..ROLL
    },
    Factor {
        name: "rc_height_track",
        title: "roll-centre height from the track change",
        symbol: "h_Rt",
        sign: "+ above the ground",
        formula: "P_y dP_y / dP_z of the lowest point",
        source: "Reimpell, The Automotive Chassis, ch. 3",
        value: formula!(roll_center_by_track),
        ..ROLL
    },
];

/// Slope of the way of the point at which the force acts, the patch or the wheel centre, positive
/// where the suspension resists the pitch that braking or driving causes.
fn support<S: Real>(pose: &Pose<S>, at_patch: bool) -> Option<S> {
    let at = if at_patch { pose.wheel.contact_patch() } else { pose.wheel.center };
    let v = per_travel(pose)?.at(at);
    Some(-(rearward_is_longer(pose)? * quotient(v[0], v[2], NEARLY_PARALLEL)?))
}

/// Outboard brakes lock the wheel to its body, inboard ones act at the wheel centre like a drive.
fn brake_support<S: Real>(pose: &Pose<S>) -> Option<S> {
    support(pose, pose.vehicle.brakes == Brakes::Outboard)
}

fn drive_support<S: Real>(pose: &Pose<S>) -> Option<S> {
    support(pose, false)
}

/// The part of the load transfer that the suspension takes up: share · L/h · slope.
pub(super) fn compensated<S: Real>(
    pose: &Pose<S>,
    share: Option<f64>,
    slope: Option<S>,
    height: Option<S>,
) -> Option<S> {
    let force = S::from_f64(share? * pose.vehicle.wheelbase?);
    quotient(force * slope?, height?, NEARLY_PARALLEL)
}

pub(super) fn cg_height<S: Real>(pose: &Pose<S>) -> Option<S> {
    pose.vehicle.cg_height.map(S::from_f64)
}

/// Lotus lowers the body with the wheel's bump.
fn cg_height_in_bump<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(cg_height(pose)? - patch_change(pose)[2])
}

fn braking<S: Real>(pose: &Pose<S>) -> Option<S> {
    compensated(pose, pose.vehicle.brake_share, brake_support(pose), cg_height(pose))
}

fn braking_in_bump<S: Real>(pose: &Pose<S>) -> Option<S> {
    compensated(pose, pose.vehicle.brake_share, brake_support(pose), cg_height_in_bump(pose))
}

fn driving<S: Real>(pose: &Pose<S>) -> Option<S> {
    compensated(pose, pose.vehicle.drive_share, drive_support(pose), cg_height(pose))
}

fn driving_in_bump<S: Real>(pose: &Pose<S>) -> Option<S> {
    compensated(pose, pose.vehicle.drive_share, drive_support(pose), cg_height_in_bump(pose))
}

const SLOPE: Factor = Factor {
    subject: Subject::Anti,
    quantity: Quantity::Ratio,
    needs: &[Need::Motion, Need::Axle],
    source: "Lotus; Milliken, Race Car Vehicle Dynamics, ch. 17",
    ..Factor::BLANK
};

const BRAKING: Factor = Factor {
    quantity: Quantity::Percent,
    formula: "100 β tan_brake L / h, h constant",
    value: formula!(braking),
    lotus: Some(Definition {
        sign: "+ less pitch",
        formula: "100 β tan_brake L / (h − bump), bump = P_z − P_z at design",
        source: "Lotus",
        value: formula!(braking_in_bump),
    }),
    sign: "+ less pitch",
    needs: &[Need::Motion, Need::Axle, Need::Wheelbase, Need::CgHeight, Need::BrakeShare],
    ..SLOPE
};

const DRIVING: Factor = Factor {
    formula: "100 κ tan_drive L / h, h constant, differential on the chassis",
    value: formula!(driving),
    lotus: Some(Definition {
        sign: "+ less pitch",
        formula: "100 κ tan_drive L / (h − bump), bump = P_z − P_z at design",
        source: "Lotus",
        value: formula!(driving_in_bump),
    }),
    needs: &[Need::Motion, Need::Axle, Need::Wheelbase, Need::CgHeight, Need::DriveShare],
    ..BRAKING
};

pub(super) const ANTI: &[Factor] = &[
    Factor {
        name: "tan_brake",
        title: "slope of support in braking",
        symbol: "tan φ_b",
        sign: "+ resists pitch",
        formula: "v_Px / v_Pz at the front, −v_Px / v_Pz at the rear; v_W with inboard brakes",
        value: formula!(brake_support),
        ..SLOPE
    },
    Factor {
        name: "tan_drive",
        title: "slope of support in driving",
        symbol: "tan φ_d",
        sign: "+ resists pitch",
        formula: "v_Wx / v_Wz at the front, −v_Wx / v_Wz at the rear",
        value: formula!(drive_support),
        ..SLOPE
    },
    Factor {
        name: "anti_dive",
        title: "anti-dive of a front axle in braking",
        symbol: "AD",
        axle: Some(Axle::Front),
        ..BRAKING
    },
    Factor {
        name: "anti_lift",
        title: "anti-lift of a rear axle in braking",
        symbol: "AL_b",
        axle: Some(Axle::Rear),
        ..BRAKING
    },
    Factor {
        name: "anti_lift_drive",
        title: "anti-lift of a driven front axle",
        symbol: "AL_d",
        axle: Some(Axle::Front),
        ..DRIVING
    },
    Factor {
        name: "anti_squat",
        title: "anti-squat of a driven rear axle",
        symbol: "AS",
        axle: Some(Axle::Rear),
        ..DRIVING
    },
];
