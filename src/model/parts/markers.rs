//! Reads `[[markers]]`: points of bodies with axes, which are followed in motion.

use toml::Spanned;

use super::{Parts, named_sections};
use crate::mechanism::{BodyId, PointId, Triad};
use crate::model::diagnostics::Report;
use crate::model::read::Section;

/// A point of a body with axes that turn with it, to be followed in motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// The name of its columns.
    pub name: String,
    /// The body that it moves with.
    pub body: BodyId,
    /// Where it is.
    pub at: PointId,
    /// Its axes at the design position.
    pub axes: Triad,
}

impl Parts<'_> {
    /// The markers in the order of the file; `None` for one with a mistake.
    pub(crate) fn markers(
        &self,
        root: &mut Section,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Marker>)> {
        named_sections(root, "markers", "center_of_mass", report, |section, name, report| {
            self.marker(section, name, report)
        })
    }

    fn marker(&self, mut section: Section, name: &str, report: &mut Report) -> Option<Marker> {
        let help = "name the body that it moves with: `body = \"…\"`";
        let body = section.required::<String>("body", help, report);
        let body =
            body.and_then(|body| self.names.moving_body(&body, "name a moving body", report));
        let at = self.point(&mut section, "at", "name its point: `at = \"…\"`", report);
        let axes = self.triad(&mut section, report);
        section.finish(report);
        Some(Marker { name: name.to_owned(), body: body?, at: at?, axes: axes? })
    }
}
