//! From several designs to the best one.

use rayon::prelude::*;

use super::Obstacle;
use super::problem::Task;
use crate::design::request::Request;
use crate::design::sqp::{Outcome, Settings, Sobol, Status, solve};
use crate::rig::Variable;

/// Targets count as met where none is off by more than this part of its tolerance.
const MET: f64 = 1e-6;

/// A constraint is kept where it is violated by no more than this part of its typical change.
pub(super) const KEPT: f64 = 1e-6;

/// The best design that was found, and the way to it.
pub(super) struct Found {
    pub outcome: Outcome,
    /// From how many designs it was sought.
    pub starts: usize,
    /// Designs that were evaluated, from all starts.
    pub evaluations: usize,
}

/// Seeks from the model itself and, where that does not lead to a design that meets all targets, from points
/// of a Sobol sequence between the bounds. `task` sets the request up once more.
pub(super) fn search<'a, V: Variable>(
    request: &Request,
    first: &mut Task<'a, V>,
    task: impl Fn() -> Result<Task<'a, V>, Obstacle> + Sync,
) -> Result<Found, Obstacle> {
    let start = first.start();
    let outcome = settle(request, first, &start)?;
    let mut found = Found { evaluations: outcome.evaluations, outcome, starts: 1 };
    if found.is_met(first) {
        return Ok(found);
    }
    let points = starts(request, first);
    let outcomes: Vec<Option<Outcome>> = points
        .par_iter()
        .map_init(&task, |task, point| settle(request, task.as_mut().ok()?, point).ok())
        .collect();
    for outcome in outcomes.into_iter().flatten() {
        found.starts += 1;
        found.evaluations += outcome.evaluations;
        if rank(&outcome) < rank(&found.outcome) {
            found.outcome = outcome;
        }
    }
    Ok(found)
}

/// Seeks from one design.
pub(super) fn settle<V: Variable>(
    request: &Request,
    task: &mut Task<'_, V>,
    start: &[f64],
) -> Result<Outcome, Obstacle> {
    let settings = Settings {
        iterations: request.search.iterations as usize,
        evaluations: 3 * request.search.iterations as usize,
        ..Settings::default()
    };
    let statement = task.statement.clone();
    let outcome = solve(task, &statement, start, &settings).map_err(Obstacle::Statement)?;
    match outcome.status {
        Status::Stalled(kkt) | Status::Iterations(kkt) if kkt.violation > KEPT => {
            restore(task, outcome, &settings)
        }
        _ => Ok(outcome),
    }
}

/// Looks for a design that keeps all limits without regard to the targets that are no constraints, which pull a search to
/// and fro between limits that contradict each other. It ends in that contradiction, or in a design from which
/// the search goes on.
fn restore<V: Variable>(
    task: &mut Task<'_, V>,
    from: Outcome,
    settings: &Settings,
) -> Result<Outcome, Obstacle> {
    let statement = task.statement.clone();
    let mut limits_alone = statement.clone();
    limits_alone.weights.fill(0.0);
    let factors = std::mem::take(&mut task.goals.factors);
    task.goals.factors = vec![0.0; factors.len()];
    let kept = solve(task, &limits_alone, &from.x, settings);
    task.goals.factors = factors;
    let mut kept = kept.map_err(Obstacle::Statement)?;
    kept.evaluations += from.evaluations;
    match &kept.status {
        Status::Infeasible(_) => Ok(kept),
        Status::Converged(kkt) | Status::Stalled(kkt) | Status::Iterations(kkt)
            if kkt.violation <= KEPT =>
        {
            let mut found =
                solve(task, &statement, &kept.x, settings).map_err(Obstacle::Statement)?;
            found.evaluations += kept.evaluations;
            Ok(found)
        }
        _ => Ok(Outcome { evaluations: kept.evaluations, ..from }),
    }
}

impl Found {
    /// Whether every target is met and every constraint kept.
    fn is_met<V: Variable>(&self, task: &Task<'_, V>) -> bool {
        let open = task
            .goals
            .wishes
            .iter()
            .any(|wish| matches!(wish.kind, super::goals::Kind::Open { .. }));
        let feasible = matches!(self.outcome.status, Status::Converged(_) | Status::Stalled(_));
        feasible && !open && task.worst(&self.outcome.residuals) < MET
    }
}

/// Other designs to start from.
fn starts<V: Variable>(request: &Request, task: &Task<'_, V>) -> Vec<Vec<f64>> {
    let variables = &task.statement.variables;
    let count = request.search.starts.saturating_sub(1) as usize;
    let Ok(mut sequence) = Sobol::new(variables.len()) else { return vec![] };
    for _ in 0..=request.search.seed {
        // The first point is a corner of the bounds.
        sequence.next();
    }
    let place = |point: Vec<f64>| {
        let parts = point.iter().zip(variables);
        let mut point: Vec<f64> =
            parts.map(|(part, v)| v.lower + part * (v.upper - v.lower)).collect();
        task.limits.pull(&mut point);
        point
    };
    sequence.take(count).map(place).collect()
}

/// The order of outcomes: kept constraints first, then small objectives.
fn rank(outcome: &Outcome) -> (u8, f64) {
    match &outcome.status {
        Status::Converged(_) => (0, outcome.objective),
        Status::Stalled(kkt) | Status::Iterations(kkt) if kkt.violation <= KEPT => {
            (0, outcome.objective)
        }
        // What contradicts itself says more than a search that has not ended.
        Status::Infeasible(conflict) => {
            (1, conflict.violations.iter().map(|violation| violation.abs()).sum())
        }
        Status::Stalled(kkt) | Status::Iterations(kkt) => (2, kkt.violation),
        Status::EvaluationFailed(_) => (3, 0.0),
    }
}
