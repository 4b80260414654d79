//! Spring and damper, and how fast they move.

use super::definition::{Factor, Subject, formula};
use super::need::Need;
use super::travel::{center_rise, patch_rise};
use super::{NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::{Line, Pose};
use crate::scalar::Real;

/// A line that grows shorter in travel, at a state, at design and by its velocities.
struct Strut<S> {
    now: Line<S>,
    design: Line<S>,
    rates: Option<Line<S>>,
}

fn spring<S: Real>(pose: &Pose<S>) -> Option<Strut<S>> {
    let rates = pose.motions.and_then(|motions| motions.travel.spring);
    Some(Strut { now: pose.spring?, design: pose.design.spring?, rates })
}

fn damper<S: Real>(pose: &Pose<S>) -> Option<Strut<S>> {
    let rates = pose.motions.and_then(|motions| motions.travel.damper);
    Some(Strut { now: pose.damper?, design: pose.design.damper?, rates })
}

impl<S: Real> Strut<S> {
    fn travel(&self) -> S {
        self.now.length() - self.design.length()
    }

    /// How fast it grows shorter in travel.
    fn compression(&self) -> Option<S> {
        Some(-self.now.moving(&self.rates?).length().derivative)
    }
}

fn ratio<S: Real>(numerator: Option<S>, denominator: Option<S>) -> Option<S> {
    quotient(numerator?, denominator?, NEARLY_PARALLEL)
}

const LENGTH: Factor =
    Factor { subject: Subject::Spring, quantity: Quantity::Length, ..Factor::BLANK };

const RATIO: Factor = Factor { quantity: Quantity::Ratio, ..LENGTH };

/// The rows of a spring or a damper, which `$strut` finds.
macro_rules! strut {
    ($name:literal, $motion_ratio:literal, $symbol:literal, $strut:expr, $need:expr, $of:literal) => {
        [
            Factor {
                name: concat!($name, "_length"),
                title: concat!($name, " length"),
                symbol: concat!("L_", $symbol),
                sign: "distance of the ends",
                formula: concat!("distance of the ends of the first ", $name),
                source: "Adams/Car, Lotus",
                value: formula!(|pose| Some($strut(pose)?.now.length())),
                needs: &[$need],
                ..LENGTH
            },
            Factor {
                name: concat!($name, "_travel"),
                title: concat!($name, " travel"),
                symbol: concat!("ΔL_", $symbol),
                sign: "+ longer",
                formula: concat!("L_", $symbol, " − L_", $symbol, " at design"),
                source: "Lotus",
                value: formula!(|pose| Some($strut(pose)?.travel())),
                needs: &[$need],
                ..LENGTH
            },
            Factor {
                name: $motion_ratio,
                title: concat!("motion ratio, ", $name, " by wheel"),
                symbol: concat!("i_", $symbol),
                sign: concat!("+ ", $name, " shortens in jounce"),
                formula: concat!("−dL_", $symbol, " / dW_z"),
                source: "Adams/Car; Milliken, Race Car Vehicle Dynamics, ch. 16",
                value: formula!(|pose| ratio($strut(pose)?.compression(), center_rise(pose))),
                needs: &[Need::Motion, $need],
                ..RATIO
            },
            Factor {
                name: concat!($motion_ratio, "_patch"),
                title: concat!("motion ratio, ", $name, " by patch"),
                symbol: concat!("i_", $symbol, "P"),
                sign: concat!("+ ", $name, " shortens in jounce"),
                formula: concat!("−dL_", $symbol, " / dP_z, P the lowest point"),
                source: "Lotus",
                value: formula!(|pose| ratio($strut(pose)?.compression(), patch_rise(pose))),
                needs: &[Need::Motion, $need],
                ..RATIO
            },
            Factor {
                name: concat!($name, "_ratio"),
                title: concat!($name, " ratio, wheel by ", $name),
                symbol: concat!("1/i_", $symbol),
                sign: concat!("+ ", $name, " shortens in jounce"),
                formula: concat!("−dW_z / dL_", $symbol),
                source: "Adams/Car",
                value: formula!(|pose| ratio(center_rise(pose), $strut(pose)?.compression())),
                needs: &[Need::Motion, $need],
                ..RATIO
            },
            Factor {
                name: concat!($name, "_ratio_patch"),
                title: concat!($name, " ratio, patch by ", $name),
                symbol: concat!("1/i_", $symbol, "P"),
                sign: concat!("+ ", $name, " shortens in jounce"),
                formula: concat!("−dP_z / dL_", $symbol, ", P the lowest point"),
                source: $of,
                value: formula!(|pose| ratio(patch_rise(pose), $strut(pose)?.compression())),
                needs: &[Need::Motion, $need],
                ..RATIO
            },
        ]
    };
}

pub(super) const SPRING: [Factor; 6] =
    strut!("spring", "motion_ratio", "s", spring, Need::Spring, "Lotus (spring ratio)");

pub(super) const DAMPER: [Factor; 6] =
    strut!("damper", "damper_motion_ratio", "d", damper, Need::Damper, "Lotus (damper ratio)");
