//! Least squares without constraints: problems of Moré, Garbow and Hillstrom, *ACM Trans. Math. Softw.* 7
//! (1981) 17–41, numbered as there, and problems without full rank.

#[path = "common/sqp.rs"]
mod stated;

use hardpoint::design::sqp::{Outcome, Settings, Status};
use num_dual::{Dual64, DualNum};
use stated::{FREE, Stated, Values, assert_minimum};

fn residuals(residuals: Vec<Dual64>) -> Values {
    Values { phi: Dual64::from(0.0), residuals, constraints: vec![] }
}

fn solve(name: &str, stated: &mut Stated, start: &[f64]) -> Outcome {
    let outcome = stated.solve(start);
    println!(
        "{name:22} {:3} iterations {:3} evaluations, f = {:9.3e}",
        outcome.iterations, outcome.evaluations, outcome.objective
    );
    outcome
}

/// Solves a problem whose residuals can be zero, and compares them with those at the start.
fn zero(name: &str, mut stated: Stated, start: &[f64], most: usize) -> Vec<f64> {
    let outcome = solve(name, &mut stated, start);
    assert_minimum(&stated, &outcome, 1e-7);
    let first = stated.at(start).residuals;
    let largest = |values: &[f64]| values.iter().fold(0.0f64, |max, value| max.max(value.abs()));
    let relative = largest(&outcome.residuals) / largest(&first);
    assert!(relative <= 1e-12, "{name}: {relative:e}");
    assert!(outcome.evaluations <= most, "{name}: {}", outcome.evaluations);
    outcome.x
}

#[test]
fn zero_residuals_are_reached_to_rounding() {
    let f = |x: &[Dual64]| residuals(vec![(x[1] - x[0] * x[0]) * 10.0, -x[0] + 1.0]);
    zero("1 Rosenbrock", Stated::new(&[FREE; 2], &[], f), &[-1.2, 1.0], 30);
    let f = |x: &[Dual64]| {
        let angle = x[1].atan2(x[0]) / (2.0 * std::f64::consts::PI);
        residuals(vec![
            (x[2] - angle * 10.0) * 10.0,
            ((x[0] * x[0] + x[1] * x[1]).sqrt() - 1.0) * 10.0,
            x[2],
        ])
    };
    zero("7 helical valley", Stated::new(&[FREE; 3], &[], f), &[-1.0, 0.0, 0.0], 20);
    let f = |x: &[Dual64]| {
        residuals(vec![
            x[0] + x[1] * 10.0,
            (x[2] - x[3]) * 5f64.sqrt(),
            (x[1] - x[2] * 2.0).powi(2),
            (x[0] - x[3]).powi(2) * 10f64.sqrt(),
        ])
    };
    // The Jacobian loses its rank at the solution, so convergence is linear there.
    zero("13 Powell singular", Stated::new(&[FREE; 4], &[], f), &[3.0, -1.0, 0.0, 1.0], 40);
    let f = |x: &[Dual64]| {
        residuals(vec![
            (x[1] - x[0] * x[0]) * 10.0,
            -x[0] + 1.0,
            (x[3] - x[2] * x[2]) * 90f64.sqrt(),
            -x[2] + 1.0,
            (x[1] + x[3] - 2.0) * 10f64.sqrt(),
            (x[1] - x[3]) / 10f64.sqrt(),
        ])
    };
    zero("14 Wood", Stated::new(&[FREE; 4], &[], f), &[-3.0, -1.0, -3.0, -1.0], 80);
}

#[test]
fn badly_scaled_problems_are_solved_with_typical_sizes_and_without() {
    let f = |x: &[Dual64]| {
        let product = x[0] * x[1] * 1e4 - 1.0;
        residuals(vec![product, (-x[0]).exp() + (-x[1]).exp() - 1.0001])
    };
    let known = [1.098159e-5, 9.106146];
    for typical in [[1.0, 1.0], [1e-5, 10.0]] {
        let mut stated = Stated::new(&[FREE; 2], &[], f);
        for (variable, typical) in stated.statement.variables.iter_mut().zip(typical) {
            variable.typical = typical;
        }
        let x = zero("3 Powell badly scaled", stated, &[0.0, 1.0], 120);
        for (x, known) in x.iter().zip(known) {
            assert!((x / known - 1.0).abs() < 1e-6, "{x} is not {known}");
        }
    }
    let f = |x: &[Dual64]| residuals(vec![x[0] - 1e6, x[1] - 2e-6, x[0] * x[1] - 2.0]);
    zero("4 Brown badly scaled", Stated::new(&[FREE; 2], &[], f), &[1.0, 1.0], 60);
}

fn trigonometric(n: usize) -> Stated {
    Stated::new(&vec![FREE; n], &[], move |x| {
        let sum: Dual64 = x.iter().map(DualNum::cos).sum();
        let each = |k: usize| -sum + n as f64 + (-x[k].cos() + 1.0) * (k + 1) as f64 - x[k].sin();
        residuals((0..n).map(each).collect())
    })
}

#[test]
fn the_trigonometric_function_has_local_minima() {
    // From 1/n for each variable most codes end at 2.79506e-5 for n = 10; both are minima.
    let mut stated = trigonometric(10);
    let outcome = solve("26 trigonometric 10", &mut stated, &[0.1; 10]);
    assert_minimum(&stated, &outcome, 1e-7);
    let squares = 2.0 * outcome.objective;
    assert!(squares < 1e-20 || (squares - 2.79506e-5).abs() < 1e-9, "{squares}");
    zero("26 trigonometric 5", trigonometric(5), &[0.02; 5], 30);
}

