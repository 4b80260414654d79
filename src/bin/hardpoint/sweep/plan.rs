//! What a suspension goes through: the event of the options with its values.

use hardpoint::model::{Model, Quantity, Units};
use hardpoint::rig::{Held, SweepPlan};

use super::over::Over;
use super::{Sweep, usage};
use crate::events::{Course, EventName};
use crate::failure::Failure;
use crate::loads::FARTHEST;

/// More states than this are a mistake in the step.
const MOST_STATES: f64 = 1e6;

/// More roll (rad) than this is a mistake in the unit: a quarter of a turn.
const MOST_ROLL: f64 = 1.6;

impl Sweep {
    /// Refuses numbers that are none, and lengths that no suspension has. The values of the event are
    /// of the quantity.
    pub(super) fn check_values(&self, quantity: Quantity, units: Units) -> Result<(), Failure> {
        let options = [
            ("--from", self.from),
            ("--to", self.to),
            ("--step", self.step),
            ("--rack", self.rack),
            ("--travel", self.travel),
        ];
        for (name, value) in options {
            let Some(value) = value else { continue };
            if !value.is_finite() {
                return usage(format!("{name} is not a finite number"));
            }
            let is_length = match name {
                "--step" => false,
                "--from" | "--to" => quantity == Quantity::Length && self.driver.is_none(),
                _ => true,
            };
            if is_length && units.length.to_metres(value).abs() > FARTHEST {
                return usage(format!(
                    "{name} is more than a kilometre; lengths are in the unit of the model"
                ));
            }
        }
        Ok(())
    }

    /// The states to visit, what their values are, and the name of the event.
    pub(super) fn plan(
        &self,
        event: EventName,
        units: Units,
        steers: bool,
    ) -> Result<(Quantity, SweepPlan, String), Failure> {
        if self.rack.is_some_and(|rack| rack != 0.0) && !steers {
            return usage("this suspension has no rack; leave out --rack");
        }
        match event {
            EventName::Travel | EventName::Parallel | EventName::Envelope
                if self.travel.is_some() && !self.vertical.is_force() =>
            {
                return usage(
                    "a travel event moves the travel; hold the rack with --rack, \
                     and say the range of travel with --from and --to",
                );
            }
            EventName::Steer if self.rack.is_some() => {
                return usage(
                    "a steer event moves the rack; hold the travel with --travel, \
                     and say the range of the rack with --from and --to",
                );
            }
            EventName::Steer if !steers => {
                return usage("this suspension has no rack, so there is no steer event");
            }
            _ => {}
        }
        let course = if self.axle {
            Course::of_axle(event, self.vary.as_deref(), self.wheels)?
        } else {
            Course::of_corner(event, self.vary.as_deref())?
        };
        let ranged = self.from.is_some() && self.to.is_some();
        let Course { event, quantity, range, step, name } = course.held(&self.vertical, ranged)?;
        self.check_values(quantity, units)?;
        let value = |value: Option<f64>, default: f64| {
            value.map_or(default, |value| quantity.to_si(units, value))
        };
        let length = |value: Option<f64>| value.map_or(0.0, |value| units.length.to_metres(value));
        let plan = SweepPlan {
            event,
            from: value(self.from, -range),
            to: value(self.to, range),
            step: value(self.step, step),
            held: Held { travel: length(self.travel), rack: length(self.rack), ..Held::default() },
        };
        if quantity == Quantity::Angle && plan.from.abs().max(plan.to.abs()) > MOST_ROLL {
            return usage("a body that rolls further than 90° lies on its side");
        }
        check_states(&plan)?;
        Ok((quantity, plan, name))
    }

    /// The plan, or that at each value of `--over`, with their names.
    pub(super) fn plans(
        &self,
        event: EventName,
        plan: &SweepPlan,
        model: &Model,
    ) -> Result<Vec<(String, SweepPlan)>, Failure> {
        let default = (event == EventName::Envelope).then(|| Over::rack(model.units));
        let Some(over) = self.over.or(default) else {
            return Ok(vec![(String::new(), *plan)]);
        };
        over.check(plan.event, self.axle, model.steers(), self.vertical.is_force())?;
        over.plans(plan, model.units)
    }
}

/// Refuses a step that leads nowhere or to too many states.
pub(super) fn check_states(plan: &SweepPlan) -> Result<(), Failure> {
    let states = ((plan.to - plan.from) / plan.step).abs();
    if plan.step == 0.0 && plan.from != plan.to {
        return usage("--step is zero");
    }
    if states > MOST_STATES {
        return usage("--step is too small for the range: at most 1,000,000 states");
    }
    Ok(())
}
