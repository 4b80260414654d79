//! Linear systems of one fixed sparsity pattern.

use super::elimination::Elimination;
use super::sparse_lu::SparseLu;
use crate::assembly::Pattern;

/// The matrix has no usable inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the matrix is singular")]
pub struct Singular;

/// Factorises matrices of one pattern and solves with them.
///
/// After the first factorisation no method allocates, as long as the pivots do not change.
pub trait LinearSolver: Send {
    /// Factorises the matrix with these values, in the order of the pattern.
    ///
    /// # Errors
    /// [`Singular`], after which the solver has no factorisation.
    fn factorise(&mut self, values: &[f64]) -> Result<(), Singular>;

    /// Replaces the right-hand side b by the solution of A x = b.
    ///
    /// # Errors
    /// [`Singular`] if there is no factorisation, or the solution is not finite or does not
    /// satisfy the equations.
    fn solve(&mut self, right_side: &mut [f64]) -> Result<(), Singular>;

    /// As [`Self::solve`], with a step of iterative refinement: where stiffnesses, lengths and angles
    /// stand in one matrix, small unknowns are then as exact as large ones. For results.
    ///
    /// # Errors
    /// As for [`Self::solve`].
    fn solve_refined(&mut self, right_side: &mut [f64]) -> Result<(), Singular>;

    /// Replaces b by the solution of Aᵀ x = b, refined as by [`Self::solve_refined`].
    ///
    /// # Errors
    /// As for [`Self::solve`].
    fn solve_transposed(&mut self, right_side: &mut [f64]) -> Result<(), Singular>;

    /// The sign of the determinant: 1, −1, or 0 without factorisation.
    fn determinant_sign(&self) -> f64;

    /// How many matrices were factorised.
    fn factorisations(&self) -> usize;
}

/// The largest matrix for which an elimination plan is made. Planning takes time with the cube
/// of the size, and the matrix of a larger system has room for a sparse factorisation.
const LARGEST_PLAN: usize = 400;

/// The solver for a square pattern: a fixed elimination plan, or the sparse LU
/// factorisation of faer for a large one.
///
/// # Panics
/// If the pattern is not square.
pub fn solver(pattern: &Pattern) -> Box<dyn LinearSolver> {
    if pattern.rows() <= LARGEST_PLAN {
        Box::new(Checked::new(pattern, Elimination::new(pattern)))
    } else {
        sparse_lu(pattern)
    }
}

/// The solver by the sparse LU factorisation of faer, whatever the size.
///
/// # Panics
/// If the pattern is not square.
pub fn sparse_lu(pattern: &Pattern) -> Box<dyn LinearSolver> {
    Box::new(Checked::new(pattern, SparseLu::new(pattern)))
}

/// A factorisation that may be wrong without saying so.
pub(super) trait Factors: Send {
    /// Factorises the matrix with these finite values.
    fn factorise(&mut self, values: &[f64]) -> Result<(), Singular>;

    /// Replaces b by the solution of A x = b, or Aᵀ x = b, as far as it is known.
    fn substitute(&mut self, right_side: &mut [f64], transposed: bool);

    /// The sign of the determinant; 0 or not finite where a pivot is.
    fn determinant_sign(&mut self) -> f64;
}

/// A solver that holds every solution against the matrix itself.
pub(super) struct Checked<F> {
    pattern: Pattern,
    factors: F,
    values: Vec<f64>,
    // The right-hand side and, behind it, its residual.
    check: Vec<f64>,
    // The largest entry of the matrix.
    size: f64,
    sign: f64,
    factorisations: usize,
}

/// Largest accepted backward error ‖b − A x‖ ∕ (‖A‖ ‖x‖ + ‖b‖).
const BACKWARD_ERROR: f64 = 1e-10;

impl<F: Factors> Checked<F> {
    /// A solver that factorises by `factors`.
    ///
    /// # Panics
    /// If the pattern is not square.
    pub fn new(pattern: &Pattern, factors: F) -> Self {
        let n = pattern.rows();
        assert_eq!(n, pattern.columns(), "only square matrices are factorised");
        Self {
            factors,
            values: vec![0.0; pattern.nonzeros()],
            check: vec![0.0; 2 * n],
            size: 0.0,
            sign: 0.0,
            factorisations: 0,
            pattern: pattern.clone(),
        }
    }

