//! How the wheel steers and leans in ride and roll, from the compliance.

use super::compliance::{
    Adams, Pair, VERTICAL, camber_rate, caster_rate, other, own, per_rise, toe_rate,
};
use super::definition::{Definition, Factor, Subject, formula};
use super::need::Need;
use super::roll::roll_rate;
use super::steering::track;
use super::{NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::Real;
use crate::solve::Twist;

/// Turns of the wheel about an axis of Adams/Car by its height, both wheels loaded alike.
fn adams_ride<S: Real>(pose: &Pose<S>, row: usize) -> Option<S> {
    let matrix = Adams::of(pose)?;
    quotient(matrix.sum(row, 3), matrix.sum(3, 3), NEARLY_PARALLEL)
}

/// d track/dz of the lowest points of both wheels.
fn tread_change<S: Real>(pose: &Pose<S>) -> Option<S> {
    let wheel = pose.wheel.moving(&own(pose, VERTICAL, Pair::Parallel)?);
    let others = pose.other?.wheel.moving(&other(pose, VERTICAL, Pair::Parallel)?);
    let wider =
        pose.sigma() * (wheel.contact_patch()[1].derivative - others.contact_patch()[1].derivative);
    let rise = wheel.center[2].derivative + others.center[2].derivative;
    quotient(S::from_f64(2.0) * wider, rise, NEARLY_PARALLEL)
}

const SLOPE: Factor = Factor {
    subject: Subject::Ride,
    quantity: Quantity::Gradient,
    needs: &[Need::Compliance],
    ..Factor::BLANK
};

pub(super) const RIDE: &[Factor] = &[
    Factor {
        name: "ride_steer",
        title: "ride steer",
        symbol: "dδ_t/dz",
        sign: "+ toe-in in jounce",
        formula: "d toe / dW_z under equal vertical forces on both wheels",
        source: "Adams/Car, Altair 180",
        value: formula!(|pose| Some(toe_rate(pose, &per_rise(pose, Pair::Parallel)?))),
        adams: Some(Definition {
            sign: "+ toe-in in jounce",
            formula: "−σ (C63 + C69)/(C33 + C39)",
            source: "Adams/Car",
            value: formula!(|pose| Some(-(pose.sigma() * adams_ride(pose, 6)?))),
        }),
        ..SLOPE
    },
    Factor {
        name: "ride_camber",
        title: "ride camber",
        symbol: "dγ/dz",
        sign: "+ top outboard in jounce",
        formula: "d camber / dW_z under equal vertical forces on both wheels",
        source: "Adams/Car, Altair 180",
        value: formula!(|pose| Some(camber_rate(pose, &per_rise(pose, Pair::Parallel)?))),
        adams: Some(Definition {
            sign: "+ top outboard in jounce",
            formula: "(C43 + C49)/(C33 + C39) left, −(C10,3 + C10,9)/(C93 + C99) right",
            source: "Adams/Car (camber change)",
            value: formula!(|pose| Some(pose.sigma() * adams_ride(pose, 4)?)),
        }),
        ..SLOPE
    },
    Factor {
        name: "ride_caster",
        title: "ride caster",
        symbol: "dτ/dz",
        sign: "+ top rearward in jounce",
        formula: "−ω_y / v_Wz under equal vertical forces: (C53 + C59)/(C33 + C39) in Adams' axes",
        source: "Adams/Car (caster change), Altair 180",
        value: formula!(|pose| Some(caster_rate(&per_rise(pose, Pair::Parallel)?))),
        ..SLOPE
    },
    Factor {
        name: "tread_change",
        title: "tread change",
        symbol: "dT/dz",
        quantity: Quantity::Ratio,
        sign: "+ wider in jounce",
        formula: "dT / dW_z of the lowest points under equal vertical forces, W_z the mean of both wheels",
        source: "Altair 40",
        value: formula!(tread_change),
        needs: &[Need::Compliance, Need::BothWheels],
        ..SLOPE
    },
];

/// What turns the line against which roll is measured.
#[derive(Clone, Copy)]
enum Ground {
    /// The patches of the wheels.
    Patches,
    /// The road under tyres that give way.
    Road,
}

/// A rate of the wheel by roll, positive with the right side of the body down, under a force up on the own
/// wheel and one down on the other.
fn per_roll<S: Real>(pose: &Pose<S>, ground: Ground, rate: impl Fn(&Twist<S>) -> S) -> Option<S> {
    let (twist, others) =
        (own(pose, VERTICAL, Pair::Opposed)?, other(pose, VERTICAL, Pair::Opposed)?);
    let mut patch = pose.wheel.moving(&twist).contact_patch();
    let mut across = pose.other?.wheel.moving(&others).contact_patch();
    if let Ground::Road = ground {
        let one = S::from_f64(1.0);
        patch[2].derivative = patch[2].derivative + one / pose.tyre?.rate;
        across[2].derivative = across[2].derivative - one / pose.other?.tyre?.rate;
    }
    quotient(rate(&twist), roll_rate(patch, across), NEARLY_PARALLEL)
}

fn roll_steer<S: Real>(pose: &Pose<S>, ground: Ground) -> Option<S> {
    per_roll(pose, ground, |twist| -(pose.sigma() * toe_rate(pose, twist)))
}

fn roll_camber<S: Real>(pose: &Pose<S>, ground: Ground) -> Option<S> {
    per_roll(pose, ground, |twist| camber_rate(pose, twist))
}

fn roll_caster<S: Real>(pose: &Pose<S>, ground: Ground) -> Option<S> {
    per_roll(pose, ground, caster_rate)
}

/// A turn under a unit force up on the left wheel and one down on the right one, by the angle Dz/T.
fn adams_roll<S: Real>(pose: &Pose<S>, turn: S) -> Option<S> {
    let (own, other) = (Adams::of(pose)?, Adams::of_other(pose)?);
    let one = S::from_f64(1.0);
    let tyres = one / pose.tyre?.rate + one / pose.other?.tyre?.rate;
    // Dz = C33 − C39 − C93 + C99 + 2/Kt, whichever wheel is the left one.
    let rise = pose.sigma() * (own.difference(3, 3) - other.difference(3, 3)) + tyres;
    quotient(turn * track(pose)?, rise, NEARLY_PARALLEL)
}

fn adams_roll_steer<S: Real>(pose: &Pose<S>) -> Option<S> {
    let turns = Adams::of(pose)?.difference(6, 3) + Adams::of_other(pose)?.difference(6, 3);
    adams_roll(pose, S::from_f64(0.5) * turns)
}

/// 1 − Ac/Av: how the wheel leans against the road.
fn adams_roll_camber<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(S::from_f64(1.0) + adams_roll(pose, Adams::of(pose)?.difference(4, 3))?)
}

