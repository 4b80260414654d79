//! Which constraints contradict each other.

use faer::Col;

use super::active_set::Limits;
use super::outcome::{ActiveSide, Conflict, Member};
use super::point::{Point, excess};
use super::problem::Statement;
use super::subproblem::least_violation;

/// A conflict is what loses less than this part of its violation within a step of typical size.
const STUCK: f64 = 1e-5;
/// Multipliers below this are zero; those of violated constraints are 1.
const ZERO: f64 = 1e-6;

/// Looks for a conflict at a point whose constraints are violated by more than `tolerance`. None if
/// a small step brings it nearer to all of them together.
pub(super) fn find(point: &Point, statement: &Statement, tolerance: f64) -> Option<Conflict> {
    let limits = Limits::new(point, statement, 1.0);
    if point.worst_violation() <= tolerance {
        return None;
    }
    let (step, least) = least_violation(point, &limits)?;
    if point.violation() - least > STUCK * point.violation() {
        return None;
    }
    let sizes = || statement.constraints.iter().map(|constraint| constraint.typical);
    let outside = point.outside(&point.constraints);
    let violations = outside.iter().zip(sizes()).map(|(outside, size)| outside * size).collect();
    let clean = |value: f64| if value.abs() > ZERO { value } else { 0.0 };
    let multipliers = sizes().enumerate().map(|(i, size)| clean(step.y[i]) / size).collect();
    let bounds = Col::from_fn(point.x.len(), |j| {
        if held_by_bound(point, statement, j, step.z[j]) { clean(step.z[j]) } else { 0.0 }
    });
    let typical = statement.variables.iter().map(|variable| variable.typical).enumerate();
    let bound_multipliers = typical.map(|(j, size)| bounds[j] / size).collect();
    let members = Filter { point, limits, tolerance }.smallest(&step.y, &bounds);
    Some(Conflict { violations, multipliers, bound_multipliers, members })
}

/// Whether a multiplier belongs to a bound and not to the trust region.
fn held_by_bound(point: &Point, statement: &Statement, j: usize, multiplier: f64) -> bool {
    let variable = statement.variables[j];
    let bound = if multiplier > 0.0 { variable.lower } else { variable.upper };
    (bound - point.x[j]).abs() < variable.typical
}

/// A deletion filter (Chinneck, *Feasibility and Infeasibility in Optimization*, §6.2.1) on the
/// linearised constraints.
struct Filter<'a> {
    point: &'a Point,
    limits: Limits,
    tolerance: f64,
}

impl Filter<'_> {
    /// Members with a multiplier contradict each other, by the lemma of Farkas. Those
    /// with small ones are tried first, as the others are more likely to be needed.
    fn smallest(&self, y: &Col<f64>, z: &Col<f64>) -> Vec<Member> {
        let side = |multiplier: f64| {
            if multiplier > 0.0 { ActiveSide::Lower } else { ActiveSide::Upper }
        };
        let rows = (0..y.nrows())
            .filter(|&i| y[i].abs() > ZERO)
            .map(|i| (y[i].abs(), Member::Constraint(i, side(y[i]))));
        let bounds = (0..z.nrows())
            .filter(|&j| z[j].abs() > ZERO)
            .map(|j| (z[j].abs(), Member::Bound(j, side(z[j]))));
        let mut candidates: Vec<(f64, Member)> = bounds.chain(rows).collect();
        candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut members: Vec<Member> = candidates.into_iter().map(|(_, member)| member).collect();
        let mut index = 0;
        while index < members.len() {
            let mut rest = members.clone();
            rest.remove(index);
            if self.contradictory(&rest) {
                members = rest;
            } else {
                index += 1;
            }
        }
        members.sort_by_key(|member| match *member {
            Member::Constraint(i, _) => (0, i),
            Member::Bound(j, _) => (1, j),
        });
        members
    }

    /// Whether no step of typical size brings these members nearer together.
    fn contradictory(&self, members: &[Member]) -> bool {
        let (n, m) = (self.limits.lower.len(), self.limits.row_lower.len());
        let mut limits = Limits {
            lower: vec![-1.0; n],
            upper: vec![1.0; n],
            row_lower: vec![f64::NEG_INFINITY; m],
            row_upper: vec![f64::INFINITY; m],
        };
        for &member in members {
            match member {
                Member::Constraint(i, ActiveSide::Lower) => {
                    limits.row_lower[i] = self.limits.row_lower[i];
                }
                Member::Constraint(i, ActiveSide::Upper) => {
                    limits.row_upper[i] = self.limits.row_upper[i];
                }
                Member::Bound(j, ActiveSide::Lower) => limits.lower[j] = self.limits.lower[j],
                Member::Bound(j, ActiveSide::Upper) => limits.upper[j] = self.limits.upper[j],
            }
        }
        let sides = limits.row_lower.iter().zip(&limits.row_upper);
        let violation: f64 = sides.map(|(&low, &high)| excess(0.0, low, high).abs()).sum();
        if violation <= self.tolerance {
            return false;
        }
        least_violation(self.point, &limits)
            .is_some_and(|(_, least)| violation - least <= STUCK * violation)
    }
}
