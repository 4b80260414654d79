//! Anti-dive and its like from the compliance, and what dive and squat are left.

use super::anti::{cg_height, compensated};
use super::compliance::{Adams, At, FORWARD, Load, Pair, UP, loaded_radius, own, shift};
use super::definition::{Definition, Factor, Subject, formula};
use super::longitudinal::brake_point;
use super::need::Need;
use super::place::rearward_is_longer;
use super::{NEARLY_PARALLEL, quotient};
use crate::model::{Axle, Quantity};
use crate::rig::Pose;
use crate::scalar::Real;

/// Standard gravity (m/s²), by which accelerations are counted.
const G: f64 = 9.806_65;

/// What accelerates the vehicle.
#[derive(Clone, Copy)]
enum Cause {
    Brakes,
    Drive,
}

impl Cause {
    /// Where its force acts on the wheel's body.
    fn at<S: Real>(self, pose: &Pose<S>) -> At {
        match self {
            Self::Brakes => brake_point(pose),
            Self::Drive => At::Center,
        }
    }

    /// The sign of its force along x.
    const fn sign(self) -> f64 {
        match self {
            Self::Brakes => -1.0,
            Self::Drive => 1.0,
        }
    }

    /// The part of its force that the axle has.
    fn share<S: Real>(self, pose: &Pose<S>) -> Option<f64> {
        match self {
            Self::Brakes => pose.vehicle.brake_share,
            Self::Drive => pose.vehicle.drive_share,
        }
    }

    /// +1 where it presses the axle down, −1 where it relieves it.
    fn transfer<S: Real>(self, pose: &Pose<S>) -> Option<S> {
        Some(S::from_f64(self.sign()) * rearward_is_longer(pose)?)
    }
}

/// How far wheel centres rise under a unit force of the cause on each wheel, and under a unit vertical one.
fn rises<S: Real>(pose: &Pose<S>, cause: Cause) -> Option<[S; 2]> {
    let rise = |axis| {
        let twist = own(pose, Load::Force(axis, cause.at(pose)), Pair::Parallel)?;
        Some(shift(pose, &twist, At::Center, UP))
    };
    Some([S::from_f64(cause.sign()) * rise(FORWARD)?, rise(UP)?])
}

/// The slope of the support: vertical load that the force makes up for.
fn support<S: Real>(pose: &Pose<S>, cause: Cause) -> Option<S> {
    let [force, vertical] = rises(pose, cause)?;
    Some(-(cause.transfer(pose)? * quotient(force, vertical, NEARLY_PARALLEL)?))
}

fn anti<S: Real>(pose: &Pose<S>, cause: Cause) -> Option<S> {
    compensated(pose, cause.share(pose), support(pose, cause), cg_height(pose))
}

/// −Zf/Zw of the formulas of Adams/Car, with the radius plumb below the wheel centre.
fn adams_braking<S: Real>(pose: &Pose<S>) -> Option<S> {
    let matrix = Adams::of(pose)?;
    let own = loaded_radius(&pose.wheel, pose.tyre);
    let radius = pose
        .other
        .map_or(own, |other| S::from_f64(0.5) * (own + loaded_radius(&other.wheel, other.tyre)));
    let force = matrix.sum(3, 1) - radius * matrix.sum(3, 5);
    let slope = quotient(force, matrix.sum(3, 3), NEARLY_PARALLEL)?;
    let slope = -(Cause::Brakes.transfer(pose)? * slope);
    compensated(pose, pose.vehicle.brake_share, Some(slope), cg_height(pose))
}

/// How far the wheel rises per g of acceleration: by the load transfer m g h/2L and by the force itself.
fn rise_by_g<S: Real>(pose: &Pose<S>, cause: Cause) -> Option<S> {
    let [force, vertical] = rises(pose, cause)?;
    let vehicle = &pose.vehicle;
    let half = S::from_f64(0.5 * G * vehicle.mass?);
    let transfer = S::from_f64(vehicle.cg_height? / vehicle.wheelbase?) * cause.transfer(pose)?;
    Some(half * (transfer * vertical + S::from_f64(cause.share(pose)?) * force))
}

/// How far the body sinks at the axle per g.
fn sinking<S: Real>(pose: &Pose<S>, cause: Cause) -> Option<S> {
    rise_by_g(pose, cause)
}

/// How far the body rises at the axle per g.
fn lifting<S: Real>(pose: &Pose<S>, cause: Cause) -> Option<S> {
    Some(-rise_by_g(pose, cause)?)
}

/// The part of the axle in the pitch of the body.
fn pitch<S: Real>(pose: &Pose<S>, way: Option<S>) -> Option<S> {
    Some(way? / S::from_f64(pose.vehicle.wheelbase?))
}

