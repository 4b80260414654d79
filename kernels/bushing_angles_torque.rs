// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Tait–Bryan angles in a bushing, with torques about its axes
///
/// `(a, b, c) = 0, Bᵀ A_iᵀ A_j B_j = R_x(a) R_y(b) R_z(c); torques about B = [x_i y_i z_i], B_j = [x_j y_j z_j]` (unit 1)
///
/// Source: rotations about x, then the new y, then the new z, whose product is solved for the angles; |b| < π/2.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `x_i` | 1 | body i | unit vector of the first bushing axis |
/// | 3..6 | `y_i` | 1 | body i | unit vector of the second bushing axis |
/// | 6..9 | `z_i` | 1 | body i | unit vector of the third bushing axis |
/// | 9..12 | `x_j` | 1 | body j | unit vector that lies along x_i at zero angles |
/// | 12..15 | `y_j` | 1 | body j | unit vector that lies along y_i at zero angles |
/// | 15..18 | `z_j` | 1 | body j | unit vector that lies along z_i at zero angles |
pub mod bushing_angles_torque {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "bushing_angles_torque",
        title: "Tait–Bryan angles in a bushing, with torques about its axes",
        equation: "(a, b, c) = 0, Bᵀ A_iᵀ A_j B_j = R_x(a) R_y(b) R_z(c); torques about B = [x_i y_i z_i], B_j = [x_j y_j z_j]",
        reference: "rotations about x, then the new y, then the new z, whose product is solved for the angles; |b| < π/2",
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
            Parameter {
                name: "x_j",
                size: 3,
                offset: 9,
                unit: "1",
                frame: "body j",
                meaning: "unit vector that lies along x_i at zero angles",
            },
            Parameter {
                name: "y_j",
                size: 3,
                offset: 12,
                unit: "1",
                frame: "body j",
                meaning: "unit vector that lies along y_i at zero angles",
            },
            Parameter {
                name: "z_j",
                size: 3,
                offset: 15,
                unit: "1",
                frame: "body j",
                meaning: "unit vector that lies along z_i at zero angles",
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
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 7),
            (0, 8),
            (0, 15),
            (0, 16),
            (0, 17),
            (1, 0),
            (1, 1),
            (1, 2),
            (1, 9),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (1, 14),
            (1, 15),
            (1, 16),
            (1, 17),
            (2, 0),
            (2, 1),
            (2, 2),
            (2, 9),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
            (2, 14),
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
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (0, 7),
            (0, 8),
            (0, 15),
            (0, 16),
            (0, 17),
            (1, 0),
            (1, 1),
            (1, 2),
            (1, 9),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (1, 14),
            (1, 15),
            (1, 16),
            (1, 17),
            (2, 0),
            (2, 1),
            (2, 2),
            (2, 9),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
            (2, 14),
        ],
        operations: [
            Operations {
                additions: 113,
                multiplications: 163,
                divisions: 0,
                functions: 4,
            },
            Operations {
                additions: 275,
                multiplications: 472,
                divisions: 4,
                functions: 4,
            },
            Operations {
                additions: 469,
                multiplications: 672,
                divisions: 4,
                functions: 4,
            },
            Operations {
                additions: 237,
                multiplications: 515,
                divisions: 4,
                functions: 1,
            },
            Operations {
                additions: 1110,
                multiplications: 1727,
                divisions: 4,
                functions: 1,
            },
        ],
    };
    /// Tait–Bryan angles in a bushing, with torques about its axes
    #[derive(Clone, Copy, Debug, Default)]
    pub struct BushingAnglesTorque;
    impl<S: Scalar> Relation<S> for BushingAnglesTorque {
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
    /// 113 additions, 163 multiplications, 0 divisions, 4 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        phi: &mut [S; 3],
    ) {
        let t0 = h[5] * q_i[6] + (h[3] * q_i[4] + q_i[5] * h[4]);
        let t1 = q_i[3] * h[5] + h[4] * q_i[4] - h[3] * q_i[5];
        let t2 = h[3] * q_i[6] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t3 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t4 = q_i[6] * t0 + (q_i[3] * t1 + q_i[4] * t2 - q_i[5] * t3);
        let t5 = h[17] * q_j[6] + (h[15] * q_j[4] + q_j[5] * h[16]);
        let t6 = q_j[3] * h[17] + h[16] * q_j[4] - h[15] * q_j[5];
        let t7 = h[15] * q_j[6] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t8 = q_j[3] * h[15] + q_j[5] * h[17] - q_j[6] * h[16];
        let t9 = q_j[6] * t5 + (q_j[3] * t6 + q_j[4] * t7 - q_j[5] * t8);
        let t10 = q_i[5] * t1 + (q_i[3] * t3 + q_i[4] * t0) - q_i[6] * t2;
        let t11 = q_j[5] * t6 + (q_j[3] * t8 + q_j[4] * t5) - q_j[6] * t7;
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t2 - q_i[4] * t1));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t7 - q_j[4] * t6));
        let t14 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t15 = q_i[3] * h[8] + q_i[4] * h[7] - q_i[5] * h[6];
        let t16 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t17 = q_i[3] * h[6] + q_i[5] * h[8] - q_i[6] * h[7];
        let t18 = q_i[6] * t14 + (q_i[3] * t15 + q_i[4] * t16 - q_i[5] * t17);
        let t19 = q_i[5] * t15 + (q_i[3] * t17 + q_i[4] * t14) - q_i[6] * t16;
        let t20 = q_i[6] * t17 + (q_i[5] * t14 + (q_i[3] * t16 - q_i[4] * t15));
        let t21 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t22 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t23 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t24 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t25 = q_i[6] * t21 + (q_i[3] * t22 + q_i[4] * t23 - q_i[5] * t24);
        let t26 = q_i[5] * t22 + (q_i[3] * t24 + q_i[4] * t21) - q_i[6] * t23;
        let t27 = q_i[6] * t24 + (q_i[5] * t21 + (q_i[3] * t23 - q_i[4] * t22));
        let t28 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t29 = q_j[3] * h[11] + q_j[4] * h[10] - q_j[5] * h[9];
        let t30 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t31 = q_j[3] * h[9] + q_j[5] * h[11] - q_j[6] * h[10];
        let t32 = q_j[6] * t28 + (q_j[3] * t29 + q_j[4] * t30 - q_j[5] * t31);
        let t33 = q_j[5] * t29 + (q_j[3] * t31 + q_j[4] * t28) - q_j[6] * t30;
        let t34 = q_j[6] * t31 + (q_j[5] * t28 + (q_j[3] * t30 - q_j[4] * t29));
        let t35 = t25 * t32 + (t26 * t33 + t27 * t34);
        let t36 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t37 = q_j[3] * h[14] + q_j[4] * h[13] - q_j[5] * h[12];
        let t38 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t39 = q_j[3] * h[12] + q_j[5] * h[14] - q_j[6] * h[13];
        let t40 = q_j[6] * t36 + (q_j[3] * t37 + q_j[4] * t38 - q_j[5] * t39);
        let t41 = q_j[5] * t37 + (q_j[3] * t39 + q_j[4] * t36) - q_j[6] * t38;
        let t42 = q_j[6] * t39 + (q_j[5] * t36 + (q_j[3] * t38 - q_j[4] * t37));
        let t43 = t25 * t40 + (t26 * t41 + t27 * t42);
        phi[0] = (-(t4 * t9 + (t10 * t11 + t12 * t13)))
            .atan2(t9 * t18 + (t11 * t19 + t13 * t20));
        phi[1] = (t9 * t25 + (t11 * t26 + t13 * t27))
            .atan2((t35 * t35 + t43 * t43).sqrt());
        phi[2] = (-t43).atan2(t35);
    }
    /// Φ, Φ_q and W.
    ///
    /// 275 additions, 472 multiplications, 4 divisions, 4 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        work: &mut [S; 24],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let t0 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t1 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t2 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t3 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = h[17] * q_j[6] + (q_j[4] * h[15] + h[16] * q_j[5]);
        let t6 = q_j[6] * h[15] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t7 = q_j[4] * h[16] + (h[17] * q_j[3] - h[15] * q_j[5]);
        let t8 = h[17] * q_j[5] + (q_j[3] * h[15] - h[16] * q_j[6]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t11 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t16 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t17 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t18 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = t9 * t19 + (t11 * t20 + t13 * t21);
        let t23 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t24 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t25 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t26 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t27 = q_i[6] * t23 + (q_i[4] * t24 + (q_i[3] * t25 - q_i[5] * t26));
        let t28 = q_i[5] * t25 + (q_i[4] * t23 + (q_i[3] * t26 - q_i[6] * t24));
        let t29 = q_i[6] * t26 + (q_i[5] * t23 + (q_i[3] * t24 - q_i[4] * t25));
        let t30 = t9 * t27 + (t11 * t28 + t13 * t29);
        let t31 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t32 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t33 = q_j[4] * h[10] + (q_j[3] * h[11] - q_j[5] * h[9]);
        let t34 = q_j[5] * h[11] + (q_j[3] * h[9] - q_j[6] * h[10]);
        let t35 = q_j[6] * t31 + (q_j[4] * t32 + (q_j[3] * t33 - q_j[5] * t34));
        let t36 = q_j[5] * t33 + (q_j[4] * t31 + (q_j[3] * t34 - q_j[6] * t32));
        let t37 = q_j[6] * t34 + (q_j[5] * t31 + (q_j[3] * t32 - q_j[4] * t33));
        let t38 = t27 * t35 + (t28 * t36 + t29 * t37);
        let t39 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t40 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t41 = q_j[4] * h[13] + (q_j[3] * h[14] - q_j[5] * h[12]);
        let t42 = q_j[5] * h[14] + (q_j[3] * h[12] - q_j[6] * h[13]);
        let t43 = q_j[6] * t39 + (q_j[4] * t40 + (q_j[3] * t41 - q_j[5] * t42));
        let t44 = q_j[5] * t41 + (q_j[4] * t39 + (q_j[3] * t42 - q_j[6] * t40));
        let t45 = q_j[6] * t42 + (q_j[5] * t39 + (q_j[3] * t40 - q_j[4] * t41));
        let t46 = t27 * t43 + (t28 * t44 + t29 * t45);
        let t47 = t38 * t38 + t46 * t46;
        let t48 = t47.sqrt();
        let t49 = one / (t14 * t14 + t22 * t22);
        let t50 = t14 * t49;
        let t51 = t22 * t49;
        let t52 = (t9 * t17 + (t11 * t18 + t13 * t16)) * t50
            - (t2 * t9 + (t3 * t11 + t1 * t13)) * t51;
        let t53 = t50 * (t9 * t16 + (t11 * t15 - t13 * t17))
            - t51 * (t1 * t9 + (t0 * t11 - t2 * t13));
        let t54 = t50 * (t11 * t17 + (t13 * t15 - t9 * t18))
            - t51 * (t2 * t11 + (t0 * t13 - t3 * t9));
        let t55 = t50 * (t13 * t18 + (t9 * t15 - t11 * t16))
            - t51 * (t3 * t13 + (t0 * t9 - t1 * t11));
        let t56 = t50 * (t7 * t19 + (t8 * t20 + t6 * t21))
            - t51 * (t7 * t4 + (t10 * t8 + t6 * t12));
        let t57 = t50 * (t6 * t19 + (t5 * t20 - t7 * t21))
            - t51 * (t6 * t4 + (t10 * t5 - t7 * t12));
        let t58 = t50 * (t5 * t21 + (t7 * t20 - t8 * t19))
            - t51 * (t5 * t12 + (t10 * t7 - t8 * t4));
        let t59 = t50 * (t5 * t19 + (t8 * t21 - t6 * t20))
            - t51 * (t5 * t4 + (t8 * t12 - t10 * t6));
        let t60 = one / (t48 * t48 + t30 * t30);
        let t61 = t48 * t60;
        let t62 = t25 * t35 + (t26 * t36 + t24 * t37);
        let t63 = t25 * t43 + (t26 * t44 + t24 * t45);
        let t64 = one / t48;
        let t65 = t30 * t60;
        let t66 = (t9 * t25 + (t11 * t26 + t13 * t24)) * t61
            - (t38 * t62 + t46 * t63) * t64 * t65;
        let t67 = t24 * t35 + (t23 * t36 - t25 * t37);
        let t68 = t24 * t43 + (t23 * t44 - t25 * t45);
        let t69 = t61 * (t9 * t24 + (t11 * t23 - t13 * t25))
            - t65 * (t64 * (t38 * t67 + t46 * t68));
        let t70 = t25 * t36 + (t23 * t37 - t26 * t35);
        let t71 = t25 * t44 + (t23 * t45 - t26 * t43);
        let t72 = t61 * (t11 * t25 + (t13 * t23 - t9 * t26))
            - t65 * (t64 * (t38 * t70 + t46 * t71));
        let t73 = t26 * t37 + (t23 * t35 - t24 * t36);
        let t74 = t26 * t45 + (t23 * t43 - t24 * t44);
        let t75 = t61 * (t13 * t26 + (t9 * t23 - t11 * t24))
            - t65 * (t64 * (t38 * t73 + t46 * t74));
        let t76 = t27 * t33 + (t28 * t34 + t29 * t32);
        let t77 = t27 * t41 + (t28 * t42 + t29 * t40);
        let t78 = t61 * (t7 * t27 + (t8 * t28 + t6 * t29))
            - t65 * (t64 * (t38 * t76 + t46 * t77));
        let t79 = t27 * t32 + (t28 * t31 - t29 * t33);
        let t80 = t27 * t40 + (t28 * t39 - t29 * t41);
        let t81 = t61 * (t6 * t27 + (t5 * t28 - t7 * t29))
            - t65 * (t64 * (t38 * t79 + t46 * t80));
        let t82 = t29 * t31 + (t28 * t33 - t27 * t34);
        let t83 = t29 * t39 + (t28 * t41 - t27 * t42);
        let t84 = t61 * (t5 * t29 + (t7 * t28 - t8 * t27))
            - t65 * (t64 * (t38 * t82 + t46 * t83));
        let t85 = t27 * t31 + (t29 * t34 - t28 * t32);
        let t86 = t27 * t39 + (t29 * t42 - t28 * t40);
        let t87 = t61 * (t5 * t27 + (t8 * t29 - t6 * t28))
            - t65 * (t64 * (t38 * t85 + t46 * t86));
        let t88 = one / t47;
        let t89 = t46 * t88;
        let t90 = t38 * t88;
        let t91 = q_i[6] * two;
        let t92 = q_i[4] * two;
        let t93 = q_i[5] * two;
        let t94 = q_i[3] * two;
        let t95 = q_j[4] * two;
        let t96 = q_j[5] * two;
        let t97 = q_j[6] * two;
        let t98 = q_j[3] * two;
        phi[0] = (-t14).atan2(t22);
        phi[1] = t30.atan2(t48);
        phi[2] = (-t46).atan2(t38);
        phi_q[0] = t52 * two;
        phi_q[1] = t53 * two;
        phi_q[2] = t54 * two;
        phi_q[3] = t55 * two;
        phi_q[4] = t56 * two;
        phi_q[5] = t57 * two;
        phi_q[6] = t58 * two;
        phi_q[7] = t59 * two;
        phi_q[8] = t66 * two;
        phi_q[9] = t69 * two;
        phi_q[10] = t72 * two;
        phi_q[11] = t75 * two;
        phi_q[12] = t78 * two;
        phi_q[13] = t81 * two;
        phi_q[14] = t84 * two;
        phi_q[15] = t87 * two;
        phi_q[16] = (t62 * t89 - t63 * t90) * two;
        phi_q[17] = (t67 * t89 - t68 * t90) * two;
        phi_q[18] = (t70 * t89 - t71 * t90) * two;
        phi_q[19] = (t73 * t89 - t74 * t90) * two;
        phi_q[20] = (t76 * t89 - t77 * t90) * two;
        phi_q[21] = (t79 * t89 - t80 * t90) * two;
        phi_q[22] = (t82 * t89 - t83 * t90) * two;
        phi_q[23] = (t85 * t89 - t86 * t90) * two;
        work[0] = t27 * t91 + (t28 * t92 + t29 * t93);
        work[1] = t27 * t93 - t28 * t94 - t29 * t91;
        work[2] = t28 * t91 - t29 * t94 - t27 * t92;
        work[3] = t29 * t92 - t27 * t94 - t28 * t93;
        work[4] = -(t28 * t95) - t29 * t96 - t27 * t97;
        work[5] = t29 * t97 + (t28 * t98 - t27 * t96);
        work[6] = t27 * t95 + (t29 * t98 - t28 * t97);
        work[7] = t28 * t96 + (t27 * t98 - t29 * t95);
        work[8] = t4 * t91 + (t10 * t92 + t12 * t93);
        work[9] = t4 * t93 - t10 * t94 - t12 * t91;
        work[10] = t10 * t91 - t12 * t94 - t4 * t92;
        work[11] = t12 * t92 - t4 * t94 - t10 * t93;
        work[12] = -(t10 * t95) - t12 * t96 - t4 * t97;
        work[13] = t12 * t97 + (t10 * t98 - t4 * t96);
        work[14] = t4 * t95 + (t12 * t98 - t10 * t97);
        work[15] = t10 * t96 + (t4 * t98 - t12 * t95);
        work[16] = t19 * t91 + (t20 * t92 + t21 * t93);
        work[17] = t19 * t93 - t20 * t94 - t21 * t91;
        work[18] = t20 * t91 - t21 * t94 - t19 * t92;
        work[19] = t21 * t92 - t19 * t94 - t20 * t93;
        work[20] = -(t20 * t95) - t21 * t96 - t19 * t97;
        work[21] = t21 * t97 + (t20 * t98 - t19 * t96);
        work[22] = t19 * t95 + (t21 * t98 - t20 * t97);
        work[23] = t20 * t96 + (t19 * t98 - t21 * t95);
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 469 additions, 672 multiplications, 4 divisions, 4 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        lambda: &[S; 3],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        work: &mut [S; 24],
        curvature: &mut [S; 44],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t1 = q_i[6] * t0;
        let t2 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t3 = q_i[4] * t2;
        let t4 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t5 = q_i[3] * t4;
        let t6 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t7 = q_i[5] * t6;
        let t8 = t1 + (t3 + (t5 - t7));
        let t9 = h[17] * q_j[6] + (q_j[4] * h[15] + h[16] * q_j[5]);
        let t10 = q_j[6] * h[15] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t11 = q_j[4] * h[16] + (h[17] * q_j[3] - h[15] * q_j[5]);
        let t12 = h[17] * q_j[5] + (q_j[3] * h[15] - h[16] * q_j[6]);
        let t13 = q_j[6] * t9 + (q_j[4] * t10 + (q_j[3] * t11 - q_j[5] * t12));
        let t14 = q_i[5] * t4;
        let t15 = q_i[4] * t0;
        let t16 = q_i[3] * t6;
        let t17 = q_i[6] * t2;
        let t18 = t14 + (t15 + (t16 - t17));
        let t19 = q_j[5] * t11 + (q_j[4] * t9 + (q_j[3] * t12 - q_j[6] * t10));
        let t20 = q_i[6] * t6;
        let t21 = q_i[5] * t0;
        let t22 = q_i[3] * t2;
        let t23 = q_i[4] * t4;
        let t24 = t20 + (t21 + (t22 - t23));
        let t25 = q_j[6] * t12 + (q_j[5] * t9 + (q_j[3] * t10 - q_j[4] * t11));
        let t26 = t8 * t13 + (t18 * t19 + t24 * t25);
        let t27 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t28 = q_i[6] * t27;
        let t29 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t30 = q_i[4] * t29;
        let t31 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t32 = q_i[3] * t31;
        let t33 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t34 = q_i[5] * t33;
        let t35 = t28 + (t30 + (t32 - t34));
        let t36 = q_i[5] * t31;
        let t37 = q_i[4] * t27;
        let t38 = q_i[3] * t33;
        let t39 = q_i[6] * t29;
        let t40 = t36 + (t37 + (t38 - t39));
        let t41 = q_i[6] * t33;
        let t42 = q_i[5] * t27;
        let t43 = q_i[3] * t29;
        let t44 = q_i[4] * t31;
        let t45 = t41 + (t42 + (t43 - t44));
        let t46 = t13 * t35 + (t19 * t40 + t25 * t45);
        let t47 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t48 = q_i[6] * t47;
        let t49 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t50 = q_i[4] * t49;
        let t51 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t52 = q_i[3] * t51;
        let t53 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t54 = q_i[5] * t53;
        let t55 = t48 + (t50 + (t52 - t54));
        let t56 = q_i[5] * t51;
        let t57 = q_i[4] * t47;
        let t58 = q_i[3] * t53;
        let t59 = q_i[6] * t49;
        let t60 = t56 + (t57 + (t58 - t59));
        let t61 = q_i[6] * t53;
        let t62 = q_i[5] * t47;
        let t63 = q_i[3] * t49;
        let t64 = q_i[4] * t51;
        let t65 = t61 + (t62 + (t63 - t64));
        let t66 = t13 * t55 + (t19 * t60 + t25 * t65);
        let t67 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t68 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t69 = q_j[4] * h[10] + (q_j[3] * h[11] - q_j[5] * h[9]);
        let t70 = q_j[5] * h[11] + (q_j[3] * h[9] - q_j[6] * h[10]);
        let t71 = q_j[6] * t67 + (q_j[4] * t68 + (q_j[3] * t69 - q_j[5] * t70));
        let t72 = q_j[5] * t69 + (q_j[4] * t67 + (q_j[3] * t70 - q_j[6] * t68));
        let t73 = q_j[6] * t70 + (q_j[5] * t67 + (q_j[3] * t68 - q_j[4] * t69));
        let t74 = t55 * t71 + (t60 * t72 + t65 * t73);
        let t75 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t76 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t77 = q_j[4] * h[13] + (q_j[3] * h[14] - q_j[5] * h[12]);
        let t78 = q_j[5] * h[14] + (q_j[3] * h[12] - q_j[6] * h[13]);
        let t79 = q_j[6] * t75 + (q_j[4] * t76 + (q_j[3] * t77 - q_j[5] * t78));
        let t80 = q_j[5] * t77 + (q_j[4] * t75 + (q_j[3] * t78 - q_j[6] * t76));
        let t81 = q_j[6] * t78 + (q_j[5] * t75 + (q_j[3] * t76 - q_j[4] * t77));
        let t82 = t55 * t79 + (t60 * t80 + t65 * t81);
        let t83 = t74 * t74 + t82 * t82;
        let t84 = t83.sqrt();
        let t85 = one / (t26 * t26 + t46 * t46);
        let t86 = t26 * t85;
        let t87 = t46 * t85;
        let t88 = (t13 * t31 + (t19 * t33 + t25 * t29)) * t86
            - (t4 * t13 + (t6 * t19 + t2 * t25)) * t87;
        let t89 = t86 * (t13 * t29 + (t19 * t27 - t25 * t31))
            - t87 * (t2 * t13 + (t0 * t19 - t4 * t25));
        let t90 = t86 * (t19 * t31 + (t25 * t27 - t13 * t33))
            - t87 * (t4 * t19 + (t0 * t25 - t6 * t13));
        let t91 = t86 * (t25 * t33 + (t13 * t27 - t19 * t29))
            - t87 * (t6 * t25 + (t0 * t13 - t2 * t19));
        let t92 = t86 * (t11 * t35 + (t12 * t40 + t10 * t45))
            - t87 * (t11 * t8 + (t18 * t12 + t10 * t24));
        let t93 = t86 * (t10 * t35 + (t9 * t40 - t11 * t45))
            - t87 * (t10 * t8 + (t18 * t9 - t11 * t24));
        let t94 = t86 * (t9 * t45 + (t11 * t40 - t12 * t35))
            - t87 * (t9 * t24 + (t18 * t11 - t12 * t8));
        let t95 = t86 * (t9 * t35 + (t12 * t45 - t10 * t40))
            - t87 * (t9 * t8 + (t12 * t24 - t18 * t10));
        let t96 = one / (t84 * t84 + t66 * t66);
        let t97 = t84 * t96;
        let t98 = t51 * t71 + (t53 * t72 + t49 * t73);
        let t99 = t51 * t79 + (t53 * t80 + t49 * t81);
        let t100 = one / t84;
        let t101 = t66 * t96;
        let t102 = (t13 * t51 + (t19 * t53 + t25 * t49)) * t97
            - (t74 * t98 + t82 * t99) * t100 * t101;
        let t103 = t49 * t71 + (t47 * t72 - t51 * t73);
        let t104 = t49 * t79 + (t47 * t80 - t51 * t81);
        let t105 = t97 * (t13 * t49 + (t19 * t47 - t25 * t51))
            - t101 * (t100 * (t74 * t103 + t82 * t104));
        let t106 = t51 * t72 + (t47 * t73 - t53 * t71);
        let t107 = t51 * t80 + (t47 * t81 - t53 * t79);
        let t108 = t97 * (t19 * t51 + (t25 * t47 - t13 * t53))
            - t101 * (t100 * (t74 * t106 + t82 * t107));
        let t109 = t53 * t73 + (t47 * t71 - t49 * t72);
        let t110 = t53 * t81 + (t47 * t79 - t49 * t80);
        let t111 = t97 * (t25 * t53 + (t13 * t47 - t19 * t49))
            - t101 * (t100 * (t74 * t109 + t82 * t110));
        let t112 = t55 * t69 + (t60 * t70 + t65 * t68);
        let t113 = t55 * t77 + (t60 * t78 + t65 * t76);
        let t114 = t97 * (t11 * t55 + (t12 * t60 + t10 * t65))
            - t101 * (t100 * (t74 * t112 + t82 * t113));
        let t115 = t55 * t68 + (t60 * t67 - t65 * t69);
        let t116 = t55 * t76 + (t60 * t75 - t65 * t77);
        let t117 = t97 * (t10 * t55 + (t9 * t60 - t11 * t65))
            - t101 * (t100 * (t74 * t115 + t82 * t116));
        let t118 = t65 * t67 + (t60 * t69 - t55 * t70);
        let t119 = t65 * t75 + (t60 * t77 - t55 * t78);
        let t120 = t97 * (t9 * t65 + (t11 * t60 - t12 * t55))
            - t101 * (t100 * (t74 * t118 + t82 * t119));
        let t121 = t55 * t67 + (t65 * t70 - t60 * t68);
        let t122 = t55 * t75 + (t65 * t78 - t60 * t76);
        let t123 = t97 * (t9 * t55 + (t12 * t65 - t10 * t60))
            - t101 * (t100 * (t74 * t121 + t82 * t122));
        let t124 = one / t83;
        let t125 = t82 * t124;
        let t126 = t74 * t124;
        let t127 = q_i[6] * two;
        let t128 = q_i[4] * two;
        let t129 = q_i[5] * two;
        let t130 = q_i[3] * two;
        let t131 = t65 * two;
        let t132 = t55 * two;
        let t133 = t60 * two;
        let t134 = q_j[4] * two;
        let t135 = q_j[5] * two;
        let t136 = q_j[6] * two;
        let t137 = q_j[3] * two;
        let t138 = t24 * two;
        let t139 = t8 * two;
        let t140 = t18 * two;
        let t141 = t45 * two;
        let t142 = t35 * two;
        let t143 = t40 * two;
        let t144 = lambda[1] * k4;
        let t145 = lambda[0] * k4;
        let t146 = t144 * (q_i[4] * t6) + t145 * (q_i[4] * t53);
        let t147 = t144 * (t2 * q_i[5]) + t145 * (q_i[5] * t49);
        let t148 = t146 + t147;
        let t149 = lambda[2] * k4;
        let t150 = t149 * (q_i[4] * t33);
        let t151 = t144 * (q_i[6] * t4) + t145 * (q_i[6] * t51);
        let t152 = t149 * (q_i[6] * t31);
        let t153 = t149 * (q_i[5] * t29);
        let t154 = t151 + (t152 + t153);
        let t155 = t14 * t144;
        let t156 = t56 * t145;
        let t157 = t57 * t145;
        let t158 = t36 * t149;
        let t159 = t37 * t149;
        let t160 = t15 * t144;
        let t161 = -t155 - t156 + (t157 - t158 + (t159 + t160));
        let t162 = t143 * lambda[2];
        let t163 = t140 * lambda[1];
        let t164 = t133 * lambda[0];
        let t165 = t162 + (t163 + t164);
        let t166 = t39 * t149;
        let t167 = t59 * t145;
        let t168 = t17 * t144;
        let t169 = t20 * t144;
        let t170 = t61 * t145;
        let t171 = t62 * t145;
        let t172 = t41 * t149;
        let t173 = t42 * t149;
        let t174 = t21 * t144;
        let t175 = -t169 - t170 + (t171 - t172 + (t173 + t174));
        let t176 = t141 * lambda[2];
        let t177 = t138 * lambda[1];
        let t178 = t131 * lambda[0];
        let t179 = t176 + (t177 + t178);
        let t180 = t44 * t149;
        let t181 = t64 * t145;
        let t182 = t23 * t144;
        let t183 = t3 * t144;
        let t184 = t50 * t145;
        let t185 = t48 * t145;
        let t186 = t30 * t149;
        let t187 = t28 * t149;
        let t188 = t1 * t144;
        let t189 = -t183 - t184 + (t185 - t186 + (t187 + t188));
        let t190 = t142 * lambda[2];
        let t191 = t139 * lambda[1];
        let t192 = t132 * lambda[0];
        let t193 = t190 + (t191 + t192);
        let t194 = t34 * t149;
        let t195 = t54 * t145;
        let t196 = t7 * t144;
        let t197 = t38 * t149;
        let t198 = t16 * t144;
        let t199 = t58 * t145;
        let t200 = -t197 - t198 + (-t168 - t167 + (-t199 - t166));
        let t201 = -t163 - t164 - t162;
        let t202 = -(t144 * (q_i[3] * t0)) - t145 * (q_i[3] * t47);
        let t203 = t149 * (q_i[3] * t27);
        let t204 = t5 * t144;
        let t205 = t52 * t145;
        let t206 = t32 * t149;
        let t207 = -t204 - t205 + (-t195 - t206 + (-t194 - t196));
        let t208 = -t177 - t178 - t176;
        let t209 = t43 * t149;
        let t210 = t22 * t144;
        let t211 = t63 * t145;
        let t212 = -t210 - t211 + (-t181 - t209 + (-t180 - t182));
        let t213 = -t191 - t192 - t190;
        let t214 = t202 + (t150 - t203);
        let t215 = -(t144 * (t6 * q_j[4])) - t145 * (q_j[4] * t53);
        let t216 = -(t144 * (t2 * q_j[5])) - t145 * (q_j[5] * t49);
        let t217 = t215 + t216;
        let t218 = -(t144 * (t4 * q_j[6])) - t145 * (q_j[6] * t51);
        let t219 = t149 * (q_j[6] * t31);
        let t220 = t149 * (q_j[5] * t29);
        let t221 = t218 + (-t219 - t220);
        let t222 = t149 * (q_j[4] * t33);
        let t223 = t144 * (t0 * q_j[4]);
        let t224 = t145 * (q_j[4] * t47);
        let t225 = t145 * (q_j[5] * t51);
        let t226 = t149 * (q_j[4] * t27);
        let t227 = t149 * (q_j[5] * t31);
        let t228 = t144 * (t4 * q_j[5]);
        let t229 = -t223 - t224 + (t225 - t226 + (t227 + t228));
        let t230 = t145 * (q_j[6] * t49);
        let t231 = t144 * (t2 * q_j[6]);
        let t232 = t149 * (q_j[6] * t29);
        let t233 = t144 * (t0 * q_j[5]);
        let t234 = t145 * (q_j[5] * t47);
        let t235 = t145 * (q_j[6] * t53);
        let t236 = t149 * (q_j[5] * t27);
        let t237 = t149 * (q_j[6] * t33);
        let t238 = t144 * (t6 * q_j[6]);
        let t239 = -t233 - t234 + (t235 - t236 + (t237 + t238));
        let t240 = t145 * (q_j[4] * t51);
        let t241 = t144 * (t4 * q_j[4]);
        let t242 = t149 * (q_j[4] * t31);
        let t243 = t144 * (t0 * q_j[6]);
        let t244 = t145 * (q_j[6] * t47);
        let t245 = t145 * (q_j[4] * t49);
        let t246 = t149 * (q_j[6] * t27);
        let t247 = t149 * (q_j[4] * t29);
        let t248 = t144 * (t2 * q_j[4]);
        let t249 = -t243 - t244 + (t245 - t246 + (t247 + t248));
        let t250 = t145 * (q_j[5] * t53);
        let t251 = t144 * (t6 * q_j[5]);
        let t252 = t149 * (q_j[5] * t33);
        let t253 = t144 * (t6 * q_j[3]);
        let t254 = t145 * (q_j[3] * t53);
        let t255 = t149 * (q_j[3] * t33);
        let t256 = t253 + t254 + (t230 + t255 + (t231 + t232));
        let t257 = t144 * (t0 * q_j[3]) + t145 * (q_j[3] * t47);
        let t258 = t149 * (q_j[3] * t27);
        let t259 = t144 * (t4 * q_j[3]);
        let t260 = t145 * (q_j[3] * t51);
        let t261 = t149 * (q_j[3] * t31);
        let t262 = t259 + t260 + (t250 + t261 + (t251 + t252));
        let t263 = t145 * (q_j[3] * t49);
        let t264 = t144 * (t2 * q_j[3]);
        let t265 = t149 * (q_j[3] * t29);
        let t266 = t263 + t264 + (t240 + t265 + (t241 + t242));
        let t267 = t257 + (t258 - t222);
        phi[0] = (-t26).atan2(t46);
        phi[1] = t66.atan2(t84);
        phi[2] = (-t82).atan2(t74);
        phi_q[0] = t88 * two;
        phi_q[1] = t89 * two;
        phi_q[2] = t90 * two;
        phi_q[3] = t91 * two;
        phi_q[4] = t92 * two;
        phi_q[5] = t93 * two;
        phi_q[6] = t94 * two;
        phi_q[7] = t95 * two;
        phi_q[8] = t102 * two;
        phi_q[9] = t105 * two;
        phi_q[10] = t108 * two;
        phi_q[11] = t111 * two;
        phi_q[12] = t114 * two;
        phi_q[13] = t117 * two;
        phi_q[14] = t120 * two;
        phi_q[15] = t123 * two;
        phi_q[16] = (t98 * t125 - t99 * t126) * two;
        phi_q[17] = (t103 * t125 - t104 * t126) * two;
        phi_q[18] = (t106 * t125 - t107 * t126) * two;
        phi_q[19] = (t109 * t125 - t110 * t126) * two;
        phi_q[20] = (t112 * t125 - t113 * t126) * two;
        phi_q[21] = (t115 * t125 - t116 * t126) * two;
        phi_q[22] = (t118 * t125 - t119 * t126) * two;
        phi_q[23] = (t121 * t125 - t122 * t126) * two;
        work[0] = t55 * t127 + (t60 * t128 + t65 * t129);
        work[1] = t55 * t129 - t60 * t130 - q_i[6] * t131;
        work[2] = t60 * t127 - t65 * t130 - q_i[4] * t132;
        work[3] = t65 * t128 - t55 * t130 - q_i[5] * t133;
        work[4] = -(t60 * t134) - t65 * t135 - t55 * t136;
        work[5] = q_j[6] * t131 + (t60 * t137 - t55 * t135);
        work[6] = q_j[4] * t132 + (t65 * t137 - t60 * t136);
        work[7] = q_j[5] * t133 + (t55 * t137 - t65 * t134);
        work[8] = t8 * t127 + (t18 * t128 + t24 * t129);
        work[9] = t8 * t129 - t18 * t130 - q_i[6] * t138;
        work[10] = t18 * t127 - t24 * t130 - q_i[4] * t139;
        work[11] = t24 * t128 - t8 * t130 - q_i[5] * t140;
        work[12] = -(t18 * t134) - t24 * t135 - t8 * t136;
        work[13] = q_j[6] * t138 + (t18 * t137 - t8 * t135);
        work[14] = q_j[4] * t139 + (t24 * t137 - t18 * t136);
        work[15] = q_j[5] * t140 + (t8 * t137 - t24 * t134);
        work[16] = t35 * t127 + (t40 * t128 + t45 * t129);
        work[17] = t35 * t129 - t40 * t130 - q_i[6] * t141;
        work[18] = t40 * t127 - t45 * t130 - q_i[4] * t142;
        work[19] = t45 * t128 - t35 * t130 - q_i[5] * t143;
        work[20] = -(t40 * t134) - t45 * t135 - t35 * t136;
        work[21] = q_j[6] * t141 + (t40 * t137 - t35 * t135);
        work[22] = q_j[4] * t142 + (t45 * t137 - t40 * t136);
        work[23] = q_j[5] * t143 + (t35 * t137 - t45 * t134);
        curvature[0] = t148 + (t150 + t154);
        curvature[1] = t161 + (t165 + (t166 + (t167 + t168)));
        curvature[2] = t175 + (t179 + (t180 + (t181 + t182)));
        curvature[3] = t189 + (t193 + (t194 + (t195 + t196)));
        curvature[4] = t200 + (t201 + (t158 + (t155 + t156)));
        curvature[5] = t202 + (t154 + t147 - t203);
        curvature[6] = t207 + (t193 - t185 - t188 - t187);
        curvature[7] = t208 + (t209 + (t210 + (t175 + t211)));
        curvature[8] = t212 + (t172 + (t169 + (t170 + t208)));
        curvature[9] = t213 + (t206 + (t204 + (t189 + t205)));
        curvature[10] = t214 + (t151 + (t152 + t146));
        curvature[11] = t165 + t200 - t157 - t160 - t159;
        curvature[12] = t186 + (t183 + (t184 + (t207 + t213)));
        curvature[13] = t179 + t212 - t171 - t174 - t173;
        curvature[14] = t197 + (t198 + (t199 + (t161 + t201)));
        curvature[15] = t214 + (t153 + t148);
        curvature[16] = t217 + (t221 - t222);
        curvature[17] = t229 - t230 - t231 - t232;
        curvature[18] = t239 - t240 - t241 - t242;
        curvature[19] = t249 - t250 - t251 - t252;
        curvature[20] = t201;
        curvature[21] = t208;
        curvature[22] = t213;
        curvature[23] = t256 - t225 - t228 - t227;
        curvature[24] = t257 + (t258 + (t221 + t216));
        curvature[25] = t262 + (t246 + (t243 + t244));
        curvature[26] = t239 - t263 - t264 - t265;
        curvature[27] = t165;
        curvature[28] = t213;
        curvature[29] = t179;
        curvature[30] = t266 - t235 - t238 - t237;
        curvature[31] = t249 - t260 - t259 - t261;
        curvature[32] = t267 + (t218 + (t215 - t219));
        curvature[33] = t226 + (t223 + (t224 + t256));
        curvature[34] = t179;
        curvature[35] = t193;
        curvature[36] = t201;
        curvature[37] = t262 - t245 - t248 - t247;
        curvature[38] = t236 + (t233 + (t234 + t266));
        curvature[39] = t229 - t254 - t253 - t255;
        curvature[40] = t267 + (t217 - t220);
        curvature[41] = t193;
        curvature[42] = t208;
        curvature[43] = t165;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 237 additions, 515 multiplications, 4 divisions, 1 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        lambda: &[S; 3],
        phi_h: &mut [S; 30],
        force_h: &mut [S; 72],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = h[8] * q_i[6] + (q_i[4] * h[6] + h[7] * q_i[5]);
        let t1 = q_i[6] * h[6] + (q_i[3] * h[7] - h[8] * q_i[4]);
        let t2 = q_i[4] * h[7] + (h[8] * q_i[3] - h[6] * q_i[5]);
        let t3 = h[8] * q_i[5] + (q_i[3] * h[6] - h[7] * q_i[6]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = h[17] * q_j[6] + (q_j[4] * h[15] + h[16] * q_j[5]);
        let t6 = q_j[6] * h[15] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t7 = q_j[4] * h[16] + (h[17] * q_j[3] - h[15] * q_j[5]);
        let t8 = h[17] * q_j[5] + (q_j[3] * h[15] - h[16] * q_j[6]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t11 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t16 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t17 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t18 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = t9 * t19 + (t11 * t20 + t13 * t21);
        let t23 = one / (t22 * t22 + t14 * t14);
        let t24 = t14 * t23;
        let t25 = q_i[4] * q_i[6];
        let t26 = q_i[3] * q_i[5];
        let t27 = t25 - t26;
        let t28 = q_i[3] * q_i[6];
        let t29 = q_i[4] * q_i[5];
        let t30 = t28 + t29;
        let t31 = q_i[3] * q_i[3];
        let t32 = q_i[4] * q_i[4];
        let t33 = q_i[6] * q_i[6];
        let t34 = q_i[5] * q_i[5];
        let t35 = t31 + t32 - t33 - t34;
        let t36 = (t9 * t27 + t13 * t30) * two + t11 * t35;
        let t37 = q_i[4] * q_i[3];
        let t38 = q_i[6] * q_i[5];
        let t39 = t37 + t38;
        let t40 = t31 - t32;
        let t41 = t34 - t33;
        let t42 = t40 + t41;
        let t43 = t42 * half;
        let t44 = t29 - t28;
        let t45 = t9 * t39 + (t13 * t43 + t11 * t44);
        let t46 = t38 - t37;
        let t47 = t40 - t41;
        let t48 = t47 * half;
        let t49 = t26 + t25;
        let t50 = t13 * t46 + (t9 * t48 + t11 * t49);
        let t51 = t22 * t23;
        let t52 = q_j[4] * q_j[6];
        let t53 = q_j[3] * q_j[5];
        let t54 = t52 - t53;
        let t55 = q_j[3] * q_j[6];
        let t56 = q_j[4] * q_j[5];
        let t57 = t55 + t56;
        let t58 = q_j[3] * q_j[3];
        let t59 = q_j[4] * q_j[4];
        let t60 = q_j[6] * q_j[6];
        let t61 = q_j[5] * q_j[5];
        let t62 = t58 + t59 - t60 - t61;
        let t63 = t51 * ((t4 * t54 + t12 * t57) * two + t10 * t62);
        let t64 = t24 * ((t19 * t54 + t21 * t57) * two + t20 * t62);
        let t65 = q_j[4] * q_j[3];
        let t66 = q_j[6] * q_j[5];
        let t67 = t65 + t66;
        let t68 = t58 - t59;
        let t69 = t61 - t60;
        let t70 = (t68 + t69) * half;
        let t71 = t56 - t55;
        let t72 = t51 * (t4 * t67 + (t12 * t70 + t10 * t71))
            - t24 * (t19 * t67 + (t21 * t70 + t20 * t71));
        let t73 = t66 - t65;
        let t74 = (t68 - t69) * half;
        let t75 = t53 + t52;
        let t76 = t51 * (t12 * t73 + (t4 * t74 + t10 * t75))
            - t24 * (t21 * t73 + (t19 * t74 + t20 * t75));
        let t77 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t78 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t79 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t80 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t81 = q_i[6] * t77 + (q_i[4] * t78 + (q_i[3] * t79 - q_i[5] * t80));
        let t82 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t83 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t84 = q_j[4] * h[10] + (q_j[3] * h[11] - q_j[5] * h[9]);
        let t85 = q_j[5] * h[11] + (q_j[3] * h[9] - q_j[6] * h[10]);
        let t86 = q_j[6] * t82 + (q_j[4] * t83 + (q_j[3] * t84 - q_j[5] * t85));
        let t87 = q_i[5] * t79 + (q_i[4] * t77 + (q_i[3] * t80 - q_i[6] * t78));
        let t88 = q_j[5] * t84 + (q_j[4] * t82 + (q_j[3] * t85 - q_j[6] * t83));
        let t89 = q_i[6] * t80 + (q_i[5] * t77 + (q_i[3] * t78 - q_i[4] * t79));
        let t90 = q_j[6] * t85 + (q_j[5] * t82 + (q_j[3] * t83 - q_j[4] * t84));
        let t91 = t81 * t86 + (t87 * t88 + t89 * t90);
        let t92 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t93 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t94 = q_j[4] * h[13] + (q_j[3] * h[14] - q_j[5] * h[12]);
        let t95 = q_j[5] * h[14] + (q_j[3] * h[12] - q_j[6] * h[13]);
        let t96 = q_j[6] * t92 + (q_j[4] * t93 + (q_j[3] * t94 - q_j[5] * t95));
        let t97 = q_j[5] * t94 + (q_j[4] * t92 + (q_j[3] * t95 - q_j[6] * t93));
        let t98 = q_j[6] * t95 + (q_j[5] * t92 + (q_j[3] * t93 - q_j[4] * t94));
        let t99 = t81 * t96 + (t87 * t97 + t89 * t98);
        let t100 = t91 * t91 + t99 * t99;
        let t101 = t100.sqrt();
        let t102 = t9 * t81 + (t11 * t87 + t13 * t89);
        let t103 = one / (t101 * t101 + t102 * t102);
        let t104 = t101 * t103;
        let t105 = one / t101;
        let t106 = (t27 * t86 + t30 * t90) * two + t35 * t88;
        let t107 = (t27 * t96 + t30 * t98) * two + t35 * t97;
        let t108 = t102 * t103;
        let t109 = t39 * t86 + (t43 * t90 + t44 * t88);
        let t110 = t39 * t96 + (t43 * t98 + t44 * t97);
        let t111 = t45 * t104 - t108 * (t105 * (t91 * t109 + t99 * t110));
        let t112 = t46 * t90 + (t48 * t86 + t49 * t88);
        let t113 = t46 * t98 + (t48 * t96 + t49 * t97);
        let t114 = t50 * t104 - t108 * (t105 * (t91 * t112 + t99 * t113));
        let t115 = (t54 * t81 + t57 * t89) * two + t62 * t87;
        let t116 = t67 * t81 + (t70 * t89 + t71 * t87);
        let t117 = t73 * t89 + (t74 * t81 + t75 * t87);
        let t118 = one / t100;
        let t119 = t99 * t118;
        let t120 = t91 * t118;
        let t121 = (q_i[6] * t27 + q_i[5] * t30) * two + q_i[4] * t35;
        let t122 = lambda[0] * two;
        let t123 = t44 * two;
        let t124 = t39 * two;
        let t125 = q_i[4] * t123 + (q_i[6] * t124 + q_i[5] * t42);
        let t126 = t49 * two;
        let t127 = t46 * two;
        let t128 = q_i[4] * t126 + (q_i[6] * t47 + q_i[5] * t127);
        let t129 = lambda[1] * two;
        let t130 = lambda[2] * two;
        let t131 = (q_i[5] * t27 - q_i[6] * t30) * two - q_i[3] * t35;
        let t132 = q_i[3] * two;
        let t133 = q_i[5] * t124 - q_i[6] * t42 - t44 * t132;
        let t134 = q_i[5] * t47 - q_i[6] * t127 - t49 * t132;
        let t135 = q_i[6] * t35 - q_i[4] * t27 * two - t30 * t132;
        let t136 = (q_i[6] * t44 - q_i[4] * t39) * two - q_i[3] * t42;
        let t137 = q_i[6] * t126 - q_i[4] * t47 - t46 * t132;
        let t138 = q_i[4] * t30 * two - q_i[5] * t35 - t27 * t132;
        let t139 = q_i[4] * t42 - q_i[5] * t123 - t39 * t132;
        let t140 = (q_i[4] * t46 - q_i[5] * t49) * two - q_i[3] * t47;
        let t141 = (-(q_j[6] * t27) - q_j[5] * t30) * two - q_j[4] * t35;
        let t142 = -(q_j[6] * t124) - q_j[5] * t42 - q_j[4] * t123;
        let t143 = -(q_j[6] * t47) - q_j[5] * t127 - q_j[4] * t126;
        let t144 = (q_j[6] * t30 - q_j[5] * t27) * two + q_j[3] * t35;
        let t145 = q_j[3] * two;
        let t146 = q_j[6] * t42 + t44 * t145 - q_j[5] * t124;
        let t147 = q_j[6] * t127 + t49 * t145 - q_j[5] * t47;
        let t148 = t30 * t145 + (q_j[4] * t27 * two - q_j[6] * t35);
        let t149 = (q_j[4] * t39 - q_j[6] * t44) * two + q_j[3] * t42;
        let t150 = t46 * t145 + (q_j[4] * t47 - q_j[6] * t126);
        let t151 = q_j[5] * t35 + t27 * t145 - q_j[4] * t30 * two;
        let t152 = q_j[5] * t123 + t39 * t145 - q_j[4] * t42;
        let t153 = (q_j[5] * t49 - q_j[4] * t46) * two + q_j[3] * t47;
        phi_h[0] = -(t24 * t36);
        phi_h[1] = -(t24 * t45 * two);
        phi_h[2] = -(t24 * t50 * two);
        phi_h[3] = t36 * t51;
        phi_h[4] = t45 * t51 * two;
        phi_h[5] = t50 * t51 * two;
        phi_h[6] = t63 - t64;
        phi_h[7] = t72 * two;
        phi_h[8] = t76 * two;
        phi_h[9] = t36 * t104 - t105 * (t91 * t106 + t99 * t107) * t108;
        phi_h[10] = t111 * two;
        phi_h[11] = t114 * two;
        phi_h[12] = -(t108 * (t105 * (t91 * t115)));
        phi_h[13] = -(t108 * (t105 * (t91 * t116)) * two);
        phi_h[14] = -(t108 * (t105 * (t91 * t117)) * two);
        phi_h[15] = -(t108 * (t105 * (t99 * t115)));
        phi_h[16] = -(t108 * (t105 * (t99 * t116)) * two);
        phi_h[17] = -(t108 * (t105 * (t99 * t117)) * two);
        phi_h[18] = t104 * t115;
        phi_h[19] = t104 * t116 * two;
        phi_h[20] = t104 * t117 * two;
        phi_h[21] = t106 * t119 - t107 * t120;
        phi_h[22] = (t109 * t119 - t110 * t120) * two;
        phi_h[23] = (t112 * t119 - t113 * t120) * two;
        phi_h[24] = t115 * t119;
        phi_h[25] = t116 * t119 * two;
        phi_h[26] = t117 * t119 * two;
        phi_h[27] = -(t115 * t120);
        phi_h[28] = -(t116 * t120 * two);
        phi_h[29] = -(t117 * t120 * two);
        force_h[0] = t121 * t122;
        force_h[1] = t122 * t125;
        force_h[2] = t122 * t128;
        force_h[3] = t121 * t129;
        force_h[4] = t125 * t129;
        force_h[5] = t128 * t129;
        force_h[6] = t121 * t130;
        force_h[7] = t125 * t130;
        force_h[8] = t128 * t130;
        force_h[9] = t122 * t131;
        force_h[10] = t122 * t133;
        force_h[11] = t122 * t134;
        force_h[12] = t129 * t131;
        force_h[13] = t129 * t133;
        force_h[14] = t129 * t134;
        force_h[15] = t130 * t131;
        force_h[16] = t130 * t133;
        force_h[17] = t130 * t134;
        force_h[18] = t122 * t135;
        force_h[19] = t122 * t136;
        force_h[20] = t122 * t137;
        force_h[21] = t129 * t135;
        force_h[22] = t129 * t136;
        force_h[23] = t129 * t137;
        force_h[24] = t130 * t135;
        force_h[25] = t130 * t136;
        force_h[26] = t130 * t137;
        force_h[27] = t122 * t138;
        force_h[28] = t122 * t139;
        force_h[29] = t122 * t140;
        force_h[30] = t129 * t138;
        force_h[31] = t129 * t139;
        force_h[32] = t129 * t140;
        force_h[33] = t130 * t138;
        force_h[34] = t130 * t139;
        force_h[35] = t130 * t140;
        force_h[36] = t122 * t141;
        force_h[37] = t122 * t142;
        force_h[38] = t122 * t143;
        force_h[39] = t129 * t141;
        force_h[40] = t129 * t142;
        force_h[41] = t129 * t143;
        force_h[42] = t130 * t141;
        force_h[43] = t130 * t142;
        force_h[44] = t130 * t143;
        force_h[45] = t122 * t144;
        force_h[46] = t122 * t146;
        force_h[47] = t122 * t147;
        force_h[48] = t129 * t144;
        force_h[49] = t129 * t146;
        force_h[50] = t129 * t147;
        force_h[51] = t130 * t144;
        force_h[52] = t130 * t146;
        force_h[53] = t130 * t147;
        force_h[54] = t122 * t148;
        force_h[55] = t122 * t149;
        force_h[56] = t122 * t150;
        force_h[57] = t129 * t148;
        force_h[58] = t129 * t149;
        force_h[59] = t129 * t150;
        force_h[60] = t130 * t148;
        force_h[61] = t130 * t149;
        force_h[62] = t130 * t150;
        force_h[63] = t122 * t151;
        force_h[64] = t122 * t152;
        force_h[65] = t122 * t153;
        force_h[66] = t129 * t151;
        force_h[67] = t129 * t152;
        force_h[68] = t129 * t153;
        force_h[69] = t130 * t151;
        force_h[70] = t130 * t152;
        force_h[71] = t130 * t153;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 1110 additions, 1727 multiplications, 4 divisions, 1 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 24],
        rate_h: &mut [S; 30],
    ) {
        let one = S::from_f64(1.0);
        let half = S::from_f64(0.5);
        let two = S::from_f64(2.0);
        let t0 = h[5] * q_i[6] + (q_i[4] * h[3] + h[4] * q_i[5]);
        let t1 = q_i[6] * h[3] + (q_i[3] * h[4] - h[5] * q_i[4]);
        let t2 = q_i[4] * h[4] + (h[5] * q_i[3] - h[3] * q_i[5]);
        let t3 = h[5] * q_i[5] + (q_i[3] * h[3] - h[4] * q_i[6]);
        let t4 = q_i[6] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[5] * t3));
        let t5 = h[17] * q_j[6] + (q_j[4] * h[15] + h[16] * q_j[5]);
        let t6 = q_j[6] * h[15] + (q_j[3] * h[16] - h[17] * q_j[4]);
        let t7 = q_j[4] * h[16] + (h[17] * q_j[3] - h[15] * q_j[5]);
        let t8 = h[17] * q_j[5] + (q_j[3] * h[15] - h[16] * q_j[6]);
        let t9 = q_j[6] * t5 + (q_j[4] * t6 + (q_j[3] * t7 - q_j[5] * t8));
        let t10 = q_i[5] * t2 + (q_i[4] * t0 + (q_i[3] * t3 - q_i[6] * t1));
        let t11 = q_j[5] * t7 + (q_j[4] * t5 + (q_j[3] * t8 - q_j[6] * t6));
        let t12 = q_i[6] * t3 + (q_i[5] * t0 + (q_i[3] * t1 - q_i[4] * t2));
        let t13 = q_j[6] * t8 + (q_j[5] * t5 + (q_j[3] * t6 - q_j[4] * t7));
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t16 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t17 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t18 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t19 = q_i[6] * t15 + (q_i[4] * t16 + (q_i[3] * t17 - q_i[5] * t18));
        let t20 = q_i[5] * t17 + (q_i[4] * t15 + (q_i[3] * t18 - q_i[6] * t16));
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t16 - q_i[4] * t17));
        let t22 = t9 * t19 + (t11 * t20 + t13 * t21);
        let t23 = one / (t14 * t14 + t22 * t22);
        let t24 = t14 * t23;
        let t25 = h[8] * v_i[3] + (h[7] * v_i[4] - h[6] * v_i[5]);
        let t26 = h[7] * v_i[3] + (h[6] * v_i[6] - h[8] * v_i[4]);
        let t27 = h[8] * v_i[5] + (h[6] * v_i[3] - h[7] * v_i[6]);
        let t28 = h[17] * v_j[6] + (h[15] * v_j[4] + h[16] * v_j[5]);
        let t29 = h[16] * v_j[3] + (h[15] * v_j[6] - h[17] * v_j[4]);
        let t30 = h[17] * v_j[3] + (h[16] * v_j[4] - h[15] * v_j[5]);
        let t31 = h[17] * v_j[5] + (h[15] * v_j[3] - h[16] * v_j[6]);
        let t32 = q_j[4] * t29 + (q_j[3] * t30 - q_j[5] * t31 - t8 * v_j[5]);
        let t33 = t5 * v_j[6] + (t6 * v_j[4] + (t7 * v_j[3] + (q_j[6] * t28 + t32)));
        let t34 = q_j[4] * t28 + (q_j[3] * t31 - q_j[6] * t29 - t6 * v_j[6]);
        let t35 = t7 * v_j[5] + (t5 * v_j[4] + (t8 * v_j[3] + (q_j[5] * t30 + t34)));
        let t36 = q_j[5] * t28 + (q_j[3] * t29 - q_j[4] * t30 - t7 * v_j[4]);
        let t37 = t8 * v_j[6] + (t5 * v_j[5] + (t6 * v_j[3] + (q_j[6] * t31 + t36)));
        let t38 = t11 * t27 + (t17 * t33 + (t18 * t35 + t16 * t37));
        let t39 = t2 * t9 + (t3 * t11 + t1 * t13);
        let t40 = t23 * half;
        let t41 = t9 * t17 + (t11 * t18 + t13 * t16);
        let t42 = t23 * t23;
        let t43 = (t14 * t39 + t22 * t41) * t42;
        let t44 = h[8] * v_i[6] + (h[6] * v_i[4] + h[7] * v_i[5]);
        let t45 = q_i[4] * t26 + (q_i[3] * t25 - q_i[5] * t27 - t18 * v_i[5]);
        let t46 = t15 * v_i[6] + (t16 * v_i[4] + (t17 * v_i[3] + (q_i[6] * t44 + t45)));
        let t47 = q_i[5] * t44 + (q_i[3] * t26 - q_i[4] * t25 - t17 * v_i[4]);
        let t48 = t18 * v_i[6] + (t15 * v_i[5] + (t16 * v_i[3] + (q_i[6] * t27 + t47)));
        let t49 = q_i[4] * t44 + (q_i[3] * t27 - q_i[6] * t26 - t16 * v_i[6]);
        let t50 = t17 * v_i[5] + (t15 * v_i[4] + (t18 * v_i[3] + (q_i[5] * t25 + t49)));
        let t51 = t11 * t50 + (t19 * t33 + (t20 * t35 + t21 * t37));
        let t52 = t9 * t46 + (t13 * t48 + t51);
        let t53 = t52 * two;
        let t54 = h[5] * v_i[6] + (h[3] * v_i[4] + h[4] * v_i[5]);
        let t55 = h[4] * v_i[3] + (h[3] * v_i[6] - h[5] * v_i[4]);
        let t56 = h[5] * v_i[3] + (h[4] * v_i[4] - h[3] * v_i[5]);
        let t57 = h[5] * v_i[5] + (h[3] * v_i[3] - h[4] * v_i[6]);
        let t58 = q_i[4] * t55 + (q_i[3] * t56 - q_i[5] * t57 - t3 * v_i[5]);
        let t59 = t0 * v_i[6] + (t1 * v_i[4] + (t2 * v_i[3] + (q_i[6] * t54 + t58)));
        let t60 = q_i[5] * t54 + (q_i[3] * t55 - q_i[4] * t56 - t2 * v_i[4]);
        let t61 = t3 * v_i[6] + (t0 * v_i[5] + (t1 * v_i[3] + (q_i[6] * t57 + t60)));
        let t62 = q_i[4] * t54 + (q_i[3] * t57 - q_i[6] * t55 - t1 * v_i[6]);
        let t63 = t2 * v_i[5] + (t0 * v_i[4] + (t3 * v_i[3] + (q_i[5] * t56 + t62)));
        let t64 = t11 * t63 + (t4 * t33 + (t10 * t35 + t12 * t37));
        let t65 = t9 * t59 + (t13 * t61 + t64);
        let t66 = t65 * two;
        let t67 = (t39 * t40 - t14 * t43) * t53 - (t41 * t40 - t22 * t43) * t66;
        let t68 = t11 * t57 + (t2 * t33 + (t3 * t35 + t1 * t37));
        let t69 = t22 * t23;
        let t70 = t24 * (t9 * t25 + (t13 * t26 + t38))
            + (t67 - (t9 * t56 + (t13 * t55 + t68)) * t69);
        let t71 = t16 * t33 + (t15 * t35 - t17 * t37 - t13 * t25);
        let t72 = t1 * t9 + (t0 * t11 - t2 * t13);
        let t73 = t9 * t16 + (t11 * t15 - t13 * t17);
        let t74 = t42 * (t14 * t72 + t22 * t73);
        let t75 = t53 * (t40 * t72 - t14 * t74) - t66 * (t40 * t73 - t22 * t74);
        let t76 = t1 * t33 + (t0 * t35 - t2 * t37 - t13 * t56);
        let t77 = t24 * (t9 * t26 + (t11 * t44 + t71))
            + (t75 - t69 * (t9 * t55 + (t11 * t54 + t76)));
        let t78 = t17 * t35 + (t15 * t37 - t18 * t33 - t9 * t27);
        let t79 = t2 * t11 + (t0 * t13 - t3 * t9);
        let t80 = t11 * t17 + (t13 * t15 - t9 * t18);
        let t81 = t42 * (t14 * t79 + t22 * t80);
        let t82 = t53 * (t40 * t79 - t14 * t81) - t66 * (t40 * t80 - t22 * t81);
        let t83 = t2 * t35 + (t0 * t37 - t3 * t33 - t9 * t57);
        let t84 = t24 * (t13 * t44 + (t11 * t25 + t78))
            + (t82 - t69 * (t13 * t54 + (t11 * t56 + t83)));
        let t85 = t18 * t37 + (t15 * t33 - t16 * t35 - t11 * t26);
        let t86 = t3 * t13 + (t0 * t9 - t1 * t11);
        let t87 = t13 * t18 + (t9 * t15 - t11 * t16);
        let t88 = t42 * (t14 * t86 + t22 * t87);
        let t89 = t53 * (t40 * t86 - t14 * t88) - t66 * (t40 * t87 - t22 * t88);
        let t90 = t3 * t37 + (t0 * t33 - t1 * t35 - t11 * t55);
        let t91 = t24 * (t9 * t44 + (t13 * t27 + t85))
            + (t89 - t69 * (t9 * t54 + (t13 * t57 + t90)));
        let t92 = t8 * t50 + (t19 * t30 + (t20 * t31 + t21 * t29));
        let t93 = t7 * t4 + (t10 * t8 + t6 * t12);
        let t94 = t7 * t19 + (t8 * t20 + t6 * t21);
        let t95 = t42 * (t14 * t93 + t22 * t94);
        let t96 = t53 * (t40 * t93 - t14 * t95) - t66 * (t40 * t94 - t22 * t95);
        let t97 = t8 * t63 + (t4 * t30 + (t10 * t31 + t12 * t29));
        let t98 = t24 * (t7 * t46 + (t6 * t48 + t92))
            + (t96 - t69 * (t7 * t59 + (t6 * t61 + t97)));
        let t99 = t19 * t29 + (t20 * t28 - t21 * t30 - t7 * t48);
        let t100 = t6 * t4 + (t10 * t5 - t7 * t12);
        let t101 = t6 * t19 + (t5 * t20 - t7 * t21);
        let t102 = t42 * (t14 * t100 + t22 * t101);
        let t103 = t53 * (t40 * t100 - t14 * t102) - t66 * (t40 * t101 - t22 * t102);
        let t104 = t4 * t29 + (t10 * t28 - t12 * t30 - t7 * t61);
        let t105 = t24 * (t6 * t46 + (t5 * t50 + t99))
            + (t103 - t69 * (t6 * t59 + (t5 * t63 + t104)));
        let t106 = t21 * t28 + (t20 * t30 - t19 * t31 - t8 * t46);
        let t107 = t5 * t12 + (t10 * t7 - t8 * t4);
        let t108 = t5 * t21 + (t7 * t20 - t8 * t19);
        let t109 = t42 * (t14 * t107 + t22 * t108);
        let t110 = t53 * (t40 * t107 - t14 * t109) - t66 * (t40 * t108 - t22 * t109);
        let t111 = t12 * t28 + (t10 * t30 - t4 * t31 - t8 * t59);
        let t112 = t24 * (t7 * t50 + (t5 * t48 + t106))
            + (t110 - t69 * (t7 * t63 + (t5 * t61 + t111)));
        let t113 = t19 * t28 + (t21 * t31 - t20 * t29 - t6 * t50);
        let t114 = t5 * t4 + (t8 * t12 - t10 * t6);
        let t115 = t5 * t19 + (t8 * t21 - t6 * t20);
        let t116 = t42 * (t14 * t114 + t22 * t115);
        let t117 = t53 * (t40 * t114 - t14 * t116) - t66 * (t40 * t115 - t22 * t116);
        let t118 = t4 * t28 + (t12 * t31 - t10 * t29 - t6 * t63);
        let t119 = t24 * (t8 * t48 + (t5 * t46 + t113))
            + (t117 - t69 * (t8 * t61 + (t5 * t59 + t118)));
        let t120 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t121 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t122 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t123 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t124 = q_i[6] * t120 + (q_i[4] * t121 + (q_i[3] * t122 - q_i[5] * t123));
        let t125 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t126 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t127 = q_j[4] * h[10] + (q_j[3] * h[11] - q_j[5] * h[9]);
        let t128 = q_j[5] * h[11] + (q_j[3] * h[9] - q_j[6] * h[10]);
        let t129 = q_j[6] * t125 + (q_j[4] * t126 + (q_j[3] * t127 - q_j[5] * t128));
        let t130 = q_i[5] * t122 + (q_i[4] * t120 + (q_i[3] * t123 - q_i[6] * t121));
        let t131 = q_j[5] * t127 + (q_j[4] * t125 + (q_j[3] * t128 - q_j[6] * t126));
        let t132 = q_i[6] * t123 + (q_i[5] * t120 + (q_i[3] * t121 - q_i[4] * t122));
        let t133 = q_j[6] * t128 + (q_j[5] * t125 + (q_j[3] * t126 - q_j[4] * t127));
        let t134 = t124 * t129 + (t130 * t131 + t132 * t133);
        let t135 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t136 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t137 = q_j[4] * h[13] + (q_j[3] * h[14] - q_j[5] * h[12]);
        let t138 = q_j[5] * h[14] + (q_j[3] * h[12] - q_j[6] * h[13]);
        let t139 = q_j[6] * t135 + (q_j[4] * t136 + (q_j[3] * t137 - q_j[5] * t138));
        let t140 = q_j[5] * t137 + (q_j[4] * t135 + (q_j[3] * t138 - q_j[6] * t136));
        let t141 = q_j[6] * t138 + (q_j[5] * t135 + (q_j[3] * t136 - q_j[4] * t137));
        let t142 = t124 * t139 + (t130 * t140 + t132 * t141);
        let t143 = t134 * t134 + t142 * t142;
        let t144 = t143.sqrt();
        let t145 = t9 * t124 + (t11 * t130 + t13 * t132);
        let t146 = one / (t144 * t144 + t145 * t145);
        let t147 = t144 * t146;
        let t148 = v_i[3] * h[2] + (v_i[4] * h[1] - v_i[5] * h[0]);
        let t149 = v_i[3] * h[1] + (v_i[6] * h[0] - v_i[4] * h[2]);
        let t150 = v_i[5] * h[2] + (v_i[3] * h[0] - v_i[6] * h[1]);
        let t151 = t11 * t150 + (t33 * t122 + (t35 * t123 + t37 * t121));
        let t152 = t122 * t129 + (t123 * t131 + t121 * t133);
        let t153 = t122 * t139 + (t123 * t140 + t121 * t141);
        let t154 = t134 * t152 + t142 * t153;
        let t155 = one / t144;
        let t156 = t154 * t155;
        let t157 = t146 * half;
        let t158 = t9 * t122 + (t11 * t123 + t13 * t121);
        let t159 = t146 * t146;
        let t160 = (t144 * t156 + t145 * t158) * t159;
        let t161 = v_i[6] * h[2] + (v_i[4] * h[0] + v_i[5] * h[1]);
        let t162 = q_i[4] * t149 + (q_i[3] * t148 - q_i[5] * t150 - v_i[5] * t123);
        let t163 = v_i[6] * t120
            + (v_i[4] * t121 + (v_i[3] * t122 + (q_i[6] * t161 + t162)));
        let t164 = q_i[5] * t161 + (q_i[3] * t149 - q_i[4] * t148 - v_i[4] * t122);
        let t165 = v_i[6] * t123
            + (v_i[5] * t120 + (v_i[3] * t121 + (q_i[6] * t150 + t164)));
        let t166 = q_i[4] * t161 + (q_i[3] * t150 - q_i[6] * t149 - v_i[6] * t121);
        let t167 = v_i[5] * t122
            + (v_i[4] * t120 + (v_i[3] * t123 + (q_i[5] * t148 + t166)));
        let t168 = t11 * t167 + (t33 * t124 + (t35 * t130 + t37 * t132));
        let t169 = t9 * t163 + (t13 * t165 + t168);
        let t170 = t169 * two;
        let t171 = v_j[6] * h[11] + (v_j[4] * h[9] + v_j[5] * h[10]);
        let t172 = v_j[3] * h[10] + (v_j[6] * h[9] - v_j[4] * h[11]);
        let t173 = v_j[3] * h[11] + (v_j[4] * h[10] - v_j[5] * h[9]);
        let t174 = v_j[5] * h[11] + (v_j[3] * h[9] - v_j[6] * h[10]);
        let t175 = q_j[4] * t172 + (q_j[3] * t173 - q_j[5] * t174 - v_j[5] * t128);
        let t176 = v_j[6] * t125
            + (v_j[4] * t126 + (v_j[3] * t127 + (q_j[6] * t171 + t175)));
        let t177 = q_j[4] * t171 + (q_j[3] * t174 - q_j[6] * t172 - v_j[6] * t126);
        let t178 = v_j[5] * t127
            + (v_j[4] * t125 + (v_j[3] * t128 + (q_j[5] * t173 + t177)));
        let t179 = q_j[5] * t171 + (q_j[3] * t172 - q_j[4] * t173 - v_j[4] * t127);
        let t180 = v_j[6] * t128
            + (v_j[5] * t125 + (v_j[3] * t126 + (q_j[6] * t174 + t179)));
        let t181 = t131 * t167 + (t124 * t176 + (t130 * t178 + t132 * t180));
        let t182 = t129 * t163 + (t133 * t165 + t181);
        let t183 = v_j[6] * h[14] + (v_j[4] * h[12] + v_j[5] * h[13]);
        let t184 = v_j[3] * h[13] + (v_j[6] * h[12] - v_j[4] * h[14]);
        let t185 = v_j[3] * h[14] + (v_j[4] * h[13] - v_j[5] * h[12]);
        let t186 = v_j[5] * h[14] + (v_j[3] * h[12] - v_j[6] * h[13]);
        let t187 = q_j[4] * t184 + (q_j[3] * t185 - q_j[5] * t186 - v_j[5] * t138);
        let t188 = v_j[6] * t135
            + (v_j[4] * t136 + (v_j[3] * t137 + (q_j[6] * t183 + t187)));
        let t189 = q_j[4] * t183 + (q_j[3] * t186 - q_j[6] * t184 - v_j[6] * t136);
        let t190 = v_j[5] * t137
            + (v_j[4] * t135 + (v_j[3] * t138 + (q_j[5] * t185 + t189)));
        let t191 = q_j[5] * t183 + (q_j[3] * t184 - q_j[4] * t185 - v_j[4] * t137);
        let t192 = v_j[6] * t138
            + (v_j[5] * t135 + (v_j[3] * t136 + (q_j[6] * t186 + t191)));
        let t193 = t140 * t167 + (t124 * t188 + (t130 * t190 + t132 * t192));
        let t194 = t139 * t163 + (t141 * t165 + t193);
        let t195 = t134 * t182 + t142 * t194;
        let t196 = t155 * t195;
        let t197 = t196 * two;
        let t198 = (t156 * t157 - t144 * t160) * t170
            - (t158 * t157 - t145 * t160) * t197;
        let t199 = t131 * t150 + (t122 * t176 + (t123 * t178 + t121 * t180));
        let t200 = t129 * t148 + (t133 * t149 + t199);
        let t201 = t140 * t150 + (t122 * t188 + (t123 * t190 + t121 * t192));
        let t202 = t139 * t148 + (t141 * t149 + t201);
        let t203 = t153 * t194 + (t152 * t182 + (t134 * t200 + t142 * t202));
        let t204 = t155 * t155;
        let t205 = t145 * t146;
        let t206 = t147 * (t9 * t148 + (t13 * t149 + t151))
            + (t198 - (t155 * t203 - t195 * (t156 * t204)) * t205);
        let t207 = t33 * t121 + (t35 * t120 - t37 * t122 - t13 * t148);
        let t208 = t121 * t129 + (t120 * t131 - t122 * t133);
        let t209 = t121 * t139 + (t120 * t140 - t122 * t141);
        let t210 = t134 * t208 + t142 * t209;
        let t211 = t155 * t210;
        let t212 = t9 * t121 + (t11 * t120 - t13 * t122);
        let t213 = t159 * (t144 * t211 + t145 * t212);
        let t214 = t170 * (t157 * t211 - t144 * t213)
            - t197 * (t157 * t212 - t145 * t213);
        let t215 = t121 * t176 + (t120 * t178 - t122 * t180 - t133 * t148);
        let t216 = t129 * t149 + (t131 * t161 + t215);
        let t217 = t121 * t188 + (t120 * t190 - t122 * t192 - t141 * t148);
        let t218 = t139 * t149 + (t140 * t161 + t217);
        let t219 = t194 * t209 + (t182 * t208 + (t134 * t216 + t142 * t218));
        let t220 = t147 * (t9 * t149 + (t11 * t161 + t207))
            + (t214 - t205 * (t155 * t219 - t195 * (t204 * t211)));
        let t221 = t35 * t122 + (t37 * t120 - t33 * t123 - t9 * t150);
        let t222 = t122 * t131 + (t120 * t133 - t123 * t129);
        let t223 = t122 * t140 + (t120 * t141 - t123 * t139);
        let t224 = t134 * t222 + t142 * t223;
        let t225 = t155 * t224;
        let t226 = t11 * t122 + (t13 * t120 - t9 * t123);
        let t227 = t159 * (t144 * t225 + t145 * t226);
        let t228 = t170 * (t157 * t225 - t144 * t227)
            - t197 * (t157 * t226 - t145 * t227);
        let t229 = t122 * t178 + (t120 * t180 - t123 * t176 - t129 * t150);
        let t230 = t133 * t161 + (t131 * t148 + t229);
        let t231 = t122 * t190 + (t120 * t192 - t123 * t188 - t139 * t150);
        let t232 = t141 * t161 + (t140 * t148 + t231);
        let t233 = t194 * t223 + (t182 * t222 + (t134 * t230 + t142 * t232));
        let t234 = t147 * (t13 * t161 + (t11 * t148 + t221))
            + (t228 - t205 * (t155 * t233 - t195 * (t204 * t225)));
        let t235 = t37 * t123 + (t33 * t120 - t35 * t121 - t11 * t149);
        let t236 = t123 * t133 + (t120 * t129 - t121 * t131);
        let t237 = t123 * t141 + (t120 * t139 - t121 * t140);
        let t238 = t134 * t236 + t142 * t237;
        let t239 = t155 * t238;
        let t240 = t13 * t123 + (t9 * t120 - t11 * t121);
        let t241 = t159 * (t144 * t239 + t145 * t240);
        let t242 = t170 * (t157 * t239 - t144 * t241)
            - t197 * (t157 * t240 - t145 * t241);
        let t243 = t123 * t180 + (t120 * t176 - t121 * t178 - t131 * t149);
        let t244 = t129 * t161 + (t133 * t150 + t243);
        let t245 = t123 * t192 + (t120 * t188 - t121 * t190 - t140 * t149);
        let t246 = t139 * t161 + (t141 * t150 + t245);
        let t247 = t194 * t237 + (t182 * t236 + (t134 * t244 + t142 * t246));
        let t248 = t147 * (t9 * t161 + (t13 * t150 + t235))
            + (t242 - t205 * (t155 * t247 - t195 * (t204 * t239)));
        let t249 = t8 * t167 + (t30 * t124 + (t31 * t130 + t29 * t132));
        let t250 = t127 * t124 + (t130 * t128 + t126 * t132);
        let t251 = t124 * t137 + (t130 * t138 + t132 * t136);
        let t252 = t134 * t250 + t142 * t251;
        let t253 = t155 * t252;
        let t254 = t7 * t124 + (t8 * t130 + t6 * t132);
        let t255 = t159 * (t144 * t253 + t145 * t254);
        let t256 = t170 * (t157 * t253 - t144 * t255)
            - t197 * (t157 * t254 - t145 * t255);
        let t257 = t128 * t167 + (t124 * t173 + (t130 * t174 + t132 * t172));
        let t258 = t127 * t163 + (t126 * t165 + t257);
        let t259 = t138 * t167 + (t124 * t185 + (t130 * t186 + t132 * t184));
        let t260 = t137 * t163 + (t136 * t165 + t259);
        let t261 = t194 * t251 + (t182 * t250 + (t134 * t258 + t142 * t260));
        let t262 = t147 * (t7 * t163 + (t6 * t165 + t249))
            + (t256 - t205 * (t155 * t261 - t195 * (t204 * t253)));
        let t263 = t29 * t124 + (t28 * t130 - t30 * t132 - t7 * t165);
        let t264 = t126 * t124 + (t130 * t125 - t127 * t132);
        let t265 = t124 * t136 + (t130 * t135 - t132 * t137);
        let t266 = t134 * t264 + t142 * t265;
        let t267 = t155 * t266;
        let t268 = t6 * t124 + (t5 * t130 - t7 * t132);
        let t269 = t159 * (t144 * t267 + t145 * t268);
        let t270 = t170 * (t157 * t267 - t144 * t269)
            - t197 * (t157 * t268 - t145 * t269);
        let t271 = t124 * t172 + (t130 * t171 - t132 * t173 - t127 * t165);
        let t272 = t126 * t163 + (t125 * t167 + t271);
        let t273 = t124 * t184 + (t130 * t183 - t132 * t185 - t137 * t165);
        let t274 = t136 * t163 + (t135 * t167 + t273);
        let t275 = t194 * t265 + (t182 * t264 + (t134 * t272 + t142 * t274));
        let t276 = t147 * (t6 * t163 + (t5 * t167 + t263))
            + (t270 - t205 * (t155 * t275 - t195 * (t204 * t267)));
        let t277 = t28 * t132 + (t30 * t130 - t31 * t124 - t8 * t163);
        let t278 = t125 * t132 + (t130 * t127 - t128 * t124);
        let t279 = t132 * t135 + (t130 * t137 - t124 * t138);
        let t280 = t134 * t278 + t142 * t279;
        let t281 = t155 * t280;
        let t282 = t5 * t132 + (t7 * t130 - t8 * t124);
        let t283 = t159 * (t144 * t281 + t145 * t282);
        let t284 = t170 * (t157 * t281 - t144 * t283)
            - t197 * (t157 * t282 - t145 * t283);
        let t285 = t132 * t171 + (t130 * t173 - t124 * t174 - t128 * t163);
        let t286 = t127 * t167 + (t125 * t165 + t285);
        let t287 = t132 * t183 + (t130 * t185 - t124 * t186 - t138 * t163);
        let t288 = t137 * t167 + (t135 * t165 + t287);
        let t289 = t194 * t279 + (t182 * t278 + (t134 * t286 + t142 * t288));
        let t290 = t147 * (t7 * t167 + (t5 * t165 + t277))
            + (t284 - t205 * (t155 * t289 - t195 * (t204 * t281)));
        let t291 = t28 * t124 + (t31 * t132 - t29 * t130 - t6 * t167);
        let t292 = t125 * t124 + (t128 * t132 - t130 * t126);
        let t293 = t124 * t135 + (t132 * t138 - t130 * t136);
        let t294 = t134 * t292 + t142 * t293;
        let t295 = t155 * t294;
        let t296 = t5 * t124 + (t8 * t132 - t6 * t130);
        let t297 = t159 * (t144 * t295 + t145 * t296);
        let t298 = t170 * (t157 * t295 - t144 * t297)
            - t197 * (t157 * t296 - t145 * t297);
        let t299 = t124 * t171 + (t132 * t174 - t130 * t172 - t126 * t167);
        let t300 = t128 * t165 + (t125 * t163 + t299);
        let t301 = t124 * t183 + (t132 * t186 - t130 * t184 - t136 * t167);
        let t302 = t138 * t165 + (t135 * t163 + t301);
        let t303 = t194 * t293 + (t182 * t292 + (t134 * t300 + t142 * t302));
        let t304 = t147 * (t8 * t165 + (t5 * t163 + t291))
            + (t298 - t205 * (t155 * t303 - t195 * (t204 * t295)));
        let t305 = one / t143;
        let t306 = t142 * t305;
        let t307 = t305 * half;
        let t308 = t305 * t305;
        let t309 = t154 * t308;
        let t310 = t182 * two;
        let t311 = t194 * two;
        let t312 = (t153 * t307 - t142 * t309) * t310
            - (t152 * t307 - t134 * t309) * t311;
        let t313 = t134 * t305;
        let t314 = t210 * t308;
        let t315 = t310 * (t209 * t307 - t142 * t314)
            - t311 * (t208 * t307 - t134 * t314);
        let t316 = t224 * t308;
        let t317 = t310 * (t223 * t307 - t142 * t316)
            - t311 * (t222 * t307 - t134 * t316);
        let t318 = t238 * t308;
        let t319 = t310 * (t237 * t307 - t142 * t318)
            - t311 * (t236 * t307 - t134 * t318);
        let t320 = t252 * t308;
        let t321 = t310 * (t251 * t307 - t142 * t320)
            - t311 * (t250 * t307 - t134 * t320);
        let t322 = t266 * t308;
        let t323 = t310 * (t265 * t307 - t142 * t322)
            - t311 * (t264 * t307 - t134 * t322);
        let t324 = t280 * t308;
        let t325 = t310 * (t279 * t307 - t142 * t324)
            - t311 * (t278 * t307 - t134 * t324);
        let t326 = t294 * t308;
        let t327 = t310 * (t293 * t307 - t142 * t326)
            - t311 * (t292 * t307 - t134 * t326);
        let t328 = q_i[3] * q_i[3];
        let t329 = q_i[4] * q_i[4];
        let t330 = q_i[6] * q_i[6];
        let t331 = q_i[5] * q_i[5];
        let t332 = t328 + t329 - t330 - t331;
        let t333 = q_i[3] * q_i[6];
        let t334 = q_i[4] * q_i[5];
        let t335 = t333 + t334;
        let t336 = t335 * two;
        let t337 = q_i[4] * q_i[6];
        let t338 = q_i[3] * q_i[5];
        let t339 = t337 - t338;
        let t340 = t339 * two;
        let t341 = t11 * t332 + (t13 * t336 + t9 * t340);
        let t342 = t40 * t341;
        let t343 = t42 * (t14 * t341);
        let t344 = t22 * t343;
        let t345 = q_i[6] * v_i[4] + q_i[4] * v_i[6];
        let t346 = q_i[3] * v_i[5];
        let t347 = q_i[5] * v_i[3];
        let t348 = t345 - t346 - t347;
        let t349 = q_i[5] * v_i[4] + q_i[4] * v_i[5];
        let t350 = q_i[3] * v_i[6];
        let t351 = q_i[6] * v_i[3];
        let t352 = t349 + (t350 + t351);
        let t353 = t332 * half;
        let t354 = q_i[4] * v_i[4];
        let t355 = q_i[3] * v_i[3];
        let t356 = q_i[6] * v_i[6];
        let t357 = q_i[5] * v_i[5];
        let t358 = t354 + t355 - t356 - t357;
        let t359 = t9 * t348 + (t13 * t352 + (t35 * t353 + t11 * t358));
        let t360 = t33 * t339 + (t37 * t335 + t359);
        let t361 = t52 * (t342 - t14 * t343) + (t65 * t344 - t69 * t360);
        let t362 = q_i[4] * q_i[3];
        let t363 = q_i[6] * q_i[5];
        let t364 = t362 + t363;
        let t365 = t328 - t329;
        let t366 = t331 - t330;
        let t367 = (t365 + t366) * half;
        let t368 = t334 - t333;
        let t369 = t9 * t364 + (t13 * t367 + t11 * t368);
        let t370 = t40 * t369;
        let t371 = t42 * (t14 * t369);
        let t372 = t22 * t371;
        let t373 = q_i[6] * v_i[5] + q_i[5] * v_i[6];
        let t374 = q_i[3] * v_i[4];
        let t375 = q_i[4] * v_i[3];
        let t376 = t373 + (t374 + t375);
        let t377 = t355 - t354;
        let t378 = t377 + (t357 - t356);
        let t379 = t349 - t350 - t351;
        let t380 = t9 * t376 + (t13 * t378 + (t37 * t367 + t11 * t379));
        let t381 = t33 * t364 + (t35 * t368 + t380);
        let t382 = t53 * (t370 - t14 * t371) + (t66 * t372 - t69 * t381);
        let t383 = t363 - t362;
        let t384 = (t365 - t366) * half;
        let t385 = t338 + t337;
        let t386 = t13 * t383 + (t9 * t384 + t11 * t385);
        let t387 = t40 * t386;
        let t388 = t42 * (t14 * t386);
        let t389 = t22 * t388;
        let t390 = t356 + (t377 - t357);
        let t391 = t373 - t374 - t375;
        let t392 = t347 + (t346 + t345);
        let t393 = t9 * t390 + (t13 * t391 + (t33 * t384 + t11 * t392));
        let t394 = t37 * t383 + (t35 * t385 + t393);
        let t395 = t53 * (t387 - t14 * t388) + (t66 * t389 - t69 * t394);
        let t396 = t65 * (t342 - t22 * (t42 * (t22 * t341))) - t24 * t360;
        let t397 = t66 * (t370 - t22 * (t42 * (t22 * t369))) - t24 * t381;
        let t398 = t66 * (t387 - t22 * (t42 * (t22 * t386))) - t24 * t394;
        let t399 = q_j[3] * q_j[3];
        let t400 = q_j[4] * q_j[4];
        let t401 = q_j[6] * q_j[6];
        let t402 = q_j[5] * q_j[5];
        let t403 = t399 + t400 - t401 - t402;
        let t404 = q_j[3] * q_j[6];
        let t405 = q_j[4] * q_j[5];
        let t406 = t404 + t405;
        let t407 = t406 * two;
        let t408 = q_j[4] * q_j[6];
        let t409 = q_j[3] * q_j[5];
        let t410 = t408 - t409;
        let t411 = t410 * two;
        let t412 = t10 * t403 + (t12 * t407 + t4 * t411);
        let t413 = t20 * t403 + (t21 * t407 + t19 * t411);
        let t414 = t42 * (t14 * t412 + t22 * t413);
        let t415 = q_j[6] * v_j[4] + q_j[4] * v_j[6];
        let t416 = q_j[3] * v_j[5];
        let t417 = q_j[5] * v_j[3];
        let t418 = t415 - t416 - t417;
        let t419 = q_j[5] * v_j[4] + q_j[4] * v_j[5];
        let t420 = q_j[3] * v_j[6];
        let t421 = q_j[6] * v_j[3];
        let t422 = t419 + (t420 + t421);
        let t423 = t403 * half;
        let t424 = q_j[4] * v_j[4];
        let t425 = q_j[3] * v_j[3];
        let t426 = q_j[6] * v_j[6];
        let t427 = q_j[5] * v_j[5];
        let t428 = t424 + t425 - t426 - t427;
        let t429 = t19 * t418 + (t21 * t422 + (t50 * t423 + t20 * t428));
        let t430 = t4 * t418 + (t12 * t422 + (t63 * t423 + t10 * t428));
        let t431 = t24 * (t46 * t410 + (t48 * t406 + t429))
            - t69 * (t59 * t410 + (t61 * t406 + t430));
        let t432 = t52 * (t40 * t412 - t14 * t414)
            + (t431 - t65 * (t40 * t413 - t22 * t414));
        let t433 = q_j[4] * q_j[3];
        let t434 = q_j[6] * q_j[5];
        let t435 = t433 + t434;
        let t436 = t405 - t404;
        let t437 = q_j[6] * v_j[5] + q_j[5] * v_j[6];
        let t438 = q_j[3] * v_j[4];
        let t439 = q_j[4] * v_j[3];
        let t440 = t437 + (t438 + t439);
        let t441 = t425 - t424;
        let t442 = t441 + (t427 - t426);
        let t443 = t399 - t400;
        let t444 = t402 - t401;
        let t445 = (t443 + t444) * half;
        let t446 = t419 - t420 - t421;
        let t447 = t19 * t440 + (t21 * t442 + (t48 * t445 + t20 * t446));
        let t448 = t4 * t435 + (t12 * t445 + t10 * t436);
        let t449 = t19 * t435 + (t21 * t445 + t20 * t436);
        let t450 = t42 * (t14 * t448 + t22 * t449);
        let t451 = t53 * (t40 * t448 - t14 * t450) - t66 * (t40 * t449 - t22 * t450);
        let t452 = t4 * t440 + (t12 * t442 + (t61 * t445 + t10 * t446));
        let t453 = t24 * (t46 * t435 + (t50 * t436 + t447))
            + (t451 - t69 * (t59 * t435 + (t63 * t436 + t452)));
        let t454 = t434 - t433;
        let t455 = t409 + t408;
        let t456 = t426 + (t441 - t427);
        let t457 = t437 - t438 - t439;
        let t458 = (t443 - t444) * half;
        let t459 = t417 + (t416 + t415);
        let t460 = t19 * t456 + (t21 * t457 + (t46 * t458 + t20 * t459));
        let t461 = t12 * t454 + (t4 * t458 + t10 * t455);
        let t462 = t21 * t454 + (t19 * t458 + t20 * t455);
        let t463 = t42 * (t14 * t461 + t22 * t462);
        let t464 = t53 * (t40 * t461 - t14 * t463) - t66 * (t40 * t462 - t22 * t463);
        let t465 = t4 * t456 + (t12 * t457 + (t59 * t458 + t10 * t459));
        let t466 = t24 * (t48 * t454 + (t50 * t455 + t460))
            + (t464 - t69 * (t61 * t454 + (t63 * t455 + t465)));
        let t467 = t131 * t332 + (t133 * t336 + t129 * t340);
        let t468 = t140 * t332 + (t141 * t336 + t139 * t340);
        let t469 = t134 * t467 + t142 * t468;
        let t470 = t155 * t469;
        let t471 = t159 * (t144 * t470 + t145 * t341);
        let t472 = t139 * t348 + (t141 * t352 + (t190 * t353 + t140 * t358));
        let t473 = t188 * t339 + (t192 * t335 + t472);
        let t474 = t129 * t348 + (t133 * t352 + (t178 * t353 + t131 * t358));
        let t475 = t176 * t339 + (t180 * t335 + t474);
        let t476 = t134 * t475 + (t182 * t467 * half + t194 * t468 * half);
        let t477 = t195 * half;
        let t478 = t205 * (t155 * (t142 * t473 + t476) - t204 * t470 * t477);
        let t479 = t147 * t360 - t478 - t196 * (t157 * t341 - t145 * t471);
        let t480 = t129 * t364 + (t133 * t367 + t131 * t368);
        let t481 = t139 * t364 + (t141 * t367 + t140 * t368);
        let t482 = t134 * t480 + t142 * t481;
        let t483 = t155 * t482;
        let t484 = t159 * (t144 * t483 + t145 * t369);
        let t485 = t170 * (t157 * t483 - t144 * t484)
            - t197 * (t157 * t369 - t145 * t484);
        let t486 = t129 * t376 + (t133 * t378 + (t180 * t367 + t131 * t379));
        let t487 = t176 * t364 + (t178 * t368 + t486);
        let t488 = t139 * t376 + (t141 * t378 + (t192 * t367 + t140 * t379));
        let t489 = t188 * t364 + (t190 * t368 + t488);
        let t490 = t194 * t481 + (t182 * t480 + (t134 * t487 + t142 * t489));
        let t491 = t147 * t381 + (t485 - t205 * (t155 * t490 - t195 * (t204 * t483)));
        let t492 = t133 * t383 + (t129 * t384 + t131 * t385);
        let t493 = t141 * t383 + (t139 * t384 + t140 * t385);
        let t494 = t134 * t492 + t142 * t493;
        let t495 = t155 * t494;
        let t496 = t159 * (t144 * t495 + t145 * t386);
        let t497 = t170 * (t157 * t495 - t144 * t496)
            - t197 * (t157 * t386 - t145 * t496);
        let t498 = t129 * t390 + (t133 * t391 + (t176 * t384 + t131 * t392));
        let t499 = t180 * t383 + (t178 * t385 + t498);
        let t500 = t139 * t390 + (t141 * t391 + (t188 * t384 + t140 * t392));
        let t501 = t192 * t383 + (t190 * t385 + t500);
        let t502 = t194 * t493 + (t182 * t492 + (t134 * t499 + t142 * t501));
        let t503 = t147 * t394 + (t497 - t205 * (t155 * t502 - t195 * (t204 * t495)));
        let t504 = t130 * t403 + (t132 * t407 + t124 * t411);
        let t505 = t134 * t504;
        let t506 = t155 * t505;
        let t507 = t159 * (t144 * t506);
        let t508 = t504 * half;
        let t509 = t124 * t418 + (t132 * t422 + (t167 * t423 + t130 * t428));
        let t510 = t163 * t410 + (t165 * t406 + t509);
        let t511 = t155 * (t182 * t508 + t134 * t510) - t477 * (t204 * t506);
        let t512 = t196 * (t145 * t507)
            + (t169 * (t157 * t506 - t144 * t507) - t205 * t511);
        let t513 = t124 * t435 + (t132 * t445 + t130 * t436);
        let t514 = t134 * t513;
        let t515 = t155 * t514;
        let t516 = t159 * (t144 * t515);
        let t517 = t124 * t440 + (t132 * t442 + (t165 * t445 + t130 * t446));
        let t518 = t163 * t435 + (t167 * t436 + t517);
        let t519 = t155 * (t134 * t518 + t182 * t513) - t195 * (t204 * t515);
        let t520 = t197 * (t145 * t516)
            + (t170 * (t157 * t515 - t144 * t516) - t205 * t519);
        let t521 = t132 * t454 + (t124 * t458 + t130 * t455);
        let t522 = t134 * t521;
        let t523 = t155 * t522;
        let t524 = t159 * (t144 * t523);
        let t525 = t124 * t456 + (t132 * t457 + (t163 * t458 + t130 * t459));
        let t526 = t165 * t454 + (t167 * t455 + t525);
        let t527 = t155 * (t134 * t526 + t182 * t521) - t195 * (t204 * t523);
        let t528 = t197 * (t145 * t524)
            + (t170 * (t157 * t523 - t144 * t524) - t205 * t527);
        let t529 = t142 * t504;
        let t530 = t155 * t529;
        let t531 = t159 * (t144 * t530);
        let t532 = t155 * (t194 * t508 + t142 * t510) - t477 * (t204 * t530);
        let t533 = t196 * (t145 * t531)
            + (t169 * (t157 * t530 - t144 * t531) - t205 * t532);
        let t534 = t142 * t513;
        let t535 = t155 * t534;
        let t536 = t159 * (t144 * t535);
        let t537 = t155 * (t142 * t518 + t194 * t513) - t195 * (t204 * t535);
        let t538 = t197 * (t145 * t536)
            + (t170 * (t157 * t535 - t144 * t536) - t205 * t537);
        let t539 = t142 * t521;
        let t540 = t155 * t539;
        let t541 = t159 * (t144 * t540);
        let t542 = t155 * (t142 * t526 + t194 * t521) - t195 * (t204 * t540);
        let t543 = t197 * (t145 * t541)
            + (t170 * (t157 * t540 - t144 * t541) - t205 * t542);
        let t544 = t159 * (t145 * t504);
        let t545 = t196 * (t157 * t504 - t145 * t544)
            + (t169 * (t144 * t544) - t147 * t510);
        let t546 = t159 * (t145 * t513);
        let t547 = t197 * (t157 * t513 - t145 * t546)
            + (t170 * (t144 * t546) - t147 * t518);
        let t548 = t159 * (t145 * t521);
        let t549 = t197 * (t157 * t521 - t145 * t548)
            + (t170 * (t144 * t548) - t147 * t526);
        let t550 = t308 * t469;
        let t551 = t306 * t475 - t313 * t473 - t194 * (t307 * t467 - t134 * t550);
        let t552 = t308 * t482;
        let t553 = t310 * (t307 * t481 - t142 * t552)
            - t311 * (t307 * t480 - t134 * t552);
        let t554 = t308 * t494;
        let t555 = t310 * (t307 * t493 - t142 * t554)
            - t311 * (t307 * t492 - t134 * t554);
        let t556 = t307 * t504;
        let t557 = t308 * t505;
        let t558 = t142 * t557;
        let t559 = t194 * (t556 - t134 * t557) + (t182 * t558 - t306 * t510);
        let t560 = t307 * t513;
        let t561 = t308 * t514;
        let t562 = t142 * t561;
        let t563 = t311 * (t560 - t134 * t561) + (t310 * t562 - t306 * t518);
        let t564 = t307 * t521;
        let t565 = t308 * t522;
        let t566 = t142 * t565;
        let t567 = t311 * (t564 - t134 * t565) + (t310 * t566 - t306 * t526);
        let t568 = t194 * t558 + (t182 * (t556 - t142 * (t308 * t529)) - t313 * t510);
        let t569 = t311 * t562 + (t310 * (t560 - t142 * (t308 * t534)) - t313 * t518);
        let t570 = t311 * t566 + (t310 * (t564 - t142 * (t308 * t539)) - t313 * t526);
        rate_q[0] = t70 * two;
        rate_q[1] = t77 * two;
        rate_q[2] = t84 * two;
        rate_q[3] = t91 * two;
        rate_q[4] = t98 * two;
        rate_q[5] = t105 * two;
        rate_q[6] = t112 * two;
        rate_q[7] = t119 * two;
        rate_q[8] = t206 * two;
        rate_q[9] = t220 * two;
        rate_q[10] = t234 * two;
        rate_q[11] = t248 * two;
        rate_q[12] = t262 * two;
        rate_q[13] = t276 * two;
        rate_q[14] = t290 * two;
        rate_q[15] = t304 * two;
        rate_q[16] = (t200 * t306 + (t312 - t202 * t313)) * two;
        rate_q[17] = (t216 * t306 + (t315 - t218 * t313)) * two;
        rate_q[18] = (t230 * t306 + (t317 - t232 * t313)) * two;
        rate_q[19] = (t244 * t306 + (t319 - t246 * t313)) * two;
        rate_q[20] = (t258 * t306 + (t321 - t260 * t313)) * two;
        rate_q[21] = (t272 * t306 + (t323 - t274 * t313)) * two;
        rate_q[22] = (t286 * t306 + (t325 - t288 * t313)) * two;
        rate_q[23] = (t300 * t306 + (t327 - t302 * t313)) * two;
        rate_h[0] = t361 * two;
        rate_h[1] = t382 * two;
        rate_h[2] = t395 * two;
        rate_h[3] = -((t52 * t344 + t396) * two);
        rate_h[4] = -((t53 * t372 + t397) * two);
        rate_h[5] = -((t53 * t389 + t398) * two);
        rate_h[6] = t432 * two;
        rate_h[7] = t453 * two;
        rate_h[8] = t466 * two;
        rate_h[9] = (t169 * (t157 * t470 - t144 * t471) + t479) * two;
        rate_h[10] = t491 * two;
        rate_h[11] = t503 * two;
        rate_h[12] = t512 * two;
        rate_h[13] = t520 * two;
        rate_h[14] = t528 * two;
        rate_h[15] = t533 * two;
        rate_h[16] = t538 * two;
        rate_h[17] = t543 * two;
        rate_h[18] = -(t545 * two);
        rate_h[19] = -(t547 * two);
        rate_h[20] = -(t549 * two);
        rate_h[21] = (t182 * (t307 * t468 - t142 * t550) + t551) * two;
        rate_h[22] = (t306 * t487 + (t553 - t313 * t489)) * two;
        rate_h[23] = (t306 * t499 + (t555 - t313 * t501)) * two;
        rate_h[24] = -(t559 * two);
        rate_h[25] = -(t563 * two);
        rate_h[26] = -(t567 * two);
        rate_h[27] = t568 * two;
        rate_h[28] = t569 * two;
        rate_h[29] = t570 * two;
    }
}
