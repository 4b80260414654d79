//! Vertical tyres on level ground.

use toml::Spanned;

use super::Parts;
use super::law::LENGTH;
use super::line::Element;
use crate::mechanism::{Acts, BodyId, Contact, ForceKind, Law};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

/// Where a tyre touches the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TyreContact {
    /// Straight below the wheel centre: only its height counts.
    WheelCenter,
    /// At the lowest point of the disc of the free radius.
    ContactPatch,
}

/// What the sections of tyres have in common.
pub(crate) struct TyreFile {
    pub(crate) contact: TyreContact,
    pub(crate) free_radius: Option<f64>,
    pub(crate) ground: f64,
    pub(crate) law: Law,
}

const CONTACTS: &[(&str, TyreContact)] =
    &[("contact-patch", TyreContact::ContactPatch), ("wheel-center", TyreContact::WheelCenter)];

impl Parts<'_> {
    /// λ = −F(deflection) + c Φ̇ with Φ the height above the ground; −λ is the load.
    pub(crate) fn tyre_law(&self, section: &mut Section, report: &mut Report) -> Option<TyreFile> {
        let contact = section.choice("contact", "contact", CONTACTS, "", report);
        let curve = self.elastic(section, "tyre", LENGTH, "deflection, load", report);
        let viscous = self.damping(section, report);
        let free_radius = self.optional_number(section, "free_radius", Quantity::Length, report);
        let help = "write the height of the ground, the z of the file: `ground = -428.0`";
        let ground = self.number(section, "ground", Quantity::Length, help, report);
        let lift_off = section.optional::<bool>("lift_off", report);
        let lift_off = lift_off.is_none_or(Spanned::into_inner);
        let acts = if lift_off { Acts::Below } else { Acts::Always };
        Some(TyreFile {
            contact: contact?.into_inner(),
            free_radius: free_radius.map(Spanned::into_inner),
            ground: self.axes.to_iso([0.0, 0.0, ground?.into_inner()])[2],
            law: Law { elastic: curve?.reversed(), viscous, preload: 0.0, acts },
        })
    }

    /// A tyre of a mechanism, on any of its bodies.
    pub(super) fn tyre(&self, section: &mut Section, report: &mut Report) -> Option<Element> {
        let body = self.loaded_body(section, report);
        let center =
            self.point(section, "center", "name the wheel centre: `center = \"…\"`", report);
        let tyre = self.tyre_law(section, report);
        if !section.has("free_radius") {
            let help = "write the radius without load: `free_radius = 300.0`";
            section.required::<f64>("free_radius", help, report);
        }
        section.value("axis");
        let (center, tyre) = (center?, tyre?);
        let contact = match tyre.contact {
            TyreContact::WheelCenter => Contact::Center(center),
            TyreContact::ContactPatch => {
                Contact::Patch { center, spin: self.direction(section, "axis", report)? }
            }
        };
        let free_radius = tyre.free_radius?;
        let kind = ForceKind::Tyre { contact, free_radius, ground: tyre.ground, law: tyre.law };
        Some((BodyId::GROUND, body?, kind))
    }
}
