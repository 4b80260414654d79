//! Stiffnesses of wheel, ride and roll, from the compliance.

use std::f64::consts::TAU;

use super::compliance::{
    At, FORWARD, LEFT, Load, Pair, UP, VERTICAL, loaded_radius, other, own, shift, stiffness,
};
use super::definition::{Factor, Scope, Subject, formula};
use super::need::Need;
use super::steering::track;
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;

/// How far the wheel centre rises under unit vertical forces.
fn rise<S: Real>(pose: &Pose<S>, pair: Pair) -> Option<S> {
    Some(shift(pose, &own(pose, VERTICAL, pair)?, At::Center, UP))
}

fn wheel_rate<S: Real>(pose: &Pose<S>, pair: Pair) -> Option<S> {
    stiffness(rise(pose, pair)?)
}

fn ride_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    stiffness(rise(pose, Pair::Parallel)? + S::from_f64(1.0) / pose.tyre?.rate)
}

fn hop_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(wheel_rate(pose, Pair::Parallel)? + pose.tyre?.rate)
}

/// √(k/m)/2π; `None` where the wheel would run away.
fn frequency<S: Real>(rate: Option<S>, mass: Option<f64>) -> Option<S> {
    let square = rate? / S::from_f64(mass?);
    (square.value() > 0.0).then(|| square.sqrt() / S::from_f64(TAU))
}

/// How far the wheel centres go apart in height under opposed unit vertical forces.
fn apart<S: Real>(pose: &Pose<S>) -> Option<S> {
    let others = other(pose, VERTICAL, Pair::Opposed)?.at(pose.other?.wheel.center);
    Some(rise(pose, Pair::Opposed)? - others[2])
}

/// The moment T by the angle apart/T.
fn roll_rate<S: Real>(pose: &Pose<S>, apart: S) -> Option<S> {
    let track = track(pose)?;
    Some(track * track * stiffness(apart)?)
}

fn tyres<S: Real>(pose: &Pose<S>) -> Option<S> {
    let one = S::from_f64(1.0);
    Some(one / pose.tyre?.rate + one / pose.other?.tyre?.rate)
}

/// What the suspension has more in roll than wheels with their rates of parallel travel.
fn roll_bar_rate<S: Real>(pose: &Pose<S>) -> Option<S> {
    let others = other(pose, VERTICAL, Pair::Parallel)?.at(pose.other?.wheel.center);
    let rates = wheel_rate(pose, Pair::Parallel)? + stiffness(others[2])?;
    let track = track(pose)?;
    let alone = S::from_f64(0.25) * track * track * rates;
    Some(roll_rate(pose, apart(pose)?)? - alone)
}

/// The stiffness of the wheel against a force, at the point where it acts.
fn linear<S: Real>(pose: &Pose<S>, axis: usize, at: At) -> Option<S> {
    stiffness(shift(pose, &own(pose, Load::Force(axis, at), Pair::Parallel)?, at, axis))
}

/// The stiffness of the wheel against a moment.
fn angular<S: Real>(pose: &Pose<S>, axis: usize) -> Option<S> {
    stiffness(own(pose, Load::Moment(axis), Pair::Parallel)?.rotation[axis])
}

const RATE: Factor = Factor {
    subject: Subject::Rates,
    quantity: Quantity::Stiffness,
    sign: "+ stiffer in jounce",
    needs: &[Need::Compliance],
    ..Factor::BLANK
};

const TYRE: Factor = Factor { needs: &[Need::Compliance, Need::Tyre], ..RATE };

pub(super) const VERTICAL_RATES: &[Factor] = &[
    Factor {
        name: "wheel_rate_parallel",
        title: "wheel rate, both wheels together",
        symbol: "K_W",
        formula: "1/(C33 + C39): equal vertical forces on both wheels; wheel_rate holds the other wheel",
        source: "Adams/Car (wheel rate), Altair 210 and 50",
        value: formula!(|pose| wheel_rate(pose, Pair::Parallel)),
        ..RATE
    },
    Factor {
        name: "wheel_rate_opposed",
        title: "wheel rate, wheels against each other",
        symbol: "K_Wo",
        formula: "1/(C33 − C39): opposed vertical forces, with the anti-roll bar",
        source: "Milliken, Race Car Vehicle Dynamics, ch. 16",
        value: formula!(|pose| pose.other.and_then(|_| wheel_rate(pose, Pair::Opposed))),
        needs: &[Need::Compliance, Need::BothWheels],
        ..RATE
    },
    Factor {
        name: "tyre_rate",
        title: "tyre rate",
        symbol: "K_t",
        sign: "+ stiffer when pressed in",
        formula: "vertical stiffness of [tyre] at its load",
        source: "Morse",
        value: formula!(|pose| Some(pose.tyre?.rate)),
        needs: &[Need::Tyre],
        ..RATE
    },
    Factor {
        name: "loaded_radius",
        title: "loaded radius",
        symbol: "R_l",
        quantity: Quantity::Length,
        sign: "+ distance",
        formula: "R − deflection of the tyre at its load",
        source: "Adams/Car, Altair (slr)",
        value: formula!(|pose| {
            pose.tyre?;
            Some(loaded_radius(&pose.wheel, pose.tyre))
        }),
        needs: &[Need::Tyre],
        ..RATE
    },
    Factor {
        name: "ride_rate",
        title: "ride rate",
        symbol: "K_R",
        formula: "1/(1/K_W + 1/K_t): suspension and tyre in series",
        source: "Adams/Car, Altair 210; Milliken, Race Car Vehicle Dynamics, ch. 16",
        value: formula!(ride_rate),
        ..TYRE
    },
    Factor {
        name: "hop_rate",
        title: "hop rate",
        symbol: "K_h",
        formula: "K_W + K_t: suspension and tyre in parallel, as the wheel between them feels them",
        source: "Altair 210",
        value: formula!(hop_rate),
        ..TYRE
    },
    Factor {
        name: "ride_frequency",
        title: "ride frequency",
        symbol: "f_R",
        quantity: Quantity::Frequency,
        sign: "+ undamped",
        formula: "√(K_R/m_s)/2π, m_s the sprung mass of one wheel, the wheel without mass",
        source: "MathWorks; Milliken, Race Car Vehicle Dynamics, ch. 16",
        value: formula!(|pose| frequency(ride_rate(pose), pose.vehicle.sprung_mass)),
        needs: &[Need::Compliance, Need::Tyre, Need::SprungMass],
        ..TYRE
    },
    Factor {
        name: "hop_frequency",
        title: "hop frequency",
        symbol: "f_h",
        quantity: Quantity::Frequency,
        sign: "+ undamped",
        formula: "√(K_h/m_u)/2π, m_u the unsprung mass of one wheel, the chassis at rest",
        source: "MathWorks",
        value: formula!(|pose| frequency(hop_rate(pose), pose.vehicle.unsprung_mass)),
        needs: &[Need::Compliance, Need::Tyre, Need::UnsprungMass],
        ..TYRE
    },
];

