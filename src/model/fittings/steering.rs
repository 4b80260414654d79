//! `[steering]`: rack travel, the ratio to the steering wheel, and the stiffness between the two.

use std::f64::consts::TAU;

use toml::Spanned;

use super::Fittings;
use crate::mechanism::{Direction, Force, ForceKind, Joint, JointKind, Law};
use crate::model::architecture::Architecture;
use crate::model::diagnostics::Report;
use crate::model::loads::JointBushing;
use crate::model::parts::{Parts, Y};
use crate::model::quantity::Quantity;
use crate::model::read::Section;

/// The steering gear, in SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steering {
    /// Displacements (m) between which the rack can move, along y of the model's own axes.
    pub limits: Option<[f64; 2]>,
    /// Displacement of the rack (m) along y of the model's own axes per radian of the steering wheel,
    /// which is positive to the left.
    pub rack_per_radian: Option<f64>,
    /// Stiffness (N/m) between the driven end of the steering gear and the rack, seen at the rack;
    /// `None` where that is driven directly.
    pub stiffness: Option<f64>,
}

impl Steering {
    /// The limit (m) that a displacement of the rack (m) exceeds, by more than rounding.
    pub fn exceeded(&self, rack: f64) -> Option<f64> {
        let [lower, upper] = self.limits?;
        let play = 1e-9 * (upper - lower);
        if rack > upper + play {
            Some(upper)
        } else if rack < lower - play {
            Some(lower)
        } else {
            None
        }
    }
}

const STIFFNESSES: [&str; 3] = ["column_stiffness", "torsion_bar_stiffness", "mount_stiffness"];

pub(super) fn fit(
    root: &mut Section,
    parts: &Parts,
    architecture: &mut Architecture,
    fittings: &mut Fittings,
    report: &mut Report,
) {
    let help = "write a section `[steering]` with lines such as `limits = [-75.0, 75.0]` and `rack_per_turn = 50.0`";
    let Some(mut section) = root.optional_section("steering", help, report) else { return };
    let limits = limits(&mut section, parts, report);
    let rack_per_radian = ratio(&mut section, parts, report);
    let stiffness = stiffness(&mut section, parts, rack_per_radian, report);
    let span = section.span();
    let Some(slide) = architecture.rack else {
        let message = format!("`{}` has no rack to steer with", architecture.title);
        report.mistake(&span, message, "a steering gear").help(
            "leave this section out, or name the joint of the rack in [rack] of the architecture",
        );
        section.finish_open(report);
        return;
    };
    fittings.steering = Some(Steering { limits, rack_per_radian, stiffness });
    if let Some(stiffness) = stiffness {
        let Joint { i: carrier, j: rack, kind, .. } = architecture.joints[slide].clone();
        let JointKind::Translational { at, .. } = kind else {
            report.mistake(&span, "the stiffness of a steering gear is known of racks only", "a pitman arm").help(
                "leave out `column_stiffness`, `torsion_bar_stiffness` and `mount_stiffness`, or put a \
                 torsion spring of [[forces]] on a body of the architecture",
            );
            section.finish_open(report);
            return;
        };
        let body = ("steering_input", "Driven end of the steering gear");
        let Some(input) = super::add_body(architecture, &section, body, true, report) else {
            return;
        };
        let joint = |name: &str, i, j, kind| Joint { name: name.to_owned(), i, j, kind };
        let joints = &mut architecture.joints;
        architecture.rack = Some(joints.len());
        joints.push(joint("steering_input_slide", carrier, input, kind));
        // Both slide along the same line, so one equation makes them one.
        let rigid = JointKind::InPlane { at, normal: Y };
        joints.push(joint("steering_gear", input, rack, rigid));
        let along = Direction::Fixed(parts.axes.to_iso([0.0, 1.0, 0.0]));
        let kind = ForceKind::Slide { at, along, law: Law::spring(stiffness) };
        let force = Force { name: "steering_gear".to_owned(), i: input, j: rack, kind };
        let joint = joints.len() - 1;
        fittings.bushings.push((span, JointBushing { joint, force, each_side: false }));
    }
    section.finish(report);
}

fn limits(section: &mut Section, parts: &Parts, report: &mut Report) -> Option<[f64; 2]> {
    let limits = section.optional::<[f64; 2]>("limits", report)?;
    let [lower, upper] = *limits.get_ref();
    if lower < 0.0 && upper > 0.0 {
        return Some(parts.all_in_si(&limits, Quantity::Length, report));
    }
    report
        .mistake(&limits.span(), "`limits` must lie on both sides of zero", "not around zero")
        .help(
            "write the lowest and the highest displacement of the rack: `limits = [-75.0, 75.0]`",
        );
    None
}

/// Displacement of the rack (m) per radian of the steering wheel.
fn ratio(section: &mut Section, parts: &Parts, report: &mut Report) -> Option<f64> {
    let key = "rack_per_turn";
    let turn = parts.optional_number(section, key, Quantity::Length, report)?;
    if *turn.get_ref() != 0.0 {
        return Some(turn.into_inner() / TAU);
    }
    report.mistake(&turn.span(), "the steering wheel does not move the rack", "zero").help(
        "write the displacement of the rack along the model's +y when the steering wheel makes one turn to \
         the left: `rack_per_turn = 50.0`, or −50.0 where the rack then moves against y",
    );
    None
}

/// Mount, column and torsion bar in series, seen at the rack (N/m): a force F at the rack is the torque F r at
/// the wheel, and its twist moves the rack by r, so k = 1/(1/k_mount + r²/k_column + r²/k_bar).
fn stiffness(
    section: &mut Section,
    parts: &Parts,
    rack_per_radian: Option<f64>,
    report: &mut Report,
) -> Option<f64> {
    let [column, bar, mount] = STIFFNESSES;
    let turning = [column, bar].map(|key| {
        let stiffness =
            super::stiffness(section, parts, key, Quantity::RotationalStiffness, report);
        stiffness.map(|stiffness| (key, stiffness))
    });
    let sliding = super::stiffness(section, parts, mount, Quantity::Stiffness, report);
    let mut compliance = sliding.map_or(0.0, |stiffness| 1.0 / stiffness);
    for (key, stiffness) in turning.into_iter().flatten() {
        let Some(r) = rack_per_radian else {
            if !section.has("rack_per_turn") {
                let span = section.value(key).map_or(section.span(), Spanned::span);
                let message = format!("`{key}` is felt at the rack through the steering ratio");
                report
                    .mistake(&span, message, "needs the ratio")
                    .help("add `rack_per_turn = 50.0`, the displacement of the rack per turn");
            }
            return None;
        };
        compliance += r * r / stiffness;
    }
    (compliance > 0.0).then(|| 1.0 / compliance)
}
