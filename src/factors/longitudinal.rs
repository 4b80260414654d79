//! How the wheel gives way to braking and driving forces, the same on both wheels.

use super::compliance::{At, FORWARD, Load, Pair, camber_rate, caster_rate, own, shift, toe_rate};
use super::definition::{Factor, Subject, formula};
use super::need::Need;
use crate::model::{Brakes, Quantity};
use crate::rig::Pose;
use crate::scalar::{Real, Scalar};
use crate::solve::Twist;

/// Where the force of braking acts on the body of the wheel, which outboard brakes are locked to.
pub(super) fn brake_point<S: Scalar>(pose: &Pose<S>) -> At {
    match pose.vehicle.brakes {
        Brakes::Outboard => At::Patch,
        Brakes::Inboard => At::Center,
    }
}

/// The motion by a force forward at the wheel centres.
fn driven<S: Real>(pose: &Pose<S>) -> Option<Twist<S>> {
    own(pose, Load::Force(FORWARD, At::Center), Pair::Parallel)
}

/// The motion by a force rearward where brakes make it act.
fn braked<S: Real>(pose: &Pose<S>) -> Option<Twist<S>> {
    let forward = own(pose, Load::Force(FORWARD, brake_point(pose)), Pair::Parallel)?;
    Some(forward.times(S::from_f64(-1.0)))
}

fn forward<S: Real>(pose: &Pose<S>, twist: Option<Twist<S>>, at: At) -> Option<S> {
    Some(shift(pose, &twist?, at, FORWARD))
}

const TURN: Factor = Factor {
    subject: Subject::Longitudinal,
    quantity: Quantity::AngleByForce,
    needs: &[Need::Compliance],
    source: "Altair 120, Adams/Car, Morse",
    ..Factor::BLANK
};

const WAY: Factor =
    Factor { quantity: Quantity::LengthByForce, source: "MathWorks, Altair, Morse", ..TURN };

pub(super) const TRACTION: &[Factor] = &[
    Factor {
        name: "traction_deflection",
        title: "deflection of the wheel centre in traction",
        symbol: "c_x",
        sign: "+ forward by force forward",
        formula: "way of W along the vehicle by F_x at both wheel centres",
        value: formula!(|pose| forward(pose, driven(pose), At::Center)),
        ..WAY
    },
    Factor {
        name: "traction_steer",
        title: "traction steer",
        symbol: "c_δx",
        sign: "+ toe-in by force forward",
        formula: "d toe by F_x at both wheel centres",
        value: formula!(|pose| Some(toe_rate(pose, &driven(pose)?))),
        ..TURN
    },
    Factor {
        name: "traction_camber",
        title: "traction camber",
        symbol: "c_γx",
        sign: "+ top outboard by force forward",
        formula: "d camber by F_x at both wheel centres",
        value: formula!(|pose| Some(camber_rate(pose, &driven(pose)?))),
        ..TURN
    },
    Factor {
        name: "traction_caster",
        title: "traction caster",
        symbol: "c_τx",
        sign: "+ top rearward by force forward",
        formula: "−ω_y by F_x at both wheel centres",
        value: formula!(|pose| Some(caster_rate(&driven(pose)?))),
        ..TURN
    },
];

pub(super) const BRAKING: &[Factor] = &[
    Factor {
        name: "braking_deflection",
        title: "recession of the wheel centre in braking",
        symbol: "c_xb",
        sign: "+ rearward by force rearward",
        formula: "way of W along the vehicle by F_x at both patches, wheels locked to their bodies; at W with inboard brakes",
        value: formula!(|pose| Some(-forward(pose, braked(pose), At::Center)?)),
        ..WAY
    },
    Factor {
        name: "braking_deflection_patch",
        title: "recession of the patch in braking",
        symbol: "c_Pxb",
        sign: "+ rearward by force rearward",
        formula: "way of the body's point in the patch along the vehicle by F_x as for braking_deflection",
        value: formula!(|pose| Some(-forward(pose, braked(pose), At::Patch)?)),
        ..WAY
    },
    Factor {
        name: "braking_steer",
        title: "braking steer",
        symbol: "c_δxb",
        sign: "+ toe-in by force rearward",
        formula: "d toe by F_x as for braking_deflection",
        value: formula!(|pose| Some(toe_rate(pose, &braked(pose)?))),
        ..TURN
    },
    Factor {
        name: "braking_camber",
        title: "braking camber",
        symbol: "c_γxb",
        sign: "+ top outboard by force rearward",
        formula: "d camber by F_x as for braking_deflection",
        value: formula!(|pose| Some(camber_rate(pose, &braked(pose)?))),
        ..TURN
    },
    Factor {
        name: "braking_caster",
        title: "braking caster, wind-up",
        symbol: "c_τxb",
        sign: "+ top rearward by force rearward",
        formula: "−ω_y by F_x as for braking_deflection",
        value: formula!(|pose| Some(caster_rate(&braked(pose)?))),
        ..TURN
    },
];
