//! The request as a nonlinear program.

use super::Obstacle;
use super::goals::{Goals, Kind, values};
use super::limits::Limits;
use super::spread::{Deviation, Spread};
use super::trial::Trial;
use crate::design::request::Request;
use crate::design::sqp::{self, Constraint, Evaluation, Failure, Statement};
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
    /// The spread that is to be small, where one is.
    pub spread: Option<Spread>,
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
            // Where points may not go far, the search should not begin with longer steps.
            let movements = [request.limits.movement, request.limits.total_movement];
            let movements = movements.into_iter().flatten();
            let movements = movements.filter(|_| variable.parameter.point().is_some());
            let range = movements.fold(upper - lower, |range, most| range.min(2.0 * most));
            sqp::Variable { lower, upper, typical: TYPICAL * range }
        };
        let mut weights = goals.weights.clone();
        weights.extend(request.variables.iter().map(|_| STILLNESS));
        let spread = Spread::of(request, model, &mut trial, &goals, weights.len());
        weights.extend(spread.iter().flat_map(Spread::weights));
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
        Ok(Self {
            request,
            trial,
            goals,
            limits,
            statement,
            before,
            obstacle,
            spread,
            wheel,
            ranges,
        })
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

    /// The spread of the model and of a design; none where the request asks for none.
    ///
    /// # Errors
    /// [`Obstacle`].
    pub fn deviations(&mut self, x: &[f64]) -> Result<Vec<Deviation>, Obstacle> {
        let start = self.start();
        let Self { spread, trial, goals, request, .. } = self;
        match spread {
            Some(spread) => spread.deviations(trial, goals, request, [&start, x]),
            None => Ok(vec![]),
        }
    }

    /// The residuals of soft targets that have these factors (SI).
    pub fn residuals(&self, factors: &[Vec<Option<f64>>]) -> Vec<f64> {
        let mut residuals = vec![0.0; self.goals.weights.len()];
        let mut counts = vec![0; self.request.targets.len()];
        for wish in &self.goals.wishes {
            let value = factors[wish.target][counts[wish.target]].unwrap_or(f64::NAN);
            counts[wish.target] += 1;
            match wish.kind {
                Kind::Residual { row, wanted } => residuals[row] = value - wanted,
                Kind::Band { row, limits: [least, most] } => {
                    residuals[row] = (value - most).max(0.0) + (value - least).min(0.0);
                }
                Kind::Hard { .. } | Kind::Open { .. } => {}
            }
        }
        residuals
    }

    /// The largest difference of a target that is no constraint at one state, in tolerances and weighted.
    pub fn worst(&self, residuals: &[f64]) -> f64 {
        let soft = residuals.iter().zip(&self.goals.weights);
        soft.fold(0.0, |worst: f64, (residual, weight)| worst.max((residual * weight).abs()))
    }

    /// Gives targets other weights, as factors of their own: zero leaves one out.
    pub fn weigh(&mut self, factors: &[f64]) {
        self.goals.factors.copy_from_slice(factors);
        for wish in &self.goals.wishes {
            if let Kind::Residual { row, .. } | Kind::Band { row, .. } = wish.kind {
                self.statement.weights[row] = factors[wish.target] * self.goals.weights[row];
            }
        }
    }

    /// Makes how far a target is off a constraint with the greatest value, or no longer.
    pub fn bound(&mut self, target: Option<(usize, f64)>) {
        self.statement.constraints.clone_from(&self.goals.constraints);
        self.goals.bounded = target.map(|(target, most)| {
            // Squares of differences are smooth where the differences are.
            let upper = if self.goals.is_open(target) { most } else { most * most };
            let (lower, typical) = (f64::NEG_INFINITY, upper.abs().max(1.0));
            self.statement.constraints.push(Constraint { lower, upper, typical });
            (target, self.statement.constraints.len() - 1)
        });
    }

    fn try_evaluate(&mut self, x: &[f64], out: &mut Evaluation) -> Result<(), Obstacle> {
        let n = x.len();
        self.trial.set(x)?;
        self.limits.evaluate_parameters(x, out);
        let first = self.goals.weights.len();
        // What follows is in the order of the weights: stillness, then spread.
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
        if let Some(spread) = &self.spread {
            spread.evaluate(&mut self.trial, &self.goals, self.request, x, out)?;
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
