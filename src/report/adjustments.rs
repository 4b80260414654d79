//! What the adjusters of a model are set to.

use std::io;

use serde_json::{Value, json};

use super::rounded;
use super::table::cell;
use crate::model::{Quantity, Units};
use crate::rig::Adjustment;

/// Writes one line for each adjuster with unit and sign rule; nothing where there are none.
///
/// # Errors
/// What the writer says.
pub fn write_adjustments(
    mut writer: impl io::Write,
    units: Units,
    adjustments: &[Adjustment],
) -> io::Result<()> {
    if adjustments.is_empty() {
        return Ok(());
    }
    writeln!(writer, "\nStatic state, zero at the hard points")?;
    let width = adjustments.iter().map(|adjustment| adjustment.name.len()).max().unwrap_or(0);
    for adjustment in adjustments {
        let Adjustment { name, title, sign, sets, .. } = adjustment;
        let (value, unit) = (cell(Some(shown(units, adjustment))), units.length.symbol());
        let sets = sets.map_or_else(String::new, |factor| format!("; sets {factor}"));
        writeln!(writer, "  {name:<width$} {value:>13} {unit:<6} {title}; {sign}{sets}")?;
    }
    Ok(())
}

/// One object for each adjuster.
pub(super) fn json(units: Units, adjustments: &[Adjustment]) -> Vec<Value> {
    let object = |adjustment: &Adjustment| {
        json!({
            "name": adjustment.name,
            "side": adjustment.side.name(),
            "title": adjustment.title,
            "value": shown(units, adjustment),
            "unit": units.length.symbol(),
            "sign": adjustment.sign,
            "sets": adjustment.sets,
        })
    };
    adjustments.iter().map(object).collect()
}

/// The value of an adjuster in the unit of the model.
pub(super) fn shown(units: Units, adjustment: &Adjustment) -> f64 {
    rounded(Quantity::Length.show(units, adjustment.value))
}
