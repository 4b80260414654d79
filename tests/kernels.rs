//! The generated kernels against dual numbers and against residuals written independently.

#[path = "common/by_hand.rs"]
mod by_hand;
#[path = "common/dual.rs"]
mod dual;
#[path = "common/matrices.rs"]
mod matrices;

use by_hand::{applied, force};
use dual::{First, Foreign, Second, State, dot, rotation_matrix, times};
use hardpoint::kernels::RelationKind;
use hardpoint::relation::{Place, Shape};
use hardpoint::scalar::{Dual, Scalar};
use matrices::{assert_close, columns, dense};
use num_dual::{Dual64, HyperDual64};

const STATES: usize = 20;
struct Outputs {
    phi: Vec<f64>,
    phi_q: Vec<f64>,
    work: Vec<f64>,
    curvature: Vec<f64>,
    phi_h: Vec<f64>,
    force_h: Vec<f64>,
    rate_q: Vec<f64>,
    rate_h: Vec<f64>,
}

fn split<S: Copy>(q: &[S; 14]) -> ([S; 7], [S; 7]) {
    (std::array::from_fn(|k| q[k]), std::array::from_fn(|k| q[7 + k]))
}

fn outputs(kind: RelationKind, state: &State) -> Outputs {
    let shape = kind.shape();
    let kernels = kind.kernels::<f64>();
    let (q_i, q_j) = split(&state.q);
    let (v_i, v_j) = split(&state.v);
    let place = Place { q_i: &q_i, q_j: &q_j, h: &state.h };
    let vector = |size: usize| vec![f64::NAN; size];
    let mut phi = vector(shape.equations);
    let mut phi_q = vector(shape.jacobian.len());
    let mut work = vector(shape.work.len());
    let mut curvature = vector(shape.curvature.len());
    kernels.curvature(place, &state.lambda, &mut phi, &mut phi_q, &mut work, &mut curvature);
    let mut phi_h = vector(shape.design.len());
    let mut force_h = vector(shape.force_design.len());
    kernels.design(place, &state.lambda, &mut phi_h, &mut force_h);
    let mut rate_q = vector(shape.rate.len());
    let mut rate_h = vector(shape.rate_design.len());
    kernels.rate(place, &v_i, &v_j, &mut rate_q, &mut rate_h);

    // The smaller programs agree with the largest one.
    let mut phi_alone = vector(shape.equations);
    kernels.residual(place, &mut phi_alone);
    let mut phi_with = vector(shape.equations);
    let mut phi_q_with = vector(shape.jacobian.len());
    let mut work_with = vector(shape.work.len());
    kernels.jacobian(place, &mut phi_with, &mut phi_q_with, &mut work_with);
    let close = |a: &[f64], b: &[f64]| {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-14 * (1.0 + b.abs()))
    };
    assert!(close(&phi_alone, &phi) && close(&phi_with, &phi));
    assert!(close(&phi_q_with, &phi_q) && close(&work_with, &work));

    Outputs { phi, phi_q, work, curvature, phi_h, force_h, rate_q, rate_h }
}

/// Φ of the residual program on another number type, from functions that seed it.
fn residual<S: Scalar>(
    kind: RelationKind,
    state: &State,
    q: impl Fn(usize, f64) -> S,
    h: impl Fn(usize, f64) -> S,
) -> Vec<S> {
    let q: [S; 14] = std::array::from_fn(|k| q(k, state.q[k]));
    let h: Vec<S> = state.h.iter().enumerate().map(|(k, &value)| h(k, value)).collect();
    let (q_i, q_j) = split(&q);
    let mut phi = vec![S::from_f64(f64::NAN); kind.shape().equations];
    kind.kernels::<S>().residual(Place { q_i: &q_i, q_j: &q_j, h: &h }, &mut phi);
    phi
}

/// Where the two directions of a second-order dual number point.
#[derive(Clone, Copy)]
enum Direction<'a> {
    Coordinate(usize),
    Parameter(usize),
    Velocity(&'a [f64; 14]),
}

