// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Distance of two points
///
/// `|d_ij| − l = 0, d_ij = r_j + A_j s_j − r_i − A_i s_i` (unit m)
///
/// Source: method paper, eq. (20), (21).
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `s_i` | m | body i | first end |
/// | 3..6 | `s_j` | m | body j | second end, never at the first |
/// | 6 | `length` | m |  | distance of the ends |
pub mod distance {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "distance",
        title: "Distance of two points",
        equation: "|d_ij| − l = 0, d_ij = r_j + A_j s_j − r_i − A_i s_i",
        reference: "method paper, eq. (20), (21)",
        bodies: 2,
        equations: 1,
        unit: "m",
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
                meaning: "second end, never at the first",
            },
            Parameter {
                name: "length",
                size: 1,
                offset: 6,
                unit: "m",
                frame: "",
                meaning: "distance of the ends",
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
            (1, 0),
            (1, 1),
            (2, 0),
            (2, 1),
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
            (7, 1),
            (7, 2),
            (7, 3),
            (7, 4),
            (7, 5),
            (7, 6),
            (7, 7),
            (8, 0),
            (8, 1),
            (8, 2),
            (8, 3),
            (8, 4),
            (8, 5),
            (8, 6),
            (8, 7),
            (8, 8),
            (9, 0),
            (9, 1),
            (9, 2),
            (9, 3),
            (9, 4),
            (9, 5),
            (9, 6),
            (9, 7),
            (9, 8),
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
                multiplications: 51,
                divisions: 0,
                functions: 1,
            },
            Operations {
                additions: 62,
                multiplications: 101,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 276,
                multiplications: 406,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 248,
                multiplications: 389,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 301,
                multiplications: 399,
                divisions: 1,
                functions: 1,
            },
        ],
    };
    /// Distance of two points
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Distance;
    impl<S: Scalar> Relation<S> for Distance {
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
    /// 46 additions, 51 multiplications, 0 divisions, 1 functions.
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
        let t11 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t12 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t13 = q_j[0] + t11 - q_i[0] - t12;
        let t14 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t15 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t16 = q_j[1] + t14 - q_i[1] - t15;
        phi[0] = (t10 * t10 + (t13 * t13 + t16 * t16)).sqrt() - h[6];
    }
    /// Φ, Φ_q and W.
    ///
    /// 62 additions, 101 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
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
        let t11 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t12 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t13 = q_j[0] + t11 - q_i[0] - t12;
        let t14 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t15 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t16 = q_j[1] + t14 - q_i[1] - t15;
        let t17 = (t10 * t10 + (t13 * t13 + t16 * t16)).sqrt();
        let t18 = one / t17;
        let t19 = t13 * t18;
        let t20 = t16 * t18;
        let t21 = t10 * t18;
        let t22 = t18 * (t6 * t10 + (t8 * t13 + t7 * t16)) * two;
        let t23 = t18 * (t5 * t13 + t7 * t10 - t6 * t16) * two;
        let t24 = t18 * (t6 * t13 + (t5 * t16 - t8 * t10)) * two;
        let t25 = t18 * (t5 * t10 + t8 * t16 - t7 * t13) * two;
        phi[0] = t17 - h[6];
        phi_q[0] = -t19;
        phi_q[1] = -t20;
        phi_q[2] = -t21;
        phi_q[3] = -t22;
        phi_q[4] = -t23;
        phi_q[5] = -t24;
        phi_q[6] = -t25;
        phi_q[7] = t19;
        phi_q[8] = t20;
        phi_q[9] = t21;
        phi_q[10] = t18 * (t1 * t10 + (t3 * t13 + t2 * t16)) * two;
        phi_q[11] = t18 * (t0 * t13 + t2 * t10 - t1 * t16) * two;
        phi_q[12] = t18 * (t1 * t13 + (t0 * t16 - t3 * t10)) * two;
        phi_q[13] = t18 * (t0 * t10 + t3 * t16 - t2 * t13) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 276 additions, 406 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
        curvature: &mut [S; 105],
    ) {
        let one = S::from_f64(1.0);
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
        let t11 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t12 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t13 = q_j[0] + t11 - q_i[0] - t12;
        let t14 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t15 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t16 = q_j[1] + t14 - q_i[1] - t15;
        let t17 = (t10 * t10 + (t13 * t13 + t16 * t16)).sqrt();
        let t18 = one / t17;
        let t19 = t13 * t18;
        let t20 = t16 * t18;
        let t21 = t10 * t18;
        let t22 = t18 * (t7 * t10 + (t8 * t13 + t6 * t16));
        let t23 = t18 * (t6 * t10 + (t5 * t13 - t7 * t16));
        let t24 = t18 * (t7 * t13 + (t5 * t16 - t8 * t10));
        let t25 = t18 * (t8 * t16 + (t5 * t10 - t6 * t13));
        let t26 = t18 * (t2 * t10 + (t3 * t13 + t1 * t16));
        let t27 = t18 * (t1 * t10 + (t0 * t13 - t2 * t16));
        let t28 = t18 * (t2 * t13 + (t0 * t16 - t3 * t10));
        let t29 = t18 * (t3 * t16 + (t0 * t10 - t1 * t13));
        let t30 = t18 * t18;
        let t31 = t18 * lambda[0];
        let t32 = t13 * (lambda[0] * (t19 * t30)) - t31;
        let t33 = -t32;
        let t34 = lambda[0] * (t20 * t30);
        let t35 = t13 * t34;
        let t36 = -t35;
        let t37 = t16 * t34 - t31;
        let t38 = -t37;
        let t39 = lambda[0] * (t21 * t30);
        let t40 = t13 * t39;
        let t41 = -t40;
        let t42 = t16 * t39;
        let t43 = -t42;
        let t44 = t10 * t39 - t31;
        let t45 = -t44;
        let t46 = t32 * two;
        let t47 = t35 * two;
        let t48 = t6 * t47;
        let t49 = t40 * two;
        let t50 = t7 * t49;
        let t51 = t37 * two;
        let t52 = t42 * two;
        let t53 = t7 * t52;
        let t54 = t8 * t47;
        let t55 = t8 * t49;
        let t56 = t44 * two;
        let t57 = t6 * t52;
        let t58 = lambda[0] * (t22 * t30);
        let t59 = t8 * t31;
        let t60 = t13 * t58 - t59;
        let t61 = t8 * k4;
        let t62 = t6 * t31;
        let t63 = t16 * t58 - t62;
        let t64 = t6 * k4;
        let t65 = t7 * t31;
        let t66 = t10 * t58 - t65;
        let t67 = t66 * k4;
        let t68 = t13 * t31 * two;
        let t69 = h[0] * t68;
        let t70 = -(t60 * t61) - t63 * t64 - t7 * t67 - t69;
        let t71 = t10 * t31 * two;
        let t72 = h[2] * t71;
        let t73 = t16 * t31 * two;
        let t74 = h[1] * t73;
        let t75 = t7 * t47;
        let t76 = t6 * t49;
        let t77 = t5 * t47;
        let t78 = t5 * t49;
        let t79 = t7 * k4;
        let t80 = h[2] * t73;
        let t81 = t5 * k4;
        let t82 = h[1] * t71;
        let t83 = lambda[0] * (t23 * t30);
        let t84 = t65 + t16 * t83;
        let t85 = t5 * t31;
        let t86 = t13 * t83 - t85;
        let t87 = t10 * t83 - t62;
        let t88 = t72 + (t79 * t84 - t69 - t81 * t86 - t64 * t87);
        let t89 = t8 * t52;
        let t90 = t5 * t52;
        let t91 = h[0] * t71;
        let t92 = h[2] * t68;
        let t93 = h[1] * t68;
        let t94 = h[0] * t73;
        let t95 = lambda[0] * (t24 * t30);
        let t96 = t59 + t10 * t95;
        let t97 = t72 - t74;
        let t98 = t16 * t95 - t85;
        let t99 = t13 * t95 - t65;
        let t100 = lambda[0] * (t25 * t30);
        let t101 = t62 + t13 * t100;
        let t102 = t10 * t100 - t85;
        let t103 = t16 * t100 - t59;
        let t104 = t1 * t47;
        let t105 = t3 * two;
        let t106 = t2 * t49;
        let t107 = t3 * t47;
        let t108 = t1 * two;
        let t109 = t2 * t52;
        let t110 = t3 * t49;
        let t111 = t2 * two;
        let t112 = t1 * t52;
        let t113 = t2 * k4;
        let t114 = t3 * k4;
        let t115 = t1 * k4;
        let t116 = h[3] * t68;
        let t117 = h[4] * t73;
        let t118 = h[5] * t71;
        let t119 = t2 * t31;
        let t120 = lambda[0] * (t26 * t30);
        let t121 = t119 - t10 * t120;
        let t122 = t3 * t31;
        let t123 = t122 - t13 * t120;
        let t124 = t1 * t31;
        let t125 = t124 - t16 * t120;
        let t126 = t117 + (t118 + (t113 * t121 + (t114 * t123 + t115 * t125)));
        let t127 = t0 * two;
        let t128 = t1 * t49;
        let t129 = t2 * t47;
        let t130 = t0 * t47;
        let t131 = t0 * t49;
        let t132 = t0 * k4;
        let t133 = h[4] * t71;
        let t134 = h[5] * t73;
        let t135 = lambda[0] * (t27 * t30);
        let t136 = t119 + t16 * t135;
        let t137 = t124 - t10 * t135;
        let t138 = t0 * t31;
        let t139 = t138 - t13 * t135;
        let t140 = t113 * t136 + (t115 * t137 + (t116 + t132 * t139)) - t118;
        let t141 = t130 - t110;
        let t142 = t3 * t52;
        let t143 = t0 * t52;
        let t144 = h[5] * t68;
        let t145 = h[3] * t71;
        let t146 = h[3] * t73;
        let t147 = h[4] * t68;
        let t148 = lambda[0] * (t28 * t30);
        let t149 = t119 - t13 * t148;
        let t150 = t122 + t10 * t148;
        let t151 = t138 - t16 * t148;
        let t152 = t117 - t118;
        let t153 = t143 - t104;
        let t154 = t142 - t128;
        let t155 = lambda[0] * (t29 * t30);
        let t156 = t114 * (t122 - t16 * t155)
            + (t132 * (t138 - t10 * t155) + (-t152 - t116));
        phi[0] = t17 - h[6];
        phi_q[0] = -t19;
        phi_q[1] = -t20;
        phi_q[2] = -t21;
        phi_q[3] = -(t22 * two);
        phi_q[4] = -(t23 * two);
        phi_q[5] = -(t24 * two);
        phi_q[6] = -(t25 * two);
        phi_q[7] = t19;
        phi_q[8] = t20;
        phi_q[9] = t21;
        phi_q[10] = t26 * two;
        phi_q[11] = t27 * two;
        phi_q[12] = t28 * two;
        phi_q[13] = t29 * two;
        curvature[0] = t33;
        curvature[1] = t36;
        curvature[2] = t38;
        curvature[3] = t41;
        curvature[4] = t43;
        curvature[5] = t45;
        curvature[6] = -(t8 * t46) - t48 - t50;
        curvature[7] = -(t6 * t51) - t53 - t54;
        curvature[8] = -t55 - t7 * t56 - t57;
        curvature[9] = t70 - t72 - t74;
        curvature[10] = t75 - t5 * t46 - t76;
        curvature[11] = t7 * t37 * two - t57 - t77;
        curvature[12] = t53 - t6 * t56 - t78;
        curvature[13] = t63 * t79 + (t80 - t60 * t81 - t6 * t67) - t82;
        curvature[14] = t74 + t88;
        curvature[15] = t55 - t77 - t7 * t46;
        curvature[16] = t89 - t5 * t51 - t75;
        curvature[17] = t8 * t44 * two - t50 - t90;
        curvature[18] = t61 * t66 + (t91 - t63 * t81 - t60 * t79) - t92;
        curvature[19] = t61 * t87 - t81 * t84 - t79 * t86 - t93 - t94;
        curvature[20] = t69 + (t61 * t96 + (t97 - t81 * t98 - t79 * t99));
        curvature[21] = t6 * t32 * two - t54 - t78;
        curvature[22] = t48 - t90 - t8 * t51;
        curvature[23] = t76 - t5 * t56 - t89;
        curvature[24] = t60 * t64 + (t93 - t94 - t66 * t81 - t61 * t63);
        curvature[25] = t64 * t86 - t92 - t81 * t87 - t61 * t84 - t91;
        curvature[26] = t64 * t99 - t82 - t81 * t96 - t61 * t98 - t80;
        curvature[27] = t64 * t101 + (t69 - t97 - t81 * t102 - t61 * t103);
        curvature[28] = t32;
        curvature[29] = t35;
        curvature[30] = t40;
        curvature[31] = t60 * two;
        curvature[32] = t86 * two;
        curvature[33] = t99 * two;
        curvature[34] = t101 * two;
        curvature[35] = t33;
        curvature[36] = t35;
        curvature[37] = t37;
        curvature[38] = t42;
        curvature[39] = t63 * two;
        curvature[40] = t84 * two;
        curvature[41] = t98 * two;
        curvature[42] = t103 * two;
        curvature[43] = t36;
        curvature[44] = t38;
        curvature[45] = t40;
        curvature[46] = t42;
        curvature[47] = t44;
        curvature[48] = t66 * two;
        curvature[49] = t87 * two;
        curvature[50] = t96 * two;
        curvature[51] = t102 * two;
        curvature[52] = t41;
        curvature[53] = t43;
        curvature[54] = t45;
        curvature[55] = t104 + (t32 * t105 + t106);
        curvature[56] = t107 + (t37 * t108 + t109);
        curvature[57] = t110 + (t44 * t111 + t112);
        curvature[58] = t66 * t113 + (t60 * t114 + t63 * t115);
        curvature[59] = t87 * t113 + (t86 * t114 + t84 * t115);
        curvature[60] = t96 * t113 + (t99 * t114 + t98 * t115);
        curvature[61] = t102 * t113 + (t101 * t114 + t103 * t115);
        curvature[62] = -(t3 * t46) - t106 - t104;
        curvature[63] = -(t1 * t51) - t109 - t107;
        curvature[64] = -(t2 * t56) - t112 - t110;
        curvature[65] = t116 + t126;
        curvature[66] = t32 * t127 + t128 - t129;
        curvature[67] = t130 + (t112 - t2 * t51);
        curvature[68] = t131 + (t44 * t108 - t109);
        curvature[69] = t66 * t115 + (t60 * t132 - t63 * t113);
        curvature[70] = t87 * t115 + (t86 * t132 - t84 * t113);
        curvature[71] = t96 * t115 + (t99 * t132 - t98 * t113);
        curvature[72] = t102 * t115 + (t101 * t132 - t103 * t113);
        curvature[73] = t129 - t0 * t46 - t128;
        curvature[74] = t37 * t111 - t112 - t130;
        curvature[75] = t109 - t1 * t56 - t131;
        curvature[76] = t133 + (t115 * t121 + (t123 * t132 - t113 * t125 - t134));
        curvature[77] = t140 - t117;
        curvature[78] = t32 * t111 + t141;
        curvature[79] = t129 + t37 * t127 - t142;
        curvature[80] = t143 + (t106 - t3 * t56);
        curvature[81] = t60 * t113 + (t63 * t132 - t66 * t114);
        curvature[82] = t86 * t113 + (t84 * t132 - t87 * t114);
        curvature[83] = t99 * t113 + (t98 * t132 - t96 * t114);
        curvature[84] = t101 * t113 + (t103 * t132 - t102 * t114);
        curvature[85] = -t141 - t2 * t46;
        curvature[86] = t142 - t129 - t0 * t51;
        curvature[87] = t44 * t105 - t106 - t143;
        curvature[88] = t144 + (t113 * t123 + (t125 * t132 - t114 * t121 - t145));
        curvature[89] = t146 + (t113 * t139 + (t147 - t132 * t136 - t114 * t137));
        curvature[90] = t113 * t149 + (t114 * t150 + (t132 * t151 + t152)) - t116;
        curvature[91] = t107 + t131 - t1 * t46;
        curvature[92] = t37 * t105 + t153;
        curvature[93] = t44 * t127 + t154;
        curvature[94] = t63 * t114 + (t66 * t132 - t60 * t115);
        curvature[95] = t84 * t114 + (t87 * t132 - t86 * t115);
        curvature[96] = t98 * t114 + (t96 * t132 - t99 * t115);
        curvature[97] = t103 * t114 + (t102 * t132 - t101 * t115);
        curvature[98] = t32 * t108 - t107 - t131;
        curvature[99] = -t153 - t3 * t51;
        curvature[100] = -t154 - t0 * t56;
        curvature[101] = t114 * t125 + (t121 * t132 + (t146 - t115 * t123 - t147));
        curvature[102] = t132 * t137 + (t145 + (t144 - t114 * t136 - t115 * t139));
        curvature[103] = t114 * t151 + (t134 + (t133 - t132 * t150 - t115 * t149));
        curvature[104] = t115 * (t124 + t13 * t155) + t156;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 248 additions, 389 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 7],
        lambda: &[S; 1],
        phi_h: &mut [S; 7],
        force_h: &mut [S; 84],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let minus_one = S::from_f64(-1.0);
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
        let t11 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t12 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t13 = q_j[0] + t11 - q_i[0] - t12;
        let t14 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t15 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t16 = q_j[1] + t14 - q_i[1] - t15;
        let t17 = one / (t10 * t10 + (t13 * t13 + t16 * t16)).sqrt();
        let t18 = q_i[3] * q_i[3];
        let t19 = q_i[4] * q_i[4];
        let t20 = q_i[6] * q_i[6];
        let t21 = q_i[5] * q_i[5];
        let t22 = t18 + t19 - t20 - t21;
        let t23 = q_i[3] * q_i[6];
        let t24 = q_i[4] * q_i[5];
        let t25 = t23 + t24;
        let t26 = q_i[4] * q_i[6];
        let t27 = q_i[3] * q_i[5];
        let t28 = t26 - t27;
        let t29 = t13 * t22 + (t16 * t25 * two + t10 * t28 * two);
        let t30 = t17 * t29;
        let t31 = q_i[4] * q_i[3];
        let t32 = q_i[6] * q_i[5];
        let t33 = t31 + t32;
        let t34 = t18 - t19;
        let t35 = t21 - t20;
        let t36 = t34 + t35;
        let t37 = t24 - t23;
        let t38 = t17 * (t10 * t33 + (t16 * t36 * half + t13 * t37));
        let t39 = t32 - t31;
        let t40 = t34 - t35;
        let t41 = t27 + t26;
        let t42 = t17 * (t16 * t39 + (t10 * t40 * half + t13 * t41));
        let t43 = q_j[3] * q_j[3];
        let t44 = q_j[4] * q_j[4];
        let t45 = q_j[6] * q_j[6];
        let t46 = q_j[5] * q_j[5];
        let t47 = t43 + t44 - t45 - t46;
        let t48 = q_j[3] * q_j[6];
        let t49 = q_j[4] * q_j[5];
        let t50 = (t48 + t49) * two;
        let t51 = q_j[4] * q_j[6];
        let t52 = q_j[3] * q_j[5];
        let t53 = (t51 - t52) * two;
        let t54 = t17 * (t13 * t47 + (t16 * t50 + t10 * t53));
        let t55 = q_j[4] * q_j[3];
        let t56 = q_j[6] * q_j[5];
        let t57 = t55 + t56;
        let t58 = t43 - t44;
        let t59 = t46 - t45;
        let t60 = (t58 + t59) * half;
        let t61 = t49 - t48;
        let t62 = t17 * (t10 * t57 + (t16 * t60 + t13 * t61));
        let t63 = t56 - t55;
        let t64 = (t58 - t59) * half;
        let t65 = t52 + t51;
        let t66 = t17 * (t16 * t63 + (t10 * t64 + t13 * t65));
        let t67 = t17 * t17;
        let t68 = lambda[0] * (t30 * t67);
        let t69 = t17 * lambda[0];
        let t70 = t13 * t68 - t22 * t69;
        let t71 = lambda[0] * (t38 * t67);
        let t72 = t13 * t71 - t37 * t69;
        let t73 = t72 * two;
        let t74 = lambda[0] * (t42 * t67);
        let t75 = t13 * t74 - t41 * t69;
        let t76 = t75 * two;
        let t77 = lambda[0] * (t54 * t67);
        let t78 = t47 * t69 - t13 * t77;
        let t79 = lambda[0] * (t62 * t67);
        let t80 = t61 * t69 - t13 * t79;
        let t81 = t80 * two;
        let t82 = lambda[0] * (t66 * t67);
        let t83 = t65 * t69 - t13 * t82;
        let t84 = t83 * two;
        let t85 = t69 * two;
        let t86 = t16 * t68 - t25 * t85;
        let t87 = t69 * half;
        let t88 = t16 * t71 - t36 * t87;
        let t89 = t88 * two;
        let t90 = t16 * t74 - t39 * t69;
        let t91 = t90 * two;
        let t92 = t50 * t69 - t16 * t77;
        let t93 = t60 * t69 - t16 * t79;
        let t94 = t93 * two;
        let t95 = t63 * t69 - t16 * t82;
        let t96 = t95 * two;
        let t97 = t10 * t68 - t28 * t85;
        let t98 = t10 * t71 - t33 * t69;
        let t99 = t98 * two;
        let t100 = t10 * t74 - t40 * t87;
        let t101 = t100 * two;
        let t102 = t53 * t69 - t10 * t77;
        let t103 = t57 * t69 - t10 * t79;
        let t104 = t103 * two;
        let t105 = t64 * t69 - t10 * t82;
        let t106 = t105 * two;
        let t107 = t10 * t69 * two;
        let t108 = q_i[5] * t107;
        let t109 = t16 * t69 * two;
        let t110 = q_i[6] * t109;
        let t111 = t13 * t69 * two;
        let t112 = q_i[3] * t111;
        let t113 = t108 - t110 - t112;
        let t114 = t70 * two;
        let t115 = t86 * two;
        let t116 = t97 * two;
        let t117 = q_i[6] * t111;
        let t118 = q_i[4] * t107;
        let t119 = q_i[3] * t109;
        let t120 = t117 + (-t118 - t119);
        let t121 = t8 * k4;
        let t122 = t6 * k4;
        let t123 = t7 * k4;
        let t124 = q_i[4] * t109;
        let t125 = q_i[5] * t111;
        let t126 = q_i[3] * t107;
        let t127 = t124 + (-t125 - t126);
        let t128 = t78 * two;
        let t129 = t92 * two;
        let t130 = t102 * two;
        let t131 = -(q_i[5] * t109) - q_i[4] * t111 - q_i[6] * t107;
        let t132 = t5 * two;
        let t133 = t5 * k4;
        let t134 = t2 * k4;
        let t135 = t3 * k4;
        let t136 = t1 * k4;
        let t137 = q_j[6] * t109;
        let t138 = q_j[3] * t111;
        let t139 = q_j[5] * t107;
        let t140 = t137 + (t138 - t139);
        let t141 = q_j[4] * t107;
        let t142 = q_j[3] * t109;
        let t143 = q_j[6] * t111;
        let t144 = t141 + (t142 - t143);
        let t145 = q_j[5] * t111;
        let t146 = q_j[3] * t107 - q_j[4] * t109;
        let t147 = t145 + t146;
        let t148 = t0 * two;
        let t149 = t0 * k4;
        let t150 = q_j[6] * t107 + (q_j[5] * t109 + q_j[4] * t111);
        phi_h[0] = -t30;
        phi_h[1] = -(t38 * two);
        phi_h[2] = -(t42 * two);
        phi_h[3] = t54;
        phi_h[4] = t62 * two;
        phi_h[5] = t66 * two;
        phi_h[6] = minus_one;
        force_h[0] = -t70;
        force_h[1] = -t73;
        force_h[2] = -t76;
        force_h[3] = -t78;
        force_h[4] = -t81;
        force_h[5] = -t84;
        force_h[6] = -t86;
        force_h[7] = -t89;
        force_h[8] = -t91;
        force_h[9] = -t92;
        force_h[10] = -t94;
        force_h[11] = -t96;
        force_h[12] = -t97;
        force_h[13] = -t99;
        force_h[14] = -t101;
        force_h[15] = -t102;
        force_h[16] = -t104;
        force_h[17] = -t106;
        force_h[18] = t113 - t8 * t114 - t6 * t115 - t7 * t116;
        force_h[19] = t120 - t72 * t121 - t88 * t122 - t98 * t123;
        force_h[20] = t127 - t75 * t121 - t90 * t122 - t100 * t123;
        force_h[21] = -(t8 * t128) - t6 * t129 - t7 * t130;
        force_h[22] = -(t80 * t121) - t93 * t122 - t103 * t123;
        force_h[23] = -(t83 * t121) - t95 * t122 - t105 * t123;
        force_h[24] = t131 + (t7 * t115 - t70 * t132 - t6 * t116);
        force_h[25] = t88 * t123 + (t127 - t72 * t133 - t98 * t122);
        force_h[26] = t90 * t123 + (t118 + (t119 - t75 * t133 - t100 * t122 - t117));
        force_h[27] = t7 * t129 - t78 * t132 - t6 * t130;
        force_h[28] = t93 * t123 - t80 * t133 - t103 * t122;
        force_h[29] = t95 * t123 - t83 * t133 - t105 * t122;
        force_h[30] = t8 * t116 + (t125 + (t126 - t124 - t86 * t132 - t7 * t114));
        force_h[31] = t98 * t121 + (t131 - t88 * t133 - t72 * t123);
        force_h[32] = t100 * t121 + (t113 - t90 * t133 - t75 * t123);
        force_h[33] = t8 * t130 - t92 * t132 - t7 * t128;
        force_h[34] = t103 * t121 - t93 * t133 - t80 * t123;
        force_h[35] = t105 * t121 - t95 * t133 - t83 * t123;
        force_h[36] = t6 * t114 + (t120 - t97 * t132 - t8 * t115);
        force_h[37] = t72 * t122 + (t110 + (t112 - t98 * t133 - t88 * t121 - t108));
        force_h[38] = t75 * t122 + (t131 - t100 * t133 - t90 * t121);
        force_h[39] = t6 * t128 - t102 * t132 - t8 * t129;
        force_h[40] = t80 * t122 - t103 * t133 - t93 * t121;
        force_h[41] = t83 * t122 - t105 * t133 - t95 * t121;
        force_h[42] = t70;
        force_h[43] = t73;
        force_h[44] = t76;
        force_h[45] = t78;
        force_h[46] = t81;
        force_h[47] = t84;
        force_h[48] = t86;
        force_h[49] = t89;
        force_h[50] = t91;
        force_h[51] = t92;
        force_h[52] = t94;
        force_h[53] = t96;
        force_h[54] = t97;
        force_h[55] = t99;
        force_h[56] = t101;
        force_h[57] = t102;
        force_h[58] = t104;
        force_h[59] = t106;
        force_h[60] = t2 * t116 + (t3 * t114 + t1 * t115);
        force_h[61] = t98 * t134 + (t72 * t135 + t88 * t136);
        force_h[62] = t100 * t134 + (t75 * t135 + t90 * t136);
        force_h[63] = t140 + (t2 * t130 + (t3 * t128 + t1 * t129));
        force_h[64] = t144 + (t103 * t134 + (t80 * t135 + t93 * t136));
        force_h[65] = t147 + (t105 * t134 + (t83 * t135 + t95 * t136));
        force_h[66] = t1 * t116 + (t70 * t148 - t2 * t115);
        force_h[67] = t98 * t136 + (t72 * t149 - t88 * t134);
        force_h[68] = t100 * t136 + (t75 * t149 - t90 * t134);
        force_h[69] = t150 + (t1 * t130 + (t78 * t148 - t2 * t129));
        force_h[70] = t103 * t136 + (t80 * t149 + (t147 - t93 * t134));
        force_h[71] = t105 * t136 + (t83 * t149 + (t143 - t95 * t134 - t142 - t141));
        force_h[72] = t2 * t114 + (t86 * t148 - t3 * t116);
        force_h[73] = t72 * t134 + (t88 * t149 - t98 * t135);
        force_h[74] = t75 * t134 + (t90 * t149 - t100 * t135);
        force_h[75] = t2 * t128 + (t92 * t148 + (-t146 - t145 - t3 * t130));
        force_h[76] = t80 * t134 + (t93 * t149 + (t150 - t103 * t135));
        force_h[77] = t83 * t134 + (t95 * t149 + (t140 - t105 * t135));
        force_h[78] = t3 * t115 + (t97 * t148 - t1 * t114);
        force_h[79] = t88 * t135 + (t98 * t149 - t72 * t136);
        force_h[80] = t90 * t135 + (t100 * t149 - t75 * t136);
        force_h[81] = t3 * t129 + (t102 * t148 + (t144 - t1 * t128));
        force_h[82] = t93 * t135 + (t103 * t149 + (t139 - t80 * t136 - t138 - t137));
        force_h[83] = t95 * t135 + (t105 * t149 + (t150 - t83 * t136));
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 301 additions, 399 multiplications, 1 divisions, 1 functions.
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
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = q_j[3] * h[5] + h[4] * q_j[4] - h[3] * q_j[5];
        let t1 = q_j[3] * h[3] + h[5] * q_j[5] - h[4] * q_j[6];
        let t2 = h[5] * q_j[6] + (h[3] * q_j[4] + h[4] * q_j[5]);
        let t3 = h[3] * q_j[6] + (q_j[3] * h[4] - h[5] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[3] * t1 + q_j[4] * t2) - q_j[6] * t3;
        let t5 = q_i[3] * h[2] + h[1] * q_i[4] - h[0] * q_i[5];
        let t6 = q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6];
        let t7 = h[2] * q_i[6] + (h[0] * q_i[4] + h[1] * q_i[5]);
        let t8 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t9 = q_i[5] * t5 + (q_i[3] * t6 + q_i[4] * t7) - q_i[6] * t8;
        let t10 = q_j[0] + t4 - (q_i[0] + t9);
        let t11 = q_j[6] * t2 + (q_j[3] * t0 + q_j[4] * t3 - q_j[5] * t1);
        let t12 = q_i[6] * t7 + (q_i[3] * t5 + q_i[4] * t8 - q_i[5] * t6);
        let t13 = q_j[2] + t11 - (q_i[2] + t12);
        let t14 = q_j[6] * t1 + (q_j[5] * t2 + (q_j[3] * t3 - q_j[4] * t0));
        let t15 = q_i[6] * t6 + (q_i[5] * t7 + (q_i[3] * t8 - q_i[4] * t5));
        let t16 = q_j[1] + t14 - (q_i[1] + t15);
        let t17 = one / (t13 * t13 + (t10 * t10 + t16 * t16)).sqrt();
        let t18 = t17 * t17;
        let t19 = v_j[6] * h[5] + (h[3] * v_j[4] + h[4] * v_j[5]);
        let t20 = v_j[3] * h[5] + (h[4] * v_j[4] - h[3] * v_j[5]);
        let t21 = h[3] * v_j[6] + v_j[3] * h[4] - h[5] * v_j[4];
        let t22 = v_j[3] * t0 + (t19 * q_j[6] + (q_j[3] * t20 + q_j[4] * t21));
        let t23 = h[5] * v_j[5] + (h[3] * v_j[3] - h[4] * v_j[6]);
        let t24 = v_j[6] * t2 + (v_j[4] * t3 + t22) - (t23 * q_j[5] + v_j[5] * t1);
        let t25 = v_i[6] * h[2] + (h[0] * v_i[4] + h[1] * v_i[5]);
        let t26 = v_i[3] * h[2] + (h[1] * v_i[4] - h[0] * v_i[5]);
        let t27 = h[0] * v_i[6] + v_i[3] * h[1] - h[2] * v_i[4];
        let t28 = v_i[3] * t5 + (t25 * q_i[6] + (q_i[3] * t26 + q_i[4] * t27));
        let t29 = h[2] * v_i[5] + (h[0] * v_i[3] - h[1] * v_i[6]);
        let t30 = v_i[6] * t7 + (v_i[4] * t8 + t28) - (t29 * q_i[5] + v_i[5] * t6);
        let t31 = v_j[2] + t24 - (v_i[2] + t30);
        let t32 = v_j[3] * t1 + (q_j[5] * t20 + (q_j[3] * t23 + q_j[4] * t19));
        let t33 = v_j[5] * t0 + (v_j[4] * t2 + t32) - (q_j[6] * t21 + v_j[6] * t3);
        let t34 = v_i[3] * t6 + (q_i[5] * t26 + (q_i[3] * t29 + q_i[4] * t25));
        let t35 = v_i[5] * t5 + (v_i[4] * t7 + t34) - (q_i[6] * t27 + v_i[6] * t8);
        let t36 = v_j[0] + t33 - (v_i[0] + t35);
        let t37 = v_j[3] * t3 + (t23 * q_j[6] + (q_j[3] * t21 + t19 * q_j[5]));
        let t38 = v_j[6] * t1 + (v_j[5] * t2 + t37) - (q_j[4] * t20 + v_j[4] * t0);
        let t39 = v_i[3] * t8 + (t29 * q_i[6] + (q_i[3] * t27 + t25 * q_i[5]));
        let t40 = v_i[6] * t6 + (v_i[5] * t7 + t39) - (q_i[4] * t26 + v_i[4] * t5);
        let t41 = v_j[1] + t38 - (v_i[1] + t40);
        let t42 = t13 * t31 + (t36 * t10 + t16 * t41);
        let t43 = t10 * t17 * t18 * t42 - t36 * t17;
        let t44 = t42 * (t18 * (t16 * t17)) - t17 * t41;
        let t45 = t42 * (t18 * (t13 * t17)) - t17 * t31;
        let t46 = t18 * (t17 * (t5 * t13 + (t6 * t10 + t8 * t16)));
        let t47 = t29 * t10 + (t5 * t31 + (t6 * t36 + t8 * t41));
        let t48 = t42 * t46 - t17 * (t26 * t13 + (t27 * t16 + t47));
        let t49 = t18 * (t17 * (t7 * t10 + t8 * t13 - t5 * t16));
        let t50 = t27 * t13 + (t25 * t10 + (t7 * t36 + t8 * t31));
        let t51 = t42 * t49 - t17 * (t50 - (t5 * t41 + t26 * t16));
        let t52 = t18 * (t17 * (t5 * t10 + (t7 * t16 - t6 * t13)));
        let t53 = t25 * t16 + (t26 * t10 + (t7 * t41 + t5 * t36));
        let t54 = t42 * t52 - t17 * (t53 - (t6 * t31 + t29 * t13));
        let t55 = t18 * (t17 * (t7 * t13 + t6 * t16 - t8 * t10));
        let t56 = t25 * t13 + (t29 * t16 + (t7 * t31 + t6 * t41));
        let t57 = t42 * t55 - t17 * (t56 - (t8 * t36 + t27 * t10));
        let t58 = t23 * t10 + (t0 * t31 + (t1 * t36 + t3 * t41));
        let t59 = t18 * (t17 * (t0 * t13 + (t1 * t10 + t3 * t16)));
        let t60 = t17 * (t20 * t13 + (t21 * t16 + t58)) - t42 * t59;
        let t61 = t21 * t13 + (t19 * t10 + (t2 * t36 + t3 * t31));
        let t62 = t18 * (t17 * (t2 * t10 + t3 * t13 - t0 * t16));
        let t63 = t17 * (t61 - (t0 * t41 + t20 * t16)) - t42 * t62;
        let t64 = t19 * t16 + (t20 * t10 + (t2 * t41 + t0 * t36));
        let t65 = t18 * (t17 * (t0 * t10 + (t2 * t16 - t1 * t13)));
        let t66 = t17 * (t64 - (t1 * t31 + t23 * t13)) - t42 * t65;
        let t67 = t19 * t13 + (t23 * t16 + (t2 * t31 + t1 * t41));
        let t68 = t18 * (t17 * (t2 * t13 + t1 * t16 - t3 * t10));
        let t69 = t17 * (t67 - (t3 * t36 + t21 * t10)) - t42 * t68;
        let t70 = q_i[4] * q_i[4];
        let t71 = q_i[3] * q_i[3];
        let t72 = q_i[5] * q_i[5];
        let t73 = q_i[6] * q_i[6];
        let t74 = t70 + (t71 - (t72 + t73));
        let t75 = q_i[3] * q_i[6];
        let t76 = q_i[4] * q_i[5];
        let t77 = t75 + t76;
        let t78 = q_i[4] * q_i[6];
        let t79 = q_i[3] * q_i[5];
        let t80 = t78 - t79;
        let t81 = t17 * (t10 * t74 + (t16 * t77 + t13 * t80) * two);
        let t82 = t36 * half;
        let t83 = v_i[6] * q_i[4] + v_i[4] * q_i[6];
        let t84 = q_i[3] * v_i[5] + v_i[3] * q_i[5];
        let t85 = q_i[3] * v_i[3];
        let t86 = q_i[4] * v_i[4];
        let t87 = v_i[5] * q_i[5];
        let t88 = v_i[6] * q_i[6];
        let t89 = v_i[5] * q_i[4] + v_i[4] * q_i[5];
        let t90 = q_i[3] * v_i[6] + v_i[3] * q_i[6];
        let t91 = t10 * (t85 + t86 - (t87 + t88)) + t16 * (t89 + t90);
        let t92 = t41 * t77 + (t74 * t82 + (t13 * (t83 - t84) + t91));
        let t93 = t42 * (t18 * t81) * half - t17 * (t31 * t80 + t92);
        let t94 = q_i[3] * q_i[4];
        let t95 = q_i[5] * q_i[6];
        let t96 = t94 + t95;
        let t97 = t76 - t75;
        let t98 = t72 + t71 - (t73 + t70);
        let t99 = t16 * half;
        let t100 = t18 * (t17 * (t13 * t96 + (t10 * t97 + t98 * t99)));
        let t101 = t41 * half;
        let t102 = v_i[6] * q_i[5] + v_i[5] * q_i[6];
        let t103 = q_i[3] * v_i[4] + v_i[3] * q_i[4];
        let t104 = t10 * (t89 - t90) + t16 * (t85 + t87 - (t86 + t88));
        let t105 = t98 * t101 + (t36 * t97 + (t13 * (t102 + t103) + t104));
        let t106 = t73 + t71 - (t72 + t70);
        let t107 = t13 * half;
        let t108 = t79 + t78;
        let t109 = t95 - t94;
        let t110 = t18 * (t17 * (t106 * t107 + (t10 * t108 + t16 * t109)));
        let t111 = t31 * half;
        let t112 = t13 * (t85 + t88 - (t86 + t87))
            + (t10 * (t84 + t83) + t16 * (t102 - t103));
        let t113 = t17 * (t106 * t111 + (t41 * t109 + (t36 * t108 + t112)));
        let t114 = q_j[4] * q_j[6];
        let t115 = q_j[3] * q_j[5];
        let t116 = t114 - t115;
        let t117 = q_j[3] * q_j[6];
        let t118 = q_j[4] * q_j[5];
        let t119 = t117 + t118;
        let t120 = q_j[4] * q_j[4];
        let t121 = q_j[3] * q_j[3];
        let t122 = q_j[5] * q_j[5];
        let t123 = q_j[6] * q_j[6];
        let t124 = t120 + (t121 - (t122 + t123));
        let t125 = v_j[6] * q_j[4] + v_j[4] * q_j[6];
        let t126 = q_j[3] * v_j[5] + v_j[3] * q_j[5];
        let t127 = q_j[3] * v_j[3];
        let t128 = q_j[4] * v_j[4];
        let t129 = v_j[5] * q_j[5];
        let t130 = v_j[6] * q_j[6];
        let t131 = v_j[5] * q_j[4] + v_j[4] * q_j[5];
        let t132 = q_j[3] * v_j[6] + v_j[3] * q_j[6];
        let t133 = t10 * (t127 + t128 - (t129 + t130)) + t16 * (t131 + t132);
        let t134 = t41 * t119 + (t82 * t124 + (t13 * (t125 - t126) + t133));
        let t135 = t17 * (t10 * t124 + (t16 * t119 + t13 * t116) * two);
        let t136 = t17 * (t31 * t116 + t134) - t42 * (t18 * t135) * half;
        let t137 = q_j[3] * q_j[4];
        let t138 = q_j[5] * q_j[6];
        let t139 = t137 + t138;
        let t140 = t122 + t121 - (t123 + t120);
        let t141 = t118 - t117;
        let t142 = v_j[6] * q_j[5] + v_j[5] * q_j[6];
        let t143 = q_j[3] * v_j[4] + v_j[3] * q_j[4];
        let t144 = t10 * (t131 - t132) + t16 * (t127 + t129 - (t128 + t130));
        let t145 = t101 * t140 + (t36 * t141 + (t13 * (t142 + t143) + t144));
        let t146 = t18 * (t17 * (t13 * t139 + (t10 * t141 + t99 * t140)));
        let t147 = t123 + t121 - (t122 + t120);
        let t148 = t138 - t137;
        let t149 = t115 + t114;
        let t150 = t13 * (t127 + t130 - (t128 + t129))
            + (t10 * (t126 + t125) + t16 * (t142 - t143));
        let t151 = t17 * (t111 * t147 + (t41 * t148 + (t36 * t149 + t150)));
        let t152 = t18 * (t17 * (t107 * t147 + (t10 * t149 + t16 * t148)));
        rate_q[0] = t43;
        rate_q[1] = t44;
        rate_q[2] = t45;
        rate_q[3] = t48 * two;
        rate_q[4] = t51 * two;
        rate_q[5] = t54 * two;
        rate_q[6] = t57 * two;
        rate_q[7] = -t43;
        rate_q[8] = -t44;
        rate_q[9] = -t45;
        rate_q[10] = t60 * two;
        rate_q[11] = t63 * two;
        rate_q[12] = t66 * two;
        rate_q[13] = t69 * two;
        rate_h[0] = t93 * two;
        rate_h[1] = (t42 * t100 - t17 * (t31 * t96 + t105)) * two;
        rate_h[2] = (t42 * t110 - t113) * two;
        rate_h[3] = t136 * two;
        rate_h[4] = (t17 * (t31 * t139 + t145) - t42 * t146) * two;
        rate_h[5] = (t151 - t42 * t152) * two;
    }
}
