//! The sparsity pattern of a matrix.

/// Row indices by column, sorted and without duplicates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    rows: usize,
    columns: usize,
    column_starts: Vec<usize>,
    row_indices: Vec<usize>,
}

impl Pattern {
    /// The pattern that contains the given (row, column) pairs, in any order, repeated or not.
    ///
    /// # Panics
    /// If a pair lies outside the matrix.
    pub fn new(rows: usize, columns: usize, mut entries: Vec<(usize, usize)>) -> Self {
        entries.sort_unstable_by_key(|&(row, column)| (column, row));
        entries.dedup();
        let mut column_starts = vec![0; columns + 1];
        for &(row, column) in &entries {
            assert!(row < rows, "row {row} of {rows}");
            column_starts[column + 1] += 1;
        }
        for column in 0..columns {
            column_starts[column + 1] += column_starts[column];
        }
        Self {
            rows,
            columns,
            column_starts,
            row_indices: entries.into_iter().map(|(row, _)| row).collect(),
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of structural nonzeros.
    pub fn nonzeros(&self) -> usize {
        self.row_indices.len()
    }

    /// Where each column starts in [`Self::row_indices`]; one more entry than columns.
    pub fn column_starts(&self) -> &[usize] {
        &self.column_starts
    }

    /// The row of each nonzero, column after column.
    pub fn row_indices(&self) -> &[usize] {
        &self.row_indices
    }

    /// The place of an entry in the value array, if the pattern contains it.
    pub fn slot(&self, row: usize, column: usize) -> Option<usize> {
        let range = self.column_starts[column]..self.column_starts[column + 1];
        let start = range.start;
        self.row_indices[range].binary_search(&row).ok().map(|position| start + position)
    }

    /// All (row, column, place) triples in the order of the value array.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        (0..self.columns).flat_map(move |column| {
            (self.column_starts[column]..self.column_starts[column + 1])
                .map(move |slot| (self.row_indices[slot], column, slot))
        })
    }
}
