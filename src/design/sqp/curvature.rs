//! What the Gauss–Newton matrix lacks of the Hessian of the Lagrangian, from secants.

use faer::{Col, Mat, Scale};

use super::point::Point;

/// A secant whose denominator is relatively smaller than this says nothing (Nocedal and Wright, eq. 6.26).
const SECANT: f64 = 1e-8;
/// By this factor a model has to be better to replace the other.
const HYSTERESIS: f64 = 3.0;
/// Differences of derivatives over a shorter step, in typical changes, are mostly rounding.
const SHORTEST: f64 = 1e-11;

/// The three parts of the Hessian that first derivatives do not give,
///
/// ```text
/// ‖r‖ T_r + S_φ + ‖y‖ T_c  ≈  Σ r_k ∇²r_k + ∇²φ − Σ y_i ∇²c_i
/// ```
///
/// The factors in front make the first and last part vanish with the residuals and the multipliers
/// (the product structure of Huschens, *SIAM J. Optim.* 4 (1994) 108–129), so a problem whose targets can
/// be met is solved with the quadratic convergence of Gauss and Newton, and one whose targets
/// cannot be met still superlinearly. Each part is updated by the symmetric rank-one formula, which
/// may become indefinite as the true part is.
pub(super) struct Curvature {
    residual: Mat<f64>,
    /// Whether the part of the residuals has told the objective better than Gauss and Newton alone.
    residual_trusted: bool,
    objective: Mat<f64>,
    constraint: Mat<f64>,
    /// Whether φ has shown a secant; before that its part is a guess.
    objective_known: bool,
    /// A guess from the size of ∂φ/∂x, which makes the first step about as long as the trust region.
    objective_guess: f64,
}

impl Curvature {
    pub fn new(start: &Point, radius: f64) -> Self {
        let n = start.x.len();
        let guess = start.phi_gradient.norm_max() / radius;
        let mut objective = Mat::zeros(n, n);
        for j in 0..n {
            objective[(j, j)] = guess;
        }
        Self {
            residual: Mat::zeros(n, n),
            residual_trusted: false,
            objective,
            constraint: Mat::zeros(n, n),
            objective_known: false,
            objective_guess: guess,
        }
    }

    /// T_c.
    pub fn constraint(&self) -> &Mat<f64> {
        &self.constraint
    }

    /// The correction at a point, for multipliers of a size ‖y‖.
    pub fn second(&self, point: &Point, multipliers: f64) -> Mat<f64> {
        let size = if self.residual_trusted { point.residuals.norm_l2() } else { 0.0 };
        Scale(size) * &self.residual + &self.objective + Scale(multipliers) * &self.constraint
    }

    /// Learns from two points, the second of which need not have been accepted.
    pub fn update(&mut self, from: &Point, to: &Point, step: &Col<f64>, y: &Col<f64>) {
        if step.norm_max() < SHORTEST {
            return;
        }
        let size = to.residuals.norm_l2();
        if size > 0.0 {
            self.compare(from, to, step);
            let change = (&to.jacobian - &from.jacobian).transpose() * &to.residuals;
            rank_one(&mut self.residual, step, &(Scale(1.0 / size) * change));
        }
        let change = &to.phi_gradient - &from.phi_gradient;
        if !self.objective_known && self.objective_guess > 0.0 {
            self.objective_known = true;
            let mean = step.transpose() * &change / step.squared_norm_l2();
            let n = self.objective.nrows();
            self.objective = Mat::zeros(n, n);
            for j in 0..n {
                self.objective[(j, j)] = mean.max(0.0);
            }
        }
        rank_one(&mut self.objective, step, &change);
        let size = y.norm_l2();
        if size > 0.0 {
            let change = (&to.rows - &from.rows).transpose() * y;
            rank_one(&mut self.constraint, step, &(Scale(-1.0 / size) * change));
        }
    }

    /// Chooses between the model of Gauss and Newton and the one with the correction by what each
    /// told of the sum of squares, as NL2SOL does (Dennis, Gay and Welsch, *ACM Trans. Math. Softw.* 7
    /// (1981) 348–368): the correction is better near the end of problems whose residuals stay, and
    /// worse before it has seen much.
    fn compare(&mut self, from: &Point, to: &Point, step: &Col<f64>) {
        let plain = (&from.residuals + &from.jacobian * step).squared_norm_l2();
        let bend: f64 = step.transpose() * (&self.residual * step);
        let corrected = plain + from.residuals.norm_l2() * bend;
        let true_value = to.residuals.squared_norm_l2();
        let (plain, corrected) = ((plain - true_value).abs(), (corrected - true_value).abs());
        if self.residual_trusted && HYSTERESIS * plain < corrected {
            self.residual_trusted = false;
        } else if !self.residual_trusted && HYSTERESIS * corrected < plain {
            self.residual_trusted = true;
        }
    }
}

/// Makes `matrix` map `step` to `change` (Nocedal and Wright, eq. 6.24).
fn rank_one(matrix: &mut Mat<f64>, step: &Col<f64>, change: &Col<f64>) {
    let error = change - &*matrix * step;
    let denominator: f64 = error.transpose() * step;
    let n = step.nrows();
    if denominator.abs() <= SECANT * error.norm_l2() * step.norm_l2() {
        return;
    }
    for column in 0..n {
        for row in 0..n {
            matrix[(row, column)] += error[row] * error[column] / denominator;
        }
    }
}
