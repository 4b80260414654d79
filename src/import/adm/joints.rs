//! JOINT and JPRIM.

use super::dataset::{Dataset, normal_to};
use super::notes::Notes;
use super::output::{List, Output, direction, number};
use super::pair::{Pair, not_assembled};
use super::statement::Statement;
use crate::vector::{Vector, cross, dot, norm, sub};

const JOINTS: &[&str] = &[
    "CONVEL",
    "CYLINDRICAL",
    "FIXED",
    "HOOKE",
    "PLANAR",
    "RACKPIN",
    "REVOLUTE",
    "SCREW",
    "SPHERICAL",
    "TRANSLATIONAL",
    "UNIVERSAL",
];

const PRIMITIVES: &[&str] =
    &["ATPOINT", "INLINE", "INPLANE", "ORIENTATION", "PARALLEL_AXES", "PERPENDICULAR"];

pub(super) const JOINT_KEYS: &[&str] = &[
    "CONVEL",
    "CYLINDRICAL",
    "FIXED",
    "HOOKE",
    "PLANAR",
    "RACKPIN",
    "REVOLUTE",
    "SCREW",
    "SPHERICAL",
    "TRANSLATIONAL",
    "UNIVERSAL",
    "I",
    "J",
    "PD",
    "PITCH",
    "IC",
    "ICTRAN",
    "ICROT",
];

pub(super) const PRIMITIVE_KEYS: &[&str] =
    &["ATPOINT", "INLINE", "INPLANE", "ORIENTATION", "PARALLEL_AXES", "PERPENDICULAR", "I", "J"];

/// Axes whose cosine is less are at right angles but for rounding of the dataset.
const RIGHT: f64 = 1e-5;

/// Translates one JOINT.
pub(super) fn joint(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let Some(kind) = kind(statement, JOINTS, notes) else { return };
    let Some(pair) = Pair::of(dataset, statement, notes) else { return };
    for key in ["IC", "ICTRAN", "ICROT"] {
        if let Some((line, value)) = statement.text(key) {
            let what = format!("{key} = {value} of {}", statement.title());
            let why = "initial conditions belong to parts: write VX … WZ of PART, or let Adams save the dataset";
            notes.missing(line, what, why);
        }
    }
    let name = output.name(List::Joints, statement, "joint");
    let axis = ("axis", direction(pair.z_j()));
    let at = ("at", output.point(pair.i));
    let mut write = |kind: &str, lines: &[(&str, String)]| {
        let lines: Vec<(&str, String)> =
            [("kind", format!("\"{kind}\"")), at.clone()].iter().chain(lines).cloned().collect();
        output.section(List::Joints, statement, &name, &lines);
    };
    match kind {
        "SPHERICAL" if pair.together(statement, notes) => write("spherical", &[pair.i_to_j()]),
        "FIXED" if pair.together(statement, notes) => write("fixed", &[pair.i_to_j()]),
        "REVOLUTE" => {
            let held = pair.aligned(statement, notes).is_some();
            if pair.together(statement, notes) && held {
                write("revolute", &[pair.i_to_j(), axis]);
            }
        }
        "CYLINDRICAL" | "TRANSLATIONAL" => {
            let held = pair.aligned(statement, notes).is_some();
            if pair.in_line(statement, notes) && held {
                write(&kind.to_ascii_lowercase(), &[pair.i_to_j(), axis]);
            }
        }
        "HOOKE" | "UNIVERSAL" => {
            let (pin_i, pin_j) = match kind {
                "HOOKE" => (pair.i.frame.axes[0], pair.j.frame.axes[1]),
                _ => (pair.z_i(), pair.z_j()),
            };
            let pins = right_angle(pin_i, pin_j, "pins of the cross", statement, notes);
            if let (true, Some([pin_i, pin_j])) = (pair.together(statement, notes), pins) {
                let pins = [("pin_i", direction(pin_i)), ("pin_j", direction(pin_j))];
                write("universal", &[&[pair.i_to_j()], &pins[..]].concat());
            }
        }
        "SCREW" => {
            let lead = required(statement, "PITCH", notes);
            let held = pair.aligned(statement, notes).is_some();
            if let (true, true, Some(lead)) = (pair.in_line(statement, notes), held, lead) {
                let lead = ("lead", number(lead * dataset.scales.length));
                write("screw", &[pair.j_to_i(), axis, lead]);
            }
        }
        "RACKPIN" => {
            let radius = required(statement, "PD", notes).map(|diameter| 0.5 * diameter);
            if let Some(radius) = radius {
                let sense = rack_sense(&pair, radius, statement, notes);
                let radius = number(sense * radius * dataset.scales.length);
                let axis = ("axis", direction(pair.z_i()));
                let along = ("along", direction(pair.z_j()));
                write("rack-and-pinion", &[pair.j_to_i(), axis, along, ("pitch_radius", radius)]);
            }
        }
        "PLANAR" => {
            let held = pair.aligned(statement, notes).is_some();
            if pair.in_plane(statement, notes) && held {
                write("parallel-axes", &[pair.j_to_i(), axis]);
                let name = format!("{name}_plane");
                let kind = ("kind", "\"in-plane\"".to_owned());
                let normal = ("normal", direction(pair.z_j()));
                let lines = [kind, at, pair.j_to_i(), normal];
                output.section(List::Joints, statement, &name, &lines);
            }
        }
        "CONVEL" => {
            notes.missing(
                statement.line,
                statement.title(),
                "hardpoint has no constant-velocity joint yet",
            );
        }
        _ => {}
    }
}

