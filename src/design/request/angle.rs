//! Limits of joint angles.

use toml::Spanned;
use toml::de::DeValue;

use super::Place;
use super::attached::End;
use super::known::{Known, name};
use super::read::{AXES, sections};
use crate::mechanism::BodyId;
use crate::model::read::{FromToml, Section};
use crate::model::{Quantity, Report};
use crate::rig;
use crate::vector::norm;

/// What the angle of a link is measured from. It is fixed in a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// The direction that the link has at the design position.
    Design,
    /// A direction (ISO 8855 axes, of any length but zero) at the design position.
    Direction([f64; 3]),
    /// From one point of the model to another, at the design position.
    Between([usize; 2]),
}

/// A link that does not turn too far in the body that it is joined to.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleLimit {
    /// The name for reports.
    pub name: String,
    /// The ends of the link.
    pub link: [End; 2],
    /// The body in which the reference is fixed.
    pub on: BodyId,
    /// What the angle is measured from.
    pub from: Reference,
    /// The greatest angle (rad, below π).
    pub max: f64,
    /// Where it counts.
    pub states: Vec<rig::Target>,
    /// Where the request says so.
    pub place: Place,
}

impl Known<'_> {
    /// The limits of joint angles.
    pub(super) fn angles(&self, root: &mut Section, report: &mut Report) -> Vec<AngleLimit> {
        let mut angles = vec![];
        for (index, mut section) in sections(root, "angles", report).into_iter().enumerate() {
            let found = self.angle(&mut section, index, report);
            section.finish(report);
            angles.extend(found);
        }
        angles
    }

    fn angle(
        &self,
        section: &mut Section,
        index: usize,
        report: &mut Report,
    ) -> Option<AngleLimit> {
        let name = name(section, "angle", index, report);
        let help = "name two points of the link: `link = [\"tierod_inner\", \"tierod_outer\"]`";
        let link = if section.has("link") {
            section.value("link").and_then(|value| self.link(value, report))
        } else {
            section.required::<[Spanned<String>; 2]>("link", help, report);
            None
        };
        let help = "name the body that has the socket: `on = \"upright\"`";
        let on = section.required::<String>("on", help, report);
        let on = on.and_then(|on| self.context.attached.body(&on, report));
        let from = match section.value("from") {
            Some(value) => self.reference(value, report),
            None => Some(Reference::Design),
        };
        let help = "write the greatest angle to both sides: `max = 25.0`";
        let max = section.required::<f64>("max", help, report);
        let max = max.and_then(|max| {
            let angle = self.context.si(Quantity::Angle, *max.get_ref());
            if angle > 0.0 && angle < std::f64::consts::PI {
                return Some(angle);
            }
            report
                .mistake(&max.span(), "`max` must be between 0° and 180°", "no such angle")
                .help(help);
            None
        });
        let states = self.states(section, report)?;
        let (link, on, from, max) = (link?, on?, from?, max?);
        Some(AngleLimit { name, link, on, from, max, states, place: Place(section.span()) })
    }

    /// The direction from which an angle counts.
    fn reference(&self, value: &Spanned<DeValue>, report: &mut Report) -> Option<Reference> {
        if let Some(word) = value.get_ref().as_str() {
            if word == "design" {
                return Some(Reference::Design);
            }
            if let Some(axis) = AXES.iter().position(|axis| *axis == word) {
                let mut direction = [0.0; 3];
                direction[axis] = 1.0;
                return Some(Reference::Direction(self.context.model.axes.to_iso(direction)));
            }
            let message = format!("there is no direction `{word}`");
            report.mistake(&value.span(), message, "unknown").help(
                "write \"design\", \"x\", \"y\" or \"z\", two points, or a vector such as `[0.0, 1.0, 0.0]`",
            );
            return None;
        }
        let points = value
            .get_ref()
            .as_array()
            .is_some_and(|list| list.first().is_some_and(|first| first.get_ref().is_str()));
        if points {
            let names = <[Spanned<String>; 2]>::read(value, "`from`", report)?;
            let points = self.context.points(&names, report);
            let [(a, _), (b, _)] = points[..] else { return None };
            return Some(Reference::Between([a, b]));
        }
        let vector = <[f64; 3]>::read(value, "`from`", report)?;
        if norm(vector) == 0.0 {
            report
                .mistake(&value.span(), "a direction has a length", "zero")
                .help("write a vector such as `[0.0, 1.0, 0.0]`");
            return None;
        }
        Some(Reference::Direction(self.context.model.axes.to_iso(vector)))
    }
}
