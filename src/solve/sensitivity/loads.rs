//! Unit loads on points of bodies that move.

use super::{Change, Frame, Sensitivity};
use crate::mechanism::BodyId;
use crate::relation::{BODY_COORDINATES, Coordinates};
use crate::scalar::{Dual, Scalar as _};
use crate::solve::compliance::{coordinates_of, unit_load};
use crate::vector::{Vector, add, rotate, sub};

impl Sensitivity {
    /// The body of a loaded point, and the place of the point on it.
    pub(super) fn loaded_point(&self, point: usize) -> (BodyId, Vector<f64>) {
        let (body, point) = self.question.points[point];
        (body, sub(self.positions[point.index()], self.origins[body.index()]))
    }

    /// Adds what a unit load changes by when its body and its point move.
    pub(super) fn add_load_gradient(
        &self,
        frame: &Frame<'_>,
        y: &[f64],
        (point, component): (usize, usize),
        state: &mut [f64],
        total: &mut Change,
    ) {
        let (body, at) = self.loaded_point(point);
        let (_, index) = self.question.points[point];
        let first = coordinates_of(body);
        let work = |q: &Coordinates<Dual>, at: Vector<Dual>| -> f64 {
            let force = moved_load(q, at, component);
            force.iter().zip(&y[first..]).map(|(force, y)| force.derivative * y).sum()
        };
        let still = frame.state[body.index()].map(Dual::from_f64);
        for k in 0..BODY_COORDINATES {
            let mut q = still;
            q[k].derivative = 1.0;
            state[first + k] += work(&q, at.map(Dual::from_f64));
        }
        for k in 0..3 {
            let mut at = at.map(Dual::from_f64);
            at[k].derivative = 1.0;
            total.points[index.index()][k] += work(&still, at);
        }
    }
}

/// A unit load at a place of a body that moves.
pub(super) fn moved_load(
    q: &Coordinates<Dual>,
    at: Vector<Dual>,
    component: usize,
) -> Coordinates<Dual> {
    let place = add([q[0], q[1], q[2]], rotate([q[3], q[4], q[5], q[6]], at));
    unit_load(q, place, component)
}
