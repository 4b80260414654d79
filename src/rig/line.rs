//! Lines and wheels, and what becomes of them in a motion.

use crate::scalar::{Dual, Scalar};
use crate::solve::Twist;
use crate::vector::{Vector, add, constant, cross, dot, norm, scale, sub, unit};

/// A straight line through two points: a steer axis, a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<S> {
    /// The first point (m), the lower one of a steer axis.
    pub from: Vector<S>,
    /// The second point (m).
    pub to: Vector<S>,
}

impl<S> Line<S> {
    /// The line through two points, from the first to the second.
    pub fn through([from, to]: [Vector<S>; 2]) -> Self {
        Self { from, to }
    }
}

impl Line<f64> {
    /// The line on another scalar, at rest.
    pub fn lifted<S: Scalar>(&self) -> Line<S> {
        Line { from: constant(self.from), to: constant(self.to) }
    }
}

impl Wheel<f64> {
    /// The wheel on another scalar, at rest.
    pub fn lifted<S: Scalar>(&self) -> Wheel<S> {
        let Self { center, spin, radius } = *self;
        Wheel { center: constant(center), spin: constant(spin), radius: S::from_f64(radius) }
    }
}

impl<S: Scalar> Line<S> {
    /// The unit vector from the first to the second point.
    pub fn direction(&self) -> Vector<S> {
        unit(sub(self.to, self.from))
    }

    /// The distance of the two points (m).
    pub fn length(&self) -> S {
        norm(sub(self.to, self.from))
    }

    /// The line with the velocities of its points, which are those of `rates`.
    pub fn moving(&self, rates: &Self) -> Line<Dual<S>> {
        Line { from: moving(self.from, rates.from), to: moving(self.to, rates.to) }
    }
}

/// A wheel: a disc normal to its spin axis, in ISO 8855 axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel<S> {
    /// Wheel centre W (m).
    pub center: Vector<S>,
    /// Unit spin axis s, pointing outboard.
    pub spin: Vector<S>,
    /// Rolling radius R (m).
    pub radius: S,
}

impl<S: Scalar> Wheel<S> {
    /// The contact patch P (m): the lowest point of the disc,
    /// P = W + R d/|d|, d = −e_z + s (s·e_z).
    pub fn contact_patch(&self) -> Vector<S> {
        let vertical = [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(1.0)];
        let down = sub(scale(dot(self.spin, vertical), self.spin), vertical);
        add(self.center, scale(self.radius, unit(down)))
    }

    /// The wheel with the velocities that its body gives it. The contact patch of the result moves
    /// as the lowest point does, not as a point of the body.
    pub fn moving(&self, twist: &Twist<S>) -> Wheel<Dual<S>> {
        Wheel {
            center: moving(self.center, twist.at(self.center)),
            spin: moving(self.spin, cross(twist.rotation, self.spin)),
            radius: Dual::new(self.radius, S::from_f64(0.0)),
        }
    }
}

fn moving<S: Scalar>(position: Vector<S>, velocity: Vector<S>) -> Vector<Dual<S>> {
    std::array::from_fn(|k| Dual::new(position[k], velocity[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wheel that turns about a vertical axis through its centre: the lowest point runs along.
    #[test]
    fn lowest_point_moves_as_the_disc_does() {
        let camber = -0.1_f64;
        let wheel = Wheel {
            center: [0.2, 0.7, 0.1],
            spin: [0.0, camber.cos(), -camber.sin()],
            radius: 0.3,
        };
        let up = Twist { velocity: [0.0, 0.0, 1.0], rotation: [0.0; 3] };
        let patch = wheel.moving(&up).contact_patch();
        assert_eq!(patch.map(|c| c.derivative), [0.0, 0.0, 1.0]);
        let turn = Twist { velocity: cross([0.2, 0.7, 0.0], [0.0, 0.0, 1.0]), ..up };
        let turn = Twist { rotation: [0.0, 0.0, 1.0], ..turn };
        let patch = wheel.moving(&turn).contact_patch();
        // The patch stands 0.3 sin(camber) inboard of the centre and swings about it.
        let expected = -0.3 * camber.sin();
        assert!((patch[0].derivative + expected).abs() < 1e-15, "{patch:?}");
        assert!(patch[1].derivative.abs() < 1e-15 && patch[2].derivative.abs() < 1e-15);
    }
}
