//! The states of a file of load cases.

use std::path::Path;

use hardpoint::factors::Factor;
use hardpoint::model::{Chassis, LoadCases, Model, Quantity, WheelSupport};
use hardpoint::report::SweepReport;
use hardpoint::rig::{self, Held, Specimen, Target};

use super::{Sweep, needs_compliance};
use crate::failure::Failure;
use crate::loads::length;
use crate::output::Output;

impl Sweep {
    /// Goes through the cases of a file and writes them. What they do not say is as the options say.
    pub(super) fn cases(
        &self,
        file: &Path,
        model: &Model,
        columns: Option<&[&'static Factor]>,
        output: &Output,
    ) -> Result<(), Failure> {
        let cases = LoadCases::load(file, model, self.axle)?;
        let [load, right_load] =
            if self.axle { self.rig.axle_loads(model)? } else { [self.rig.load(model)?; 2] };
        let held = Held {
            travel: length("--travel", self.travel, model.units)?,
            rack: self.steering.rack(model)?,
            load,
            right_load: Some(right_load),
            ..Held::default()
        };
        let has_forces = if self.axle { model.axle_has_forces() } else { model.has_forces() };
        let held_by_rig = cases.holds_wheels() || self.travel.is_some() || !has_forces;
        let support = if held_by_rig { WheelSupport::Held } else { WheelSupport::Free };
        let (setup, at) = (self.rig.setup(support, Chassis::Fixed), self.rig.point());
        let targets = Target::of_cases(&cases, &held);
        let measures = needs_compliance(columns);
        let sweep = if self.axle {
            let mut axle = self.axle(model, &setup, at)?;
            axle.measure_compliance(measures);
            self.visit(&mut axle, &targets, model)
        } else {
            let mut corner = self.corner(model, &setup, at)?;
            corner.measure_compliance(measures);
            self.visit(&mut corner, &targets, model)
        };
        let report = SweepReport {
            event: "cases",
            quantity: Quantity::Ratio,
            cases: Some(&cases),
            factors: columns,
            ..self.report(model, &sweep)
        };
        self.write(&report, output)
    }

    fn visit(
        &self,
        specimen: &mut impl Specimen,
        targets: &[(String, Target)],
        model: &Model,
    ) -> rig::Sweep {
        self.go(targets.len(), model.axes, |progress| {
            rig::Sweep::cases(specimen, targets, progress)
        })
    }
}
