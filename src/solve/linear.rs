//! Linear systems of one fixed sparsity pattern.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::lu::simplicial::{
    SimplicialLu, factorize_simplicial_numeric_lu, factorize_simplicial_numeric_lu_scratch,
    solve_in_place_scratch,
};
use faer::sparse::linalg::lu::{SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

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

    /// Replaces b by the solution of Aᵀ x = b.
    ///
    /// # Errors
    /// As for [`Self::solve`].
    fn solve_transposed(&mut self, right_side: &mut [f64]) -> Result<(), Singular>;

    /// The sign of the determinant: 1, −1, or 0 without factorisation.
    fn determinant_sign(&self) -> f64;
}

/// The sparse LU factorisation of faer, its symbolic part found once.
///
/// faer reports success with infinite or undefined numbers on singular
/// matrices, so every solution is checked against the matrix itself.
pub struct SparseLu {
    pattern: Pattern,
    symbolic: SymbolicLu<usize>,
    numeric: SimplicialLu<usize, f64>,
    row_permutation: Vec<usize>,
    row_permutation_inverse: Vec<usize>,
    memory: MemBuffer,
    values: Vec<f64>,
    // The right-hand side and, behind it, its residual.
    check: Vec<f64>,
    visited: Vec<bool>,
    sign: f64,
}

/// Largest accepted backward error ‖b − A x‖ ∕ (‖A‖ ‖x‖ + ‖b‖).
const BACKWARD_ERROR: f64 = 1e-10;

impl SparseLu {
    /// Finds the symbolic factorisation of a square pattern.
    ///
    /// # Panics
    /// If the pattern is not square.
    pub fn new(pattern: &Pattern) -> Self {
        let n = pattern.rows();
        assert_eq!(n, pattern.columns(), "only square matrices are factorised");
        let symbolic = factorize_symbolic_lu(view(pattern), Default::default())
            .expect("the workspace of a symbolic factorisation fits into memory");
        let memory = MemBuffer::new(
            factorize_simplicial_numeric_lu_scratch::<usize, f64>(n, n)
                .or(solve_in_place_scratch::<usize, f64>(n, 1, Par::Seq)),
        );
        Self {
            symbolic,
            numeric: SimplicialLu::new(),
            row_permutation: vec![0; n],
            row_permutation_inverse: vec![0; n],
            memory,
            values: vec![0.0; pattern.nonzeros()],
            check: vec![0.0; 2 * n],
            visited: vec![false; n],
            sign: 0.0,
            pattern: pattern.clone(),
        }
    }

    fn solve_either(&mut self, right_side: &mut [f64], transposed: bool) -> Result<(), Singular> {
        if self.sign == 0.0 {
            return Err(Singular);
        }
        let n = right_side.len();
        self.check[..n].copy_from_slice(right_side);
        self.substitute(right_side, transposed);
        if self.backward_error(right_side, transposed) <= BACKWARD_ERROR {
            return Ok(());
        }
        // One step of iterative refinement, then the answer has to be right.
        if right_side.iter().all(|x| x.is_finite()) {
            let mut correction = std::mem::take(&mut self.check);
            let (_, residual) = correction.split_at_mut(n);
            self.substitute(residual, transposed);
            for (x, dx) in right_side.iter_mut().zip(residual.iter()) {
                *x += dx;
            }
            self.check = correction;
            if self.backward_error(right_side, transposed) <= BACKWARD_ERROR {
                return Ok(());
            }
        }
        Err(Singular)
    }

    fn substitute(&mut self, right_side: &mut [f64], transposed: bool) {
        let n = right_side.len();
        let rows = PermRef::new_checked(&self.row_permutation, &self.row_permutation_inverse, n);
        let columns = self.symbolic.col_perm();
        let right_side = MatMut::from_column_major_slice_mut(right_side, n, 1);
        let stack = MemStack::new(&mut self.memory);
        let (conj, par) = (Conj::No, Par::Seq);
        if transposed {
            self.numeric
                .solve_transpose_in_place_with_conj(rows, columns, conj, right_side, par, stack);
        } else {
            self.numeric.solve_in_place_with_conj(rows, columns, conj, right_side, par, stack);
        }
    }

