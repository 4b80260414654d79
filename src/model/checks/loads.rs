//! Loads without a meaning: no direction, no frame, masses that no body has.

use std::ops::Range;

use super::super::setup::Chassis;
use super::Geometry;
use crate::mechanism::{Force, Mechanism, MechanismError};
use crate::model::diagnostics::Report;

impl Geometry<'_> {
    /// Tries every load on the bodies and points of the model.
    pub(super) fn check_loads(&self, report: &mut Report) {
        let architecture = &self.model.architecture;
        let mut trial = Mechanism::new(&architecture.ground);
        // Their names differ and their numbers are finite, or reading would have said so.
        for (name, position) in self.model.mechanism_points() {
            let _ = trial.add_point(name, position);
        }
        for body in &architecture.bodies {
            let _ = trial.add_body(&body.name, [0.0; 3]);
        }
        let (loads, places) = (&self.model.loads, &self.loads);
        for (span, body) in &places.masses {
            if let Some(Err(error)) = loads.mass(*body).map(|mass| trial.set_mass(*body, mass)) {
                note(span, &error, report);
            }
        }
        let mut add = |span: &Range<usize>, force: &Force| {
            if let Err(error) = trial.add_force(&force.name, force.i, force.j, force.kind.clone()) {
                note(span, &error, report);
            }
        };
        if let Some(tyre) = self.model.tyre_force(Chassis::Fixed) {
            add(&places.tyre, &tyre);
        }
        for (span, force) in places.forces.iter().zip(&loads.forces) {
            add(span, force);
        }
        for (span, bushing) in places.bushings.iter().zip(&loads.bushings) {
            add(span, &bushing.force);
        }
        self.check_axle_forces(report);
    }

    /// Forces between the two sides, on the points of this side and of its mirror image.
    fn check_axle_forces(&self, report: &mut Report) {
        let (model, architecture) = (self.model, &self.model.architecture);
        let mut trial = Mechanism::new(&architecture.ground);
        for (prefix, sign) in [("", 1.0), ("other.", -1.0)] {
            for point in &model.points {
                let [x, y, z] = point.position;
                let _ = trial.add_point(&format!("{prefix}{}", point.name), [x, sign * y, z]);
            }
            for body in &architecture.bodies {
                let _ = trial.add_body(&format!("{prefix}{}", body.name), [0.0; 3]);
            }
        }
        for (span, force) in self.loads.axle_forces.iter().zip(&model.loads.axle_forces) {
            if let Some((why, help)) = architecture.not_across(force.i, force.j) {
                report
                    .mistake(span, format!("the force `{}` {why}", force.name), "here")
                    .help(help);
                continue;
            }
            if let Err(error) = trial.add_force(&force.name, force.i, force.j, force.kind.clone()) {
                note(span, &error, report);
            }
        }
    }
}

/// Notes what the mechanism says of a part of a file. Its messages end in what to do.
pub(crate) fn note(span: &Range<usize>, error: &MechanismError, report: &mut Report) {
    if let MechanismError::CoincidentPoints { what, name, part, from, to, .. } = error {
        let (from, to) = (&from.name, &to.name);
        let message =
            format!("`{from}` and `{to}` are the same point, so the {what} `{name}` has no {part}");
        report.mistake(span, message, "here").help("correct one of the two points");
        return;
    }
    let text = error.to_string();
    let end = text.rfind("; ").or_else(|| text.rfind(": "));
    let (message, help) = match end {
        Some(end) => (&text[..end], &text[end + 2..]),
        None => (text.as_str(), "correct this part"),
    };
    report.mistake(span, message, "here").help(help);
}
