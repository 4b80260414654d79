//! Reads what acts on a suspension: `[bodies]`, `[quarter_car]`, `[tyre]`, `[[forces]]`, `[bushings]`,
//! `[anti_roll_bar]`.

use std::ops::Range;

use toml::Spanned;

use super::architecture::Architecture;
use super::diagnostics::Report;
use super::loads::{AntiRollBar, JointBushing, Loads, Tyre};
use super::parts::{Parts, TyreFile, gravity};
use super::quantity::Quantity;
use super::read::{Section, as_section};
use super::suggest;
use crate::mechanism::{BodyId, Force, Joint, JointKind, MassProperties};

/// The loads that are right, with their places.
pub(super) struct LoadsFile {
    gravity: Option<f64>,
    sprung_mass: Option<Spanned<f64>>,
    masses: Vec<(Range<usize>, BodyId, MassProperties)>,
    tyre: Option<(Range<usize>, TyreFile)>,
    forces: Vec<(Range<usize>, Force)>,
    bushings: Vec<(Range<usize>, JointBushing)>,
    axle_forces: Vec<(Range<usize>, Force)>,
    anti_roll_bar: Option<AntiRollBar>,
}

/// Where the loads stand in the text, in the order of [`Loads`].
pub(super) struct LoadPlaces {
    pub(super) masses: Vec<(Range<usize>, BodyId)>,
    pub(super) tyre: Range<usize>,
    pub(super) forces: Vec<Range<usize>>,
    pub(super) bushings: Vec<Range<usize>>,
    pub(super) axle_forces: Vec<Range<usize>>,
}

impl LoadsFile {
    /// `joints` are those of the architecture, none where that is not known; `fitted` stands for some of
    /// them already.
    pub(super) fn read(
        root: &mut Section,
        parts: &Parts,
        joints: &[Joint],
        fitted: Vec<(Range<usize>, JointBushing)>,
        report: &mut Report,
    ) -> Self {
        let mut place_of_mass = None;
        let sprung_mass = quarter_car(root, parts, &mut place_of_mass, report);
        let masses = masses(root, parts, &mut place_of_mass, report);
        let gravity = gravity(root, place_of_mass.as_ref(), report);
        let tyre = tyre(root, parts, report);
        let forces = parts.forces(root, false, report).into_iter();
        let forces = forces.filter_map(|(name, force)| Some((name.span(), force?))).collect();
        let mut bushings = bushings(root, parts, joints, report);
        bushings.extend(fitted);
        let axle_forces = axle_forces(root, parts, report);
        let anti_roll_bar = anti_roll_bar(root, parts, report);
        Self { gravity, sprung_mass, masses, tyre, forces, bushings, axle_forces, anti_roll_bar }
    }

    /// The loads without their places. `radius` is that of the wheel (m).
    pub(super) fn loads(&self, architecture: &Architecture, radius: f64) -> Loads {
        let mut masses = vec![None; architecture.bodies().len()];
        for (_, body, mass) in &self.masses {
            masses[body.0 - 1] = Some(*mass);
        }
        let tyre = self.tyre.as_ref().map(|(_, tyre)| Tyre {
            contact: tyre.contact,
            free_radius: tyre.free_radius.unwrap_or(radius),
            ground: tyre.ground,
            law: tyre.law.clone(),
        });
        Loads {
            gravity: self.gravity.unwrap_or(0.0),
            sprung_mass: self.sprung_mass.as_ref().map(|mass| *mass.get_ref()),
            masses,
            tyre,
            forces: self.forces.iter().map(|(_, force)| force.clone()).collect(),
            bushings: self.bushings.iter().map(|(_, bushing)| bushing.clone()).collect(),
            axle_forces: self.axle_forces.iter().map(|(_, force)| force.clone()).collect(),
            anti_roll_bar: self.anti_roll_bar,
        }
    }

    /// The force elements that are right.
    pub(super) fn forces(&self) -> impl Iterator<Item = &Force> {
        self.forces.iter().map(|(_, force)| force)
    }

    /// The joints that bushings stand for, by their places in the architecture.
    pub(super) fn bushed(&self) -> impl Iterator<Item = usize> {
        self.bushings.iter().map(|(_, bushing)| bushing.joint)
    }

    pub(super) fn places(&self) -> LoadPlaces {
        LoadPlaces {
            masses: self.masses.iter().map(|(span, body, _)| (span.clone(), *body)).collect(),
            tyre: self.tyre.as_ref().map_or(0..0, |(span, _)| span.clone()),
            forces: self.forces.iter().map(|(span, _)| span.clone()).collect(),
            bushings: self.bushings.iter().map(|(span, _)| span.clone()).collect(),
            axle_forces: self.axle_forces.iter().map(|(span, _)| span.clone()).collect(),
        }
    }
}

/// The forces between the two sides. The points that they name are used on this side, too.
fn axle_forces(
    root: &mut Section,
    parts: &Parts,
    report: &mut Report,
) -> Vec<(Range<usize>, Force)> {
    let names = parts.names.across();
    let across = Parts { names: &names, units: parts.units, axes: parts.axes, own_numbers: true };
    let forces = across.axle_forces(root, report);
    parts.names.use_points_of(&names);
    forces.into_iter().filter_map(|(name, force)| Some((name.span(), force?))).collect()
}

