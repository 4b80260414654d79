//! Constraints that contradict each other, points without a value, and mistakes.

#[path = "common/sqp.rs"]
mod stated;

use hardpoint::design::sqp::{
    ActiveSide, Conflict, Evaluation, Failure, Member, Mistake, Outcome, Problem, Settings,
    Statement, Status, solve,
};
use num_dual::{Dual64, DualNum};
use stated::{AT_LEAST_0, FREE, Stated, Values, ZERO, assert_minimum, variable};

fn values(residuals: Vec<Dual64>, constraints: Vec<Dual64>) -> Values {
    Values { phi: Dual64::from(0.0), residuals, constraints }
}

fn conflict(outcome: &Outcome) -> &Conflict {
    match &outcome.status {
        Status::Infeasible(conflict) => conflict,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_conflicting_pair_is_named_among_others() {
    // x + y ≥ 3 and x + y ≤ 1 contradict each other; the others can be met.
    let f = |x: &[Dual64]| {
        let constraints = vec![x[0] - x[1], x[0] + x[1], x[2] * x[2], x[0] + x[1], x[0] * x[2]];
        values(vec![x[0], x[1] - 5.0, x[2] - 1.0], constraints)
    };
    let limits = [(-1.0, 1.0), (3.0, f64::INFINITY), (0.5, 2.0), (f64::NEG_INFINITY, 1.0), FREE];
    let mut stated = Stated::new(&[(-10.0, 10.0); 3], &limits, f);
    let outcome = stated.solve(&[0.0, 0.0, 1.0]);
    let conflict = conflict(&outcome);
    let pair = [Member::Constraint(1, ActiveSide::Lower), Member::Constraint(3, ActiveSide::Upper)];
    assert_eq!(conflict.members, pair);
    // Together they are missed by 2, however that is shared.
    let missed: f64 = conflict.violations.iter().map(|violation| violation.abs()).sum();
    assert!((missed - 2.0).abs() < 1e-6, "{conflict:?}");
    assert!((conflict.multipliers[1] - 1.0).abs() < 1e-5, "{conflict:?}");
    assert!((conflict.multipliers[3] + 1.0).abs() < 1e-5, "{conflict:?}");
}

#[test]
fn one_of_equal_limits_is_enough_for_a_conflict() {
    // The multipliers are shared among the first three, any one of which contradicts the last.
    let f = |x: &[Dual64]| values(vec![x[0], x[1]], vec![x[0], x[0], x[0], x[1], x[0]]);
    let lower = (3.0, f64::INFINITY);
    let limits = [lower, lower, lower, (0.0, 1.0), (f64::NEG_INFINITY, 1.0)];
    let outcome = Stated::new(&[FREE; 2], &limits, f).solve(&[0.0, 0.5]);
    let found = conflict(&outcome);
    let shared = (0..3).filter(|&i| found.multipliers[i] > 0.01).count();
    assert_eq!(shared, 3, "{found:?}");
    let [Member::Constraint(first, ActiveSide::Lower), last] = found.members[..] else {
        panic!("{found:?}");
    };
    assert!(first < 3 && last == Member::Constraint(4, ActiveSide::Upper), "{found:?}");
}

#[test]
fn bounds_take_part_in_conflicts() {
    let f = |x: &[Dual64]| values(vec![x[0], x[1], x[2]], vec![x[0] + x[1], x[2] - x[0]]);
    let mut stated = Stated::new(&[(0.0, 3.0), (-5.0, 3.0), FREE], &[(10.0, 20.0), ZERO], f);
    let outcome = stated.solve(&[0.0; 3]);
    let found = conflict(&outcome);
    let members = [
        Member::Constraint(0, ActiveSide::Lower),
        Member::Bound(0, ActiveSide::Upper),
        Member::Bound(1, ActiveSide::Upper),
    ];
    assert_eq!(found.members, members);
    assert!((found.violations[0] + 4.0).abs() < 1e-6, "{found:?}");
    assert!((found.bound_multipliers[0] + 1.0).abs() < 1e-5, "{found:?}");
    assert_eq!(&outcome.x[..2], &[3.0, 3.0]);
}

#[test]
fn nonlinear_constraints_conflict_where_they_are_nearest() {
    // A circle of radius 1 and a line at distance 2: nearest at 45°.
    let f = |x: &[Dual64]| values(vec![x[0] - 1.0], vec![x[0] * x[0] + x[1] * x[1], x[0] + x[1]]);
    let limits = [(0.0, 1.0), (8f64.sqrt(), f64::INFINITY)];
    let outcome = Stated::new(&[FREE; 2], &limits, f).solve(&[1.0, -0.5]);
    let found = conflict(&outcome);
    let pair = [Member::Constraint(0, ActiveSide::Upper), Member::Constraint(1, ActiveSide::Lower)];
    assert_eq!(found.members, pair);
    assert!((outcome.x[0] - outcome.x[1]).abs() < 1e-3, "{outcome:?}");
}

#[test]
fn typical_sizes_and_units_of_conflicts() {
    let f = |x: &[Dual64]| values(vec![], vec![x[0] * 1000.0, x[0] * 1000.0]);
    let mut stated = Stated::new(&[FREE], &[(5.0, 9.0), (1.0, 2.0)], f);
    stated.statement.constraints[0].typical = 10.0;
    stated.statement.variables[0].typical = 0.01;
    let outcome = stated.solve(&[0.0]);
    let found = conflict(&outcome);
    // The first is missed as it weighs less: 3 in its own unit.
    assert!((found.violations[0] + 3.0).abs() < 1e-6, "{found:?}");
    assert!(found.violations[1].abs() < 1e-6, "{found:?}");
    assert!((found.multipliers[0] - 0.1).abs() < 1e-6, "{found:?}");
}

#[test]
fn redundant_and_repeated_equations_are_no_conflict() {
    let f = |x: &[Dual64]| {
        let tie = x[0] - x[1];
        let tied = vec![tie, tie * 2.0, -tie, x[1] - x[2], x[0] - x[2], x[2] * x[2] - x[2] * x[0]];
        values(vec![x[0] - 1.0, x[1] - 2.0, x[2] * x[0] - 6.0], tied)
    };
    let mut stated = Stated::new(&[FREE; 3], &[ZERO; 6], f);
    let outcome = stated.solve(&[0.5, 0.7, 3.0]);
    assert_minimum(&stated, &outcome, 1e-7);
    assert!(outcome.evaluations < 20, "{}", outcome.evaluations);
}

#[test]
fn points_without_a_value_are_avoided() {
    // The residuals have no value beyond a circle, near whose edge the solution lies.
    let f = |x: &[Dual64]| {
        let inside = -x[0] * x[0] - x[1] * x[1] + 4.0;
        if inside.re <= 0.0 {
            return Err(Failure("the mechanism locks up".to_owned()));
        }
        let residuals = vec![inside.ln() - 0.05f64.ln(), (x[0] - x[1] * 2.0) * 3.0];
        Ok(values(residuals, vec![]))
    };
    let mut stated = Stated::fallible(&[FREE; 2], &[], f);
    let settings = Settings { radius: 5.0, ..Settings::default() };
    let outcome = stated.solve_with(&[0.1, 0.1], &settings);
    assert_minimum(&stated, &outcome, 1e-7);
    assert!(outcome.objective < 1e-20, "{outcome:?}");
    let failed = stated.visited.iter().filter(|x| x[0] * x[0] + x[1] * x[1] >= 4.0).count();
    assert!(failed > 0, "no point without a value was met");
}

#[test]
fn an_edge_without_values_ends_with_its_reason() {
    // The objective falls towards the edge, so no minimum exists.
    let f = |x: &[Dual64]| {
        if x[0].re > 1.0 {
            return Err(Failure("the tie rod is too short".to_owned()));
        }
        Ok(values(vec![x[0] - 3.0], vec![]))
    };
    let outcome = Stated::fallible(&[FREE], &[], f).solve(&[0.0]);
    let reason = Status::EvaluationFailed(Failure("the tie rod is too short".to_owned()));
    assert_eq!(outcome.status, reason);
    assert!(outcome.x[0] <= 1.0 && outcome.x[0] > 0.999, "{outcome:?}");

    let outcome = Stated::fallible(&[FREE], &[], f).solve(&[2.0]);
    assert_eq!(outcome.status, reason);
    assert_eq!((outcome.x, outcome.evaluations), (vec![2.0], 1));
}

#[test]
fn numbers_that_are_not_finite_never_come_out() {
    let f = |x: &[Dual64]| values(vec![x[0].ln() - 50.0, (-x[1] + 1.0).sqrt()], vec![x[1].recip()]);
    let mut stated = Stated::new(&[FREE; 2], &[(0.1, 1e3)], f);
    let outcome = stated.solve(&[0.01, 0.5]);
    assert!(outcome.objective.is_finite());
    assert!(outcome.x.iter().chain(&outcome.multipliers).all(|value| value.is_finite()));
    let outcome = stated.solve(&[-1.0, 0.5]);
    let Status::EvaluationFailed(failure) = &outcome.status else { panic!("{outcome:?}") };
    assert!(failure.to_string().contains("not finite"));
    assert_eq!(outcome.objective, 0.0);
}

#[test]
fn mistakes_are_refused() {
    struct Nothing;
    impl Problem for Nothing {
        fn evaluate(&mut self, _: &[f64], _: &mut Evaluation) -> Result<(), Failure> {
            Ok(())
        }
    }
    let try_with = |statement: &Statement, start: &[f64]| {
        solve(&mut Nothing, statement, start, &Settings::default()).expect_err("a mistake")
    };
    let sound = Statement { variables: vec![variable((0.0, 1.0))], ..Statement::default() };
    assert!(matches!(try_with(&sound, &[]), Mistake::StartSize { start: 0, variables: 1 }));
    assert!(matches!(try_with(&sound, &[f64::NAN]), Mistake::Start { index: 0, .. }));
    let mut wrong = sound.clone();
    wrong.variables[0].upper = -1.0;
    let message = try_with(&wrong, &[0.0]).to_string();
    assert!(message.starts_with("variable 0 has bounds 0 to -1"), "{message}");
    let mut wrong = sound.clone();
    wrong.variables[0].typical = 0.0;
    assert!(matches!(try_with(&wrong, &[0.0]), Mistake::Variable { .. }));
    let mut wrong = sound.clone();
    wrong.weights = vec![f64::INFINITY];
    assert!(matches!(try_with(&wrong, &[0.0]), Mistake::Weight { index: 0, .. }));
    let stated = Stated::new(&[FREE], &[AT_LEAST_0], |x| values(vec![], vec![x[0]]));
    let mut wrong = stated.statement.clone();
    wrong.constraints[0].lower = f64::NAN;
    assert!(matches!(try_with(&wrong, &[0.0]), Mistake::Constraint { index: 0, .. }));
    let settings = Settings { step: 0.0, ..Settings::default() };
    let refused = solve(&mut Nothing, &sound, &[0.0], &settings);
    assert_eq!(refused, Err(Mistake::Setting { name: "step", value: 0.0 }));
}