    /// Writes b − A x behind b and returns the backward error; infinite if x is not finite.
    fn backward_error(&mut self, x: &[f64], transposed: bool) -> f64 {
        let (b, residual) = self.check.split_at_mut(x.len());
        residual.copy_from_slice(b);
        let mut matrix: f64 = 0.0;
        for (row, column, slot) in self.pattern.entries() {
            let value = self.values[slot];
            matrix = matrix.max(value.abs());
            let (row, column) = if transposed { (column, row) } else { (row, column) };
            residual[row] -= value * x[column];
        }
        let error = largest(residual) / (matrix * largest(x) + largest(b)).max(f64::MIN_POSITIVE);
        if error.is_nan() { f64::INFINITY } else { error }
    }

    fn sign_of_determinant(&mut self) -> f64 {
        let upper = self.numeric.u_factor_unsorted();
        let mut sign = permutation_sign(&self.row_permutation, &mut self.visited)
            * permutation_sign(self.symbolic.col_perm().arrays().0, &mut self.visited);
        for column in 0..self.pattern.columns() {
            // faer stores the diagonal entry last.
            let pivot = upper.val_of_col(column).last().copied().unwrap_or(0.0);
            if pivot == 0.0 || !pivot.is_finite() {
                return 0.0;
            }
            sign *= pivot.signum();
        }
        sign
    }
}

impl LinearSolver for SparseLu {
    fn factorise(&mut self, values: &[f64]) -> Result<(), Singular> {
        self.sign = 0.0;
        self.values.copy_from_slice(values);
        if !values.iter().all(|value| value.is_finite()) {
            return Err(Singular);
        }
        factorize_simplicial_numeric_lu(
            &mut self.row_permutation,
            &mut self.row_permutation_inverse,
            &mut self.numeric,
            SparseColMatRef::new(view(&self.pattern), &self.values),
            self.symbolic.col_perm(),
            MemStack::new(&mut self.memory),
        )
        .map_err(|_| Singular)?;
        self.sign = self.sign_of_determinant();
        if self.sign == 0.0 { Err(Singular) } else { Ok(()) }
    }

    fn solve(&mut self, right_side: &mut [f64]) -> Result<(), Singular> {
        self.solve_either(right_side, false)
    }

    fn solve_transposed(&mut self, right_side: &mut [f64]) -> Result<(), Singular> {
        self.solve_either(right_side, true)
    }

    fn determinant_sign(&self) -> f64 {
        self.sign
    }
}

fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    SymbolicSparseColMatRef::new_checked(
        pattern.rows(),
        pattern.columns(),
        pattern.column_starts(),
        None,
        pattern.row_indices(),
    )
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

fn permutation_sign(permutation: &[usize], visited: &mut [bool]) -> f64 {
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

    #[test]
    fn solves_and_solves_transposed() {
        let (pattern, values) = example();
        let mut solver = SparseLu::new(&pattern);
        solver.factorise(&values).unwrap();
        let mut x = [4.0, 13.0, 21.0];
        solver.solve(&mut x).unwrap();
        assert_eq!(x.map(|v| (v * 1e12).round() / 1e12), [1.0, 2.0, 3.0]);
        let mut x = [2.0, 11.0, 23.0];
        solver.solve_transposed(&mut x).unwrap();
        assert_eq!(x.map(|v| (v * 1e12).round() / 1e12), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn knows_the_sign_of_the_determinant() {
        let (pattern, mut values) = example();
        let mut solver = SparseLu::new(&pattern);
        assert_eq!(solver.determinant_sign(), 0.0);
        solver.factorise(&values).unwrap();
        assert_eq!(solver.determinant_sign(), -1.0);
        values[0] = -1.0;
        solver.factorise(&values).unwrap();
        assert_eq!(solver.determinant_sign(), 1.0);
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
        let (pattern, mut values) = example();
        let mut solver = SparseLu::new(&pattern);
        values[0] = 0.0;
        values[3] = 0.0;
        assert_eq!(solver.factorise(&values), Err(Singular));
        assert_eq!(solver.solve(&mut [1.0, 1.0, 1.0]), Err(Singular));
        values[0] = f64::NAN;
        assert_eq!(solver.factorise(&values), Err(Singular));
    }
}
