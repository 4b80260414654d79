//! The axis about which the body rolls, where targets ask for that.
//!
//! It goes through the static roll centre, which moves with the points. Roll about another height of the axis differs
//! in the second order of the angle only, so derivatives leave it out, and a design is sought anew about its own
//! axis until that stays.

use super::trial::Trial;
use super::{Obstacle, parameters};
use crate::design::request::Request;
use crate::factors::roll_axis;
use crate::model::{Chassis, Model, Setup};
use crate::programme::{StageError, rolling};
use crate::rig::{Axle, Event, LoadPoint, Target};

/// Whether the body rolls in a request.
pub(super) fn rolls(request: &Request) -> bool {
    request.targets.iter().any(|target| target.event == Some(Event::Roll))
}

/// The setup of an axle in which a request is looked at: the body rolls about the static roll centre of the model,
/// where it rolls at all.
pub(super) fn setup_for(
    request: &Request,
    model: &Model,
    setup: &Setup,
) -> Result<Setup, Obstacle> {
    if !rolls(request) {
        return Ok(*setup);
    }
    let chassis = rolling(model, setup, LoadPoint::ContactPatch).map_err(|error| match error {
        StageError::Rig(error) => Obstacle::Rig(error),
        StageError::NotBegun(stop) => Obstacle::Stopped(stop),
        StageError::NoRollCenter => Obstacle::NoRollCenter,
    })?;
    Ok(Setup { chassis, ..*setup })
}

/// The setup whose axis is that of a design, given by the values of the variables.
pub(super) fn setup_of_design(
    request: &Request,
    model: &Model,
    setup: &Setup,
    values: &[f64],
) -> Result<Setup, Obstacle> {
    let axle = Axle::new(model, setup).map_err(Obstacle::Rig)?;
    let mut trial = Trial::new(axle, model, &parameters(request, model), false);
    trial.set(values)?;
    trial.go_to(&Target::default())?;
    let poses = trial.poses();
    let [left, right] = &poses[..] else { return Err(Obstacle::NoRollCenter) };
    let axis = roll_axis([left, right]).ok_or(Obstacle::NoRollCenter)?;
    Ok(Setup { chassis: Chassis::Roll { axis }, ..*setup })
}
