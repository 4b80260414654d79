// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Prescribed angle about an axis
///
/// `sin(θ − α) = 0, with cos θ = (A_i u_i)ᵀ A_j w_j and sin θ = (A_i v_i)ᵀ A_j w_j` (unit 1)
///
/// Source: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.3; in sine form, so that it is smooth over several turns.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `u_i` | 1 | body i | unit vector normal to the axis, where the angle is zero |
/// | 3..6 | `v_i` | 1 | body i | unit vector normal to the axis and to u_i, a quarter turn on |
/// | 6..9 | `w_j` | 1 | body j | unit vector normal to the axis, whose angle is prescribed |
/// | 9 | `angle` | rad |  | the angle |
pub mod rotation {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "rotation",
        title: "Prescribed angle about an axis",
        equation: "sin(θ − α) = 0, with cos θ = (A_i u_i)ᵀ A_j w_j and sin θ = (A_i v_i)ᵀ A_j w_j",
        reference: "Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.3; in sine form, so that it is smooth over several turns",
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
                meaning: "unit vector normal to the axis, where the angle is zero",
            },
            Parameter {
                name: "v_i",
                size: 3,
                offset: 3,
                unit: "1",
                frame: "body i",
                meaning: "unit vector normal to the axis and to u_i, a quarter turn on",
            },
            Parameter {
                name: "w_j",
                size: 3,
                offset: 6,
                unit: "1",
                frame: "body j",
                meaning: "unit vector normal to the axis, whose angle is prescribed",
            },
            Parameter {
                name: "angle",
                size: 1,
                offset: 9,
                unit: "rad",
                frame: "",
                meaning: "the angle",
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
            (3, 0),
            (3, 1),
            (3, 2),
            (3, 3),
            (3, 4),
            (3, 5),
            (3, 6),
            (3, 7),
            (3, 8),
            (3, 9),
            (4, 0),
            (4, 1),
            (4, 2),
            (4, 3),
            (4, 4),
            (4, 5),
            (4, 6),
            (4, 7),
            (4, 8),
            (4, 9),
            (5, 0),
            (5, 1),
            (5, 2),
            (5, 3),
            (5, 4),
            (5, 5),
            (5, 6),
            (5, 7),
            (5, 8),
            (5, 9),
            (6, 0),
            (6, 1),
            (6, 2),
            (6, 3),
            (6, 4),
            (6, 5),
            (6, 6),
            (6, 7),
            (6, 8),
            (6, 9),
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
        ],
        rate: &[(0, 3), (0, 4), (0, 5), (0, 6), (0, 10), (0, 11), (0, 12), (0, 13)],
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
            (0, 9),
        ],
        operations: [
            Operations {
                additions: 56,
                multiplications: 80,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 87,
                multiplications: 139,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 153,
                multiplications: 220,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 281,
                multiplications: 486,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 324,
                multiplications: 411,
                divisions: 0,
                functions: 2,
            },
        ],
    };
    /// Prescribed angle about an axis
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Rotation;
    impl<S: Scalar> Relation<S> for Rotation {
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
    /// 56 additions, 80 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        phi: &mut [S; 1],
    ) {
        let t0 = h[5] * q_i[6] + (h[3] * q_i[4] + q_i[5] * h[4]);
        let t1 = q_i[3] * h[5] + h[4] * q_i[4] - h[3] * q_i[5];
        let t2 = h[3] * q_i[6] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t3 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = h[8] * q_j[6] + (h[6] * q_j[4] + q_j[5] * h[7]);
        let t6 = q_j[3] * h[8] + h[7] * q_j[4] - h[6] * q_j[5];
        let t7 = h[6] * q_j[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t8 = q_j[3] * h[6] + q_j[5] * h[8] - q_j[6] * h[7];
        let t9 = q_j[6] * t5 + (q_j[3] * t6 + q_j[4] * t7 - q_j[5] * t8);
        let t10 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t11 = q_j[5] * t6 + (q_j[3] * t8 + q_j[4] * t5) - q_j[6] * t7;
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t7 - q_j[4] * t6));
        let t14 = h[9].cos() * (t4 * t9 + (t10 * t11 + t12 * t13));
        let t15 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t16 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t17 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t18 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t19 = q_i[6] * t15 + (q_i[3] * t16 + q_i[4] * t17 - q_i[5] * t18);
        let t20 = q_i[5] * t16 + (q_i[3] * t18 + q_i[4] * t15) - q_i[6] * t17;
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t17 - q_i[4] * t16));
        let t22 = h[9].sin() * (t9 * t19 + (t11 * t20 + t13 * t21));
        phi[0] = t14 - t22;
    }
    /// Φ, Φ_q and W.
    ///
    /// 87 additions, 139 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        phi: &mut [S; 1],
        phi_q: &mut [S; 8],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[9].cos();
        let t1 = q_j[6] * h[8] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t2 = q_j[6] * h[6] + (q_j[3] * h[7] - q_j[4] * h[8]);
        let t3 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t4 = h[8] * q_j[5] + (q_j[3] * h[6] - q_j[6] * h[7]);
        let t5 = q_j[6] * t1 + (q_j[4] * t2 + (q_j[3] * t3 - q_j[5] * t4));
        let t6 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t7 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t8 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t9 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t10 = q_i[6] * t6 + (q_i[4] * t7 + (q_i[3] * t8 - q_i[5] * t9));
        let t11 = q_j[5] * t3 + (q_j[4] * t1 + (q_j[3] * t4 - q_j[6] * t2));
        let t12 = q_i[5] * t8 + (q_i[4] * t6 + (q_i[3] * t9 - q_i[6] * t7));
        let t13 = q_j[6] * t4 + (q_j[5] * t1 + (q_j[3] * t2 - q_j[4] * t3));
        let t14 = q_i[6] * t9 + (q_i[5] * t6 + (q_i[3] * t7 - q_i[4] * t8));
        let t15 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t16 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t17 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t18 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = h[9].sin();
        let t23 = t22 * (-(t11 * t18) - t16 * t13 - t17 * t5);
        let t24 = t0 * (t13 * t7 + (t5 * t8 + t11 * t9)) + t23;
        let t25 = t0 * (t11 * t6 + (t5 * t7 - t13 * t8))
            + t22 * (t17 * t13 - t11 * t15 - t16 * t5);
        let t26 = t0 * (t11 * t8 + (t13 * t6 - t5 * t9))
            + t22 * (t18 * t5 - t11 * t17 - t15 * t13);
        let t27 = t0 * (t13 * t9 + (t5 * t6 - t11 * t7))
            + t22 * (t11 * t16 - t18 * t13 - t15 * t5);
        let t28 = t0 * t14 - t21 * t22;
        let t29 = t0 * t10 - t19 * t22;
        let t30 = t0 * t12 - t20 * t22;
        phi[0] = t0 * (t5 * t10 + (t11 * t12 + t13 * t14))
            - (t5 * t19 + (t11 * t20 + t13 * t21)) * t22;
        phi_q[0] = t24 * two;
        phi_q[1] = t25 * two;
        phi_q[2] = t26 * two;
        phi_q[3] = t27 * two;
        phi_q[4] = (t2 * t28 + (t3 * t29 + t4 * t30)) * two;
        phi_q[5] = (t2 * t29 + (t1 * t30 - t3 * t28)) * two;
        phi_q[6] = (t1 * t28 + (t3 * t30 - t4 * t29)) * two;
        phi_q[7] = (t4 * t28 + (t1 * t29 - t2 * t30)) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 153 additions, 220 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 8],
        _work: &mut [S; 0],
        curvature: &mut [S; 36],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[9].cos();
        let t1 = h[8] * q_j[6] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t2 = q_j[6] * h[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t3 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t4 = h[8] * q_j[5] + (q_j[3] * h[6] - h[7] * q_j[6]);
        let t5 = q_j[6] * t1 + (q_j[4] * t2 + (q_j[3] * t3 - q_j[5] * t4));
        let t6 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t7 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t8 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t9 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t10 = q_i[6] * t6 + (q_i[4] * t7 + (q_i[3] * t8 - q_i[5] * t9));
        let t11 = q_j[5] * t3 + (q_j[4] * t1 + (q_j[3] * t4 - q_j[6] * t2));
        let t12 = q_i[5] * t8 + (q_i[4] * t6 + (q_i[3] * t9 - q_i[6] * t7));
        let t13 = q_j[6] * t4 + (q_j[5] * t1 + (q_j[3] * t2 - q_j[4] * t3));
        let t14 = q_i[6] * t9 + (q_i[5] * t6 + (q_i[3] * t7 - q_i[4] * t8));
        let t15 = h[9].sin();
        let t16 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t17 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t18 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t19 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t20 = q_i[6] * t16 + (q_i[4] * t17 + (q_i[3] * t18 - q_i[5] * t19));
        let t21 = q_i[5] * t18 + (q_i[4] * t16 + (q_i[3] * t19 - q_i[6] * t17));
        let t22 = q_i[6] * t19 + (q_i[5] * t16 + (q_i[3] * t17 - q_i[4] * t18));
        let t23 = t0 * two;
        let t24 = t5 * t23;
        let t25 = t13 * t23;
        let t26 = t11 * t23;
        let t27 = t15 * two;
        let t28 = t11 * t27;
        let t29 = t13 * t27;
        let t30 = t5 * t27;
        let t31 = t9 * t26 - t19 * t28 - t17 * t29 - t18 * t30;
        let t32 = t16 * t27;
        let t33 = t6 * t26 - t23 * (t13 * t8) - t11 * t32 - t17 * t30;
        let t34 = t6 * t25 - t23 * (t5 * t9) - t18 * t28 - t13 * t32;
        let t35 = t6 * t24 - t23 * (t11 * t7) - t19 * t29 - t5 * t32;
        let t36 = t0 * t10 - t15 * t20;
        let t37 = t36 * two;
        let t38 = t0 * t12 - t15 * t21;
        let t39 = t38 * two;
        let t40 = t0 * t14 - t15 * t22;
        let t41 = t40 * two;
        let t42 = t0 * lambda[0];
        let t43 = t5 * t42 * two;
        let t44 = t15 * lambda[0];
        let t45 = t5 * t44 * two;
        let t46 = h[5] * t43 - h[2] * t45;
        let t47 = t11 * t42 * two;
        let t48 = t11 * t44 * two;
        let t49 = h[3] * t47 - h[0] * t48;
        let t50 = t13 * t42 * two;
        let t51 = t13 * t44 * two;
        let t52 = h[4] * t50 - h[1] * t51;
        let t53 = h[4] * t43 - h[1] * t45;
        let t54 = h[2] * t51;
        let t55 = h[5] * t50;
        let t56 = h[5] * t47 - h[2] * t48;
        let t57 = h[0] * t45;
        let t58 = h[3] * t43;
        let t59 = h[3] * t50 - h[0] * t51;
        let t60 = h[4] * t47;
        let t61 = h[1] * t48;
        let t62 = t52 - t46;
        let t63 = (t9 * t42 - t19 * t44) * k4;
        let t64 = t4 * t63;
        let t65 = (t8 * t42 - t18 * t44) * k4;
        let t66 = t3 * t65;
        let t67 = (t7 * t42 - t17 * t44) * k4;
        let t68 = t2 * t67;
        let t69 = t66 + t68;
        let t70 = t3 * t67;
        let t71 = (t6 * t42 - t16 * t44) * k4;
        let t72 = t4 * t71;
        let t73 = t2 * t65;
        let t74 = t72 - t73;
        let t75 = t4 * t65;
        let t76 = t2 * t71;
        let t77 = t3 * t63;
        let t78 = t76 - t77;
        let t79 = t2 * t63;
        let t80 = t3 * t71;
        let t81 = t4 * t67;
        let t82 = t80 - t81;
        let t83 = t38 * lambda[0] * two;
        let t84 = h[6] * t83;
        let t85 = t36 * lambda[0] * two;
        let t86 = h[8] * t85;
        let t87 = t40 * lambda[0] * two;
        let t88 = h[7] * t87;
        let t89 = t1 * t63;
        let t90 = t89 - t70;
        let t91 = t1 * t71;
        let t92 = t1 * t65;
        let t93 = t92 - t79;
        let t94 = t1 * t67;
        let t95 = h[7] * t85;
        let t96 = h[8] * t87;
        let t97 = t94 - t75;
        let t98 = t64 + t91;
        let t99 = h[8] * t83;
        let t100 = h[6] * t85;
        let t101 = h[7] * t83;
        let t102 = h[6] * t87;
        let t103 = t88 - t86;
        phi[0] = t0 * (t5 * t10 + (t11 * t12 + t13 * t14))
            - t15 * (t5 * t20 + (t11 * t21 + t13 * t22));
        phi_q[0] = t8 * t24 + (t7 * t25 + t31);
        phi_q[1] = t27 * (t18 * t13) + (t7 * t24 + t33);
        phi_q[2] = t27 * (t19 * t5) + (t8 * t26 + t34);
        phi_q[3] = t27 * (t11 * t17) + (t9 * t25 + t35);
        phi_q[4] = t3 * t37 + (t4 * t39 + t2 * t41);
        phi_q[5] = t2 * t37 + (t1 * t39 - t3 * t40 * two);
        phi_q[6] = t3 * t39 + (t1 * t41 - t4 * t36 * two);
        phi_q[7] = t4 * t41 + (t1 * t37 - t2 * t38 * two);
        curvature[0] = t46 + (t49 + t52);
        curvature[1] = t53 + (t54 - t55);
        curvature[2] = t49 - t52 - t46;
        curvature[3] = t56 + (t57 - t58);
        curvature[4] = t59 + (t60 - t61);
        curvature[5] = t62 - t49;
        curvature[6] = t61 + (t59 - t60);
        curvature[7] = t58 + (t56 - t57);
        curvature[8] = t55 + (t53 - t54);
        curvature[9] = -t62 - t49;
        curvature[10] = t64 + t69;
        curvature[11] = t70 + t74;
        curvature[12] = t75 + t78;
        curvature[13] = t79 + t82;
        curvature[14] = t84 + (t86 + t88);
        curvature[15] = t73 + t90;
        curvature[16] = t69 + t91;
        curvature[17] = t93 - t80;
        curvature[18] = t78 - t94;
        curvature[19] = t95 - t96;
        curvature[20] = t84 - t86 - t88;
        curvature[21] = t77 + t97;
        curvature[22] = t82 - t92;
        curvature[23] = t66 + t98;
        curvature[24] = t90 - t72;
        curvature[25] = t99 - t100;
        curvature[26] = t101 + t102;
        curvature[27] = t103 - t84;
        curvature[28] = t81 + t93;
        curvature[29] = t97 - t76;
        curvature[30] = t74 - t89;
        curvature[31] = t68 + t98;
        curvature[32] = t102 - t101;
        curvature[33] = t100 + t99;
        curvature[34] = t96 + t95;
        curvature[35] = -t103 - t84;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 281 additions, 486 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        lambda: &[S; 1],
        phi_h: &mut [S; 10],
        force_h: &mut [S; 80],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[9].sin();
        let t1 = t0 * two;
        let t2 = q_j[5] * h[8] + (h[6] * q_j[3] - h[7] * q_j[6]);
        let t3 = h[8] * q_j[6] + (h[6] * q_j[4] + q_j[5] * h[7]);
        let t4 = h[6] * q_j[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t5 = q_j[4] * h[7] + (q_j[3] * h[8] - h[6] * q_j[5]);
        let t6 = q_j[6] * t2 + (q_j[5] * t3 + (q_j[3] * t4 - q_j[4] * t5));
        let t7 = q_i[3] * q_i[6];
        let t8 = q_i[4] * q_i[5];
        let t9 = t7 + t8;
        let t10 = t6 * t9;
        let t11 = q_j[6] * t3 + (q_j[4] * t4 + (q_j[3] * t5 - q_j[5] * t2));
        let t12 = q_i[6] * q_i[4];
        let t13 = q_i[3] * q_i[5];
        let t14 = t12 - t13;
        let t15 = t11 * t14;
        let t16 = q_j[5] * t5 + (q_j[4] * t3 + (q_j[3] * t2 - q_j[6] * t4));
        let t17 = q_i[3] * q_i[3];
        let t18 = q_i[4] * q_i[4];
        let t19 = q_i[6] * q_i[6];
        let t20 = q_i[5] * q_i[5];
        let t21 = t17 + t18 - t19 - t20;
        let t22 = t16 * t21;
        let t23 = t8 - t7;
        let t24 = t16 * t23;
        let t25 = q_i[3] * q_i[4];
        let t26 = q_i[6] * q_i[5];
        let t27 = t25 + t26;
        let t28 = t11 * t27;
        let t29 = t17 - t18;
        let t30 = t20 - t19;
        let t31 = t29 + t30;
        let t32 = t6 * t31;
        let t33 = t13 + t12;
        let t34 = t16 * t33;
        let t35 = t26 - t25;
        let t36 = t6 * t35;
        let t37 = t29 - t30;
        let t38 = t11 * t37;
        let t39 = h[9].cos();
        let t40 = t39 * two;
        let t41 = q_j[3] * q_j[3];
        let t42 = q_j[4] * q_j[4];
        let t43 = q_j[6] * q_j[6];
        let t44 = q_j[5] * q_j[5];
        let t45 = t41 + t42 - t43 - t44;
        let t46 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t47 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t48 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t49 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t50 = q_i[5] * t46 + (q_i[4] * t47 + (q_i[3] * t48 - q_i[6] * t49));
        let t51 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t52 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t53 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t54 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t55 = q_i[5] * t51 + (q_i[4] * t52 + (q_i[3] * t53 - q_i[6] * t54));
        let t56 = t39 * t50 - t0 * t55;
        let t57 = q_j[3] * q_j[6];
        let t58 = q_j[5] * q_j[4];
        let t59 = t57 + t58;
        let t60 = q_i[6] * t48 + (q_i[5] * t47 + (q_i[3] * t49 - q_i[4] * t46));
        let t61 = q_i[6] * t53 + (q_i[5] * t52 + (q_i[3] * t54 - q_i[4] * t51));
        let t62 = t39 * t60 - t0 * t61;
        let t63 = t62 * two;
        let t64 = q_j[4] * q_j[6];
        let t65 = q_j[5] * q_j[3];
        let t66 = t64 - t65;
        let t67 = q_i[6] * t47 + (q_i[4] * t49 + (q_i[3] * t46 - q_i[5] * t48));
        let t68 = q_i[6] * t52 + (q_i[4] * t54 + (q_i[3] * t51 - q_i[5] * t53));
        let t69 = t39 * t67 - t0 * t68;
        let t70 = t69 * two;
        let t71 = t41 - t42;
        let t72 = t44 - t43;
        let t73 = t71 + t72;
        let t74 = t58 - t57;
        let t75 = t56 * two;
        let t76 = q_j[3] * q_j[4];
        let t77 = q_j[5] * q_j[6];
        let t78 = t76 + t77;
        let t79 = t71 - t72;
        let t80 = t65 + t64;
        let t81 = t77 - t76;
        let t82 = -(t39 * (t11 * t68 + (t16 * t55 + t6 * t61)));
        let t83 = t0 * lambda[0];
        let t84 = t11 * t83;
        let t85 = q_i[5] * two;
        let t86 = t16 * t83;
        let t87 = t86 * two;
        let t88 = t6 * t83;
        let t89 = t88 * two;
        let t90 = t84 * t85 - q_i[3] * t87 - q_i[6] * t89;
        let t91 = q_i[6] * two;
        let t92 = t84 * two;
        let t93 = t86 * t91 - q_i[3] * t89 - q_i[4] * t92;
        let t94 = q_i[4] * two;
        let t95 = t88 * t94 - q_i[3] * t92 - q_i[5] * t87;
        let t96 = t39 * lambda[0];
        let t97 = t6 * t96;
        let t98 = t97 * two;
        let t99 = q_i[6] * t98;
        let t100 = t16 * t96;
        let t101 = q_i[3] * two;
        let t102 = t11 * t96;
        let t103 = t102 * two;
        let t104 = q_i[5] * t103;
        let t105 = t99 + (t100 * t101 - t104);
        let t106 = q_i[4] * t103;
        let t107 = t100 * two;
        let t108 = q_i[6] * t107;
        let t109 = t106 + (t101 * t97 - t108);
        let t110 = q_i[5] * t107;
        let t111 = q_i[4] * t98;
        let t112 = t110 + (t102 * t101 - t111);
        let t113 = t66 * t96;
        let t114 = t46 * k4;
        let t115 = t59 * t96;
        let t116 = t49 * k4;
        let t117 = t45 * t96;
        let t118 = t117 * two;
        let t119 = t59 * t83;
        let t120 = t54 * k4;
        let t121 = t66 * t83;
        let t122 = t51 * k4;
        let t123 = t45 * t83;
        let t124 = t53 * two;
        let t125 = t48 * t118 - t119 * t120 - t121 * t122 - t123 * t124;
        let t126 = t78 * t96;
        let t127 = t74 * t96;
        let t128 = t48 * k4;
        let t129 = t73 * t96;
        let t130 = t129 * two;
        let t131 = t74 * t83;
        let t132 = t53 * k4;
        let t133 = t78 * t83;
        let t134 = t73 * t83;
        let t135 = t54 * two;
        let t136 = t49 * t130 - t131 * t132 - t122 * t133 - t134 * t135;
        let t137 = t81 * t96;
        let t138 = t80 * t96;
        let t139 = t79 * t96;
        let t140 = t139 * two;
        let t141 = t80 * t83;
        let t142 = t81 * t83;
        let t143 = t79 * t83;
        let t144 = t51 * two;
        let t145 = t46 * t140 - t132 * t141 - t120 * t142 - t143 * t144;
        let t146 = -(t48 * t87) - t49 * t89 - t46 * t92 - t53 * t107;
        let t147 = -(q_i[4] * t87) - q_i[5] * t89 - q_i[6] * t92;
        let t148 = q_i[6] * t103 + (q_i[4] * t107 + q_i[5] * t98);
        let t149 = t52 * two;
        let t150 = t47 * t118 - t115 * t114 - t120 * t121 - t123 * t149;
        let t151 = t47 * k4;
        let t152 = t52 * k4;
        let t153 = t51 * t134 * two - t131 * t152 - t120 * t133 - t46 * t129 * two;
        let t154 = t49 * t140 - t114 * t137 - t141 * t152 - t135 * t143;
        let t155 = t46 * t88 * two - t47 * t87 - t49 * t92 - t52 * t107;
        let t156 = t46 * t118 - t113 * t128 - t119 * t152 - t123 * t144;
        let t157 = t47 * t130 - t128 * t126 - t122 * t131 - t134 * t149;
        let t158 = t53 * t143 * two - t142 * t152 - t122 * t141 - t48 * t139 * two;
        let t159 = t48 * t84 * two - t47 * t89 - t46 * t87 - t52 * t98;
        let t160 = t54 * t123 * two - t121 * t152 - t119 * t132 - t49 * t117 * two;
        let t161 = t48 * t130 - t116 * t127 - t133 * t152 - t124 * t134;
        let t162 = t47 * t140 - t116 * t138 - t132 * t142 - t143 * t149;
        let t163 = t49 * t86 * two - t47 * t92 - t48 * t89 - t52 * t103;
        let t164 = t9 * t83;
        let t165 = t4 * k4;
        let t166 = t14 * t83;
        let t167 = t5 * k4;
        let t168 = t21 * t83;
        let t169 = t2 * two;
        let t170 = t23 * t83;
        let t171 = t2 * k4;
        let t172 = t27 * t83;
        let t173 = t31 * t83;
        let t174 = t4 * two;
        let t175 = t33 * t83;
        let t176 = t35 * t83;
        let t177 = t37 * t83;
        let t178 = t5 * two;
        let t179 = t14 * t96;
        let t180 = t21 * t96;
        let t181 = t9 * t96;
        let t182 = t27 * t96;
        let t183 = t31 * t96;
        let t184 = t23 * t96;
        let t185 = t35 * t96;
        let t186 = t37 * t96;
        let t187 = t33 * t96;
        let t188 = t62 * lambda[0] * two;
        let t189 = q_j[6] * t188;
        let t190 = t56 * lambda[0] * two;
        let t191 = t69 * lambda[0] * two;
        let t192 = q_j[3] * t190 - q_j[5] * t191;
        let t193 = t189 + t192;
        let t194 = q_j[4] * t191;
        let t195 = q_j[3] * t188 - q_j[6] * t190;
        let t196 = t194 + t195;
        let t197 = q_j[5] * t190;
        let t198 = q_j[3] * t191 - q_j[4] * t188;
        let t199 = t197 + t198;
        let t200 = t50 * t83 + t55 * t96;
        let t201 = t60 * t83 + t61 * t96;
        let t202 = t67 * t83 + t68 * t96;
        let t203 = t3 * two;
        let t204 = t3 * k4;
        let t205 = q_j[6] * t191 + (q_j[4] * t190 + q_j[5] * t188);
        phi_h[0] = -(t1 * t10) - t1 * t15 - t0 * t22;
        phi_h[1] = -(t1 * t24) - t1 * t28 - t0 * t32;
        phi_h[2] = -(t1 * t34) - t1 * t36 - t0 * t38;
        phi_h[3] = t22 * t39 + (t10 * t40 + t15 * t40);
        phi_h[4] = t32 * t39 + (t24 * t40 + t28 * t40);
        phi_h[5] = t38 * t39 + (t34 * t40 + t36 * t40);
        phi_h[6] = t45 * t56 + (t59 * t63 + t66 * t70);
        phi_h[7] = t62 * t73 + (t74 * t75 + t70 * t78);
        phi_h[8] = t69 * t79 + (t75 * t80 + t63 * t81);
        phi_h[9] = t82 - t0 * (t11 * t67 + (t16 * t50 + t6 * t60));
        force_h[0] = t90;
        force_h[1] = t93;
        force_h[2] = t95;
        force_h[3] = t105;
        force_h[4] = t109;
        force_h[5] = t112;
        force_h[6] = t113 * t114 + (t115 * t116 + t125);
        force_h[7] = t114 * t126 + (t127 * t128 + t136);
        force_h[8] = t116 * t137 + (t128 * t138 + t145);
        force_h[9] = t146 - t54 * t98 - t51 * t103;
        force_h[10] = t147;
        force_h[11] = t95;
        force_h[12] = t84 * t94 + (t88 * t101 - q_i[6] * t87);
        force_h[13] = t148;
        force_h[14] = t112;
        force_h[15] = t108 - q_i[3] * t98 - t106;
        force_h[16] = t119 * t122 + (t116 * t113 + t150);
        force_h[17] = t116 * t126 + (t127 * t151 + t153);
        force_h[18] = t122 * t142 + (t138 * t151 + t154);
        force_h[19] = t51 * t98 + (t155 - t54 * t103);
        force_h[20] = t86 * t85 + (t84 * t101 - q_i[4] * t89);
        force_h[21] = t147;
        force_h[22] = t90;
        force_h[23] = t111 - q_i[3] * t103 - t110;
        force_h[24] = t148;
        force_h[25] = t105;
        force_h[26] = t121 * t132 + (t115 * t151 + t156);
        force_h[27] = t132 * t133 + (t114 * t127 + t157);
        force_h[28] = t114 * t138 + (t137 * t151 + t158);
        force_h[29] = t53 * t103 + (t159 - t51 * t107);
        force_h[30] = t93;
        force_h[31] = t88 * t91 + (t86 * t101 - q_i[5] * t92);
        force_h[32] = t147;
        force_h[33] = t109;
        force_h[34] = t104 - q_i[3] * t107 - t99;
        force_h[35] = t148;
        force_h[36] = t115 * t128 + (t113 * t151 + t160);
        force_h[37] = t120 * t131 + (t126 * t151 + t161);
        force_h[38] = t120 * t141 + (t128 * t137 + t162);
        force_h[39] = t54 * t107 + (t163 - t53 * t98);
        force_h[40] = -(t164 * t165) - t166 * t167 - t168 * t169;
        force_h[41] = -(t170 * t171) - t167 * t172 - t173 * t174;
        force_h[42] = -(t171 * t175) - t165 * t176 - t177 * t178;
        force_h[43] = t167 * t179 + (t169 * t180 + t165 * t181);
        force_h[44] = t167 * t182 + (t174 * t183 + t171 * t184);
        force_h[45] = t165 * t185 + (t178 * t186 + t171 * t187);
        force_h[46] = t193;
        force_h[47] = t196;
        force_h[48] = t199;
        force_h[49] = -(t169 * t200) - t174 * t201 - t178 * t202;
        force_h[50] = t164 * t167 - t165 * t166 - t168 * t203;
        force_h[51] = t173 * t178 - t170 * t204 - t165 * t172;
        force_h[52] = t167 * t176 - t175 * t204 - t174 * t177;
        force_h[53] = t165 * t179 + (t180 * t203 - t167 * t181);
        force_h[54] = t165 * t182 + (t184 * t204 - t178 * t183);
        force_h[55] = t187 * t204 + (t174 * t186 - t167 * t185);
        force_h[56] = t205;
        force_h[57] = t199;
        force_h[58] = -t195 - t194;
        force_h[59] = t178 * t201 - t200 * t203 - t174 * t202;
        force_h[60] = t166 * t171 - t164 * t204 - t168 * t178;
        force_h[61] = t171 * t172 - t167 * t170 - t173 * t203;
        force_h[62] = t169 * t177 - t176 * t204 - t167 * t175;
        force_h[63] = t181 * t204 + (t178 * t180 - t171 * t179);
        force_h[64] = t167 * t184 + (t183 * t203 - t171 * t182);
        force_h[65] = t167 * t187 + (t185 * t204 - t169 * t186);
        force_h[66] = -t198 - t197;
        force_h[67] = t205;
        force_h[68] = t193;
        force_h[69] = t169 * t202 - t201 * t203 - t178 * t200;
        force_h[70] = t168 * t174 - t166 * t204 - t164 * t171;
        force_h[71] = t165 * t170 - t172 * t204 - t169 * t173;
        force_h[72] = t165 * t175 - t171 * t176 - t177 * t203;
        force_h[73] = t171 * t181 + (t179 * t204 - t174 * t180);
        force_h[74] = t182 * t204 + (t169 * t183 - t165 * t184);
        force_h[75] = t171 * t185 + (t186 * t203 - t165 * t187);
        force_h[76] = t196;
        force_h[77] = -t192 - t189;
        force_h[78] = t205;
        force_h[79] = t174 * t200 - t202 * t203 - t169 * t201;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 324 additions, 411 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 8],
        rate_h: &mut [S; 10],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[9].cos();
        let t1 = h[8] * q_j[6] + (h[6] * q_j[4] + h[7] * q_j[5]);
        let t2 = q_j[3] * h[8] + h[7] * q_j[4] - h[6] * q_j[5];
        let t3 = h[6] * q_j[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t4 = q_j[3] * h[6] + h[8] * q_j[5] - h[7] * q_j[6];
        let t5 = q_j[6] * t1 + (q_j[3] * t2 + q_j[4] * t3 - q_j[5] * t4);
        let t6 = h[5] * v_i[3] + (h[4] * v_i[4] - h[3] * v_i[5]);
        let t7 = q_j[6] * t4 + (q_j[5] * t1 + (q_j[3] * t3 - q_j[4] * t2));
        let t8 = h[3] * v_i[6] + h[4] * v_i[3] - h[5] * v_i[4];
        let t9 = q_j[5] * t2 + (q_j[3] * t4 + q_j[4] * t1) - q_j[6] * t3;
        let t10 = h[5] * v_i[5] + (h[3] * v_i[3] - h[4] * v_i[6]);
        let t11 = q_i[3] * h[5] + h[4] * q_i[4] - h[3] * q_i[5];
        let t12 = v_j[6] * h[8] + (h[6] * v_j[4] + h[7] * v_j[5]);
        let t13 = v_j[3] * h[8] + (h[7] * v_j[4] - h[6] * v_j[5]);
        let t14 = h[6] * v_j[6] + v_j[3] * h[7] - h[8] * v_j[4];
        let t15 = v_j[3] * t2 + (t12 * q_j[6] + (q_j[3] * t13 + q_j[4] * t14));
        let t16 = h[8] * v_j[5] + (h[6] * v_j[3] - h[7] * v_j[6]);
        let t17 = v_j[6] * t1 + (v_j[4] * t3 + t15) - (t16 * q_j[5] + v_j[5] * t4);
        let t18 = q_i[3] * h[3] + q_i[5] * h[5] - h[4] * q_i[6];
        let t19 = v_j[3] * t4 + (q_j[5] * t13 + (q_j[3] * t16 + q_j[4] * t12));
        let t20 = v_j[5] * t2 + (v_j[4] * t1 + t19) - (q_j[6] * t14 + v_j[6] * t3);
        let t21 = h[3] * q_i[6] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t22 = v_j[3] * t3 + (t16 * q_j[6] + (q_j[3] * t14 + t12 * q_j[5]));
        let t23 = v_j[6] * t4 + (v_j[5] * t1 + t22) - (q_j[4] * t13 + v_j[4] * t2);
        let t24 = t9 * t10 + (t11 * t17 + (t18 * t20 + t21 * t23));
        let t25 = h[9].sin();
        let t26 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t27 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t28 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t29 = v_i[3] * h[2] + (v_i[4] * h[1] - v_i[5] * h[0]);
        let t30 = v_i[5] * h[2] + (v_i[3] * h[0] - v_i[6] * h[1]);
        let t31 = v_i[6] * h[0] + v_i[3] * h[1] - v_i[4] * h[2];
        let t32 = t20 * t28 + (t5 * t29 + (t9 * t30 + t7 * t31));
        let t33 = h[5] * v_i[6] + (h[3] * v_i[4] + h[4] * v_i[5]);
        let t34 = h[5] * q_i[6] + (h[3] * q_i[4] + q_i[5] * h[4]);
        let t35 = t8 * t5 + (t9 * t33 + (t20 * t34 + t21 * t17));
        let t36 = t0 * (t35 * two - (t23 * t11 + t7 * t6) * two);
        let t37 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t38 = v_i[6] * h[2] + (v_i[4] * h[0] + v_i[5] * h[1]);
        let t39 = t17 * t27 + (t20 * t37 + (t9 * t38 + t5 * t31));
        let t40 = t25 * ((t7 * t29 + t23 * t26) * two - t39 * two);
        let t41 = t7 * t33 + (t9 * t6 + (t23 * t34 + t20 * t11));
        let t42 = t0 * (t41 * two - (t18 * t17 + t10 * t5) * two);
        let t43 = t20 * t26 + (t23 * t37 + (t9 * t29 + t7 * t38));
        let t44 = t25 * ((t5 * t30 + t17 * t28) * two - t43 * two);
        let t45 = t5 * t33 + (t10 * t7 + (t17 * t34 + t18 * t23));
        let t46 = t0 * (t45 * two - (t20 * t21 + t9 * t8) * two);
        let t47 = t23 * t28 + (t17 * t37 + (t7 * t30 + t5 * t38));
        let t48 = t25 * ((t9 * t31 + t20 * t27) * two - t47 * two);
        let t49 = q_i[6] * t34 + (q_i[3] * t11 + q_i[4] * t21 - q_i[5] * t18);
        let t50 = q_i[6] * t37 + (q_i[3] * t26 + q_i[4] * t27 - q_i[5] * t28);
        let t51 = t0 * t49 - t25 * t50;
        let t52 = q_i[6] * t18 + (q_i[5] * t34 + (q_i[3] * t21 - q_i[4] * t11));
        let t53 = q_i[6] * t28 + (q_i[5] * t37 + (q_i[3] * t27 - q_i[4] * t26));
        let t54 = t0 * t52 - t25 * t53;
        let t55 = q_i[5] * t11 + (q_i[3] * t18 + q_i[4] * t34) - q_i[6] * t21;
        let t56 = q_i[5] * t26 + (q_i[3] * t28 + q_i[4] * t37) - q_i[6] * t27;
        let t57 = t0 * t55 - t25 * t56;
        let t58 = t11 * v_i[3] + (q_i[6] * t33 + (q_i[3] * t6 + q_i[4] * t8));
        let t59 = v_i[6] * t34 + (t21 * v_i[4] + t58) - (q_i[5] * t10 + t18 * v_i[5]);
        let t60 = v_i[3] * t26 + (q_i[6] * t38 + (q_i[3] * t29 + q_i[4] * t31));
        let t61 = v_i[6] * t37 + (v_i[4] * t27 + t60) - (q_i[5] * t30 + v_i[5] * t28);
        let t62 = t0 * t59 - t25 * t61;
        let t63 = t18 * v_i[3] + (q_i[5] * t6 + (q_i[3] * t10 + q_i[4] * t33));
        let t64 = t11 * v_i[5] + (v_i[4] * t34 + t63) - (q_i[6] * t8 + t21 * v_i[6]);
        let t65 = v_i[3] * t28 + (q_i[5] * t29 + (q_i[3] * t30 + q_i[4] * t38));
        let t66 = v_i[5] * t26 + (v_i[4] * t37 + t65) - (q_i[6] * t31 + v_i[6] * t27);
        let t67 = t0 * t64 - t25 * t66;
        let t68 = t21 * v_i[3] + (q_i[6] * t10 + (q_i[3] * t8 + q_i[5] * t33));
        let t69 = t18 * v_i[6] + (v_i[5] * t34 + t68) - (q_i[4] * t6 + t11 * v_i[4]);
        let t70 = v_i[3] * t27 + (q_i[6] * t30 + (q_i[3] * t31 + q_i[5] * t38));
        let t71 = v_i[6] * t28 + (v_i[5] * t37 + t70) - (q_i[4] * t29 + v_i[4] * t26);
        let t72 = t0 * t69 - t25 * t71;
        let t73 = t16 * t57 + (t2 * t62 + (t4 * t67 + t3 * t72));
        let t74 = t14 * t51 + (t12 * t57 + (t1 * t67 + t3 * t62));
        let t75 = t13 * t57 + (t12 * t54 + (t1 * t72 + t2 * t67));
        let t76 = t16 * t54 + (t12 * t51 + (t1 * t62 + t4 * t72));
        let t77 = q_i[4] * q_i[4];
        let t78 = q_i[3] * q_i[3];
        let t79 = q_i[5] * q_i[5];
        let t80 = q_i[6] * q_i[6];
        let t81 = t20 * (t77 + (t78 - (t79 + t80)));
        let t82 = q_i[6] * q_i[4];
        let t83 = q_i[3] * q_i[5];
        let t84 = q_i[3] * q_i[6];
        let t85 = q_i[5] * q_i[4];
        let t86 = q_i[4] * v_i[6] + q_i[6] * v_i[4];
        let t87 = q_i[3] * v_i[5] + q_i[5] * v_i[3];
        let t88 = q_i[3] * v_i[3];
        let t89 = q_i[4] * v_i[4];
        let t90 = q_i[5] * v_i[5];
        let t91 = q_i[6] * v_i[6];
        let t92 = q_i[4] * v_i[5] + q_i[5] * v_i[4];
        let t93 = q_i[3] * v_i[6] + q_i[6] * v_i[3];
        let t94 = t9 * (t88 + t89 - (t90 + t91)) + t7 * (t92 + t93);
        let t95 = t17 * (t82 - t83) + (t23 * (t84 + t85) + (t5 * (t86 - t87) + t94));
        let t96 = t95 * two;
        let t97 = t23 * (t79 + t78 - (t80 + t77));
        let t98 = q_i[3] * q_i[4];
        let t99 = q_i[5] * q_i[6];
        let t100 = q_i[5] * v_i[6] + q_i[6] * v_i[5];
        let t101 = q_i[3] * v_i[4] + q_i[4] * v_i[3];
        let t102 = t9 * (t92 - t93) + t7 * (t88 + t90 - (t89 + t91));
        let t103 = t17 * (t98 + t99) + (t20 * (t85 - t84) + (t5 * (t100 + t101) + t102));
        let t104 = t103 * two;
        let t105 = t17 * (t80 + t78 - (t79 + t77));
        let t106 = t5 * (t88 + t91 - (t89 + t90))
            + (t9 * (t87 + t86) + t7 * (t100 - t101));
        let t107 = (t23 * (t99 - t98) + (t20 * (t83 + t82) + t106)) * two;
        let t108 = q_j[4] * q_j[4];
        let t109 = q_j[3] * q_j[3];
        let t110 = q_j[5] * q_j[5];
        let t111 = q_j[6] * q_j[6];
        let t112 = v_j[6] * q_j[4] + v_j[4] * q_j[6];
        let t113 = q_j[3] * v_j[5] + v_j[3] * q_j[5];
        let t114 = v_j[5] * q_j[4] + v_j[4] * q_j[5];
        let t115 = q_j[3] * v_j[6] + v_j[3] * q_j[6];
        let t116 = q_j[3] * v_j[3];
        let t117 = q_j[4] * v_j[4];
        let t118 = v_j[5] * q_j[5];
        let t119 = v_j[6] * q_j[6];
        let t120 = q_j[3] * q_j[6];
        let t121 = q_j[4] * q_j[5];
        let t122 = q_j[4] * q_j[6];
        let t123 = q_j[3] * q_j[5];
        let t124 = t57 * (t116 + t117 - (t118 + t119))
            + (t72 * (t120 + t121) + t62 * (t122 - t123));
        let t125 = (t51 * (t112 - t113) + (t54 * (t114 + t115) + t124)) * two;
        let t126 = v_j[6] * q_j[5] + v_j[5] * q_j[6];
        let t127 = q_j[3] * v_j[4] + v_j[3] * q_j[4];
        let t128 = q_j[3] * q_j[4];
        let t129 = q_j[5] * q_j[6];
        let t130 = t57 * (t114 - t115) + (t67 * (t121 - t120) + t62 * (t128 + t129));
        let t131 = t51 * (t126 + t127) + (t54 * (t116 + t118 - (t117 + t119)) + t130);
        let t132 = t57 * (t113 + t112) + (t67 * (t123 + t122) + t72 * (t129 - t128));
        let t133 = t51 * (t116 + t119 - (t117 + t118)) + (t54 * (t126 - t127) + t132);
        let t134 = t20 * t56 + (t5 * t61 + (t9 * t66 + t7 * t71));
        let t135 = t9 * t64 + (t17 * t49 + (t20 * t55 + t23 * t52));
        let t136 = t0 * (t17 * t50 + (t23 * t53 + t134))
            + t25 * (t5 * t59 + (t7 * t69 + t135));
        rate_q[0] = t0 * (t5 * t6 + (t7 * t8 + t24)) * two
            - t25 * (t17 * t26 + (t23 * t27 + t32)) * two;
        rate_q[1] = t36 + t40;
        rate_q[2] = t42 + t44;
        rate_q[3] = t46 + t48;
        rate_q[4] = (t13 * t51 + (t14 * t54 + t73)) * two;
        rate_q[5] = t74 * two - (t2 * t72 + t13 * t54) * two;
        rate_q[6] = t75 * two - (t4 * t62 + t16 * t51) * two;
        rate_q[7] = t76 * two - (t3 * t67 + t14 * t57) * two;
        rate_h[0] = t25 * (-t81 - t96);
        rate_h[1] = t25 * (-t97 - t104);
        rate_h[2] = t25 * (-t105 - t107);
        rate_h[3] = t0 * (t81 + t96);
        rate_h[4] = t0 * (t97 + t104);
        rate_h[5] = t0 * (t105 + t107);
        rate_h[6] = t67 * (t108 + (t109 - (t110 + t111))) + t125;
        rate_h[7] = t72 * (t110 + t109 - (t111 + t108)) + t131 * two;
        rate_h[8] = t62 * (t111 + t109 - (t110 + t108)) + t133 * two;
        rate_h[9] = -t136;
    }
}
