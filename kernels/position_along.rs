// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Position of a point along a fixed direction
///
/// `aᵀ (r + A s) − c = 0` (unit m)
///
/// Source: method paper, eq. (10), along one direction of the ground.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `a` | 1 | ground | unit direction of the coordinate |
/// | 3..6 | `s_i` | m | body i | the point |
/// | 6 | `value` | m |  | the coordinate |
pub mod position_along {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "position_along",
        title: "Position of a point along a fixed direction",
        equation: "aᵀ (r + A s) − c = 0",
        reference: "method paper, eq. (10), along one direction of the ground",
        bodies: 1,
        equations: 1,
        unit: "m",
        parameters: &[
            Parameter {
                name: "a",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "ground",
                meaning: "unit direction of the coordinate",
            },
            Parameter {
                name: "s_i",
                size: 3,
                offset: 3,
                unit: "m",
                frame: "body i",
                meaning: "the point",
            },
            Parameter {
                name: "value",
                size: 1,
                offset: 6,
                unit: "m",
                frame: "",
                meaning: "the coordinate",
            },
        ],
        jacobian: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
        work: &[],
        curvature: &[
            (3, 3),
            (4, 3),
            (4, 4),
            (5, 3),
            (5, 4),
            (5, 5),
            (6, 3),
            (6, 4),
            (6, 5),
            (6, 6),
        ],
        design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
        force_design: &[
            (0, 0),
            (1, 1),
            (2, 2),
            (3, 0),
            (3, 1),
            (3, 2),
            (3, 3),
            (3, 4),
            (3, 5),
            (4, 0),
            (4, 1),
            (4, 2),
            (4, 3),
            (4, 4),
            (4, 5),
            (5, 0),
            (5, 1),
            (5, 2),
            (5, 3),
            (5, 4),
            (5, 5),
            (6, 0),
            (6, 1),
            (6, 2),
            (6, 3),
            (6, 4),
            (6, 5),
        ],
        rate: &[(0, 3), (0, 4), (0, 5), (0, 6)],
        rate_design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5)],
        operations: [
            Operations {
                additions: 23,
                multiplications: 27,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 31,
                multiplications: 43,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 44,
                multiplications: 62,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 50,
                multiplications: 75,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 77,
                multiplications: 91,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Position of a point along a fixed direction
    #[derive(Clone, Copy, Debug, Default)]
    pub struct PositionAlong;
    impl<S: Scalar> Relation<S> for PositionAlong {
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
    /// 23 additions, 27 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(q_i: &[S; 7], h: &[S; 7], phi: &mut [S; 1]) {
        let t0 = h[5] * q_i[6] + (h[3] * q_i[4] + q_i[5] * h[4]);
        let t1 = q_i[3] * h[5] + h[4] * q_i[4] - h[3] * q_i[5];
        let t2 = h[3] * q_i[6] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t3 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t6 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t7 = h[2] * (q_i[2] + t4) + (h[0] * (q_i[0] + t5) + h[1] * (q_i[1] + t6));
        phi[0] = t7 - h[6];
    }
    /// Φ, Φ_q and W.
    ///
    /// 31 additions, 43 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 7],
        phi: &mut [S; 1],
        phi_q: &mut [S; 7],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let t0 = q_i[6] * h[5] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t1 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t2 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t3 = h[5] * q_i[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t6 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        phi[0] = h[2] * (q_i[2] + t4)
            + (h[1] * (q_i[1] + t5) + (h[0] * (q_i[0] + t6) - h[6]));
        phi_q[0] = h[0];
        phi_q[1] = h[1];
        phi_q[2] = h[2];
        phi_q[3] = (t1 * h[1] + (t2 * h[2] + h[0] * t3)) * two;
        phi_q[4] = (t1 * h[2] + (h[0] * t0 - t2 * h[1])) * two;
        phi_q[5] = (t0 * h[1] + (h[0] * t2 - t3 * h[2])) * two;
        phi_q[6] = (t0 * h[2] + (t3 * h[1] - h[0] * t1)) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 44 additions, 62 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 7],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 7],
        _work: &mut [S; 0],
        curvature: &mut [S; 10],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t1 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t2 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t3 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t6 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t7 = h[2] * two;
        let t8 = h[0] * two;
        let t9 = h[1] * two;
        let t10 = t0 * two;
        let t11 = h[0] * lambda[0] * two;
        let t12 = h[3] * t11;
        let t13 = h[2] * lambda[0] * two;
        let t14 = h[5] * t13;
        let t15 = h[1] * lambda[0] * two;
        let t16 = h[4] * t15;
        let t17 = h[4] * t13;
        let t18 = h[5] * t15;
        let t19 = h[5] * t11;
        let t20 = h[3] * t13;
        let t21 = h[4] * t11;
        let t22 = h[3] * t15;
        let t23 = t16 - t14;
        phi[0] = h[2] * (q_i[2] + t4)
            + (h[1] * (q_i[1] + t5) + (h[0] * (q_i[0] + t6) - h[6]));
        phi_q[0] = h[0];
        phi_q[1] = h[1];
        phi_q[2] = h[2];
        phi_q[3] = t2 * t7 + (t3 * t8 + t1 * t9);
        phi_q[4] = t1 * t7 + (h[0] * t10 - t2 * h[1] * two);
        phi_q[5] = h[1] * t10 + (t2 * t8 - t3 * h[2] * two);
        phi_q[6] = h[2] * t10 + (t3 * t9 - h[0] * t1 * two);
        curvature[0] = t12 + (t14 + t16);
        curvature[1] = t17 - t18;
        curvature[2] = t12 - t14 - t16;
        curvature[3] = t19 - t20;
        curvature[4] = t21 + t22;
        curvature[5] = t23 - t12;
        curvature[6] = t22 - t21;
        curvature[7] = t20 + t19;
        curvature[8] = t18 + t17;
        curvature[9] = -t23 - t12;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 50 additions, 75 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 7],
        lambda: &[S; 1],
        phi_h: &mut [S; 7],
        force_h: &mut [S; 27],
    ) {
        let two = S::from_f64(2.0);
        let minus_one = S::from_f64(-1.0);
        let t0 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t1 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t2 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t3 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t4 = q_i[5] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[6] * t3));
        let t5 = q_i[6] * t2 + (q_i[5] * t1 + (q_i[3] * t3 - q_i[4] * t0));
        let t6 = q_i[6] * t1 + (q_i[4] * t3 + (q_i[3] * t0 - q_i[5] * t2));
        let t7 = q_i[3] * q_i[3];
        let t8 = q_i[4] * q_i[4];
        let t9 = q_i[6] * q_i[6];
        let t10 = q_i[5] * q_i[5];
        let t11 = q_i[3] * q_i[6];
        let t12 = q_i[4] * q_i[5];
        let t13 = h[1] * two;
        let t14 = q_i[4] * q_i[6];
        let t15 = q_i[3] * q_i[5];
        let t16 = h[2] * two;
        let t17 = t7 - t8;
        let t18 = t10 - t9;
        let t19 = h[0] * two;
        let t20 = q_i[4] * q_i[3];
        let t21 = q_i[6] * q_i[5];
        let t22 = lambda[0] * two;
        let t23 = t2 * t22;
        let t24 = t3 * t22;
        let t25 = t0 * t22;
        let t26 = h[1] * lambda[0] * two;
        let t27 = q_i[6] * t26;
        let t28 = h[0] * lambda[0] * two;
        let t29 = h[2] * lambda[0] * two;
        let t30 = q_i[3] * t28 - q_i[5] * t29;
        let t31 = t27 + t30;
        let t32 = q_i[4] * t29;
        let t33 = q_i[3] * t26 - q_i[6] * t28;
        let t34 = t32 + t33;
        let t35 = q_i[5] * t28;
        let t36 = q_i[3] * t29 - q_i[4] * t26;
        let t37 = t35 + t36;
        let t38 = t1 * t22;
        let t39 = q_i[6] * t29 + (q_i[4] * t28 + q_i[5] * t26);
        phi_h[0] = q_i[0] + t4;
        phi_h[1] = q_i[1] + t5;
        phi_h[2] = q_i[2] + t6;
        phi_h[3] = h[0] * (t7 + t8 - t9 - t10) + ((t11 + t12) * t13 + (t14 - t15) * t16);
        phi_h[4] = h[1] * (t17 + t18) + ((t12 - t11) * t19 + t16 * (t20 + t21));
        phi_h[5] = h[2] * (t17 - t18) + (t19 * (t15 + t14) + t13 * (t21 - t20));
        phi_h[6] = minus_one;
        force_h[0] = lambda[0];
        force_h[1] = lambda[0];
        force_h[2] = lambda[0];
        force_h[3] = t23;
        force_h[4] = t24;
        force_h[5] = t25;
        force_h[6] = t31;
        force_h[7] = t34;
        force_h[8] = t37;
        force_h[9] = t38;
        force_h[10] = -t25;
        force_h[11] = t24;
        force_h[12] = t39;
        force_h[13] = t37;
        force_h[14] = -t33 - t32;
        force_h[15] = t25;
        force_h[16] = t38;
        force_h[17] = -t23;
        force_h[18] = -t36 - t35;
        force_h[19] = t39;
        force_h[20] = t31;
        force_h[21] = -t24;
        force_h[22] = t23;
        force_h[23] = t38;
        force_h[24] = t34;
        force_h[25] = -t30 - t27;
        force_h[26] = t39;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 77 additions, 91 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 7],
        v_i: &[S; 7],
        rate_q: &mut [S; 4],
        rate_h: &mut [S; 6],
    ) {
        let two = S::from_f64(2.0);
        let t0 = v_i[3] * h[5] + (h[4] * v_i[4] - h[3] * v_i[5]);
        let t1 = h[2] * two;
        let t2 = h[5] * v_i[5] + (h[3] * v_i[3] - h[4] * v_i[6]);
        let t3 = h[0] * two;
        let t4 = h[4] * v_i[3] + (v_i[6] * h[3] - h[5] * v_i[4]);
        let t5 = h[1] * two;
        let t6 = v_i[6] * h[5] + (h[3] * v_i[4] + h[4] * v_i[5]);
        let t7 = h[4] * q_i[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t8 = h[5] * q_i[6] + (h[3] * q_i[4] + h[4] * q_i[5]);
        let t9 = h[5] * q_i[5] + (h[3] * q_i[3] - h[4] * q_i[6]);
        let t10 = h[3] * q_i[6] + (h[4] * q_i[3] - h[5] * q_i[4]);
        let t11 = t6 * q_i[4] + (t2 * q_i[3] - t4 * q_i[6] - v_i[6] * t10);
        let t12 = v_i[5] * t7 + (v_i[4] * t8 + (v_i[3] * t9 + (t0 * q_i[5] + t11)));
        let t13 = t6 * q_i[5] + (t4 * q_i[3] - t0 * q_i[4] - v_i[4] * t7);
        let t14 = v_i[6] * t9 + (v_i[5] * t8 + (v_i[3] * t10 + (t2 * q_i[6] + t13)));
        let t15 = t4 * q_i[4] + (t0 * q_i[3] - t2 * q_i[5] - v_i[5] * t9);
        let t16 = v_i[6] * t8 + (v_i[4] * t10 + (v_i[3] * t7 + (t6 * q_i[6] + t15)));
        let t17 = v_i[4] * q_i[6] + v_i[6] * q_i[4];
        let t18 = v_i[5] * q_i[3];
        let t19 = v_i[3] * q_i[5];
        let t20 = v_i[4] * q_i[4];
        let t21 = v_i[3] * q_i[3];
        let t22 = v_i[6] * q_i[6];
        let t23 = v_i[5] * q_i[5];
        let t24 = v_i[4] * q_i[5] + v_i[5] * q_i[4];
        let t25 = v_i[6] * q_i[3];
        let t26 = v_i[3] * q_i[6];
        let t27 = t3 * (t20 + t21 - t22 - t23) + t5 * (t24 + (t25 + t26));
        let t28 = v_i[5] * q_i[6] + v_i[6] * q_i[5];
        let t29 = v_i[4] * q_i[3];
        let t30 = v_i[3] * q_i[4];
        let t31 = t21 - t20;
        let t32 = t3 * (t24 - t25 - t26) + t5 * (t31 + (t23 - t22));
        let t33 = t3 * (t19 + (t18 + t17)) + t5 * (t28 - t29 - t30);
        rate_q[0] = t0 * t1 + (t2 * t3 + t4 * t5);
        rate_q[1] = t4 * t1 + (t3 * t6 - h[1] * t0 * two);
        rate_q[2] = t5 * t6 + (t3 * t0 - t2 * h[2] * two);
        rate_q[3] = t1 * t6 + (t2 * t5 - h[0] * t4 * two);
        rate_h[0] = v_i[0] + t12;
        rate_h[1] = v_i[1] + t14;
        rate_h[2] = v_i[2] + t16;
        rate_h[3] = t1 * (t17 - t18 - t19) + t27;
        rate_h[4] = t1 * (t28 + (t29 + t30)) + t32;
        rate_h[5] = t1 * (t22 + (t31 - t23)) + t33;
    }
}
