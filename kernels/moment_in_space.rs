// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Moment fixed in space
///
/// `a virtual rotation aᵀ δθ; the multiplier is the moment about −a` (unit 1)
///
/// Source: a moment whose axis does not turn with the body; it has no potential.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `a` | 1 | ground | unit vector of the moment's axis |
pub mod moment_in_space {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "moment_in_space",
        title: "Moment fixed in space",
        equation: "a virtual rotation aᵀ δθ; the multiplier is the moment about −a",
        reference: "a moment whose axis does not turn with the body; it has no potential",
        bodies: 1,
        equations: 1,
        unit: "1",
        parameters: &[
            Parameter {
                name: "a",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "ground",
                meaning: "unit vector of the moment's axis",
            },
        ],
        jacobian: &[],
        work: &[(0, 3), (0, 4), (0, 5), (0, 6)],
        curvature: &[
            (3, 4),
            (3, 5),
            (3, 6),
            (4, 3),
            (4, 5),
            (4, 6),
            (5, 3),
            (5, 4),
            (5, 6),
            (6, 3),
            (6, 4),
            (6, 5),
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
                additions: 8,
                multiplications: 17,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 8,
                multiplications: 23,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 0,
                multiplications: 8,
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
    /// Moment fixed in space
    #[derive(Clone, Copy, Debug, Default)]
    pub struct MomentInSpace;
    impl<S: Scalar> Relation<S> for MomentInSpace {
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
    /// 8 additions, 17 multiplications, 0 divisions, 0 functions.
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
        phi[0] = zero;
        work[0] = (-(q_i[4] * h[0]) - q_i[5] * h[1] - q_i[6] * h[2]) * two;
        work[1] = (h[1] * q_i[6] + (h[0] * q_i[3] - q_i[5] * h[2])) * two;
        work[2] = (h[1] * q_i[3] + (q_i[4] * h[2] - h[0] * q_i[6])) * two;
        work[3] = (h[0] * q_i[5] + (h[2] * q_i[3] - q_i[4] * h[1])) * two;
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 8 additions, 23 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 3],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        _phi_q: &mut [S; 0],
        work: &mut [S; 4],
        curvature: &mut [S; 12],
    ) {
        let zero = S::from_f64(0.0);
        let two = S::from_f64(2.0);
        let t0 = h[0] * two;
        let t1 = h[1] * two;
        let t2 = h[2] * two;
        let t3 = lambda[0] * two;
        let t4 = h[0] * t3;
        let t5 = -t4;
        let t6 = h[1] * t3;
        let t7 = -t6;
        let t8 = h[2] * t3;
        let t9 = -t8;
        phi[0] = zero;
        work[0] = -(q_i[4] * t0) - q_i[5] * t1 - q_i[6] * t2;
        work[1] = t1 * q_i[6] + (t0 * q_i[3] - q_i[5] * t2);
        work[2] = q_i[4] * t2 + (t1 * q_i[3] - t0 * q_i[6]);
        work[3] = t0 * q_i[5] + (t2 * q_i[3] - q_i[4] * t1);
        curvature[0] = t5;
        curvature[1] = t7;
        curvature[2] = t9;
        curvature[3] = t4;
        curvature[4] = t9;
        curvature[5] = t6;
        curvature[6] = t6;
        curvature[7] = t8;
        curvature[8] = t5;
        curvature[9] = t8;
        curvature[10] = t7;
        curvature[11] = t4;
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 0 additions, 8 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        _h: &[S; 3],
        lambda: &[S; 1],
        _phi_h: &mut [S; 0],
        force_h: &mut [S; 12],
    ) {
        let two = S::from_f64(2.0);
        let t0 = lambda[0] * two;
        let t1 = q_i[4] * t0;
        let t2 = -t1;
        let t3 = t0 * q_i[5];
        let t4 = -t3;
        let t5 = t0 * q_i[6];
        let t6 = -t5;
        let t7 = t0 * q_i[3];
        force_h[0] = t2;
        force_h[1] = t4;
        force_h[2] = t6;
        force_h[3] = t7;
        force_h[4] = t5;
        force_h[5] = t4;
        force_h[6] = t6;
        force_h[7] = t7;
        force_h[8] = t1;
        force_h[9] = t3;
        force_h[10] = t2;
        force_h[11] = t7;
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
