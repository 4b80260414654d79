//! The kinetic energy of a rigid body: its derivatives against dual numbers, its
//! force of inertia against Newton, Euler and closed solutions.

#[path = "common/dual.rs"]
mod dual;
#[path = "common/matrices.rs"]
mod matrices;

use dual::{Foreign, Second, Third, dot, rotation_matrix, times};
use hardpoint::energy::Motion;
use hardpoint::kernels::EnergyKind;
use hardpoint::scalar::{Dual, Scalar};
use hardpoint::vector::{add, cross, rotate, scale};
use matrices::{assert_close, columns, dense};
use num_dual::{Dual64, HyperDual, HyperDual64};

const STATES: usize = 20;

/// q, v, a and h.
struct State {
    q: [f64; 7],
    v: [f64; 7],
    a: [f64; 7],
    h: [f64; 10],
}

impl State {
    /// A motion with pᵀp = 1 for all time: pᵀṗ = 0 and pᵀp̈ = −ṗᵀṗ.
    fn random(rng: &mut fastrand::Rng) -> Self {
        let mut numbers = || std::array::from_fn(|_| 2.0 * rng.f64() - 1.0);
        let (mut q, mut v, mut a) = (numbers(), numbers(), numbers());
        let norm = dot(&q[3..], &q[3..]).sqrt();
        q[3..].iter_mut().for_each(|e| *e /= norm);
        let p: [f64; 4] = std::array::from_fn(|k| q[3 + k]);
        let radial = dot(&p, &v[3..]);
        (0..4).for_each(|k| v[3 + k] -= radial * p[k]);
        let radial = dot(&p, &a[3..]) + dot(&v[3..], &v[3..]);
        (0..4).for_each(|k| a[3 + k] -= radial * p[k]);
        let [sx, sy, sz, j1, j2, j3, _] = numbers();
        let h = [12.5, sx, sy, sz, 1.5, 1.2, 0.9, 0.2 * j1, 0.2 * j2, 0.2 * j3];
        Self { q, v, a, h }
    }

    fn motion(&self) -> Motion<'_, f64> {
        Motion { q: &self.q, v: &self.v, a: &self.a, h: &self.h }
    }
}

fn force(state: &State) -> [f64; 7] {
    let mut force = [f64::NAN; 7];
    EnergyKind::RigidBody.kernels::<f64>().force(state.motion(), &mut force);
    force
}

/// F, F_q, F_v and the mass matrix with both triangles.
fn tangent(state: &State) -> (Vec<f64>, [Vec<Vec<f64>>; 3]) {
    let shape = EnergyKind::RigidBody.shape();
    let patterns = [shape.force_q, shape.force_v, shape.mass];
    let [mut force_q, mut force_v, mut mass] =
        patterns.map(|entries| vec![f64::NAN; entries.len()]);
    let mut force = vec![f64::NAN; 7];
    EnergyKind::RigidBody.kernels::<f64>().tangent(
        state.motion(),
        &mut force,
        &mut force_q,
        &mut force_v,
        &mut mass,
    );
    let mut mass = dense(shape.mass, &mass, 7, 7);
    for row in 0..7 {
        for column in row + 1..7 {
            mass[row][column] = mass[column][row];
        }
    }
    (force, [dense(shape.force_q, &force_q, 7, 7), dense(shape.force_v, &force_v, 7, 7), mass])
}

/// ω′ = 2 G(p) ṗ = 2 (e0 ė − ė0 e − e × ė), in body axes.
fn omega<S: Scalar>(p: &[S], v: &[S]) -> [S; 3] {
    let (e, d) = ([p[1], p[2], p[3]], [v[1], v[2], v[3]]);
    let turned = cross(d, e);
    std::array::from_fn(|k| S::from_f64(2.0) * (p[0] * d[k] - v[0] * e[k] + turned[k]))
}

fn tensor(h: &[f64]) -> [[f64; 3]; 3] {
    [[h[4], h[7], h[8]], [h[7], h[5], h[9]], [h[8], h[9], h[6]]]
}

/// T with the centre of mass multiplied out and A homogeneous, so that it is the same
/// function of q and q̇ off the unit sphere too.
fn energy<S: Scalar>(q: &[S], v: &[S], h: &[f64]) -> S {
    let vector = |from: &[f64]| [from[0], from[1], from[2]].map(S::from_f64);
    let product = |a: [S; 3], b: [S; 3]| hardpoint::vector::dot(a, b);
    let omega = omega(&q[3..], &v[3..]);
    let velocity = [v[0], v[1], v[2]];
    let lever = cross(omega, vector(&h[1..4]));
    let spin = tensor(h).map(|row| product(vector(&row), omega));
    let both = product(velocity, rotate([q[3], q[4], q[5], q[6]], lever));
    let mass = S::from_f64(h[0]);
    let squares = product(velocity, velocity) + product(lever, lever) + both + both;
    S::from_f64(0.5) * (mass * squares + product(omega, spin))
}

/// What the three directions of a third-order dual number seed.
#[derive(Clone, Copy)]
enum Variable {
    Q(usize),
    V(usize),
    A(usize),
}

