// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Constant distance, squared
///
/// `d_ijᵀ d_ij − l² = 0, d_ij = r_j + A_j s_j − r_i − A_i s_i` (unit m^2)
///
/// Source: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.1.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `s_i` | m | body i | first end |
/// | 3..6 | `s_j` | m | body j | second end |
/// | 6 | `length` | m |  | distance of the ends, not zero |
pub mod squared_distance {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "squared_distance",
        title: "Constant distance, squared",
        equation: "d_ijᵀ d_ij − l² = 0, d_ij = r_j + A_j s_j − r_i − A_i s_i",
        reference: "Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.1",
        bodies: 2,
        equations: 1,
        unit: "m^2",
        parameters: &[
            Parameter {
                name: "s_i",
                size: 3,
                offset: 0,
                unit: "m",
                frame: "body i",
                meaning: "first end",
            },
            Parameter {
                name: "s_j",
                size: 3,
                offset: 3,
                unit: "m",
                frame: "body j",
                meaning: "second end",
            },
            Parameter {
                name: "length",
                size: 1,
                offset: 6,
                unit: "m",
                frame: "",
                meaning: "distance of the ends, not zero",
            },
        ],
        jacobian: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 7),
            (0, 8),
            (0, 9),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
        ],
        work: &[],
        curvature: &[
            (0, 0),
            (1, 1),
            (2, 2),
            (3, 0),
            (3, 1),
            (3, 2),
            (3, 3),
            (4, 0),
            (4, 1),
            (4, 2),
            (4, 3),
            (4, 4),
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
            (6, 6),
            (7, 0),
            (7, 3),
            (7, 4),
            (7, 5),
            (7, 6),
            (7, 7),
            (8, 1),
            (8, 3),
            (8, 4),
            (8, 5),
            (8, 6),
            (8, 8),
            (9, 2),
            (9, 3),
            (9, 4),
            (9, 5),
            (9, 6),
            (9, 9),
            (10, 0),
            (10, 1),
            (10, 2),
            (10, 3),
            (10, 4),
            (10, 5),
            (10, 6),
            (10, 7),
            (10, 8),
            (10, 9),
            (10, 10),
            (11, 0),
            (11, 1),
            (11, 2),
            (11, 3),
            (11, 4),
            (11, 5),
            (11, 6),
            (11, 7),
            (11, 8),
            (11, 9),
            (11, 10),
            (11, 11),
            (12, 0),
            (12, 1),
            (12, 2),
            (12, 3),
            (12, 4),
            (12, 5),
            (12, 6),
            (12, 7),
            (12, 8),
            (12, 9),
            (12, 10),
            (12, 11),
            (12, 12),
            (13, 0),
            (13, 1),
            (13, 2),
            (13, 3),
            (13, 4),
            (13, 5),
            (13, 6),
            (13, 7),
            (13, 8),
            (13, 9),
            (13, 10),
            (13, 11),
            (13, 12),
            (13, 13),
        ],
        design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
        force_design: &[
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
            (7, 0),
            (7, 1),
            (7, 2),
            (7, 3),
            (7, 4),
            (7, 5),
            (8, 0),
            (8, 1),
            (8, 2),
            (8, 3),
            (8, 4),
            (8, 5),
            (9, 0),
            (9, 1),
            (9, 2),
            (9, 3),
            (9, 4),
            (9, 5),
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
        rate: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 7),
            (0, 8),
            (0, 9),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
        ],
        rate_design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5)],
        operations: [
            Operations {
                additions: 46,
                multiplications: 52,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 62,
                multiplications: 86,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 162,
                multiplications: 210,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 229,
                multiplications: 351,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 252,
                multiplications: 272,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Constant distance, squared
    #[derive(Clone, Copy, Debug, Default)]
    pub struct SquaredDistance;
    impl<S: Scalar> Relation<S> for SquaredDistance {
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
    /// 46 additions, 52 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        phi: &mut [S; 1],
    ) {
        let t0 = h[5] * q_j[6] + (h[3] * q_j[4] + q_j[5] * h[4]);
        let t1 = q_j[3] * h[5] + h[4] * q_j[4] - h[3] * q_j[5];
        let t2 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t3 = q_j[3] * h[3] + q_j[5] * h[5] - q_j[6] * h[4];
        let t4 = q_j[6] * t0 + (q_j[3] * t1 + q_j[4] * t2 - q_j[5] * t3);
        let t5 = h[2] * q_i[6] + (h[0] * q_i[4] + q_i[5] * h[1]);
        let t6 = q_i[3] * h[2] + h[1] * q_i[4] - h[0] * q_i[5];
        let t7 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t8 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t9 = q_i[6] * t5 + (q_i[3] * t6 + q_i[4] * t7 - q_i[5] * t8);
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t12 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t13 = q_j[1] + t11 - q_i[1] - t12;
        let t14 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t15 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t16 = q_j[0] + t14 - q_i[0] - t15;
        phi[0] = t10 * t10 + (t13 * t13 + (t16 * t16 - h[6] * h[6]));
    }
    /// Φ, Φ_q and W.
    ///
    /// 62 additions, 86 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[5] * q_j[6] + (q_j[4] * h[3] + h[4] * q_j[5]);
        let t1 = q_j[6] * h[3] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t2 = q_j[4] * h[4] + (h[5] * q_j[3] - h[3] * q_j[5]);
        let t3 = h[5] * q_j[5] + (q_j[3] * h[3] - h[4] * q_j[6]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t6 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t7 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t8 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t12 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t13 = q_j[1] + t11 - q_i[1] - t12;
        let t14 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t15 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t16 = q_j[0] + t14 - q_i[0] - t15;
        let t17 = t16 * two;
        let t18 = t13 * two;
        let t19 = t10 * two;
        let t20 = t16 * k4;
        let t21 = t13 * k4;
        let t22 = t10 * k4;
        phi[0] = t10 * t10 + (t13 * t13 + (t16 * t16 - h[6] * h[6]));
        phi_q[0] = -t17;
        phi_q[1] = -t18;
        phi_q[2] = -t19;
        phi_q[3] = -(t8 * t20) - t6 * t21 - t7 * t22;
        phi_q[4] = t7 * t21 - t5 * t20 - t6 * t22;
        phi_q[5] = t8 * t22 - t5 * t21 - t7 * t20;
        phi_q[6] = t6 * t20 - t5 * t22 - t8 * t21;
        phi_q[7] = t17;
        phi_q[8] = t18;
        phi_q[9] = t19;
        phi_q[10] = t2 * t22 + (t3 * t20 + t1 * t21);
        phi_q[11] = t1 * t22 + (t0 * t20 - t2 * t21);
        phi_q[12] = t2 * t20 + (t0 * t21 - t3 * t22);
        phi_q[13] = t3 * t21 + (t0 * t22 - t1 * t20);
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 162 additions, 210 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
        curvature: &mut [S; 93],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let k8 = S::from_f64(8.0);
        let t0 = h[5] * q_j[6] + (q_j[4] * h[3] + h[4] * q_j[5]);
        let t1 = q_j[6] * h[3] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t2 = q_j[4] * h[4] + (h[5] * q_j[3] - h[3] * q_j[5]);
        let t3 = h[5] * q_j[5] + (q_j[3] * h[3] - h[4] * q_j[6]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t6 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t7 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t8 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t12 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t13 = q_j[1] + t11 - q_i[1] - t12;
        let t14 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t15 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t16 = q_j[0] + t14 - q_i[0] - t15;
        let t17 = t16 * two;
        let t18 = t13 * two;
        let t19 = t10 * two;
        let t20 = t16 * k4;
        let t21 = t13 * k4;
        let t22 = t10 * k4;
        let t23 = lambda[0] * two;
        let t24 = lambda[0] * k4;
        let t25 = t8 * t24;
        let t26 = t6 * t24;
        let t27 = t7 * t24;
        let t28 = t8 * lambda[0];
        let t29 = t28 * k8;
        let t30 = t8 * t29;
        let t31 = t13 * lambda[0] * k4;
        let t32 = h[1] * t31;
        let t33 = t30 - t32;
        let t34 = t7 * lambda[0];
        let t35 = t34 * k8;
        let t36 = t7 * t35;
        let t37 = t6 * lambda[0];
        let t38 = t37 * k8;
        let t39 = t6 * t38;
        let t40 = t10 * lambda[0] * k4;
        let t41 = h[2] * t40;
        let t42 = t16 * lambda[0] * k4;
        let t43 = h[0] * t42;
        let t44 = t5 * t24;
        let t45 = t6 * t35;
        let t46 = t5 * t29;
        let t47 = h[2] * t31;
        let t48 = h[1] * t40;
        let t49 = t36 + t41;
        let t50 = t39 + t32;
        let t51 = t5 * lambda[0];
        let t52 = t51 * k8;
        let t53 = t5 * t52;
        let t54 = t5 * t38 + (-(h[2] * t42) - t8 * t35);
        let t55 = h[0] * t40;
        let t56 = t5 * t35;
        let t57 = t8 * t38;
        let t58 = h[1] * t42;
        let t59 = h[0] * t31;
        let t60 = t43 + t53;
        let t61 = -t23;
        let t62 = t28 * k4;
        let t63 = -t62;
        let t64 = -(t51 * k4);
        let t65 = t34 * k4;
        let t66 = -t65;
        let t67 = t37 * k4;
        let t68 = -t67;
        let t69 = t3 * t24;
        let t70 = -t69;
        let t71 = t1 * t24;
        let t72 = -t71;
        let t73 = t2 * t24;
        let t74 = -t73;
        let t75 = t2 * t35;
        let t76 = t1 * k8;
        let t77 = t37 * t76;
        let t78 = -t75 - t77;
        let t79 = t3 * t29;
        let t80 = t1 * t35;
        let t81 = t3 * k8;
        let t82 = t80 - t51 * t81;
        let t83 = t2 * t38;
        let t84 = t2 * t29;
        let t85 = t84 - t51 * t76;
        let t86 = t3 * t35;
        let t87 = t3 * t38;
        let t88 = t2 * t52;
        let t89 = t87 - t88;
        let t90 = t3 * lambda[0];
        let t91 = t81 * t90;
        let t92 = h[4] * t31;
        let t93 = t91 + t92;
        let t94 = h[3] * t42;
        let t95 = h[5] * t40;
        let t96 = t2 * lambda[0];
        let t97 = t2 * k8;
        let t98 = t96 * t97;
        let t99 = t1 * lambda[0];
        let t100 = t76 * t99;
        let t101 = t0 * t24;
        let t102 = -t101;
        let t103 = t83 - t0 * t29;
        let t104 = t0 * k8;
        let t105 = t51 * t104;
        let t106 = t1 * t29 - t0 * t35;
        let t107 = h[4] * t40;
        let t108 = t76 * t96;
        let t109 = t90 * t104;
        let t110 = h[5] * t31;
        let t111 = t98 - t95;
        let t112 = t100 - t92;
        let t113 = t0 * lambda[0];
        let t114 = t104 * t113;
        let t115 = t86 - t0 * t38;
        let t116 = -t79 - t105;
        let t117 = t99 * t104 + (h[5] * t42 - t81 * t96);
        let t118 = h[3] * t40;
        let t119 = h[3] * t31;
        let t120 = h[4] * t42;
        let t121 = t96 * t104;
        let t122 = t81 * t99;
        let t123 = t114 - t94;
        phi[0] = t10 * t10 + (t13 * t13 + (t16 * t16 - h[6] * h[6]));
        phi_q[0] = -t17;
        phi_q[1] = -t18;
        phi_q[2] = -t19;
        phi_q[3] = -(t8 * t20) - t6 * t21 - t7 * t22;
        phi_q[4] = t7 * t21 - t5 * t20 - t6 * t22;
        phi_q[5] = t8 * t22 - t5 * t21 - t7 * t20;
        phi_q[6] = t6 * t20 - t5 * t22 - t8 * t21;
        phi_q[7] = t17;
        phi_q[8] = t18;
        phi_q[9] = t19;
        phi_q[10] = t2 * t22 + (t3 * t20 + t1 * t21);
        phi_q[11] = t1 * t22 + (t0 * t20 - t2 * t21);
        phi_q[12] = t2 * t20 + (t0 * t21 - t3 * t22);
        phi_q[13] = t3 * t21 + (t0 * t22 - t1 * t20);
        curvature[0] = t23;
        curvature[1] = t23;
        curvature[2] = t23;
        curvature[3] = t25;
        curvature[4] = t26;
        curvature[5] = t27;
        curvature[6] = t33 + (t36 + t39 - t41 - t43);
        curvature[7] = t44;
        curvature[8] = -t27;
        curvature[9] = t26;
        curvature[10] = t45 + (t46 + (t47 - t7 * t38)) - t48;
        curvature[11] = t49 + (t50 + (t53 - t43));
        curvature[12] = t27;
        curvature[13] = t44;
        curvature[14] = -t25;
        curvature[15] = t54 + (t55 + t7 * t29);
        curvature[16] = t7 * t52 - t56 - t57 - t58 - t59;
        curvature[17] = t60 + (t33 + t49);
        curvature[18] = -t26;
        curvature[19] = t25;
        curvature[20] = t44;
        curvature[21] = t57 + (t56 + (t58 - t59 - t6 * t29));
        curvature[22] = t54 - t6 * t52 - t55;
        curvature[23] = t8 * t52 - t48 - t46 - t45 - t47;
        curvature[24] = t60 + (t50 + (t30 - t41));
        curvature[25] = t61;
        curvature[26] = t63;
        curvature[27] = t64;
        curvature[28] = t66;
        curvature[29] = t67;
        curvature[30] = t23;
        curvature[31] = t61;
        curvature[32] = t68;
        curvature[33] = t65;
        curvature[34] = t64;
        curvature[35] = t63;
        curvature[36] = t23;
        curvature[37] = t61;
        curvature[38] = t66;
        curvature[39] = t68;
        curvature[40] = t62;
        curvature[41] = t64;
        curvature[42] = t23;
        curvature[43] = t70;
        curvature[44] = t72;
        curvature[45] = t74;
        curvature[46] = t78 - t79;
        curvature[47] = t82 - t83;
        curvature[48] = t85 - t86;
        curvature[49] = t89 - t28 * t76;
        curvature[50] = t69;
        curvature[51] = t71;
        curvature[52] = t73;
        curvature[53] = t93 + (t94 + (t95 + (t98 + t100)));
        curvature[54] = t102;
        curvature[55] = t73;
        curvature[56] = t72;
        curvature[57] = t103 - t80;
        curvature[58] = t78 - t105;
        curvature[59] = t88 + t106;
        curvature[60] = t85 + t37 * t104;
        curvature[61] = t101;
        curvature[62] = t74;
        curvature[63] = t71;
        curvature[64] = t107 + (t108 + (t109 - t2 * t99 * k8 - t110));
        curvature[65] = t111 + (t112 + (t94 + t114));
        curvature[66] = t74;
        curvature[67] = t102;
        curvature[68] = t69;
        curvature[69] = t115 - t84;
        curvature[70] = t89 + t34 * t104;
        curvature[71] = t116 - t75;
        curvature[72] = t103 + t3 * t52;
        curvature[73] = t73;
        curvature[74] = t101;
        curvature[75] = t70;
        curvature[76] = t117 + (t97 * t90 - t118);
        curvature[77] = t119 + (t97 * t113 + (t120 - t121 - t122));
        curvature[78] = t123 + (t93 + t111);
        curvature[79] = t71;
        curvature[80] = t70;
        curvature[81] = t102;
        curvature[82] = t106 - t87;
        curvature[83] = t115 + t1 * t52;
        curvature[84] = t82 + t28 * t104;
        curvature[85] = t116 - t77;
        curvature[86] = t72;
        curvature[87] = t69;
        curvature[88] = t101;
        curvature[89] = t122 + (t121 + (t119 - t76 * t90 - t120));
        curvature[90] = t118 + (t117 - t76 * t113);
        curvature[91] = t81 * t113 + (t110 + (t107 - t109 - t108));
        curvature[92] = t123 + (t112 + (t95 + t91));
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 229 additions, 351 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        lambda: &[S; 1],
        phi_h: &mut [S; 7],
        force_h: &mut [S; 84],
    ) {
        let k4 = S::from_f64(4.0);
        let two = S::from_f64(2.0);
        let k8 = S::from_f64(8.0);
        let t0 = q_i[3] * q_i[6];
        let t1 = q_i[4] * q_i[5];
        let t2 = t0 + t1;
        let t3 = q_j[5] * h[5] + (h[3] * q_j[3] - h[4] * q_j[6]);
        let t4 = h[5] * q_j[6] + (h[3] * q_j[4] + q_j[5] * h[4]);
        let t5 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t6 = q_j[4] * h[4] + (q_j[3] * h[5] - h[3] * q_j[5]);
        let t7 = q_j[6] * t3 + (q_j[5] * t4 + (q_j[3] * t5 - q_j[4] * t6));
        let t8 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t9 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t10 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t11 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t12 = q_i[6] * t8 + (q_i[5] * t9 + (q_i[3] * t10 - q_i[4] * t11));
        let t13 = q_j[1] + t7 - q_i[1] - t12;
        let t14 = t13 * k4;
        let t15 = q_i[6] * q_i[4];
        let t16 = q_i[3] * q_i[5];
        let t17 = t15 - t16;
        let t18 = q_j[6] * t4 + (q_j[4] * t5 + (q_j[3] * t6 - q_j[5] * t3));
        let t19 = q_i[6] * t9 + (q_i[4] * t10 + (q_i[3] * t11 - q_i[5] * t8));
        let t20 = q_j[2] + t18 - q_i[2] - t19;
        let t21 = t20 * k4;
        let t22 = q_j[5] * t6 + (q_j[4] * t4 + (q_j[3] * t3 - q_j[6] * t5));
        let t23 = q_i[5] * t11 + (q_i[4] * t9 + (q_i[3] * t8 - q_i[6] * t10));
        let t24 = q_j[0] + t22 - q_i[0] - t23;
        let t25 = q_i[3] * q_i[3];
        let t26 = q_i[4] * q_i[4];
        let t27 = q_i[6] * q_i[6];
        let t28 = q_i[5] * q_i[5];
        let t29 = t25 + t26 - t27 - t28;
        let t30 = t1 - t0;
        let t31 = t24 * k4;
        let t32 = q_i[3] * q_i[4];
        let t33 = q_i[6] * q_i[5];
        let t34 = t32 + t33;
        let t35 = t25 - t26;
        let t36 = t28 - t27;
        let t37 = t35 + t36;
        let t38 = t16 + t15;
        let t39 = t33 - t32;
        let t40 = t35 - t36;
        let t41 = q_j[4] * q_j[6];
        let t42 = q_j[5] * q_j[3];
        let t43 = t41 - t42;
        let t44 = q_j[3] * q_j[3];
        let t45 = q_j[4] * q_j[4];
        let t46 = q_j[6] * q_j[6];
        let t47 = q_j[5] * q_j[5];
        let t48 = t44 + t45 - t46 - t47;
        let t49 = q_j[3] * q_j[6];
        let t50 = q_j[5] * q_j[4];
        let t51 = t49 + t50;
        let t52 = q_j[3] * q_j[4];
        let t53 = q_j[5] * q_j[6];
        let t54 = t52 + t53;
        let t55 = t44 - t45;
        let t56 = t47 - t46;
        let t57 = t55 + t56;
        let t58 = t50 - t49;
        let t59 = t53 - t52;
        let t60 = t55 - t56;
        let t61 = t42 + t41;
        let t62 = t29 * lambda[0];
        let t63 = t62 * two;
        let t64 = t30 * lambda[0];
        let t65 = t64 * k4;
        let t66 = t38 * lambda[0];
        let t67 = t66 * k4;
        let t68 = t48 * lambda[0];
        let t69 = t68 * two;
        let t70 = t58 * lambda[0];
        let t71 = t70 * k4;
        let t72 = t61 * lambda[0];
        let t73 = t72 * k4;
        let t74 = t2 * lambda[0];
        let t75 = t74 * k4;
        let t76 = t37 * lambda[0];
        let t77 = t76 * two;
        let t78 = t39 * lambda[0];
        let t79 = t78 * k4;
        let t80 = t51 * lambda[0];
        let t81 = t80 * k4;
        let t82 = t57 * lambda[0];
        let t83 = t82 * two;
        let t84 = t59 * lambda[0];
        let t85 = t84 * k4;
        let t86 = t17 * lambda[0];
        let t87 = t86 * k4;
        let t88 = t34 * lambda[0];
        let t89 = t88 * k4;
        let t90 = t40 * lambda[0];
        let t91 = t90 * two;
        let t92 = t43 * lambda[0];
        let t93 = t92 * k4;
        let t94 = t54 * lambda[0];
        let t95 = t94 * k4;
        let t96 = t60 * lambda[0];
        let t97 = t96 * two;
        let t98 = t20 * lambda[0] * k4;
        let t99 = q_i[5] * t98;
        let t100 = t13 * lambda[0] * k4;
        let t101 = q_i[6] * t100;
        let t102 = t24 * lambda[0] * k4;
        let t103 = q_i[3] * t102;
        let t104 = t99 - t101 - t103;
        let t105 = t11 * k8;
        let t106 = t62 * k4;
        let t107 = t10 * k8;
        let t108 = q_i[6] * t102;
        let t109 = q_i[4] * t98;
        let t110 = q_i[3] * t100;
        let t111 = t108 + (-t109 - t110);
        let t112 = t76 * k4;
        let t113 = t8 * k8;
        let t114 = q_i[4] * t100;
        let t115 = q_i[5] * t102;
        let t116 = q_i[3] * t98;
        let t117 = t114 + (-t115 - t116);
        let t118 = t90 * k4;
        let t119 = t68 * k4;
        let t120 = t82 * k4;
        let t121 = t96 * k4;
        let t122 = -(q_i[5] * t100) - q_i[4] * t102 - q_i[6] * t98;
        let t123 = t9 * k8;
        let t124 = t5 * k8;
        let t125 = t6 * k8;
        let t126 = t3 * k8;
        let t127 = q_j[6] * t100;
        let t128 = q_j[3] * t102;
        let t129 = q_j[5] * t98;
        let t130 = t127 + (t128 - t129);
        let t131 = q_j[4] * t98;
        let t132 = q_j[3] * t100;
        let t133 = q_j[6] * t102;
        let t134 = t131 + (t132 - t133);
        let t135 = q_j[5] * t102;
        let t136 = q_j[3] * t98;
        let t137 = q_j[4] * t100;
        let t138 = t135 + (t136 - t137);
        let t139 = t4 * k8;
        let t140 = q_j[6] * t98 + (q_j[5] * t100 + q_j[4] * t102);
        phi_h[0] = -(t2 * t14) - t17 * t21 - t24 * t29 * two;
        phi_h[1] = -(t30 * t31) - t21 * t34 - t13 * t37 * two;
        phi_h[2] = -(t31 * t38) - t14 * t39 - t20 * t40 * two;
        phi_h[3] = t21 * t43 + (t24 * t48 * two + t14 * t51);
        phi_h[4] = t21 * t54 + (t13 * t57 * two + t31 * t58);
        phi_h[5] = t14 * t59 + (t20 * t60 * two + t31 * t61);
        phi_h[6] = -(h[6] * two);
        force_h[0] = t63;
        force_h[1] = t65;
        force_h[2] = t67;
        force_h[3] = -t69;
        force_h[4] = -t71;
        force_h[5] = -t73;
        force_h[6] = t75;
        force_h[7] = t77;
        force_h[8] = t79;
        force_h[9] = -t81;
        force_h[10] = -t83;
        force_h[11] = -t85;
        force_h[12] = t87;
        force_h[13] = t89;
        force_h[14] = t91;
        force_h[15] = -t93;
        force_h[16] = -t95;
        force_h[17] = -t97;
        force_h[18] = t104 + (t86 * t105 + (t8 * t106 + t74 * t107));
        force_h[19] = t111 + (t88 * t105 + (t10 * t112 + t64 * t113));
        force_h[20] = t117 + (t78 * t107 + (t11 * t118 + t66 * t113));
        force_h[21] = -(t80 * t107) - t92 * t105 - t8 * t119;
        force_h[22] = -(t70 * t113) - t94 * t105 - t10 * t120;
        force_h[23] = -(t72 * t113) - t84 * t107 - t11 * t121;
        force_h[24] = t122 + (t86 * t107 + (t9 * t106 - t74 * t105));
        force_h[25] = t88 * t107 + (t64 * t123 + (t117 - t11 * t112));
        force_h[26] = t66 * t123 + (t10 * t118 + (t109 + (t110 - t78 * t105 - t108)));
        force_h[27] = t80 * t105 - t92 * t107 - t9 * t119;
        force_h[28] = t11 * t120 - t70 * t123 - t94 * t107;
        force_h[29] = t84 * t105 - t72 * t123 - t10 * t121;
        force_h[30] = t74 * t123 + (t11 * t106 + (t115 + (t116 - t86 * t113 - t114)));
        force_h[31] = t64 * t105 + (t9 * t112 + (t122 - t88 * t113));
        force_h[32] = t66 * t105 + (t78 * t123 + (t104 - t8 * t118));
        force_h[33] = t92 * t113 - t80 * t123 - t11 * t119;
        force_h[34] = t94 * t113 - t70 * t105 - t9 * t120;
        force_h[35] = t8 * t121 - t84 * t123 - t72 * t105;
        force_h[36] = t74 * t113 + (t86 * t123 + (t111 - t10 * t106));
        force_h[37] = t88 * t123 + (t8 * t112 + (t101 + (t103 - t64 * t107 - t99)));
        force_h[38] = t78 * t113 + (t9 * t118 + (t122 - t66 * t107));
        force_h[39] = t10 * t119 - t92 * t123 - t80 * t113;
        force_h[40] = t70 * t107 - t94 * t123 - t8 * t120;
        force_h[41] = t72 * t107 - t84 * t113 - t9 * t121;
        force_h[42] = -t63;
        force_h[43] = -t65;
        force_h[44] = -t67;
        force_h[45] = t69;
        force_h[46] = t71;
        force_h[47] = t73;
        force_h[48] = -t75;
        force_h[49] = -t77;
        force_h[50] = -t79;
        force_h[51] = t81;
        force_h[52] = t83;
        force_h[53] = t85;
        force_h[54] = -t87;
        force_h[55] = -t89;
        force_h[56] = -t91;
        force_h[57] = t93;
        force_h[58] = t95;
        force_h[59] = t97;
        force_h[60] = -(t74 * t124) - t86 * t125 - t3 * t106;
        force_h[61] = -(t64 * t126) - t88 * t125 - t5 * t112;
        force_h[62] = -(t66 * t126) - t78 * t124 - t6 * t118;
        force_h[63] = t130 + (t92 * t125 + (t3 * t119 + t80 * t124));
        force_h[64] = t134 + (t94 * t125 + (t5 * t120 + t70 * t126));
        force_h[65] = t138 + (t84 * t124 + (t6 * t121 + t72 * t126));
        force_h[66] = t74 * t125 - t86 * t124 - t4 * t106;
        force_h[67] = t6 * t112 - t64 * t139 - t88 * t124;
        force_h[68] = t78 * t125 - t66 * t139 - t5 * t118;
        force_h[69] = t140 + (t92 * t124 + (t4 * t119 - t80 * t125));
        force_h[70] = t94 * t124 + (t70 * t139 + (t138 - t6 * t120));
        force_h[71] = t72 * t139 + (t5 * t121 + (t133 - t84 * t125 - t132 - t131));
        force_h[72] = t86 * t126 - t74 * t139 - t6 * t106;
        force_h[73] = t88 * t126 - t64 * t125 - t4 * t112;
        force_h[74] = t3 * t118 - t78 * t139 - t66 * t125;
        force_h[75] = t80 * t139 + (t6 * t119 + (t137 - t92 * t126 - t136 - t135));
        force_h[76] = t70 * t125 + (t4 * t120 + (t140 - t94 * t126));
        force_h[77] = t72 * t125 + (t84 * t139 + (t130 - t3 * t121));
        force_h[78] = t5 * t106 - t86 * t139 - t74 * t126;
        force_h[79] = t64 * t124 - t88 * t139 - t3 * t112;
        force_h[80] = t66 * t124 - t78 * t126 - t4 * t118;
        force_h[81] = t80 * t126 + (t92 * t139 + (t134 - t5 * t119));
        force_h[82] = t94 * t139 + (t3 * t120 + (t129 - t70 * t124 - t128 - t127));
        force_h[83] = t84 * t126 + (t4 * t121 + (t140 - t72 * t124));
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 252 additions, 272 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 14],
        rate_h: &mut [S; 6],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[4] * q_j[4] + (h[5] * q_j[3] - h[3] * q_j[5]);
        let t1 = h[5] * q_j[6] + (h[3] * q_j[4] + h[4] * q_j[5]);
        let t2 = h[5] * q_j[5] + (h[3] * q_j[3] - h[4] * q_j[6]);
        let t3 = h[5] * v_j[3] + (v_j[4] * h[4] - h[3] * v_j[5]);
        let t4 = h[5] * v_j[6] + (v_j[4] * h[3] + h[4] * v_j[5]);
        let t5 = h[5] * v_j[5] + (h[3] * v_j[3] - v_j[6] * h[4]);
        let t6 = h[4] * v_j[3] + (h[3] * v_j[6] - h[5] * v_j[4]);
        let t7 = h[3] * q_j[6] + (h[4] * q_j[3] - h[5] * q_j[4]);
        let t8 = q_j[4] * t4 + (q_j[3] * t5 - t6 * q_j[6] - v_j[6] * t7);
        let t9 = v_j[5] * t0 + (v_j[4] * t1 + (v_j[3] * t2 + (q_j[5] * t3 + t8)));
        let t10 = h[1] * q_i[4] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t11 = h[2] * q_i[6] + (h[0] * q_i[4] + h[1] * q_i[5]);
        let t12 = h[2] * q_i[5] + (h[0] * q_i[3] - h[1] * q_i[6]);
        let t13 = h[2] * v_i[3] + (v_i[4] * h[1] - h[0] * v_i[5]);
        let t14 = h[2] * v_i[6] + (v_i[4] * h[0] + h[1] * v_i[5]);
        let t15 = h[2] * v_i[5] + (h[0] * v_i[3] - v_i[6] * h[1]);
        let t16 = h[1] * v_i[3] + (h[0] * v_i[6] - h[2] * v_i[4]);
        let t17 = h[0] * q_i[6] + (h[1] * q_i[3] - h[2] * q_i[4]);
        let t18 = q_i[4] * t14 + (q_i[3] * t15 - t16 * q_i[6] - v_i[6] * t17);
        let t19 = v_i[5] * t10 + (v_i[4] * t11 + (v_i[3] * t12 + (q_i[5] * t13 + t18)));
        let t20 = v_j[0] + t9 - v_i[0] - t19;
        let t21 = t20 * two;
        let t22 = t4 * q_j[5] + (t6 * q_j[3] - q_j[4] * t3 - v_j[4] * t0);
        let t23 = v_j[6] * t2 + (v_j[5] * t1 + (v_j[3] * t7 + (q_j[6] * t5 + t22)));
        let t24 = t14 * q_i[5] + (t16 * q_i[3] - q_i[4] * t13 - v_i[4] * t10);
        let t25 = v_i[6] * t12 + (v_i[5] * t11 + (v_i[3] * t17 + (q_i[6] * t15 + t24)));
        let t26 = v_j[1] + t23 - v_i[1] - t25;
        let t27 = t26 * two;
        let t28 = t6 * q_j[4] + (q_j[3] * t3 - t5 * q_j[5] - v_j[5] * t2);
        let t29 = v_j[6] * t1 + (v_j[4] * t7 + (v_j[3] * t0 + (q_j[6] * t4 + t28)));
        let t30 = t16 * q_i[4] + (q_i[3] * t13 - t15 * q_i[5] - v_i[5] * t12);
        let t31 = v_i[6] * t11 + (v_i[4] * t17 + (v_i[3] * t10 + (q_i[6] * t14 + t30)));
        let t32 = v_j[2] + t29 - v_i[2] - t31;
        let t33 = t32 * two;
        let t34 = t20 * k4;
        let t35 = t26 * k4;
        let t36 = t32 * k4;
        let t37 = q_j[5] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[6] * t7));
        let t38 = q_i[5] * t10 + (q_i[4] * t11 + (q_i[3] * t12 - q_i[6] * t17));
        let t39 = (q_j[0] + t37 - q_i[0] - t38) * k4;
        let t40 = -(t12 * t34) - t17 * t35 - t10 * t36 - t15 * t39;
        let t41 = q_j[6] * t2 + (q_j[5] * t1 + (q_j[3] * t7 - q_j[4] * t0));
        let t42 = q_i[6] * t12 + (q_i[5] * t11 + (q_i[3] * t17 - q_i[4] * t10));
        let t43 = (q_j[1] + t41 - q_i[1] - t42) * k4;
        let t44 = q_j[6] * t1 + (q_j[4] * t7 + (q_j[3] * t0 - q_j[5] * t2));
        let t45 = q_i[6] * t11 + (q_i[4] * t17 + (q_i[3] * t10 - q_i[5] * t12));
        let t46 = (q_j[2] + t44 - q_i[2] - t45) * k4;
        let t47 = t10 * t35 - t11 * t34 - t17 * t36 - t14 * t39;
        let t48 = t12 * t36 - t11 * t35 - t10 * t34 - t13 * t39;
        let t49 = t17 * t34 - t11 * t36 - t12 * t35 - t15 * t43;
        let t50 = t5 * t39 + (t0 * t36 + (t2 * t34 + t7 * t35));
        let t51 = t7 * t36 + (t1 * t34 - t0 * t35 - t3 * t43);
        let t52 = t0 * t34 + (t1 * t35 - t2 * t36 - t5 * t46);
        let t53 = t2 * t35 + (t1 * t36 - t7 * t34 - t6 * t39);
        let t54 = v_i[4] * q_i[4];
        let t55 = v_i[3] * q_i[3];
        let t56 = v_i[6] * q_i[6];
        let t57 = v_i[5] * q_i[5];
        let t58 = v_i[4] * q_i[5] + q_i[4] * v_i[5];
        let t59 = v_i[6] * q_i[3];
        let t60 = v_i[3] * q_i[6];
        let t61 = -(t39 * (t54 + t55 - t56 - t57)) - t43 * (t58 + (t59 + t60));
        let t62 = v_i[4] * q_i[6] + v_i[6] * q_i[4];
        let t63 = q_i[3] * v_i[5];
        let t64 = v_i[3] * q_i[5];
        let t65 = q_i[6] * q_i[3];
        let t66 = q_i[4] * q_i[5];
        let t67 = t61 - t46 * (t62 - t63 - t64) - t35 * (t65 + t66);
        let t68 = q_i[6] * q_i[4];
        let t69 = q_i[3] * q_i[5];
        let t70 = q_i[3] * q_i[3];
        let t71 = q_i[4] * q_i[4];
        let t72 = q_i[6] * q_i[6];
        let t73 = q_i[5] * q_i[5];
        let t74 = t55 - t54;
        let t75 = -(t39 * (t58 - t59 - t60)) - t43 * (t74 + (t57 - t56));
        let t76 = q_i[6] * v_i[5] + v_i[6] * q_i[5];
        let t77 = v_i[4] * q_i[3];
        let t78 = v_i[3] * q_i[4];
        let t79 = t75 - t46 * (t76 + (t77 + t78)) - t34 * (t66 - t65);
        let t80 = q_i[4] * q_i[3];
        let t81 = q_i[6] * q_i[5];
        let t82 = t70 - t71;
        let t83 = t73 - t72;
        let t84 = -(t39 * (t64 + (t63 + t62))) - t43 * (t76 - t77 - t78);
        let t85 = t84 - t46 * (t56 + (t74 - t57)) - t34 * (t69 + t68);
        let t86 = q_j[6] * q_j[4];
        let t87 = q_j[3] * q_j[5];
        let t88 = q_j[6] * q_j[3];
        let t89 = q_j[4] * q_j[5];
        let t90 = v_j[4] * q_j[6] + v_j[6] * q_j[4];
        let t91 = q_j[3] * v_j[5];
        let t92 = v_j[3] * q_j[5];
        let t93 = v_j[4] * q_j[5] + q_j[4] * v_j[5];
        let t94 = v_j[6] * q_j[3];
        let t95 = v_j[3] * q_j[6];
        let t96 = q_j[3] * q_j[3];
        let t97 = q_j[4] * q_j[4];
        let t98 = q_j[6] * q_j[6];
        let t99 = q_j[5] * q_j[5];
        let t100 = v_j[4] * q_j[4];
        let t101 = v_j[3] * q_j[3];
        let t102 = v_j[6] * q_j[6];
        let t103 = v_j[5] * q_j[5];
        let t104 = t21 * (t96 + t97 - t98 - t99) + t39 * (t100 + t101 - t102 - t103);
        let t105 = t46 * (t90 - t91 - t92) + (t43 * (t93 + (t94 + t95)) + t104);
        let t106 = q_j[4] * q_j[3];
        let t107 = q_j[6] * q_j[5];
        let t108 = q_j[6] * v_j[5] + v_j[6] * q_j[5];
        let t109 = v_j[4] * q_j[3];
        let t110 = v_j[3] * q_j[4];
        let t111 = t101 - t100;
        let t112 = t96 - t97;
        let t113 = t99 - t98;
        let t114 = t43 * (t111 + (t103 - t102))
            + (t27 * (t112 + t113) + t39 * (t93 - t94 - t95));
        let t115 = t34 * (t89 - t88) + (t46 * (t108 + (t109 + t110)) + t114);
        let t116 = t43 * (t108 - t109 - t110)
            + (t33 * (t112 - t113) + t39 * (t92 + (t91 + t90)));
        let t117 = t34 * (t87 + t86) + (t46 * (t102 + (t111 - t103)) + t116);
        rate_q[0] = -t21;
        rate_q[1] = -t27;
        rate_q[2] = -t33;
        rate_q[3] = t40 - t16 * t43 - t13 * t46;
        rate_q[4] = t13 * t43 + (t47 - t16 * t46);
        rate_q[5] = t15 * t46 + (t48 - t14 * t43);
        rate_q[6] = t16 * t39 + (t49 - t14 * t46);
        rate_q[7] = t21;
        rate_q[8] = t27;
        rate_q[9] = t33;
        rate_q[10] = t3 * t46 + (t6 * t43 + t50);
        rate_q[11] = t6 * t46 + (t4 * t39 + t51);
        rate_q[12] = t4 * t43 + (t3 * t39 + t52);
        rate_q[13] = t4 * t46 + (t5 * t43 + t53);
        rate_h[0] = t67 - t36 * (t68 - t69) - t21 * (t70 + t71 - t72 - t73);
        rate_h[1] = t79 - t36 * (t80 + t81) - t27 * (t82 + t83);
        rate_h[2] = t85 - t35 * (t81 - t80) - t33 * (t82 - t83);
        rate_h[3] = t36 * (t86 - t87) + (t35 * (t88 + t89) + t105);
        rate_h[4] = t36 * (t106 + t107) + t115;
        rate_h[5] = t35 * (t107 - t106) + t117;
    }
}
