//! Roll centres from the compliance: of the lines along which wheels are free to go, and of the forces that
//! the links take up.

use super::compliance::{At, LEFT, Load, Pair, UP, other, own, place};
use super::definition::{Factor, Scope, Subject, formula};
use super::jacking::holding;
use super::need::Need;
use super::roll::{Normal, above, in_model};
use super::{FARTHEST, quotient};
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;
use crate::vector::Vector;

const VERTICAL: Load = Load::Force(UP, At::Patch);

/// The patches of both wheels at the loaded radius.
fn patches<S: Real>(pose: &Pose<S>) -> Option<[Vector<S>; 2]> {
    let other = pose.other?;
    Some([place(&pose.wheel, pose.tyre, At::Patch), place(&other.wheel, other.tyre, At::Patch)])
}

/// Where the lines normal to the ways of both patches under opposed vertical forces meet (y, z), the tyres
/// giving way too or not.
fn center<S: Real>(pose: &Pose<S>, tyres: bool) -> Option<[S; 2]> {
    let [patch, across] = patches(pose)?;
    let mut v = own(pose, VERTICAL, Pair::Opposed)?.at(patch);
    let mut others = other(pose, VERTICAL, Pair::Opposed)?.at(across);
    if tyres {
        let one = S::from_f64(1.0);
        v[2] = v[2] + one / pose.tyre?.rate;
        others[2] = others[2] - one / pose.other?.tyre?.rate;
    }
    // The lengths of the ways do not matter, so they are made of the size of one.
    let normal = |point, way: Vector<S>| {
        let rise = S::from_f64(1.0) / way[2];
        Some(Normal::new(point, way.map(|component| rise * component)))
    };
    normal(patch, v)?.meeting(&normal(across, others)?)
}

fn height<S: Real>(pose: &Pose<S>, tyres: bool) -> Option<S> {
    Some(above(patches(pose)?, center(pose, tyres)?))
}

/// The same of one wheel with the middle of the vehicle.
fn half_height<S: Real>(pose: &Pose<S>) -> Option<S> {
    let patch = place(&pose.wheel, pose.tyre, At::Patch);
    let way = own(pose, VERTICAL, Pair::Opposed)?.at(patch);
    quotient(patch[1] * way[1], way[2], FARTHEST)
}

/// The height at which a lateral force makes the moment of the vertical forces that hold the wheels.
fn force_height<S: Real>(pose: &Pose<S>) -> Option<S> {
    let [own, other] = holding(pose, LEFT, At::Patch)?;
    let moment = place(&pose.wheel, pose.tyre, At::Patch)[1] * own;
    Some(-match patches(pose) {
        Some([_, across]) => S::from_f64(0.5) * (moment + across[1] * other),
        None => moment,
    })
}

const CENTER: Factor = Factor {
    subject: Subject::RollCenter,
    quantity: Quantity::Length,
    scope: Scope::Axle,
    sign: "+ above the line through both patches",
    needs: &[Need::Compliance, Need::BothWheels],
    ..Factor::BLANK
};

const TYRES: Factor = Factor {
    needs: &[Need::Compliance, Need::BothWheels, Need::Tyre],
    source: "Altair 220",
    ..CENTER
};

pub(super) const ELASTIC: &[Factor] = &[
    Factor {
        name: "rc_height_elastic",
        title: "roll-centre height from the compliance",
        symbol: "h_Re",
        sign: "+ above the ground",
        formula: "P_y (CP23 − CP29)/(CP33 − CP39): way of the patch under opposed vertical forces, of one wheel",
        source: "Adams/Car, Altair 220",
        value: formula!(half_height),
        scope: Scope::Wheel,
        needs: &[Need::Compliance],
        ..CENTER
    },
    Factor {
        name: "roll_center_elastic_y",
        title: "roll centre from the compliance across the vehicle",
        symbol: "y_Re",
        sign: "+ along the model's +y",
        formula: "where DY_i (y − y_i) + DZ_i (z − z_i) = 0 of both patches meet, y in the model's axes: DY = CP23 − CP29, DZ = CP33 − CP39 left",
        source: "Adams/Car (roll centre location)",
        value: formula!(|pose| Some(in_model(pose, center(pose, false)?[0]))),
        ..CENTER
    },
    Factor {
        name: "roll_center_elastic_z",
        title: "roll centre from the compliance above the ground",
        symbol: "z_Re",
        formula: "where the same lines meet",
        source: "Adams/Car (roll centre location)",
        value: formula!(|pose| height(pose, false)),
        ..CENTER
    },
    Factor {
        name: "roll_center_total_y",
        title: "roll centre with tyres across the vehicle",
        symbol: "y_Rt",
        sign: "+ along the model's +y",
        formula: "the same with DZ + 1/K_t, y in the model's axes",
        value: formula!(|pose| Some(in_model(pose, center(pose, true)?[0]))),
        ..TYRES
    },
    Factor {
        name: "roll_center_total_z",
        title: "roll centre with tyres above the ground",
        symbol: "z_Rt",
        formula: "the same with DZ + 1/K_t",
        value: formula!(|pose| height(pose, true)),
        ..TYRES
    },
    Factor {
        name: "force_rc_height",
        title: "force-based roll-centre height",
        symbol: "h_RF",
        sign: "+ above the ground",
        formula: "−Σ P_y ΔF_z / Σ F_y of both wheels, F_y equal at both patches, ΔF_z holds the patches at their heights",
        source: "Morse; SAE J670 (roll centre)",
        value: formula!(force_height),
        needs: &[Need::Compliance],
        ..CENTER
    },
];
