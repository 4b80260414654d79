//! Orientation of the wheel and of its steer axis, in ISO 8855 axes.
//!
//! The formulas are generic over the scalar, so that their derivatives are exact.

use crate::model::Side;
use crate::scalar::Scalar;
use crate::vector::Vector;

/// Toe (rad), positive toe-in: atan2(s_x, σ s_y) with s the unit spin axis pointing outboard.
/// Up to a quarter turn of steering σ s_y is |s_y|, as Adams/Car and Lotus write it.
pub fn toe<S: Scalar>(spin: Vector<S>, side: Side) -> S {
    spin[0].atan2(S::from_f64(side.sign()) * spin[1])
}

/// Camber (rad), positive with the top outboard: −asin(s_z) for the unit spin axis s,
/// as Adams/Car and ISO 8855 define it.
pub fn camber<S: Scalar>(spin: Vector<S>) -> S {
    // The arc tangent keeps its accuracy where the arc sine loses half of its digits.
    (-spin[2]).atan2((spin[0] * spin[0] + spin[1] * spin[1]).sqrt())
}

/// Caster (rad), positive with the top rearward: atan2(−k_x, k_z) with k the steer axis
/// pointing up.
pub fn caster<S: Scalar>(steer_axis: Vector<S>) -> S {
    (-steer_axis[0]).atan2(steer_axis[2])
}

/// Kingpin inclination (rad), positive with the top inboard: atan2(−σ k_y, k_z).
pub fn kingpin<S: Scalar>(steer_axis: Vector<S>, side: Side) -> S {
    (S::from_f64(-side.sign()) * steer_axis[1]).atan2(steer_axis[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Alignment;
    use crate::scalar::Dual;

    #[test]
    fn toe_and_camber_are_those_that_made_the_spin_axis() {
        for side in [Side::Left, Side::Right] {
            let alignment = Alignment { toe: 0.03, camber: -0.02 };
            let spin = alignment.spin_axis(side);
            assert!((toe(spin, side) - alignment.toe).abs() < 1e-15);
            assert!((camber(spin) - alignment.camber).abs() < 1e-15);
        }
    }

    #[test]
    fn caster_and_kingpin_of_a_leaning_axis() {
        // Top rearward and inboard on the left.
        let axis = [-0.1, -0.2, 1.0];
        assert!((caster(axis) - 0.1_f64.atan()).abs() < 1e-15);
        assert!((kingpin(axis, Side::Left) - 0.2_f64.atan()).abs() < 1e-15);
        assert!((kingpin([-0.1, 0.2, 1.0], Side::Right) - 0.2_f64.atan()).abs() < 1e-15);
    }

    #[test]
    fn derivatives_of_angles_are_exact() {
        let spin = |t: f64| [0.1 + t, 0.9 - t * t, 0.2 * t - 0.3];
        let dual = [Dual::new(0.1, 1.0), Dual::new(0.9, 0.0), Dual::new(-0.3, 0.2)];
        let h = 1e-6;
        let difference = (toe(spin(h), Side::Left) - toe(spin(-h), Side::Left)) / (2.0 * h);
        assert!((toe(dual, Side::Left).derivative - difference).abs() < 1e-9);
        let difference = (camber(spin(h)) - camber(spin(-h))) / (2.0 * h);
        assert!((camber(dual).derivative - difference).abs() < 1e-9);
    }
}
