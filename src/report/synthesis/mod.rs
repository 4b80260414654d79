//! What became of a request: targets before and after, what moved, what holds the design.

mod json;
mod table;
mod words;

use crate::design::request::{Goal, Request, Target};
use crate::design::synthesis::{Synthesis, Verdict};
use crate::model::{Drive, Model};

/// A synthesis and all that is needed to show it.
#[derive(Clone, Copy)]
pub struct SynthesisReport<'a> {
    /// The model as it was; the report is in its units and axes.
    pub model: &'a Model,
    /// What was asked for.
    pub request: &'a Request,
    /// Which height a travel means.
    pub drive: Drive,
    /// Whether the design meets the targets; of a design that is written that of the written one.
    pub verdict: &'a Verdict,
    /// The factors (SI) of the model, target by target and state by state.
    pub before: &'a [Vec<Option<f64>>],
    /// The new model with its factors; `None` where there is no design.
    pub design: Option<(&'a Model, &'a [Vec<Option<f64>>])>,
    /// How it was found.
    pub found: &'a Synthesis,
    /// The file of the new model, where it was written.
    pub file: Option<&'a str>,
}

/// The largest and the root-mean-square difference (SI) of the states of a target.
struct Spread {
    largest: f64,
    rms: f64,
}

/// How far a hard point has moved.
struct Moved<'a> {
    name: &'a str,
    /// In metres.
    distance: f64,
}

impl SynthesisReport<'_> {
    /// The differences of a target; `None` where a state has no value.
    fn spread(&self, index: usize, values: &[Option<f64>]) -> Option<Spread> {
        let target = &self.request.targets[index];
        let mut spread = Spread { largest: 0.0, rms: 0.0 };
        for (state, (value, before)) in values.iter().zip(&self.before[index]).enumerate() {
            let off = target.off(state, *value, *before)?;
            if off.abs() > spread.largest.abs() {
                spread.largest = off;
            }
            spread.rms += off * off;
        }
        #[allow(clippy::cast_precision_loss)] // A target has a handful of states.
        let count = values.len() as f64;
        spread.rms = (spread.rms / count).sqrt();
        Some(spread)
    }

    /// The factors (SI) of the design.
    fn after(&self, index: usize) -> Option<&[Option<f64>]> {
        Some(&self.design?.1[index])
    }

    /// Whether a target is met; `None` where nothing counts as met, or there is no design.
    fn is_met(&self, index: usize) -> Option<bool> {
        if matches!(self.request.targets[index].goal, Goal::Minimise | Goal::Maximise) {
            return None;
        }
        match self.verdict {
            Verdict::Met => Some(true),
            Verdict::Compromise { unmet } => Some(unmet.iter().all(|unmet| unmet.target != index)),
            _ => None,
        }
    }

    /// The values (SI, coordinates in the axes of the model) of a variable before and, where there is a design, after.
    fn variable(&self, index: usize) -> (f64, Option<f64>) {
        let variable = &self.request.variables[index];
        let sign = variable.parameter.axis().map_or(1.0, |axis| self.model.axes.signs()[axis]);
        let after = self.design.and_then(|(new, _)| variable.parameter.value(new));
        (sign * variable.start, after.map(|after| sign * after))
    }

    /// The points that have moved.
    fn moved(&self) -> Vec<Moved<'_>> {
        let Some((new, _)) = self.design else { return vec![] };
        let points = self.model.points().iter().zip(new.points());
        let moved = points.map(|(old, new)| {
            let squares = old.position.iter().zip(new.position).map(|(a, b)| (a - b).powi(2));
            Moved { name: &old.name, distance: squares.sum::<f64>().sqrt() }
        });
        moved.filter(|moved| moved.distance > 0.0).collect()
    }
}

/// The mean of values; `None` where one is missing.
fn mean(values: &[Option<f64>]) -> Option<f64> {
    let values: Option<Vec<f64>> = values.iter().copied().collect();
    #[allow(clippy::cast_precision_loss)] // A target has a handful of states.
    values.map(|values| values.iter().sum::<f64>() / values.len() as f64)
}

/// Whether a target is shown by one value: at one state, or as a mean.
fn has_one_value(target: &Target) -> bool {
    target.states.len() == 1 || matches!(target.goal, Goal::Minimise | Goal::Maximise)
}
