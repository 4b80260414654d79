// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Spherical joint
///
/// `r_j + A_j s_j − r_i − A_i s_i = 0` (unit m)
///
/// Source: method paper, eq. (10)–(12).
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `s_i` | m | body i | joint point |
/// | 3..6 | `s_j` | m | body j | joint point |
pub mod spherical {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "spherical",
        title: "Spherical joint",
        equation: "r_j + A_j s_j − r_i − A_i s_i = 0",
        reference: "method paper, eq. (10)–(12)",
        bodies: 2,
        equations: 3,
        unit: "m",
        parameters: &[
            Parameter {
                name: "s_i",
                size: 3,
                offset: 0,
                unit: "m",
                frame: "body i",
                meaning: "joint point",
            },
            Parameter {
                name: "s_j",
                size: 3,
                offset: 3,
                unit: "m",
                frame: "body j",
                meaning: "joint point",
            },
        ],
        jacobian: &[
            (0, 0),
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 7),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
            (1, 1),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 6),
            (1, 8),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (2, 2),
            (2, 3),
            (2, 4),
            (2, 5),
            (2, 6),
            (2, 9),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
        ],
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
            (10, 10),
            (11, 10),
            (11, 11),
            (12, 10),
            (12, 11),
            (12, 12),
            (13, 10),
            (13, 11),
            (13, 12),
            (13, 13),
        ],
        design: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 3),
            (0, 4),
            (0, 5),
            (1, 0),
            (1, 1),
            (1, 2),
            (1, 3),
            (1, 4),
            (1, 5),
            (2, 0),
            (2, 1),
            (2, 2),
            (2, 3),
            (2, 4),
            (2, 5),
        ],
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
            (10, 3),
            (10, 4),
            (10, 5),
            (11, 3),
            (11, 4),
            (11, 5),
            (12, 3),
            (12, 4),
            (12, 5),
            (13, 3),
            (13, 4),
            (13, 5),
        ],
        rate: &[
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 6),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (2, 3),
            (2, 4),
            (2, 5),
            (2, 6),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
        ],
        rate_design: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 3),
            (0, 4),
            (0, 5),
            (1, 0),
            (1, 1),
            (1, 2),
            (1, 3),
            (1, 4),
            (1, 5),
            (2, 0),
            (2, 1),
            (2, 2),
            (2, 3),
            (2, 4),
            (2, 5),
        ],
        operations: [
            Operations {
                additions: 43,
                multiplications: 48,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 43,
                multiplications: 63,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 69,
                multiplications: 89,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 45,
                multiplications: 75,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 58,
                multiplications: 98,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Spherical joint
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Spherical;
    impl<S: Scalar> Relation<S> for Spherical {
        fn shape(&self) -> &'static Shape {
            &SHAPE
        }
        fn residual(&self, place: Place<'_, S>, phi: &mut [S]) {
            residual(place.q_i, place.q_j, exact(place.h), exact_mut(phi));
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
                place.q_j,
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
                place.q_j,
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
                place.q_j,
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
            v_j: &Coordinates<S>,
            rate_q: &mut [S],
            rate_h: &mut [S],
        ) {
            rate(
                place.q_i,
                place.q_j,
                exact(place.h),
                v_i,
                v_j,
                exact_mut(rate_q),
                exact_mut(rate_h),
            );
        }
    }
    /// Φ.
    ///
    /// 43 additions, 48 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        phi: &mut [S; 3],
    ) {
        let t0 = q_j[3] * h[5] + h[4] * q_j[4] - h[3] * q_j[5];
        let t1 = q_j[3] * h[3] + q_j[5] * h[5] - q_j[6] * h[4];
        let t2 = h[5] * q_j[6] + (h[3] * q_j[4] + q_j[5] * h[4]);
        let t3 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[3] * t1 + q_j[4] * t2) - q_j[6] * t3;
        let t5 = q_i[3] * h[2] + h[1] * q_i[4] - h[0] * q_i[5];
        let t6 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t7 = h[2] * q_i[6] + (h[0] * q_i[4] + q_i[5] * h[1]);
        let t8 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t9 = q_i[5] * t5 + (q_i[3] * t6 + q_i[4] * t7) - q_i[6] * t8;
        let t10 = q_j[6] * t1 + (q_j[5] * t2 + (q_j[3] * t3 - q_j[4] * t0));
        let t11 = q_i[6] * t6 + (q_i[5] * t7 + (q_i[3] * t8 - q_i[4] * t5));
        let t12 = q_j[6] * t2 + (q_j[3] * t0 + q_j[4] * t3 - q_j[5] * t1);
        let t13 = q_i[6] * t7 + (q_i[3] * t5 + q_i[4] * t8 - q_i[5] * t6);
        phi[0] = q_j[0] + t4 - q_i[0] - t9;
        phi[1] = q_j[1] + t10 - q_i[1] - t11;
        phi[2] = q_j[2] + t12 - q_i[2] - t13;
    }
    /// Φ, Φ_q and W.
    ///
    /// 43 additions, 63 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        phi: &mut [S; 3],
        phi_q: &mut [S; 30],
        _work: &mut [S; 0],
    ) {
        let minus_one = S::from_f64(-1.0);
        let two = S::from_f64(2.0);
        let one = S::from_f64(1.0);
        let t0 = q_j[3] * h[5] + h[4] * q_j[4] - h[3] * q_j[5];
        let t1 = q_j[3] * h[3] + q_j[5] * h[5] - q_j[6] * h[4];
        let t2 = h[5] * q_j[6] + (h[3] * q_j[4] + q_j[5] * h[4]);
        let t3 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[3] * t1 + q_j[4] * t2) - q_j[6] * t3;
        let t5 = q_i[3] * h[2] + h[1] * q_i[4] - h[0] * q_i[5];
        let t6 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t7 = h[2] * q_i[6] + (h[0] * q_i[4] + q_i[5] * h[1]);
        let t8 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t9 = q_i[5] * t5 + (q_i[3] * t6 + q_i[4] * t7) - q_i[6] * t8;
        let t10 = q_j[6] * t1 + (q_j[5] * t2 + (q_j[3] * t3 - q_j[4] * t0));
        let t11 = q_i[6] * t6 + (q_i[5] * t7 + (q_i[3] * t8 - q_i[4] * t5));
        let t12 = q_j[6] * t2 + (q_j[3] * t0 + q_j[4] * t3 - q_j[5] * t1);
        let t13 = q_i[6] * t7 + (q_i[3] * t5 + q_i[4] * t8 - q_i[5] * t6);
        let t14 = t6 * two;
        let t15 = -t14;
        let t16 = -(t7 * two);
        let t17 = t5 * two;
        let t18 = -t17;
        let t19 = t8 * two;
        let t20 = t1 * two;
        let t21 = t2 * two;
        let t22 = t0 * two;
        let t23 = t3 * two;
        let t24 = -t19;
        phi[0] = q_j[0] + t4 - q_i[0] - t9;
        phi[1] = q_j[1] + t10 - q_i[1] - t11;
        phi[2] = q_j[2] + t12 - q_i[2] - t13;
        phi_q[0] = minus_one;
        phi_q[1] = t15;
        phi_q[2] = t16;
        phi_q[3] = t18;
        phi_q[4] = t19;
        phi_q[5] = one;
        phi_q[6] = t20;
        phi_q[7] = t21;
        phi_q[8] = t22;
        phi_q[9] = -t23;
        phi_q[10] = minus_one;
        phi_q[11] = t24;
        phi_q[12] = t17;
        phi_q[13] = t16;
        phi_q[14] = t15;
        phi_q[15] = one;
        phi_q[16] = t23;
        phi_q[17] = -t22;
        phi_q[18] = t21;
        phi_q[19] = t20;
        phi_q[20] = minus_one;
        phi_q[21] = t18;
        phi_q[22] = t24;
        phi_q[23] = t14;
        phi_q[24] = t16;
        phi_q[25] = one;
        phi_q[26] = t22;
        phi_q[27] = t23;
        phi_q[28] = -t20;
        phi_q[29] = t21;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 69 additions, 89 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        lambda: &[S; 3],
        phi: &mut [S; 3],
        phi_q: &mut [S; 30],
        _work: &mut [S; 0],
        curvature: &mut [S; 20],
    ) {
        let minus_one = S::from_f64(-1.0);
        let two = S::from_f64(2.0);
        let one = S::from_f64(1.0);
        let t0 = q_j[4] * h[4] + (h[5] * q_j[3] - h[3] * q_j[5]);
        let t1 = h[5] * q_j[6] + (q_j[4] * h[3] + h[4] * q_j[5]);
        let t2 = h[5] * q_j[5] + (q_j[3] * h[3] - h[4] * q_j[6]);
        let t3 = q_j[6] * h[3] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[6] * t3));
        let t5 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t6 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t7 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t8 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t9 = q_i[5] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[6] * t8));
        let t10 = q_j[6] * t2 + (q_j[5] * t1 + (q_j[3] * t3 - q_j[4] * t0));
        let t11 = q_i[6] * t7 + (q_i[5] * t6 + (q_i[3] * t8 - q_i[4] * t5));
        let t12 = q_j[6] * t1 + (q_j[4] * t3 + (q_j[3] * t0 - q_j[5] * t2));
        let t13 = q_i[6] * t6 + (q_i[4] * t8 + (q_i[3] * t5 - q_i[5] * t7));
        let t14 = t7 * two;
        let t15 = -t14;
        let t16 = -(t6 * two);
        let t17 = t5 * two;
        let t18 = -t17;
        let t19 = t8 * two;
        let t20 = t2 * two;
        let t21 = t1 * two;
        let t22 = t0 * two;
        let t23 = t3 * two;
        let t24 = -t19;
        let t25 = lambda[0] * two;
        let t26 = h[0] * t25;
        let t27 = lambda[2] * two;
        let t28 = h[2] * t27;
        let t29 = lambda[1] * two;
        let t30 = h[1] * t29;
        let t31 = h[2] * t29;
        let t32 = h[1] * t27;
        let t33 = h[0] * t27;
        let t34 = h[2] * t25;
        let t35 = h[1] * t25;
        let t36 = h[0] * t29;
        let t37 = t28 - t30;
        let t38 = h[3] * t25;
        let t39 = h[5] * t27;
        let t40 = h[4] * t29;
        let t41 = h[4] * t27;
        let t42 = h[5] * t29;
        let t43 = h[5] * t25;
        let t44 = h[3] * t27;
        let t45 = h[4] * t25;
        let t46 = h[3] * t29;
        let t47 = t40 - t39;
        phi[0] = q_j[0] + t4 - q_i[0] - t9;
        phi[1] = q_j[1] + t10 - q_i[1] - t11;
        phi[2] = q_j[2] + t12 - q_i[2] - t13;
        phi_q[0] = minus_one;
        phi_q[1] = t15;
        phi_q[2] = t16;
        phi_q[3] = t18;
        phi_q[4] = t19;
        phi_q[5] = one;
        phi_q[6] = t20;
        phi_q[7] = t21;
        phi_q[8] = t22;
        phi_q[9] = -t23;
        phi_q[10] = minus_one;
        phi_q[11] = t24;
        phi_q[12] = t17;
        phi_q[13] = t16;
        phi_q[14] = t15;
        phi_q[15] = one;
        phi_q[16] = t23;
        phi_q[17] = -t22;
        phi_q[18] = t21;
        phi_q[19] = t20;
        phi_q[20] = minus_one;
        phi_q[21] = t18;
        phi_q[22] = t24;
        phi_q[23] = t14;
        phi_q[24] = t16;
        phi_q[25] = one;
        phi_q[26] = t22;
        phi_q[27] = t23;
        phi_q[28] = -t20;
        phi_q[29] = t21;
        curvature[0] = -t26 - t28 - t30;
        curvature[1] = t31 - t32;
        curvature[2] = t30 + (t28 - t26);
        curvature[3] = t33 - t34;
        curvature[4] = -t35 - t36;
        curvature[5] = t26 + t37;
        curvature[6] = t35 - t36;
        curvature[7] = -t34 - t33;
        curvature[8] = -t32 - t31;
        curvature[9] = t26 - t37;
        curvature[10] = t38 + (t39 + t40);
        curvature[11] = t41 - t42;
        curvature[12] = t38 - t39 - t40;
        curvature[13] = t43 - t44;
        curvature[14] = t45 + t46;
        curvature[15] = t47 - t38;
        curvature[16] = t46 - t45;
        curvature[17] = t44 + t43;
        curvature[18] = t42 + t41;
        curvature[19] = -t47 - t38;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 45 additions, 75 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        _h: &[S; 6],
        lambda: &[S; 3],
        phi_h: &mut [S; 18],
        force_h: &mut [S; 24],
    ) {
        let two = S::from_f64(2.0);
        let t0 = q_i[3] * q_i[3];
        let t1 = q_i[4] * q_i[4];
        let t2 = q_i[6] * q_i[6];
        let t3 = q_i[5] * q_i[5];
        let t4 = q_i[4] * q_i[5];
        let t5 = q_i[3] * q_i[6];
        let t6 = q_i[3] * q_i[5];
        let t7 = q_i[4] * q_i[6];
        let t8 = q_j[3] * q_j[3];
        let t9 = q_j[4] * q_j[4];
        let t10 = q_j[6] * q_j[6];
        let t11 = q_j[5] * q_j[5];
        let t12 = q_j[4] * q_j[5];
        let t13 = q_j[3] * q_j[6];
        let t14 = q_j[3] * q_j[5];
        let t15 = q_j[4] * q_j[6];
        let t16 = t0 - t1;
        let t17 = t3 - t2;
        let t18 = q_i[6] * q_i[5];
        let t19 = q_i[3] * q_i[4];
        let t20 = t8 - t9;
        let t21 = t11 - t10;
        let t22 = q_j[6] * q_j[5];
        let t23 = q_j[3] * q_j[4];
        let t24 = lambda[2] * two;
        let t25 = lambda[0] * two;
        let t26 = lambda[1] * two;
        let t27 = q_i[5] * t24 - q_i[3] * t25 - q_i[6] * t26;
        let t28 = q_i[6] * t25 - q_i[3] * t26 - q_i[4] * t24;
        let t29 = q_i[4] * t26 - q_i[3] * t24 - q_i[5] * t25;
        let t30 = -(q_i[4] * t25) - q_i[5] * t26 - q_i[6] * t24;
        let t31 = q_j[6] * t26;
        let t32 = q_j[3] * t25 - q_j[5] * t24;
        let t33 = t31 + t32;
        let t34 = q_j[4] * t24;
        let t35 = q_j[3] * t26 - q_j[6] * t25;
        let t36 = t34 + t35;
        let t37 = q_j[5] * t25;
        let t38 = q_j[3] * t24 - q_j[4] * t26;
        let t39 = t37 + t38;
        let t40 = q_j[6] * t24 + (q_j[4] * t25 + q_j[5] * t26);
        phi_h[0] = -(t0 + t1 - t2 - t3);
        phi_h[1] = -((t4 - t5) * two);
        phi_h[2] = -((t6 + t7) * two);
        phi_h[3] = t8 + t9 - t10 - t11;
        phi_h[4] = (t12 - t13) * two;
        phi_h[5] = (t14 + t15) * two;
        phi_h[6] = -((t5 + t4) * two);
        phi_h[7] = -(t16 + t17);
        phi_h[8] = -((t18 - t19) * two);
        phi_h[9] = (t13 + t12) * two;
        phi_h[10] = t20 + t21;
        phi_h[11] = (t22 - t23) * two;
        phi_h[12] = -((t7 - t6) * two);
        phi_h[13] = -((t19 + t18) * two);
        phi_h[14] = -(t16 - t17);
        phi_h[15] = (t15 - t14) * two;
        phi_h[16] = (t23 + t22) * two;
        phi_h[17] = t20 - t21;
        force_h[0] = t27;
        force_h[1] = t28;
        force_h[2] = t29;
        force_h[3] = t30;
        force_h[4] = t29;
        force_h[5] = -t28;
        force_h[6] = -t29;
        force_h[7] = t30;
        force_h[8] = t27;
        force_h[9] = t28;
        force_h[10] = -t27;
        force_h[11] = t30;
        force_h[12] = t33;
        force_h[13] = t36;
        force_h[14] = t39;
        force_h[15] = t40;
        force_h[16] = t39;
        force_h[17] = -t35 - t34;
        force_h[18] = -t38 - t37;
        force_h[19] = t40;
        force_h[20] = t33;
        force_h[21] = t36;
        force_h[22] = -t32 - t31;
        force_h[23] = t40;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 58 additions, 98 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 24],
        rate_h: &mut [S; 18],
    ) {
        let two = S::from_f64(2.0);
        let t0 = (h[2] * v_i[5] + (h[0] * v_i[3] - h[1] * v_i[6])) * two;
        let t1 = -t0;
        let t2 = -((v_i[6] * h[2] + (h[0] * v_i[4] + h[1] * v_i[5])) * two);
        let t3 = (v_i[3] * h[2] + (h[1] * v_i[4] - h[0] * v_i[5])) * two;
        let t4 = -t3;
        let t5 = (h[0] * v_i[6] + v_i[3] * h[1] - h[2] * v_i[4]) * two;
        let t6 = (h[5] * v_j[5] + (h[3] * v_j[3] - h[4] * v_j[6])) * two;
        let t7 = (v_j[6] * h[5] + (h[3] * v_j[4] + h[4] * v_j[5])) * two;
        let t8 = (v_j[3] * h[5] + (h[4] * v_j[4] - h[3] * v_j[5])) * two;
        let t9 = (h[3] * v_j[6] + v_j[3] * h[4] - h[5] * v_j[4]) * two;
        let t10 = -t5;
        let t11 = v_i[3] * q_i[3];
        let t12 = v_i[4] * q_i[4];
        let t13 = v_i[5] * q_i[5];
        let t14 = v_i[6] * q_i[6];
        let t15 = v_i[5] * q_i[4] + v_i[4] * q_i[5];
        let t16 = v_i[6] * q_i[3] + v_i[3] * q_i[6];
        let t17 = v_i[6] * q_i[4] + v_i[4] * q_i[6];
        let t18 = v_i[5] * q_i[3] + v_i[3] * q_i[5];
        let t19 = v_j[3] * q_j[3];
        let t20 = v_j[4] * q_j[4];
        let t21 = v_j[5] * q_j[5];
        let t22 = v_j[6] * q_j[6];
        let t23 = v_j[5] * q_j[4] + v_j[4] * q_j[5];
        let t24 = v_j[6] * q_j[3] + v_j[3] * q_j[6];
        let t25 = v_j[6] * q_j[4] + v_j[4] * q_j[6];
        let t26 = v_j[5] * q_j[3] + v_j[3] * q_j[5];
        let t27 = v_i[6] * q_i[5] + v_i[5] * q_i[6];
        let t28 = v_i[4] * q_i[3] + v_i[3] * q_i[4];
        let t29 = v_j[6] * q_j[5] + v_j[5] * q_j[6];
        let t30 = v_j[4] * q_j[3] + v_j[3] * q_j[4];
        rate_q[0] = t1;
        rate_q[1] = t2;
        rate_q[2] = t4;
        rate_q[3] = t5;
        rate_q[4] = t6;
        rate_q[5] = t7;
        rate_q[6] = t8;
        rate_q[7] = -t9;
        rate_q[8] = t10;
        rate_q[9] = t3;
        rate_q[10] = t2;
        rate_q[11] = t1;
        rate_q[12] = t9;
        rate_q[13] = -t8;
        rate_q[14] = t7;
        rate_q[15] = t6;
        rate_q[16] = t4;
        rate_q[17] = t10;
        rate_q[18] = t0;
        rate_q[19] = t2;
        rate_q[20] = t8;
        rate_q[21] = t9;
        rate_q[22] = -t6;
        rate_q[23] = t7;
        rate_h[0] = -((t11 + t12 - (t13 + t14)) * two);
        rate_h[1] = -((t15 - t16) * two);
        rate_h[2] = -((t17 + t18) * two);
        rate_h[3] = (t19 + t20 - (t21 + t22)) * two;
        rate_h[4] = (t23 - t24) * two;
        rate_h[5] = (t25 + t26) * two;
        rate_h[6] = -((t16 + t15) * two);
        rate_h[7] = -((t11 + t13 - (t12 + t14)) * two);
        rate_h[8] = -((t27 - t28) * two);
        rate_h[9] = (t24 + t23) * two;
        rate_h[10] = (t19 + t21 - (t20 + t22)) * two;
        rate_h[11] = (t29 - t30) * two;
        rate_h[12] = -((t17 - t18) * two);
        rate_h[13] = -((t28 + t27) * two);
        rate_h[14] = -((t11 + t14 - (t12 + t13)) * two);
        rate_h[15] = (t25 - t26) * two;
        rate_h[16] = (t30 + t29) * two;
        rate_h[17] = (t19 + t22 - (t20 + t21)) * two;
    }
}
