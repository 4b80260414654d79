//! The steering wheel and the wheels that it steers.

use super::definition::{Factor, Subject, formula};
use super::need::Need;
use super::wheel::toe;
use super::{NEARLY_PARALLEL, quotient};
use crate::model::Quantity;
use crate::rig::Pose;
use crate::scalar::{Real, Scalar};

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

pub(super) const STEERING: &[Factor] = &[Factor {
    name: "steering_ratio",
    title: "steering ratio",
    symbol: "i_S",
    subject: Subject::Steering,
    quantity: Quantity::Ratio,
    sign: "+ steers the way that the steering wheel turns",
    formula: "dδ_H / dδ of this wheel, its height held, exact slope",
    source: "ISO 8855 (overall steering ratio); Adams/Car",
    value: formula!(|pose| ratio(pose)),
    needs: &[Need::HeldWheel, Need::Rack, Need::SteeringRatio],
    ..Factor::BLANK
}];
