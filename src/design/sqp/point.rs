//! The functions at one point, without dimensions.

use faer::{Col, Mat};

use super::problem::{Evaluation, Failure, Problem, Statement};

/// Functions at a point. Variables are in typical changes, residuals have their weights, and constraints
/// are in typical changes.
#[derive(Clone)]
pub(super) struct Point {
    /// In the units of the problem.
    pub x: Vec<f64>,
    /// φ.
    pub phi: f64,
    pub phi_gradient: Col<f64>,
    pub residuals: Col<f64>,
    pub jacobian: Mat<f64>,
    pub constraints: Col<f64>,
    pub rows: Mat<f64>,
    /// Limits of the constraints.
    pub row_lower: Vec<f64>,
    pub row_upper: Vec<f64>,
}

impl Point {
    pub fn evaluate(
        problem: &mut dyn Problem,
        statement: &Statement,
        x: Vec<f64>,
        raw: &mut Evaluation,
    ) -> Result<Self, Failure> {
        raw.clear();
        problem.evaluate(&x, raw)?;
        let (variables, weights) = (&statement.variables, &statement.weights);
        let (n, m, c) = (variables.len(), weights.len(), statement.constraints.len());
        let shape = [raw.gradient.len(), raw.residuals.len(), raw.residual_jacobian.len()];
        let constraint_shape = [raw.constraints.len(), raw.constraint_jacobian.len()];
        if shape != [n, m, m * n] || constraint_shape != [c, c * n] {
            return Err(Failure("the evaluation has another shape than the statement".to_owned()));
        }
        let size = |row: usize| statement.constraints[row].typical;
        let point = Self {
            x,
            phi: raw.objective,
            phi_gradient: Col::from_fn(n, |j| raw.gradient[j] * variables[j].typical),
            residuals: Col::from_fn(m, |k| raw.residuals[k] * weights[k]),
            jacobian: Mat::from_fn(m, n, |k, j| {
                raw.residual_jacobian[k * n + j] * weights[k] * variables[j].typical
            }),
            constraints: Col::from_fn(c, |i| raw.constraints[i] / size(i)),
            rows: Mat::from_fn(c, n, |i, j| {
                raw.constraint_jacobian[i * n + j] * variables[j].typical / size(i)
            }),
            row_lower: statement.constraints.iter().map(|row| row.lower / row.typical).collect(),
            row_upper: statement.constraints.iter().map(|row| row.upper / row.typical).collect(),
        };
        // Squares that overflow are no value either.
        let finite = point.objective().is_finite()
            && point.gradient().is_all_finite()
            && point.jacobian.is_all_finite()
            && point.constraints.is_all_finite()
            && point.rows.is_all_finite()
            && (point.jacobian.transpose() * &point.jacobian).is_all_finite();
        if finite { Ok(point) } else { Err(Failure("a value is not finite".to_owned())) }
    }

    pub fn objective(&self) -> f64 {
        0.5 * self.residuals.squared_norm_l2() + self.phi
    }

    pub fn gradient(&self) -> Col<f64> {
        self.jacobian.transpose() * &self.residuals + &self.phi_gradient
    }

    /// How far the numbers c are outside the limits: below zero under them.
    pub fn outside(&self, c: &Col<f64>) -> Vec<f64> {
        let limits = self.row_lower.iter().zip(&self.row_upper);
        limits.enumerate().map(|(i, (&lower, &upper))| excess(c[i], lower, upper)).collect()
    }

    /// Sum of the violations.
    pub fn violation(&self) -> f64 {
        self.outside(&self.constraints).iter().map(|outside| outside.abs()).sum()
    }

    /// The largest violation.
    pub fn worst_violation(&self) -> f64 {
        self.outside(&self.constraints).iter().fold(0.0, |worst, outside| worst.max(outside.abs()))
    }

    /// Sum of the violations of the linearised constraints after a step.
    pub fn linear_violation(&self, step: &Col<f64>) -> f64 {
        let c = &self.constraints + &self.rows * step;
        self.outside(&c).iter().map(|outside| outside.abs()).sum()
    }

    pub fn merit(&self, penalty: f64) -> f64 {
        self.objective() + penalty * self.violation()
    }
}

pub(super) fn excess(value: f64, lower: f64, upper: f64) -> f64 {
    if value < lower {
        value - lower
    } else if value > upper {
        value - upper
    } else {
        0.0
    }
}
