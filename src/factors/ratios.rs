//! The spring and how fast it moves.

use super::definition::{Factor, Subject, formula};
use super::need::Need;
use super::steer_axis::spring_rate;
use super::travel::{center_rise, patch_rise};
use super::{NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;

/// How fast the spring grows shorter in travel.
fn compression<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(-spring_rate(pose, &pose.motions?.travel)?)
}

fn ratio<S: Real>(numerator: Option<S>, denominator: Option<S>) -> Option<S> {
    quotient(numerator?, denominator?, NEARLY_PARALLEL)
}

const LENGTH: Factor = Factor {
    subject: Subject::Spring,
    quantity: Quantity::Length,
    needs: &[Need::Spring],
    ..Factor::BLANK
};

const RATIO: Factor = Factor {
    quantity: Quantity::Ratio,
    sign: "+ spring shortens in jounce",
    needs: &[Need::Motion, Need::Spring],
    ..LENGTH
};

pub(super) const SPRING: &[Factor] = &[
    Factor {
        name: "spring_length",
        title: "spring length",
        symbol: "L_s",
        sign: "distance of the ends",
        formula: "distance of the ends of the first spring",
        source: "Adams/Car, Lotus",
        value: formula!(|pose| Some(pose.spring?.length())),
        ..LENGTH
    },
    Factor {
        name: "spring_travel",
        title: "spring travel",
        symbol: "ΔL_s",
        sign: "+ longer",
        formula: "L_s − L_s at design",
        source: "Lotus",
        value: formula!(|pose| Some(pose.spring?.length() - pose.design.spring?.length())),
        ..LENGTH
    },
    Factor {
        name: "motion_ratio",
        title: "motion ratio, spring by wheel",
        symbol: "i_s",
        formula: "−dL_s / dW_z",
        source: "Adams/Car; Milliken, Race Car Vehicle Dynamics, ch. 16",
        value: formula!(|pose| ratio(compression(pose), center_rise(pose))),
        ..RATIO
    },
    Factor {
        name: "motion_ratio_patch",
        title: "motion ratio, spring by patch",
        symbol: "i_sP",
        formula: "−dL_s / dP_z, P the lowest point",
        source: "Lotus",
        value: formula!(|pose| ratio(compression(pose), patch_rise(pose))),
        ..RATIO
    },
    Factor {
        name: "spring_ratio",
        title: "spring ratio, wheel by spring",
        symbol: "1/i_s",
        formula: "−dW_z / dL_s",
        source: "Adams/Car",
        value: formula!(|pose| ratio(center_rise(pose), compression(pose))),
        ..RATIO
    },
    Factor {
        name: "spring_ratio_patch",
        title: "spring ratio, patch by spring",
        symbol: "1/i_sP",
        formula: "−dP_z / dL_s, P the lowest point",
        source: "Lotus (damper ratio, spring ratio)",
        value: formula!(|pose| ratio(patch_rise(pose), compression(pose))),
        ..RATIO
    },
];
