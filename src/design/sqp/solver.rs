//! The iteration.

use faer::Col;

use super::active_set::{Places, Step};
use super::conflict;
use super::convergence::{NEAR, active_bound, active_side, kkt};
use super::curvature::Curvature;
use super::outcome::{ActiveSide, Kkt, Outcome, Settings, Status};
use super::point::Point;
use super::problem::{Evaluation, Failure, Mistake, Problem, Statement};
use super::subproblem::{Found, Stage, balance};

/// A step is taken if the merit function falls by this part of what the model promises.
const TAKEN: f64 = 1e-4;
/// Below the first part the trust region shrinks, above the second it grows.
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// Factors of the trust region.
const SHRINK: f64 = 0.25;
const GROW: f64 = 2.5;
/// A penalty is lowered to this multiple of the largest multiplier, and so often at most.
const RELAXED: f64 = 2.0;
const RELAXATIONS: usize = 20;
/// The least penalty, as a part of the one that balances the objective at the start.
const LEAST: f64 = 1e-4;
/// A penalty that leaves a violation for the sake of the objective is raised by this factor.
const RAISED: f64 = 100.0;
/// The largest and smallest trust region, in typical changes.
const LARGEST: f64 = 1e6;
const SMALLEST: f64 = 1e-13;
/// Where steps shorter than this do not help, rounding is in the way.
const ROUNDING_STEP: f64 = 1e-6;
/// A decrease that is this part of the first objective is none: residuals that could be met have then
/// lost thirteen digits.
const NOTHING: f64 = 1e-26;
/// A decrease by less than this part is slow.
const SLOW: f64 = 0.01;
/// Rounding of the merit function, relative.
const ROUNDING: f64 = 1e-14;

/// Solves a problem from a start, which is moved into the bounds.
///
/// # Errors
/// [`Mistake`] for a statement, start or settings that make no sense. Everything that happens on the
/// way is a [`Status`].
pub fn solve(
    problem: &mut dyn Problem,
    statement: &Statement,
    start: &[f64],
    settings: &Settings,
) -> Result<Outcome, Mistake> {
    statement.check(start)?;
    settings.check()?;
    let sides = start.iter().zip(&statement.variables);
    let x: Vec<f64> = sides.map(|(x, variable)| x.clamp(variable.lower, variable.upper)).collect();
    let mut raw = Evaluation::zeros(statement);
    match Point::evaluate(problem, statement, x.clone(), &mut raw) {
        Ok(point) => Ok(Search::new(problem, statement, settings, point, raw).run()),
        Err(failure) => Ok(nowhere(statement, x, failure)),
    }
}

/// The outcome of a start that has no value.
fn nowhere(statement: &Statement, x: Vec<f64>, failure: Failure) -> Outcome {
    let (n, c) = (x.len(), statement.constraints.len());
    Outcome {
        status: Status::EvaluationFailed(failure),
        x,
        objective: 0.0,
        residuals: vec![],
        constraints: vec![],
        multipliers: vec![0.0; c],
        bound_multipliers: vec![0.0; n],
        active: vec![None; c],
        active_bounds: vec![None; n],
        iterations: 0,
        evaluations: 1,
    }
}

/// What came of a trial step.
enum Trial {
    /// A point and the part of the promised decrease that it has.
    Point(Box<Point>, f64),
    Failed(Failure),
}

struct Search<'a> {
    problem: &'a mut dyn Problem,
    statement: &'a Statement,
    settings: &'a Settings,
    raw: Evaluation,
    point: Point,
    curvature: Curvature,
    /// Size of the objective at the start.
    first_objective: f64,
    radius: f64,
    penalty: f64,
    least_penalty: f64,
    /// Multipliers of the last subproblem.
    y: Col<f64>,
    /// Whether they are those of penalties.
    y_penalised: bool,
    places: Places,
    /// How often the penalty may still be lowered.
    relaxations: usize,
    /// Why the last trial could not be evaluated.
    failure: Option<Failure>,
    iterations: usize,
    evaluations: usize,
}

