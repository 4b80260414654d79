//! Boxes that points must not leave.

use toml::Spanned;

use super::Place;
use super::attached::End;
use super::known::{Known, name};
use super::read::{AXES, interval, sections};
use crate::model::Report;
use crate::model::read::{FromToml, Section};
use crate::rig;

/// Points that stay in a box, whose faces are fixed to the chassis.
#[derive(Clone, Debug, PartialEq)]
pub struct PackagingBox {
    /// The name for reports.
    pub name: String,
    /// The points with the bodies that move them.
    pub points: Vec<End>,
    /// Least and greatest x, y and z (m, ISO 8855 axes); infinite where the box is open.
    pub limits: [[f64; 2]; 3],
    /// Where it counts.
    pub states: Vec<rig::Target>,
    /// Where the request says so.
    pub place: Place,
}

impl Known<'_> {
    /// The boxes.
    pub(super) fn boxes(&self, root: &mut Section, report: &mut Report) -> Vec<PackagingBox> {
        let mut boxes = vec![];
        for (index, mut section) in sections(root, "boxes", report).into_iter().enumerate() {
            let found = self.packaging_box(&mut section, index, report);
            section.finish(report);
            boxes.extend(found);
        }
        boxes
    }

    fn packaging_box(
        &self,
        section: &mut Section,
        index: usize,
        report: &mut Report,
    ) -> Option<PackagingBox> {
        let name = name(section, "box", index, report);
        let help =
            "say what stays in the box: `points = [\"tierod_inner\"]` or `body = \"tierod\"`";
        let points = match section.one_of(&["points", "body"], help, report) {
            Some("points") => {
                let names = section.optional::<Vec<Spanned<String>>>("points", report);
                names.map(|names| {
                    let points = self.context.points(names.get_ref(), report);
                    points.iter().filter_map(|(p, span)| self.end(*p, span, report)).collect()
                })
            }
            Some(_) => section
                .optional::<String>("body", report)
                .and_then(|body| self.context.attached.body(&body, report))
                .map(|body| self.context.attached.points_of(body)),
            None => None,
        };
        let mut limits = [[f64::NEG_INFINITY, f64::INFINITY]; 3];
        let mut given = false;
        for (axis, key) in AXES.into_iter().enumerate() {
            let Some(value) = section.value(key) else { continue };
            given = true;
            if !value.get_ref().is_array() {
                <[f64; 2]>::read(value, &format!("`{key}`"), report);
                continue;
            }
            if let Some(ends) = interval(value, &format!("`{key}`"), report) {
                limits[axis] = self.context.interval(axis, ends.into_inner());
            }
        }
        if !given {
            report
                .mistake(&section.span(), "the box has no limits", "this box")
                .help("write `x`, `y` or `z` with least and greatest value: `z = [-200.0, 150.0]`");
            return None;
        }
        let states = self.states(section, report)?;
        let points: Vec<End> = points?;
        if points.is_empty() {
            return None; // Why has been noted.
        }
        Some(PackagingBox { name, points, limits, states, place: Place(section.span()) })
    }
}
