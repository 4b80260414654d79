//! Orientation of the wheel and of its steer axis, in ISO 8855 axes.
//!
//! The formulas are generic over the scalar, so that their derivatives are exact.

use super::definition::{Definition, Factor, Subject, components, formula};
use crate::model::{Quantity, Side};
use crate::rig::Pose;
use crate::scalar::Scalar;
use crate::vector::{Vector, cross, dot, rotation_angles, scale, unit};

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

/// Camber (rad) as it is seen from the front, positive with the top outboard: −atan2(s_z, σ s_y),
/// as Lotus defines it.
pub fn front_view_camber<S: Scalar>(spin: Vector<S>, side: Side) -> S {
    (-spin[2]).atan2(S::from_f64(side.sign()) * spin[1])
}

/// The horizontal unit vector along which the wheel rolls, forward: σ unit(s × e_z).
pub fn heading<S: Scalar>(spin: Vector<S>, side: Side) -> Vector<S> {
    let up = [0.0, 0.0, 1.0].map(S::from_f64);
    scale(S::from_f64(side.sign()), unit(cross(spin, up)))
}

/// The horizontal unit vector across the wheel, pointing outboard.
pub fn outboard<S: Scalar>(spin: Vector<S>) -> Vector<S> {
    unit([spin[0], spin[1], S::from_f64(0.0)])
}

/// How far the wheel's body has turned about the spin axis (rad), positive with the top rearward: the
/// angle in the plane of the wheel from its heading to the direction of its body that was the heading
/// at design.
pub fn side_view_angle<S: Scalar>(pose: &Pose<S>) -> S {
    let (spin, side) = (pose.wheel.spin, pose.side);
    let carried = heading(pose.design.wheel.spin, side);
    let carried = pose.rotation.map(|row| dot(row, carried));
    let heading = heading(spin, side);
    // Upward in the plane of the wheel; both axes change their signs with the side.
    let up = scale(S::from_f64(side.sign()), cross(heading, spin));
    dot(carried, up).atan2(dot(carried, heading))
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

const ANGLE: Factor =
    Factor { subject: Subject::Orientation, quantity: Quantity::Angle, ..Factor::BLANK };

pub(super) const ANGLES: &[Factor] = &[
    Factor {
        name: "toe",
        title: "toe",
        symbol: "δ_t",
        sign: "+ toe-in",
        formula: "atan2(s_x, σ s_y), s the outboard spin axis, σ = +1 left, −1 right",
        source: "Adams/Car, Lotus",
        value: formula!(|pose| Some(toe(pose.wheel.spin, pose.side))),
        ..ANGLE
    },
    Factor {
        name: "toe_plane",
        title: "toe in the plane of the wheel",
        symbol: "δ_p",
        sign: "+ toe-in",
        formula: "asin(s_x)",
        source: "Lotus",
        value: formula!(|pose| {
            let [x, y, z] = pose.wheel.spin;
            Some(x.atan2((y * y + z * z).sqrt()))
        }),
        ..ANGLE
    },
    Factor {
        name: "steer_angle",
        title: "steer angle of the wheel",
        symbol: "δ",
        sign: "+ to the left",
        formula: "−σ toe",
        source: "ISO 8855",
        value: formula!(|pose| Some(-(pose.sigma() * toe(pose.wheel.spin, pose.side)))),
        ..ANGLE
    },
    Factor {
        name: "camber",
        title: "camber",
        symbol: "γ",
        sign: "+ top outboard",
        formula: "−asin(s_z)",
        source: "Adams/Car, ISO 8855",
        value: formula!(|pose| Some(camber(pose.wheel.spin))),
        lotus: Some(Definition {
            sign: "+ top outboard",
            formula: "−atan2(s_z, σ s_y), as seen from the front",
            source: "Lotus",
            value: formula!(|pose| Some(front_view_camber(pose.wheel.spin, pose.side))),
        }),
        ..ANGLE
    },
    Factor {
        name: "inclination",
        title: "inclination angle",
        symbol: "ε_W",
        sign: "+ top to the right",
        formula: "−σ camber",
        source: "ISO 8855",
        value: formula!(|pose| Some(-(pose.sigma() * camber(pose.wheel.spin)))),
        ..ANGLE
    },
    Factor {
        name: "side_view_angle",
        title: "side-view angle",
        symbol: "θ_s",
        sign: "+ top rearward",
        formula: "turn of the wheel's body about s from design: from e_h to the direction that was e_h at design",
        source: "Adams/Car",
        value: formula!(|pose| Some(side_view_angle(pose))),
        ..ANGLE
    },
];

fn spin<S: Scalar>(pose: &Pose<S>) -> Option<Vector<S>> {
    Some(pose.wheel.spin)
}

pub(super) const SPIN_AXIS: [Factor; 3] = components!(
    "spin_axis",
    "spin axis",
    "s",
    spin,
    Factor {
        quantity: Quantity::Ratio,
        formula: "unit vector along the spin axis, outboard, in the model's axes",
        source: "ISO 8855",
        ..ANGLE
    }
);

/// Angles of the wheel's rotation in the axes of the model.
fn rotation<S: Scalar>(pose: &Pose<S>) -> [S; 3] {
    rotation_angles(pose.axes.rotation_from_iso(pose.rotation))
}

const TURNED: Factor =
    Factor { formula: "R = Rx(a) Ry(b) Rz(c), from design, in the model's axes", ..ANGLE };

pub(super) const ROTATION: [Factor; 3] = [
    Factor {
        name: "wheel_rot_x",
        title: "wheel rotation about x",
        symbol: "a",
        sign: "+ right-handed about the model's +x",
        source: "method paper, Fig. 9",
        value: formula!(|pose| Some(rotation(pose)[0])),
        ..TURNED
    },
    Factor {
        name: "wheel_rot_y",
        title: "wheel rotation about y",
        symbol: "b",
        sign: "+ right-handed about the model's +y",
        source: "method paper, Fig. 10",
        value: formula!(|pose| Some(rotation(pose)[1])),
        ..TURNED
    },
    Factor {
        name: "wheel_rot_z",
        title: "wheel rotation about z",
        symbol: "c",
        sign: "+ right-handed about the model's +z",
        source: "method paper, Fig. 11",
        value: formula!(|pose| Some(rotation(pose)[2])),
        ..TURNED
    },
];

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
