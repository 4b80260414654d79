//! What a model adds to its architecture: it rewrites bodies and joints before loads are read, so that
//! whatever follows knows one architecture only.
//!
//! Every fitting is a body that a rigid joint holds and that elastic elements hold instead, like the bushings
//! of `[bushings]`. So rigid joints leave a fitting without effect.

mod hub_bearing;
pub(super) mod other_side;
mod steering;
mod subframe;

use std::ops::Range;

use toml::Spanned;

pub use steering::Steering;

pub(super) use hub_bearing::HubBearing;
pub(super) use subframe::opposite;

use super::architecture::{Architecture, BodyRole};
use super::diagnostics::Report;
use super::loads::JointBushing;
use super::parts::Parts;
use super::quantity::Quantity;
use super::read::Section;
use crate::mechanism::BodyId;

/// The sections of fittings.
const SECTIONS: [&str; 3] = ["subframe", "steering", "hub_bearing"];

/// What the fittings of a model leave for later.
#[derive(Default)]
pub(super) struct Fittings {
    pub(super) steering: Option<Steering>,
    pub(super) hub_bearing: Option<HubBearing>,
    /// Elements that stand for the rigid joints of fittings, with their places.
    pub(super) bushings: Vec<(Range<usize>, JointBushing)>,
}

/// Reads the fittings and rewrites the architecture; `None` is one that is not known.
pub(super) fn fit(
    root: &mut Section,
    parts: &Parts,
    architecture: Option<&mut Architecture>,
    report: &mut Report,
) -> Fittings {
    let Some(architecture) = architecture else {
        // That there is no architecture has been noted.
        for key in SECTIONS {
            root.value(key);
        }
        return Fittings::default();
    };
    let mut fittings = Fittings::default();
    // The steering stands on the body that carries the rack, so the subframe comes first.
    subframe::fit(root, parts, architecture, &mut fittings, report);
    steering::fit(root, parts, architecture, &mut fittings, report);
    hub_bearing::fit(root, parts, architecture, &mut fittings, report);
    fittings
}

/// Adds a body to an architecture that has none of this name.
fn add_body(
    architecture: &mut Architecture,
    section: &Section,
    (name, meaning): (&str, &str),
    shared: bool,
    report: &mut Report,
) -> Option<BodyId> {
    if architecture.ground == name || architecture.bodies.iter().any(|body| body.name == name) {
        let message = format!("`{}` has a body `{name}` already", architecture.title);
        report
            .mistake(&section.span(), message, "would add another one")
            .help("give the body of the architecture another name, or leave this section out");
        return None;
    }
    // In joints between the sides, bodies of the other side have the numbers behind those of this side.
    let number = architecture.bodies.len();
    for joint in &mut architecture.axle_joints {
        for body in [&mut joint.i, &mut joint.j] {
            body.0 += usize::from(body.0 > number);
        }
    }
    let (name, meaning) = (name.to_owned(), meaning.to_owned());
    architecture.bodies.push(BodyRole { name, meaning, shared });
    Some(BodyId(architecture.bodies.len()))
}

/// Notes a number that is not above zero; `help` says what to write.
fn positive(number: &Spanned<f64>, what: &str, help: &str, report: &mut Report) -> Option<f64> {
    if *number.get_ref() > 0.0 {
        return Some(*number.get_ref());
    }
    report.mistake(&number.span(), format!("{what} must be positive"), "not positive").help(help);
    None
}

/// A stiffness (SI) that may be absent and is above zero.
fn stiffness(
    section: &mut Section,
    parts: &Parts,
    key: &'static str,
    quantity: Quantity,
    report: &mut Report,
) -> Option<f64> {
    let number = parts.optional_number(section, key, quantity, report)?;
    positive(&number, &format!("`{key}`"), "leave it out for a part that is rigid", report)
}