const ROLL: Factor = Factor {
    scope: Scope::Axle,
    quantity: Quantity::RollStiffness,
    sign: "+ stiffer in roll",
    needs: &[Need::Compliance, Need::BothWheels],
    ..RATE
};

pub(super) const ROLL_RATES: &[Factor] = &[
    Factor {
        name: "roll_rate",
        title: "suspension roll rate",
        symbol: "K_φ",
        formula: "T²/(C33 − C39 − C93 + C99): moment by the angle of the line through the wheel centres",
        source: "Adams/Car, Altair 220",
        value: formula!(|pose| roll_rate(pose, apart(pose)?)),
        ..ROLL
    },
    Factor {
        name: "roll_bar_rate",
        title: "part of the anti-roll bar in the roll rate",
        symbol: "K_φb",
        sign: "+ stiffer in roll than in ride",
        formula: "K_φ − T²/4 (K_W left + K_W right): what couples the wheels, the bar above all",
        source: "Milliken, Race Car Vehicle Dynamics, ch. 16",
        value: formula!(roll_bar_rate),
        ..ROLL
    },
    Factor {
        name: "total_roll_rate",
        title: "total roll rate",
        symbol: "K_φt",
        formula: "T²/(C33 − C39 − C93 + C99 + 1/K_t left + 1/K_t right)",
        source: "Adams/Car, Altair 220",
        value: formula!(|pose| roll_rate(pose, apart(pose)? + tyres(pose)?)),
        needs: &[Need::Compliance, Need::BothWheels, Need::Tyre],
        ..ROLL
    },
];

const STIFF: Factor = Factor { sign: "+ gives way along the force", ..RATE };

const TURNED: Factor = Factor {
    quantity: Quantity::RollStiffness,
    sign: "+ turns with the moment",
    source: "Altair 60, Morse",
    ..RATE
};

pub(super) const STIFFNESSES: &[Factor] = &[
    Factor {
        name: "center_stiffness_x",
        title: "fore-aft stiffness at the wheel centre",
        symbol: "K_x",
        formula: "1/(C11 + C17): equal forces at both wheel centres",
        source: "Adams/Car, Altair 50",
        value: formula!(|pose| linear(pose, FORWARD, At::Center)),
        ..STIFF
    },
    Factor {
        name: "center_stiffness_y",
        title: "lateral stiffness at the wheel centre",
        symbol: "K_y",
        formula: "1/(C22 + C28): equal forces at both wheel centres",
        source: "Altair 50, MathWorks, Morse",
        value: formula!(|pose| linear(pose, LEFT, At::Center)),
        ..STIFF
    },
    Factor {
        name: "patch_stiffness_x",
        title: "fore-aft stiffness at the patch",
        symbol: "K_Px",
        formula: "1/(CP11 + CP17): equal forces at both patches, wheels locked to their bodies",
        source: "MathWorks, Morse",
        value: formula!(|pose| linear(pose, FORWARD, At::Patch)),
        ..STIFF
    },
    Factor {
        name: "patch_stiffness_y",
        title: "lateral stiffness at the patch",
        symbol: "K_Py",
        formula: "1/(CP22 + CP28): equal forces at both patches",
        source: "MathWorks, Morse",
        value: formula!(|pose| linear(pose, LEFT, At::Patch)),
        ..STIFF
    },
    Factor {
        name: "camber_stiffness",
        title: "camber stiffness",
        symbol: "K_γ",
        formula: "1/(C44 + C4,10): equal moments about x on both wheels",
        value: formula!(|pose| angular(pose, FORWARD)),
        ..TURNED
    },
    Factor {
        name: "caster_stiffness",
        title: "caster stiffness",
        symbol: "K_τ",
        formula: "1/(C55 + C5,11): equal moments about y on both wheels, locked to their bodies",
        value: formula!(|pose| angular(pose, LEFT)),
        ..TURNED
    },
    Factor {
        name: "toe_stiffness",
        title: "toe stiffness",
        symbol: "K_δ",
        formula: "1/(C66 + C6,12): equal moments about z on both wheels, the rack held",
        value: formula!(|pose| angular(pose, UP)),
        ..TURNED
    },
];
