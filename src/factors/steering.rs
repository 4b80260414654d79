//! Steering: the steering wheel, and both wheels of an axle: track, Ackermann, turning circle.

use super::definition::{Definition, Factor, Scope, Subject, formula};
use super::need::Need;
use super::wheel::toe;
use super::{FARTHEST, NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::{OtherWheel, Pose};
use crate::scalar::{Dual, Real, Scalar};

/// The angle of the steering wheel (rad), + to the left.
pub(super) fn steering_wheel<S: Scalar>(pose: &Pose<S>) -> Option<S> {
    Some(pose.rack / S::from_f64(pose.vehicle.rack_per_radian?))
}

/// The angle of the steering wheel per steer angle of the wheel.
fn ratio<S: Real>(pose: &Pose<S>) -> Option<S> {
    let wheel = pose.wheel.moving(&pose.motions?.rack?.wheel);
    let steer = -(pose.sigma() * toe(wheel.spin, pose.side).derivative);
    let per_rack = S::from_f64(1.0 / pose.vehicle.rack_per_radian?);
    quotient(per_rack, steer, NEARLY_PARALLEL)
}

/// Smaller turns (rad) have no inner wheel: the wheels are parallel but for rounding and toe.
const STRAIGHT: f64 = 1e-6;

/// Steer angles of the left and the right wheel (rad, + to the left).
fn steer_angles<S: Real>(pose: &Pose<S>) -> Option<[S; 2]> {
    let OtherWheel { wheel, .. } = pose.other?;
    let own = -(pose.sigma() * toe(pose.wheel.spin, pose.side));
    let other = pose.sigma() * toe(wheel.spin, pose.side.other());
    Some(if pose.sigma().value() > 0.0 { [own, other] } else { [other, own] })
}

fn mean_steer<S: Real>(pose: &Pose<S>) -> Option<S> {
    let [left, right] = steer_angles(pose)?;
    Some(S::from_f64(0.5) * (left + right))
}

/// Distance of the contact patches across the vehicle (m).
pub(super) fn track<S: Real>(pose: &Pose<S>) -> Option<S> {
    let other = pose.other?.wheel;
    Some(pose.sigma() * (pose.wheel.contact_patch()[1] - other.contact_patch()[1]))
}

fn design_track<S: Real>(pose: &Pose<S>) -> Option<S> {
    let (own, other) = (pose.design.wheel, pose.other?.design);
    Some(pose.sigma() * (own.contact_patch()[1] - other.contact_patch()[1]))
}

fn wheelbase<S: Real>(pose: &Pose<S>) -> Option<S> {
    pose.vehicle.wheelbase.map(S::from_f64)
}

/// A turn: the angles (rad) of the inner and the outer wheel, positive into the turn.
struct Turn<S> {
    inner: S,
    outer: S,
}

/// The turn to the side to which the wheels point in the mean; `None` straight ahead.
fn turn<S: Real>(pose: &Pose<S>) -> Option<Turn<S>> {
    let [left, right] = steer_angles(pose)?;
    let mean = 0.5 * (left + right).value();
    if mean.abs() < STRAIGHT {
        return None;
    }
    Some(if mean > 0.0 {
        Turn { inner: left, outer: right }
    } else {
        Turn { inner: -right, outer: -left }
    })
}

fn tan<S: Real>(angle: S) -> S {
    angle.sin() / angle.cos()
}

/// The angle (rad) whose tangent is L/length.
fn angle_at<S: Real>(wheelbase: S, length: S) -> S {
    wheelbase.atan2(length)
}

/// The inner angle that goes with the outer one where both wheels roll about one point on the
/// line of the rear axle: cot δ_i = cot δ_o − T/L.
fn ideal_inner<S: Real>(pose: &Pose<S>) -> Option<S> {
    let (wheelbase, outer) = (wheelbase(pose)?, turn(pose)?.outer);
    let radius = quotient(wheelbase, tan(outer), FARTHEST)?;
    Some(angle_at(wheelbase, radius - track(pose)?))
}

fn ackermann_angle<S: Real>(pose: &Pose<S>) -> Option<S> {
    let Turn { inner, outer } = turn(pose)?;
    Some(inner - outer)
}

fn ackermann_error<S: Real>(pose: &Pose<S>) -> Option<S> {
    Some(turn(pose)?.inner - ideal_inner(pose)?)
}

fn ackermann<S: Real>(pose: &Pose<S>) -> Option<S> {
    let ideal = ideal_inner(pose)? - turn(pose)?.outer;
    quotient(ackermann_angle(pose)?, ideal, NEARLY_PARALLEL)
}

/// Lotus: ideal angles at the radius of the mean angle, with the track at design.
fn ackermann_lotus<S: Real>(pose: &Pose<S>) -> Option<S> {
    let (wheelbase, mean) = (wheelbase(pose)?, mean_steer(pose)?);
    let size = if mean.value() < 0.0 { -mean } else { mean };
    let radius = quotient(wheelbase, tan(size), FARTHEST)?;
    let half = S::from_f64(0.5) * design_track(pose)?;
    let ideal = angle_at(wheelbase, radius - half) - angle_at(wheelbase, radius + half);
    quotient(ackermann_angle(pose)?, ideal, NEARLY_PARALLEL)
}

/// L (cot δ_i + cot δ_o)/2.
fn turning_radius<S: Real>(pose: &Pose<S>) -> Option<S> {
    let (wheelbase, Turn { inner, outer }) = (wheelbase(pose)?, turn(pose)?);
    let radius = |angle| quotient(wheelbase, tan(angle), FARTHEST);
    Some(S::from_f64(0.5) * (radius(inner)? + radius(outer)?))
}

fn outside_turn_diameter<S: Real>(pose: &Pose<S>) -> Option<S> {
    let outer = turn(pose)?.outer;
    quotient(S::from_f64(2.0) * wheelbase(pose)?, outer.sin(), FARTHEST)
}

/// Steer angles of both wheels per metre of the rack (rad/m).
fn mean_steer_by_rack<S: Real>(pose: &Pose<S>) -> Option<S> {
    let other = pose.other?;
    let own = pose.wheel.moving(&pose.motions?.rack?.wheel).spin;
    let others: [Dual<S>; 3] = other.wheel.moving(&other.rack?).spin;
    let rate = toe(others, pose.side.other()).derivative - toe(own, pose.side).derivative;
    Some(S::from_f64(0.5) * pose.sigma() * rate)
}

const AXLE: Factor = Factor {
    subject: Subject::Steering,
    scope: Scope::Axle,
    needs: &[Need::BothWheels],
    ..Factor::BLANK
};

const STEERED: Factor =
    Factor { quantity: Quantity::Angle, needs: &[Need::BothWheels, Need::Wheelbase], ..AXLE };

pub(super) const STEERING: &[Factor] = &[
    Factor {
        name: "steering_ratio",
        title: "steering ratio",
        symbol: "i_S",
        subject: Subject::Steering,
        quantity: Quantity::Ratio,
        sign: "+ steers the way that the steering wheel turns",
        formula: "dδ_H / dδ of this wheel, its height held, exact slope",
        source: "ISO 8855 (overall steering ratio); Adams/Car",
        value: formula!(|pose| ratio(pose)),
        needs: &[Need::Motion, Need::Rack, Need::SteeringRatio],
        ..Factor::BLANK
    },
    Factor {
        name: "track",
        title: "track",
        symbol: "T",
        sign: "+ distance",
        formula: "σ (P_y − P_y of the other wheel)",
        source: "ISO 8855",
        value: formula!(track),
        ..AXLE
    },
    Factor {
        name: "track_change",
        title: "track change",
        symbol: "ΔT",
        sign: "+ wider",
        formula: "T − T at design",
        source: "Adams/Car, Lotus",
        value: formula!(|pose| Some(track(pose)? - design_track(pose)?)),
        ..AXLE
    },
    Factor {
        name: "total_toe",
        title: "total toe",
        symbol: "δ_T",
        quantity: Quantity::Angle,
        sign: "+ toe-in",
        formula: "toe left + toe right",
        source: "Adams/Car",
        value: formula!(|pose| {
            let [left, right] = steer_angles(pose)?;
            Some(right - left)
        }),
        ..AXLE
    },
    Factor {
        name: "mean_steer",
        title: "mean steer angle",
        symbol: "δ_m",
        quantity: Quantity::Angle,
        sign: "+ to the left",
        formula: "(δ left + δ right)/2",
        source: "ISO 8855",
        value: formula!(mean_steer),
        ..AXLE
    },
    Factor {
        name: "mean_steer_by_rack",
        title: "mean steer angle by rack travel",
        symbol: "dδ_m/dr",
        quantity: Quantity::Gradient,
        sign: "+ to the left where the rack goes along the model's +y",
        formula: "d δ_m / dr at constant travels, exact slope",
        source: "Adams/Car, MathWorks",
        value: formula!(mean_steer_by_rack),
        needs: &[Need::BothWheels, Need::Rack],
        ..AXLE
    },
    Factor {
        name: "ideal_steer",
        title: "ideal angle of the inner wheel",
        symbol: "δ_A",
        sign: "+ into the turn",
        formula: "cot δ_A = cot δ_o − T/L, δ_o the angle of the outer wheel",
        source: "Adams/Car",
        value: formula!(ideal_inner),
        ..STEERED
    },
    Factor {
        name: "ackermann_angle",
        title: "Ackermann angle",
        symbol: "δ_i − δ_o",
        sign: "+ the inner wheel turns more",
        formula: "angle of the inner wheel − angle of the outer wheel, positive into the turn",
        source: "Adams/Car",
        value: formula!(ackermann_angle),
        needs: &[Need::BothWheels],
        ..STEERED
    },
    Factor {
        name: "ackermann_error",
        title: "Ackermann error",
        symbol: "δ_i − δ_A",
        sign: "+ the inner wheel turns more than ideal",
        formula: "angle of the inner wheel − ideal angle",
        source: "Adams/Car",
        value: formula!(ackermann_error),
        ..STEERED
    },
    Factor {
        name: "ackermann",
        title: "percent Ackermann",
        symbol: "A",
        quantity: Quantity::Percent,
        sign: "+ the inner wheel turns more; 100 % ideal, 0 % parallel",
        formula: "(δ_i − δ_o)/(δ_A − δ_o)",
        source: "Adams/Car",
        value: formula!(ackermann),
        lotus: Some(Definition {
            sign: "+ the inner wheel turns more; 100 % ideal, 0 % parallel",
            formula: "(δ_i − δ_o)/(atan(L/(R − T/2)) − atan(L/(R + T/2))), R = L/tan|δ_m|, T at design",
            source: "Lotus",
            value: formula!(ackermann_lotus),
        }),
        ..STEERED
    },
    Factor {
        name: "turning_radius",
        title: "turning radius",
        symbol: "R",
        quantity: Quantity::Length,
        sign: "+ distance of the middle of the axle line from the centre of the turn",
        formula: "L (cot δ_i + cot δ_o)/2",
        source: "Lotus",
        value: formula!(turning_radius),
        ..STEERED
    },
    Factor {
        name: "outside_turn_diameter",
        title: "outside turn diameter",
        symbol: "D_o",
        quantity: Quantity::Length,
        sign: "+ diameter of the circle of the outer wheel",
        formula: "2 L / sin δ_o",
        source: "Adams/Car",
        value: formula!(outside_turn_diameter),
        ..STEERED
    },
];
