//! Checks that an architecture hangs together: everything is connected and everything is used.

use std::ops::Range;

use super::{Across, Architecture, point_across};
use crate::mechanism::{BodyId, Direction, Joint, PointId};
use crate::model::diagnostics::Report;

/// Where the text names points, bodies and the steer axis.
pub(super) struct Places<'a> {
    pub(super) points: &'a [Range<usize>],
    pub(super) bodies: &'a [Range<usize>],
    pub(super) axle_joints: &'a [Range<usize>],
    pub(super) steer_axis: Range<usize>,
}

pub(super) fn check(architecture: &Architecture, places: &Places, report: &mut Report) {
    bodies_hang_on_the_ground(architecture, places.bodies, report);
    points_are_used(architecture, places.points, report);
    steer_axis_is_held(architecture, &places.steer_axis, report);
    rack_is_shared(architecture, places.bodies, report);
    sides_touch(architecture, places, report);
}

/// Parts that both sides have in common make an axle of them, and so do joints that are there once.
fn sides_touch(architecture: &Architecture, places: &Places, report: &mut Report) {
    let wheel = architecture.wheel.body;
    let help = "write `axle = true`, and there is no corner to look at alone";
    if !architecture.is_axle && architecture.is_shared(wheel) {
        let message = format!(
            "both wheels are on the body `{}`, so the two sides are one mechanism",
            architecture.body_name(wheel)
        );
        report.mistake(&places.bodies[wheel.0 - 1], message, "carries both wheels").help(help);
    }
    for (joint, span) in architecture.axle_joints.iter().zip(places.axle_joints) {
        if !architecture.is_axle {
            let message =
                format!("the joint `{}` makes one mechanism of the two sides", joint.name);
            report.mistake(span, message, "between the sides").help(help);
        }
        if let Some((why, help)) = architecture.not_across(joint.i, joint.j) {
            report.mistake(span, format!("the joint `{}` {why}", joint.name), "here").help(help);
        }
    }
}

impl Architecture {
    /// Why a part between two bodies is not one that an axle has once though its bodies are on both sides, and
    /// what to do.
    pub(crate) fn not_across(&self, i: BodyId, j: BodyId) -> Option<(String, &'static str)> {
        let sides = [i, j].map(|body| self.body_across(body));
        for side in sides {
            if let Across::Other(body) = side
                && self.is_shared(body)
            {
                let name = self.body_name(body);
                let why = format!("names `other.{name}`, but both sides have `{name}` together");
                return Some((why, "leave out `other.`"));
            }
        }
        let shared = sides.iter().all(|side| match side {
            Across::This(body) => self.is_shared(*body),
            Across::Other(_) => false,
        });
        let why = || "is between bodies that both sides have together".to_owned();
        shared.then(|| {
            (
                why(),
                "write it among [[joints]] or [[forces]], where such a part is there once anyway",
            )
        })
    }

    /// The joints between the sides with the numbers of one side.
    fn axle_joints_folded(&self) -> impl Iterator<Item = Joint> {
        let fold = |point| match point_across(point, self.points.len()) {
            Across::This(point) | Across::Other(point) => point,
        };
        self.axle_joints.iter().map(move |joint| {
            let [i, j] = [joint.i, joint.j].map(|body| match self.body_across(body) {
                Across::This(body) | Across::Other(body) => body,
            });
            Joint { name: joint.name.clone(), i, j, kind: joint.kind.on_points(fold) }
        })
    }
}

/// Every body must be joined to the ground, directly or through other bodies.
fn bodies_hang_on_the_ground(
    architecture: &Architecture,
    spans: &[Range<usize>],
    report: &mut Report,
) {
    let mut reached = vec![false; architecture.bodies.len() + 1];
    reached[BodyId::GROUND.0] = true;
    // Each pass reaches at least one body more, or none is left to reach.
    for _ in 0..reached.len() {
        for joint in architecture.joints.iter().cloned().chain(architecture.axle_joints_folded()) {
            let either = reached[joint.i.0] || reached[joint.j.0];
            reached[joint.i.0] = either;
            reached[joint.j.0] = either;
        }
    }
    for (index, (body, span)) in architecture.bodies.iter().zip(spans).enumerate() {
        let id = BodyId(index + 1);
        if reached[id.0] {
            continue;
        }
        let joined = architecture.joints.iter().any(|joint| joint.i == id || joint.j == id);
        let ground = &architecture.ground;
        let message = if joined {
            format!("no chain of joints connects the body `{}` to `{ground}`", body.name)
        } else {
            format!("no joint holds the body `{}`", body.name)
        };
        report
            .mistake(span, message, "would float away")
            .help("add the joint that is missing, or remove the body");
    }
}

/// One rack steers both wheels.
fn rack_is_shared(architecture: &Architecture, spans: &[Range<usize>], report: &mut Report) {
    let Some(rack) = architecture.rack.map(|joint| architecture.joints[joint].j) else {
        return;
    };
    if architecture.is_shared(rack) {
        return;
    }
    let name = architecture.body_name(rack);
    let message = format!("steering moves the body `{name}`, but each side would have its own");
    report
        .mistake(&spans[rack.0 - 1], message, "the rack")
        .help(format!("write `{name} = {{ meaning = \"…\", shared = true }}`"));
}

fn points_are_used(architecture: &Architecture, spans: &[Range<usize>], report: &mut Report) {
    let mut used = vec![false; architecture.points.len()];
    used[architecture.wheel.center.0] = true;
    let mut mark = |point: PointId| used[point.0] = true;
    if let Some(axis) = architecture.steer_axis {
        mark(axis.lower.0);
        mark(axis.upper.0);
    }
    for joint in architecture.joints.iter().cloned().chain(architecture.axle_joints_folded()) {
        joint.kind.points().into_iter().for_each(&mut mark);
        for direction in joint.kind.directions() {
            if let Direction::Between(from, to) = direction {
                mark(from);
                mark(to);
            }
        }
    }
    for ((point, span), used) in architecture.points.iter().zip(spans).zip(used) {
        if !used {
            let message = format!("nothing uses the point `{}`", point.name);
            report
                .mistake(span, message, "unused")
                .help("move it to [optional_points], or use it in a joint");
        }
    }
}

/// The steer axis goes through joints, so that its points are known in every position.
fn steer_axis_is_held(architecture: &Architecture, span: &Range<usize>, report: &mut Report) {
    let Some(axis) = architecture.steer_axis else {
        return;
    };
    for (point, body) in [axis.lower, axis.upper] {
        if !architecture.joint_points(body).contains(&point) {
            let message = format!(
                "the steer axis takes `{}` on the body `{}`, but no joint holds that body there",
                architecture.point_name(point),
                architecture.body_name(body)
            );
            report
                .mistake(span, message, "this axis")
                .help("name a body that has a joint at this point");
        }
    }
}
