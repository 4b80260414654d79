//! Joints without an axis and bodies that turn freely.

use super::{Geometry, NEAR};
use crate::mechanism::{BodyId, Direction, JointKind, PointId};
use crate::model::diagnostics::Report;
use crate::model::suggest;
use crate::vector::{cross, norm, sub};

impl Geometry<'_> {
    /// Axes between two points need two different points.
    pub(super) fn check_directions(&self, report: &mut Report) {
        for joint in &self.model.architecture.joints {
            let what = match joint.kind {
                JointKind::InPlane { .. } => "has no plane",
                JointKind::Universal { .. } => "has a shaft of zero length",
                JointKind::Link { .. } => "has zero length",
                _ => "has no axis",
            };
            let length = match joint.kind {
                JointKind::Link { on_i, on_j } => Some(Direction::Between(on_i, on_j)),
                _ => None,
            };
            for direction in joint.kind.directions().chain(length) {
                let Direction::Between(a, b) = direction else { continue };
                if self.coincide(a, b) {
                    let message = format!(
                        "`{}` and `{}` are the same point, so the joint `{}` {what}",
                        self.name(a),
                        self.name(b),
                        joint.name
                    );
                    report
                        .mistake(self.span(b), message, "the same point")
                        .also(self.span(a), "as this")
                        .help("correct one of the two points");
                }
            }
        }
    }

    /// A body held only along one line turns freely about it.
    pub(super) fn check_bodies(&self, report: &mut Report) {
        let architecture = &self.model.architecture;
        for index in 1..=architecture.bodies.len() {
            let body = BodyId(index);
            if architecture.is_shared(body) {
                continue; // Its joints on the other side are not among these.
            }
            let points = architecture.joint_points(body);
            let Some(line) = self.only_line(body, &points) else {
                continue;
            };
            let off_line = |point: &PointId| self.distance_from_line(*point, line) > NEAR;
            if self.coincide(line.0, line.1) || points.iter().any(off_line) {
                continue;
            }
            let names: Vec<&str> = points.iter().map(|point| self.name(*point)).collect();
            let message = format!(
                "all joints of the body `{}` lie on one line: {}",
                architecture.body_name(body),
                suggest::listed(&names)
            );
            let last = points.len() - 1;
            let mistake = report.mistake(self.span(points[last]), message, "on the line");
            for point in &points[..last] {
                mistake.also(self.span(*point), "on the line");
            }
            mistake.help("the body would turn freely about that line; correct the point that should lie beside it");
        }
    }

    /// The line that must not hold all joints of a body: the axis of an arm whose other
    /// joints are ball joints, or any line where all joints are ball joints. A tie rod,
    /// which has two of them only, and bodies with other joints have no such line.
    fn only_line(&self, body: BodyId, points: &[PointId]) -> Option<(PointId, PointId)> {
        let architecture = &self.model.architecture;
        let joints = architecture.joints.iter();
        let (mut hinges, mut balls) = (vec![], 0);
        for joint in joints.filter(|joint| joint.i == body || joint.j == body) {
            match joint.kind {
                JointKind::Revolute { axis: Direction::Between(a, b), .. } => hinges.push((a, b)),
                JointKind::Spherical { .. } | JointKind::Link { .. } => balls += 1,
                _ => return None,
            }
        }
        match hinges[..] {
            [axis] if balls > 0 => Some(axis),
            [] if points.len() > 2 => Some(self.farthest_pair(points)),
            _ => None,
        }
    }

    fn farthest_pair(&self, points: &[PointId]) -> (PointId, PointId) {
        let distance = |point: &PointId| norm(sub(self.position(*point), self.position(points[0])));
        let far = points.iter().copied().max_by(|a, b| distance(a).total_cmp(&distance(b)));
        (points[0], far.unwrap_or(points[0]))
    }

    fn distance_from_line(&self, point: PointId, line: (PointId, PointId)) -> f64 {
        let along = sub(self.position(line.1), self.position(line.0));
        let to = sub(self.position(point), self.position(line.0));
        norm(cross(along, to)) / norm(along)
    }
}
