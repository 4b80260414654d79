// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Force fixed in the body
///
/// `a virtual displacement (A a)ᵀ (δr + δθ × A s); the multiplier is the force along −A a at the point s` (unit m)
///
/// Source: a follower force, such as the thrust of a propeller.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0..3 | `a_i` | 1 | body i | unit vector of the force's direction |
/// | 3..6 | `s_i` | m | body i | point of application |
pub mod force_in_body {
    use super::{
        Coordinates, Operations, Parameter, Place, Relation, Scalar, Shape, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: Shape = Shape {
        name: "force_in_body",
        title: "Force fixed in the body",
        equation: "a virtual displacement (A a)ᵀ (δr + δθ × A s); the multiplier is the force along −A a at the point s",
        reference: "a follower force, such as the thrust of a propeller",
        bodies: 1,
        equations: 1,
        unit: "m",
        parameters: &[
            Parameter {
                name: "a_i",
                size: 3,
                offset: 0,
                unit: "1",
                frame: "body i",
                meaning: "unit vector of the force's direction",
            },
            Parameter {
                name: "s_i",
                size: 3,
                offset: 3,
                unit: "m",
                frame: "body i",
                meaning: "point of application",
            },
        ],
        jacobian: &[],
        work: &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6)],
        curvature: &[
            (0, 3),
            (0, 4),
            (0, 5),
            (0, 6),
            (1, 3),
            (1, 4),
            (1, 5),
            (1, 6),
            (2, 3),
            (2, 4),
            (2, 5),
            (2, 6),
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
            (0, 0),
            (0, 1),
            (0, 2),
            (1, 0),
            (1, 1),
            (1, 2),
            (2, 0),
            (2, 1),
            (2, 2),
            (3, 0),
            (3, 1),
            (3, 2),
            (3, 3),
            (3, 4),
            (3, 5),
            (4, 0),
            (4, 1),
            (4, 2),
            (4, 3),
            (4, 4),
            (4, 5),
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
                additions: 45,
                multiplications: 71,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 161,
                multiplications: 214,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 119,
                multiplications: 173,
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
    /// Force fixed in the body
    #[derive(Clone, Copy, Debug, Default)]
    pub struct ForceInBody;
    impl<S: Scalar> Relation<S> for ForceInBody {
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
    pub fn residual<S: Scalar>(_q_i: &[S; 7], _h: &[S; 6], phi: &mut [S; 1]) {
        let zero = S::from_f64(0.0);
        phi[0] = zero;
    }
    /// Φ, Φ_q and W.
    ///
    /// 45 additions, 71 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn jacobian<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 6],
        phi: &mut [S; 1],
        _phi_q: &mut [S; 0],
        work: &mut [S; 7],
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
        let t7 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t8 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t9 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t10 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t11 = q_i[6] * t7 + (q_i[5] * t8 + (q_i[3] * t9 - q_i[4] * t10));
        let t12 = q_i[6] * t8 + (q_i[4] * t9 + (q_i[3] * t10 - q_i[5] * t7));
        let t13 = t6 * t11 - t5 * t12;
        let t14 = t13 * two;
        let t15 = q_i[5] * t10 + (q_i[4] * t8 + (q_i[3] * t7 - q_i[6] * t9));
        let t16 = t4 * t12 - t6 * t15;
        let t17 = t16 * two;
        let t18 = (t5 * t15 - t4 * t11) * two;
        let t19 = q_i[3] * two;
        phi[0] = zero;
        work[0] = t4;
        work[1] = t5;
        work[2] = t6;
        work[3] = -(q_i[4] * t14) - q_i[5] * t17 - q_i[6] * t18;
        work[4] = q_i[6] * t17 + (t13 * t19 - q_i[5] * t18);
        work[5] = q_i[4] * t18 + (t16 * t19 - q_i[6] * t14);
        work[6] = q_i[5] * t14 + (q_i[3] * t18 - q_i[4] * t17);
    }
    /// Φ, Φ_q, W and (Wᵀλ)_q.
    ///
    /// 161 additions, 214 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn curvature<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 6],
        lambda: &[S; 1],
        phi: &mut [S; 1],
        _phi_q: &mut [S; 0],
        work: &mut [S; 7],
        curvature: &mut [S; 28],
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
        let t7 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t8 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t9 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t10 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t11 = q_i[6] * t7 + (q_i[5] * t8 + (q_i[3] * t9 - q_i[4] * t10));
        let t12 = t11 * two;
        let t13 = q_i[6] * t8 + (q_i[4] * t9 + (q_i[3] * t10 - q_i[5] * t7));
        let t14 = t13 * two;
        let t15 = t6 * t12 - t5 * t14;
        let t16 = q_i[5] * t10 + (q_i[4] * t8 + (q_i[3] * t7 - q_i[6] * t9));
        let t17 = t16 * two;
        let t18 = t4 * t14 - t6 * t17;
        let t19 = t5 * t17 - t4 * t12;
        let t20 = lambda[0] * two;
        let t21 = t2 * t20;
        let t22 = t1 * t20;
        let t23 = t0 * t20;
        let t24 = t3 * t20;
        let t25 = t5 * two;
        let t26 = q_i[4] * t25;
        let t27 = t4 * two;
        let t28 = q_i[5] * t27;
        let t29 = t26 - t28;
        let t30 = t10 * t20;
        let t31 = q_i[6] * t27;
        let t32 = t6 * two;
        let t33 = q_i[4] * t32;
        let t34 = t31 - t33;
        let t35 = t9 * t20;
        let t36 = q_i[5] * t32;
        let t37 = q_i[6] * t25;
        let t38 = t36 - t37;
        let t39 = t7 * t20;
        let t40 = q_i[5] * t17;
        let t41 = q_i[4] * t12;
        let t42 = t40 - t41;
        let t43 = q_i[6] * t12;
        let t44 = q_i[5] * t14;
        let t45 = t43 - t44;
        let t46 = q_i[4] * t14;
        let t47 = q_i[6] * t17;
        let t48 = t46 - t47;
        let t49 = t38 * t39 + (t23 * t42 + (t21 * t45 + t24 * t48));
        let t50 = t8 * t20;
        let t51 = t24 * t42 + (t22 * t45 - t23 * t48 - t34 * t30);
        let t52 = t15 * lambda[0];
        let t53 = t23 * t45 + (t22 * t48 - t21 * t42 - t39 * t29);
        let t54 = t18 * lambda[0];
        let t55 = t21 * t48 + (t22 * t42 - t24 * t45 - t38 * t35);
        let t56 = t19 * lambda[0];
        let t57 = q_i[3] * two;
        let t58 = t5 * t57;
        let t59 = t31 - t58;
        let t60 = t6 * t57;
        let t61 = t28 + t60;
        let t62 = -(q_i[5] * t25);
        let t63 = q_i[6] * t32;
        let t64 = t62 - t63;
        let t65 = t11 * t57;
        let t66 = t65 - t47;
        let t67 = q_i[6] * t14;
        let t68 = q_i[5] * t12;
        let t69 = t67 + t68;
        let t70 = t13 * t57;
        let t71 = -t70 - t40;
        let t72 = t39 * t64 + (t23 * t66 + (t21 * t69 + t24 * t71));
        let t73 = t24 * t66 + (t22 * t69 - t23 * t71 - t30 * t61);
        let t74 = t23 * t69 + (t22 * t71 - t56 - t21 * t66 - t39 * t59);
        let t75 = t21 * t71 + (t22 * t66 - t24 * t69 - t35 * t64);
        let t76 = t4 * t57;
        let t77 = t37 + t76;
        let t78 = q_i[4] * t27;
        let t79 = -t63 - t78;
        let t80 = t26 - t60;
        let t81 = t16 * t57;
        let t82 = -t81 - t43;
        let t83 = q_i[4] * t17;
        let t84 = t67 + t83;
        let t85 = t70 - t41;
        let t86 = t39 * t80 + (t23 * t82 + (t24 * t84 + (t54 + t21 * t85)));
        let t87 = t24 * t82 + (t22 * t85 - t23 * t84 - t30 * t79);
        let t88 = t23 * t85 + (t22 * t84 - t21 * t82 - t39 * t77);
        let t89 = t21 * t84 + (t22 * t82 - t52 - t24 * t85 - t35 * t80);
        let t90 = t62 - t78;
        let t91 = t36 - t76;
        let t92 = t33 + t58;
        let t93 = t68 + t83;
        let t94 = t81 - t44;
        let t95 = -t65 - t46;
        let t96 = t39 * t92 + (t23 * t93 + (t24 * t94 + (t56 + t21 * t95)));
        let t97 = t24 * t93 + (t22 * t95 - t54 - t23 * t94 - t30 * t91);
        let t98 = t23 * t95 + (t22 * t94 + (t52 - t21 * t93 - t39 * t90));
        let t99 = t21 * t94 + (t22 * t93 - t24 * t95 - t35 * t92);
        phi[0] = zero;
        work[0] = t4;
        work[1] = t5;
        work[2] = t6;
        work[3] = -(q_i[4] * t15) - q_i[5] * t18 - q_i[6] * t19;
        work[4] = q_i[6] * t18 + (q_i[3] * t15 - q_i[5] * t19);
        work[5] = q_i[4] * t19 + (q_i[3] * t18 - q_i[6] * t15);
        work[6] = q_i[5] * t15 + (q_i[3] * t19 - q_i[4] * t18);
        curvature[0] = t21;
        curvature[1] = t22;
        curvature[2] = t23;
        curvature[3] = -t24;
        curvature[4] = t24;
        curvature[5] = -t23;
        curvature[6] = t22;
        curvature[7] = t21;
        curvature[8] = t23;
        curvature[9] = t24;
        curvature[10] = -t21;
        curvature[11] = t22;
        curvature[12] = t29 * t30 + (t34 * t35 + t49);
        curvature[13] = t35 * t29 + (t38 * t50 + t51) - t52;
        curvature[14] = t38 * t30 + (t34 * t50 + t53) - t54;
        curvature[15] = t39 * t34 + (t29 * t50 + t55) - t56;
        curvature[16] = t52 + (t30 * t59 + (t35 * t61 + t72));
        curvature[17] = t35 * t59 + (t50 * t64 + t73);
        curvature[18] = t30 * t64 + (t50 * t61 + t74);
        curvature[19] = t54 + (t39 * t61 + (t50 * t59 + t75));
        curvature[20] = t30 * t77 + (t35 * t79 + t86);
        curvature[21] = t56 + (t35 * t77 + (t50 * t80 + t87));
        curvature[22] = t30 * t80 + (t50 * t79 + t88);
        curvature[23] = t39 * t79 + (t50 * t77 + t89);
        curvature[24] = t30 * t90 + (t35 * t91 + t96);
        curvature[25] = t35 * t90 + (t50 * t92 + t97);
        curvature[26] = t30 * t92 + (t50 * t91 + t98);
        curvature[27] = t39 * t91 + (t50 * t90 + t99);
    }
    /// Φ_h and (Wᵀλ)_h.
    ///
    /// 119 additions, 173 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn design<S: Scalar>(
        q_i: &[S; 7],
        h: &[S; 6],
        lambda: &[S; 1],
        _phi_h: &mut [S; 0],
        force_h: &mut [S; 33],
    ) {
        let two = S::from_f64(2.0);
        let t0 = q_i[3] * q_i[3];
        let t1 = q_i[4] * q_i[4];
        let t2 = q_i[6] * q_i[6];
        let t3 = q_i[5] * q_i[5];
        let t4 = lambda[0] * (t0 + t1 - t2 - t3);
        let t5 = q_i[4] * q_i[5];
        let t6 = q_i[3] * q_i[6];
        let t7 = lambda[0] * two;
        let t8 = (t5 - t6) * t7;
        let t9 = q_i[3] * q_i[5];
        let t10 = q_i[4] * q_i[6];
        let t11 = t7 * (t9 + t10);
        let t12 = t7 * (t6 + t5);
        let t13 = t0 - t1;
        let t14 = t3 - t2;
        let t15 = lambda[0] * (t13 + t14);
        let t16 = q_i[6] * q_i[5];
        let t17 = q_i[3] * q_i[4];
        let t18 = t7 * (t16 - t17);
        let t19 = t7 * (t10 - t9);
        let t20 = t7 * (t17 + t16);
        let t21 = lambda[0] * (t13 - t14);
        let t22 = q_i[6] * two;
        let t23 = q_i[5] * h[5] + (q_i[3] * h[3] - q_i[6] * h[4]);
        let t24 = q_i[6] * h[5] + (q_i[4] * h[3] + q_i[5] * h[4]);
        let t25 = q_i[6] * h[3] + (q_i[3] * h[4] - q_i[4] * h[5]);
        let t26 = q_i[4] * h[4] + (q_i[3] * h[5] - q_i[5] * h[3]);
        let t27 = q_i[6] * t23 + (q_i[5] * t24 + (q_i[3] * t25 - q_i[4] * t26));
        let t28 = t22 * t27;
        let t29 = q_i[6] * t24 + (q_i[4] * t25 + (q_i[3] * t26 - q_i[5] * t23));
        let t30 = q_i[5] * two;
        let t31 = t29 * t30;
        let t32 = t28 - t31;
        let t33 = q_i[4] * two;
        let t34 = t29 * t33;
        let t35 = q_i[5] * t26 + (q_i[4] * t24 + (q_i[3] * t23 - q_i[6] * t25));
        let t36 = t35 * t22;
        let t37 = t34 - t36;
        let t38 = t35 * t30;
        let t39 = t33 * t27;
        let t40 = t38 - t39;
        let t41 = q_i[6] * h[2] + (q_i[4] * h[0] + q_i[5] * h[1]);
        let t42 = q_i[6] * h[0] + (q_i[3] * h[1] - q_i[4] * h[2]);
        let t43 = q_i[4] * h[1] + (q_i[3] * h[2] - q_i[5] * h[0]);
        let t44 = q_i[5] * h[2] + (q_i[3] * h[0] - q_i[6] * h[1]);
        let t45 = q_i[6] * t41 + (q_i[4] * t42 + (q_i[3] * t43 - q_i[5] * t44));
        let t46 = t30 * t45;
        let t47 = q_i[6] * t44 + (q_i[5] * t41 + (q_i[3] * t42 - q_i[4] * t43));
        let t48 = t22 * t47;
        let t49 = t46 - t48;
        let t50 = q_i[5] * t43 + (q_i[4] * t41 + (q_i[3] * t44 - q_i[6] * t42));
        let t51 = t22 * t50;
        let t52 = t33 * t45;
        let t53 = t51 - t52;
        let t54 = t33 * t47;
        let t55 = t30 * t50;
        let t56 = t54 - t55;
        let t57 = t29 * t22;
        let t58 = t30 * t27;
        let t59 = t57 + t58;
        let t60 = q_i[3] * two;
        let t61 = t29 * t60;
        let t62 = -t61 - t38;
        let t63 = t27 * t60;
        let t64 = t63 - t36;
        let t65 = -(t30 * t47);
        let t66 = t22 * t45;
        let t67 = t65 - t66;
        let t68 = t45 * t60;
        let t69 = t55 + t68;
        let t70 = t47 * t60;
        let t71 = t51 - t70;
        let t72 = t61 - t39;
        let t73 = t33 * t35;
        let t74 = t57 + t73;
        let t75 = t35 * t60;
        let t76 = -t75 - t28;
        let t77 = t54 - t68;
        let t78 = t33 * t50;
        let t79 = -t66 - t78;
        let t80 = t50 * t60;
        let t81 = t48 + t80;
        let t82 = -t63 - t34;
        let t83 = t75 - t31;
        let t84 = t58 + t73;
        let t85 = t52 + t70;
        let t86 = t46 - t80;
        let t87 = t65 - t78;
        force_h[0] = t4;
        force_h[1] = t8;
        force_h[2] = t11;
        force_h[3] = t12;
        force_h[4] = t15;
        force_h[5] = t18;
        force_h[6] = t19;
        force_h[7] = t20;
        force_h[8] = t21;
        force_h[9] = t4 * t32 + (t12 * t37 + t19 * t40);
        force_h[10] = t15 * t37 + (t8 * t32 + t20 * t40);
        force_h[11] = t21 * t40 + (t11 * t32 + t18 * t37);
        force_h[12] = t4 * t49 + (t12 * t53 + t19 * t56);
        force_h[13] = t15 * t53 + (t8 * t49 + t20 * t56);
        force_h[14] = t21 * t56 + (t11 * t49 + t18 * t53);
        force_h[15] = t4 * t59 + (t12 * t62 + t19 * t64);
        force_h[16] = t15 * t62 + (t8 * t59 + t20 * t64);
        force_h[17] = t21 * t64 + (t11 * t59 + t18 * t62);
        force_h[18] = t4 * t67 + (t12 * t69 + t19 * t71);
        force_h[19] = t15 * t69 + (t8 * t67 + t20 * t71);
        force_h[20] = t21 * t71 + (t11 * t67 + t18 * t69);
        force_h[21] = t4 * t72 + (t12 * t74 + t19 * t76);
        force_h[22] = t15 * t74 + (t8 * t72 + t20 * t76);
        force_h[23] = t21 * t76 + (t11 * t72 + t18 * t74);
        force_h[24] = t4 * t77 + (t12 * t79 + t19 * t81);
        force_h[25] = t15 * t79 + (t8 * t77 + t20 * t81);
        force_h[26] = t21 * t81 + (t11 * t77 + t18 * t79);
        force_h[27] = t4 * t82 + (t12 * t83 + t19 * t84);
        force_h[28] = t15 * t83 + (t8 * t82 + t20 * t84);
        force_h[29] = t21 * t84 + (t11 * t82 + t18 * t83);
        force_h[30] = t4 * t85 + (t12 * t86 + t19 * t87);
        force_h[31] = t15 * t86 + (t8 * t85 + t20 * t87);
        force_h[32] = t21 * t87 + (t11 * t85 + t18 * t86);
    }
    /// (Φ_q v)_q and (Φ_q v)_h.
    ///
    /// 0 additions, 0 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn rate<S: Scalar>(
        _q_i: &[S; 7],
        _h: &[S; 6],
        _v_i: &[S; 7],
        _rate_q: &mut [S; 0],
        _rate_h: &mut [S; 0],
    ) {}
}
