//! Problems stated with dual numbers, and conditions of a minimum checked apart from the solver.

#![allow(dead_code)]

use hardpoint::design::sqp::{
    ActiveSide, Constraint, Evaluation, Failure, Outcome, Problem, Settings, Statement, Status,
    Variable, solve,
};
use num_dual::Dual64;

pub const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);
pub const AT_LEAST_0: (f64, f64) = (0.0, f64::INFINITY);
pub const ZERO: (f64, f64) = (0.0, 0.0);

/// φ, residuals and constraints.
pub struct Values {
    pub phi: Dual64,
    pub residuals: Vec<Dual64>,
    pub constraints: Vec<Dual64>,
}

pub type Functions = Box<dyn Fn(&[Dual64]) -> Result<Values, Failure>>;

/// A problem whose derivatives are those of dual numbers; it remembers where it was evaluated.
pub struct Stated {
    functions: Functions,
    pub statement: Statement,
    pub visited: Vec<Vec<f64>>,
}

pub fn variable((lower, upper): (f64, f64)) -> Variable {
    Variable { lower, upper, typical: 1.0 }
}

impl Stated {
    pub fn new(
        bounds: &[(f64, f64)],
        limits: &[(f64, f64)],
        functions: impl Fn(&[Dual64]) -> Values + 'static,
    ) -> Self {
        Self::fallible(bounds, limits, move |x| Ok(functions(x)))
    }

    pub fn fallible(
        bounds: &[(f64, f64)],
        limits: &[(f64, f64)],
        functions: impl Fn(&[Dual64]) -> Result<Values, Failure> + 'static,
    ) -> Self {
        let inside: Vec<Dual64> = (bounds.iter())
            .map(|&(lower, upper)| Dual64::from(0.3f64.clamp(lower, upper)))
            .collect();
        let residuals = functions(&inside).map_or(0, |values| values.residuals.len());
        let constraints =
            limits.iter().map(|&(lower, upper)| Constraint { lower, upper, typical: 1.0 });
        let statement = Statement {
            variables: bounds.iter().copied().map(variable).collect(),
            weights: vec![1.0; residuals],
            constraints: constraints.collect(),
        };
        Self { functions: Box::new(functions), statement, visited: vec![] }
    }

    pub fn solve(&mut self, start: &[f64]) -> Outcome {
        self.solve_with(start, &Settings::default())
    }

    pub fn solve_with(&mut self, start: &[f64], settings: &Settings) -> Outcome {
        let statement = self.statement.clone();
        solve(self, &statement, start, settings).expect("a sound statement")
    }

    pub fn at(&self, x: &[f64]) -> Evaluation {
        let mut out = Evaluation::zeros(&self.statement);
        self.write(x, &mut out).expect("a value");
        out
    }

    fn write(&self, x: &[f64], out: &mut Evaluation) -> Result<(), Failure> {
        let n = x.len();
        for j in 0..n {
            let dual: Vec<Dual64> =
                (0..n).map(|k| Dual64::new(x[k], if k == j { 1.0 } else { 0.0 })).collect();
            let values = (self.functions)(&dual)?;
            out.objective = values.phi.re;
            out.gradient[j] = values.phi.eps;
            for (k, value) in values.residuals.iter().enumerate() {
                out.residuals[k] = value.re;
                out.residual_jacobian[k * n + j] = value.eps;
            }
            for (i, value) in values.constraints.iter().enumerate() {
                out.constraints[i] = value.re;
                out.constraint_jacobian[i * n + j] = value.eps;
            }
        }
        Ok(())
    }
}

impl Problem for Stated {
    fn evaluate(&mut self, x: &[f64], out: &mut Evaluation) -> Result<(), Failure> {
        self.visited.push(x.to_vec());
        self.write(x, out)
    }
}

/// Checks a converged outcome: feasibility, signs, complementarity and stationarity, all relative to the
/// terms that they are made of, and that the active sides are the ones that hold.
pub fn assert_minimum(stated: &Stated, outcome: &Outcome, tolerance: f64) {
    assert!(matches!(outcome.status, Status::Converged(_)), "{:?}", outcome.status);
    let n = outcome.x.len();
    let at = stated.at(&outcome.x);
    let mut gradient = at.gradient.clone();
    let mut terms: Vec<f64> = gradient.iter().map(|value| value.abs()).collect();
    let mut add = |j: usize, value: f64| {
        gradient[j] += value;
        terms[j] += value.abs();
    };
    for (k, weight) in stated.statement.weights.iter().enumerate() {
        for j in 0..n {
            add(j, weight * weight * at.residuals[k] * at.residual_jacobian[k * n + j]);
        }
    }
    for (i, y) in outcome.multipliers.iter().enumerate() {
        for j in 0..n {
            add(j, -y * at.constraint_jacobian[i * n + j]);
        }
    }
    for j in 0..n {
        add(j, -outcome.bound_multipliers[j]);
    }
    for j in 0..n {
        assert!(gradient[j].abs() <= tolerance * terms[j].max(1.0), "∂L/∂x{j} = {:e}", gradient[j]);
    }
    let check = |what: &str,
                 value: f64,
                 lower: f64,
                 upper: f64,
                 y: f64,
                 side: Option<ActiveSide>| {
        let scale = tolerance * value.abs().max(1.0);
        assert!(value >= lower - scale && value <= upper + scale, "{what}: {value}");
        match side {
            Some(ActiveSide::Lower) => assert!((value - lower).abs() <= scale, "{what}: {value}"),
            Some(ActiveSide::Upper) => assert!((value - upper).abs() <= scale, "{what}: {value}"),
            None => assert!(y == 0.0, "{what}: multiplier {y} although it is not active"),
        }
        if lower < upper {
            let wrong = match side {
                Some(ActiveSide::Lower) => -y,
                Some(ActiveSide::Upper) => y,
                None => 0.0,
            };
            assert!(wrong <= tolerance, "{what}: multiplier {y} has the wrong sign");
        }
    };
    for (i, limits) in stated.statement.constraints.iter().enumerate() {
        let (y, side) = (outcome.multipliers[i], outcome.active[i]);
        check(&format!("c{i}"), at.constraints[i], limits.lower, limits.upper, y, side);
    }
    for (j, limits) in stated.statement.variables.iter().enumerate() {
        let (z, side) = (outcome.bound_multipliers[j], outcome.active_bounds[j]);
        check(&format!("x{j}"), outcome.x[j], limits.lower, limits.upper, z, side);
    }
}
