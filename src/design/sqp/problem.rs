//! What a problem is.

use thiserror::Error;

/// The functions of a problem at one point. Matrices are dense, row after row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// φ, the part of the objective that is no sum of squares.
    pub objective: f64,
    /// ∂φ/∂x, n numbers.
    pub gradient: Vec<f64>,
    /// r, m numbers, without weights.
    pub residuals: Vec<f64>,
    /// ∂r/∂x, m × n numbers.
    pub residual_jacobian: Vec<f64>,
    /// c, one number for each constraint.
    pub constraints: Vec<f64>,
    /// ∂c/∂x, constraints × n numbers.
    pub constraint_jacobian: Vec<f64>,
}

impl Evaluation {
    /// Zeros in the shape that a statement has.
    pub fn zeros(statement: &Statement) -> Self {
        let n = statement.variables.len();
        let (m, c) = (statement.weights.len(), statement.constraints.len());
        Self {
            objective: 0.0,
            gradient: vec![0.0; n],
            residuals: vec![0.0; m],
            residual_jacobian: vec![0.0; m * n],
            constraints: vec![0.0; c],
            constraint_jacobian: vec![0.0; c * n],
        }
    }

    /// Sets everything to zero and keeps the shape.
    pub(super) fn clear(&mut self) {
        self.objective = 0.0;
        for part in [
            &mut self.gradient,
            &mut self.residuals,
            &mut self.residual_jacobian,
            &mut self.constraints,
            &mut self.constraint_jacobian,
        ] {
            part.fill(0.0);
        }
    }
}

/// A point where the problem has no value, with the reason in words.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct Failure(pub String);

/// The functions of a nonlinear program with their exact first derivatives.
///
/// They should be twice continuously differentiable; derivatives of second order are not asked for.
pub trait Problem {
    /// Writes the functions at x into `out`, which is all zero and in the shape of the statement, so
    /// parts that a problem does not have need no care. x is within the bounds.
    ///
    /// # Errors
    /// [`Failure`] where the problem has no value. The solver then tries a point nearer to the last.
    /// A number that is not finite counts as a failure, too.
    fn evaluate(&mut self, x: &[f64], out: &mut Evaluation) -> Result<(), Failure>;
}

/// A variable. Infinite bounds are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variable {
    /// Lower bound.
    pub lower: f64,
    /// Upper bound; equal to the lower one for a variable that is locked.
    pub upper: f64,
    /// A typical change, above zero: the first trust region is this large.
    pub typical: f64,
}

/// A constraint. Infinite limits are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Lower limit.
    pub lower: f64,
    /// Upper limit; equal to the lower one for an equation.
    pub upper: f64,
    /// A typical change, above zero: violations are measured in it.
    pub typical: f64,
}

/// The numbers of a problem that do not depend on x.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statement {
    /// The variables.
    pub variables: Vec<Variable>,
    /// The weight w of each residual.
    pub weights: Vec<f64>,
    /// The constraints.
    pub constraints: Vec<Constraint>,
}

/// A statement or start that makes no sense.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Mistake {
    /// Bounds that cannot be kept, or a size that is no size.
    #[error(
        "variable {index} has bounds {lower} to {upper} and typical change {typical}: give bounds in rising order and a typical change above zero"
    )]
    Variable {
        /// Which variable.
        index: usize,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
        /// Its typical change.
        typical: f64,
    },
    /// Limits that cannot be kept, or a size that is no size.
    #[error(
        "constraint {index} has limits {lower} to {upper} and typical change {typical}: give limits in rising order and a typical change above zero"
    )]
    Constraint {
        /// Which constraint.
        index: usize,
        /// Its lower limit.
        lower: f64,
        /// Its upper limit.
        upper: f64,
        /// Its typical change.
        typical: f64,
    },
    /// A weight that is not finite.
    #[error("residual {index} has weight {weight}: give a finite one")]
    Weight {
        /// Which residual.
        index: usize,
        /// Its weight.
        weight: f64,
    },
    /// A start that is not finite.
    #[error("the start has {value} for variable {index}: give a finite number")]
    Start {
        /// Which variable.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A start of another size.
    #[error("the start has {start} values for {variables} variables")]
    StartSize {
        /// Values of the start.
        start: usize,
        /// Variables of the statement.
        variables: usize,
    },
    /// A setting that makes no sense.
    #[error("the setting {name} is {value}: give a finite number above zero")]
    Setting {
        /// Which setting.
        name: &'static str,
        /// Its value.
        value: f64,
    },
}

impl Statement {
    /// Finds the first mistake in the statement or the start.
    pub(super) fn check(&self, start: &[f64]) -> Result<(), Mistake> {
        for (index, &Variable { lower, upper, typical }) in self.variables.iter().enumerate() {
            if !sensible(lower, upper, typical) {
                return Err(Mistake::Variable { index, lower, upper, typical });
            }
        }
        for (index, &Constraint { lower, upper, typical }) in self.constraints.iter().enumerate() {
            if !sensible(lower, upper, typical) {
                return Err(Mistake::Constraint { index, lower, upper, typical });
            }
        }
        if let Some(index) = self.weights.iter().position(|weight| !weight.is_finite()) {
            return Err(Mistake::Weight { index, weight: self.weights[index] });
        }
        if start.len() != self.variables.len() {
            let variables = self.variables.len();
            return Err(Mistake::StartSize { start: start.len(), variables });
        }
        if let Some(index) = start.iter().position(|value| !value.is_finite()) {
            return Err(Mistake::Start { index, value: start[index] });
        }
        Ok(())
    }
}

/// Comparisons with NaN are false, so it is refused, too.
fn sensible(lower: f64, upper: f64, typical: f64) -> bool {
    lower <= upper
        && lower < f64::INFINITY
        && upper > f64::NEG_INFINITY
        && typical > 0.0
        && typical.is_finite()
}