const BRAKING: Factor = Factor {
    subject: Subject::Pitch,
    quantity: Quantity::Percent,
    sign: "+ less pitch",
    formula: "−Zf/Zw: Zf the rise of W under the braking forces β/2 at the patches, or at W with inboard brakes, Zw under the load transfer h/2L at the same points",
    source: "Adams/Car, Altair 240",
    value: formula!(|pose| anti(pose, Cause::Brakes)),
    adams: Some(Definition {
        sign: "+ less pitch",
        formula: "−Zf/Zw: Zf = β/2 (C31 + C37 − R_l (C35 + C3,11)), Zw = ±h/2L (C33 + C39), + at the front",
        source: "Adams/Car (percent anti-dive, percent anti-lift in braking)",
        value: formula!(adams_braking),
    }),
    needs: &[Need::Compliance, Need::Axle, Need::Wheelbase, Need::CgHeight, Need::BrakeShare],
    ..Factor::BLANK
};

const DRIVING: Factor = Factor {
    formula: "−Zf/Zw: Zf the rise of W under the driving forces κ/2 at the wheel centres, Zw under the load transfer h/2L there",
    source: "Adams/Car (independent), Altair 230",
    value: formula!(|pose| anti(pose, Cause::Drive)),
    adams: None,
    needs: &[Need::Compliance, Need::Axle, Need::Wheelbase, Need::CgHeight, Need::DriveShare],
    ..BRAKING
};

pub(super) const ANTI: &[Factor] = &[
    Factor {
        name: "anti_dive_elastic",
        title: "anti-dive of a front axle from the compliance",
        symbol: "AD_e",
        axle: Some(Axle::Front),
        ..BRAKING
    },
    Factor {
        name: "anti_lift_elastic",
        title: "anti-lift of a rear axle in braking from the compliance",
        symbol: "AL_be",
        axle: Some(Axle::Rear),
        ..BRAKING
    },
    Factor {
        name: "anti_lift_drive_elastic",
        title: "anti-lift of a driven front axle from the compliance",
        symbol: "AL_de",
        axle: Some(Axle::Front),
        ..DRIVING
    },
    Factor {
        name: "anti_squat_elastic",
        title: "anti-squat of a driven rear axle from the compliance",
        symbol: "AS_e",
        axle: Some(Axle::Rear),
        ..DRIVING
    },
];

const BRAKED: Factor = Factor {
    quantity: Quantity::LengthByG,
    formula: "m g (Zf + Zw) per g of braking, Zf and Zw as for the anti from the compliance, m the mass of the vehicle",
    source: "Altair 240, Adams/Car",
    adams: None,
    needs: &[
        Need::Compliance,
        Need::Axle,
        Need::Wheelbase,
        Need::CgHeight,
        Need::BrakeShare,
        Need::Mass,
    ],
    ..BRAKING
};

const DRIVEN: Factor = Factor {
    quantity: Quantity::LengthByG,
    formula: "m g (Zf + Zw) per g of driving, Zf and Zw as for the anti from the compliance, m the mass of the vehicle",
    source: "Altair 230, Adams/Car",
    needs: &[
        Need::Compliance,
        Need::Axle,
        Need::Wheelbase,
        Need::CgHeight,
        Need::DriveShare,
        Need::Mass,
    ],
    ..DRIVING
};

/// The way of the body at the axle and the same as an angle of pitch.
macro_rules! by_g {
    ($name:literal, $title:literal, $symbol:literal, $sign:literal, $axle:ident, $cause:ident, $of:ident, $base:ident) => {
        [
            Factor {
                name: $name,
                title: $title,
                symbol: $symbol,
                sign: $sign,
                value: formula!(|pose| $of(pose, Cause::$cause)),
                axle: Some(Axle::$axle),
                ..$base
            },
            Factor {
                name: concat!($name, "_pitch"),
                title: concat!($title, ", as an angle"),
                symbol: concat!("θ_", $symbol),
                quantity: Quantity::AngleByG,
                sign: $sign,
                formula: concat!($name, " / L: the part of this axle in the pitch of the body"),
                value: formula!(|pose| pitch(pose, $of(pose, Cause::$cause))),
                axle: Some(Axle::$axle),
                ..$base
            },
        ]
    };
}

pub(super) const DIVE: [Factor; 2] = by_g!(
    "dive_braking",
    "dive in braking",
    "z_b",
    "+ the front sinks",
    Front,
    Brakes,
    sinking,
    BRAKED
);

pub(super) const LIFT_BRAKING: [Factor; 2] = by_g!(
    "lift_braking",
    "lift in braking",
    "z_b",
    "+ the rear rises",
    Rear,
    Brakes,
    lifting,
    BRAKED
);

pub(super) const LIFT_DRIVING: [Factor; 2] = by_g!(
    "lift_driving",
    "lift in driving",
    "z_d",
    "+ the front rises",
    Front,
    Drive,
    lifting,
    DRIVEN
);

pub(super) const SQUAT: [Factor; 2] = by_g!(
    "squat_driving",
    "squat in driving",
    "z_d",
    "+ the rear sinks",
    Rear,
    Drive,
    sinking,
    DRIVEN
);
