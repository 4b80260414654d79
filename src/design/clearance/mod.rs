//! How far parts are from each other and from where they must not be.
//!
//! All values are generic over the scalar, so that [`Dual`](crate::scalar::Dual) gives their exact derivatives.
//! Lengths are in any one unit. Where a value has a kink, such as the distance of two segments that are
//! parallel or touch, the derivative is that of one of the smooth pieces that meet there; it is always finite.

mod cylinder;
mod segment;

pub use cylinder::{Cylinder, Keeps};
pub use segment::{Segment, between_segments, segment_to_point};

use crate::scalar::Real;
use crate::vector::{Vector, cross, dot, norm};

/// The Euclidean length; at zero, where it has no derivative, one of zero.
fn length<S: Real>(a: Vector<S>) -> S {
    if a.map(Real::value) == [0.0; 3] { S::from_f64(0.0) } else { norm(a) }
}

/// How far a point is inside of a box with faces along the axes: x − least x, greatest x − x, then y and z.
/// All six are positive inside; an open side is an infinite limit.
pub fn inside_box<S: Real>(point: Vector<S>, limits: [[f64; 2]; 3]) -> [S; 6] {
    std::array::from_fn(|face| {
        let [least, greatest] = limits[face / 2].map(S::from_f64);
        let at = point[face / 2];
        if face % 2 == 0 { at - least } else { greatest - at }
    })
}

/// The cosine of the angle between two directions of any length but zero.
///
/// It is smooth everywhere, also where the angle is zero, so `cosine(a, b) − cos(limit) ≥ 0` is how a limit of
/// an angle is stated.
pub fn cosine<S: Real>(a: Vector<S>, b: Vector<S>) -> S {
    dot(a, b) / (norm(a) * norm(b))
}

/// The angle (rad, 0 to π) between two directions of any length but zero. At 0 and π, where it has a kink,
/// its derivative is zero.
pub fn angle<S: Real>(a: Vector<S>, b: Vector<S>) -> S {
    length(cross(a, b)).atan2(dot(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Dual;

    #[test]
    fn a_box_has_six_faces() {
        let limits = [[0.0, 2.0], [f64::NEG_INFINITY, 5.0], [-1.0, f64::INFINITY]];
        let inside = inside_box([0.5, 4.0, -2.0], limits);
        assert_eq!(inside, [0.5, 1.5, f64::INFINITY, 1.0, -1.0, f64::INFINITY]);
        let moved = inside_box([0.5, 4.0, -2.0].map(|x| Dual::new(x, 1.0)), limits);
        assert_eq!(moved.map(|face| face.derivative), [1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
    }

    #[test]
    fn angles_are_those_between_directions() {
        let quarter = angle([2.0, 0.0, 0.0], [0.0, 0.0, 3.0]);
        assert!((quarter - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert!((cosine([1.0, 1.0, 0.0], [5.0, 0.0, 0.0]) - 0.5_f64.sqrt()).abs() < 1e-15);
        assert!((angle([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]) - std::f64::consts::PI).abs() < 1e-15);
        // A direction that turns with one radian per second.
        let turning = [Dual::new(0.8, -0.6), Dual::new(0.6, 0.8), Dual::new(0.0, 0.0)];
        let still = [1.0, 0.0, 0.0].map(|x| Dual::new(x, 0.0));
        assert!((angle(turning, still).derivative - 1.0).abs() < 1e-15);
        assert!((cosine(turning, still).derivative + 0.6).abs() < 1e-15);
        assert_eq!(angle(turning, turning).derivative, 0.0);
    }
}
