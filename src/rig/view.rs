//! A state of a stand on any scalar.

use crate::mechanism::{Body, BodyId, Direction, DriverId, PointId};
use crate::relation::Coordinates;
use crate::scalar::Scalar;
use crate::solve::equilibrium::Equilibrium;
use crate::vector::{Vector, add, dot, rotate, sub, unit};

/// Where the bodies are, and what that depends on.
#[derive(Clone, Copy)]
pub(super) struct View<'a, S> {
    /// The bodies, the ground first.
    pub bodies: &'a [Body],
    /// Design positions of all points (m).
    pub points: &'a [Vector<S>],
    /// Coordinates of all bodies.
    pub state: &'a [Coordinates<S>],
    /// Parameters with the values of drivers.
    pub h: &'a [S],
    /// Values (m or rad) of all drivers.
    pub drivers: &'a [S],
}

impl<'a> View<'a, f64> {
    /// The state of an equilibrium.
    pub fn of(equilibrium: &'a Equilibrium, points: &'a [Vector<f64>]) -> Self {
        Self {
            bodies: equilibrium.mechanism().bodies(),
            points,
            state: equilibrium.state(),
            h: equilibrium.parameters(),
            drivers: equilibrium.driver_values(),
        }
    }
}

impl<S: Scalar> View<'_, S> {
    /// Where a point of a body is (m).
    pub fn point(&self, (point, body): (PointId, BodyId)) -> Vector<S> {
        let origin = self.bodies[body.index()].origin.map(S::from_f64);
        self.place(body, sub(self.points[point.index()], origin))
    }

    /// Where a place in body axes is (m).
    pub fn place(&self, body: BodyId, local: Vector<S>) -> Vector<S> {
        let q = &self.state[body.index()];
        add([q[0], q[1], q[2]], rotate([q[3], q[4], q[5], q[6]], local))
    }

    /// The rotation of a body from its design position, row by row.
    pub fn rotation(&self, body: BodyId) -> [Vector<S>; 3] {
        let q = &self.state[body.index()];
        let p = [q[3], q[4], q[5], q[6]];
        let one = |k| std::array::from_fn(|i| S::from_f64(if i == k { 1.0 } else { 0.0 }));
        let columns = [one(0), one(1), one(2)].map(|axis| rotate(p, axis));
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]))
    }

    /// A direction of a body in the axes of the ground.
    pub fn turned(&self, body: BodyId, direction: Vector<S>) -> Vector<S> {
        self.rotation(body).map(|row| dot(row, direction))
    }

    /// The unit vector of a direction at the design position.
    pub fn direction(&self, direction: Direction) -> Vector<S> {
        match direction {
            Direction::Between(from, to) => {
                unit(sub(self.points[to.index()], self.points[from.index()]))
            }
            Direction::Fixed(vector) => unit(vector).map(S::from_f64),
        }
    }

    /// The value of a driver.
    pub fn driver(&self, driver: DriverId) -> S {
        self.drivers[driver.index()]
    }

    /// Three parameters from the given one on.
    pub fn three(&self, first: usize) -> Vector<S> {
        [self.h[first], self.h[first + 1], self.h[first + 2]]
    }
}