impl Direction<'_> {
    fn q(self, k: usize) -> f64 {
        match self {
            Self::Coordinate(coordinate) => f64::from(u8::from(coordinate == k)),
            Self::Parameter(_) => 0.0,
            Self::Velocity(v) => v[k],
        }
    }

    fn h(self, k: usize) -> f64 {
        f64::from(u8::from(matches!(self, Self::Parameter(parameter) if parameter == k)))
    }
}

/// First derivative of each equation.
fn first(kind: RelationKind, state: &State, direction: Direction<'_>) -> Vec<f64> {
    let q = |k: usize, value: f64| -> First { Foreign(Dual64::new(value, direction.q(k))) };
    let h = |k: usize, value: f64| -> First { Foreign(Dual64::new(value, direction.h(k))) };
    residual(kind, state, q, h).iter().map(|phi| phi.0.eps).collect()
}

/// Second derivative of each equation.
fn second(kind: RelationKind, state: &State, a: Direction<'_>, b: Direction<'_>) -> Vec<f64> {
    let q =
        |k: usize, value: f64| -> Second { Foreign(HyperDual64::new(value, a.q(k), b.q(k), 0.0)) };
    let h =
        |k: usize, value: f64| -> Second { Foreign(HyperDual64::new(value, a.h(k), b.h(k), 0.0)) };
    residual(kind, state, q, h).iter().map(|phi| phi.0.eps1eps2).collect()
}

fn for_each_state(mut test: impl FnMut(RelationKind, &'static Shape, &State)) {
    for &kind in RelationKind::ALL {
        let mut rng = fastrand::Rng::with_seed(20_261_121);
        for _ in 0..STATES {
            test(kind, kind.shape(), &State::random(kind.shape(), &mut rng));
        }
    }
}

#[test]
fn jacobian_and_design_equal_dual_numbers() {
    for_each_state(|kind, shape, state| {
        let found = outputs(kind, state);
        let (rows, parameters) = (shape.equations, shape.parameter_count());
        let expected = columns(14, |k| first(kind, state, Direction::Coordinate(k)));
        let phi_q = dense(shape.jacobian, &found.phi_q, rows, 14);
        assert_close(&format!("{} Φ_q", shape.name), &phi_q, &expected);
        let expected = columns(parameters, |k| first(kind, state, Direction::Parameter(k)));
        let phi_h = dense(shape.design, &found.phi_h, rows, parameters);
        assert_close(&format!("{} Φ_h", shape.name), &phi_h, &expected);
    });
}

#[test]
fn curvature_equals_second_order_dual_numbers_and_is_symmetric() {
    for_each_state(|kind, shape, state| {
        if shape.has_work() {
            return;
        }
        let found = outputs(kind, state);
        assert!(shape.curvature.iter().all(|(row, column)| row >= column), "{}", shape.name);
        let mut curvature = dense(shape.curvature, &found.curvature, 14, 14);
        for row in 0..14 {
            for column in row + 1..14 {
                curvature[row][column] = curvature[column][row];
            }
        }
        let expected = columns(14, |b| {
            (0..14)
                .map(|a| {
                    let (a, b) = (Direction::Coordinate(a), Direction::Coordinate(b));
                    dot(&state.lambda, &second(kind, state, a, b))
                })
                .collect()
        });
        assert_close(&format!("{} (Φ_qᵀλ)_q", shape.name), &curvature, &expected);
    });
}

#[test]
fn force_design_equals_second_order_dual_numbers() {
    for_each_state(|kind, shape, state| {
        if shape.has_work() {
            return;
        }
        let found = outputs(kind, state);
        let parameters = shape.parameter_count();
        let expected = columns(parameters, |b| {
            (0..14)
                .map(|a| {
                    let (a, b) = (Direction::Coordinate(a), Direction::Parameter(b));
                    dot(&state.lambda, &second(kind, state, a, b))
                })
                .collect()
        });
        let force_h = dense(shape.force_design, &found.force_h, 14, parameters);
        assert_close(&format!("{} (Φ_qᵀλ)_h", shape.name), &force_h, &expected);
    });
}

/// Wᵀλ and its derivatives where the relation says itself what its force works on.
#[test]
fn work_equals_dual_numbers_of_forces_written_by_hand() {
    for_each_state(|kind, shape, state| {
        if !shape.has_work() {
            return;
        }
        let found = outputs(kind, state);
        let (rows, parameters) = (shape.equations, shape.parameter_count());
        let w = dense(shape.work, &found.work, rows, 14);
        let expected: Vec<Vec<f64>> = (0..rows)
            .map(|row| {
                let mut lambda = vec![0.0; rows];
                lambda[row] = 1.0;
                force(&applied(kind, &state.q, &state.h, &lambda), &state.q).to_vec()
            })
            .collect();
        assert_close(&format!("{} W", shape.name), &w, &expected);

        let derivative = |direction: Direction<'_>| -> Vec<f64> {
            let q: [Dual; 14] = std::array::from_fn(|k| Dual::new(state.q[k], direction.q(k)));
            let h: Vec<Dual> =
                (0..parameters).map(|k| Dual::new(state.h[k], direction.h(k))).collect();
            let lambda: Vec<Dual> = state.lambda.iter().map(|&l| Dual::from_f64(l)).collect();
            force(&applied(kind, &q, &h, &lambda), &q).iter().map(|f| f.derivative).collect()
        };
        let force_q = dense(shape.curvature, &found.curvature, 14, 14);
        let expected = columns(14, |k| derivative(Direction::Coordinate(k)));
        assert_close(&format!("{} (Wᵀλ)_q", shape.name), &force_q, &expected);
        let force_h = dense(shape.force_design, &found.force_h, 14, parameters);
        let expected = columns(parameters, |k| derivative(Direction::Parameter(k)));
        assert_close(&format!("{} (Wᵀλ)_h", shape.name), &force_h, &expected);
    });
}

