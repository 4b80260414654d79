// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Prescribed coordinate of a point
///
/// `(A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i) − c = 0` (unit m)
///
/// Source: method paper, eq. (16), with a prescribed value.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `a_i` | 1 | body i | unit direction of the coordinate |
/// | 3..6 | `s_i` | m | body i | point where the coordinate is zero |
/// | 6..9 | `s_j` | m | body j | point whose coordinate is prescribed |
/// | 9 | `value` | m |  | the coordinate |
pub mod displacement {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "displacement",
        title: "Prescribed coordinate of a point",
        equation: "(A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i) − c = 0",
        reference: "method paper, eq. (16), with a prescribed value",
        bodies: 2,
        equations: 1,
        unit: "m",
        parameters: &[
            Parameter {
                name: "a_i",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "body i",
                meaning: "unit direction of the coordinate",
            },
            Parameter {
                name: "s_i",
                size: 3,
                offset: 3,
                unit: "m",
                frame: "body i",
                meaning: "point where the coordinate is zero",
            },
            Parameter {
                name: "s_j",
                size: 3,
                offset: 6,
                unit: "m",
                frame: "body j",
                meaning: "point whose coordinate is prescribed",
            },
            Parameter {
                name: "value",
                size: 1,
                offset: 9,
                unit: "m",
                frame: "",
                meaning: "the coordinate",
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
            (7, 3),
            (7, 4),
            (7, 5),
            (7, 6),
            (8, 3),
            (8, 4),
            (8, 5),
            (8, 6),
            (9, 3),
            (9, 4),
            (9, 5),
            (9, 6),
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
        design: &[
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
        ],
        force_design: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 0),
            (1, 1),
            (1, 2),
            (2, 0),
            (2, 1),
            (2, 2),
            (3, 0),
            (3, 1),
            (3, 2),
            (3, 3),
            (3, 4),
            (3, 5),
            (3, 6),
            (3, 7),
            (3, 8),
            (4, 0),
            (4, 1),
            (4, 2),
            (4, 3),
            (4, 4),
            (4, 5),
            (4, 6),
            (4, 7),
            (4, 8),
            (5, 0),
            (5, 1),
            (5, 2),
            (5, 3),
            (5, 4),
            (5, 5),
            (5, 6),
            (5, 7),
            (5, 8),
            (6, 0),
            (6, 1),
            (6, 2),
            (6, 3),
            (6, 4),
            (6, 5),
            (6, 6),
            (6, 7),
            (6, 8),
            (7, 0),
            (7, 1),
            (7, 2),
            (8, 0),
            (8, 1),
            (8, 2),
            (9, 0),
            (9, 1),
            (9, 2),
            (10, 0),
            (10, 1),
            (10, 2),
            (10, 6),
            (10, 7),
            (10, 8),
            (11, 0),
            (11, 1),
            (11, 2),
            (11, 6),
            (11, 7),
            (11, 8),
            (12, 0),
            (12, 1),
            (12, 2),
            (12, 6),
            (12, 7),
            (12, 8),
            (13, 0),
            (13, 1),
            (13, 2),
            (13, 6),
            (13, 7),
            (13, 8),
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
        rate_design: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 7),
            (0, 8),
        ],
        operations: [
            Operations {
                additions: 63,
                multiplications: 75,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 91,
                multiplications: 122,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 198,
                multiplications: 257,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 263,
                multiplications: 381,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 337,
                multiplications: 382,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Prescribed coordinate of a point
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Displacement;
    impl<S: Scalar> Relation<S> for Displacement {
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
    /// 63 additions, 75 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        phi: &mut [S; 1],
    ) {
        let t0 = h[8] * q_j[6] + (h[6] * q_j[4] + q_j[5] * h[7]);
        let t1 = q_j[3] * h[8] + h[7] * q_j[4] - h[6] * q_j[5];
        let t2 = h[6] * q_j[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t3 = q_j[3] * h[6] + q_j[5] * h[8] - q_j[6] * h[7];
        let t4 = q_j[6] * t0 + (q_j[3] * t1 + q_j[4] * t2 - q_j[5] * t3);
        let t5 = h[5] * q_i[6] + (h[3] * q_i[4] + q_i[5] * h[4]);
        let t6 = q_i[3] * h[5] + h[4] * q_i[4] - h[3] * q_i[5];
        let t7 = h[3] * q_i[6] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t8 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t9 = q_i[6] * t5 + (q_i[3] * t6 + q_i[4] * t7 - q_i[5] * t8);
        let t10 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t11 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t12 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t13 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t14 = q_i[6] * t10 + (q_i[3] * t11 + q_i[4] * t12 - q_i[5] * t13);
        let t15 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t16 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t17 = q_i[6] * t13 + (q_i[5] * t10 + (q_i[3] * t12 - q_i[4] * t11));
        let t18 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t19 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t20 = q_i[5] * t11 + (q_i[3] * t13 + q_i[4] * t10) - q_i[6] * t12;
        let t21 = (q_j[1] + t15 - q_i[1] - t16) * t17
            + ((q_j[0] + t18 - q_i[0] - t19) * t20 - h[9]);
        phi[0] = (q_j[2] + t4 - q_i[2] - t9) * t14 + t21;
    }
    /// Φ, Φ_q and W.
    ///
    /// 91 additions, 122 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[8] * q_j[6] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t1 = q_j[6] * h[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t2 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t3 = h[8] * q_j[5] + (q_j[3] * h[6] - h[7] * q_j[6]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t6 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t7 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t8 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t12 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t13 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t14 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t15 = q_i[6] * t11 + (q_i[4] * t12 + (q_i[3] * t13 - q_i[5] * t14));
        let t16 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t17 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t18 = q_j[1] + t16 - q_i[1] - t17;
        let t19 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t12 - q_i[4] * t13));
        let t20 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t21 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t22 = q_j[0] + t20 - q_i[0] - t21;
        let t23 = q_i[5] * t13 + (q_i[4] * t11 + (q_i[3] * t14 - q_i[6] * t12));
        let t24 = t13 * t10 - t8 * t23 - t6 * t19 - t7 * t15;
        let t25 = t7 * t19 - t5 * t23 - t6 * t15 - t13 * t18;
        let t26 = t22 * t13 - t5 * t19 - t7 * t23 - t14 * t10;
        let t27 = t6 * t23 - t5 * t15 - t8 * t19 - t22 * t12;
        phi[0] = t10 * t15 + (t18 * t19 + (t22 * t23 - h[9]));
        phi_q[0] = -t23;
        phi_q[1] = -t19;
        phi_q[2] = -t15;
        phi_q[3] = (t12 * t18 + (t22 * t14 + t24)) * two;
        phi_q[4] = (t12 * t10 + (t22 * t11 + t25)) * two;
        phi_q[5] = (t11 * t18 + (t8 * t15 + t26)) * two;
        phi_q[6] = (t11 * t10 + (t14 * t18 + t27)) * two;
        phi_q[7] = t23;
        phi_q[8] = t19;
        phi_q[9] = t15;
        phi_q[10] = (t1 * t19 + (t2 * t15 + t3 * t23)) * two;
        phi_q[11] = (t0 * t23 + (t1 * t15 - t2 * t19)) * two;
        phi_q[12] = (t2 * t23 + (t0 * t19 - t3 * t15)) * two;
        phi_q[13] = (t3 * t19 + (t0 * t15 - t1 * t23)) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 198 additions, 257 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
        curvature: &mut [S; 60],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[8] * q_j[6] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t1 = q_j[6] * h[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t2 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t3 = h[8] * q_j[5] + (q_j[3] * h[6] - h[7] * q_j[6]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t6 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t7 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t8 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t12 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t13 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t14 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t15 = q_i[6] * t11 + (q_i[4] * t12 + (q_i[3] * t13 - q_i[5] * t14));
        let t16 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t17 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t18 = q_j[1] + t16 - q_i[1] - t17;
        let t19 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t12 - q_i[4] * t13));
        let t20 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t21 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t22 = q_j[0] + t20 - q_i[0] - t21;
        let t23 = q_i[5] * t13 + (q_i[4] * t11 + (q_i[3] * t14 - q_i[6] * t12));
        let t24 = t13 * two;
        let t25 = t12 * two;
        let t26 = t14 * two;
        let t27 = t23 * two;
        let t28 = t19 * two;
        let t29 = t15 * two;
        let t30 = t22 * t26 - t8 * t27 - t6 * t28 - t7 * t29;
        let t31 = t11 * two;
        let t32 = t7 * t28 - t5 * t27 - t6 * t29 - t13 * t18 * two;
        let t33 = t8 * t29 - t5 * t28 - t7 * t27 - t14 * t10 * two;
        let t34 = t6 * t27 - t5 * t29 - t8 * t28 - t22 * t12 * two;
        let t35 = lambda[0] * two;
        let t36 = -(t14 * t35);
        let t37 = -(t12 * t35);
        let t38 = -(t13 * t35);
        let t39 = t8 * lambda[0];
        let t40 = t39 * k4;
        let t41 = t14 * lambda[0];
        let t42 = t41 * k4;
        let t43 = -(t14 * t40) - t8 * t42;
        let t44 = t10 * lambda[0] * two;
        let t45 = t15 * lambda[0] * two;
        let t46 = h[2] * t44 - h[5] * t45;
        let t47 = t43 + t46;
        let t48 = t18 * lambda[0] * two;
        let t49 = t19 * lambda[0] * two;
        let t50 = h[1] * t48 - h[4] * t49;
        let t51 = t22 * lambda[0] * two;
        let t52 = t23 * lambda[0] * two;
        let t53 = h[0] * t51 - h[3] * t52;
        let t54 = t6 * lambda[0];
        let t55 = t54 * k4;
        let t56 = t12 * lambda[0];
        let t57 = t56 * k4;
        let t58 = -(t12 * t55) - t6 * t57;
        let t59 = t7 * lambda[0];
        let t60 = t59 * k4;
        let t61 = t13 * lambda[0];
        let t62 = t61 * k4;
        let t63 = -(t13 * t60) - t7 * t62;
        let t64 = -(t11 * t35);
        let t65 = h[1] * t44 - h[4] * t45;
        let t66 = h[5] * t49;
        let t67 = t5 * t42;
        let t68 = t6 * t62;
        let t69 = t11 * k4;
        let t70 = t12 * t60;
        let t71 = h[2] * t48;
        let t72 = t7 * t57 + (t66 - t67 - t68 - t39 * t69 - t70 - t71);
        let t73 = t58 - t50;
        let t74 = t63 - t46;
        let t75 = t5 * lambda[0];
        let t76 = t11 * lambda[0];
        let t77 = t76 * k4;
        let t78 = -(t69 * t75) - t5 * t77;
        let t79 = h[2] * t51 - h[5] * t52 + (t14 * t60 + t8 * t62);
        let t80 = -(t54 * t69) - t5 * t57 + t79;
        let t81 = h[3] * t45;
        let t82 = h[0] * t44;
        let t83 = h[0] * t48 - h[3] * t49;
        let t84 = t14 * t55;
        let t85 = t8 * t57;
        let t86 = t5 * t62;
        let t87 = h[1] * t51;
        let t88 = t75 * k4;
        let t89 = h[4] * t52;
        let t90 = t85 + (t86 + (t87 - t7 * t77 - t13 * t88 - t89));
        let t91 = t78 - t53;
        let t92 = t12 * k4;
        let t93 = t89 + (t83 - t86 - t85 - t59 * t69 - t84 - t87);
        let t94 = t67 + (t71 + (t65 - t8 * t77 - t14 * t88 - t66));
        let t95 = t41 * two;
        let t96 = t76 * two;
        let t97 = t61 * two;
        let t98 = t56 * two;
        let t99 = t3 * t42;
        let t100 = t2 * t62;
        let t101 = t1 * t57;
        let t102 = t100 + t101;
        let t103 = t2 * t57;
        let t104 = t3 * t77;
        let t105 = t1 * t62;
        let t106 = t104 - t105;
        let t107 = t3 * t62;
        let t108 = t1 * t77;
        let t109 = t2 * t42;
        let t110 = t108 - t109;
        let t111 = t1 * t42;
        let t112 = t2 * t77;
        let t113 = t3 * t57;
        let t114 = t112 - t113;
        let t115 = h[6] * t52;
        let t116 = h[8] * t45;
        let t117 = h[7] * t49;
        let t118 = t0 * t42;
        let t119 = t118 - t103;
        let t120 = t0 * t77;
        let t121 = t0 * t62;
        let t122 = t121 - t111;
        let t123 = t0 * t57;
        let t124 = h[7] * t45;
        let t125 = h[8] * t49;
        let t126 = t123 - t107;
        let t127 = t99 + t120;
        let t128 = h[8] * t52;
        let t129 = h[6] * t45;
        let t130 = h[7] * t52;
        let t131 = h[6] * t49;
        let t132 = t117 - t116;
        phi[0] = t10 * t15 + (t18 * t19 + (t22 * t23 - h[9]));
        phi_q[0] = -t23;
        phi_q[1] = -t19;
        phi_q[2] = -t15;
        phi_q[3] = t10 * t24 + (t18 * t25 + t30);
        phi_q[4] = t10 * t25 + (t22 * t31 + t32);
        phi_q[5] = t18 * t31 + (t22 * t24 + t33);
        phi_q[6] = t10 * t31 + (t18 * t26 + t34);
        phi_q[7] = t23;
        phi_q[8] = t19;
        phi_q[9] = t15;
        phi_q[10] = t2 * t29 + (t3 * t27 + t1 * t28);
        phi_q[11] = t1 * t29 + (t0 * t27 - t2 * t28);
        phi_q[12] = t2 * t27 + (t0 * t28 - t3 * t29);
        phi_q[13] = t3 * t28 + (t0 * t29 - t1 * t27);
        curvature[0] = t36;
        curvature[1] = t37;
        curvature[2] = t38;
        curvature[3] = t47 + (t50 + (t53 + (t58 + t63)));
        curvature[4] = t64;
        curvature[5] = t24 * lambda[0];
        curvature[6] = t37;
        curvature[7] = t65 + (t13 * t55 + t72);
        curvature[8] = t73 + (t74 + (t53 + t78));
        curvature[9] = t38;
        curvature[10] = t64;
        curvature[11] = t26 * lambda[0];
        curvature[12] = t80 + (t81 - t7 * t42 - t13 * t40 - t82);
        curvature[13] = t83 + (t84 + (t11 * t60 + t90));
        curvature[14] = t91 + (t74 + (t50 + t43));
        curvature[15] = t25 * lambda[0];
        curvature[16] = t36;
        curvature[17] = t64;
        curvature[18] = t39 * t92 + (t6 * t42 + t93);
        curvature[19] = t75 * t92 + (t6 * t77 + (t82 + (t80 - t81)));
        curvature[20] = t70 + (t11 * t39 * k4 + (t68 + t94));
        curvature[21] = t91 + (t47 + t73);
        curvature[22] = t95;
        curvature[23] = t96;
        curvature[24] = t97;
        curvature[25] = -t98;
        curvature[26] = t98;
        curvature[27] = -t97;
        curvature[28] = t96;
        curvature[29] = t95;
        curvature[30] = t97;
        curvature[31] = t98;
        curvature[32] = -t95;
        curvature[33] = t96;
        curvature[34] = t99 + t102;
        curvature[35] = t103 + t106;
        curvature[36] = t107 + t110;
        curvature[37] = t111 + t114;
        curvature[38] = t115 + (t116 + t117);
        curvature[39] = t105 + t119;
        curvature[40] = t102 + t120;
        curvature[41] = t122 - t112;
        curvature[42] = t110 - t123;
        curvature[43] = t124 - t125;
        curvature[44] = t115 - t116 - t117;
        curvature[45] = t109 + t126;
        curvature[46] = t114 - t121;
        curvature[47] = t100 + t127;
        curvature[48] = t119 - t104;
        curvature[49] = t128 - t129;
        curvature[50] = t130 + t131;
        curvature[51] = t132 - t115;
        curvature[52] = t113 + t122;
        curvature[53] = t126 - t108;
        curvature[54] = t106 - t118;
        curvature[55] = t101 + t127;
        curvature[56] = t131 - t130;
        curvature[57] = t129 + t128;
        curvature[58] = t125 + t124;
        curvature[59] = -t132 - t115;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 263 additions, 381 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        lambda: &[S; 1],
        phi_h: &mut [S; 10],
        force_h: &mut [S; 78],
    ) {
        let two = S::from_f64(2.0);
        let minus_one = S::from_f64(-1.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_j[4] * h[7] + (q_j[3] * h[8] - h[6] * q_j[5]);
        let t1 = h[8] * q_j[6] + (h[6] * q_j[4] + q_j[5] * h[7]);
        let t2 = q_j[5] * h[8] + (h[6] * q_j[3] - h[7] * q_j[6]);
        let t3 = h[6] * q_j[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[6] * t3));
        let t5 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t6 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t7 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t8 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t9 = q_i[5] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[6] * t8));
        let t10 = q_j[0] + t4 - q_i[0] - t9;
        let t11 = q_i[3] * q_i[3];
        let t12 = q_i[4] * q_i[4];
        let t13 = q_i[6] * q_i[6];
        let t14 = q_i[5] * q_i[5];
        let t15 = t11 + t12 - t13 - t14;
        let t16 = q_i[3] * q_i[6];
        let t17 = q_i[4] * q_i[5];
        let t18 = t16 + t17;
        let t19 = q_j[6] * t2 + (q_j[5] * t1 + (q_j[3] * t3 - q_j[4] * t0));
        let t20 = q_i[6] * t7 + (q_i[5] * t6 + (q_i[3] * t8 - q_i[4] * t5));
        let t21 = q_j[1] + t19 - q_i[1] - t20;
        let t22 = t21 * two;
        let t23 = q_i[6] * q_i[4];
        let t24 = q_i[3] * q_i[5];
        let t25 = t23 - t24;
        let t26 = q_j[6] * t1 + (q_j[4] * t3 + (q_j[3] * t0 - q_j[5] * t2));
        let t27 = q_i[6] * t6 + (q_i[4] * t8 + (q_i[3] * t5 - q_i[5] * t7));
        let t28 = q_j[2] + t26 - q_i[2] - t27;
        let t29 = t28 * two;
        let t30 = t11 - t12;
        let t31 = t14 - t13;
        let t32 = t30 + t31;
        let t33 = t17 - t16;
        let t34 = t10 * two;
        let t35 = q_i[3] * q_i[4];
        let t36 = q_i[6] * q_i[5];
        let t37 = t35 + t36;
        let t38 = t30 - t31;
        let t39 = t24 + t23;
        let t40 = t36 - t35;
        let t41 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t42 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t43 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t44 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t45 = q_i[6] * t41 + (q_i[5] * t42 + (q_i[3] * t43 - q_i[4] * t44));
        let t46 = t45 * two;
        let t47 = q_i[6] * t42 + (q_i[4] * t43 + (q_i[3] * t44 - q_i[5] * t41));
        let t48 = t47 * two;
        let t49 = q_i[5] * t44 + (q_i[4] * t42 + (q_i[3] * t41 - q_i[6] * t43));
        let t50 = t49 * two;
        let t51 = q_j[3] * q_j[3];
        let t52 = q_j[4] * q_j[4];
        let t53 = q_j[6] * q_j[6];
        let t54 = q_j[5] * q_j[5];
        let t55 = t51 + t52 - t53 - t54;
        let t56 = q_j[3] * q_j[6];
        let t57 = q_j[5] * q_j[4];
        let t58 = t56 + t57;
        let t59 = q_j[4] * q_j[6];
        let t60 = q_j[5] * q_j[3];
        let t61 = t59 - t60;
        let t62 = t51 - t52;
        let t63 = t54 - t53;
        let t64 = t62 + t63;
        let t65 = t57 - t56;
        let t66 = q_j[3] * q_j[4];
        let t67 = q_j[5] * q_j[6];
        let t68 = t66 + t67;
        let t69 = t62 - t63;
        let t70 = t60 + t59;
        let t71 = t67 - t66;
        let t72 = t15 * lambda[0];
        let t73 = t33 * lambda[0];
        let t74 = t73 * two;
        let t75 = t39 * lambda[0];
        let t76 = t75 * two;
        let t77 = t18 * lambda[0];
        let t78 = t77 * two;
        let t79 = t32 * lambda[0];
        let t80 = t40 * lambda[0];
        let t81 = t80 * two;
        let t82 = t25 * lambda[0];
        let t83 = t82 * two;
        let t84 = t37 * lambda[0];
        let t85 = t84 * two;
        let t86 = t38 * lambda[0];
        let t87 = t21 * lambda[0];
        let t88 = q_i[6] * two;
        let t89 = t87 * t88;
        let t90 = t10 * lambda[0];
        let t91 = q_i[3] * two;
        let t92 = t90 * t91;
        let t93 = t28 * lambda[0];
        let t94 = q_i[5] * two;
        let t95 = t93 * t94;
        let t96 = t89 + (t92 - t95);
        let t97 = t77 * k4;
        let t98 = t82 * k4;
        let t99 = t72 * two;
        let t100 = q_i[4] * two;
        let t101 = t93 * t100;
        let t102 = t87 * t91;
        let t103 = t88 * t90;
        let t104 = t101 + (t102 - t103);
        let t105 = t73 * k4;
        let t106 = t84 * k4;
        let t107 = t79 * two;
        let t108 = t90 * t94;
        let t109 = t91 * t93;
        let t110 = t87 * t100;
        let t111 = t108 + (t109 - t110);
        let t112 = t75 * k4;
        let t113 = t80 * k4;
        let t114 = t86 * two;
        let t115 = t47 * lambda[0] * two;
        let t116 = q_i[5] * t115;
        let t117 = t45 * lambda[0] * two;
        let t118 = q_i[6] * t117;
        let t119 = t49 * lambda[0] * two;
        let t120 = q_i[3] * t119;
        let t121 = t116 + (-t118 - t120);
        let t122 = q_i[6] * t119;
        let t123 = q_i[4] * t115;
        let t124 = q_i[3] * t117;
        let t125 = t122 + (-t123 - t124);
        let t126 = q_i[4] * t117;
        let t127 = q_i[5] * t119;
        let t128 = q_i[3] * t115;
        let t129 = t126 + (-t127 - t128);
        let t130 = t61 * lambda[0];
        let t131 = t44 * k4;
        let t132 = t55 * lambda[0];
        let t133 = t132 * two;
        let t134 = t58 * lambda[0];
        let t135 = t43 * k4;
        let t136 = t68 * lambda[0];
        let t137 = t64 * lambda[0];
        let t138 = t137 * two;
        let t139 = t65 * lambda[0];
        let t140 = t41 * k4;
        let t141 = t71 * lambda[0];
        let t142 = t69 * lambda[0];
        let t143 = t142 * two;
        let t144 = t70 * lambda[0];
        let t145 = t88 * t93 + (t87 * t94 + t90 * t100);
        let t146 = -(q_i[5] * t117) - q_i[4] * t119 - q_i[6] * t115;
        let t147 = t42 * k4;
        let t148 = q_j[6] * t117;
        let t149 = q_j[3] * t119 - q_j[5] * t115;
        let t150 = t148 + t149;
        let t151 = q_j[4] * t115;
        let t152 = q_j[3] * t117 - q_j[6] * t119;
        let t153 = t151 + t152;
        let t154 = q_j[5] * t119;
        let t155 = q_j[3] * t115 - q_j[4] * t117;
        let t156 = t154 + t155;
        let t157 = t1 * k4;
        let t158 = q_j[6] * t115 + (q_j[4] * t119 + q_j[5] * t117);
        phi_h[0] = t10 * t15 + (t18 * t22 + t25 * t29);
        phi_h[1] = t21 * t32 + (t33 * t34 + t29 * t37);
        phi_h[2] = t28 * t38 + (t34 * t39 + t22 * t40);
        phi_h[3] = -(t18 * t46) - t25 * t48 - t15 * t49;
        phi_h[4] = -(t33 * t50) - t37 * t48 - t32 * t45;
        phi_h[5] = -(t39 * t50) - t40 * t46 - t38 * t47;
        phi_h[6] = t49 * t55 + (t46 * t58 + t48 * t61);
        phi_h[7] = t45 * t64 + (t50 * t65 + t48 * t68);
        phi_h[8] = t47 * t69 + (t50 * t70 + t46 * t71);
        phi_h[9] = minus_one;
        force_h[0] = -t72;
        force_h[1] = -t74;
        force_h[2] = -t76;
        force_h[3] = -t78;
        force_h[4] = -t79;
        force_h[5] = -t81;
        force_h[6] = -t83;
        force_h[7] = -t85;
        force_h[8] = -t86;
        force_h[9] = t96 - t8 * t97 - t5 * t98 - t7 * t99;
        force_h[10] = t104 - t7 * t105 - t5 * t106 - t8 * t107;
        force_h[11] = t111 - t7 * t112 - t8 * t113 - t5 * t114;
        force_h[12] = t121 - t43 * t97 - t44 * t98 - t41 * t99;
        force_h[13] = t125 - t41 * t105 - t44 * t106 - t43 * t107;
        force_h[14] = t129 - t41 * t112 - t43 * t113 - t44 * t114;
        force_h[15] = t130 * t131 + (t41 * t133 + t134 * t135);
        force_h[16] = t131 * t136 + (t43 * t138 + t139 * t140);
        force_h[17] = t135 * t141 + (t44 * t143 + t140 * t144);
        force_h[18] = t145 + (t5 * t97 - t8 * t98 - t6 * t99);
        force_h[19] = t5 * t107 + (t111 - t6 * t105 - t8 * t106);
        force_h[20] = t5 * t113 + (t103 - t6 * t112 - t102 - t101 - t8 * t114);
        force_h[21] = t146 + (t77 * t131 - t43 * t98 - t42 * t99);
        force_h[22] = t44 * t107 + (t129 - t42 * t105 - t43 * t106);
        force_h[23] = t80 * t131 + (t123 + (t124 - t42 * t112 - t122 - t43 * t114));
        force_h[24] = t135 * t130 + (t42 * t133 - t134 * t131);
        force_h[25] = t135 * t136 + (t139 * t147 - t44 * t137 * two);
        force_h[26] = t144 * t147 + (t43 * t143 - t131 * t141);
        force_h[27] = t7 * t98 + (t110 - t6 * t97 - t109 - t108 - t5 * t99);
        force_h[28] = t7 * t106 + (t145 - t5 * t105 - t6 * t107);
        force_h[29] = t7 * t114 + (t96 - t6 * t113 - t5 * t112);
        force_h[30] = t82 * t140 + (t127 + (t128 - t42 * t97 - t126 - t44 * t99));
        force_h[31] = t84 * t140 + (t146 - t44 * t105 - t42 * t107);
        force_h[32] = t41 * t114 + (t121 - t42 * t113 - t44 * t112);
        force_h[33] = t134 * t147 + (t44 * t133 - t130 * t140);
        force_h[34] = t131 * t139 + (t42 * t138 - t140 * t136);
        force_h[35] = t131 * t144 + (t141 * t147 - t41 * t142 * two);
        force_h[36] = t8 * t99 + (t104 - t6 * t98 - t7 * t97);
        force_h[37] = t8 * t105 + (t95 - t6 * t106 - t92 - t89 - t7 * t107);
        force_h[38] = t8 * t112 + (t145 - t7 * t113 - t6 * t114);
        force_h[39] = t43 * t99 + (t125 - t42 * t98 - t41 * t97);
        force_h[40] = t73 * t135 + (t118 + (t120 - t42 * t106 - t116 - t41 * t107));
        force_h[41] = t75 * t135 + (t146 - t41 * t113 - t42 * t114);
        force_h[42] = t134 * t140 + (t130 * t147 - t43 * t132 * two);
        force_h[43] = t136 * t147 + (t41 * t138 - t135 * t139);
        force_h[44] = t140 * t141 + (t42 * t143 - t135 * t144);
        force_h[45] = t72;
        force_h[46] = t74;
        force_h[47] = t76;
        force_h[48] = t78;
        force_h[49] = t79;
        force_h[50] = t81;
        force_h[51] = t83;
        force_h[52] = t85;
        force_h[53] = t86;
        force_h[54] = t0 * t98 + (t2 * t99 + t3 * t97);
        force_h[55] = t0 * t106 + (t3 * t107 + t2 * t105);
        force_h[56] = t3 * t113 + (t0 * t114 + t2 * t112);
        force_h[57] = t150;
        force_h[58] = t153;
        force_h[59] = t156;
        force_h[60] = t3 * t98 + (t1 * t99 - t0 * t97);
        force_h[61] = t3 * t106 + (t73 * t157 - t0 * t107);
        force_h[62] = t75 * t157 + (t3 * t114 - t0 * t113);
        force_h[63] = t158;
        force_h[64] = t156;
        force_h[65] = -t152 - t151;
        force_h[66] = t77 * t157 + (t0 * t99 - t2 * t98);
        force_h[67] = t0 * t105 + (t1 * t107 - t2 * t106);
        force_h[68] = t0 * t112 + (t80 * t157 - t2 * t114);
        force_h[69] = -t155 - t154;
        force_h[70] = t158;
        force_h[71] = t150;
        force_h[72] = t2 * t97 + (t82 * t157 - t3 * t99);
        force_h[73] = t84 * t157 + (t2 * t107 - t3 * t105);
        force_h[74] = t2 * t113 + (t1 * t114 - t3 * t112);
        force_h[75] = t153;
        force_h[76] = -t149 - t148;
        force_h[77] = t158;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 337 additions, 382 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 14],
        rate_h: &mut [S; 9],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[1] * q_i[4] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t1 = h[2] * q_i[6] + (h[0] * q_i[4] + h[1] * q_i[5]);
        let t2 = h[2] * q_i[5] + (h[0] * q_i[3] - h[1] * q_i[6]);
        let t3 = h[2] * v_i[3] + (v_i[4] * h[1] - h[0] * v_i[5]);
        let t4 = h[2] * v_i[6] + (v_i[4] * h[0] + h[1] * v_i[5]);
        let t5 = h[2] * v_i[5] + (h[0] * v_i[3] - v_i[6] * h[1]);
        let t6 = h[1] * v_i[3] + (h[0] * v_i[6] - h[2] * v_i[4]);
        let t7 = h[0] * q_i[6] + (h[1] * q_i[3] - h[2] * q_i[4]);
        let t8 = q_i[4] * t4 + (q_i[3] * t5 - t6 * q_i[6] - v_i[6] * t7);
        let t9 = v_i[5] * t0 + (v_i[4] * t1 + (v_i[3] * t2 + (q_i[5] * t3 + t8)));
        let t10 = t4 * q_i[5] + (t6 * q_i[3] - q_i[4] * t3 - v_i[4] * t0);
        let t11 = v_i[6] * t2 + (v_i[5] * t1 + (v_i[3] * t7 + (q_i[6] * t5 + t10)));
        let t12 = t6 * q_i[4] + (q_i[3] * t3 - t5 * q_i[5] - v_i[5] * t2);
        let t13 = v_i[6] * t1 + (v_i[4] * t7 + (v_i[3] * t0 + (q_i[6] * t4 + t12)));
        let t14 = h[8] * q_j[6] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t15 = q_j[6] * h[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t16 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t17 = h[8] * v_j[6] + (h[6] * v_j[4] + h[7] * v_j[5]);
        let t18 = h[7] * v_j[3] + (h[6] * v_j[6] - h[8] * v_j[4]);
        let t19 = h[8] * v_j[3] + (h[7] * v_j[4] - h[6] * v_j[5]);
        let t20 = h[8] * v_j[5] + (h[6] * v_j[3] - h[7] * v_j[6]);
        let t21 = h[8] * q_j[5] + (q_j[3] * h[6] - h[7] * q_j[6]);
        let t22 = q_j[4] * t18 + (q_j[3] * t19 - q_j[5] * t20 - t21 * v_j[5]);
        let t23 = t14 * v_j[6] + (t15 * v_j[4] + (t16 * v_j[3] + (q_j[6] * t17 + t22)));
        let t24 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t25 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t26 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t27 = v_i[6] * h[5] + (v_i[4] * h[3] + v_i[5] * h[4]);
        let t28 = v_i[3] * h[4] + (v_i[6] * h[3] - v_i[4] * h[5]);
        let t29 = v_i[3] * h[5] + (v_i[4] * h[4] - v_i[5] * h[3]);
        let t30 = v_i[5] * h[5] + (v_i[3] * h[3] - v_i[6] * h[4]);
        let t31 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t32 = q_i[4] * t28 + (q_i[3] * t29 - q_i[5] * t30 - v_i[5] * t31);
        let t33 = v_i[6] * t24 + (v_i[4] * t25 + (v_i[3] * t26 + (q_i[6] * t27 + t32)));
        let t34 = v_j[2] + t23 - v_i[2] - t33;
        let t35 = t34 * two;
        let t36 = q_j[5] * t17 + (q_j[3] * t18 - q_j[4] * t19 - t16 * v_j[4]);
        let t37 = t21 * v_j[6] + (t14 * v_j[5] + (t15 * v_j[3] + (q_j[6] * t20 + t36)));
        let t38 = q_i[5] * t27 + (q_i[3] * t28 - q_i[4] * t29 - v_i[4] * t26);
        let t39 = v_i[6] * t31 + (v_i[5] * t24 + (v_i[3] * t25 + (q_i[6] * t30 + t38)));
        let t40 = v_j[1] + t37 - v_i[1] - t39;
        let t41 = t40 * two;
        let t42 = q_j[4] * t17 + (q_j[3] * t20 - q_j[6] * t18 - t15 * v_j[6]);
        let t43 = t16 * v_j[5] + (t14 * v_j[4] + (t21 * v_j[3] + (q_j[5] * t19 + t42)));
        let t44 = q_i[4] * t27 + (q_i[3] * t30 - q_i[6] * t28 - v_i[6] * t25);
        let t45 = v_i[5] * t26 + (v_i[4] * t24 + (v_i[3] * t31 + (q_i[5] * t29 + t44)));
        let t46 = v_j[0] + t43 - v_i[0] - t45;
        let t47 = t46 * two;
        let t48 = q_j[6] * t14 + (q_j[4] * t15 + (q_j[3] * t16 - q_j[5] * t21));
        let t49 = q_i[6] * t24 + (q_i[4] * t25 + (q_i[3] * t26 - q_i[5] * t31));
        let t50 = q_j[2] + t48 - q_i[2] - t49;
        let t51 = t50 * two;
        let t52 = q_j[6] * t21 + (q_j[5] * t14 + (q_j[3] * t15 - q_j[4] * t16));
        let t53 = q_i[6] * t31 + (q_i[5] * t24 + (q_i[3] * t25 - q_i[4] * t26));
        let t54 = q_j[1] + t52 - q_i[1] - t53;
        let t55 = t54 * two;
        let t56 = q_j[5] * t16 + (q_j[4] * t14 + (q_j[3] * t21 - q_j[6] * t15));
        let t57 = q_i[5] * t26 + (q_i[4] * t24 + (q_i[3] * t31 - q_i[6] * t25));
        let t58 = q_j[0] + t56 - q_i[0] - t57;
        let t59 = t58 * two;
        let t60 = t9 * two;
        let t61 = t11 * two;
        let t62 = t13 * two;
        let t63 = t5 * t59 - t31 * t60 - t25 * t61 - t26 * t62;
        let t64 = q_i[5] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[6] * t7));
        let t65 = t64 * two;
        let t66 = q_i[6] * t2 + (q_i[5] * t1 + (q_i[3] * t7 - q_i[4] * t0));
        let t67 = t66 * two;
        let t68 = q_i[6] * t1 + (q_i[4] * t7 + (q_i[3] * t0 - q_i[5] * t2));
        let t69 = t68 * two;
        let t70 = t6 * t55 + (t63 - t30 * t65 - t28 * t67 - t29 * t69);
        let t71 = t61 * t26 - t60 * t24 - t25 * t62 - t3 * t54 * two;
        let t72 = t71 - t0 * t40 * two - t65 * t27 - t28 * t69;
        let t73 = t7 * t35 + (t1 * t47 + (t6 * t51 + (t4 * t59 + t72)));
        let t74 = t31 * t62 - t61 * t24 - t60 * t26 - t5 * t50 * two;
        let t75 = t74 - t2 * t34 * two - t65 * t29 - t67 * t27;
        let t76 = t0 * t47 + (t1 * t41 + (t4 * t55 + (t3 * t59 + t75)));
        let t77 = t60 * t25 - t62 * t24 - t31 * t61 - t6 * t58 * two;
        let t78 = t77 - t7 * t46 * two - t30 * t67 - t69 * t27;
        let t79 = t2 * t41 + (t1 * t35 + (t4 * t51 + (t5 * t55 + t78)));
        let t80 = t65 * t20 + (t62 * t16 + (t60 * t21 + t61 * t15));
        let t81 = t62 * t15 + (t60 * t14 - t61 * t16 - t67 * t19);
        let t82 = t60 * t16 + (t61 * t14 - t62 * t21 - t69 * t20);
        let t83 = t61 * t21 + (t62 * t14 - t60 * t15 - t65 * t18);
        let t84 = q_i[3] * q_i[3];
        let t85 = q_i[4] * q_i[4];
        let t86 = q_i[6] * q_i[6];
        let t87 = q_i[5] * q_i[5];
        let t88 = t84 + t85 - t86 - t87;
        let t89 = q_i[6] * q_i[4];
        let t90 = q_i[3] * q_i[5];
        let t91 = t89 - t90;
        let t92 = q_i[6] * q_i[3];
        let t93 = q_i[4] * q_i[5];
        let t94 = t92 + t93;
        let t95 = v_i[4] * q_i[6] + v_i[6] * q_i[4];
        let t96 = q_i[3] * v_i[5];
        let t97 = v_i[3] * q_i[5];
        let t98 = t95 - t96 - t97;
        let t99 = v_i[4] * q_i[4];
        let t100 = v_i[3] * q_i[3];
        let t101 = v_i[6] * q_i[6];
        let t102 = v_i[5] * q_i[5];
        let t103 = t99 + t100 - t101 - t102;
        let t104 = v_i[4] * q_i[5] + q_i[4] * v_i[5];
        let t105 = v_i[6] * q_i[3];
        let t106 = v_i[3] * q_i[6];
        let t107 = t104 + (t105 + t106);
        let t108 = t41 * t94 + (t51 * t98 + (t59 * t103 + t55 * t107));
        let t109 = t84 - t85;
        let t110 = t87 - t86;
        let t111 = t109 + t110;
        let t112 = q_i[4] * q_i[3];
        let t113 = q_i[6] * q_i[5];
        let t114 = t112 + t113;
        let t115 = t93 - t92;
        let t116 = q_i[6] * v_i[5] + v_i[6] * q_i[5];
        let t117 = v_i[4] * q_i[3];
        let t118 = v_i[3] * q_i[4];
        let t119 = t116 + (t117 + t118);
        let t120 = t104 - t105 - t106;
        let t121 = t100 - t99;
        let t122 = t121 + (t102 - t101);
        let t123 = t47 * t115 + (t51 * t119 + (t59 * t120 + t55 * t122));
        let t124 = t109 - t110;
        let t125 = t113 - t112;
        let t126 = t90 + t89;
        let t127 = t101 + (t121 - t102);
        let t128 = t97 + (t96 + t95);
        let t129 = t116 - t117 - t118;
        let t130 = t47 * t126 + (t51 * t127 + (t59 * t128 + t55 * t129));
        let t131 = -(t65 * t103) - t67 * t107 - t69 * t98 - t61 * t94;
        let t132 = -(t65 * t120) - t67 * t122 - t69 * t119 - t60 * t115;
        let t133 = -(t65 * t128) - t67 * t129 - t69 * t127 - t60 * t126;
        let t134 = q_j[3] * q_j[3];
        let t135 = q_j[4] * q_j[4];
        let t136 = q_j[6] * q_j[6];
        let t137 = q_j[5] * q_j[5];
        let t138 = q_j[4] * q_j[6];
        let t139 = q_j[3] * q_j[5];
        let t140 = q_j[3] * q_j[6];
        let t141 = q_j[4] * q_j[5];
        let t142 = q_j[6] * v_j[4] + q_j[4] * v_j[6];
        let t143 = q_j[3] * v_j[5];
        let t144 = q_j[5] * v_j[3];
        let t145 = q_j[4] * v_j[4];
        let t146 = q_j[3] * v_j[3];
        let t147 = q_j[6] * v_j[6];
        let t148 = q_j[5] * v_j[5];
        let t149 = q_j[5] * v_j[4] + q_j[4] * v_j[5];
        let t150 = q_j[3] * v_j[6];
        let t151 = q_j[6] * v_j[3];
        let t152 = t65 * (t145 + t146 - t147 - t148) + t67 * (t149 + (t150 + t151));
        let t153 = t61 * (t140 + t141) + (t69 * (t142 - t143 - t144) + t152);
        let t154 = t134 - t135;
        let t155 = t137 - t136;
        let t156 = q_j[4] * q_j[3];
        let t157 = q_j[6] * q_j[5];
        let t158 = q_j[6] * v_j[5] + q_j[5] * v_j[6];
        let t159 = q_j[3] * v_j[4];
        let t160 = q_j[4] * v_j[3];
        let t161 = t146 - t145;
        let t162 = t65 * (t149 - t150 - t151) + t67 * (t161 + (t148 - t147));
        let t163 = t60 * (t141 - t140) + (t69 * (t158 + (t159 + t160)) + t162);
        let t164 = t65 * (t144 + (t143 + t142)) + t67 * (t158 - t159 - t160);
        let t165 = t60 * (t139 + t138) + (t69 * (t147 + (t161 - t148)) + t164);
        rate_q[0] = -t9;
        rate_q[1] = -t11;
        rate_q[2] = -t13;
        rate_q[3] = t0 * t35 + (t7 * t41 + (t2 * t47 + (t3 * t51 + t70)));
        rate_q[4] = t67 * t29 + t73;
        rate_q[5] = t30 * t69 + t76;
        rate_q[6] = t65 * t28 + t79;
        rate_q[7] = t9;
        rate_q[8] = t11;
        rate_q[9] = t13;
        rate_q[10] = t69 * t19 + (t67 * t18 + t80);
        rate_q[11] = t69 * t18 + (t65 * t17 + t81);
        rate_q[12] = t67 * t17 + (t65 * t19 + t82);
        rate_q[13] = t69 * t17 + (t67 * t20 + t83);
        rate_h[0] = t46 * t88 + (t35 * t91 + t108);
        rate_h[1] = t40 * t111 + (t35 * t114 + t123);
        rate_h[2] = t34 * t124 + (t41 * t125 + t130);
        rate_h[3] = t131 - t62 * t91 - t9 * t88;
        rate_h[4] = t132 - t62 * t114 - t11 * t111;
        rate_h[5] = t133 - t61 * t125 - t13 * t124;
        rate_h[6] = t9 * (t134 + t135 - t136 - t137) + (t62 * (t138 - t139) + t153);
        rate_h[7] = t11 * (t154 + t155) + (t62 * (t156 + t157) + t163);
        rate_h[8] = t13 * (t154 - t155) + (t61 * (t157 - t156) + t165);
    }
}
