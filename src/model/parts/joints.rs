//! Reads `[[joints]]`.

use toml::Spanned;

use super::{Parts, named_sections};
use crate::mechanism::{BodyId, Direction, Joint, JointKind, PointId};
use crate::model::diagnostics::Report;
use crate::model::quantity::Quantity;
use crate::model::read::Section;

/// The y axis, along which racks slide. Joints know lines, which have no sign, and the
/// axis systems differ in signs only, so `"y"` is the same line in all of them.
pub(crate) const Y: Direction = Direction::Fixed([0.0, 1.0, 0.0]);

/// The kinds of mechanisms; those that need lengths come last.
const KINDS_WITH_LENGTHS: &[&str] = &[
    "spherical",
    "revolute",
    "universal",
    "translational",
    "cylindrical",
    "fixed",
    "link",
    "in-plane",
    "in-line",
    "perpendicular",
    "perpendicular-axes",
    "parallel-axes",
    "orientation",
    "rack-and-pinion",
    "screw",
];

/// The kinds of architectures, which have no lengths of their own.
const KINDS: &[&str] = KINDS_WITH_LENGTHS.split_at(KINDS_WITH_LENGTHS.len() - 2).0;

impl Parts<'_> {
    /// The joints in the order of the file; `None` for a joint with a mistake.
    pub(crate) fn joints(
        &self,
        root: &mut Section,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Joint>)> {
        if !root.has("joints") {
            let span = root.span();
            report
                .mistake(&span, "`joints` is missing", "in this file")
                .help("write one `[[joints]]` section for each joint");
        }
        self.joints_of(root, "joints", report)
    }

    /// The joints of a list of sections, which may be absent.
    pub(crate) fn joints_of(
        &self,
        root: &mut Section,
        key: &'static str,
        report: &mut Report,
    ) -> Vec<(Spanned<String>, Option<Joint>)> {
        named_sections(root, key, "lca_pivot", report, |section, name, report| {
            self.joint(section, name, report)
        })
    }

    fn joint(&self, mut section: Section, name: &str, report: &mut Report) -> Option<Joint> {
        let bodies = self.between(&mut section, &format!("the joint `{name}`"), report);
        let kinds = if self.own_numbers { KINDS_WITH_LENGTHS } else { KINDS };
        let kind = section.word("kind", "joint kind", kinds, report);
        let Some(kind) = kind else {
            // Which other keys the joint has depends on its kind.
            section.finish_open(report);
            return None;
        };
        let kind = self.joint_kind(&mut section, kind, report);
        section.finish(report);
        let ((i, j), kind) = (bodies?, kind?);
        Some(Joint { name: name.to_owned(), i, j, kind })
    }

    /// Reads the points and directions of a joint; `word` is one of [`KINDS_WITH_LENGTHS`].
    fn joint_kind(
        &self,
        section: &mut Section,
        word: &str,
        report: &mut Report,
    ) -> Option<JointKind> {
        if word == "link" {
            let help = "name a point on each body: `on = [\"tierod_inner\", \"tierod_outer\"]`";
            let [on_i, on_j] = self.two_points(section, "on", help, report)?;
            return Some(JointKind::Link { on_i, on_j });
        }
        let at = self.point(section, "at", "name the point of the joint: `at = \"…\"`", report);
        match word {
            "spherical" => Some(JointKind::Spherical { at: at? }),
            "fixed" => Some(JointKind::Fixed { at: at? }),
            "orientation" => Some(JointKind::Orientation { at: at? }),
            "universal" if section.has("pin_i") || section.has("pin_j") => {
                let pin_i = self.direction(section, "pin_i", report);
                let pin_j = self.direction(section, "pin_j", report);
                Some(JointKind::Hooke { at: at?, pin_i: pin_i?, pin_j: pin_j? })
            }
            "universal" => {
                let shaft = self.direction(section, "shaft", report);
                Some(JointKind::Universal { at: at?, shaft: shaft? })
            }
            "perpendicular-axes" => {
                let axis_i = self.direction(section, "axis_i", report);
                let axis_j = self.direction(section, "axis_j", report);
                Some(JointKind::PerpendicularAxes { at: at?, axis_i: axis_i?, axis_j: axis_j? })
            }
            "rack-and-pinion" => {
                let axis = self.direction(section, "axis", report);
                let along = self.direction(section, "along", report);
                let help = "write the way of the rack along its direction for each radian of the pinion: `pitch_radius = 8.0`";
                let radius = self.number(section, "pitch_radius", Quantity::Length, help, report);
                let (axis, along) = (axis?, along?);
                let pitch_radius = radius?.into_inner();
                Some(JointKind::RackAndPinion { at: at?, axis, along, pitch_radius })
            }
            "screw" => {
                let axis = self.direction(section, "axis", report);
                let help = "write the way of the second body along the axis for each right-handed turn: `lead = 5.0`";
                let lead = self.number(section, "lead", Quantity::Length, help, report);
                Some(JointKind::Screw { at: at?, axis: axis?, lead: lead?.into_inner() })
            }
            "in-plane" => {
                let normal = self.direction(section, "normal", report);
                Some(JointKind::InPlane { at: at?, normal: normal? })
            }
            _ => {
                let axis = self.direction(section, "axis", report);
                let (at, axis) = (at?, axis?);
                Some(match word {
                    "revolute" => JointKind::Revolute { at, axis },
                    "translational" => JointKind::Translational { at, axis },
                    "cylindrical" => JointKind::Cylindrical { at, axis },
                    "perpendicular" => JointKind::Perpendicular { at, axis },
                    "parallel-axes" => JointKind::ParallelAxes { at, axis },
                    _ => JointKind::InLine { at, axis },
                })
            }
        }
    }
}

/// The points at which joints hold a body, each once. A line that the body
/// shares with its neighbour counts with both of its points.
pub(crate) fn joint_points(joints: &[Joint], body: BodyId) -> Vec<PointId> {
    let mut points = vec![];
    for joint in joints {
        if body != joint.i && body != joint.j {
            continue;
        }
        points.extend(match joint.kind {
            JointKind::Revolute { at, axis } | JointKind::Cylindrical { at, axis } => {
                let [from, to] = ends(axis, at);
                vec![at, from, to]
            }
            JointKind::Link { on_i, .. } if body == joint.i => vec![on_i],
            JointKind::Link { on_j, .. } => vec![on_j],
            // All others hold one point of both bodies.
            kind => vec![kind.points()[0]],
        });
    }
    points.sort_unstable();
    points.dedup();
    points
}

/// The points of a direction, or `at` twice for a constant direction.
fn ends(direction: Direction, at: PointId) -> [PointId; 2] {
    match direction {
        Direction::Between(from, to) => [from, to],
        Direction::Fixed(_) => [at, at],
    }
}
