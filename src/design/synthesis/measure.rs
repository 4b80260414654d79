//! What a model makes of a request, without any search.

use super::Obstacle;
use super::goals::{values, wheel_of};
use super::rolling;
use super::trial::Trial;
use crate::design::request::{Request, Target};
use crate::factors::Need;
use crate::model::{Mistake, Model, Setup};
use crate::rig::{Axle, Corner, Pose, RigError, Variable};

/// The factors of a model at the states of a request.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The values (SI), target by target and state by state; `None` where a factor is not defined.
    pub values: Vec<Vec<Option<f64>>>,
    /// Why targets have no value, with their places in the request and what to do.
    pub mistakes: Vec<Mistake>,
}

/// Finds the factors that a request names, of a model as it is.
///
/// # Errors
/// [`Obstacle`] where the rig does not reach a state.
pub fn measure(request: &Request, model: &Model, setup: &Setup) -> Result<Measured, Obstacle> {
    if request.needs_axle(model) {
        let setup = rolling::setup_for(request, model, setup)?;
        of(request, model, Axle::new(model, &setup))
    } else {
        of(request, model, Corner::new(model, setup))
    }
}

fn of<V: Variable>(
    request: &Request,
    model: &Model,
    specimen: Result<V, RigError>,
) -> Result<Measured, Obstacle> {
    let compliance =
        request.targets.iter().any(|target| target.factor.needs.contains(&Need::Compliance));
    let mut trial = Trial::new(specimen.map_err(Obstacle::Rig)?, model, &[], compliance);
    let values = values(request, &mut trial)?;
    let mut mistakes = vec![];
    for (target, values) in request.targets.iter().zip(&values) {
        let Some(state) = values.iter().position(Option::is_none) else { continue };
        trial.go_to(&target.states[state].rig)?;
        let poses = trial.poses();
        mistakes.push(undefined(request, target, &poses[wheel_of(target, poses.len())]));
    }
    Ok(Measured { values, mistakes })
}

/// Why a target has no value.
fn undefined(request: &Request, target: &Target, pose: &Pose<f64>) -> Mistake {
    let name = target.factor.name;
    if let Some(axle) = target.factor.axle.filter(|_| !target.factor.applies(pose)) {
        let message = format!("`{name}` belongs to a {} axle", axle.name());
        let help = "leave this target out, or name the factor of the other axle";
        return request.mistake(&target.place, &message, "this target", help);
    }
    let needs: Vec<&str> = target.factor.missing(pose).map(Need::words).collect();
    if needs.is_empty() {
        let message = format!("`{name}` is not defined at a state of this target");
        let help = "an instant centre, a ratio or an axis is at infinity there: name other states, or another factor";
        return request.mistake(&target.place, &message, "this target", help);
    }
    let message = format!("`{name}` needs {}", needs.join(" and "));
    let help = "add that to the model, or leave this target out";
    request.mistake(&target.place, &message, "this target", help)
}
