//! Reads `[[drivers]]` of mechanisms.

use toml::Spanned;

use super::{Parts, named_sections};
use crate::mechanism::{Driver, DriverKind};
use crate::model::diagnostics::Report;
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
        let kind = self.driver_kind(&mut section, kind, report);
        section.finish(report);
        let ((i, j), kind) = (bodies?, kind?);
        Some(Driver { name: name.to_owned(), i, j, kind })
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
