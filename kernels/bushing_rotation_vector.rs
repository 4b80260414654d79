// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Rotation vector in a bushing
///
/// `Bᵀ θ = 0, A_iᵀ A_j the rotation by |θ| about θ, B = [x_i y_i z_i]` (unit 1)
///
/// Source: θ = 2 (e/e0) g(|e|²/e0²), g(x) = atan(√x)/√x, from e = e0 tan(|θ|/2) θ/|θ|: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.3.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `x_i` | 1 | body i | unit vector of the first bushing axis |
/// | 3..6 | `y_i` | 1 | body i | unit vector of the second bushing axis |
/// | 6..9 | `z_i` | 1 | body i | unit vector of the third bushing axis |
pub mod bushing_rotation_vector {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "bushing_rotation_vector",
        title: "Rotation vector in a bushing",
        equation: "Bᵀ θ = 0, A_iᵀ A_j the rotation by |θ| about θ, B = [x_i y_i z_i]",
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
                additions: 124,
                multiplications: 251,
                divisions: 1,
                functions: 2,
            },
            Operations {
                additions: 698,
                multiplications: 1031,
                divisions: 1,
                functions: 3,
            },
            Operations {
                additions: 70,
                multiplications: 263,
                divisions: 1,
                functions: 2,
            },
            Operations {
                additions: 290,
                multiplications: 458,
                divisions: 1,
                functions: 3,
            },
        ],
    };
    /// Rotation vector in a bushing
    #[derive(Clone, Copy, Debug, Default)]
    pub struct BushingRotationVector;
    impl<S: Scalar> Relation<S> for BushingRotationVector {
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
    /// 124 additions, 251 multiplications, 1 divisions, 2 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 9],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        _work: &mut [S; 0],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = q_i[5] * q_j[6] + (q_i[4] * q_j[3] - q_i[3] * q_j[4] - q_i[6] * q_j[5]);
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
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 698 additions, 1031 multiplications, 1 divisions, 3 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 9],
        lambda: &[S; 3],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        _work: &mut [S; 0],
        curvature: &mut [S; 36],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let k8 = S::from_f64(8.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_i[4] * q_j[3];
        let t1 = q_i[3] * q_j[4];
        let t2 = t0 - t1;
        let t3 = q_i[5] * q_j[6];
        let t4 = q_i[6] * q_j[5];
        let t5 = t3 - t4;
        let t6 = t2 + t5;
        let t7 = q_i[4] * q_j[4];
        let t8 = q_j[3] * q_i[3];
        let t9 = t7 + t8;
        let t10 = q_i[6] * q_j[6];
        let t11 = q_j[5] * q_i[5];
        let t12 = t10 + t11;
        let t13 = one / (t9 + t12);
        let t14 = q_i[6] * q_j[3];
        let t15 = q_j[6] * q_i[3];
        let t16 = t14 - t15;
        let t17 = q_j[5] * q_i[4];
        let t18 = q_i[5] * q_j[4];
        let t19 = t17 - t18;
        let t20 = t16 + t19;
        let t21 = q_i[5] * q_j[3];
        let t22 = q_j[5] * q_i[3];
        let t23 = t21 - t22;
        let t24 = q_i[6] * q_j[4];
        let t25 = q_j[6] * q_i[4];
        let t26 = t24 - t25;
        let t27 = t23 + t26;
        let t28 = t20 * t20 + (t6 * t6 + t27 * t27);
        let t29 = t13 * t13;
        let t30 = t28 * t29;
        let t31 = t30.atan_ratio(0);
        let t32 = t13 * t31;
        let t33 = t6 * t32;
        let t34 = h[0] * two;
        let t35 = t27 * t32;
        let t36 = h[1] * two;
        let t37 = t20 * t32;
        let t38 = h[2] * two;
        let t39 = h[3] * two;
        let t40 = h[4] * two;
        let t41 = h[5] * two;
        let t42 = h[6] * two;
        let t43 = h[7] * two;
        let t44 = h[8] * two;
        let t45 = q_j[3] * t29;
        let t46 = t31 * half;
        let t47 = t13 * t28;
        let t48 = q_j[6] * t20 + (q_j[4] * t6 + q_j[5] * t27);
        let t49 = t45 * t47 + t29 * t48;
        let t50 = t30.atan_ratio(1);
        let t51 = t49 * t50;
        let t52 = t45 * t46 + t13 * t51;
        let t53 = t20 * two;
        let t54 = q_j[6] * t32;
        let t55 = (t52 * t53 + t54) * two;
        let t56 = t6 * two;
        let t57 = q_j[4] * t32;
        let t58 = (t52 * t56 + t57) * two;
        let t59 = t27 * two;
        let t60 = q_j[5] * t32;
        let t61 = (t52 * t59 + t60) * two;
        let t62 = q_j[5] * t20 + (q_j[3] * t6 - q_j[6] * t27);
        let t63 = q_j[4] * t29;
        let t64 = t29 * t62 - t47 * t63;
        let t65 = t50 * t64;
        let t66 = t13 * t65 - t46 * t63;
        let t67 = q_j[3] * t32;
        let t68 = t56 * t66 + t67;
        let t69 = t59 * t66 - t54;
        let t70 = t60 + t53 * t66;
        let t71 = q_j[6] * t6 + (q_j[3] * t27 - q_j[4] * t20);
        let t72 = q_j[5] * t29;
        let t73 = t29 * t71 - t47 * t72;
        let t74 = t50 * t73;
        let t75 = t72 * half;
        let t76 = t13 * t74 - t31 * t75;
        let t77 = t54 + t56 * t76;
        let t78 = t67 + t59 * t76;
        let t79 = t53 * t76 - t57;
        let t80 = q_j[4] * t27 + (q_j[3] * t20 - q_j[5] * t6);
        let t81 = q_j[6] * t29;
        let t82 = t29 * t80 - t47 * t81;
        let t83 = t50 * t82;
        let t84 = t81 * half;
        let t85 = t13 * t83 - t31 * t84;
        let t86 = t56 * t85 - t60;
        let t87 = t57 + t59 * t85;
        let t88 = t67 + t53 * t85;
        let t89 = q_i[6] * t20 + (q_i[4] * t6 + q_i[5] * t27);
        let t90 = q_i[3] * t29;
        let t91 = t29 * t89 - t47 * t90;
        let t92 = t50 * t91;
        let t93 = t13 * t92 - t46 * t90;
        let t94 = q_i[4] * t32;
        let t95 = t56 * t93 + t94;
        let t96 = q_i[5] * t32;
        let t97 = t59 * t93 + t96;
        let t98 = q_i[6] * t32;
        let t99 = t53 * t93 + t98;
        let t100 = q_i[4] * t29;
        let t101 = q_i[5] * t20 + (q_i[3] * t6 - q_i[6] * t27);
        let t102 = t47 * t100 + t29 * t101;
        let t103 = t50 * t102;
        let t104 = t46 * t100 + t13 * t103;
        let t105 = (t96 + t53 * t104) * two;
        let t106 = q_i[3] * t32;
        let t107 = (t56 * t104 + t106) * two;
        let t108 = t98 - t59 * t104;
        let t109 = q_i[5] * t29;
        let t110 = q_i[6] * t6 + (q_i[3] * t27 - q_i[4] * t20);
        let t111 = t47 * t109 + t29 * t110;
        let t112 = t50 * t111;
        let t113 = t46 * t109 + t13 * t112;
        let t114 = (t106 + t59 * t113) * two;
        let t115 = (t98 + t56 * t113) * two;
        let t116 = t94 - t53 * t113;
        let t117 = q_i[6] * t29;
        let t118 = q_i[4] * t27 + (q_i[3] * t20 - q_i[5] * t6);
        let t119 = t47 * t117 + t29 * t118;
        let t120 = t50 * t119;
        let t121 = t46 * t117 + t13 * t120;
        let t122 = (t106 + t53 * t121) * two;
        let t123 = (t94 + t59 * t121) * two;
        let t124 = t96 - t56 * t121;
        let t125 = t13 * t45;
        let t126 = q_j[3] * t125;
        let t127 = t30.atan_ratio(2);
        let t128 = q_j[4] * q_j[4];
        let t129 = q_j[6] * q_j[6];
        let t130 = q_j[5] * q_j[5];
        let t131 = t129 + t130;
        let t132 = t29 * half;
        let t133 = t13 * two;
        let t134 = -(t48 * t133) - t28 * t45;
        let t135 = t47 * t126 + ((t128 + t131) * t132 - t45 * t134 * half);
        let t136 = t13 * (t49 * (t49 * t127) + t50 * (t48 * t125 + t135));
        let t137 = t45 * t51 + (t46 * t126 + t136);
        let t138 = q_j[4] * t52;
        let t139 = h[6] * lambda[2] + (h[0] * lambda[0] + h[3] * lambda[1]);
        let t140 = t139 * k8;
        let t141 = q_j[5] * t52;
        let t142 = h[7] * lambda[2] + (h[1] * lambda[0] + h[4] * lambda[1]);
        let t143 = t142 * k8;
        let t144 = -((t6 * t137 + t138) * t140) - (t27 * t137 + t141) * t143;
        let t145 = q_j[6] * t52;
        let t146 = h[8] * lambda[2] + (h[2] * lambda[0] + h[5] * lambda[1]);
        let t147 = t146 * k8;
        let t148 = q_j[6] * t66;
        let t149 = t64 * t127;
        let t150 = t134 * half;
        let t151 = t13 * t63;
        let t152 = q_j[3] * t151;
        let t153 = t62 * t125 + (t132 * (q_j[3] * q_j[4]) + (t63 * t150 - t47 * t152));
        let t154 = t45 * half;
        let t155 = t63 * half;
        let t156 = t13 * (t49 * t149 + t50 * t153)
            + (t65 * t154 - t46 * t152 - t51 * t155);
        let t157 = t146 * k4;
        let t158 = q_j[4] * t66;
        let t159 = q_j[3] * t52;
        let t160 = t139 * k4;
        let t161 = q_j[5] * t66;
        let t162 = t142 * k4;
        let t163 = (t158 + (t56 * t156 + t159)) * t160
            + (t161 + (t59 * t156 - t145)) * t162;
        let t164 = q_j[4] * t151;
        let t165 = q_j[3] * q_j[3];
        let t166 = t28 * t63 - t62 * t133;
        let t167 = t132 * (t131 + t165) + (t63 * t166 * half - t62 * t151);
        let t168 = t13 * (t50 * (t47 * t164 + t167) + t64 * t149)
            + (t46 * t164 - t63 * t65);
        let t169 = q_j[3] * t66;
        let t170 = -(t140 * (t6 * t168 + t169)) - t143 * (t27 * t168 - t148);
        let t171 = q_j[6] * t76;
        let t172 = t73 * t127;
        let t173 = t13 * t72;
        let t174 = q_j[3] * t173;
        let t175 = t71 * t125 + (t132 * (q_j[5] * q_j[3]) + (t72 * t150 - t47 * t174));
        let t176 = t13 * (t49 * t172 + t50 * t175)
            + (t74 * t154 - t46 * t174 - t51 * t75);
        let t177 = q_j[4] * t76;
        let t178 = q_j[5] * t76;
        let t179 = t160 * (t177 + (t145 + t56 * t176))
            + t162 * (t178 + (t159 + t59 * t176));
        let t180 = q_j[3] * t76;
        let t181 = q_j[4] * t173;
        let t182 = t71 * t151 + (t132 * (q_j[5] * q_j[4]) - t47 * t181 - t75 * t166);
        let t183 = t13 * (t64 * t172 - t50 * t182)
            + (t46 * t181 - t74 * t155 - t65 * t75);
        let t184 = -(t160 * (t180 + (t148 + t56 * t183)))
            - t162 * (t59 * t183 + (t169 - t171));
        let t185 = q_j[5] * t173;
        let t186 = t128 + t165;
        let t187 = t28 * t72 - t71 * t133;
        let t188 = t132 * (t129 + t186) + (t72 * t187 * half - t71 * t173);
        let t189 = t13 * (t50 * (t47 * t185 + t188) + t73 * t172)
            + (t46 * t185 - t72 * t74);
        let t190 = -(t140 * (t171 + t6 * t189)) - t143 * (t180 + t27 * t189);
        let t191 = q_j[6] * t85;
        let t192 = t82 * t127;
        let t193 = t13 * t81;
        let t194 = q_j[3] * t193;
        let t195 = t80 * t125 + (t132 * (q_j[6] * q_j[3]) + (t81 * t150 - t47 * t194));
        let t196 = t13 * (t49 * t192 + t50 * t195)
            + (t83 * t154 - t46 * t194 - t51 * t84);
        let t197 = q_j[4] * t85;
        let t198 = q_j[5] * t85;
        let t199 = t160 * (t197 + (t56 * t196 - t141))
            + t162 * (t198 + (t138 + t59 * t196));
        let t200 = q_j[3] * t85;
        let t201 = q_j[4] * t193;
        let t202 = t80 * t151 + (t132 * (q_j[6] * q_j[4]) - t47 * t201 - t84 * t166);
        let t203 = t13 * (t64 * t192 - t50 * t202)
            + (t46 * t201 - t83 * t155 - t65 * t84);
        let t204 = -(t160 * (t200 + (t56 * t203 - t161)))
            - t162 * (t59 * t203 + (t158 - t191));
        let t205 = q_j[5] * t193;
        let t206 = t80 * t173 + (t132 * (q_j[5] * q_j[6]) - t47 * t205 - t84 * t187);
        let t207 = t13 * (t73 * t192 - t50 * t206)
            + (t46 * t205 - t75 * t83 - t74 * t84);
        let t208 = -(t160 * (t56 * t207 + (t191 - t178)))
            - t162 * (t59 * t207 + (t177 + t200));
        let t209 = q_j[6] * t193;
        let t210 = t28 * t81 - t80 * t133;
        let t211 = t132 * (t130 + t186) + (t81 * t210 * half - t80 * t193);
        let t212 = t13 * (t50 * (t47 * t209 + t211) + t82 * t192)
            + (t46 * t209 - t81 * t83);
        let t213 = -(t140 * (t6 * t212 - t198)) - t143 * (t197 + t27 * t212);
        let t214 = q_i[6] * t52;
        let t215 = t91 * t127;
        let t216 = t132 - t13 * (q_j[3] * t90);
        let t217 = t90 * half;
        let t218 = t89 * t125 + (t47 * t216 + (t134 * t217 + t132 * (t7 + t12)));
        let t219 = t13 * (t49 * t215 + t50 * t218)
            + (t92 * t154 + (t46 * t216 - t51 * t217));
        let t220 = q_j[6] * t93;
        let t221 = q_i[4] * t52;
        let t222 = q_j[4] * t93;
        let t223 = q_i[5] * t52;
        let t224 = q_j[5] * t93;
        let t225 = t160 * (t221 + (t56 * t219 + t222))
            + t162 * (t223 + (t59 * t219 + t224));
        let t226 = t32 * half;
        let t227 = t226 + q_j[3] * t93;
        let t228 = t13 * t90;
        let t229 = q_j[4] * t228;
        let t230 = t6 - t5;
        let t231 = t13 * t89;
        let t232 = t47 * t229 + (t132 * (t0 + t230) + (t166 * t217 - t63 * t231));
        let t233 = t13 * (t50 * t232 + t64 * t215)
            + (t46 * t229 - t92 * t155 - t65 * t217);
        let t234 = q_i[4] * t66;
        let t235 = q_i[5] * t66;
        let t236 = -(t160 * (t227 + (t56 * t233 + t234)))
            - t162 * (t235 + (t59 * t233 - t220));
        let t237 = q_i[6] * t66;
        let t238 = q_i[4] * t76;
        let t239 = q_j[5] * t228;
        let t240 = t27 - t26;
        let t241 = t47 * t239 + (t132 * (t21 + t240) + (t187 * t217 - t72 * t231));
        let t242 = t13 * (t50 * t241 + t73 * t215)
            + (t46 * t239 - t75 * t92 - t74 * t217);
        let t243 = q_i[5] * t76;
        let t244 = -(t160 * (t238 + (t220 + t56 * t242)))
            - t162 * (t243 + (t227 + t59 * t242));
        let t245 = q_i[6] * t76;
        let t246 = q_i[4] * t85;
        let t247 = q_j[6] * t228;
        let t248 = t20 - t19;
        let t249 = t47 * t247 + (t132 * (t14 + t248) + (t210 * t217 - t81 * t231));
        let t250 = t13 * (t50 * t249 + t82 * t215)
            + (t46 * t247 - t84 * t92 - t83 * t217);
        let t251 = q_i[5] * t85;
        let t252 = -(t160 * (t246 + (t56 * t250 - t224)))
            - t162 * (t251 + (t222 + t59 * t250));
        let t253 = q_i[6] * t85;
        let t254 = q_i[3] * t228;
        let t255 = q_i[4] * q_i[4];
        let t256 = q_i[6] * q_i[6];
        let t257 = q_i[5] * q_i[5];
        let t258 = t256 + t257;
        let t259 = t28 * t90 - t89 * t133;
        let t260 = t47 * t254 + (t132 * (t255 + t258) + (t217 * t259 - t90 * t231));
        let t261 = t13 * (t50 * t260 + t91 * t215) + (t46 * t254 - t90 * t92);
        let t262 = q_i[4] * t93;
        let t263 = q_i[5] * t93;
        let t264 = -(t140 * (t6 * t261 + t262)) - t143 * (t27 * t261 + t263);
        let t265 = q_i[6] * t93;
        let t266 = q_i[3] * t52 - t226;
        let t267 = t102 * t127;
        let t268 = t13 * t100;
        let t269 = q_j[3] * t268;
        let t270 = t100 * half;
        let t271 = t101 * t125 + (t47 * t269 - t134 * t270 - t132 * (t230 - t1));
        let t272 = t13 * (t49 * t267 + t50 * t271)
            + (t51 * t270 + (t46 * t269 + t103 * t154));
        let t273 = q_j[4] * t104;
        let t274 = q_j[5] * t104;
        let t275 = -(t160 * (t266 + (t56 * t272 + t273)))
            - t162 * (t274 + (t59 * t272 - t214));
        let t276 = q_j[6] * t104;
        let t277 = t132 - t13 * (q_j[4] * t100);
        let t278 = t47 * t277 + (t132 * (t8 + t12) - t101 * t151 - t166 * t270);
        let t279 = t13 * (t50 * t278 + t64 * t267)
            + (t65 * t270 + (t46 * t277 - t103 * t155));
        let t280 = q_i[3] * t66;
        let t281 = q_j[3] * t104;
        let t282 = t160 * (t280 + (t56 * t279 + t281))
            - t162 * (t237 + t276 - t59 * t279);
        let t283 = q_i[3] * t76;
        let t284 = q_j[5] * t268;
        let t285 = t47 * t284 + (t187 * t270 + t132 * (t18 + t16 - t20));
        let t286 = t103 * half;
        let t287 = t13 * (t50 * (t101 * t173 + t285) - t73 * t267)
            + (t72 * t286 + (t46 * t284 - t74 * t270));
        let t288 = t160 * (t283 + (t276 - t56 * t287))
            - t162 * (t59 * t287 + (t245 - t281));
        let t289 = q_j[6] * t268;
        let t290 = t47 * t289 + (t210 * t270 + t132 * (t22 + (t24 + t27 - t21)));
        let t291 = t13 * (t50 * (t101 * t193 + t290) - t82 * t267)
            + (t81 * t286 + (t46 * t289 - t83 * t270));
        let t292 = q_i[3] * t85;
        let t293 = t157 * (t251 + t281 - t53 * t291)
            - t160 * (t56 * t291 + (t274 - t292));
        let t294 = q_i[6] * t104;
        let t295 = q_i[3] * t268;
        let t296 = t101 * t228 + (t47 * t295 + (t259 * t270 - t132 * (q_i[4] * q_i[3])));
        let t297 = t13 * (t50 * t296 - t91 * t267)
            + (t103 * t217 + (t46 * t295 - t92 * t270));
        let t298 = q_i[4] * t104;
        let t299 = q_i[3] * t93;
        let t300 = q_i[5] * t104;
        let t301 = t160 * (t298 + (t299 - t56 * t297))
            - t162 * (t265 + t59 * t297 - t300);
        let t302 = q_i[4] * t268;
        let t303 = q_i[3] * q_i[3];
        let t304 = -(t101 * t133) - t28 * t100;
        let t305 = t101 * t268 + (t47 * t302 + (t132 * (t258 + t303) - t270 * t304));
        let t306 = t100 * t103 + (t46 * t302 + t13 * (t50 * t305 + t102 * t267));
        let t307 = q_i[3] * t104;
        let t308 = -(t140 * (t6 * t306 + t307)) - t143 * (t27 * t306 - t294);
        let t309 = q_j[4] * t113;
        let t310 = t111 * t127;
        let t311 = t13 * t109;
        let t312 = q_j[3] * t311;
        let t313 = t109 * half;
        let t314 = t110 * t125 + (t47 * t312 - t134 * t313 - t132 * (t240 - t22));
        let t315 = t13 * (t49 * t310 + t50 * t314)
            + (t51 * t313 + (t46 * t312 + t112 * t154));
        let t316 = q_j[5] * t113;
        let t317 = -(t160 * (t309 + (t214 + t56 * t315)))
            - t162 * (t316 + (t266 + t59 * t315));
        let t318 = q_j[6] * t113;
        let t319 = q_j[3] * t113;
        let t320 = q_j[4] * t311;
        let t321 = t47 * t320 + (t166 * t313 + t132 * (t15 + (t17 + t20 - t14)));
        let t322 = t112 * half;
        let t323 = t13 * (t50 * (t110 * t151 + t321) - t64 * t310)
            + (t63 * t322 + (t46 * t320 - t65 * t313));
        let t324 = t160 * (t319 + (t237 - t56 * t323))
            - t162 * (t59 * t323 + (t318 - t280));
        let t325 = t132 - t13 * (q_j[5] * t109);
        let t326 = t47 * t325 + (t132 * (t9 + t10) - t110 * t173 - t187 * t313);
        let t327 = t13 * (t50 * t326 + t73 * t310)
            + (t74 * t313 + (t46 * t325 - t75 * t112));
        let t328 = t160 * (t56 * t327 + (t245 + t318))
            - t157 * (t238 + t309 - t53 * t327);
        let t329 = q_j[6] * t311;
        let t330 = t47 * t329 + (t210 * t313 + t132 * (t4 + t2 - t6));
        let t331 = t13 * (t50 * (t110 * t193 + t330) - t82 * t310)
            + (t81 * t322 + (t46 * t329 - t83 * t313));
        let t332 = t162 * (t292 + (t309 - t59 * t331))
            - t160 * (t56 * t331 + (t316 - t226 - t253));
        let t333 = q_i[5] * t113;
        let t334 = q_i[3] * t311;
        let t335 = t110 * t228 + (t47 * t334 + (t259 * t313 - t132 * (q_i[5] * q_i[3])));
        let t336 = t13 * (t50 * t335 - t91 * t310)
            + (t112 * t217 + (t46 * t334 - t92 * t313));
        let t337 = q_i[4] * t113;
        let t338 = q_i[6] * t113;
        let t339 = t160 * (t337 + (t265 - t56 * t336))
            - t157 * (t262 + t53 * t336 - t338);
        let t340 = q_i[3] * t113;
        let t341 = q_i[4] * t311;
        let t342 = t110 * t268 + (t47 * t341 - t304 * t313 - t132 * (q_i[5] * q_i[4]));
        let t343 = t13 * (t50 * t342 + t102 * t310)
            + (t103 * t313 + (t46 * t341 + t112 * t270));
        let t344 = -(t160 * (t340 + (t294 + t56 * t343)))
            - t162 * (t59 * t343 + (t307 - t338));
        let t345 = q_i[5] * t311;
        let t346 = t255 + t303;
        let t347 = -(t110 * t133) - t28 * t109;
        let t348 = t110 * t311 + (t47 * t345 + (t132 * (t256 + t346) - t313 * t347));
        let t349 = t109 * t112 + (t46 * t345 + t13 * (t50 * t348 + t111 * t310));
        let t350 = -(t140 * (t338 + t6 * t349)) - t143 * (t340 + t27 * t349);
        let t351 = q_j[4] * t121;
        let t352 = t119 * t127;
        let t353 = t13 * t117;
        let t354 = q_j[3] * t353;
        let t355 = t117 * half;
        let t356 = t118 * t125 + (t47 * t354 - t134 * t355 - t132 * (t248 - t15));
        let t357 = t13 * (t49 * t352 + t50 * t356)
            + (t51 * t355 + (t46 * t354 + t120 * t154));
        let t358 = q_j[5] * t121;
        let t359 = -(t160 * (t351 + (t56 * t357 - t223)))
            - t162 * (t358 + (t221 + t59 * t357));
        let t360 = q_j[6] * t121;
        let t361 = q_j[4] * t353;
        let t362 = t47 * t361 + (t166 * t355 + t132 * (t25 + t23 - t27));
        let t363 = t120 * half;
        let t364 = t13 * (t50 * (t118 * t151 + t362) - t64 * t352)
            + (t63 * t363 + (t46 * t361 - t65 * t355));
        let t365 = q_j[3] * t121;
        let t366 = t157 * (t280 + t358 - t53 * t364)
            - t160 * (t56 * t364 + (t235 - t365));
        let t367 = q_j[5] * t353;
        let t368 = t47 * t367 + (t187 * t355 + t132 * (t1 + (t3 + t6 - t0)));
        let t369 = t13 * (t50 * (t118 * t173 + t368) - t73 * t352)
            + (t72 * t363 + (t46 * t367 - t74 * t355));
        let t370 = t162 * (t365 + (t238 - t59 * t369))
            - t160 * (t56 * t369 + (t226 + t243 - t360));
        let t371 = t132 - t13 * (q_j[6] * t117);
        let t372 = t47 * t371 + (t132 * (t9 + t11) - t118 * t193 - t210 * t355);
        let t373 = t13 * (t50 * t372 + t82 * t352)
            + (t83 * t355 + (t46 * t371 - t84 * t120));
        let t374 = t162 * (t59 * t373 + (t246 + t351))
            - t160 * (t251 + t358 - t56 * t373);
        let t375 = q_i[6] * t121;
        let t376 = q_i[3] * t353;
        let t377 = t118 * t228 + (t47 * t376 + (t259 * t355 - t132 * (q_i[6] * q_i[3])));
        let t378 = t13 * (t50 * t377 - t91 * t352)
            + (t120 * t217 + (t46 * t376 - t92 * t355));
        let t379 = q_i[5] * t121;
        let t380 = q_i[4] * t121;
        let t381 = t162 * (t379 + (t262 - t59 * t378))
            - t160 * (t263 + t56 * t378 - t380);
        let t382 = q_i[3] * t121;
        let t383 = q_i[4] * t353;
        let t384 = t118 * t268 + (t47 * t383 - t304 * t355 - t132 * (q_i[6] * q_i[4]));
        let t385 = t13 * (t50 * t384 + t102 * t352)
            + (t103 * t355 + (t46 * t383 + t120 * t270));
        let t386 = -(t160 * (t382 + (t56 * t385 - t300)))
            - t162 * (t59 * t385 + (t298 - t375));
        let t387 = q_i[5] * t353;
        let t388 = t118 * t311 + (t47 * t387 - t347 * t355 - t132 * (q_i[6] * q_i[5]));
        let t389 = t13 * (t50 * t388 + t111 * t352)
            + (t112 * t355 + (t46 * t387 + t120 * t313));
        let t390 = -(t160 * (t56 * t389 + (t375 - t333)))
            - t162 * (t59 * t389 + (t337 + t382));
        let t391 = q_i[6] * t353;
        let t392 = t132 * (t257 + t346) - t355 * (-(t118 * t133) - t28 * t117);
        let t393 = t50 * (t118 * t353 + (t47 * t391 + t392)) + t119 * t352;
        let t394 = t117 * t120 + (t46 * t391 + t13 * t393);
        let t395 = -(t140 * (t6 * t394 - t379)) - t143 * (t380 + t27 * t394);
        phi[0] = -(t33 * t34) - t35 * t36 - t37 * t38;
        phi[1] = -(t33 * t39) - t35 * t40 - t37 * t41;
        phi[2] = -(t33 * t42) - t35 * t43 - t37 * t44;
        phi_q[0] = h[2] * t55 + (h[0] * t58 + h[1] * t61);
        phi_q[1] = -(t34 * t68) - t36 * t69 - t38 * t70;
        phi_q[2] = -(t34 * t77) - t36 * t78 - t38 * t79;
        phi_q[3] = -(t34 * t86) - t36 * t87 - t38 * t88;
        phi_q[4] = -(t34 * t95) - t36 * t97 - t38 * t99;
        phi_q[5] = h[2] * t105 + (h[0] * t107 - t36 * t108);
        phi_q[6] = h[1] * t114 + (h[0] * t115 - t38 * t116);
        phi_q[7] = h[2] * t122 + (h[1] * t123 - t34 * t124);
        phi_q[8] = h[5] * t55 + (h[3] * t58 + h[4] * t61);
        phi_q[9] = -(t39 * t68) - t40 * t69 - t41 * t70;
        phi_q[10] = -(t39 * t77) - t40 * t78 - t41 * t79;
        phi_q[11] = -(t39 * t86) - t40 * t87 - t41 * t88;
        phi_q[12] = -(t39 * t95) - t40 * t97 - t41 * t99;
        phi_q[13] = h[5] * t105 + (h[3] * t107 - t40 * t108);
        phi_q[14] = h[4] * t114 + (h[3] * t115 - t41 * t116);
        phi_q[15] = h[5] * t122 + (h[4] * t123 - t39 * t124);
        phi_q[16] = h[8] * t55 + (h[6] * t58 + h[7] * t61);
        phi_q[17] = -(t42 * t68) - t43 * t69 - t44 * t70;
        phi_q[18] = -(t42 * t77) - t43 * t78 - t44 * t79;
        phi_q[19] = -(t42 * t86) - t43 * t87 - t44 * t88;
        phi_q[20] = -(t42 * t95) - t43 * t97 - t44 * t99;
        phi_q[21] = h[8] * t105 + (h[6] * t107 - t43 * t108);
        phi_q[22] = h[7] * t114 + (h[6] * t115 - t44 * t116);
        phi_q[23] = h[8] * t122 + (h[7] * t123 - t42 * t124);
        curvature[0] = t144 - (t20 * t137 + t145) * t147;
        curvature[1] = (t148 + (t141 + t53 * t156)) * t157 + t163;
        curvature[2] = t170 - t147 * (t161 + t20 * t168);
        curvature[3] = t157 * (t171 + (t53 * t176 - t138)) + t179;
        curvature[4] = t184 - t157 * (t53 * t183 + (t178 - t158));
        curvature[5] = t190 - t147 * (t20 * t189 - t177);
        curvature[6] = t157 * (t191 + (t159 + t53 * t196)) + t199;
        curvature[7] = t204 - t157 * (t53 * t203 + (t169 + t198));
        curvature[8] = t208 - t157 * (t53 * t207 + (t180 - t197));
        curvature[9] = t213 - t147 * (t200 + t20 * t212);
        curvature[10] = t157 * (t214 + (t53 * t219 + t220)) + t225;
        curvature[11] = t236 - t157 * (t237 + (t224 + t53 * t233));
        curvature[12] = t244 - t157 * (t245 + (t53 * t242 - t222));
        curvature[13] = t252 - t157 * (t253 + (t227 + t53 * t250));
        curvature[14] = t264 - t147 * (t20 * t261 + t265);
        curvature[15] = t275 - t157 * (t276 + (t223 + t53 * t272));
        curvature[16] = t157 * (t53 * t279 + (t235 + t274)) + t282;
        curvature[17] = t288 - t157 * (t53 * t287 + (t273 - t226 - t243));
        curvature[18] = t293 - t162 * (t59 * t291 + (t226 + t253 - t273));
        curvature[19] = t157 * (t294 + (t263 - t53 * t297)) + t301;
        curvature[20] = t308 - t147 * (t300 + t20 * t306);
        curvature[21] = t317 - t157 * (t318 + (t53 * t315 - t221));
        curvature[22] = t324 - t157 * (t53 * t323 + (t234 + t226 - t316));
        curvature[23] = t162 * (t59 * t327 + (t283 + t319)) + t328;
        curvature[24] = t332 - t157 * (t53 * t331 + (t246 - t319));
        curvature[25] = t162 * (t333 + (t299 - t59 * t336)) + t339;
        curvature[26] = t344 - t157 * (t53 * t343 + (t333 - t298));
        curvature[27] = t350 - t147 * (t20 * t349 - t337);
        curvature[28] = t359 - t157 * (t360 + (t266 + t53 * t357));
        curvature[29] = t366 - t162 * (t59 * t364 + (t360 - t226 - t234));
        curvature[30] = t370 - t157 * (t53 * t369 + (t351 - t283));
        curvature[31] = t157 * (t53 * t373 + (t292 + t365)) + t374;
        curvature[32] = t157 * (t375 + (t299 - t53 * t378)) + t381;
        curvature[33] = t386 - t157 * (t53 * t385 + (t307 + t379));
        curvature[34] = t390 - t157 * (t53 * t389 + (t340 - t380));
        curvature[35] = t395 - t147 * (t382 + t20 * t394);
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 70 additions, 263 multiplications, 1 divisions, 2 functions.
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
        let half = S::from_f64(0.5);
        let t0 = q_i[5] * q_j[6] + (q_i[4] * q_j[3] - q_i[3] * q_j[4] - q_i[6] * q_j[5]);
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
        let t10 = -(t0 * t9 * two);
        let t11 = -(t4 * t9 * two);
        let t12 = -(t3 * t9 * two);
        let t13 = q_j[3] * t6;
        let t14 = t8 * half;
        let t15 = t2 * t5;
        let t16 = t13 * t15 + t6 * (q_j[6] * t3 + (q_j[4] * t0 + q_j[5] * t4));
        let t17 = t7.atan_ratio(1);
        let t18 = t13 * t14 + t2 * (t16 * t17);
        let t19 = t0 * two;
        let t20 = q_j[4] * t9;
        let t21 = t18 * t19 + t20;
        let t22 = lambda[0] * two;
        let t23 = t4 * two;
        let t24 = q_j[5] * t9;
        let t25 = t18 * t23 + t24;
        let t26 = t3 * two;
        let t27 = q_j[6] * t9;
        let t28 = t18 * t26 + t27;
        let t29 = lambda[1] * two;
        let t30 = lambda[2] * two;
        let t31 = q_j[4] * t6;
        let t32 = t6 * (q_j[5] * t3 + (q_j[3] * t0 - q_j[6] * t4)) - t15 * t31;
        let t33 = t2 * (t17 * t32) - t14 * t31;
        let t34 = q_j[3] * t9;
        let t35 = t19 * t33 + t34;
        let t36 = t23 * t33 - t27;
        let t37 = t24 + t26 * t33;
        let t38 = q_j[5] * t6;
        let t39 = t6 * (q_j[6] * t0 + (q_j[3] * t4 - q_j[4] * t3)) - t15 * t38;
        let t40 = t2 * (t17 * t39) - t14 * t38;
        let t41 = t27 + t19 * t40;
        let t42 = t34 + t23 * t40;
        let t43 = t26 * t40 - t20;
        let t44 = q_j[6] * t6;
        let t45 = t6 * (q_j[4] * t4 + (q_j[3] * t3 - q_j[5] * t0)) - t15 * t44;
        let t46 = t2 * (t17 * t45) - t14 * t44;
        let t47 = t19 * t46 - t24;
        let t48 = t20 + t23 * t46;
        let t49 = t34 + t26 * t46;
        let t50 = q_i[3] * t6;
        let t51 = t6 * (q_i[6] * t3 + (q_i[4] * t0 + q_i[5] * t4)) - t15 * t50;
        let t52 = t2 * (t17 * t51) - t14 * t50;
        let t53 = q_i[4] * t9;
        let t54 = t19 * t52 + t53;
        let t55 = q_i[5] * t9;
        let t56 = t23 * t52 + t55;
        let t57 = q_i[6] * t9;
        let t58 = t26 * t52 + t57;
        let t59 = q_i[4] * t6;
        let t60 = t15 * t59 + t6 * (q_i[5] * t3 + (q_i[3] * t0 - q_i[6] * t4));
        let t61 = t14 * t59 + t2 * (t17 * t60);
        let t62 = q_i[3] * t9;
        let t63 = t19 * t61 + t62;
        let t64 = t57 - t4 * t61 * two;
        let t65 = t55 + t26 * t61;
        let t66 = q_i[5] * t6;
        let t67 = t15 * t66 + t6 * (q_i[6] * t0 + (q_i[3] * t4 - q_i[4] * t3));
        let t68 = t14 * t66 + t2 * (t17 * t67);
        let t69 = t57 + t19 * t68;
        let t70 = t62 + t23 * t68;
        let t71 = t53 - t3 * t68 * two;
        let t72 = q_i[6] * t6;
        let t73 = t15 * t72 + t6 * (q_i[4] * t4 + (q_i[3] * t3 - q_i[5] * t0));
        let t74 = t14 * t72 + t2 * (t17 * t73);
        let t75 = t55 - t0 * t74 * two;
        let t76 = t53 + t23 * t74;
        let t77 = t62 + t26 * t74;
        phi_h[0] = t10;
        phi_h[1] = t11;
        phi_h[2] = t12;
        phi_h[3] = t10;
        phi_h[4] = t11;
        phi_h[5] = t12;
        phi_h[6] = t10;
        phi_h[7] = t11;
        phi_h[8] = t12;
        force_h[0] = t21 * t22;
        force_h[1] = t22 * t25;
        force_h[2] = t22 * t28;
        force_h[3] = t21 * t29;
        force_h[4] = t25 * t29;
        force_h[5] = t28 * t29;
        force_h[6] = t21 * t30;
        force_h[7] = t25 * t30;
        force_h[8] = t28 * t30;
        force_h[9] = -(t22 * t35);
        force_h[10] = -(t22 * t36);
        force_h[11] = -(t22 * t37);
        force_h[12] = -(t29 * t35);
        force_h[13] = -(t29 * t36);
        force_h[14] = -(t29 * t37);
        force_h[15] = -(t30 * t35);
        force_h[16] = -(t30 * t36);
        force_h[17] = -(t30 * t37);
        force_h[18] = -(t22 * t41);
        force_h[19] = -(t22 * t42);
        force_h[20] = -(t22 * t43);
        force_h[21] = -(t29 * t41);
        force_h[22] = -(t29 * t42);
        force_h[23] = -(t29 * t43);
        force_h[24] = -(t30 * t41);
        force_h[25] = -(t30 * t42);
        force_h[26] = -(t30 * t43);
        force_h[27] = -(t22 * t47);
        force_h[28] = -(t22 * t48);
        force_h[29] = -(t22 * t49);
        force_h[30] = -(t29 * t47);
        force_h[31] = -(t29 * t48);
        force_h[32] = -(t29 * t49);
        force_h[33] = -(t30 * t47);
        force_h[34] = -(t30 * t48);
        force_h[35] = -(t30 * t49);
        force_h[36] = -(t22 * t54);
        force_h[37] = -(t22 * t56);
        force_h[38] = -(t22 * t58);
        force_h[39] = -(t29 * t54);
        force_h[40] = -(t29 * t56);
        force_h[41] = -(t29 * t58);
        force_h[42] = -(t30 * t54);
        force_h[43] = -(t30 * t56);
        force_h[44] = -(t30 * t58);
        force_h[45] = t22 * t63;
        force_h[46] = -(t22 * t64);
        force_h[47] = t22 * t65;
        force_h[48] = t29 * t63;
        force_h[49] = -(t29 * t64);
        force_h[50] = t29 * t65;
        force_h[51] = t30 * t63;
        force_h[52] = -(t30 * t64);
        force_h[53] = t30 * t65;
        force_h[54] = t22 * t69;
        force_h[55] = t22 * t70;
        force_h[56] = -(t22 * t71);
        force_h[57] = t29 * t69;
        force_h[58] = t29 * t70;
        force_h[59] = -(t29 * t71);
        force_h[60] = t30 * t69;
        force_h[61] = t30 * t70;
        force_h[62] = -(t30 * t71);
        force_h[63] = -(t22 * t75);
        force_h[64] = t22 * t76;
        force_h[65] = t22 * t77;
        force_h[66] = -(t29 * t75);
        force_h[67] = t29 * t76;
        force_h[68] = t29 * t77;
        force_h[69] = -(t30 * t75);
        force_h[70] = t30 * t76;
        force_h[71] = t30 * t77;
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
