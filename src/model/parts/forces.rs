//! Reads `[[forces]]`.

use toml::Spanned;

use super::line::Element;
use super::{Parts, named_sections};
use crate::mechanism::{Acts, BodyId, Force, ForceKind, LoadFrame};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;
use crate::vector::norm;

/// The kinds that suspensions and mechanisms have.
const KINDS: &[&str] = &[
    "spring",
    "damper",
    "actuator",
    "bump-stop",
    "rebound-stop",
    "torsion-spring",
    "bushing",
    "force",
    "moment",
];

/// The kinds of mechanisms: the tyre of a suspension has a section of its own.
const KINDS_WITH_TYRE: &[&str] = &[
    "spring",
    "damper",
    "actuator",
    "bump-stop",
    "rebound-stop",
    "torsion-spring",
    "bushing",
    "force",
    "moment",
    "tyre",
];

/// The kinds between the two sides of an axle.
const KINDS_ACROSS: &[&str] =
    &["spring", "damper", "actuator", "bump-stop", "rebound-stop", "torsion-spring", "bushing"];

impl Parts<'_> {
    /// The force elements in the order of the file; `None` for one with a mistake.
    pub(crate) fn forces(
        &self,
        root: &mut Section,
        tyres: bool,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Force>)> {
        let kinds = if tyres { KINDS_WITH_TYRE } else { KINDS };
        self.forces_of(root, "forces", kinds, report)
    }

    /// The force elements between the two sides of an axle.
    pub(crate) fn axle_forces(
        &self,
        root: &mut Section,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Force>)> {
        self.forces_of(root, "axle_forces", KINDS_ACROSS, report)
    }

    fn forces_of(
        &self,
        root: &mut Section,
        key: &'static str,
        kinds: &[&'static str],
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Force>)> {
        named_sections(root, key, "spring", report, |section, name, report| {
            self.force(section, name, kinds, report)
        })
    }

    fn force(
        &self,
        mut section: Section,
        name: &str,
        kinds: &[&'static str],
        report: &mut Report,
    ) -> Option<Force> {
        let Some(kind) = section.word("kind", "kind of force", kinds, report) else {
            // Which other keys the force has depends on its kind.
            section.finish_open(report);
            return None;
        };
        let element = self.element(&mut section, kind, name, report);
        section.finish(report);
        let (i, j, kind) = element?;
        Some(Force { name: name.to_owned(), i, j, kind })
    }

    /// Reads the keys of a kind, which is one of [`KINDS_WITH_TYRE`].
    fn element(
        &self,
        section: &mut Section,
        kind: &str,
        name: &str,
        report: &mut Report,
    ) -> Option<Element> {
        match kind {
            "spring" => self.spring(section, name, report),
            "damper" => self.damper(section, name, report),
            "actuator" => self.actuator(section, name, report),
            "bump-stop" => self.stop(section, name, Acts::Below, report),
            "rebound-stop" => self.stop(section, name, Acts::Above, report),
            "torsion-spring" => self.torsion_spring(section, name, report),
            "bushing" => {
                let bodies = self.between(section, &format!("the force `{name}`"), report);
                let kind = self.bushing(section, name, None, report);
                let (i, j) = bodies?;
                Some((i, j, kind?))
            }
            "tyre" => self.tyre(section, report),
            "force" => {
                let at =
                    self.point(section, "at", "name the point it acts on: `at = \"…\"`", report);
                let (body, frame, direction, size) =
                    self.load(section, "force", Quantity::Force, report)?;
                let kind = ForceKind::PointForce { at: at?, frame, direction, size };
                Some((BodyId::GROUND, body, kind))
            }
            _ => {
                let (body, frame, direction, size) =
                    self.load(section, "moment", Quantity::Torque, report)?;
                Some((BodyId::GROUND, body, ForceKind::Moment { frame, direction, size }))
            }
        }
    }

    /// The body, frame, direction and size of a load.
    fn load(
        &self,
        section: &mut Section,
        key: &'static str,
        quantity: Quantity,
        report: &mut Report,
    ) -> Option<(BodyId, LoadFrame, [f64; 3], f64)> {
        let body = self.loaded_body(section, report);
        let help = format!("write its components: `{key} = [0.0, 0.0, 1000.0]`");
        let vector = section.required::<[f64; 3]>(key, &help, report);
        let frames = [("space", LoadFrame::Space), ("body", LoadFrame::Body)];
        let frame = section.choice_or("frame", "frame", &frames, LoadFrame::Space, report);
        let vector = self.vector(&vector?, quantity, report);
        // A load of zero has no direction of its own, so any will do.
        let direction = if vector == [0.0; 3] { [0.0, 0.0, 1.0] } else { vector };
        Some((body?, frame?, direction, norm(vector)))
    }
}
