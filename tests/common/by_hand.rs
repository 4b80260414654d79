//! What relations say, written once more by hand.

use hardpoint::kernels::RelationKind;
use hardpoint::scalar::Scalar;
use hardpoint::vector::{Vector, add, cross, rotate, scale};

use super::dual::{State, dot, rotation_matrix, times};

/// Residuals written by hand from the equations of the books, with the textbook rotation matrix.
pub fn residual(kind: RelationKind, state: &State) -> Vec<f64> {
    let (q, h) = (&state.q, &state.h);
    let a = [rotation_matrix(&q[3..7]), rotation_matrix(&q[10..14])];
    let point = |body: usize, s: &[f64]| {
        let turned = times(&a[body], s);
        let r = &q[7 * body..7 * body + 3];
        [r[0] + turned[0], r[1] + turned[1], r[2] + turned[2]]
    };
    let between = |from: &[f64], to: &[f64]| {
        let (p, q) = (point(0, from), point(1, to));
        [q[0] - p[0], q[1] - p[1], q[2] - p[2]]
    };
    match kind {
        RelationKind::Spherical => between(&h[0..3], &h[3..6]).to_vec(),
        RelationKind::Orthogonal1 => vec![dot(&times(&a[0], &h[0..3]), &times(&a[1], &h[3..6]))],
        RelationKind::Orthogonal2 => {
            vec![dot(&times(&a[0], &h[0..3]), &between(&h[3..6], &h[6..9]))]
        }
        RelationKind::EulerParameters => vec![dot(&q[3..7], &q[3..7]) - 1.0],
        RelationKind::Distance => {
            let d = between(&h[0..3], &h[3..6]);
            vec![dot(&d, &d).sqrt() - h[6]]
        }
        RelationKind::SquaredDistance => {
            let d = between(&h[0..3], &h[3..6]);
            vec![dot(&d, &d) - h[6] * h[6]]
        }
        RelationKind::Displacement => {
            vec![dot(&times(&a[0], &h[0..3]), &between(&h[3..6], &h[6..9])) - h[9]]
        }
        RelationKind::Rotation => {
            let w = times(&a[1], &h[6..9]);
            let (cosine, sine) =
                (dot(&times(&a[0], &h[0..3]), &w), dot(&times(&a[0], &h[3..6]), &w));
            vec![sine * h[9].cos() - cosine * h[9].sin()]
        }
        RelationKind::RackAndPinion => {
            let turn = h[18] * dot(&times(&a[0], &h[9..12]), &between(&h[12..15], &h[15..18]));
            let w = times(&a[1], &h[6..9]);
            let (cosine, sine) =
                (dot(&times(&a[0], &h[0..3]), &w), dot(&times(&a[0], &h[3..6]), &w));
            vec![sine * turn.cos() - cosine * turn.sin()]
        }
        RelationKind::PointHeight => vec![point(0, &h[0..3])[2] - h[3]],
        RelationKind::PatchHeight => {
            // The lowest point of the disc, found along the steepest descent in its plane.
            let (center, s) = (point(0, &h[0..3]), times(&a[0], &h[3..6]));
            let down = [s[2] * s[0], s[2] * s[1], s[2] * s[2] - 1.0];
            let length = dot(&down, &down).sqrt();
            vec![center[2] + h[6] * down[2] / length - h[7]]
        }
        RelationKind::ForceInBody | RelationKind::MomentInBody | RelationKind::MomentInSpace => {
            vec![0.0]
        }
        RelationKind::BushingRotationVector | RelationKind::BushingRotationVectorTorque => {
            // Angle and axis from the trace and the unsymmetric part of A_iᵀ A_j.
            let r: [[f64; 3]; 3] = std::array::from_fn(|row| {
                std::array::from_fn(|column| (0..3).map(|k| a[0][k][row] * a[1][k][column]).sum())
            });
            let axis = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
            let sine = dot(&axis, &axis).sqrt() / 2.0;
            let angle = sine.atan2((r[0][0] + r[1][1] + r[2][2] - 1.0) / 2.0);
            let theta = axis.map(|component| component * angle / (2.0 * sine));
            (0..3).map(|k| dot(&h[3 * k..3 * k + 3], &theta)).collect()
        }
        RelationKind::PositionAlong => vec![dot(&h[0..3], &point(0, &h[3..6])) - h[6]],
        RelationKind::Torsion => {
            let u = times(&a[1], &h[6..9]);
            let (cosine, sine) =
                (dot(&times(&a[0], &h[0..3]), &u), dot(&times(&a[0], &h[3..6]), &u));
            vec![sine.atan2(cosine) - h[9]]
        }
        RelationKind::BushingTranslation => {
            let d = between(&h[9..12], &h[12..15]);
            (0..3).map(|k| dot(&times(&a[0], &h[3 * k..3 * k + 3]), &d)).collect()
        }
        RelationKind::BushingAngles | RelationKind::BushingAnglesTorque => {
            let entry = |row: usize, column: usize| {
                let (b, c) = (&h[3 * row..3 * row + 3], &h[9 + 3 * column..12 + 3 * column]);
                dot(&times(&a[0], b), &times(&a[1], c))
            };
            vec![
                (-entry(1, 2)).atan2(entry(2, 2)),
                entry(0, 2).atan2(entry(0, 0).hypot(entry(0, 1))),
                (-entry(0, 1)).atan2(entry(0, 0)),
            ]
        }
    }
}

