//! The axis about which the wheel steers, through its joints or instantaneous.

use super::NEARLY_PARALLEL;
use super::definition::{Definition, Factor, Subject, formula};
use super::need::Need;
use super::quotient;
use super::screw::{Axis, Screw};
use super::wheel::{caster, heading, kingpin, outboard};
use crate::model::Quantity;
use crate::rig::{Motion, Pose};
use crate::scalar::Real;
use crate::vector::{Vector, dot, sub};

/// The axis through two joints.
fn through_joints<S: Real>(pose: &Pose<S>) -> Option<Axis<S>> {
    pose.steer_axis.as_ref().map(Axis::of)
}

/// The screw of the wheel's body when the rack moves and something else is held instead of the driven
/// height. `rate` is how fast that changes in a motion.
fn steered<S: Real>(
    pose: &Pose<S>,
    rate: impl Fn(&Pose<S>, &Motion<S>) -> Option<S>,
) -> Option<Screw<S>> {
    let motions = pose.motions?;
    let (travel, rack) = (motions.travel, motions.rack?);
    let back = quotient(rate(pose, &rack)?, rate(pose, &travel)?, NEARLY_PARALLEL)?;
    Screw::of(&rack.wheel.minus(&travel.wheel.times(back)), pose.wheel.center)
}

fn height_rate<S: Real>(pose: &Pose<S>, motion: &Motion<S>) -> Option<S> {
    Some(motion.wheel.at(pose.wheel.center)[2])
}

/// How fast the spring grows longer in a motion.
pub(super) fn spring_rate<S: Real>(pose: &Pose<S>, motion: &Motion<S>) -> Option<S> {
    Some(pose.spring?.moving(&motion.spring?).length().derivative)
}

fn at_height<S: Real>(pose: &Pose<S>) -> Option<Axis<S>> {
    Some(steered(pose, height_rate)?.axis())
}

fn at_spring_length<S: Real>(pose: &Pose<S>) -> Option<Axis<S>> {
    Some(steered(pose, spring_rate)?.axis())
}

/// The axis on the ground, G, from the contact patch.
fn ground_offset<S: Real>(pose: &Pose<S>, axis: Option<Axis<S>>) -> Option<Vector<S>> {
    let patch = pose.wheel.contact_patch();
    Some(sub(axis?.at_height(patch[2])?, patch))
}

/// The axis at the height of the wheel centre, H, from the wheel centre.
fn center_offset<S: Real>(pose: &Pose<S>, axis: Option<Axis<S>>) -> Option<Vector<S>> {
    let center = pose.wheel.center;
    Some(sub(axis?.at_height(center[2])?, center))
}

/// The axis on the ground in the axes of the model.
fn ground<S: Real>(pose: &Pose<S>, axis: Option<Axis<S>>) -> Option<Vector<S>> {
    let patch = pose.wheel.contact_patch();
    Some(pose.axes.from_iso(axis?.at_height(patch[2])?))
}

/// What Lotus calls castor offset: from the wheel centre forward to the axis on the ground.
fn castor_offset<S: Real>(pose: &Pose<S>, axis: Option<Axis<S>>) -> Option<S> {
    let patch = pose.wheel.contact_patch();
    Some(axis?.at_height(patch[2])?[0] - pose.wheel.center[0])
}

/// What Lotus calls mechanical trail: the castor offset, square to the axis.
fn lotus_trail<S: Real>(pose: &Pose<S>, axis: Option<Axis<S>>) -> Option<S> {
    Some(castor_offset(pose, axis)? * caster(axis?.direction).cos())
}

const BASE: Factor = Factor { quantity: Quantity::Length, ..Factor::BLANK };

