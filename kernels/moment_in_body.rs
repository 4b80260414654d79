// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Moment fixed in the body
///
/// `a virtual rotation (A a)ᵀ δθ; the multiplier is the moment about −A a` (unit 1)
///
/// Source: a moment that turns with the body, such as that of a motor on it.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `a_i` | 1 | body i | unit vector of the moment's axis |
pub mod moment_in_body {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "moment_in_body",
        title: "Moment fixed in the body",
        equation: "a virtual rotation (A a)ᵀ δθ; the multiplier is the moment about −A a",
        reference: "a moment that turns with the body, such as that of a motor on it",
        bodies: 1,
        equations: 1,
        unit: "1",
        parameters: &[
            Parameter {
                name: "a_i",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "body i",
                meaning: "unit vector of the moment's axis",
            },
        ],
        jacobian: &[],
        work: &[(0, 3), (0, 4), (0, 5), (0, 6)],
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
        ],
        design: &[],
        force_design: &[
            (3, 0),
            (3, 1),
            (3, 2),
            (4, 0),
            (4, 1),
            (4, 2),
            (5, 0),
            (5, 1),
            (5, 2),
            (6, 0),
            (6, 1),
            (6, 2),
        ],
        rate: &[],
        rate_design: &[],
        operations: [
            Operations {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 25,
                multiplications: 41,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 61,
                multiplications: 65,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 37,
                multiplications: 61,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Moment fixed in the body
    #[derive(Clone, Copy, Debug, Default)]
    pub struct MomentInBody;
    impl<S: Scalar> Relation<S> for MomentInBody {
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
    /// 0 additions, 0 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(_q_i: &[S; 7], _h: &[S; 3], phi: &mut [S; 1]) {
        let zero = S::from_f64(0.0);
        phi[0] = zero;
    }
    /// Φ, Φ_q and W.
    ///
    /// 25 additions, 41 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 3],
        phi: &mut [S; 1],
        _phi_q: &mut [S; 0],
        work: &mut [S; 4],
    ) {
        let zero = S::from_f64(0.0);
        let two = S::from_f64(2.0);
        let t0 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t1 = h[2] * q_i[6] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t2 = h[2] * q_i[5] + (q_i[3] * h[0] - h[1] * q_i[6]);
        let t3 = q_i[6] * h[0] + (q_i[3] * h[1] - h[2] * q_i[4]);
        let t4 = q_i[5] * t0 + (q_i[4] * t1 + (q_i[3] * t2 - q_i[6] * t3));
        let t5 = q_i[6] * t2 + (q_i[5] * t1 + (q_i[3] * t3 - q_i[4] * t0));
        let t6 = q_i[6] * t1 + (q_i[4] * t3 + (q_i[3] * t0 - q_i[5] * t2));
        phi[0] = zero;
        work[0] = (-(q_i[4] * t4) - q_i[5] * t5 - q_i[6] * t6) * two;
        work[1] = (q_i[3] * t4 + (q_i[6] * t5 - q_i[5] * t6)) * two;
        work[2] = (q_i[4] * t6 + (q_i[3] * t5 - q_i[6] * t4)) * two;
        work[3] = (q_i[3] * t6 + (q_i[5] * t4 - q_i[4] * t5)) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 61 additions, 65 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 3],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        _phi_q: &mut [S; 0],
        work: &mut [S; 4],
        curvature: &mut [S; 16],
    ) {
        let zero = S::from_f64(0.0);
        let two = S::from_f64(2.0);
        let k4 = S::from_f64(4.0);
        let t0 = q_i[4] * h[1] + (h[2] * q_i[3] - h[0] * q_i[5]);
        let t1 = q_i[5] * t0;
        let t2 = q_i[6] * h[2] + (q_i[4] * h[0] + h[1] * q_i[5]);
        let t3 = q_i[4] * t2;
        let t4 = h[2] * q_i[5] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t5 = q_i[3] * t4;
        let t6 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t7 = q_i[6] * t6;
        let t8 = (t1 + (t3 + (t5 - t7))) * two;
        let t9 = q_i[6] * t4;
        let t10 = q_i[5] * t2;
        let t11 = q_i[3] * t6;
        let t12 = q_i[4] * t0;
        let t13 = (t9 + (t10 + (t11 - t12))) * two;
        let t14 = q_i[6] * t2;
        let t15 = q_i[4] * t6;
        let t16 = q_i[3] * t0;
        let t17 = q_i[5] * t4;
        let t18 = (t14 + (t15 + (t16 - t17))) * two;
        let t19 = lambda[0] * k4;
        let t20 = t19 * (q_i[6] * t0);
        let t21 = t19 * (t6 * q_i[5]);
        let t22 = -t20 - t21;
        let t23 = t19 * (q_i[4] * t4);
        let t24 = t1 * t19;
        let t25 = t3 * t19;
        let t26 = t24 - t25;
        let t27 = t7 * t19;
        let t28 = t8 * lambda[0];
        let t29 = t9 * t19;
        let t30 = t10 * t19;
        let t31 = t29 - t30;
        let t32 = t12 * t19;
        let t33 = t13 * lambda[0];
        let t34 = t15 * t19;
        let t35 = t14 * t19;
        let t36 = t34 - t35;
        let t37 = t17 * t19;
        let t38 = t18 * lambda[0];
        let t39 = t5 * t19;
        let t40 = t27 + t39;
        let t41 = t19 * (q_i[3] * t2);
        let t42 = t16 * t19;
        let t43 = t37 + t42;
        let t44 = t11 * t19;
        let t45 = t32 + t44;
        let t46 = t41 - t23;
        phi[0] = zero;
        work[0] = -(q_i[4] * t8) - q_i[5] * t13 - q_i[6] * t18;
        work[1] = q_i[6] * t13 + (q_i[3] * t8 - q_i[5] * t18);
        work[2] = q_i[4] * t18 + (q_i[3] * t13 - q_i[6] * t8);
        work[3] = q_i[5] * t8 + (q_i[3] * t18 - q_i[4] * t13);
        curvature[0] = t22 - t23;
        curvature[1] = t26 - t27 - t28;
        curvature[2] = t31 - t32 - t33;
        curvature[3] = t36 - t37 - t38;
        curvature[4] = t40 + (t28 - t24);
        curvature[5] = t22 + t41;
        curvature[6] = t43 + (t35 - t38);
        curvature[7] = t33 + (t31 - t44);
        curvature[8] = t45 + (t33 - t29);
        curvature[9] = t38 + (t36 - t42);
        curvature[10] = t46 - t20;
        curvature[11] = t25 + (t40 - t28);
        curvature[12] = t38 + t43 - t34;
        curvature[13] = t30 + (t45 - t33);
        curvature[14] = t28 + t26 - t39;
        curvature[15] = t46 - t21;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 37 additions, 61 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        _h: &[S; 3],
        lambda: &[S; 1],
        _phi_h: &mut [S; 0],
        force_h: &mut [S; 12],
    ) {
        let k4 = S::from_f64(4.0);
        let two = S::from_f64(2.0);
        let t0 = q_i[3] * q_i[6];
        let t1 = q_i[4] * q_i[5];
        let t2 = t0 + t1;
        let t3 = lambda[0] * k4;
        let t4 = q_i[5] * t3;
        let t5 = q_i[6] * q_i[4];
        let t6 = q_i[3] * q_i[5];
        let t7 = t5 - t6;
        let t8 = q_i[6] * t3;
        let t9 = q_i[4] * lambda[0];
        let t10 = q_i[3] * q_i[3];
        let t11 = q_i[4] * q_i[4];
        let t12 = q_i[6] * q_i[6];
        let t13 = q_i[5] * q_i[5];
        let t14 = (t10 + t11 - t12 - t13) * two;
        let t15 = t1 - t0;
        let t16 = q_i[4] * t3;
        let t17 = q_i[3] * q_i[4];
        let t18 = q_i[6] * q_i[5];
        let t19 = t17 + t18;
        let t20 = q_i[5] * lambda[0];
        let t21 = t10 - t11;
        let t22 = t13 - t12;
        let t23 = (t21 + t22) * two;
        let t24 = t6 + t5;
        let t25 = t18 - t17;
        let t26 = q_i[6] * lambda[0];
        let t27 = (t21 - t22) * two;
        let t28 = q_i[3] * lambda[0];
        let t29 = q_i[3] * t3;
        force_h[0] = -(t2 * t4) - t7 * t8 - t9 * t14;
        force_h[1] = -(t15 * t16) - t8 * t19 - t20 * t23;
        force_h[2] = -(t16 * t24) - t4 * t25 - t26 * t27;
        force_h[3] = t2 * t8 + (t14 * t28 - t4 * t7);
        force_h[4] = t15 * t29 + (t23 * t26 - t4 * t19);
        force_h[5] = t8 * t25 + (t24 * t29 - t20 * t27);
        force_h[6] = t7 * t16 + (t2 * t29 - t14 * t26);
        force_h[7] = t16 * t19 + (t23 * t28 - t8 * t15);
        force_h[8] = t25 * t29 + (t9 * t27 - t8 * t24);
        force_h[9] = t7 * t29 + (t14 * t20 - t2 * t16);
        force_h[10] = t4 * t15 + (t19 * t29 - t9 * t23);
        force_h[11] = t4 * t24 + (t27 * t28 - t16 * t25);
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 0 additions, 0 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        _q_i: &[S; 7],
        _h: &[S; 3],
        _v_i: &[S; 7],
        _rate_q: &mut [S; 0],
        _rate_h: &mut [S; 0],
    ) {}
}