/// A force at a point and a moment, both in ground axes, on each of two bodies.
pub struct Load<S> {
    /// The point from the origin of the body, the force there, and the moment.
    pub bodies: [[Vector<S>; 3]; 2],
}

fn vector<S: Copy>(from: &[S]) -> Vector<S> {
    [from[0], from[1], from[2]]
}

/// What the multipliers of a relation with `work` push with.
pub fn applied<S: Scalar>(kind: RelationKind, q: &[S; 14], h: &[S], lambda: &[S]) -> Load<S> {
    let zero = [S::from_f64(0.0); 3];
    let p_i = [q[3], q[4], q[5], q[6]];
    match kind {
        RelationKind::BushingAnglesTorque | RelationKind::BushingRotationVectorTorque => {
            let axes = [vector(&h[0..3]), vector(&h[3..6]), vector(&h[6..9])];
            let local = (0..3).fold(zero, |sum, k| add(sum, scale(lambda[k], axes[k])));
            let moment = rotate(p_i, local);
            let against = moment.map(|component| -component);
            Load { bodies: [[zero, zero, against], [zero, zero, moment]] }
        }
        RelationKind::MomentInSpace => {
            Load { bodies: [[zero, zero, scale(lambda[0], vector(h))], [zero; 3]] }
        }
        RelationKind::MomentInBody => {
            let moment = rotate(p_i, scale(lambda[0], vector(h)));
            Load { bodies: [[zero, zero, moment], [zero; 3]] }
        }
        RelationKind::ForceInBody => {
            let (push, point) = (rotate(p_i, vector(h)), rotate(p_i, vector(&h[3..6])));
            Load { bodies: [[point, scale(lambda[0], push), zero], [zero; 3]] }
        }
        other => panic!("{} states no work", other.name()),
    }
}

/// The generalized force of a load: f at the point s gives f for r and 2 Eᵀ(m + s × f) for p,
/// E = [−e, e0 1 + ẽ] (Haug 9.3).
pub fn force<S: Scalar>(load: &Load<S>, q: &[S; 14]) -> [S; 14] {
    let two = S::from_f64(2.0);
    let mut force = [S::from_f64(0.0); 14];
    for (body, [point, push, moment]) in load.bodies.iter().enumerate() {
        let (e0, e) = (q[7 * body + 3], vector(&q[7 * body + 4..7 * body + 7]));
        let moment = add(*moment, cross(*point, *push));
        // ẽᵀ m = −e × m = m × e
        let of_e = add(scale(e0, moment), cross(moment, e));
        for k in 0..3 {
            force[7 * body + k] = push[k];
            force[7 * body + 3] = force[7 * body + 3] - two * e[k] * moment[k];
            force[7 * body + 4 + k] = two * of_e[k];
        }
    }
    force
}
