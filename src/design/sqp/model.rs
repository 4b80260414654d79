//! The quadratic model of the objective around a point.

use faer::{Col, Mat, Side};

use super::point::Point;

/// Eigenvalues of a convex model are at least this, relative to the largest.
const FLATTEST: f64 = 1e-10;

/// ½ ‖r + J p‖² + φ + φ'ᵀ p + ½ pᵀ S p.
pub(super) struct Model<'a> {
    pub point: &'a Point,
    /// S.
    second: Mat<f64>,
    /// JᵀJ + S.
    pub hessian: Mat<f64>,
}

impl<'a> Model<'a> {
    pub fn new(point: &'a Point, second: Mat<f64>) -> Self {
        let hessian = point.jacobian.transpose() * &point.jacobian + &second;
        Self { point, second, hessian }
    }

    /// A model of constraints alone, of which only the Hessian counts.
    pub fn of_constraints(point: &'a Point, second: Mat<f64>) -> Self {
        Self { point, hessian: second.clone(), second }
    }

    /// The gradient after a step. The product with J is not replaced by JᵀJ, so that steps can be
    /// refined beyond what the condition of JᵀJ allows (Björck, *Numerical Methods for Least Squares
    /// Problems*, §2.9.3).
    pub fn gradient_at(&self, step: &Col<f64>) -> Col<f64> {
        let residuals = &self.point.residuals + &self.point.jacobian * step;
        self.point.jacobian.transpose() * residuals + &self.point.phi_gradient + &self.second * step
    }

    /// Twice the second-order part of the model along a step.
    pub fn bend(&self, step: &Col<f64>) -> f64 {
        let second: f64 = step.transpose() * (&self.second * step);
        (&self.point.jacobian * step).squared_norm_l2() + second
    }

    /// By how much the model falls over a step.
    pub fn decrease(&self, step: &Col<f64>) -> f64 {
        let change = &self.point.jacobian * step;
        let linear: f64 = self.point.residuals.transpose() * &change;
        let phi: f64 = self.point.phi_gradient.transpose() * step;
        let bend: f64 = step.transpose() * (&self.second * step);
        -(linear + phi + 0.5 * (change.squared_norm_l2() + bend))
    }

    /// The model with the absolute values of the eigenvalues of its Hessian, or none if the
    /// Hessian is safely positive definite already.
    pub fn convexified(&self) -> Option<Model<'a>> {
        let n = self.hessian.nrows();
        if self.hessian.llt(Side::Lower).is_ok() {
            return None;
        }
        let eigen = self.hessian.self_adjoint_eigen(Side::Lower).ok()?;
        let values: Vec<f64> = (0..n).map(|k| eigen.S()[k].abs()).collect();
        let floor = FLATTEST * values.iter().fold(0.0f64, |largest, &value| largest.max(value));
        let vectors = eigen.U();
        let scaled = Mat::from_fn(n, n, |row, k| vectors[(row, k)] * values[k].max(floor));
        let hessian = scaled * vectors.transpose();
        let second = &self.second + (&hessian - &self.hessian);
        Some(Model { point: self.point, second, hessian })
    }
}