const ROLLED: Factor = Factor {
    quantity: Quantity::Ratio,
    needs: &[Need::Compliance, Need::BothWheels],
    source: "Altair 190, Adams/Car",
    ..SLOPE
};

const TOTAL: Factor = Factor {
    quantity: Quantity::Percent,
    needs: &[Need::Compliance, Need::BothWheels, Need::Tyre],
    ..ROLLED
};

pub(super) const ROLL: &[Factor] = &[
    Factor {
        name: "roll_steer_elastic",
        title: "roll steer from the compliance",
        symbol: "dδ/dφ",
        sign: "+ to the left, by roll with the right side down",
        formula: "d steer_angle / dφ under opposed vertical forces, φ the angle of the body to the line through both patches",
        value: formula!(|pose| roll_steer(pose, Ground::Patches)),
        ..ROLLED
    },
    Factor {
        name: "roll_camber_elastic",
        title: "roll camber from the compliance",
        symbol: "dγ/dφ",
        sign: "+ top outboard, by roll with the right side down",
        formula: "d camber / dφ under opposed vertical forces, camber against the body",
        value: formula!(|pose| roll_camber(pose, Ground::Patches)),
        ..ROLLED
    },
    Factor {
        name: "roll_caster_elastic",
        title: "roll caster from the compliance",
        symbol: "dτ/dφ",
        sign: "+ top rearward, by roll with the right side down",
        formula: "−ω_y / dφ under opposed vertical forces",
        value: formula!(|pose| roll_caster(pose, Ground::Patches)),
        ..ROLLED
    },
    Factor {
        name: "roll_steer_total",
        title: "roll steer by the roll on the road",
        symbol: "dδ/dφ_t",
        sign: "+ to the left, by roll with the right side down",
        formula: "d steer_angle / dφ_t under opposed vertical forces, φ_t the angle of the body to the road: with 1/K_t of both tyres",
        value: formula!(|pose| roll_steer(pose, Ground::Road)),
        adams: Some(Definition {
            sign: "+ to the left, by roll with the left side down",
            formula: "As/Av: As = (C63 − C69 + C12,3 − C12,9)/2, the mean of both wheels, Av = (C33 − C39 − C93 + C99 + 2/K_t)/T",
            source: "Adams/Car (percent roll steer)",
            value: formula!(adams_roll_steer),
        }),
        ..TOTAL
    },
    Factor {
        name: "roll_camber_total",
        title: "roll camber by the roll on the road",
        symbol: "dγ/dφ_t",
        sign: "+ top outboard, by roll with the right side down",
        formula: "d camber / dφ_t under opposed vertical forces, camber against the body",
        value: formula!(|pose| roll_camber(pose, Ground::Road)),
        adams: Some(Definition {
            sign: "+ leans with the body",
            formula: "1 − Ac/Av: Ac = −C43 + C49 left, −C10,3 + C10,9 right, Av as for roll steer; against the road",
            source: "Adams/Car (roll camber)",
            value: formula!(adams_roll_camber),
        }),
        ..TOTAL
    },
    Factor {
        name: "roll_caster_total",
        title: "roll caster by the roll on the road",
        symbol: "dτ/dφ_t",
        sign: "+ top rearward, by roll with the right side down",
        formula: "−ω_y / dφ_t under opposed vertical forces",
        value: formula!(|pose| roll_caster(pose, Ground::Road)),
        adams: Some(Definition {
            sign: "+ top rearward, by roll with the left side down",
            formula: "(C53 − C59)/Av left, (C11,3 − C11,9)/Av right, Av as for roll steer",
            source: "Adams/Car (roll caster coefficient), Altair 190",
            value: formula!(|pose| adams_roll(pose, Adams::of(pose)?.difference(5, 3))),
        }),
        ..TOTAL
    },
];
