//! JSON: the columns with their definitions, and the states with how they were found.

use std::io;

use serde_json::{Map, Value, json};

use super::SweepReport;
use crate::factors::FACTORS;

impl SweepReport<'_> {
    /// Writes one object to 15 significant digits. A factor that the suspension does not have is null.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let names = self.columns();
        let columns: Vec<Value> = FACTORS
            .iter()
            .zip(&names)
            .map(|(factor, name)| {
                json!({
                    "name": name,
                    "title": factor.title,
                    "unit": factor.quantity.symbol(self.model.units),
                    "sign": factor.sign,
                    "formula": factor.formula,
                    "source": factor.source,
                })
            })
            .collect();
        let rows: Vec<Value> = self
            .sweep
            .rows
            .iter()
            .map(|row| {
                let mut object: Map<String, Value> = names
                    .iter()
                    .zip(self.values(row))
                    .map(|(name, value)| (name.clone(), json!(value)))
                    .collect();
                object.insert("newton_iterations".into(), json!(row.iterations));
                object.insert("relative_residual".into(), json!(row.relative_residual));
                Value::Object(object)
            })
            .collect();
        let stops: Vec<String> = self.sweep.stops.iter().map(ToString::to_string).collect();
        json!({
            "model": self.model.name,
            "side": self.model.side.name(),
            "axes": self.model.axes.name(),
            "event": self.plan.event.name(),
            "drive": self.drive.name(),
            "states_planned": self.sweep.planned,
            "stops": stops,
            "free_motions": self.sweep.free_motions,
            "columns": columns,
            "rows": rows,
        })
    }
}
