// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

/// Rigid body
///
/// `T = ½ m |ṙ + A (ω′ × s)|² + ½ ω′ᵀ J ω′, J = [Jxx Jxy Jxz; Jxy Jyy Jyz; Jxz Jyz Jzz]` (unit m^2*kg*s^-2)
///
/// Source: Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, chapter 11; the centre of mass need not be the origin.
///
/// | h | parameter | unit | frame | meaning |
/// |---|---|---|---|---|
/// | 0 | `mass` | kg |  | mass |
/// | 1..4 | `s_i` | m | body i | centre of mass |
/// | 4..7 | `inertia_diagonal` | kg*m^2 | body i | Jxx, Jyy, Jzz about the centre of mass, in the axes of the body frame |
/// | 7..10 | `inertia_products` | kg*m^2 | body i | Jxy, Jxz, Jyz likewise: elements of the tensor with their own sign, Jxy = −∫ x y dm |
pub mod rigid_body {
    use super::{
        EnergyShape, KineticEnergy, Motion, Operations, Parameter, Scalar, exact,
        exact_mut,
    };
    /// Patterns, parameters and operation counts.
    pub const SHAPE: EnergyShape = EnergyShape {
        name: "rigid_body",
        title: "Rigid body",
        equation: "T = ½ m |ṙ + A (ω′ × s)|² + ½ ω′ᵀ J ω′, J = [Jxx Jxy Jxz; Jxy Jyy Jyz; Jxz Jyz Jzz]",
        reference: "Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, chapter 11; the centre of mass need not be the origin",
        parameters: &[
            Parameter {
                name: "mass",
                size: 1,
                offset: 0,
                unit: "kg",
                frame: "",
                meaning: "mass",
            },
            Parameter {
                name: "s_i",
                size: 3,
                offset: 1,
                unit: "m",
                frame: "body i",
                meaning: "centre of mass",
            },
            Parameter {
                name: "inertia_diagonal",
                size: 3,
                offset: 4,
                unit: "kg*m^2",
                frame: "body i",
                meaning: "Jxx, Jyy, Jzz about the centre of mass, in the axes of the body frame",
            },
            Parameter {
                name: "inertia_products",
                size: 3,
                offset: 7,
                unit: "kg*m^2",
                frame: "body i",
                meaning: "Jxy, Jxz, Jyz likewise: elements of the tensor with their own sign, Jxy = −∫ x y dm",
            },
        ],
        force_q: &[
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
        force_v: &[
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
        mass: &[
            (0, 0),
            (1, 1),
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
        ],
        operations: [
            Operations {
                additions: 49,
                multiplications: 76,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 213,
                multiplications: 247,
                divisions: 0,
                functions: 0,
            },
            Operations {
                additions: 972,
                multiplications: 1062,
                divisions: 0,
                functions: 0,
            },
        ],
    };
    /// Rigid body
    #[derive(Clone, Copy, Debug, Default)]
    pub struct RigidBody;
    impl<S: Scalar> KineticEnergy<S> for RigidBody {
        fn shape(&self) -> &'static EnergyShape {
            &SHAPE
        }
        fn energy(&self, motion: Motion<'_, S>) -> S {
            let mut value = [S::from_f64(0.0)];
            energy(motion.q, motion.v, exact(motion.h), &mut value);
            value[0]
        }
        fn force(&self, motion: Motion<'_, S>, force: &mut [S]) {
            self::force(motion.q, motion.v, motion.a, exact(motion.h), exact_mut(force));
        }
        fn tangent(
            &self,
            motion: Motion<'_, S>,
            force: &mut [S],
            force_q: &mut [S],
            force_v: &mut [S],
            mass: &mut [S],
        ) {
            tangent(
                motion.q,
                motion.v,
                motion.a,
                exact(motion.h),
                exact_mut(force),
                exact_mut(force_q),
                exact_mut(force_v),
                exact_mut(mass),
            );
        }
    }
    /// T.
    ///
    /// 49 additions, 76 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn energy<S: Scalar>(q: &[S; 7], v: &[S; 7], h: &[S; 10], energy: &mut [S; 1]) {
        let two = S::from_f64(2.0);
        let half = S::from_f64(0.5);
        let t0 = v[2] * q[6] + (v[0] * q[4] + v[1] * q[5]);
        let t1 = v[1] * q[6] + (v[0] * q[3] - v[2] * q[5]);
        let t2 = v[0] * q[5] + (v[2] * q[3] - v[1] * q[4]);
        let t3 = v[2] * q[4] + (v[1] * q[3] - v[0] * q[6]);
        let t4 = q[6] * t0 + (q[5] * t1 + (q[3] * t2 - q[4] * t3));
        let t5 = h[0] * h[2];
        let t6 = v[5] * q[6] + (q[3] * v[4] - q[4] * v[3] - v[6] * q[5]);
        let t7 = t6 * two;
        let t8 = h[0] * h[1];
        let t9 = q[4] * v[6] + (v[5] * q[3] - v[3] * q[5] - q[6] * v[4]);
        let t10 = q[5] * t0 + (q[4] * t2 + (q[3] * t3 - q[6] * t1));
        let t11 = q[5] * v[4] + (q[3] * v[6] - v[5] * q[4] - v[3] * q[6]);
        let t12 = t11 * two;
        let t13 = h[0] * h[3];
        let t14 = q[6] * t3 + (q[4] * t0 + (q[3] * t1 - q[5] * t2));
        let t15 = t9 * two;
        let t16 = h[1] * t8;
        let t17 = h[3] * t13;
        let t18 = (h[9] - t5 * h[3]) * t12 + t9 * (t16 + (t17 + h[5]));
        let t19 = t11 * (h[8] - t8 * h[3]) + (h[7] - h[2] * t8) * t9;
        let t20 = h[2] * t5;
        let t21 = h[0] * (v[2] * v[2] + (v[0] * v[0] + v[1] * v[1])) * half;
        let t22 = (t19 * two + (t20 + (h[4] + t17)) * t6) * t7
            + (t21 + (t16 + (h[6] + t20)) * (t11 * t11) * two);
        let t23 = t14 * (t13 * t15 - t5 * t11 * two) + (t18 * t15 + t22);
        energy[0] = t4 * (t5 * t7 - t8 * t9 * two)
            + (t10 * (t8 * t12 - t13 * t6 * two) + t23);
    }
    /// F.
    ///
    /// 213 additions, 247 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn force<S: Scalar>(
        q: &[S; 7],
        v: &[S; 7],
        a: &[S; 7],
        h: &[S; 10],
        force: &mut [S; 7],
    ) {
        let k4 = S::from_f64(4.0);
        let two = S::from_f64(2.0);
        let t0 = q[3] * q[5];
        let t1 = q[4] * q[6];
        let t2 = h[0] * h[2];
        let t3 = q[6] * a[5] + (q[3] * a[4] - q[4] * a[3] - q[5] * a[6]);
        let t4 = q[4] * a[6] + (q[3] * a[5] - q[5] * a[3] - q[6] * a[4]);
        let t5 = h[0] * h[1];
        let t6 = t2 * t3 - t4 * t5;
        let t7 = t6 * k4;
        let t8 = q[4] * q[5];
        let t9 = q[3] * q[6];
        let t10 = q[5] * a[4] + (q[3] * a[6] - q[4] * a[5] - q[6] * a[3]);
        let t11 = h[0] * h[3];
        let t12 = t10 * t5 - t11 * t3;
        let t13 = t12 * k4;
        let t14 = q[6] * v[4];
        let t15 = q[4] * v[6];
        let t16 = t14 + t15;
        let t17 = q[3] * v[5];
        let t18 = q[5] * v[3];
        let t19 = q[3] * v[4];
        let t20 = q[6] * v[5];
        let t21 = q[5] * v[6];
        let t22 = q[4] * v[3];
        let t23 = t19 + (t20 - t21 - t22);
        let t24 = t17 + (t15 - t14) - t18;
        let t25 = t2 * t23 - t24 * t5;
        let t26 = t25 * k4;
        let t27 = q[4] * v[5];
        let t28 = q[5] * v[4];
        let t29 = t27 + t28;
        let t30 = q[6] * v[3];
        let t31 = q[3] * v[6];
        let t32 = t31 + (t28 - t27) - t30;
        let t33 = t32 * t5 - t11 * t23;
        let t34 = t33 * k4;
        let t35 = q[4] * v[4];
        let t36 = q[3] * v[3];
        let t37 = q[6] * v[6];
        let t38 = q[5] * v[5];
        let t39 = t11 * t24 - t2 * t32;
        let t40 = t39 * k4;
        let t41 = q[3] * q[3];
        let t42 = q[4] * q[4];
        let t43 = q[6] * q[6];
        let t44 = q[5] * q[5];
        let t45 = t11 * t4 - t10 * t2;
        let t46 = h[0] * a[0] + (t41 + t42 - t43 - t44) * t45 * two;
        let t47 = (t29 - t30 - t31) * t34 + ((t35 + t36 - t37 - t38) * t40 + t46);
        let t48 = (t8 - t9) * t13 + ((t16 + (t17 + t18)) * t26 + t47);
        let t49 = q[6] * q[5];
        let t50 = q[3] * q[4];
        let t51 = t45 * k4;
        let t52 = t21 + t20;
        let t53 = t36 - t35;
        let t54 = t41 - t42;
        let t55 = t44 - t43;
        let t56 = t40 * (t30 + (t31 + t29)) + (h[0] * a[1] + t12 * (t54 + t55) * two);
        let t57 = t26 * (t52 - t22 - t19) + (t34 * (t53 + (t38 - t37)) + t56);
        let t58 = t40 * (t16 - t18 - t17) + (h[0] * a[2] + t6 * (t54 - t55) * two);
        let t59 = t26 * (t37 + (t53 - t38)) + (t34 * (t22 + (t19 + t52)) + t58);
        let t60 = q[6] * v[2] + (q[4] * v[0] + q[5] * v[1]);
        let t61 = q[6] * v[1] + (q[3] * v[0] - q[5] * v[2]);
        let t62 = q[5] * v[0] + (q[3] * v[2] - q[4] * v[1]);
        let t63 = v[4] * v[0] + (q[6] * a[2] + (a[0] * q[4] + q[5] * a[1]));
        let t64 = v[6] * v[2] + (v[5] * v[1] + t63);
        let t65 = q[6] * a[1] + (a[0] * q[3] - q[5] * a[2] - v[5] * v[2]);
        let t66 = v[6] * v[1] + (v[3] * v[0] + t65);
        let t67 = a[0] * q[5] + (q[3] * a[2] - q[4] * a[1] - v[4] * v[1]);
        let t68 = v[3] * v[2] + (v[5] * v[0] + t67);
        let t69 = q[4] * a[2] + (q[3] * a[1] - a[0] * q[6] - v[6] * v[0]);
        let t70 = v[4] * v[2] + (v[3] * v[1] + t69);
        let t71 = q[4] * v[2] + (q[3] * v[1] - q[6] * v[0]);
        let t72 = q[5] * t66 + (q[3] * t68 - q[4] * t70 - v[4] * t71);
        let t73 = v[6] * t60 + (v[5] * t61 + (v[3] * t62 + (q[6] * t64 + t72)));
        let t74 = (h[8] - h[3] * t5) * two;
        let t75 = (h[7] - h[2] * t5) * two;
        let t76 = h[2] * t2;
        let t77 = h[3] * t11;
        let t78 = (t76 + (h[4] + t77)) * two;
        let t79 = q[4] * t68 + (q[3] * t70 - q[6] * t66 - v[6] * t61);
        let t80 = v[5] * t60 + (v[4] * t62 + (v[3] * t71 + (q[5] * t64 + t79)));
        let t81 = t10 * t74 + (t4 * t75 + (t3 * t78 - t11 * t80));
        let t82 = t2 * t73 + t81;
        let t83 = t82 * two;
        let t84 = q[4] * t64 + (q[3] * t66 - q[5] * t68 - v[5] * t62);
        let t85 = v[6] * t71 + (v[4] * t60 + (v[3] * t61 + (q[6] * t70 + t84)));
        let t86 = (h[9] - t2 * h[3]) * two;
        let t87 = h[1] * t5;
        let t88 = (t87 + (t77 + h[5])) * two;
        let t89 = t10 * t86 + (t3 * t75 + (t4 * t88 - t5 * t73));
        let t90 = t11 * t85 + t89;
        let t91 = t90 * two;
        let t92 = (t87 + (t76 + h[6])) * two;
        let t93 = t4 * t86 + (t3 * t74 + (t10 * t92 - t2 * t85));
        let t94 = t5 * t80 + t93;
        let t95 = t94 * two;
        let t96 = q[6] * t60 + (q[5] * t61 + (q[3] * t62 - q[4] * t71));
        let t97 = q[5] * t60 + (q[4] * t62 + (q[3] * t71 - q[6] * t61));
        let t98 = t32 * t74 + (t24 * t75 + (t23 * t78 - t11 * t97));
        let t99 = (t2 * t96 + t98) * two;
        let t100 = v[4] * t99;
        let t101 = -(q[4] * t83) - q[5] * t91 - q[6] * t95 - t100;
        let t102 = q[6] * t71 + (q[4] * t60 + (q[3] * t61 - q[5] * t62));
        let t103 = t32 * t86 + (t23 * t75 + (t24 * t88 - t5 * t96));
        let t104 = (t11 * t102 + t103) * two;
        let t105 = v[5] * t104;
        let t106 = t24 * t86 + (t23 * t74 + (t32 * t92 - t2 * t102));
        let t107 = (t5 * t97 + t106) * two;
        let t108 = v[6] * t107;
        let t109 = t26 * t62 + (t34 * t71 + (t40 * t61 + (t108 + (t100 + t105))));
        let t110 = v[5] * t107;
        let t111 = v[3] * t99;
        let t112 = q[3] * two;
        let t113 = v[6] * t104;
        let t114 = t40 * t60 + (t113 - t25 * t71 * k4 - t111 - t110);
        let t115 = t82 * t112 - q[6] * t91 - t113 - (t34 * t62 + t114);
        let t116 = v[6] * t99;
        let t117 = v[3] * t104;
        let t118 = v[4] * t107;
        let t119 = t34 * t60 + (t118 - t39 * t62 * k4 - t117 - t116);
        let t120 = t90 * t112 - q[4] * t95 - t118 - (t26 * t61 + t119);
        let t121 = v[4] * t104;
        let t122 = v[3] * t107;
        let t123 = v[5] * t99;
        let t124 = t26 * t60 + (t123 - t33 * t61 * k4 - t122 - t121);
        let t125 = t94 * t112 - q[5] * t83 - t123 - (t40 * t71 + t124);
        force[0] = (t0 + t1) * t7 + t48;
        force[1] = t7 * (t49 - t50) + ((t9 + t8) * t51 + t57);
        force[2] = t13 * (t50 + t49) + (t51 * (t1 - t0) + t59);
        force[3] = t101 - t105 - t108 - t109;
        force[4] = t110 + (t111 + (q[5] * t94 * two + t115));
        force[5] = t116 + (t117 + (q[6] * t82 * two + t120));
        force[6] = t121 + (t122 + (q[4] * t90 * two + t125));
    }
    /// F, F_q, F_q̇ and F_q̈.
    ///
    /// 972 additions, 1062 multiplications, 0 divisions, 0 functions.
    #[inline]
    pub fn tangent<S: Scalar>(
        q: &[S; 7],
        v: &[S; 7],
        a: &[S; 7],
        h: &[S; 10],
        force: &mut [S; 7],
        force_q: &mut [S; 28],
        force_v: &mut [S; 40],
        mass: &mut [S; 25],
    ) {
        let k4 = S::from_f64(4.0);
        let two = S::from_f64(2.0);
        let k8 = S::from_f64(8.0);
        let half = S::from_f64(0.5);
        let t0 = q[3] * q[5];
        let t1 = q[4] * q[6];
        let t2 = t0 + t1;
        let t3 = h[0] * h[2];
        let t4 = a[5] * q[6] + (q[3] * a[4] - q[4] * a[3] - a[6] * q[5]);
        let t5 = q[4] * a[6] + (a[5] * q[3] - a[3] * q[5] - q[6] * a[4]);
        let t6 = h[0] * h[1];
        let t7 = t3 * t4 - t5 * t6;
        let t8 = t7 * k4;
        let t9 = q[4] * q[5];
        let t10 = q[6] * q[3];
        let t11 = t9 - t10;
        let t12 = q[5] * a[4] + (q[3] * a[6] - a[5] * q[4] - a[3] * q[6]);
        let t13 = h[0] * h[3];
        let t14 = t12 * t6 - t13 * t4;
        let t15 = t14 * k4;
        let t16 = q[6] * v[4];
        let t17 = q[4] * v[6];
        let t18 = t16 + t17;
        let t19 = q[3] * v[5];
        let t20 = q[5] * v[3];
        let t21 = t18 + (t19 + t20);
        let t22 = q[3] * v[4];
        let t23 = q[6] * v[5];
        let t24 = q[5] * v[6];
        let t25 = q[4] * v[3];
        let t26 = t22 + (t23 - t24) - t25;
        let t27 = t19 + (t17 - t16) - t20;
        let t28 = t3 * t26 - t27 * t6;
        let t29 = t28 * k4;
        let t30 = q[4] * v[5];
        let t31 = q[5] * v[4];
        let t32 = t30 + t31;
        let t33 = q[6] * v[3];
        let t34 = q[3] * v[6];
        let t35 = t32 - t33 - t34;
        let t36 = t34 + (t31 - t30) - t33;
        let t37 = t36 * t6 - t13 * t26;
        let t38 = t37 * k4;
        let t39 = q[4] * v[4];
        let t40 = q[3] * v[3];
        let t41 = q[6] * v[6];
        let t42 = q[5] * v[5];
        let t43 = t39 + t40 - t41 - t42;
        let t44 = t13 * t27 - t3 * t36;
        let t45 = t44 * k4;
        let t46 = t13 * t5 - t12 * t3;
        let t47 = q[3] * q[3];
        let t48 = q[4] * q[4];
        let t49 = q[6] * q[6];
        let t50 = q[5] * q[5];
        let t51 = t47 + t48 - t49 - t50;
        let t52 = t51 * two;
        let t53 = t35 * t38 + (t43 * t45 + (h[0] * a[0] + t46 * t52));
        let t54 = q[6] * q[5];
        let t55 = q[4] * q[3];
        let t56 = t54 - t55;
        let t57 = t10 + t9;
        let t58 = t46 * k4;
        let t59 = t24 + t23;
        let t60 = t59 - t25 - t22;
        let t61 = t40 - t39;
        let t62 = t61 + (t42 - t41);
        let t63 = t33 + (t34 + t32);
        let t64 = t47 - t48;
        let t65 = t50 - t49;
        let t66 = t64 + t65;
        let t67 = t66 * two;
        let t68 = t38 * t62 + (t45 * t63 + (h[0] * a[1] + t14 * t67));
        let t69 = t55 + t54;
        let t70 = t1 - t0;
        let t71 = t41 + (t61 - t42);
        let t72 = t25 + (t22 + t59);
        let t73 = t18 - t20 - t19;
        let t74 = t64 - t65;
        let t75 = t74 * two;
        let t76 = t38 * t72 + (t45 * t73 + (h[0] * a[2] + t7 * t75));
        let t77 = q[6] * v[2] + (q[4] * v[0] + q[5] * v[1]);
        let t78 = q[6] * v[1] + (q[3] * v[0] - q[5] * v[2]);
        let t79 = q[5] * v[0] + (q[3] * v[2] - q[4] * v[1]);
        let t80 = v[4] * v[0] + (q[6] * a[2] + (a[0] * q[4] + q[5] * a[1]));
        let t81 = v[6] * v[2] + (v[5] * v[1] + t80);
        let t82 = q[6] * a[1] + (a[0] * q[3] - q[5] * a[2] - v[5] * v[2]);
        let t83 = v[6] * v[1] + (v[3] * v[0] + t82);
        let t84 = a[0] * q[5] + (q[3] * a[2] - q[4] * a[1] - v[4] * v[1]);
        let t85 = v[3] * v[2] + (v[5] * v[0] + t84);
        let t86 = q[4] * a[2] + (q[3] * a[1] - a[0] * q[6] - v[6] * v[0]);
        let t87 = v[4] * v[2] + (v[3] * v[1] + t86);
        let t88 = q[4] * v[2] + (q[3] * v[1] - q[6] * v[0]);
        let t89 = q[5] * t83 + (q[3] * t85 - q[4] * t87 - v[4] * t88);
        let t90 = v[6] * t77 + (v[5] * t78 + (v[3] * t79 + (q[6] * t81 + t89)));
        let t91 = h[8] - h[3] * t6;
        let t92 = t91 * two;
        let t93 = h[7] - h[2] * t6;
        let t94 = t93 * two;
        let t95 = h[2] * t3;
        let t96 = h[3] * t13;
        let t97 = t95 + (h[4] + t96);
        let t98 = t97 * two;
        let t99 = q[4] * t85 + (q[3] * t87 - q[6] * t83 - v[6] * t78);
        let t100 = v[5] * t77 + (v[4] * t79 + (v[3] * t88 + (q[5] * t81 + t99)));
        let t101 = t12 * t92 + (t5 * t94 + (t4 * t98 - t13 * t100));
        let t102 = t3 * t90 + t101;
        let t103 = q[4] * two;
        let t104 = q[4] * t81 + (q[3] * t83 - q[5] * t85 - v[5] * t79);
        let t105 = v[6] * t88 + (v[4] * t77 + (v[3] * t78 + (q[6] * t87 + t104)));
        let t106 = h[9] - t3 * h[3];
        let t107 = t106 * two;
        let t108 = h[1] * t6;
        let t109 = t108 + (t96 + h[5]);
        let t110 = t109 * two;
        let t111 = t12 * t107 + (t4 * t94 + (t5 * t110 - t6 * t90));
        let t112 = t13 * t105 + t111;
        let t113 = q[5] * two;
        let t114 = t108 + (t95 + h[6]);
        let t115 = t114 * two;
        let t116 = t5 * t107 + (t4 * t92 + (t12 * t115 - t3 * t105));
        let t117 = t6 * t100 + t116;
        let t118 = q[6] * two;
        let t119 = q[6] * t77 + (q[5] * t78 + (q[3] * t79 - q[4] * t88));
        let t120 = q[5] * t77 + (q[4] * t79 + (q[3] * t88 - q[6] * t78));
        let t121 = t36 * t92 + (t27 * t94 + (t26 * t98 - t13 * t120));
        let t122 = t3 * t119 + t121;
        let t123 = t122 * two;
        let t124 = v[4] * t123;
        let t125 = -(t102 * t103) - t112 * t113 - t117 * t118 - t124;
        let t126 = q[6] * t88 + (q[4] * t77 + (q[3] * t78 - q[5] * t79));
        let t127 = t36 * t107 + (t26 * t94 + (t27 * t110 - t6 * t119));
        let t128 = t13 * t126 + t127;
        let t129 = t128 * two;
        let t130 = v[5] * t129;
        let t131 = t27 * t107 + (t26 * t92 + (t36 * t115 - t3 * t126));
        let t132 = t6 * t120 + t131;
        let t133 = t132 * two;
        let t134 = v[6] * t133;
        let t135 = t29 * t79 + (t38 * t88 + (t45 * t78 + (t134 + (t124 + t130))));
        let t136 = v[5] * t133;
        let t137 = v[3] * t123;
        let t138 = t117 * two;
        let t139 = q[3] * two;
        let t140 = v[6] * t129;
        let t141 = t88 * k4;
        let t142 = t38 * t79 + (t45 * t77 + (t140 - t28 * t141 - t137 - t136));
        let t143 = q[5] * t138 + (t102 * t139 - t112 * t118 - t140 - t142);
        let t144 = v[6] * t123;
        let t145 = v[3] * t129;
        let t146 = t102 * two;
        let t147 = v[4] * t133;
        let t148 = t79 * k4;
        let t149 = t29 * t78 + (t38 * t77 + (t147 - t44 * t148 - t145 - t144));
        let t150 = q[6] * t146 + (t112 * t139 - t103 * t117 - t147 - t149);
        let t151 = v[4] * t129;
        let t152 = v[3] * t133;
        let t153 = t112 * two;
        let t154 = v[5] * t123;
        let t155 = t78 * k4;
        let t156 = t45 * t88 + (t29 * t77 + (t154 - t37 * t155 - t152 - t151));
        let t157 = q[4] * t153 + (t117 * t139 - t102 * t113 - t154 - t156);
        let t158 = v[6] * t38;
        let t159 = q[6] * k4;
        let t160 = t14 * t159;
        let t161 = q[5] * k4;
        let t162 = t7 * t161;
        let t163 = q[3] * k4;
        let t164 = t46 * t163;
        let t165 = v[5] * t29;
        let t166 = v[3] * t45;
        let t167 = -t158 - t160 + (t162 + t164 + (t165 + t166));
        let t168 = t3 * v[4];
        let t169 = v[5] * t6;
        let t170 = t168 - t169;
        let t171 = t21 * k4;
        let t172 = v[6] * t6;
        let t173 = t13 * v[4];
        let t174 = t172 - t173;
        let t175 = t35 * k4;
        let t176 = t13 * v[5];
        let t177 = t3 * v[6];
        let t178 = t176 - t177;
        let t179 = t43 * k4;
        let t180 = a[4] * t3;
        let t181 = a[5] * t6;
        let t182 = t180 - t181;
        let t183 = t2 * k4;
        let t184 = a[5] * t13;
        let t185 = a[6] * t3;
        let t186 = t184 - t185;
        let t187 = a[6] * t6;
        let t188 = a[4] * t13;
        let t189 = t187 - t188;
        let t190 = t11 * k4;
        let t191 = t178 * t179 + (t182 * t183 + (t52 * t186 + t189 * t190));
        let t192 = q[4] * k4;
        let t193 = v[4] * t45 + t7 * t159 + (v[6] * t29 + v[5] * t38);
        let t194 = t14 * t161 + t46 * t192 + t193;
        let t195 = t13 * v[3];
        let t196 = t195 - t169;
        let t197 = t13 * v[6];
        let t198 = t3 * v[5];
        let t199 = t197 + t198;
        let t200 = a[3] * t13;
        let t201 = t200 - t181;
        let t202 = a[6] * t13;
        let t203 = a[5] * t3;
        let t204 = t202 + t203;
        let t205 = a[3] * t3;
        let t206 = t187 + t205;
        let t207 = t206 * k4;
        let t208 = t3 * v[3];
        let t209 = t172 + t208;
        let t210 = t209 * k4;
        let t211 = t190 * t201 + (t52 * t204 - t2 * t207 - t21 * t210);
        let t212 = v[5] * t45;
        let t213 = t46 * t161;
        let t214 = t14 * t192;
        let t215 = t7 * t163;
        let t216 = v[4] * t38;
        let t217 = v[3] * t29;
        let t218 = -t212 - t213 + (t214 + t215 + (t216 + t217));
        let t219 = v[3] * t6;
        let t220 = t219 - t177;
        let t221 = v[4] * t6;
        let t222 = t197 + t221;
        let t223 = a[3] * t6;
        let t224 = t223 - t185;
        let t225 = a[4] * t6;
        let t226 = t202 + t225;
        let t227 = t168 + t195;
        let t228 = t227 * k4;
        let t229 = t180 + t200;
        let t230 = t183 * t224 + (t190 * t226 - t43 * t228 - t51 * t229 * two);
        let t231 = t198 + t221;
        let t232 = t208 - t173;
        let t233 = t203 + t225;
        let t234 = v[4] * t29;
        let t235 = t7 * t192;
        let t236 = t205 - t188;
        let t237 = t14 * t163;
        let t238 = t46 * t159;
        let t239 = v[3] * t38;
        let t240 = v[6] * t45;
        let t241 = t184 + t223;
        let t242 = t241 * k4;
        let t243 = t52 * t236 - t237 - t238 - t239 - t240 - t11 * t242;
        let t244 = t176 + t219;
        let t245 = t244 * k4;
        let t246 = t179 * t232 + (t183 * t233 + (t234 + (t235 + (t243 - t35 * t245))));
        let t247 = t237 - t234 + (t238 + t239 + (t240 - t235));
        let t248 = t60 * k4;
        let t249 = t62 * k4;
        let t250 = t63 * k4;
        let t251 = t56 * k4;
        let t252 = t57 * k4;
        let t253 = t178 * t250 + (t182 * t251 + (t67 * t189 + t186 * t252));
        let t254 = t67 * t201 - t215 - t214 - t217 - t216 - t56 * t207;
        let t255 = t199 * t250 + (t204 * t252 + (t212 + (t213 + (t254 - t60 * t210))));
        let t256 = t229 * k4;
        let t257 = t224 * t251 + (t67 * t226 + (t194 - t57 * t256 - t63 * t228));
        let t258 = t236 * t252 + (t167 - t62 * t245 - t66 * t241 * two);
        let t259 = t71 * k4;
        let t260 = t72 * k4;
        let t261 = t73 * k4;
        let t262 = t69 * k4;
        let t263 = t70 * k4;
        let t264 = t178 * t261 + (t189 * t262 + (t186 * t263 + (t218 + t75 * t182)));
        let t265 = t204 * t263 + (t247 - t71 * t210 - t74 * t206 * two);
        let t266 = t75 * t224 - t164 - t162 - t166 - t165 - t70 * t256;
        let t267 = t222 * t260 + (t226 * t262 + (t158 + (t160 + (t266 - t73 * t228))));
        let t268 = t236 * t263 + (t75 * t233 + (t194 - t69 * t242 - t72 * t245));
        let t269 = t3 * t79;
        let t270 = t13 * t88;
        let t271 = t269 - t270;
        let t272 = v[6] * t91;
        let t273 = v[5] * t93;
        let t274 = t271 + (t272 + (v[4] * t97 + t273));
        let t275 = v[4] * k8;
        let t276 = t13 * t78;
        let t277 = t6 * t79;
        let t278 = t276 - t277;
        let t279 = v[6] * t106;
        let t280 = v[4] * t93;
        let t281 = t278 + (t279 + (t280 + v[5] * t109));
        let t282 = v[5] * k8;
        let t283 = t6 * t88;
        let t284 = t3 * t78;
        let t285 = t283 - t284;
        let t286 = v[4] * t91;
        let t287 = v[5] * t106;
        let t288 = t285 + (v[6] * t114 + (t286 + t287));
        let t289 = v[6] * k8;
        let t290 = t3 * t85;
        let t291 = a[6] * t91;
        let t292 = a[5] * t93;
        let t293 = t13 * t87;
        let t294 = t290 + (t291 + (a[4] * t97 + t292)) - t293;
        let t295 = -(t274 * t275) - t281 * t282 - t288 * t289 - t192 * t294;
        let t296 = t13 * t83;
        let t297 = a[6] * t106;
        let t298 = a[4] * t93;
        let t299 = t6 * t85;
        let t300 = t296 + (t297 + (a[5] * t109 + t298)) - t299;
        let t301 = t6 * t87;
        let t302 = a[5] * t106;
        let t303 = a[4] * t91;
        let t304 = t3 * t83;
        let t305 = t301 + (t302 + (a[6] * t114 + t303)) - t304;
        let t306 = t295 - t161 * t300 - t159 * t305 - t155 * t178 - t141 * t174;
        let t307 = t29 * v[2];
        let t308 = t38 * v[1];
        let t309 = t45 * v[0];
        let t310 = t29 * v[1];
        let t311 = t38 * v[2];
        let t312 = t310 - t311;
        let t313 = t3 * t77;
        let t314 = v[3] * t91;
        let t315 = t313 + (v[5] * t114 + (t314 - t277 - t279));
        let t316 = t13 * t79;
        let t317 = t3 * t88;
        let t318 = t316 + t317;
        let t319 = v[5] * t91;
        let t320 = v[6] * t93;
        let t321 = t318 + (t319 + (v[3] * t97 - t320));
        let t322 = t3 * t81;
        let t323 = a[3] * t91;
        let t324 = t322 + (t323 + (a[5] * t114 - t299 - t297));
        let t325 = t3 * t87;
        let t326 = t13 * t85;
        let t327 = a[5] * t91;
        let t328 = a[6] * t93;
        let t329 = t325 + (t326 + (t327 + (a[3] * t97 - t328)));
        let t330 = t13 * t77;
        let t331 = t283 + t330;
        let t332 = v[3] * t93;
        let t333 = t331 + (v[6] * t109 - t332 - t287);
        let t334 = t13 * t81;
        let t335 = a[3] * t93;
        let t336 = t334 + (a[6] * t109 + (t301 - t335 - t302));
        let t337 = t192 * t329 - t282 * t333 - t161 * t336 - t155 * t199;
        let t338 = t275 * t321 + (t148 * t209 + (t159 * t324 + (t337 - t141 * t196)));
        let t339 = t29 * v[0];
        let t340 = -t339 - t153;
        let t341 = t45 * v[2];
        let t342 = t6 * t78;
        let t343 = t316 + t342;
        let t344 = v[4] * t106;
        let t345 = t343 + (t320 + (v[3] * t109 - t344));
        let t346 = t330 - t284;
        let t347 = v[6] * t97 + (t332 + (t346 - t286));
        let t348 = t6 * t83;
        let t349 = a[4] * t106;
        let t350 = t348 + (t328 + (a[3] * t109 + (t326 - t349)));
        let t351 = t335 + (a[6] * t97 + (t334 - t304 - t303));
        let t352 = t6 * t77;
        let t353 = t269 + t352;
        let t354 = v[3] * t106;
        let t355 = t353 + (v[4] * t114 - t354 - t272);
        let t356 = t6 * t81;
        let t357 = a[3] * t106;
        let t358 = t356 + (a[4] * t114 + (t290 - t291 - t357));
        let t359 = t192 * t351 - t289 * t355 - t159 * t358 - t141 * t222;
        let t360 = t275 * t347 + (t155 * t227 + (t161 * t350 + (t359 - t148 * t220)));
        let t361 = t38 * v[0];
        let t362 = t45 * v[1];
        let t363 = t361 - t362;
        let t364 = t317 + t342;
        let t365 = t364 + (t344 + (v[3] * t114 - t319));
        let t366 = t352 - t270;
        let t367 = v[4] * t109 + (t354 + (t366 - t273));
        let t368 = t349 + (a[3] * t114 + (t325 + t348 - t327));
        let t369 = t357 + (a[4] * t109 + (t356 - t293 - t292));
        let t370 = t276 + t313;
        let t371 = t370 + (v[5] * t97 - t314 - t280);
        let t372 = a[5] * t97 + (t296 + t322 - t298 - t323);
        let t373 = t161 * t369 - t275 * t371 - t192 * t372 - t155 * t232;
        let t374 = t282 * t367 + (t141 * t244 + (t159 * t368 + (t373 - t148 * t231)));
        let t375 = v[3] * k8;
        let t376 = t77 * k4;
        let t377 = t146 + t312 - t281 * t289 - t159 * t300 - t178 * t376;
        let t378 = t141 * t170 + (t161 * t305 + (t163 * t294 + (t377 - t148 * t174)));
        let t379 = t307 - t309 - t321 * t375 - t282 * t315 - t289 * t333;
        let t380 = t379 - t163 * t329 - t161 * t324 - t159 * t336 - t199 * t376;
        let t381 = -t362 - t361;
        let t382 = t161 * t358 + (t138 - t347 * t375 - t163 * t351 - t148 * t222);
        let t383 = t282 * t355 + (t141 * t220 + (t227 * t376 + (t159 * t350 + t382)));
        let t384 = t163 * t372 + (t340 - t282 * t365 - t161 * t368 - t232 * t376);
        let t385 = t371 * t375 + (t148 * t244 + (t141 * t231 + (t159 * t369 + t384)));
        let t386 = t153 - t339;
        let t387 = t341 - t275 * t288 - t192 * t305 - t174 * t376 - t155 * t170;
        let t388 = t281 * t375 + (t148 * t178 + (t159 * t294 + (t163 * t300 + t387)));
        let t389 = t381 - t138 - t289 * t321 - t159 * t329 - t196 * t376;
        let t390 = t148 * t199 + (t155 * t209 + (t192 * t324 + (t163 * t336 + t389)));
        let t391 = t307 - t308;
        let t392 = t391 - t345 * t375 - t275 * t355 - t289 * t347 - t163 * t350;
        let t393 = t392 - t192 * t358 - t159 * t351 - t222 * t376 - t155 * t220;
        let t394 = -t311 - t310;
        let t395 = t192 * t368 + (t146 - t367 * t375 - t163 * t369 - t155 * t231);
        let t396 = t275 * t365 + (t148 * t232 + (t244 * t376 + (t159 * t372 + t395)));
        let t397 = t138 + t363 - t274 * t282 - t161 * t294 - t170 * t376;
        let t398 = t155 * t174 + (t192 * t300 + (t163 * t305 + (t397 - t141 * t178)));
        let t399 = t386 - t341 - t315 * t375 - t163 * t324 - t141 * t199;
        let t400 = t155 * t196 + (t209 * t376 + (t161 * t329 + (t192 * t336 + t399)));
        let t401 = t394 - t146 - t275 * t345 - t192 * t350 - t220 * t376;
        let t402 = t141 * t227 + (t155 * t222 + (t161 * t351 + (t163 * t358 + t401)));
        let t403 = t309 - t391 - t365 * t375 - t275 * t367 - t282 * t371;
        let t404 = t403 - t163 * t368 - t192 * t369 - t161 * t372 - t231 * t376;
        let t405 = t28 * t161;
        let t406 = t44 * t163;
        let t407 = t37 * t159;
        let t408 = t405 + (t406 - t407);
        let t409 = q[5] * t6;
        let t410 = q[4] * t3;
        let t411 = t409 - t410;
        let t412 = q[6] * t3;
        let t413 = q[5] * t13;
        let t414 = t412 - t413;
        let t415 = q[4] * t13;
        let t416 = q[6] * t6;
        let t417 = t415 - t416;
        let t418 = t28 * t159;
        let t419 = t37 * t161;
        let t420 = t44 * t192;
        let t421 = t418 + (t419 + t420);
        let t422 = q[3] * t3;
        let t423 = t416 + t422;
        let t424 = q[3] * t13;
        let t425 = t409 - t424;
        let t426 = q[6] * t13;
        let t427 = q[5] * t3;
        let t428 = t426 + t427;
        let t429 = t428 * k4;
        let t430 = t37 * t192;
        let t431 = t28 * t163;
        let t432 = t44 * t161;
        let t433 = t430 + (t431 - t432);
        let t434 = q[3] * t6;
        let t435 = t412 - t434;
        let t436 = t410 + t424;
        let t437 = q[4] * t6;
        let t438 = t426 + t437;
        let t439 = t438 * k4;
        let t440 = t28 * t192;
        let t441 = t44 * t159;
        let t442 = t37 * t163;
        let t443 = t440 + (-t441 - t442);
        let t444 = t413 + t434;
        let t445 = t415 - t422;
        let t446 = t427 + t437;
        let t447 = t446 * k4;
        let t448 = t441 + (t442 - t440);
        let t449 = t432 + (-t430 - t431);
        let t450 = t407 + (-t405 - t406);
        let t451 = t3 * t2 - t13 * t11;
        let t452 = t13 * t51 * half - t6 * t2;
        let t453 = t6 * t11 - t3 * t51 * half;
        let t454 = t3 * t21 - t13 * t35;
        let t455 = t450 - t275 * t451 - t282 * t452 - t289 * t453 - t192 * t454;
        let t456 = t13 * t43 - t6 * t21;
        let t457 = t35 * t6 - t3 * t43;
        let t458 = t3 * t56 - t13 * t66 * half;
        let t459 = t13 * t57 - t6 * t56;
        let t460 = t3 * t60 - t13 * t62;
        let t461 = t13 * t63 - t6 * t60;
        let t462 = t443 - t275 * t458 - t282 * t459 - t192 * t460 - t161 * t461;
        let t463 = t6 * t62 - t3 * t63;
        let t464 = t6 * t66 - t3 * t57 * two;
        let t465 = v[6] * k4;
        let t466 = t6 * t69 - t3 * t70;
        let t467 = t3 * t71 - t13 * t72;
        let t468 = t13 * t73 - t6 * t71;
        let t469 = t6 * t72 - t3 * t73;
        let t470 = t449 - t289 * t466 - t192 * t467 - t161 * t468 - t159 * t469;
        let t471 = t3 * t74 - t13 * t69 * two;
        let t472 = v[4] * k4;
        let t473 = t13 * t70 * two - t6 * t74;
        let t474 = v[5] * k4;
        let t475 = q[5] * t106;
        let t476 = q[4] * t91;
        let t477 = t475 + (t476 + q[6] * t114);
        let t478 = q[4] * t93;
        let t479 = q[6] * t106;
        let t480 = t478 + (q[5] * t109 + t479);
        let t481 = q[6] * t91;
        let t482 = q[5] * t93;
        let t483 = t481 + (q[4] * t97 + t482);
        let t484 = t275 * t483 - t192 * t271 - t161 * t278 - t159 * t285;
        let t485 = t282 * t480 + (t484 - t155 * t414 - t141 * t417 - t148 * t411);
        let t486 = q[5] * t91;
        let t487 = q[6] * t93;
        let t488 = t486 + (q[3] * t97 - t487);
        let t489 = q[3] * t93;
        let t490 = t489 + (t475 - q[6] * t109);
        let t491 = q[3] * t91;
        let t492 = t491 + (q[5] * t114 - t479);
        let t493 = t192 * t318 - t275 * t488 - t282 * t490 - t289 * t492;
        let t494 = t277 - t313;
        let t495 = t493 - t161 * t331 - t159 * t494 - t141 * t425 - t148 * t423;
        let t496 = t122 * k4;
        let t497 = q[6] * t97 + (t489 - t476);
        let t498 = q[4] * t106;
        let t499 = t487 + (q[3] * t109 - t498);
        let t500 = q[3] * t106;
        let t501 = t500 + (t481 - q[4] * t114);
        let t502 = t192 * t346 - t275 * t497 - t282 * t499 - t289 * t501;
        let t503 = t161 * t343 + (t502 - t159 * t353 - t155 * t436 - t148 * t435);
        let t504 = t128 * k4;
        let t505 = t478 + t491 - q[5] * t97;
        let t506 = q[4] * t109 + (t500 - t482);
        let t507 = t498 + (q[3] * t114 - t486);
        let t508 = t161 * t366 - t275 * t505 - t282 * t506 - t289 * t507;
        let t509 = t159 * t364 + (t508 - t192 * t370 - t155 * t445 - t141 * t444);
        let t510 = t132 * k4;
        let t511 = -t419 - t420 - t418;
        let t512 = t161 * t457 + (t163 * t454 - t289 * t452 - t159 * t456);
        let t513 = t161 * t463 + (t163 * t460 + (t433 - t289 * t459 - t159 * t461));
        let t514 = v[3] * k4;
        let t515 = t161 * t469 + (t163 * t467 + (t443 - t159 * t468 - t465 * t473));
        let t516 = t163 * t271 - t375 * t483 - t282 * t477 - t159 * t278;
        let t517 = t141 * t411 + (t161 * t285 + (t516 - t376 * t414 - t148 * t417));
        let t518 = t161 * t494 - t289 * t490 - t163 * t318 - t159 * t331;
        let t519 = t375 * t488 + (t141 * t423 + (t376 * t428 + (t518 - t148 * t425)));
        let t520 = t161 * t353 - t289 * t499 - t376 * t436 - t163 * t346;
        let t521 = t375 * t497 + (t148 * t438 + (t141 * t435 + (t159 * t343 + t520)));
        let t522 = t159 * t366 - t504 - t289 * t506 - t161 * t364 - t376 * t445;
        let t523 = t375 * t505 + (t163 * t370 + (t522 - t141 * t446 - t148 * t444));
        let t524 = t159 * t454 + (t163 * t456 + (t449 - t275 * t453 - t192 * t457));
        let t525 = t159 * t460 + (t163 * t461 + (t511 - t192 * t463 - t464 * t472));
        let t526 = t159 * t467 + (t163 * t468 + (t408 - t275 * t466 - t192 * t469));
        let t527 = t163 * t278 - t375 * t480 - t289 * t483 - t192 * t285;
        let t528 = t148 * t414 + (t159 * t271 + (t527 - t376 * t417 - t155 * t411));
        let t529 = t163 * t331 - t510 - t275 * t492 - t192 * t494 - t159 * t318;
        let t530 = t375 * t490 + (t529 - t376 * t425 - t155 * t423 - t148 * t428);
        let t531 = t376 * t438 - t275 * t501 - t163 * t343 - t192 * t353;
        let t532 = t375 * t499 + (t148 * t436 + (t531 - t155 * t435 - t159 * t346));
        let t533 = t192 * t364 + (t496 - t275 * t507 - t376 * t444 - t163 * t366);
        let t534 = t375 * t506 + (t148 * t445 + (t155 * t446 + (t159 * t370 + t533)));
        let t535 = t192 * t456 + (t163 * t457 + (t448 - t282 * t451 - t161 * t454));
        let t536 = t192 * t461 + (t163 * t463 + (t450 - t282 * t458 - t161 * t460));
        let t537 = t192 * t468 + (t163 * t469 + (t511 - t161 * t467 - t471 * t474));
        let t538 = t510 - t375 * t477 - t275 * t480 - t161 * t271 - t376 * t411;
        let t539 = t155 * t417 + (t192 * t278 + (t163 * t285 + (t538 - t141 * t414)));
        let t540 = t192 * t331 + (t163 * t494 + (t504 - t282 * t488 - t376 * t423));
        let t541 = t375 * t492 + (t141 * t428 + (t155 * t425 + (t161 * t318 + t540)));
        let t542 = t161 * t346 - t496 - t282 * t497 - t192 * t343 - t376 * t435;
        let t543 = t375 * t501 + (t163 * t353 + (t542 - t155 * t438 - t141 * t436));
        let t544 = t376 * t446 - t282 * t505 - t163 * t364 - t161 * t370;
        let t545 = t375 * t507 + (t155 * t444 + (t544 - t141 * t445 - t192 * t366));
        force[0] = t2 * t8 + (t11 * t15 + (t21 * t29 + t53));
        force[1] = t8 * t56 + (t57 * t58 + (t29 * t60 + t68));
        force[2] = t15 * t69 + (t58 * t70 + (t29 * t71 + t76));
        force[3] = t125 - t130 - t134 - t135;
        force[4] = t136 + (t137 + t143);
        force[5] = t144 + (t145 + t150);
        force[6] = t151 + (t152 + t157);
        force_q[0] = t167 + (t170 * t171 + (t174 * t175 + t191));
        force_q[1] = t194 + (t175 * t196 + (t179 * t199 + t211));
        force_q[2] = t218 + (t171 * t220 + (t175 * t222 + t230));
        force_q[3] = t171 * t231 + t246;
        force_q[4] = t247 + (t170 * t248 + (t174 * t249 + t253));
        force_q[5] = t196 * t249 + t255;
        force_q[6] = t220 * t248 + (t222 * t249 + t257);
        force_q[7] = t231 * t248 + (t232 * t250 + (t233 * t251 + t258));
        force_q[8] = t170 * t259 + (t174 * t260 + t264);
        force_q[9] = t196 * t260 + (t199 * t261 + (t201 * t262 + t265));
        force_q[10] = t220 * t259 + t267;
        force_q[11] = t231 * t259 + (t232 * t261 + t268);
        force_q[12] = t306 - t148 * t170 - t307 - t308 - t309;
        force_q[13] = t312 + (t289 * t315 + t338 - t146);
        force_q[14] = t340 + (t341 + (t282 * t345 + t360));
        force_q[15] = t363 + (t289 * t365 + t374 - t138);
        force_q[16] = t282 * t288 + (t274 * t375 + t378);
        force_q[17] = t308 + (t380 - t141 * t209 - t148 * t196);
        force_q[18] = t381 + (t289 * t345 + t383);
        force_q[19] = t289 * t367 + t385 - t341;
        force_q[20] = t386 + (t274 * t289 + t388);
        force_q[21] = t275 * t315 + (t333 * t375 + t390);
        force_q[22] = t309 + (t393 - t148 * t227);
        force_q[23] = t394 + (t289 * t371 + t396);
        force_q[24] = t275 * t281 + (t288 * t375 + t398);
        force_q[25] = t282 * t321 + (t275 * t333 + t400);
        force_q[26] = t282 * t347 + (t355 * t375 + t402);
        force_q[27] = t404 - t155 * t244 - t141 * t232;
        force_v[0] = t408 + (t171 * t411 + (t179 * t414 + t175 * t417));
        force_v[1] = t421 + (t171 * t423 + (t175 * t425 - t43 * t429));
        force_v[2] = t433 + (t171 * t435 + (t179 * t436 - t35 * t439));
        force_v[3] = t443 + (t175 * t444 + (t179 * t445 - t21 * t447));
        force_v[4] = t448 + (t248 * t411 + (t250 * t414 + t249 * t417));
        force_v[5] = t449 + (t248 * t423 + (t249 * t425 - t63 * t429));
        force_v[6] = t248 * t435 + (t250 * t436 + (t421 - t62 * t439));
        force_v[7] = t249 * t444 + (t250 * t445 + (t408 - t60 * t447));
        force_v[8] = t259 * t411 + (t260 * t417 + (t433 + t261 * t414));
        force_v[9] = t259 * t423 + (t260 * t425 + (t448 - t73 * t429));
        force_v[10] = t450 + (t259 * t435 + (t261 * t436 - t72 * t439));
        force_v[11] = t260 * t444 + (t261 * t445 + (t421 - t71 * t447));
        force_v[12] = t455 - t161 * t456 - t159 * t457;
        force_v[13] = t462 - t159 * t463 - t464 * t465;
        force_v[14] = t470 - t471 * t472 - t473 * t474;
        force_v[15] = t289 * t477 + t485;
        force_v[16] = t155 * t428 + t495 - t496;
        force_v[17] = t141 * t438 + t503 - t504;
        force_v[18] = t148 * t446 + t509 - t510;
        force_v[19] = t511 + (t282 * t453 + (t375 * t451 + t512));
        force_v[20] = t375 * t458 + (v[5] * t464 * k4 + t513);
        force_v[21] = t282 * t466 + (t471 * t514 + t515);
        force_v[22] = t496 + (t289 * t480 + t517);
        force_v[23] = t282 * t492 + t519;
        force_v[24] = t510 + (t282 * t501 + t521);
        force_v[25] = t282 * t507 + t523;
        force_v[26] = t289 * t451 + (t375 * t452 + t524);
        force_v[27] = t289 * t458 + (t375 * t459 + t525);
        force_v[28] = v[6] * t471 * k4 + (t473 * t514 + t526);
        force_v[29] = t504 + (t275 * t477 + t528);
        force_v[30] = t289 * t488 + t530;
        force_v[31] = t289 * t497 + t532;
        force_v[32] = t289 * t505 + t534;
        force_v[33] = t275 * t452 + (t375 * t453 + t535);
        force_v[34] = t275 * t459 + (t464 * t514 + t536);
        force_v[35] = t375 * t466 + (v[4] * t473 * k4 + t537);
        force_v[36] = t282 * t483 + t539;
        force_v[37] = t275 * t490 + t541;
        force_v[38] = t275 * t499 + t543;
        force_v[39] = t275 * t506 + t545;
        mass[0] = h[0];
        mass[1] = h[0];
        mass[2] = h[0];
        mass[3] = -(t192 * t451) - t161 * t452 - t159 * t453;
        mass[4] = -(t192 * t458) - t161 * t459 - t118 * t464;
        mass[5] = -(t159 * t466) - t103 * t471 - t113 * t473;
        mass[6] = t159 * t477 + (t192 * t483 + t161 * t480);
        mass[7] = t161 * t453 + (t163 * t451 - t159 * t452);
        mass[8] = t163 * t458 + (q[5] * t464 * two - t159 * t459);
        mass[9] = t161 * t466 + (t139 * t471 - t118 * t473);
        mass[10] = t159 * t480 - t163 * t483 - t161 * t477;
        mass[11] = t161 * t492 + (t163 * t488 - t159 * t490);
        mass[12] = t159 * t451 + (t163 * t452 - t192 * t453);
        mass[13] = t159 * t458 + (t163 * t459 - t103 * t464);
        mass[14] = q[6] * t471 * two + (t139 * t473 - t192 * t466);
        mass[15] = t192 * t477 - t163 * t480 - t159 * t483;
        mass[16] = t159 * t488 + (t163 * t490 - t192 * t492);
        mass[17] = t159 * t497 + (t163 * t499 - t192 * t501);
        mass[18] = t192 * t452 + (t163 * t453 - t161 * t451);
        mass[19] = t192 * t459 + (t139 * t464 - t161 * t458);
        mass[20] = t163 * t466 + (q[4] * t473 * two - t113 * t471);
        mass[21] = t161 * t483 - t163 * t477 - t192 * t480;
        mass[22] = t192 * t490 + (t163 * t492 - t161 * t488);
        mass[23] = t192 * t499 + (t163 * t501 - t161 * t497);
        mass[24] = t192 * t506 + (t163 * t507 - t161 * t505);
    }
}
