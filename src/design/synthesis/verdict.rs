//! Whether a design is what was asked for, and what stands against it.

use super::goals::Kind;
use super::problem::Task;
use super::search::KEPT;
use crate::design::request::{Request, short, state_words};
use crate::design::sqp::{ActiveSide, Evaluation, Member, Outcome, Problem as _, Status};
use crate::model::Model;
use crate::rig::Variable;

/// A target counts as met where it is off by no more than this many tolerances.
const MET: f64 = 1.0;

/// A multiplier below this part of the largest holds nothing.
const HOLDS: f64 = 1e-6;

/// A constraint that changes by less than this part of its typical change over the bounds does not change.
const FLAT: f64 = 1e-9;

/// An equation that costs less than this costs nothing.
const COSTS: f64 = 1e-6;

/// What became of a request.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every target is met within its tolerance, every limit is kept.
    Met,
    /// All limits are kept, but some targets are off by more than their tolerance.
    Compromise {
        /// These targets.
        unmet: Vec<Unmet>,
    },
    /// Limits and constraints contradict each other: there is no design.
    Conflict {
        /// A smallest set that does, in words.
        between: Vec<String>,
    },
    /// Designs could not be evaluated.
    Unreachable {
        /// Why.
        reason: String,
    },
    /// The iterations ended before a design was found that keeps all limits, or before it was clear which of them
    /// contradict each other.
    Unfinished {
        /// What the nearest design does not keep, in words, the worst first.
        broken: Vec<String>,
    },
}

/// A target that is not met.
#[derive(Clone, Debug, PartialEq)]
pub struct Unmet {
    /// The target, by its place in the request.
    pub target: usize,
    /// The largest difference (SI) of its states.
    pub off: f64,
    /// The same in tolerances.
    pub tolerances: f64,
}

/// A bound or constraint on which the design lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// What it is, in words.
    pub name: String,
    /// How much the objective, half the sum of squares of weighted differences in tolerances, would fall if the limit
    /// were a typical change wider: which limits cost most.
    pub cost: f64,
}

pub(super) fn verdict<V: Variable>(
    request: &Request,
    model: &Model,
    task: &Task<'_, V>,
    outcome: &Outcome,
    after: &[Vec<Option<f64>>],
) -> Verdict {
    let kept = |violation: f64| violation <= KEPT;
    match &outcome.status {
        Status::EvaluationFailed(failure) => Verdict::Unreachable { reason: failure.to_string() },
        Status::Infeasible(conflict) => Verdict::Conflict {
            between: conflict.members.iter().map(|m| member(request, model, task, *m)).collect(),
        },
        Status::Stalled(kkt) | Status::Iterations(kkt) if !kept(kkt.violation) => {
            Verdict::Unfinished { broken: broken(request, model, task, outcome) }
        }
        Status::Converged(_) | Status::Stalled(_) | Status::Iterations(_) => {
            judge(request, &task.before, after)
        }
    }
}

/// The constraints that a design breaks, in words.
fn broken<V: Variable>(
    request: &Request,
    model: &Model,
    task: &Task<'_, V>,
    outcome: &Outcome,
) -> Vec<String> {
    let rows = task.statement.constraints.iter().zip(&outcome.constraints).enumerate();
    let broken = rows.map(|(row, (constraint, value))| {
        let (below, above) = (constraint.lower - value, value - constraint.upper);
        let side = if above > below { ActiveSide::Upper } else { ActiveSide::Lower };
        (below.max(above) / constraint.typical, Member::Constraint(row, side))
    });
    let mut broken: Vec<(f64, Member)> = broken.filter(|(by, _)| *by > KEPT).collect();
    broken.sort_by(|a, b| b.0.total_cmp(&a.0));
    broken.into_iter().map(|(_, limit)| member(request, model, task, limit)).collect()
}

/// Whether a design that keeps all limits meets all targets. `before` has the factors (SI) of the model and `after` those
/// of the design, target by target and state by state.
pub fn judge(
    request: &Request,
    before: &[Vec<Option<f64>>],
    after: &[Vec<Option<f64>>],
) -> Verdict {
    let unmet = unmet(request, before, after);
    if unmet.is_empty() { Verdict::Met } else { Verdict::Compromise { unmet } }
}

