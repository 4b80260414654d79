//! A factorised matrix with more conditions at its edge.

use super::linear::{LinearSolver, Singular};

/// The part of a pivot that has to be left when other conditions are taken out of it, or they are
/// not independent.
const DEPENDENT: f64 = 1e-13;

/// The system [M, A; Aᵀ, 0] [x; μ] = [b; c], solved by the factorisation of M alone: a column of A is
/// a condition aᵀx = c, which μ keeps.
///
/// With the gradient of a driver for a, the driver is held. With the unit vector of its
/// multiplier for a, the multiplier keeps its value and μ takes up its equation: the driver is let go.
#[derive(Default)]
pub(super) struct Border {
    size: usize,
    count: usize,
    /// A, column after column.
    conditions: Vec<f64>,
    /// M⁻¹ A (Aᵀ M⁻¹ A)⁻¹, column after column: A's transpose times it is the identity.
    responses: Vec<f64>,
    /// (Aᵀ M⁻¹ A)⁻¹, column after column.
    inverse: Vec<f64>,
    /// Aᵀ times the responses, while they become that.
    products: Vec<f64>,
}

impl Border {
    /// Begins anew with so many conditions on so many unknowns.
    pub fn begin(&mut self, size: usize, count: usize) {
        (self.size, self.count) = (size, count);
        for (vector, length) in [
            (&mut self.conditions, size * count),
            (&mut self.responses, size * count),
            (&mut self.inverse, count * count),
            (&mut self.products, count * count),
        ] {
            vector.clear();
            vector.resize(length, 0.0);
        }
    }

    /// The coefficients of a condition, all zero at first.
    pub fn condition_mut(&mut self, k: usize) -> &mut [f64] {
        &mut self.conditions[k * self.size..][..self.size]
    }

    /// Finds what the conditions do, with the factorisation of M.
    ///
    /// # Errors
    /// [`Singular`] where they depend on each other.
    pub fn close(&mut self, linear: &mut dyn LinearSolver) -> Result<(), Singular> {
        self.close_by(|x| linear.solve_refined(x))
    }

    /// As [`Self::close`], with whatever replaces b by M⁻¹ b: the transposed system has the same edge.
    ///
    /// # Errors
    /// As for [`Self::close`].
    pub fn close_by(
        &mut self,
        mut solve: impl FnMut(&mut [f64]) -> Result<(), Singular>,
    ) -> Result<(), Singular> {
        let (size, count) = (self.size, self.count);
        self.responses.copy_from_slice(&self.conditions);
        for k in 0..count {
            solve(&mut self.responses[k * size..][..size])?;
            self.inverse[k * count + k] = 1.0;
            for row in 0..count {
                let condition = &self.conditions[row * size..][..size];
                self.products[k * count + row] =
                    dot(condition, &self.responses[k * size..][..size]);
            }
        }
        // Gauss–Jordan elimination by columns turns the products into the identity.
        for pivot in 0..count {
            let value = self.products[pivot * count + pivot];
            if !value.is_finite() || value == 0.0 {
                return Err(Singular);
            }
            for (columns, length) in self.columns() {
                columns[pivot * length..][..length].iter_mut().for_each(|x| *x /= value);
            }
            for other in (0..count).filter(|&other| other != pivot) {
                let factor = self.products[other * count + pivot];
                let before = self.products[other * count + other];
                for (columns, length) in self.columns() {
                    for k in 0..length {
                        columns[other * length + k] -= factor * columns[pivot * length + k];
                    }
                }
                if self.products[other * count + other].abs() <= DEPENDENT * before.abs() {
                    return Err(Singular);
                }
            }
        }
        Ok(())
    }

    /// What a column operation is done to, with the lengths of columns.
    fn columns(&mut self) -> [(&mut Vec<f64>, usize); 3] {
        let Self { responses, inverse, products, size, count, .. } = self;
        [(responses, *size), (inverse, *count), (products, *count)]
    }

    /// The solution x for b = 0 and c = 1 in one condition, 0 in the others. Its multipliers are
    /// minus those of [`Self::inverse`].
    pub fn response(&self, k: usize) -> &[f64] {
        &self.responses[k * self.size..][..self.size]
    }

