//! The parts that an axle has once though its bodies are on both sides.

use super::Half;
use crate::mechanism::{BodyId, Mechanism, MechanismError, PointId};
use crate::model::Model;
use crate::model::architecture::{Across, point_across};

/// A point of the other side that a force names and that only one of two models has.
pub(super) fn missing_point([left, right]: [&Model; 2]) -> Option<String> {
    for (side, here, there) in [(left.side, left, right), (right.side, right, left)] {
        let forces = here.loads.axle_forces.iter();
        let points = forces.filter_map(|force| force.kind.points()).flatten();
        let others = points.filter_map(|point| match point_across(point, here.points.len()) {
            Across::This(_) => None,
            Across::Other(point) => Some(&here.points[point.0].name),
        });
        if let Some(name) = others.into_iter().find(|name| there.point(name).is_none()) {
            let name = name.clone();
            return Some(format!("only the {} one has the point `{name}`", side.name()));
        }
    }
    None
}

impl Half<'_> {
    /// Adds the joints and forces between this side and the other one.
    pub(super) fn add_parts_across(
        &self,
        other: &Self,
        mechanism: &mut Mechanism,
    ) -> Result<(), MechanismError> {
        let model = self.model;
        let body = |id: BodyId| match model.architecture.body_across(id) {
            Across::This(body) => self.body(body),
            Across::Other(body) => other.body(body),
        };
        let point = |id: PointId, count: usize| match point_across(id, count) {
            Across::This(point) => self.point(point),
            // The other side may have a file and points of its own.
            Across::Other(point) => {
                let name = &model.points[point.0].name;
                let found = other.model.points.iter().position(|point| point.name == *name);
                other.point(found.map_or(point, PointId))
            }
        };
        let required = model.architecture.points.len();
        for joint in &model.architecture.axle_joints {
            let kind = joint.kind.on_points(|id| point(id, required));
            mechanism.add_joint(&joint.name, body(joint.i), body(joint.j), kind)?;
        }
        for force in &model.loads.axle_forces {
            let kind = force.kind.clone().on_points(|id| point(id, model.points.len()));
            mechanism.add_force(&force.name, body(force.i), body(force.j), kind)?;
        }
        Ok(())
    }
}
