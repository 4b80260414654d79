//! Sweeps as text: a table for people, CSV and JSON for programs.

mod csv;
mod json;
mod table;

use crate::factors::{FACTORS, Factor};
use crate::model::{Drive, Model};
use crate::rig::{Row, Sweep, SweepPlan};

/// A sweep and all that is needed to show it.
#[derive(Clone, Copy)]
pub struct SweepReport<'a> {
    /// The model; its axes and units are those of the report.
    pub model: &'a Model,
    /// What the travel driver holds.
    pub drive: Drive,
    /// What was asked for.
    pub plan: &'a SweepPlan,
    /// What came of it.
    pub sweep: &'a Sweep,
}

impl SweepReport<'_> {
    /// The names of the columns, with units.
    fn columns(&self) -> Vec<String> {
        FACTORS.iter().map(|factor| factor.column(self.model.units)).collect()
    }

    /// The values of a row in the units of the model, to 15 significant digits: what lies
    /// behind them is only the change of units, such as 179.99999999999994 mm for 0.18 m.
    fn values(&self, row: &Row) -> Vec<Option<f64>> {
        let value = |factor: &Factor| factor.show(self.model.units, &row.pose);
        FACTORS.iter().map(|factor| value(factor).map(rounded)).collect()
    }
}

fn rounded(value: f64) -> f64 {
    // Adding zero turns −0 into 0.
    format!("{value:.14e}").parse().unwrap_or(value) + 0.0
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn fifteen_digits_hide_the_change_of_units() {
        assert_eq!(rounded(0.18 * 1000.0), 180.0);
        assert_eq!(rounded(-109.90000000000002), -109.9);
        assert_eq!(rounded(1.0 / 3.0), 0.333333333333333);
        assert!(rounded(-0.0).is_sign_positive());
    }
}
