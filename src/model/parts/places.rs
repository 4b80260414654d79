//! Points, directions and pairs of bodies.

use toml::Spanned;
use toml::de::DeValue;

use super::Parts;
use crate::mechanism::{BodyId, Direction, PointId};
use crate::model::diagnostics::Report;
use crate::model::read::Section;

/// The directions that have a name, in the axes of the file.
pub(super) const AXES: &[(&str, [f64; 3])] =
    &[("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])];

impl Parts<'_> {
    /// The two bodies of `between`; `what` is such as "the joint `lca_pivot`".
    pub(super) fn between(
        &self,
        section: &mut Section,
        what: &str,
        report: &mut Report,
    ) -> Option<(BodyId, BodyId)> {
        let help = "name the two bodies: `between = [\"chassis\", \"lca\"]`";
        let between = section.required::<[Spanned<String>; 2]>("between", help, report)?;
        let [i, j] = between.get_ref().each_ref().map(|name| self.names.body(name, report));
        let (i, j) = (i?, j?);
        if i == j {
            let message = format!("{what} joins a body to itself");
            report
                .mistake(&between.span(), message, "the same body twice")
                .help("name two different bodies");
            return None;
        }
        Some((i, j))
    }

    /// The moving body of `body`.
    pub(super) fn loaded_body(&self, section: &mut Section, report: &mut Report) -> Option<BodyId> {
        let help = "name the body that it acts on: `body = \"…\"`";
        let name = section.required::<String>("body", help, report)?;
        self.names.moving_body(&name, "name a moving body, on which it has an effect", report)
    }

    /// The point of `at` or another key.
    pub(crate) fn point(
        &self,
        section: &mut Section,
        key: &'static str,
        help: &str,
        report: &mut Report,
    ) -> Option<PointId> {
        let name = section.required(key, help, report)?;
        self.names.point(&name, report)
    }

    /// A direction: two points, the name of an axis of the file, or a vector in its axes.
    pub(crate) fn direction(
        &self,
        section: &mut Section,
        key: &'static str,
        report: &mut Report,
    ) -> Option<Direction> {
        let help = format!(
            "write two points, `{key} = [\"lca_front\", \"lca_rear\"]`, or an axis, `{key} = \"y\"`"
        );
        if section.value(key).is_some_and(|value| value.get_ref().is_str()) {
            let axis = section.choice(key, "axis", AXES, ", or two points", report)?;
            return Some(Direction::Fixed(self.axes.to_iso(axis.into_inner())));
        }
        let list = section.value(key).and_then(|value| value.get_ref().as_array());
        let number =
            |value: &Spanned<DeValue>| value.get_ref().is_float() || value.get_ref().is_integer();
        if self.own_numbers && list.is_some_and(|list| list.iter().next().is_some_and(number)) {
            let vector = section.required::<[f64; 3]>(key, &help, report)?;
            return Some(Direction::Fixed(self.axes.to_iso(vector.into_inner())));
        }
        let [from, to] = self.two_points(section, key, &help, report)?;
        Some(Direction::Between(from, to))
    }

    /// Two different points.
    pub(crate) fn two_points(
        &self,
        section: &mut Section,
        key: &'static str,
        help: &str,
        report: &mut Report,
    ) -> Option<[PointId; 2]> {
        let pair = section.required::<[Spanned<String>; 2]>(key, help, report)?;
        let [from, to] = pair.get_ref().each_ref().map(|name| self.names.point(name, report));
        let points = [from?, to?];
        if points[0] == points[1] {
            let message = format!("`{key}` has one point twice");
            report.mistake(&pair.span(), message, "the same point").help(help);
            return None;
        }
        Some(points)
    }
}
