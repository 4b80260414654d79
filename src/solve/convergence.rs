//! When an iteration ends (paper, Fig. 1).

/// When a Newton iteration is converged and when it is given up.
///
/// All numbers are relative: coordinates in metres are divided by the size of
/// the mechanism, every equation by the size of its own terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Largest last step. The iteration converges quadratically, so the error
    /// that is left after this step is about its square.
    pub step: f64,
    /// Largest residual.
    pub residual: f64,
    /// Iterations after which the iteration is given up.
    pub iterations: usize,
    /// Largest ratio of a step to the one before. Continuation keeps it small
    /// to stay on its branch; infinite where only the solution matters.
    pub contraction: f64,
}

impl Default for Tolerances {
    fn default() -> Self {
        Self { step: 1e-9, residual: 1e-12, iterations: 25, contraction: f64::INFINITY }
    }
}

/// How an iteration ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Both the last step and the residual are below their tolerances.
    Converged,
    /// The matrix is singular.
    Singular,
    /// The residual does not fall, not even along a short part of the step.
    Stalled,
    /// A step is not enough shorter than the one before.
    NotContracting,
    /// The iterations are used up.
    TooManyIterations,
}

/// The end of an iteration in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Linear systems that were solved.
    pub iterations: usize,
    /// The residual at the end, relative.
    pub relative_residual: f64,
    /// Size of the first step, relative.
    pub first_step: f64,
    /// Size of the last step, relative.
    pub last_step: f64,
}

impl Outcome {
    /// Whether the iteration found a solution.
    pub fn converged(&self) -> bool {
        self.status == Status::Converged
    }
}