    /// One column of (Aᵀ M⁻¹ A)⁻¹.
    pub fn inverse(&self, k: usize) -> &[f64] {
        &self.inverse[k * self.count..][..self.count]
    }

    /// Makes the solution of M x = b the one with all conditions c = 0, and writes their multipliers.
    pub fn keep(&self, x: &mut [f64], multipliers: &mut [f64]) {
        multipliers.fill(0.0);
        for k in 0..self.count {
            let condition = &self.conditions[k * self.size..][..self.size];
            let excess = dot(condition, x);
            for (multiplier, inverse) in multipliers.iter_mut().zip(self.inverse(k)) {
                *multiplier += excess * inverse;
            }
            for (x, response) in x.iter_mut().zip(self.response(k)) {
                *x -= excess * response;
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::super::linear::solver;
    use super::*;
    use crate::assembly::Pattern;

    const N: usize = 6;

    /// A full matrix that is not symmetric, and its solver.
    fn matrix() -> ([[f64; N]; N], Box<dyn LinearSolver>) {
        let mut random = fastrand::Rng::with_seed(11);
        let mut dense = [[0.0; N]; N];
        dense.iter_mut().flatten().for_each(|x| *x = 2.0 * random.f64() - 1.0);
        let pattern = Pattern::new(N, N, (0..N * N).map(|k| (k % N, k / N)).collect());
        let values: Vec<f64> =
            pattern.entries().map(|(row, column, _)| dense[row][column]).collect();
        let mut linear = solver(&pattern);
        linear.factorise(&values).unwrap();
        (dense, linear)
    }

    fn times(matrix: &[[f64; N]; N], x: &[f64]) -> Vec<f64> {
        matrix.iter().map(|row| dot(row, x)).collect()
    }

    const CONDITIONS: [[f64; N]; 2] =
        [[0.0, 0.0, 0.0, 0.0, 1.0, 0.0], [0.3, -1.0, 0.0, 0.5, 0.0, 0.0]];

    fn border(linear: &mut dyn LinearSolver, conditions: &[[f64; N]]) -> Result<Border, Singular> {
        let mut border = Border::default();
        border.begin(N, conditions.len());
        for (k, condition) in conditions.iter().enumerate() {
            border.condition_mut(k).copy_from_slice(condition);
        }
        border.close(linear).map(|()| border)
    }

    #[test]
    fn solves_the_matrix_with_its_border() {
        let (dense, mut linear) = matrix();
        let border = border(linear.as_mut(), &CONDITIONS).unwrap();
        let b = [1.0, -2.0, 0.5, 3.0, 0.0, -1.0];
        let (mut x, mut multipliers) = (b.to_vec(), vec![f64::NAN; 2]);
        linear.solve(&mut x).unwrap();
        border.keep(&mut x, &mut multipliers);
        let check = |x: &[f64], multipliers: [f64; 2], b: [f64; N], c: [f64; 2]| {
            for (k, sum) in times(&dense, x).into_iter().enumerate() {
                let edge = multipliers[0] * CONDITIONS[0][k] + multipliers[1] * CONDITIONS[1][k];
                assert!((sum + edge - b[k]).abs() < 1e-13, "row {k}");
            }
            for (condition, c) in CONDITIONS.iter().zip(c) {
                assert!((dot(condition, x) - c).abs() < 1e-13);
            }
        };
        check(&x, [multipliers[0], multipliers[1]], b, [0.0; 2]);
        for k in 0..2 {
            let multipliers = [0, 1].map(|row| -border.inverse(k)[row]);
            let mut c = [0.0; 2];
            c[k] = 1.0;
            check(border.response(k), multipliers, [0.0; N], c);
        }
    }

    #[test]
    fn refuses_conditions_that_depend_on_each_other() {
        let (_, mut linear) = matrix();
        let twice = [CONDITIONS[1], CONDITIONS[1].map(|x| -3.0 * x)];
        assert!(matches!(border(linear.as_mut(), &twice), Err(Singular)));
        assert!(matches!(border(linear.as_mut(), &[[0.0; N]]), Err(Singular)));
    }
}
