//! What a suspension goes through: the event of the options with its values.

use hardpoint::model::{Model, Quantity, Units};
use hardpoint::rig::{Event, Held, SweepPlan};

use super::over::Over;
use super::{Sweep, usage};
use crate::events::{Course, EventName};
use crate::failure::Failure;
use crate::loads::FARTHEST;
use crate::steering::{SteerBy, rack_per_radian};

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
        model: &Model,
    ) -> Result<(Quantity, SweepPlan, String), Failure> {
        let (units, steers) = (model.units, model.steers());
        if self.steer_by.is_some() && event != EventName::Steer {
            return usage("--steer-by belongs to --event steer");
        }
        let rack = self.steering.rack(model)?;
        match event {
            EventName::Travel | EventName::Parallel | EventName::Envelope
                if self.travel.is_some() && !self.vertical.is_force() =>
            {
                return usage(
                    "a travel event moves the travel; hold the rack with --rack, \
                     and say the range of travel with --from and --to",
                );
            }
            EventName::Steer if self.steering.given().is_some() => {
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
        let by = self.steer_by.unwrap_or(SteerBy::Rack);
        let course = if self.axle {
            Course::of_axle(event, model, self.vary.as_deref(), by, self.wheels)?
        } else {
            Course::of_corner(event, model, self.vary.as_deref(), by)?
        };
        let ranged = self.from.is_some() && self.to.is_some();
        let Course { event, quantity, range, step, name } = course.held(&self.vertical, ranged)?;
        self.check_values(quantity, units)?;
        let value = |value: Option<f64>, default: f64| {
            value.map_or(default, |value| quantity.to_si(units, value))
        };
        let travel = self.travel.map_or(0.0, |travel| units.length.to_metres(travel));
        let mut plan = SweepPlan {
            event,
            from: value(self.from, range[0]),
            to: value(self.to, range[1]),
            step: value(self.step, step),
            held: Held { travel, rack, ..Held::default() },
        };
        if event == Event::Steer && by == SteerBy::Wheel {
            // The rig drives the rack, so a steering wheel is turned by moving that.
            let per_radian = rack_per_radian(model)?;
            for value in [&mut plan.from, &mut plan.to, &mut plan.step] {
                *value *= per_radian;
            }
        }
        check_plan(&plan)?;
        Ok((quantity, plan, name))
    }

    /// The plan, or that at each value of `--over`, with their names.
    pub(super) fn plans(
        &self,
        event: EventName,
        plan: &SweepPlan,
        model: &Model,
    ) -> Result<Vec<(String, SweepPlan)>, Failure> {
        let default = (event == EventName::Envelope).then(|| Over::rack(model));
        let Some(over) = self.over.or(default) else {
            return Ok(vec![(String::new(), *plan)]);
        };
        over.check_held(self.steering.given(), self.travel)?;
        over.check(plan.event, self.axle, model.steers(), self.vertical.is_force())?;
        over.plans(plan, model.units)
    }
}

/// Refuses a step that leads nowhere, and a body that rolls onto its side.
pub fn check_plan(plan: &SweepPlan) -> Result<(), Failure> {
    if plan.event == Event::Roll && plan.from.abs().max(plan.to.abs()) > MOST_ROLL {
        return usage("a body that rolls further than 90° lies on its side");
    }
    check_states(plan)
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
