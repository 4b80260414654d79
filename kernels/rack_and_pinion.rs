// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Rack and pinion
///
/// `sin(θ − κ s) = 0, with cos θ = (A_i u_i)ᵀ A_j w_j, sin θ = (A_i v_i)ᵀ A_j w_j and s = (A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i)` (unit 1)
///
/// Source: rolling without slip; the angle as in Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.3.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `u_i` | 1 | body i | unit vector normal to the axis of rotation, where the angle is zero |
/// | 3..6 | `v_i` | 1 | body i | unit vector normal to the axis and to u_i, a quarter turn on |
/// | 6..9 | `w_j` | 1 | body j | unit vector normal to the axis, whose angle is taken |
/// | 9..12 | `a_i` | 1 | body i | unit direction of the way |
/// | 12..15 | `s_i` | m | body i | point where the way is zero |
/// | 15..18 | `s_j` | m | body j | point whose way is taken |
/// | 18 | `ratio` | rad/m |  | angle by way; negative where body j turns left-handed as it goes along |
pub mod rack_and_pinion {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "rack_and_pinion",
        title: "Rack and pinion",
        equation: "sin(θ − κ s) = 0, with cos θ = (A_i u_i)ᵀ A_j w_j, sin θ = (A_i v_i)ᵀ A_j w_j and s = (A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i)",
        reference: "rolling without slip; the angle as in Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, section 9.4.3",
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
                meaning: "unit vector normal to the axis of rotation, where the angle is zero",
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
                meaning: "unit vector normal to the axis, whose angle is taken",
            },
            Parameter {
                name: "a_i",
                size: 3,
                offset: 9,
                unit: "1",
                frame: "body i",
                meaning: "unit direction of the way",
            },
            Parameter {
                name: "s_i",
                size: 3,
                offset: 12,
                unit: "m",
                frame: "body i",
                meaning: "point where the way is zero",
            },
            Parameter {
                name: "s_j",
                size: 3,
                offset: 15,
                unit: "m",
                frame: "body j",
                meaning: "point whose way is taken",
            },
            Parameter {
                name: "ratio",
                size: 1,
                offset: 18,
                unit: "rad/m",
                frame: "",
                meaning: "angle by way; negative where body j turns left-handed as it goes along",
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
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
            (0, 14),
            (0, 15),
            (0, 16),
            (0, 17),
            (0, 18),
        ],
        force_design: &[
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
            (0, 14),
            (0, 15),
            (0, 16),
            (0, 17),
            (0, 18),
            (1, 0),
            (1, 1),
            (1, 2),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 6),
            (1, 7),
            (1, 8),
            (1, 9),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (1, 14),
            (1, 15),
            (1, 16),
            (1, 17),
            (1, 18),
            (2, 0),
            (2, 1),
            (2, 2),
            (2, 3),
            (2, 4),
            (2, 5),
            (2, 6),
            (2, 7),
            (2, 8),
            (2, 9),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
            (2, 14),
            (2, 15),
            (2, 16),
            (2, 17),
            (2, 18),
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
            (3, 10),
            (3, 11),
            (3, 12),
            (3, 13),
            (3, 14),
            (3, 15),
            (3, 16),
            (3, 17),
            (3, 18),
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
            (4, 10),
            (4, 11),
            (4, 12),
            (4, 13),
            (4, 14),
            (4, 15),
            (4, 16),
            (4, 17),
            (4, 18),
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
            (5, 10),
            (5, 11),
            (5, 12),
            (5, 13),
            (5, 14),
            (5, 15),
            (5, 16),
            (5, 17),
            (5, 18),
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
            (6, 10),
            (6, 11),
            (6, 12),
            (6, 13),
            (6, 14),
            (6, 15),
            (6, 16),
            (6, 17),
            (6, 18),
            (7, 0),
            (7, 1),
            (7, 2),
            (7, 3),
            (7, 4),
            (7, 5),
            (7, 6),
            (7, 7),
            (7, 8),
            (7, 9),
            (7, 10),
            (7, 11),
            (7, 12),
            (7, 13),
            (7, 14),
            (7, 15),
            (7, 16),
            (7, 17),
            (7, 18),
            (8, 0),
            (8, 1),
            (8, 2),
            (8, 3),
            (8, 4),
            (8, 5),
            (8, 6),
            (8, 7),
            (8, 8),
            (8, 9),
            (8, 10),
            (8, 11),
            (8, 12),
            (8, 13),
            (8, 14),
            (8, 15),
            (8, 16),
            (8, 17),
            (8, 18),
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
            (9, 10),
            (9, 11),
            (9, 12),
            (9, 13),
            (9, 14),
            (9, 15),
            (9, 16),
            (9, 17),
            (9, 18),
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
            (10, 11),
            (10, 12),
            (10, 13),
            (10, 14),
            (10, 15),
            (10, 16),
            (10, 17),
            (10, 18),
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
            (11, 12),
            (11, 13),
            (11, 14),
            (11, 15),
            (11, 16),
            (11, 17),
            (11, 18),
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
            (12, 13),
            (12, 14),
            (12, 15),
            (12, 16),
            (12, 17),
            (12, 18),
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
            (13, 14),
            (13, 15),
            (13, 16),
            (13, 17),
            (13, 18),
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
            (0, 9),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
            (0, 14),
            (0, 15),
            (0, 16),
            (0, 17),
            (0, 18),
        ],
        operations: [
            Operations {
                additions: 118,
                multiplications: 156,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 191,
                multiplications: 312,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 941,
                multiplications: 1283,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 1486,
                multiplications: 2154,
                divisions: 0,
                functions: 2,
            },
            Operations {
                additions: 791,
                multiplications: 1151,
                divisions: 0,
                functions: 2,
            },
        ],
    };
    /// Rack and pinion
    #[derive(Clone, Copy, Debug, Default)]
    pub struct RackAndPinion;
    impl<S: Scalar> Relation<S> for RackAndPinion {
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
    /// 118 additions, 156 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 19],
        phi: &mut [S; 1],
    ) {
        let t0 = h[11] * q_i[6] + (h[9] * q_i[4] + q_i[5] * h[10]);
        let t1 = q_i[3] * h[11] + h[10] * q_i[4] - h[9] * q_i[5];
        let t2 = h[9] * q_i[6] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t3 = q_i[3] * h[9] + q_i[5] * h[11] - q_i[6] * h[10];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = h[17] * q_j[6] + (h[15] * q_j[4] + q_j[5] * h[16]);
        let t6 = q_j[3] * h[17] + h[16] * q_j[4] - h[15] * q_j[5];
        let t7 = h[15] * q_j[6] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t8 = q_j[3] * h[15] + q_j[5] * h[17] - q_j[6] * h[16];
        let t9 = q_j[6] * t5 + (q_j[3] * t6 + q_j[4] * t7 - q_j[5] * t8);
        let t10 = q_i[6] * h[14] + (q_i[4] * h[12] + q_i[5] * h[13]);
        let t11 = q_i[3] * h[14] + q_i[4] * h[13] - q_i[5] * h[12];
        let t12 = q_i[6] * h[12] + (q_i[3] * h[13] - q_i[4] * h[14]);
        let t13 = q_i[3] * h[12] + q_i[5] * h[14] - q_i[6] * h[13];
        let t14 = q_i[6] * t10 + (q_i[3] * t11 + q_i[4] * t12 - q_i[5] * t13);
        let t15 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t16 = q_j[5] * t6 + (q_j[3] * t8 + q_j[4] * t5) - q_j[6] * t7;
        let t17 = q_i[5] * t11 + (q_i[3] * t13 + q_i[4] * t10) - q_i[6] * t12;
        let t18 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t19 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t7 - q_j[4] * t6));
        let t20 = q_i[6] * t13 + (q_i[5] * t10 + (q_i[3] * t12 - q_i[4] * t11));
        let t21 = t15 * (q_j[0] + t16 - q_i[0] - t17)
            + t18 * (q_j[1] + t19 - q_i[1] - t20);
        let t22 = h[18] * (t4 * (q_j[2] + t9 - q_i[2] - t14) + t21);
        let t23 = q_j[6] * h[8] + (q_j[4] * h[6] + q_j[5] * h[7]);
        let t24 = q_j[3] * h[8] + q_j[4] * h[7] - q_j[5] * h[6];
        let t25 = q_j[6] * h[6] + (q_j[3] * h[7] - q_j[4] * h[8]);
        let t26 = q_j[3] * h[6] + q_j[5] * h[8] - q_j[6] * h[7];
        let t27 = q_j[6] * t23 + (q_j[3] * t24 + q_j[4] * t25 - q_j[5] * t26);
        let t28 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t29 = q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3];
        let t30 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t31 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t32 = q_i[6] * t28 + (q_i[3] * t29 + q_i[4] * t30 - q_i[5] * t31);
        let t33 = q_j[5] * t24 + (q_j[3] * t26 + q_j[4] * t23) - q_j[6] * t25;
        let t34 = q_i[5] * t29 + (q_i[3] * t31 + q_i[4] * t28) - q_i[6] * t30;
        let t35 = q_j[6] * t26 + (q_j[5] * t23 + (q_j[3] * t25 - q_j[4] * t24));
        let t36 = q_i[6] * t31 + (q_i[5] * t28 + (q_i[3] * t30 - q_i[4] * t29));
        let t37 = t22.cos() * (t27 * t32 + (t33 * t34 + t35 * t36));
        let t38 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t39 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t40 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t41 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t42 = q_i[6] * t38 + (q_i[3] * t39 + q_i[4] * t40 - q_i[5] * t41);
        let t43 = q_i[5] * t39 + (q_i[3] * t41 + q_i[4] * t38) - q_i[6] * t40;
        let t44 = q_i[6] * t41 + (q_i[5] * t38 + (q_i[3] * t40 - q_i[4] * t39));
        let t45 = t22.sin() * (t27 * t42 + (t33 * t43 + t35 * t44));
        phi[0] = t37 - t45;
    }
    /// Φ, Φ_q and W.
    ///
    /// 191 additions, 312 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 19],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = h[11] * q_i[6] + (h[9] * q_i[4] + q_i[5] * h[10]);
        let t1 = q_i[3] * h[11] + h[10] * q_i[4] - h[9] * q_i[5];
        let t2 = h[9] * q_i[6] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t3 = q_i[3] * h[9] + q_i[5] * h[11] - h[10] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = h[17] * q_j[6] + (h[15] * q_j[4] + q_j[5] * h[16]);
        let t6 = q_j[3] * h[17] + h[16] * q_j[4] - h[15] * q_j[5];
        let t7 = h[15] * q_j[6] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t8 = q_j[3] * h[15] + q_j[5] * h[17] - h[16] * q_j[6];
        let t9 = q_j[6] * t5 + (q_j[3] * t6 + q_j[4] * t7 - q_j[5] * t8);
        let t10 = q_j[2] + t9;
        let t11 = q_i[6] * h[14] + (q_i[4] * h[12] + q_i[5] * h[13]);
        let t12 = q_i[3] * h[14] + q_i[4] * h[13] - q_i[5] * h[12];
        let t13 = q_i[6] * h[12] + (q_i[3] * h[13] - q_i[4] * h[14]);
        let t14 = q_i[3] * h[12] + q_i[5] * h[14] - q_i[6] * h[13];
        let t15 = q_i[6] * t11 + (q_i[3] * t12 + q_i[4] * t13 - q_i[5] * t14);
        let t16 = q_i[2] + t15;
        let t17 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t18 = q_j[5] * t6 + (q_j[3] * t8 + q_j[4] * t5) - q_j[6] * t7;
        let t19 = q_j[0] + t18;
        let t20 = q_i[5] * t12 + (q_i[3] * t14 + q_i[4] * t11) - q_i[6] * t13;
        let t21 = q_i[0] + t20;
        let t22 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t23 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t7 - q_j[4] * t6));
        let t24 = q_j[1] + t23;
        let t25 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t13 - q_i[4] * t12));
        let t26 = q_i[1] + t25;
        let t27 = t4 * (t10 - t16) + (t17 * (t19 - t21) + t22 * (t24 - t26));
        let t28 = h[18] * t27;
        let t29 = t28.cos();
        let t30 = q_j[6] * h[8] + (q_j[4] * h[6] + q_j[5] * h[7]);
        let t31 = q_j[3] * h[8] + q_j[4] * h[7] - q_j[5] * h[6];
        let t32 = q_j[6] * h[6] + (q_j[3] * h[7] - q_j[4] * h[8]);
        let t33 = q_j[3] * h[6] + q_j[5] * h[8] - q_j[6] * h[7];
        let t34 = q_j[6] * t30 + (q_j[3] * t31 + q_j[4] * t32 - q_j[5] * t33);
        let t35 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t36 = q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3];
        let t37 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t38 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t39 = q_i[6] * t35 + (q_i[3] * t36 + q_i[4] * t37 - q_i[5] * t38);
        let t40 = q_j[5] * t31 + (q_j[3] * t33 + q_j[4] * t30) - q_j[6] * t32;
        let t41 = q_i[5] * t36 + (q_i[3] * t38 + q_i[4] * t35) - q_i[6] * t37;
        let t42 = q_j[6] * t33 + (q_j[5] * t30 + (q_j[3] * t32 - q_j[4] * t31));
        let t43 = q_i[6] * t38 + (q_i[5] * t35 + (q_i[3] * t37 - q_i[4] * t36));
        let t44 = t34 * t39 + (t40 * t41 + t42 * t43);
        let t45 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t46 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t47 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t48 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t49 = q_i[6] * t45 + (q_i[3] * t46 + q_i[4] * t47 - q_i[5] * t48);
        let t50 = q_i[5] * t46 + (q_i[3] * t48 + q_i[4] * t45) - q_i[6] * t47;
        let t51 = q_i[6] * t48 + (q_i[5] * t45 + (q_i[3] * t47 - q_i[4] * t46));
        let t52 = t34 * t49 + (t40 * t50 + t42 * t51);
        let t53 = t28.sin();
        let t54 = h[18] * t17;
        let t55 = t44 * (t53 * t54) + t52 * (t29 * t54);
        let t56 = h[18] * t22;
        let t57 = t44 * (t53 * t56) + t52 * (t29 * t56);
        let t58 = h[18] * t4;
        let t59 = t44 * (t53 * t58) + t52 * (t29 * t58);
        let t60 = t29 * two;
        let t61 = t53 * two;
        let t62 = t36 * t60 - t46 * t61;
        let t63 = t38 * t60 - t48 * t61;
        let t64 = t37 * t60 - t47 * t61;
        let t65 = t10 * two - t16 * two;
        let t66 = t19 * two - t21 * two;
        let t67 = t24 * two - t26 * two;
        let t68 = (t1 * t65 + (t3 * t66 + t2 * t67)) * half
            - (t12 * t4 + (t17 * t14 + t13 * t22));
        let t69 = h[18] * t68;
        let t70 = t35 * t60 - t45 * t61;
        let t71 = (t0 * t66 + t2 * t65 - t1 * t67) * half
            + (t12 * t22 - (t17 * t11 + t13 * t4));
        let t72 = h[18] * t71;
        let t73 = (t1 * t66 + (t0 * t67 - t3 * t65)) * half
            + (t14 * t4 - (t17 * t12 + t11 * t22));
        let t74 = h[18] * t73;
        let t75 = (t0 * t65 + t3 * t67 - t2 * t66) * half
            + (t17 * t13 - (t14 * t22 + t11 * t4));
        let t76 = h[18] * t75;
        let t77 = t29 * t39 - t49 * t53;
        let t78 = t29 * t41 - t50 * t53;
        let t79 = t29 * t43 - t51 * t53;
        let t80 = h[18] * (t6 * t4 + (t17 * t8 + t7 * t22));
        let t81 = h[18] * (t7 * t4 + (t17 * t5 - t6 * t22));
        let t82 = t52 * (t29 * t81) + (t31 * t79 + t44 * (t53 * t81));
        let t83 = h[18] * (t17 * t6 + t5 * t22 - t8 * t4);
        let t84 = t52 * (t29 * t83) + (t33 * t77 + t44 * (t53 * t83));
        let t85 = h[18] * (t5 * t4 + (t8 * t22 - t17 * t7));
        let t86 = t52 * (t29 * t85) + (t32 * t78 + t44 * (t53 * t85));
        phi[0] = t29 * t44 - t52 * t53;
        phi_q[0] = t55;
        phi_q[1] = t57;
        phi_q[2] = t59;
        phi_q[3] = t34 * t62 + (t40 * t63 + t42 * t64)
            - (t44 * (t53 * t69) + t52 * (t29 * t69)) * two;
        phi_q[4] = t34 * t64 + (t40 * t70 - t42 * t62)
            - (t44 * (t53 * t72) + t52 * (t29 * t72)) * two;
        phi_q[5] = t40 * t62 + t42 * t70 - t34 * t63
            - (t44 * (t53 * t74) + t52 * (t29 * t74)) * two;
        phi_q[6] = t34 * t70 + (t42 * t63 - t40 * t64)
            - (t44 * (t53 * t76) + t52 * (t29 * t76)) * two;
        phi_q[7] = -t55;
        phi_q[8] = -t57;
        phi_q[9] = -t59;
        phi_q[10] = (t31 * t77 + (t33 * t78 + t32 * t79)) * two
            - (t44 * (t53 * t80) + t52 * (t29 * t80)) * two;
        phi_q[11] = (t30 * t78 + t32 * t77) * two - t82 * two;
        phi_q[12] = (t30 * t79 + t31 * t78) * two - t84 * two;
        phi_q[13] = (t30 * t77 + t33 * t79) * two - t86 * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 941 additions, 1283 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 19],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 14],
        _work: &mut [S; 0],
        curvature: &mut [S; 105],
    ) {
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let k4 = S::from_f64(4.0);
        let t0 = q_i[6] * h[11] + (q_i[4] * h[9] + q_i[5] * h[10]);
        let t1 = q_i[6] * h[9] + (q_i[3] * h[10] - q_i[4] * h[11]);
        let t2 = q_i[4] * h[10] + (q_i[3] * h[11] - q_i[5] * h[9]);
        let t3 = q_i[5] * h[11] + (q_i[3] * h[9] - q_i[6] * h[10]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = q_j[6] * h[17] + (q_j[4] * h[15] + q_j[5] * h[16]);
        let t6 = q_j[6] * h[15] + (q_j[3] * h[16] - q_j[4] * h[17]);
        let t7 = q_j[4] * h[16] + (q_j[3] * h[17] - q_j[5] * h[15]);
        let t8 = q_j[5] * h[17] + (q_j[3] * h[15] - q_j[6] * h[16]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[6] * h[14] + (q_i[4] * h[12] + q_i[5] * h[13]);
        let t11 = q_i[6] * h[12] + (q_i[3] * h[13] - q_i[4] * h[14]);
        let t12 = q_i[4] * h[13] + (q_i[3] * h[14] - q_i[5] * h[12]);
        let t13 = q_i[5] * h[14] + (q_i[3] * h[12] - q_i[6] * h[13]);
        let t14 = q_i[6] * t10 + (q_i[4] * t11 + (q_i[3] * t12 - q_i[5] * t13));
        let t15 = q_j[2] + t9 - q_i[2] - t14;
        let t16 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t17 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t18 = q_i[5] * t12 + (q_i[4] * t10 + (q_i[3] * t13 - q_i[6] * t11));
        let t19 = q_j[0] + t17 - q_i[0] - t18;
        let t20 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t21 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        let t22 = q_i[6] * t13 + (q_i[5] * t10 + (q_i[3] * t11 - q_i[4] * t12));
        let t23 = q_j[1] + t21 - q_i[1] - t22;
        let t24 = h[18] * (t4 * t15 + (t16 * t19 + t20 * t23));
        let t25 = t24.cos();
        let t26 = h[8] * q_j[6] + (q_j[4] * h[6] + h[7] * q_j[5]);
        let t27 = q_j[6] * h[6] + (q_j[3] * h[7] - h[8] * q_j[4]);
        let t28 = q_j[4] * h[7] + (h[8] * q_j[3] - h[6] * q_j[5]);
        let t29 = h[8] * q_j[5] + (q_j[3] * h[6] - h[7] * q_j[6]);
        let t30 = q_j[6] * t26 + (q_j[4] * t27 + (q_j[3] * t28 - q_j[5] * t29));
        let t31 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t32 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t33 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t34 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t35 = q_i[6] * t31 + (q_i[4] * t32 + (q_i[3] * t33 - q_i[5] * t34));
        let t36 = q_j[5] * t28 + (q_j[4] * t26 + (q_j[3] * t29 - q_j[6] * t27));
        let t37 = q_i[5] * t33 + (q_i[4] * t31 + (q_i[3] * t34 - q_i[6] * t32));
        let t38 = q_j[6] * t29 + (q_j[5] * t26 + (q_j[3] * t27 - q_j[4] * t28));
        let t39 = q_i[6] * t34 + (q_i[5] * t31 + (q_i[3] * t32 - q_i[4] * t33));
        let t40 = t30 * t35 + (t36 * t37 + t38 * t39);
        let t41 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t42 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t43 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t44 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t45 = q_i[6] * t41 + (q_i[4] * t42 + (q_i[3] * t43 - q_i[5] * t44));
        let t46 = q_i[5] * t43 + (q_i[4] * t41 + (q_i[3] * t44 - q_i[6] * t42));
        let t47 = q_i[6] * t44 + (q_i[5] * t41 + (q_i[3] * t42 - q_i[4] * t43));
        let t48 = t30 * t45 + (t36 * t46 + t38 * t47);
        let t49 = t24.sin();
        let t50 = h[18] * t16;
        let t51 = t49 * t50;
        let t52 = t40 * t51;
        let t53 = t25 * t50;
        let t54 = t48 * t53;
        let t55 = h[18] * t20;
        let t56 = t49 * t55;
        let t57 = t40 * t56;
        let t58 = t25 * t55;
        let t59 = t48 * t58;
        let t60 = h[18] * t4;
        let t61 = t49 * t60;
        let t62 = t40 * t61;
        let t63 = t25 * t60;
        let t64 = t48 * t63;
        let t65 = t25 * two;
        let t66 = t33 * t65;
        let t67 = t32 * t65;
        let t68 = t34 * t65;
        let t69 = t49 * two;
        let t70 = t36 * t69;
        let t71 = t38 * t69;
        let t72 = t30 * t69;
        let t73 = t36 * t68 - t44 * t70 - t42 * t71 - t43 * t72;
        let t74 = h[18] * half;
        let t75 = t9 * two;
        let t76 = q_j[2] * two - q_i[2] * two;
        let t77 = t14 * two;
        let t78 = t74 * (t75 + (t76 - t77));
        let t79 = t21 * two;
        let t80 = q_j[1] * two - q_i[1] * two;
        let t81 = t22 * two;
        let t82 = t74 * (t79 + (t80 - t81));
        let t83 = t17 * two;
        let t84 = q_j[0] * two - q_i[0] * two;
        let t85 = t18 * two;
        let t86 = (t83 + (t84 - t85)) * t74;
        let t87 = t3 * t86 - t13 * t50 - t11 * t55 - t12 * t60;
        let t88 = t2 * t78 + (t1 * t82 + t87);
        let t89 = t49 * t88;
        let t90 = t40 * two;
        let t91 = t25 * t88;
        let t92 = t48 * two;
        let t93 = t43 * two;
        let t94 = t31 * two;
        let t95 = t25 * t94;
        let t96 = t41 * t69;
        let t97 = t25 * t33;
        let t98 = t36 * t95 - t36 * t96 - t38 * t97 * two - t42 * t72;
        let t99 = t1 * t78 + (t0 * t86 - t10 * t50 - t11 * t60);
        let t100 = t12 * t55 + ((t81 + (-t80 - t79)) * (t2 * t74) + t99);
        let t101 = t49 * t100;
        let t102 = t25 * t100;
        let t103 = t93 * (t38 * t49) + (t98 - t90 * t101 - t92 * t102);
        let t104 = t44 * two;
        let t105 = t25 * t34;
        let t106 = t36 * t66 - t43 * t70 - t38 * t96 - t30 * t105 * two;
        let t107 = (t77 + (-t76 - t75)) * (t3 * t74)
            + (t0 * t82 - t12 * t50 - t10 * t55);
        let t108 = t13 * t60 + (t2 * t86 + t107);
        let t109 = t49 * t108;
        let t110 = t25 * t108;
        let t111 = t42 * two;
        let t112 = t25 * t32;
        let t113 = t111 * (t36 * t49) - t36 * t112 * two - t44 * t71;
        let t114 = t3 * t82 + (t0 * t78 - t13 * t55 - t10 * t60);
        let t115 = t11 * t50 + ((t85 + (-t84 - t83)) * (t1 * t74) + t114);
        let t116 = t49 * t115;
        let t117 = t25 * t115;
        let t118 = t38 * t68 + (t113 - t30 * t96 - t90 * t116 - t92 * t117);
        let t119 = t25 * t35 - t45 * t49;
        let t120 = t28 * two;
        let t121 = t25 * t39 - t47 * t49;
        let t122 = t27 * two;
        let t123 = t25 * t37 - t46 * t49;
        let t124 = t29 * two;
        let t125 = t7 * t60 + (t8 * t50 + t6 * t55);
        let t126 = t49 * t125;
        let t127 = t25 * t125;
        let t128 = t121 * t122 + (t123 * t124 - t90 * t126 - t92 * t127);
        let t129 = t26 * two;
        let t130 = t6 * t60 + (t5 * t50 - t7 * t55);
        let t131 = t49 * t130;
        let t132 = t25 * t130;
        let t133 = t123 * t129 - t121 * t120 - t90 * t131 - t92 * t132;
        let t134 = t5 * t55 + (t7 * t50 - t8 * t60);
        let t135 = t49 * t134;
        let t136 = t25 * t134;
        let t137 = t121 * t129 - t124 * t119 - t90 * t135 - t92 * t136;
        let t138 = t5 * t60 + (t8 * t55 - t6 * t50);
        let t139 = t49 * t138;
        let t140 = t25 * t138;
        let t141 = t119 * t129 - t123 * t122 - t90 * t139 - t92 * t140;
        let t142 = t48 * lambda[0];
        let t143 = t40 * lambda[0];
        let t144 = t51 * t142 - t53 * t143;
        let t145 = t50 * t144;
        let t146 = t56 * t142 - t58 * t143;
        let t147 = t50 * t146;
        let t148 = t55 * t146;
        let t149 = t61 * t142 - t63 * t143;
        let t150 = t50 * t149;
        let t151 = t55 * t149;
        let t152 = t60 * t149;
        let t153 = t150 * two;
        let t154 = t12 * t153;
        let t155 = t30 * lambda[0];
        let t156 = t53 * t155;
        let t157 = t38 * lambda[0];
        let t158 = t53 * t157;
        let t159 = t36 * lambda[0];
        let t160 = t53 * t159;
        let t161 = t51 * t155;
        let t162 = t33 * two;
        let t163 = t51 * t157;
        let t164 = t32 * two;
        let t165 = t51 * t159;
        let t166 = t34 * two;
        let t167 = t147 * two;
        let t168 = t11 * t167;
        let t169 = t145 * two;
        let t170 = h[18] * t144;
        let t171 = h[18] * (t25 * t142 + t49 * t143);
        let t172 = t19 * t170 - t171;
        let t173 = t3 * two;
        let t174 = t23 * t170;
        let t175 = t1 * two;
        let t176 = t15 * t170;
        let t177 = t2 * two;
        let t178 = t13 * t169 - t172 * t173 - t174 * t175 - t176 * t177;
        let t179 = t161 * t162 + (t163 * t164 + (t165 * t166 + (t168 + t178)));
        let t180 = t13 * t167;
        let t181 = t58 * t155;
        let t182 = t58 * t157;
        let t183 = t58 * t159;
        let t184 = t56 * t155;
        let t185 = t56 * t157;
        let t186 = t56 * t159;
        let t187 = t151 * two;
        let t188 = t12 * t187;
        let t189 = t148 * two;
        let t190 = h[18] * t146;
        let t191 = t19 * t190;
        let t192 = t23 * t190 - t171;
        let t193 = t15 * t190;
        let t194 = t11 * t189 - t173 * t191 - t175 * t192 - t177 * t193;
        let t195 = t162 * t184 + (t164 * t185 + (t166 * t186 + (t188 + t194)));
        let t196 = t11 * t187;
        let t197 = t63 * t155;
        let t198 = t63 * t157;
        let t199 = t63 * t159;
        let t200 = t61 * t155;
        let t201 = t61 * t157;
        let t202 = t61 * t159;
        let t203 = t152 * two;
        let t204 = t13 * t153;
        let t205 = h[18] * t149;
        let t206 = t19 * t205;
        let t207 = t23 * t205;
        let t208 = t15 * t205 - t171;
        let t209 = t12 * t203 + (t204 - t173 * t206 - t175 * t207 - t177 * t208);
        let t210 = t104 * t199 + (t162 * t200 + (t164 * t201 + (t166 * t202 + t209)));
        let t211 = t23 * t171 * two;
        let t212 = h[10] * t211;
        let t213 = t49 * t157 * two;
        let t214 = h[1] * t213;
        let t215 = t20 * t171 * two;
        let t216 = h[13] * t215;
        let t217 = t25 * t157 * two;
        let t218 = h[4] * t217;
        let t219 = -t212 - t214 + (t216 + t218);
        let t220 = t15 * t171 * two;
        let t221 = h[11] * t220;
        let t222 = t49 * t155 * two;
        let t223 = h[2] * t222;
        let t224 = t4 * t171 * two;
        let t225 = h[14] * t224;
        let t226 = t25 * t155 * two;
        let t227 = h[5] * t226;
        let t228 = -t221 - t223 + (t225 + t227);
        let t229 = t25 * t159 * two;
        let t230 = h[3] * t229;
        let t231 = t19 * t171 * two;
        let t232 = h[9] * t231;
        let t233 = t16 * t171 * two;
        let t234 = h[12] * t233;
        let t235 = t49 * t159 * two;
        let t236 = h[0] * t235;
        let t237 = t230 - t232 + (t234 - t236);
        let t238 = t2 * t171;
        let t239 = t25 * (t43 * t155 + (t44 * t159 + t42 * t157)) - t89 * t142;
        let t240 = t49 * (t33 * t155 + (t34 * t159 + t32 * t157)) + t239;
        let t241 = t91 * t143 + t240;
        let t242 = t238 + t60 * t241;
        let t243 = t242 * k4;
        let t244 = t1 * t171;
        let t245 = t55 * t241 + t244;
        let t246 = t11 * k4;
        let t247 = t3 * t171;
        let t248 = t50 * t241 + t247;
        let t249 = t13 * k4;
        let t250 = t13 * t171;
        let t251 = t86 * t241 - t250;
        let t252 = t3 * k4;
        let t253 = t11 * t171;
        let t254 = t82 * t241 - t253;
        let t255 = t1 * k4;
        let t256 = t12 * t171;
        let t257 = t78 * t241 - t256;
        let t258 = t2 * k4;
        let t259 = t248 * t249 - t251 * t252 - t254 * t255 - t257 * t258;
        let t260 = t89 * t159;
        let t261 = t34 * k4;
        let t262 = t89 * t157;
        let t263 = t32 * k4;
        let t264 = t89 * t155;
        let t265 = t33 * k4;
        let t266 = t91 * t159;
        let t267 = t44 * k4;
        let t268 = t259 - t260 * t261 - t262 * t263 - t264 * t265 - t266 * t267;
        let t269 = t91 * t157;
        let t270 = t42 * k4;
        let t271 = t91 * t155;
        let t272 = t43 * k4;
        let t273 = t12 * t243 + (t245 * t246 + (t268 - t269 * t270 - t271 * t272));
        let t274 = t41 * two;
        let t275 = t11 * t153;
        let t276 = t0 * two;
        let t277 = t12 * t167;
        let t278 = t174 * t177 - t172 * t276 - t175 * t176 - t277 - t163 * t162;
        let t279 = t94 * t165 + (t275 + (t10 * t169 + (t278 - t93 * t158)));
        let t280 = t10 * t167;
        let t281 = t196 - t191 * t276 - t175 * t193 - t12 * t148 * two;
        let t282 = t94 * t186 + (t177 * t192 + (t281 - t162 * t185 - t93 * t182));
        let t283 = t10 * t153;
        let t284 = t177 * t207 - t206 * t276 - t175 * t208 - t188 - t162 * t201;
        let t285 = t164 * t200 + (t94 * t202 + (t11 * t203 + (t284 - t93 * t198)));
        let t286 = -(h[10] * t220) - h[1] * t222 + (h[13] * t224 + h[4] * t226);
        let t287 = t10 * k4;
        let t288 = h[11] * t211;
        let t289 = h[2] * t213;
        let t290 = t0 * k4;
        let t291 = t12 * k4;
        let t292 = t31 * k4;
        let t293 = t289 - t251 * t290 - t255 * t257 - t245 * t291 - t260 * t292;
        let t294 = t41 * k4;
        let t295 = h[5] * t217;
        let t296 = t293 - t263 * t264 - t266 * t294 - t270 * t271 - t295;
        let t297 = h[14] * t215;
        let t298 = t11 * t243 + (t248 * t287 + (t254 * t258 + (t288 + (t296 - t297))));
        let t299 = -t216 - t218 + (t212 + t214);
        let t300 = -t225 - t227 + (t221 + t223);
        let t301 = t102 * t157;
        let t302 = t101 * t157;
        let t303 = t25 * (t42 * t155 + (t41 * t159 - t43 * t157)) - t101 * t142;
        let t304 = t49 * (t32 * t155 + (t31 * t159 - t33 * t157)) + t303;
        let t305 = t102 * t143 + t304;
        let t306 = t244 + t60 * t305;
        let t307 = t0 * t171;
        let t308 = t50 * t305 + t307;
        let t309 = t256 + t82 * t305;
        let t310 = t10 * t171;
        let t311 = t86 * t305 - t310;
        let t312 = t78 * t305 - t253;
        let t313 = t55 * t305 - t238;
        let t314 = t101 * t159;
        let t315 = t237 - t290 * t311 - t255 * t312 - t291 * t313 - t292 * t314;
        let t316 = t101 * t155;
        let t317 = t102 * t159;
        let t318 = t102 * t155;
        let t319 = t258 * t309 + (t315 - t263 * t316 - t294 * t317 - t270 * t318);
        let t320 = t272 * t301 + (t265 * t302 + (t246 * t306 + (t287 * t308 + t319)));
        let t321 = t280 - t174 * t276 - t172 * t177 - t204 - t166 * t161;
        let t322 = t94 * t163 + (t12 * t169 + (t173 * t176 + (t321 - t104 * t156)));
        let t323 = t13 * t187;
        let t324 = t173 * t193 - t192 * t276 - t177 * t191 - t323 - t166 * t184;
        let t325 = t94 * t185 + (t277 + (t10 * t189 + (t324 - t104 * t181)));
        let t326 = t10 * t187;
        let t327 = t154 - t207 * t276 - t177 * t206 - t13 * t152 * two;
        let t328 = t94 * t201 + (t173 * t208 + (t327 - t166 * t200 - t104 * t197));
        let t329 = -(h[11] * t231) - h[2] * t235 + (h[14] * t233 + h[5] * t229);
        let t330 = h[9] * t220;
        let t331 = h[0] * t222;
        let t332 = t331 - t254 * t290 - t251 * t258 - t249 * t242 - t262 * t292;
        let t333 = h[3] * t226;
        let t334 = t332 - t260 * t265 - t269 * t294 - t266 * t272 - t333;
        let t335 = h[12] * t224;
        let t336 = t248 * t291 + (t245 * t287 + (t252 * t257 + (t330 + (t334 - t335))));
        let t337 = -(h[9] * t211) - h[0] * t213 + (h[12] * t215 + h[3] * t217);
        let t338 = h[13] * t233;
        let t339 = h[4] * t229;
        let t340 = t339 - t290 * t309 - t258 * t311 - t249 * t306 - t292 * t302;
        let t341 = h[1] * t235;
        let t342 = t340 - t265 * t314 - t294 * t301 - t272 * t317 - t341;
        let t343 = h[10] * t231;
        let t344 = t291 * t308 + (t287 * t313 + (t252 * t312 + (t338 + (t342 - t343))));
        let t345 = -t234 - t230 + (t232 + t236);
        let t346 = t110 * t155;
        let t347 = t109 * t155;
        let t348 = t25 * (t41 * t157 + (t43 * t159 - t44 * t155)) - t109 * t142;
        let t349 = t49 * (t31 * t157 + (t33 * t159 - t34 * t155)) + t348;
        let t350 = t110 * t143 + t349;
        let t351 = t238 + t50 * t350;
        let t352 = t307 + t55 * t350;
        let t353 = t250 + t78 * t350;
        let t354 = t82 * t350 - t310;
        let t355 = t86 * t350 - t256;
        let t356 = t60 * t350 - t247;
        let t357 = t219 + t300 - t290 * t354 - t258 * t355 - t249 * t356;
        let t358 = t109 * t157;
        let t359 = t109 * t159;
        let t360 = t110 * t157;
        let t361 = t110 * t159;
        let t362 = t357 - t292 * t358 - t265 * t359 - t294 * t360 - t272 * t361;
        let t363 = t261 * t347 + (t291 * t351 + (t287 * t352 + (t252 * t353 + t362)));
        let t364 = t180 + t283 - t176 * t276 - t173 * t174 - t11 * t145 * two;
        let t365 = t94 * t161 + (t172 * t175 + (t364 - t165 * t164 - t111 * t160));
        let t366 = t326 - t193 * t276 - t173 * t192 - t168 - t164 * t186;
        let t367 = t94 * t184 + (t13 * t189 + (t175 * t191 + (t366 - t111 * t183)));
        let t368 = t175 * t206 - t208 * t276 - t173 * t207 - t275 - t164 * t202;
        let t369 = t94 * t200 + (t323 + (t10 * t203 + (t368 - t111 * t199)));
        let t370 = t337 - t257 * t290 - t252 * t254 - t248 * t246 - t264 * t292;
        let t371 = t370 - t261 * t262 - t271 * t294 - t267 * t269 - t339;
        let t372 = t242 * t287 + (t251 * t255 + (t343 + (t341 + (t371 - t338))));
        let t373 = t329 - t290 * t312 - t252 * t309 - t246 * t308 - t292 * t316;
        let t374 = t373 - t261 * t302 - t294 * t318 - t267 * t301 - t331;
        let t375 = t287 * t306 + (t255 * t311 + (t335 + (t333 + (t374 - t330))));
        let t376 = t286 - t290 * t353 - t252 * t354 - t246 * t351 - t292 * t347;
        let t377 = t376 - t261 * t358 - t294 * t346 - t267 * t360 - t289;
        let t378 = t287 * t356 + (t255 * t355 + (t297 + (t295 + (t377 - t288))));
        let t379 = t25 * (t41 * t155 + (t44 * t157 - t42 * t159)) - t116 * t142;
        let t380 = t49 * (t31 * t155 + (t34 * t157 - t32 * t159)) + t379;
        let t381 = t117 * t143 + t380;
        let t382 = t247 + t55 * t381;
        let t383 = t307 + t60 * t381;
        let t384 = t345 + (t228 + t299) - t290 * (t78 * t381 - t310)
            - t252 * (t82 * t381 - t250);
        let t385 = t50 * t381 - t244;
        let t386 = t384 - t246 * t385 - t292 * (t116 * t155) - t261 * (t116 * t157);
        let t387 = t255 * (t253 + t86 * t381)
            + (t386 - t294 * (t117 * t155) - t267 * (t117 * t157));
        let t388 = t263 * (t116 * t159) + (t249 * t382 + (t287 * t383 + t387));
        let t389 = -t147;
        let t390 = -t150;
        let t391 = -t151;
        let t392 = t35 * lambda[0];
        let t393 = t45 * lambda[0];
        let t394 = t51 * t392 + t53 * t393;
        let t395 = t120 * t394;
        let t396 = t39 * lambda[0];
        let t397 = t47 * lambda[0];
        let t398 = t51 * t396 + t53 * t397;
        let t399 = t122 * t398;
        let t400 = t37 * lambda[0];
        let t401 = t46 * lambda[0];
        let t402 = t51 * t400 + t53 * t401;
        let t403 = t124 * t402;
        let t404 = t8 * two;
        let t405 = t7 * t153;
        let t406 = t6 * t167;
        let t407 = t56 * t392 + t58 * t393;
        let t408 = t120 * t407;
        let t409 = t56 * t396 + t58 * t397;
        let t410 = t122 * t409;
        let t411 = t56 * t400 + t58 * t401;
        let t412 = t124 * t411;
        let t413 = t6 * two;
        let t414 = t7 * t187;
        let t415 = t8 * t167;
        let t416 = t61 * t392 + t63 * t393;
        let t417 = t120 * t416;
        let t418 = t61 * t396 + t63 * t397;
        let t419 = t122 * t418;
        let t420 = t61 * t400 + t63 * t401;
        let t421 = t124 * t420;
        let t422 = t7 * two;
        let t423 = t6 * t187;
        let t424 = t8 * t153;
        let t425 = t49 * lambda[0];
        let t426 = t44 * t425;
        let t427 = t426 - t105 * lambda[0];
        let t428 = t427 + (t89 * t400 + t91 * t401);
        let t429 = t29 * k4;
        let t430 = t42 * t425;
        let t431 = t430 - t112 * lambda[0];
        let t432 = t431 + (t89 * t396 + t91 * t397);
        let t433 = t27 * k4;
        let t434 = t43 * t425;
        let t435 = t434 - t97 * lambda[0];
        let t436 = t435 + (t89 * t392 + t91 * t393);
        let t437 = t28 * k4;
        let t438 = t8 * k4;
        let t439 = -(t428 * t429) - t432 * t433 - t436 * t437 - t248 * t438;
        let t440 = t6 * k4;
        let t441 = t7 * k4;
        let t442 = t41 * t425 - lambda[0] * (t25 * t31);
        let t443 = t442 + (t101 * t400 + t102 * t401);
        let t444 = t25 * lambda[0];
        let t445 = t102 * t397 + (t101 * t396 + (t33 * t444 - t434));
        let t446 = t102 * t393 + (t431 + t101 * t392);
        let t447 = -(t429 * t443) - t433 * t445 - t437 * t446 - t308 * t438;
        let t448 = t110 * t401 + (t435 + t109 * t400);
        let t449 = t110 * t397 + (t442 + t109 * t396);
        let t450 = t110 * t393 + (t109 * t392 + (t34 * t444 - t426));
        let t451 = -(t429 * t448) - t433 * t449 - t437 * t450 - t351 * t438;
        let t452 = t117 * t401 + (t116 * t400 + (t32 * t444 - t430));
        let t453 = t117 * t397 + (t427 + t116 * t396);
        let t454 = t117 * t393 + (t442 + t116 * t392);
        let t455 = -(t429 * t452) - t433 * t453 - t437 * t454 - t385 * t438;
        let t456 = t119 * lambda[0] * two;
        let t457 = h[8] * t456 - h[17] * t224;
        let t458 = t121 * lambda[0] * two;
        let t459 = h[7] * t458 - h[16] * t215;
        let t460 = t123 * lambda[0] * two;
        let t461 = h[6] * t460 - h[15] * t233;
        let t462 = t126 * t400 + t127 * t401;
        let t463 = t126 * t396 + t127 * t397;
        let t464 = t126 * t392 + t127 * t393;
        let t465 = t25 * (t28 * t393 + (t29 * t401 + t27 * t397)) - t126 * t142;
        let t466 = t49 * (t28 * t392 + (t29 * t400 + t27 * t396)) + t465;
        let t467 = t127 * t143 + t466;
        let t468 = t50 * t467;
        let t469 = t461 - t429 * t462 - t433 * t463 - t437 * t464 - t438 * t468;
        let t470 = t55 * t467;
        let t471 = t60 * t467;
        let t472 = t7 * t167;
        let t473 = t122 * t394;
        let t474 = t129 * t402 - t120 * t398;
        let t475 = t5 * two;
        let t476 = t6 * t153;
        let t477 = t122 * t407;
        let t478 = t129 * t411 - t423;
        let t479 = t120 * t409;
        let t480 = t5 * t167;
        let t481 = t122 * t416;
        let t482 = t129 * t420;
        let t483 = t414 - t120 * t418;
        let t484 = t5 * t153;
        let t485 = t26 * k4;
        let t486 = t5 * k4;
        let t487 = t432 * t437 - t428 * t485 - t433 * t436 - t248 * t486;
        let t488 = t437 * t445 - t443 * t485 - t433 * t446 - t308 * t486;
        let t489 = t437 * t449 - t448 * t485 - t433 * t450 - t351 * t486;
        let t490 = t437 * t453 - t452 * t485 - t433 * t454 - t385 * t486;
        let t491 = h[7] * t456 - h[16] * t224;
        let t492 = h[17] * t215;
        let t493 = t492 - t462 * t485 - t433 * t464 - t468 * t486 - t440 * t471;
        let t494 = h[8] * t458;
        let t495 = t28 * lambda[0];
        let t496 = t25 * (t27 * t393 + (t26 * t401 - t47 * t495)) - t131 * t142;
        let t497 = t49 * (t27 * t392 + (t26 * t400 - t39 * t495)) + t496;
        let t498 = t132 * t143 + t497;
        let t499 = t55 * t498;
        let t500 = t131 * t396 + t132 * t397;
        let t501 = t131 * t400 + t132 * t401;
        let t502 = t131 * t392 + t132 * t393;
        let t503 = t50 * t498;
        let t504 = t60 * t498;
        let t505 = t461 - t485 * t501 - t433 * t502 - t486 * t503 - t440 * t504;
        let t506 = t120 * t402;
        let t507 = t129 * t398;
        let t508 = t424 - t480;
        let t509 = t124 * t394;
        let t510 = t8 * t187;
        let t511 = t120 * t411;
        let t512 = t129 * t409 - t472;
        let t513 = t124 * t407;
        let t514 = t120 * t420;
        let t515 = t129 * t418 - t405;
        let t516 = t124 * t416;
        let t517 = t5 * t187;
        let t518 = t429 * t436 - t432 * t485 - t428 * t437 - t245 * t486;
        let t519 = t429 * t446 - t445 * t485 - t437 * t443 - t313 * t486;
        let t520 = t429 * t450 - t449 * t485 - t437 * t448 - t352 * t486;
        let t521 = t429 * t454 - t453 * t485 - t437 * t452 - t382 * t486;
        let t522 = h[8] * t460 - h[17] * t233;
        let t523 = h[15] * t224;
        let t524 = t523 - t463 * t485 - t437 * t462 - t470 * t486 - t441 * t468;
        let t525 = h[6] * t456;
        let t526 = h[6] * t458 - h[15] * t215;
        let t527 = h[7] * t460;
        let t528 = t527 - t485 * t500 - t437 * t501 - t486 * t499 - t441 * t503;
        let t529 = h[16] * t233;
        let t530 = t29 * lambda[0];
        let t531 = t25 * (t28 * t401 + (t26 * t397 - t45 * t530)) - t135 * t142;
        let t532 = t49 * (t28 * t400 + (t26 * t396 - t35 * t530)) + t531;
        let t533 = t136 * t143 + t532;
        let t534 = t60 * t533;
        let t535 = t135 * t392 + t136 * t393;
        let t536 = t459 - t457;
        let t537 = t135 * t396 + t136 * t397;
        let t538 = t135 * t400 + t136 * t401;
        let t539 = t55 * t533;
        let t540 = t50 * t533;
        let t541 = t536 - t485 * t537 - t437 * t538 - t486 * t539 - t441 * t540;
        let t542 = t124 * t398;
        let t543 = t129 * t394;
        let t544 = t122 * t402;
        let t545 = t124 * t409;
        let t546 = t129 * t407;
        let t547 = t406 - t517;
        let t548 = t122 * t411;
        let t549 = t124 * t418;
        let t550 = t129 * t416;
        let t551 = t476 - t510;
        let t552 = t122 * t420;
        let t553 = t428 * t433 - t436 * t485 - t429 * t432 - t242 * t486;
        let t554 = t433 * t443 - t446 * t485 - t429 * t445 - t306 * t486;
        let t555 = t433 * t448 - t450 * t485 - t429 * t449 - t356 * t486;
        let t556 = t433 * t452 - t454 * t485 - t429 * t453 - t383 * t486;
        let t557 = t526 - t464 * t485 - t429 * t463 - t471 * t486 - t438 * t470;
        let t558 = t522 - t485 * t502 - t429 * t500 - t486 * t504 - t438 * t499;
        let t559 = t491 - t485 * t535 - t429 * t537 - t486 * t534 - t438 * t539;
        let t560 = t27 * lambda[0];
        let t561 = t25 * (t29 * t397 + (t26 * t393 - t46 * t560)) - t139 * t142;
        let t562 = t49 * (t29 * t396 + (t26 * t392 - t37 * t560)) + t561;
        let t563 = t140 * t143 + t562;
        let t564 = -t536 - t461 - t485 * (t139 * t392 + t140 * t393);
        let t565 = t564 - t429 * (t139 * t396 + t140 * t397) - t486 * (t60 * t563);
        let t566 = t433 * (t139 * t400 + t140 * t401) + (t565 - t438 * (t55 * t563));
        phi[0] = t25 * t40 - t48 * t49;
        phi_q[0] = t52 + t54;
        phi_q[1] = t57 + t59;
        phi_q[2] = t62 + t64;
        phi_q[3] = t30 * t66 + (t38 * t67 + (t73 - t89 * t90 - t91 * t92));
        phi_q[4] = t30 * t67 + t103;
        phi_q[5] = t104 * (t30 * t49) + (t38 * t95 + (t106 - t90 * t109 - t92 * t110));
        phi_q[6] = t30 * t95 + t118;
        phi_q[7] = -t52 - t54;
        phi_q[8] = -t57 - t59;
        phi_q[9] = -t62 - t64;
        phi_q[10] = t119 * t120 + t128;
        phi_q[11] = t122 * t119 + t133;
        phi_q[12] = t123 * t120 + t137;
        phi_q[13] = t124 * t121 + t141;
        curvature[0] = t145;
        curvature[1] = t147;
        curvature[2] = t148;
        curvature[3] = t150;
        curvature[4] = t151;
        curvature[5] = t152;
        curvature[6] = t154 + (t93 * t156 + (t111 * t158 + (t104 * t160 + t179)));
        curvature[7] = t180 + (t93 * t181 + (t111 * t182 + (t104 * t183 + t195)));
        curvature[8] = t196 + (t93 * t197 + (t111 * t198 + t210));
        curvature[9] = t219 + (t228 + (t237 + t273));
        curvature[10] = t111 * t156 + (t160 * t274 + (t164 * t161 + t279));
        curvature[11] = t280 + (t111 * t181 + (t183 * t274 + (t164 * t184 + t282)));
        curvature[12] = t283 + (t111 * t197 + (t199 * t274 + t285));
        curvature[13] = t286 + (t269 * t272 + (t262 * t265 + t298));
        curvature[14] = t299 + (t300 + t320);
        curvature[15] = t93 * t160 + (t158 * t274 + (t165 * t162 + t322));
        curvature[16] = t93 * t183 + (t182 * t274 + (t162 * t186 + t325));
        curvature[17] = t326 + (t93 * t199 + (t198 * t274 + (t162 * t202 + t328)));
        curvature[18] = t329 + (t267 * t271 + (t261 * t264 + t336));
        curvature[19] = t337 + (t267 * t318 + (t261 * t316 + t344));
        curvature[20] = t345 + (t267 * t346 + t363);
        curvature[21] = t104 * t158 + (t156 * t274 + (t166 * t163 + t365));
        curvature[22] = t104 * t182 + (t181 * t274 + (t166 * t185 + t367));
        curvature[23] = t104 * t198 + (t197 * t274 + (t166 * t201 + t369));
        curvature[24] = t266 * t270 + (t260 * t263 + (t249 * t245 + t372));
        curvature[25] = t270 * t317 + (t263 * t314 + (t249 * t313 + t375));
        curvature[26] = t270 * t361 + (t263 * t359 + (t249 * t352 + t378));
        curvature[27] = t270 * (t117 * t159) + t388;
        curvature[28] = -t145;
        curvature[29] = t389;
        curvature[30] = t390;
        curvature[31] = -(t248 * two);
        curvature[32] = -(t308 * two);
        curvature[33] = -(t351 * two);
        curvature[34] = -(t385 * two);
        curvature[35] = t145;
        curvature[36] = t389;
        curvature[37] = -t148;
        curvature[38] = t391;
        curvature[39] = -(t245 * two);
        curvature[40] = -(t313 * two);
        curvature[41] = -(t352 * two);
        curvature[42] = -(t382 * two);
        curvature[43] = t147;
        curvature[44] = t148;
        curvature[45] = t390;
        curvature[46] = t391;
        curvature[47] = -t152;
        curvature[48] = -(t242 * two);
        curvature[49] = -(t306 * two);
        curvature[50] = -(t356 * two);
        curvature[51] = -(t383 * two);
        curvature[52] = t150;
        curvature[53] = t151;
        curvature[54] = t152;
        curvature[55] = t395 + (t399 + (t403 - t145 * t404)) - t405 - t406;
        curvature[56] = t408 + (t410 + (t412 - t148 * t413)) - t414 - t415;
        curvature[57] = t417 + (t419 + (t421 - t152 * t422)) - t423 - t424;
        curvature[58] = t439 - t245 * t440 - t242 * t441;
        curvature[59] = t447 - t313 * t440 - t306 * t441;
        curvature[60] = t451 - t352 * t440 - t356 * t441;
        curvature[61] = t455 - t382 * t440 - t383 * t441;
        curvature[62] = t406 + (t405 + (t8 * t169 - t403 - t399 - t395));
        curvature[63] = t415 + (t414 + (t6 * t189 - t412 - t410 - t408));
        curvature[64] = t424 + (t423 + (t7 * t203 - t421 - t419 - t417));
        curvature[65] = t457 + (t459 + (t469 - t440 * t470 - t441 * t471));
        curvature[66] = t472 + (t473 + (t474 - t145 * t475)) - t476;
        curvature[67] = t7 * t189 + (t477 + (t478 - t479)) - t480;
        curvature[68] = t481 + (t482 + (t483 - t152 * t413)) - t484;
        curvature[69] = t245 * t441 + (t487 - t242 * t440);
        curvature[70] = t313 * t441 + (t488 - t306 * t440);
        curvature[71] = t352 * t441 + (t489 - t356 * t440);
        curvature[72] = t382 * t441 + (t490 - t383 * t440);
        curvature[73] = t476 + (t5 * t169 + (-t474 - t473)) - t472;
        curvature[74] = t480 + (t479 + (-t478 - t477 - t148 * t422));
        curvature[75] = t484 + (t6 * t203 + (-t483 - t482 - t481));
        curvature[76] = t491 + (t441 * t470 + (t437 * t463 + (t493 - t494)));
        curvature[77] = t441 * t499 + (t437 * t500 + t505) - t459 - t457;
        curvature[78] = t506 + (t507 + (t508 - t509 - t145 * t422));
        curvature[79] = t510 + (t511 + (t512 - t513 - t148 * t475));
        curvature[80] = t8 * t203 + (t514 + (t515 - t516)) - t517;
        curvature[81] = t242 * t438 + (t518 - t248 * t441);
        curvature[82] = t306 * t438 + (t519 - t308 * t441);
        curvature[83] = t356 * t438 + (t520 - t351 * t441);
        curvature[84] = t383 * t438 + (t521 - t385 * t441);
        curvature[85] = t7 * t169 + (t509 + (-t508 - t507 - t506));
        curvature[86] = t5 * t189 + (t513 + (-t512 - t511)) - t510;
        curvature[87] = t517 + (t516 + (-t515 - t514 - t152 * t404));
        curvature[88] = t522 + (t438 * t471 + (t429 * t464 + (t524 - t525)));
        curvature[89] = t526 + (t438 * t504 + (t429 * t502 + (t528 - t529)));
        curvature[90] = t438 * t534 + (t429 * t535 + t541) - t461;
        curvature[91] = t6 * t169 + (t542 + (t543 - t415 - t484 - t544));
        curvature[92] = t545 + (t546 + (t547 - t548 - t148 * t404));
        curvature[93] = t549 + (t550 + (t551 - t552 - t152 * t475));
        curvature[94] = t248 * t440 + (t553 - t245 * t438);
        curvature[95] = t308 * t440 + (t554 - t313 * t438);
        curvature[96] = t351 * t440 + (t555 - t352 * t438);
        curvature[97] = t385 * t440 + (t556 - t382 * t438);
        curvature[98] = t544 + (t415 + t484 - t543 - t542 - t145 * t413);
        curvature[99] = t8 * t189 + (t548 + (-t547 - t546 - t545));
        curvature[100] = t5 * t203 + (t552 + (-t551 - t550 - t549));
        curvature[101] = t440 * t468 + (t433 * t462 + (t529 + (t557 - t527)));
        curvature[102] = t440 * t503 + (t433 * t501 + (t525 + (t558 - t523)));
        curvature[103] = t440 * t540 + (t433 * t538 + (t494 + (t559 - t492)));
        curvature[104] = t440 * (t50 * t563) + t566;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 1486 additions, 2154 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 19],
        lambda: &[S; 1],
        phi_h: &mut [S; 19],
        force_h: &mut [S; 266],
    ) {
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let k4 = S::from_f64(4.0);
        let t0 = h[11] * q_i[6] + (q_i[4] * h[9] + h[10] * q_i[5]);
        let t1 = q_i[6] * h[9] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t2 = q_i[4] * h[10] + (h[11] * q_i[3] - h[9] * q_i[5]);
        let t3 = h[11] * q_i[5] + (q_i[3] * h[9] - h[10] * q_i[6]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = h[17] * q_j[6] + (q_j[4] * h[15] + h[16] * q_j[5]);
        let t6 = q_j[6] * h[15] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t7 = q_j[4] * h[16] + (h[17] * q_j[3] - h[15] * q_j[5]);
        let t8 = h[17] * q_j[5] + (q_j[3] * h[15] - h[16] * q_j[6]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[6] * h[14] + (q_i[4] * h[12] + q_i[5] * h[13]);
        let t11 = q_i[6] * h[12] + (q_i[3] * h[13] - q_i[4] * h[14]);
        let t12 = q_i[4] * h[13] + (q_i[3] * h[14] - q_i[5] * h[12]);
        let t13 = q_i[5] * h[14] + (q_i[3] * h[12] - q_i[6] * h[13]);
        let t14 = q_i[6] * t10 + (q_i[4] * t11 + (q_i[3] * t12 - q_i[5] * t13));
        let t15 = q_j[2] + t9 - q_i[2] - t14;
        let t16 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t17 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t18 = q_i[5] * t12 + (q_i[4] * t10 + (q_i[3] * t13 - q_i[6] * t11));
        let t19 = q_j[0] + t17 - q_i[0] - t18;
        let t20 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t21 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        let t22 = q_i[6] * t13 + (q_i[5] * t10 + (q_i[3] * t11 - q_i[4] * t12));
        let t23 = q_j[1] + t21 - q_i[1] - t22;
        let t24 = t4 * t15 + (t16 * t19 + t20 * t23);
        let t25 = h[18] * t24;
        let t26 = t25.sin();
        let t27 = t26 * two;
        let t28 = q_j[5] * h[8] + (q_j[3] * h[6] - q_j[6] * h[7]);
        let t29 = q_j[6] * h[8] + (q_j[4] * h[6] + q_j[5] * h[7]);
        let t30 = q_j[6] * h[6] + (q_j[3] * h[7] - q_j[4] * h[8]);
        let t31 = q_j[4] * h[7] + (q_j[3] * h[8] - q_j[5] * h[6]);
        let t32 = q_j[6] * t28 + (q_j[5] * t29 + (q_j[3] * t30 - q_j[4] * t31));
        let t33 = q_i[3] * q_i[6];
        let t34 = q_i[4] * q_i[5];
        let t35 = t33 + t34;
        let t36 = t32 * t35;
        let t37 = q_j[6] * t29 + (q_j[4] * t30 + (q_j[3] * t31 - q_j[5] * t28));
        let t38 = q_i[4] * q_i[6];
        let t39 = q_i[3] * q_i[5];
        let t40 = t38 - t39;
        let t41 = t37 * t40;
        let t42 = q_j[5] * t31 + (q_j[4] * t29 + (q_j[3] * t28 - q_j[6] * t30));
        let t43 = q_i[3] * q_i[3];
        let t44 = q_i[4] * q_i[4];
        let t45 = q_i[6] * q_i[6];
        let t46 = q_i[5] * q_i[5];
        let t47 = t43 + t44 - t45 - t46;
        let t48 = t42 * t47;
        let t49 = t34 - t33;
        let t50 = t42 * t49;
        let t51 = q_i[4] * q_i[3];
        let t52 = q_i[6] * q_i[5];
        let t53 = t51 + t52;
        let t54 = t37 * t53;
        let t55 = t43 - t44;
        let t56 = t46 - t45;
        let t57 = t55 + t56;
        let t58 = t32 * t57;
        let t59 = t39 + t38;
        let t60 = t42 * t59;
        let t61 = t52 - t51;
        let t62 = t32 * t61;
        let t63 = t55 - t56;
        let t64 = t37 * t63;
        let t65 = t25.cos();
        let t66 = t65 * two;
        let t67 = q_j[3] * q_j[3];
        let t68 = q_j[4] * q_j[4];
        let t69 = q_j[6] * q_j[6];
        let t70 = q_j[5] * q_j[5];
        let t71 = t67 + t68 - t69 - t70;
        let t72 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t73 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t74 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t75 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t76 = q_i[5] * t72 + (q_i[4] * t73 + (q_i[3] * t74 - q_i[6] * t75));
        let t77 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t78 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t79 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t80 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t81 = q_i[5] * t77 + (q_i[4] * t78 + (q_i[3] * t79 - q_i[6] * t80));
        let t82 = t65 * t76 - t26 * t81;
        let t83 = q_i[6] * t74 + (q_i[5] * t73 + (q_i[3] * t75 - q_i[4] * t72));
        let t84 = q_i[6] * t79 + (q_i[5] * t78 + (q_i[3] * t80 - q_i[4] * t77));
        let t85 = t65 * t83 - t26 * t84;
        let t86 = q_j[3] * q_j[6];
        let t87 = q_j[4] * q_j[5];
        let t88 = t86 + t87;
        let t89 = t88 * two;
        let t90 = q_i[6] * t73 + (q_i[4] * t75 + (q_i[3] * t72 - q_i[5] * t74));
        let t91 = q_i[6] * t78 + (q_i[4] * t80 + (q_i[3] * t77 - q_i[5] * t79));
        let t92 = t65 * t90 - t26 * t91;
        let t93 = q_j[4] * q_j[6];
        let t94 = q_j[3] * q_j[5];
        let t95 = t93 - t94;
        let t96 = t95 * two;
        let t97 = t67 - t68;
        let t98 = t70 - t69;
        let t99 = t97 + t98;
        let t100 = t87 - t86;
        let t101 = t82 * two;
        let t102 = q_j[4] * q_j[3];
        let t103 = q_j[6] * q_j[5];
        let t104 = t102 + t103;
        let t105 = t97 - t98;
        let t106 = t94 + t93;
        let t107 = t103 - t102;
        let t108 = t9 * two + (q_j[2] * two - q_i[2] * two - t14 * two);
        let t109 = h[18] * t108;
        let t110 = h[18] * t19;
        let t111 = t21 * two + (q_j[1] * two - q_i[1] * two - t22 * two);
        let t112 = h[18] * t111;
        let t113 = t40 * t109 + (t47 * t110 + t35 * t112);
        let t114 = t26 * t113;
        let t115 = t37 * t90 + (t42 * t76 + t32 * t83);
        let t116 = t65 * t113;
        let t117 = t37 * t91 + (t42 * t81 + t32 * t84);
        let t118 = h[18] * half;
        let t119 = t108 * t118;
        let t120 = t17 * two + (q_j[0] * two - q_i[0] * two - t18 * two);
        let t121 = t120 * t118;
        let t122 = t23 * t118;
        let t123 = t53 * t119 + (t49 * t121 + t57 * t122);
        let t124 = t26 * t123;
        let t125 = t115 * two;
        let t126 = t65 * t123;
        let t127 = t117 * two;
        let t128 = t15 * t118;
        let t129 = t111 * t118;
        let t130 = t63 * t128 + (t59 * t121 + t61 * t129);
        let t131 = t26 * t130;
        let t132 = t65 * t130;
        let t133 = h[18] * t16;
        let t134 = h[18] * t20;
        let t135 = t35 * two;
        let t136 = h[18] * t4;
        let t137 = t40 * two;
        let t138 = t47 * t133 + (t134 * t135 + t136 * t137);
        let t139 = t26 * t138;
        let t140 = t65 * t138;
        let t141 = t57 * half;
        let t142 = t53 * t136 + (t134 * t141 + t49 * t133);
        let t143 = t26 * t142;
        let t144 = t65 * t142;
        let t145 = t63 * half;
        let t146 = t61 * t134 + (t136 * t145 + t59 * t133);
        let t147 = t26 * t146;
        let t148 = t65 * t146;
        let t149 = t71 * t133 + (t89 * t134 + t96 * t136);
        let t150 = t26 * t149;
        let t151 = t65 * t149;
        let t152 = t99 * half;
        let t153 = t104 * t136 + (t134 * t152 + t100 * t133);
        let t154 = t26 * t153;
        let t155 = t65 * t153;
        let t156 = t105 * half;
        let t157 = t107 * t134 + (t136 * t156 + t106 * t133);
        let t158 = t26 * t157;
        let t159 = t65 * t157;
        let t160 = t24 * t26;
        let t161 = t24 * t65;
        let t162 = t42 * lambda[0];
        let t163 = t32 * lambda[0];
        let t164 = t37 * lambda[0];
        let t165 = t47 * t162 + (t135 * t163 + t137 * t164);
        let t166 = t65 * t165;
        let t167 = t133 * t166;
        let t168 = t53 * t164 + (t141 * t163 + t49 * t162);
        let t169 = t65 * t168;
        let t170 = t133 * t169;
        let t171 = t170 * two;
        let t172 = t61 * t163 + (t145 * t164 + t59 * t162);
        let t173 = t65 * t172;
        let t174 = t133 * t173;
        let t175 = t174 * two;
        let t176 = t26 * t165;
        let t177 = t133 * t176;
        let t178 = t26 * t168;
        let t179 = t133 * t178;
        let t180 = t179 * two;
        let t181 = t26 * t172;
        let t182 = t133 * t181;
        let t183 = t182 * two;
        let t184 = t81 * lambda[0];
        let t185 = t84 * lambda[0];
        let t186 = t91 * lambda[0];
        let t187 = t76 * lambda[0];
        let t188 = t83 * lambda[0];
        let t189 = t90 * lambda[0];
        let t190 = t65 * (t71 * t184 + (t89 * t185 + t96 * t186))
            + t26 * (t71 * t187 + (t89 * t188 + t96 * t189));
        let t191 = t133 * t190;
        let t192 = t65 * (t104 * t186 + (t152 * t185 + t100 * t184))
            + t26 * (t104 * t189 + (t152 * t188 + t100 * t187));
        let t193 = t133 * t192;
        let t194 = t193 * two;
        let t195 = t65 * (t107 * t185 + (t156 * t186 + t106 * t184))
            + t26 * (t107 * t188 + (t156 * t189 + t106 * t187));
        let t196 = t133 * t195;
        let t197 = t196 * two;
        let t198 = t115 * lambda[0];
        let t199 = t117 * lambda[0];
        let t200 = t116 * t198 - t114 * t199;
        let t201 = t65 * t199 + t26 * t198;
        let t202 = h[18] * t201;
        let t203 = t47 * t202;
        let t204 = t133 * t200 + t203;
        let t205 = t126 * t198 - t124 * t199;
        let t206 = t49 * t202;
        let t207 = t133 * t205 + t206;
        let t208 = t207 * two;
        let t209 = t132 * t198 - t131 * t199;
        let t210 = t59 * t202;
        let t211 = t133 * t209 + t210;
        let t212 = t211 * two;
        let t213 = t139 * t199 - t140 * t198;
        let t214 = t133 * t213;
        let t215 = t143 * t199 - t144 * t198;
        let t216 = t133 * t215;
        let t217 = t216 * two;
        let t218 = t147 * t199 - t148 * t198;
        let t219 = t133 * t218;
        let t220 = t219 * two;
        let t221 = t151 * t198 - t150 * t199;
        let t222 = t133 * t221;
        let t223 = t155 * t198 - t154 * t199;
        let t224 = t133 * t223;
        let t225 = t224 * two;
        let t226 = t159 * t198 - t158 * t199;
        let t227 = t133 * t226;
        let t228 = t227 * two;
        let t229 = t161 * t198 - t160 * t199;
        let t230 = t133 * t229 + t16 * t201;
        let t231 = t134 * t166;
        let t232 = t134 * t169;
        let t233 = t232 * two;
        let t234 = t134 * t173;
        let t235 = t234 * two;
        let t236 = t134 * t176;
        let t237 = t134 * t178;
        let t238 = t237 * two;
        let t239 = t134 * t181;
        let t240 = t239 * two;
        let t241 = t134 * t190;
        let t242 = t134 * t192;
        let t243 = t242 * two;
        let t244 = t134 * t195;
        let t245 = t244 * two;
        let t246 = t135 * t202 + t134 * t200;
        let t247 = t141 * t202 + t134 * t205;
        let t248 = t247 * two;
        let t249 = t61 * t202;
        let t250 = t134 * t209 + t249;
        let t251 = t250 * two;
        let t252 = t134 * t213;
        let t253 = t134 * t215;
        let t254 = t253 * two;
        let t255 = t134 * t218;
        let t256 = t255 * two;
        let t257 = t134 * t221;
        let t258 = t134 * t223;
        let t259 = t258 * two;
        let t260 = t134 * t226;
        let t261 = t260 * two;
        let t262 = t134 * t229 + t20 * t201;
        let t263 = t136 * t166;
        let t264 = t136 * t169;
        let t265 = t264 * two;
        let t266 = t136 * t173;
        let t267 = t266 * two;
        let t268 = t136 * t176;
        let t269 = t136 * t178;
        let t270 = t269 * two;
        let t271 = t136 * t181;
        let t272 = t271 * two;
        let t273 = t136 * t190;
        let t274 = t136 * t192;
        let t275 = t274 * two;
        let t276 = t136 * t195;
        let t277 = t276 * two;
        let t278 = t137 * t202 + t136 * t200;
        let t279 = t53 * t202;
        let t280 = t136 * t205 + t279;
        let t281 = t280 * two;
        let t282 = t145 * t202 + t136 * t209;
        let t283 = t282 * two;
        let t284 = t136 * t213;
        let t285 = t136 * t215;
        let t286 = t285 * two;
        let t287 = t136 * t218;
        let t288 = t287 * two;
        let t289 = t136 * t221;
        let t290 = t136 * t223;
        let t291 = t290 * two;
        let t292 = t136 * t226;
        let t293 = t292 * two;
        let t294 = t136 * t229 + t4 * t201;
        let t295 = t26 * t164;
        let t296 = q_i[5] * two;
        let t297 = t295 * t296;
        let t298 = t26 * t163;
        let t299 = q_i[6] * two;
        let t300 = t298 * t299;
        let t301 = t26 * t162;
        let t302 = q_i[3] * two;
        let t303 = t301 * t302;
        let t304 = t297 + (-t300 - t303);
        let t305 = t12 * two;
        let t306 = t11 * two;
        let t307 = t13 * two;
        let t308 = t110 * t166;
        let t309 = t3 * two;
        let t310 = h[18] * t23;
        let t311 = t166 * t310;
        let t312 = t1 * two;
        let t313 = h[18] * t15;
        let t314 = t166 * t313;
        let t315 = t2 * two;
        let t316 = t167 * t307 - t308 * t309 - t311 * t312 - t314 * t315;
        let t317 = t299 * t301;
        let t318 = q_i[4] * two;
        let t319 = t295 * t318;
        let t320 = t298 * t302;
        let t321 = t317 + (-t319 - t320);
        let t322 = t12 * k4;
        let t323 = t11 * k4;
        let t324 = t13 * k4;
        let t325 = t110 * t169;
        let t326 = t3 * k4;
        let t327 = t169 * t310;
        let t328 = t1 * k4;
        let t329 = t169 * t313;
        let t330 = t2 * k4;
        let t331 = t170 * t324 - t325 * t326 - t327 * t328 - t329 * t330;
        let t332 = t298 * t318;
        let t333 = t296 * t301;
        let t334 = t295 * t302;
        let t335 = t332 + (-t333 - t334);
        let t336 = t110 * t173;
        let t337 = t173 * t310;
        let t338 = t173 * t313;
        let t339 = t174 * t324 - t326 * t336 - t328 * t337 - t330 * t338;
        let t340 = t65 * t163;
        let t341 = t299 * t340;
        let t342 = t65 * t162;
        let t343 = t302 * t342;
        let t344 = t65 * t164;
        let t345 = t296 * t344;
        let t346 = t341 + (t343 - t345);
        let t347 = t110 * t176;
        let t348 = t176 * t310;
        let t349 = t176 * t313;
        let t350 = t177 * t307 - t309 * t347 - t312 * t348 - t315 * t349;
        let t351 = t318 * t344;
        let t352 = t302 * t340;
        let t353 = t299 * t342;
        let t354 = t351 + (t352 - t353);
        let t355 = t110 * t178;
        let t356 = t178 * t310;
        let t357 = t178 * t313;
        let t358 = t179 * t324 - t326 * t355 - t328 * t356 - t330 * t357;
        let t359 = t296 * t342;
        let t360 = t302 * t344 - t318 * t340;
        let t361 = t359 + t360;
        let t362 = t110 * t181;
        let t363 = t181 * t310;
        let t364 = t181 * t313;
        let t365 = t182 * t324 - t326 * t362 - t328 * t363 - t330 * t364;
        let t366 = t65 * lambda[0];
        let t367 = t95 * t366;
        let t368 = t72 * k4;
        let t369 = t88 * t366;
        let t370 = t75 * k4;
        let t371 = t71 * t366;
        let t372 = t74 * two;
        let t373 = t26 * lambda[0];
        let t374 = t88 * t373;
        let t375 = t80 * k4;
        let t376 = t95 * t373;
        let t377 = t77 * k4;
        let t378 = t110 * t190;
        let t379 = t191 * t307 - t374 * t375 - t376 * t377 - t309 * t378;
        let t380 = t190 * t310;
        let t381 = t190 * t313;
        let t382 = t71 * t373;
        let t383 = t79 * two;
        let t384 = t241 * t306 + (t379 - t312 * t380 - t315 * t381 - t382 * t383);
        let t385 = t104 * t366;
        let t386 = t100 * t366;
        let t387 = t74 * k4;
        let t388 = t99 * t366;
        let t389 = t75 * two;
        let t390 = t110 * t192;
        let t391 = t192 * t310;
        let t392 = t192 * t313;
        let t393 = t388 * t389 - t326 * t390 - t328 * t391 - t330 * t392;
        let t394 = t100 * t373;
        let t395 = t79 * k4;
        let t396 = t104 * t373;
        let t397 = t99 * t373;
        let t398 = t80 * two;
        let t399 = t193 * t324 + (t393 - t394 * t395 - t377 * t396 - t397 * t398);
        let t400 = t107 * t366;
        let t401 = t106 * t366;
        let t402 = t105 * t366;
        let t403 = t72 * two;
        let t404 = t110 * t195;
        let t405 = t195 * t310;
        let t406 = t195 * t313;
        let t407 = t402 * t403 - t326 * t404 - t328 * t405 - t330 * t406;
        let t408 = t106 * t373;
        let t409 = t107 * t373;
        let t410 = t105 * t373;
        let t411 = t77 * two;
        let t412 = t196 * t324 + (t407 - t395 * t408 - t375 * t409 - t410 * t411);
        let t413 = t15 * t202;
        let t414 = t296 * t413;
        let t415 = t23 * t202;
        let t416 = t299 * t415;
        let t417 = t19 * t202;
        let t418 = t302 * t417;
        let t419 = t414 - t416 - t418;
        let t420 = t110 * t200;
        let t421 = t200 * t310;
        let t422 = t200 * t313;
        let t423 = t204 * t307 - t309 * t420 - t312 * t421 - t315 * t422;
        let t424 = t114 * t162;
        let t425 = t114 * t163;
        let t426 = t114 * t164;
        let t427 = t116 * t162;
        let t428 = t423 - t372 * t424 - t389 * t425 - t403 * t426 - t383 * t427;
        let t429 = t116 * t163;
        let t430 = t116 * t164;
        let t431 = t278 * t305 + (t246 * t306 + (t428 - t398 * t429 - t411 * t430));
        let t432 = t299 * t417;
        let t433 = t318 * t413;
        let t434 = t302 * t415;
        let t435 = t432 + (-t433 - t434);
        let t436 = t110 * t205;
        let t437 = t205 * t310;
        let t438 = t205 * t313;
        let t439 = t207 * t324 - t326 * t436 - t328 * t437 - t330 * t438;
        let t440 = t124 * t162;
        let t441 = t124 * t163;
        let t442 = t124 * t164;
        let t443 = t126 * t162;
        let t444 = t439 - t387 * t440 - t370 * t441 - t368 * t442 - t395 * t443;
        let t445 = t126 * t163;
        let t446 = t126 * t164;
        let t447 = t280 * t322 + (t247 * t323 + (t444 - t375 * t445 - t377 * t446));
        let t448 = t318 * t415;
        let t449 = t296 * t417;
        let t450 = t302 * t413;
        let t451 = t448 + (-t449 - t450);
        let t452 = t110 * t209;
        let t453 = t209 * t310;
        let t454 = t209 * t313;
        let t455 = t211 * t324 - t326 * t452 - t328 * t453 - t330 * t454;
        let t456 = t131 * t162;
        let t457 = t131 * t163;
        let t458 = t131 * t164;
        let t459 = t132 * t162;
        let t460 = t455 - t387 * t456 - t370 * t457 - t368 * t458 - t395 * t459;
        let t461 = t132 * t163;
        let t462 = t132 * t164;
        let t463 = t282 * t322 + (t250 * t323 + (t460 - t375 * t461 - t377 * t462));
        let t464 = t20 * t202;
        let t465 = t299 * t464;
        let t466 = t16 * t202;
        let t467 = t302 * t466;
        let t468 = t4 * t202;
        let t469 = t296 * t468;
        let t470 = t465 + (t467 - t469);
        let t471 = t140 * t164;
        let t472 = t140 * t163;
        let t473 = t140 * t162;
        let t474 = t139 * t164;
        let t475 = t139 * t163;
        let t476 = t139 * t162;
        let t477 = t122 * t213 - t35 * t202;
        let t478 = t128 * t213 - t40 * t202;
        let t479 = t110 * t213 - t203;
        let t480 = t214 * t307 - t328 * t477 - t330 * t478 - t309 * t479;
        let t481 = t389 * t475 + (t372 * t476 + (t284 * t305 + (t252 * t306 + t480)));
        let t482 = t411 * t471 + (t398 * t472 + (t383 * t473 + (t403 * t474 + t481)));
        let t483 = t318 * t468;
        let t484 = t302 * t464;
        let t485 = t299 * t466;
        let t486 = t483 + (t484 - t485);
        let t487 = t144 * t164;
        let t488 = t144 * t163;
        let t489 = t144 * t162;
        let t490 = t143 * t164;
        let t491 = t143 * t163;
        let t492 = t143 * t162;
        let t493 = t121 * t215 - t206;
        let t494 = t119 * t215 - t279;
        let t495 = t112 * t215 - t57 * t202;
        let t496 = t216 * t324 - t326 * t493 - t330 * t494 - t312 * t495;
        let t497 = t370 * t491 + (t387 * t492 + (t285 * t322 + (t253 * t323 + t496)));
        let t498 = t377 * t487 + (t375 * t488 + (t395 * t489 + (t368 * t490 + t497)));
        let t499 = t296 * t466;
        let t500 = t302 * t468;
        let t501 = t318 * t464;
        let t502 = t499 + (t500 - t501);
        let t503 = t148 * t164;
        let t504 = t148 * t163;
        let t505 = t148 * t162;
        let t506 = t147 * t164;
        let t507 = t147 * t163;
        let t508 = t147 * t162;
        let t509 = t121 * t218 - t210;
        let t510 = t129 * t218 - t249;
        let t511 = t109 * t218 - t63 * t202;
        let t512 = t219 * t324 - t326 * t509 - t328 * t510 - t315 * t511;
        let t513 = t370 * t507 + (t387 * t508 + (t287 * t322 + (t255 * t323 + t512)));
        let t514 = t377 * t503 + (t375 * t504 + (t395 * t505 + (t368 * t506 + t513)));
        let t515 = t122 * t221 + t88 * t202;
        let t516 = t128 * t221 + t95 * t202;
        let t517 = t71 * t202 + t110 * t221;
        let t518 = t222 * t307 - t328 * t515 - t330 * t516 - t309 * t517;
        let t519 = t150 * t162;
        let t520 = t150 * t163;
        let t521 = t150 * t164;
        let t522 = t151 * t162;
        let t523 = t518 - t372 * t519 - t389 * t520 - t403 * t521 - t383 * t522;
        let t524 = t151 * t163;
        let t525 = t151 * t164;
        let t526 = t121 * t223 + t100 * t202;
        let t527 = t119 * t223 + t104 * t202;
        let t528 = t154 * t162;
        let t529 = t224 * t324 - t326 * t526 - t330 * t527 - t387 * t528;
        let t530 = t154 * t163;
        let t531 = t154 * t164;
        let t532 = t155 * t162;
        let t533 = t155 * t163;
        let t534 = t529 - t370 * t530 - t368 * t531 - t395 * t532 - t375 * t533;
        let t535 = t155 * t164;
        let t536 = t99 * t202 + t112 * t223;
        let t537 = t121 * t226 + t106 * t202;
        let t538 = t129 * t226 + t107 * t202;
        let t539 = t158 * t162;
        let t540 = t227 * t324 - t326 * t537 - t328 * t538 - t387 * t539;
        let t541 = t158 * t163;
        let t542 = t158 * t164;
        let t543 = t159 * t162;
        let t544 = t159 * t163;
        let t545 = t540 - t370 * t541 - t368 * t542 - t395 * t543 - t375 * t544;
        let t546 = t159 * t164;
        let t547 = t105 * t202 + t109 * t226;
        let t548 = t110 * t229 + t19 * t201;
        let t549 = t229 * t310 + t23 * t201;
        let t550 = t229 * t313 + t15 * t201;
        let t551 = t230 * t307 - t309 * t548 - t312 * t549 - t315 * t550;
        let t552 = t160 * t162;
        let t553 = t160 * t163;
        let t554 = t160 * t164;
        let t555 = t161 * t162;
        let t556 = t551 - t372 * t552 - t389 * t553 - t403 * t554 - t383 * t555;
        let t557 = t161 * t163;
        let t558 = t161 * t164;
        let t559 = -(t296 * t298) - t301 * t318 - t295 * t299;
        let t560 = t10 * two;
        let t561 = t0 * two;
        let t562 = t311 * t315 - t308 * t561 - t312 * t314 - t231 * t305;
        let t563 = t10 * k4;
        let t564 = t0 * k4;
        let t565 = t327 * t330 + (t335 - t325 * t564 - t328 * t329 - t232 * t322);
        let t566 = t320 - t336 * t564 - t328 * t338 - t234 * t322 - t317;
        let t567 = t299 * t344 + (t296 * t340 + t318 * t342);
        let t568 = t315 * t348 - t347 * t561 - t312 * t349 - t236 * t305;
        let t569 = t330 * t356 + (t361 - t355 * t564 - t328 * t357 - t237 * t322);
        let t570 = t353 - t362 * t564 - t328 * t364 - t239 * t322 - t352;
        let t571 = t73 * two;
        let t572 = t315 * t380 - t369 * t368 - t375 * t376 - t378 * t561;
        let t573 = t78 * two;
        let t574 = t191 * t560 + (t572 - t312 * t381 - t241 * t305 - t382 * t573);
        let t575 = t73 * k4;
        let t576 = t397 * t411 - t390 * t564 - t328 * t392 - t242 * t322;
        let t577 = t78 * k4;
        let t578 = t330 * t391 + (t576 - t394 * t577 - t375 * t396 - t388 * t403);
        let t579 = t389 * t402 - t404 * t564 - t328 * t406 - t244 * t322;
        let t580 = t330 * t405 + (t579 - t368 * t400 - t408 * t577 - t398 * t410);
        let t581 = -(t296 * t415) - t318 * t417 - t299 * t413;
        let t582 = t315 * t421 - t420 * t561 - t312 * t422 - t246 * t305;
        let t583 = t582 - t424 * t571 - t389 * t426 - t427 * t573 - t398 * t430;
        let t584 = t411 * t429 + (t403 * t425 + (t278 * t306 + (t204 * t560 + t583)));
        let t585 = t451 - t436 * t564 - t328 * t438 - t247 * t322 - t440 * t575;
        let t586 = t330 * t437 + (t585 - t370 * t442 - t443 * t577 - t375 * t446);
        let t587 = t434 - t452 * t564 - t328 * t454 - t250 * t322 - t456 * t575;
        let t588 = t587 - t370 * t458 - t459 * t577 - t375 * t462 - t432;
        let t589 = t282 * t323 + (t211 * t563 + (t330 * t453 + (t433 + t588)));
        let t590 = t299 * t468 + (t296 * t464 + t318 * t466);
        let t591 = t214 * t560 - t328 * t478 - t479 * t561 - t252 * t305;
        let t592 = t476 * t571 + (t284 * t306 + (t591 - t403 * t475 - t411 * t472));
        let t593 = t330 * t477 + (t398 * t471 + (t473 * t573 + (t389 * t474 + t592)));
        let t594 = t502 - t493 * t564 - t328 * t494 - t253 * t322 - t368 * t491;
        let t595 = t285 * t323 + (t216 * t563 + (t315 * t495 + (t594 - t377 * t488)));
        let t596 = t485 - t509 * t564 - t255 * t322 - t368 * t507 - t377 * t504;
        let t597 = t219 * t563 + (t330 * t510 + (t596 - t484 - t483 - t312 * t511));
        let t598 = t505 * t577 + (t370 * t506 + (t508 * t575 + (t287 * t323 + t597)));
        let t599 = t222 * t560 - t328 * t516 - t517 * t561 - t257 * t305;
        let t600 = t599 - t519 * t571 - t389 * t521 - t522 * t573 - t398 * t525;
        let t601 = t315 * t536 - t526 * t564 - t328 * t527 - t258 * t322;
        let t602 = t601 - t528 * t575 - t370 * t531 - t532 * t577 - t375 * t535;
        let t603 = t330 * t538 - t537 * t564 - t260 * t322 - t539 * t575;
        let t604 = t603 - t370 * t542 - t543 * t577 - t375 * t546 - t312 * t547;
        let t605 = t315 * t549 - t548 * t561 - t312 * t550 - t262 * t305;
        let t606 = t605 - t552 * t571 - t389 * t554 - t555 * t573 - t398 * t558;
        let t607 = t334 - t332 - t311 * t561 - t308 * t315 - t263 * t307;
        let t608 = t326 * t329 + (t559 - t327 * t564 - t325 * t330 - t264 * t324);
        let t609 = t326 * t338 + (t304 - t337 * t564 - t330 * t336 - t266 * t324);
        let t610 = -t360 - t359 - t348 * t561 - t315 * t347 - t268 * t307;
        let t611 = t326 * t357 + (t567 - t356 * t564 - t330 * t355 - t269 * t324);
        let t612 = t326 * t364 + (t346 - t363 * t564 - t330 * t362 - t271 * t324);
        let t613 = t309 * t381 - t367 * t387 - t374 * t577 - t380 * t561;
        let t614 = t241 * t560 + (t613 - t315 * t378 - t273 * t307 - t382 * t411);
        let t615 = t388 * t571 - t391 * t564 - t330 * t390 - t274 * t324;
        let t616 = t326 * t392 + (t615 - t387 * t385 - t377 * t394 - t397 * t573);
        let t617 = t383 * t410 - t405 * t564 - t330 * t404 - t276 * t324;
        let t618 = t326 * t406 + (t617 - t409 * t577 - t377 * t408 - t372 * t402);
        let t619 = t450 - t448 - t421 * t561 - t315 * t420 - t278 * t307;
        let t620 = t619 - t425 * t571 - t403 * t424 - t429 * t573 - t411 * t427;
        let t621 = t204 * t305 + (t246 * t560 + (t309 * t422 + (t449 + t620)));
        let t622 = t581 - t437 * t564 - t330 * t436 - t280 * t324 - t441 * t575;
        let t623 = t326 * t438 + (t622 - t368 * t440 - t445 * t577 - t377 * t443);
        let t624 = t419 - t453 * t564 - t330 * t452 - t282 * t324 - t457 * t575;
        let t625 = t326 * t454 + (t624 - t368 * t456 - t461 * t577 - t377 * t459);
        let t626 = t501 - t477 * t564 - t500 - t499 - t315 * t479 - t284 * t307;
        let t627 = t214 * t305 + (t252 * t560 + (t626 - t372 * t474 - t383 * t471));
        let t628 = t411 * t473 + (t472 * t573 + (t403 * t476 + (t475 * t571 + t627)));
        let t629 = t590 - t330 * t493 - t285 * t324 - t387 * t490 - t395 * t487;
        let t630 = t216 * t322 + (t253 * t563 + (t326 * t494 + (t629 - t495 * t561)));
        let t631 = t470 - t510 * t564 - t330 * t509 - t287 * t324 - t387 * t506;
        let t632 = t219 * t322 + (t255 * t563 + (t309 * t511 + (t631 - t395 * t503)));
        let t633 = t257 * t560 - t515 * t564 - t315 * t517 - t289 * t307;
        let t634 = t633 - t520 * t571 - t403 * t519 - t524 * t573 - t411 * t522;
        let t635 = t326 * t527 - t330 * t526 - t290 * t324 - t530 * t575;
        let t636 = t635 - t368 * t528 - t533 * t577 - t377 * t532 - t536 * t561;
        let t637 = t309 * t547 - t538 * t564 - t330 * t537 - t292 * t324;
        let t638 = t637 - t541 * t575 - t368 * t539 - t544 * t577 - t377 * t543;
        let t639 = t309 * t550 - t549 * t561 - t315 * t548 - t294 * t307;
        let t640 = t639 - t553 * t571 - t403 * t552 - t557 * t573 - t411 * t555;
        let t641 = t308 * t312 + (t321 - t314 * t561 - t309 * t311 - t167 * t306);
        let t642 = t303 - t329 * t564 - t326 * t327 - t170 * t323 - t297;
        let t643 = t328 * t336 + (t559 - t338 * t564 - t326 * t337 - t174 * t323);
        let t644 = t312 * t347 + (t354 - t349 * t561 - t309 * t348 - t177 * t306);
        let t645 = t345 - t357 * t564 - t326 * t356 - t179 * t323 - t343;
        let t646 = t328 * t362 + (t567 - t364 * t564 - t326 * t363 - t182 * t323);
        let t647 = t312 * t378 - t376 * t577 - t374 * t395 - t381 * t561;
        let t648 = t273 * t560 + (t647 - t309 * t380 - t191 * t306 - t371 * t389);
        let t649 = t372 * t388 - t392 * t564 - t326 * t391 - t193 * t323;
        let t650 = t328 * t390 + (t649 - t370 * t386 - t396 * t577 - t383 * t397);
        let t651 = t402 * t571 - t406 * t564 - t326 * t405 - t196 * t323;
        let t652 = t328 * t404 + (t651 - t370 * t401 - t395 * t409 - t410 * t573);
        let t653 = t435 - t422 * t561 - t309 * t421 - t204 * t306 - t426 * t571;
        let t654 = t312 * t420 + (t653 - t372 * t425 - t430 * t573 - t383 * t429);
        let t655 = t418 - t438 * t564 - t326 * t437 - t207 * t323 - t442 * t575;
        let t656 = t655 - t387 * t441 - t446 * t577 - t395 * t445 - t414;
        let t657 = t247 * t324 + (t280 * t563 + (t328 * t436 + (t416 + t656)));
        let t658 = t581 - t454 * t564 - t326 * t453 - t211 * t323 - t458 * t575;
        let t659 = t328 * t452 + (t658 - t387 * t457 - t462 * t577 - t395 * t461);
        let t660 = t486 - t478 * t564 - t326 * t477 - t214 * t306 - t389 * t476;
        let t661 = t252 * t307 + (t284 * t560 + (t312 * t479 + (t660 - t398 * t473)));
        let t662 = t469 - t494 * t564 - t216 * t323 - t370 * t492 - t375 * t489;
        let t663 = t285 * t563 + (t328 * t493 + (t662 - t467 - t465 - t309 * t495));
        let t664 = t487 * t577 + (t387 * t491 + (t490 * t575 + (t253 * t324 + t663)));
        let t665 = t590 - t326 * t510 - t219 * t323 - t370 * t508 - t375 * t505;
        let t666 = t255 * t324 + (t287 * t563 + (t328 * t509 + (t665 - t511 * t561)));
        let t667 = t312 * t517 - t516 * t564 - t326 * t515 - t222 * t306;
        let t668 = t667 - t521 * t571 - t372 * t520 - t525 * t573 - t383 * t524;
        let t669 = t328 * t526 - t527 * t564 - t224 * t323 - t531 * t575;
        let t670 = t669 - t387 * t530 - t535 * t577 - t395 * t533 - t309 * t536;
        let t671 = t328 * t537 - t326 * t538 - t227 * t323 - t542 * t575;
        let t672 = t671 - t387 * t541 - t546 * t577 - t395 * t544 - t547 * t561;
        let t673 = t312 * t548 - t550 * t561 - t309 * t549 - t230 * t306;
        let t674 = t673 - t554 * t571 - t372 * t553 - t558 * t573 - t383 * t557;
        let t675 = t35 * t373;
        let t676 = t30 * k4;
        let t677 = t40 * t373;
        let t678 = t31 * k4;
        let t679 = t47 * t373;
        let t680 = t28 * two;
        let t681 = t8 * two;
        let t682 = -(t675 * t676) - t677 * t678 - t679 * t680 - t167 * t681;
        let t683 = t6 * two;
        let t684 = t7 * two;
        let t685 = t49 * t373;
        let t686 = t28 * k4;
        let t687 = t53 * t373;
        let t688 = t8 * k4;
        let t689 = t6 * k4;
        let t690 = -(t685 * t686) - t678 * t687 - t170 * t688 - t232 * t689;
        let t691 = t7 * k4;
        let t692 = t57 * t373;
        let t693 = t30 * two;
        let t694 = t59 * t373;
        let t695 = t61 * t373;
        let t696 = -(t686 * t694) - t676 * t695 - t174 * t688 - t234 * t689;
        let t697 = t63 * t373;
        let t698 = t31 * two;
        let t699 = t40 * t366;
        let t700 = t35 * t366;
        let t701 = t47 * t366;
        let t702 = t680 * t701 - t177 * t681 - t236 * t683 - t268 * t684;
        let t703 = t53 * t366;
        let t704 = t49 * t366;
        let t705 = t57 * t366;
        let t706 = t693 * t705 - t179 * t688 - t237 * t689 - t269 * t691;
        let t707 = t61 * t366;
        let t708 = t59 * t366;
        let t709 = t63 * t366;
        let t710 = t698 * t709 - t182 * t688 - t239 * t689 - t271 * t691;
        let t711 = t85 * lambda[0];
        let t712 = q_j[6] * two;
        let t713 = t711 * t712;
        let t714 = t82 * lambda[0];
        let t715 = q_j[3] * two;
        let t716 = t714 * t715;
        let t717 = t92 * lambda[0];
        let t718 = q_j[5] * two;
        let t719 = t717 * t718;
        let t720 = t713 + (t716 - t719);
        let t721 = q_j[4] * two;
        let t722 = t717 * t721;
        let t723 = t711 * t715;
        let t724 = t712 * t714;
        let t725 = t722 + (t723 - t724);
        let t726 = t714 * t718;
        let t727 = t715 * t717 - t711 * t721;
        let t728 = t726 + t727;
        let t729 = t114 * t187 + t116 * t184;
        let t730 = t114 * t188 + t116 * t185;
        let t731 = t114 * t189 + t116 * t186;
        let t732 = -(t680 * t729) - t693 * t730 - t698 * t731 - t204 * t681;
        let t733 = t124 * t187 + t126 * t184;
        let t734 = t124 * t188 + t126 * t185;
        let t735 = t124 * t189 + t126 * t186;
        let t736 = -(t686 * t733) - t676 * t734 - t678 * t735 - t207 * t688;
        let t737 = t131 * t187 + t132 * t184;
        let t738 = t131 * t188 + t132 * t185;
        let t739 = t131 * t189 + t132 * t186;
        let t740 = -(t686 * t737) - t676 * t738 - t678 * t739 - t211 * t688;
        let t741 = t139 * t189 + t140 * t186;
        let t742 = t139 * t188 + t140 * t185;
        let t743 = t139 * t187 + t140 * t184;
        let t744 = t680 * t743 - t214 * t681 - t252 * t683 - t284 * t684;
        let t745 = t143 * t189 + t144 * t186;
        let t746 = t143 * t188 + t144 * t185;
        let t747 = t143 * t187 + t144 * t184;
        let t748 = t686 * t747 - t216 * t688 - t253 * t689 - t285 * t691;
        let t749 = t147 * t189 + t148 * t186;
        let t750 = t147 * t188 + t148 * t185;
        let t751 = t147 * t187 + t148 * t184;
        let t752 = t686 * t751 - t219 * t688 - t255 * t689 - t287 * t691;
        let t753 = t468 * two;
        let t754 = q_j[5] * t753;
        let t755 = t464 * two;
        let t756 = q_j[6] * t755;
        let t757 = t466 * two;
        let t758 = q_j[3] * t757;
        let t759 = t754 + (-t756 - t758);
        let t760 = t150 * t187 + t151 * t184;
        let t761 = t150 * t188 + t151 * t185;
        let t762 = t150 * t189 + t151 * t186;
        let t763 = t759 - t680 * t760 - t693 * t761 - t698 * t762 - t222 * t681;
        let t764 = q_j[6] * t757;
        let t765 = q_j[4] * t753;
        let t766 = q_j[3] * t755;
        let t767 = t764 + (-t765 - t766);
        let t768 = t154 * t187 + t155 * t184;
        let t769 = t154 * t188 + t155 * t185;
        let t770 = t154 * t189 + t155 * t186;
        let t771 = t767 - t686 * t768 - t676 * t769 - t678 * t770 - t224 * t688;
        let t772 = q_j[4] * t755;
        let t773 = q_j[5] * t757;
        let t774 = q_j[3] * t753;
        let t775 = t772 + (-t773 - t774);
        let t776 = t158 * t187 + t159 * t184;
        let t777 = t158 * t188 + t159 * t185;
        let t778 = t158 * t189 + t159 * t186;
        let t779 = t775 - t686 * t776 - t676 * t777 - t678 * t778 - t227 * t688;
        let t780 = t160 * t187 + t161 * t184;
        let t781 = t160 * t188 + t161 * t185;
        let t782 = t160 * t189 + t161 * t186;
        let t783 = -(t680 * t780) - t693 * t781 - t698 * t782 - t230 * t681;
        let t784 = t29 * two;
        let t785 = t5 * two;
        let t786 = t231 * t684 - t676 * t677 - t679 * t784 - t167 * t785;
        let t787 = t29 * k4;
        let t788 = t5 * k4;
        let t789 = t692 * t698 - t685 * t787 - t676 * t687 - t170 * t788;
        let t790 = t678 * t695 - t694 * t787 - t174 * t788 - t266 * t689;
        let t791 = t701 * t784 - t678 * t700 - t177 * t785 - t268 * t683;
        let t792 = t704 * t787 - t179 * t788 - t269 * t689 - t698 * t705;
        let t793 = t693 * t709 - t678 * t707 - t182 * t788 - t271 * t689;
        let t794 = t712 * t717 + (t711 * t718 + t714 * t721);
        let t795 = t698 * t730 - t729 * t784 - t693 * t731 - t204 * t785;
        let t796 = t678 * t734 - t733 * t787 - t676 * t735 - t207 * t788;
        let t797 = t678 * t738 - t737 * t787 - t676 * t739 - t211 * t788;
        let t798 = t743 * t784 - t698 * t742 - t214 * t785 - t284 * t683;
        let t799 = t747 * t787 - t678 * t746 - t216 * t788 - t285 * t689;
        let t800 = t751 * t787 - t678 * t750 - t219 * t788 - t287 * t689;
        let t801 = -(q_j[5] * t755) - q_j[4] * t757 - q_j[6] * t753;
        let t802 = t698 * t761 - t760 * t784 - t693 * t762 - t222 * t785;
        let t803 = t775 - t768 * t787 - t676 * t770 - t224 * t788 - t290 * t689;
        let t804 = t766 - t776 * t787 - t676 * t778 - t227 * t788 - t292 * t689;
        let t805 = t698 * t781 - t780 * t784 - t693 * t782 - t230 * t785;
        let t806 = t263 * t681 - t675 * t787 - t679 * t698 - t231 * t785;
        let t807 = t686 * t687 - t678 * t685 - t232 * t788 - t170 * t691;
        let t808 = t680 * t697 - t695 * t787 - t678 * t694 - t234 * t788;
        let t809 = t698 * t701 - t686 * t699 - t236 * t785 - t177 * t684;
        let t810 = t705 * t784 - t686 * t703 - t237 * t788 - t179 * t691;
        let t811 = t707 * t787 - t239 * t788 - t182 * t691 - t680 * t709;
        let t812 = t680 * t731 - t730 * t784 - t698 * t729 - t246 * t785;
        let t813 = t686 * t735 - t734 * t787 - t678 * t733 - t247 * t788;
        let t814 = t686 * t739 - t738 * t787 - t678 * t737 - t250 * t788;
        let t815 = t742 * t784 - t680 * t741 - t252 * t785 - t214 * t684;
        let t816 = t746 * t787 - t686 * t745 - t253 * t788 - t216 * t691;
        let t817 = t750 * t787 - t686 * t749 - t255 * t788 - t219 * t691;
        let t818 = t774 - t772 - t761 * t784 - t698 * t760 - t257 * t785;
        let t819 = t801 - t769 * t787 - t678 * t768 - t258 * t788 - t224 * t691;
        let t820 = t759 - t777 * t787 - t678 * t776 - t260 * t788 - t227 * t691;
        let t821 = t680 * t782 - t781 * t784 - t698 * t780 - t262 * t785;
        let t822 = t679 * t693 - t677 * t787 - t675 * t686 - t263 * t785;
        let t823 = t676 * t685 - t687 * t787 - t264 * t788 - t232 * t688;
        let t824 = t676 * t694 - t686 * t695 - t266 * t788 - t234 * t688;
        let t825 = t177 * t683 - t693 * t701 - t268 * t785 - t236 * t681;
        let t826 = t680 * t705 - t676 * t704 - t269 * t788 - t237 * t688;
        let t827 = t709 * t784 - t676 * t708 - t271 * t788 - t239 * t688;
        let t828 = t693 * t729 - t731 * t784 - t680 * t730 - t278 * t785;
        let t829 = t676 * t733 - t735 * t787 - t686 * t734 - t280 * t788;
        let t830 = t676 * t737 - t739 * t787 - t686 * t738 - t282 * t788;
        let t831 = t741 * t784 - t693 * t743 - t284 * t785 - t252 * t681;
        let t832 = t745 * t787 - t676 * t747 - t285 * t788 - t253 * t688;
        let t833 = t749 * t787 - t676 * t751 - t287 * t788 - t255 * t688;
        let t834 = t767 - t762 * t784 - t680 * t761 - t289 * t785 - t257 * t681;
        let t835 = t758 - t770 * t787 - t686 * t769 - t290 * t788 - t258 * t688;
        let t836 = t801 - t778 * t787 - t686 * t777 - t292 * t788 - t260 * t688;
        let t837 = t693 * t780 - t782 * t784 - t680 * t781 - t294 * t785;
        phi_h[0] = -(t27 * t36) - t27 * t41 - t26 * t48;
        phi_h[1] = -(t27 * t50) - t27 * t54 - t26 * t58;
        phi_h[2] = -(t27 * t60) - t27 * t62 - t26 * t64;
        phi_h[3] = t48 * t65 + (t36 * t66 + t41 * t66);
        phi_h[4] = t58 * t65 + (t50 * t66 + t54 * t66);
        phi_h[5] = t64 * t65 + (t60 * t66 + t62 * t66);
        phi_h[6] = t71 * t82 + (t85 * t89 + t92 * t96);
        phi_h[7] = t85 * t99 + (t100 * t101 + t92 * t104 * two);
        phi_h[8] = t92 * t105 + (t101 * t106 + t85 * t107 * two);
        phi_h[9] = -(t114 * t115) - t116 * t117;
        phi_h[10] = -(t124 * t125) - t126 * t127;
        phi_h[11] = -(t125 * t131) - t127 * t132;
        phi_h[12] = t115 * t139 + t117 * t140;
        phi_h[13] = t125 * t143 + t127 * t144;
        phi_h[14] = t125 * t147 + t127 * t148;
        phi_h[15] = -(t115 * t150) - t117 * t151;
        phi_h[16] = -(t125 * t154) - t127 * t155;
        phi_h[17] = -(t125 * t158) - t127 * t159;
        phi_h[18] = -(t115 * t160) - t117 * t161;
        force_h[0] = t167;
        force_h[1] = t171;
        force_h[2] = t175;
        force_h[3] = t177;
        force_h[4] = t180;
        force_h[5] = t183;
        force_h[6] = t191;
        force_h[7] = t194;
        force_h[8] = t197;
        force_h[9] = t204;
        force_h[10] = t208;
        force_h[11] = t212;
        force_h[12] = t214;
        force_h[13] = t217;
        force_h[14] = t220;
        force_h[15] = t222;
        force_h[16] = t225;
        force_h[17] = t228;
        force_h[18] = t230;
        force_h[19] = t231;
        force_h[20] = t233;
        force_h[21] = t235;
        force_h[22] = t236;
        force_h[23] = t238;
        force_h[24] = t240;
        force_h[25] = t241;
        force_h[26] = t243;
        force_h[27] = t245;
        force_h[28] = t246;
        force_h[29] = t248;
        force_h[30] = t251;
        force_h[31] = t252;
        force_h[32] = t254;
        force_h[33] = t256;
        force_h[34] = t257;
        force_h[35] = t259;
        force_h[36] = t261;
        force_h[37] = t262;
        force_h[38] = t263;
        force_h[39] = t265;
        force_h[40] = t267;
        force_h[41] = t268;
        force_h[42] = t270;
        force_h[43] = t272;
        force_h[44] = t273;
        force_h[45] = t275;
        force_h[46] = t277;
        force_h[47] = t278;
        force_h[48] = t281;
        force_h[49] = t283;
        force_h[50] = t284;
        force_h[51] = t286;
        force_h[52] = t288;
        force_h[53] = t289;
        force_h[54] = t291;
        force_h[55] = t293;
        force_h[56] = t294;
        force_h[57] = t304 + (t263 * t305 + (t231 * t306 + t316));
        force_h[58] = t321 + (t264 * t322 + (t232 * t323 + t331));
        force_h[59] = t335 + (t266 * t322 + (t234 * t323 + t339));
        force_h[60] = t346 + (t268 * t305 + (t236 * t306 + t350));
        force_h[61] = t354 + (t269 * t322 + (t237 * t323 + t358));
        force_h[62] = t361 + (t271 * t322 + (t239 * t323 + t365));
        force_h[63] = t367 * t368 + (t369 * t370 + (t371 * t372 + (t273 * t305 + t384)));
        force_h[64] = t368 * t385 + (t386 * t387 + (t274 * t322 + (t242 * t323 + t399)));
        force_h[65] = t370 * t400 + (t387 * t401 + (t276 * t322 + (t244 * t323 + t412)));
        force_h[66] = t419 + t431;
        force_h[67] = t435 + t447;
        force_h[68] = t451 + t463;
        force_h[69] = t470 + t482;
        force_h[70] = t486 + t498;
        force_h[71] = t502 + t514;
        force_h[72] = t289 * t305 + (t257 * t306 + (t523 - t398 * t524 - t411 * t525));
        force_h[73] = t290 * t322 + (t258 * t323 + (t534 - t377 * t535 - t312 * t536));
        force_h[74] = t292 * t322 + (t260 * t323 + (t545 - t377 * t546 - t315 * t547));
        force_h[75] = t294 * t305 + (t262 * t306 + (t556 - t398 * t557 - t411 * t558));
        force_h[76] = t559 + (t263 * t306 + (t167 * t560 + t562));
        force_h[77] = t264 * t323 + (t170 * t563 + t565);
        force_h[78] = t266 * t323 + (t174 * t563 + (t330 * t337 + (t319 + t566)));
        force_h[79] = t567 + (t268 * t306 + (t177 * t560 + t568));
        force_h[80] = t269 * t323 + (t179 * t563 + t569);
        force_h[81] = t271 * t323 + (t182 * t563 + (t330 * t363 + (t570 - t351)));
        force_h[82] = t374 * t377 + (t370 * t367 + (t371 * t571 + (t273 * t306 + t574)));
        force_h[83] = t370 * t385 + (t386 * t575 + (t274 * t323 + (t193 * t563 + t578)));
        force_h[84] = t377 * t409 + (t401 * t575 + (t276 * t323 + (t196 * t563 + t580)));
        force_h[85] = t581 + t584;
        force_h[86] = t377 * t445 + (t368 * t441 + (t280 * t323 + (t207 * t563 + t586)));
        force_h[87] = t377 * t461 + (t368 * t457 + t589);
        force_h[88] = t590 + t593;
        force_h[89] = t375 * t487 + (t489 * t577 + (t370 * t490 + (t492 * t575 + t595)));
        force_h[90] = t375 * t503 + t598;
        force_h[91] = t330 * t515 + (t411 * t524 + (t403 * t520 + (t289 * t306 + t600)));
        force_h[92] = t377 * t533 + (t368 * t530 + (t290 * t323 + (t224 * t563 + t602)));
        force_h[93] = t377 * t544 + (t368 * t541 + (t292 * t323 + (t227 * t563 + t604)));
        force_h[94] = t411 * t557 + (t403 * t553 + (t294 * t306 + (t230 * t560 + t606)));
        force_h[95] = t167 * t305 + (t231 * t560 + (t309 * t314 + (t333 + t607)));
        force_h[96] = t170 * t322 + (t232 * t563 + t608);
        force_h[97] = t174 * t322 + (t234 * t563 + t609);
        force_h[98] = t177 * t305 + (t236 * t560 + (t309 * t349 + t610));
        force_h[99] = t179 * t322 + (t237 * t563 + t611);
        force_h[100] = t182 * t322 + (t239 * t563 + t612);
        force_h[101] = t376 * t395
            + (t369 * t575 + (t371 * t403 + (t191 * t305 + t614)));
        force_h[102] = t395 * t396
            + (t368 * t386 + (t193 * t322 + (t242 * t563 + t616)));
        force_h[103] = t368 * t401
            + (t400 * t575 + (t196 * t322 + (t244 * t563 + t618)));
        force_h[104] = t383 * t430 + (t372 * t426 + t621);
        force_h[105] = t395 * t446
            + (t387 * t442 + (t207 * t322 + (t247 * t563 + t623)));
        force_h[106] = t395 * t462
            + (t387 * t458 + (t211 * t322 + (t250 * t563 + t625)));
        force_h[107] = t326 * t478 + t628;
        force_h[108] = t377 * t489
            + (t488 * t577 + (t368 * t492 + (t491 * t575 + t630)));
        force_h[109] = t377 * t505
            + (t504 * t577 + (t368 * t508 + (t507 * t575 + t632)));
        force_h[110] = t326 * t516
            + (t383 * t525 + (t372 * t521 + (t222 * t305 + t634)));
        force_h[111] = t395 * t535
            + (t387 * t531 + (t224 * t322 + (t258 * t563 + t636)));
        force_h[112] = t395 * t546
            + (t387 * t542 + (t227 * t322 + (t260 * t563 + t638)));
        force_h[113] = t383 * t558
            + (t372 * t554 + (t230 * t305 + (t262 * t560 + t640)));
        force_h[114] = t231 * t307 + (t263 * t560 + t641);
        force_h[115] = t232 * t324 + (t264 * t563 + (t325 * t328 + (t300 + t642)));
        force_h[116] = t234 * t324 + (t266 * t563 + t643);
        force_h[117] = t236 * t307 + (t268 * t560 + t644);
        force_h[118] = t237 * t324 + (t269 * t563 + (t328 * t355 + (t645 - t341)));
        force_h[119] = t239 * t324 + (t271 * t563 + t646);
        force_h[120] = t369 * t387
            + (t367 * t575 + (t382 * t398 + (t241 * t307 + t648)));
        force_h[121] = t375 * t394
            + (t385 * t575 + (t242 * t324 + (t274 * t563 + t650)));
        force_h[122] = t375 * t408
            + (t387 * t400 + (t244 * t324 + (t276 * t563 + t652)));
        force_h[123] = t398 * t427
            + (t389 * t424 + (t246 * t307 + (t278 * t560 + t654)));
        force_h[124] = t375 * t443 + (t370 * t440 + t657);
        force_h[125] = t375 * t459
            + (t370 * t456 + (t250 * t324 + (t282 * t563 + t659)));
        force_h[126] = t383 * t472
            + (t471 * t573 + (t372 * t475 + (t474 * t571 + t661)));
        force_h[127] = t395 * t488 + t664;
        force_h[128] = t395 * t504
            + (t503 * t577 + (t387 * t507 + (t506 * t575 + t666)));
        force_h[129] = t398 * t522
            + (t389 * t519 + (t257 * t307 + (t289 * t560 + t668)));
        force_h[130] = t375 * t532
            + (t370 * t528 + (t258 * t324 + (t290 * t563 + t670)));
        force_h[131] = t375 * t543
            + (t370 * t539 + (t260 * t324 + (t292 * t563 + t672)));
        force_h[132] = t398 * t555
            + (t389 * t552 + (t262 * t307 + (t294 * t560 + t674)));
        force_h[133] = -t167;
        force_h[134] = -t171;
        force_h[135] = -t175;
        force_h[136] = -t177;
        force_h[137] = -t180;
        force_h[138] = -t183;
        force_h[139] = -t191;
        force_h[140] = -t194;
        force_h[141] = -t197;
        force_h[142] = -t204;
        force_h[143] = -t208;
        force_h[144] = -t212;
        force_h[145] = -t214;
        force_h[146] = -t217;
        force_h[147] = -t220;
        force_h[148] = -t222;
        force_h[149] = -t225;
        force_h[150] = -t228;
        force_h[151] = -t230;
        force_h[152] = -t231;
        force_h[153] = -t233;
        force_h[154] = -t235;
        force_h[155] = -t236;
        force_h[156] = -t238;
        force_h[157] = -t240;
        force_h[158] = -t241;
        force_h[159] = -t243;
        force_h[160] = -t245;
        force_h[161] = -t246;
        force_h[162] = -t248;
        force_h[163] = -t251;
        force_h[164] = -t252;
        force_h[165] = -t254;
        force_h[166] = -t256;
        force_h[167] = -t257;
        force_h[168] = -t259;
        force_h[169] = -t261;
        force_h[170] = -t262;
        force_h[171] = -t263;
        force_h[172] = -t265;
        force_h[173] = -t267;
        force_h[174] = -t268;
        force_h[175] = -t270;
        force_h[176] = -t272;
        force_h[177] = -t273;
        force_h[178] = -t275;
        force_h[179] = -t277;
        force_h[180] = -t278;
        force_h[181] = -t281;
        force_h[182] = -t283;
        force_h[183] = -t284;
        force_h[184] = -t286;
        force_h[185] = -t288;
        force_h[186] = -t289;
        force_h[187] = -t291;
        force_h[188] = -t293;
        force_h[189] = -t294;
        force_h[190] = t682 - t231 * t683 - t263 * t684;
        force_h[191] = t690 - t264 * t691 - t692 * t693;
        force_h[192] = t696 - t266 * t691 - t697 * t698;
        force_h[193] = t678 * t699 + (t676 * t700 + t702);
        force_h[194] = t678 * t703 + (t686 * t704 + t706);
        force_h[195] = t676 * t707 + (t686 * t708 + t710);
        force_h[196] = t720 - t191 * t681 - t241 * t683 - t273 * t684;
        force_h[197] = t725 - t193 * t688 - t242 * t689 - t274 * t691;
        force_h[198] = t728 - t196 * t688 - t244 * t689 - t276 * t691;
        force_h[199] = t732 - t246 * t683 - t278 * t684;
        force_h[200] = t736 - t247 * t689 - t280 * t691;
        force_h[201] = t740 - t250 * t689 - t282 * t691;
        force_h[202] = t698 * t741 + (t693 * t742 + t744);
        force_h[203] = t678 * t745 + (t676 * t746 + t748);
        force_h[204] = t678 * t749 + (t676 * t750 + t752);
        force_h[205] = t763 - t257 * t683 - t289 * t684;
        force_h[206] = t771 - t258 * t689 - t290 * t691;
        force_h[207] = t779 - t260 * t689 - t292 * t691;
        force_h[208] = t783 - t262 * t683 - t294 * t684;
        force_h[209] = t675 * t678 + (t786 - t263 * t683);
        force_h[210] = t232 * t691 + (t789 - t264 * t689);
        force_h[211] = t234 * t691 + (t790 - t693 * t697);
        force_h[212] = t676 * t699 + (t236 * t684 + t791);
        force_h[213] = t237 * t691 + (t676 * t703 + t792);
        force_h[214] = t239 * t691 + (t708 * t787 + t793);
        force_h[215] = t794 + (t241 * t684 - t191 * t785 - t273 * t683);
        force_h[216] = t242 * t691 + (t728 - t193 * t788 - t274 * t689);
        force_h[217] = t244 * t691 + (t724 - t196 * t788 - t276 * t689 - t723 - t722);
        force_h[218] = t246 * t684 + (t795 - t278 * t683);
        force_h[219] = t247 * t691 + (t796 - t280 * t689);
        force_h[220] = t250 * t691 + (t797 - t282 * t689);
        force_h[221] = t252 * t684 + (t693 * t741 + t798);
        force_h[222] = t253 * t691 + (t676 * t745 + t799);
        force_h[223] = t255 * t691 + (t676 * t749 + t800);
        force_h[224] = t801 + (t257 * t684 + (t802 - t289 * t683));
        force_h[225] = t258 * t691 + (t678 * t769 + t803);
        force_h[226] = t260 * t691 + (t678 * t777 + (t765 + (t804 - t764)));
        force_h[227] = t262 * t684 + (t805 - t294 * t683);
        force_h[228] = t677 * t686 + (t806 - t167 * t684);
        force_h[229] = t264 * t688 + (t807 - t692 * t784);
        force_h[230] = t266 * t688 + (t808 - t174 * t691);
        force_h[231] = t700 * t787 + (t268 * t681 + t809);
        force_h[232] = t269 * t688 + (t678 * t704 + t810);
        force_h[233] = t271 * t688 + (t678 * t708 + t811);
        force_h[234] = t273 * t681 + (-t727 - t726 - t241 * t785 - t191 * t684);
        force_h[235] = t274 * t688 + (t794 - t242 * t788 - t193 * t691);
        force_h[236] = t276 * t688 + (t720 - t244 * t788 - t196 * t691);
        force_h[237] = t278 * t681 + (t812 - t204 * t684);
        force_h[238] = t280 * t688 + (t813 - t207 * t691);
        force_h[239] = t282 * t688 + (t814 - t211 * t691);
        force_h[240] = t284 * t681 + (t698 * t743 + t815);
        force_h[241] = t285 * t688 + (t678 * t747 + t816);
        force_h[242] = t287 * t688 + (t678 * t751 + t817);
        force_h[243] = t289 * t681 + (t680 * t762 + (t773 + (t818 - t222 * t684)));
        force_h[244] = t290 * t688 + (t686 * t770 + t819);
        force_h[245] = t292 * t688 + (t686 * t778 + t820);
        force_h[246] = t294 * t681 + (t821 - t230 * t684);
        force_h[247] = t167 * t683 + (t822 - t231 * t681);
        force_h[248] = t170 * t689 + (t823 - t680 * t692);
        force_h[249] = t174 * t689 + (t824 - t697 * t784);
        force_h[250] = t686 * t700 + (t699 * t787 + t825);
        force_h[251] = t179 * t689 + (t703 * t787 + t826);
        force_h[252] = t182 * t689 + (t686 * t707 + t827);
        force_h[253] = t191 * t683 + (t725 - t273 * t785 - t241 * t681);
        force_h[254] = t193 * t689 + (t719 - t274 * t788 - t242 * t688 - t716 - t713);
        force_h[255] = t196 * t689 + (t794 - t276 * t788 - t244 * t688);
        force_h[256] = t204 * t683 + (t828 - t246 * t681);
        force_h[257] = t207 * t689 + (t829 - t247 * t688);
        force_h[258] = t211 * t689 + (t830 - t250 * t688);
        force_h[259] = t214 * t683 + (t680 * t742 + t831);
        force_h[260] = t216 * t689 + (t686 * t746 + t832);
        force_h[261] = t219 * t689 + (t686 * t750 + t833);
        force_h[262] = t222 * t683 + (t693 * t760 + t834);
        force_h[263] = t224 * t689 + (t676 * t768 + (t756 + (t835 - t754)));
        force_h[264] = t227 * t689 + (t676 * t776 + t836);
        force_h[265] = t230 * t683 + (t837 - t262 * t681);
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 791 additions, 1151 multiplications, 0 divisions, 2 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 19],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 14],
        rate_h: &mut [S; 19],
    ) {
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = h[11] * q_i[6] + (h[9] * q_i[4] + h[10] * q_i[5]);
        let t1 = q_i[3] * h[11] + h[10] * q_i[4] - h[9] * q_i[5];
        let t2 = h[9] * q_i[6] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t3 = q_i[3] * h[9] + h[11] * q_i[5] - h[10] * q_i[6];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = h[17] * q_j[6] + (h[15] * q_j[4] + q_j[5] * h[16]);
        let t6 = q_j[3] * h[17] + h[16] * q_j[4] - h[15] * q_j[5];
        let t7 = h[15] * q_j[6] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t8 = q_j[3] * h[15] + q_j[5] * h[17] - h[16] * q_j[6];
        let t9 = q_j[6] * t5 + (q_j[3] * t6 + q_j[4] * t7 - q_j[5] * t8);
        let t10 = q_j[2] + t9;
        let t11 = q_i[6] * h[14] + (q_i[4] * h[12] + q_i[5] * h[13]);
        let t12 = q_i[3] * h[14] + q_i[4] * h[13] - q_i[5] * h[12];
        let t13 = q_i[6] * h[12] + (q_i[3] * h[13] - q_i[4] * h[14]);
        let t14 = q_i[3] * h[12] + q_i[5] * h[14] - q_i[6] * h[13];
        let t15 = q_i[6] * t11 + (q_i[3] * t12 + q_i[4] * t13 - q_i[5] * t14);
        let t16 = q_i[2] + t15;
        let t17 = t10 - t16;
        let t18 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t19 = q_j[5] * t6 + (q_j[3] * t8 + q_j[4] * t5) - q_j[6] * t7;
        let t20 = q_j[0] + t19;
        let t21 = q_i[5] * t12 + (q_i[3] * t14 + q_i[4] * t11) - q_i[6] * t13;
        let t22 = q_i[0] + t21;
        let t23 = t20 - t22;
        let t24 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t25 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t7 - q_j[4] * t6));
        let t26 = q_j[1] + t25;
        let t27 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t13 - q_i[4] * t12));
        let t28 = q_i[1] + t27;
        let t29 = t26 - t28;
        let t30 = t4 * t17 + (t18 * t23 + t24 * t29);
        let t31 = h[18] * t30;
        let t32 = t31.sin();
        let t33 = h[18] * t18;
        let t34 = t32 * t33;
        let t35 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t36 = q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3];
        let t37 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t38 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t39 = q_i[6] * t35 + (q_i[3] * t36 + q_i[4] * t37 - q_i[5] * t38);
        let t40 = q_j[6] * h[8] + (q_j[4] * h[6] + q_j[5] * h[7]);
        let t41 = q_j[6] * h[6] + (q_j[3] * h[7] - q_j[4] * h[8]);
        let t42 = q_j[3] * h[8] + q_j[4] * h[7] - q_j[5] * h[6];
        let t43 = v_j[6] * h[8] + (v_j[4] * h[6] + v_j[5] * h[7]);
        let t44 = v_j[3] * h[8] + (v_j[4] * h[7] - v_j[5] * h[6]);
        let t45 = v_j[6] * h[6] + v_j[3] * h[7] - v_j[4] * h[8];
        let t46 = v_j[3] * t42 + (q_j[6] * t43 + (q_j[3] * t44 + q_j[4] * t45));
        let t47 = v_j[5] * h[8] + (v_j[3] * h[6] - v_j[6] * h[7]);
        let t48 = q_j[3] * h[6] + q_j[5] * h[8] - q_j[6] * h[7];
        let t49 = v_j[6] * t40 + (v_j[4] * t41 + t46) - (q_j[5] * t47 + v_j[5] * t48);
        let t50 = q_i[6] * t38 + (q_i[5] * t35 + (q_i[3] * t37 - q_i[4] * t36));
        let t51 = v_j[3] * t41 + (q_j[6] * t47 + (q_j[3] * t45 + q_j[5] * t43));
        let t52 = v_j[6] * t48 + (v_j[5] * t40 + t51) - (q_j[4] * t44 + v_j[4] * t42);
        let t53 = q_i[5] * t36 + (q_i[3] * t38 + q_i[4] * t35) - q_i[6] * t37;
        let t54 = v_j[3] * t48 + (q_j[5] * t44 + (q_j[3] * t47 + q_j[4] * t43));
        let t55 = v_j[5] * t42 + (v_j[4] * t40 + t54) - (q_j[6] * t45 + v_j[6] * t41);
        let t56 = q_j[6] * t40 + (q_j[3] * t42 + q_j[4] * t41 - q_j[5] * t48);
        let t57 = v_i[6] * h[5] + (v_i[4] * h[3] + v_i[5] * h[4]);
        let t58 = v_i[3] * h[5] + (v_i[4] * h[4] - v_i[5] * h[3]);
        let t59 = v_i[6] * h[3] + v_i[3] * h[4] - v_i[4] * h[5];
        let t60 = v_i[3] * t36 + (q_i[6] * t57 + (q_i[3] * t58 + q_i[4] * t59));
        let t61 = v_i[5] * h[5] + (v_i[3] * h[3] - v_i[6] * h[4]);
        let t62 = v_i[6] * t35 + (v_i[4] * t37 + t60) - (q_i[5] * t61 + v_i[5] * t38);
        let t63 = q_j[5] * t42 + (q_j[3] * t48 + q_j[4] * t40) - q_j[6] * t41;
        let t64 = v_i[3] * t38 + (q_i[5] * t58 + (q_i[3] * t61 + q_i[4] * t57));
        let t65 = v_i[5] * t36 + (v_i[4] * t35 + t64) - (q_i[6] * t59 + v_i[6] * t37);
        let t66 = q_j[6] * t48 + (q_j[5] * t40 + (q_j[3] * t41 - q_j[4] * t42));
        let t67 = v_i[3] * t37 + (q_i[6] * t61 + (q_i[3] * t59 + q_i[5] * t57));
        let t68 = v_i[6] * t38 + (v_i[5] * t35 + t67) - (q_i[4] * t58 + v_i[4] * t36);
        let t69 = t53 * t55 + (t56 * t62 + (t63 * t65 + t66 * t68));
        let t70 = t39 * t49 + (t50 * t52 + t69);
        let t71 = t31.cos();
        let t72 = t71 * t33;
        let t73 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t74 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t75 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t76 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t77 = q_i[6] * t73 + (q_i[3] * t74 + q_i[4] * t75 - q_i[5] * t76);
        let t78 = q_i[6] * t76 + (q_i[5] * t73 + (q_i[3] * t75 - q_i[4] * t74));
        let t79 = q_i[5] * t74 + (q_i[3] * t76 + q_i[4] * t73) - q_i[6] * t75;
        let t80 = v_i[6] * h[2] + (v_i[4] * h[0] + v_i[5] * h[1]);
        let t81 = v_i[3] * h[2] + (v_i[4] * h[1] - v_i[5] * h[0]);
        let t82 = v_i[6] * h[0] + v_i[3] * h[1] - v_i[4] * h[2];
        let t83 = v_i[3] * t74 + (q_i[6] * t80 + (q_i[3] * t81 + q_i[4] * t82));
        let t84 = v_i[5] * h[2] + (v_i[3] * h[0] - v_i[6] * h[1]);
        let t85 = v_i[6] * t73 + (v_i[4] * t75 + t83) - (q_i[5] * t84 + v_i[5] * t76);
        let t86 = v_i[3] * t76 + (q_i[5] * t81 + (q_i[3] * t84 + q_i[4] * t80));
        let t87 = v_i[5] * t74 + (v_i[4] * t73 + t86) - (q_i[6] * t82 + v_i[6] * t75);
        let t88 = v_i[3] * t75 + (q_i[6] * t84 + (q_i[3] * t82 + q_i[5] * t80));
        let t89 = v_i[6] * t76 + (v_i[5] * t73 + t88) - (q_i[4] * t81 + v_i[4] * t74);
        let t90 = t79 * t55 + (t56 * t85 + (t63 * t87 + t66 * t89));
        let t91 = t77 * t49 + (t78 * t52 + t90);
        let t92 = v_i[3] * h[11] + (h[10] * v_i[4] - h[9] * v_i[5]);
        let t93 = h[11] * v_i[5] + (h[9] * v_i[3] - h[10] * v_i[6]);
        let t94 = v_i[6] * h[11] + (h[9] * v_i[4] + h[10] * v_i[5]);
        let t95 = v_i[3] * t3 + (q_i[5] * t92 + (q_i[3] * t93 + q_i[4] * t94));
        let t96 = h[9] * v_i[6] + v_i[3] * h[10] - h[11] * v_i[4];
        let t97 = v_i[5] * t1 + (v_i[4] * t0 + t95) - (q_i[6] * t96 + v_i[6] * t2);
        let t98 = h[18] * t97;
        let t99 = v_i[3] * t1 + (t94 * q_i[6] + (q_i[3] * t92 + q_i[4] * t96));
        let t100 = v_i[6] * t0 + (v_i[4] * t2 + t99) - (t93 * q_i[5] + v_i[5] * t3);
        let t101 = v_i[3] * t2 + (t93 * q_i[6] + (q_i[3] * t96 + t94 * q_i[5]));
        let t102 = v_i[6] * t3 + (v_i[5] * t0 + t101) - (q_i[4] * t92 + v_i[4] * t1);
        let t103 = h[17] * v_j[6] + (h[15] * v_j[4] + h[16] * v_j[5]);
        let t104 = h[17] * v_j[3] + (h[16] * v_j[4] - h[15] * v_j[5]);
        let t105 = h[15] * v_j[6] + h[16] * v_j[3] - h[17] * v_j[4];
        let t106 = t6 * v_j[3] + (q_j[6] * t103 + (q_j[3] * t104 + q_j[4] * t105));
        let t107 = h[17] * v_j[5] + (h[15] * v_j[3] - h[16] * v_j[6]);
        let t108 = t5 * v_j[6] + (t7 * v_j[4] + t106) - (q_j[5] * t107 + t8 * v_j[5]);
        let t109 = v_i[6] * h[14] + (v_i[4] * h[12] + v_i[5] * h[13]);
        let t110 = v_i[3] * h[14] + (v_i[4] * h[13] - v_i[5] * h[12]);
        let t111 = v_i[6] * h[12] + v_i[3] * h[13] - v_i[4] * h[14];
        let t112 = v_i[3] * t12 + (q_i[6] * t109 + (q_i[3] * t110 + q_i[4] * t111));
        let t113 = v_i[5] * h[14] + (v_i[3] * h[12] - v_i[6] * h[13]);
        let t114 = v_i[6] * t11 + (v_i[4] * t13 + t112) - (q_i[5] * t113 + v_i[5] * t14);
        let t115 = t8 * v_j[3] + (q_j[5] * t104 + (q_j[3] * t107 + q_j[4] * t103));
        let t116 = t6 * v_j[5] + (t5 * v_j[4] + t115) - (q_j[6] * t105 + t7 * v_j[6]);
        let t117 = v_i[3] * t14 + (q_i[5] * t110 + (q_i[3] * t113 + q_i[4] * t109));
        let t118 = v_i[5] * t12 + (v_i[4] * t11 + t117) - (q_i[6] * t111 + v_i[6] * t13);
        let t119 = t7 * v_j[3] + (q_j[6] * t107 + (q_j[3] * t105 + q_j[5] * t103));
        let t120 = t8 * v_j[6] + (t5 * v_j[5] + t119) - (q_j[4] * t104 + t6 * v_j[4]);
        let t121 = v_i[3] * t13 + (q_i[6] * t113 + (q_i[3] * t111 + q_i[5] * t109));
        let t122 = v_i[6] * t14 + (v_i[5] * t11 + t121) - (q_i[4] * t110 + v_i[4] * t12);
        let t123 = t18 * (v_j[0] + t116 - (v_i[0] + t118))
            + t24 * (v_j[1] + t120 - (v_i[1] + t122));
        let t124 = t97 * t23 + (t4 * (v_j[2] + t108 - (v_i[2] + t114)) + t123);
        let t125 = t17 * t100 + (t29 * t102 + t124);
        let t126 = h[18] * t125;
        let t127 = t56 * t39 + (t63 * t53 + t66 * t50);
        let t128 = t34 * t70 + (t72 * t91 + (t98 * t32 + t126 * t72) * t127);
        let t129 = t56 * t77 + (t63 * t79 + t66 * t78);
        let t130 = t128 - (t34 * t126 - t98 * t71) * t129;
        let t131 = h[18] * t24;
        let t132 = t32 * t131;
        let t133 = t71 * t131;
        let t134 = h[18] * t102;
        let t135 = t70 * t132 + (t91 * t133 + t127 * (t32 * t134 + t126 * t133));
        let t136 = t135 - t129 * (t126 * t132 - t71 * t134);
        let t137 = h[18] * t4;
        let t138 = t32 * t137;
        let t139 = t71 * t137;
        let t140 = h[18] * t100;
        let t141 = t70 * t138 + (t91 * t139 + t127 * (t32 * t140 + t126 * t139));
        let t142 = t141 - t129 * (t126 * t138 - t71 * t140);
        let t143 = t32 * t126;
        let t144 = t71 * t49 - t56 * t143;
        let t145 = t71 * t55 - t63 * t143;
        let t146 = t71 * t52 - t66 * t143;
        let t147 = t71 * (t56 * t58 + (t63 * t61 + t66 * t59))
            + (t36 * t144 + (t38 * t145 + t37 * t146));
        let t148 = t10 * two - t16 * two;
        let t149 = t20 * two - t22 * two;
        let t150 = t26 * two - t28 * two;
        let t151 = t97 * t14 + (t4 * t110 + (t18 * t113 + t24 * t111));
        let t152 = (t92 * t148 + (t93 * t149 + t96 * t150)) * half
            - (t12 * t100 + (t13 * t102 + t151));
        let t153 = h[18] * v_j[2] + h[18] * t108;
        let t154 = h[18] * v_i[2] + h[18] * t114;
        let t155 = t153 * two - t154 * two;
        let t156 = h[18] * v_j[0] + h[18] * t116;
        let t157 = h[18] * v_i[0] + h[18] * t118;
        let t158 = t156 * two - t157 * two;
        let t159 = h[18] * v_j[1] + h[18] * t120;
        let t160 = h[18] * v_i[1] + h[18] * t122;
        let t161 = t159 * two - t160 * two;
        let t162 = h[18] * t152 + (t1 * t155 + (t3 * t158 + t2 * t161)) * half;
        let t163 = (t1 * t148 + (t3 * t149 + t2 * t150)) * half
            - (t12 * t4 + (t18 * t14 + t13 * t24));
        let t164 = h[18] * t163;
        let t165 = t32 * t164;
        let t166 = t71 * t164;
        let t167 = t71 * t126;
        let t168 = t56 * t167 + t32 * t49;
        let t169 = t63 * t167 + t32 * t55;
        let t170 = t66 * t167 + t32 * t52;
        let t171 = t32 * (t56 * t81 + (t63 * t84 + t66 * t82))
            + (t74 * t168 + (t76 * t169 + t75 * t170));
        let t172 = t127 * (t32 * t162 + t126 * t166)
            + (t91 * t166 + (t70 * t165 + t171));
        let t173 = (t63 * t57 + t56 * t59) * two - t66 * t58 * two;
        let t174 = t66 * t81 * two - (t63 * t80 + t56 * t82) * two;
        let t175 = (t74 * t170 + (t35 * t145 + t37 * t144)) * two
            + (t71 * t173 + t32 * t174);
        let t176 = (t94 * t149 + t96 * t148 - t92 * t150) * half
            + (t24 * t110 + t12 * t102);
        let t177 = t13 * t100 + (t97 * t11 + (t18 * t109 + t4 * t111));
        let t178 = h[18] * (t176 - t177) + (t0 * t158 + t2 * t155 - t1 * t161) * half;
        let t179 = (t0 * t149 + t2 * t148 - t1 * t150) * half
            + (t12 * t24 - (t18 * t11 + t13 * t4));
        let t180 = h[18] * t179;
        let t181 = t32 * t180;
        let t182 = t71 * t180;
        let t183 = t70 * t181 + (t75 * t168 + (t36 * t146 + t73 * t169));
        let t184 = t127 * (t32 * t178 + t126 * t182) + (t91 * t182 + t183);
        let t185 = (t63 * t58 + t66 * t57) * two - t56 * t61 * two;
        let t186 = t56 * t84 * two - (t63 * t81 + t66 * t80) * two;
        let t187 = (t76 * t168 + (t35 * t146 + t36 * t145)) * two
            + (t71 * t185 + t32 * t186);
        let t188 = (t92 * t149 + (t94 * t150 - t93 * t148)) * half
            + (t4 * t113 + t14 * t100);
        let t189 = t97 * t12 + (t11 * t102 + (t18 * t110 + t24 * t109));
        let t190 = h[18] * (t188 - t189) + (t1 * t158 + (t0 * t161 - t3 * t155)) * half;
        let t191 = (t1 * t149 + (t0 * t150 - t3 * t148)) * half
            + (t14 * t4 - (t18 * t12 + t11 * t24));
        let t192 = h[18] * t191;
        let t193 = t32 * t192;
        let t194 = t71 * t192;
        let t195 = t70 * t193 + (t74 * t169 + (t38 * t144 + t73 * t170));
        let t196 = t127 * (t32 * t190 + t126 * t194) + (t91 * t194 + t195);
        let t197 = (t66 * t61 + t56 * t57) * two - t63 * t59 * two;
        let t198 = t63 * t82 * two - (t66 * t84 + t56 * t80) * two;
        let t199 = (t75 * t169 + (t35 * t144 + t38 * t146)) * two
            + (t71 * t197 + t32 * t198);
        let t200 = (t94 * t148 + t93 * t150 - t96 * t149) * half
            + (t18 * t111 + t97 * t13);
        let t201 = t14 * t102 + (t11 * t100 + (t24 * t113 + t4 * t109));
        let t202 = h[18] * (t200 - t201) + (t0 * t155 + t3 * t161 - t2 * t158) * half;
        let t203 = (t0 * t148 + t3 * t150 - t2 * t149) * half
            + (t18 * t13 - (t14 * t24 + t11 * t4));
        let t204 = h[18] * t203;
        let t205 = t32 * t204;
        let t206 = t71 * t204;
        let t207 = t70 * t205 + (t76 * t170 + (t37 * t145 + t73 * t168));
        let t208 = t127 * (t32 * t202 + t126 * t206) + (t91 * t206 + t207);
        let t209 = t71 * t39 - t32 * t77;
        let t210 = t71 * t50 - t32 * t78;
        let t211 = t71 * t53 - t32 * t79;
        let t212 = t71 * t62 - (t32 * t85 + (t39 * t143 + t77 * t167));
        let t213 = t71 * t65 - (t32 * t87 + (t53 * t143 + t79 * t167));
        let t214 = t71 * t68 - (t32 * t89 + (t50 * t143 + t78 * t167));
        let t215 = t47 * t211 + (t42 * t212 + (t48 * t213 + t41 * t214));
        let t216 = t97 * t8 + (t4 * t104 + (t18 * t107 + t24 * t105));
        let t217 = h[18] * (t6 * t100 + (t7 * t102 + t216));
        let t218 = h[18] * (t6 * t4 + (t18 * t8 + t7 * t24));
        let t219 = t32 * t218;
        let t220 = t71 * t218;
        let t221 = t127 * (t32 * t217 + t126 * t220) + (t70 * t219 + t91 * t220);
        let t222 = t45 * t209 + (t43 * t211 + (t40 * t213 + t41 * t212));
        let t223 = t7 * t100 + (t97 * t5 + (t18 * t103 + t4 * t105));
        let t224 = h[18] * (t223 - (t24 * t104 + t6 * t102));
        let t225 = h[18] * (t7 * t4 + (t18 * t5 - t6 * t24));
        let t226 = t32 * t225;
        let t227 = t71 * t225;
        let t228 = t127 * (t32 * t224 + t126 * t227)
            + (t91 * t227 + (t42 * t214 + t70 * t226));
        let t229 = t44 * t210 + (t129 * (t71 * t224 - t126 * t226) + t228);
        let t230 = t44 * t211 + (t43 * t210 + (t40 * t214 + t42 * t213));
        let t231 = t97 * t6 + (t5 * t102 + (t18 * t104 + t24 * t103));
        let t232 = h[18] * (t231 - (t4 * t107 + t8 * t100));
        let t233 = h[18] * (t18 * t6 + t5 * t24 - t8 * t4);
        let t234 = t32 * t233;
        let t235 = t71 * t233;
        let t236 = t127 * (t32 * t232 + t126 * t235)
            + (t91 * t235 + (t48 * t212 + t70 * t234));
        let t237 = t47 * t209 + (t129 * (t71 * t232 - t126 * t234) + t236);
        let t238 = t47 * t210 + (t43 * t209 + (t40 * t212 + t48 * t214));
        let t239 = t8 * t102 + (t5 * t100 + (t24 * t107 + t4 * t103));
        let t240 = h[18] * (t239 - (t18 * t105 + t97 * t7));
        let t241 = h[18] * (t5 * t4 + (t8 * t24 - t18 * t7));
        let t242 = t32 * t241;
        let t243 = t71 * t241;
        let t244 = t127 * (t32 * t240 + t126 * t243)
            + (t91 * t243 + (t41 * t213 + t70 * t242));
        let t245 = t45 * t211 + (t129 * (t71 * t240 - t126 * t242) + t244);
        let t246 = q_i[4] * q_i[4];
        let t247 = q_i[3] * q_i[3];
        let t248 = q_i[5] * q_i[5];
        let t249 = q_i[6] * q_i[6];
        let t250 = t246 + (t247 - (t248 + t249));
        let t251 = q_i[4] * q_i[6];
        let t252 = q_i[3] * q_i[5];
        let t253 = t251 - t252;
        let t254 = v_i[6] * q_i[4] + v_i[4] * q_i[6];
        let t255 = q_i[3] * v_i[5] + v_i[3] * q_i[5];
        let t256 = t254 - t255;
        let t257 = q_i[3] * v_i[3];
        let t258 = q_i[4] * v_i[4];
        let t259 = v_i[5] * q_i[5];
        let t260 = v_i[6] * q_i[6];
        let t261 = t257 + t258 - (t259 + t260);
        let t262 = v_i[5] * q_i[4] + v_i[4] * q_i[5];
        let t263 = q_i[3] * v_i[6] + v_i[3] * q_i[6];
        let t264 = t262 + t263;
        let t265 = t56 * t256 + (t63 * t261 + t66 * t264);
        let t266 = q_i[3] * q_i[6];
        let t267 = q_i[4] * q_i[5];
        let t268 = t266 + t267;
        let t269 = t248 + t247 - (t249 + t246);
        let t270 = q_i[3] * q_i[4];
        let t271 = q_i[5] * q_i[6];
        let t272 = t270 + t271;
        let t273 = v_i[6] * q_i[5] + v_i[5] * q_i[6];
        let t274 = q_i[3] * v_i[4] + v_i[3] * q_i[4];
        let t275 = t273 + t274;
        let t276 = t262 - t263;
        let t277 = t257 + t259 - (t258 + t260);
        let t278 = t56 * t275 + (t63 * t276 + t66 * t277);
        let t279 = t267 - t266;
        let t280 = t249 + t247 - (t248 + t246);
        let t281 = t271 - t270;
        let t282 = t257 + t260 - (t258 + t259);
        let t283 = t255 + t254;
        let t284 = t273 - t274;
        let t285 = t56 * t282 + (t63 * t283 + t66 * t284);
        let t286 = t252 + t251;
        let t287 = q_j[4] * q_j[4];
        let t288 = q_j[3] * q_j[3];
        let t289 = q_j[5] * q_j[5];
        let t290 = q_j[6] * q_j[6];
        let t291 = t287 + (t288 - (t289 + t290));
        let t292 = q_j[6] * q_j[4];
        let t293 = q_j[3] * q_j[5];
        let t294 = t292 - t293;
        let t295 = q_j[3] * q_j[6];
        let t296 = q_j[5] * q_j[4];
        let t297 = t295 + t296;
        let t298 = q_j[4] * v_j[6] + q_j[6] * v_j[4];
        let t299 = q_j[3] * v_j[5] + q_j[5] * v_j[3];
        let t300 = t298 - t299;
        let t301 = q_j[3] * v_j[3];
        let t302 = q_j[4] * v_j[4];
        let t303 = q_j[5] * v_j[5];
        let t304 = q_j[6] * v_j[6];
        let t305 = t301 + t302 - (t303 + t304);
        let t306 = q_j[4] * v_j[5] + q_j[5] * v_j[4];
        let t307 = q_j[3] * v_j[6] + q_j[6] * v_j[3];
        let t308 = t306 + t307;
        let t309 = t214 * t297 + (t209 * t300 + (t211 * t305 + t210 * t308));
        let t310 = t289 + t288 - (t290 + t287);
        let t311 = q_j[3] * q_j[4];
        let t312 = q_j[5] * q_j[6];
        let t313 = t311 + t312;
        let t314 = t296 - t295;
        let t315 = q_j[5] * v_j[6] + q_j[6] * v_j[5];
        let t316 = q_j[3] * v_j[4] + q_j[4] * v_j[3];
        let t317 = t315 + t316;
        let t318 = t306 - t307;
        let t319 = t301 + t303 - (t302 + t304);
        let t320 = t213 * t314 + (t209 * t317 + (t211 * t318 + t210 * t319));
        let t321 = t290 + t288 - (t289 + t287);
        let t322 = t312 - t311;
        let t323 = t293 + t292;
        let t324 = t301 + t304 - (t302 + t303);
        let t325 = t299 + t298;
        let t326 = t315 - t316;
        let t327 = t213 * t323 + (t209 * t324 + (t211 * t325 + t210 * t326));
        let t328 = h[18] * (t148 * t256 + (t149 * t261 + t150 * t264))
            + t250 * (t156 - t157);
        let t329 = (t155 * t253 + (t161 * t268 + t328)) * half;
        let t330 = h[18] * (t148 * t253 + (t23 * t250 + t150 * t268));
        let t331 = t71 * t330;
        let t332 = t126 * half;
        let t333 = t32 * t330;
        let t334 = t127 * (t32 * t329 + t331 * t332) + t129 * (t71 * t329 - t332 * t333);
        let t335 = h[18] * half;
        let t336 = (t148 * t272 + (t149 * t279 + t29 * t269)) * t335;
        let t337 = t71 * t336;
        let t338 = t32 * t336;
        let t339 = h[18] * (t148 * t275 + (t149 * t276 + t150 * t277)) + t158 * t279;
        let t340 = (t155 * t272 + (t269 * (t159 - t160) + t339)) * half;
        let t341 = t127 * (t32 * t340 + t126 * t337) + t129 * (t71 * t340 - t126 * t338);
        let t342 = t335 * (t17 * t280 + (t149 * t286 + t150 * t281));
        let t343 = t71 * t342;
        let t344 = t32 * t342;
        let t345 = h[18] * (t148 * t282 + (t149 * t283 + t150 * t284)) + t158 * t286;
        let t346 = (t280 * (t153 - t154) + (t161 * t281 + t345)) * half;
        let t347 = t127 * (t32 * t346 + t126 * t343) + t129 * (t71 * t346 - t126 * t344);
        let t348 = h[18] * (t18 * t250 + (t24 * t268 + t4 * t253) * two);
        let t349 = t71 * t348;
        let t350 = t32 * t348;
        let t351 = t97 * half;
        let t352 = t250 * t351 + (t4 * t256 + (t18 * t261 + t24 * t264));
        let t353 = h[18] * (t100 * t253 + (t102 * t268 + t352));
        let t354 = t129 * two;
        let t355 = t127 * (t32 * t353 + t332 * t349) * two
            - (t332 * t350 - t71 * t353) * t354;
        let t356 = t24 * half;
        let t357 = h[18] * (t4 * t272 + (t18 * t279 + t269 * t356));
        let t358 = t71 * t357;
        let t359 = t102 * half;
        let t360 = t97 * t279 + (t4 * t275 + (t18 * t276 + t24 * t277));
        let t361 = h[18] * (t100 * t272 + (t269 * t359 + t360));
        let t362 = t32 * t357;
        let t363 = t91 * t358 + (t127 * (t32 * t361 + t126 * t358) + t70 * t362);
        let t364 = t4 * half;
        let t365 = h[18] * (t280 * t364 + (t18 * t286 + t24 * t281));
        let t366 = t71 * t365;
        let t367 = t100 * half;
        let t368 = t97 * t286 + (t4 * t282 + (t18 * t283 + t24 * t284));
        let t369 = h[18] * (t280 * t367 + (t102 * t281 + t368));
        let t370 = t32 * t365;
        let t371 = t91 * t366 + (t127 * (t32 * t369 + t126 * t366) + t70 * t370);
        let t372 = t291 * t351 + (t4 * t300 + (t18 * t305 + t24 * t308));
        let t373 = h[18] * (t100 * t294 + (t102 * t297 + t372));
        let t374 = h[18] * (t18 * t291 + (t24 * t297 + t4 * t294) * two);
        let t375 = t71 * t374;
        let t376 = t32 * t374;
        let t377 = t127 * (t32 * t373 + t332 * t375) + t129 * (t71 * t373 - t332 * t376);
        let t378 = h[18] * (t4 * t313 + (t18 * t314 + t310 * t356));
        let t379 = t71 * t378;
        let t380 = t32 * t378;
        let t381 = t97 * t314 + (t4 * t317 + (t18 * t318 + t24 * t319));
        let t382 = h[18] * (t100 * t313 + (t310 * t359 + t381));
        let t383 = t127 * (t32 * t382 + t126 * t379) + t129 * (t71 * t382 - t126 * t380);
        let t384 = h[18] * (t321 * t364 + (t18 * t323 + t24 * t322));
        let t385 = t71 * t384;
        let t386 = t32 * t384;
        let t387 = t97 * t323 + (t4 * t324 + (t18 * t325 + t24 * t326));
        let t388 = h[18] * (t321 * t367 + (t102 * t322 + t387));
        let t389 = t127 * (t32 * t388 + t126 * t385) + t129 * (t71 * t388 - t126 * t386);
        let t390 = t30 * t71;
        let t391 = t30 * t32;
        let t392 = t127 * (t32 * t125 + t126 * t390) + t129 * (t71 * t125 - t126 * t391);
        rate_q[0] = t130;
        rate_q[1] = t136;
        rate_q[2] = t142;
        rate_q[3] = t147 * two - (t129 * (t71 * t162 - t126 * t165) + t172) * two;
        rate_q[4] = t175 - (t129 * (t71 * t178 - t126 * t181) + t184) * two;
        rate_q[5] = t187 - (t129 * (t71 * t190 - t126 * t193) + t196) * two;
        rate_q[6] = t199 - (t129 * (t71 * t202 - t126 * t205) + t208) * two;
        rate_q[7] = -t130;
        rate_q[8] = -t136;
        rate_q[9] = -t142;
        rate_q[10] = (t44 * t209 + (t45 * t210 + t215)) * two
            - (t129 * (t71 * t217 - t126 * t219) + t221) * two;
        rate_q[11] = t222 * two - t229 * two;
        rate_q[12] = t230 * two - t237 * two;
        rate_q[13] = t238 * two - t245 * two;
        rate_h[0] = -(t169 * t250) - (t168 * t253 + (t32 * t265 + t170 * t268)) * two;
        rate_h[1] = -(t170 * t269) - (t168 * t272 + (t32 * t278 + t169 * t279)) * two;
        rate_h[2] = -(t168 * t280) - (t170 * t281 + (t32 * t285 + t169 * t286)) * two;
        rate_h[3] = t145 * t250 + (t144 * t253 + (t71 * t265 + t146 * t268)) * two;
        rate_h[4] = t146 * t269 + (t144 * t272 + (t71 * t278 + t145 * t279)) * two;
        rate_h[5] = t144 * t280 + (t146 * t281 + (t71 * t285 + t145 * t286)) * two;
        rate_h[6] = t213 * t291 + (t212 * t294 + t309) * two;
        rate_h[7] = t214 * t310 + (t212 * t313 + t320) * two;
        rate_h[8] = t212 * t321 + (t214 * t322 + t327) * two;
        rate_h[9] = -(t334 * two) - (t70 * t333 + t91 * t331);
        rate_h[10] = -((t91 * t337 + (t70 * t338 + t341)) * two);
        rate_h[11] = -((t91 * t343 + (t70 * t344 + t347)) * two);
        rate_h[12] = t91 * t349 + (t70 * t350 + t355);
        rate_h[13] = t363 * two - t354 * (t126 * t362 - t71 * t361);
        rate_h[14] = t371 * two - t354 * (t126 * t370 - t71 * t369);
        rate_h[15] = -(t377 * two) - (t70 * t376 + t91 * t375);
        rate_h[16] = -((t91 * t379 + (t70 * t380 + t383)) * two);
        rate_h[17] = -((t91 * t385 + (t70 * t386 + t389)) * two);
        rate_h[18] = -(t91 * t390 + (t70 * t391 + t392));
    }
}
