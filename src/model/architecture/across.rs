//! What joins the two sides of an axle: `other.` names bodies and points of the other side.

use super::Architecture;
use crate::mechanism::{BodyId, PointId};

/// A body or a point of one of the two sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Across<T> {
    /// Of the side that the file describes.
    This(T),
    /// Of the other side.
    Other(T),
}

impl Architecture {
    /// The body of a number in parts between the sides: those of the other side come after all of this one.
    pub(crate) fn body_across(&self, body: BodyId) -> Across<BodyId> {
        match body.0.checked_sub(self.bodies.len() + 1) {
            None => Across::This(body),
            Some(index) => Across::Other(BodyId(index + 1)),
        }
    }
}

/// The point of a number in parts between the sides, of which each has `count` points.
pub(crate) fn point_across(point: PointId, count: usize) -> Across<PointId> {
    match point.0.checked_sub(count) {
        None => Across::This(point),
        Some(index) => Across::Other(PointId(index)),
    }
}
