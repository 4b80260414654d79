//! Screw axes and where lines meet the ground.

use super::{FARTHEST, NEARLY_PARALLEL, quotient};
use crate::rig::Line;
use crate::scalar::Real;
use crate::solve::Twist;
use crate::vector::{Vector, add, cross, dot, norm, scale};

/// A line in space that points up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis<S> {
    point: Vector<S>,
    pub direction: Vector<S>,
}

impl<S: Real> Axis<S> {
    fn new(point: Vector<S>, direction: Vector<S>) -> Self {
        let up = if direction[2].value() < 0.0 { -1.0 } else { 1.0 };
        Self { point, direction: scale(S::from_f64(up), direction) }
    }

    /// The axis through the points of a line, in its direction.
    pub fn of(line: &Line<S>) -> Self {
        Self { point: line.from, direction: line.direction() }
    }

    /// The point of the axis at a height; `None` where the axis is horizontal.
    pub fn at_height(&self, z: S) -> Option<Vector<S>> {
        let [x, y, k_z] = self.direction;
        let slope = [quotient(x, k_z, NEARLY_PARALLEL)?, quotient(y, k_z, NEARLY_PARALLEL)?];
        let way = z - self.point[2];
        Some([self.point[0] + slope[0] * way, self.point[1] + slope[1] * way, z])
    }
}

/// What a motion is at one moment: a turn about an axis and a way along it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Screw<S> {
    /// Unit vector along the angular velocity.
    pub direction: Vector<S>,
    /// The point of the axis that is nearest to a given point.
    pub point: Vector<S>,
    /// Way along the axis by angle (m/rad).
    pub pitch: S,
}

impl<S: Real> Screw<S> {
    /// The screw axis of a motion, near a point; `None` where the body hardly turns.
    pub fn of(twist: &Twist<S>, near: Vector<S>) -> Option<Self> {
        let (omega, v) = (twist.rotation, twist.at(near));
        if norm(v.map(Real::value)) >= FARTHEST * norm(omega.map(Real::value)) {
            return None;
        }
        let square = dot(omega, omega);
        Some(Self {
            direction: scale(S::from_f64(1.0) / square.sqrt(), omega),
            point: add(near, scale(S::from_f64(1.0) / square, cross(omega, v))),
            pitch: dot(omega, v) / square,
        })
    }

    /// The axis itself.
    pub fn axis(&self) -> Axis<S> {
        Axis::new(self.point, self.direction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn screw_is_found_from_its_motion() {
        // A turn of 2 rad/s about the upright line through (1, 2), 0.5 m/rad along it.
        let rotation = [0.0, 0.0, 2.0];
        let velocity = add(cross([1.0, 2.0, 0.0], rotation), [0.0, 0.0, 1.0]);
        let twist = Twist { velocity, rotation };
        let screw = Screw::of(&twist, [5.0, 2.0, 7.0]).expect("the body turns");
        assert_eq!(screw.point, [1.0, 2.0, 7.0]);
        assert_eq!((screw.direction, screw.pitch), ([0.0, 0.0, 1.0], 0.5));
        assert_eq!(screw.axis().at_height(0.0), Some([1.0, 2.0, 0.0]));
    }

    #[test]
    fn no_turn_has_no_axis_and_a_horizontal_axis_no_ground() {
        let slide = Twist { velocity: [0.0, 0.0, 1.0], rotation: [1e-17, 0.0, 0.0] };
        assert!(Screw::of(&slide, [0.0, 1.0, 0.0]).is_none());
        assert!(Screw::of(&Twist::<f64>::default(), [0.0; 3]).is_none());
        let roll = Twist { velocity: [0.0; 3], rotation: [1.0, 0.0, 1e-4] };
        let screw = Screw::of(&roll, [0.0, 1.0, 0.0]).expect("the body turns");
        assert!(screw.axis().at_height(-0.3).is_none());
    }
}
