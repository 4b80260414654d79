//! Interpolation in the tables of SPLINE statements.

use crate::mechanism::{Curve, Spline};

/// The table of a SPLINE statement: at least four rows whose first column rises.
pub(super) struct Table {
    rows: Vec<[f64; 2]>,
    cubic: Curve,
}

impl Table {
    pub(super) fn new(rows: Vec<[f64; 2]>) -> Option<Self> {
        let cubic = Curve::Table(Spline::new("spline", rows.clone()).ok()?);
        (rows.len() >= 4).then_some(Self { rows, cubic })
    }

    /// The value by `AKISPL`, Akima's interpolation (J. ACM 17, 1970), or `CUBSPL`, a natural cubic spline;
    /// beyond the table both go on straight.
    pub(super) fn value(&self, function: &str, x: f64) -> f64 {
        if function == "AKISPL" { akima(&self.rows, x) } else { self.cubic.at(x).value }
    }
}

fn akima(rows: &[[f64; 2]], x: f64) -> f64 {
    let last = rows.len() - 1;
    let k = rows.partition_point(|row| row[0] <= x).clamp(1, last) - 1;
    let ([x0, y0], [x1, y1]) = (rows[k], rows[k + 1]);
    let (t0, t1) = (slope(rows, k), slope(rows, k + 1));
    if x < rows[0][0] {
        return y0 + t0 * (x - x0);
    }
    if x > rows[last][0] {
        return y1 + t1 * (x - x1);
    }
    let (h, m) = (x1 - x0, (y1 - y0) / (x1 - x0));
    let s = x - x0;
    y0 + s * (t0 + s * ((3.0 * m - 2.0 * t0 - t1) / h + s * (t0 + t1 - 2.0 * m) / (h * h)))
}

/// The slope at a row: the mean of the slopes beside it, each weighted by how much those on the other
/// side differ.
fn slope(rows: &[[f64; 2]], k: usize) -> f64 {
    let last = rows.len() - 1;
    let inner = |k: usize| (rows[k + 1][1] - rows[k][1]) / (rows[k + 1][0] - rows[k][0]);
    // Beyond the table the slopes go on as an arithmetic series.
    let m = |offset: isize| {
        #[allow(clippy::cast_possible_wrap)] // A table is short.
        let place = k as isize + offset;
        #[allow(clippy::cast_possible_wrap, clippy::cast_precision_loss, clippy::cast_sign_loss)]
        match place {
            below if below < 0 => inner(0) + below as f64 * (inner(1) - inner(0)),
            above if above >= last as isize => {
                let end = inner(last - 1);
                end + (above - last as isize + 1) as f64 * (end - inner(last - 2))
            }
            place => inner(place as usize),
        }
    };
    let (left, right) = ((m(1) - m(0)).abs(), (m(-1) - m(-2)).abs());
    if left + right == 0.0 {
        return 0.5 * (m(-1) + m(0));
    }
    (left * m(-1) + right * m(0)) / (left + right)
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn akima_keeps_lines_straight_beside_a_bend() {
        let rows: Vec<[f64; 2]> =
            [-4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0].map(|x: f64| [x, x.max(0.0)]).to_vec();
        let table = Table::new(rows).unwrap();
        for x in [-5.0, -3.5, -1.2, 2.3, 4.0] {
            assert!((table.value("AKISPL", x) - f64::max(x, 0.0)).abs() < 1e-14, "{x}");
        }
        // A parabola is met exactly inside.
        let rows: Vec<[f64; 2]> = (0..8).map(f64::from).map(|x| [x, x * x]).collect();
        let table = Table::new(rows).unwrap();
        assert!((table.value("AKISPL", 3.5) - 12.25).abs() < 1e-12);
        assert_eq!(table.value("CUBSPL", 3.0), 9.0);
    }
}