/// Translates one JPRIM.
pub(super) fn primitive(
    dataset: &Dataset,
    statement: &Statement,
    output: &mut Output,
    notes: &mut Notes,
) {
    let Some(kind) = kind(statement, PRIMITIVES, notes) else { return };
    let Some(pair) = Pair::of(dataset, statement, notes) else { return };
    let name = output.name(List::Joints, statement, "jprim");
    let at = ("at", output.point(pair.i));
    let z = direction(pair.z_j());
    let lines = match kind {
        "ATPOINT" if pair.together(statement, notes) => ("spherical", vec![]),
        "INLINE" if pair.in_line(statement, notes) => ("in-line", vec![("axis", z)]),
        "INPLANE" if pair.in_plane(statement, notes) => ("in-plane", vec![("normal", z)]),
        "ORIENTATION" => ("orientation", vec![]),
        "PARALLEL_AXES" if pair.aligned(statement, notes).is_some() => {
            ("parallel-axes", vec![("axis", z)])
        }
        "PERPENDICULAR" => {
            let axes = right_angle(pair.z_j(), pair.z_i(), "z axes", statement, notes);
            let Some([axis_i, axis_j]) = axes else { return };
            let axes = vec![("axis_i", direction(axis_i)), ("axis_j", direction(axis_j))];
            ("perpendicular-axes", axes)
        }
        _ => return,
    };
    let first = [("kind", format!("\"{}\"", lines.0)), pair.j_to_i(), at];
    output.section(List::Joints, statement, &name, &[&first[..], &lines.1].concat());
}

/// The word that says which kind a statement is of.
fn kind(statement: &Statement, kinds: &[&'static str], notes: &mut Notes) -> Option<&'static str> {
    let found = statement.word(kinds);
    if found.is_none() {
        let what = format!("{} does not say what kind it is", statement.title());
        notes.mistake(statement.line, what, format!("hardpoint knows {}", kinds.join(", ")));
    }
    found
}

fn required(statement: &Statement, key: &str, notes: &mut Notes) -> Option<f64> {
    if !statement.has(key) {
        notes.mistake(
            statement.line,
            format!("{} lacks {key}", statement.title()),
            format!("write {key} = …"),
        );
    }
    let number = statement.number(key, notes);
    if number == Some(0.0) {
        notes.mistake(
            statement.line,
            format!("{key} of {} is zero", statement.title()),
            "write another number",
        );
    }
    number.filter(|number| *number != 0.0)
}

/// Two axes at right angles, the second turned by what rounding of the dataset has left.
fn right_angle(
    i: Vector<f64>,
    j: Vector<f64>,
    what: &str,
    statement: &Statement,
    notes: &mut Notes,
) -> Option<[Vector<f64>; 2]> {
    let cosine = dot(i, j);
    if cosine.abs() <= RIGHT {
        return Some([i, normal_to(j, i)]);
    }
    let angle = cosine.clamp(-1.0, 1.0).acos().to_degrees();
    let what = format!("the {what} of {} are at {angle:.4}° instead of 90°", statement.title());
    not_assembled(statement.line, what, notes);
    None
}

/// Whether the rack goes along its z axis (1) or against it (−1) as the pinion turns right-handed.
fn rack_sense(pair: &Pair, radius: f64, statement: &Statement, notes: &mut Notes) -> f64 {
    // From the axis of the pinion to the line on which the rack moves.
    let (axis, along) = (pair.z_i(), pair.z_j());
    let way = sub([0.0; 3], pair.way());
    let side = cross(axis, along);
    let beside = dot(way, side);
    if norm(side) > 0.5 && beside.abs() > 0.1 * radius.abs() {
        // The teeth of the pinion are at that side, where it goes along axis × way.
        return -beside.signum();
    }
    notes.assume(format!(
        "{}: the rack lies on the axis of the pinion, so nothing says on which side the teeth meet; the rack \
         goes along the z axis of its marker {} when the pinion turns right-handed about that of {}. Otherwise \
         change the sign of `pitch_radius`",
        statement.title(),
        pair.j.id,
        pair.i.id
    ));
    1.0
}
