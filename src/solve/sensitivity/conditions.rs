//! What a change has to respect besides the equations: forces that stay, and equations that are left out.

use super::{Change, Frame, Gradient, Sensitivity, SensitivityError};
use crate::mechanism::DriverId;
use crate::solve::linear::Singular;

/// Drivers that go where they have the same forces again.
#[derive(Default)]
pub(super) struct ByForce {
    /// The inverse of the derivatives of their multipliers (rows) by their values (columns), row by row.
    pub inverse: Vec<f64>,
    /// The derivatives of their multipliers by everything, all drivers held at their values.
    pub gradients: Vec<Change>,
}

/// An equation that is left out, with what a change of the kept ones does to it: −Φ_q M⁻¹.
pub(super) struct LeftOut {
    equation: usize,
    response: Vec<f64>,
}

/// The part of its terms that the change of a left-out equation may have.
const CONSISTENT: f64 = 1e-7;

impl Sensitivity {
    /// Finds what changes do to the equations that are left out.
    pub(super) fn ask_left_out(&mut self, frame: &mut Frame<'_>) -> Result<(), Singular> {
        self.left_out.clear();
        for equation in self.values.left_out_by_unknown.rows() {
            let mut response = vec![0.0; frame.size];
            self.values.left_out_by_unknown.add_row(-1.0, equation, &mut response);
            frame.linear.solve_transposed(&mut response)?;
            self.left_out.push(LeftOut { equation, response });
        }
        Ok(())
    }

    /// Finds how the forces that hold drivers change with their values and with everything else.
    pub(super) fn ask_by_force(&mut self, frame: &mut Frame<'_>) -> Result<(), Singular> {
        let by_force = std::mem::take(&mut self.question.by_force);
        let count = by_force.len();
        self.by_force = ByForce::default();
        let mut slopes = vec![0.0; count * count];
        let mut gradients = vec![];
        for (row, &(_, equation)) in by_force.iter().enumerate() {
            let multiplier = frame.multiplier(equation).ok_or(Singular)?;
            let mut gradient = Gradient { unknowns: vec![0.0; frame.size], ..Gradient::default() };
            gradient.unknowns[multiplier] = 1.0;
            let by = self.adjoint(frame, &gradient)?;
            for (column, &(driver, _)) in by_force.iter().enumerate() {
                slopes[row * count + column] = along_driver(frame, driver, &by);
            }
            gradients.push(by);
        }
        self.question.by_force = by_force;
        let inverse = inverse(&slopes, count)?;
        self.by_force = ByForce { inverse, gradients };
        Ok(())
    }

    /// How far the drivers that forces hold go with a change.
    pub(super) fn ways(&self, change: &Change) -> Vec<f64> {
        let ByForce { inverse, gradients } = &self.by_force;
        let forces: Vec<f64> = gradients.iter().map(|gradient| gradient.dot(change)).collect();
        let row = |k: usize| &inverse[k * forces.len()..][..forces.len()];
        let way = |k: usize| -row(k).iter().zip(&forces).map(|(a, b)| a * b).sum::<f64>();
        (0..forces.len()).map(way).collect()
    }

    /// Whether the equations that are left out go with a change.
    ///
    /// # Errors
    /// [`SensitivityError::Redundant`] where one does not.
    pub fn check(&self, frame: &Frame<'_>, change: &Change) -> Result<(), SensitivityError> {
        if self.left_out.is_empty() {
            return Ok(());
        }
        let mut kept = vec![0.0; frame.size];
        self.values.by_parameter.add_product(1.0, &change.h, &mut kept);
        self.values.by_constant.add_product(1.0, &change.constants, &mut kept);
        let mut own = vec![0.0; frame.equations];
        self.values.left_out_by_parameter.add_product(1.0, &change.h, &mut own);
        for LeftOut { equation, response } in &self.left_out {
            let terms = response.iter().zip(&kept).map(|(by, change)| by * change);
            let terms = terms.chain([own[*equation]]);
            let (sum, size) =
                terms.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
            if sum.abs() > CONSISTENT * size {
                return Err(SensitivityError::Redundant { equation: *equation });
            }
        }
        Ok(())
    }
}

/// The derivative by the value of a driver, from those by parameters.
pub(super) fn along_driver(frame: &Frame<'_>, driver: DriverId, by: &Change) -> f64 {
    frame.slots.of(driver).iter().map(|&(slot, factor)| factor * by.h[slot]).sum()
}

/// The inverse of a small square matrix, row by row.
pub(crate) fn inverse(matrix: &[f64], order: usize) -> Result<Vec<f64>, Singular> {
    use faer::linalg::solvers::DenseSolveCore as _;
    if order == 0 {
        return Ok(vec![]);
    }
    let matrix = faer::Mat::from_fn(order, order, |row, column| matrix[row * order + column]);
    let inverse = matrix.full_piv_lu().inverse();
    let entries = (0..order * order).map(|k| inverse[(k / order, k % order)]);
    let entries: Vec<f64> = entries.collect();
    if entries.iter().all(|entry| entry.is_finite()) { Ok(entries) } else { Err(Singular) }
}
