//! Torsion springs: moments about an axis that two bodies share.

use toml::Spanned;

use super::Parts;
use super::law::ANGLE;
use super::line::{Element, preloaded};
use crate::mechanism::{Acts, Curve, ForceKind, Law};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

impl Parts<'_> {
    /// λ = M(θ − free angle) + c θ̇: the moment on body j about the axis is −λ.
    pub(super) fn torsion_spring(
        &self,
        section: &mut Section,
        name: &str,
        report: &mut Report,
    ) -> Option<Element> {
        let bodies = self.between(section, &format!("the force `{name}`"), report);
        let axis = self.direction(section, "axis", report);
        let curve = self.elastic(section, name, ANGLE, "angle, torque", report);
        let quantity = Quantity::RotationalDamping;
        let damping = self.optional_number(section, "damping", quantity, report);
        let rest = self.torsion_rest(section, name, curve, report);
        let ((i, j), (elastic, preload)) = (bodies?, rest?);
        let viscous = damping.map_or(Curve::Zero, |damping| Curve::linear(damping.into_inner()));
        let law = Law { elastic, viscous, preload, acts: Acts::Always };
        Some((i, j, ForceKind::Torsion { axis: axis?, law }))
    }

    /// The curve by θ and the constant part, from `free_angle`, `preload` or none of the two.
    fn torsion_rest(
        &self,
        section: &mut Section,
        name: &str,
        curve: Option<Curve>,
        report: &mut Report,
    ) -> Option<(Curve, f64)> {
        let free = self.optional_number(section, "free_angle", Quantity::Angle, report);
        let preload = self.optional_number(section, "preload", Quantity::Torque, report);
        if section.has("free_angle") && section.has("preload") {
            let help = "keep one of the two: both say what the moment at the design position is";
            section.clash("free_angle", "preload", help, report);
            return None;
        }
        let free = free.map_or(0.0, Spanned::into_inner);
        match (curve?, preload) {
            (Curve::Table(table), None) => Some((Curve::Table(table.shifted(free)), 0.0)),
            (Curve::Table(table), Some(preload)) => {
                let curve = Curve::Table(table.clone());
                let angle = preloaded(&curve, &preload, -*preload.get_ref(), name, report)?;
                Some((Curve::Table(table.shifted(-angle)), 0.0))
            }
            (Curve::Linear(k), None) => Some((Curve::Linear(k), 0.0 - k * free)),
            (curve, preload) => {
                Some((curve, preload.map_or(0.0, |moment| 0.0 - moment.into_inner())))
            }
        }
    }
}
