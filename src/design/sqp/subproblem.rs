//! The quadratic subproblem of one iteration.

use faer::{Col, Scale};

use super::active_set::{self, BEYOND, Limits, Places, Step};
use super::curvature::Curvature;
use super::interior::{Answer, Program};
use super::model::Model;
use super::point::Point;
use super::problem::Statement;

/// A penalty exceeds multipliers by this factor at least, and by the next when it is raised.
const ABOVE_MULTIPLIERS: f64 = 1.1;
const RAISED: f64 = 2.0;
/// The part of the possible decrease of the linearised violation that a step has to reach.
const STEERING: f64 = 0.5;
/// The part of a violation that clarabel leaves undetermined.
const LEAST_GAIN: f64 = 1e-8;
/// How often the penalty is raised tenfold for that in one iteration.
const STEERS: usize = 8;
/// Shorter steps, in typical changes, are rounding.
const ROUNDING_STEP: f64 = 1e-13;
/// An approximate step that is shorter, in typical changes, is none.
const NO_STEP: f64 = 1e-6;
/// The linearised constraints hold if no more than this part of their violation is left.
const MET: f64 = 1e-7;

/// The step that a subproblem asks for.
pub(super) struct Found {
    pub step: Step,
    pub limits: Limits,
    /// The penalty from now on.
    pub penalty: f64,
    /// By how much the model of the merit function falls, above zero unless the point is a solution.
    pub decrease: f64,
    /// Whether the linearised constraints hold after the step.
    pub feasible: bool,
}

/// Where a subproblem is stated.
pub(super) struct Stage<'a> {
    pub point: &'a Point,
    pub statement: &'a Statement,
    pub radius: f64,
    /// Largest violation that counts as none.
    pub feasibility: f64,
    pub penalty: f64,
    pub curvature: &'a Curvature,
    /// Multipliers of the last subproblem.
    pub y: &'a Col<f64>,
    /// Whether they are those of penalties.
    pub y_penalised: bool,
}

impl Stage<'_> {
    fn limits(&self) -> Limits {
        Limits::new(self.point, self.statement, self.radius)
    }

    /// The model of the objective, with the curvature of the constraints for a penalty: multipliers
    /// that are penalties grow with it.
    fn model(&self, penalty: f64) -> Model<'_> {
        let grown = self.y_penalised && self.penalty > 0.0;
        let growth = if grown { penalty / self.penalty } else { 1.0 };
        let size = growth * self.y.norm_l2();
        Model::new(self.point, self.curvature.second(self.point, size))
    }

    /// Solves the subproblem, with a guess of the working set to start from. There is no solution only if
    /// arithmetic breaks down.
    pub fn solve(&self, guess: &Places) -> Option<Found> {
        let model = self.model(self.penalty);
        let limits = self.limits();
        if let Some(step) = active_set::solve(&model, &limits, None, guess)
            && let Some(found) = self.judge(&model, &limits, step, self.penalty)
        {
            return Some(found);
        }
        let convex = model.convexified();
        let safe = convex.as_ref().unwrap_or(&model);
        let gradient = self.point.gradient();
        let program = Program {
            hessian: Some(&safe.hessian),
            gradient: &gradient,
            rows: &self.point.rows,
            limits: &limits,
            penalty: None,
        };
        if let Answer::Solved(rough) = program.solve() {
            let found = self.polish([&model, safe], &limits, None, &rough, self.penalty);
            if found.is_some() {
                return found;
            }
        }
        self.penalised(&limits)
    }

    /// The step where the linearised constraints contradict each other within the trust region. The
    /// penalty is raised until the step takes away a good part of what a step that cares for nothing but
    /// the constraints does (the steering rules of Byrd, Nocedal and Waltz, *Optim. Methods
    /// Softw.* 23 (2008) 197–213, with the curvature of the constraints).
    fn penalised(&self, limits: &Limits) -> Option<Found> {
        let violation = self.point.violation();
        let (mut penalty, share) = if self.y_penalised {
            (self.penalty, self.y.norm_l2() / self.penalty)
        } else {
            (self.penalty.max(balance(self.point)), 0.0)
        };
        let bends = Model::of_constraints(self.point, Scale(share) * self.curvature.constraint());
        let convex = bends.convexified();
        let zero = Col::zeros(self.point.x.len());
        let bends = &convex.as_ref().unwrap_or(&bends).hessian;
        let program = Program {
            hessian: (share > 0.0).then_some(bends),
            gradient: &zero,
            rows: &self.point.rows,
            limits,
            penalty: Some(1.0),
        };
        let possible = match program.solve() {
            Answer::Solved(step) => violation - self.point.linear_violation(&step.step),
            _ => 0.0,
        };
        let gradient = self.point.gradient();
        let mut best = None;
        for _ in 0..STEERS {
            let model = self.model(penalty);
            let convex = model.convexified();
            let safe = convex.as_ref().unwrap_or(&model);
            let (hessian, allowed) = (Some(&safe.hessian), Some(penalty));
            let program = Program { hessian, gradient: &gradient, penalty: allowed, ..program };
            if let Answer::Solved(rough) = program.solve()
                && let Some(found) = self.polish([&model, safe], limits, allowed, &rough, penalty)
            {
                let reached = violation - self.point.linear_violation(&found.step.step);
                best = Some(found);
                if reached >= STEERING * possible - LEAST_GAIN * violation {
                    break;
                }
            }
            penalty *= 10.0;
        }
        best
    }

    /// The exact solution that an approximate one suggests: of the true model if that has one, otherwise
    /// of the convex one, otherwise the approximate one itself.
    fn polish(
        &self,
        models: [&Model; 2],
        limits: &Limits,
        allowed: Option<f64>,
        rough: &Step,
        penalty: f64,
    ) -> Option<Found> {
        for model in models {
            let exact = active_set::solve(model, limits, allowed, &rough.places);
            let found = exact.and_then(|step| self.judge(model, limits, step, penalty));
            if found.is_some() {
                return found;
            }
        }
        let rough = rough.clone().without_passive_multipliers();
        let found = self.judge(models[1], limits, rough.clone(), penalty);
        if found.is_some() || rough.step.norm_max() > NO_STEP {
            return found;
        }
        // The point itself is the solution as far as clarabel can tell.
        let step = Step { step: Col::zeros(self.point.x.len()), ..rough };
        self.judge(models[1], limits, step, penalty)
    }

    /// Raises the penalty above the multipliers and, as long as the step brings the constraints nearer,
    /// until the merit function falls by a fair part of that. None if it does not fall.
    fn judge(&self, model: &Model, limits: &Limits, step: Step, mut penalty: f64) -> Option<Found> {
        let before = self.point.violation();
        let after = self.point.linear_violation(&step.step);
        let feasible = after <= (MET * before.min(1.0)).max(0.1 * self.feasibility);
        if feasible && penalty < ABOVE_MULTIPLIERS * step.y.norm_max() {
            penalty = RAISED * step.y.norm_max();
        }
        let gain = model.decrease(&step.step);
        // The active-set method may leave so much of each constraint.
        let slack = 10.0 * BEYOND * self.statement.constraints.len() as f64;
        let beyond = |sum: f64| if sum <= slack { 0.0 } else { sum };
        let nearer = before - beyond(after);
        if nearer > 0.01 * self.feasibility && gain + 0.9 * penalty * nearer < 0.0 {
            penalty = -gain / (0.5 * nearer);
        }
        let decrease = gain + penalty * nearer;
        // Rounding may leave a decrease of nothing with the wrong sign.
        let rounding = 1e-14 * (self.point.objective().abs() + penalty * before);
        let nothing = step.step.norm_max() <= ROUNDING_STEP;
        let sound = decrease.is_finite() && (decrease >= -rounding || nothing);
        sound.then(|| Found { step, limits: limits.clone(), penalty, decrease, feasible })
    }

    /// A second-order correction: the same subproblem with the constraints at a trial point, so that
    /// their curvature no longer matters (Nocedal and Wright, §18.3).
    pub fn corrected(&self, found: &Found, trial: &Point) -> Option<Step> {
        let model = self.model(found.penalty);
        let mut limits = found.limits.clone();
        let bent = &trial.constraints - &self.point.rows * &found.step.step;
        limits.relative_to(self.point, &bent);
        let allowed = (!found.feasible).then_some(found.penalty);
        active_set::solve(&model, &limits, allowed, &found.step.places)
    }
}

