//! A state with its derivatives.

use crate::mechanism::{Body, BodyId, PointId};
use crate::relation::Coordinates;
use crate::rig::Pose;
use crate::scalar::Dual;
use crate::solve::sensitivity::Response;
use crate::vector::{Vector, add, constant, rotate, sub};

/// A state with its derivatives along a change.
#[derive(Clone, Debug)]
pub struct Moved {
    /// One of a corner, left and right of an axle.
    pub poses: Vec<Pose<Dual>>,
    state: Vec<Coordinates<Dual>>,
    points: Vec<Vector<Dual>>,
    origins: Vec<[f64; 3]>,
}

impl Moved {
    pub(super) fn new(poses: Vec<Pose<Dual>>, response: Response, bodies: &[Body]) -> Self {
        let Response { state, points, .. } = response;
        Self { poses, state, points, origins: bodies.iter().map(|body| body.origin).collect() }
    }

    /// Where a point of a body is (m).
    ///
    /// # Panics
    /// If body or point belong to another mechanism.
    pub fn point(&self, (point, body): (PointId, BodyId)) -> Vector<Dual> {
        let q = &self.state[body.index()];
        let local = sub(self.points[point.index()], constant(self.origins[body.index()]));
        add([q[0], q[1], q[2]], self.turned(body, local))
    }

    /// A direction of a body in the axes of the ground.
    ///
    /// # Panics
    /// If the body belongs to another mechanism.
    pub fn turned(&self, body: BodyId, direction: Vector<Dual>) -> Vector<Dual> {
        let q = &self.state[body.index()];
        rotate([q[3], q[4], q[5], q[6]], direction)
    }

    /// The design position (m) of a point.
    ///
    /// # Panics
    /// If the point belongs to another mechanism.
    pub fn design(&self, point: PointId) -> Vector<Dual> {
        self.points[point.index()]
    }
}