impl<'a> Search<'a> {
    fn new(
        problem: &'a mut dyn Problem,
        statement: &'a Statement,
        settings: &'a Settings,
        point: Point,
        raw: Evaluation,
    ) -> Self {
        let (n, c) = (statement.variables.len(), statement.constraints.len());
        Self {
            problem,
            statement,
            settings,
            raw,
            curvature: Curvature::new(&point, settings.radius),
            first_objective: point.objective().abs(),
            least_penalty: LEAST * balance(&point),
            penalty: LEAST * balance(&point),
            point,
            radius: settings.radius,
            y: Col::zeros(c),
            y_penalised: false,
            places: Places::between(n, c),
            relaxations: RELAXATIONS,
            failure: None,
            iterations: 0,
            evaluations: 1,
        }
    }

    fn run(mut self) -> Outcome {
        let mut last = self.no_step();
        loop {
            let status = match self.iterate(&mut last) {
                Some(status) => status,
                None if self.iterations >= self.settings.iterations
                    || self.evaluations >= self.settings.evaluations =>
                {
                    Status::Iterations(kkt(&self.point, self.statement, &last))
                }
                None => continue,
            };
            return self.outcome(status, &last);
        }
    }

    fn no_step(&self) -> Step {
        let (n, c) = (self.point.x.len(), self.y.nrows());
        let places = Places::between(n, c);
        Step { step: Col::zeros(n), y: Col::zeros(c), z: Col::zeros(n), places }
    }

    /// One subproblem and one trial step, and a status if it is the last.
    fn iterate(&mut self, last: &mut Step) -> Option<Status> {
        self.iterations += 1;
        let Some(found) = self.stage().solve(&self.places) else {
            return Some(self.stuck(kkt(&self.point, self.statement, last)));
        };
        self.penalty = found.penalty;
        self.y = found.step.y.clone();
        self.y_penalised = !found.feasible;
        self.places = found.step.places.clone();
        *last = found.step.clone();
        let now = kkt(&self.point, self.statement, last);
        // Flat minima, where steps stay long, end where nothing is left to gain.
        let merit = self.point.merit(self.penalty).abs();
        let end = now.step <= self.settings.step && found.decrease <= ROUNDING * merit
            || found.decrease <= NOTHING * self.first_objective
            || now.stationarity <= self.settings.optimality.powi(2)
                && found.decrease <= SLOW * merit;
        if found.feasible && now.holds(self.settings) && end {
            return Some(Status::Converged(now));
        }
        if !found.feasible
            && let Some(conflict) =
                conflict::find(&self.point, self.statement, self.settings.feasibility)
        {
            return Some(Status::Infeasible(conflict));
        }
        let length = found.step.step.norm_max();
        if !found.feasible && length <= NEAR {
            // What is left of the violation is what this penalty leaves to the objective.
            self.penalty *= RAISED;
            return None;
        }
        if self.end_of(&found.step, &found) == self.point.x {
            return Some(self.stuck(now));
        }
        match self.attempt(&found) {
            Trial::Point(trial, ratio) => {
                self.failure = None;
                if ratio > TAKEN {
                    self.point = *trial;
                    self.relax(&found);
                    if ratio > GOOD && length > 0.8 * self.radius {
                        self.radius = (GROW * self.radius).min(LARGEST);
                    }
                } else if length <= ROUNDING_STEP && now.holds(self.settings) {
                    return Some(Status::Converged(now));
                }
                if ratio < POOR {
                    self.radius = SHRINK * length.min(self.radius);
                }
            }
            Trial::Failed(failure) => {
                self.failure = Some(failure);
                self.radius = SHRINK * length.min(self.radius);
            }
        }
        (self.radius < SMALLEST).then(|| self.stuck(now))
    }

    /// Lowers a penalty that is far above the multipliers: it makes the way along curved constraints slow.
    /// A limited number of times, so that it cannot go to and fro for ever.
    fn relax(&mut self, found: &Found) {
        let enough = RELAXED * found.step.y.norm_max();
        if found.feasible && self.relaxations > 0 && self.penalty > 4.0 * enough {
            self.penalty = enough.max(0.25 * self.penalty).max(self.least_penalty);
            self.relaxations -= 1;
        }
    }

    /// The status where the trust region has no size any more.
    fn stuck(&mut self, now: Kkt) -> Status {
        match self.failure.take() {
            _ if now.holds(self.settings) => Status::Converged(now),
            Some(failure) => Status::EvaluationFailed(failure),
            None => match conflict::find(&self.point, self.statement, self.settings.feasibility) {
                Some(conflict) => Status::Infeasible(conflict),
                None => Status::Stalled(now),
            },
        }
    }

