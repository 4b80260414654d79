//! A solver for nonlinear least squares under bounds and constraints.
//!
//! ```text
//! minimise ½ Σ (w_k r_k(x))² + φ(x)   subject to   l ≤ x ≤ u,   c_l ≤ c(x) ≤ c_u
//! ```
//!
//! It is sequential quadratic programming in a trust region with the ℓ1 merit function (Fletcher's
//! Sℓ1QP: Nocedal and Wright, *Numerical Optimization*, 2nd ed., §18.5). One iteration:
//!
//! 1. The Gauss–Newton matrix JᵀJ is completed by secant corrections that vanish with the residuals and
//!    the multipliers, so that targets that can be met are met with quadratic convergence.
//! 2. The quadratic subproblem is solved: first from the active set of the last iteration, otherwise by
//!    the interior-point solver clarabel, whose answer an active-set method makes exact. Where the
//!    linearised constraints contradict each other their violation is penalised.
//! 3. The step is taken if the merit function falls, if need be after a second-order correction,
//!    and the trust region follows. A point that cannot be evaluated shortens the step.
//!
//! It ends in a minimum, or in a smallest set of constraints that contradict each other. Where only
//! small steps bring progress, as along a narrow curved valley, it takes as long as others.
//!
//! Bounds hold at every point that is evaluated. The result does not depend on anything but the
//! arguments: there is no randomness, no clock and no thread in it.

mod active_set;
mod conflict;
mod convergence;
mod curvature;
mod equality;
mod interior;
mod model;
mod outcome;
mod point;
mod problem;
mod sobol;
mod solver;
mod subproblem;

pub use outcome::{ActiveSide, Conflict, Kkt, Member, Outcome, Settings, Status};
pub use problem::{Constraint, Evaluation, Failure, Mistake, Problem, Statement, Variable};
pub use sobol::{Sobol, TooManyDimensions};
pub use solver::solve;
