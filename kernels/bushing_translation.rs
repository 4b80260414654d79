// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Displacement in a bushing
///
/// `Bᵀ A_iᵀ (r_j + A_j s_j − r_i − A_i s_i) = 0, B = [x_i y_i z_i]` (unit m)
///
/// Source: method paper, eq. (16), along three axes fixed in body i.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `x_i` | 1 | body i | unit vector of the first bushing axis |
/// | 3..6 | `y_i` | 1 | body i | unit vector of the second bushing axis |
/// | 6..9 | `z_i` | 1 | body i | unit vector of the third bushing axis |
/// | 9..12 | `s_i` | m | body i | bushing centre |
/// | 12..15 | `s_j` | m | body j | bushing centre |
pub mod bushing_translation {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "bushing_translation",
        title: "Displacement in a bushing",
        equation: "Bᵀ A_iᵀ (r_j + A_j s_j − r_i − A_i s_i) = 0, B = [x_i y_i z_i]",
        reference: "method paper, eq. (16), along three axes fixed in body i",
        bodies: 2,
        equations: 3,
        unit: "m",
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
                name: "s_i",
                size: 3,
                offset: 9,
                unit: "m",
                frame: "body i",
                meaning: "bushing centre",
            },
            Parameter {
                name: "s_j",
                size: 3,
                offset: 12,
                unit: "m",
                frame: "body j",
                meaning: "bushing centre",
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
            (0, 9),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
            (0, 14),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 9),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (1, 14),
            (2, 6),
            (2, 7),
            (2, 8),
            (2, 9),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
            (2, 14),
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
            (1, 0),
            (1, 1),
            (1, 2),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 6),
            (1, 7),
            (1, 8),
            (2, 0),
            (2, 1),
            (2, 2),
            (2, 3),
            (2, 4),
            (2, 5),
            (2, 6),
            (2, 7),
            (2, 8),
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
            (7, 0),
            (7, 1),
            (7, 2),
            (7, 3),
            (7, 4),
            (7, 5),
            (7, 6),
            (7, 7),
            (7, 8),
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
            (10, 0),
            (10, 1),
            (10, 2),
            (10, 3),
            (10, 4),
            (10, 5),
            (10, 6),
            (10, 7),
            (10, 8),
            (10, 12),
            (10, 13),
            (10, 14),
            (11, 0),
            (11, 1),
            (11, 2),
            (11, 3),
            (11, 4),
            (11, 5),
            (11, 6),
            (11, 7),
            (11, 8),
            (11, 12),
            (11, 13),
            (11, 14),
            (12, 0),
            (12, 1),
            (12, 2),
            (12, 3),
            (12, 4),
            (12, 5),
            (12, 6),
            (12, 7),
            (12, 8),
            (12, 12),
            (12, 13),
            (12, 14),
            (13, 0),
            (13, 1),
            (13, 2),
            (13, 3),
            (13, 4),
            (13, 5),
            (13, 6),
            (13, 7),
            (13, 8),
            (13, 12),
            (13, 13),
            (13, 14),
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
        ],
        rate_design: &[
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 9),
            (0, 10),
            (0, 11),
            (0, 12),
            (0, 13),
            (0, 14),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 9),
            (1, 10),
            (1, 11),
            (1, 12),
            (1, 13),
            (1, 14),
            (2, 6),
            (2, 7),
            (2, 8),
            (2, 9),
            (2, 10),
            (2, 11),
            (2, 12),
            (2, 13),
            (2, 14),
        ],
        operations: [
            Operations {
                additions: 100,
                multiplications: 129,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 184,
                multiplications: 257,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 392,
                multiplications: 507,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 619,
                multiplications: 920,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 617,
                multiplications: 740,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Displacement in a bushing
    #[derive(Clone, Copy, Debug, Default)]
    pub struct BushingTranslation;
    impl<S: Scalar> Relation<S> for BushingTranslation {
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
    /// 100 additions, 129 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 15],
        phi: &mut [S; 3],
    ) {
        let t0 = h[14] * q_j[6] + (h[12] * q_j[4] + q_j[5] * h[13]);
        let t1 = q_j[3] * h[14] + h[13] * q_j[4] - h[12] * q_j[5];
        let t2 = h[12] * q_j[6] + (q_j[3] * h[13] - h[14] * q_j[4]);
        let t3 = q_j[3] * h[12] + q_j[5] * h[14] - q_j[6] * h[13];
        let t4 = q_j[6] * t0 + (q_j[3] * t1 + q_j[4] * t2 - q_j[5] * t3);
        let t5 = h[11] * q_i[6] + (h[9] * q_i[4] + q_i[5] * h[10]);
        let t6 = q_i[3] * h[11] + h[10] * q_i[4] - h[9] * q_i[5];
        let t7 = h[9] * q_i[6] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t8 = q_i[3] * h[9] + q_i[5] * h[11] - q_i[6] * h[10];
        let t9 = q_i[6] * t5 + (q_i[3] * t6 + q_i[4] * t7 - q_i[5] * t8);
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t12 = q_i[3] * h[2] + q_i[4] * h[1] - q_i[5] * h[0];
        let t13 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t14 = q_i[3] * h[0] + q_i[5] * h[2] - q_i[6] * h[1];
        let t15 = q_i[6] * t11 + (q_i[3] * t12 + q_i[4] * t13 - q_i[5] * t14);
        let t16 = q_j[5] * t1 + (q_j[3] * t3 + q_j[4] * t0) - q_j[6] * t2;
        let t17 = q_i[5] * t6 + (q_i[3] * t8 + q_i[4] * t5) - q_i[6] * t7;
        let t18 = q_j[0] + t16 - q_i[0] - t17;
        let t19 = q_i[5] * t12 + (q_i[3] * t14 + q_i[4] * t11) - q_i[6] * t13;
        let t20 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t2 - q_j[4] * t1));
        let t21 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t7 - q_i[4] * t6));
        let t22 = q_j[1] + t20 - q_i[1] - t21;
        let t23 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t13 - q_i[4] * t12));
        let t24 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t25 = q_i[3] * h[5] + q_i[4] * h[4] - q_i[5] * h[3];
        let t26 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t27 = q_i[3] * h[3] + q_i[5] * h[5] - q_i[6] * h[4];
        let t28 = q_i[6] * t24 + (q_i[3] * t25 + q_i[4] * t26 - q_i[5] * t27);
        let t29 = q_i[5] * t25 + (q_i[3] * t27 + q_i[4] * t24) - q_i[6] * t26;
        let t30 = q_i[6] * t27 + (q_i[5] * t24 + (q_i[3] * t26 - q_i[4] * t25));
        let t31 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t32 = q_i[3] * h[8] + q_i[4] * h[7] - q_i[5] * h[6];
        let t33 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t34 = q_i[3] * h[6] + q_i[5] * h[8] - q_i[6] * h[7];
        let t35 = q_i[6] * t31 + (q_i[3] * t32 + q_i[4] * t33 - q_i[5] * t34);
        let t36 = q_i[5] * t32 + (q_i[3] * t34 + q_i[4] * t31) - q_i[6] * t33;
        let t37 = q_i[6] * t34 + (q_i[5] * t31 + (q_i[3] * t33 - q_i[4] * t32));
        phi[0] = t10 * t15 + (t18 * t19 + t22 * t23);
        phi[1] = t10 * t28 + (t18 * t29 + t22 * t30);
        phi[2] = t10 * t35 + (t18 * t36 + t22 * t37);
    }
    /// Φ, Φ_q and W.
    ///
    /// 184 additions, 257 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 15],
        phi: &mut [S; 3],
        phi_q: &mut [S; 42],
        _work: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        let t0 = h[14] * q_j[6] + (q_j[4] * h[12] + h[13] * q_j[5]);
        let t1 = q_j[6] * h[12] + (q_j[3] * h[13] - h[14] * q_j[4]);
        let t2 = q_j[4] * h[13] + (h[14] * q_j[3] - h[12] * q_j[5]);
        let t3 = h[14] * q_j[5] + (q_j[3] * h[12] - h[13] * q_j[6]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[11] * q_i[6] + (q_i[4] * h[9] + h[10] * q_i[5]);
        let t6 = q_i[6] * h[9] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t7 = q_i[4] * h[10] + (h[11] * q_i[3] - h[9] * q_i[5]);
        let t8 = h[11] * q_i[5] + (q_i[3] * h[9] - h[10] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t12 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t13 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t14 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t15 = q_i[6] * t11 + (q_i[4] * t12 + (q_i[3] * t13 - q_i[5] * t14));
        let t16 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t17 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t18 = q_j[0] + t16 - q_i[0] - t17;
        let t19 = q_i[5] * t13 + (q_i[4] * t11 + (q_i[3] * t14 - q_i[6] * t12));
        let t20 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t21 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t22 = q_j[1] + t20 - q_i[1] - t21;
        let t23 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t12 - q_i[4] * t13));
        let t24 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t25 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t26 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t27 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t28 = q_i[6] * t24 + (q_i[4] * t25 + (q_i[3] * t26 - q_i[5] * t27));
        let t29 = q_i[5] * t26 + (q_i[4] * t24 + (q_i[3] * t27 - q_i[6] * t25));
        let t30 = q_i[6] * t27 + (q_i[5] * t24 + (q_i[3] * t25 - q_i[4] * t26));
        let t31 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t32 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t33 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t34 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t35 = q_i[6] * t31 + (q_i[4] * t32 + (q_i[3] * t33 - q_i[5] * t34));
        let t36 = q_i[5] * t33 + (q_i[4] * t31 + (q_i[3] * t34 - q_i[6] * t32));
        let t37 = q_i[6] * t34 + (q_i[5] * t31 + (q_i[3] * t32 - q_i[4] * t33));
        let t38 = t10 * two;
        let t39 = t22 * two;
        let t40 = t18 * two;
        let t41 = t8 * two;
        let t42 = t6 * two;
        let t43 = t7 * two;
        let t44 = t14 * t40 - t19 * t41 - t23 * t42 - t15 * t43;
        let t45 = t5 * two;
        let t46 = t23 * t43 - t19 * t45 - t15 * t42 - t13 * t39;
        let t47 = t15 * t41 - t23 * t45 - t19 * t43 - t14 * t38;
        let t48 = t19 * t42 - t15 * t45 - t23 * t41 - t12 * t40;
        let t49 = t2 * two;
        let t50 = t3 * two;
        let t51 = t1 * two;
        let t52 = t0 * two;
        let t53 = t27 * t40 - t29 * t41 - t30 * t42 - t28 * t43;
        let t54 = t30 * t43 - t29 * t45 - t28 * t42 - t26 * t39;
        let t55 = t28 * t41 - t30 * t45 - t29 * t43 - t27 * t38;
        let t56 = t29 * t42 - t28 * t45 - t30 * t41 - t25 * t40;
        let t57 = t34 * t40 - t36 * t41 - t37 * t42 - t35 * t43;
        let t58 = t37 * t43 - t36 * t45 - t35 * t42 - t33 * t39;
        let t59 = t35 * t41 - t37 * t45 - t36 * t43 - t34 * t38;
        let t60 = t36 * t42 - t35 * t45 - t37 * t41 - t32 * t40;
        phi[0] = t10 * t15 + (t18 * t19 + t22 * t23);
        phi[1] = t10 * t28 + (t18 * t29 + t22 * t30);
        phi[2] = t10 * t35 + (t18 * t36 + t22 * t37);
        phi_q[0] = -t19;
        phi_q[1] = -t23;
        phi_q[2] = -t15;
        phi_q[3] = t13 * t38 + (t12 * t39 + t44);
        phi_q[4] = t12 * t38 + (t11 * t40 + t46);
        phi_q[5] = t11 * t39 + (t13 * t40 + t47);
        phi_q[6] = t11 * t38 + (t14 * t39 + t48);
        phi_q[7] = t19;
        phi_q[8] = t23;
        phi_q[9] = t15;
        phi_q[10] = t15 * t49 + (t19 * t50 + t23 * t51);
        phi_q[11] = t15 * t51 + (t19 * t52 - t23 * t49);
        phi_q[12] = t19 * t49 + (t23 * t52 - t15 * t50);
        phi_q[13] = t23 * t50 + (t15 * t52 - t19 * t51);
        phi_q[14] = -t29;
        phi_q[15] = -t30;
        phi_q[16] = -t28;
        phi_q[17] = t26 * t38 + (t25 * t39 + t53);
        phi_q[18] = t25 * t38 + (t24 * t40 + t54);
        phi_q[19] = t24 * t39 + (t26 * t40 + t55);
        phi_q[20] = t24 * t38 + (t27 * t39 + t56);
        phi_q[21] = t29;
        phi_q[22] = t30;
        phi_q[23] = t28;
        phi_q[24] = t28 * t49 + (t29 * t50 + t30 * t51);
        phi_q[25] = t28 * t51 + (t29 * t52 - t30 * t49);
        phi_q[26] = t29 * t49 + (t30 * t52 - t28 * t50);
        phi_q[27] = t30 * t50 + (t28 * t52 - t29 * t51);
        phi_q[28] = -t36;
        phi_q[29] = -t37;
        phi_q[30] = -t35;
        phi_q[31] = t33 * t38 + (t32 * t39 + t57);
        phi_q[32] = t32 * t38 + (t31 * t40 + t58);
        phi_q[33] = t31 * t39 + (t33 * t40 + t59);
        phi_q[34] = t31 * t38 + (t34 * t39 + t60);
        phi_q[35] = t36;
        phi_q[36] = t37;
        phi_q[37] = t35;
        phi_q[38] = t35 * t49 + (t36 * t50 + t37 * t51);
        phi_q[39] = t35 * t51 + (t36 * t52 - t37 * t49);
        phi_q[40] = t36 * t49 + (t37 * t52 - t35 * t50);
        phi_q[41] = t37 * t50 + (t35 * t52 - t36 * t51);
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 392 additions, 507 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 15],
        lambda: &[S; 3],
        phi: &mut [S; 3],
        phi_q: &mut [S; 42],
        _work: &mut [S; 0],
        curvature: &mut [S; 60],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = h[14] * q_j[6] + (q_j[4] * h[12] + h[13] * q_j[5]);
        let t1 = q_j[6] * h[12] + (q_j[3] * h[13] - h[14] * q_j[4]);
        let t2 = q_j[4] * h[13] + (h[14] * q_j[3] - h[12] * q_j[5]);
        let t3 = h[14] * q_j[5] + (q_j[3] * h[12] - h[13] * q_j[6]);
        let t4 = q_j[6] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[5] * t3));
        let t5 = h[11] * q_i[6] + (q_i[4] * h[9] + h[10] * q_i[5]);
        let t6 = q_i[6] * h[9] + (q_i[3] * h[10] - h[11] * q_i[4]);
        let t7 = q_i[4] * h[10] + (h[11] * q_i[3] - h[9] * q_i[5]);
        let t8 = h[11] * q_i[5] + (q_i[3] * h[9] - h[10] * q_i[6]);
        let t9 = q_i[6] * t5 + (q_i[4] * t6 + (q_i[3] * t7 - q_i[5] * t8));
        let t10 = q_j[2] + t4 - q_i[2] - t9;
        let t11 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t12 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t13 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t14 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t15 = q_i[6] * t11 + (q_i[4] * t12 + (q_i[3] * t13 - q_i[5] * t14));
        let t16 = q_j[5] * t2 + (q_j[4] * t0 + (q_j[3] * t3 - q_j[6] * t1));
        let t17 = q_i[5] * t7 + (q_i[4] * t5 + (q_i[3] * t8 - q_i[6] * t6));
        let t18 = q_j[0] + t16 - q_i[0] - t17;
        let t19 = q_i[5] * t13 + (q_i[4] * t11 + (q_i[3] * t14 - q_i[6] * t12));
        let t20 = q_j[6] * t3 + (q_j[5] * t0 + (q_j[3] * t1 - q_j[4] * t2));
        let t21 = q_i[6] * t8 + (q_i[5] * t5 + (q_i[3] * t6 - q_i[4] * t7));
        let t22 = q_j[1] + t20 - q_i[1] - t21;
        let t23 = q_i[6] * t14 + (q_i[5] * t11 + (q_i[3] * t12 - q_i[4] * t13));
        let t24 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t25 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t26 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t27 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t28 = q_i[6] * t24 + (q_i[4] * t25 + (q_i[3] * t26 - q_i[5] * t27));
        let t29 = q_i[5] * t26 + (q_i[4] * t24 + (q_i[3] * t27 - q_i[6] * t25));
        let t30 = q_i[6] * t27 + (q_i[5] * t24 + (q_i[3] * t25 - q_i[4] * t26));
        let t31 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t32 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t33 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t34 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t35 = q_i[6] * t31 + (q_i[4] * t32 + (q_i[3] * t33 - q_i[5] * t34));
        let t36 = q_i[5] * t33 + (q_i[4] * t31 + (q_i[3] * t34 - q_i[6] * t32));
        let t37 = q_i[6] * t34 + (q_i[5] * t31 + (q_i[3] * t32 - q_i[4] * t33));
        let t38 = t10 * two;
        let t39 = t22 * two;
        let t40 = t18 * two;
        let t41 = t8 * two;
        let t42 = t6 * two;
        let t43 = t7 * two;
        let t44 = t14 * t40 - t19 * t41 - t23 * t42 - t15 * t43;
        let t45 = t5 * two;
        let t46 = t23 * t43 - t19 * t45 - t15 * t42 - t13 * t39;
        let t47 = t15 * t41 - t23 * t45 - t19 * t43 - t14 * t38;
        let t48 = t19 * t42 - t15 * t45 - t23 * t41 - t12 * t40;
        let t49 = t2 * two;
        let t50 = t3 * two;
        let t51 = t1 * two;
        let t52 = t0 * two;
        let t53 = t27 * t40 - t29 * t41 - t30 * t42 - t28 * t43;
        let t54 = t30 * t43 - t29 * t45 - t28 * t42 - t26 * t39;
        let t55 = t28 * t41 - t30 * t45 - t29 * t43 - t27 * t38;
        let t56 = t29 * t42 - t28 * t45 - t30 * t41 - t25 * t40;
        let t57 = t34 * t40 - t36 * t41 - t37 * t42 - t35 * t43;
        let t58 = t37 * t43 - t36 * t45 - t35 * t42 - t33 * t39;
        let t59 = t35 * t41 - t37 * t45 - t36 * t43 - t34 * t38;
        let t60 = t36 * t42 - t35 * t45 - t37 * t41 - t32 * t40;
        let t61 = lambda[0] * two;
        let t62 = t14 * t61;
        let t63 = lambda[1] * two;
        let t64 = t27 * t63;
        let t65 = lambda[2] * two;
        let t66 = t34 * t65;
        let t67 = -t62 - t64 - t66;
        let t68 = t12 * t61;
        let t69 = t25 * t63;
        let t70 = t32 * t65;
        let t71 = -t68 - t69 - t70;
        let t72 = t13 * t61;
        let t73 = t26 * t63;
        let t74 = t33 * t65;
        let t75 = -t72 - t73 - t74;
        let t76 = t8 * lambda[0];
        let t77 = t76 * k4;
        let t78 = t34 * lambda[2] + (t14 * lambda[0] + t27 * lambda[1]);
        let t79 = t78 * k4;
        let t80 = t8 * lambda[2];
        let t81 = t80 * k4;
        let t82 = t8 * lambda[1];
        let t83 = t82 * k4;
        let t84 = -(t14 * t77) - t8 * t79 + (-(t34 * t81) - t27 * t83);
        let t85 = t22 * lambda[0] * two;
        let t86 = h[1] * t85;
        let t87 = (t37 * lambda[2] + (t23 * lambda[0] + t30 * lambda[1])) * two;
        let t88 = h[10] * t87;
        let t89 = t22 * lambda[2] * two;
        let t90 = h[7] * t89;
        let t91 = t22 * lambda[1] * two;
        let t92 = h[4] * t91;
        let t93 = t84 + (t86 - t88 + (t90 + t92));
        let t94 = t18 * lambda[0] * two;
        let t95 = h[0] * t94;
        let t96 = (t36 * lambda[2] + (t19 * lambda[0] + t29 * lambda[1])) * two;
        let t97 = h[9] * t96;
        let t98 = t18 * lambda[2] * two;
        let t99 = h[6] * t98;
        let t100 = t18 * lambda[1] * two;
        let t101 = h[3] * t100;
        let t102 = t95 - t97 + (t99 + t101);
        let t103 = t10 * lambda[0] * two;
        let t104 = h[2] * t103;
        let t105 = (t35 * lambda[2] + (t15 * lambda[0] + t28 * lambda[1])) * two;
        let t106 = h[11] * t105;
        let t107 = t10 * lambda[2] * two;
        let t108 = h[8] * t107;
        let t109 = t10 * lambda[1] * two;
        let t110 = h[5] * t109;
        let t111 = t104 - t106 + (t108 + t110);
        let t112 = t7 * lambda[0];
        let t113 = t112 * k4;
        let t114 = t33 * lambda[2] + (t13 * lambda[0] + t26 * lambda[1]);
        let t115 = t114 * k4;
        let t116 = t7 * lambda[2];
        let t117 = t116 * k4;
        let t118 = t7 * lambda[1];
        let t119 = t118 * k4;
        let t120 = -(t13 * t113) - t7 * t115 + (-(t33 * t117) - t26 * t119);
        let t121 = t6 * lambda[0];
        let t122 = t121 * k4;
        let t123 = t32 * lambda[2] + (t12 * lambda[0] + t25 * lambda[1]);
        let t124 = t123 * k4;
        let t125 = t6 * lambda[2];
        let t126 = t125 * k4;
        let t127 = t6 * lambda[1];
        let t128 = t127 * k4;
        let t129 = -(t12 * t122) - t6 * t124 + (-(t32 * t126) - t25 * t128);
        let t130 = -(t11 * t61) - t24 * t63 - t31 * t65;
        let t131 = h[1] * t103 - h[10] * t105 + (h[7] * t107 + h[4] * t109);
        let t132 = h[11] * t87;
        let t133 = t5 * t79;
        let t134 = t6 * t115;
        let t135 = t11 * k4;
        let t136 = t12 * t113;
        let t137 = t24 * k4;
        let t138 = t132 - t133 - t134 - t76 * t135 - t136 - t82 * t137;
        let t139 = t25 * t119;
        let t140 = t31 * k4;
        let t141 = t32 * t117;
        let t142 = h[2] * t85;
        let t143 = h[5] * t91;
        let t144 = h[8] * t89;
        let t145 = t138 - t139 - t80 * t140 - t141 - t142 - t143 - t144;
        let t146 = t33 * t126 + (t26 * t128 + (t13 * t122 + (t7 * t124 + t145)));
        let t147 = t120 + (-t110 - t104 + (t106 - t108));
        let t148 = t129 + (-t92 - t86 + (t88 - t90));
        let t149 = t5 * lambda[0];
        let t150 = t31 * lambda[2] + (t11 * lambda[0] + t24 * lambda[1]);
        let t151 = t150 * k4;
        let t152 = t5 * lambda[2];
        let t153 = t5 * lambda[1];
        let t154 = -(t135 * t149) - t5 * t151 + (-(t140 * t152) - t137 * t153);
        let t155 = t14 * t113 + t8 * t115 + (t34 * t117 + t27 * t119);
        let t156 = h[2] * t94 - h[11] * t96 + (h[8] * t98 + h[5] * t100);
        let t157 = -(t121 * t135) - t5 * t124 + (-(t125 * t140) - t127 * t137);
        let t158 = t155 + (t156 + t157);
        let t159 = h[9] * t105;
        let t160 = t159 - t7 * t79 - t13 * t77 - t26 * t83 - t33 * t81;
        let t161 = h[0] * t103;
        let t162 = h[3] * t109;
        let t163 = h[6] * t107;
        let t164 = h[0] * t85 - h[9] * t87 + (h[6] * t89 + h[3] * t91);
        let t165 = t34 * t126;
        let t166 = t27 * t128;
        let t167 = t14 * t122;
        let t168 = t8 * t124;
        let t169 = t5 * t115;
        let t170 = h[7] * t98;
        let t171 = h[4] * t100;
        let t172 = h[1] * t94;
        let t173 = t149 * k4;
        let t174 = t153 * k4;
        let t175 = t152 * k4;
        let t176 = t172 - t7 * t151 - t13 * t173 - t26 * t174 - t33 * t175;
        let t177 = h[10] * t96;
        let t178 = t11 * t113 + (t168 + (t169 + (t170 + (t171 + (t176 - t177)))));
        let t179 = t165 + (t31 * t117 + (t166 + (t24 * t119 + (t167 + t178))));
        let t180 = t154 + (-t101 - t95 + (t97 - t99));
        let t181 = t32 * k4;
        let t182 = t25 * k4;
        let t183 = t12 * k4;
        let t184 = t164 - t169 - t168 - t112 * t135 - t167 - t118 * t137;
        let t185 = t184 - t166 - t116 * t140 - t165 - t172 - t171 - t170;
        let t186 = t82 * t182 + (t76 * t183 + (t6 * t79 + (t177 + t185)));
        let t187 = t149 * t183 + (t6 * t151 + (t163 + (t162 + (t161 + (t158 - t159)))));
        let t188 = t131 - t8 * t151 - t14 * t173 - t27 * t174 - t34 * t175;
        let t189 = t11 * t76 * k4
            + (t134 + (t133 + (t144 + (t143 + (t142 + (t188 - t132))))));
        let t190 = t31 * t80 * k4 + (t139 + (t24 * t82 * k4 + (t136 + t189)));
        let t191 = t78 * two;
        let t192 = t150 * two;
        let t193 = t114 * two;
        let t194 = t123 * two;
        let t195 = t3 * t79;
        let t196 = t2 * t115;
        let t197 = t1 * t124;
        let t198 = t196 + t197;
        let t199 = t2 * t124;
        let t200 = t3 * t151;
        let t201 = t1 * t115;
        let t202 = t200 - t201;
        let t203 = t3 * t115;
        let t204 = t1 * t151;
        let t205 = t2 * t79;
        let t206 = t204 - t205;
        let t207 = t1 * t79;
        let t208 = t2 * t151;
        let t209 = t3 * t124;
        let t210 = t208 - t209;
        let t211 = h[12] * t96;
        let t212 = h[14] * t105;
        let t213 = h[13] * t87;
        let t214 = t0 * t79;
        let t215 = t214 - t199;
        let t216 = t0 * t151;
        let t217 = t0 * t115;
        let t218 = t217 - t207;
        let t219 = t0 * t124;
        let t220 = h[13] * t105;
        let t221 = h[14] * t87;
        let t222 = t219 - t203;
        let t223 = t195 + t216;
        let t224 = h[14] * t96;
        let t225 = h[12] * t105;
        let t226 = h[13] * t96;
        let t227 = h[12] * t87;
        let t228 = t213 - t212;
        phi[0] = t10 * t15 + (t18 * t19 + t22 * t23);
        phi[1] = t10 * t28 + (t18 * t29 + t22 * t30);
        phi[2] = t10 * t35 + (t18 * t36 + t22 * t37);
        phi_q[0] = -t19;
        phi_q[1] = -t23;
        phi_q[2] = -t15;
        phi_q[3] = t13 * t38 + (t12 * t39 + t44);
        phi_q[4] = t12 * t38 + (t11 * t40 + t46);
        phi_q[5] = t11 * t39 + (t13 * t40 + t47);
        phi_q[6] = t11 * t38 + (t14 * t39 + t48);
        phi_q[7] = t19;
        phi_q[8] = t23;
        phi_q[9] = t15;
        phi_q[10] = t15 * t49 + (t19 * t50 + t23 * t51);
        phi_q[11] = t15 * t51 + (t19 * t52 - t23 * t49);
        phi_q[12] = t19 * t49 + (t23 * t52 - t15 * t50);
        phi_q[13] = t23 * t50 + (t15 * t52 - t19 * t51);
        phi_q[14] = -t29;
        phi_q[15] = -t30;
        phi_q[16] = -t28;
        phi_q[17] = t26 * t38 + (t25 * t39 + t53);
        phi_q[18] = t25 * t38 + (t24 * t40 + t54);
        phi_q[19] = t24 * t39 + (t26 * t40 + t55);
        phi_q[20] = t24 * t38 + (t27 * t39 + t56);
        phi_q[21] = t29;
        phi_q[22] = t30;
        phi_q[23] = t28;
        phi_q[24] = t28 * t49 + (t29 * t50 + t30 * t51);
        phi_q[25] = t28 * t51 + (t29 * t52 - t30 * t49);
        phi_q[26] = t29 * t49 + (t30 * t52 - t28 * t50);
        phi_q[27] = t30 * t50 + (t28 * t52 - t29 * t51);
        phi_q[28] = -t36;
        phi_q[29] = -t37;
        phi_q[30] = -t35;
        phi_q[31] = t33 * t38 + (t32 * t39 + t57);
        phi_q[32] = t32 * t38 + (t31 * t40 + t58);
        phi_q[33] = t31 * t39 + (t33 * t40 + t59);
        phi_q[34] = t31 * t38 + (t34 * t39 + t60);
        phi_q[35] = t36;
        phi_q[36] = t37;
        phi_q[37] = t35;
        phi_q[38] = t35 * t49 + (t36 * t50 + t37 * t51);
        phi_q[39] = t35 * t51 + (t36 * t52 - t37 * t49);
        phi_q[40] = t36 * t49 + (t37 * t52 - t35 * t50);
        phi_q[41] = t37 * t50 + (t35 * t52 - t36 * t51);
        curvature[0] = t67;
        curvature[1] = t71;
        curvature[2] = t75;
        curvature[3] = t93 + (t102 + (t111 + (t120 + t129)));
        curvature[4] = t130;
        curvature[5] = t74 + (t72 + t73);
        curvature[6] = t71;
        curvature[7] = t131 + t146;
        curvature[8] = t147 + (t148 + (t102 + t154));
        curvature[9] = t75;
        curvature[10] = t130;
        curvature[11] = t66 + (t62 + t64);
        curvature[12] = t158 + (t160 - t161 - t162 - t163);
        curvature[13] = t164 + t179;
        curvature[14] = t180 + (t93 + t147);
        curvature[15] = t70 + (t68 + t69);
        curvature[16] = t67;
        curvature[17] = t130;
        curvature[18] = t80 * t181 + t186;
        curvature[19] = t152 * t181 + (t153 * t182 + t187);
        curvature[20] = t141 + t190;
        curvature[21] = t180 + (t148 + (t111 + t84));
        curvature[22] = t191;
        curvature[23] = t192;
        curvature[24] = t193;
        curvature[25] = -t194;
        curvature[26] = t194;
        curvature[27] = -t193;
        curvature[28] = t192;
        curvature[29] = t191;
        curvature[30] = t193;
        curvature[31] = t194;
        curvature[32] = -t191;
        curvature[33] = t192;
        curvature[34] = t195 + t198;
        curvature[35] = t199 + t202;
        curvature[36] = t203 + t206;
        curvature[37] = t207 + t210;
        curvature[38] = t211 + (t212 + t213);
        curvature[39] = t201 + t215;
        curvature[40] = t198 + t216;
        curvature[41] = t218 - t208;
        curvature[42] = t206 - t219;
        curvature[43] = t220 - t221;
        curvature[44] = t211 - t212 - t213;
        curvature[45] = t205 + t222;
        curvature[46] = t210 - t217;
        curvature[47] = t196 + t223;
        curvature[48] = t215 - t200;
        curvature[49] = t224 - t225;
        curvature[50] = t226 + t227;
        curvature[51] = t228 - t211;
        curvature[52] = t209 + t218;
        curvature[53] = t222 - t204;
        curvature[54] = t202 - t214;
        curvature[55] = t197 + t223;
        curvature[56] = t227 - t226;
        curvature[57] = t225 + t224;
        curvature[58] = t221 + t220;
        curvature[59] = -t228 - t211;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 619 additions, 920 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 15],
        lambda: &[S; 3],
        phi_h: &mut [S; 27],
        force_h: &mut [S; 162],
    ) {
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_j[4] * h[13] + (q_j[3] * h[14] - h[12] * q_j[5]);
        let t1 = h[14] * q_j[6] + (h[12] * q_j[4] + q_j[5] * h[13]);
        let t2 = q_j[5] * h[14] + (h[12] * q_j[3] - h[13] * q_j[6]);
        let t3 = h[12] * q_j[6] + (q_j[3] * h[13] - h[14] * q_j[4]);
        let t4 = q_j[5] * t0 + (q_j[4] * t1 + (q_j[3] * t2 - q_j[6] * t3));
        let t5 = q_i[4] * h[10] + (q_i[3] * h[11] - q_i[5] * h[9]);
        let t6 = q_i[6] * h[11] + (q_i[4] * h[9] + q_i[5] * h[10]);
        let t7 = q_i[5] * h[11] + (q_i[3] * h[9] - q_i[6] * h[10]);
        let t8 = q_i[6] * h[9] + (q_i[3] * h[10] - q_i[4] * h[11]);
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
        let t30 = t10 * t15 + (t18 * t22 + t25 * t29);
        let t31 = t11 - t12;
        let t32 = t14 - t13;
        let t33 = t31 + t32;
        let t34 = t17 - t16;
        let t35 = t10 * two;
        let t36 = q_i[3] * q_i[4];
        let t37 = q_i[6] * q_i[5];
        let t38 = t36 + t37;
        let t39 = t21 * t33 + (t34 * t35 + t29 * t38);
        let t40 = t31 - t32;
        let t41 = t24 + t23;
        let t42 = t37 - t36;
        let t43 = t28 * t40 + (t35 * t41 + t22 * t42);
        let t44 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t45 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t46 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t47 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t48 = q_i[6] * t44 + (q_i[5] * t45 + (q_i[3] * t46 - q_i[4] * t47));
        let t49 = t18 * two;
        let t50 = q_i[6] * t45 + (q_i[4] * t46 + (q_i[3] * t47 - q_i[5] * t44));
        let t51 = t25 * two;
        let t52 = q_i[5] * t47 + (q_i[4] * t45 + (q_i[3] * t44 - q_i[6] * t46));
        let t53 = t34 * two;
        let t54 = t38 * two;
        let t55 = t41 * two;
        let t56 = t42 * two;
        let t57 = q_j[3] * q_j[3];
        let t58 = q_j[4] * q_j[4];
        let t59 = q_j[6] * q_j[6];
        let t60 = q_j[5] * q_j[5];
        let t61 = t57 + t58 - t59 - t60;
        let t62 = q_j[3] * q_j[6];
        let t63 = q_j[5] * q_j[4];
        let t64 = t62 + t63;
        let t65 = t64 * two;
        let t66 = q_j[4] * q_j[6];
        let t67 = q_j[5] * q_j[3];
        let t68 = t66 - t67;
        let t69 = t68 * two;
        let t70 = t57 - t58;
        let t71 = t60 - t59;
        let t72 = t70 + t71;
        let t73 = t63 - t62;
        let t74 = t73 * two;
        let t75 = q_j[3] * q_j[4];
        let t76 = q_j[5] * q_j[6];
        let t77 = t75 + t76;
        let t78 = t77 * two;
        let t79 = t70 - t71;
        let t80 = t67 + t66;
        let t81 = t80 * two;
        let t82 = t76 - t75;
        let t83 = t82 * two;
        let t84 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t85 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t86 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t87 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t88 = q_i[6] * t84 + (q_i[5] * t85 + (q_i[3] * t86 - q_i[4] * t87));
        let t89 = q_i[6] * t85 + (q_i[4] * t86 + (q_i[3] * t87 - q_i[5] * t84));
        let t90 = q_i[5] * t87 + (q_i[4] * t85 + (q_i[3] * t84 - q_i[6] * t86));
        let t91 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t92 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t93 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t94 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t95 = q_i[6] * t91 + (q_i[5] * t92 + (q_i[3] * t93 - q_i[4] * t94));
        let t96 = q_i[6] * t92 + (q_i[4] * t93 + (q_i[3] * t94 - q_i[5] * t91));
        let t97 = q_i[5] * t94 + (q_i[4] * t92 + (q_i[3] * t91 - q_i[6] * t93));
        let t98 = t15 * lambda[0];
        let t99 = t34 * lambda[0];
        let t100 = t99 * two;
        let t101 = t41 * lambda[0];
        let t102 = t101 * two;
        let t103 = t15 * lambda[1];
        let t104 = t34 * lambda[1];
        let t105 = t104 * two;
        let t106 = t41 * lambda[1];
        let t107 = t106 * two;
        let t108 = t15 * lambda[2];
        let t109 = t34 * lambda[2];
        let t110 = t109 * two;
        let t111 = t41 * lambda[2];
        let t112 = t111 * two;
        let t113 = t18 * lambda[0];
        let t114 = t113 * two;
        let t115 = t33 * lambda[0];
        let t116 = t42 * lambda[0];
        let t117 = t116 * two;
        let t118 = t18 * lambda[1];
        let t119 = t118 * two;
        let t120 = t33 * lambda[1];
        let t121 = t42 * lambda[1];
        let t122 = t121 * two;
        let t123 = t18 * lambda[2];
        let t124 = t123 * two;
        let t125 = t33 * lambda[2];
        let t126 = t42 * lambda[2];
        let t127 = t126 * two;
        let t128 = t25 * lambda[0];
        let t129 = t128 * two;
        let t130 = t38 * lambda[0];
        let t131 = t130 * two;
        let t132 = t40 * lambda[0];
        let t133 = t25 * lambda[1];
        let t134 = t133 * two;
        let t135 = t38 * lambda[1];
        let t136 = t135 * two;
        let t137 = t40 * lambda[1];
        let t138 = t25 * lambda[2];
        let t139 = t138 * two;
        let t140 = t38 * lambda[2];
        let t141 = t140 * two;
        let t142 = t40 * lambda[2];
        let t143 = t21 * lambda[0];
        let t144 = q_i[6] * two;
        let t145 = t143 * t144;
        let t146 = t10 * lambda[0];
        let t147 = q_i[3] * two;
        let t148 = t146 * t147;
        let t149 = t28 * lambda[0];
        let t150 = q_i[5] * two;
        let t151 = t149 * t150;
        let t152 = t145 + (t148 - t151);
        let t153 = t8 * k4;
        let t154 = t5 * k4;
        let t155 = t98 * two;
        let t156 = q_i[4] * two;
        let t157 = t149 * t156;
        let t158 = t143 * t147;
        let t159 = t144 * t146;
        let t160 = t157 + (t158 - t159);
        let t161 = t7 * k4;
        let t162 = t115 * two;
        let t163 = t146 * t150;
        let t164 = t147 * t149;
        let t165 = t143 * t156;
        let t166 = t163 + (t164 - t165);
        let t167 = t132 * two;
        let t168 = t21 * lambda[1];
        let t169 = t144 * t168;
        let t170 = t10 * lambda[1];
        let t171 = t147 * t170;
        let t172 = t28 * lambda[1];
        let t173 = t150 * t172;
        let t174 = t169 + (t171 - t173);
        let t175 = t103 * two;
        let t176 = t156 * t172;
        let t177 = t147 * t168;
        let t178 = t144 * t170;
        let t179 = t176 + (t177 - t178);
        let t180 = t120 * two;
        let t181 = t150 * t170;
        let t182 = t147 * t172;
        let t183 = t156 * t168;
        let t184 = t181 + (t182 - t183);
        let t185 = t137 * two;
        let t186 = t21 * lambda[2];
        let t187 = t144 * t186;
        let t188 = t10 * lambda[2];
        let t189 = t147 * t188;
        let t190 = t28 * lambda[2];
        let t191 = t150 * t190;
        let t192 = t187 + (t189 - t191);
        let t193 = t108 * two;
        let t194 = t156 * t190;
        let t195 = t147 * t186;
        let t196 = t144 * t188;
        let t197 = t194 + (t195 - t196);
        let t198 = t125 * two;
        let t199 = t150 * t188;
        let t200 = t147 * t190;
        let t201 = t156 * t186;
        let t202 = t199 + (t200 - t201);
        let t203 = t142 * two;
        let t204 = t96 * lambda[2] + (t50 * lambda[0] + t89 * lambda[1]);
        let t205 = t150 * t204;
        let t206 = t95 * lambda[2] + (t48 * lambda[0] + t88 * lambda[1]);
        let t207 = t144 * t206;
        let t208 = t97 * lambda[2] + (t52 * lambda[0] + t90 * lambda[1]);
        let t209 = t147 * t208;
        let t210 = t205 + (-t207 - t209);
        let t211 = t113 * k4;
        let t212 = t128 * k4;
        let t213 = t118 * k4;
        let t214 = t133 * k4;
        let t215 = t210 - t46 * t211 - t47 * t212 - t86 * t213 - t87 * t214;
        let t216 = t123 * k4;
        let t217 = t138 * k4;
        let t218 = t215 - t93 * t216 - t94 * t217 - t44 * t155 - t84 * t175;
        let t219 = t144 * t208;
        let t220 = t156 * t204;
        let t221 = t147 * t206;
        let t222 = t219 + (-t220 - t221);
        let t223 = t99 * k4;
        let t224 = t130 * k4;
        let t225 = t104 * k4;
        let t226 = t135 * k4;
        let t227 = t222 - t44 * t223 - t47 * t224 - t84 * t225 - t87 * t226;
        let t228 = t109 * k4;
        let t229 = t140 * k4;
        let t230 = t227 - t91 * t228 - t94 * t229 - t46 * t162 - t86 * t180;
        let t231 = t156 * t206;
        let t232 = t150 * t208;
        let t233 = t147 * t204;
        let t234 = t231 + (-t232 - t233);
        let t235 = t101 * k4;
        let t236 = t116 * k4;
        let t237 = t106 * k4;
        let t238 = t121 * k4;
        let t239 = t234 - t44 * t235 - t46 * t236 - t84 * t237 - t86 * t238;
        let t240 = t111 * k4;
        let t241 = t126 * k4;
        let t242 = t239 - t91 * t240 - t93 * t241 - t47 * t167 - t87 * t185;
        let t243 = t68 * lambda[2];
        let t244 = t94 * k4;
        let t245 = t64 * lambda[2];
        let t246 = t93 * k4;
        let t247 = t68 * lambda[1];
        let t248 = t87 * k4;
        let t249 = t64 * lambda[1];
        let t250 = t86 * k4;
        let t251 = t68 * lambda[0];
        let t252 = t47 * k4;
        let t253 = t64 * lambda[0];
        let t254 = t46 * k4;
        let t255 = t61 * lambda[2];
        let t256 = t255 * two;
        let t257 = t61 * lambda[0];
        let t258 = t257 * two;
        let t259 = t61 * lambda[1];
        let t260 = t259 * two;
        let t261 = t253 * t254 + (t91 * t256 + (t44 * t258 + t84 * t260));
        let t262 = t245 * t246 + (t247 * t248 + (t249 * t250 + (t251 * t252 + t261)));
        let t263 = t77 * lambda[2];
        let t264 = t73 * lambda[2];
        let t265 = t91 * k4;
        let t266 = t77 * lambda[1];
        let t267 = t73 * lambda[1];
        let t268 = t84 * k4;
        let t269 = t77 * lambda[0];
        let t270 = t73 * lambda[0];
        let t271 = t44 * k4;
        let t272 = t72 * lambda[2];
        let t273 = t272 * two;
        let t274 = t72 * lambda[0];
        let t275 = t274 * two;
        let t276 = t72 * lambda[1];
        let t277 = t276 * two;
        let t278 = t270 * t271 + (t93 * t273 + (t46 * t275 + t86 * t277));
        let t279 = t264 * t265 + (t248 * t266 + (t267 * t268 + (t252 * t269 + t278)));
        let t280 = t82 * lambda[2];
        let t281 = t80 * lambda[2];
        let t282 = t82 * lambda[1];
        let t283 = t80 * lambda[1];
        let t284 = t82 * lambda[0];
        let t285 = t80 * lambda[0];
        let t286 = t79 * lambda[2];
        let t287 = t286 * two;
        let t288 = t79 * lambda[0];
        let t289 = t288 * two;
        let t290 = t79 * lambda[1];
        let t291 = t290 * two;
        let t292 = t271 * t285 + (t94 * t287 + (t47 * t289 + t87 * t291));
        let t293 = t265 * t281 + (t250 * t282 + (t268 * t283 + (t254 * t284 + t292)));
        let t294 = t144 * t149 + (t143 * t150 + t146 * t156);
        let t295 = t6 * two;
        let t296 = t6 * k4;
        let t297 = t144 * t172 + (t150 * t168 + t156 * t170);
        let t298 = t144 * t190 + (t150 * t186 + t156 * t188);
        let t299 = -(t150 * t206) - t156 * t208 - t144 * t204;
        let t300 = t113 * t252 - t46 * t212 - t86 * t214 - t93 * t217;
        let t301 = t118 * t248 + (t300 - t45 * t155 - t85 * t175 - t92 * t193);
        let t302 = t234 - t45 * t223 - t46 * t224 - t85 * t225 - t86 * t226;
        let t303 = t87 * t180 + (t47 * t162 + (t302 - t92 * t228 - t93 * t229));
        let t304 = t221 - t45 * t235 - t85 * t237 - t92 * t240 - t219;
        let t305 = t220 + (t304 - t46 * t167 - t86 * t185 - t93 * t203);
        let t306 = t45 * t258 - t253 * t252 - t249 * t248 - t245 * t244;
        let t307 = t250 * t247 + (t254 * t251 + (t92 * t256 + (t85 * t260 + t306)));
        let t308 = t92 * k4;
        let t309 = t85 * k4;
        let t310 = t45 * k4;
        let t311 = t270 * t310 - t47 * t274 * two - t87 * t276 * two;
        let t312 = t267 * t309 + (t254 * t269 + (t311 - t94 * t272 * two));
        let t313 = t46 * t289 - t252 * t284 - t248 * t282 - t244 * t280;
        let t314 = t283 * t309 + (t285 * t310 + (t93 * t287 + (t86 * t291 + t313)));
        let t315 = t233 - t45 * t211 - t85 * t213 - t92 * t216 - t231;
        let t316 = t232 + (t315 - t47 * t155 - t87 * t175 - t94 * t193);
        let t317 = t299 - t47 * t223 - t87 * t225 - t94 * t228 - t45 * t162;
        let t318 = t135 * t268 + (t130 * t271 + (t317 - t85 * t180 - t92 * t198));
        let t319 = t210 - t45 * t236 - t47 * t235 - t85 * t238 - t87 * t237;
        let t320 = t84 * t185 + (t44 * t167 + (t319 - t92 * t241 - t94 * t240));
        let t321 = t47 * t258 - t251 * t271 - t247 * t268 - t243 * t265;
        let t322 = t249 * t309 + (t253 * t310 + (t94 * t256 + (t87 * t260 + t321)));
        let t323 = t45 * t275 - t271 * t269 - t268 * t266 - t265 * t263;
        let t324 = t248 * t267 + (t252 * t270 + (t92 * t273 + (t85 * t277 + t323)));
        let t325 = t284 * t310 - t44 * t288 * two - t84 * t290 * two;
        let t326 = t282 * t309 + (t252 * t285 + (t325 - t91 * t286 * two));
        let t327 = t222 - t45 * t212 - t44 * t211 - t85 * t214 - t84 * t213;
        let t328 = t86 * t175 + (t46 * t155 + (t327 - t92 * t217 - t91 * t216));
        let t329 = t209 - t45 * t224 - t85 * t226 - t92 * t229 - t205;
        let t330 = t207 + (t329 - t44 * t162 - t84 * t180 - t91 * t198);
        let t331 = t299 - t44 * t236 - t84 * t238 - t91 * t241 - t45 * t167;
        let t332 = t106 * t250 + (t101 * t254 + (t331 - t85 * t185 - t92 * t203));
        let t333 = t251 * t310 - t46 * t257 * two - t86 * t259 * two;
        let t334 = t247 * t309 + (t253 * t271 + (t333 - t93 * t255 * two));
        let t335 = t44 * t275 - t254 * t270 - t250 * t267 - t246 * t264;
        let t336 = t266 * t309 + (t269 * t310 + (t91 * t273 + (t84 * t277 + t335)));
        let t337 = t45 * t289 - t254 * t285 - t250 * t283 - t246 * t281;
        let t338 = t268 * t282 + (t271 * t284 + (t92 * t287 + (t85 * t291 + t337)));
        let t339 = t0 * k4;
        let t340 = t2 * two;
        let t341 = t3 * k4;
        let t342 = t3 * two;
        let t343 = t2 * k4;
        let t344 = t0 * two;
        let t345 = t206 * two;
        let t346 = q_j[6] * t345;
        let t347 = t208 * two;
        let t348 = t204 * two;
        let t349 = q_j[3] * t347 - q_j[5] * t348;
        let t350 = t346 + t349;
        let t351 = q_j[4] * t348;
        let t352 = q_j[3] * t345 - q_j[6] * t347;
        let t353 = t351 + t352;
        let t354 = q_j[5] * t347;
        let t355 = q_j[3] * t348 - q_j[4] * t345;
        let t356 = t354 + t355;
        let t357 = t1 * two;
        let t358 = t1 * k4;
        let t359 = q_j[6] * t348 + (q_j[4] * t347 + q_j[5] * t345);
        phi_h[0] = t30;
        phi_h[1] = t39;
        phi_h[2] = t43;
        phi_h[3] = -(t48 * t49) - t50 * t51 - t15 * t52;
        phi_h[4] = -(t52 * t53) - t50 * t54 - t33 * t48;
        phi_h[5] = -(t52 * t55) - t48 * t56 - t40 * t50;
        phi_h[6] = t52 * t61 + (t48 * t65 + t50 * t69);
        phi_h[7] = t48 * t72 + (t52 * t74 + t50 * t78);
        phi_h[8] = t50 * t79 + (t52 * t81 + t48 * t83);
        phi_h[9] = t30;
        phi_h[10] = t39;
        phi_h[11] = t43;
        phi_h[12] = -(t49 * t88) - t51 * t89 - t15 * t90;
        phi_h[13] = -(t53 * t90) - t54 * t89 - t33 * t88;
        phi_h[14] = -(t55 * t90) - t56 * t88 - t40 * t89;
        phi_h[15] = t61 * t90 + (t65 * t88 + t69 * t89);
        phi_h[16] = t72 * t88 + (t74 * t90 + t78 * t89);
        phi_h[17] = t79 * t89 + (t81 * t90 + t83 * t88);
        phi_h[18] = t30;
        phi_h[19] = t39;
        phi_h[20] = t43;
        phi_h[21] = -(t49 * t95) - t51 * t96 - t15 * t97;
        phi_h[22] = -(t53 * t97) - t54 * t96 - t33 * t95;
        phi_h[23] = -(t55 * t97) - t56 * t95 - t40 * t96;
        phi_h[24] = t61 * t97 + (t65 * t95 + t69 * t96);
        phi_h[25] = t72 * t95 + (t74 * t97 + t78 * t96);
        phi_h[26] = t79 * t96 + (t81 * t97 + t83 * t95);
        force_h[0] = -t98;
        force_h[1] = -t100;
        force_h[2] = -t102;
        force_h[3] = -t103;
        force_h[4] = -t105;
        force_h[5] = -t107;
        force_h[6] = -t108;
        force_h[7] = -t110;
        force_h[8] = -t112;
        force_h[9] = -t114;
        force_h[10] = -t115;
        force_h[11] = -t117;
        force_h[12] = -t119;
        force_h[13] = -t120;
        force_h[14] = -t122;
        force_h[15] = -t124;
        force_h[16] = -t125;
        force_h[17] = -t127;
        force_h[18] = -t129;
        force_h[19] = -t131;
        force_h[20] = -t132;
        force_h[21] = -t134;
        force_h[22] = -t136;
        force_h[23] = -t137;
        force_h[24] = -t139;
        force_h[25] = -t141;
        force_h[26] = -t142;
        force_h[27] = t152 - t113 * t153 - t128 * t154 - t7 * t155;
        force_h[28] = t160 - t99 * t161 - t130 * t154 - t8 * t162;
        force_h[29] = t166 - t101 * t161 - t116 * t153 - t5 * t167;
        force_h[30] = t174 - t118 * t153 - t133 * t154 - t7 * t175;
        force_h[31] = t179 - t104 * t161 - t135 * t154 - t8 * t180;
        force_h[32] = t184 - t106 * t161 - t121 * t153 - t5 * t185;
        force_h[33] = t192 - t123 * t153 - t138 * t154 - t7 * t193;
        force_h[34] = t197 - t109 * t161 - t140 * t154 - t8 * t198;
        force_h[35] = t202 - t111 * t161 - t126 * t153 - t5 * t203;
        force_h[36] = t218 - t91 * t193;
        force_h[37] = t230 - t93 * t198;
        force_h[38] = t242 - t94 * t203;
        force_h[39] = t243 * t244 + t262;
        force_h[40] = t244 * t263 + t279;
        force_h[41] = t246 * t280 + t293;
        force_h[42] = t294 + (t113 * t154 - t128 * t153 - t98 * t295);
        force_h[43] = t5 * t162 + (t166 - t99 * t296 - t130 * t153);
        force_h[44] = t116 * t154 + (t159 - t101 * t296 - t158 - t157 - t8 * t167);
        force_h[45] = t297 + (t118 * t154 - t133 * t153 - t103 * t295);
        force_h[46] = t5 * t180 + (t184 - t104 * t296 - t135 * t153);
        force_h[47] = t121 * t154 + (t178 - t106 * t296 - t177 - t176 - t8 * t185);
        force_h[48] = t298 + (t123 * t154 - t138 * t153 - t108 * t295);
        force_h[49] = t5 * t198 + (t202 - t109 * t296 - t140 * t153);
        force_h[50] = t126 * t154 + (t196 - t111 * t296 - t195 - t194 - t8 * t203);
        force_h[51] = t299 + (t123 * t244 + t301);
        force_h[52] = t94 * t198 + t303;
        force_h[53] = t126 * t244 + (t121 * t248 + (t116 * t252 + t305));
        force_h[54] = t246 * t243 + t307;
        force_h[55] = t246 * t263 + (t264 * t308 + (t250 * t266 + t312));
        force_h[56] = t281 * t308 + t314;
        force_h[57] = t128 * t161 + (t165 - t113 * t296 - t164 - t163 - t5 * t155);
        force_h[58] = t130 * t161 + (t294 - t99 * t154 - t115 * t295);
        force_h[59] = t7 * t167 + (t152 - t116 * t296 - t101 * t154);
        force_h[60] = t133 * t161 + (t183 - t118 * t296 - t182 - t181 - t5 * t175);
        force_h[61] = t135 * t161 + (t297 - t104 * t154 - t120 * t295);
        force_h[62] = t7 * t185 + (t174 - t121 * t296 - t106 * t154);
        force_h[63] = t138 * t161 + (t201 - t123 * t296 - t200 - t199 - t5 * t193);
        force_h[64] = t140 * t161 + (t298 - t109 * t154 - t125 * t295);
        force_h[65] = t7 * t203 + (t192 - t126 * t296 - t111 * t154);
        force_h[66] = t138 * t265 + (t133 * t268 + (t128 * t271 + t316));
        force_h[67] = t140 * t265 + t318;
        force_h[68] = t91 * t203 + t320;
        force_h[69] = t245 * t308 + t322;
        force_h[70] = t244 * t264 + t324;
        force_h[71] = t244 * t281 + (t280 * t308 + (t248 * t283 + t326));
        force_h[72] = t8 * t155 + (t160 - t128 * t296 - t113 * t161);
        force_h[73] = t99 * t153 + (t151 - t130 * t296 - t148 - t145 - t7 * t162);
        force_h[74] = t101 * t153 + (t294 - t116 * t161 - t132 * t295);
        force_h[75] = t8 * t175 + (t179 - t133 * t296 - t118 * t161);
        force_h[76] = t104 * t153 + (t173 - t135 * t296 - t171 - t169 - t7 * t180);
        force_h[77] = t106 * t153 + (t297 - t121 * t161 - t137 * t295);
        force_h[78] = t8 * t193 + (t197 - t138 * t296 - t123 * t161);
        force_h[79] = t109 * t153 + (t191 - t140 * t296 - t189 - t187 - t7 * t198);
        force_h[80] = t111 * t153 + (t298 - t126 * t161 - t142 * t295);
        force_h[81] = t93 * t193 + t328;
        force_h[82] = t109 * t246 + (t104 * t250 + (t99 * t254 + t330));
        force_h[83] = t111 * t246 + t332;
        force_h[84] = t245 * t265 + (t243 * t308 + (t249 * t268 + t334));
        force_h[85] = t263 * t308 + t336;
        force_h[86] = t265 * t280 + t338;
        force_h[87] = t98;
        force_h[88] = t100;
        force_h[89] = t102;
        force_h[90] = t103;
        force_h[91] = t105;
        force_h[92] = t107;
        force_h[93] = t108;
        force_h[94] = t110;
        force_h[95] = t112;
        force_h[96] = t114;
        force_h[97] = t115;
        force_h[98] = t117;
        force_h[99] = t119;
        force_h[100] = t120;
        force_h[101] = t122;
        force_h[102] = t124;
        force_h[103] = t125;
        force_h[104] = t127;
        force_h[105] = t129;
        force_h[106] = t131;
        force_h[107] = t132;
        force_h[108] = t134;
        force_h[109] = t136;
        force_h[110] = t137;
        force_h[111] = t139;
        force_h[112] = t141;
        force_h[113] = t142;
        force_h[114] = t128 * t339 + (t98 * t340 + t113 * t341);
        force_h[115] = t130 * t339 + (t115 * t342 + t99 * t343);
        force_h[116] = t116 * t341 + (t132 * t344 + t101 * t343);
        force_h[117] = t133 * t339 + (t103 * t340 + t118 * t341);
        force_h[118] = t135 * t339 + (t120 * t342 + t104 * t343);
        force_h[119] = t121 * t341 + (t137 * t344 + t106 * t343);
        force_h[120] = t138 * t339 + (t108 * t340 + t123 * t341);
        force_h[121] = t140 * t339 + (t125 * t342 + t109 * t343);
        force_h[122] = t126 * t341 + (t142 * t344 + t111 * t343);
        force_h[123] = t350;
        force_h[124] = t353;
        force_h[125] = t356;
        force_h[126] = t128 * t341 + (t98 * t357 - t0 * t211);
        force_h[127] = t130 * t341 + (t99 * t358 - t0 * t162);
        force_h[128] = t101 * t358 + (t132 * t342 - t0 * t236);
        force_h[129] = t133 * t341 + (t103 * t357 - t0 * t213);
        force_h[130] = t135 * t341 + (t104 * t358 - t0 * t180);
        force_h[131] = t106 * t358 + (t137 * t342 - t0 * t238);
        force_h[132] = t138 * t341 + (t108 * t357 - t0 * t216);
        force_h[133] = t140 * t341 + (t109 * t358 - t0 * t198);
        force_h[134] = t111 * t358 + (t142 * t342 - t0 * t241);
        force_h[135] = t359;
        force_h[136] = t356;
        force_h[137] = -t352 - t351;
        force_h[138] = t113 * t358 + (t98 * t344 - t2 * t212);
        force_h[139] = t99 * t339 + (t115 * t357 - t2 * t224);
        force_h[140] = t101 * t339 + (t116 * t358 - t2 * t167);
        force_h[141] = t118 * t358 + (t103 * t344 - t2 * t214);
        force_h[142] = t104 * t339 + (t120 * t357 - t2 * t226);
        force_h[143] = t106 * t339 + (t121 * t358 - t2 * t185);
        force_h[144] = t123 * t358 + (t108 * t344 - t2 * t217);
        force_h[145] = t109 * t339 + (t125 * t357 - t2 * t229);
        force_h[146] = t111 * t339 + (t126 * t358 - t2 * t203);
        force_h[147] = -t355 - t354;
        force_h[148] = t359;
        force_h[149] = t350;
        force_h[150] = t113 * t343 + (t128 * t358 - t3 * t155);
        force_h[151] = t130 * t358 + (t115 * t340 - t3 * t223);
        force_h[152] = t116 * t343 + (t132 * t357 - t3 * t235);
        force_h[153] = t118 * t343 + (t133 * t358 - t3 * t175);
        force_h[154] = t135 * t358 + (t120 * t340 - t3 * t225);
        force_h[155] = t121 * t343 + (t137 * t357 - t3 * t237);
        force_h[156] = t123 * t343 + (t138 * t358 - t3 * t193);
        force_h[157] = t140 * t358 + (t125 * t340 - t3 * t228);
        force_h[158] = t126 * t343 + (t142 * t357 - t3 * t240);
        force_h[159] = t353;
        force_h[160] = -t349 - t346;
        force_h[161] = t359;
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 617 additions, 740 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        q_i: &[S; 7],
        q_j: &[S; 7],
        h: &[S; 15],
        v_i: &[S; 7],
        v_j: &[S; 7],
        rate_q: &mut [S; 42],
        rate_h: &mut [S; 27],
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
        let t14 = h[14] * q_j[6] + (q_j[4] * h[12] + h[13] * q_j[5]);
        let t15 = q_j[6] * h[12] + (q_j[3] * h[13] - h[14] * q_j[4]);
        let t16 = q_j[4] * h[13] + (h[14] * q_j[3] - h[12] * q_j[5]);
        let t17 = h[14] * v_j[6] + (h[12] * v_j[4] + h[13] * v_j[5]);
        let t18 = h[13] * v_j[3] + (h[12] * v_j[6] - h[14] * v_j[4]);
        let t19 = h[14] * v_j[3] + (h[13] * v_j[4] - h[12] * v_j[5]);
        let t20 = h[14] * v_j[5] + (h[12] * v_j[3] - h[13] * v_j[6]);
        let t21 = h[14] * q_j[5] + (q_j[3] * h[12] - h[13] * q_j[6]);
        let t22 = q_j[4] * t18 + (q_j[3] * t19 - q_j[5] * t20 - t21 * v_j[5]);
        let t23 = t14 * v_j[6] + (t15 * v_j[4] + (t16 * v_j[3] + (q_j[6] * t17 + t22)));
        let t24 = q_i[6] * h[11] + (q_i[4] * h[9] + q_i[5] * h[10]);
        let t25 = q_i[6] * h[9] + (q_i[3] * h[10] - q_i[4] * h[11]);
        let t26 = q_i[4] * h[10] + (q_i[3] * h[11] - q_i[5] * h[9]);
        let t27 = v_i[6] * h[11] + (v_i[4] * h[9] + v_i[5] * h[10]);
        let t28 = v_i[3] * h[10] + (v_i[6] * h[9] - v_i[4] * h[11]);
        let t29 = v_i[3] * h[11] + (v_i[4] * h[10] - v_i[5] * h[9]);
        let t30 = v_i[5] * h[11] + (v_i[3] * h[9] - v_i[6] * h[10]);
        let t31 = q_i[5] * h[11] + (q_i[3] * h[9] - q_i[6] * h[10]);
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
        let t50 = (q_j[2] + t48 - q_i[2] - t49) * two;
        let t51 = q_j[6] * t21 + (q_j[5] * t14 + (q_j[3] * t15 - q_j[4] * t16));
        let t52 = q_i[6] * t31 + (q_i[5] * t24 + (q_i[3] * t25 - q_i[4] * t26));
        let t53 = (q_j[1] + t51 - q_i[1] - t52) * two;
        let t54 = q_j[5] * t16 + (q_j[4] * t14 + (q_j[3] * t21 - q_j[6] * t15));
        let t55 = q_i[5] * t26 + (q_i[4] * t24 + (q_i[3] * t31 - q_i[6] * t25));
        let t56 = (q_j[0] + t54 - q_i[0] - t55) * two;
        let t57 = t9 * two;
        let t58 = t11 * two;
        let t59 = t13 * two;
        let t60 = t5 * t56 - t31 * t57 - t25 * t58 - t26 * t59;
        let t61 = q_i[5] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[6] * t7));
        let t62 = t61 * two;
        let t63 = q_i[6] * t2 + (q_i[5] * t1 + (q_i[3] * t7 - q_i[4] * t0));
        let t64 = t63 * two;
        let t65 = q_i[6] * t1 + (q_i[4] * t7 + (q_i[3] * t0 - q_i[5] * t2));
        let t66 = t65 * two;
        let t67 = t6 * t53 + (t60 - t30 * t62 - t28 * t64 - t29 * t66);
        let t68 = t24 * two;
        let t69 = t58 * t26 - t9 * t68 - t25 * t59 - t3 * t53;
        let t70 = t27 * two;
        let t71 = t4 * t56 + (t69 - t0 * t41 - t61 * t70 - t28 * t66);
        let t72 = t31 * t59 - t11 * t68 - t57 * t26 - t5 * t50;
        let t73 = t3 * t56 + (t72 - t2 * t35 - t62 * t29 - t63 * t70);
        let t74 = t57 * t25 - t13 * t68 - t31 * t58 - t6 * t56;
        let t75 = t5 * t53 + (t74 - t7 * t47 - t30 * t64 - t65 * t70);
        let t76 = t62 * t20 + (t59 * t16 + (t57 * t21 + t58 * t15));
        let t77 = t17 * two;
        let t78 = t14 * two;
        let t79 = t59 * t15 + (t9 * t78 - t58 * t16 - t64 * t19);
        let t80 = t57 * t16 + (t11 * t78 - t59 * t21 - t66 * t20);
        let t81 = t58 * t21 + (t13 * t78 - t57 * t15 - t62 * t18);
        let t82 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t83 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t84 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t85 = v_i[3] * h[5] + (v_i[4] * h[4] - v_i[5] * h[3]);
        let t86 = v_i[6] * h[5] + (v_i[4] * h[3] + v_i[5] * h[4]);
        let t87 = v_i[5] * h[5] + (v_i[3] * h[3] - v_i[6] * h[4]);
        let t88 = v_i[3] * h[4] + (v_i[6] * h[3] - v_i[4] * h[5]);
        let t89 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t90 = q_i[4] * t86 + (q_i[3] * t87 - q_i[6] * t88 - v_i[6] * t89);
        let t91 = v_i[5] * t82 + (v_i[4] * t83 + (v_i[3] * t84 + (q_i[5] * t85 + t90)));
        let t92 = q_i[5] * t86 + (q_i[3] * t88 - q_i[4] * t85 - v_i[4] * t82);
        let t93 = v_i[6] * t84 + (v_i[5] * t83 + (v_i[3] * t89 + (q_i[6] * t87 + t92)));
        let t94 = q_i[4] * t88 + (q_i[3] * t85 - q_i[5] * t87 - v_i[5] * t84);
        let t95 = v_i[6] * t83 + (v_i[4] * t89 + (v_i[3] * t82 + (q_i[6] * t86 + t94)));
        let t96 = t91 * two;
        let t97 = t93 * two;
        let t98 = t95 * two;
        let t99 = t56 * t87 - t31 * t96 - t25 * t97 - t26 * t98;
        let t100 = q_i[5] * t82 + (q_i[4] * t83 + (q_i[3] * t84 - q_i[6] * t89));
        let t101 = t100 * two;
        let t102 = q_i[6] * t84 + (q_i[5] * t83 + (q_i[3] * t89 - q_i[4] * t82));
        let t103 = t102 * two;
        let t104 = q_i[6] * t83 + (q_i[4] * t89 + (q_i[3] * t82 - q_i[5] * t84));
        let t105 = t104 * two;
        let t106 = t53 * t88 + (t99 - t30 * t101 - t28 * t103 - t29 * t105);
        let t107 = t26 * t97 - t68 * t91 - t25 * t98 - t53 * t85;
        let t108 = t56 * t86 + (t107 - t41 * t82 - t70 * t100 - t28 * t105);
        let t109 = t31 * t98 - t68 * t93 - t26 * t96 - t50 * t87;
        let t110 = t56 * t85 + (t109 - t35 * t84 - t29 * t101 - t70 * t102);
        let t111 = t25 * t96 - t68 * t95 - t31 * t97 - t56 * t88;
        let t112 = t53 * t87 + (t111 - t47 * t89 - t30 * t103 - t70 * t104);
        let t113 = t20 * t101 + (t16 * t98 + (t21 * t96 + t15 * t97));
        let t114 = t15 * t98 + (t78 * t91 - t16 * t97 - t19 * t103);
        let t115 = t16 * t96 + (t78 * t93 - t21 * t98 - t20 * t105);
        let t116 = t21 * t97 + (t78 * t95 - t15 * t96 - t18 * t101);
        let t117 = q_i[4] * h[7] + (q_i[3] * h[8] - q_i[5] * h[6]);
        let t118 = q_i[6] * h[8] + (q_i[4] * h[6] + q_i[5] * h[7]);
        let t119 = q_i[5] * h[8] + (q_i[3] * h[6] - q_i[6] * h[7]);
        let t120 = v_i[3] * h[8] + (v_i[4] * h[7] - v_i[5] * h[6]);
        let t121 = v_i[6] * h[8] + (v_i[4] * h[6] + v_i[5] * h[7]);
        let t122 = v_i[5] * h[8] + (v_i[3] * h[6] - v_i[6] * h[7]);
        let t123 = v_i[3] * h[7] + (v_i[6] * h[6] - v_i[4] * h[8]);
        let t124 = q_i[6] * h[6] + (q_i[3] * h[7] - q_i[4] * h[8]);
        let t125 = q_i[4] * t121 + (q_i[3] * t122 - q_i[6] * t123 - v_i[6] * t124);
        let t126 = v_i[5] * t117
            + (v_i[4] * t118 + (v_i[3] * t119 + (q_i[5] * t120 + t125)));
        let t127 = q_i[5] * t121 + (q_i[3] * t123 - q_i[4] * t120 - v_i[4] * t117);
        let t128 = v_i[6] * t119
            + (v_i[5] * t118 + (v_i[3] * t124 + (q_i[6] * t122 + t127)));
        let t129 = q_i[4] * t123 + (q_i[3] * t120 - q_i[5] * t122 - v_i[5] * t119);
        let t130 = v_i[6] * t118
            + (v_i[4] * t124 + (v_i[3] * t117 + (q_i[6] * t121 + t129)));
        let t131 = t126 * two;
        let t132 = t128 * two;
        let t133 = t130 * two;
        let t134 = t56 * t122 - t31 * t131 - t25 * t132 - t26 * t133;
        let t135 = q_i[5] * t117 + (q_i[4] * t118 + (q_i[3] * t119 - q_i[6] * t124));
        let t136 = t135 * two;
        let t137 = q_i[6] * t119 + (q_i[5] * t118 + (q_i[3] * t124 - q_i[4] * t117));
        let t138 = t137 * two;
        let t139 = q_i[6] * t118 + (q_i[4] * t124 + (q_i[3] * t117 - q_i[5] * t119));
        let t140 = t139 * two;
        let t141 = t53 * t123 + (t134 - t30 * t136 - t28 * t138 - t29 * t140);
        let t142 = t26 * t132 - t68 * t126 - t25 * t133 - t53 * t120;
        let t143 = t56 * t121 + (t142 - t41 * t117 - t70 * t135 - t28 * t140);
        let t144 = t31 * t133 - t68 * t128 - t26 * t131 - t50 * t122;
        let t145 = t56 * t120 + (t144 - t35 * t119 - t29 * t136 - t70 * t137);
        let t146 = t25 * t131 - t68 * t130 - t31 * t132 - t56 * t123;
        let t147 = t53 * t122 + (t146 - t47 * t124 - t30 * t138 - t70 * t139);
        let t148 = t20 * t136 + (t16 * t133 + (t21 * t131 + t15 * t132));
        let t149 = t15 * t133 + (t78 * t126 - t16 * t132 - t19 * t138);
        let t150 = t16 * t131 + (t78 * t128 - t21 * t133 - t20 * t140);
        let t151 = t21 * t132 + (t78 * t130 - t15 * t131 - t18 * t136);
        let t152 = q_i[3] * q_i[3];
        let t153 = q_i[4] * q_i[4];
        let t154 = q_i[6] * q_i[6];
        let t155 = q_i[5] * q_i[5];
        let t156 = t152 + t153 - t154 - t155;
        let t157 = q_i[6] * q_i[4];
        let t158 = q_i[3] * q_i[5];
        let t159 = t157 - t158;
        let t160 = q_i[6] * q_i[3];
        let t161 = q_i[4] * q_i[5];
        let t162 = t160 + t161;
        let t163 = v_i[4] * q_i[6] + v_i[6] * q_i[4];
        let t164 = q_i[3] * v_i[5];
        let t165 = v_i[3] * q_i[5];
        let t166 = t163 - t164 - t165;
        let t167 = v_i[4] * q_i[4];
        let t168 = v_i[3] * q_i[3];
        let t169 = v_i[6] * q_i[6];
        let t170 = v_i[5] * q_i[5];
        let t171 = t167 + t168 - t169 - t170;
        let t172 = v_i[4] * q_i[5] + q_i[4] * v_i[5];
        let t173 = v_i[6] * q_i[3];
        let t174 = v_i[3] * q_i[6];
        let t175 = t172 + (t173 + t174);
        let t176 = t41 * t162 + (t50 * t166 + (t56 * t171 + t53 * t175));
        let t177 = t46 * t156 + (t35 * t159 + t176);
        let t178 = t152 - t153;
        let t179 = t155 - t154;
        let t180 = t178 + t179;
        let t181 = q_i[4] * q_i[3];
        let t182 = q_i[6] * q_i[5];
        let t183 = t181 + t182;
        let t184 = t161 - t160;
        let t185 = q_i[6] * v_i[5] + v_i[6] * q_i[5];
        let t186 = v_i[4] * q_i[3];
        let t187 = v_i[3] * q_i[4];
        let t188 = t185 + (t186 + t187);
        let t189 = t172 - t173 - t174;
        let t190 = t168 - t167;
        let t191 = t190 + (t170 - t169);
        let t192 = t47 * t184 + (t50 * t188 + (t56 * t189 + t53 * t191));
        let t193 = t40 * t180 + (t35 * t183 + t192);
        let t194 = t178 - t179;
        let t195 = t182 - t181;
        let t196 = t158 + t157;
        let t197 = t169 + (t190 - t170);
        let t198 = t165 + (t164 + t163);
        let t199 = t185 - t186 - t187;
        let t200 = t47 * t196 + (t50 * t197 + (t56 * t198 + t53 * t199));
        let t201 = t34 * t194 + (t41 * t195 + t200);
        let t202 = -(t62 * t171) - t64 * t175 - t66 * t166 - t58 * t162;
        let t203 = -(t62 * t189) - t64 * t191 - t66 * t188 - t57 * t184;
        let t204 = -(t62 * t198) - t64 * t199 - t66 * t197 - t57 * t196;
        let t205 = q_j[3] * q_j[3];
        let t206 = q_j[4] * q_j[4];
        let t207 = q_j[6] * q_j[6];
        let t208 = q_j[5] * q_j[5];
        let t209 = t205 + t206 - t207 - t208;
        let t210 = q_j[4] * q_j[6];
        let t211 = q_j[3] * q_j[5];
        let t212 = t210 - t211;
        let t213 = q_j[3] * q_j[6];
        let t214 = q_j[4] * q_j[5];
        let t215 = t213 + t214;
        let t216 = q_j[6] * v_j[4] + q_j[4] * v_j[6];
        let t217 = q_j[3] * v_j[5];
        let t218 = q_j[5] * v_j[3];
        let t219 = t216 - t217 - t218;
        let t220 = q_j[4] * v_j[4];
        let t221 = q_j[3] * v_j[3];
        let t222 = q_j[6] * v_j[6];
        let t223 = q_j[5] * v_j[5];
        let t224 = t220 + t221 - t222 - t223;
        let t225 = q_j[5] * v_j[4] + q_j[4] * v_j[5];
        let t226 = q_j[3] * v_j[6];
        let t227 = q_j[6] * v_j[3];
        let t228 = t225 + (t226 + t227);
        let t229 = t58 * t215 + (t66 * t219 + (t62 * t224 + t64 * t228));
        let t230 = t205 - t206;
        let t231 = t208 - t207;
        let t232 = t230 + t231;
        let t233 = q_j[4] * q_j[3];
        let t234 = q_j[6] * q_j[5];
        let t235 = t233 + t234;
        let t236 = t214 - t213;
        let t237 = q_j[6] * v_j[5] + q_j[5] * v_j[6];
        let t238 = q_j[3] * v_j[4];
        let t239 = q_j[4] * v_j[3];
        let t240 = t237 + (t238 + t239);
        let t241 = t225 - t226 - t227;
        let t242 = t221 - t220;
        let t243 = t242 + (t223 - t222);
        let t244 = t57 * t236 + (t66 * t240 + (t62 * t241 + t64 * t243));
        let t245 = t230 - t231;
        let t246 = t234 - t233;
        let t247 = t211 + t210;
        let t248 = t222 + (t242 - t223);
        let t249 = t218 + (t217 + t216);
        let t250 = t237 - t238 - t239;
        let t251 = t57 * t247 + (t66 * t248 + (t62 * t249 + t64 * t250));
        let t252 = -(t101 * t171) - t103 * t175 - t105 * t166 - t97 * t162;
        let t253 = -(t101 * t189) - t103 * t191 - t105 * t188 - t96 * t184;
        let t254 = -(t101 * t198) - t103 * t199 - t105 * t197 - t96 * t196;
        let t255 = t97 * t215 + (t105 * t219 + (t101 * t224 + t103 * t228));
        let t256 = t96 * t236 + (t105 * t240 + (t101 * t241 + t103 * t243));
        let t257 = t96 * t247 + (t105 * t248 + (t101 * t249 + t103 * t250));
        let t258 = -(t136 * t171) - t138 * t175 - t140 * t166 - t132 * t162;
        let t259 = -(t136 * t189) - t138 * t191 - t140 * t188 - t131 * t184;
        let t260 = -(t136 * t198) - t138 * t199 - t140 * t197 - t131 * t196;
        let t261 = t132 * t215 + (t140 * t219 + (t136 * t224 + t138 * t228));
        let t262 = t131 * t236 + (t140 * t240 + (t136 * t241 + t138 * t243));
        let t263 = t131 * t247 + (t140 * t248 + (t136 * t249 + t138 * t250));
        rate_q[0] = -t9;
        rate_q[1] = -t11;
        rate_q[2] = -t13;
        rate_q[3] = t0 * t35 + (t7 * t41 + (t2 * t47 + (t3 * t50 + t67)));
        rate_q[4] = t64 * t29 + (t7 * t35 + (t1 * t47 + (t6 * t50 + t71)));
        rate_q[5] = t30 * t66 + (t0 * t47 + (t1 * t41 + (t4 * t53 + t73)));
        rate_q[6] = t62 * t28 + (t2 * t41 + (t1 * t35 + (t4 * t50 + t75)));
        rate_q[7] = t9;
        rate_q[8] = t11;
        rate_q[9] = t13;
        rate_q[10] = t66 * t19 + (t64 * t18 + t76);
        rate_q[11] = t66 * t18 + (t61 * t77 + t79);
        rate_q[12] = t63 * t77 + (t62 * t19 + t80);
        rate_q[13] = t65 * t77 + (t64 * t20 + t81);
        rate_q[14] = -t91;
        rate_q[15] = -t93;
        rate_q[16] = -t95;
        rate_q[17] = t35 * t82 + (t41 * t89 + (t47 * t84 + (t50 * t85 + t106)));
        rate_q[18] = t29 * t103 + (t35 * t89 + (t47 * t83 + (t50 * t88 + t108)));
        rate_q[19] = t30 * t105 + (t47 * t82 + (t41 * t83 + (t53 * t86 + t110)));
        rate_q[20] = t28 * t101 + (t41 * t84 + (t35 * t83 + (t50 * t86 + t112)));
        rate_q[21] = t91;
        rate_q[22] = t93;
        rate_q[23] = t95;
        rate_q[24] = t19 * t105 + (t18 * t103 + t113);
        rate_q[25] = t18 * t105 + (t77 * t100 + t114);
        rate_q[26] = t77 * t102 + (t19 * t101 + t115);
        rate_q[27] = t77 * t104 + (t20 * t103 + t116);
        rate_q[28] = -t126;
        rate_q[29] = -t128;
        rate_q[30] = -t130;
        rate_q[31] = t35 * t117 + (t41 * t124 + (t47 * t119 + (t50 * t120 + t141)));
        rate_q[32] = t29 * t138 + (t35 * t124 + (t47 * t118 + (t50 * t123 + t143)));
        rate_q[33] = t30 * t140 + (t47 * t117 + (t41 * t118 + (t53 * t121 + t145)));
        rate_q[34] = t28 * t136 + (t41 * t119 + (t35 * t118 + (t50 * t121 + t147)));
        rate_q[35] = t126;
        rate_q[36] = t128;
        rate_q[37] = t130;
        rate_q[38] = t19 * t140 + (t18 * t138 + t148);
        rate_q[39] = t18 * t140 + (t77 * t135 + t149);
        rate_q[40] = t77 * t137 + (t19 * t136 + t150);
        rate_q[41] = t77 * t139 + (t20 * t138 + t151);
        rate_h[0] = t177;
        rate_h[1] = t193;
        rate_h[2] = t201;
        rate_h[3] = t202 - t59 * t159 - t9 * t156;
        rate_h[4] = t203 - t59 * t183 - t11 * t180;
        rate_h[5] = t204 - t58 * t195 - t13 * t194;
        rate_h[6] = t9 * t209 + (t59 * t212 + t229);
        rate_h[7] = t11 * t232 + (t59 * t235 + t244);
        rate_h[8] = t13 * t245 + (t58 * t246 + t251);
        rate_h[9] = t177;
        rate_h[10] = t193;
        rate_h[11] = t201;
        rate_h[12] = t252 - t98 * t159 - t91 * t156;
        rate_h[13] = t253 - t98 * t183 - t93 * t180;
        rate_h[14] = t254 - t97 * t195 - t95 * t194;
        rate_h[15] = t91 * t209 + (t98 * t212 + t255);
        rate_h[16] = t93 * t232 + (t98 * t235 + t256);
        rate_h[17] = t95 * t245 + (t97 * t246 + t257);
        rate_h[18] = t177;
        rate_h[19] = t193;
        rate_h[20] = t201;
        rate_h[21] = t258 - t133 * t159 - t126 * t156;
        rate_h[22] = t259 - t133 * t183 - t128 * t180;
        rate_h[23] = t260 - t132 * t195 - t130 * t194;
        rate_h[24] = t126 * t209 + (t133 * t212 + t261);
        rate_h[25] = t128 * t232 + (t133 * t235 + t262);
        rate_h[26] = t130 * t245 + (t132 * t246 + t263);
    }
}