    /// Tries a step, and a corrected one where the curvature of constraints spoils it.
    fn attempt(&mut self, found: &Found) -> Trial {
        let trial = match self.evaluate(&found.step, found) {
            Ok(trial) => trial,
            Err(failure) => return Trial::Failed(failure),
        };
        self.curvature.update(&self.point, &trial, &found.step.step, &found.step.y);
        let ratio = self.ratio(&trial, found);
        let promised = self.point.linear_violation(&found.step.step);
        let bent = self.penalty * (trial.violation() - promised) > 0.5 * found.decrease;
        if ratio > TAKEN || !bent || self.evaluations >= self.settings.evaluations {
            return Trial::Point(Box::new(trial), ratio);
        }
        let corrected = self.stage().corrected(found, &trial);
        if let Some(corrected) = corrected
            && let Ok(better) = self.evaluate(&corrected, found)
        {
            self.curvature.update(&self.point, &better, &corrected.step, &found.step.y);
            let better_ratio = self.ratio(&better, found);
            if better_ratio > ratio {
                return Trial::Point(Box::new(better), better_ratio);
            }
        }
        Trial::Point(Box::new(trial), ratio)
    }

    /// The subproblem as things are.
    fn stage(&self) -> Stage<'_> {
        Stage {
            point: &self.point,
            statement: self.statement,
            radius: self.radius,
            feasibility: self.settings.feasibility,
            penalty: self.penalty,
            curvature: &self.curvature,
            y: &self.y,
            y_penalised: self.y_penalised,
        }
    }

    /// The decrease of the merit function relative to what the model promises.
    fn ratio(&self, trial: &Point, found: &Found) -> f64 {
        let (before, after) = (self.point.merit(self.penalty), trial.merit(self.penalty));
        let rounding = ROUNDING * before.abs().max(after.abs());
        (before - after + rounding) / (found.decrease + rounding).max(f64::MIN_POSITIVE)
    }

    fn evaluate(&mut self, step: &Step, found: &Found) -> Result<Point, Failure> {
        self.evaluations += 1;
        let x = self.end_of(step, found);
        Point::evaluate(self.problem, self.statement, x, &mut self.raw)
    }

    /// The variables at the end of a step. A step to a bound ends on it exactly.
    fn end_of(&self, step: &Step, found: &Found) -> Vec<f64> {
        (self.statement.variables.iter().zip(&self.point.x).enumerate())
            .map(|(j, (variable, &x))| {
                let moved = step.step[j];
                let on = |limit: f64, bound: f64| {
                    moved == limit && (bound - x) / variable.typical == limit
                };
                if on(found.limits.lower[j], variable.lower) {
                    variable.lower
                } else if on(found.limits.upper[j], variable.upper) {
                    variable.upper
                } else {
                    (x + moved * variable.typical).clamp(variable.lower, variable.upper)
                }
            })
            .collect()
    }

    fn outcome(self, status: Status, last: &Step) -> Outcome {
        let (variables, constraints) = (&self.statement.variables, &self.statement.constraints);
        let active_bounds: Vec<Option<ActiveSide>> = (0..variables.len())
            .map(|j| active_bound(&self.point, self.statement, last, j))
            .collect();
        let active: Vec<Option<ActiveSide>> =
            (0..constraints.len()).map(|i| active_side(&self.point, last, i)).collect();
        let weights = &self.statement.weights;
        Outcome {
            status,
            objective: self.point.objective(),
            residuals: unweighted(&self.point, weights),
            constraints: (constraints.iter().enumerate())
                .map(|(i, constraint)| self.point.constraints[i] * constraint.typical)
                .collect(),
            multipliers: (constraints.iter().enumerate())
                .map(|(i, constraint)| match active[i] {
                    Some(_) => last.y[i] / constraint.typical,
                    None => 0.0,
                })
                .collect(),
            bound_multipliers: (variables.iter().enumerate())
                .map(|(j, variable)| match active_bounds[j] {
                    Some(_) => last.z[j] / variable.typical,
                    None => 0.0,
                })
                .collect(),
            active,
            active_bounds,
            x: self.point.x,
            iterations: self.iterations,
            evaluations: self.evaluations,
        }
    }
}

/// Residuals without their weights; those of weight zero are zero.
fn unweighted(point: &Point, weights: &[f64]) -> Vec<f64> {
    let pairs = weights.iter().enumerate();
    pairs.map(|(k, &w)| if w == 0.0 { 0.0 } else { point.residuals[k] / w }).collect()
}
