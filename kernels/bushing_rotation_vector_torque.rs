// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Rotation vector in a bushing, with torques about its axes
///
/// `Bᵀ θ = 0, A_iᵀ A_j the rotation by |θ| about θ; torques about B = [x_i y_i z_i]` (unit 1)
///
/// Source: θ = 2 (e/e0) g(|e|²/e0²), g(x) = atan(√x)/√x, from e = e0 tan(|θ|/2) θ/|θ|: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.3.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `x_i` | 1 | body i | unit vector of the first bushing axis |
/// | 3..6 | `y_i` | 1 | body i | unit vector of the second bushing axis |
/// | 6..9 | `z_i` | 1 | body i | unit vector of the third bushing axis |
pub mod bushing_rotation_vector_torque {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "bushing_rotation_vector_torque",
        title: "Rotation vector in a bushing, with torques about its axes",
        equation: "Bᵀ θ = 0, A_iᵀ A_j the rotation by |θ| about θ; torques about B = [x_i y_i z_i]",
        reference: "θ = 2 (e/e0) g(|e|²/e0²), g(x) = atan(√x)/√x, from e = e0 tan(|θ|/2) θ/|θ|: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.3",
        bodies: 2,
        equations: 3,
        unit: "1",
        parameters: &[
            Parameter {
                name: "x_i",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "body i",
                meaning: "unit vector of the first bushing axis",
            },
            Parameter {
                name: "y_i",
                size: 3,
                offset: 3,
                unit: "1",
                frame: "body i",
                meaning: "unit vector of the second bushing axis",
            },
            Parameter {
                name: "z_i",
                size: 3,
                offset: 6,
                unit: "1",
                frame: "body i",
                meaning: "unit vector of the third bushing axis",
            },
        ],
        jacobian: &[
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
        work: &[
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
        curvature: &[
            (3, 3),
            (3, 4),
            (3, 5),
            (3, 6),
            (4, 3),
            (4, 4),
            (4, 5),
            (4, 6),
            (5, 3),
            (5, 4),
            (5, 5),
            (5, 6),
            (6, 3),
            (6, 4),
            (6, 5),
            (6, 6),
            (10, 3),
            (10, 4),
            (10, 5),
            (10, 6),
            (10, 11),
            (10, 12),
            (10, 13),
            (11, 3),
            (11, 4),
            (11, 5),
            (11, 6),
            (11, 10),
            (11, 12),
            (11, 13),
            (12, 3),
            (12, 4),
            (12, 5),
            (12, 6),
            (12, 10),
            (12, 11),
            (12, 13),
            (13, 3),
            (13, 4),
            (13, 5),
            (13, 6),
            (13, 10),
            (13, 11),
            (13, 12),
        ],
        design: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 3),
            (1, 4),
            (1, 5),
            (2, 6),
            (2, 7),
            (2, 8),
        ],
        force_design: &[
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
            (10, 0),
            (10, 1),
            (10, 2),
            (10, 3),
            (10, 4),
            (10, 5),
            (10, 6),
            (10, 7),
            (10, 8),
            (11, 0),
            (11, 1),
            (11, 2),
            (11, 3),
            (11, 4),
            (11, 5),
            (11, 6),
            (11, 7),
            (11, 8),
            (12, 0),
            (12, 1),
            (12, 2),
            (12, 3),
            (12, 4),
            (12, 5),
            (12, 6),
            (12, 7),
            (12, 8),
            (13, 0),
            (13, 1),
            (13, 2),
            (13, 3),
            (13, 4),
            (13, 5),
            (13, 6),
            (13, 7),
            (13, 8),
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
            (1, 3),
            (1, 4),
            (1, 5),
            (2, 6),
            (2, 7),
            (2, 8),
        ],
        operations: [
            Operations {
                additions: 20,
                multiplications: 40,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 223,
                multiplications: 406,
                divisions: 1,
                functions: 2,
            },
            Operations {
                additions: 417,
                multiplications: 606,
                divisions: 1,
                functions: 2,
            },
            Operations {
                additions: 75,
                multiplications: 209,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 290,
                multiplications: 458,
                divisions: 1,
                functions: 3,
            },
        ],
    };
    /// Rotation vector in a bushing, with torques about its axes
    #[derive(Clone, Copy, Debug, Default)]
    pub struct BushingRotationVectorTorque;
    impl<S: Scalar> Relation<S> for BushingRotationVectorTorque {
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
    /// 20 additions, 40 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 9],
        phi: &mut [S; 3],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let t0 = q_i[4] * q_j[5] + q_j[3] * q_i[6] - (q_j[6] * q_i[3] + q_i[5] * q_j[4]);
        let t1 = q_j[6] * q_i[6]
            + (q_i[5] * q_j[5] + (q_j[3] * q_i[3] + q_i[4] * q_j[4]));
        let t2 = one / t1;
        let t3 = q_i[4] * q_j[3] + q_i[5] * q_j[6] - (q_i[3] * q_j[4] + q_i[6] * q_j[5]);
        let t4 = q_j[3] * q_i[5] + q_j[4] * q_i[6] - (q_i[3] * q_j[5] + q_i[4] * q_j[6]);
        let t5 = (t0 * t0 + (t3 * t3 + t4 * t4)) * (t2 * t2);
        let t6 = t2 * t5.atan_ratio(0);
        let t7 = t0 * t6;
        let t8 = t3 * t6;
        let t9 = t4 * t6;
        phi[0] = -((h[2] * t7 + (h[0] * t8 + h[1] * t9)) * two);
        phi[1] = -((t7 * h[5] + (t8 * h[3] + t9 * h[4])) * two);
        phi[2] = -((t7 * h[8] + (t8 * h[6] + t9 * h[7])) * two);
    }
    /// Φ, Φ_q and W.
    ///
    /// 223 additions, 406 multiplications, 1 divisions, 2 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 9],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        work: &mut [S; 24],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = q_i[5] * q_j[6] + (q_i[4] * q_j[3] - q_i[3] * q_j[4] - q_j[5] * q_i[6]);
        let t1 = q_i[6] * q_j[6]
            + (q_j[5] * q_i[5] + (q_i[3] * q_j[3] + q_j[4] * q_i[4]));
        let t2 = one / t1;
        let t3 = q_i[6] * q_j[3] + (q_j[5] * q_i[4] - q_i[3] * q_j[6] - q_j[4] * q_i[5]);
        let t4 = q_j[4] * q_i[6] + (q_j[3] * q_i[5] - q_i[3] * q_j[5] - q_i[4] * q_j[6]);
        let t5 = t3 * t3 + (t0 * t0 + t4 * t4);
        let t6 = t2 * t2;
        let t7 = t5 * t6;
        let t8 = t7.atan_ratio(0);
        let t9 = t2 * t8;
        let t10 = t0 * t9;
        let t11 = h[0] * two;
        let t12 = t4 * t9;
        let t13 = h[1] * two;
        let t14 = t3 * t9;
        let t15 = h[2] * two;
        let t16 = h[3] * two;
        let t17 = h[4] * two;
        let t18 = h[5] * two;
        let t19 = h[6] * two;
        let t20 = h[7] * two;
        let t21 = h[8] * two;
        let t22 = q_j[3] * t6;
        let t23 = t8 * half;
        let t24 = t2 * t5;
        let t25 = t22 * t24 + t6 * (q_j[6] * t3 + (q_j[4] * t0 + q_j[5] * t4));
        let t26 = t7.atan_ratio(1);
        let t27 = t22 * t23 + t2 * (t25 * t26);
        let t28 = t3 * two;
        let t29 = q_j[6] * t9;
        let t30 = (t27 * t28 + t29) * two;
        let t31 = t0 * two;
        let t32 = q_j[4] * t9;
        let t33 = (t27 * t31 + t32) * two;
        let t34 = t4 * two;
        let t35 = q_j[5] * t9;
        let t36 = (t27 * t34 + t35) * two;
        let t37 = q_j[4] * t6;
        let t38 = t6 * (q_j[5] * t3 + (q_j[3] * t0 - q_j[6] * t4)) - t24 * t37;
        let t39 = t2 * (t26 * t38) - t23 * t37;
        let t40 = q_j[3] * t9;
        let t41 = t31 * t39 + t40;
        let t42 = t34 * t39 - t29;
        let t43 = t35 + t28 * t39;
        let t44 = q_j[5] * t6;
        let t45 = t6 * (q_j[6] * t0 + (q_j[3] * t4 - q_j[4] * t3)) - t24 * t44;
        let t46 = t2 * (t26 * t45) - t23 * t44;
        let t47 = t29 + t31 * t46;
        let t48 = t40 + t34 * t46;
        let t49 = t28 * t46 - t32;
        let t50 = q_j[6] * t6;
        let t51 = t6 * (q_j[4] * t4 + (q_j[3] * t3 - q_j[5] * t0)) - t24 * t50;
        let t52 = t2 * (t26 * t51) - t23 * t50;
        let t53 = t31 * t52 - t35;
        let t54 = t32 + t34 * t52;
        let t55 = t40 + t28 * t52;
        let t56 = q_i[3] * t6;
        let t57 = t6 * (q_i[6] * t3 + (q_i[4] * t0 + q_i[5] * t4)) - t24 * t56;
        let t58 = t2 * (t26 * t57) - t23 * t56;
        let t59 = q_i[4] * t9;
        let t60 = t31 * t58 + t59;
        let t61 = q_i[5] * t9;
        let t62 = t34 * t58 + t61;
        let t63 = q_i[6] * t9;
        let t64 = t28 * t58 + t63;
        let t65 = q_i[4] * t6;
        let t66 = t24 * t65 + t6 * (q_i[5] * t3 + (q_i[3] * t0 - q_i[6] * t4));
        let t67 = t23 * t65 + t2 * (t26 * t66);
        let t68 = (t61 + t28 * t67) * two;
        let t69 = q_i[3] * t9;
        let t70 = (t31 * t67 + t69) * two;
        let t71 = t63 - t4 * t67 * two;
        let t72 = q_i[5] * t6;
        let t73 = t24 * t72 + t6 * (q_i[6] * t0 + (q_i[3] * t4 - q_i[4] * t3));
        let t74 = t23 * t72 + t2 * (t26 * t73);
        let t75 = (t69 + t34 * t74) * two;
        let t76 = (t63 + t31 * t74) * two;
        let t77 = t59 - t3 * t74 * two;
        let t78 = q_i[6] * t6;
        let t79 = t24 * t78 + t6 * (q_i[4] * t4 + (q_i[3] * t3 - q_i[5] * t0));
        let t80 = t23 * t78 + t2 * (t26 * t79);
        let t81 = (t69 + t28 * t80) * two;
        let t82 = (t59 + t34 * t80) * two;
        let t83 = t61 - t0 * t80 * two;
        let t84 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t85 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t86 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t87 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t88 = q_i[6] * t84 + (q_i[4] * t85 + (q_i[3] * t86 - q_i[5] * t87));
        let t89 = q_i[6] * two;
        let t90 = q_i[5] * t86 + (q_i[4] * t84 + (q_i[3] * t87 - q_i[6] * t85));
        let t91 = q_i[4] * two;
        let t92 = q_i[6] * t87 + (q_i[5] * t84 + (q_i[3] * t85 - q_i[4] * t86));
        let t93 = q_i[5] * two;
        let t94 = q_i[3] * two;
        let t95 = q_j[4] * two;
        let t96 = q_j[5] * two;
        let t97 = q_j[6] * two;
        let t98 = q_j[3] * two;
        let t99 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t100 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t101 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t102 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t103 = q_i[6] * t99 + (q_i[4] * t100 + (q_i[3] * t101 - q_i[5] * t102));
        let t104 = q_i[5] * t101 + (q_i[4] * t99 + (q_i[3] * t102 - q_i[6] * t100));
        let t105 = q_i[6] * t102 + (q_i[5] * t99 + (q_i[3] * t100 - q_i[4] * t101));
        let t106 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t107 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t108 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t109 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t110 = q_i[6] * t106 + (q_i[4] * t107 + (q_i[3] * t108 - q_i[5] * t109));
        let t111 = q_i[5] * t108 + (q_i[4] * t106 + (q_i[3] * t109 - q_i[6] * t107));
        let t112 = q_i[6] * t109 + (q_i[5] * t106 + (q_i[3] * t107 - q_i[4] * t108));
        phi[0] = -(t10 * t11) - t12 * t13 - t14 * t15;
        phi[1] = -(t10 * t16) - t12 * t17 - t14 * t18;
        phi[2] = -(t10 * t19) - t12 * t20 - t14 * t21;
        phi_q[0] = h[2] * t30 + (h[0] * t33 + h[1] * t36);
        phi_q[1] = -(t11 * t41) - t13 * t42 - t15 * t43;
        phi_q[2] = -(t11 * t47) - t13 * t48 - t15 * t49;
        phi_q[3] = -(t11 * t53) - t13 * t54 - t15 * t55;
        phi_q[4] = -(t11 * t60) - t13 * t62 - t15 * t64;
        phi_q[5] = h[2] * t68 + (h[0] * t70 - t13 * t71);
        phi_q[6] = h[1] * t75 + (h[0] * t76 - t15 * t77);
        phi_q[7] = h[2] * t81 + (h[1] * t82 - t11 * t83);
        phi_q[8] = h[5] * t30 + (h[3] * t33 + h[4] * t36);
        phi_q[9] = -(t16 * t41) - t17 * t42 - t18 * t43;
        phi_q[10] = -(t16 * t47) - t17 * t48 - t18 * t49;
        phi_q[11] = -(t16 * t53) - t17 * t54 - t18 * t55;
        phi_q[12] = -(t16 * t60) - t17 * t62 - t18 * t64;
        phi_q[13] = h[5] * t68 + (h[3] * t70 - t17 * t71);
        phi_q[14] = h[4] * t75 + (h[3] * t76 - t18 * t77);
        phi_q[15] = h[5] * t81 + (h[4] * t82 - t16 * t83);
        phi_q[16] = h[8] * t30 + (h[6] * t33 + h[7] * t36);
        phi_q[17] = -(t19 * t41) - t20 * t42 - t21 * t43;
        phi_q[18] = -(t19 * t47) - t20 * t48 - t21 * t49;
        phi_q[19] = -(t19 * t53) - t20 * t54 - t21 * t55;
        phi_q[20] = -(t19 * t60) - t20 * t62 - t21 * t64;
        phi_q[21] = h[8] * t68 + (h[6] * t70 - t20 * t71);
        phi_q[22] = h[7] * t75 + (h[6] * t76 - t21 * t77);
        phi_q[23] = h[8] * t81 + (h[7] * t82 - t19 * t83);
        work[0] = t88 * t89 + (t90 * t91 + t92 * t93);
        work[1] = t93 * t88 - t90 * t94 - t92 * t89;
        work[2] = t90 * t89 - t92 * t94 - t91 * t88;
        work[3] = t91 * t92 - t88 * t94 - t90 * t93;
        work[4] = -(t90 * t95) - t92 * t96 - t88 * t97;
        work[5] = t92 * t97 + (t90 * t98 - t88 * t96);
        work[6] = t88 * t95 + (t92 * t98 - t90 * t97);
        work[7] = t90 * t96 + (t88 * t98 - t92 * t95);
        work[8] = t89 * t103 + (t91 * t104 + t93 * t105);
        work[9] = t93 * t103 - t94 * t104 - t89 * t105;
        work[10] = t89 * t104 - t94 * t105 - t91 * t103;
        work[11] = t91 * t105 - t94 * t103 - t93 * t104;
        work[12] = -(t95 * t104) - t96 * t105 - t97 * t103;
        work[13] = t97 * t105 + (t98 * t104 - t96 * t103);
        work[14] = t95 * t103 + (t98 * t105 - t97 * t104);
        work[15] = t96 * t104 + (t98 * t103 - t95 * t105);
        work[16] = t89 * t110 + (t91 * t111 + t93 * t112);
        work[17] = t93 * t110 - t94 * t111 - t89 * t112;
        work[18] = t89 * t111 - t94 * t112 - t91 * t110;
        work[19] = t91 * t112 - t94 * t110 - t93 * t111;
        work[20] = -(t95 * t111) - t96 * t112 - t97 * t110;
        work[21] = t97 * t112 + (t98 * t111 - t96 * t110);
        work[22] = t95 * t110 + (t98 * t112 - t97 * t111);
        work[23] = t96 * t111 + (t98 * t110 - t95 * t112);
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 417 additions, 606 multiplications, 1 divisions, 2 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 9],
        lambda: &[S; 3],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        work: &mut [S; 24],
        curvature: &mut [S; 44],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let k4 = S::from_f64(4.0);
        let t0 = q_i[5] * q_j[6] + (q_i[4] * q_j[3] - q_i[3] * q_j[4] - q_j[5] * q_i[6]);
        let t1 = q_i[6] * q_j[6]
            + (q_j[5] * q_i[5] + (q_i[3] * q_j[3] + q_j[4] * q_i[4]));
        let t2 = one / t1;
        let t3 = q_i[6] * q_j[3] + (q_j[5] * q_i[4] - q_i[3] * q_j[6] - q_j[4] * q_i[5]);
        let t4 = q_j[4] * q_i[6] + (q_j[3] * q_i[5] - q_i[3] * q_j[5] - q_i[4] * q_j[6]);
        let t5 = t3 * t3 + (t0 * t0 + t4 * t4);
        let t6 = t2 * t2;
        let t7 = t5 * t6;
        let t8 = t7.atan_ratio(0);
        let t9 = t2 * t8;
        let t10 = t0 * t9;
        let t11 = h[0] * two;
        let t12 = t4 * t9;
        let t13 = h[1] * two;
        let t14 = t3 * t9;
        let t15 = h[2] * two;
        let t16 = h[3] * two;
        let t17 = h[4] * two;
        let t18 = h[5] * two;
        let t19 = h[6] * two;
        let t20 = h[7] * two;
        let t21 = h[8] * two;
        let t22 = q_j[3] * t6;
        let t23 = t8 * half;
        let t24 = t2 * t5;
        let t25 = t22 * t24 + t6 * (q_j[6] * t3 + (q_j[4] * t0 + q_j[5] * t4));
        let t26 = t7.atan_ratio(1);
        let t27 = t22 * t23 + t2 * (t25 * t26);
        let t28 = t3 * two;
        let t29 = q_j[6] * t9;
        let t30 = (t27 * t28 + t29) * two;
        let t31 = t0 * two;
        let t32 = q_j[4] * t9;
        let t33 = (t27 * t31 + t32) * two;
        let t34 = t4 * two;
        let t35 = q_j[5] * t9;
        let t36 = (t27 * t34 + t35) * two;
        let t37 = q_j[4] * t6;
        let t38 = t6 * (q_j[5] * t3 + (q_j[3] * t0 - q_j[6] * t4)) - t24 * t37;
        let t39 = t2 * (t26 * t38) - t23 * t37;
        let t40 = q_j[3] * t9;
        let t41 = t31 * t39 + t40;
        let t42 = t34 * t39 - t29;
        let t43 = t35 + t28 * t39;
        let t44 = q_j[5] * t6;
        let t45 = t6 * (q_j[6] * t0 + (q_j[3] * t4 - q_j[4] * t3)) - t24 * t44;
        let t46 = t2 * (t26 * t45) - t23 * t44;
        let t47 = t29 + t31 * t46;
        let t48 = t40 + t34 * t46;
        let t49 = t28 * t46 - t32;
        let t50 = q_j[6] * t6;
        let t51 = t6 * (q_j[4] * t4 + (q_j[3] * t3 - q_j[5] * t0)) - t24 * t50;
        let t52 = t2 * (t26 * t51) - t23 * t50;
        let t53 = t31 * t52 - t35;
        let t54 = t32 + t34 * t52;
        let t55 = t40 + t28 * t52;
        let t56 = q_i[3] * t6;
        let t57 = t6 * (q_i[6] * t3 + (q_i[4] * t0 + q_i[5] * t4)) - t24 * t56;
        let t58 = t2 * (t26 * t57) - t23 * t56;
        let t59 = q_i[4] * t9;
        let t60 = t31 * t58 + t59;
        let t61 = q_i[5] * t9;
        let t62 = t34 * t58 + t61;
        let t63 = q_i[6] * t9;
        let t64 = t28 * t58 + t63;
        let t65 = q_i[4] * t6;
        let t66 = t24 * t65 + t6 * (q_i[5] * t3 + (q_i[3] * t0 - q_i[6] * t4));
        let t67 = t23 * t65 + t2 * (t26 * t66);
        let t68 = (t61 + t28 * t67) * two;
        let t69 = q_i[3] * t9;
        let t70 = (t31 * t67 + t69) * two;
        let t71 = t63 - t4 * t67 * two;
        let t72 = q_i[5] * t6;
        let t73 = t24 * t72 + t6 * (q_i[6] * t0 + (q_i[3] * t4 - q_i[4] * t3));
        let t74 = t23 * t72 + t2 * (t26 * t73);
        let t75 = (t69 + t34 * t74) * two;
        let t76 = (t63 + t31 * t74) * two;
        let t77 = t59 - t3 * t74 * two;
        let t78 = q_i[6] * t6;
        let t79 = t24 * t78 + t6 * (q_i[4] * t4 + (q_i[3] * t3 - q_i[5] * t0));
        let t80 = t23 * t78 + t2 * (t26 * t79);
        let t81 = (t69 + t28 * t80) * two;
        let t82 = (t59 + t34 * t80) * two;
        let t83 = t61 - t0 * t80 * two;
        let t84 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t85 = q_i[6] * t84;
        let t86 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t87 = q_i[4] * t86;
        let t88 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t89 = q_i[3] * t88;
        let t90 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t91 = q_i[5] * t90;
        let t92 = t85 + (t87 + (t89 - t91));
        let t93 = q_i[6] * two;
        let t94 = q_i[5] * t88;
        let t95 = q_i[4] * t84;
        let t96 = q_i[3] * t90;
        let t97 = q_i[6] * t86;
        let t98 = t94 + (t95 + (t96 - t97));
        let t99 = q_i[4] * two;
        let t100 = q_i[6] * t90;
        let t101 = q_i[5] * t84;
        let t102 = q_i[3] * t86;
        let t103 = q_i[4] * t88;
        let t104 = t100 + (t101 + (t102 - t103));
        let t105 = q_i[5] * two;
        let t106 = q_i[3] * two;
        let t107 = t104 * two;
        let t108 = t92 * two;
        let t109 = t98 * two;
        let t110 = q_j[4] * two;
        let t111 = q_j[5] * two;
        let t112 = q_j[6] * two;
        let t113 = q_j[3] * two;
        let t114 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t115 = q_i[6] * t114;
        let t116 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t117 = q_i[4] * t116;
        let t118 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t119 = q_i[3] * t118;
        let t120 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t121 = q_i[5] * t120;
        let t122 = t115 + (t117 + (t119 - t121));
        let t123 = q_i[5] * t118;
        let t124 = q_i[4] * t114;
        let t125 = q_i[3] * t120;
        let t126 = q_i[6] * t116;
        let t127 = t123 + (t124 + (t125 - t126));
        let t128 = q_i[6] * t120;
        let t129 = q_i[5] * t114;
        let t130 = q_i[3] * t116;
        let t131 = q_i[4] * t118;
        let t132 = t128 + (t129 + (t130 - t131));
        let t133 = t132 * two;
        let t134 = t122 * two;
        let t135 = t127 * two;
        let t136 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t137 = q_i[6] * t136;
        let t138 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t139 = q_i[4] * t138;
        let t140 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t141 = q_i[3] * t140;
        let t142 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t143 = q_i[5] * t142;
        let t144 = t137 + (t139 + (t141 - t143));
        let t145 = q_i[5] * t140;
        let t146 = q_i[4] * t136;
        let t147 = q_i[3] * t142;
        let t148 = q_i[6] * t138;
        let t149 = t145 + (t146 + (t147 - t148));
        let t150 = q_i[6] * t142;
        let t151 = q_i[5] * t136;
        let t152 = q_i[3] * t138;
        let t153 = q_i[4] * t140;
        let t154 = t150 + (t151 + (t152 - t153));
        let t155 = t154 * two;
        let t156 = t144 * two;
        let t157 = t149 * two;
        let t158 = lambda[1] * k4;
        let t159 = lambda[0] * k4;
        let t160 = t158 * (q_i[4] * t120) + t159 * (q_i[4] * t90);
        let t161 = t158 * (q_i[5] * t116) + t159 * (q_i[5] * t86);
        let t162 = t160 + t161;
        let t163 = lambda[2] * k4;
        let t164 = t163 * (q_i[4] * t142);
        let t165 = t158 * (q_i[6] * t118) + t159 * (q_i[6] * t88);
        let t166 = t163 * (q_i[6] * t140);
        let t167 = t163 * (q_i[5] * t138);
        let t168 = t165 + (t166 + t167);
        let t169 = t123 * t158;
        let t170 = t94 * t159;
        let t171 = t95 * t159;
        let t172 = t145 * t163;
        let t173 = t146 * t163;
        let t174 = t124 * t158;
        let t175 = -t169 - t170 + (t171 - t172 + (t173 + t174));
        let t176 = t157 * lambda[2];
        let t177 = t135 * lambda[1];
        let t178 = t109 * lambda[0];
        let t179 = t176 + (t177 + t178);
        let t180 = t148 * t163;
        let t181 = t97 * t159;
        let t182 = t126 * t158;
        let t183 = t128 * t158;
        let t184 = t100 * t159;
        let t185 = t101 * t159;
        let t186 = t150 * t163;
        let t187 = t151 * t163;
        let t188 = t129 * t158;
        let t189 = -t183 - t184 + (t185 - t186 + (t187 + t188));
        let t190 = t155 * lambda[2];
        let t191 = t133 * lambda[1];
        let t192 = t107 * lambda[0];
        let t193 = t190 + (t191 + t192);
        let t194 = t153 * t163;
        let t195 = t103 * t159;
        let t196 = t131 * t158;
        let t197 = t117 * t158;
        let t198 = t87 * t159;
        let t199 = t85 * t159;
        let t200 = t139 * t163;
        let t201 = t137 * t163;
        let t202 = t115 * t158;
        let t203 = -t197 - t198 + (t199 - t200 + (t201 + t202));
        let t204 = t156 * lambda[2];
        let t205 = t134 * lambda[1];
        let t206 = t108 * lambda[0];
        let t207 = t204 + (t205 + t206);
        let t208 = t143 * t163;
        let t209 = t91 * t159;
        let t210 = t121 * t158;
        let t211 = t147 * t163;
        let t212 = t125 * t158;
        let t213 = t96 * t159;
        let t214 = -t211 - t212 + (-t182 - t181 + (-t213 - t180));
        let t215 = -t177 - t178 - t176;
        let t216 = -(t158 * (q_i[3] * t114)) - t159 * (q_i[3] * t84);
        let t217 = t163 * (q_i[3] * t136);
        let t218 = t119 * t158;
        let t219 = t89 * t159;
        let t220 = t141 * t163;
        let t221 = -t218 - t219 + (-t209 - t220 + (-t208 - t210));
        let t222 = -t191 - t192 - t190;
        let t223 = t152 * t163;
        let t224 = t130 * t158;
        let t225 = t102 * t159;
        let t226 = -t224 - t225 + (-t195 - t223 + (-t194 - t196));
        let t227 = -t205 - t206 - t204;
        let t228 = t216 + (t164 - t217);
        let t229 = -(t158 * (q_j[4] * t120)) - t159 * (q_j[4] * t90);
        let t230 = -(t158 * (q_j[5] * t116)) - t159 * (q_j[5] * t86);
        let t231 = t229 + t230;
        let t232 = -(t158 * (q_j[6] * t118)) - t159 * (q_j[6] * t88);
        let t233 = t163 * (q_j[6] * t140);
        let t234 = t163 * (q_j[5] * t138);
        let t235 = t232 + (-t233 - t234);
        let t236 = t163 * (q_j[4] * t142);
        let t237 = t158 * (q_j[4] * t114);
        let t238 = t159 * (q_j[4] * t84);
        let t239 = t159 * (q_j[5] * t88);
        let t240 = t163 * (q_j[4] * t136);
        let t241 = t163 * (q_j[5] * t140);
        let t242 = t158 * (q_j[5] * t118);
        let t243 = -t237 - t238 + (t239 - t240 + (t241 + t242));
        let t244 = t159 * (q_j[6] * t86);
        let t245 = t158 * (q_j[6] * t116);
        let t246 = t163 * (q_j[6] * t138);
        let t247 = t158 * (q_j[5] * t114);
        let t248 = t159 * (q_j[5] * t84);
        let t249 = t159 * (q_j[6] * t90);
        let t250 = t163 * (q_j[5] * t136);
        let t251 = t163 * (q_j[6] * t142);
        let t252 = t158 * (q_j[6] * t120);
        let t253 = -t247 - t248 + (t249 - t250 + (t251 + t252));
        let t254 = t159 * (q_j[4] * t88);
        let t255 = t158 * (q_j[4] * t118);
        let t256 = t163 * (q_j[4] * t140);
        let t257 = t158 * (q_j[6] * t114);
        let t258 = t159 * (q_j[6] * t84);
        let t259 = t159 * (q_j[4] * t86);
        let t260 = t163 * (q_j[6] * t136);
        let t261 = t163 * (q_j[4] * t138);
        let t262 = t158 * (q_j[4] * t116);
        let t263 = -t257 - t258 + (t259 - t260 + (t261 + t262));
        let t264 = t159 * (q_j[5] * t90);
        let t265 = t158 * (q_j[5] * t120);
        let t266 = t163 * (q_j[5] * t142);
        let t267 = t158 * (q_j[3] * t120);
        let t268 = t159 * (q_j[3] * t90);
        let t269 = t163 * (q_j[3] * t142);
        let t270 = t267 + t268 + (t244 + t269 + (t245 + t246));
        let t271 = t158 * (q_j[3] * t114) + t159 * (q_j[3] * t84);
        let t272 = t163 * (q_j[3] * t136);
        let t273 = t158 * (q_j[3] * t118);
        let t274 = t159 * (q_j[3] * t88);
        let t275 = t163 * (q_j[3] * t140);
        let t276 = t273 + t274 + (t264 + t275 + (t265 + t266));
        let t277 = t159 * (q_j[3] * t86);
        let t278 = t158 * (q_j[3] * t116);
        let t279 = t163 * (q_j[3] * t138);
        let t280 = t277 + t278 + (t254 + t279 + (t255 + t256));
        let t281 = t271 + (t272 - t236);
        phi[0] = -(t10 * t11) - t12 * t13 - t14 * t15;
        phi[1] = -(t10 * t16) - t12 * t17 - t14 * t18;
        phi[2] = -(t10 * t19) - t12 * t20 - t14 * t21;
        phi_q[0] = h[2] * t30 + (h[0] * t33 + h[1] * t36);
        phi_q[1] = -(t11 * t41) - t13 * t42 - t15 * t43;
        phi_q[2] = -(t11 * t47) - t13 * t48 - t15 * t49;
        phi_q[3] = -(t11 * t53) - t13 * t54 - t15 * t55;
        phi_q[4] = -(t11 * t60) - t13 * t62 - t15 * t64;
        phi_q[5] = h[2] * t68 + (h[0] * t70 - t13 * t71);
        phi_q[6] = h[1] * t75 + (h[0] * t76 - t15 * t77);
        phi_q[7] = h[2] * t81 + (h[1] * t82 - t11 * t83);
        phi_q[8] = h[5] * t30 + (h[3] * t33 + h[4] * t36);
        phi_q[9] = -(t16 * t41) - t17 * t42 - t18 * t43;
        phi_q[10] = -(t16 * t47) - t17 * t48 - t18 * t49;
        phi_q[11] = -(t16 * t53) - t17 * t54 - t18 * t55;
        phi_q[12] = -(t16 * t60) - t17 * t62 - t18 * t64;
        phi_q[13] = h[5] * t68 + (h[3] * t70 - t17 * t71);
        phi_q[14] = h[4] * t75 + (h[3] * t76 - t18 * t77);
        phi_q[15] = h[5] * t81 + (h[4] * t82 - t16 * t83);
        phi_q[16] = h[8] * t30 + (h[6] * t33 + h[7] * t36);
        phi_q[17] = -(t19 * t41) - t20 * t42 - t21 * t43;
        phi_q[18] = -(t19 * t47) - t20 * t48 - t21 * t49;
        phi_q[19] = -(t19 * t53) - t20 * t54 - t21 * t55;
        phi_q[20] = -(t19 * t60) - t20 * t62 - t21 * t64;
        phi_q[21] = h[8] * t68 + (h[6] * t70 - t20 * t71);
        phi_q[22] = h[7] * t75 + (h[6] * t76 - t21 * t77);
        phi_q[23] = h[8] * t81 + (h[7] * t82 - t19 * t83);
        work[0] = t92 * t93 + (t98 * t99 + t104 * t105);
        work[1] = t105 * t92 - t98 * t106 - q_i[6] * t107;
        work[2] = t98 * t93 - t104 * t106 - q_i[4] * t108;
        work[3] = t99 * t104 - t92 * t106 - q_i[5] * t109;
        work[4] = -(t98 * t110) - t104 * t111 - t92 * t112;
        work[5] = q_j[6] * t107 + (t98 * t113 - t92 * t111);
        work[6] = q_j[4] * t108 + (t104 * t113 - t98 * t112);
        work[7] = q_j[5] * t109 + (t92 * t113 - t104 * t110);
        work[8] = t93 * t122 + (t99 * t127 + t105 * t132);
        work[9] = t105 * t122 - t106 * t127 - q_i[6] * t133;
        work[10] = t93 * t127 - t106 * t132 - q_i[4] * t134;
        work[11] = t99 * t132 - t106 * t122 - q_i[5] * t135;
        work[12] = -(t110 * t127) - t111 * t132 - t112 * t122;
        work[13] = q_j[6] * t133 + (t113 * t127 - t111 * t122);
        work[14] = q_j[4] * t134 + (t113 * t132 - t112 * t127);
        work[15] = q_j[5] * t135 + (t113 * t122 - t110 * t132);
        work[16] = t93 * t144 + (t99 * t149 + t105 * t154);
        work[17] = t105 * t144 - t106 * t149 - q_i[6] * t155;
        work[18] = t93 * t149 - t106 * t154 - q_i[4] * t156;
        work[19] = t99 * t154 - t106 * t144 - q_i[5] * t157;
        work[20] = -(t110 * t149) - t111 * t154 - t112 * t144;
        work[21] = q_j[6] * t155 + (t113 * t149 - t111 * t144);
        work[22] = q_j[4] * t156 + (t113 * t154 - t112 * t149);
        work[23] = q_j[5] * t157 + (t113 * t144 - t110 * t154);
        curvature[0] = t162 + (t164 + t168);
        curvature[1] = t175 + (t179 + (t180 + (t181 + t182)));
        curvature[2] = t189 + (t193 + (t194 + (t195 + t196)));
        curvature[3] = t203 + (t207 + (t208 + (t209 + t210)));
        curvature[4] = t214 + (t215 + (t172 + (t169 + t170)));
        curvature[5] = t216 + (t168 + t161 - t217);
        curvature[6] = t221 + (t207 - t199 - t202 - t201);
        curvature[7] = t222 + (t223 + (t224 + (t189 + t225)));
        curvature[8] = t226 + (t186 + (t183 + (t184 + t222)));
        curvature[9] = t227 + (t220 + (t218 + (t203 + t219)));
        curvature[10] = t228 + (t165 + (t166 + t160));
        curvature[11] = t179 + t214 - t171 - t174 - t173;
        curvature[12] = t200 + (t197 + (t198 + (t221 + t227)));
        curvature[13] = t193 + t226 - t185 - t188 - t187;
        curvature[14] = t211 + (t212 + (t213 + (t175 + t215)));
        curvature[15] = t228 + (t167 + t162);
        curvature[16] = t231 + (t235 - t236);
        curvature[17] = t243 - t244 - t245 - t246;
        curvature[18] = t253 - t254 - t255 - t256;
        curvature[19] = t263 - t264 - t265 - t266;
        curvature[20] = t215;
        curvature[21] = t222;
        curvature[22] = t227;
        curvature[23] = t270 - t239 - t242 - t241;
        curvature[24] = t271 + (t272 + (t235 + t230));
        curvature[25] = t276 + (t260 + (t257 + t258));
        curvature[26] = t253 - t277 - t278 - t279;
        curvature[27] = t179;
        curvature[28] = t227;
        curvature[29] = t193;
        curvature[30] = t280 - t249 - t252 - t251;
        curvature[31] = t263 - t274 - t273 - t275;
        curvature[32] = t281 + (t232 + (t229 - t233));
        curvature[33] = t240 + (t237 + (t238 + t270));
        curvature[34] = t193;
        curvature[35] = t207;
        curvature[36] = t215;
        curvature[37] = t276 - t259 - t262 - t261;
        curvature[38] = t250 + (t247 + (t248 + t280));
        curvature[39] = t243 - t268 - t267 - t269;
        curvature[40] = t281 + (t231 - t234);
        curvature[41] = t207;
        curvature[42] = t222;
        curvature[43] = t179;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 75 additions, 209 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        _h: &[S; 9],
        lambda: &[S; 3],
        phi_h: &mut [S; 9],
        force_h: &mut [S; 72],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let t0 = q_i[5] * q_j[6] + (q_i[4] * q_j[3] - q_j[4] * q_i[3] - q_i[6] * q_j[5]);
        let t1 = q_i[6] * q_j[6]
            + (q_j[5] * q_i[5] + (q_i[3] * q_j[3] + q_j[4] * q_i[4]));
        let t2 = one / t1;
        let t3 = q_i[6] * q_j[3] + (q_j[5] * q_i[4] - q_i[3] * q_j[6] - q_j[4] * q_i[5]);
        let t4 = q_j[4] * q_i[6] + (q_j[3] * q_i[5] - q_i[3] * q_j[5] - q_i[4] * q_j[6]);
        let t5 = (t3 * t3 + (t0 * t0 + t4 * t4)) * (t2 * t2);
        let t6 = t2 * t5.atan_ratio(0);
        let t7 = -(t0 * t6 * two);
        let t8 = -(t4 * t6 * two);
        let t9 = -(t3 * t6 * two);
        let t10 = q_i[6] * q_i[4];
        let t11 = q_i[3] * q_i[5];
        let t12 = t10 - t11;
        let t13 = q_i[3] * q_i[6];
        let t14 = q_i[4] * q_i[5];
        let t15 = t13 + t14;
        let t16 = q_i[3] * q_i[3];
        let t17 = q_i[4] * q_i[4];
        let t18 = q_i[6] * q_i[6];
        let t19 = q_i[5] * q_i[5];
        let t20 = t16 + t17 - t18 - t19;
        let t21 = (q_i[6] * t12 + q_i[5] * t15) * two + q_i[4] * t20;
        let t22 = lambda[0] * two;
        let t23 = t14 - t13;
        let t24 = t23 * two;
        let t25 = q_i[3] * q_i[4];
        let t26 = q_i[6] * q_i[5];
        let t27 = t25 + t26;
        let t28 = t27 * two;
        let t29 = t16 - t17;
        let t30 = t19 - t18;
        let t31 = t29 + t30;
        let t32 = q_i[4] * t24 + (q_i[6] * t28 + q_i[5] * t31);
        let t33 = t11 + t10;
        let t34 = t33 * two;
        let t35 = t29 - t30;
        let t36 = t26 - t25;
        let t37 = t36 * two;
        let t38 = q_i[4] * t34 + (q_i[6] * t35 + q_i[5] * t37);
        let t39 = lambda[1] * two;
        let t40 = lambda[2] * two;
        let t41 = (q_i[5] * t12 - q_i[6] * t15) * two - q_i[3] * t20;
        let t42 = q_i[3] * two;
        let t43 = q_i[5] * t28 - q_i[6] * t31 - t23 * t42;
        let t44 = q_i[5] * t35 - q_i[6] * t37 - t33 * t42;
        let t45 = q_i[6] * t20 - q_i[4] * t12 * two - t15 * t42;
        let t46 = (q_i[6] * t23 - q_i[4] * t27) * two - q_i[3] * t31;
        let t47 = q_i[6] * t34 - q_i[4] * t35 - t36 * t42;
        let t48 = q_i[4] * t15 * two - q_i[5] * t20 - t12 * t42;
        let t49 = q_i[4] * t31 - q_i[5] * t24 - t27 * t42;
        let t50 = (q_i[4] * t36 - q_i[5] * t33) * two - q_i[3] * t35;
        let t51 = (-(q_j[6] * t12) - q_j[5] * t15) * two - q_j[4] * t20;
        let t52 = -(q_j[6] * t28) - q_j[5] * t31 - q_j[4] * t24;
        let t53 = -(q_j[6] * t35) - q_j[5] * t37 - q_j[4] * t34;
        let t54 = (q_j[6] * t15 - q_j[5] * t12) * two + q_j[3] * t20;
        let t55 = q_j[3] * two;
        let t56 = q_j[6] * t31 + t23 * t55 - q_j[5] * t28;
        let t57 = q_j[6] * t37 + t33 * t55 - q_j[5] * t35;
        let t58 = t15 * t55 + (q_j[4] * t12 * two - q_j[6] * t20);
        let t59 = (q_j[4] * t27 - q_j[6] * t23) * two + q_j[3] * t31;
        let t60 = t36 * t55 + (q_j[4] * t35 - q_j[6] * t34);
        let t61 = q_j[5] * t20 + t12 * t55 - q_j[4] * t15 * two;
        let t62 = q_j[5] * t24 + t27 * t55 - q_j[4] * t31;
        let t63 = (q_j[5] * t33 - q_j[4] * t36) * two + q_j[3] * t35;
        phi_h[0] = t7;
        phi_h[1] = t8;
        phi_h[2] = t9;
        phi_h[3] = t7;
        phi_h[4] = t8;
        phi_h[5] = t9;
        phi_h[6] = t7;
        phi_h[7] = t8;
        phi_h[8] = t9;
        force_h[0] = t21 * t22;
        force_h[1] = t22 * t32;
        force_h[2] = t22 * t38;
        force_h[3] = t21 * t39;
        force_h[4] = t32 * t39;
        force_h[5] = t38 * t39;
        force_h[6] = t21 * t40;
        force_h[7] = t32 * t40;
        force_h[8] = t38 * t40;
        force_h[9] = t22 * t41;
        force_h[10] = t22 * t43;
        force_h[11] = t22 * t44;
        force_h[12] = t39 * t41;
        force_h[13] = t39 * t43;
        force_h[14] = t39 * t44;
        force_h[15] = t40 * t41;
        force_h[16] = t40 * t43;
        force_h[17] = t40 * t44;
        force_h[18] = t22 * t45;
        force_h[19] = t22 * t46;
        force_h[20] = t22 * t47;
        force_h[21] = t39 * t45;
        force_h[22] = t39 * t46;
        force_h[23] = t39 * t47;
        force_h[24] = t40 * t45;
        force_h[25] = t40 * t46;
        force_h[26] = t40 * t47;
        force_h[27] = t22 * t48;
        force_h[28] = t22 * t49;
        force_h[29] = t22 * t50;
        force_h[30] = t39 * t48;
        force_h[31] = t39 * t49;
        force_h[32] = t39 * t50;
        force_h[33] = t40 * t48;
        force_h[34] = t40 * t49;
        force_h[35] = t40 * t50;
        force_h[36] = t22 * t51;
        force_h[37] = t22 * t52;
        force_h[38] = t22 * t53;
        force_h[39] = t39 * t51;
        force_h[40] = t39 * t52;
        force_h[41] = t39 * t53;
        force_h[42] = t40 * t51;
        force_h[43] = t40 * t52;
        force_h[44] = t40 * t53;
        force_h[45] = t22 * t54;
        force_h[46] = t22 * t56;
        force_h[47] = t22 * t57;
        force_h[48] = t39 * t54;
        force_h[49] = t39 * t56;
        force_h[50] = t39 * t57;
        force_h[51] = t40 * t54;
        force_h[52] = t40 * t56;
        force_h[53] = t40 * t57;
        force_h[54] = t22 * t58;
        force_h[55] = t22 * t59;
        force_h[56] = t22 * t60;
        force_h[57] = t39 * t58;
        force_h[58] = t39 * t59;
        force_h[59] = t39 * t60;
        force_h[60] = t40 * t58;
        force_h[61] = t40 * t59;
        force_h[62] = t40 * t60;
        force_h[63] = t22 * t61;
        force_h[64] = t22 * t62;
        force_h[65] = t22 * t63;
        force_h[66] = t39 * t61;
        force_h[67] = t39 * t62;
        force_h[68] = t39 * t63;
        force_h[69] = t40 * t61;
        force_h[70] = t40 * t62;
        force_h[71] = t40 * t63;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 290 additions, 458 multiplications, 1 divisions, 3 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 9],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 24],
        rate_h: &mut [S; 9],
    ) {
        let one = S::from_f64(1.0);
        let half = S::from_f64(0.5);
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_i[6] * q_j[6]
            + (q_j[5] * q_i[5] + (q_i[3] * q_j[3] + q_j[4] * q_i[4]));
        let t1 = one / t0;
        let t2 = t1 * t1;
        let t3 = q_i[6] * q_j[3] + (q_j[5] * q_i[4] - q_i[3] * q_j[6] - q_j[4] * q_i[5]);
        let t4 = q_i[5] * q_j[6] + (q_i[4] * q_j[3] - q_i[3] * q_j[4] - q_i[6] * q_j[5]);
        let t5 = q_j[4] * q_i[6] + (q_j[3] * q_i[5] - q_i[3] * q_j[5] - q_i[4] * q_j[6]);
        let t6 = t3 * t3 + (t4 * t4 + t5 * t5);
        let t7 = t2 * t6;
        let t8 = t7.atan_ratio(1);
        let t9 = q_i[4] * v_j[5] - q_i[3] * v_j[6] - q_i[5] * v_j[4] - q_j[4] * v_i[5];
        let t10 = q_j[5] * v_i[4]
            + (q_j[3] * v_i[6] + (q_i[6] * v_j[3] + (t9 - q_j[6] * v_i[3])));
        let t11 = q_i[4] * v_j[3] - q_i[3] * v_j[4] - q_i[6] * v_j[5] - q_j[4] * v_i[3];
        let t12 = q_j[6] * v_i[5]
            + (q_j[3] * v_i[4] + (q_i[5] * v_j[6] + (t11 - q_j[5] * v_i[6])));
        let t13 = q_i[5] * v_j[3] - q_i[3] * v_j[5] - q_i[4] * v_j[6] - q_j[5] * v_i[3];
        let t14 = q_j[4] * v_i[6]
            + (q_j[3] * v_i[5] + (q_i[6] * v_j[4] + (t13 - q_j[6] * v_i[4])));
        let t15 = t3 * t10 + (t4 * t12 + t5 * t14);
        let t16 = t1 * t6;
        let t17 = q_i[6] * v_j[6]
            + (q_i[5] * v_j[5] + (q_i[3] * v_j[3] + q_i[4] * v_j[4]));
        let t18 = q_j[6] * v_i[6]
            + (q_j[5] * v_i[5] + (q_j[4] * v_i[4] + (q_j[3] * v_i[3] + t17)));
        let t19 = t2 * t18;
        let t20 = t2 * t15 - t16 * t19;
        let t21 = t8 * t20;
        let t22 = t7.atan_ratio(0);
        let t23 = t22 * half;
        let t24 = t1 * t21 - t19 * t23;
        let t25 = t1 * t22 * half;
        let t26 = q_j[6] * t24 + v_j[6] * t25;
        let t27 = q_j[3] * t2;
        let t28 = q_j[6] * t3 + (q_j[4] * t4 + q_j[5] * t5);
        let t29 = t27 * t16 + t2 * t28;
        let t30 = t7.atan_ratio(2);
        let t31 = t20 * two;
        let t32 = t4 * v_j[4] + (q_j[6] * t10 + (q_j[4] * t12 + q_j[5] * t14));
        let t33 = t1 * two;
        let t34 = t18 * t33;
        let t35 = t2 * v_j[3] - t27 * t34;
        let t36 = t19 * t33;
        let t37 = t6 * t19 - t33 * t15;
        let t38 = t2 * (t3 * v_j[6] + (t5 * v_j[5] + t32))
            + (t16 * t35 - t28 * t36 - t27 * t37);
        let t39 = t29 * t8;
        let t40 = t1 * (t29 * t30 * t31 + t8 * t38) + (t35 * t23 - t39 * t19);
        let t41 = t27 * t21 + t40;
        let t42 = t27 * t23 + t1 * t39;
        let t43 = t26 + (t3 * t41 + t10 * t42);
        let t44 = h[2] * k4;
        let t45 = q_j[4] * t24 + v_j[4] * t25;
        let t46 = t45 + (t4 * t41 + t12 * t42);
        let t47 = h[0] * k4;
        let t48 = q_j[5] * t24 + v_j[5] * t25;
        let t49 = t48 + (t5 * t41 + t14 * t42);
        let t50 = h[1] * k4;
        let t51 = q_j[5] * t3 + (q_j[3] * t4 - q_j[6] * t5);
        let t52 = q_j[4] * t2;
        let t53 = t2 * t51 - t16 * t52;
        let t54 = t8 * t53;
        let t55 = t2 * v_j[4] - t34 * t52;
        let t56 = t1 * t19 * two;
        let t57 = q_j[5] * t10 + (q_j[3] * t12 - q_j[6] * t14 - t5 * v_j[6]);
        let t58 = t51 * t56 - t37 * t52 - t2 * (t3 * v_j[5] + (t4 * v_j[3] + t57));
        let t59 = t1 * (t31 * (t30 * t53) - t8 * (t16 * t55 + t58));
        let t60 = t19 * t54 + (t21 * t52 + (t23 * t55 - t59));
        let t61 = t1 * t54 - t23 * t52;
        let t62 = t5 * t60 + (t26 - t14 * t61);
        let t63 = q_j[3] * t24 + v_j[3] * t25;
        let t64 = t63 + (t12 * t61 - t4 * t60);
        let t65 = t10 * t61 + (t48 - t3 * t60);
        let t66 = q_j[6] * t4 + (q_j[3] * t5 - q_j[4] * t3);
        let t67 = q_j[5] * t2;
        let t68 = t2 * t66 - t16 * t67;
        let t69 = t8 * t68;
        let t70 = t2 * v_j[5] - t34 * t67;
        let t71 = q_j[6] * t12 + (q_j[3] * t14 - q_j[4] * t10 - t3 * v_j[4]);
        let t72 = t56 * t66 - t37 * t67 - t2 * (t4 * v_j[6] + (t5 * v_j[3] + t71));
        let t73 = t1 * (t31 * (t30 * t68) - t8 * (t16 * t70 + t72));
        let t74 = t19 * t69 + (t21 * t67 + (t23 * t70 - t73));
        let t75 = t1 * t69 - t23 * t67;
        let t76 = t3 * t74 + (t45 - t10 * t75);
        let t77 = t12 * t75 + (t26 - t4 * t74);
        let t78 = t14 * t75 + (t63 - t5 * t74);
        let t79 = q_j[4] * t5 + (q_j[3] * t3 - q_j[5] * t4);
        let t80 = q_j[6] * t2;
        let t81 = t2 * t79 - t16 * t80;
        let t82 = t8 * t81;
        let t83 = t2 * v_j[6] - t34 * t80;
        let t84 = q_j[4] * t14 + (q_j[3] * t10 - q_j[5] * t12 - t4 * v_j[5]);
        let t85 = t56 * t79 - t37 * t80 - t2 * (t5 * v_j[4] + (t3 * v_j[3] + t84));
        let t86 = t1 * (t31 * (t30 * t81) - t8 * (t16 * t83 + t85));
        let t87 = t19 * t82 + (t21 * t80 + (t23 * t83 - t86));
        let t88 = t1 * t82 - t23 * t80;
        let t89 = t4 * t87 + (t48 - t12 * t88);
        let t90 = t14 * t88 + (t45 - t5 * t87);
        let t91 = t10 * t88 + (t63 - t3 * t87);
        let t92 = q_i[4] * t24 + v_i[4] * t25;
        let t93 = q_i[6] * t3 + (q_i[4] * t4 + q_i[5] * t5);
        let t94 = q_i[3] * t2;
        let t95 = t2 * t93 - t16 * t94;
        let t96 = t8 * t95;
        let t97 = t1 * t96 - t23 * t94;
        let t98 = t2 * v_i[3] - t34 * t94;
        let t99 = t4 * v_i[4] + (q_i[6] * t10 + (q_i[4] * t12 + q_i[5] * t14));
        let t100 = t56 * t93 - t37 * t94 - t2 * (t3 * v_i[6] + (t5 * v_i[5] + t99));
        let t101 = t1 * (t31 * (t30 * t95) - t8 * (t16 * t98 + t100));
        let t102 = t19 * t96 + (t21 * t94 + (t23 * t98 - t101));
        let t103 = t92 + (t12 * t97 - t4 * t102);
        let t104 = q_i[5] * t24 + v_i[5] * t25;
        let t105 = t104 + (t14 * t97 - t5 * t102);
        let t106 = q_i[6] * t24 + v_i[6] * t25;
        let t107 = t106 + (t10 * t97 - t3 * t102);
        let t108 = q_i[4] * t2;
        let t109 = q_i[5] * t3 + (q_i[3] * t4 - q_i[6] * t5);
        let t110 = t16 * t108 + t2 * t109;
        let t111 = t8 * t110;
        let t112 = t23 * t108 + t1 * t111;
        let t113 = q_i[5] * t10 + (q_i[3] * t12 - q_i[6] * t14 - t5 * v_i[6]);
        let t114 = t2 * v_i[4] - t34 * t108;
        let t115 = t2 * (t3 * v_i[5] + (t4 * v_i[3] + t113))
            + (t16 * t114 - t36 * t109 - t37 * t108);
        let t116 = t1 * (t31 * (t30 * t110) + t8 * t115) + (t23 * t114 - t19 * t111);
        let t117 = t21 * t108 + t116;
        let t118 = t10 * t112 + (t104 + t3 * t117);
        let t119 = q_i[3] * t24 + v_i[3] * t25;
        let t120 = t119 + (t4 * t117 + t12 * t112);
        let t121 = t106 - t5 * t117 - t14 * t112;
        let t122 = q_i[5] * t2;
        let t123 = q_i[6] * t4 + (q_i[3] * t5 - q_i[4] * t3);
        let t124 = t16 * t122 + t2 * t123;
        let t125 = t8 * t124;
        let t126 = t23 * t122 + t1 * t125;
        let t127 = q_i[6] * t12 + (q_i[3] * t14 - q_i[4] * t10 - t3 * v_i[4]);
        let t128 = t2 * v_i[5] - t34 * t122;
        let t129 = t2 * (t4 * v_i[6] + (t5 * v_i[3] + t127))
            + (t16 * t128 - t36 * t123 - t37 * t122);
        let t130 = t1 * (t31 * (t30 * t124) + t8 * t129) + (t23 * t128 - t19 * t125);
        let t131 = t21 * t122 + t130;
        let t132 = t14 * t126 + (t119 + t5 * t131);
        let t133 = t12 * t126 + (t106 + t4 * t131);
        let t134 = t92 - t3 * t131 - t10 * t126;
        let t135 = q_i[6] * t2;
        let t136 = q_i[4] * t5 + (q_i[3] * t3 - q_i[5] * t4);
        let t137 = t16 * t135 + t2 * t136;
        let t138 = t8 * t137;
        let t139 = t23 * t135 + t1 * t138;
        let t140 = q_i[4] * t14 + (q_i[3] * t10 - q_i[5] * t12 - t4 * v_i[5]);
        let t141 = t2 * v_i[6] - t34 * t135;
        let t142 = t2 * (t5 * v_i[4] + (t3 * v_i[3] + t140))
            + (t16 * t141 - t36 * t136 - t37 * t135);
        let t143 = t1 * (t31 * (t30 * t137) + t8 * t142) + (t23 * t141 - t19 * t138);
        let t144 = t21 * t135 + t143;
        let t145 = t10 * t139 + (t119 + t3 * t144);
        let t146 = t14 * t139 + (t92 + t5 * t144);
        let t147 = t104 - t4 * t144 - t12 * t139;
        let t148 = h[5] * k4;
        let t149 = h[3] * k4;
        let t150 = h[4] * k4;
        let t151 = h[8] * k4;
        let t152 = h[6] * k4;
        let t153 = h[7] * k4;
        let t154 = -((t12 * t25 + t4 * t24) * k4);
        let t155 = -((t14 * t25 + t5 * t24) * k4);
        let t156 = -((t10 * t25 + t3 * t24) * k4);
        rate_q[0] = t43 * t44 + (t46 * t47 + t49 * t50);
        rate_q[1] = t50 * t62 - t47 * t64 - t44 * t65;
        rate_q[2] = t44 * t76 - t47 * t77 - t50 * t78;
        rate_q[3] = t47 * t89 - t50 * t90 - t44 * t91;
        rate_q[4] = -(t47 * t103) - t50 * t105 - t44 * t107;
        rate_q[5] = t44 * t118 + (t47 * t120 - t50 * t121);
        rate_q[6] = t50 * t132 + (t47 * t133 - t44 * t134);
        rate_q[7] = t44 * t145 + (t50 * t146 - t47 * t147);
        rate_q[8] = t43 * t148 + (t46 * t149 + t49 * t150);
        rate_q[9] = t62 * t150 - t64 * t149 - t65 * t148;
        rate_q[10] = t76 * t148 - t77 * t149 - t78 * t150;
        rate_q[11] = t89 * t149 - t90 * t150 - t91 * t148;
        rate_q[12] = -(t103 * t149) - t105 * t150 - t107 * t148;
        rate_q[13] = t118 * t148 + (t120 * t149 - t121 * t150);
        rate_q[14] = t132 * t150 + (t133 * t149 - t134 * t148);
        rate_q[15] = t145 * t148 + (t146 * t150 - t147 * t149);
        rate_q[16] = t43 * t151 + (t46 * t152 + t49 * t153);
        rate_q[17] = t62 * t153 - t64 * t152 - t65 * t151;
        rate_q[18] = t76 * t151 - t77 * t152 - t78 * t153;
        rate_q[19] = t89 * t152 - t90 * t153 - t91 * t151;
        rate_q[20] = -(t103 * t152) - t105 * t153 - t107 * t151;
        rate_q[21] = t118 * t151 + (t120 * t152 - t121 * t153);
        rate_q[22] = t132 * t153 + (t133 * t152 - t134 * t151);
        rate_q[23] = t145 * t151 + (t146 * t153 - t147 * t152);
        rate_h[0] = t154;
        rate_h[1] = t155;
        rate_h[2] = t156;
        rate_h[3] = t154;
        rate_h[4] = t155;
        rate_h[5] = t156;
        rate_h[6] = t154;
        rate_h[7] = t155;
        rate_h[8] = t156;
    }
}
