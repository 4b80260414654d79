//! How a solution is asked for and what comes of it.

use super::problem::{Failure, Mistake};

/// When to stop, and how far the first step may go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Largest violation of a constraint at a solution, in its typical change.
    pub feasibility: f64,
    /// Largest gradient of the Lagrangian at a solution, for typical changes of the variables and
    /// relative to the terms that it is the sum of where these are above 1.
    pub optimality: f64,
    /// Largest step that a solution still asks for, in typical changes.
    pub step: f64,
    /// Radius of the first trust region, in typical changes.
    pub radius: f64,
    /// Most iterations.
    pub iterations: usize,
    /// Most evaluations.
    pub evaluations: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            feasibility: 1e-9,
            optimality: 1e-7,
            step: 1e-9,
            radius: 1.0,
            iterations: 200,
            evaluations: 400,
        }
    }
}

impl Settings {
    pub(super) fn check(&self) -> Result<(), Mistake> {
        for (name, value) in [
            ("feasibility", self.feasibility),
            ("optimality", self.optimality),
            ("step", self.step),
            ("radius", self.radius),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Mistake::Setting { name, value });
            }
        }
        Ok(())
    }
}

/// How well the conditions of Karush, Kuhn and Tucker hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kkt {
    /// Gradient of the Lagrangian, as [`Settings::optimality`] measures it.
    pub stationarity: f64,
    /// Largest violation of a constraint, in its typical change.
    pub violation: f64,
    /// The smaller of the multiplier of a constraint or bound and the distance to it, for typical changes;
    /// the largest of all.
    pub complementarity: f64,
    /// The step that the last subproblem asks for, in typical changes.
    pub step: f64,
}

/// The side of a bound or constraint that holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ActiveSide {
    /// The lower limit, or an equation.
    Lower,
    /// The upper limit.
    Upper,
}

/// A constraint or bound that takes part in a contradiction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Member {
    /// A limit of a constraint. An equation has the side from which it cannot be reached.
    Constraint(usize, ActiveSide),
    /// A bound of a variable.
    Bound(usize, ActiveSide),
}

/// Constraints that no small change of the variables brings nearer together. Where they are
/// nonlinear they may still be met elsewhere, which another start finds out.
#[derive(Clone, Debug, PartialEq)]
pub struct Conflict {
    /// By how much each constraint is missed, in its own unit: below zero under the lower limit, above
    /// zero over the upper one.
    pub violations: Vec<f64>,
    /// How much the sum of violations, in typical changes, falls for each unit by which a limit is
    /// relaxed: one number for each constraint, above zero at lower limits.
    pub multipliers: Vec<f64>,
    /// The same for the bounds of the variables.
    pub bound_multipliers: Vec<f64>,
    /// A smallest set that contradicts itself: the linearised members without any one of them can
    /// be met, or brought nearer.
    pub members: Vec<Member>,
}

/// How a solution ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// A local minimum, as far as first derivatives tell.
    Converged(Kkt),
    /// No step makes the merit function smaller although the conditions of a minimum do not hold: a
    /// kink, or functions with more rounding than the settings allow.
    Stalled(Kkt),
    /// The constraints contradict each other.
    Infeasible(Conflict),
    /// The start cannot be evaluated, or points that cannot be evaluated surround the last one.
    EvaluationFailed(Failure),
    /// The iterations or evaluations ran out.
    Iterations(Kkt),
}

/// The best point with all that is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// The variables, within their bounds.
    pub x: Vec<f64>,
    /// ½ Σ (w r)² + φ.
    pub objective: f64,
    /// r without weights.
    pub residuals: Vec<f64>,
    /// c.
    pub constraints: Vec<f64>,
    /// How much the objective rises for each unit by which the active limit of a constraint rises:
    /// at least 0 at lower limits, at most 0 at upper ones.
    pub multipliers: Vec<f64>,
    /// The same for the bounds of the variables.
    pub bound_multipliers: Vec<f64>,
    /// Which side of each constraint holds.
    pub active: Vec<Option<ActiveSide>>,
    /// Which bound of each variable holds.
    pub active_bounds: Vec<Option<ActiveSide>>,
    /// Subproblems that were solved.
    pub iterations: usize,
    /// Points that were evaluated, with those that failed.
    pub evaluations: usize,
}