fn quarter_car(
    root: &mut Section,
    parts: &Parts,
    place: &mut Option<Range<usize>>,
    report: &mut Report,
) -> Option<Spanned<f64>> {
    let help = "write the mass of the chassis above this wheel: `sprung_mass = 380.0`";
    let mut section = root.optional_section("quarter_car", help, report)?;
    *place = Some(section.span());
    let mass = parts.number(&mut section, "sprung_mass", Quantity::Mass, help, report);
    section.finish(report);
    let mass = mass?;
    if *mass.get_ref() <= 0.0 {
        report.mistake(&mass.span(), "the sprung mass must be positive", "not positive").help(help);
        return None;
    }
    Some(mass)
}

fn masses(
    root: &mut Section,
    parts: &Parts,
    place: &mut Option<Range<usize>>,
    report: &mut Report,
) -> Vec<(Range<usize>, BodyId, MassProperties)> {
    let mut masses = vec![];
    let help = "write a section for a body: `[bodies.upright]` with `mass`, `center_of_mass` and `inertia`";
    let Some(bodies) = root.optional_section("bodies", help, report) else {
        return masses;
    };
    for (name, value) in bodies.entries() {
        let title = format!("[bodies.{}]", name.get_ref());
        let Some(mut section) = as_section(value, title, help, report) else {
            continue;
        };
        place.get_or_insert_with(|| name.span());
        let mass = parts.mass(&mut section, report);
        section.finish(report);
        let help = "the chassis has no mass of its own; give `sprung_mass` in [quarter_car]";
        let body = parts.names.moving_body(&name, help, report);
        if let (Some(mass), Some(body)) = (mass, body) {
            masses.push((name.span(), body, mass));
        }
    }
    masses
}

fn tyre(
    root: &mut Section,
    parts: &Parts,
    report: &mut Report,
) -> Option<(Range<usize>, TyreFile)> {
    let help = "write a section `[tyre]` with `contact`, `stiffness` and `ground`";
    let mut section = root.optional_section("tyre", help, report)?;
    let tyre = parts.tyre_law(&mut section, report);
    let span = section.span();
    section.finish(report);
    Some((span, tyre?))
}

fn anti_roll_bar(root: &mut Section, parts: &Parts, report: &mut Report) -> Option<AntiRollBar> {
    let help =
        "write a section `[anti_roll_bar]` with `stiffness`, `pivot`, `link` and `link_body`";
    let mut section = root.optional_section("anti_roll_bar", help, report)?;
    let help = "write the torque by the angle between the arms: `stiffness = 8000.0`, or 0.0 for a bar that is cut";
    let quantity = Quantity::RotationalStiffness;
    let stiffness = parts.number(&mut section, "stiffness", quantity, help, report);
    let help = "name a point on the axis of the bar: `pivot = \"arb_pivot\"`";
    let pivot = parts.point(&mut section, "pivot", help, report);
    let help = "name the ends of the drop link, that on the arm first: `link = [\"arb_arm_end\", \"arb_link_lower\"]`";
    let link = parts.two_points(&mut section, "link", help, report);
    let help = "name the body that carries the drop link: `link_body = \"lca\"`";
    let body = section.required::<String>("link_body", help, report);
    section.finish(report);
    let help = "name a moving body; on the chassis the bar would do nothing";
    let link_body = body.and_then(|body| parts.names.moving_body(&body, help, report));
    let stiffness = stiffness?;
    if *stiffness.get_ref() < 0.0 {
        report
            .mistake(&stiffness.span(), "the stiffness of the bar is below zero", "negative")
            .help("write 0.0 for a bar that is cut");
        return None;
    }
    let stiffness = stiffness.into_inner();
    Some(AntiRollBar { stiffness, pivot: pivot?, link: link?, link_body: link_body? })
}

fn bushings(
    root: &mut Section,
    parts: &Parts,
    joints: &[Joint],
    report: &mut Report,
) -> Vec<(Range<usize>, JointBushing)> {
    let mut bushings = vec![];
    let help = "write a section for a bushing: `[bushings.lca_front_bushing]` with `replaces` and `stiffness`";
    let Some(list) = root.optional_section("bushings", help, report) else {
        return bushings;
    };
    for (name, value) in list.entries() {
        let title = format!("[bushings.{}]", name.get_ref());
        let Some(mut section) = as_section(value, title, help, report) else {
            continue;
        };
        let help = "name the joint that it stands for: `replaces = \"lca_pivot\"`";
        let replaces = section.required::<String>("replaces", help, report);
        let Some(joint) = replaces.and_then(|word| joint(&word, joints, report)) else {
            // Which point and bodies the bushing has depends on the joint.
            section.finish_open(report);
            continue;
        };
        let at = match joints[joint].kind {
            JointKind::Link { .. } => None,
            kind => Some(kind.points()[0]),
        };
        let kind = parts.bushing(&mut section, name.get_ref(), at, report);
        section.finish(report);
        if let Some(kind) = kind {
            let (i, j) = (joints[joint].i, joints[joint].j);
            let force = Force { name: name.get_ref().clone(), i, j, kind };
            bushings.push((name.span(), JointBushing { joint, force, each_side: false }));
        }
    }
    bushings
}

/// The joint of a name.
pub(super) fn joint(
    name: &Spanned<String>,
    joints: &[Joint],
    report: &mut Report,
) -> Option<usize> {
    let word = name.get_ref();
    let found = joints.iter().position(|joint| joint.name == *word);
    if found.is_none() && !joints.is_empty() {
        let known: Vec<&str> = joints.iter().map(|joint| joint.name.as_str()).collect();
        report
            .mistake(&name.span(), format!("there is no joint `{word}`"), "unknown joint")
            .help(suggest::choices(word, &known));
    }
    found
}
