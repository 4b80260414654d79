//! The Newton–Raphson iteration of the paper's eq. (5)–(7) and Fig. 1.

pub use super::convergence::{Outcome, Status, Tolerances};
use super::linear::LinearSolver;

/// Nonlinear equations F(x) = 0 that hold their own unknowns x.
pub trait Equations {
    /// Evaluates F at x and returns its size, relative.
    fn residual(&mut self) -> f64;

    /// Evaluates F and its matrix F_x at x and returns the size of F, relative.
    fn linearise(&mut self) -> f64;

    /// The values of F_x.
    fn matrix(&self) -> &[f64];

    /// Writes −F.
    fn right_side(&self, right_side: &mut [f64]);

    /// Remembers x as the start of a step.
    fn begin_step(&mut self);

    /// Sets x to the start of the step plus `fraction` of `step`.
    fn take_step(&mut self, step: &[f64], fraction: f64);

    /// Size of a step, relative.
    fn step_size(&self, step: &[f64]) -> f64;
}

/// A residual below this is rounding and need not fall any more.
const ROUNDING: f64 = 1e-13;

/// The shortest fraction of a step that is tried.
const SHORTEST: f64 = 1.0 / 64.0;

/// Iterates until step and residual are below their tolerances.
///
/// `step` is scratch of the length of x. On any end but
/// [`Status::Converged`] x is wherever the iteration left it.
pub fn newton(
    equations: &mut impl Equations,
    linear: &mut dyn LinearSolver,
    tolerances: &Tolerances,
    step: &mut [f64],
) -> Outcome {
    let mut outcome = Outcome {
        status: Status::TooManyIterations,
        iterations: 0,
        relative_residual: f64::INFINITY,
        first_step: f64::INFINITY,
        last_step: f64::INFINITY,
    };
    while outcome.iterations < tolerances.iterations {
        outcome.relative_residual = equations.linearise();
        outcome.iterations += 1;

        // F_x Δx = −F
        equations.right_side(step);
        let solved = linear.factorise(equations.matrix()).and_then(|()| linear.solve(step));
        if solved.is_err() {
            outcome.status = Status::Singular;
            return outcome;
        }

        let before = outcome.last_step;
        outcome.last_step = equations.step_size(step);
        if outcome.iterations == 1 {
            outcome.first_step = outcome.last_step;
        }
        let small = outcome.last_step <= tolerances.step;
        if !small && outcome.last_step > tolerances.contraction * before {
            outcome.status = Status::NotContracting;
            return outcome;
        }

        let Some(residual) = damped(equations, step, outcome.relative_residual) else {
            outcome.status = Status::Stalled;
            return outcome;
        };
        outcome.relative_residual = residual;
        if small && residual <= tolerances.residual {
            outcome.status = Status::Converged;
            return outcome;
        }
    }
    outcome
}

/// Takes the longest fraction 1, ½, ¼ … of the step along which the residual
/// falls, and returns the residual there.
fn damped(equations: &mut impl Equations, step: &[f64], before: f64) -> Option<f64> {
    equations.begin_step();
    let mut fraction = 1.0;
    while fraction >= SHORTEST {
        equations.take_step(step, fraction);
        let residual = equations.residual();
        if residual <= ROUNDING || residual <= (1.0 - 0.25 * fraction) * before {
            return Some(residual);
        }
        fraction *= 0.5;
    }
    None
}
