//! JSON: the columns with their definitions, and the states with how they were found.

use std::io;

use serde_json::{Map, Value, json};

use super::SweepReport;
use crate::model::Drive;

impl SweepReport<'_> {
    /// Writes one object to 15 significant digits. A value that a state does not have is null.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let units = self.units;
        let shown = self.columns();
        let names: Vec<String> = shown.iter().map(|column| column.header(units)).collect();
        let columns: Vec<Value> = shown
            .iter()
            .zip(&names)
            .map(|(column, name)| {
                json!({
                    "name": name,
                    "title": column.title,
                    "unit": column.quantity.symbol(units),
                    "sign": column.sign,
                    "formula": column.formula,
                    "source": column.source,
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
                    .zip(self.values(&shown, row))
                    .map(|(name, value)| (name.clone(), json!(value)))
                    .collect();
                if let Some(case) = self.case(row) {
                    object.insert("case".into(), json!(case));
                }
                object.insert("newton_iterations".into(), json!(row.iterations));
                object.insert("relative_residual".into(), json!(row.relative_residual));
                Value::Object(object)
            })
            .collect();
        let stops: Vec<String> = self.sweep.stops.iter().map(ToString::to_string).collect();
        json!({
            "model": self.name,
            "side": match self.sides {
                [] => None,
                [side] => Some(side.name()),
                _ => Some("both"),
            },
            "axes": self.axes.name(),
            "event": self.event,
            "drive": self.drive.map(Drive::name),
            "states_planned": self.sweep.planned,
            "stops": stops,
            "free_motions": self.sweep.free_motions,
            "columns": columns,
            "rows": rows,
        })
    }
}