impl Variable {
    fn seed(self, other: Self) -> f64 {
        let same = match (self, other) {
            (Self::Q(k), Self::Q(l)) | (Self::V(k), Self::V(l)) | (Self::A(k), Self::A(l)) => {
                k == l
            }
            _ => false,
        };
        f64::from(u8::from(same))
    }
}

/// F = d/dt T_v − T_q and its derivative by one variable, from third derivatives of T.
fn lagrange(state: &State, by: Variable) -> Vec<(f64, f64)> {
    let dual = |value: f64, variable: Variable| Dual64::new(value, by.seed(variable));
    let number = |value: f64, rate: Dual64, at: Variable, first: Variable| -> Third {
        let first = Dual64::new(first.seed(at), 0.0);
        Foreign(HyperDual::new(dual(value, at), first, rate, Dual64::new(0.0, 0.0)))
    };
    let derivative = |first: Variable| {
        let q: [Third; 7] = std::array::from_fn(|k| {
            number(state.q[k], dual(state.v[k], Variable::V(k)), Variable::Q(k), first)
        });
        let v: [Third; 7] = std::array::from_fn(|k| {
            number(state.v[k], dual(state.a[k], Variable::A(k)), Variable::V(k), first)
        });
        energy(&q, &v, &state.h).0
    };
    (0..7)
        .map(|k| derivative(Variable::V(k)).eps1eps2 - derivative(Variable::Q(k)).eps1)
        .map(|force| (force.re, force.eps))
        .collect()
}

fn for_each_state(mut test: impl FnMut(&State)) {
    let mut rng = fastrand::Rng::with_seed(20_261_122);
    for _ in 0..STATES {
        test(&State::random(&mut rng));
    }
}

#[test]
fn force_and_tangents_equal_third_order_dual_numbers() {
    for_each_state(|state| {
        let (found, [force_q, force_v, mass]) = tangent(state);
        let expected = lagrange(state, Variable::Q(0)).iter().map(|(force, _)| *force).collect();
        assert_close("F", &[force(state).to_vec(), found], &[Vec::clone(&expected), expected]);
        type Seed = fn(usize) -> Variable;
        let tangents: [(&str, Seed, _); 3] = [
            ("F_q", Variable::Q, force_q),
            ("F_v", Variable::V, force_v),
            ("mass", Variable::A, mass),
        ];
        for (name, variable, found) in tangents {
            let column = |k| lagrange(state, variable(k)).iter().map(|(_, slope)| *slope).collect();
            assert_close(name, &found, &columns(7, column));
        }
    });
}

/// T of the file, of its parts, and ½ q̇ᵀ M q̇ are one number.
#[test]
fn energy_is_that_of_translation_and_rotation() {
    for_each_state(|state| {
        let found = EnergyKind::RigidBody.kernels::<f64>().energy(state.motion());
        let omega = omega(&state.q[3..], &state.v[3..]);
        let (center, h) = ([state.h[1], state.h[2], state.h[3]], &state.h);
        let turned = times(&rotation_matrix(&state.q[3..]), &cross(omega, center));
        let velocity = add([state.v[0], state.v[1], state.v[2]], turned);
        let spin = times(&tensor(h), &omega);
        let expected = 0.5 * (h[0] * dot(&velocity, &velocity) + dot(&omega, &spin));
        let (_, [.., mass]) = tangent(state);
        let momentum: Vec<f64> = mass.iter().map(|row| dot(row, &state.v)).collect();
        for other in [expected, 0.5 * dot(&momentum, &state.v)] {
            assert!((found - other).abs() < 1e-13 * expected, "{found} instead of {other}");
        }
    });
}

/// F_r is mass times the acceleration of the centre of mass, and ½ G F_p the moment
/// that Euler's equations ask for, about the origin of the body and in its axes.
#[test]
fn force_is_that_of_newton_and_euler() {
    for_each_state(|state| {
        let (p, h) = (&state.q[3..], &state.h);
        let a = rotation_matrix(p);
        let omega_dot = omega(p, &state.a[3..]);
        let omega = omega(p, &state.v[3..]);
        let center = [h[1], h[2], h[3]];
        let local = add(cross(omega_dot, center), cross(omega, cross(omega, center)));
        let acceleration = add([state.a[0], state.a[1], state.a[2]], times(&a, &local));
        let transposed: [[f64; 3]; 3] = std::array::from_fn(|r| std::array::from_fn(|c| a[c][r]));
        let push = scale(h[0], times(&transposed, &acceleration));
        let spin = times(&tensor(h), &omega);
        let euler = add(times(&tensor(h), &omega_dot), cross(omega, spin));
        let moment = add(euler, cross(center, push));

        let force = force(state);
        for k in 0..3 {
            let (found, expected) = (force[k], h[0] * acceleration[k]);
            assert!((found - expected).abs() < 1e-11, "{found} instead of {expected}");
            let found = body_moment(&state.q, &force)[k];
            assert!((found - moment[k]).abs() < 1e-11, "{found} instead of {}", moment[k]);
        }
    });
}

