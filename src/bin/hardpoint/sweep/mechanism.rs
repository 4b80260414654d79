//! A driver of a mechanism that moves.

use hardpoint::factors::Convention;
use hardpoint::mechanism::DriverId;
use hardpoint::model::{Axes, MechanismModel, Quantity};
use hardpoint::report::SweepReport;
use hardpoint::rig::{self, Held, Stand, SweepPlan};

use super::plan::check_states;
use super::{Sweep, usage};
use crate::failure::Failure;
use crate::output::Output;

impl Sweep {
    /// Moves the driver and writes every state.
    pub(super) fn mechanism(&self, model: &MechanismModel, output: &Output) -> Result<(), Failure> {
        let suspension = [
            (self.event.is_some(), "--event"),
            (self.vary.is_some(), "--vary"),
            (self.steer_by.is_some(), "--steer-by"),
            (self.travel.is_some(), "--travel"),
            (self.axle, "--axle"),
            (self.wheels.is_some(), "--wheels"),
            (self.columns.is_some(), "--columns"),
            (self.convention.is_some(), "--convention"),
            (self.cases.is_some(), "--cases"),
            (self.over.is_some(), "--over"),
        ];
        if let Some((_, option)) = suspension.iter().find(|(given, _)| *given) {
            return usage(format!("{option} belongs to suspensions; this file is a mechanism"));
        }
        if let Some(option) = self.vertical.given().or(self.steering.given()) {
            return usage(format!("{option} belongs to suspensions; this file is a mechanism"));
        }
        self.rig.refuse()?;
        let driver = self.driver_of(model)?;
        let part = &model.mechanism.drivers()[driver.index()];
        let quantity = if part.kind.unit() == "rad" { Quantity::Angle } else { Quantity::Length };
        let name = part.name.clone();
        let mut stand = Stand::new(model.mechanism.clone(), &[], Axes::Iso8855)
            .map_err(|error| Failure::Rig(self.model.display().to_string(), Box::new(error)))?;
        let (Some(from), Some(to)) = (self.from, self.to) else {
            return usage(format!(
                "say the range of driver {name} in {} with --from and --to",
                quantity.symbol(model.units)
            ));
        };
        let step = self.step.unwrap_or((to - from) / 10.0);
        let value = |value| quantity.to_si(model.units, value);
        self.check_values(quantity, model.units)?;
        let plan = SweepPlan {
            event: rig::Event::Driver(driver),
            from: value(from),
            to: value(to),
            step: value(step),
            held: Held::default(),
        };
        check_states(&plan)?;
        let sweep = self.go(plan.values().len(), Axes::Iso8855, |progress| {
            rig::Sweep::run(&mut stand, &plan, progress)
        });
        let report = SweepReport {
            name: &model.name,
            sides: &[],
            axes: Axes::Iso8855,
            units: model.units,
            event: &name,
            drive: None,
            quantity,
            plan: Some(&plan),
            cases: None,
            sweep: &sweep,
            reactions: self.reactions,
            factors: None,
            convention: Convention::Iso,
        };
        self.write(&report, output)
    }

    fn driver_of(&self, model: &MechanismModel) -> Result<DriverId, Failure> {
        if let Some(name) = &self.driver {
            let found = crate::equilibrium::released(std::slice::from_ref(name), model)?;
            return Ok(found[0]);
        }
        let mut drivers = model.mechanism.driver_ids();
        match (drivers.next(), drivers.next()) {
            (Some(only), None) => Ok(only),
            (None, _) => {
                usage("the mechanism has no driver; add a [[drivers]] section to the file")
            }
            _ => usage("the mechanism has several drivers; name one with --driver"),
        }
    }
}
