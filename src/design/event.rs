//! Derivatives of factors at all states of an event.

use super::parameter::Parameter;
use super::sensitivity::{Sensitivities, SensitivityFailure, Way, sensitivities};
use crate::factors::{Convention, Factor};
use crate::model::Model;
use crate::rig::{Missed, SweepPlan, Variable};

/// What is asked at each state.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The model on the rig.
    pub model: &'a Model,
    /// The factors.
    pub factors: &'a [&'static Factor],
    /// By whose definitions.
    pub convention: Convention,
    /// The parameters.
    pub parameters: &'a [Parameter],
    /// Which way derivatives are found.
    pub way: Way,
}

/// One state with its derivatives.
#[derive(Clone)]
pub struct StateSensitivities {
    /// The value of the event (SI).
    pub value: f64,
    /// Travels of the wheels (m), left first in an axle.
    pub travels: Vec<f64>,
    /// Displacement of the rack (m).
    pub rack: f64,
    /// The derivatives.
    pub found: Sensitivities,
}

/// The states of an event that were reached.
#[derive(Clone, Default)]
pub struct EventSensitivities {
    /// In the order of the plan.
    pub states: Vec<StateSensitivities>,
    /// The number of states that were asked for.
    pub planned: usize,
    /// Where the mechanism could not go on.
    pub stops: Vec<Missed>,
    /// The values (SI) of states without derivatives, with the reason.
    pub without: Vec<(f64, SensitivityFailure)>,
}

/// The derivatives at all states of a plan, from the value nearest to the design position outwards, as
/// [`Sweep::run`](crate::rig::Sweep::run). `progress` is told after each state how many are done.
pub fn along(
    specimen: &mut impl Variable,
    plan: &SweepPlan,
    asked: &Asked<'_>,
    mut progress: impl FnMut(usize),
) -> EventSensitivities {
    let values = plan.values();
    let middle = (0..values.len()).min_by(|&a, &b| values[a].abs().total_cmp(&values[b].abs()));
    let (before, after) = values.split_at(middle.unwrap_or_default());
    let mut result = EventSensitivities { planned: values.len(), ..Default::default() };
    let mut done = 0;
    let mut follow = |specimen: &mut _, values: &mut dyn Iterator<Item = f64>| {
        let mut states = vec![];
        for value in values {
            match state(specimen, plan, value, asked) {
                Ok(Ok(state)) => states.push(state),
                Ok(Err(failure)) => result.without.push((value, failure)),
                Err(stop) => {
                    result.stops.push(Missed { at: None, stop });
                    break;
                }
            }
            done += 1;
            progress(done);
        }
        states
    };
    let outwards = follow(specimen, &mut after.iter().copied());
    let mut states = vec![];
    if let (false, Some(&first)) = (before.is_empty(), after.first()) {
        specimen.reset();
        // Where not even the first state is reached, nothing beyond it is.
        if specimen.go_to(&plan.target(first)).is_ok() {
            states = follow(specimen, &mut before.iter().rev().copied());
            states.reverse();
        }
    }
    states.extend(outwards);
    result.states = states;
    result
}

/// The derivatives at one value of a plan.
///
/// # Errors
/// [`Stop`](crate::solve::Stop) where the mechanism does not get there; within, why the state that was reached has
/// no derivatives.
fn state(
    specimen: &mut impl Variable,
    plan: &SweepPlan,
    value: f64,
    asked: &Asked<'_>,
) -> Result<Result<StateSensitivities, SensitivityFailure>, crate::solve::Stop> {
    specimen.go_to(&plan.target(value))?;
    Ok(here(specimen, value, asked))
}

/// The derivatives where a specimen is, which is the `value` (SI) of an event.
///
/// # Errors
/// [`SensitivityFailure`] where the state has none.
pub fn here(
    specimen: &mut impl Variable,
    value: f64,
    asked: &Asked<'_>,
) -> Result<StateSensitivities, SensitivityFailure> {
    let Asked { model, factors, convention, parameters, way } = *asked;
    let found = sensitivities(specimen, model, factors, convention, parameters, way)?;
    let poses = specimen.poses();
    let rack = poses.first().map_or(0.0, |pose| pose.rack);
    Ok(StateSensitivities { value, travels: poses.iter().map(|p| p.travel).collect(), rack, found })
}
