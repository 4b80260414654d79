//! The spread of factors under tolerances of hard points.
//!
//! To first order the variance of a factor is Σ (∂f/∂p σ_p)² over all coordinates p. So its derivatives are residuals,
//! each times the deviation of its coordinate. How they change with the variables is the one derivative of synthesis
//! that is differenced: it would be a second one. What is differenced are exact first derivatives.

use super::Obstacle;
use super::goals::{Goals, dual, plain};
use super::trial::Trial;
use crate::design::parameter::Parameter;
use crate::design::request::Request;
use crate::design::sqp::Evaluation;
use crate::model::Model;
use crate::rig::{Pose, Variable};

/// The part of the range of a variable over which derivatives are differenced.
const STEP: f64 = 1e-4;

/// What is to spread little, as rows of residuals.
#[derive(Clone, Debug)]
pub(super) struct Spread {
    /// The first row.
    first: usize,
    /// Wishes by their places, each with the weight of its spread.
    wishes: Vec<(usize, f64)>,
    /// Standard deviations (m) of the coordinates that have one.
    deviations: Vec<f64>,
    /// The steps of differences.
    steps: Vec<f64>,
}

/// The spread of one factor at one state (SI): standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The target, by its place in the request.
    pub target: usize,
    /// The state, by its place in the target.
    pub state: usize,
    /// Of the model, to first order.
    pub before: f64,
    /// Of the design, to first order.
    pub after: f64,
    /// Of the design, of random designs; `None` where some of them could not be evaluated.
    pub sampled: Option<f64>,
}

impl Spread {
    /// The spread that a request asks for; the trial is told of its coordinates.
    pub fn of<V: Variable>(
        request: &Request,
        model: &Model,
        trial: &mut Trial<V>,
        goals: &Goals,
        first: usize,
    ) -> Option<Self> {
        let robustness = request.robustness.as_ref()?;
        let all = Parameter::coordinates(model);
        let each = all.into_iter().zip(robustness.deviations.iter().flat_map(|d| [*d; 3]));
        let (parameters, deviations): (Vec<_>, Vec<_>) = each.filter(|(_, d)| *d > 0.0).unzip();
        trial.tolerate(parameters);
        let wishes = goals.wishes.iter().enumerate();
        let wishes = wishes.filter(|(_, wish)| robustness.targets.contains(&wish.target));
        let weight = |index: usize| {
            let target = &request.targets[index];
            #[allow(clippy::cast_precision_loss)] // A target has a handful of states.
            let states = target.states.len() as f64;
            robustness.weight / target.tolerance / states.sqrt()
        };
        let ranges = request.variables.iter().map(|v| STEP * (v.bounds[1] - v.bounds[0]));
        Some(Self {
            first,
            wishes: wishes.map(|(index, wish)| (index, weight(wish.target))).collect(),
            deviations,
            steps: ranges.collect(),
        })
    }

