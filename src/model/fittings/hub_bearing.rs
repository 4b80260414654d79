//! `[hub_bearing]`: the wheel apart from the upright that carries it.

use toml::Spanned;

use super::Fittings;
use crate::mechanism::{
    BodyId, Bushing, Direction, Force, ForceKind, Joint, JointKind, Law, MomentLaw,
    RotationMeasure, Triad,
};
use crate::model::Model;
use crate::model::architecture::Architecture;
use crate::model::diagnostics::Report;
use crate::model::loads::JointBushing;
use crate::model::parts::Parts;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

/// A bearing between the upright and the wheel, in SI units. Its axes are the spin axis and two across it.
#[derive(Clone, Copy, Debug)]
pub(in crate::model) struct HubBearing {
    upright: BodyId,
    wheel: BodyId,
    /// Along the spin axis (N/m).
    axial: f64,
    /// Across it (N/m).
    radial: f64,
    /// Against camber and against toe (N·m/rad).
    tilt: [f64; 2],
    /// About the spin axis (N·m/rad); `None` where that is locked.
    spin: Option<f64>,
}

pub(super) fn fit(
    root: &mut Section,
    parts: &Parts,
    architecture: &mut Architecture,
    fittings: &mut Fittings,
    report: &mut Report,
) {
    let help = "write a section `[hub_bearing]` with `radial`, `axial` and `tilt`";
    let Some(mut section) = root.optional_section("hub_bearing", help, report) else { return };
    let body = ("wheel", "Wheel, on the hub bearing");
    let body = super::add_body(architecture, &section, body, false, report);
    let stiffness = [
        ("radial", "write the stiffness across the spin axis: `radial = 120000.0`"),
        ("axial", "write the stiffness along the spin axis: `axial = 80000.0`"),
    ];
    let [radial, axial] = stiffness.map(|(key, help)| {
        let number = parts.number(&mut section, key, Quantity::Stiffness, help, report)?;
        super::positive(&number, &format!("`{key}`"), help, report)
    });
    let tilt = tilt(&mut section, parts, report);
    let quantity = Quantity::RotationalStiffness;
    let spin = super::stiffness(&mut section, parts, "spin", quantity, report);
    section.finish(report);
    let Some(wheel) = body else { return };
    let upright = std::mem::replace(&mut architecture.wheel.body, wheel);
    if let (Some(radial), Some(axial), Some(tilt)) = (radial, axial, tilt) {
        fittings.hub_bearing = Some(HubBearing { upright, wheel, axial, radial, tilt, spin });
    }
}

/// The stiffness against camber and toe: two numbers, or one for both.
fn tilt(section: &mut Section, parts: &Parts, report: &mut Report) -> Option<[f64; 2]> {
    let help =
        "write the moment by the tilt of the wheel: `tilt = 200000.0`, or `tilt = [camber, toe]`";
    let quantity = Quantity::RotationalStiffness;
    let listed = section.value("tilt").is_some_and(|value| value.get_ref().is_array());
    let (span, tilt) = if listed {
        let numbers = section.required::<[f64; 2]>("tilt", help, report)?;
        (numbers.span(), parts.all_in_si(&numbers, quantity, report))
    } else {
        let number = parts.number(section, "tilt", quantity, help, report)?;
        (number.span(), [number.into_inner(); 2])
    };
    for stiffness in tilt {
        super::positive(&Spanned::new(span.clone(), stiffness), "`tilt`", help, report)?;
    }
    Some(tilt)
}

impl HubBearing {
    /// Adds the bearing to a model, whose spin axis is known by now.
    ///
    /// Rigid, it is a revolute joint about the spin axis, and where the spin is locked that is a joint of its own,
    /// which stays when the bearing gives way.
    pub(in crate::model) fn attach(&self, model: &mut Model) {
        let Self { upright, wheel, axial, radial, tilt: [camber, toe], spin } = *self;
        let (at, axis) = (model.architecture.wheel.center, model.spin_direction());
        let joints = &mut model.architecture.joints;
        let bearing = joints.len();
        let mut add = |name: &str, kind| {
            joints.push(Joint { name: name.to_owned(), i: upright, j: wheel, kind });
        };
        if spin.is_some() {
            add("hub_bearing", JointKind::Fixed { at });
        } else {
            add("hub_bearing", JointKind::Revolute { at, axis });
            add("spin_lock", JointKind::Perpendicular { at, axis });
        }
        let law = Law::spring;
        // x is the spin axis, z points up, so y lies along the vehicle.
        let bushing = Bushing {
            at,
            axes: Triad { x: axis, z: Direction::Fixed([0.0, 0.0, 1.0]) },
            translation: [axial, radial, radial].map(law),
            rotation: [spin.map_or_else(Law::default, law), law(camber), law(toe)],
            measure: RotationMeasure::RotationVector,
            moment: MomentLaw::Energy,
        };
        let kind = ForceKind::Bushing(Box::new(bushing));
        let force = Force { name: "hub_bearing".to_owned(), i: upright, j: wheel, kind };
        model.loads.bushings.push(JointBushing { joint: bearing, force, each_side: false });
    }
}
