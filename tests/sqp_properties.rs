//! Random problems: bounds hold wherever a function is asked for, an answer satisfies the conditions
//! of a minimum, and the same question has the same answer.

#[path = "common/sqp.rs"]
mod stated;

use hardpoint::design::sqp::Status;
use num_dual::{Dual64, DualNum};
use proptest::prelude::*;
use stated::{Stated, Values, assert_minimum};

/// Curved residuals and constraints with random coefficients; the constraints hold at a point
/// within the bounds.
fn random(seed: u64, n: usize, m: usize, c: usize, reachable: bool) -> (Stated, Vec<f64>) {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut number = move || 2.0 * random.f64() - 1.0;
    let bounds: Vec<(f64, f64)> = (0..n)
        .map(|_| {
            let (a, b) = (2.0 * number(), 2.0 * number());
            match number() {
                kind if kind < -0.9 => (a, a),
                kind if kind < 0.3 => (a.min(b), a.max(b)),
                kind if kind < 0.6 => (a.min(b), f64::INFINITY),
                _ => (f64::NEG_INFINITY, f64::INFINITY),
            }
        })
        .collect();
    let inside: Vec<f64> = bounds.iter().map(|&(l, u)| (2.0 * number()).clamp(l, u)).collect();
    let start: Vec<f64> = (0..n).map(|_| 3.0 * number()).collect();
    let rows = m + c;
    let table: Vec<Vec<[f64; 3]>> =
        (0..rows).map(|_| (0..n).map(|_| [number(), number(), number()]).collect()).collect();
    let bend = 0.5;
    let value = move |row: usize, x: &[Dual64]| -> Dual64 {
        let terms = table[row].iter().zip(x);
        terms.map(|(&[a, b, phase], &x)| x * a + (x * 1.5 + phase * 3.0).sin() * (bend * b)).sum()
    };
    let there: Vec<Dual64> = inside.iter().map(|&x| Dual64::from(x)).collect();
    let at_inside: Vec<f64> = (0..rows).map(|row| value(row, &there).re).collect();
    let limits: Vec<(f64, f64)> = (m..rows)
        .map(|row| {
            let middle = at_inside[row];
            match number() {
                kind if kind < -0.6 => (middle, middle),
                kind if kind < 0.0 => (middle - 0.1, middle + 0.3),
                kind if kind < 0.5 => (middle, f64::INFINITY),
                _ => (f64::NEG_INFINITY, middle + 0.2),
            }
        })
        .collect();
    let targets: Vec<f64> =
        (0..m).map(|row| if reachable { at_inside[row] } else { 2.0 * number() }).collect();
    let stated = Stated::new(&bounds, &limits, move |x| Values {
        phi: Dual64::from(0.0),
        residuals: (0..m).map(|row| value(row, x) - targets[row]).collect(),
        constraints: (m..rows).map(|row| value(row, x)).collect(),
    });
    (stated, start)
}

fn assert_bounds_held(stated: &Stated) {
    for x in &stated.visited {
        for (value, variable) in x.iter().zip(&stated.statement.variables) {
            assert!((variable.lower..=variable.upper).contains(value), "{value} of {variable:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    #[test]
    fn bounds_hold_and_answers_are_minima(
        seed: u64,
        n in 1usize..9,
        m in 1usize..14,
        c in 0usize..5,
        reachable: bool,
    ) {
        let (mut stated, start) = random(seed, n, m, c, reachable);
        let outcome = stated.solve(&start);
        assert_bounds_held(&stated);
        match &outcome.status {
            Status::Converged(_) => assert_minimum(&stated, &outcome, 1e-6),
            // Curved constraints may be stuck where they cannot be met nearby.
            Status::Infeasible(conflict) => prop_assert!(!conflict.members.is_empty()),
            other => prop_assert!(false, "{other:?}"),
        }
        let (mut again, start) = random(seed, n, m, c, reachable);
        prop_assert_eq!(again.solve(&start), outcome);
    }
}

#[test]
fn reachable_targets_are_met_in_few_evaluations() {
    let (mut conflicts, mut met, mut evaluations) = (0, 0, vec![]);
    for seed in 0..200 {
        let (mut stated, start) = random(seed, 8, 12, 4, true);
        let outcome = stated.solve(&start);
        match outcome.status {
            Status::Converged(_) => met += usize::from(outcome.objective < 1e-20),
            Status::Infeasible(_) => conflicts += 1,
            other => panic!("{seed}: {other:?}"),
        }
        evaluations.push(outcome.evaluations);
    }
    evaluations.sort_unstable();
    let (median, most) = (evaluations[100], evaluations[199]);
    println!("{met} of 200 met, {conflicts} conflicts, {median} evaluations, {most} at most");
    // The others end in local minima and at curved constraints that cannot be met nearby.
    assert!(met >= 180 && conflicts <= 12);
    assert!(median <= 12 && most <= 60);
}
