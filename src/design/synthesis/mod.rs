//! Synthesis: the parameters that give wanted factors.
//!
//! A [request](super::request) is a nonlinear program: targets are residuals of least squares, or constraints where
//! they are hard, limits are constraints, and all derivatives are those of
//! [`Varied`](crate::rig::Varied). It is solved by [sequential quadratic programming](super::sqp) from the model
//! and, where that does not meet all targets, from other designs between the bounds.

mod goals;
mod limits;
mod measure;
mod pareto;
mod problem;
mod rolling;
mod search;
mod spread;
mod trial;
mod verdict;

use thiserror::Error;

pub use measure::{Measured, measure};
pub use pareto::TradeOff;
pub use spread::Deviation;
pub use verdict::{Held, Unmet, Verdict, judge};

use super::parameter::Parameter;
use super::request::Request;
use super::sqp;
use crate::factors::Need;
use crate::model::{Chassis, Model, Setup};
use crate::rig::{Axle, Corner, RigError, Variable, VaryError};
use crate::solve::Stop;
use crate::solve::sensitivity::SensitivityError;
use problem::Task;
use trial::Trial;

/// Why a design has no value.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Obstacle {
    /// The mechanism does not reach a state.
    #[error("{0}")]
    Stopped(Box<Stop>),
    /// A state has no derivatives.
    #[error(transparent)]
    State(VaryError),
    /// A parameter has none.
    #[error(transparent)]
    Derivative(SensitivityError),
    /// A factor is not defined.
    #[error("the factor of the target `{0}` is not defined at one of its states")]
    Undefined(String),
    /// The request makes no program, such as one with a bound that is not finite.
    #[error(transparent)]
    Statement(sqp::Mistake),
    /// The specimen cannot be made.
    #[error(transparent)]
    Rig(RigError),
    /// There is nothing to roll about.
    #[error(
        "the axle has no static roll centre to roll about: it is at infinity, or the wheels do not move; \
         leave the targets of roll out, or use `event = \"opposite\"`"
    )]
    NoRollCenter,
}

/// A roll axis that moves by less than this (m) stays.
const AXIS_STAYS: f64 = 1e-6;

/// A design is sought so often about its own roll axis.
const ROLLS: usize = 4;

/// What became of a request.
#[derive(Clone, Debug)]
pub struct Synthesis {
    /// Whether the targets are met, and if not, what stands against them.
    pub verdict: Verdict,
    /// The values (SI, coordinates in ISO 8855 axes) of the variables of the request.
    pub values: Vec<f64>,
    /// The factors (SI) of the model, target by target and state by state.
    pub before: Vec<Vec<Option<f64>>>,
    /// Those of the design.
    pub after: Vec<Vec<Option<f64>>>,
    /// Bounds and constraints that hold the design where it is.
    pub held: Vec<Held>,
    /// The trade-off, where the request asks for one, in the order of the second of its targets.
    pub trade_off: Vec<TradeOff>,
    /// The spread under tolerances, where the request asks for it.
    pub spread: Vec<Deviation>,
    /// From how many designs it was sought.
    pub starts: usize,
    /// Iterations of the best start.
    pub iterations: usize,
    /// Designs that were evaluated, from all starts.
    pub evaluations: usize,
}

/// Seeks the design that a request asks for. Both wheels are on the rig where the request needs them.
///
/// # Errors
/// [`Obstacle`] where the model itself cannot be evaluated.
pub fn synthesize(request: &Request, model: &Model, setup: &Setup) -> Result<Synthesis, Obstacle> {
    if !request.needs_axle(model) {
        return run(request, model, || Corner::new(model, setup));
    }
    let mut setup = rolling::setup_for(request, model, setup)?;
    let mut found = run(request, model, || Axle::new(model, &setup))?;
    for _ in 1..ROLLS {
        let (Chassis::Roll { axis }, Verdict::Met | Verdict::Compromise { .. }) =
            (setup.chassis, &found.verdict)
        else {
            break;
        };
        setup = rolling::setup_of_design(request, model, &setup, &found.values)?;
        if matches!(setup.chassis, Chassis::Roll { axis: new } if (new - axis).abs() < AXIS_STAYS) {
            break;
        }
        found = run(request, model, || Axle::new(model, &setup))?;
    }
    Ok(found)
}

fn run<V: Variable>(
    request: &Request,
    model: &Model,
    specimen: impl Fn() -> Result<V, RigError> + Sync,
) -> Result<Synthesis, Obstacle> {
    let parameters = parameters(request, model);
    let compliance =
        request.targets.iter().any(|target| target.factor.needs.contains(&Need::Compliance));
    let task = || {
        let specimen = specimen().map_err(Obstacle::Rig)?;
        Task::new(request, model, Trial::new(specimen, model, &parameters, compliance))
    };
    let mut first = task()?;
    let found = search::search(request, &mut first, task)?;
    let after = first.values(&found.outcome.x);
    let after =
        after.unwrap_or_else(|_| first.before.iter().map(|v| vec![None; v.len()]).collect());
    let outcome = &found.outcome;
    let trade_off = match request.pareto {
        Some(pareto) => pareto::trade_off(request, pareto, &mut first, &outcome.x)?,
        None => vec![],
    };
    let spread = first.deviations(&outcome.x)?;
    Ok(Synthesis {
        verdict: verdict::verdict(request, model, &first, outcome, &after),
        held: verdict::held(request, model, &mut first, outcome),
        values: outcome.x.clone(),
        before: first.before,
        after,
        trade_off,
        spread,
        starts: found.starts,
        iterations: outcome.iterations,
        evaluations: found.evaluations,
    })
}

/// The variables of a request as parameters of its model.
fn parameters(request: &Request, model: &Model) -> Vec<Parameter> {
    let variables = request.variables.iter();
    variables.map(|v| Parameter::wanted(v.parameter, &v.name, model)).collect()
}
