//! Dense matrices of derivatives and how they are compared.

const TOLERANCE: f64 = 1e-12;

/// A dense matrix from the entries of a pattern.
pub fn dense(pattern: &[(u8, u8)], values: &[f64], rows: usize, columns: usize) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; columns]; rows];
    for (&(row, column), &value) in pattern.iter().zip(values) {
        matrix[usize::from(row)][usize::from(column)] = value;
    }
    matrix
}

/// Compares matrices relative to the largest entry of the expected one.
pub fn assert_close(what: &str, found: &[Vec<f64>], expected: &[Vec<f64>]) {
    let scale = expected.iter().flatten().fold(1.0_f64, |scale, value| scale.max(value.abs()));
    for (row, (found, expected)) in found.iter().zip(expected).enumerate() {
        for (column, (found, expected)) in found.iter().zip(expected).enumerate() {
            let difference = (found - expected).abs();
            assert!(
                difference <= TOLERANCE * scale,
                "{what}[{row}, {column}]: symbolic {found}, dual {expected}, \
                 difference {difference:e}"
            );
        }
    }
}

/// A matrix from its columns.
pub fn columns(count: usize, column: impl Fn(usize) -> Vec<f64>) -> Vec<Vec<f64>> {
    let columns: Vec<_> = (0..count).map(column).collect();
    let rows = columns.first().map_or(0, Vec::len);
    (0..rows).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
}
