//! Where points are and how they move.

use super::Dynamics;
use super::start::center;
use crate::mechanism::{BodyId, PointId};
use crate::relation::Coordinates;
use crate::solve::motion::{self, Twist, point_position};
use crate::vector::{add, cross, norm, sub};

impl Dynamics {
    /// Where a point of a body is (m). The point moves with the body, whichever joint it belongs to.
    ///
    /// # Panics
    /// If body or point belong to another mechanism, here and below.
    pub fn point_position(&self, body: BodyId, point: PointId) -> [f64; 3] {
        point_position(&self.mechanism, &self.now.state, body, point)
    }

    /// Velocity of a point of a body (m/s), in ground axes.
    pub fn point_velocity(&self, body: BodyId, point: PointId) -> [f64; 3] {
        let v = &self.now.velocity[body.index()];
        let arm = self.arm(body, point);
        add([v[0], v[1], v[2]], cross(self.angular_velocity(body), arm))
    }

    /// Acceleration of a point of a body (m/s²), in ground axes.
    pub fn point_acceleration(&self, body: BodyId, point: PointId) -> [f64; 3] {
        let a = &self.now.acceleration[body.index()];
        let (omega, arm) = (self.angular_velocity(body), self.arm(body, point));
        let tangential = cross(self.angular_acceleration(body), arm);
        let centripetal = cross(omega, cross(omega, arm));
        add([a[0], a[1], a[2]], add(tangential, centripetal))
    }

    /// Angular velocity of a body (rad/s), in ground axes.
    pub fn angular_velocity(&self, body: BodyId) -> [f64; 3] {
        self.rotation_of(body, &self.now.velocity)
    }

    /// Angular acceleration of a body (rad/s²), in ground axes: 2 E p̈, because Ė ṗ is zero.
    pub fn angular_acceleration(&self, body: BodyId) -> [f64; 3] {
        self.rotation_of(body, &self.now.acceleration)
    }

    /// The rotation matrix of a body, row by row: it turns directions from the design position to
    /// the present one.
    pub fn rotation(&self, body: BodyId) -> [[f64; 3]; 3] {
        motion::rotation(&self.now.state, body)
    }

    /// The largest speed of all bodies (m/s), at their centres of mass and, times the size of the
    /// mechanism, of their rotation.
    pub fn largest_speed(&self) -> f64 {
        self.largest(&self.now.velocity)
    }

    /// As [`Self::largest_speed`] of accelerations (m/s²).
    pub fn largest_acceleration(&self) -> f64 {
        self.largest(&self.now.acceleration)
    }

    fn largest(&self, rates: &[Coordinates<f64>]) -> f64 {
        let bodies = self.mechanism.bodies().iter().zip(&self.now.state).zip(rates).skip(1);
        bodies.fold(0.0, |largest: f64, ((body, q), rate)| {
            let twist = Twist::new(q, rate);
            let velocity = norm(twist.at(center(q, body)));
            largest.max(velocity).max(norm(twist.rotation) * self.scales.length)
        })
    }

    fn rotation_of(&self, body: BodyId, rates: &[Coordinates<f64>]) -> [f64; 3] {
        Twist::new(&self.now.state[body.index()], &rates[body.index()]).rotation
    }

    fn arm(&self, body: BodyId, point: PointId) -> [f64; 3] {
        let q = &self.now.state[body.index()];
        sub(self.point_position(body, point), [q[0], q[1], q[2]])
    }
}
