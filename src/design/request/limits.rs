//! What must not happen: points that move too far, parts that leave their room or come too near.

use super::angle::AngleLimit;
use super::clearance::{self, Clearance, Round};
use super::known::{self, Known};
use super::packaging::PackagingBox;
use super::read::Context;
use super::target::Target;
use crate::model::Report;
use crate::model::read::Section;

/// What must not happen.
#[derive(Clone, Debug, Default)]
pub struct Limits {
    /// How far (m) each hard point may be from where the model has it: √(Δx² + Δy² + Δz²).
    pub movement: Option<f64>,
    /// How far (m) all of them together: √(Σ Δx² + Δy² + Δz²), the root of the sum of squares of all points.
    pub total_movement: Option<f64>,
    /// Boxes that points must not leave.
    pub boxes: Vec<PackagingBox>,
    /// Parts that must not come too near to each other.
    pub clearances: Vec<Clearance>,
    /// Joints that must not turn too far.
    pub angles: Vec<AngleLimit>,
    /// The barrel of the rim, inside of which parts have to stay.
    pub rim: Option<Round>,
    /// The tyre, outside of which parts have to stay.
    pub tyre: Option<Round>,
}

/// The limits of `[limits]`.
pub(super) fn distances(root: &mut Section, context: &Context, report: &mut Report) -> Limits {
    let mut limits = Limits::default();
    let help = "write a section `[limits]` with `movement = 15.0` or `total_movement = 40.0`";
    if let Some(mut section) = root.optional_section("limits", help, report) {
        limits.movement = context.length(&mut section, "movement", report);
        limits.total_movement = context.length(&mut section, "total_movement", report);
        section.finish(report);
    }
    limits
}

/// Adds all other limits.
pub(super) fn read(
    root: &mut Section,
    context: &Context,
    limits: &mut Limits,
    targets: &[Target],
    report: &mut Report,
) {
    let has_rounds = ["rim", "tyre"].map(|key| root.has(key));
    let rim = clearance::round(root, "rim", context, report);
    let tyre = clearance::round(root, "tyre", context, report);
    let known = Known { context, rounds: [rim, tyre], has_rounds, states: known::ends(targets) };
    limits.boxes = known.boxes(root, report);
    limits.clearances = known.clearances(root, report);
    limits.angles = known.angles(root, report);
    (limits.rim, limits.tyre) = (rim, tyre);
}
