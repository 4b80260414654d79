//! The conditions of Karush, Kuhn and Tucker at a point.

use super::active_set::{Place, Step};
use super::outcome::{ActiveSide, Kkt, Settings};
use super::point::Point;
use super::problem::Statement;

/// What is nearer than this, in typical changes, is reached.
pub(super) const NEAR: f64 = 1e-8;

/// How well they hold with the multipliers of a step.
pub(super) fn kkt(point: &Point, statement: &Statement, found: &Step) -> Kkt {
    let Step { step, y, z, places } = found;
    let gradient = point.gradient();
    let pull = point.rows.transpose() * y;
    let (mut stationarity, mut complementarity) = (0.0f64, 0.0f64);
    for j in 0..point.x.len() {
        let residual_terms = (0..point.residuals.nrows())
            .map(|k| (point.residuals[k] * point.jacobian[(k, j)]).abs());
        let row_terms = (0..y.nrows()).map(|i| (y[i] * point.rows[(i, j)]).abs());
        let terms = residual_terms.chain(row_terms).sum::<f64>() + point.phi_gradient[j].abs();
        let held = active_bound(point, statement, found, j);
        let push = if held.is_some() { z[j] } else { 0.0 };
        stationarity = stationarity.max((gradient[j] - pull[j] - push).abs() / terms.max(1.0));
        let distance = match held {
            Some(ActiveSide::Lower) => point.x[j] - statement.variables[j].lower,
            Some(ActiveSide::Upper) => statement.variables[j].upper - point.x[j],
            None => 0.0,
        };
        let distance = distance / statement.variables[j].typical;
        complementarity = complementarity.max(push.abs().min(distance.abs()));
    }
    for i in 0..y.nrows() {
        let limit = match places.rows[i] {
            Place::Lower => point.row_lower[i],
            Place::Upper => point.row_upper[i],
            _ => continue,
        };
        let distance = (point.constraints[i] - limit).abs();
        complementarity = complementarity.max(y[i].abs().min(distance));
    }
    Kkt { stationarity, violation: point.worst_violation(), complementarity, step: step.norm_max() }
}

/// The bound that holds a variable. A component of the step may also be held by the trust region,
/// which is no condition of the problem.
pub(super) fn active_bound(
    point: &Point,
    statement: &Statement,
    found: &Step,
    j: usize,
) -> Option<ActiveSide> {
    let variable = statement.variables[j];
    let near = |bound: f64| (point.x[j] - bound).abs() <= NEAR * variable.typical;
    match found.places.bounds[j] {
        Place::Lower => near(variable.lower).then_some(ActiveSide::Lower),
        Place::Upper => near(variable.upper).then_some(ActiveSide::Upper),
        _ => None,
    }
}

/// The side of a constraint that holds, or penalises its violation.
pub(super) fn active_side(point: &Point, found: &Step, i: usize) -> Option<ActiveSide> {
    let value = point.constraints[i];
    let near = |limit: f64| (value - limit).abs() <= NEAR * value.abs().max(1.0);
    match found.places.rows[i] {
        Place::Lower => near(point.row_lower[i]).then_some(ActiveSide::Lower),
        Place::Upper => near(point.row_upper[i]).then_some(ActiveSide::Upper),
        Place::Below => Some(ActiveSide::Lower),
        Place::Above => Some(ActiveSide::Upper),
        Place::Between => None,
    }
}

impl Kkt {
    /// Whether they hold but for the length of the step.
    pub(super) fn holds(&self, settings: &Settings) -> bool {
        self.stationarity <= settings.optimality
            && self.violation <= settings.feasibility
            && self.complementarity <= settings.optimality
    }
}
