//! Springs, dampers, actuators and stops: forces along the line between two points.

use toml::Spanned;

use super::law::{self, LENGTH, SPEED, STOP};
use super::{Parts, not_negative};
use crate::mechanism::{Acts, BodyId, Curve, ForceKind, Law, PointId, Reference};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

const POSITIVE: &str =
    "a length is not negative; a spring that pushes has a smaller length than its free length";

/// A force element and the bodies it acts on.
pub(super) type Element = (BodyId, BodyId, ForceKind);

/// What the length is measured from, and a constant part of λ.
type Rest = (Reference, f64);

impl Parts<'_> {
    /// λ = −F(free length − length) + damping: compression pushes, so λ is negative in it.
    pub(super) fn spring(
        &self,
        section: &mut Section,
        name: &str,
        report: &mut Report,
    ) -> Option<Element> {
        let ends = self.ends(section, name, report);
        let curve = self.elastic(section, name, LENGTH, "compression, force", report);
        let viscous = self.optional_damping(section, name, report);
        let rest = self.rest(section, name, curve.as_ref(), report);
        let ((i, j, [on_i, on_j]), (reference, preload)) = (ends?, rest?);
        let law =
            Law { elastic: curve?.reversed(), viscous: viscous?, preload, acts: Acts::Always };
        Some((i, j, ForceKind::Line { on_i, on_j, reference, law }))
    }

    /// λ = damping: tension resists extension.
    pub(super) fn damper(
        &self,
        section: &mut Section,
        name: &str,
        report: &mut Report,
    ) -> Option<Element> {
        let ends = self.ends(section, name, report);
        let keys = ["damping", "table"];
        let viscous = self.linear_or_table(section, keys, name, SPEED, "velocity, force", report);
        let (i, j, [on_i, on_j]) = ends?;
        let law = Law { viscous: viscous?, ..Law::default() };
        Some((i, j, ForceKind::Line { on_i, on_j, reference: Reference::Design(0.0), law }))
    }

    /// A constant λ.
    pub(super) fn actuator(
        &self,
        section: &mut Section,
        name: &str,
        report: &mut Report,
    ) -> Option<Element> {
        let ends = self.ends(section, name, report);
        let help = "write the force, positive where it pulls the ends together: `force = 500.0`";
        let force = self.number(section, "force", Quantity::Force, help, report);
        let (i, j, [on_i, on_j]) = ends?;
        let law = Law::constant(force?.into_inner());
        Some((i, j, ForceKind::Line { on_i, on_j, reference: Reference::Design(0.0), law }))
    }

    /// A stop that acts when the line is shorter (`Acts::Below`) or longer than at the design
    /// position by more than its clearance.
    pub(super) fn stop(
        &self,
        section: &mut Section,
        name: &str,
        acts: Acts,
        report: &mut Report,
    ) -> Option<Element> {
        let ends = self.ends(section, name, report);
        let help = "write by how much the length changes from the design position until the stop touches: `clearance = 40.0`";
        let clearance = self.number(section, "clearance", Quantity::Length, help, report);
        let columns = "way beyond the clearance, force";
        let curve = self.elastic(section, name, STOP, columns, report);
        let damping = self.damping(section, report);
        let ((i, j, [on_i, on_j]), clearance) = (ends?, clearance?.into_inner());
        let (elastic, offset) = match acts {
            Acts::Above => (curve?, clearance),
            Acts::Below | Acts::Always => (curve?.reversed(), -clearance),
        };
        let law = Law { elastic, viscous: damping, preload: 0.0, acts };
        Some((i, j, ForceKind::Line { on_i, on_j, reference: Reference::Design(offset), law }))
    }

    /// The bodies and the point on each.
    fn ends(
        &self,
        section: &mut Section,
        name: &str,
        report: &mut Report,
    ) -> Option<(BodyId, BodyId, [PointId; 2])> {
        let bodies = self.between(section, &format!("the force `{name}`"), report);
        let help = "name a point on each body: `on = [\"spring_upper\", \"spring_lower\"]`";
        let points = self.two_points(section, "on", help, report);
        let ((i, j), points) = (bodies?, points?);
        Some((i, j, points))
    }

    /// `damping`, zero where it is absent or wrong.
    pub(super) fn damping(&self, section: &mut Section, report: &mut Report) -> Curve {
        let damping = self.optional_number(section, "damping", Quantity::Damping, report);
        damping.map_or(Curve::Zero, |damping| Curve::linear(damping.into_inner()))
    }

    /// `damping` or `damping_table` or none of the two.
    fn optional_damping(
        &self,
        section: &mut Section,
        name: &str,
        report: &mut Report,
    ) -> Option<Curve> {
        let keys = ["damping", "damping_table"];
        if keys.iter().all(|key| section.value(key).is_none()) {
            return Some(Curve::Zero);
        }
        self.linear_or_table(section, keys, name, SPEED, "velocity, force", report)
    }

    /// The length without force, from `free_length`, `preload`, or `free_length` with
    /// `installed_length`.
    fn rest(
        &self,
        section: &mut Section,
        name: &str,
        curve: Option<&Curve>,
        report: &mut Report,
    ) -> Option<Rest> {
        let help = "give `free_length`, or `preload`, the force at the design position, positive where it pushes apart";
        let key = section.one_of(&["free_length", "preload"], help, report);
        let installed = self.optional_number(section, "installed_length", Quantity::Length, report);
        if key? == "free_length" {
            let free = self.number(section, "free_length", Quantity::Length, help, report)?;
            let free = not_negative(&free, "the free length", POSITIVE, report)?;
            let reference = match installed {
                None => Reference::Length(free),
                Some(installed) => {
                    let installed =
                        not_negative(&installed, "the installed length", POSITIVE, report)?;
                    Reference::Design(free - installed)
                }
            };
            return Some((reference, 0.0));
        }
        if installed.is_some() {
            section.clash("preload", "installed_length", help, report);
        }
        let preload = self.number(section, "preload", Quantity::Force, help, report)?;
        match curve? {
            Curve::Zero | Curve::Linear(_) => Some((Reference::Design(0.0), -preload.into_inner())),
            table @ Curve::Table(_) => {
                let compression = preloaded(table, &preload, *preload.get_ref(), name, report)?;
                Some((Reference::Design(compression), 0.0))
            }
        }
    }
}

/// The value at which a table gives a force that the file calls `preload`.
pub(super) fn preloaded(
    table: &Curve,
    preload: &Spanned<f64>,
    force: f64,
    name: &str,
    report: &mut Report,
) -> Option<f64> {
    match law::inverse(table, force) {
        Ok(value) => Some(value),
        Err(problem) => {
            let message = format!("the table of `{name}` cannot give this preload: {problem}");
            report
                .mistake(&preload.span(), message, "this preload")
                .help("change the table, or say at which length or angle it has no force instead");
            None
        }
    }
}
