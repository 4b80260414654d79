//! Sweeps as text: a table for people, CSV and JSON for programs.

mod csv;
mod json;
mod table;

use crate::factors::FACTORS;
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

    /// The values of a row in the units of the model.
    fn values(&self, row: &Row) -> Vec<Option<f64>> {
        FACTORS.iter().map(|factor| factor.show(self.model.units, &row.pose)).collect()
    }
}