    /// The weights of the rows.
    pub fn weights(&self) -> impl Iterator<Item = f64> + '_ {
        let count = self.deviations.len();
        self.wishes.iter().flat_map(move |&(_, weight)| std::iter::repeat_n(weight, count))
    }

    /// Writes residuals and their derivatives.
    pub fn evaluate<V: Variable>(
        &self,
        trial: &mut Trial<V>,
        goals: &Goals,
        request: &Request,
        x: &[f64],
        out: &mut Evaluation,
    ) -> Result<(), Obstacle> {
        let n = x.len();
        let here = self.products(trial, goals, request, x)?;
        for (row, value) in here.iter().enumerate() {
            out.residuals[self.first + row] = *value;
        }
        for (k, step) in self.steps.iter().enumerate() {
            let mut moved = x.to_vec();
            // Into the bounds, where x lies on the upper one.
            let way = if x[k] + step > request.variables[k].bounds[1] { -step } else { *step };
            moved[k] += way;
            let there = self.products(trial, goals, request, &moved)?;
            for (row, (here, there)) in here.iter().zip(there).enumerate() {
                out.residual_jacobian[(self.first + row) * n + k] = (there - here) / way;
            }
        }
        Ok(())
    }

    /// ∂f/∂p σ_p of all wishes and coordinates.
    fn products<V: Variable>(
        &self,
        trial: &mut Trial<V>,
        goals: &Goals,
        request: &Request,
        x: &[f64],
    ) -> Result<Vec<f64>, Obstacle> {
        let count = self.deviations.len();
        let mut products = vec![0.0; self.wishes.len() * count];
        trial.set(x)?;
        for (state, target) in goals.states.iter().enumerate() {
            let own = |index: usize| goals.wishes[index].state == state;
            if !self.wishes.iter().any(|&(index, _)| own(index)) {
                continue;
            }
            trial.go_to(target)?;
            let reached = trial.tolerances()?;
            for (row, &(index, _)) in self.wishes.iter().enumerate().filter(|(_, w)| own(w.0)) {
                let wish = &goals.wishes[index];
                let target = &request.targets[wish.target];
                let (_, by) = reached
                    .of(|moved| dual(target, wish.wheel, moved))
                    .ok_or_else(|| Obstacle::Undefined(target.name.clone()))?;
                for (k, (by, deviation)) in by.iter().zip(&self.deviations).enumerate() {
                    products[row * count + k] = by * deviation;
                }
            }
        }
        Ok(products)
    }

    /// The spread of the model and of a design.
    pub fn deviations<V: Variable>(
        &self,
        trial: &mut Trial<V>,
        goals: &Goals,
        request: &Request,
        [before, after]: [&[f64]; 2],
    ) -> Result<Vec<Deviation>, Obstacle> {
        let count = self.deviations.len();
        let sums = |products: Vec<f64>| -> Vec<f64> {
            let root = |part: &[f64]| part.iter().map(|p| p * p).sum::<f64>().sqrt();
            products.chunks_exact(count.max(1)).map(root).collect()
        };
        let before = sums(self.products(trial, goals, request, before)?);
        let first_order = sums(self.products(trial, goals, request, after)?);
        let sampled = self.sampled(trial, goals, request, after);
        let mut list = vec![];
        for (row, &(index, _)) in self.wishes.iter().enumerate() {
            let target = goals.wishes[index].target;
            let earlier = goals.wishes[..index].iter().filter(|wish| wish.target == target);
            list.push(Deviation {
                target,
                state: earlier.count(),
                before: before[row],
                after: first_order[row],
                sampled: sampled.as_ref().map(|sampled| sampled[row]),
            });
        }
        Ok(list)
    }

    /// Standard deviations of random designs about one.
    fn sampled<V: Variable>(
        &self,
        trial: &mut Trial<V>,
        goals: &Goals,
        request: &Request,
        x: &[f64],
    ) -> Option<Vec<f64>> {
        let robustness = request.robustness.as_ref()?;
        let mut random = fastrand::Rng::with_seed(u64::from(request.search.seed));
        // Mean and sum of squares about it, updated sample by sample (Welford 1962).
        let mut moments = vec![(0.0, 0.0); self.wishes.len()];
        for sample in 1..=robustness.samples {
            let offsets: Vec<f64> =
                self.deviations.iter().map(|deviation| deviation * normal(&mut random)).collect();
            trial.set_off(x, &offsets).ok()?;
            for (state, target) in goals.states.iter().enumerate() {
                let own = |index: usize| goals.wishes[index].state == state;
                if !self.wishes.iter().any(|&(index, _)| own(index)) {
                    continue;
                }
                trial.go_to(target).ok()?;
                let poses: Vec<Pose<f64>> = trial.poses();
                for (row, &(index, _)) in self.wishes.iter().enumerate().filter(|(_, w)| own(w.0)) {
                    let wish = &goals.wishes[index];
                    let value = plain(&request.targets[wish.target], &poses)?;
                    let (mean, squares) = &mut moments[row];
                    let off = value - *mean;
                    *mean += off / f64::from(sample);
                    *squares += off * (value - *mean);
                }
            }
        }
        let others = f64::from(robustness.samples.max(2) - 1);
        Some(
            moments.into_iter().map(|(_, squares): (f64, f64)| (squares / others).sqrt()).collect(),
        )
    }
}

/// A random number of mean 0 and deviation 1 (Box and Muller 1958).
fn normal(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}
