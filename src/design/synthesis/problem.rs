//! The request as a nonlinear program.

use super::Obstacle;
use super::goals::{Goals, Kind, values};
use super::limits::Limits;
use super::trial::Trial;
use crate::design::request::Request;
use crate::design::sqp::{self, Evaluation, Failure, Statement};
use crate::model::Model;
use crate::rig::Variable;

/// What it counts to change nothing without need: changes over the whole of the bounds, times this, are
/// residuals, too. Met targets are off by less than its square then.
const STILLNESS: f64 = 1e-4;

/// The part of the bounds that is a typical change.
const TYPICAL: f64 = 0.25;

/// A request for a specimen.
pub(super) struct Task<'a, V> {
    pub request: &'a Request,
    pub trial: Trial<V>,
    pub goals: Goals,
    pub limits: Limits,
    pub statement: Statement,
    /// The factors of the model as it is (SI), target by target.
    pub before: Vec<Vec<Option<f64>>>,
    /// The last reason why a design had no value.
    pub obstacle: Option<Obstacle>,
    wheel: usize,
    ranges: Vec<f64>,
}

impl<'a, V: Variable> Task<'a, V> {
    /// Sets a request up.
    ///
    /// # Errors
    /// [`Obstacle`] where the model itself does not reach the states, or has no such factors.
    pub fn new(request: &'a Request, model: &Model, mut trial: Trial<V>) -> Result<Self, Obstacle> {
        let start: Vec<f64> = request.variables.iter().map(|variable| variable.start).collect();
        trial.set(&start)?;
        let before = values(request, &mut trial)?;
        let undefined = |(target, values): (_, &Vec<Option<f64>>)| {
            let target: &crate::design::request::Target = target;
            values.contains(&None).then(|| target.name.clone())
        };
        if let Some(name) = request.targets.iter().zip(&before).find_map(undefined) {
            return Err(Obstacle::Undefined(name));
        }
        let own: Vec<Vec<f64>> =
            before.iter().map(|values| values.iter().flatten().copied().collect()).collect();
        let mut goals = Goals::of(request, model, trial.sides(), &own);
        let limits = Limits::of(request, model, &trial, &mut goals);
        let variable = |variable: &crate::design::request::Variable| {
            let [lower, upper] = variable.bounds;
            sqp::Variable { lower, upper, typical: TYPICAL * (upper - lower) }
        };
        let mut weights = goals.weights.clone();
        weights.extend(request.variables.iter().map(|_| STILLNESS));
        let statement = Statement {
            variables: request.variables.iter().map(variable).collect(),
            weights,
            constraints: goals.constraints.clone(),
        };
        let wheel = match trial.sides() {
            1 => 0,
            _ => model.side.index(),
        };
        let ranges = request.variables.iter().map(|v| v.bounds[1] - v.bounds[0]).collect();
        let obstacle = None;
        Ok(Self { request, trial, goals, limits, statement, before, obstacle, wheel, ranges })
    }

    /// The model as it is.
    pub fn start(&self) -> Vec<f64> {
        self.request.variables.iter().map(|variable| variable.start).collect()
    }

    /// The factors (SI) for other parameters.
    ///
    /// # Errors
    /// [`Obstacle`].
    pub fn values(&mut self, x: &[f64]) -> Result<Vec<Vec<Option<f64>>>, Obstacle> {
        self.trial.set(x)?;
        values(self.request, &mut self.trial)
    }

    /// The largest difference of a target that is no constraint at one state, in tolerances and weighted.
    pub fn worst(&self, residuals: &[f64]) -> f64 {
        let soft = residuals.iter().zip(&self.goals.weights);
        soft.fold(0.0, |worst: f64, (residual, weight)| worst.max((residual * weight).abs()))
    }

    /// Gives single targets other weights, as a trade-off does: zero leaves them out.
    pub fn weigh(&mut self, target: usize, factor: f64) {
        for wish in self.goals.wishes.iter_mut().filter(|wish| wish.target == target) {
            match &mut wish.kind {
                Kind::Residual { row, .. } | Kind::Band { row, .. } => {
                    self.goals.weights[*row] *= factor;
                    self.statement.weights[*row] *= factor;
                }
                Kind::Open { factor: own } => *own *= factor,
                Kind::Hard { .. } => {}
            }
        }
    }

    fn try_evaluate(&mut self, x: &[f64], out: &mut Evaluation) -> Result<(), Obstacle> {
        let n = x.len();
        self.trial.set(x)?;
        self.limits.evaluate_parameters(x, out);
        let first = self.goals.weights.len();
        for (k, variable) in self.request.variables.iter().enumerate() {
            out.residuals[first + k] = (x[k] - variable.start) / self.ranges[k];
            out.residual_jacobian[(first + k) * n + k] = 1.0 / self.ranges[k];
        }
        for (state, target) in self.goals.states.iter().enumerate() {
            self.trial.go_to(target)?;
            let reached = self.trial.reached()?;
            self.goals.evaluate(self.request, state, &reached, out)?;
            self.limits.evaluate(state, self.wheel, &reached, out);
        }
        Ok(())
    }
}

impl<V: Variable> sqp::Problem for Task<'_, V> {
    fn evaluate(&mut self, x: &[f64], out: &mut Evaluation) -> Result<(), Failure> {
        self.try_evaluate(x, out).map_err(|obstacle| {
            let words = obstacle.to_string();
            self.obstacle = Some(obstacle);
            Failure(words)
        })
    }
}