/// The targets that are off by more than their tolerance.
fn unmet(request: &Request, before: &[Vec<Option<f64>>], after: &[Vec<Option<f64>>]) -> Vec<Unmet> {
    let mut list = vec![];
    for (index, target) in request.targets.iter().enumerate() {
        let off = |k: usize, value: Option<f64>| {
            target.off(k, value, before[index][k]).unwrap_or(f64::INFINITY)
        };
        let states = after[index].iter().enumerate().map(|(k, value)| off(k, *value));
        let worst =
            states.fold(0.0, |worst: f64, off| if off.abs() > worst.abs() { off } else { worst });
        let tolerances = worst.abs() / target.tolerance;
        // A hard target is kept as exactly as constraints are.
        if tolerances > MET * (1.0 + 1e-6) {
            list.push(Unmet { target: index, off: worst, tolerances });
        }
    }
    list.sort_by(|a, b| b.tolerances.total_cmp(&a.tolerances));
    list
}

/// The bounds and constraints on which a design lies, the costly ones first.
pub(super) fn held<V: Variable>(
    request: &Request,
    model: &Model,
    task: &mut Task<'_, V>,
    outcome: &Outcome,
) -> Vec<Held> {
    let mut list = vec![];
    let mut here = Evaluation::zeros(&task.statement);
    if task.evaluate(&outcome.x, &mut here).is_err() {
        return list;
    }
    for (k, side) in outcome.active_bounds.iter().enumerate() {
        let Some(side) = side else { continue };
        let typical = task.statement.variables[k].typical;
        let cost = outcome.bound_multipliers.get(k).map_or(0.0, |m| m.abs() * typical);
        list.push(Held { name: member(request, model, task, Member::Bound(k, *side)), cost });
    }
    for (row, side) in outcome.active.iter().enumerate() {
        let Some(side) = side else { continue };
        let constraint = task.statement.constraints[row];
        let typical = constraint.typical;
        let by = &here.constraint_jacobian[row * outcome.x.len()..][..outcome.x.len()];
        let changes = by.iter().zip(&task.statement.variables);
        // What no variable changes holds nothing, whatever its multiplier is.
        if changes.fold(0.0, |sum: f64, (by, v)| sum + (by * v.typical).abs()) < FLAT * typical {
            continue;
        }
        let cost = outcome.multipliers.get(row).map_or(0.0, |m| m.abs() * typical);
        // An equation always holds; it is worth a word where it costs something.
        if constraint.lower < constraint.upper || cost > COSTS {
            let name = member(request, model, task, Member::Constraint(row, *side));
            list.push(Held { name, cost });
        }
    }
    list.sort_by(|a, b| b.cost.total_cmp(&a.cost));
    let most = list.first().map_or(0.0, |held| held.cost);
    list.retain(|held| held.cost >= HOLDS * most && held.cost > 0.0);
    list
}

/// A bound or constraint in words.
fn member<V: Variable>(
    request: &Request,
    model: &Model,
    task: &Task<'_, V>,
    member: Member,
) -> String {
    match member {
        Member::Bound(k, side) => {
            let variable = &request.variables[k];
            let quantity = variable.parameter.quantity(model);
            let sign = match variable.parameter.axis() {
                Some(axis) => model.axes.signs()[axis],
                None => 1.0,
            };
            let bound = match side {
                ActiveSide::Lower => variable.bounds[0],
                ActiveSide::Upper => variable.bounds[1],
            };
            let upper = (side == ActiveSide::Upper) == (sign > 0.0);
            let which = if upper { "at most" } else { "at least" };
            let shown = quantity.show(model.units, sign * bound);
            let unit = quantity.symbol(model.units);
            format!("{} {which} {} {unit}", variable.name, short(shown))
        }
        Member::Constraint(row, side) => {
            let limit = task.limits.list.iter().find(|limit| limit.row == row);
            if let Some(limit) = limit {
                return limit.words[usize::from(side == ActiveSide::Upper)].clone();
            }
            let is_own = |kind| matches!(kind, Kind::Hard { row: own, .. } if own == row);
            let wish = task.goals.wishes.iter().find(|wish| is_own(wish.kind));
            let Some(wish) = wish else { return format!("constraint {row}") };
            let target = &request.targets[wish.target];
            let constraint = &task.statement.constraints[row];
            let (which, limit) = match side {
                _ if constraint.lower == constraint.upper => ("equal to", constraint.lower),
                ActiveSide::Lower => ("at least", constraint.lower),
                ActiveSide::Upper => ("at most", constraint.upper),
            };
            let shown = short(target.show(model.units, limit));
            let unit = target.unit(model.units);
            let state = state_words(&task.goals.states[wish.state], model.units);
            let at = if state.is_empty() { state } else { format!(" at {state}") };
            format!("target `{}` {which} {shown} {unit}{at}", target.name)
        }
    }
}
