//! Reads the `[[joints]]` of an architecture file.

use toml::Spanned;

use super::read::Names;
use crate::mechanism::{BodyId, Direction, Joint, JointKind, PointId};
use crate::model::diagnostics::Report;
use crate::model::read::{Section, as_section};
use crate::model::suggest;

/// The y axis, along which racks slide.
pub(super) const Y: Direction = Direction::Fixed([0.0, 1.0, 0.0]);

/// The directions that have a name. Joints know lines, which have no sign, and
/// the axis systems differ in signs only, so `"y"` is the same line in all of them.
const AXES: &[(&str, Direction)] =
    &[("x", Direction::Fixed([1.0, 0.0, 0.0])), ("y", Y), ("z", Direction::Fixed([0.0, 0.0, 1.0]))];

const KINDS: &[&str] = &[
    "spherical",
    "revolute",
    "universal",
    "translational",
    "cylindrical",
    "fixed",
    "link",
    "in-plane",
    "in-line",
];

/// The joints in the order of the file; `None` for a joint with a mistake.
pub(super) fn read(
    root: &mut Section,
    names: &Names,
    report: &mut Report,
) -> Vec<(Spanned<String>, Option<Joint>)> {
    let mut joints: Vec<(Spanned<String>, Option<Joint>)> = vec![];
    let Some(value) = root.value("joints") else {
        let span = root.span();
        report
            .mistake(&span, "`joints` is missing", "in this file")
            .help("write one `[[joints]]` section for each joint");
        return joints;
    };
    let Some(list) = value.get_ref().as_array() else {
        report
            .mistake(&value.span(), "`joints` must be a list of sections", "a single section")
            .help("write `[[joints]]` in double brackets, one for each joint");
        return joints;
    };
    for value in list.iter() {
        let help = "write one `[[joints]]` section for each joint";
        let Some(mut section) = as_section(value, "[[joints]]".to_owned(), help, report) else {
            continue;
        };
        let help = "give the joint a name for messages: `name = \"lca_pivot\"`";
        let Some(name) = section.required::<String>("name", help, report) else {
            section.finish_open(report);
            continue;
        };
        if let Some((first, _)) = joints.iter().find(|(n, _)| n.get_ref() == name.get_ref()) {
            let message = format!("there are two joints named `{}`", name.get_ref());
            report
                .mistake(&name.span(), message, "taken")
                .also(&first.span(), "by this joint")
                .help("give one of them another name");
        }
        let joint = joint(section, name.get_ref(), names, report);
        joints.push((name, joint));
    }
    joints
}

fn joint(mut section: Section, name: &str, names: &Names, report: &mut Report) -> Option<Joint> {
    let help = "name the two bodies: `between = [\"chassis\", \"lca\"]`";
    let between = section.required::<[Spanned<String>; 2]>("between", help, report);
    let bodies = between.and_then(|between| bodies(&between, name, names, report));
    let help = format!("write `kind = …` with one of {}", suggest::listed(KINDS));
    let kind = section.required::<String>("kind", &help, report);
    let kind = match kind.filter(|kind| is_kind(kind, report)) {
        Some(kind) => joint_kind(&mut section, kind.get_ref(), names, report),
        None => {
            // Which other keys the joint has depends on its kind.
            section.finish_open(report);
            return None;
        }
    };
    section.finish(report);
    let ((i, j), kind) = (bodies?, kind?);
    Some(Joint { name: name.to_owned(), i, j, kind })
}

fn bodies(
    between: &Spanned<[Spanned<String>; 2]>,
    joint: &str,
    names: &Names,
    report: &mut Report,
) -> Option<(BodyId, BodyId)> {
    let [i, j] = between.get_ref().each_ref().map(|name| names.body(name, report));
    let (i, j) = (i?, j?);
    if i == j {
        let message = format!("the joint `{joint}` joins a body to itself");
        report
            .mistake(&between.span(), message, "the same body twice")
            .help("name two different bodies");
    }
    Some((i, j))
}

fn is_kind(kind: &Spanned<String>, report: &mut Report) -> bool {
    let word = kind.get_ref().as_str();
    if KINDS.contains(&word) {
        return true;
    }
    let help = suggest::choices(word, KINDS);
    let message = format!("there is no joint kind `{word}`");
    report.mistake(&kind.span(), message, "unknown kind").help(help);
    false
}

/// Reads the points and directions of a joint; `word` is one of [`KINDS`].
fn joint_kind(
    section: &mut Section,
    word: &str,
    names: &Names,
    report: &mut Report,
) -> Option<JointKind> {
    if word == "link" {
        let help = "name a point on each body: `on = [\"tierod_inner\", \"tierod_outer\"]`";
        let [on_i, on_j] = two_points(section, "on", help, names, report)?;
        return Some(JointKind::Link { on_i, on_j });
    }
    let at = section.required("at", "name the point of the joint: `at = \"…\"`", report);
    let at = at.and_then(|at| names.point(&at, report));
    match word {
        "spherical" => Some(JointKind::Spherical { at: at? }),
        "fixed" => Some(JointKind::Fixed { at: at? }),
        "universal" => {
            let shaft = direction(section, "shaft", names, report);
            Some(JointKind::Universal { at: at?, shaft: shaft? })
        }
        "in-plane" => {
            let normal = direction(section, "normal", names, report);
            Some(JointKind::InPlane { at: at?, normal: normal? })
        }
        _ => {
            let axis = direction(section, "axis", names, report);
            let (at, axis) = (at?, axis?);
            Some(match word {
                "revolute" => JointKind::Revolute { at, axis },
                "translational" => JointKind::Translational { at, axis },
                "cylindrical" => JointKind::Cylindrical { at, axis },
                _ => JointKind::InLine { at, axis },
            })
        }
    }
}

/// A direction: two points, or the name of an axis.
fn direction(
    section: &mut Section,
    key: &'static str,
    names: &Names,
    report: &mut Report,
) -> Option<Direction> {
    let help = format!(
        "write two points, `{key} = [\"lca_front\", \"lca_rear\"]`, or an axis, `{key} = \"y\"`"
    );
    let is_name = section.value(key).is_some_and(|value| value.get_ref().is_str());
    if is_name {
        let axis = section.choice(key, "axis", AXES, ", or two points", report)?;
        return Some(axis.into_inner());
    }
    let [from, to] = two_points(section, key, &help, names, report)?;
    Some(Direction::Between(from, to))
}

fn two_points(
    section: &mut Section,
    key: &'static str,
    help: &str,
    names: &Names,
    report: &mut Report,
) -> Option<[PointId; 2]> {
    let pair = section.required::<[Spanned<String>; 2]>(key, help, report)?;
    let [from, to] = pair.get_ref().each_ref().map(|name| names.point(name, report));
    let points = [from?, to?];
    if points[0] == points[1] {
        let message = format!("`{key}` has one point twice");
        report.mistake(&pair.span(), message, "the same point").help(help);
    }
    Some(points)
}
