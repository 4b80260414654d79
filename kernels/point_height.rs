// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Prescribed height of a point
///
/// `e_zᵀ (r + A s) − z = 0` (unit m)
///
/// Source: the z row of method paper, eq. (10), against the ground.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `s_i` | m | body i | the point |
/// | 3 | `height` | m |  | its height in the frame of the ground |
pub mod point_height {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "point_height",
        title: "Prescribed height of a point",
        equation: "e_zᵀ (r + A s) − z = 0",
        reference: "the z row of method paper, eq. (10), against the ground",
        bodies: 1,
        equations: 1,
        unit: "m",
        parameters: &[
            Parameter {
                name: "s_i",
                size: 3,
                offset: 0,
                unit: "m",
                frame: "body i",
                meaning: "the point",
            },
            Parameter {
                name: "height",
                size: 1,
                offset: 3,
                unit: "m",
                frame: "",
                meaning: "its height in the frame of the ground",
            },
        ],
        jacobian: &[(0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
        work: &[],
        curvature: &[(3, 3), (4, 3), (4, 4), (5, 3), (5, 5), (6, 4), (6, 5), (6, 6)],
        design: &[(0, 0), (0, 1), (0, 2), (0, 3)],
        force_design: &[
            (3, 0),
            (3, 1),
            (3, 2),
            (4, 0),
            (4, 1),
            (4, 2),
            (5, 0),
            (5, 1),
            (5, 2),
            (6, 0),
            (6, 1),
            (6, 2),
        ],
        rate: &[(0, 3), (0, 4), (0, 5), (0, 6)],
        rate_design: &[(0, 0), (0, 1), (0, 2)],
        operations: [
            Operations {
                additions: 13,
                multiplications: 16,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 13,
                multiplications: 21,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 13,
                multiplications: 27,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 5,
                multiplications: 18,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 17,
                multiplications: 32,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Prescribed height of a point
    #[derive(Clone, Copy, Debug, Default)]
    pub struct PointHeight;
    impl<S: Scalar> Relation<S> for PointHeight {
        fn shape(&self) -> &'static Shape {
            &SHAPE
        }
        fn residual(&self, place: Place<'_, S>, phi: &mut [S]) {
            residual(place.q_i, exact(place.h), exact_mut(phi));
        }
        fn jacobian(
            &self,
            place: Place<'_, S>,
            phi: &mut [S],
            phi_q: &mut [S],
            work: &mut [S],
        ) {
            jacobian(
                place.q_i,
                exact(place.h),
                exact_mut(phi),
                exact_mut(phi_q),
                exact_mut(work),
            );
        }
        fn curvature(
            &self,
            place: Place<'_, S>,
            lambda: &[S],
            phi: &mut [S],
            phi_q: &mut [S],
            work: &mut [S],
            curvature: &mut [S],
        ) {
            self::curvature(
                place.q_i,
                exact(place.h),
                exact(lambda),
                exact_mut(phi),
                exact_mut(phi_q),
                exact_mut(work),
                exact_mut(curvature),
            );
        }
        fn design(
            &self,
            place: Place<'_, S>,
            lambda: &[S],
            phi_h: &mut [S],
            force_h: &mut [S],
        ) {
            design(
                place.q_i,
                exact(place.h),
                exact(lambda),
                exact_mut(phi_h),
                exact_mut(force_h),
            );
        }
        fn rate(
            &self,
            place: Place<'_, S>,
            v_i: &Coordinates<S>,
            _v_j: &Coordinates<S>,
            rate_q: &mut [S],
            rate_h: &mut [S],
        ) {
            rate(place.q_i, exact(place.h), v_i, exact_mut(rate_q), exact_mut(rate_h));
        }
    }
    /// Φ.
    ///
    /// 13 additions, 16 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(q_i: &[S; 7], h: &[S; 4], phi: &mut [S; 1]) {
        let t0 = q_i[3] * (q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0])
            + q_i[4] * (h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]));
        let t1 = t0 - q_i[5] * (q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6]);
        let t2 = q_i[6] * (h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5])) + t1;
        phi[0] = q_i[2] + t2 - h[3];
    }
    /// Φ, Φ_q and W.
    ///
    /// 13 additions, 21 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 4],
        phi: &mut [S; 1],
        phi_q: &mut [S; 5],
        _work: &mut [S; 0],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let t0 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t1 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t2 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t3 = q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        phi[0] = q_i[2] + t4 - h[3];
        phi_q[0] = one;
        phi_q[1] = t1 * two;
        phi_q[2] = t2 * two;
        phi_q[3] = -(t3 * two);
        phi_q[4] = t0 * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 13 additions, 27 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 4],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 5],
        _work: &mut [S; 0],
        curvature: &mut [S; 8],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let t0 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t1 = q_i[3] * h[2] + q_i[4] * h[1] - h[0] * q_i[5];
        let t2 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t3 = q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = lambda[0] * two;
        let t6 = h[2] * t5;
        let t7 = h[1] * t5;
        let t8 = -t6;
        let t9 = h[0] * t5;
        phi[0] = q_i[2] + t4 - h[3];
        phi_q[0] = one;
        phi_q[1] = t1 * two;
        phi_q[2] = t2 * two;
        phi_q[3] = -(t3 * two);
        phi_q[4] = t0 * two;
        curvature[0] = t6;
        curvature[1] = t7;
        curvature[2] = t8;
        curvature[3] = -t9;
        curvature[4] = t8;
        curvature[5] = t9;
        curvature[6] = t7;
        curvature[7] = t6;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 5 additions, 18 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        _h: &[S; 4],
        lambda: &[S; 1],
        phi_h: &mut [S; 4],
        force_h: &mut [S; 12],
    ) {
        let two = S::from_f64(2.0);
        let minus_one = S::from_f64(-1.0);
        let t0 = lambda[0] * two;
        let t1 = q_i[5] * t0;
        let t2 = -t1;
        let t3 = q_i[4] * t0;
        let t4 = q_i[3] * t0;
        let t5 = q_i[6] * t0;
        phi_h[0] = (q_i[4] * q_i[6] - q_i[3] * q_i[5]) * two;
        phi_h[1] = (q_i[3] * q_i[4] + q_i[5] * q_i[6]) * two;
        phi_h[2] = q_i[6] * q_i[6]
            + (q_i[3] * q_i[3] - (q_i[4] * q_i[4] + q_i[5] * q_i[5]));
        phi_h[3] = minus_one;
        force_h[0] = t2;
        force_h[1] = t3;
        force_h[2] = t4;
        force_h[3] = t5;
        force_h[4] = t4;
        force_h[5] = -t3;
        force_h[6] = -t4;
        force_h[7] = t5;
        force_h[8] = t2;
        force_h[9] = t3;
        force_h[10] = t1;
        force_h[11] = t5;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 17 additions, 32 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 4],
        v_i: &[S; 7],
        rate_q: &mut [S; 4],
        rate_h: &mut [S; 3],
    ) {
        let two = S::from_f64(2.0);
        let t0 = v_i[4] * q_i[6] + (v_i[6] * q_i[4] - v_i[5] * q_i[3] - v_i[3] * q_i[5]);
        let t1 = v_i[5] * q_i[6]
            + (v_i[6] * q_i[5] + (v_i[4] * q_i[3] + v_i[3] * q_i[4]));
        let t2 = v_i[6] * q_i[6] + (v_i[3] * q_i[3] - v_i[4] * q_i[4] - v_i[5] * q_i[5]);
        rate_q[0] = (h[2] * v_i[3] + (h[1] * v_i[4] - h[0] * v_i[5])) * two;
        rate_q[1] = (h[0] * v_i[6] + h[1] * v_i[3] - v_i[4] * h[2]) * two;
        rate_q[2] = -((v_i[5] * h[2] + (h[0] * v_i[3] - h[1] * v_i[6])) * two);
        rate_q[3] = (h[2] * v_i[6] + (h[0] * v_i[4] + v_i[5] * h[1])) * two;
        rate_h[0] = t0 * two;
        rate_h[1] = t1 * two;
        rate_h[2] = t2 * two;
    }
}
