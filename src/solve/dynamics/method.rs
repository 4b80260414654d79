//! The coefficients of the generalised-α method and the choice of steps.

use super::failure::DynamicsFailure;

/// How long steps are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepSize {
    /// This long (s). Only where Newton's method fails are steps shorter for a while.
    Fixed(f64),
    /// As long as the local error allows.
    Adaptive {
        /// Largest error of the position in one step, relative: of lengths by the size of the
        /// mechanism, of Euler parameters as they are.
        tolerance: f64,
        /// Longest step (s). The first one has a thousandth of it.
        largest: f64,
    },
}

/// How motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrator {
    /// ρ∞ in 0 ..= 1: the factor by which a step damps what is much faster than the step. One
    /// conserves energy best, but keeps the noise of multipliers alive; zero forgets it at once.
    pub spectral_radius: f64,
    /// How long steps are.
    pub step: StepSize,
}

impl Integrator {
    /// Steps of constant length (s) with ρ∞ = 0.8.
    pub fn fixed(step: f64) -> Self {
        Self { spectral_radius: 0.8, step: StepSize::Fixed(step) }
    }

    /// Steps of at most 20 ms with a given local error, relative to the size of the mechanism, and
    /// ρ∞ = 0.8.
    pub fn adaptive(tolerance: f64) -> Self {
        Self { spectral_radius: 0.8, step: StepSize::Adaptive { tolerance, largest: 0.02 } }
    }

    pub(super) fn check(&self) -> Result<(), DynamicsFailure> {
        let refuse = |what, value, range| Err(DynamicsFailure::Setting { what, value, range });
        if !(0.0..=1.0).contains(&self.spectral_radius) {
            return refuse("spectral radius", self.spectral_radius, "from 0 to 1");
        }
        let positive = |value: f64| value > 0.0 && value.is_finite();
        match self.step {
            StepSize::Fixed(step) if !positive(step) => {
                refuse("step (s)", step, "greater than zero")
            }
            StepSize::Adaptive { largest, .. } if !positive(largest) => {
                refuse("largest step (s)", largest, "greater than zero")
            }
            StepSize::Adaptive { tolerance, .. } if !(1e-13..=0.1).contains(&tolerance) => {
                refuse("tolerance", tolerance, "from 1e-13 to 0.1")
            }
            _ => Ok(()),
        }
    }

    pub(super) fn first_step(&self) -> f64 {
        match self.step {
            StepSize::Fixed(step) => step,
            StepSize::Adaptive { largest, .. } => 1e-3 * largest,
        }
    }

    /// The longest step (s).
    pub(super) fn largest_step(&self) -> f64 {
        match self.step {
            StepSize::Fixed(step) => step,
            StepSize::Adaptive { largest, .. } => largest,
        }
    }

    /// The step (s) below which it makes no sense to go on.
    pub(super) fn smallest_step(&self) -> f64 {
        match self.step {
            StepSize::Fixed(step) => step / 1024.0,
            StepSize::Adaptive { largest, .. } => 1e-7 * largest,
        }
    }

    pub(super) fn coefficients(&self) -> Coefficients {
        Coefficients::new(self.spectral_radius)
    }
}

/// The coefficients by ρ∞ (Chung & Hulbert 1993, eq. 17, 20, 25; their α_f, α_m):
///
/// (1 − α_m) a₁ + α_m a₀ = (1 − α_f) q̈₁ + α_f q̈₀,
/// q₁ = q₀ + h q̇₀ + h² ((½ − β) a₀ + β a₁),  q̇₁ = q̇₀ + h ((1 − γ) a₀ + γ a₁).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficients {
    pub alpha_m: f64,
    pub alpha_f: f64,
    pub beta: f64,
    pub gamma: f64,
}

impl Coefficients {
    pub fn new(rho: f64) -> Self {
        let alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        let alpha_f = rho / (rho + 1.0);
        let gamma = 0.5 + alpha_f - alpha_m;
        Self { alpha_m, alpha_f, beta: 0.25 * (gamma + 0.5).powi(2), gamma }
    }

    /// The weights of a₁, a₀ and −q̈₀ in q̈₁.
    pub fn weights(&self) -> [f64; 3] {
        let rest = 1.0 - self.alpha_f;
        [(1.0 - self.alpha_m) / rest, self.alpha_m / rest, self.alpha_f / rest]
    }

    /// a₀ is q̈ at the time t₀ plus this part of the step (Arnold & Brüls 2007, section 3).
    pub fn shift(&self) -> f64 {
        self.alpha_m - self.alpha_f
    }

    /// The local error of q₁ is this times h³ times the third derivative of q: Taylor's series of
    /// the formula of q₁ with a₀ and a₁ at their shifted times.
    pub fn error(&self) -> f64 {
        (0.5 * self.shift() + self.beta - 1.0 / 6.0).abs()
    }
}
