//! The words for equations: which joint, and which motion an equation holds.

use super::build::Mechanism;
use super::topology::{Driver, Joint, JointKind};

const POSITION: [&str; 3] = ["x position", "y position", "z position"];
const ALIGNMENT: [&str; 2] = ["first alignment of the axes", "second alignment of the axes"];
const ORIENTATION: [&str; 3] = ["rotation about z", "rotation about x", "rotation about y"];
const OFFSET: [&str; 2] = ["first offset from the axis", "second offset from the axis"];

/// The motion that each equation of a joint holds, in the order of the equations.
pub(super) fn components(kind: JointKind) -> Vec<&'static str> {
    let groups: &[&[&'static str]] = match kind {
        JointKind::Spherical { .. } => &[&POSITION],
        JointKind::Revolute { .. } => &[&POSITION, &ALIGNMENT],
        JointKind::Universal { .. } => &[&POSITION, &["rotation about the shaft"]],
        JointKind::Translational { .. } => &[&ALIGNMENT, &["rotation about the axis"], &OFFSET],
        JointKind::Cylindrical { .. } => &[&ALIGNMENT, &OFFSET],
        JointKind::Fixed { .. } => &[&POSITION, &ORIENTATION],
        JointKind::Link { .. } => &[&["length"]],
        JointKind::InPlane { .. } => &[&["offset from the plane"]],
        JointKind::InLine { .. } => {
            &[&["first offset from the line", "second offset from the line"]]
        }
        JointKind::Perpendicular { .. } => &[&["rotation about the axis"]],
        JointKind::Hooke { .. } => &[&POSITION, &["right angle of the pins"]],
        JointKind::PerpendicularAxes { .. } => &[&["right angle of the axes"]],
        JointKind::ParallelAxes { .. } => &[&ALIGNMENT],
        JointKind::Orientation { .. } => &[&ORIENTATION],
        JointKind::RackAndPinion { .. } | JointKind::Screw { .. } => &[&["way by rotation"]],
    };
    groups.concat()
}

/// `lca_outer (spherical joint of lca and upright)`.
pub(crate) fn joint(mechanism: &Mechanism, joint: &Joint) -> String {
    let bodies = mechanism.bodies();
    let (i, j) = (&bodies[joint.i.0].name, &bodies[joint.j.0].name);
    let kind = joint.kind.name();
    let noun = if matches!(joint.kind, JointKind::Link { .. }) { "" } else { " joint" };
    format!("{} ({kind}{noun} of {i} and {j})", joint.name)
}

/// `travel (height driver of upright)`.
pub(super) fn driver(mechanism: &Mechanism, driver: &Driver) -> String {
    let body = &mechanism.bodies()[driver.j.0].name;
    format!("{} ({} driver of {body})", driver.name, driver.kind.name())
}