/// The factors of one axis: prefix of the names, beginning of the titles, mark of the symbols, the axis,
/// what they share.
macro_rules! of_axis {
    ($prefix:literal, $before:literal, $mark:literal, $axis:ident, $base:expr) => {
        [
            Factor {
                name: concat!($prefix, "caster"),
                title: concat!($before, "caster"),
                symbol: concat!("τ", $mark),
                quantity: Quantity::Angle,
                sign: "+ top rearward",
                formula: "atan2(−k_x, k_z), k the steer axis pointing up",
                source: "Altair, Lotus",
                value: formula!(|pose| Some(caster($axis(pose)?.direction))),
                ..$base
            },
            Factor {
                name: concat!($prefix, "kpi"),
                title: concat!($before, "kingpin inclination"),
                symbol: concat!("σ_k", $mark),
                quantity: Quantity::Angle,
                sign: "+ top inboard",
                formula: "atan2(−σ k_y, k_z)",
                source: "Altair, Lotus",
                value: formula!(|pose| Some(kingpin($axis(pose)?.direction, pose.side))),
                ..$base
            },
            Factor {
                name: concat!($prefix, "axis_ground_x"),
                title: concat!($before, "steer axis on the ground, x"),
                symbol: concat!("G_x", $mark),
                sign: "+ along the model's +x",
                formula: "G, the axis at z = P_z, in the model's axes",
                source: "ISO 8855",
                value: formula!(|pose| Some(ground(pose, $axis(pose))?[0])),
                ..$base
            },
            Factor {
                name: concat!($prefix, "axis_ground_y"),
                title: concat!($before, "steer axis on the ground, y"),
                symbol: concat!("G_y", $mark),
                sign: "+ along the model's +y",
                formula: "G, the axis at z = P_z, in the model's axes",
                source: "ISO 8855",
                value: formula!(|pose| Some(ground(pose, $axis(pose))?[1])),
                ..$base
            },
            Factor {
                name: concat!($prefix, "mechanical_trail"),
                title: concat!($before, "mechanical trail"),
                symbol: concat!("n_τ", $mark),
                sign: "+ axis meets the ground ahead of the patch",
                formula: "(G − P)·e_h",
                source: "ISO 8855; Adams/Car (caster moment arm), Altair",
                value: formula!(|pose| {
                    let heading = heading(pose.wheel.spin, pose.side);
                    Some(dot(ground_offset(pose, $axis(pose))?, heading))
                }),
                lotus: Some(Definition {
                    sign: "+ axis meets the ground ahead of the wheel centre",
                    formula: "(G_x − W_x) cos(caster)",
                    source: "Lotus",
                    value: formula!(|pose| lotus_trail(pose, $axis(pose))),
                }),
                ..$base
            },
            Factor {
                name: concat!($prefix, "scrub_radius"),
                title: concat!($before, "scrub radius"),
                symbol: concat!("r_σ", $mark),
                sign: "+ axis meets the ground inboard of the patch",
                formula: "(P − G)·e_l",
                source: "ISO 8855 (without sign); Adams/Car, Altair",
                value: formula!(|pose| {
                    Some(-dot(ground_offset(pose, $axis(pose))?, outboard(pose.wheel.spin)))
                }),
                ..$base
            },
            Factor {
                name: concat!($prefix, "trail_x"),
                title: concat!($before, "trail along the vehicle"),
                symbol: concat!("n_x", $mark),
                sign: "+ axis meets the ground ahead of the patch",
                formula: "G_x − P_x",
                source: "Altair",
                value: formula!(|pose| Some(ground_offset(pose, $axis(pose))?[0])),
                lotus: Some(Definition {
                    sign: "+ axis meets the ground ahead of the wheel centre",
                    formula: "G_x − W_x",
                    source: "Lotus (castor offset)",
                    value: formula!(|pose| castor_offset(pose, $axis(pose))),
                }),
                ..$base
            },
            Factor {
                name: concat!($prefix, "scrub_y"),
                title: concat!($before, "scrub radius across the vehicle"),
                symbol: concat!("r_y", $mark),
                sign: "+ axis meets the ground inboard of the patch",
                formula: "σ (P_y − G_y)",
                source: "Altair, Lotus",
                value: formula!(|pose| {
                    Some(-(pose.sigma() * ground_offset(pose, $axis(pose))?[1]))
                }),
                ..$base
            },
            Factor {
                name: concat!($prefix, "wheel_center_trail"),
                title: concat!($before, "trail at the wheel centre"),
                symbol: concat!("n_W", $mark),
                sign: "+ axis ahead of the wheel centre",
                formula: "(H − W)·e_h, H the axis at z = W_z",
                source: "ISO 8855",
                value: formula!(|pose| {
                    let heading = heading(pose.wheel.spin, pose.side);
                    Some(dot(center_offset(pose, $axis(pose))?, heading))
                }),
                lotus: Some(Definition {
                    sign: "+ axis behind the wheel centre",
                    formula: "W_x − H_x",
                    source: "Lotus (castor trail at the hub)",
                    value: formula!(|pose| Some(-center_offset(pose, $axis(pose))?[0])),
                }),
                ..$base
            },
            Factor {
                name: concat!($prefix, "kingpin_offset"),
                title: concat!($before, "kingpin offset at the wheel centre"),
                symbol: concat!("r_W", $mark),
                sign: "+ axis inboard of the wheel centre",
                formula: "(W − H)·e_l, H the axis at z = W_z",
                source: "Adams/Car, Altair",
                value: formula!(|pose| {
                    Some(-dot(center_offset(pose, $axis(pose))?, outboard(pose.wheel.spin)))
                }),
                ..$base
            },
        ]
    };
}

pub(super) const THROUGH_JOINTS: [Factor; 10] = of_axis!(
    "",
    "",
    "",
    through_joints,
    Factor { subject: Subject::SteerAxis, needs: &[Need::SteerAxis], ..BASE }
);

const VIRTUAL: Factor =
    Factor { subject: Subject::VirtualAxis, needs: &[Need::Motion, Need::Rack], ..BASE };

const VIRTUAL_SPRING: Factor = Factor {
    subject: Subject::VirtualAxisSpring,
    needs: &[Need::Motion, Need::Rack, Need::Spring],
    ..BASE
};

pub(super) const VIRTUAL_PITCH: Factor = Factor {
    name: "vk_pitch",
    title: "virtual axis: pitch",
    symbol: "p′",
    quantity: Quantity::Pitch,
    sign: "+ right-handed screw",
    formula: "ω·v_W / ω²",
    source: "Ball, Theory of Screws",
    value: formula!(|pose| Some(steered(pose, height_rate)?.pitch)),
    ..VIRTUAL
};

pub(super) const VIRTUAL_SPRING_PITCH: Factor = Factor {
    name: "vks_pitch",
    title: "virtual axis, spring held: pitch",
    symbol: "p″",
    quantity: Quantity::Pitch,
    sign: "+ right-handed screw",
    formula: "ω·v_W / ω²",
    source: "Ball, Theory of Screws",
    value: formula!(|pose| Some(steered(pose, spring_rate)?.pitch)),
    ..VIRTUAL_SPRING
};

pub(super) const AT_HEIGHT: [Factor; 10] =
    of_axis!("vk_", "virtual axis: ", "′", at_height, VIRTUAL);

pub(super) const AT_SPRING_LENGTH: [Factor; 10] =
    of_axis!("vks_", "virtual axis, spring held: ", "″", at_spring_length, VIRTUAL_SPRING);
