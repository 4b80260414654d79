//! Relations that measure angles find the angles that bodies were turned by.

use hardpoint::kernels::RelationKind;
use hardpoint::relation::Place;

type Quaternion = [f64; 4];

/// The Euler parameters of the product A(p) A(q).
fn product(p: Quaternion, q: Quaternion) -> Quaternion {
    [
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
        p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1],
    ]
}

fn inverse(p: Quaternion) -> Quaternion {
    [p[0], -p[1], -p[2], -p[3]]
}

/// The turn by `angle` (rad) about a unit vector, right-handed.
fn turn(axis: [f64; 3], angle: f64) -> Quaternion {
    let (sin, cos) = (angle / 2.0).sin_cos();
    [cos, axis[0] * sin, axis[1] * sin, axis[2] * sin]
}

fn about(axis: usize, angle: f64) -> Quaternion {
    turn(std::array::from_fn(|k| f64::from(u8::from(k == axis))), angle)
}

fn column(p: Quaternion, axis: usize) -> [f64; 3] {
    let unit = about(axis, std::f64::consts::PI);
    let [_, x, y, z] = product(product(p, unit), inverse(p));
    [x, y, z]
}

fn random_turn(rng: &mut fastrand::Rng) -> Quaternion {
    let mut p = [0.0; 4].map(|_: f64| 2.0 * rng.f64() - 1.0);
    let norm = p.iter().map(|e| e * e).sum::<f64>().sqrt();
    p.iter_mut().for_each(|e| *e /= norm);
    p
}

fn measured(kind: RelationKind, p_i: Quaternion, p_j: Quaternion, h: &[f64]) -> Vec<f64> {
    let place = |p: Quaternion| [0.3, -0.2, 0.1, p[0], p[1], p[2], p[3]];
    let mut phi = vec![f64::NAN; kind.shape().equations];
    let place = Place { q_i: &place(p_i), q_j: &place(p_j), h };
    kind.kernels::<f64>().residual(place, &mut phi);
    phi
}

fn assert_same(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-13, "{found} instead of {expected}");
    }
}

/// Body j is turned about the bushing's x, its new y and its new z axis.
#[test]
fn bushing_angles_are_those_of_three_turns() {
    let mut rng = fastrand::Rng::with_seed(3);
    let small = [[0.0; 3], [1e-9, -2e-9, 3e-9], [0.02, 0.01, -0.03]];
    let large = [[3.1, 1.4, -3.1], [-2.0, -1.5, 0.5], [1.0, 0.7, 2.5]];
    for angles in small.into_iter().chain(large) {
        let [p_i, frame_i, frame_j] = [(); 3].map(|()| random_turn(&mut rng));
        let [a, b, c] = angles;
        let turned = product(product(about(0, a), about(1, b)), about(2, c));
        let p_j = product(product(product(p_i, frame_i), turned), inverse(frame_j));
        let h: Vec<f64> = [frame_i, frame_j]
            .iter()
            .flat_map(|&frame| (0..3).flat_map(move |axis| column(frame, axis)))
            .collect();
        assert_same(&measured(RelationKind::BushingAngles, p_i, p_j, &h), &angles);
        assert_same(&measured(RelationKind::BushingAnglesTorque, p_i, p_j, &h), &angles);
    }
}

/// Body j is turned about u_i × w_i; the angle that counts as zero is taken off.
#[test]
fn torsion_is_the_right_handed_angle_about_its_axis() {
    let mut rng = fastrand::Rng::with_seed(5);
    for angle in [0.0, 1e-9, -0.3, 1.2, 3.1, -3.1] {
        let [p_i, frame] = [(); 2].map(|()| random_turn(&mut rng));
        let [u, w, axis] = [0, 1, 2].map(|axis| column(frame, axis));
        let p_j = product(p_i, turn(axis, angle));
        let h: Vec<f64> = [u, w, u].concat().into_iter().chain([0.25]).collect();
        assert_same(&measured(RelationKind::Torsion, p_i, p_j, &h), &[angle - 0.25]);
    }
}

/// Body j is turned about any axis; the rotation vector is angle times axis.
#[test]
fn rotation_vectors_are_angle_times_axis() {
    let mut rng = fastrand::Rng::with_seed(6);
    for angle in [0.0, 1e-12, 1e-6, 0.02, -0.5, 1.9, 3.0, -3.0] {
        let [p_i, frame, direction] = [(); 3].map(|()| random_turn(&mut rng));
        let axis = column(direction, 0);
        let turned = product(p_i, turn(axis, angle));
        // Both signs of Euler parameters are one rotation.
        for p_j in [turned, turned.map(|e| -e)] {
            let axes = [0, 1, 2].map(|k| column(frame, k));
            let expected = axes.map(|b| angle * (b[0] * axis[0] + b[1] * axis[1] + b[2] * axis[2]));
            let h = axes.concat();
            let kind = RelationKind::BushingRotationVector;
            assert_same(&measured(kind, p_i, p_j, &h), &expected);
            let kind = RelationKind::BushingRotationVectorTorque;
            assert_same(&measured(kind, p_i, p_j, &h), &expected);
        }
    }
}