#[test]
fn rate_equals_second_order_dual_numbers() {
    for_each_state(|kind, shape, state| {
        let found = outputs(kind, state);
        let velocity = Direction::Velocity(&state.v);
        let (rows, parameters) = (shape.equations, shape.parameter_count());
        let expected = columns(14, |k| second(kind, state, velocity, Direction::Coordinate(k)));
        let rate_q = dense(shape.rate, &found.rate_q, rows, 14);
        assert_close(&format!("{} (Φ_q v)_q", shape.name), &rate_q, &expected);
        let expected =
            columns(parameters, |k| second(kind, state, velocity, Direction::Parameter(k)));
        let rate_h = dense(shape.rate_design, &found.rate_h, rows, parameters);
        assert_close(&format!("{} (Φ_q v)_h", shape.name), &rate_h, &expected);
    });
}

/// Whole kernels on our own dual numbers give directional derivatives of what they write.
#[test]
fn kernels_run_on_dual_numbers() {
    for_each_state(|kind, shape, state| {
        let q: [Dual; 14] = std::array::from_fn(|k| Dual::new(state.q[k], state.v[k]));
        let (q_i, q_j) = split(&q);
        let h: Vec<Dual> = state.h.iter().map(|&value| Dual::from_f64(value)).collect();
        let mut phi = vec![Dual::default(); shape.equations];
        let mut phi_q = vec![Dual::default(); shape.jacobian.len()];
        let mut work = vec![Dual::default(); shape.work.len()];
        let place = Place { q_i: &q_i, q_j: &q_j, h: &h };
        kind.kernels::<Dual>().jacobian(place, &mut phi, &mut phi_q, &mut work);
        let derivatives: Vec<f64> = phi_q.iter().map(|entry| entry.derivative).collect();
        let found = dense(shape.jacobian, &derivatives, shape.equations, 14);
        let rate = outputs(kind, state).rate_q;
        let expected = dense(shape.rate, &rate, shape.equations, 14);
        assert_close(&format!("{} d(Φ_q)·v", shape.name), &found, &expected);
    });
}

#[test]
fn residuals_equal_those_written_by_hand() {
    for_each_state(|kind, shape, state| {
        let found = outputs(kind, state).phi;
        for (found, expected) in found.iter().zip(by_hand::residual(kind, state)) {
            let difference = (found - expected).abs();
            assert!(difference <= 1e-13, "{}: {found} by hand {expected}", shape.name);
        }
    });
}