/// A penalty of the size that balances the gradient of the objective.
pub(super) fn balance(point: &Point) -> f64 {
    let rows = &point.rows;
    let longest = (0..rows.nrows()).fold(0.0f64, |max, i| max.max(rows.row(i).norm_max()));
    let ratio = point.gradient().norm_max() / longest;
    if ratio.is_finite() && ratio > 0.0 { 10.0 * ratio } else { 1.0 }
}

impl Limits {
    /// Bounds, trust region and linearised constraints, relative to a point.
    pub fn new(point: &Point, statement: &Statement, radius: f64) -> Self {
        let sides = statement.variables.iter().zip(&point.x);
        let (lower, upper) = sides
            .map(|(variable, x)| {
                let lower = ((variable.lower - x) / variable.typical).min(0.0).max(-radius);
                (lower, ((variable.upper - x) / variable.typical).max(0.0).min(radius))
            })
            .unzip();
        let mut limits = Limits { lower, upper, row_lower: vec![], row_upper: vec![] };
        limits.relative_to(point, &point.constraints);
        limits
    }

    /// Sets the limits of the change of the constraints from these values.
    fn relative_to(&mut self, point: &Point, constraints: &Col<f64>) {
        let less = |limits: &[f64]| -> Vec<f64> {
            limits.iter().enumerate().map(|(i, limit)| limit - constraints[i]).collect()
        };
        self.row_lower = less(&point.row_lower);
        self.row_upper = less(&point.row_upper);
    }
}

/// The step with the least sum of linearised violations within limits, and that sum.
pub(super) fn least_violation(point: &Point, limits: &Limits) -> Option<(Step, f64)> {
    let zero = Col::zeros(point.x.len());
    let program =
        Program { hessian: None, gradient: &zero, rows: &point.rows, limits, penalty: Some(1.0) };
    let Answer::Solved(step) = program.solve() else { return None };
    let changes = &point.rows * &step.step;
    let pairs = limits.row_lower.iter().zip(&limits.row_upper).enumerate();
    let sum = pairs
        .map(|(i, (&lower, &upper))| super::point::excess(changes[i], lower, upper).abs())
        .sum();
    Some((*step, sum))
}
