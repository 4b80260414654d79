//! The sparse LU factorisation of faer, its symbolic part found once.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::lu::simplicial::{
    SimplicialLu, factorize_simplicial_numeric_lu, factorize_simplicial_numeric_lu_scratch,
    solve_in_place_scratch,
};
use faer::sparse::linalg::lu::{SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

use super::linear::{Factors, Singular, permutation_sign};
use crate::assembly::Pattern;

/// Factors by faer, which reports success with infinite or undefined numbers
/// on singular matrices.
pub(super) struct SparseLu {
    pattern: Pattern,
    symbolic: SymbolicLu<usize>,
    numeric: SimplicialLu<usize, f64>,
    row_permutation: Vec<usize>,
    row_permutation_inverse: Vec<usize>,
    memory: MemBuffer,
    visited: Vec<bool>,
}

impl SparseLu {
    /// Finds the symbolic factorisation of a square pattern.
    pub fn new(pattern: &Pattern) -> Self {
        let n = pattern.rows();
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
            visited: vec![false; n],
            pattern: pattern.clone(),
        }
    }
}

impl Factors for SparseLu {
    fn factorise(&mut self, values: &[f64]) -> Result<(), Singular> {
        factorize_simplicial_numeric_lu(
            &mut self.row_permutation,
            &mut self.row_permutation_inverse,
            &mut self.numeric,
            SparseColMatRef::new(view(&self.pattern), values),
            self.symbolic.col_perm(),
            MemStack::new(&mut self.memory),
        )
        .map_err(|_| Singular)
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

    fn determinant_sign(&mut self) -> f64 {
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

fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    SymbolicSparseColMatRef::new_checked(
        pattern.rows(),
        pattern.columns(),
        pattern.column_starts(),
        None,
        pattern.row_indices(),
    )
}