    fn solve_either(&mut self, right_side: &mut [f64], transposed: bool) -> Result<(), Singular> {
        if self.sign == 0.0 {
            return Err(Singular);
        }
        let n = right_side.len();
        self.check[..n].copy_from_slice(right_side);
        self.factors.substitute(right_side, transposed);
        if self.backward_error(right_side, transposed) <= BACKWARD_ERROR {
            return Ok(());
        }
        self.refine(right_side, transposed)
    }

    /// One step of iterative refinement from the residual of the last check, then the answer has to
    /// be right.
    fn refine(&mut self, x: &mut [f64], transposed: bool) -> Result<(), Singular> {
        if x.iter().any(|x| !x.is_finite()) {
            return Err(Singular);
        }
        let mut correction = std::mem::take(&mut self.check);
        let (_, residual) = correction.split_at_mut(x.len());
        self.factors.substitute(residual, transposed);
        for (x, dx) in x.iter_mut().zip(residual.iter()) {
            *x += dx;
        }
        self.check = correction;
        let right = self.backward_error(x, transposed) <= BACKWARD_ERROR;
        if right { Ok(()) } else { Err(Singular) }
    }

    /// Writes b − A x behind b and returns the backward error; infinite if x is not finite.
    fn backward_error(&mut self, x: &[f64], transposed: bool) -> f64 {
        let (b, residual) = self.check.split_at_mut(x.len());
        residual.copy_from_slice(b);
        let (starts, rows) = (self.pattern.column_starts(), self.pattern.row_indices());
        for column in 0..x.len() {
            let entries = starts[column]..starts[column + 1];
            let entries = rows[entries.clone()].iter().zip(&self.values[entries]);
            if transposed {
                residual[column] -= entries.map(|(&row, value)| value * x[row]).sum::<f64>();
            } else {
                entries.for_each(|(&row, value)| residual[row] -= value * x[column]);
            }
        }
        let error =
            largest(residual) / (self.size * largest(x) + largest(b)).max(f64::MIN_POSITIVE);
        if error.is_nan() { f64::INFINITY } else { error }
    }
}

impl<F: Factors> LinearSolver for Checked<F> {
    fn factorise(&mut self, values: &[f64]) -> Result<(), Singular> {
        self.factorisations += 1;
        self.sign = 0.0;
        self.values.copy_from_slice(values);
        self.size = largest(values);
        if !self.size.is_finite() {
            return Err(Singular);
        }
        self.factors.factorise(values)?;
        let sign = self.factors.determinant_sign();
        if sign == 0.0 || !sign.is_finite() {
            return Err(Singular);
        }
        self.sign = sign;
        Ok(())
    }

    fn solve(&mut self, right_side: &mut [f64]) -> Result<(), Singular> {
        self.solve_either(right_side, false)
    }

    fn solve_refined(&mut self, right_side: &mut [f64]) -> Result<(), Singular> {
        self.solve_either(right_side, false)?;
        self.refine(right_side, false)
    }

    fn solve_transposed(&mut self, right_side: &mut [f64]) -> Result<(), Singular> {
        self.solve_either(right_side, true)?;
        self.refine(right_side, true)
    }

    fn determinant_sign(&self) -> f64 {
        self.sign
    }

    fn factorisations(&self) -> usize {
        self.factorisations
    }
}

/// The largest absolute value; infinite if one is not a number.
pub(super) fn largest(vector: &[f64]) -> f64 {
    vector.iter().fold(
        0.0,
        |largest: f64, x| {
            if x.is_nan() { f64::INFINITY } else { largest.max(x.abs()) }
        },
    )
}

