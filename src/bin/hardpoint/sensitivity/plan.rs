//! The event of the options, and the body that it moves.

use hardpoint::model::{Chassis, Model, Quantity, Units, WheelSupport};
use hardpoint::programme::{StageError, rolling};
use hardpoint::rig::{Event, Held, RigError, SweepPlan};

use super::{Question, Sensitivity, not_reached, usage};
use crate::events::{Course, EventName};
use crate::failure::Failure;
use crate::loads::length;
use crate::steering::SteerBy;

impl Sensitivity {
    /// The event with its values.
    pub(super) fn plan(
        &self,
        event: EventName,
        model: &Model,
        held: Held,
    ) -> Result<(Course, SweepPlan), Failure> {
        let has_forces = if self.axle { model.axle_has_forces() } else { model.has_forces() };
        match event {
            EventName::Envelope => {
                return usage(
                    "sensitivities go along one event, not over a field; use --rack with --event travel",
                );
            }
            EventName::RollLoad if !has_forces => {
                return usage(
                    "a model without forces has no axle load to keep; add [[forces]] to the model, or use \
                     --event roll",
                );
            }
            EventName::Travel | EventName::Parallel
                if self.travel.is_some() && !self.vertical.is_force() =>
            {
                return usage(
                    "a travel event moves the travel; say its range with --from and --to",
                );
            }
            EventName::Steer if self.steering.given().is_some() => {
                return usage("a steer event moves the rack; say its range with --from and --to");
            }
            EventName::Steer if !model.steers() => {
                return usage("this suspension has no rack, so there is no steer event");
            }
            EventName::Load if !has_forces => {
                return usage(
                    "a load moves nothing in a model without forces; add [[forces]] to the model",
                );
            }
            _ => {}
        }
        if self.vary.is_some() && event != EventName::Load {
            return usage("--vary belongs to --event load");
        }
        if self.wheels.is_some() && !(self.axle && event == EventName::Load) {
            return usage("--wheels belongs to --axle with --event load");
        }
        let vary = self.vary.as_deref();
        let course = match self.axle {
            true => Course::of_axle(event, model, vary, SteerBy::Rack, self.wheels)?,
            false => Course::of_corner(event, model, vary, SteerBy::Rack)?,
        };
        let course = course.held(&self.vertical, self.from.is_some() && self.to.is_some())?;
        let value =
            |option, given, default| value(option, given, course.quantity, model.units, default);
        let [from, to] = course.range;
        let plan = SweepPlan {
            event: course.event,
            from: value("--from", self.from, from)?,
            to: value("--to", self.to, to)?,
            step: value("--step", self.step, course.step)?,
            held,
        };
        crate::sweep::check_plan(&plan)?;
        Ok((course, plan))
    }

    /// A body that rolls about the static roll centre in a roll event.
    pub(super) fn chassis(
        &self,
        question: &Question,
        model: &Model,
        rig: &impl Fn(RigError) -> Failure,
    ) -> Result<Chassis, Failure> {
        if question.plan.event != Event::Roll {
            return Ok(Chassis::Fixed);
        }
        let setup = self.rig.setup(WheelSupport::Held, Chassis::Fixed);
        rolling(model, &setup, self.rig.point()).map_err(|error| match error {
            StageError::Rig(error) => rig(error),
            StageError::NotBegun(stop) => not_reached(*stop, model),
            StageError::NoRollCenter => Failure::Usage(error.to_string()),
        })
    }
}

/// A value of the event in SI units.
fn value(
    option: &str,
    given: Option<f64>,
    quantity: Quantity,
    units: Units,
    default: f64,
) -> Result<f64, Failure> {
    match given {
        None => Ok(default),
        Some(_) if quantity == Quantity::Length => length(option, given, units),
        Some(value) if value.is_finite() => Ok(quantity.to_si(units, value)),
        Some(_) => usage(format!("{option} is not a finite number")),
    }
}