#[test]
fn residuals_that_stay_converge_superlinearly() {
    let f = |x: &[Dual64]| {
        let first = x[0] - 13.0 + ((-x[1] + 5.0) * x[1] - 2.0) * x[1];
        residuals(vec![first, x[0] - 29.0 + ((x[1] + 1.0) * x[1] - 14.0) * x[1]])
    };
    let mut stated = Stated::new(&[FREE; 2], &[], f);
    let outcome = solve("2 Freudenstein Roth", &mut stated, &[0.5, -2.0]);
    assert_minimum(&stated, &outcome, 1e-7);
    assert!((2.0 * outcome.objective - 48.98425).abs() < 1e-5);
    assert!(outcome.evaluations <= 40);

    let f = |x: &[Dual64]| {
        residuals(
            (1..=10)
                .map(|k| {
                    let k = f64::from(k);
                    -(x[0] * k).exp() - (x[1] * k).exp() + 2.0 + 2.0 * k
                })
                .collect(),
        )
    };
    let mut stated = Stated::new(&[FREE; 2], &[], f);
    let outcome = solve("6 Jennrich Sampson", &mut stated, &[0.3, 0.4]);
    assert_minimum(&stated, &outcome, 1e-7);
    assert!((2.0 * outcome.objective - 124.362).abs() < 1e-3);
    assert!(outcome.evaluations <= 40);

    let y =
        [0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39, 0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39];
    let f = move |x: &[Dual64]| {
        let each = |k: usize| {
            let (u, v) = ((k + 1) as f64, (15 - k) as f64);
            -x[0] - (x[1] * v + x[2] * u.min(v)).recip() * u + y[k]
        };
        residuals((0..15).map(each).collect())
    };
    let mut stated = Stated::new(&[FREE; 3], &[], f);
    let outcome = solve("8 Bard", &mut stated, &[1.0, 1.0, 1.0]);
    assert_minimum(&stated, &outcome, 1e-7);
    assert!((2.0 * outcome.objective - 8.21487e-3).abs() < 1e-8);
}

#[test]
fn variables_without_effect_and_equal_variables_do_no_harm() {
    // The third variable has no effect, and the first two only together.
    let f = |x: &[Dual64]| {
        let sum = x[0] + x[1];
        residuals(vec![sum.exp() - 2.0, sum * sum - 2f64.ln().powi(2), sum - 2f64.ln()])
    };
    let x = zero("rank one of three", Stated::new(&[FREE; 3], &[], f), &[1.0, -2.0, 5.0], 15);
    assert!((x[2] - 5.0).abs() < 1e-9, "{x:?}");
    // Equal ways are the shortest.
    assert!((x[0] - 1.0 - (x[1] + 2.0)).abs() < 1e-3, "{x:?}");
}

#[test]
fn ill_conditioned_residuals_are_met() {
    // The Hilbert matrix of order 8 has a condition of 1e10, the square of which drowns in rounding.
    let n = 8;
    let f = move |x: &[Dual64]| {
        let row = |i: usize| -> Dual64 {
            let linear: Dual64 = (0..n).map(|j| (x[j] - 1.0) / (i + j + 1) as f64).sum();
            linear + linear * linear * 0.1
        };
        residuals((0..n).map(row).collect())
    };
    zero("Hilbert 8", Stated::new(&vec![FREE; n], &[], f), &[0.5; 8], 30);
}

#[test]
fn weights_are_squared_in_the_objective() {
    let f = |x: &[Dual64]| residuals(vec![x[0] - 1.0, x[0] - 4.0, x[0] * 1e9]);
    let mut stated = Stated::new(&[FREE], &[], f);
    stated.statement.weights = vec![1.0, 2.0, 0.0];
    let outcome = stated.solve(&[0.0]);
    assert_minimum(&stated, &outcome, 1e-9);
    assert!((outcome.x[0] - 17.0 / 5.0).abs() < 1e-12);
    assert!((outcome.residuals[1] + 0.6).abs() < 1e-12);
}

#[test]
fn no_variables_and_no_functions_are_a_problem_too() {
    let outcome = Stated::new(&[], &[], |_| residuals(vec![])).solve(&[]);
    assert!(matches!(outcome.status, Status::Converged(_)), "{:?}", outcome.status);
    let outcome = Stated::new(&[FREE; 2], &[], |_| residuals(vec![])).solve(&[1.0, 2.0]);
    assert!(matches!(outcome.status, Status::Converged(_)), "{:?}", outcome.status);
    let outcome = Stated::new(&[(3.0, 3.0)], &[], |x| residuals(vec![x[0]])).solve(&[1.0]);
    assert!(matches!(outcome.status, Status::Converged(_)), "{:?}", outcome.status);
    assert_eq!(outcome.x, [3.0]);
}

#[test]
fn the_iterations_end_where_settings_say() {
    let f = |x: &[Dual64]| residuals(vec![(x[1] - x[0] * x[0]) * 10.0, -x[0] + 1.0]);
    let mut stated = Stated::new(&[FREE; 2], &[], f);
    let few = Settings { iterations: 4, ..Settings::default() };
    let outcome = stated.solve_with(&[-1.2, 1.0], &few);
    assert!(matches!(outcome.status, Status::Iterations(_)), "{:?}", outcome.status);
    assert_eq!(outcome.iterations, 4);
    let few = Settings { evaluations: 5, ..Settings::default() };
    let outcome = stated.solve_with(&[-1.2, 1.0], &few);
    assert!(matches!(outcome.status, Status::Iterations(_)), "{:?}", outcome.status);
    assert!(outcome.evaluations <= 6);
}
