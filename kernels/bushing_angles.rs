// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Tait–Bryan angles in a bushing
///
/// `(a, b, c) = 0, Bᵀ A_iᵀ A_j B_j = R_x(a) R_y(b) R_z(c), B = [x_i y_i z_i], B_j = [x_j y_j z_j]` (unit 1)
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
pub mod bushing_angles {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "bushing_angles",
        title: "Tait–Bryan angles in a bushing",
        equation: "(a, b, c) = 0, Bᵀ A_iᵀ A_j B_j = R_x(a) R_y(b) R_z(c), B = [x_i y_i z_i], B_j = [x_j y_j z_j]",
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
            (3, 9),
            (3, 10),
            (3, 11),
            (3, 12),
            (3, 13),
            (3, 14),
            (3, 15),
            (3, 16),
            (3, 17),
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
                additions: 227,
                multiplications: 389,
                divisions: 4,
                functions: 4,
            },
            Operations {
                additions: 1109,
                multiplications: 1626,
                divisions: 4,
                functions: 4,
            },
            Operations {
                additions: 1658,
                multiplications: 2499,
                divisions: 4,
                functions: 1,
            },
            Operations {
                additions: 1110,
                multiplications: 1729,
                divisions: 4,
                functions: 1,
            },
        ],
    };
    /// Tait–Bryan angles in a bushing
    #[derive(Clone, Copy, Debug, Default)]
    pub struct BushingAngles;
    impl<S: Scalar> Relation<S> for BushingAngles {
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
    /// 227 additions, 389 multiplications, 4 divisions, 4 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        phi: &mut [S; 3],
        phi_q: &mut [S; 24],
        _work: &mut [S; 0],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
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
        let t14 = t4 * t9 + (t10 * t11 + t12 * t13);
        let t15 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t16 = q_i[3] * h[8] + q_i[4] * h[7] - q_i[5] * h[6];
        let t17 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t18 = q_i[3] * h[6] + q_i[5] * h[8] - q_i[6] * h[7];
        let t19 = q_i[6] * t15 + (q_i[3] * t16 + q_i[4] * t17 - q_i[5] * t18);
        let t20 = q_i[5] * t16 + (q_i[3] * t18 + q_i[4] * t15) - q_i[6] * t17;
        let t21 = q_i[6] * t18 + (q_i[5] * t15 + (q_i[3] * t17 - q_i[4] * t16));
        let t22 = t9 * t19 + (t11 * t20 + t13 * t21);
        let t23 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t24 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t25 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t26 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t27 = q_i[6] * t23 + (q_i[3] * t24 + q_i[4] * t25 - q_i[5] * t26);
        let t28 = q_i[5] * t24 + (q_i[3] * t26 + q_i[4] * t23) - q_i[6] * t25;
        let t29 = q_i[6] * t26 + (q_i[5] * t23 + (q_i[3] * t25 - q_i[4] * t24));
        let t30 = t9 * t27 + (t11 * t28 + t13 * t29);
        let t31 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t32 = q_j[3] * h[11] + q_j[4] * h[10] - q_j[5] * h[9];
        let t33 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t34 = q_j[3] * h[9] + q_j[5] * h[11] - q_j[6] * h[10];
        let t35 = q_j[6] * t31 + (q_j[3] * t32 + q_j[4] * t33 - q_j[5] * t34);
        let t36 = q_j[5] * t32 + (q_j[3] * t34 + q_j[4] * t31) - q_j[6] * t33;
        let t37 = q_j[6] * t34 + (q_j[5] * t31 + (q_j[3] * t33 - q_j[4] * t32));
        let t38 = t27 * t35 + (t28 * t36 + t29 * t37);
        let t39 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t40 = q_j[3] * h[14] + q_j[4] * h[13] - q_j[5] * h[12];
        let t41 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t42 = q_j[3] * h[12] + q_j[5] * h[14] - q_j[6] * h[13];
        let t43 = q_j[6] * t39 + (q_j[3] * t40 + q_j[4] * t41 - q_j[5] * t42);
        let t44 = q_j[5] * t40 + (q_j[3] * t42 + q_j[4] * t39) - q_j[6] * t41;
        let t45 = q_j[6] * t42 + (q_j[5] * t39 + (q_j[3] * t41 - q_j[4] * t40));
        let t46 = t27 * t43 + (t28 * t44 + t29 * t45);
        let t47 = t38 * t38 + t46 * t46;
        let t48 = t47.sqrt();
        let t49 = one / (t14 * t14 + t22 * t22);
        let t50 = t14 * t49;
        let t51 = t22 * t49;
        let t52 = (t9 * t16 + (t11 * t18 + t13 * t17)) * t50
            - (t1 * t9 + (t3 * t11 + t2 * t13)) * t51;
        let t53 = t50 * (t11 * t15 + t9 * t17 - t13 * t16)
            - t51 * (t0 * t11 + t2 * t9 - t1 * t13);
        let t54 = t50 * (t11 * t16 + (t13 * t15 - t9 * t18))
            - t51 * (t1 * t11 + (t0 * t13 - t3 * t9));
        let t55 = t50 * (t9 * t15 + t13 * t18 - t11 * t17)
            - t51 * (t0 * t9 + t3 * t13 - t2 * t11);
        let t56 = t50 * (t6 * t19 + (t8 * t20 + t7 * t21))
            - t51 * (t6 * t4 + (t10 * t8 + t7 * t12));
        let t57 = t50 * (t7 * t19 + (t5 * t20 - t6 * t21))
            - t51 * (t7 * t4 + (t10 * t5 - t6 * t12));
        let t58 = t50 * (t6 * t20 + t5 * t21 - t8 * t19)
            - t51 * (t10 * t6 + t5 * t12 - t8 * t4);
        let t59 = t50 * (t5 * t19 + (t8 * t21 - t7 * t20))
            - t51 * (t5 * t4 + (t8 * t12 - t10 * t7));
        let t60 = one / (t48 * t48 + t30 * t30);
        let t61 = t48 * t60;
        let t62 = t24 * t35 + (t26 * t36 + t25 * t37);
        let t63 = t24 * t43 + (t26 * t44 + t25 * t45);
        let t64 = one / t48;
        let t65 = t30 * t60;
        let t66 = (t9 * t24 + (t11 * t26 + t13 * t25)) * t61
            - (t38 * t62 + t46 * t63) * t64 * t65;
        let t67 = t23 * t36 + t25 * t35 - t24 * t37;
        let t68 = t23 * t44 + t25 * t43 - t24 * t45;
        let t69 = t61 * (t11 * t23 + t9 * t25 - t13 * t24)
            - t65 * (t64 * (t38 * t67 + t46 * t68));
        let t70 = t24 * t36 + (t23 * t37 - t26 * t35);
        let t71 = t24 * t44 + (t23 * t45 - t26 * t43);
        let t72 = t61 * (t11 * t24 + (t13 * t23 - t9 * t26))
            - t65 * (t64 * (t38 * t70 + t46 * t71));
        let t73 = t23 * t35 + t26 * t37 - t25 * t36;
        let t74 = t23 * t43 + t26 * t45 - t25 * t44;
        let t75 = t61 * (t9 * t23 + t13 * t26 - t11 * t25)
            - t65 * (t64 * (t38 * t73 + t46 * t74));
        let t76 = t27 * t32 + (t28 * t34 + t29 * t33);
        let t77 = t27 * t40 + (t28 * t42 + t29 * t41);
        let t78 = t61 * (t6 * t27 + (t8 * t28 + t7 * t29))
            - t65 * (t64 * (t38 * t76 + t46 * t77));
        let t79 = t27 * t33 + (t28 * t31 - t29 * t32);
        let t80 = t27 * t41 + (t28 * t39 - t29 * t40);
        let t81 = t61 * (t7 * t27 + (t5 * t28 - t6 * t29))
            - t65 * (t64 * (t38 * t79 + t46 * t80));
        let t82 = t28 * t32 + t29 * t31 - t27 * t34;
        let t83 = t28 * t40 + t29 * t39 - t27 * t42;
        let t84 = t61 * (t6 * t28 + t5 * t29 - t8 * t27)
            - t65 * (t64 * (t38 * t82 + t46 * t83));
        let t85 = t27 * t31 + (t29 * t34 - t28 * t33);
        let t86 = t27 * t39 + (t29 * t42 - t28 * t41);
        let t87 = t61 * (t5 * t27 + (t8 * t29 - t7 * t28))
            - t65 * (t64 * (t38 * t85 + t46 * t86));
        let t88 = one / t47;
        let t89 = t46 * t88;
        let t90 = t38 * t88;
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
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 1109 additions, 1626 multiplications, 4 divisions, 4 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
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
        let t49 = t9 * t17 + (t11 * t18 + t13 * t16);
        let t50 = one / (t14 * t14 + t22 * t22);
        let t51 = t14 * t50;
        let t52 = t2 * t9 + (t3 * t11 + t1 * t13);
        let t53 = t22 * t50;
        let t54 = t9 * t16 + (t11 * t15 - t13 * t17);
        let t55 = t1 * t9 + (t0 * t11 - t2 * t13);
        let t56 = t11 * t17 + (t13 * t15 - t9 * t18);
        let t57 = t2 * t11 + (t0 * t13 - t3 * t9);
        let t58 = t13 * t18 + (t9 * t15 - t11 * t16);
        let t59 = t3 * t13 + (t0 * t9 - t1 * t11);
        let t60 = t7 * t19 + (t8 * t20 + t6 * t21);
        let t61 = t7 * t4 + (t10 * t8 + t6 * t12);
        let t62 = t6 * t19 + (t5 * t20 - t7 * t21);
        let t63 = t6 * t4 + (t10 * t5 - t7 * t12);
        let t64 = t5 * t21 + (t7 * t20 - t8 * t19);
        let t65 = t5 * t12 + (t10 * t7 - t8 * t4);
        let t66 = t5 * t19 + (t8 * t21 - t6 * t20);
        let t67 = t5 * t4 + (t8 * t12 - t10 * t6);
        let t68 = t9 * t25 + (t11 * t26 + t13 * t24);
        let t69 = one / (t48 * t48 + t30 * t30);
        let t70 = t48 * t69;
        let t71 = t25 * t35 + (t26 * t36 + t24 * t37);
        let t72 = t25 * t43 + (t26 * t44 + t24 * t45);
        let t73 = t38 * t71 + t46 * t72;
        let t74 = one / t48;
        let t75 = t73 * t74;
        let t76 = t30 * t69;
        let t77 = t9 * t24 + (t11 * t23 - t13 * t25);
        let t78 = t24 * t35 + (t23 * t36 - t25 * t37);
        let t79 = t24 * t43 + (t23 * t44 - t25 * t45);
        let t80 = t38 * t78 + t46 * t79;
        let t81 = t74 * t80;
        let t82 = t11 * t25 + (t13 * t23 - t9 * t26);
        let t83 = t25 * t36 + (t23 * t37 - t26 * t35);
        let t84 = t25 * t44 + (t23 * t45 - t26 * t43);
        let t85 = t38 * t83 + t46 * t84;
        let t86 = t74 * t85;
        let t87 = t13 * t26 + (t9 * t23 - t11 * t24);
        let t88 = t26 * t37 + (t23 * t35 - t24 * t36);
        let t89 = t26 * t45 + (t23 * t43 - t24 * t44);
        let t90 = t38 * t88 + t46 * t89;
        let t91 = t74 * t90;
        let t92 = t7 * t27 + (t8 * t28 + t6 * t29);
        let t93 = t27 * t33 + (t28 * t34 + t29 * t32);
        let t94 = t27 * t41 + (t28 * t42 + t29 * t40);
        let t95 = t38 * t93 + t46 * t94;
        let t96 = t74 * t95;
        let t97 = t6 * t27 + (t5 * t28 - t7 * t29);
        let t98 = t27 * t32 + (t28 * t31 - t29 * t33);
        let t99 = t27 * t40 + (t28 * t39 - t29 * t41);
        let t100 = t38 * t98 + t46 * t99;
        let t101 = t74 * t100;
        let t102 = t5 * t29 + (t7 * t28 - t8 * t27);
        let t103 = t29 * t31 + (t28 * t33 - t27 * t34);
        let t104 = t29 * t39 + (t28 * t41 - t27 * t42);
        let t105 = t38 * t103 + t46 * t104;
        let t106 = t74 * t105;
        let t107 = t5 * t27 + (t8 * t29 - t6 * t28);
        let t108 = t27 * t31 + (t29 * t34 - t28 * t32);
        let t109 = t27 * t39 + (t29 * t42 - t28 * t40);
        let t110 = t38 * t108 + t46 * t109;
        let t111 = t74 * t110;
        let t112 = one / t47;
        let t113 = t46 * t112;
        let t114 = t38 * t112;
        let t115 = t51 * lambda[0];
        let t116 = t9 * t115 * two;
        let t117 = h[8] * t116;
        let t118 = t113 * lambda[2];
        let t119 = t70 * lambda[1];
        let t120 = t114 * lambda[2];
        let t121 = (t35 * t118 + (t9 * t119 - t43 * t120)) * two;
        let t122 = h[2] * t121;
        let t123 = t53 * lambda[0];
        let t124 = t9 * t123 * two;
        let t125 = h[5] * t124;
        let t126 = t117 + (t122 - t125);
        let t127 = t13 * t115 * two;
        let t128 = h[7] * t127;
        let t129 = (t37 * t118 + (t13 * t119 - t45 * t120)) * two;
        let t130 = h[1] * t129;
        let t131 = t13 * t123 * two;
        let t132 = h[4] * t131;
        let t133 = t128 + (t130 - t132);
        let t134 = t11 * t115 * two;
        let t135 = h[6] * t134;
        let t136 = (t36 * t118 + (t11 * t119 - t44 * t120)) * two;
        let t137 = h[0] * t136;
        let t138 = t11 * t123 * two;
        let t139 = h[3] * t138;
        let t140 = t135 + (t137 - t139);
        let t141 = t50 * half;
        let t142 = t50 * t50;
        let t143 = (t14 * t52 + t22 * t49) * t142;
        let t144 = lambda[0] * (t52 * t141 - t14 * t143);
        let t145 = t9 * t144;
        let t146 = t17 * k8;
        let t147 = t13 * t144;
        let t148 = t16 * k8;
        let t149 = t11 * t144;
        let t150 = t18 * k8;
        let t151 = t112 * half;
        let t152 = t112 * t112;
        let t153 = t73 * t152;
        let t154 = lambda[2] * (t72 * t151 - t46 * t153);
        let t155 = t69 * half;
        let t156 = t69 * t69;
        let t157 = (t48 * t75 + t30 * t68) * t156;
        let t158 = lambda[1] * (t75 * t155 - t48 * t157);
        let t159 = lambda[2] * (t71 * t151 - t38 * t153);
        let t160 = t35 * t154 + (t9 * t158 - t43 * t159);
        let t161 = t25 * k8;
        let t162 = t37 * t154 + (t13 * t158 - t45 * t159);
        let t163 = t24 * k8;
        let t164 = t36 * t154 + (t11 * t158 - t44 * t159);
        let t165 = t26 * k8;
        let t166 = lambda[0] * (t49 * t141 - t22 * t143);
        let t167 = t11 * t166;
        let t168 = t3 * k8;
        let t169 = t13 * t166;
        let t170 = t1 * k8;
        let t171 = t9 * t166;
        let t172 = t2 * k8;
        let t173 = t164 * t165 - t167 * t168 - t169 * t170 - t171 * t172;
        let t174 = t74 * t74;
        let t175 = t76 * lambda[1];
        let t176 = t175 * half;
        let t177 = t74 * (lambda[1] * (t68 * t155 - t30 * t157)) - t75 * t174 * t176;
        let t178 = t177 * k8;
        let t179 = h[2] * t43;
        let t180 = h[1] * t45;
        let t181 = h[0] * t44;
        let t182 = t180 + t181;
        let t183 = h[2] * t35;
        let t184 = h[1] * t37;
        let t185 = h[0] * t36;
        let t186 = t184 + t185;
        let t187 = t38 * (t183 + t186) + (t71 * t71 * two + t72 * t72 * two);
        let t188 = t74 * t175;
        let t189 = t188 * two;
        let t190 = t173 - t73 * t178 - (t46 * (t179 + t182) + t187) * t189;
        let t191 = t147 * t148 + (t149 * t150 + (t160 * t161 + (t162 * t163 + t190)));
        let t192 = h[7] * t116 + (h[1] * t121 - h[4] * t124);
        let t193 = t15 * k8;
        let t194 = t23 * k8;
        let t195 = h[5] * t131;
        let t196 = t0 * k8;
        let t197 = t195 - t162 * t161 - t167 * t196 - t170 * t171 - t147 * t146;
        let t198 = h[2] * t129;
        let t199 = h[8] * t127;
        let t200 = h[1] * t43;
        let t201 = h[2] * t45;
        let t202 = h[1] * t35;
        let t203 = h[2] * t37;
        let t204 = t38 * (t202 - t203) + (t71 * t78 * two + t72 * t79 * two);
        let t205 = t197 - t80 * t178 - t198 - t199 - t189 * (t46 * (t200 - t201) + t204);
        let t206 = t149 * t193 + (t169 * t172 + (t163 * t160 + (t164 * t194 + t205)));
        let t207 = t125 + (-t117 - t122);
        let t208 = t132 + (-t128 - t130);
        let t209 = t142 * (t14 * t55 + t22 * t54);
        let t210 = lambda[0] * (t55 * t141 - t14 * t209);
        let t211 = t9 * t210;
        let t212 = t11 * t210;
        let t213 = lambda[0] * (t54 * t141 - t22 * t209);
        let t214 = t13 * t213;
        let t215 = t80 * t152;
        let t216 = lambda[2] * (t79 * t151 - t46 * t215);
        let t217 = t156 * (t48 * t81 + t30 * t77);
        let t218 = lambda[1] * (t81 * t155 - t48 * t217);
        let t219 = lambda[2] * (t78 * t151 - t38 * t215);
        let t220 = t35 * t216 + (t9 * t218 - t43 * t219);
        let t221 = t36 * t216 + (t11 * t218 - t44 * t219);
        let t222 = t37 * t216 + (t13 * t218 - t45 * t219);
        let t223 = t11 * t213;
        let t224 = t9 * t213;
        let t225 = t13 * t210;
        let t226 = t140 - t161 * t222 - t196 * t223 - t170 * t224 - t146 * t225;
        let t227 = t74 * (lambda[1] * (t77 * t155 - t30 * t217)) - t176 * (t81 * t174);
        let t228 = t227 * k8;
        let t229 = t78 * t78 * two - t38 * (t183 + t184 - t185)
            - t46 * (t179 + t180 - t181);
        let t230 = t226 - t80 * t228 - t189 * (t79 * t79 * two + t229);
        let t231 = t193 * t212 + (t172 * t214 + (t163 * t220 + (t194 * t221 + t230)));
        let t232 = h[8] * t134 + (h[2] * t136 - h[5] * t138);
        let t233 = h[3] * t124;
        let t234 = t233 - t165 * t160 - t169 * t196 - t167 * t172 - t150 * t145;
        let t235 = h[0] * t121;
        let t236 = h[6] * t116;
        let t237 = h[2] * t44;
        let t238 = h[0] * t43;
        let t239 = h[2] * t36;
        let t240 = h[0] * t35;
        let t241 = t83 * two;
        let t242 = t84 * two;
        let t243 = t46 * (t237 - t238)
            + (t38 * (t239 - t240) + (t71 * t241 + t72 * t242));
        let t244 = t162 * t194 + (t234 - t85 * t178 - t235 - t236 - t189 * t243);
        let t245 = t149 * t146 + (t147 * t193 + (t168 * t171 + (t164 * t161 + t244)));
        let t246 = h[6] * t127 + (h[0] * t129 - h[3] * t131);
        let t247 = h[7] * t134;
        let t248 = h[1] * t136;
        let t249 = t248 - t165 * t220 - t196 * t214 - t172 * t223 - t150 * t211;
        let t250 = h[4] * t138;
        let t251 = h[0] * t45;
        let t252 = h[1] * t44;
        let t253 = h[0] * t37;
        let t254 = h[1] * t36;
        let t255 = t46 * (t251 + t252)
            + (t38 * (t253 + t254) + (t78 * t241 + t79 * t242));
        let t256 = t194 * t222 + (t247 + (t249 - t85 * t228 - t250 - t189 * t255));
        let t257 = t146 * t212 + (t193 * t225 + (t168 * t224 + (t161 * t221 + t256)));
        let t258 = t139 - t135 - t137;
        let t259 = t142 * (t14 * t57 + t22 * t56);
        let t260 = lambda[0] * (t57 * t141 - t14 * t259);
        let t261 = t11 * t260;
        let t262 = t13 * t260;
        let t263 = lambda[0] * (t56 * t141 - t22 * t259);
        let t264 = t9 * t263;
        let t265 = t85 * t152;
        let t266 = lambda[2] * (t84 * t151 - t46 * t265);
        let t267 = t156 * (t48 * t86 + t30 * t82);
        let t268 = lambda[1] * (t86 * t155 - t48 * t267);
        let t269 = lambda[2] * (t83 * t151 - t38 * t265);
        let t270 = t36 * t266 + (t11 * t268 - t44 * t269);
        let t271 = t37 * t266 + (t13 * t268 - t45 * t269);
        let t272 = t35 * t266 + (t9 * t268 - t43 * t269);
        let t273 = t13 * t263;
        let t274 = t11 * t263;
        let t275 = t133 + t207 - t165 * t272 - t196 * t273 - t172 * t274;
        let t276 = t9 * t260;
        let t277 = t74 * (lambda[1] * (t82 * t155 - t30 * t267)) - t176 * (t86 * t174);
        let t278 = t277 * k8;
        let t279 = t83 * t83 * two - t38 * (t183 + t185 - t184)
            - t46 * (t179 + t181 - t180);
        let t280 = t275 - t150 * t276 - t85 * t278 - t189 * (t84 * t84 * two + t279);
        let t281 = t193 * t262 + (t168 * t264 + (t161 * t270 + (t194 * t271 + t280)));
        let t282 = t246 - t164 * t163 - t171 * t196 - t168 * t169 - t149 * t148;
        let t283 = t88 * two;
        let t284 = t89 * two;
        let t285 = t46 * (t251 - t252)
            + (t38 * (t253 - t254) + (t71 * t283 + t72 * t284));
        let t286 = t250 + (t282 - t90 * t178 - t248 - t247 - t189 * t285);
        let t287 = t145 * t193 + (t167 * t170 + (t165 * t162 + (t160 * t194 + t286)));
        let t288 = t232 - t163 * t221 - t196 * t224 - t168 * t214 - t148 * t212;
        let t289 = t46 * (t238 + t237)
            + (t38 * (t240 + t239) + (t78 * t283 + t79 * t284));
        let t290 = t236 + (t235 + (t288 - t90 * t228 - t233 - t189 * t289));
        let t291 = t193 * t211 + (t170 * t223 + (t165 * t222 + (t194 * t220 + t290)));
        let t292 = t192 - t163 * t270 - t196 * t264 - t168 * t273 - t148 * t261;
        let t293 = t46 * (t201 + t200)
            + (t38 * (t203 + t202) + (t83 * t283 + t84 * t284));
        let t294 = t199 + (t198 + (t292 - t90 * t278 - t195 - t189 * t293));
        let t295 = t193 * t276 + (t170 * t274 + (t165 * t271 + (t194 * t272 + t294)));
        let t296 = t142 * (t14 * t59 + t22 * t58);
        let t297 = lambda[0] * (t59 * t141 - t14 * t296);
        let t298 = lambda[0] * (t58 * t141 - t22 * t296);
        let t299 = t90 * t152;
        let t300 = lambda[2] * (t89 * t151 - t46 * t299);
        let t301 = t156 * (t48 * t91 + t30 * t87);
        let t302 = lambda[1] * (t91 * t155 - t48 * t301);
        let t303 = lambda[2] * (t88 * t151 - t38 * t299);
        let t304 = t258 + (t126 + t208)
            - t163 * (t36 * t300 + (t11 * t302 - t44 * t303));
        let t305 = t304 - t196 * (t9 * t298) - t168 * (t13 * t298) - t148 * (t11 * t297);
        let t306 = t74 * (lambda[1] * (t87 * t155 - t30 * t301)) - t176 * (t91 * t174);
        let t307 = t306 * k8;
        let t308 = t88 * t88 * two - t38 * (t186 - t183) - t46 * (t182 - t179);
        let t309 = t305 - t90 * t307 - t189 * (t89 * t89 * two + t308);
        let t310 = t194 * (t35 * t300 + (t9 * t302 - t43 * t303)) + t309;
        let t311 = t165 * (t37 * t300 + (t13 * t302 - t45 * t303)) + t310;
        let t312 = t27 * two;
        let t313 = t25 * t118;
        let t314 = t154 * t312 + t313;
        let t315 = t33 * k4;
        let t316 = t29 * two;
        let t317 = t24 * t118;
        let t318 = t154 * t316 + t317;
        let t319 = t32 * k4;
        let t320 = t28 * two;
        let t321 = t26 * t118;
        let t322 = t154 * t320 + t321;
        let t323 = t34 * k4;
        let t324 = t17 * t115;
        let t325 = t25 * t119;
        let t326 = t2 * t123;
        let t327 = t324 + (t325 - t326);
        let t328 = t19 * two;
        let t329 = t4 * two;
        let t330 = t327 + (t144 * t328 + (t158 * t312 - t166 * t329));
        let t331 = t7 * k4;
        let t332 = t16 * t115;
        let t333 = t24 * t119;
        let t334 = t1 * t123;
        let t335 = t332 + (t333 - t334);
        let t336 = t21 * two;
        let t337 = t12 * two;
        let t338 = t335 + (t144 * t336 + (t158 * t316 - t166 * t337));
        let t339 = t6 * k4;
        let t340 = t18 * t115;
        let t341 = t26 * t119;
        let t342 = t3 * t123;
        let t343 = t340 + (t341 - t342);
        let t344 = t20 * two;
        let t345 = t10 * two;
        let t346 = t343 + (t144 * t344 + (t158 * t320 - t166 * t345));
        let t347 = t8 * k4;
        let t348 = t26 * t120;
        let t349 = t159 * t320 + t348;
        let t350 = t42 * k4;
        let t351 = t24 * t120;
        let t352 = t159 * t316 + t351;
        let t353 = t40 * k4;
        let t354 = t346 * t347 - t95 * t178 - t349 * t350 - t352 * t353;
        let t355 = t25 * t120;
        let t356 = t159 * t312 + t355;
        let t357 = t41 * k4;
        let t358 = t26 * t34;
        let t359 = t25 * t33;
        let t360 = t24 * t32;
        let t361 = t359 + t360;
        let t362 = t26 * t42;
        let t363 = t25 * t41;
        let t364 = t24 * t40;
        let t365 = t363 + t364;
        let t366 = t71 * t93 + (t38 * (t358 + t361) + t46 * (t362 + t365));
        let t367 = t188 * k4;
        let t368 = t338 * t339 + (t354 - t356 * t357 - (t72 * t94 + t366) * t367);
        let t369 = t317 + t216 * t312;
        let t370 = t216 * t316 - t313;
        let t371 = t23 * t118;
        let t372 = t216 * t320 + t371;
        let t373 = t210 * t328 + (t218 * t312 + (t335 - t213 * t329));
        let t374 = t210 * t336 + (t218 * t316 - t213 * t337 - t325 - t324);
        let t375 = t326 + t374;
        let t376 = t15 * t115 + (t23 * t119 - t0 * t123);
        let t377 = t376 + (t210 * t344 + (t218 * t320 - t213 * t345));
        let t378 = t23 * t120;
        let t379 = t219 * t320 + t378;
        let t380 = t219 * t316 - t355;
        let t381 = t347 * t377 - t95 * t228 - t350 * t379 - t353 * t380;
        let t382 = t351 + t219 * t312;
        let t383 = t24 * t33;
        let t384 = t23 * t34;
        let t385 = t383 + t384;
        let t386 = t25 * t32;
        let t387 = t24 * t41;
        let t388 = t23 * t42;
        let t389 = t387 + t388;
        let t390 = t25 * t40;
        let t391 = t78 * t93 + (t38 * (t385 - t386) + t46 * (t389 - t390));
        let t392 = t339 * t375 + (t381 - t357 * t382 - t367 * (t79 * t94 + t391));
        let t393 = t266 * t312 - t321;
        let t394 = t371 + t266 * t316;
        let t395 = t313 + t266 * t320;
        let t396 = t260 * t328 + (t268 * t312 - t263 * t329 - t341 - t340);
        let t397 = t342 + t396;
        let t398 = t260 * t336 + (t268 * t316 + (t376 - t263 * t337));
        let t399 = t260 * t344 + (t268 * t320 + (t327 - t263 * t345));
        let t400 = t355 + t269 * t320;
        let t401 = t378 + t269 * t316;
        let t402 = t347 * t399 - t95 * t278 - t350 * t400 - t353 * t401;
        let t403 = t269 * t312 - t348;
        let t404 = t25 * t34;
        let t405 = t23 * t32;
        let t406 = t404 + t405;
        let t407 = t26 * t33;
        let t408 = t25 * t42;
        let t409 = t23 * t40;
        let t410 = t408 + t409;
        let t411 = t26 * t41;
        let t412 = t83 * t93 + (t38 * (t406 - t407) + t46 * (t410 - t411));
        let t413 = t339 * t398 + (t402 - t357 * t403 - t367 * (t84 * t94 + t412));
        let t414 = t371 + t300 * t312;
        let t415 = t321 + t300 * t316;
        let t416 = t300 * t320 - t317;
        let t417 = t297 * t328 + (t302 * t312 + (t376 - t298 * t329));
        let t418 = t297 * t336 + (t302 * t316 + (t343 - t298 * t337));
        let t419 = t297 * t344 + (t302 * t320 - t298 * t345 - t333 - t332);
        let t420 = t334 + t419;
        let t421 = t303 * t320 - t351;
        let t422 = t348 + t303 * t316;
        let t423 = t347 * t420 - t95 * t307 - t350 * t421 - t353 * t422;
        let t424 = t378 + t303 * t312;
        let t425 = t26 * t32;
        let t426 = t23 * t33;
        let t427 = t425 + t426;
        let t428 = t24 * t34;
        let t429 = t26 * t40;
        let t430 = t23 * t41;
        let t431 = t429 + t430;
        let t432 = t24 * t42;
        let t433 = t88 * t93 + (t38 * (t427 - t428) + t46 * (t431 - t432));
        let t434 = t339 * t418 + (t423 - t357 * t424 - t367 * (t89 * t94 + t433));
        let t435 = (t19 * t115 + (t27 * t119 - t4 * t123)) * two;
        let t436 = h[17] * t435;
        let t437 = t27 * t118 * two;
        let t438 = h[11] * t437;
        let t439 = t27 * t120 * two;
        let t440 = h[14] * t439;
        let t441 = t436 + (t438 - t440);
        let t442 = (t21 * t115 + (t29 * t119 - t12 * t123)) * two;
        let t443 = h[16] * t442;
        let t444 = t29 * t118 * two;
        let t445 = h[10] * t444;
        let t446 = t29 * t120 * two;
        let t447 = h[13] * t446;
        let t448 = t443 + (t445 - t447);
        let t449 = (t20 * t115 + (t28 * t119 - t10 * t123)) * two;
        let t450 = h[15] * t449;
        let t451 = t28 * t118 * two;
        let t452 = h[9] * t451;
        let t453 = t28 * t120 * two;
        let t454 = h[12] * t453;
        let t455 = t450 + (t452 - t454);
        let t456 = t95 * t152;
        let t457 = lambda[2] * (t94 * t151 - t46 * t456);
        let t458 = t27 * t457;
        let t459 = t33 * k8;
        let t460 = t29 * t457;
        let t461 = t32 * k8;
        let t462 = t28 * t457;
        let t463 = t34 * k8;
        let t464 = t142 * (t14 * t61 + t22 * t60);
        let t465 = lambda[0] * (t61 * t141 - t14 * t464);
        let t466 = t156 * (t48 * t96 + t30 * t92);
        let t467 = lambda[1] * (t96 * t155 - t48 * t466);
        let t468 = lambda[0] * (t60 * t141 - t22 * t464);
        let t469 = t19 * t465 + (t27 * t467 - t4 * t468);
        let t470 = t7 * k8;
        let t471 = t21 * t465 + (t29 * t467 - t12 * t468);
        let t472 = t6 * k8;
        let t473 = t20 * t465 + (t28 * t467 - t10 * t468);
        let t474 = t8 * k8;
        let t475 = lambda[2] * (t93 * t151 - t38 * t456);
        let t476 = t28 * t475;
        let t477 = t42 * k8;
        let t478 = t29 * t475;
        let t479 = t40 * k8;
        let t480 = t27 * t475;
        let t481 = t41 * k8;
        let t482 = t473 * t474 - t476 * t477 - t478 * t479 - t480 * t481;
        let t483 = t74 * (lambda[1] * (t92 * t155 - t30 * t466)) - t176 * (t96 * t174);
        let t484 = t27 * h[14];
        let t485 = t29 * h[13];
        let t486 = t28 * h[12];
        let t487 = t485 + t486;
        let t488 = t27 * h[11];
        let t489 = t29 * h[10];
        let t490 = t28 * h[9];
        let t491 = t489 + t490;
        let t492 = t38 * (t488 + t491) + (t93 * t93 * two + t94 * t94 * two);
        let t493 = t482 - t95 * t483 * k8 - t189 * (t46 * (t484 + t487) + t492);
        let t494 = t460 * t461 + (t462 * t463 + (t469 * t470 + (t471 * t472 + t493)));
        let t495 = t31 * k4;
        let t496 = t5 * k4;
        let t497 = t346 * t496 - t100 * t178 - t338 * t331 - t318 * t315;
        let t498 = t39 * k4;
        let t499 = t26 * t31;
        let t500 = t386 + t499;
        let t501 = t26 * t39;
        let t502 = t390 + t501;
        let t503 = t71 * t98 + (t38 * (t500 - t383) + t46 * (t502 - t387));
        let t504 = t497 - t349 * t498 - t353 * t356 - t367 * (t72 * t99 + t503);
        let t505 = t377 * t496 - t100 * t228 - t331 * t375 - t315 * t370;
        let t506 = t23 * t31;
        let t507 = t23 * t39;
        let t508 = t78 * t98 + (t38 * (t361 + t506) + t46 * (t365 + t507));
        let t509 = t505 - t379 * t498 - t353 * t382 - t367 * (t79 * t99 + t508);
        let t510 = t399 * t496 - t100 * t278 - t331 * t398 - t315 * t394;
        let t511 = t25 * t31;
        let t512 = t25 * t39;
        let t513 = t83 * t98 - t38 * (t427 - t511) - t46 * (t431 - t512);
        let t514 = t510 - t400 * t498 - t353 * t403 - t367 * (t84 * t99 + t513);
        let t515 = t100 * k8;
        let t516 = t420 * t496 - t306 * t515 - t331 * t418 - t315 * t415;
        let t517 = t24 * t31;
        let t518 = t407 + t517;
        let t519 = t24 * t39;
        let t520 = t411 + t519;
        let t521 = t88 * t98 - t38 * (t518 - t405) - t46 * (t520 - t409);
        let t522 = t516 - t421 * t498 - t353 * t424 - t367 * (t89 * t99 + t521);
        let t523 = h[16] * t435 + (h[10] * t437 - h[13] * t439);
        let t524 = t31 * k8;
        let t525 = t5 * k8;
        let t526 = h[14] * t446;
        let t527 = t39 * k8;
        let t528 = t526 - t471 * t470 - t460 * t459 - t476 * t527 - t479 * t480;
        let t529 = h[11] * t444;
        let t530 = h[17] * t442;
        let t531 = t27 * h[13];
        let t532 = t29 * h[14];
        let t533 = t27 * h[10];
        let t534 = t29 * h[11];
        let t535 = t38 * (t533 - t534) + (t93 * t98 * two + t94 * t99 * two);
        let t536 = t528 - t483 * t515 - t529 - t530
            - t189 * (t46 * (t531 - t532) + t535);
        let t537 = t461 * t458 + (t462 * t524 + (t472 * t469 + (t473 * t525 + t536)));
        let t538 = t440 + (-t436 - t438);
        let t539 = t447 + (-t443 - t445);
        let t540 = t100 * t152;
        let t541 = lambda[2] * (t98 * t151 - t38 * t540);
        let t542 = t29 * t541;
        let t543 = lambda[2] * (t99 * t151 - t46 * t540);
        let t544 = t27 * t543;
        let t545 = t28 * t543;
        let t546 = t142 * (t14 * t63 + t22 * t62);
        let t547 = lambda[0] * (t63 * t141 - t14 * t546);
        let t548 = t156 * (t48 * t101 + t30 * t97);
        let t549 = lambda[1] * (t101 * t155 - t48 * t548);
        let t550 = lambda[0] * (t62 * t141 - t22 * t546);
        let t551 = t19 * t547 + (t27 * t549 - t4 * t550);
        let t552 = t20 * t547 + (t28 * t549 - t10 * t550);
        let t553 = t21 * t547 + (t29 * t549 - t12 * t550);
        let t554 = t29 * t543;
        let t555 = t28 * t541;
        let t556 = t27 * t541;
        let t557 = t455 - t470 * t553 - t459 * t554 - t527 * t555 - t479 * t556;
        let t558 = t74 * (lambda[1] * (t97 * t155 - t30 * t548)) - t176 * (t101 * t174);
        let t559 = t98 * t98 * two - t38 * (t488 + t489 - t490)
            - t46 * (t484 + t485 - t486);
        let t560 = t557 - t515 * t558 - t189 * (t99 * t99 * two + t559);
        let t561 = t461 * t544 + (t524 * t545 + (t472 * t551 + (t525 * t552 + t560)));
        let t562 = t338 * t496 - t105 * t178 - t347 * t330 - t323 * t314;
        let t563 = t71 * t103 + (t38 * (t518 - t404) + t46 * (t520 - t408));
        let t564 = t562 - t352 * t498 - t349 * t357 - t367 * (t72 * t104 + t563);
        let t565 = t375 * t496 - t105 * t228 - t347 * t373 - t323 * t369;
        let t566 = t428 + t511;
        let t567 = t432 + t512;
        let t568 = t78 * t103 - t38 * (t566 - t426) - t46 * (t567 - t430);
        let t569 = t565 - t380 * t498 - t357 * t379 - t367 * (t79 * t104 + t568);
        let t570 = t105 * k8;
        let t571 = t398 * t496 - t277 * t570 - t347 * t397 - t323 * t393;
        let t572 = t358 + t506;
        let t573 = t362 + t507;
        let t574 = t83 * t103 + (t38 * (t359 + t572) + t46 * (t363 + t573));
        let t575 = t571 - t401 * t498 - t357 * t400 - t367 * (t84 * t104 + t574);
        let t576 = t418 * t496 - t306 * t570 - t347 * t417 - t323 * t414;
        let t577 = t88 * t103 - t38 * (t385 - t499) - t46 * (t389 - t501);
        let t578 = t576 - t422 * t498 - t357 * t421 - t367 * (t89 * t104 + t577);
        let t579 = h[17] * t449 + (h[11] * t451 - h[14] * t453);
        let t580 = h[12] * t439;
        let t581 = t580 - t474 * t469 - t463 * t458 - t478 * t527 - t476 * t481;
        let t582 = h[9] * t437;
        let t583 = h[15] * t435;
        let t584 = t28 * h[14];
        let t585 = t27 * h[12];
        let t586 = t28 * h[11];
        let t587 = t27 * h[9];
        let t588 = t103 * two;
        let t589 = t104 * two;
        let t590 = t46 * (t584 - t585)
            + (t38 * (t586 - t587) + (t93 * t588 + t94 * t589));
        let t591 = t471 * t525 + (t581 - t483 * t570 - t582 - t583 - t189 * t590);
        let t592 = t477 * t480 + (t462 * t459 + (t460 * t524 + (t473 * t470 + t591)));
        let t593 = h[15] * t442 + (h[9] * t444 - h[12] * t446);
        let t594 = h[16] * t449;
        let t595 = h[10] * t451;
        let t596 = t595 - t474 * t551 - t463 * t544 - t527 * t542 - t481 * t555;
        let t597 = h[13] * t453;
        let t598 = t29 * h[12];
        let t599 = t28 * h[13];
        let t600 = t29 * h[9];
        let t601 = t28 * h[10];
        let t602 = t46 * (t598 + t599)
            + (t38 * (t600 + t601) + (t98 * t588 + t99 * t589));
        let t603 = t525 * t553 + (t594 + (t596 - t558 * t570 - t597 - t189 * t602));
        let t604 = t477 * t556 + (t459 * t545 + (t524 * t554 + (t470 * t552 + t603)));
        let t605 = t454 + (-t450 - t452);
        let t606 = t105 * t152;
        let t607 = lambda[2] * (t103 * t151 - t38 * t606);
        let t608 = t27 * t607;
        let t609 = lambda[2] * (t104 * t151 - t46 * t606);
        let t610 = t28 * t609;
        let t611 = t29 * t609;
        let t612 = t142 * (t14 * t65 + t22 * t64);
        let t613 = lambda[0] * (t65 * t141 - t14 * t612);
        let t614 = t156 * (t48 * t106 + t30 * t102);
        let t615 = lambda[1] * (t106 * t155 - t48 * t614);
        let t616 = lambda[0] * (t64 * t141 - t22 * t612);
        let t617 = t20 * t613 + (t28 * t615 - t10 * t616);
        let t618 = t21 * t613 + (t29 * t615 - t12 * t616);
        let t619 = t19 * t613 + (t27 * t615 - t4 * t616);
        let t620 = t27 * t609;
        let t621 = t29 * t607;
        let t622 = t448 + t538 - t474 * t619 - t463 * t620 - t527 * t621;
        let t623 = t28 * t607;
        let t624 = t74 * (lambda[1] * (t102 * t155 - t30 * t614)) - t176 * (t106 * t174);
        let t625 = t103 * t103 * two - t38 * (t488 + t490 - t489)
            - t46 * (t484 + t486 - t485);
        let t626 = t622 - t481 * t623 - t570 * t624 - t189 * (t104 * t104 * two + t625);
        let t627 = t459 * t610 + (t524 * t611 + (t470 * t617 + (t525 * t618 + t626)));
        let t628 = t330 * t496 - t110 * t178 - t346 * t339 - t322 * t319;
        let t629 = t71 * t108 + (t38 * (t566 - t425) + t46 * (t567 - t429));
        let t630 = t628 - t356 * t498 - t350 * t352 - t367 * (t72 * t109 + t629);
        let t631 = t110 * k8;
        let t632 = t373 * t496 - t227 * t631 - t339 * t377 - t319 * t372;
        let t633 = t78 * t108 - t38 * (t406 - t517) - t46 * (t410 - t519);
        let t634 = t632 - t382 * t498 - t350 * t380 - t367 * (t79 * t109 + t633);
        let t635 = t397 * t496 - t277 * t631 - t339 * t399 - t319 * t395;
        let t636 = t83 * t108 - t38 * (t500 - t384) - t46 * (t502 - t388);
        let t637 = t635 - t403 * t498 - t350 * t401 - t367 * (t84 * t109 + t636);
        let t638 = t417 * t496 - t306 * t631 - t339 * t420 - t319 * t416;
        let t639 = t88 * t108 + (t38 * (t360 + t572) + t46 * (t364 + t573));
        let t640 = t638 - t424 * t498 - t350 * t422 - t367 * (t89 * t109 + t639);
        let t641 = t593 - t473 * t472 - t462 * t461 - t480 * t527 - t477 * t478;
        let t642 = t108 * two;
        let t643 = t109 * two;
        let t644 = t46 * (t598 - t599)
            + (t38 * (t600 - t601) + (t93 * t642 + t94 * t643));
        let t645 = t597 + (t641 - t483 * t631 - t595 - t594 - t189 * t644);
        let t646 = t463 * t460 + (t458 * t524 + (t474 * t471 + (t469 * t525 + t645)));
        let t647 = t579 - t472 * t552 - t461 * t545 - t527 * t556 - t477 * t542;
        let t648 = t46 * (t585 + t584)
            + (t38 * (t587 + t586) + (t98 * t642 + t99 * t643));
        let t649 = t583 + (t582 + (t647 - t558 * t631 - t580 - t189 * t648));
        let t650 = t463 * t554 + (t524 * t544 + (t474 * t553 + (t525 * t551 + t649)));
        let t651 = t523 - t472 * t617 - t461 * t610 - t527 * t608 - t477 * t621;
        let t652 = t46 * (t532 + t531)
            + (t38 * (t534 + t533) + (t103 * t642 + t104 * t643));
        let t653 = t530 + (t529 + (t651 - t624 * t631 - t526 - t189 * t652));
        let t654 = t463 * t611 + (t524 * t620 + (t474 * t618 + (t525 * t619 + t653)));
        let t655 = t110 * t152;
        let t656 = lambda[2] * (t108 * t151 - t38 * t655);
        let t657 = lambda[2] * (t109 * t151 - t46 * t655);
        let t658 = t142 * (t14 * t67 + t22 * t66);
        let t659 = lambda[0] * (t67 * t141 - t14 * t658);
        let t660 = t156 * (t48 * t111 + t30 * t107);
        let t661 = lambda[1] * (t111 * t155 - t48 * t660);
        let t662 = lambda[0] * (t66 * t141 - t22 * t658);
        let t663 = t605 + (t441 + t539)
            - t472 * (t20 * t659 + (t28 * t661 - t10 * t662));
        let t664 = t663 - t461 * (t28 * t657) - t527 * (t27 * t656)
            - t477 * (t29 * t656);
        let t665 = t74 * (lambda[1] * (t107 * t155 - t30 * t660)) - t176 * (t111 * t174);
        let t666 = t108 * t108 * two - t38 * (t491 - t488) - t46 * (t487 - t484);
        let t667 = t664 - t631 * t665 - t189 * (t109 * t109 * two + t666);
        let t668 = t525 * (t19 * t659 + (t27 * t661 - t4 * t662)) + t667;
        let t669 = t474 * (t21 * t659 + (t29 * t661 - t12 * t662)) + t668;
        phi[0] = (-t14).atan2(t22);
        phi[1] = t30.atan2(t48);
        phi[2] = (-t46).atan2(t38);
        phi_q[0] = (t49 * t51 - t52 * t53) * two;
        phi_q[1] = (t51 * t54 - t53 * t55) * two;
        phi_q[2] = (t51 * t56 - t53 * t57) * two;
        phi_q[3] = (t51 * t58 - t53 * t59) * two;
        phi_q[4] = (t51 * t60 - t53 * t61) * two;
        phi_q[5] = (t51 * t62 - t53 * t63) * two;
        phi_q[6] = (t51 * t64 - t53 * t65) * two;
        phi_q[7] = (t51 * t66 - t53 * t67) * two;
        phi_q[8] = (t68 * t70 - t75 * t76) * two;
        phi_q[9] = (t70 * t77 - t76 * t81) * two;
        phi_q[10] = (t70 * t82 - t76 * t86) * two;
        phi_q[11] = (t70 * t87 - t76 * t91) * two;
        phi_q[12] = (t70 * t92 - t76 * t96) * two;
        phi_q[13] = (t70 * t97 - t76 * t101) * two;
        phi_q[14] = (t70 * t102 - t76 * t106) * two;
        phi_q[15] = (t70 * t107 - t76 * t111) * two;
        phi_q[16] = (t71 * t113 - t72 * t114) * two;
        phi_q[17] = (t78 * t113 - t79 * t114) * two;
        phi_q[18] = (t83 * t113 - t84 * t114) * two;
        phi_q[19] = (t88 * t113 - t89 * t114) * two;
        phi_q[20] = (t93 * t113 - t94 * t114) * two;
        phi_q[21] = (t98 * t113 - t99 * t114) * two;
        phi_q[22] = (t103 * t113 - t104 * t114) * two;
        phi_q[23] = (t108 * t113 - t109 * t114) * two;
        curvature[0] = t126 + (t133 + (t140 + (t145 * t146 + t191)));
        curvature[1] = t192 + (t148 * t145 + t206);
        curvature[2] = t207 + (t208 + (t148 * t211 + t231));
        curvature[3] = t232 + t245;
        curvature[4] = t246 + t257;
        curvature[5] = t258 + (t146 * t261 + t281);
        curvature[6] = t150 * t147 + t287;
        curvature[7] = t150 * t225 + t291;
        curvature[8] = t150 * t262 + t295;
        curvature[9] = t150 * (t13 * t297)
            + (t193 * (t9 * t297) + (t170 * (t11 * t298) + t311));
        curvature[10] = t314 * t315
            + (t318 * t319 + (t322 * t323 + (t330 * t331 + t368)));
        curvature[11] = t315 * t369
            + (t319 * t370 + (t323 * t372 + (t331 * t373 + t392)));
        curvature[12] = t315 * t393
            + (t319 * t394 + (t323 * t395 + (t331 * t397 + t413)));
        curvature[13] = t315 * t414
            + (t319 * t415 + (t323 * t416 + (t331 * t417 + t434)));
        curvature[14] = t441 + (t448 + (t455 + (t458 * t459 + t494)));
        curvature[15] = t352 * t357
            + (t319 * t314 + (t322 * t495 + (t339 * t330 + t504)));
        curvature[16] = t357 * t380
            + (t319 * t369 + (t372 * t495 + (t339 * t373 + t509)));
        curvature[17] = t357 * t401
            + (t319 * t393 + (t395 * t495 + (t339 * t397 + t514)));
        curvature[18] = t357 * t422
            + (t319 * t414 + (t416 * t495 + (t339 * t417 + t522)));
        curvature[19] = t523 + (t478 * t481 + t537);
        curvature[20] = t538 + (t539 + (t481 * t542 + t561));
        curvature[21] = t350 * t356
            + (t322 * t315 + (t318 * t495 + (t346 * t331 + t564)));
        curvature[22] = t350 * t382
            + (t315 * t372 + (t370 * t495 + (t331 * t377 + t569)));
        curvature[23] = t350 * t403
            + (t315 * t395 + (t394 * t495 + (t331 * t399 + t575)));
        curvature[24] = t350 * t424
            + (t315 * t416 + (t415 * t495 + (t331 * t420 + t578)));
        curvature[25] = t579 + t592;
        curvature[26] = t593 + t604;
        curvature[27] = t605 + (t477 * t608 + t627);
        curvature[28] = t349 * t353
            + (t323 * t318 + (t314 * t495 + (t347 * t338 + t630)));
        curvature[29] = t353 * t379
            + (t323 * t370 + (t369 * t495 + (t347 * t375 + t634)));
        curvature[30] = t353 * t400
            + (t323 * t394 + (t393 * t495 + (t347 * t398 + t637)));
        curvature[31] = t353 * t421
            + (t323 * t415 + (t414 * t495 + (t347 * t418 + t640)));
        curvature[32] = t476 * t479 + t646;
        curvature[33] = t479 * t555 + t650;
        curvature[34] = t479 * t623 + t654;
        curvature[35] = t479 * (t28 * t656)
            + (t463 * (t29 * t657) + (t524 * (t27 * t657) + t669));
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 1658 additions, 2499 multiplications, 4 divisions, 1 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 18],
        lambda: &[S; 3],
        phi_h: &mut [S; 30],
        force_h: &mut [S; 144],
    ) {
        let one = S::from_f64(1.0);
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let k4 = S::from_f64(4.0);
        let k8 = S::from_f64(8.0);
        let k1_over_4 = S::from_f64(0.25);
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
        let t25 = q_i[3] * q_i[3];
        let t26 = q_i[4] * q_i[4];
        let t27 = q_i[6] * q_i[6];
        let t28 = q_i[5] * q_i[5];
        let t29 = t25 + t26 - t27 - t28;
        let t30 = q_i[3] * q_i[6];
        let t31 = q_i[4] * q_i[5];
        let t32 = t30 + t31;
        let t33 = t32 * two;
        let t34 = q_i[4] * q_i[6];
        let t35 = q_i[3] * q_i[5];
        let t36 = t34 - t35;
        let t37 = t36 * two;
        let t38 = t11 * t29 + (t13 * t33 + t9 * t37);
        let t39 = q_i[4] * q_i[3];
        let t40 = q_i[6] * q_i[5];
        let t41 = t39 + t40;
        let t42 = t25 - t26;
        let t43 = t28 - t27;
        let t44 = t42 + t43;
        let t45 = t44 * half;
        let t46 = t31 - t30;
        let t47 = t9 * t41 + (t13 * t45 + t11 * t46);
        let t48 = t40 - t39;
        let t49 = t42 - t43;
        let t50 = t49 * half;
        let t51 = t35 + t34;
        let t52 = t13 * t48 + (t9 * t50 + t11 * t51);
        let t53 = t22 * t23;
        let t54 = q_j[3] * q_j[3];
        let t55 = q_j[4] * q_j[4];
        let t56 = q_j[6] * q_j[6];
        let t57 = q_j[5] * q_j[5];
        let t58 = t54 + t55 - t56 - t57;
        let t59 = q_j[3] * q_j[6];
        let t60 = q_j[4] * q_j[5];
        let t61 = t59 + t60;
        let t62 = t61 * two;
        let t63 = q_j[4] * q_j[6];
        let t64 = q_j[3] * q_j[5];
        let t65 = t63 - t64;
        let t66 = t65 * two;
        let t67 = t10 * t58 + (t12 * t62 + t4 * t66);
        let t68 = t20 * t58 + (t21 * t62 + t19 * t66);
        let t69 = q_j[4] * q_j[3];
        let t70 = q_j[6] * q_j[5];
        let t71 = t69 + t70;
        let t72 = t54 - t55;
        let t73 = t57 - t56;
        let t74 = t72 + t73;
        let t75 = t74 * half;
        let t76 = t60 - t59;
        let t77 = t4 * t71 + (t12 * t75 + t10 * t76);
        let t78 = t19 * t71 + (t21 * t75 + t20 * t76);
        let t79 = t70 - t69;
        let t80 = t72 - t73;
        let t81 = t80 * half;
        let t82 = t64 + t63;
        let t83 = t12 * t79 + (t4 * t81 + t10 * t82);
        let t84 = t21 * t79 + (t19 * t81 + t20 * t82);
        let t85 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t86 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t87 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t88 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t89 = q_i[6] * t85 + (q_i[4] * t86 + (q_i[3] * t87 - q_i[5] * t88));
        let t90 = q_j[6] * h[11] + (q_j[4] * h[9] + q_j[5] * h[10]);
        let t91 = q_j[6] * h[9] + (q_j[3] * h[10] - q_j[4] * h[11]);
        let t92 = q_j[4] * h[10] + (q_j[3] * h[11] - q_j[5] * h[9]);
        let t93 = q_j[5] * h[11] + (q_j[3] * h[9] - q_j[6] * h[10]);
        let t94 = q_j[6] * t90 + (q_j[4] * t91 + (q_j[3] * t92 - q_j[5] * t93));
        let t95 = q_i[5] * t87 + (q_i[4] * t85 + (q_i[3] * t88 - q_i[6] * t86));
        let t96 = q_j[5] * t92 + (q_j[4] * t90 + (q_j[3] * t93 - q_j[6] * t91));
        let t97 = q_i[6] * t88 + (q_i[5] * t85 + (q_i[3] * t86 - q_i[4] * t87));
        let t98 = q_j[6] * t93 + (q_j[5] * t90 + (q_j[3] * t91 - q_j[4] * t92));
        let t99 = t89 * t94 + (t95 * t96 + t97 * t98);
        let t100 = q_j[6] * h[14] + (q_j[4] * h[12] + q_j[5] * h[13]);
        let t101 = q_j[6] * h[12] + (q_j[3] * h[13] - q_j[4] * h[14]);
        let t102 = q_j[4] * h[13] + (q_j[3] * h[14] - q_j[5] * h[12]);
        let t103 = q_j[5] * h[14] + (q_j[3] * h[12] - q_j[6] * h[13]);
        let t104 = q_j[6] * t100 + (q_j[4] * t101 + (q_j[3] * t102 - q_j[5] * t103));
        let t105 = q_j[5] * t102 + (q_j[4] * t100 + (q_j[3] * t103 - q_j[6] * t101));
        let t106 = q_j[6] * t103 + (q_j[5] * t100 + (q_j[3] * t101 - q_j[4] * t102));
        let t107 = t89 * t104 + (t95 * t105 + t97 * t106);
        let t108 = t99 * t99 + t107 * t107;
        let t109 = t108.sqrt();
        let t110 = t9 * t89 + (t11 * t95 + t13 * t97);
        let t111 = one / (t109 * t109 + t110 * t110);
        let t112 = t109 * t111;
        let t113 = one / t109;
        let t114 = t29 * t96 + (t33 * t98 + t37 * t94);
        let t115 = t29 * t105 + (t33 * t106 + t37 * t104);
        let t116 = t99 * t114 + t107 * t115;
        let t117 = t113 * t116;
        let t118 = t110 * t111;
        let t119 = t41 * t94 + (t45 * t98 + t46 * t96);
        let t120 = t41 * t104 + (t45 * t106 + t46 * t105);
        let t121 = t99 * t119 + t107 * t120;
        let t122 = t113 * t121;
        let t123 = t48 * t98 + (t50 * t94 + t51 * t96);
        let t124 = t48 * t106 + (t50 * t104 + t51 * t105);
        let t125 = t99 * t123 + t107 * t124;
        let t126 = t113 * t125;
        let t127 = t58 * t95 + (t62 * t97 + t66 * t89);
        let t128 = t99 * t127;
        let t129 = t113 * t128;
        let t130 = t71 * t89 + (t75 * t97 + t76 * t95);
        let t131 = t99 * t130;
        let t132 = t113 * t131;
        let t133 = t79 * t97 + (t81 * t89 + t82 * t95);
        let t134 = t99 * t133;
        let t135 = t113 * t134;
        let t136 = t107 * t127;
        let t137 = t113 * t136;
        let t138 = t107 * t130;
        let t139 = t113 * t138;
        let t140 = t107 * t133;
        let t141 = t113 * t140;
        let t142 = one / t108;
        let t143 = t107 * t142;
        let t144 = t99 * t142;
        let t145 = t143 * lambda[2];
        let t146 = t112 * lambda[1];
        let t147 = t144 * lambda[2];
        let t148 = t98 * t145 + (t13 * t146 - t106 * t147);
        let t149 = q_i[6] * two;
        let t150 = t148 * t149;
        let t151 = t96 * t145 + (t11 * t146 - t105 * t147);
        let t152 = q_i[3] * two;
        let t153 = t151 * t152;
        let t154 = t94 * t145 + (t9 * t146 - t104 * t147);
        let t155 = q_i[5] * two;
        let t156 = t154 * t155;
        let t157 = t150 + (t153 - t156);
        let t158 = t142 * half;
        let t159 = t142 * t142;
        let t160 = t116 * t159;
        let t161 = lambda[2] * (t115 * t158 - t107 * t160);
        let t162 = t111 * half;
        let t163 = t111 * t111;
        let t164 = (t109 * t117 + t38 * t110) * t163;
        let t165 = lambda[1] * (t117 * t162 - t109 * t164);
        let t166 = lambda[2] * (t114 * t158 - t99 * t160);
        let t167 = t94 * t161 + (t9 * t165 - t104 * t166);
        let t168 = t87 * k4;
        let t169 = t98 * t161 + (t13 * t165 - t106 * t166);
        let t170 = t86 * k4;
        let t171 = t96 * t161 + (t11 * t165 - t105 * t166);
        let t172 = t88 * k4;
        let t173 = t87 * t94 + (t88 * t96 + t86 * t98);
        let t174 = t87 * t104 + (t88 * t105 + t86 * t106);
        let t175 = t99 * t173 + t107 * t174;
        let t176 = t113 * t113;
        let t177 = t118 * lambda[1];
        let t178 = t177 * half;
        let t179 = t113 * (lambda[1] * (t38 * t162 - t110 * t164)) - t117 * t176 * t178;
        let t180 = t179 * k4;
        let t181 = t107 * (q_i[6] * t106 + (q_i[3] * t105 - q_i[5] * t104));
        let t182 = t99 * (q_i[6] * t98 + (q_i[3] * t96 - q_i[5] * t94));
        let t183 = t181 + t182;
        let t184 = t113 * t177;
        let t185 = t184 * two;
        let t186 = t171 * t172 - t175 * t180
            - (t183 + (t114 * t173 + t115 * t174)) * t185;
        let t187 = q_i[4] * two;
        let t188 = t154 * t187;
        let t189 = t148 * t152;
        let t190 = t149 * t151;
        let t191 = t188 + (t189 - t190);
        let t192 = t121 * t159;
        let t193 = lambda[2] * (t120 * t158 - t107 * t192);
        let t194 = t163 * (t109 * t122 + t47 * t110);
        let t195 = lambda[1] * (t122 * t162 - t109 * t194);
        let t196 = lambda[2] * (t119 * t158 - t99 * t192);
        let t197 = t94 * t193 + (t9 * t195 - t104 * t196);
        let t198 = t87 * k8;
        let t199 = t98 * t193 + (t13 * t195 - t106 * t196);
        let t200 = t86 * k8;
        let t201 = t96 * t193 + (t11 * t195 - t105 * t196);
        let t202 = t88 * k8;
        let t203 = t113 * (lambda[1] * (t47 * t162 - t110 * t194))
            - t178 * (t122 * t176);
        let t204 = t203 * k8;
        let t205 = t107 * (q_i[4] * t104 + (q_i[3] * t106 - q_i[6] * t105));
        let t206 = t99 * (q_i[4] * t94 + (q_i[3] * t98 - q_i[6] * t96));
        let t207 = t205 + t206;
        let t208 = t119 * two;
        let t209 = t120 * two;
        let t210 = t201 * t202 - t175 * t204
            - t185 * (t207 + (t173 * t208 + t174 * t209));
        let t211 = t151 * t155;
        let t212 = t152 * t154;
        let t213 = t148 * t187;
        let t214 = t211 + (t212 - t213);
        let t215 = t125 * t159;
        let t216 = lambda[2] * (t124 * t158 - t107 * t215);
        let t217 = t163 * (t109 * t126 + t52 * t110);
        let t218 = lambda[1] * (t126 * t162 - t109 * t217);
        let t219 = lambda[2] * (t123 * t158 - t99 * t215);
        let t220 = t94 * t216 + (t9 * t218 - t104 * t219);
        let t221 = t98 * t216 + (t13 * t218 - t106 * t219);
        let t222 = t96 * t216 + (t11 * t218 - t105 * t219);
        let t223 = t113 * (lambda[1] * (t52 * t162 - t110 * t217))
            - t178 * (t126 * t176);
        let t224 = t223 * k8;
        let t225 = t107 * (q_i[5] * t105 + (q_i[3] * t104 - q_i[4] * t106));
        let t226 = t99 * (q_i[5] * t96 + (q_i[3] * t94 - q_i[4] * t98));
        let t227 = t225 + t226;
        let t228 = t123 * two;
        let t229 = t124 * two;
        let t230 = t202 * t222 - t175 * t224
            - t185 * (t227 + (t173 * t228 + t174 * t229));
        let t231 = t24 * lambda[0];
        let t232 = t9 * t231;
        let t233 = t155 * t232;
        let t234 = t13 * t231;
        let t235 = t149 * t234;
        let t236 = t11 * t231;
        let t237 = t152 * t236;
        let t238 = t233 - t235 - t237;
        let t239 = t23 * half;
        let t240 = t38 * t239;
        let t241 = t23 * t23;
        let t242 = t22 * t38 * t241;
        let t243 = lambda[0] * (t240 - t22 * t242);
        let t244 = t9 * t243;
        let t245 = t2 * k4;
        let t246 = t13 * t243;
        let t247 = t1 * k4;
        let t248 = t11 * t243;
        let t249 = t3 * k4;
        let t250 = lambda[0] * (t14 * t242);
        let t251 = t9 * t250;
        let t252 = t251 * k4;
        let t253 = t11 * t250;
        let t254 = t253 * k4;
        let t255 = t13 * t250;
        let t256 = t255 * k4;
        let t257 = t248 * t249 + (t17 * t252 + (t18 * t254 + t16 * t256));
        let t258 = t149 * t236;
        let t259 = t187 * t232;
        let t260 = t152 * t234;
        let t261 = t258 + (-t259 - t260);
        let t262 = t47 * t239;
        let t263 = t241 * (t22 * t47);
        let t264 = lambda[0] * (t262 - t22 * t263);
        let t265 = t9 * t264;
        let t266 = t2 * k8;
        let t267 = t13 * t264;
        let t268 = t1 * k8;
        let t269 = t11 * t264;
        let t270 = t3 * k8;
        let t271 = lambda[0] * (t14 * t263);
        let t272 = t9 * t271;
        let t273 = t17 * k8;
        let t274 = t11 * t271;
        let t275 = t18 * k8;
        let t276 = t13 * t271;
        let t277 = t16 * k8;
        let t278 = t269 * t270 + (t272 * t273 + (t274 * t275 + t276 * t277));
        let t279 = t187 * t234;
        let t280 = t155 * t236;
        let t281 = t152 * t232;
        let t282 = t279 + (-t280 - t281);
        let t283 = t52 * t239;
        let t284 = t241 * (t22 * t52);
        let t285 = lambda[0] * (t283 - t22 * t284);
        let t286 = t9 * t285;
        let t287 = t13 * t285;
        let t288 = t11 * t285;
        let t289 = lambda[0] * (t14 * t284);
        let t290 = t9 * t289;
        let t291 = t11 * t289;
        let t292 = t13 * t289;
        let t293 = t270 * t288 + (t273 * t290 + (t275 * t291 + t277 * t292));
        let t294 = t53 * lambda[0];
        let t295 = t13 * t294;
        let t296 = t149 * t295;
        let t297 = t11 * t294;
        let t298 = t152 * t297;
        let t299 = t9 * t294;
        let t300 = t155 * t299;
        let t301 = t296 + (t298 - t300);
        let t302 = lambda[0] * (t240 - t14 * (t241 * (t14 * t38)));
        let t303 = t11 * t302;
        let t304 = t18 * k4;
        let t305 = t13 * t302;
        let t306 = t16 * k4;
        let t307 = t9 * t302;
        let t308 = t17 * k4;
        let t309 = t301 - t303 * t304 - t305 * t306 - t307 * t308 - t3 * t254;
        let t310 = t187 * t299;
        let t311 = t152 * t295;
        let t312 = t149 * t297;
        let t313 = t310 + (t311 - t312);
        let t314 = lambda[0] * (t262 - t14 * (t241 * (t14 * t47)));
        let t315 = t11 * t314;
        let t316 = t13 * t314;
        let t317 = t9 * t314;
        let t318 = t313 - t275 * t315 - t277 * t316 - t273 * t317 - t274 * t270;
        let t319 = t155 * t297;
        let t320 = t152 * t299;
        let t321 = t187 * t295;
        let t322 = t319 + (t320 - t321);
        let t323 = lambda[0] * (t283 - t14 * (t241 * (t14 * t52)));
        let t324 = t11 * t323;
        let t325 = t13 * t323;
        let t326 = t9 * t323;
        let t327 = t322 - t275 * t324 - t277 * t325 - t273 * t326 - t270 * t291;
        let t328 = t163 * (t109 * t129);
        let t329 = (t178 * (t129 * t176) + t113 * (lambda[1] * (t110 * t328))) * k4;
        let t330 = lambda[1] * (t129 * t162 - t109 * t328);
        let t331 = t128 * t159;
        let t332 = lambda[2] * (t107 * t331);
        let t333 = t127 * t158;
        let t334 = lambda[2] * (t333 - t99 * t331);
        let t335 = t65 * t145 + (t9 * t330 - t94 * t332 - t104 * t334);
        let t336 = t61 * t145 + (t13 * t330 - t98 * t332 - t106 * t334);
        let t337 = t145 * half;
        let t338 = t11 * t330 + (t58 * t337 - t96 * t332 - t105 * t334);
        let t339 = t58 * t88 + (t62 * t86 + t66 * t87);
        let t340 = t170 * t336 + (t172 * t338 - t185 * (t99 * t339 + t127 * t173));
        let t341 = t163 * (t109 * t132);
        let t342 = (t178 * (t132 * t176) + t113 * (lambda[1] * (t110 * t341))) * k8;
        let t343 = lambda[1] * (t132 * t162 - t109 * t341);
        let t344 = t131 * t159;
        let t345 = lambda[2] * (t107 * t344);
        let t346 = t130 * t158;
        let t347 = lambda[2] * (t346 - t99 * t344);
        let t348 = t9 * t343 + (t71 * t337 - t94 * t345 - t104 * t347);
        let t349 = t74 * k1_over_4;
        let t350 = t13 * t343 + (t145 * t349 - t98 * t345 - t106 * t347);
        let t351 = t11 * t343 + (t76 * t337 - t96 * t345 - t105 * t347);
        let t352 = t71 * t87 + (t75 * t86 + t76 * t88);
        let t353 = t184 * k4;
        let t354 = t200 * t350 + (t202 * t351 - (t99 * t352 + t130 * t173) * t353);
        let t355 = t163 * (t109 * t135);
        let t356 = (t178 * (t135 * t176) + t113 * (lambda[1] * (t110 * t355))) * k8;
        let t357 = lambda[1] * (t135 * t162 - t109 * t355);
        let t358 = t80 * k1_over_4;
        let t359 = t134 * t159;
        let t360 = lambda[2] * (t107 * t359);
        let t361 = t133 * t158;
        let t362 = lambda[2] * (t361 - t99 * t359);
        let t363 = t9 * t357 + (t145 * t358 - t94 * t360 - t104 * t362);
        let t364 = t13 * t357 + (t79 * t337 - t98 * t360 - t106 * t362);
        let t365 = t11 * t357 + (t82 * t337 - t96 * t360 - t105 * t362);
        let t366 = t79 * t86 + (t81 * t87 + t82 * t88);
        let t367 = t200 * t364 + (t202 * t365 - t353 * (t99 * t366 + t133 * t173));
        let t368 = t163 * (t109 * t137);
        let t369 = (t178 * (t137 * t176) + t113 * (lambda[1] * (t110 * t368))) * k4;
        let t370 = lambda[2] * (t333 - t107 * (t136 * t159));
        let t371 = lambda[1] * (t137 * t162 - t109 * t368);
        let t372 = t104 * t332 + (t94 * t370 + (t9 * t371 - t65 * t147));
        let t373 = t106 * t332 + (t98 * t370 + (t13 * t371 - t61 * t147));
        let t374 = t147 * half;
        let t375 = t105 * t332 + (t96 * t370 + (t11 * t371 - t58 * t374));
        let t376 = t170 * t373 + (t172 * t375 - t185 * (t107 * t339 + t127 * t174));
        let t377 = t163 * (t109 * t139);
        let t378 = (t178 * (t139 * t176) + t113 * (lambda[1] * (t110 * t377))) * k8;
        let t379 = lambda[2] * (t346 - t107 * (t138 * t159));
        let t380 = lambda[1] * (t139 * t162 - t109 * t377);
        let t381 = t104 * t345 + (t94 * t379 + (t9 * t380 - t71 * t374));
        let t382 = t147 * k1_over_4;
        let t383 = t106 * t345 + (t98 * t379 + (t13 * t380 - t74 * t382));
        let t384 = t105 * t345 + (t96 * t379 + (t11 * t380 - t76 * t374));
        let t385 = t200 * t383 + (t202 * t384 - t353 * (t107 * t352 + t130 * t174));
        let t386 = t163 * (t109 * t141);
        let t387 = (t178 * (t141 * t176) + t113 * (lambda[1] * (t110 * t386))) * k8;
        let t388 = lambda[2] * (t361 - t107 * (t140 * t159));
        let t389 = lambda[1] * (t141 * t162 - t109 * t386);
        let t390 = t104 * t360 + (t94 * t388 + (t9 * t389 - t80 * t382));
        let t391 = t106 * t360 + (t98 * t388 + (t13 * t389 - t79 * t374));
        let t392 = t105 * t360 + (t96 * t388 + (t11 * t389 - t82 * t374));
        let t393 = t200 * t391 + (t202 * t392 - t353 * (t107 * t366 + t133 * t174));
        let t394 = t241 * (t22 * t68 + t14 * t67);
        let t395 = lambda[0] * (t68 * t239 - t22 * t394);
        let t396 = t9 * t395 + t65 * t294;
        let t397 = t13 * t395 + t61 * t294;
        let t398 = t58 * half;
        let t399 = t294 * t398 + t11 * t395;
        let t400 = t163 * (t110 * t127);
        let t401 = lambda[1] * (t109 * t400);
        let t402 = t65 * t146 - t9 * t401;
        let t403 = t61 * t146 - t13 * t401;
        let t404 = t146 * half;
        let t405 = t58 * t404 - t11 * t401;
        let t406 = lambda[0] * (t67 * t239 - t14 * t394);
        let t407 = t231 * t398 + t11 * t406;
        let t408 = t13 * t406 + t61 * t231;
        let t409 = t9 * t406 + t65 * t231;
        let t410 = t172 * t405 - t304 * t407 - t306 * t408 - t308 * t409;
        let t411 = t113 * (lambda[1] * (t127 * t162 - t110 * t400)) * k4;
        let t412 = t249 * t399 + (t168 * t402 + (t170 * t403 + (t410 - t175 * t411)));
        let t413 = t294 * half;
        let t414 = t241 * (t22 * t78 + t14 * t77);
        let t415 = lambda[0] * (t78 * t239 - t22 * t414);
        let t416 = t71 * t413 + t9 * t415;
        let t417 = t294 * t349 + t13 * t415;
        let t418 = t76 * t413 + t11 * t415;
        let t419 = t163 * (t110 * t130);
        let t420 = lambda[1] * (t109 * t419);
        let t421 = t71 * t404 - t9 * t420;
        let t422 = t146 * t349 - t13 * t420;
        let t423 = t76 * t404 - t11 * t420;
        let t424 = t231 * half;
        let t425 = lambda[0] * (t77 * t239 - t14 * t414);
        let t426 = t76 * t424 + t11 * t425;
        let t427 = t231 * t349 + t13 * t425;
        let t428 = t71 * t424 + t9 * t425;
        let t429 = t202 * t423 - t275 * t426 - t277 * t427 - t273 * t428;
        let t430 = t113 * (lambda[1] * (t130 * t162 - t110 * t419)) * k8;
        let t431 = t270 * t418 + (t198 * t421 + (t200 * t422 + (t429 - t175 * t430)));
        let t432 = t241 * (t22 * t84 + t14 * t83);
        let t433 = lambda[0] * (t84 * t239 - t22 * t432);
        let t434 = t294 * t358 + t9 * t433;
        let t435 = t79 * t413 + t13 * t433;
        let t436 = t82 * t413 + t11 * t433;
        let t437 = t163 * (t110 * t133);
        let t438 = lambda[1] * (t109 * t437);
        let t439 = t146 * t358 - t9 * t438;
        let t440 = t79 * t404 - t13 * t438;
        let t441 = t82 * t404 - t11 * t438;
        let t442 = lambda[0] * (t83 * t239 - t14 * t432);
        let t443 = t82 * t424 + t11 * t442;
        let t444 = t79 * t424 + t13 * t442;
        let t445 = t231 * t358 + t9 * t442;
        let t446 = t202 * t441 - t275 * t443 - t277 * t444 - t273 * t445;
        let t447 = t113 * (lambda[1] * (t133 * t162 - t110 * t437)) * k8;
        let t448 = t270 * t436 + (t198 * t439 + (t200 * t440 + (t446 - t175 * t447)));
        let t449 = t149 * t154 + (t148 * t155 + t151 * t187);
        let t450 = t85 * k4;
        let t451 = t86 * t94 + (t85 * t96 - t87 * t98);
        let t452 = t86 * t104 + (t85 * t105 - t87 * t106);
        let t453 = t99 * t451 + t107 * t452;
        let t454 = t107 * (q_i[6] * t104 + (q_i[4] * t105 + q_i[5] * t106))
            + t99 * (q_i[6] * t94 + (q_i[4] * t96 + q_i[5] * t98));
        let t455 = t171 * t450 - t169 * t168 - t180 * t453
            - t185 * (t454 + (t114 * t451 + t115 * t452));
        let t456 = t85 * k8;
        let t457 = t214 - t199 * t198 - t204 * t453
            - t185 * (t209 * t452 + (t227 + t208 * t451));
        let t458 = t190 - t198 * t221 - t224 * t453 - t189 - t188
            - t185 * (t229 * t452 + (t228 * t451 - t206 - t205));
        let t459 = -(t155 * t234) - t187 * t236 - t149 * t232;
        let t460 = t0 * k4;
        let t461 = t16 * t252 + (t15 * t254 - t255 * t308 - t246 * t245);
        let t462 = t0 * k8;
        let t463 = t15 * k8;
        let t464 = t277 * t272 + (t274 * t463 + (t282 - t276 * t273 - t267 * t266));
        let t465 = t291 * t463 + (t259 + (t260 - t273 * t292 - t266 * t287 - t258));
        let t466 = t149 * t299 + (t155 * t295 + t187 * t297);
        let t467 = t15 * k4;
        let t468 = t305 * t308 - t303 * t467 - t306 * t307 - t0 * t254;
        let t469 = t322 - t315 * t463 - t277 * t317 - t274 * t462 - t272 * t268;
        let t470 = t312 - t324 * t463 - t277 * t326 - t291 * t462 - t268 * t290;
        let t471 = t58 * t85 + (t66 * t86 - t61 * t87 * two);
        let t472 = t338 * t450 - t168 * t336 - t185 * (t99 * t471 + t127 * t451);
        let t473 = t71 * t86 + (t76 * t85 - t74 * t87 * half);
        let t474 = t351 * t456 - t198 * t350 - t353 * (t99 * t473 + t130 * t451);
        let t475 = t82 * t85 + (t81 * t86 - t79 * t87);
        let t476 = t365 * t456 - t198 * t364 - t353 * (t99 * t475 + t133 * t451);
        let t477 = t375 * t450 - t168 * t373 - t185 * (t107 * t471 + t127 * t452);
        let t478 = t384 * t456 - t198 * t383 - t353 * (t107 * t473 + t130 * t452);
        let t479 = t392 * t456 - t198 * t391 - t353 * (t107 * t475 + t133 * t452);
        let t480 = t405 * t450 - t168 * t403 - t407 * t467 - t306 * t409;
        let t481 = t308 * t408 + (t170 * t402 + (t480 - t245 * t397 - t411 * t453));
        let t482 = t423 * t456 - t198 * t422 - t426 * t463 - t277 * t428;
        let t483 = t273 * t427 + (t200 * t421 + (t482 - t266 * t417 - t430 * t453));
        let t484 = t441 * t456 - t198 * t440 - t443 * t463 - t277 * t445;
        let t485 = t273 * t444 + (t200 * t439 + (t484 - t266 * t435 - t447 * t453));
        let t486 = t87 * t96 + (t85 * t98 - t88 * t94);
        let t487 = t87 * t105 + (t85 * t106 - t88 * t104);
        let t488 = t99 * t486 + t107 * t487;
        let t489 = t213 - t172 * t167 - t180 * t488 - t212 - t211
            - t185 * (t115 * t487 + (t114 * t486 - t226 - t225));
        let t490 = t449 - t202 * t197 - t204 * t488
            - t185 * (t209 * t487 + (t454 + t208 * t486));
        let t491 = t157 - t202 * t220 - t224 * t488
            - t185 * (t229 * t487 + (t183 + t228 * t486));
        let t492 = t15 * t256 + (t280 + (t281 - t251 * t304 - t249 * t244 - t279));
        let t493 = t274 * t273 + (t276 * t463 + (t459 - t275 * t272 - t270 * t265));
        let t494 = t273 * t291 + (t292 * t463 + (t238 - t275 * t290 - t270 * t286));
        let t495 = t321 - t305 * t467 - t303 * t308 - t0 * t256 - t2 * t254;
        let t496 = t466 - t316 * t463 - t273 * t315 - t276 * t462 - t274 * t266;
        let t497 = t301 - t325 * t463 - t273 * t324 - t292 * t462 - t266 * t291;
        let t498 = t127 * half;
        let t499 = t61 * t85 + (t87 * t398 - t65 * t88);
        let t500 = t336 * t450 - t172 * t335 - t353 * (t486 * t498 + t99 * t499);
        let t501 = t130 * two;
        let t502 = t74 * t85 + (t76 * t87 * two - t71 * t88 * two);
        let t503 = t350 * t456 - t202 * t348 - t185 * (t486 * t501 + t99 * t502);
        let t504 = t82 * t87 + (t79 * t85 - t80 * t88 * half);
        let t505 = t364 * t456 - t202 * t363 - t353 * (t99 * t504 + t133 * t486);
        let t506 = t373 * t450 - t172 * t372 - t353 * (t487 * t498 + t107 * t499);
        let t507 = t383 * t456 - t202 * t381 - t185 * (t487 * t501 + t107 * t502);
        let t508 = t391 * t456 - t202 * t390 - t353 * (t107 * t504 + t133 * t487);
        let t509 = t403 * t450 - t172 * t402 - t408 * t467 - t308 * t407;
        let t510 = t304 * t409 + (t168 * t405 + (t509 - t249 * t396 - t411 * t488));
        let t511 = t422 * t456 - t202 * t421 - t427 * t463 - t273 * t426;
        let t512 = t275 * t428 + (t198 * t423 + (t511 - t270 * t416 - t430 * t488));
        let t513 = t440 * t456 - t202 * t439 - t444 * t463 - t273 * t443;
        let t514 = t275 * t445 + (t198 * t441 + (t513 - t270 * t434 - t447 * t488));
        let t515 = t88 * t98 + (t85 * t94 - t86 * t96);
        let t516 = t88 * t106 + (t85 * t104 - t86 * t105);
        let t517 = t99 * t515 + t107 * t516;
        let t518 = t191 - t171 * t170 - t180 * t517
            - t185 * (t115 * t516 + (t207 + t114 * t515));
        let t519 = t156 - t201 * t200 - t204 * t517 - t153 - t150
            - t185 * (t209 * t516 + (t208 * t515 - t182 - t181));
        let t520 = t449 - t200 * t222 - t224 * t517
            - t185 * (t229 * t516 + (t454 + t228 * t515));
        let t521 = t18 * t256 + (t15 * t252 + (t261 - t253 * t306 - t248 * t247));
        let t522 = t272 * t463 + (t235 + (t237 - t274 * t277 - t269 * t268 - t233));
        let t523 = t275 * t292 + (t290 * t463 + (t459 - t277 * t291 - t268 * t288));
        let t524 = t313 - t307 * t467 - t304 * t305 - t0 * t252 - t3 * t256;
        let t525 = t300 - t317 * t463 - t275 * t316 - t272 * t462 - t276 * t270;
        let t526 = t466 - t326 * t463 - t275 * t325 - t290 * t462 - t270 * t292;
        let t527 = t61 * t88 + (t65 * t85 - t58 * t86 * half);
        let t528 = t335 * t450 - t170 * t338 - t353 * (t498 * t515 + t99 * t527);
        let t529 = t71 * t85 + (t75 * t88 - t76 * t86);
        let t530 = t348 * t456 - t200 * t351 - t353 * (t99 * t529 + t130 * t515);
        let t531 = t133 * two;
        let t532 = t80 * t85 + (t79 * t88 * two - t82 * t86 * two);
        let t533 = t363 * t456 - t200 * t365 - t185 * (t515 * t531 + t99 * t532);
        let t534 = t372 * t450 - t170 * t375 - t353 * (t498 * t516 + t107 * t527);
        let t535 = t381 * t456 - t200 * t384 - t353 * (t107 * t529 + t130 * t516);
        let t536 = t390 * t456 - t200 * t392 - t185 * (t516 * t531 + t107 * t532);
        let t537 = t402 * t450 - t170 * t405 - t409 * t467 - t304 * t408;
        let t538 = t306 * t407 + (t172 * t403 + (t537 - t247 * t399 - t411 * t517));
        let t539 = t421 * t456 - t200 * t423 - t428 * t463 - t275 * t427;
        let t540 = t277 * t426 + (t202 * t422 + (t539 - t268 * t418 - t430 * t517));
        let t541 = t439 * t456 - t200 * t441 - t445 * t463 - t275 * t444;
        let t542 = t277 * t443 + (t202 * t440 + (t541 - t268 * t436 - t447 * t517));
        let t543 = t89 * t161 + t36 * t145;
        let t544 = t92 * k4;
        let t545 = t97 * t161 + t32 * t145;
        let t546 = t91 * k4;
        let t547 = t29 * t337 + t95 * t161;
        let t548 = t93 * k4;
        let t549 = t89 * t165 + t36 * t146;
        let t550 = t7 * k4;
        let t551 = t97 * t165 + t32 * t146;
        let t552 = t6 * k4;
        let t553 = t29 * t404 + t95 * t165;
        let t554 = t8 * k4;
        let t555 = t29 * half;
        let t556 = t147 * t555 + t95 * t166;
        let t557 = t103 * k4;
        let t558 = t97 * t166 + t32 * t147;
        let t559 = t101 * k4;
        let t560 = t89 * t166 + t36 * t147;
        let t561 = t102 * k4;
        let t562 = t553 * t554 - t556 * t557 - t558 * t559 - t560 * t561;
        let t563 = t92 * t89 + (t95 * t93 + t91 * t97);
        let t564 = t89 * t102 + (t95 * t103 + t97 * t101);
        let t565 = t99 * t563 + t107 * t564;
        let t566 = t99 * (t29 * t93 + (t33 * t91 + t37 * t92))
            + t107 * (t29 * t103 + (t33 * t101 + t37 * t102));
        let t567 = t562 - t180 * t565 - t185 * (t115 * t564 + (t114 * t563 + t566));
        let t568 = t545 * t546 + (t547 * t548 + (t549 * t550 + (t551 * t552 + t567)));
        let t569 = t41 * t337 + t89 * t193;
        let t570 = t92 * k8;
        let t571 = t145 * k1_over_4;
        let t572 = t44 * t571 + t97 * t193;
        let t573 = t91 * k8;
        let t574 = t46 * t337 + t95 * t193;
        let t575 = t93 * k8;
        let t576 = t41 * t404 + t89 * t195;
        let t577 = t7 * k8;
        let t578 = t146 * k1_over_4;
        let t579 = t44 * t578 + t97 * t195;
        let t580 = t6 * k8;
        let t581 = t46 * t404 + t95 * t195;
        let t582 = t8 * k8;
        let t583 = t46 * t374 + t95 * t196;
        let t584 = t103 * k8;
        let t585 = t44 * t382 + t97 * t196;
        let t586 = t101 * k8;
        let t587 = t41 * t374 + t89 * t196;
        let t588 = t102 * k8;
        let t589 = t581 * t582 - t583 * t584 - t585 * t586 - t587 * t588;
        let t590 = t99 * (t41 * t92 + (t45 * t91 + t46 * t93))
            + t107 * (t41 * t102 + (t45 * t101 + t46 * t103));
        let t591 = t589 - t204 * t565 - t353 * (t120 * t564 + (t119 * t563 + t590));
        let t592 = t572 * t573 + (t574 * t575 + (t576 * t577 + (t579 * t580 + t591)));
        let t593 = t49 * t571 + t89 * t216;
        let t594 = t48 * t337 + t97 * t216;
        let t595 = t51 * t337 + t95 * t216;
        let t596 = t49 * t578 + t89 * t218;
        let t597 = t48 * t404 + t97 * t218;
        let t598 = t51 * t404 + t95 * t218;
        let t599 = t51 * t374 + t95 * t219;
        let t600 = t48 * t374 + t97 * t219;
        let t601 = t49 * t382 + t89 * t219;
        let t602 = t582 * t598 - t584 * t599 - t586 * t600 - t588 * t601;
        let t603 = t99 * (t48 * t91 + (t50 * t92 + t51 * t93))
            + t107 * (t48 * t101 + (t50 * t102 + t51 * t103));
        let t604 = t602 - t224 * t565 - t353 * (t124 * t564 + (t123 * t563 + t603));
        let t605 = t573 * t594 + (t575 * t595 + (t577 * t596 + (t580 * t597 + t604)));
        let t606 = t4 * t243 + (t19 * t250 - t36 * t231);
        let t607 = t10 * t243 + (t20 * t250 - t29 * t424);
        let t608 = t12 * t243 + (t21 * t250 - t32 * t231);
        let t609 = t4 * t264 + (t19 * t271 - t41 * t424);
        let t610 = t10 * t264 + (t20 * t271 - t46 * t424);
        let t611 = t44 * k1_over_4;
        let t612 = t12 * t264 + (t21 * t271 - t231 * t611);
        let t613 = t49 * k1_over_4;
        let t614 = t4 * t285 + (t19 * t289 - t231 * t613);
        let t615 = t10 * t285 + (t20 * t289 - t51 * t424);
        let t616 = t12 * t285 + (t21 * t289 - t48 * t424);
        let t617 = t10 * t250 + (t20 * t302 - t29 * t413);
        let t618 = t12 * t250 + (t21 * t302 - t32 * t294);
        let t619 = t4 * t250 + (t19 * t302 - t36 * t294);
        let t620 = t10 * t271 + (t20 * t314 - t46 * t413);
        let t621 = t12 * t271 + (t21 * t314 - t294 * t611);
        let t622 = t4 * t271 + (t19 * t314 - t41 * t413);
        let t623 = t10 * t289 + (t20 * t323 - t51 * t413);
        let t624 = t12 * t289 + (t21 * t323 - t48 * t413);
        let t625 = t4 * t289 + (t19 * t323 - t294 * t613);
        let t626 = t97 * t145;
        let t627 = q_j[6] * two;
        let t628 = t626 * t627;
        let t629 = t95 * t145;
        let t630 = q_j[3] * two;
        let t631 = t629 * t630;
        let t632 = t89 * t145;
        let t633 = q_j[5] * two;
        let t634 = t632 * t633;
        let t635 = t628 + (t631 - t634);
        let t636 = t89 * t330;
        let t637 = t97 * t330;
        let t638 = t95 * t330;
        let t639 = t95 * t332;
        let t640 = t639 * k4;
        let t641 = t97 * t332;
        let t642 = t641 * k4;
        let t643 = t89 * t332;
        let t644 = t643 * k4;
        let t645 = t554 * t638 - t93 * t640 - t91 * t642 - t92 * t644;
        let t646 = t95 * t334;
        let t647 = t97 * t334;
        let t648 = t89 * t334;
        let t649 = q_j[6] * t97 + (q_j[3] * t95 - q_j[5] * t89);
        let t650 = t99 * t649;
        let t651 = t645 - t557 * t646 - t559 * t647 - t561 * t648
            - t185 * (t127 * t563 + t650);
        let t652 = q_j[4] * two;
        let t653 = t632 * t652;
        let t654 = t626 * t630;
        let t655 = t627 * t629;
        let t656 = t653 + (t654 - t655);
        let t657 = t89 * t343;
        let t658 = t97 * t343;
        let t659 = t95 * t343;
        let t660 = t95 * t345;
        let t661 = t97 * t345;
        let t662 = t89 * t345;
        let t663 = t582 * t659 - t575 * t660 - t573 * t661 - t570 * t662;
        let t664 = t95 * t347;
        let t665 = t97 * t347;
        let t666 = t89 * t347;
        let t667 = q_j[4] * t89 + (q_j[3] * t97 - q_j[6] * t95);
        let t668 = t99 * t667;
        let t669 = t663 - t584 * t664 - t586 * t665 - t588 * t666
            - t185 * (t501 * t563 + t668);
        let t670 = t629 * t633;
        let t671 = t630 * t632;
        let t672 = t626 * t652;
        let t673 = t670 + (t671 - t672);
        let t674 = t89 * t357;
        let t675 = t97 * t357;
        let t676 = t95 * t357;
        let t677 = t95 * t360;
        let t678 = t97 * t360;
        let t679 = t89 * t360;
        let t680 = t582 * t676 - t575 * t677 - t573 * t678 - t570 * t679;
        let t681 = t95 * t362;
        let t682 = t97 * t362;
        let t683 = t89 * t362;
        let t684 = q_j[5] * t95 + (q_j[3] * t89 - q_j[4] * t97);
        let t685 = t99 * t684;
        let t686 = t680 - t584 * t681 - t586 * t682 - t588 * t683
            - t185 * (t531 * t563 + t685);
        let t687 = t89 * t147;
        let t688 = t633 * t687;
        let t689 = t97 * t147;
        let t690 = t627 * t689;
        let t691 = t95 * t147;
        let t692 = t630 * t691;
        let t693 = t688 + (-t690 - t692);
        let t694 = t89 * t370;
        let t695 = t97 * t370;
        let t696 = t95 * t370;
        let t697 = t89 * t371;
        let t698 = t97 * t371;
        let t699 = t95 * t371;
        let t700 = t107 * t649;
        let t701 = t552 * t698 + (t554 * t699 - t185 * (t127 * t564 + t700));
        let t702 = t544 * t694 + (t546 * t695 + (t548 * t696 + (t550 * t697 + t701)));
        let t703 = t369 * t565 + (t102 * t644 + (t101 * t642 + (t103 * t640 + t702)));
        let t704 = t627 * t691;
        let t705 = t652 * t687;
        let t706 = t630 * t689;
        let t707 = t704 + (-t705 - t706);
        let t708 = t89 * t379;
        let t709 = t97 * t379;
        let t710 = t95 * t379;
        let t711 = t89 * t380;
        let t712 = t97 * t380;
        let t713 = t95 * t380;
        let t714 = t107 * t667;
        let t715 = t580 * t712 + (t582 * t713 - t185 * (t501 * t564 + t714));
        let t716 = t570 * t708 + (t573 * t709 + (t575 * t710 + (t577 * t711 + t715)));
        let t717 = t378 * t565 + (t588 * t662 + (t586 * t661 + (t584 * t660 + t716)));
        let t718 = t652 * t689;
        let t719 = t633 * t691;
        let t720 = t630 * t687;
        let t721 = t718 + (-t719 - t720);
        let t722 = t89 * t388;
        let t723 = t97 * t388;
        let t724 = t95 * t388;
        let t725 = t89 * t389;
        let t726 = t97 * t389;
        let t727 = t95 * t389;
        let t728 = t107 * t684;
        let t729 = t580 * t726 + (t582 * t727 - t185 * (t531 * t564 + t728));
        let t730 = t570 * t722 + (t573 * t723 + (t575 * t724 + (t577 * t725 + t729)));
        let t731 = t387 * t565 + (t588 * t679 + (t586 * t678 + (t584 * t677 + t730)));
        let t732 = t12 * t294 + (t97 * t146 - t21 * t231);
        let t733 = t627 * t732;
        let t734 = t10 * t294 + (t95 * t146 - t20 * t231);
        let t735 = t630 * t734;
        let t736 = t4 * t294 + (t89 * t146 - t19 * t231);
        let t737 = t633 * t736;
        let t738 = t733 + (t735 - t737);
        let t739 = t20 * t406 + (t95 * t401 - t10 * t395);
        let t740 = t21 * t406 + (t97 * t401 - t12 * t395);
        let t741 = t19 * t406 + (t89 * t401 - t4 * t395);
        let t742 = t652 * t736;
        let t743 = t630 * t732;
        let t744 = t627 * t734;
        let t745 = t742 + (t743 - t744);
        let t746 = t20 * t425 + (t95 * t420 - t10 * t415);
        let t747 = t21 * t425 + (t97 * t420 - t12 * t415);
        let t748 = t19 * t425 + (t89 * t420 - t4 * t415);
        let t749 = t633 * t734;
        let t750 = t630 * t736;
        let t751 = t652 * t732;
        let t752 = t749 + (t750 - t751);
        let t753 = t20 * t442 + (t95 * t438 - t10 * t433);
        let t754 = t21 * t442 + (t97 * t438 - t12 * t433);
        let t755 = t19 * t442 + (t89 * t438 - t4 * t433);
        let t756 = t90 * k4;
        let t757 = t5 * k4;
        let t758 = t100 * k4;
        let t759 = t553 * t757 - t551 * t550 - t545 * t544 - t556 * t758;
        let t760 = t91 * t89 + (t95 * t90 - t92 * t97);
        let t761 = t89 * t101 + (t95 * t100 - t97 * t102);
        let t762 = t99 * t760 + t107 * t761;
        let t763 = t99 * (t29 * t90 + (t37 * t91 - t33 * t92))
            + t107 * (t29 * t100 + (t37 * t101 - t33 * t102));
        let t764 = t759 - t559 * t560 - t180 * t762
            - t185 * (t115 * t761 + (t114 * t760 + t763));
        let t765 = t90 * k8;
        let t766 = t5 * k8;
        let t767 = t100 * k8;
        let t768 = t581 * t766 - t579 * t577 - t572 * t570 - t583 * t767;
        let t769 = t99 * (t41 * t91 + (t46 * t90 - t45 * t92))
            + t107 * (t41 * t101 + (t46 * t100 - t45 * t102));
        let t770 = t768 - t586 * t587 - t204 * t762
            - t353 * (t120 * t761 + (t119 * t760 + t769));
        let t771 = t598 * t766 - t577 * t597 - t570 * t594 - t599 * t767;
        let t772 = t99 * (t51 * t90 + (t50 * t91 - t48 * t92))
            + t107 * (t51 * t100 + (t50 * t101 - t48 * t102));
        let t773 = t771 - t586 * t601 - t224 * t762
            - t353 * (t124 * t761 + (t123 * t760 + t772));
        let t774 = t627 * t632 + (t626 * t633 + t629 * t652);
        let t775 = t638 * t757 - t550 * t637 - t90 * t640 - t91 * t644;
        let t776 = q_j[6] * t89 + (q_j[4] * t95 + q_j[5] * t97);
        let t777 = t99 * t776;
        let t778 = t775 - t646 * t758 - t559 * t648 - t185 * (t127 * t760 + t777);
        let t779 = t329 * t762 + (t561 * t647 + (t544 * t641 + (t552 * t636 + t778)));
        let t780 = t673 - t577 * t658 - t660 * t765 - t573 * t662 - t664 * t767;
        let t781 = t659 * t766 + (t780 - t586 * t666 - t185 * (t685 + t501 * t760));
        let t782 = t655 - t577 * t675 - t677 * t765 - t573 * t679 - t681 * t767;
        let t783 = t782 - t586 * t683 - t654 - t653 - t185 * (t531 * t760 - t668);
        let t784 = t588 * t682 + (t570 * t678 + (t580 * t674 + (t676 * t766 + t783)));
        let t785 = -(t633 * t689) - t652 * t691 - t627 * t687;
        let t786 = t699 * t757 - t550 * t698 - t544 * t695 - t561 * t641;
        let t787 = t107 * t776;
        let t788 = t696 * t756 + (t552 * t697 + (t786 - t185 * (t127 * t761 + t787)));
        let t789 = t369 * t762 + (t101 * t644 + (t100 * t640 + (t546 * t694 + t788)));
        let t790 = t721 - t577 * t712 - t570 * t709 - t588 * t661
            - t185 * (t728 + t501 * t761);
        let t791 = t573 * t708 + (t710 * t765 + (t580 * t711 + (t713 * t766 + t790)));
        let t792 = t706 - t577 * t726 - t570 * t723 - t588 * t678 - t704;
        let t793 = t727 * t766 + (t705 + (t792 - t185 * (t531 * t761 - t714)));
        let t794 = t677 * t767 + (t573 * t722 + (t724 * t765 + (t580 * t725 + t793)));
        let t795 = t627 * t736 + (t633 * t732 + t652 * t734);
        let t796 = t550 * t740 - t739 * t757 - t552 * t741 - t411 * t762;
        let t797 = t744 - t753 * t766 - t580 * t755 - t447 * t762 - t743;
        let t798 = t551 * t757 - t554 * t549 - t548 * t543 - t558 * t758;
        let t799 = t90 * t97 + (t95 * t92 - t93 * t89);
        let t800 = t97 * t100 + (t95 * t102 - t89 * t103);
        let t801 = t99 * t799 + t107 * t800;
        let t802 = t114 * half;
        let t803 = t115 * half;
        let t804 = t99 * (t32 * t90 + (t92 * t555 - t36 * t93))
            + (t799 * t802 + t800 * t803);
        let t805 = t107 * (t32 * t100 + (t102 * t555 - t36 * t103)) + t804;
        let t806 = t553 * t550 + (t798 - t556 * t561 - t180 * t801 - t353 * t805);
        let t807 = t579 * t766 - t582 * t576 - t575 * t569 - t585 * t767;
        let t808 = t46 * two;
        let t809 = t41 * two;
        let t810 = t99 * (t44 * t90 + (t92 * t808 - t93 * t809))
            + (t208 * t799 + t209 * t800);
        let t811 = t107 * (t44 * t100 + (t102 * t808 - t103 * t809)) + t810;
        let t812 = t581 * t577 + (t807 - t583 * t588 - t204 * t801 - t185 * t811);
        let t813 = t597 * t766 - t582 * t596 - t575 * t593 - t600 * t767;
        let t814 = t99 * (t51 * t92 + (t48 * t90 - t50 * t93))
            + t107 * (t51 * t102 + (t48 * t100 - t50 * t103));
        let t815 = t813 - t588 * t599 - t224 * t801
            - t353 * (t124 * t800 + (t123 * t799 + t814));
        let t816 = t672 - t554 * t636 - t90 * t642 - t92 * t640 - t647 * t758;
        let t817 = t816 - t561 * t646 - t671 - t670 - t185 * (t127 * t799 - t685);
        let t818 = t557 * t648 + (t548 * t643 + (t550 * t638 + (t637 * t757 + t817)));
        let t819 = t774 - t582 * t657 - t661 * t765 - t570 * t660 - t665 * t767;
        let t820 = t658 * t766 + (t819 - t588 * t664 - t185 * (t777 + t501 * t799));
        let t821 = t635 - t582 * t674 - t678 * t765 - t570 * t677 - t682 * t767;
        let t822 = t675 * t766 + (t821 - t588 * t681 - t185 * (t650 + t531 * t799));
        let t823 = t720 - t554 * t697 - t548 * t694 - t557 * t643 - t718;
        let t824 = t698 * t757 + (t719 + (t823 - t185 * (t127 * t800 - t728)));
        let t825 = t100 * t642 + (t544 * t696 + (t695 * t756 + (t550 * t699 + t824)));
        let t826 = t785 - t582 * t711 - t575 * t708 - t584 * t662
            - t185 * (t787 + t501 * t800);
        let t827 = t570 * t710 + (t709 * t765 + (t577 * t713 + (t712 * t766 + t826)));
        let t828 = t693 - t582 * t725 - t575 * t722 - t584 * t679
            - t185 * (t700 + t531 * t800);
        let t829 = t570 * t724 + (t723 * t765 + (t577 * t727 + (t726 * t766 + t828)));
        let t830 = t751 - t740 * t757 - t550 * t739 - t411 * t801 - t750;
        let t831 = t549 * t757 - t553 * t552 - t547 * t546 - t560 * t758;
        let t832 = t90 * t89 + (t93 * t97 - t95 * t91);
        let t833 = t89 * t100 + (t97 * t103 - t95 * t101);
        let t834 = t99 * t832 + t107 * t833;
        let t835 = t99 * (t32 * t93 + (t36 * t90 - t91 * t555))
            + (t802 * t832 + t803 * t833);
        let t836 = t107 * (t32 * t103 + (t36 * t100 - t101 * t555)) + t835;
        let t837 = t554 * t551 + (t831 - t557 * t558 - t180 * t834 - t353 * t836);
        let t838 = t576 * t766 - t581 * t580 - t574 * t573 - t587 * t767;
        let t839 = t99 * (t41 * t90 + (t45 * t93 - t46 * t91))
            + t107 * (t41 * t100 + (t45 * t103 - t46 * t101));
        let t840 = t838 - t584 * t585 - t204 * t834
            - t353 * (t120 * t833 + (t119 * t832 + t839));
        let t841 = t596 * t766 - t580 * t598 - t573 * t595 - t601 * t767;
        let t842 = t48 * two;
        let t843 = t51 * two;
        let t844 = t99 * (t49 * t90 + (t93 * t842 - t91 * t843))
            + (t228 * t832 + t229 * t833);
        let t845 = t107 * (t49 * t100 + (t103 * t842 - t101 * t843)) + t844;
        let t846 = t582 * t597 + (t841 - t584 * t600 - t224 * t834 - t185 * t845);
        let t847 = t656 - t552 * t638 - t90 * t644 - t93 * t642 - t648 * t758;
        let t848 = t636 * t757 + (t847 - t557 * t647 - t185 * (t668 + t127 * t832));
        let t849 = t634 - t580 * t659 - t662 * t765 - t575 * t661 - t666 * t767;
        let t850 = t849 - t584 * t665 - t631 - t628 - t185 * (t501 * t832 - t650);
        let t851 = t586 * t664 + (t573 * t660 + (t582 * t658 + (t657 * t766 + t850)));
        let t852 = t774 - t580 * t676 - t679 * t765 - t575 * t678 - t683 * t767;
        let t853 = t674 * t766 + (t852 - t584 * t682 - t185 * (t777 + t531 * t832));
        let t854 = t707 - t552 * t699 - t546 * t696 - t559 * t639
            - t185 * (t714 + t127 * t833);
        let t855 = t548 * t695 + (t694 * t756 + (t554 * t698 + (t697 * t757 + t854)));
        let t856 = t692 - t580 * t713 - t573 * t710 - t586 * t660 - t688;
        let t857 = t711 * t766 + (t690 + (t856 - t185 * (t501 * t833 - t700)));
        let t858 = t662 * t767 + (t575 * t709 + (t708 * t765 + (t582 * t712 + t857)));
        let t859 = t785 - t580 * t727 - t573 * t724 - t586 * t677
            - t185 * (t787 + t531 * t833);
        let t860 = t575 * t723 + (t722 * t765 + (t582 * t726 + (t725 * t766 + t859)));
        let t861 = t737 - t748 * t766 - t582 * t747 - t430 * t834 - t735;
        phi_h[0] = -(t24 * t38);
        phi_h[1] = -(t24 * t47 * two);
        phi_h[2] = -(t24 * t52 * two);
        phi_h[3] = t38 * t53;
        phi_h[4] = t47 * t53 * two;
        phi_h[5] = t52 * t53 * two;
        phi_h[6] = t53 * t67 - t24 * t68;
        phi_h[7] = (t53 * t77 - t24 * t78) * two;
        phi_h[8] = (t53 * t83 - t24 * t84) * two;
        phi_h[9] = t38 * t112 - t117 * t118;
        phi_h[10] = (t47 * t112 - t118 * t122) * two;
        phi_h[11] = (t52 * t112 - t118 * t126) * two;
        phi_h[12] = -(t118 * t129);
        phi_h[13] = -(t118 * t132 * two);
        phi_h[14] = -(t118 * t135 * two);
        phi_h[15] = -(t118 * t137);
        phi_h[16] = -(t118 * t139 * two);
        phi_h[17] = -(t118 * t141 * two);
        phi_h[18] = t112 * t127;
        phi_h[19] = t112 * t130 * two;
        phi_h[20] = t112 * t133 * two;
        phi_h[21] = t114 * t143 - t115 * t144;
        phi_h[22] = (t119 * t143 - t120 * t144) * two;
        phi_h[23] = (t123 * t143 - t124 * t144) * two;
        phi_h[24] = t127 * t143;
        phi_h[25] = t130 * t143 * two;
        phi_h[26] = t133 * t143 * two;
        phi_h[27] = -(t127 * t144);
        phi_h[28] = -(t130 * t144 * two);
        phi_h[29] = -(t133 * t144 * two);
        force_h[0] = t157 + (t167 * t168 + (t169 * t170 + t186));
        force_h[1] = t191 + (t197 * t198 + (t199 * t200 + t210));
        force_h[2] = t214 + (t198 * t220 + (t200 * t221 + t230));
        force_h[3] = t238 + (t244 * t245 + (t246 * t247 + t257));
        force_h[4] = t261 + (t265 * t266 + (t267 * t268 + t278));
        force_h[5] = t282 + (t266 * t286 + (t268 * t287 + t293));
        force_h[6] = t309 - t1 * t256 - t2 * t252;
        force_h[7] = t318 - t276 * t268 - t272 * t266;
        force_h[8] = t327 - t268 * t292 - t266 * t290;
        force_h[9] = t175 * t329 + (t168 * t335 + t340);
        force_h[10] = t175 * t342 + (t198 * t348 + t354);
        force_h[11] = t175 * t356 + (t198 * t363 + t367);
        force_h[12] = t175 * t369 + (t168 * t372 + t376);
        force_h[13] = t175 * t378 + (t198 * t381 + t385);
        force_h[14] = t175 * t387 + (t198 * t390 + t393);
        force_h[15] = t245 * t396 + (t247 * t397 + t412);
        force_h[16] = t266 * t416 + (t268 * t417 + t431);
        force_h[17] = t266 * t434 + (t268 * t435 + t448);
        force_h[18] = t449 + (t170 * t167 + t455);
        force_h[19] = t200 * t197 + (t201 * t456 + t457);
        force_h[20] = t200 * t220 + (t222 * t456 + t458);
        force_h[21] = t459 + (t247 * t244 + (t248 * t460 + t461));
        force_h[22] = t268 * t265 + (t269 * t462 + t464);
        force_h[23] = t268 * t286 + (t288 * t462 + (t277 * t290 + t465));
        force_h[24] = t466 + (t255 * t245 + (t468 - t1 * t252));
        force_h[25] = t276 * t266 + (t273 * t316 + t469);
        force_h[26] = t266 * t292 + (t273 * t325 + (t470 - t311 - t310));
        force_h[27] = t329 * t453 + (t170 * t335 + t472);
        force_h[28] = t342 * t453 + (t200 * t348 + t474);
        force_h[29] = t356 * t453 + (t200 * t363 + t476);
        force_h[30] = t369 * t453 + (t170 * t372 + t477);
        force_h[31] = t378 * t453 + (t200 * t381 + t478);
        force_h[32] = t387 * t453 + (t200 * t390 + t479);
        force_h[33] = t247 * t396 + (t399 * t460 + t481);
        force_h[34] = t268 * t416 + (t418 * t462 + t483);
        force_h[35] = t268 * t434 + (t436 * t462 + t485);
        force_h[36] = t171 * t168 + (t169 * t450 + t489);
        force_h[37] = t201 * t198 + (t199 * t456 + t490);
        force_h[38] = t198 * t222 + (t221 * t456 + t491);
        force_h[39] = t248 * t245 + (t246 * t460 + (t17 * t254 + t492));
        force_h[40] = t269 * t266 + (t267 * t462 + t493);
        force_h[41] = t266 * t288 + (t287 * t462 + t494);
        force_h[42] = t251 * t249 + (t304 * t307 + (t495 - t320 - t319));
        force_h[43] = t272 * t270 + (t275 * t317 + t496);
        force_h[44] = t270 * t290 + (t275 * t326 + t497);
        force_h[45] = t329 * t488 + (t168 * t338 + t500);
        force_h[46] = t342 * t488 + (t198 * t351 + t503);
        force_h[47] = t356 * t488 + (t198 * t365 + t505);
        force_h[48] = t369 * t488 + (t168 * t375 + t506);
        force_h[49] = t378 * t488 + (t198 * t384 + t507);
        force_h[50] = t387 * t488 + (t198 * t392 + t508);
        force_h[51] = t245 * t399 + (t397 * t460 + t510);
        force_h[52] = t266 * t418 + (t417 * t462 + t512);
        force_h[53] = t266 * t436 + (t435 * t462 + t514);
        force_h[54] = t172 * t169 + (t167 * t450 + t518);
        force_h[55] = t202 * t199 + (t197 * t456 + t519);
        force_h[56] = t202 * t221 + (t220 * t456 + t520);
        force_h[57] = t249 * t246 + (t244 * t460 + t521);
        force_h[58] = t270 * t267 + (t265 * t462 + (t275 * t276 + t522));
        force_h[59] = t270 * t287 + (t286 * t462 + t523);
        force_h[60] = t253 * t247 + (t303 * t306 + t524);
        force_h[61] = t274 * t268 + (t277 * t315 + (t525 - t298 - t296));
        force_h[62] = t268 * t291 + (t277 * t324 + t526);
        force_h[63] = t329 * t517 + (t172 * t336 + t528);
        force_h[64] = t342 * t517 + (t202 * t350 + t530);
        force_h[65] = t356 * t517 + (t202 * t364 + t533);
        force_h[66] = t369 * t517 + (t172 * t373 + t534);
        force_h[67] = t378 * t517 + (t202 * t383 + t535);
        force_h[68] = t387 * t517 + (t202 * t391 + t536);
        force_h[69] = t249 * t397 + (t396 * t460 + t538);
        force_h[70] = t270 * t417 + (t416 * t462 + t540);
        force_h[71] = t270 * t435 + (t434 * t462 + t542);
        force_h[72] = t543 * t544 + t568;
        force_h[73] = t569 * t570 + t592;
        force_h[74] = t570 * t593 + t605;
        force_h[75] = t550 * t606 + (t554 * t607 + t552 * t608);
        force_h[76] = t577 * t609 + (t582 * t610 + t580 * t612);
        force_h[77] = t577 * t614 + (t582 * t615 + t580 * t616);
        force_h[78] = -(t554 * t617) - t552 * t618 - t550 * t619;
        force_h[79] = -(t582 * t620) - t580 * t621 - t577 * t622;
        force_h[80] = -(t582 * t623) - t580 * t624 - t577 * t625;
        force_h[81] = t635 + (t329 * t565 + (t550 * t636 + (t552 * t637 + t651)));
        force_h[82] = t656 + (t342 * t565 + (t577 * t657 + (t580 * t658 + t669)));
        force_h[83] = t673 + (t356 * t565 + (t577 * t674 + (t580 * t675 + t686)));
        force_h[84] = t693 + t703;
        force_h[85] = t707 + t717;
        force_h[86] = t721 + t731;
        force_h[87] = t738 - t554 * t739 - t552 * t740 - t550 * t741 - t411 * t565;
        force_h[88] = t745 - t582 * t746 - t580 * t747 - t577 * t748 - t430 * t565;
        force_h[89] = t752 - t582 * t753 - t580 * t754 - t577 * t755 - t447 * t565;
        force_h[90] = t558 * t561 + (t546 * t543 + (t547 * t756 + (t552 * t549 + t764)));
        force_h[91] = t585 * t588 + (t573 * t569 + (t574 * t765 + (t580 * t576 + t770)));
        force_h[92] = t588 * t600 + (t573 * t593 + (t595 * t765 + (t580 * t596 + t773)));
        force_h[93] = t552 * t606 + (t607 * t757 - t550 * t608);
        force_h[94] = t580 * t609 + (t610 * t766 - t577 * t612);
        force_h[95] = t580 * t614 + (t615 * t766 - t577 * t616);
        force_h[96] = t550 * t618 - t617 * t757 - t552 * t619;
        force_h[97] = t577 * t621 - t620 * t766 - t580 * t622;
        force_h[98] = t577 * t624 - t623 * t766 - t580 * t625;
        force_h[99] = t774 + t779;
        force_h[100] = t342 * t762
            + (t588 * t665 + (t570 * t661 + (t580 * t657 + t781)));
        force_h[101] = t356 * t762 + t784;
        force_h[102] = t785 + t789;
        force_h[103] = t378 * t762 + (t586 * t662 + (t660 * t767 + t791));
        force_h[104] = t387 * t762 + (t586 * t679 + t794);
        force_h[105] = t795 + t796;
        force_h[106] = t577 * t747 + (t752 - t746 * t766 - t580 * t748 - t430 * t762);
        force_h[107] = t577 * t754 + (t797 - t742);
        force_h[108] = t557 * t560 + (t547 * t544 + (t545 * t756 + t806));
        force_h[109] = t584 * t587 + (t574 * t570 + (t572 * t765 + t812));
        force_h[110] = t584 * t601
            + (t570 * t595 + (t594 * t765 + (t577 * t598 + t815)));
        force_h[111] = t550 * t607 + (t608 * t757 - t554 * t606);
        force_h[112] = t577 * t610 + (t612 * t766 - t582 * t609);
        force_h[113] = t577 * t615 + (t616 * t766 - t582 * t614);
        force_h[114] = t554 * t619 - t618 * t757 - t550 * t617;
        force_h[115] = t582 * t622 - t621 * t766 - t577 * t620;
        force_h[116] = t582 * t625 - t624 * t766 - t577 * t623;
        force_h[117] = t329 * t801 + t818;
        force_h[118] = t342 * t801
            + (t584 * t666 + (t575 * t662 + (t577 * t659 + t820)));
        force_h[119] = t356 * t801
            + (t584 * t683 + (t575 * t679 + (t577 * t676 + t822)));
        force_h[120] = t369 * t801 + (t102 * t640 + t825);
        force_h[121] = t378 * t801 + (t588 * t660 + (t661 * t767 + t827));
        force_h[122] = t387 * t801 + (t588 * t677 + (t678 * t767 + t829));
        force_h[123] = t554 * t741 + (t830 - t749);
        force_h[124] = t582 * t748 + (t795 - t747 * t766 - t577 * t746 - t430 * t801);
        force_h[125] = t582 * t755 + (t738 - t754 * t766 - t577 * t753 - t447 * t801);
        force_h[126] = t556 * t559 + (t548 * t545 + (t543 * t756 + t837));
        force_h[127] = t583 * t586
            + (t575 * t572 + (t569 * t765 + (t582 * t579 + t840)));
        force_h[128] = t586 * t599 + (t575 * t594 + (t593 * t765 + t846));
        force_h[129] = t554 * t608 + (t606 * t757 - t552 * t607);
        force_h[130] = t582 * t612 + (t609 * t766 - t580 * t610);
        force_h[131] = t582 * t616 + (t614 * t766 - t580 * t615);
        force_h[132] = t552 * t617 - t619 * t757 - t554 * t618;
        force_h[133] = t580 * t620 - t622 * t766 - t582 * t621;
        force_h[134] = t580 * t623 - t625 * t766 - t582 * t624;
        force_h[135] = t329 * t834
            + (t559 * t646 + (t546 * t639 + (t554 * t637 + t848)));
        force_h[136] = t342 * t834 + t851;
        force_h[137] = t356 * t834
            + (t586 * t681 + (t573 * t677 + (t582 * t675 + t853)));
        force_h[138] = t369 * t834 + (t103 * t642 + (t100 * t644 + t855));
        force_h[139] = t378 * t834 + (t584 * t661 + t858);
        force_h[140] = t387 * t834 + (t584 * t678 + (t679 * t767 + t860));
        force_h[141] = t552 * t739 + (t745 - t741 * t757 - t554 * t740 - t411 * t834);
        force_h[142] = t580 * t746 + (t861 - t733);
        force_h[143] = t580 * t753 + (t795 - t755 * t766 - t582 * t754 - t447 * t834);
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 1110 additions, 1729 multiplications, 4 divisions, 1 functions.
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
        let k4 = S::from_f64(4.0);
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
        let t325 = t286 * t306 * half - t194 * (t278 * t307 - t134 * t324);
        let t326 = t182 * (t279 * t307 - t142 * t324) + (t325 - t288 * t313 * half);
        let t327 = t294 * t308;
        let t328 = t310 * (t293 * t307 - t142 * t327)
            - t311 * (t292 * t307 - t134 * t327);
        let t329 = q_i[3] * q_i[3];
        let t330 = q_i[4] * q_i[4];
        let t331 = q_i[6] * q_i[6];
        let t332 = q_i[5] * q_i[5];
        let t333 = t329 + t330 - t331 - t332;
        let t334 = q_i[3] * q_i[6];
        let t335 = q_i[4] * q_i[5];
        let t336 = t334 + t335;
        let t337 = t336 * two;
        let t338 = q_i[4] * q_i[6];
        let t339 = q_i[3] * q_i[5];
        let t340 = t338 - t339;
        let t341 = t340 * two;
        let t342 = t11 * t333 + (t13 * t337 + t9 * t341);
        let t343 = t40 * t342;
        let t344 = t42 * (t14 * t342);
        let t345 = t22 * t344;
        let t346 = q_i[6] * v_i[4] + q_i[4] * v_i[6];
        let t347 = q_i[3] * v_i[5];
        let t348 = q_i[5] * v_i[3];
        let t349 = t346 - t347 - t348;
        let t350 = q_i[5] * v_i[4] + q_i[4] * v_i[5];
        let t351 = q_i[3] * v_i[6];
        let t352 = q_i[6] * v_i[3];
        let t353 = t350 + (t351 + t352);
        let t354 = t333 * half;
        let t355 = q_i[4] * v_i[4];
        let t356 = q_i[3] * v_i[3];
        let t357 = q_i[6] * v_i[6];
        let t358 = q_i[5] * v_i[5];
        let t359 = t355 + t356 - t357 - t358;
        let t360 = t9 * t349 + (t13 * t353 + (t35 * t354 + t11 * t359));
        let t361 = t33 * t340 + (t37 * t336 + t360);
        let t362 = t52 * (t343 - t14 * t344) + (t65 * t345 - t69 * t361);
        let t363 = q_i[4] * q_i[3];
        let t364 = q_i[6] * q_i[5];
        let t365 = t363 + t364;
        let t366 = t329 - t330;
        let t367 = t332 - t331;
        let t368 = (t366 + t367) * half;
        let t369 = t335 - t334;
        let t370 = t9 * t365 + (t13 * t368 + t11 * t369);
        let t371 = t40 * t370;
        let t372 = t42 * (t14 * t370);
        let t373 = t22 * t372;
        let t374 = q_i[6] * v_i[5] + q_i[5] * v_i[6];
        let t375 = q_i[3] * v_i[4];
        let t376 = q_i[4] * v_i[3];
        let t377 = t374 + (t375 + t376);
        let t378 = t356 - t355;
        let t379 = t378 + (t358 - t357);
        let t380 = t350 - t351 - t352;
        let t381 = t9 * t377 + (t13 * t379 + (t37 * t368 + t11 * t380));
        let t382 = t33 * t365 + (t35 * t369 + t381);
        let t383 = t53 * (t371 - t14 * t372) + (t66 * t373 - t69 * t382);
        let t384 = t364 - t363;
        let t385 = (t366 - t367) * half;
        let t386 = t339 + t338;
        let t387 = t13 * t384 + (t9 * t385 + t11 * t386);
        let t388 = t40 * t387;
        let t389 = t42 * (t14 * t387);
        let t390 = t22 * t389;
        let t391 = t357 + (t378 - t358);
        let t392 = t374 - t375 - t376;
        let t393 = t348 + (t347 + t346);
        let t394 = t9 * t391 + (t13 * t392 + (t33 * t385 + t11 * t393));
        let t395 = t37 * t384 + (t35 * t386 + t394);
        let t396 = t53 * (t388 - t14 * t389) + (t66 * t390 - t69 * t395);
        let t397 = t65 * (t343 - t22 * (t42 * (t22 * t342))) + (t52 * t345 - t24 * t361);
        let t398 = t66 * (t371 - t22 * (t42 * (t22 * t370))) + (t53 * t373 - t24 * t382);
        let t399 = t66 * (t388 - t22 * (t42 * (t22 * t387))) + (t53 * t390 - t24 * t395);
        let t400 = q_j[3] * q_j[3];
        let t401 = q_j[4] * q_j[4];
        let t402 = q_j[6] * q_j[6];
        let t403 = q_j[5] * q_j[5];
        let t404 = t400 + t401 - t402 - t403;
        let t405 = q_j[3] * q_j[6];
        let t406 = q_j[4] * q_j[5];
        let t407 = t405 + t406;
        let t408 = t407 * two;
        let t409 = q_j[4] * q_j[6];
        let t410 = q_j[3] * q_j[5];
        let t411 = t409 - t410;
        let t412 = t411 * two;
        let t413 = t10 * t404 + (t12 * t408 + t4 * t412);
        let t414 = t20 * t404 + (t21 * t408 + t19 * t412);
        let t415 = t42 * (t14 * t413 + t22 * t414);
        let t416 = q_j[6] * v_j[4] + q_j[4] * v_j[6];
        let t417 = q_j[3] * v_j[5];
        let t418 = q_j[5] * v_j[3];
        let t419 = t416 - t417 - t418;
        let t420 = q_j[5] * v_j[4] + q_j[4] * v_j[5];
        let t421 = q_j[3] * v_j[6];
        let t422 = q_j[6] * v_j[3];
        let t423 = t420 + (t421 + t422);
        let t424 = t404 * half;
        let t425 = q_j[4] * v_j[4];
        let t426 = q_j[3] * v_j[3];
        let t427 = q_j[6] * v_j[6];
        let t428 = q_j[5] * v_j[5];
        let t429 = t425 + t426 - t427 - t428;
        let t430 = t19 * t419 + (t21 * t423 + (t50 * t424 + t20 * t429));
        let t431 = t4 * t419 + (t12 * t423 + (t63 * t424 + t10 * t429));
        let t432 = t24 * (t46 * t411 + (t48 * t407 + t430))
            - t69 * (t59 * t411 + (t61 * t407 + t431));
        let t433 = t52 * (t40 * t413 - t14 * t415)
            + (t432 - t65 * (t40 * t414 - t22 * t415));
        let t434 = q_j[4] * q_j[3];
        let t435 = q_j[6] * q_j[5];
        let t436 = t434 + t435;
        let t437 = t406 - t405;
        let t438 = q_j[6] * v_j[5] + q_j[5] * v_j[6];
        let t439 = q_j[3] * v_j[4];
        let t440 = q_j[4] * v_j[3];
        let t441 = t438 + (t439 + t440);
        let t442 = t426 - t425;
        let t443 = t442 + (t428 - t427);
        let t444 = t400 - t401;
        let t445 = t403 - t402;
        let t446 = (t444 + t445) * half;
        let t447 = t420 - t421 - t422;
        let t448 = t19 * t441 + (t21 * t443 + (t48 * t446 + t20 * t447));
        let t449 = t4 * t436 + (t12 * t446 + t10 * t437);
        let t450 = t19 * t436 + (t21 * t446 + t20 * t437);
        let t451 = t42 * (t14 * t449 + t22 * t450);
        let t452 = t53 * (t40 * t449 - t14 * t451) - t66 * (t40 * t450 - t22 * t451);
        let t453 = t4 * t441 + (t12 * t443 + (t61 * t446 + t10 * t447));
        let t454 = t24 * (t46 * t436 + (t50 * t437 + t448))
            + (t452 - t69 * (t59 * t436 + (t63 * t437 + t453)));
        let t455 = t435 - t434;
        let t456 = t410 + t409;
        let t457 = t427 + (t442 - t428);
        let t458 = t438 - t439 - t440;
        let t459 = (t444 - t445) * half;
        let t460 = t418 + (t417 + t416);
        let t461 = t19 * t457 + (t21 * t458 + (t46 * t459 + t20 * t460));
        let t462 = t12 * t455 + (t4 * t459 + t10 * t456);
        let t463 = t21 * t455 + (t19 * t459 + t20 * t456);
        let t464 = t42 * (t14 * t462 + t22 * t463);
        let t465 = t53 * (t40 * t462 - t14 * t464) - t66 * (t40 * t463 - t22 * t464);
        let t466 = t4 * t457 + (t12 * t458 + (t59 * t459 + t10 * t460));
        let t467 = t24 * (t48 * t455 + (t50 * t456 + t461))
            + (t465 - t69 * (t61 * t455 + (t63 * t456 + t466)));
        let t468 = t131 * t333 + (t133 * t337 + t129 * t341);
        let t469 = t140 * t333 + (t141 * t337 + t139 * t341);
        let t470 = t134 * t468 + t142 * t469;
        let t471 = t155 * t470;
        let t472 = t159 * (t144 * t471 + t145 * t342);
        let t473 = t139 * t349 + (t141 * t353 + (t190 * t354 + t140 * t359));
        let t474 = t188 * t340 + (t192 * t336 + t473);
        let t475 = t129 * t349 + (t133 * t353 + (t178 * t354 + t131 * t359));
        let t476 = t176 * t340 + (t180 * t336 + t475);
        let t477 = t134 * t476 + (t182 * t468 * half + t194 * t469 * half);
        let t478 = t195 * half;
        let t479 = t205 * (t155 * (t142 * t474 + t477) - t204 * t471 * t478);
        let t480 = t147 * t361 - t479 - t196 * (t157 * t342 - t145 * t472);
        let t481 = t129 * t365 + (t133 * t368 + t131 * t369);
        let t482 = t139 * t365 + (t141 * t368 + t140 * t369);
        let t483 = t134 * t481 + t142 * t482;
        let t484 = t155 * t483;
        let t485 = t159 * (t144 * t484 + t145 * t370);
        let t486 = t170 * (t157 * t484 - t144 * t485)
            - t197 * (t157 * t370 - t145 * t485);
        let t487 = t129 * t377 + (t133 * t379 + (t180 * t368 + t131 * t380));
        let t488 = t176 * t365 + (t178 * t369 + t487);
        let t489 = t139 * t377 + (t141 * t379 + (t192 * t368 + t140 * t380));
        let t490 = t188 * t365 + (t190 * t369 + t489);
        let t491 = t194 * t482 + (t182 * t481 + (t134 * t488 + t142 * t490));
        let t492 = t147 * t382 + (t486 - t205 * (t155 * t491 - t195 * (t204 * t484)));
        let t493 = t133 * t384 + (t129 * t385 + t131 * t386);
        let t494 = t141 * t384 + (t139 * t385 + t140 * t386);
        let t495 = t134 * t493 + t142 * t494;
        let t496 = t155 * t495;
        let t497 = t159 * (t144 * t496 + t145 * t387);
        let t498 = t170 * (t157 * t496 - t144 * t497)
            - t197 * (t157 * t387 - t145 * t497);
        let t499 = t129 * t391 + (t133 * t392 + (t176 * t385 + t131 * t393));
        let t500 = t180 * t384 + (t178 * t386 + t499);
        let t501 = t139 * t391 + (t141 * t392 + (t188 * t385 + t140 * t393));
        let t502 = t192 * t384 + (t190 * t386 + t501);
        let t503 = t194 * t494 + (t182 * t493 + (t134 * t500 + t142 * t502));
        let t504 = t147 * t395 + (t498 - t205 * (t155 * t503 - t195 * (t204 * t496)));
        let t505 = t130 * t404 + (t132 * t408 + t124 * t412);
        let t506 = t134 * t505;
        let t507 = t155 * t506;
        let t508 = t159 * (t144 * t507);
        let t509 = t505 * half;
        let t510 = t124 * t419 + (t132 * t423 + (t167 * t424 + t130 * t429));
        let t511 = t163 * t411 + (t165 * t407 + t510);
        let t512 = t155 * (t182 * t509 + t134 * t511) - t478 * (t204 * t507);
        let t513 = t196 * (t145 * t508)
            + (t169 * (t157 * t507 - t144 * t508) - t205 * t512);
        let t514 = t124 * t436 + (t132 * t446 + t130 * t437);
        let t515 = t134 * t514;
        let t516 = t155 * t515;
        let t517 = t159 * (t144 * t516);
        let t518 = t124 * t441 + (t132 * t443 + (t165 * t446 + t130 * t447));
        let t519 = t163 * t436 + (t167 * t437 + t518);
        let t520 = t155 * (t134 * t519 + t182 * t514) - t195 * (t204 * t516);
        let t521 = t197 * (t145 * t517)
            + (t170 * (t157 * t516 - t144 * t517) - t205 * t520);
        let t522 = t132 * t455 + (t124 * t459 + t130 * t456);
        let t523 = t134 * t522;
        let t524 = t155 * t523;
        let t525 = t159 * (t144 * t524);
        let t526 = t124 * t457 + (t132 * t458 + (t163 * t459 + t130 * t460));
        let t527 = t165 * t455 + (t167 * t456 + t526);
        let t528 = t155 * (t134 * t527 + t182 * t522) - t195 * (t204 * t524);
        let t529 = t197 * (t145 * t525)
            + (t170 * (t157 * t524 - t144 * t525) - t205 * t528);
        let t530 = t142 * t505;
        let t531 = t155 * t530;
        let t532 = t159 * (t144 * t531);
        let t533 = t155 * (t194 * t509 + t142 * t511) - t478 * (t204 * t531);
        let t534 = t196 * (t145 * t532)
            + (t169 * (t157 * t531 - t144 * t532) - t205 * t533);
        let t535 = t142 * t514;
        let t536 = t155 * t535;
        let t537 = t159 * (t144 * t536);
        let t538 = t155 * (t142 * t519 + t194 * t514) - t195 * (t204 * t536);
        let t539 = t197 * (t145 * t537)
            + (t170 * (t157 * t536 - t144 * t537) - t205 * t538);
        let t540 = t142 * t522;
        let t541 = t155 * t540;
        let t542 = t159 * (t144 * t541);
        let t543 = t155 * (t142 * t527 + t194 * t522) - t195 * (t204 * t541);
        let t544 = t197 * (t145 * t542)
            + (t170 * (t157 * t541 - t144 * t542) - t205 * t543);
        let t545 = t159 * (t145 * t505);
        let t546 = t196 * (t157 * t505 - t145 * t545)
            + (t169 * (t144 * t545) - t147 * t511);
        let t547 = t159 * (t145 * t514);
        let t548 = t197 * (t157 * t514 - t145 * t547)
            + (t170 * (t144 * t547) - t147 * t519);
        let t549 = t159 * (t145 * t522);
        let t550 = t197 * (t157 * t522 - t145 * t549)
            + (t170 * (t144 * t549) - t147 * t527);
        let t551 = t308 * t470;
        let t552 = t306 * t476 - t313 * t474 - t194 * (t307 * t468 - t134 * t551);
        let t553 = t308 * t483;
        let t554 = t310 * (t307 * t482 - t142 * t553)
            - t311 * (t307 * t481 - t134 * t553);
        let t555 = t308 * t495;
        let t556 = t310 * (t307 * t494 - t142 * t555)
            - t311 * (t307 * t493 - t134 * t555);
        let t557 = t308 * t506;
        let t558 = t142 * t557;
        let t559 = t307 * t505;
        let t560 = t182 * t558 + (t194 * (t559 - t134 * t557) - t306 * t511);
        let t561 = t308 * t515;
        let t562 = t142 * t561;
        let t563 = t307 * t514;
        let t564 = t310 * t562 + (t311 * (t563 - t134 * t561) - t306 * t519);
        let t565 = t308 * t523;
        let t566 = t142 * t565;
        let t567 = t307 * t522;
        let t568 = t310 * t566 + (t311 * (t567 - t134 * t565) - t306 * t527);
        let t569 = t182 * (t559 - t142 * (t308 * t530)) + (t194 * t558 - t313 * t511);
        let t570 = t310 * (t563 - t142 * (t308 * t535)) + (t311 * t562 - t313 * t519);
        let t571 = t310 * (t567 - t142 * (t308 * t540)) + (t311 * t566 - t313 * t527);
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
        rate_q[22] = t326 * k4;
        rate_q[23] = (t300 * t306 + (t328 - t302 * t313)) * two;
        rate_h[0] = t362 * two;
        rate_h[1] = t383 * two;
        rate_h[2] = t396 * two;
        rate_h[3] = -(t397 * two);
        rate_h[4] = -(t398 * two);
        rate_h[5] = -(t399 * two);
        rate_h[6] = t433 * two;
        rate_h[7] = t454 * two;
        rate_h[8] = t467 * two;
        rate_h[9] = (t169 * (t157 * t471 - t144 * t472) + t480) * two;
        rate_h[10] = t492 * two;
        rate_h[11] = t504 * two;
        rate_h[12] = t513 * two;
        rate_h[13] = t521 * two;
        rate_h[14] = t529 * two;
        rate_h[15] = t534 * two;
        rate_h[16] = t539 * two;
        rate_h[17] = t544 * two;
        rate_h[18] = -(t546 * two);
        rate_h[19] = -(t548 * two);
        rate_h[20] = -(t550 * two);
        rate_h[21] = (t182 * (t307 * t469 - t142 * t551) + t552) * two;
        rate_h[22] = (t306 * t488 + (t554 - t313 * t490)) * two;
        rate_h[23] = (t306 * t500 + (t556 - t313 * t502)) * two;
        rate_h[24] = -(t560 * two);
        rate_h[25] = -(t564 * two);
        rate_h[26] = -(t568 * two);
        rate_h[27] = t569 * two;
        rate_h[28] = t570 * two;
        rate_h[29] = t571 * two;
    }
}