/// 1 for an even permutation, −1 for an odd one. `visited` is scratch of its length.
pub(super) fn permutation_sign(permutation: &[usize], visited: &mut [bool]) -> f64 {
    visited.fill(false);
    let mut sign = 1.0;
    for start in 0..permutation.len() {
        // A cycle of even length is an odd permutation.
        let mut next = start;
        while !visited[next] {
            visited[next] = true;
            next = permutation[next];
            if !visited[next] {
                sign = -sign;
            }
        }
    }
    sign
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns of [[0, 2, 0], [1, 0, 4], [0, 3, 5]], determinant −10.
    fn example() -> (Pattern, Vec<f64>) {
        let entries = vec![(1, 0), (0, 1), (2, 1), (1, 2), (2, 2)];
        (Pattern::new(3, 3, entries), vec![1.0, 2.0, 3.0, 4.0, 5.0])
    }

    fn solvers(pattern: &Pattern) -> [Box<dyn LinearSolver>; 2] {
        [
            Box::new(Checked::new(pattern, Elimination::new(pattern))),
            Box::new(Checked::new(pattern, SparseLu::new(pattern))),
        ]
    }

    /// Random sparse matrices, one pattern with many values: both solvers agree, also where a
    /// pivot of the first plan vanishes.
    #[test]
    fn both_solvers_agree_on_random_matrices() {
        let mut rng = fastrand::Rng::with_seed(3);
        for n in [1, 2, 5, 20, 40] {
            let mut entries: Vec<(usize, usize)> = (0..n).map(|k| (k, (7 * k + 3) % n)).collect();
            entries.extend((0..4 * n).map(|_| (rng.usize(0..n), rng.usize(0..n))));
            entries.extend((0..n).map(|k| (k, k)));
            let pattern = Pattern::new(n, n, entries);
            let [mut plan, mut faer] = solvers(&pattern);
            for _ in 0..30 {
                let value = |rng: &mut fastrand::Rng| match rng.u8(0..8) {
                    0 => 0.0,
                    _ => 2.0 * rng.f64() - 1.0,
                };
                let values: Vec<f64> = (0..pattern.nonzeros()).map(|_| value(&mut rng)).collect();
                let b: Vec<f64> = (0..n).map(|_| rng.f64()).collect();
                if plan.factorise(&values).is_err() || faer.factorise(&values).is_err() {
                    continue;
                }
                assert_eq!(plan.determinant_sign(), faer.determinant_sign());
                for transposed in [false, true] {
                    let [x, y] = [&mut plan, &mut faer].map(|solver| {
                        let mut x = b.clone();
                        let solved = if transposed {
                            solver.solve_transposed(&mut x)
                        } else {
                            solver.solve(&mut x)
                        };
                        solved.map(|()| x)
                    });
                    if let (Ok(x), Ok(y)) = (x, y) {
                        let size = largest(&y).max(1.0);
                        let worst =
                            x.iter().zip(&y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                        assert!(worst <= 1e-6 * size, "{worst:e} of {size:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn solves_and_solves_transposed() {
        let (pattern, values) = example();
        for mut solver in solvers(&pattern) {
            solver.factorise(&values).unwrap();
            let mut x = [4.0, 13.0, 21.0];
            solver.solve(&mut x).unwrap();
            assert_eq!(x.map(|v| (v * 1e12).round() / 1e12), [1.0, 2.0, 3.0]);
            let mut x = [2.0, 11.0, 23.0];
            solver.solve_transposed(&mut x).unwrap();
            assert_eq!(x.map(|v| (v * 1e12).round() / 1e12), [1.0, 2.0, 3.0]);
        }
    }

    #[test]
    fn knows_the_sign_of_the_determinant() {
        for mut solver in solvers(&example().0) {
            let (_, mut values) = example();
            assert_eq!(solver.determinant_sign(), 0.0);
            solver.factorise(&values).unwrap();
            assert_eq!(solver.determinant_sign(), -1.0);
            values[0] = -1.0;
            solver.factorise(&values).unwrap();
            assert_eq!(solver.determinant_sign(), 1.0);
        }
    }

    #[test]
    fn knows_the_sign_of_permutations() {
        let mut visited = [false; 5];
        for (permutation, sign) in [
            ([0, 1, 2, 3, 4], 1.0),
            ([1, 0, 2, 3, 4], -1.0),
            ([1, 2, 0, 3, 4], 1.0),
            ([1, 2, 0, 4, 3], -1.0),
            ([4, 0, 1, 2, 3], 1.0),
        ] {
            assert_eq!(permutation_sign(&permutation, &mut visited), sign, "{permutation:?}");
        }
    }

    #[test]
    fn reports_singular_matrices() {
        for mut solver in solvers(&example().0) {
            let (_, mut values) = example();
            values[0] = 0.0;
            values[3] = 0.0;
            assert_eq!(solver.factorise(&values), Err(Singular));
            assert_eq!(solver.solve(&mut [1.0, 1.0, 1.0]), Err(Singular));
            values[0] = f64::NAN;
            assert_eq!(solver.factorise(&values), Err(Singular));
        }
    }
}
