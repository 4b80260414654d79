// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Prescribed height of the tyre contact patch
///
/// `e_zᵀ (r + A s) − R √(1 − (e_zᵀ A u)²) − z = 0` (unit m)
///
/// Source: lowest point of a disc of radius R in the wheel plane, normal to u: r + A s + R d/|d|, d = −e_z + (A u)(e_zᵀ A u).
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `s_i` | m | body i | wheel centre |
/// | 3..6 | `u_i` | 1 | body i | unit vector of the spin axis, not vertical |
/// | 6 | `radius` | m |  | radius of the disc |
/// | 7 | `height` | m |  | height of its lowest point in the frame of the ground |
pub mod patch_height {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "patch_height",
        title: "Prescribed height of the tyre contact patch",
        equation: "e_zᵀ (r + A s) − R √(1 − (e_zᵀ A u)²) − z = 0",
        reference: "lowest point of a disc of radius R in the wheel plane, normal to u: r + A s + R d/|d|, d = −e_z + (A u)(e_zᵀ A u)",
        bodies: 1,
        equations: 1,
        unit: "m",
        parameters: &[
            Parameter {
                name: "s_i",
                size: 3,
                offset: 0,
                unit: "m",
                frame: "body i",
                meaning: "wheel centre",
            },
            Parameter {
                name: "u_i",
                size: 3,
                offset: 3,
                unit: "1",
                frame: "body i",
                meaning: "unit vector of the spin axis, not vertical",
            },
            Parameter {
                name: "radius",
                size: 1,
                offset: 6,
                unit: "m",
                frame: "",
                meaning: "radius of the disc",
            },
            Parameter {
                name: "height",
                size: 1,
                offset: 7,
                unit: "m",
                frame: "",
                meaning: "height of its lowest point in the frame of the ground",
            },
        ],
        jacobian: &[(0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
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
        design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (0, 7)],
        force_design: &[
            (3, 0),
            (3, 1),
            (3, 2),
            (3, 3),
            (3, 4),
            (3, 5),
            (3, 6),
            (4, 0),
            (4, 1),
            (4, 2),
            (4, 3),
            (4, 4),
            (4, 5),
            (4, 6),
            (5, 0),
            (5, 1),
            (5, 2),
            (5, 3),
            (5, 4),
            (5, 5),
            (5, 6),
            (6, 0),
            (6, 1),
            (6, 2),
            (6, 3),
            (6, 4),
            (6, 5),
            (6, 6),
        ],
        rate: &[(0, 3), (0, 4), (0, 5), (0, 6)],
        rate_design: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
        operations: [
            Operations {
                additions: 26,
                multiplications: 34,
                divisions: 0,
                functions: 1,
            },
            Operations {
                additions: 30,
                multiplications: 51,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 45,
                multiplications: 98,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 32,
                multiplications: 94,
                divisions: 1,
                functions: 1,
            },
            Operations {
                additions: 67,
                multiplications: 139,
                divisions: 1,
                functions: 1,
            },
        ],
    };
    /// Prescribed height of the tyre contact patch
    #[derive(Clone, Copy, Debug, Default)]
    pub struct PatchHeight;
    impl<S: Scalar> Relation<S> for PatchHeight {
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
    /// 26 additions, 34 multiplications, 0 divisions, 1 functions.
    #[inline]
    pub fn residual<S: Scalar>(q_i: &[S; 7], h: &[S; 8], phi: &mut [S; 1]) {
        let one = S::from_f64(1.0);
        let t0 = q_i[3] * (q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0])
            + q_i[4] * (h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]));
        let t1 = t0 - q_i[5] * (q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6]);
        let t2 = q_i[6] * (h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5])) + t1;
        let t3 = q_i[3] * (q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3])
            + q_i[4] * (q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]));
        let t4 = t3 - q_i[5] * (q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4]);
        let t5 = q_i[6] * (q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4])) + t4;
        phi[0] = q_i[2] + t2 - h[6] * (one - t5 * t5).sqrt() - h[7];
    }
    /// Φ, Φ_q and W.
    ///
    /// 30 additions, 51 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 8],
        phi: &mut [S; 1],
        phi_q: &mut [S; 5],
        _work: &mut [S; 0],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let t0 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t1 = q_i[3] * h[2] + q_i[4] * h[1] - h[0] * q_i[5];
        let t2 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t3 = q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t6 = q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3];
        let t7 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t8 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t9 = q_i[6] * t5 + (q_i[3] * t6 + q_i[4] * t7 - q_i[5] * t8);
        let t10 = (one - t9 * t9).sqrt();
        let t11 = one / t10;
        phi[0] = q_i[2] + t4 - (h[7] + h[6] * t10);
        phi_q[0] = one;
        phi_q[1] = (t1 + h[6] * (t6 * t9 * t11)) * two;
        phi_q[2] = (t2 + h[6] * (t11 * (t7 * t9))) * two;
        phi_q[3] = -((t3 + h[6] * (t11 * (t8 * t9))) * two);
        phi_q[4] = (t0 + h[6] * (t11 * (t5 * t9))) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 45 additions, 98 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 8],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 5],
        _work: &mut [S; 0],
        curvature: &mut [S; 10],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t1 = q_i[3] * h[2] + q_i[4] * h[1] - h[0] * q_i[5];
        let t2 = h[0] * q_i[6] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t3 = q_i[3] * h[0] + h[2] * q_i[5] - h[1] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t6 = q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3];
        let t7 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t8 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t9 = q_i[6] * t5 + (q_i[3] * t6 + q_i[4] * t7 - q_i[5] * t8);
        let t10 = (one - t9 * t9).sqrt();
        let t11 = one / t10;
        let t12 = t6 * t9 * t11;
        let t13 = t11 * (t7 * t9);
        let t14 = t11 * (t8 * t9);
        let t15 = t11 * (t5 * t9);
        let t16 = h[6] * lambda[0];
        let t17 = t11 * t16;
        let t18 = t11 * t11;
        let t19 = t6 * t17 + t9 * (t16 * (t12 * t18));
        let t20 = t19 * k4;
        let t21 = t9 * t17;
        let t22 = (h[2] * lambda[0] + h[5] * t21) * two;
        let t23 = (h[1] * lambda[0] + h[4] * t21) * two;
        let t24 = t7 * t17 + t9 * (t16 * (t13 * t18));
        let t25 = t8 * k4;
        let t26 = (h[0] * lambda[0] + h[3] * t21) * two;
        let t27 = t8 * t17 + t9 * (t16 * (t14 * t18));
        let t28 = t5 * k4;
        phi[0] = q_i[2] + t4 - (h[7] + h[6] * t10);
        phi_q[0] = one;
        phi_q[1] = (t1 + h[6] * t12) * two;
        phi_q[2] = (t2 + h[6] * t13) * two;
        phi_q[3] = -((t3 + h[6] * t14) * two);
        phi_q[4] = (t0 + h[6] * t15) * two;
        curvature[0] = t6 * t20 + t22;
        curvature[1] = t7 * t20 + t23;
        curvature[2] = t7 * t24 * k4 - t22;
        curvature[3] = -(t19 * t25) - t26;
        curvature[4] = -(t24 * t25);
        curvature[5] = t8 * t27 * k4 - t22;
        curvature[6] = t5 * t20;
        curvature[7] = t26 + t24 * t28;
        curvature[8] = t23 - t5 * t27 * k4;
        curvature[9] = t22 + t28 * (t5 * t17 + t9 * (t16 * (t15 * t18)));
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 32 additions, 94 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 8],
        lambda: &[S; 1],
        phi_h: &mut [S; 8],
        force_h: &mut [S; 28],
    ) {
        let two = S::from_f64(2.0);
        let one = S::from_f64(1.0);
        let minus_one = S::from_f64(-1.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_i[4] * q_i[6] - q_i[3] * q_i[5];
        let t1 = q_i[3] * q_i[4] + q_i[5] * q_i[6];
        let t2 = q_i[6] * q_i[6] + (q_i[3] * q_i[3] - q_i[4] * q_i[4] - q_i[5] * q_i[5]);
        let t3 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t4 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t5 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t6 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t7 = q_i[6] * t3 + (q_i[4] * t4 + (q_i[3] * t5 - q_i[5] * t6));
        let t8 = (one - t7 * t7).sqrt();
        let t9 = one / t8;
        let t10 = t9 * (t0 * t7);
        let t11 = h[6] * two;
        let t12 = t9 * (t1 * t7);
        let t13 = t9 * (t2 * t7);
        let t14 = lambda[0] * two;
        let t15 = q_i[5] * t14;
        let t16 = -t15;
        let t17 = q_i[4] * t14;
        let t18 = q_i[3] * t14;
        let t19 = h[6] * lambda[0];
        let t20 = t9 * t9;
        let t21 = t9 * t19;
        let t22 = t7 * (t19 * (t10 * t20)) + t0 * t21;
        let t23 = t22 * k4;
        let t24 = t7 * t21 * two;
        let t25 = q_i[5] * t24;
        let t26 = t7 * (t19 * (t12 * t20)) + t1 * t21;
        let t27 = t26 * k4;
        let t28 = q_i[4] * t24;
        let t29 = t7 * (t19 * (t13 * t20)) + t2 * t21;
        let t30 = t29 * two;
        let t31 = q_i[3] * t24;
        let t32 = t7 * (t9 * lambda[0]);
        let t33 = t32 * two;
        let t34 = q_i[6] * t14;
        let t35 = q_i[6] * t24;
        let t36 = t6 * k4;
        let t37 = t6 * two;
        phi_h[0] = t0 * two;
        phi_h[1] = t1 * two;
        phi_h[2] = t2;
        phi_h[3] = t10 * t11;
        phi_h[4] = t11 * t12;
        phi_h[5] = h[6] * t13;
        phi_h[6] = -t8;
        phi_h[7] = minus_one;
        force_h[0] = t16;
        force_h[1] = t17;
        force_h[2] = t18;
        force_h[3] = t5 * t23 - t25;
        force_h[4] = t5 * t27 + t28;
        force_h[5] = t5 * t30 + t31;
        force_h[6] = t5 * t33;
        force_h[7] = t34;
        force_h[8] = t18;
        force_h[9] = -t17;
        force_h[10] = t4 * t23 + t35;
        force_h[11] = t31 + t4 * t27;
        force_h[12] = t4 * t30 - t28;
        force_h[13] = t4 * t33;
        force_h[14] = -t18;
        force_h[15] = t34;
        force_h[16] = t16;
        force_h[17] = -(t22 * t36) - t31;
        force_h[18] = t35 - t26 * t36;
        force_h[19] = -t25 - t29 * t37;
        force_h[20] = -(t32 * t37);
        force_h[21] = t17;
        force_h[22] = t15;
        force_h[23] = t34;
        force_h[24] = t28 + t3 * t23;
        force_h[25] = t25 + t3 * t27;
        force_h[26] = t35 + t3 * t30;
        force_h[27] = t3 * t33;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 67 additions, 139 multiplications, 1 divisions, 1 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 8],
        v_i: &[S; 7],
        rate_q: &mut [S; 4],
        rate_h: &mut [S; 7],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t1 = q_i[3] * h[5] + q_i[4] * h[4] - h[3] * q_i[5];
        let t2 = h[3] * q_i[6] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t3 = q_i[3] * h[3] + h[5] * q_i[5] - h[4] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = one / (one - t4 * t4).sqrt();
        let t6 = h[5] * v_i[6] + (v_i[4] * h[3] + v_i[5] * h[4]);
        let t7 = v_i[3] * h[5] + (v_i[4] * h[4] - v_i[5] * h[3]);
        let t8 = h[3] * v_i[6] + v_i[3] * h[4] - v_i[4] * h[5];
        let t9 = v_i[3] * t1 + (q_i[6] * t6 + (q_i[3] * t7 + q_i[4] * t8));
        let t10 = v_i[5] * h[5] + (v_i[3] * h[3] - h[4] * v_i[6]);
        let t11 = t0 * v_i[6] + (v_i[4] * t2 + t9) - (q_i[5] * t10 + v_i[5] * t3);
        let t12 = t5 * t5;
        let t13 = t4 * t11;
        let t14 = t5 * (t1 * t11 + t4 * t7) + t5 * (t1 * t4) * t12 * t13;
        let t15 = h[2] * v_i[3] + (h[1] * v_i[4] - h[0] * v_i[5]) + h[6] * t14;
        let t16 = t5 * (t2 * t11 + t4 * t8) + t13 * (t12 * (t5 * (t2 * t4)));
        let t17 = h[0] * v_i[6] + h[1] * v_i[3] - v_i[4] * h[2] + h[6] * t16;
        let t18 = t5 * (t3 * t11 + t4 * t10) + t13 * (t12 * (t5 * (t3 * t4)));
        let t19 = v_i[5] * h[2] + (h[0] * v_i[3] - h[1] * v_i[6]) + h[6] * t18;
        let t20 = t5 * (t0 * t11 + t4 * t6) + t13 * (t12 * (t5 * (t0 * t4)));
        let t21 = h[2] * v_i[6] + (h[0] * v_i[4] + v_i[5] * h[1]) + h[6] * t20;
        let t22 = q_i[4] * v_i[6] + v_i[4] * q_i[6]
            - (v_i[5] * q_i[3] + v_i[3] * q_i[5]);
        let t23 = v_i[5] * q_i[6]
            + (q_i[5] * v_i[6] + (v_i[4] * q_i[3] + v_i[3] * q_i[4]));
        let t24 = v_i[3] * q_i[3] + q_i[6] * v_i[6]
            - (v_i[4] * q_i[4] + v_i[5] * q_i[5]);
        let t25 = q_i[4] * q_i[6] - q_i[3] * q_i[5];
        let t26 = t5 * (t4 * t22 + t11 * t25) + t13 * (t12 * (t5 * (t4 * t25)));
        let t27 = h[6] * two;
        let t28 = q_i[3] * q_i[4] + q_i[5] * q_i[6];
        let t29 = t5 * (t4 * t23 + t11 * t28) + t13 * (t12 * (t5 * (t4 * t28)));
        let t30 = q_i[6] * q_i[6]
            + (q_i[3] * q_i[3] - (q_i[4] * q_i[4] + q_i[5] * q_i[5]));
        let t31 = t5 * (t4 * t24 + t11 * t30 * half)
            + t13 * (t12 * (t5 * (t4 * t30))) * half;
        rate_q[0] = t15 * two;
        rate_q[1] = t17 * two;
        rate_q[2] = -(t19 * two);
        rate_q[3] = t21 * two;
        rate_h[0] = t22 * two;
        rate_h[1] = t23 * two;
        rate_h[2] = t24 * two;
        rate_h[3] = t26 * t27;
        rate_h[4] = t27 * t29;
        rate_h[5] = t27 * t31;
        rate_h[6] = t5 * t13;
    }
}
