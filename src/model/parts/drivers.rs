//! Reads `[[drivers]]` of mechanisms.

use std::ops::Range;

use toml::Spanned;

use super::law::{self, Axis};
use super::{Parts, named_sections};
use crate::mechanism::{Course, Curve, Driver, DriverKind, Step, Wave};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

const KINDS: &[&str] = &["rotation", "displacement", "length", "height"];

impl Parts<'_> {
    /// The drivers in the order of the file; `None` for one with a mistake.
    pub(crate) fn drivers(
        &self,
        root: &mut Section,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Driver>)> {
        named_sections(root, "drivers", "crank", report, |section, name, report| {
            self.driver(section, name, report)
        })
    }

    fn driver(&self, mut section: Section, name: &str, report: &mut Report) -> Option<Driver> {
        let bodies = self.between(&mut section, &format!("the driver `{name}`"), report);
        let Some(kind) = section.word("kind", "kind of driver", KINDS, report) else {
            section.finish_open(report);
            return None;
        };
        let quantity = if kind == "rotation" { Quantity::Angle } else { Quantity::Length };
        let kind = self.driver_kind(&mut section, kind, report);
        let help = "say how it moves: `motion = { polynomial = [5.0] }` goes on by 5 each second";
        let course = section.optional_section("motion", help, report);
        let course = course.and_then(|course| self.course(course, name, quantity, report));
        section.finish(report);
        let ((i, j), kind) = (bodies?, kind?);
        Some(Driver { name: name.to_owned(), i, j, kind, course })
    }

    /// A motion in time: the sum of its parts. Times are in seconds.
    fn course(
        &self,
        mut section: Section,
        name: &str,
        quantity: Quantity,
        report: &mut Report,
    ) -> Option<Course> {
        let value = |number: f64, span: &Range<usize>, report: &mut Report| {
            self.units.to_si(quantity, number, span, report)
        };
        let mut course = Course::default();
        if let Some(factors) = section.optional::<Vec<f64>>("polynomial", report) {
            let span = factors.span();
            let factors = factors.into_inner().into_iter();
            course.polynomial = factors.map(|factor| value(factor, &span, report)).collect();
        }
        if let Some(waves) = section.optional::<Vec<Spanned<[f64; 3]>>>("sine", report) {
            course.waves.extend(waves.into_inner().into_iter().map(|wave| {
                let (span, [amplitude, frequency, phase]) = (wave.span(), wave.into_inner());
                let phase = self.units.to_si(Quantity::Angle, phase, &span, report);
                Wave { amplitude: value(amplitude, &span, report), frequency, phase }
            }));
        }
        for (key, fifth) in [("step", false), ("step5", true)] {
            let steps = section.optional::<Vec<Spanned<[f64; 3]>>>(key, report);
            for step in steps.into_iter().flat_map(Spanned::into_inner) {
                let (span, [from, to, change]) = (step.span(), step.into_inner());
                if from >= to {
                    report
                        .mistake(&span, format!("`{key}` ends before it begins"), "this step")
                        .help("write where it begins, where it ends (s), and the change");
                    continue;
                }
                let change = value(change, &span, report);
                course.steps.push(Step { from, to, change, fifth });
            }
        }
        if let Some(rows) = section.optional::<Vec<Spanned<[f64; 2]>>>("table", report) {
            let axis = Axis { value: Quantity::Time, force: quantity, ..law::LENGTH };
            if let Some(Curve::Table(table)) = self.table(&rows, name, axis, report) {
                course.table = Some(table);
            }
        }
        section.finish(report);
        Some(course)
    }

    fn driver_kind(
        &self,
        section: &mut Section,
        word: &str,
        report: &mut Report,
    ) -> Option<DriverKind> {
        let help = "name the point of the second body that is moved: `at = \"…\"`";
        match word {
            "rotation" => {
                Some(DriverKind::Rotation { axis: self.direction(section, "axis", report)? })
            }
            "displacement" => {
                let at = self.point(section, "at", help, report);
                let along = self.direction(section, "along", report);
                Some(DriverKind::Displacement { at: at?, along: along? })
            }
            "length" => {
                let help = "name a point on each body: `on = [\"…\", \"…\"]`";
                let [on_i, on_j] = self.two_points(section, "on", help, report)?;
                Some(DriverKind::Length { on_i, on_j })
            }
            _ => Some(DriverKind::Height { at: self.point(section, "at", help, report)? }),
        }
    }
}
