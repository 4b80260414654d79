// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Orthogonal, type 1
///
/// `(A_i u_i)ᵀ (A_j v_j) = 0` (unit 1)
///
/// Source: method paper, eq. (13)–(15).
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `u_i` | 1 | body i | direction that stays normal to v_j |
/// | 3..6 | `v_j` | 1 | body j | direction that stays normal to u_i |
pub mod orthogonal_1 {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "orthogonal_1",
        title: "Orthogonal, type 1",
        equation: "(A_i u_i)ᵀ (A_j v_j) = 0",
        reference: "method paper, eq. (13)–(15)",
        bodies: 2,
        equations: 1,
        unit: "1",
        parameters: &[
            Parameter {
                name: "u_i",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "body i",
                meaning: "direction that stays normal to v_j",
            },
            Parameter {
                name: "v_j",
                size: 3,
                offset: 3,
                unit: "1",
                frame: "body j",
                meaning: "direction that stays normal to u_i",
            },
        ],
        jacobian: &[(0, 3), (0, 4), (0, 5), (0, 6), (0, 10), (0, 11), (0, 12), (0, 13)],
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
            (10, 3),
            (10, 4),
            (10, 5),
            (10, 6),
            (10, 10),
            (11, 3),
            (11, 4),
            (11, 5),
            (11, 6),
            (11, 10),
            (11, 11),
            (12, 3),
            (12, 4),
            (12, 5),
            (12, 6),
            (12, 10),
            (12, 11),
            (12, 12),
            (13, 3),
            (13, 4),
            (13, 5),
            (13, 6),
            (13, 10),
            (13, 11),
            (13, 12),
            (13, 13),
        ],
        design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5)],
        force_design: &[
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
            (10, 0),
            (10, 1),
            (10, 2),
            (10, 3),
            (10, 4),
            (10, 5),
            (11, 0),
            (11, 1),
            (11, 2),
            (11, 3),
            (11, 4),
            (11, 5),
            (12, 0),
            (12, 1),
            (12, 2),
            (12, 3),
            (12, 4),
            (12, 5),
            (13, 0),
            (13, 1),
            (13, 2),
            (13, 3),
            (13, 4),
            (13, 5),
        ],
        rate: &[(0, 3), (0, 4), (0, 5), (0, 6), (0, 10), (0, 11), (0, 12), (0, 13)],
        rate_design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5)],
        operations: [
            Operations {
                additions: 36,
                multiplications: 51,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 52,
                multiplications: 83,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 102,
                multiplications: 144,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 142,
                multiplications: 244,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 234,
                multiplications: 276,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Orthogonal, type 1
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Orthogonal1;
    impl<S: Scalar> Relation<S> for Orthogonal1 {
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
    /// 36 additions, 51 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        phi: &mut [S; 1],
    ) {
        let t0 = h[2] * q_i[6] + (h[0] * q_i[4] + q_i[5] * h[1]);
        let t1 = q_i[3] * h[2] + h[1] * q_i[4] - h[0] * q_i[5];
        let t2 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t3 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = h[5] * q_j[6] + (h[3] * q_j[4] + q_j[5] * h[4]);
        let t6 = q_j[3] * h[5] + h[4] * q_j[4] - h[3] * q_j[5];
        let t7 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t8 = q_j[3] * h[3] + q_j[5] * h[5] - q_j[6] * h[4];
        let t9 = q_j[6] * t5 + (q_j[3] * t6 + q_j[4] * t7 - q_j[5] * t8);
        let t10 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t11 = q_j[5] * t6 + (q_j[3] * t8 + q_j[4] * t5) - q_j[6] * t7;
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t7 - q_j[4] * t6));
        phi[0] = t4 * t9 + (t10 * t11 + t12 * t13);
    }
    /// Φ, Φ_q and W.
    ///
    /// 52 additions, 83 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        phi: &mut [S; 1],
        phi_q: &mut [S; 8],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let t0 = q_i[6] * h[2] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t1 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t2 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t3 = h[2] * q_i[5] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = q_j[6] * h[5] + (q_j[4] * h[3] + h[4] * q_j[5]);
        let t6 = q_j[6] * h[3] + (q_j[3] * h[4] - q_j[4] * h[5]);
        let t7 = q_j[4] * h[4] + (h[5] * q_j[3] - h[3] * q_j[5]);
        let t8 = h[5] * q_j[5] + (q_j[3] * h[3] - q_j[6] * h[4]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t11 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        phi[0] = t4 * t9 + (t10 * t11 + t12 * t13);
        phi_q[0] = (t1 * t13 + (t2 * t9 + t3 * t11)) * two;
        phi_q[1] = (t1 * t9 + (t0 * t11 - t2 * t13)) * two;
        phi_q[2] = (t0 * t13 + (t2 * t11 - t3 * t9)) * two;
        phi_q[3] = (t3 * t13 + (t0 * t9 - t1 * t11)) * two;
        phi_q[4] = (t6 * t12 + (t7 * t4 + t10 * t8)) * two;
        phi_q[5] = (t6 * t4 + (t10 * t5 - t7 * t12)) * two;
        phi_q[6] = (t5 * t12 + (t10 * t7 - t8 * t4)) * two;
        phi_q[7] = (t5 * t4 + (t8 * t12 - t10 * t6)) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 102 additions, 144 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 8],
        _work: &mut [S; 0],
        curvature: &mut [S; 36],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t1 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t2 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t3 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = h[5] * q_j[6] + (q_j[4] * h[3] + h[4] * q_j[5]);
        let t6 = q_j[6] * h[3] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t7 = q_j[4] * h[4] + (h[5] * q_j[3] - h[3] * q_j[5]);
        let t8 = h[5] * q_j[5] + (q_j[3] * h[3] - h[4] * q_j[6]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t11 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        let t14 = t9 * two;
        let t15 = t11 * two;
        let t16 = t13 * two;
        let t17 = t4 * two;
        let t18 = t10 * two;
        let t19 = t12 * two;
        let t20 = t5 * two;
        let t21 = t11 * lambda[0] * two;
        let t22 = h[0] * t21;
        let t23 = t9 * lambda[0] * two;
        let t24 = h[2] * t23;
        let t25 = t13 * lambda[0] * two;
        let t26 = h[1] * t25;
        let t27 = h[1] * t23;
        let t28 = h[2] * t25;
        let t29 = h[2] * t21;
        let t30 = h[0] * t23;
        let t31 = h[1] * t21;
        let t32 = h[0] * t25;
        let t33 = t26 - t24;
        let t34 = t3 * lambda[0] * k4;
        let t35 = t8 * t34;
        let t36 = t2 * lambda[0] * k4;
        let t37 = t7 * t36;
        let t38 = t1 * lambda[0] * k4;
        let t39 = t6 * t38;
        let t40 = t37 + t39;
        let t41 = t7 * t38;
        let t42 = t0 * lambda[0] * k4;
        let t43 = t8 * t42;
        let t44 = t6 * t36;
        let t45 = t43 - t44;
        let t46 = t8 * t36;
        let t47 = t6 * t42;
        let t48 = t7 * t34;
        let t49 = t47 - t48;
        let t50 = t6 * t34;
        let t51 = t7 * t42;
        let t52 = t8 * t38;
        let t53 = t51 - t52;
        let t54 = t10 * lambda[0] * two;
        let t55 = h[3] * t54;
        let t56 = t4 * lambda[0] * two;
        let t57 = h[5] * t56;
        let t58 = t12 * lambda[0] * two;
        let t59 = h[4] * t58;
        let t60 = t5 * t34;
        let t61 = t60 - t41;
        let t62 = t5 * t42;
        let t63 = t5 * t36;
        let t64 = t63 - t50;
        let t65 = t5 * t38;
        let t66 = h[4] * t56;
        let t67 = h[5] * t58;
        let t68 = t65 - t46;
        let t69 = t35 + t62;
        let t70 = h[5] * t54;
        let t71 = h[3] * t56;
        let t72 = h[4] * t54;
        let t73 = h[3] * t58;
        let t74 = t59 - t57;
        phi[0] = t4 * t9 + (t10 * t11 + t12 * t13);
        phi_q[0] = t2 * t14 + (t3 * t15 + t1 * t16);
        phi_q[1] = t1 * t14 + (t0 * t15 - t2 * t13 * two);
        phi_q[2] = t2 * t15 + (t0 * t16 - t3 * t9 * two);
        phi_q[3] = t3 * t16 + (t0 * t14 - t1 * t11 * two);
        phi_q[4] = t7 * t17 + (t8 * t18 + t6 * t19);
        phi_q[5] = t6 * t17 + (t10 * t20 - t7 * t12 * two);
        phi_q[6] = t12 * t20 + (t7 * t18 - t8 * t4 * two);
        phi_q[7] = t4 * t20 + (t8 * t19 - t10 * t6 * two);
        curvature[0] = t22 + (t24 + t26);
        curvature[1] = t27 - t28;
        curvature[2] = t22 - t24 - t26;
        curvature[3] = t29 - t30;
        curvature[4] = t31 + t32;
        curvature[5] = t33 - t22;
        curvature[6] = t32 - t31;
        curvature[7] = t30 + t29;
        curvature[8] = t28 + t27;
        curvature[9] = -t33 - t22;
        curvature[10] = t35 + t40;
        curvature[11] = t41 + t45;
        curvature[12] = t46 + t49;
        curvature[13] = t50 + t53;
        curvature[14] = t55 + (t57 + t59);
        curvature[15] = t44 + t61;
        curvature[16] = t40 + t62;
        curvature[17] = t64 - t51;
        curvature[18] = t49 - t65;
        curvature[19] = t66 - t67;
        curvature[20] = t55 - t57 - t59;
        curvature[21] = t48 + t68;
        curvature[22] = t53 - t63;
        curvature[23] = t37 + t69;
        curvature[24] = t61 - t43;
        curvature[25] = t70 - t71;
        curvature[26] = t72 + t73;
        curvature[27] = t74 - t55;
        curvature[28] = t52 + t64;
        curvature[29] = t68 - t47;
        curvature[30] = t45 - t60;
        curvature[31] = t39 + t69;
        curvature[32] = t73 - t72;
        curvature[33] = t71 + t70;
        curvature[34] = t67 + t66;
        curvature[35] = -t74 - t55;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 142 additions, 244 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        lambda: &[S; 1],
        phi_h: &mut [S; 6],
        force_h: &mut [S; 48],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_j[4] * h[4] + (q_j[3] * h[5] - h[3] * q_j[5]);
        let t1 = h[5] * q_j[6] + (h[3] * q_j[4] + q_j[5] * h[4]);
        let t2 = q_j[5] * h[5] + (h[3] * q_j[3] - h[4] * q_j[6]);
        let t3 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[6] * t3));
        let t5 = q_i[3] * q_i[3];
        let t6 = q_i[4] * q_i[4];
        let t7 = q_i[6] * q_i[6];
        let t8 = q_i[5] * q_i[5];
        let t9 = t5 + t6 - t7 - t8;
        let t10 = q_i[3] * q_i[6];
        let t11 = q_i[4] * q_i[5];
        let t12 = t10 + t11;
        let t13 = q_j[6] * t2 + (q_j[5] * t1 + (q_j[3] * t3 - q_j[4] * t0));
        let t14 = t13 * two;
        let t15 = q_i[6] * q_i[4];
        let t16 = q_i[3] * q_i[5];
        let t17 = t15 - t16;
        let t18 = q_j[6] * t1 + (q_j[4] * t3 + (q_j[3] * t0 - q_j[5] * t2));
        let t19 = t18 * two;
        let t20 = t5 - t6;
        let t21 = t8 - t7;
        let t22 = t20 + t21;
        let t23 = t11 - t10;
        let t24 = t4 * two;
        let t25 = q_i[3] * q_i[4];
        let t26 = q_i[6] * q_i[5];
        let t27 = t25 + t26;
        let t28 = t20 - t21;
        let t29 = t16 + t15;
        let t30 = t26 - t25;
        let t31 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t32 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t33 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t34 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t35 = q_i[5] * t31 + (q_i[4] * t32 + (q_i[3] * t33 - q_i[6] * t34));
        let t36 = q_j[3] * q_j[3];
        let t37 = q_j[4] * q_j[4];
        let t38 = q_j[6] * q_j[6];
        let t39 = q_j[5] * q_j[5];
        let t40 = t36 + t37 - t38 - t39;
        let t41 = q_j[3] * q_j[6];
        let t42 = q_j[5] * q_j[4];
        let t43 = t41 + t42;
        let t44 = q_i[6] * t33 + (q_i[5] * t32 + (q_i[3] * t34 - q_i[4] * t31));
        let t45 = t44 * two;
        let t46 = q_j[4] * q_j[6];
        let t47 = q_j[5] * q_j[3];
        let t48 = t46 - t47;
        let t49 = q_i[6] * t32 + (q_i[4] * t34 + (q_i[3] * t31 - q_i[5] * t33));
        let t50 = t49 * two;
        let t51 = t36 - t37;
        let t52 = t39 - t38;
        let t53 = t51 + t52;
        let t54 = t42 - t41;
        let t55 = t35 * two;
        let t56 = q_j[3] * q_j[4];
        let t57 = q_j[5] * q_j[6];
        let t58 = t56 + t57;
        let t59 = t51 - t52;
        let t60 = t47 + t46;
        let t61 = t57 - t56;
        let t62 = t13 * lambda[0] * two;
        let t63 = q_i[6] * t62;
        let t64 = t4 * lambda[0] * two;
        let t65 = t18 * lambda[0] * two;
        let t66 = q_i[3] * t64 - q_i[5] * t65;
        let t67 = t63 + t66;
        let t68 = q_i[4] * t65;
        let t69 = q_i[3] * t62 - q_i[6] * t64;
        let t70 = t68 + t69;
        let t71 = q_i[5] * t64;
        let t72 = q_i[3] * t65 - q_i[4] * t62;
        let t73 = t71 + t72;
        let t74 = t48 * lambda[0];
        let t75 = t31 * k4;
        let t76 = t40 * lambda[0];
        let t77 = t76 * two;
        let t78 = t43 * lambda[0];
        let t79 = t34 * k4;
        let t80 = t58 * lambda[0];
        let t81 = t53 * lambda[0];
        let t82 = t81 * two;
        let t83 = t54 * lambda[0];
        let t84 = t33 * k4;
        let t85 = t61 * lambda[0];
        let t86 = t59 * lambda[0];
        let t87 = t86 * two;
        let t88 = t60 * lambda[0];
        let t89 = q_i[6] * t65 + (q_i[4] * t64 + q_i[5] * t62);
        let t90 = t32 * k4;
        let t91 = t17 * lambda[0];
        let t92 = t0 * k4;
        let t93 = t9 * lambda[0];
        let t94 = t93 * two;
        let t95 = t12 * lambda[0];
        let t96 = t3 * k4;
        let t97 = t27 * lambda[0];
        let t98 = t22 * lambda[0];
        let t99 = t98 * two;
        let t100 = t23 * lambda[0];
        let t101 = t2 * k4;
        let t102 = t30 * lambda[0];
        let t103 = t28 * lambda[0];
        let t104 = t103 * two;
        let t105 = t29 * lambda[0];
        let t106 = t44 * lambda[0] * two;
        let t107 = q_j[6] * t106;
        let t108 = t35 * lambda[0] * two;
        let t109 = t49 * lambda[0] * two;
        let t110 = q_j[3] * t108 - q_j[5] * t109;
        let t111 = t107 + t110;
        let t112 = q_j[4] * t109;
        let t113 = q_j[3] * t106 - q_j[6] * t108;
        let t114 = t112 + t113;
        let t115 = q_j[5] * t108;
        let t116 = q_j[3] * t109 - q_j[4] * t106;
        let t117 = t115 + t116;
        let t118 = t1 * k4;
        let t119 = q_j[6] * t109 + (q_j[4] * t108 + q_j[5] * t106);
        phi_h[0] = t4 * t9 + (t12 * t14 + t17 * t19);
        phi_h[1] = t13 * t22 + (t23 * t24 + t19 * t27);
        phi_h[2] = t18 * t28 + (t24 * t29 + t14 * t30);
        phi_h[3] = t35 * t40 + (t43 * t45 + t48 * t50);
        phi_h[4] = t44 * t53 + (t54 * t55 + t50 * t58);
        phi_h[5] = t49 * t59 + (t55 * t60 + t45 * t61);
        force_h[0] = t67;
        force_h[1] = t70;
        force_h[2] = t73;
        force_h[3] = t74 * t75 + (t33 * t77 + t78 * t79);
        force_h[4] = t75 * t80 + (t34 * t82 + t83 * t84);
        force_h[5] = t79 * t85 + (t31 * t87 + t84 * t88);
        force_h[6] = t89;
        force_h[7] = t73;
        force_h[8] = -t69 - t68;
        force_h[9] = t79 * t74 + (t32 * t77 - t78 * t75);
        force_h[10] = t79 * t80 + (t83 * t90 - t31 * t81 * two);
        force_h[11] = t88 * t90 + (t34 * t87 - t75 * t85);
        force_h[12] = -t72 - t71;
        force_h[13] = t89;
        force_h[14] = t67;
        force_h[15] = t78 * t90 + (t31 * t77 - t74 * t84);
        force_h[16] = t75 * t83 + (t32 * t82 - t84 * t80);
        force_h[17] = t75 * t88 + (t85 * t90 - t33 * t86 * two);
        force_h[18] = t70;
        force_h[19] = -t66 - t63;
        force_h[20] = t89;
        force_h[21] = t78 * t84 + (t74 * t90 - t34 * t76 * two);
        force_h[22] = t80 * t90 + (t33 * t82 - t79 * t83);
        force_h[23] = t84 * t85 + (t32 * t87 - t79 * t88);
        force_h[24] = t91 * t92 + (t2 * t94 + t95 * t96);
        force_h[25] = t92 * t97 + (t3 * t99 + t100 * t101);
        force_h[26] = t96 * t102 + (t0 * t104 + t101 * t105);
        force_h[27] = t111;
        force_h[28] = t114;
        force_h[29] = t117;
        force_h[30] = t96 * t91 + (t1 * t94 - t95 * t92);
        force_h[31] = t96 * t97 + (t100 * t118 - t0 * t98 * two);
        force_h[32] = t105 * t118 + (t3 * t104 - t92 * t102);
        force_h[33] = t119;
        force_h[34] = t117;
        force_h[35] = -t113 - t112;
        force_h[36] = t95 * t118 + (t0 * t94 - t91 * t101);
        force_h[37] = t92 * t100 + (t1 * t99 - t101 * t97);
        force_h[38] = t92 * t105 + (t102 * t118 - t2 * t103 * two);
        force_h[39] = -t116 - t115;
        force_h[40] = t119;
        force_h[41] = t111;
        force_h[42] = t95 * t101 + (t91 * t118 - t3 * t93 * two);
        force_h[43] = t97 * t118 + (t2 * t99 - t96 * t100);
        force_h[44] = t101 * t102 + (t1 * t104 - t96 * t105);
        force_h[45] = t114;
        force_h[46] = -t110 - t107;
        force_h[47] = t119;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 234 additions, 276 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 6],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 8],
        rate_h: &mut [S; 6],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[5] * q_j[6] + (h[3] * q_j[4] + h[4] * q_j[5]);
        let t1 = q_j[3] * h[5] + h[4] * q_j[4] - h[3] * q_j[5];
        let t2 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t3 = q_j[3] * h[3] + h[5] * q_j[5] - h[4] * q_j[6];
        let t4 = q_j[6] * t0 + (q_j[3] * t1 + q_j[4] * t2 - q_j[5] * t3);
        let t5 = h[2] * v_i[3] + (h[1] * v_i[4] - h[0] * v_i[5]);
        let t6 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t7 = h[0] * v_i[6] + h[1] * v_i[3] - h[2] * v_i[4];
        let t8 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t9 = h[2] * v_i[5] + (h[0] * v_i[3] - h[1] * v_i[6]);
        let t10 = q_i[3] * h[2] + h[1] * q_i[4] - h[0] * q_i[5];
        let t11 = v_j[6] * h[5] + (h[3] * v_j[4] + h[4] * v_j[5]);
        let t12 = v_j[3] * h[5] + (h[4] * v_j[4] - h[3] * v_j[5]);
        let t13 = h[3] * v_j[6] + v_j[3] * h[4] - h[5] * v_j[4];
        let t14 = v_j[3] * t1 + (t11 * q_j[6] + (q_j[3] * t12 + q_j[4] * t13));
        let t15 = h[5] * v_j[5] + (h[3] * v_j[3] - h[4] * v_j[6]);
        let t16 = v_j[6] * t0 + (v_j[4] * t2 + t14) - (t15 * q_j[5] + v_j[5] * t3);
        let t17 = q_i[3] * h[0] + q_i[5] * h[2] - h[1] * q_i[6];
        let t18 = v_j[3] * t3 + (q_j[5] * t12 + (q_j[3] * t15 + q_j[4] * t11));
        let t19 = v_j[5] * t1 + (v_j[4] * t0 + t18) - (q_j[6] * t13 + v_j[6] * t2);
        let t20 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t21 = v_j[3] * t2 + (t15 * q_j[6] + (q_j[3] * t13 + t11 * q_j[5]));
        let t22 = v_j[6] * t3 + (v_j[5] * t0 + t21) - (q_j[4] * t12 + v_j[4] * t1);
        let t23 = t8 * t9 + (t10 * t16 + (t17 * t19 + t20 * t22));
        let t24 = h[2] * v_i[6] + (h[0] * v_i[4] + h[1] * v_i[5]);
        let t25 = h[2] * q_i[6] + (h[0] * q_i[4] + q_i[5] * h[1]);
        let t26 = t7 * t4 + (t8 * t24 + (t19 * t25 + t20 * t16));
        let t27 = t6 * t24 + (t8 * t5 + (t22 * t25 + t19 * t10));
        let t28 = t4 * t24 + (t9 * t6 + (t16 * t25 + t17 * t22));
        let t29 = t10 * v_i[3] + (q_i[6] * t24 + (q_i[3] * t5 + q_i[4] * t7));
        let t30 = v_i[6] * t25 + (t20 * v_i[4] + t29) - (q_i[5] * t9 + t17 * v_i[5]);
        let t31 = t20 * v_i[3] + (q_i[6] * t9 + (q_i[3] * t7 + q_i[5] * t24));
        let t32 = t17 * v_i[6] + (v_i[5] * t25 + t31) - (q_i[4] * t5 + t10 * v_i[4]);
        let t33 = t17 * v_i[3] + (q_i[5] * t5 + (q_i[3] * t9 + q_i[4] * t24));
        let t34 = t10 * v_i[5] + (v_i[4] * t25 + t33) - (q_i[6] * t7 + t20 * v_i[6]);
        let t35 = q_i[6] * t25 + (q_i[3] * t10 + q_i[4] * t20 - q_i[5] * t17);
        let t36 = q_i[5] * t10 + (q_i[3] * t17 + q_i[4] * t25) - q_i[6] * t20;
        let t37 = q_i[6] * t17 + (q_i[5] * t25 + (q_i[3] * t20 - q_i[4] * t10));
        let t38 = t3 * t34 + (t12 * t35 + (t15 * t36 + t13 * t37));
        let t39 = t2 * t30 + (t0 * t34 + (t11 * t36 + t13 * t35));
        let t40 = t1 * t34 + (t0 * t32 + (t12 * t36 + t11 * t37));
        let t41 = t3 * t32 + (t0 * t30 + (t15 * t37 + t11 * t35));
        let t42 = q_i[4] * q_i[4];
        let t43 = q_i[3] * q_i[3];
        let t44 = q_i[5] * q_i[5];
        let t45 = q_i[6] * q_i[6];
        let t46 = q_i[6] * q_i[4];
        let t47 = q_i[3] * q_i[5];
        let t48 = q_i[3] * q_i[6];
        let t49 = q_i[5] * q_i[4];
        let t50 = q_i[4] * v_i[6] + q_i[6] * v_i[4];
        let t51 = q_i[3] * v_i[5] + q_i[5] * v_i[3];
        let t52 = q_i[3] * v_i[3];
        let t53 = q_i[4] * v_i[4];
        let t54 = q_i[5] * v_i[5];
        let t55 = q_i[6] * v_i[6];
        let t56 = q_i[4] * v_i[5] + q_i[5] * v_i[4];
        let t57 = q_i[3] * v_i[6] + q_i[6] * v_i[3];
        let t58 = t8 * (t52 + t53 - (t54 + t55)) + t6 * (t56 + t57);
        let t59 = t16 * (t46 - t47) + (t22 * (t48 + t49) + (t4 * (t50 - t51) + t58));
        let t60 = q_i[3] * q_i[4];
        let t61 = q_i[5] * q_i[6];
        let t62 = q_i[5] * v_i[6] + q_i[6] * v_i[5];
        let t63 = q_i[3] * v_i[4] + q_i[4] * v_i[3];
        let t64 = t8 * (t56 - t57) + t6 * (t52 + t54 - (t53 + t55));
        let t65 = t16 * (t60 + t61) + (t19 * (t49 - t48) + (t4 * (t62 + t63) + t64));
        let t66 = t4 * (t52 + t55 - (t53 + t54)) + (t8 * (t51 + t50) + t6 * (t62 - t63));
        let t67 = (t22 * (t61 - t60) + (t19 * (t47 + t46) + t66)) * two;
        let t68 = q_j[4] * q_j[4];
        let t69 = q_j[3] * q_j[3];
        let t70 = q_j[5] * q_j[5];
        let t71 = q_j[6] * q_j[6];
        let t72 = q_j[4] * q_j[6];
        let t73 = q_j[3] * q_j[5];
        let t74 = q_j[3] * q_j[6];
        let t75 = q_j[4] * q_j[5];
        let t76 = v_j[6] * q_j[4] + v_j[4] * q_j[6];
        let t77 = q_j[3] * v_j[5] + v_j[3] * q_j[5];
        let t78 = q_j[3] * v_j[3];
        let t79 = q_j[4] * v_j[4];
        let t80 = v_j[5] * q_j[5];
        let t81 = v_j[6] * q_j[6];
        let t82 = v_j[5] * q_j[4] + v_j[4] * q_j[5];
        let t83 = q_j[3] * v_j[6] + v_j[3] * q_j[6];
        let t84 = t36 * (t78 + t79 - (t80 + t81)) + t37 * (t82 + t83);
        let t85 = t30 * (t72 - t73) + (t32 * (t74 + t75) + (t35 * (t76 - t77) + t84));
        let t86 = q_j[3] * q_j[4];
        let t87 = q_j[5] * q_j[6];
        let t88 = v_j[6] * q_j[5] + v_j[5] * q_j[6];
        let t89 = q_j[3] * v_j[4] + v_j[3] * q_j[4];
        let t90 = t36 * (t82 - t83) + t37 * (t78 + t80 - (t79 + t81));
        let t91 = t30 * (t86 + t87) + (t34 * (t75 - t74) + (t35 * (t88 + t89) + t90));
        let t92 = t35 * (t78 + t81 - (t79 + t80))
            + (t36 * (t77 + t76) + t37 * (t88 - t89));
        let t93 = (t32 * (t87 - t86) + (t34 * (t73 + t72) + t92)) * two;
        rate_q[0] = (t4 * t5 + (t6 * t7 + t23)) * two;
        rate_q[1] = t26 * two - (t22 * t10 + t6 * t5) * two;
        rate_q[2] = t27 * two - (t17 * t16 + t9 * t4) * two;
        rate_q[3] = t28 * two - (t19 * t20 + t8 * t7) * two;
        rate_q[4] = (t1 * t30 + (t2 * t32 + t38)) * two;
        rate_q[5] = t39 * two - (t12 * t37 + t1 * t32) * two;
        rate_q[6] = t40 * two - (t15 * t35 + t3 * t30) * two;
        rate_q[7] = t41 * two - (t13 * t36 + t2 * t34) * two;
        rate_h[0] = t19 * (t42 + (t43 - (t44 + t45))) + t59 * two;
        rate_h[1] = t22 * (t44 + t43 - (t45 + t42)) + t65 * two;
        rate_h[2] = t16 * (t45 + t43 - (t44 + t42)) + t67;
        rate_h[3] = t34 * (t68 + (t69 - (t70 + t71))) + t85 * two;
        rate_h[4] = t32 * (t70 + t69 - (t71 + t68)) + t91 * two;
        rate_h[5] = t30 * (t71 + t69 - (t70 + t68)) + t93;
    }
}
