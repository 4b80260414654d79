// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Normalisation of Euler parameters
///
/// `pᵀp − 1 = 0` (unit 1)
///
/// Source: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, eq. (9.3.8).
pub mod euler_parameters {
    use super::{
        Coordinates, Operations, Place, Relation, Scalar, Shape, exact, exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "euler_parameters",
        title: "Normalisation of Euler parameters",
        equation: "pᵀp − 1 = 0",
        reference: "Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, eq. (9.3.8)",
        bodies: 1,
        equations: 1,
        unit: "1",
        parameters: &[],
        jacobian: &[(0, 3), (0, 4), (0, 5), (0, 6)],
        work: &[],
        curvature: &[(3, 3), (4, 4), (5, 5), (6, 6)],
        design: &[],
        force_design: &[],
        rate: &[(0, 3), (0, 4), (0, 5), (0, 6)],
        rate_design: &[],
        operations: [
            Operations {
                additions: 4,
                multiplications: 4,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 4,
                multiplications: 8,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 4,
                multiplications: 9,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 0,
                multiplications: 4,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Normalisation of Euler parameters
    #[derive(Clone, Copy, Debug, Default)]
    pub struct EulerParameters;
    impl<S: Scalar> Relation<S> for EulerParameters {
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
    /// 4 additions, 4 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn residual<S: Scalar>(q_i: &[S; 7], _h: &[S; 0], phi: &mut [S; 1]) {
        let minus_one = S::from_f64(-1.0);
        phi[0] = q_i[6] * q_i[6]
            + (q_i[5] * q_i[5] + (q_i[4] * q_i[4] + (minus_one + q_i[3] * q_i[3])));
    }
    /// Φ, Φ_q and W.
    ///
    /// 4 additions, 8 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        _h: &[S; 0],
        phi: &mut [S; 1],
        phi_q: &mut [S; 4],
        _work: &mut [S; 0],
    ) {
        let minus_one = S::from_f64(-1.0);
        let two = S::from_f64(2.0);
        phi[0] = q_i[6] * q_i[6]
            + (q_i[5] * q_i[5] + (q_i[4] * q_i[4] + (minus_one + q_i[3] * q_i[3])));
        phi_q[0] = q_i[3] * two;
        phi_q[1] = q_i[4] * two;
        phi_q[2] = q_i[5] * two;
        phi_q[3] = q_i[6] * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 4 additions, 9 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        _h: &[S; 0],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        phi_q: &mut [S; 4],
        _work: &mut [S; 0],
        curvature: &mut [S; 4],
    ) {
        let minus_one = S::from_f64(-1.0);
        let two = S::from_f64(2.0);
        let t0 = lambda[0] * two;
        phi[0] = q_i[6] * q_i[6]
            + (q_i[5] * q_i[5] + (q_i[4] * q_i[4] + (minus_one + q_i[3] * q_i[3])));
        phi_q[0] = q_i[3] * two;
        phi_q[1] = q_i[4] * two;
        phi_q[2] = q_i[5] * two;
        phi_q[3] = q_i[6] * two;
        curvature[0] = t0;
        curvature[1] = t0;
        curvature[2] = t0;
        curvature[3] = t0;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 0 additions, 0 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        _q_i: &[S; 7],
        _h: &[S; 0],
        _lambda: &[S; 1],
        _phi_h: &mut [S; 0],
        _force_h: &mut [S; 0],
    ) {}
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 0 additions, 4 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        _q_i: &[S; 7],
        _h: &[S; 0],
        v_i: &[S; 7],
        rate_q: &mut [S; 4],
        _rate_h: &mut [S; 0],
    ) {
        let two = S::from_f64(2.0);
        rate_q[0] = v_i[3] * two;
        rate_q[1] = v_i[4] * two;
        rate_q[2] = v_i[5] * two;
        rate_q[3] = v_i[6] * two;
    }
}