/// ½ G F_p, G = [−e, e0 1 − ẽ].
fn body_moment(q: &[f64; 7], force: &[f64; 7]) -> [f64; 3] {
    let (e, f) = ([q[4], q[5], q[6]], [force[4], force[5], force[6]]);
    let turned = cross(e, f);
    std::array::from_fn(|k| 0.5 * (q[3] * f[k] - force[3] * e[k] - turned[k]))
}

/// A symmetric top that nobody touches precesses at φ̇ about a fixed axis and spins at
/// ψ̇ = φ̇ cos θ (A − C)/C about its own: no force, no moment (Goldstein, section 5.6).
#[test]
fn a_free_top_needs_no_moment() {
    let (tilt, precession, transverse, axial) = (0.4_f64, 7.0, 0.31, 0.47);
    let spin = precession * tilt.cos() * (transverse - axial) / axial;
    let about = |axis: usize, angle: Second| -> [Second; 4] {
        let half = angle / Second::from_f64(2.0);
        let mut p = [Second::from_f64(0.0); 4];
        (p[0], p[axis]) = (half.cos(), half.sin());
        p
    };
    let product = |p: [Second; 4], q: [Second; 4]| -> [Second; 4] {
        [
            p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
            p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1],
        ]
    };
    for time in [0.0, 0.1, 0.35, 1.7] {
        let turned =
            |rate: f64| -> Second { Foreign(HyperDual64::new(rate * time, rate, rate, 0.0)) };
        let tilted = product(about(3, turned(precession)), about(1, Second::from_f64(tilt)));
        let p = product(tilted, about(3, turned(spin)));
        let coordinates = |part: fn(&Second) -> f64| -> [f64; 7] {
            std::array::from_fn(|k| if k < 3 { 0.0 } else { part(&p[k - 3]) })
        };
        let state = State {
            q: coordinates(|e| e.0.re),
            v: coordinates(|e| e.0.eps1),
            a: coordinates(|e| e.0.eps1eps2),
            h: [3.0, 0.0, 0.0, 0.0, transverse, transverse, axial, 0.0, 0.0, 0.0],
        };
        let force = force(&state);
        let moment = body_moment(&state.q, &force);
        // The moments that cancel are of the size of A φ̇².
        assert!(moment.iter().all(|m| m.abs() < 1e-13 * transverse * precession.powi(2)));
        assert_eq!(force[..3], [0.0; 3]);
    }
}

/// A thin rod that swings about its end: T = m l² ω² / 6.
#[test]
fn a_rod_about_its_end() {
    let (mass, length, rate, angle) = (2.0, 0.6, 3.0, 0.7_f64);
    let about_center = mass * length * length / 12.0;
    let (sin, cos) = (angle / 2.0).sin_cos();
    let h = [mass, length / 2.0, 0.0, 0.0, 0.0, about_center, about_center, 0.0, 0.0, 0.0];
    let q = [0.4, -0.1, 0.2, cos, 0.0, 0.0, sin];
    let v = [0.0, 0.0, 0.0, -sin * rate / 2.0, 0.0, 0.0, cos * rate / 2.0];
    let motion = Motion { q: &q, v: &v, a: &[0.0; 7], h: &h };
    let found = EnergyKind::RigidBody.kernels::<f64>().energy(motion);
    let expected = mass * (length * rate).powi(2) / 6.0;
    assert!((found - expected).abs() < 1e-14, "{found} instead of {expected}");
}

/// Whole kernels on our own dual numbers give derivatives of what they write.
#[test]
fn kernels_run_on_dual_numbers() {
    for_each_state(|state| {
        let q = std::array::from_fn(|k| Dual::new(state.q[k], state.v[k]));
        let [v, a] = [state.v, state.a].map(|numbers| numbers.map(Dual::from_f64));
        let h = state.h.map(Dual::from_f64);
        let mut force = [Dual::default(); 7];
        let motion = Motion { q: &q, v: &v, a: &a, h: &h };
        EnergyKind::RigidBody.kernels::<Dual>().force(motion, &mut force);
        let (_, [force_q, ..]) = tangent(state);
        let found = force.iter().map(|force| force.derivative).collect();
        let expected = force_q.iter().map(|row| dot(row, &state.v)).collect();
        assert_close("dF·v", &[found], &[expected]);
    });
}

#[test]
fn names_and_patterns_are_consistent() {
    for &kind in EnergyKind::ALL {
        let shape = kind.shape();
        assert_eq!(EnergyKind::from_name(kind.name()), Some(kind));
        let patterns = [shape.force_q, shape.force_v, shape.mass];
        assert!(patterns.concat().iter().all(|&(row, column)| row < 7 && column < 7));
        assert!(shape.mass.iter().all(|(row, column)| row >= column));
        let sizes: usize = shape.parameters.iter().map(|parameter| parameter.size).sum();
        assert_eq!(shape.parameter_count(), sizes);
    }
    assert_eq!(EnergyKind::from_name("no_such_energy"), None);
}