/// Moves both bodies by one rigid motion: a rotation with the given Euler parameters, then a shift.
fn moved(state: &State, p: [f64; 4], shift: [f64; 3]) -> State {
    let a = rotation_matrix(&p);
    let mut state = state.clone();
    for body in [0, 7] {
        let r = times(&a, &state.q[body..body + 3]);
        for k in 0..3 {
            state.q[body + k] = r[k] + shift[k];
        }
        let (e0, e) =
            (state.q[body + 3], [state.q[body + 4], state.q[body + 5], state.q[body + 6]]);
        let b = [p[1], p[2], p[3]];
        state.q[body + 3] = p[0] * e0 - dot(&b, &e);
        for k in 0..3 {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            state.q[body + 4 + k] = p[0] * e[k] + e0 * b[k] + b[l] * e[m] - b[m] * e[l];
        }
    }
    state
}

/// Relations between bodies do not see a rigid motion of the whole; relations to
/// the ground do not see a horizontal shift and a turn about the vertical, unless
/// they have a direction of the ground among their parameters.
/// The spherical joint is a vector in the frame of the ground, so it turns along.
#[test]
fn rigid_motion_of_the_whole_leaves_residuals() {
    let mut rng = fastrand::Rng::with_seed(7);
    for_each_state(|kind, shape, state| {
        if shape.parameters.iter().any(|parameter| parameter.frame == "ground") {
            return;
        }
        let mut p: [f64; 4] = std::array::from_fn(|_| rng.f64() - 0.5);
        let mut shift: [f64; 3] = std::array::from_fn(|_| rng.f64() - 0.5);
        if shape.bodies == 1 {
            (p[1], p[2], shift[2]) = (0.0, 0.0, 0.0);
        }
        let norm = dot(&p, &p).sqrt();
        p = p.map(|e| e / norm);
        let mut before = outputs(kind, state).phi;
        if kind == RelationKind::Spherical {
            before = times(&rotation_matrix(&p), &before).to_vec();
        }
        let after = outputs(kind, &moved(state, p, shift)).phi;
        for (before, after) in before.iter().zip(&after) {
            assert!((before - after).abs() <= 1e-13, "{}: {before} {after}", shape.name);
        }
    });
}

/// At the design position every rotation is the identity, where half-angle formulas like to be 0/0.
#[test]
fn no_kernel_is_singular_at_the_design_position() {
    for_each_state(|kind, shape, state| {
        let mut state = state.clone();
        for body in [3, 10] {
            state.q[body..body + 4].copy_from_slice(&[1.0, 0.0, 0.0, 0.0]);
        }
        // Frames and directions lie on each other there, and angles are zero.
        for parameter in shape.parameters {
            let axis = match parameter.name {
                "x_i" | "x_j" | "u_i" | "u_j" => 0,
                "y_i" | "y_j" | "w_i" => 1,
                "z_i" | "z_j" => 2,
                _ => continue,
            };
            for k in 0..3 {
                state.h[parameter.offset + k] = f64::from(u8::from(k == axis));
            }
        }
        let Outputs { phi, phi_q, work, curvature, phi_h, force_h, rate_q, rate_h } =
            outputs(kind, &state);
        for output in [phi, phi_q, work, curvature, phi_h, force_h, rate_q, rate_h] {
            assert!(output.iter().all(|value| value.is_finite()), "{}", shape.name);
        }
    });
}

#[test]
fn names_and_patterns_are_consistent() {
    for &kind in RelationKind::ALL {
        let shape = kind.shape();
        assert_eq!(RelationKind::from_name(kind.name()), Some(kind));
        let columns = 7 * shape.bodies;
        let inside = |pattern: &[(u8, u8)], rows: usize, columns: usize| {
            pattern
                .iter()
                .all(|&(row, column)| usize::from(row) < rows && usize::from(column) < columns)
        };
        assert!(inside(shape.jacobian, shape.equations, columns));
        assert!(inside(shape.curvature, columns, columns));
        assert!(inside(shape.design, shape.equations, shape.parameter_count()));
        let mut offset = 0;
        for parameter in shape.parameters {
            assert_eq!(parameter.offset, offset, "{}", shape.name);
            offset += parameter.size;
        }
    }
    assert_eq!(RelationKind::from_name("no_such_relation"), None);
}
