// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Angle about an axis
///
/// `atan2((A_i w_i)ᵀ A_j u_j, (A_i u_i)ᵀ A_j u_j) − α = 0` (unit 1)
///
/// Source: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.3; right-handed angle of body j relative to body i about u_i × w_i, −π < angle ≤ π.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `u_i` | 1 | body i | unit vector normal to the axis, where the angle is zero |
/// | 3..6 | `w_i` | 1 | body i | unit vector normal to the axis and to u_i, a quarter turn on |
/// | 6..9 | `u_j` | 1 | body j | unit vector normal to the axis, whose angle is taken |
/// | 9 | `angle` | rad |  | the angle that counts as zero |
pub mod torsion {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "torsion",
        title: "Angle about an axis",
        equation: "atan2((A_i w_i)ᵀ A_j u_j, (A_i u_i)ᵀ A_j u_j) − α = 0",
        reference: "Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.3; right-handed angle of body j relative to body i about u_i × w_i, −π < angle ≤ π",
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
                name: "w_i",
                size: 3,
                offset: 3,
                unit: "1",
                frame: "body i",
                meaning: "unit vector normal to the axis and to u_i, a quarter turn on",
            },
            Parameter {
                name: "u_j",
                size: 3,
                offset: 6,
                unit: "1",
                frame: "body j",
                meaning: "unit vector normal to the axis, whose angle is taken",
            },
            Parameter {
                name: "angle",
                size: 1,
                offset: 9,
                unit: "rad",
                frame: "",
                meaning: "the angle that counts as zero",
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
        ],
        operations: [
            Operations {
                additions: 56,
                multiplications: 78,
                divisions: 0,
                functions: 1,
            },
            Operations {
                additions: 97,
                multiplications: 154,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 327,
                multiplications: 520,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 514,
                multiplications: 775,
                divisions: 1,
                functions: 0,
            },
            Operations {
                additions: 484,
                multiplications: 675,
                divisions: 1,
                functions: 0,
            },
        ],
    };
    /// Angle about an axis
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Torsion;
    impl<S: Scalar> Relation<S> for Torsion {
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
    /// 56 additions, 78 multiplications, 0 divisions, 1 functions.
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
        let t10 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t11 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t12 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t13 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t14 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t15 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t16 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t17 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t18 = q_i[6] * t14 + (q_i[3] * t15 + q_i[4] * t16 - q_i[5] * t17);
        let t19 = q_i[5] * t15 + (q_i[3] * t17 + q_i[4] * t14) - q_i[6] * t16;
        let t20 = q_i[6] * t17 + (q_i[5] * t14 + (q_i[3] * t16 - q_i[4] * t15));
        let t21 = (t4 * t9 + (t10 * t11 + t12 * t13))
            .atan2(t4 * t18 + (t10 * t19 + t12 * t20));
        phi[0] = t21 - h[9];
    }
    /// Φ, Φ_q and W.
    ///
    /// 97 additions, 154 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        phi: &mut [S; 1],
        phi_q: &mut [S; 8],
        _work: &mut [S; 0],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
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
        let t10 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t11 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t12 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t13 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t16 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t17 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t18 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t19 = q_i[6] * t15 + (q_i[3] * t16 + q_i[4] * t17 - q_i[5] * t18);
        let t20 = q_i[5] * t16 + (q_i[3] * t18 + q_i[4] * t15) - q_i[6] * t17;
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t17 - q_i[4] * t16));
        let t22 = t4 * t19 + (t10 * t20 + t12 * t21);
        let t23 = one / (t14 * t14 + t22 * t22);
        let t24 = t22 * t23;
        let t25 = t14 * t23;
        let t26 = (t6 * t4 + (t10 * t8 + t7 * t12)) * t24
            - (t4 * t16 + (t10 * t18 + t12 * t17)) * t25;
        let t27 = t24 * (t7 * t4 + (t10 * t5 - t6 * t12))
            - t25 * (t4 * t17 + (t10 * t15 - t12 * t16));
        let t28 = t24 * (t10 * t6 + t5 * t12 - t8 * t4)
            - t25 * (t10 * t16 + t12 * t15 - t4 * t18);
        let t29 = t24 * (t5 * t4 + (t8 * t12 - t10 * t7))
            - t25 * (t4 * t15 + (t12 * t18 - t10 * t17));
        let t30 = t24 * (t1 * t9 + (t3 * t11 + t2 * t13))
            - t25 * (t1 * t19 + (t3 * t20 + t2 * t21));
        let t31 = t24 * (t0 * t11 + t2 * t9 - t1 * t13)
            - t25 * (t0 * t20 + t2 * t19 - t1 * t21);
        let t32 = t24 * (t1 * t11 + (t0 * t13 - t3 * t9))
            - t25 * (t1 * t20 + (t0 * t21 - t3 * t19));
        let t33 = t24 * (t0 * t9 + t3 * t13 - t2 * t11)
            - t25 * (t0 * t19 + t3 * t21 - t2 * t20);
        phi[0] = t14.atan2(t22) - h[9];
        phi_q[0] = t26 * two;
        phi_q[1] = t27 * two;
        phi_q[2] = t28 * two;
        phi_q[3] = t29 * two;
        phi_q[4] = t30 * two;
        phi_q[5] = t31 * two;
        phi_q[6] = t32 * two;
        phi_q[7] = t33 * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 327 additions, 520 multiplications, 1 divisions, 1 functions.
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
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let k8 = S::from_f64(8.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_j[6] * h[8] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t1 = q_j[6] * h[6] + (q_j[3] * h[7] - q_j[4] * h[8]);
        let t2 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t3 = h[8] * q_j[5] + (q_j[3] * h[6] - q_j[6] * h[7]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t6 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t7 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t8 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t11 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t12 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t13 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t16 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t17 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t18 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = t4 * t19 + (t10 * t20 + t12 * t21);
        let t23 = t7 * t4 + (t10 * t8 + t6 * t12);
        let t24 = one / (t14 * t14 + t22 * t22);
        let t25 = t22 * t24;
        let t26 = t4 * t17 + (t10 * t18 + t12 * t16);
        let t27 = t14 * t24;
        let t28 = t6 * t4 + (t10 * t5 - t7 * t12);
        let t29 = t4 * t16 + (t10 * t15 - t12 * t17);
        let t30 = t5 * t12 + (t10 * t7 - t8 * t4);
        let t31 = t12 * t15 + (t10 * t17 - t4 * t18);
        let t32 = t5 * t4 + (t8 * t12 - t10 * t6);
        let t33 = t4 * t15 + (t12 * t18 - t10 * t16);
        let t34 = t2 * t9 + (t3 * t11 + t1 * t13);
        let t35 = t2 * t19 + (t3 * t20 + t1 * t21);
        let t36 = t1 * t9 + (t0 * t11 - t2 * t13);
        let t37 = t1 * t19 + (t0 * t20 - t2 * t21);
        let t38 = t2 * t11 + (t0 * t13 - t3 * t9);
        let t39 = t2 * t20 + (t0 * t21 - t3 * t19);
        let t40 = t3 * t13 + (t0 * t9 - t1 * t11);
        let t41 = t3 * t21 + (t0 * t19 - t1 * t20);
        let t42 = t25 * lambda[0];
        let t43 = t10 * t42 * two;
        let t44 = t27 * lambda[0];
        let t45 = t10 * t44 * two;
        let t46 = h[3] * t43 - h[0] * t45;
        let t47 = t4 * t42 * two;
        let t48 = t4 * t44 * two;
        let t49 = h[5] * t47 - h[2] * t48;
        let t50 = t12 * t42 * two;
        let t51 = t12 * t44 * two;
        let t52 = h[4] * t50 - h[1] * t51;
        let t53 = t24 * half;
        let t54 = t24 * t24;
        let t55 = (t14 * t23 + t22 * t26) * t54;
        let t56 = lambda[0] * (t26 * t53 - t22 * t55);
        let t57 = t4 * t56;
        let t58 = t7 * k8;
        let t59 = t12 * t56;
        let t60 = t6 * k8;
        let t61 = t10 * t56;
        let t62 = t8 * k8;
        let t63 = lambda[0] * (t23 * t53 - t14 * t55);
        let t64 = t10 * t63;
        let t65 = t18 * k8;
        let t66 = t12 * t63;
        let t67 = t16 * k8;
        let t68 = t4 * t63;
        let t69 = t17 * k8;
        let t70 = t61 * t62 - t64 * t65 - t66 * t67 - t68 * t69;
        let t71 = h[4] * t47 - h[1] * t48;
        let t72 = t5 * k8;
        let t73 = h[2] * t51;
        let t74 = t15 * k8;
        let t75 = h[5] * t50;
        let t76 = t73 - t59 * t58 - t64 * t74 - t67 * t68 - t75;
        let t77 = t54 * (t14 * t28 + t22 * t29);
        let t78 = lambda[0] * (t28 * t53 - t14 * t77);
        let t79 = t12 * t78;
        let t80 = lambda[0] * (t29 * t53 - t22 * t77);
        let t81 = t4 * t80;
        let t82 = t10 * t80;
        let t83 = t12 * t80;
        let t84 = t10 * t78;
        let t85 = t4 * t78;
        let t86 = t72 * t82 + (t46 - t58 * t83 - t74 * t84 - t67 * t85);
        let t87 = h[5] * t43 - h[2] * t45;
        let t88 = h[0] * t48;
        let t89 = h[3] * t47;
        let t90 = t88 - t62 * t57 - t66 * t74 - t64 * t69 - t89;
        let t91 = h[3] * t50 - h[0] * t51;
        let t92 = h[4] * t43;
        let t93 = h[1] * t45;
        let t94 = t92 - t62 * t81 - t74 * t79 - t69 * t84 - t93;
        let t95 = t54 * (t14 * t30 + t22 * t31);
        let t96 = lambda[0] * (t30 * t53 - t14 * t95);
        let t97 = t4 * t96;
        let t98 = lambda[0] * (t31 * t53 - t22 * t95);
        let t99 = t10 * t98;
        let t100 = t12 * t98;
        let t101 = t52 - t49;
        let t102 = t4 * t98;
        let t103 = t12 * t96;
        let t104 = t10 * t96;
        let t105 = t72 * t100 + (t101 - t62 * t102 - t74 * t103 - t69 * t104);
        let t106 = t91 - t61 * t60 - t68 * t74 - t65 * t66 - t92;
        let t107 = t87 - t60 * t82 - t74 * t85 - t65 * t79 - t88;
        let t108 = t71 - t60 * t99 - t74 * t97 - t65 * t103 - t73;
        let t109 = t54 * (t14 * t32 + t22 * t33);
        let t110 = lambda[0] * (t32 * t53 - t14 * t109);
        let t111 = lambda[0] * (t33 * t53 - t22 * t109);
        let t112 = -t101 - t46 - t60 * (t10 * t111) - t74 * (t4 * t110);
        let t113 = t62 * (t12 * t111)
            + (t72 * (t4 * t111) + (t112 - t65 * (t12 * t110)));
        let t114 = t7 * t42;
        let t115 = t17 * t44;
        let t116 = t114 - t115;
        let t117 = t9 * two;
        let t118 = t19 * two;
        let t119 = t116 + (t56 * t117 - t63 * t118);
        let t120 = t2 * k4;
        let t121 = t8 * t42;
        let t122 = t18 * t44;
        let t123 = t121 - t122;
        let t124 = t11 * two;
        let t125 = t20 * two;
        let t126 = t123 + (t56 * t124 - t63 * t125);
        let t127 = t3 * k4;
        let t128 = t6 * t42;
        let t129 = t16 * t44;
        let t130 = t128 - t129;
        let t131 = t13 * two;
        let t132 = t21 * two;
        let t133 = t130 + (t56 * t131 - t63 * t132);
        let t134 = t1 * k4;
        let t135 = t80 * t117 + (t130 - t78 * t118);
        let t136 = t5 * t42 - t15 * t44;
        let t137 = t136 + (t80 * t124 - t78 * t125);
        let t138 = t115 + (t80 * t131 - t78 * t132 - t114);
        let t139 = t122 + (t98 * t117 - t96 * t118 - t121);
        let t140 = t98 * t124 + (t116 - t96 * t125);
        let t141 = t98 * t131 + (t136 - t96 * t132);
        let t142 = t111 * t117 + (t136 - t110 * t118);
        let t143 = t129 + (t111 * t124 - t110 * t125 - t128);
        let t144 = t111 * t131 + (t123 - t110 * t132);
        let t145 = (t11 * t42 - t20 * t44) * two;
        let t146 = h[6] * t145;
        let t147 = (t13 * t42 - t21 * t44) * two;
        let t148 = h[7] * t147;
        let t149 = (t9 * t42 - t19 * t44) * two;
        let t150 = h[8] * t149;
        let t151 = t54 * (t14 * t34 + t22 * t35);
        let t152 = lambda[0] * (t35 * t53 - t22 * t151);
        let t153 = lambda[0] * (t34 * t53 - t14 * t151);
        let t154 = t9 * t152 - t19 * t153;
        let t155 = t2 * k8;
        let t156 = t11 * t152 - t20 * t153;
        let t157 = t3 * k8;
        let t158 = t13 * t152 - t21 * t153;
        let t159 = t1 * k8;
        let t160 = t148 + (t150 + (t154 * t155 + (t156 * t157 + t158 * t159)));
        let t161 = t0 * k4;
        let t162 = h[7] * t149;
        let t163 = t0 * k8;
        let t164 = h[8] * t147;
        let t165 = t54 * (t14 * t36 + t22 * t37);
        let t166 = lambda[0] * (t37 * t53 - t22 * t165);
        let t167 = lambda[0] * (t36 * t53 - t14 * t165);
        let t168 = t9 * t166 - t19 * t167;
        let t169 = t11 * t166 - t20 * t167;
        let t170 = t13 * t166 - t21 * t167;
        let t171 = t159 * t168 + (t163 * t169 + (t146 - t155 * t170)) - t150;
        let t172 = h[8] * t145;
        let t173 = h[6] * t149;
        let t174 = h[6] * t147;
        let t175 = h[7] * t145;
        let t176 = t54 * (t14 * t38 + t22 * t39);
        let t177 = lambda[0] * (t39 * t53 - t22 * t176);
        let t178 = lambda[0] * (t38 * t53 - t14 * t176);
        let t179 = t11 * t177 - t20 * t178;
        let t180 = t13 * t177 - t21 * t178;
        let t181 = t148 - t150;
        let t182 = t9 * t177 - t19 * t178;
        let t183 = t54 * (t14 * t40 + t22 * t41);
        let t184 = lambda[0] * (t41 * t53 - t22 * t183);
        let t185 = lambda[0] * (t40 * t53 - t14 * t183);
        let t186 = -t181 - t146 - t159 * (t11 * t184 - t20 * t185);
        phi[0] = t14.atan2(t22) - h[9];
        phi_q[0] = (t23 * t25 - t26 * t27) * two;
        phi_q[1] = (t25 * t28 - t27 * t29) * two;
        phi_q[2] = (t25 * t30 - t27 * t31) * two;
        phi_q[3] = (t25 * t32 - t27 * t33) * two;
        phi_q[4] = (t25 * t34 - t27 * t35) * two;
        phi_q[5] = (t25 * t36 - t27 * t37) * two;
        phi_q[6] = (t25 * t38 - t27 * t39) * two;
        phi_q[7] = (t25 * t40 - t27 * t41) * two;
        curvature[0] = t46 + (t49 + (t52 + (t57 * t58 + (t59 * t60 + t70))));
        curvature[1] = t71 + (t66 * t69 + (t60 * t57 + (t61 * t72 + t76)));
        curvature[2] = t69 * t79 + (t60 * t81 + t86) - t52 - t49;
        curvature[3] = t87 + (t65 * t68 + (t61 * t58 + (t59 * t72 + t90)));
        curvature[4] = t91 + (t65 * t85 + (t58 * t82 + (t72 * t83 + t94)));
        curvature[5] = t65 * t97 + (t58 * t99 + t105) - t46;
        curvature[6] = t64 * t67 + (t62 * t59 + (t57 * t72 + (t93 + t106)));
        curvature[7] = t67 * t84 + (t62 * t83 + (t72 * t81 + (t89 + t107)));
        curvature[8] = t67 * t104 + (t62 * t100 + (t72 * t102 + (t75 + t108)));
        curvature[9] = t67 * (t10 * t110) + t113;
        curvature[10] = t119 * t120 + (t126 * t127 + t133 * t134);
        curvature[11] = t120 * t135 + (t127 * t137 + t134 * t138);
        curvature[12] = t120 * t139 + (t127 * t140 + t134 * t141);
        curvature[13] = t120 * t142 + (t127 * t143 + t134 * t144);
        curvature[14] = t146 + t160;
        curvature[15] = t134 * t119 + (t126 * t161 - t133 * t120);
        curvature[16] = t134 * t135 + (t137 * t161 - t120 * t138);
        curvature[17] = t134 * t139 + (t140 * t161 - t120 * t141);
        curvature[18] = t134 * t142 + (t143 * t161 - t120 * t144);
        curvature[19] = t162 + (t159 * t154 + (t156 * t163 - t158 * t155 - t164));
        curvature[20] = t171 - t148;
        curvature[21] = t126 * t120 + (t133 * t161 - t127 * t119);
        curvature[22] = t120 * t137 + (t138 * t161 - t127 * t135);
        curvature[23] = t120 * t140 + (t141 * t161 - t127 * t139);
        curvature[24] = t120 * t143 + (t144 * t161 - t127 * t142);
        curvature[25] = t172 + (t156 * t155 + (t158 * t163 - t157 * t154 - t173));
        curvature[26] = t174 + (t155 * t169 + (t163 * t170 + (t175 - t157 * t168)));
        curvature[27] = t155 * t179 + (t163 * t180 + (t181 - t157 * t182)) - t146;
        curvature[28] = t127 * t133 + (t119 * t161 - t126 * t134);
        curvature[29] = t127 * t138 + (t135 * t161 - t134 * t137);
        curvature[30] = t127 * t141 + (t139 * t161 - t134 * t140);
        curvature[31] = t127 * t144 + (t142 * t161 - t134 * t143);
        curvature[32] = t157 * t158 + (t154 * t163 + (t174 - t156 * t159 - t175));
        curvature[33] = t157 * t170 + (t163 * t168 + (t173 + (t172 - t159 * t169)));
        curvature[34] = t157 * t180 + (t163 * t182 + (t164 + (t162 - t159 * t179)));
        curvature[35] = t157 * (t13 * t184 - t21 * t185)
            + (t163 * (t9 * t184 - t19 * t185) + t186);
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 514 additions, 775 multiplications, 1 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        lambda: &[S; 1],
        phi_h: &mut [S; 10],
        force_h: &mut [S; 72],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let minus_one = S::from_f64(-1.0);
        let k4 = S::from_f64(4.0);
        let k8 = S::from_f64(8.0);
        let k1_over_4 = S::from_f64(0.25);
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
        let t10 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t11 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t12 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t13 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t16 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t17 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t18 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = t4 * t19 + (t10 * t20 + t12 * t21);
        let t23 = one / (t14 * t14 + t22 * t22);
        let t24 = t14 * t23;
        let t25 = q_i[3] * q_i[3];
        let t26 = q_i[4] * q_i[4];
        let t27 = q_i[6] * q_i[6];
        let t28 = q_i[5] * q_i[5];
        let t29 = t25 + t26 - t27 - t28;
        let t30 = q_i[3] * q_i[6];
        let t31 = q_i[4] * q_i[5];
        let t32 = t30 + t31;
        let t33 = q_i[4] * q_i[6];
        let t34 = q_i[3] * q_i[5];
        let t35 = t33 - t34;
        let t36 = t10 * t29 + (t12 * t32 * two + t4 * t35 * two);
        let t37 = q_i[4] * q_i[3];
        let t38 = q_i[6] * q_i[5];
        let t39 = t37 + t38;
        let t40 = t25 - t26;
        let t41 = t28 - t27;
        let t42 = t40 + t41;
        let t43 = t31 - t30;
        let t44 = t4 * t39 + (t12 * t42 * half + t10 * t43);
        let t45 = t38 - t37;
        let t46 = t40 - t41;
        let t47 = t34 + t33;
        let t48 = t12 * t45 + (t4 * t46 * half + t10 * t47);
        let t49 = t22 * t23;
        let t50 = q_j[3] * q_j[3];
        let t51 = q_j[4] * q_j[4];
        let t52 = q_j[6] * q_j[6];
        let t53 = q_j[5] * q_j[5];
        let t54 = t50 + t51 - t52 - t53;
        let t55 = q_j[3] * q_j[6];
        let t56 = q_j[4] * q_j[5];
        let t57 = t55 + t56;
        let t58 = t57 * two;
        let t59 = q_j[4] * q_j[6];
        let t60 = q_j[3] * q_j[5];
        let t61 = t59 - t60;
        let t62 = t61 * two;
        let t63 = t11 * t54 + (t13 * t58 + t9 * t62);
        let t64 = t20 * t54 + (t21 * t58 + t19 * t62);
        let t65 = q_j[4] * q_j[3];
        let t66 = q_j[6] * q_j[5];
        let t67 = t65 + t66;
        let t68 = t50 - t51;
        let t69 = t53 - t52;
        let t70 = t68 + t69;
        let t71 = t70 * half;
        let t72 = t56 - t55;
        let t73 = t9 * t67 + (t13 * t71 + t11 * t72);
        let t74 = t19 * t67 + (t21 * t71 + t20 * t72);
        let t75 = t66 - t65;
        let t76 = t68 - t69;
        let t77 = t76 * half;
        let t78 = t60 + t59;
        let t79 = t13 * t75 + (t9 * t77 + t11 * t78);
        let t80 = t21 * t75 + (t19 * t77 + t20 * t78);
        let t81 = t24 * lambda[0];
        let t82 = t4 * t81;
        let t83 = q_i[5] * two;
        let t84 = t82 * t83;
        let t85 = t12 * t81;
        let t86 = q_i[6] * two;
        let t87 = t85 * t86;
        let t88 = t10 * t81;
        let t89 = q_i[3] * two;
        let t90 = t88 * t89;
        let t91 = t84 - t87 - t90;
        let t92 = t23 * t23;
        let t93 = t22 * t36 * t92;
        let t94 = lambda[0] * (t14 * t93);
        let t95 = t4 * t94;
        let t96 = t95 * k4;
        let t97 = t12 * t94;
        let t98 = t97 * k4;
        let t99 = t10 * t94;
        let t100 = t99 * k4;
        let t101 = t23 * half;
        let t102 = t36 * t101;
        let t103 = lambda[0] * (t102 - t22 * t93);
        let t104 = t4 * t103;
        let t105 = t7 * k4;
        let t106 = t10 * t103;
        let t107 = t8 * k4;
        let t108 = t12 * t103;
        let t109 = t6 * k4;
        let t110 = t18 * t100 + (t104 * t105 + (t106 * t107 + t108 * t109));
        let t111 = t88 * t86;
        let t112 = q_i[4] * two;
        let t113 = t82 * t112;
        let t114 = t89 * t85;
        let t115 = t111 + (-t113 - t114);
        let t116 = t92 * (t22 * t44);
        let t117 = lambda[0] * (t14 * t116);
        let t118 = t4 * t117;
        let t119 = t17 * k8;
        let t120 = t12 * t117;
        let t121 = t16 * k8;
        let t122 = t10 * t117;
        let t123 = t18 * k8;
        let t124 = t44 * t101;
        let t125 = lambda[0] * (t124 - t22 * t116);
        let t126 = t4 * t125;
        let t127 = t7 * k8;
        let t128 = t10 * t125;
        let t129 = t8 * k8;
        let t130 = t12 * t125;
        let t131 = t6 * k8;
        let t132 = t122 * t123 + (t126 * t127 + (t128 * t129 + t130 * t131));
        let t133 = t85 * t112;
        let t134 = t88 * t83;
        let t135 = t89 * t82;
        let t136 = t133 + (-t134 - t135);
        let t137 = t92 * (t22 * t48);
        let t138 = lambda[0] * (t14 * t137);
        let t139 = t4 * t138;
        let t140 = t12 * t138;
        let t141 = t10 * t138;
        let t142 = t48 * t101;
        let t143 = lambda[0] * (t142 - t22 * t137);
        let t144 = t4 * t143;
        let t145 = t10 * t143;
        let t146 = t12 * t143;
        let t147 = t123 * t141 + (t127 * t144 + (t129 * t145 + t131 * t146));
        let t148 = t49 * lambda[0];
        let t149 = t12 * t148;
        let t150 = t86 * t149;
        let t151 = t10 * t148;
        let t152 = t89 * t151;
        let t153 = t4 * t148;
        let t154 = t83 * t153;
        let t155 = t150 + (t152 - t154);
        let t156 = lambda[0] * (t102 - t14 * (t92 * (t14 * t36)));
        let t157 = t10 * t156;
        let t158 = t18 * k4;
        let t159 = t155 - t8 * t100 - t6 * t98 - t7 * t96 - t157 * t158;
        let t160 = t12 * t156;
        let t161 = t16 * k4;
        let t162 = t4 * t156;
        let t163 = t17 * k4;
        let t164 = t112 * t153;
        let t165 = t89 * t149;
        let t166 = t86 * t151;
        let t167 = t164 + (t165 - t166);
        let t168 = lambda[0] * (t124 - t14 * (t92 * (t14 * t44)));
        let t169 = t10 * t168;
        let t170 = t167 - t129 * t122 - t131 * t120 - t127 * t118 - t123 * t169;
        let t171 = t12 * t168;
        let t172 = t4 * t168;
        let t173 = t83 * t151;
        let t174 = t89 * t153;
        let t175 = t112 * t149;
        let t176 = t173 + (t174 - t175);
        let t177 = lambda[0] * (t142 - t14 * (t92 * (t14 * t48)));
        let t178 = t10 * t177;
        let t179 = t176 - t129 * t141 - t131 * t140 - t127 * t139 - t123 * t178;
        let t180 = t12 * t177;
        let t181 = t4 * t177;
        let t182 = t92 * (t14 * t63 + t22 * t64);
        let t183 = lambda[0] * (t64 * t101 - t22 * t182);
        let t184 = t4 * t183 + t61 * t148;
        let t185 = t12 * t183 + t57 * t148;
        let t186 = t148 * half;
        let t187 = t54 * t186 + t10 * t183;
        let t188 = t81 * half;
        let t189 = lambda[0] * (t63 * t101 - t14 * t182);
        let t190 = t54 * t188 + t10 * t189;
        let t191 = t12 * t189 + t57 * t81;
        let t192 = t4 * t189 + t61 * t81;
        let t193 = t107 * t187 - t158 * t190 - t161 * t191 - t163 * t192;
        let t194 = t92 * (t14 * t73 + t22 * t74);
        let t195 = lambda[0] * (t74 * t101 - t22 * t194);
        let t196 = t67 * t186 + t4 * t195;
        let t197 = t70 * k1_over_4;
        let t198 = t148 * t197 + t12 * t195;
        let t199 = t72 * t186 + t10 * t195;
        let t200 = lambda[0] * (t73 * t101 - t14 * t194);
        let t201 = t72 * t188 + t10 * t200;
        let t202 = t81 * t197 + t12 * t200;
        let t203 = t67 * t188 + t4 * t200;
        let t204 = t129 * t199 - t123 * t201 - t121 * t202 - t119 * t203;
        let t205 = t76 * k1_over_4;
        let t206 = t92 * (t14 * t79 + t22 * t80);
        let t207 = lambda[0] * (t80 * t101 - t22 * t206);
        let t208 = t148 * t205 + t4 * t207;
        let t209 = t75 * t186 + t12 * t207;
        let t210 = t78 * t186 + t10 * t207;
        let t211 = lambda[0] * (t79 * t101 - t14 * t206);
        let t212 = t78 * t188 + t10 * t211;
        let t213 = t75 * t188 + t12 * t211;
        let t214 = t81 * t205 + t4 * t211;
        let t215 = t129 * t210 - t123 * t212 - t121 * t213 - t119 * t214;
        let t216 = -(t83 * t85) - t88 * t112 - t82 * t86;
        let t217 = t5 * k4;
        let t218 = t109 * t104 + (t106 * t217 - t108 * t105 - t97 * t163);
        let t219 = t15 * k8;
        let t220 = t5 * k8;
        let t221 = t131 * t126 + (t128 * t220 + (t136 - t130 * t127 - t120 * t119));
        let t222 = t145 * t220 + (t113 + (t114 - t127 * t146 - t119 * t140 - t111));
        let t223 = t86 * t153 + (t83 * t149 + t112 * t151);
        let t224 = t15 * k4;
        let t225 = t105 * t97 - t5 * t100 - t6 * t96 - t157 * t224;
        let t226 = t176 - t122 * t220 - t131 * t118 - t169 * t219 - t121 * t172;
        let t227 = t166 - t141 * t220 - t131 * t139 - t178 * t219 - t121 * t181;
        let t228 = t187 * t217 - t105 * t185 - t190 * t224 - t161 * t192;
        let t229 = t199 * t220 - t127 * t198 - t201 * t219 - t121 * t203;
        let t230 = t210 * t220 - t127 * t209 - t212 * t219 - t121 * t214;
        let t231 = t108 * t217 + (t134 + (t135 - t107 * t104 - t95 * t158 - t133));
        let t232 = t128 * t127 + (t130 * t220 + (t216 - t129 * t126 - t123 * t118));
        let t233 = t127 * t145 + (t146 * t220 + (t91 - t129 * t144 - t123 * t139));
        let t234 = t175 - t5 * t98 - t7 * t100 - t160 * t224 - t157 * t163;
        let t235 = t223 - t120 * t220 - t127 * t122 - t171 * t219 - t119 * t169;
        let t236 = t155 - t140 * t220 - t127 * t141 - t180 * t219 - t119 * t178;
        let t237 = t185 * t217 - t107 * t184 - t191 * t224 - t163 * t190;
        let t238 = t198 * t220 - t129 * t196 - t202 * t219 - t119 * t201;
        let t239 = t209 * t220 - t129 * t208 - t213 * t219 - t119 * t212;
        let t240 = t107 * t108 + (t104 * t217 + (t115 - t106 * t109 - t99 * t161));
        let t241 = t126 * t220 + (t87 + (t90 - t128 * t131 - t122 * t121 - t84));
        let t242 = t129 * t146 + (t144 * t220 + (t216 - t131 * t145 - t121 * t141));
        let t243 = t167 - t5 * t96 - t8 * t98 - t162 * t224 - t158 * t160;
        let t244 = t154 - t118 * t220 - t129 * t120 - t172 * t219 - t123 * t171;
        let t245 = t223 - t139 * t220 - t129 * t140 - t181 * t219 - t123 * t180;
        let t246 = t184 * t217 - t109 * t187 - t192 * t224 - t158 * t191;
        let t247 = t196 * t220 - t131 * t199 - t203 * t219 - t123 * t202;
        let t248 = t208 * t220 - t131 * t210 - t214 * t219 - t123 * t213;
        let t249 = t19 * t94 + (t9 * t103 - t35 * t81);
        let t250 = t2 * k4;
        let t251 = t20 * t94 + (t11 * t103 - t29 * t188);
        let t252 = t3 * k4;
        let t253 = t21 * t94 + (t13 * t103 - t32 * t81);
        let t254 = t1 * k4;
        let t255 = t19 * t117 + (t9 * t125 - t39 * t188);
        let t256 = t2 * k8;
        let t257 = t20 * t117 + (t11 * t125 - t43 * t188);
        let t258 = t3 * k8;
        let t259 = t42 * k1_over_4;
        let t260 = t21 * t117 + (t13 * t125 - t81 * t259);
        let t261 = t1 * k8;
        let t262 = t46 * k1_over_4;
        let t263 = t19 * t138 + (t9 * t143 - t81 * t262);
        let t264 = t20 * t138 + (t11 * t143 - t47 * t188);
        let t265 = t21 * t138 + (t13 * t143 - t45 * t188);
        let t266 = t20 * t156 + (t11 * t94 - t29 * t186);
        let t267 = t21 * t156 + (t13 * t94 - t32 * t148);
        let t268 = t19 * t156 + (t9 * t94 - t35 * t148);
        let t269 = t20 * t168 + (t11 * t117 - t43 * t186);
        let t270 = t21 * t168 + (t13 * t117 - t148 * t259);
        let t271 = t19 * t168 + (t9 * t117 - t39 * t186);
        let t272 = t20 * t177 + (t11 * t138 - t47 * t186);
        let t273 = t21 * t177 + (t13 * t138 - t45 * t186);
        let t274 = t19 * t177 + (t9 * t138 - t148 * t262);
        let t275 = (t13 * t148 - t21 * t81) * two;
        let t276 = q_j[6] * t275;
        let t277 = (t11 * t148 - t20 * t81) * two;
        let t278 = q_j[3] * t277;
        let t279 = (t9 * t148 - t19 * t81) * two;
        let t280 = q_j[5] * t279;
        let t281 = t276 + (t278 - t280);
        let t282 = t9 * t183 - t19 * t189;
        let t283 = t11 * t183 - t20 * t189;
        let t284 = t13 * t183 - t21 * t189;
        let t285 = q_j[4] * t279;
        let t286 = q_j[3] * t275;
        let t287 = q_j[6] * t277;
        let t288 = t285 + (t286 - t287);
        let t289 = t9 * t195 - t19 * t200;
        let t290 = t11 * t195 - t20 * t200;
        let t291 = t13 * t195 - t21 * t200;
        let t292 = q_j[5] * t277;
        let t293 = q_j[3] * t279;
        let t294 = q_j[4] * t275;
        let t295 = t292 + (t293 - t294);
        let t296 = t9 * t207 - t19 * t211;
        let t297 = t11 * t207 - t20 * t211;
        let t298 = t13 * t207 - t21 * t211;
        let t299 = t0 * k4;
        let t300 = t0 * k8;
        let t301 = q_j[6] * t279 + (q_j[5] * t275 + q_j[4] * t277);
        phi_h[0] = -(t24 * t36);
        phi_h[1] = -(t24 * t44 * two);
        phi_h[2] = -(t24 * t48 * two);
        phi_h[3] = t36 * t49;
        phi_h[4] = t44 * t49 * two;
        phi_h[5] = t48 * t49 * two;
        phi_h[6] = t49 * t63 - t24 * t64;
        phi_h[7] = (t49 * t73 - t24 * t74) * two;
        phi_h[8] = (t49 * t79 - t24 * t80) * two;
        phi_h[9] = minus_one;
        force_h[0] = t91 + (t17 * t96 + (t16 * t98 + t110));
        force_h[1] = t115 + (t118 * t119 + (t120 * t121 + t132));
        force_h[2] = t136 + (t119 * t139 + (t121 * t140 + t147));
        force_h[3] = t159 - t160 * t161 - t162 * t163;
        force_h[4] = t170 - t121 * t171 - t119 * t172;
        force_h[5] = t179 - t121 * t180 - t119 * t181;
        force_h[6] = t105 * t184 + (t109 * t185 + t193);
        force_h[7] = t127 * t196 + (t131 * t198 + t204);
        force_h[8] = t127 * t208 + (t131 * t209 + t215);
        force_h[9] = t216 + (t16 * t96 + (t15 * t100 + t218));
        force_h[10] = t121 * t118 + (t122 * t219 + t221);
        force_h[11] = t121 * t139 + (t141 * t219 + (t131 * t144 + t222));
        force_h[12] = t223 + (t160 * t163 + (t225 - t161 * t162));
        force_h[13] = t119 * t171 + (t127 * t120 + t226);
        force_h[14] = t119 * t180 + (t127 * t140 + (t227 - t165 - t164));
        force_h[15] = t163 * t191 + (t109 * t184 + t228);
        force_h[16] = t119 * t202 + (t131 * t196 + t229);
        force_h[17] = t119 * t213 + (t131 * t208 + t230);
        force_h[18] = t17 * t100 + (t15 * t98 + (t106 * t105 + t231));
        force_h[19] = t122 * t119 + (t120 * t219 + t232);
        force_h[20] = t119 * t141 + (t140 * t219 + t233);
        force_h[21] = t158 * t162 + (t107 * t95 + (t234 - t174 - t173));
        force_h[22] = t123 * t172 + (t129 * t118 + t235);
        force_h[23] = t123 * t181 + (t129 * t139 + t236);
        force_h[24] = t158 * t192 + (t105 * t187 + t237);
        force_h[25] = t123 * t203 + (t127 * t199 + t238);
        force_h[26] = t123 * t214 + (t127 * t210 + t239);
        force_h[27] = t18 * t98 + (t15 * t96 + t240);
        force_h[28] = t123 * t120 + (t118 * t219 + (t129 * t130 + t241));
        force_h[29] = t123 * t140 + (t139 * t219 + t242);
        force_h[30] = t157 * t161 + (t109 * t99 + t243);
        force_h[31] = t121 * t169 + (t131 * t122 + (t244 - t152 - t150));
        force_h[32] = t121 * t178 + (t131 * t141 + t245);
        force_h[33] = t161 * t190 + (t107 * t185 + t246);
        force_h[34] = t121 * t201 + (t129 * t198 + t247);
        force_h[35] = t121 * t212 + (t129 * t209 + t248);
        force_h[36] = t249 * t250 + (t251 * t252 + t253 * t254);
        force_h[37] = t255 * t256 + (t257 * t258 + t260 * t261);
        force_h[38] = t256 * t263 + (t258 * t264 + t261 * t265);
        force_h[39] = -(t252 * t266) - t254 * t267 - t250 * t268;
        force_h[40] = -(t258 * t269) - t261 * t270 - t256 * t271;
        force_h[41] = -(t258 * t272) - t261 * t273 - t256 * t274;
        force_h[42] = t281 + (t250 * t282 + (t252 * t283 + t254 * t284));
        force_h[43] = t288 + (t256 * t289 + (t258 * t290 + t261 * t291));
        force_h[44] = t295 + (t256 * t296 + (t258 * t297 + t261 * t298));
        force_h[45] = t254 * t249 + (t251 * t299 - t253 * t250);
        force_h[46] = t261 * t255 + (t257 * t300 - t260 * t256);
        force_h[47] = t261 * t263 + (t264 * t300 - t256 * t265);
        force_h[48] = t250 * t267 - t266 * t299 - t254 * t268;
        force_h[49] = t256 * t270 - t269 * t300 - t261 * t271;
        force_h[50] = t256 * t273 - t272 * t300 - t261 * t274;
        force_h[51] = t301 + (t254 * t282 + (t283 * t299 - t250 * t284));
        force_h[52] = t261 * t289 + (t290 * t300 + (t295 - t256 * t291));
        force_h[53] = t261 * t296 + (t297 * t300 + (t287 - t256 * t298 - t286 - t285));
        force_h[54] = t251 * t250 + (t253 * t299 - t252 * t249);
        force_h[55] = t257 * t256 + (t260 * t300 - t258 * t255);
        force_h[56] = t256 * t264 + (t265 * t300 - t258 * t263);
        force_h[57] = t252 * t268 - t267 * t299 - t250 * t266;
        force_h[58] = t258 * t271 - t270 * t300 - t256 * t269;
        force_h[59] = t258 * t274 - t273 * t300 - t256 * t272;
        force_h[60] = t250 * t283 + (t284 * t299 + (t294 - t252 * t282 - t293 - t292));
        force_h[61] = t256 * t290 + (t291 * t300 + (t301 - t258 * t289));
        force_h[62] = t256 * t297 + (t298 * t300 + (t281 - t258 * t296));
        force_h[63] = t252 * t253 + (t249 * t299 - t251 * t254);
        force_h[64] = t258 * t260 + (t255 * t300 - t257 * t261);
        force_h[65] = t258 * t265 + (t263 * t300 - t261 * t264);
        force_h[66] = t254 * t266 - t268 * t299 - t252 * t267;
        force_h[67] = t261 * t269 - t271 * t300 - t258 * t270;
        force_h[68] = t261 * t272 - t274 * t300 - t258 * t273;
        force_h[69] = t252 * t284 + (t282 * t299 + (t288 - t254 * t283));
        force_h[70] = t258 * t291 + (t289 * t300 + (t280 - t261 * t290 - t278 - t276));
        force_h[71] = t258 * t298 + (t296 * t300 + (t301 - t261 * t297));
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 484 additions, 675 multiplications, 1 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 10],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 8],
        rate_h: &mut [S; 9],
    ) {
        let one = S::from_f64(1.0);
        let half = S::from_f64(0.5);
        let two = S::from_f64(2.0);
        let t0 = q_j[6] * h[8] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t1 = q_j[6] * h[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t2 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t3 = h[8] * q_j[5] + (q_j[3] * h[6] - q_j[6] * h[7]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t6 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t7 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t8 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t11 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t12 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t13 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t16 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t17 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t18 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = t4 * t19 + (t10 * t20 + t12 * t21);
        let t23 = one / (t22 * t22 + t14 * t14);
        let t24 = t14 * t23;
        let t25 = h[8] * v_j[6] + (h[6] * v_j[4] + h[7] * v_j[5]);
        let t26 = h[7] * v_j[3] + (h[6] * v_j[6] - h[8] * v_j[4]);
        let t27 = h[8] * v_j[3] + (h[7] * v_j[4] - h[6] * v_j[5]);
        let t28 = h[8] * v_j[5] + (h[6] * v_j[3] - h[7] * v_j[6]);
        let t29 = q_j[4] * t26 + (q_j[3] * t27 - q_j[5] * t28 - t3 * v_j[5]);
        let t30 = t0 * v_j[6] + (t1 * v_j[4] + (t2 * v_j[3] + (q_j[6] * t25 + t29)));
        let t31 = q_j[5] * t25 + (q_j[3] * t26 - q_j[4] * t27 - t2 * v_j[4]);
        let t32 = t3 * v_j[6] + (t0 * v_j[5] + (t1 * v_j[3] + (q_j[6] * t28 + t31)));
        let t33 = q_j[4] * t25 + (q_j[3] * t28 - q_j[6] * t26 - t1 * v_j[6]);
        let t34 = t2 * v_j[5] + (t0 * v_j[4] + (t3 * v_j[3] + (q_j[5] * t27 + t33)));
        let t35 = h[5] * v_i[3] + (h[4] * v_i[4] - h[3] * v_i[5]);
        let t36 = h[5] * v_i[5] + (h[3] * v_i[3] - h[4] * v_i[6]);
        let t37 = h[4] * v_i[3] + (h[3] * v_i[6] - h[5] * v_i[4]);
        let t38 = t18 * t34 + (t4 * t35 + (t10 * t36 + t12 * t37));
        let t39 = t4 * t7 + (t10 * t8 + t12 * t6);
        let t40 = t23 * half;
        let t41 = t17 * t4 + (t10 * t18 + t16 * t12);
        let t42 = t23 * t23;
        let t43 = (t22 * t41 + t14 * t39) * t42;
        let t44 = h[5] * v_i[6] + (h[3] * v_i[4] + h[4] * v_i[5]);
        let t45 = q_i[4] * t37 + (q_i[3] * t35 - q_i[5] * t36 - t18 * v_i[5]);
        let t46 = t15 * v_i[6] + (t16 * v_i[4] + (t17 * v_i[3] + (q_i[6] * t44 + t45)));
        let t47 = q_i[4] * t44 + (q_i[3] * t36 - q_i[6] * t37 - t16 * v_i[6]);
        let t48 = t17 * v_i[5] + (t15 * v_i[4] + (t18 * v_i[3] + (q_i[5] * t35 + t47)));
        let t49 = q_i[5] * t44 + (q_i[3] * t37 - q_i[4] * t35 - t17 * v_i[4]);
        let t50 = t18 * v_i[6] + (t15 * v_i[5] + (t16 * v_i[3] + (q_i[6] * t36 + t49)));
        let t51 = t20 * t34 + (t4 * t46 + (t10 * t48 + t12 * t50));
        let t52 = t19 * t30 + (t21 * t32 + t51);
        let t53 = t52 * two;
        let t54 = h[2] * v_i[6] + (h[0] * v_i[4] + h[1] * v_i[5]);
        let t55 = h[1] * v_i[3] + (h[0] * v_i[6] - h[2] * v_i[4]);
        let t56 = h[2] * v_i[3] + (h[1] * v_i[4] - h[0] * v_i[5]);
        let t57 = h[2] * v_i[5] + (h[0] * v_i[3] - h[1] * v_i[6]);
        let t58 = q_i[4] * t55 + (q_i[3] * t56 - q_i[5] * t57 - t8 * v_i[5]);
        let t59 = t5 * v_i[6] + (t6 * v_i[4] + (t7 * v_i[3] + (q_i[6] * t54 + t58)));
        let t60 = q_i[4] * t54 + (q_i[3] * t57 - q_i[6] * t55 - t6 * v_i[6]);
        let t61 = t7 * v_i[5] + (t5 * v_i[4] + (t8 * v_i[3] + (q_i[5] * t56 + t60)));
        let t62 = q_i[5] * t54 + (q_i[3] * t55 - q_i[4] * t56 - t7 * v_i[4]);
        let t63 = t8 * v_i[6] + (t5 * v_i[5] + (t6 * v_i[3] + (q_i[6] * t57 + t62)));
        let t64 = t11 * t34 + (t4 * t59 + (t10 * t61 + t12 * t63));
        let t65 = t9 * t30 + (t13 * t32 + t64);
        let t66 = t65 * two;
        let t67 = (t39 * t40 - t14 * t43) * t53 - (t41 * t40 - t22 * t43) * t66;
        let t68 = t8 * t34 + (t4 * t56 + (t10 * t57 + t12 * t55));
        let t69 = t22 * t23;
        let t70 = t24 * (t17 * t30 + (t16 * t32 + t38))
            + (t67 - (t7 * t30 + (t6 * t32 + t68)) * t69);
        let t71 = t4 * t37 + (t10 * t44 - t12 * t35 - t17 * t32);
        let t72 = t4 * t6 + (t10 * t5 - t12 * t7);
        let t73 = t16 * t4 + (t10 * t15 - t17 * t12);
        let t74 = t42 * (t22 * t73 + t14 * t72);
        let t75 = t53 * (t40 * t72 - t14 * t74) - t66 * (t40 * t73 - t22 * t74);
        let t76 = t4 * t55 + (t10 * t54 - t12 * t56 - t7 * t32);
        let t77 = t24 * (t16 * t30 + (t15 * t34 + t71))
            + (t75 - t69 * (t6 * t30 + (t5 * t34 + t76)));
        let t78 = t12 * t44 + (t10 * t35 - t4 * t36 - t18 * t30);
        let t79 = t12 * t5 + (t10 * t7 - t4 * t8);
        let t80 = t15 * t12 + (t10 * t17 - t18 * t4);
        let t81 = t42 * (t22 * t80 + t14 * t79);
        let t82 = t53 * (t40 * t79 - t14 * t81) - t66 * (t40 * t80 - t22 * t81);
        let t83 = t12 * t54 + (t10 * t56 - t4 * t57 - t8 * t30);
        let t84 = t24 * (t17 * t34 + (t15 * t32 + t78))
            + (t82 - t69 * (t7 * t34 + (t5 * t32 + t83)));
        let t85 = t4 * t44 + (t12 * t36 - t10 * t37 - t16 * t34);
        let t86 = t4 * t5 + (t12 * t8 - t10 * t6);
        let t87 = t15 * t4 + (t18 * t12 - t10 * t16);
        let t88 = t42 * (t22 * t87 + t14 * t86);
        let t89 = t53 * (t40 * t86 - t14 * t88) - t66 * (t40 * t87 - t22 * t88);
        let t90 = t4 * t54 + (t12 * t57 - t10 * t55 - t6 * t34);
        let t91 = t24 * (t18 * t32 + (t15 * t30 + t85))
            + (t89 - t69 * (t8 * t32 + (t5 * t30 + t90)));
        let t92 = t20 * t28 + (t2 * t46 + (t3 * t48 + t1 * t50));
        let t93 = t2 * t9 + (t3 * t11 + t1 * t13);
        let t94 = t2 * t19 + (t3 * t20 + t1 * t21);
        let t95 = t42 * (t22 * t94 + t14 * t93);
        let t96 = t53 * (t40 * t93 - t14 * t95) - t66 * (t40 * t94 - t22 * t95);
        let t97 = t11 * t28 + (t2 * t59 + (t3 * t61 + t1 * t63));
        let t98 = t24 * (t19 * t27 + (t21 * t26 + t92))
            + (t96 - t69 * (t9 * t27 + (t13 * t26 + t97)));
        let t99 = t1 * t46 + (t0 * t48 - t2 * t50 - t21 * t27);
        let t100 = t1 * t9 + (t0 * t11 - t2 * t13);
        let t101 = t1 * t19 + (t0 * t20 - t2 * t21);
        let t102 = t42 * (t22 * t101 + t14 * t100);
        let t103 = t53 * (t40 * t100 - t14 * t102) - t66 * (t40 * t101 - t22 * t102);
        let t104 = t1 * t59 + (t0 * t61 - t2 * t63 - t13 * t27);
        let t105 = t24 * (t19 * t26 + (t20 * t25 + t99))
            + (t103 - t69 * (t9 * t26 + (t11 * t25 + t104)));
        let t106 = t2 * t48 + (t0 * t50 - t3 * t46 - t19 * t28);
        let t107 = t2 * t11 + (t0 * t13 - t3 * t9);
        let t108 = t2 * t20 + (t0 * t21 - t3 * t19);
        let t109 = t42 * (t22 * t108 + t14 * t107);
        let t110 = t53 * (t40 * t107 - t14 * t109) - t66 * (t40 * t108 - t22 * t109);
        let t111 = t2 * t61 + (t0 * t63 - t3 * t59 - t9 * t28);
        let t112 = t24 * (t21 * t25 + (t20 * t27 + t106))
            + (t110 - t69 * (t13 * t25 + (t11 * t27 + t111)));
        let t113 = t3 * t50 + (t0 * t46 - t1 * t48 - t20 * t26);
        let t114 = t3 * t13 + (t0 * t9 - t1 * t11);
        let t115 = t3 * t21 + (t0 * t19 - t1 * t20);
        let t116 = t42 * (t22 * t115 + t14 * t114);
        let t117 = t53 * (t40 * t114 - t14 * t116) - t66 * (t40 * t115 - t22 * t116);
        let t118 = t3 * t63 + (t0 * t59 - t1 * t61 - t11 * t26);
        let t119 = t24 * (t19 * t25 + (t21 * t28 + t113))
            + (t117 - t69 * (t9 * t25 + (t13 * t28 + t118)));
        let t120 = q_i[4] * q_i[6];
        let t121 = q_i[3] * q_i[5];
        let t122 = t120 - t121;
        let t123 = q_i[3] * q_i[6];
        let t124 = q_i[4] * q_i[5];
        let t125 = t123 + t124;
        let t126 = q_i[3] * q_i[3];
        let t127 = q_i[4] * q_i[4];
        let t128 = q_i[6] * q_i[6];
        let t129 = q_i[5] * q_i[5];
        let t130 = t126 + t127 - t128 - t129;
        let t131 = (t4 * t122 + t12 * t125) * two + t10 * t130;
        let t132 = t42 * (t14 * t131);
        let t133 = t22 * t132;
        let t134 = t40 * t131;
        let t135 = q_i[6] * v_i[4] + q_i[4] * v_i[6];
        let t136 = q_i[3] * v_i[5];
        let t137 = q_i[5] * v_i[3];
        let t138 = q_i[5] * v_i[4] + q_i[4] * v_i[5];
        let t139 = q_i[3] * v_i[6];
        let t140 = q_i[6] * v_i[3];
        let t141 = q_i[4] * v_i[4];
        let t142 = q_i[3] * v_i[3];
        let t143 = q_i[6] * v_i[6];
        let t144 = q_i[5] * v_i[5];
        let t145 = t34 * t130 * half + t10 * (t141 + t142 - t143 - t144);
        let t146 = t4 * (t135 - t136 - t137) + (t12 * (t138 + (t139 + t140)) + t145);
        let t147 = t30 * t122 + (t32 * t125 + t146);
        let t148 = t65 * t133 + (t52 * (t134 - t14 * t132) - t69 * t147);
        let t149 = q_i[4] * q_i[3];
        let t150 = q_i[6] * q_i[5];
        let t151 = t149 + t150;
        let t152 = t126 - t127;
        let t153 = t129 - t128;
        let t154 = (t152 + t153) * half;
        let t155 = t124 - t123;
        let t156 = t4 * t151 + (t12 * t154 + t10 * t155);
        let t157 = t42 * (t14 * t156);
        let t158 = t22 * t157;
        let t159 = t40 * t156;
        let t160 = q_i[6] * v_i[5] + q_i[5] * v_i[6];
        let t161 = q_i[3] * v_i[4];
        let t162 = q_i[4] * v_i[3];
        let t163 = t142 - t141;
        let t164 = t12 * (t163 + (t144 - t143))
            + (t32 * t154 + t10 * (t138 - t139 - t140));
        let t165 = t30 * t151 + (t34 * t155 + (t4 * (t160 + (t161 + t162)) + t164));
        let t166 = t66 * t158 + (t53 * (t159 - t14 * t157) - t69 * t165);
        let t167 = t150 - t149;
        let t168 = (t152 - t153) * half;
        let t169 = t121 + t120;
        let t170 = t12 * t167 + (t4 * t168 + t10 * t169);
        let t171 = t42 * (t14 * t170);
        let t172 = t22 * t171;
        let t173 = t40 * t170;
        let t174 = t12 * (t160 - t161 - t162)
            + (t30 * t168 + t10 * (t137 + (t136 + t135)));
        let t175 = t32 * t167 + (t34 * t169 + (t4 * (t143 + (t163 - t144)) + t174));
        let t176 = t66 * t172 + (t53 * (t173 - t14 * t171) - t69 * t175);
        let t177 = t65 * (t134 - t22 * (t42 * (t22 * t131))) + (t52 * t133 - t24 * t147);
        let t178 = t66 * (t159 - t22 * (t42 * (t22 * t156))) + (t53 * t158 - t24 * t165);
        let t179 = t66 * (t173 - t22 * (t42 * (t22 * t170))) + (t53 * t172 - t24 * t175);
        let t180 = q_j[6] * q_j[4];
        let t181 = q_j[3] * q_j[5];
        let t182 = t180 - t181;
        let t183 = q_j[6] * q_j[3];
        let t184 = q_j[4] * q_j[5];
        let t185 = t183 + t184;
        let t186 = q_j[3] * q_j[3];
        let t187 = q_j[4] * q_j[4];
        let t188 = q_j[6] * q_j[6];
        let t189 = q_j[5] * q_j[5];
        let t190 = t186 + t187 - t188 - t189;
        let t191 = (t9 * t182 + t13 * t185) * two + t11 * t190;
        let t192 = (t19 * t182 + t21 * t185) * two + t20 * t190;
        let t193 = t42 * (t22 * t192 + t14 * t191);
        let t194 = q_j[6] * v_j[4] + q_j[4] * v_j[6];
        let t195 = q_j[3] * v_j[5];
        let t196 = q_j[5] * v_j[3];
        let t197 = t194 - t195 - t196;
        let t198 = q_j[5] * v_j[4] + q_j[4] * v_j[5];
        let t199 = q_j[3] * v_j[6];
        let t200 = q_j[6] * v_j[3];
        let t201 = t198 + (t199 + t200);
        let t202 = t190 * half;
        let t203 = q_j[4] * v_j[4];
        let t204 = q_j[3] * v_j[3];
        let t205 = q_j[6] * v_j[6];
        let t206 = q_j[5] * v_j[5];
        let t207 = t203 + t204 - t205 - t206;
        let t208 = t19 * t197 + (t21 * t201 + (t48 * t202 + t20 * t207));
        let t209 = t9 * t197 + (t13 * t201 + (t61 * t202 + t11 * t207));
        let t210 = t24 * (t46 * t182 + (t50 * t185 + t208))
            - t69 * (t59 * t182 + (t63 * t185 + t209));
        let t211 = t52 * (t40 * t191 - t14 * t193)
            + (t210 - t65 * (t40 * t192 - t22 * t193));
        let t212 = q_j[4] * q_j[3];
        let t213 = q_j[6] * q_j[5];
        let t214 = t212 + t213;
        let t215 = t184 - t183;
        let t216 = q_j[6] * v_j[5] + q_j[5] * v_j[6];
        let t217 = q_j[3] * v_j[4];
        let t218 = q_j[4] * v_j[3];
        let t219 = t216 + (t217 + t218);
        let t220 = t204 - t203;
        let t221 = t220 + (t206 - t205);
        let t222 = t186 - t187;
        let t223 = t189 - t188;
        let t224 = (t222 + t223) * half;
        let t225 = t198 - t199 - t200;
        let t226 = t19 * t219 + (t21 * t221 + (t50 * t224 + t20 * t225));
        let t227 = t9 * t214 + (t13 * t224 + t11 * t215);
        let t228 = t19 * t214 + (t21 * t224 + t20 * t215);
        let t229 = t42 * (t22 * t228 + t14 * t227);
        let t230 = t53 * (t40 * t227 - t14 * t229) - t66 * (t40 * t228 - t22 * t229);
        let t231 = t9 * t219 + (t13 * t221 + (t63 * t224 + t11 * t225));
        let t232 = t24 * (t46 * t214 + (t48 * t215 + t226))
            + (t230 - t69 * (t59 * t214 + (t61 * t215 + t231)));
        let t233 = t213 - t212;
        let t234 = t181 + t180;
        let t235 = t205 + (t220 - t206);
        let t236 = t216 - t217 - t218;
        let t237 = (t222 - t223) * half;
        let t238 = t196 + (t195 + t194);
        let t239 = t19 * t235 + (t21 * t236 + (t46 * t237 + t20 * t238));
        let t240 = t13 * t233 + (t9 * t237 + t11 * t234);
        let t241 = t21 * t233 + (t19 * t237 + t20 * t234);
        let t242 = t42 * (t22 * t241 + t14 * t240);
        let t243 = t53 * (t40 * t240 - t14 * t242) - t66 * (t40 * t241 - t22 * t242);
        let t244 = t9 * t235 + (t13 * t236 + (t59 * t237 + t11 * t238));
        let t245 = t24 * (t50 * t233 + (t48 * t234 + t239))
            + (t243 - t69 * (t63 * t233 + (t61 * t234 + t244)));
        rate_q[0] = t70 * two;
        rate_q[1] = t77 * two;
        rate_q[2] = t84 * two;
        rate_q[3] = t91 * two;
        rate_q[4] = t98 * two;
        rate_q[5] = t105 * two;
        rate_q[6] = t112 * two;
        rate_q[7] = t119 * two;
        rate_h[0] = t148 * two;
        rate_h[1] = t166 * two;
        rate_h[2] = t176 * two;
        rate_h[3] = -(t177 * two);
        rate_h[4] = -(t178 * two);
        rate_h[5] = -(t179 * two);
        rate_h[6] = t211 * two;
        rate_h[7] = t232 * two;
        rate_h[8] = t245 * two;
    }
}
