//! Where the wheel is, and its load.

use super::Factor;
use super::definition::{Scope, Subject, components, formula};
use super::need::Need;
use super::steering::steering_wheel;
use crate::model::{Axle, Quantity};
use crate::rig::Pose;
use crate::scalar::{Real, Scalar};
use crate::vector::{Vector, sub};

const PLACE: Factor = Factor { subject: Subject::Place, ..Factor::BLANK };

pub(super) const DRIVES: &[Factor] = &[
    Factor {
        name: "travel",
        title: "wheel travel",
        symbol: "u",
        sign: "+ jounce",
        formula: "change of the height that is driven, wheel centre or contact patch, in the axes of the body",
        source: "Adams/Car, Lotus",
        value: formula!(|pose| Some(pose.travel)),
        ..PLACE
    },
    Factor {
        name: "rack",
        title: "rack displacement",
        symbol: "r",
        sign: "+ along the model's +y",
        formula: "displacement from design of the rack, or of the driven end of a soft steering gear",
        source: "Adams/Car",
        value: formula!(|pose| Some(pose.rack)),
        scope: Scope::Axle,
        ..PLACE
    },
    Factor {
        name: "steering_wheel_angle",
        title: "steering-wheel angle",
        symbol: "δ_H",
        quantity: Quantity::Angle,
        sign: "+ to the left",
        formula: "2π r / rack_per_turn",
        source: "ISO 8855",
        value: formula!(|pose| steering_wheel(pose)),
        needs: &[Need::SteeringRatio],
        scope: Scope::Axle,
        ..PLACE
    },
];

fn center<S: Scalar>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(pose.wheel.center)
}

/// The components of the wheel centre; the formula says of each which it is.
pub(super) const WHEEL_CENTER: [Factor; 3] = {
    let mut factors = components!("wheel_center", "wheel centre", "W", center, PLACE);
    factors[0].formula = "W_x in the model's axes";
    factors[0].source = "method paper, Fig. 6";
    factors[1].formula = "W_y in the model's axes";
    factors[1].source = "method paper, Fig. 8";
    factors[2].formula = "W_z in the model's axes";
    factors[2].source = "method paper, Fig. 7";
    factors
};

fn patch<S: Scalar>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(pose.wheel.contact_patch())
}

pub(super) const CONTACT_PATCH: [Factor; 3] = components!(
    "contact_patch",
    "contact patch",
    "P",
    patch,
    Factor {
        formula: "lowest point of the disc of radius R: P = W + R d, d = unit(−e_z + s (s·e_z)), in the model's axes",
        source: "Adams/Car, Lotus",
        ..PLACE
    }
);

/// How far the patch has gone from design.
pub(super) fn patch_change<S: Scalar>(pose: &Pose<S>) -> Vector<S> {
    sub(pose.wheel.contact_patch(), pose.design.wheel.contact_patch())
}

/// −1 at the front axle, +1 at the rear, for lengths that count away from the middle of the vehicle
/// in x.
pub(super) fn rearward_is_longer<S: Real>(pose: &Pose<S>) -> Option<S> {
    pose.vehicle.axle.map(|axle| match axle {
        Axle::Front => S::from_f64(-1.0),
        Axle::Rear => S::from_f64(1.0),
    })
}

pub(super) const CHANGES: &[Factor] = &[
    Factor {
        name: "half_track_change",
        title: "half-track change",
        symbol: "Δt",
        sign: "+ wider",
        formula: "σ (P_y − P_y at design)",
        source: "Lotus",
        value: formula!(|pose| { Some(pose.sigma() * patch_change(pose)[1]) }),
        ..PLACE
    },
    Factor {
        name: "wheelbase_change",
        title: "wheelbase change",
        symbol: "Δl",
        sign: "+ longer",
        formula: "P_x − P_x at design of a front wheel, the opposite of a rear one",
        source: "Lotus",
        value: formula!(|pose| Some(-(rearward_is_longer(pose)? * patch_change(pose)[0]))),
        needs: &[Need::Axle],
        ..PLACE
    },
    Factor {
        name: "recession",
        title: "wheel-centre recession",
        symbol: "Δx_W",
        sign: "+ rearward",
        formula: "W_x at design − W_x",
        source: "MathWorks, Morse",
        value: formula!(|pose| Some(pose.design.wheel.center[0] - pose.wheel.center[0])),
        ..PLACE
    },
];

const FORCES: Factor = Factor { subject: Subject::Load, needs: &[Need::Forces], ..Factor::BLANK };

pub(super) const LOAD: &[Factor] = &[
    Factor {
        name: "wheel_load",
        title: "vertical wheel load",
        symbol: "F_z",
        quantity: Quantity::Force,
        sign: "+ up on the wheel",
        formula: "vertical force of the rig or the ground in static equilibrium",
        source: "Adams/Car",
        value: formula!(|pose| pose.load.map(|load| load.force)),
        ..FORCES
    },
    Factor {
        name: "wheel_rate",
        title: "wheel rate",
        symbol: "k_W",
        quantity: Quantity::Stiffness,
        sign: "+ stiffer in jounce",
        formula: "dF/dz of the vertical force that holds the wheel, by its travel, the other wheel held",
        source: "Adams/Car, Lotus",
        value: formula!(|pose| pose.load.and_then(|load| load.rate)),
        ..FORCES
    },
];
