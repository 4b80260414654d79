//! A compliance matrix: a table for people, CSV and JSON for programs.

use std::io;

use serde_json::{Value, json};

use super::csv::of_the_writer;
use super::rounded;
use crate::model::{Axes, Quantity, Units};
use crate::rig::{Compliance, LOAD_COMPONENTS};

/// The names of displacements and rotations of a wheel.
const DISPLACEMENTS: [&str; 6] = ["x", "y", "z", "rx", "ry", "rz"];

/// A compliance matrix and all that is needed to show it.
#[derive(Clone, Copy)]
pub struct ComplianceReport<'a> {
    /// Name of the model, with what was asked for.
    pub title: &'a str,
    /// Axes of the report.
    pub axes: Axes,
    /// Units of the report.
    pub units: Units,
    /// The matrix.
    pub compliance: &'a Compliance,
}

/// A row or a column.
struct Line {
    /// Name without unit.
    name: String,
    quantity: Quantity,
    /// The sign between the axes of the report and ISO 8855.
    sign: f64,
}

impl Line {
    fn header(&self, units: Units) -> String {
        format!("{}_{}", self.name, self.quantity.symbol(units))
    }
}

impl ComplianceReport<'_> {
    /// Writes the matrix with the units of rows and columns.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_table(&self, mut writer: impl io::Write) -> io::Result<()> {
        let (rows, columns) = self.lines();
        let at = self.compliance.at().name();
        writeln!(writer, "{}", self.title)?;
        writeln!(writer, "compliance at the {at}: displacements of rows by unit loads of columns")?;
        writeln!(writer)?;
        let unit = |line: &Line| line.quantity.symbol(self.units);
        let width = rows.iter().map(|row| row.name.chars().count() + 1 + unit(row).chars().count());
        let width = width.max().unwrap_or(0);
        let head = |words: Vec<String>| -> String {
            words.iter().map(|word| format!("  {word:>11}")).collect()
        };
        let names = columns.iter().map(|column| column.name.clone()).collect();
        let symbols = columns.iter().map(unit).collect();
        writeln!(writer, "{:width$}{}", "", head(names))?;
        writeln!(writer, "{:width$}{}", "", head(symbols))?;
        for (row, values) in rows.iter().zip(self.values(&rows, &columns)) {
            // Adding zero turns −0 into 0.
            let cells = values.iter().map(|value| format!("{:.4e}", value + 0.0)).collect();
            writeln!(writer, "{:<width$}{}", format!("{} {}", row.name, unit(row)), head(cells))?;
        }
        writeln!(writer)?;
        writeln!(
            writer,
            "asymmetry |C − Cᵀ|/|C| in SI units: {:.1e}",
            self.compliance.asymmetry()
        )?;
        let axes = self.axes.name();
        writeln!(
            writer,
            "unit of an entry: that of its row by that of its column; the rack is held"
        )?;
        writeln!(writer, "forces and displacements: + along the {axes} axes")?;
        writeln!(writer, "moments and rotations: + right-handed about the {axes} axes")
    }

    /// Writes the matrix to 15 significant digits, rows and columns with their names and units.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_csv(&self, writer: impl io::Write) -> io::Result<()> {
        let (rows, columns) = self.lines();
        let mut csv = csv::Writer::from_writer(writer);
        let headers = columns.iter().map(|column| column.header(self.units));
        csv.write_record(std::iter::once("displacement".to_owned()).chain(headers))
            .map_err(of_the_writer)?;
        for (row, values) in rows.iter().zip(self.values(&rows, &columns)) {
            let fields = values.into_iter().map(|value| rounded(value).to_string());
            csv.write_record(std::iter::once(row.header(self.units)).chain(fields))
                .map_err(of_the_writer)?;
        }
        csv.flush()
    }

    /// Writes one object to 15 significant digits.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_json(&self, mut writer: impl io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut writer, &self.json())?;
        writeln!(writer)
    }

    fn json(&self) -> Value {
        let (rows, columns) = self.lines();
        let headers = |lines: &[Line]| -> Vec<String> {
            lines.iter().map(|line| line.header(self.units)).collect()
        };
        let matrix: Vec<Vec<f64>> = self
            .values(&rows, &columns)
            .map(|values| values.into_iter().map(rounded).collect())
            .collect();
        json!({
            "title": self.title,
            "axes": self.axes.name(),
            "at": self.compliance.at().name(),
            "rows": headers(&rows),
            "columns": headers(&columns),
            "matrix": matrix,
            "asymmetry": self.compliance.asymmetry(),
        })
    }

    /// The rows and the columns.
    fn lines(&self) -> (Vec<Line>, Vec<Line>) {
        let signs = self.axes.signs();
        let lines = |names: [&str; 6], kinds: [Quantity; 2]| -> Vec<Line> {
            let sides = self.compliance.sides();
            let wheel = |before: String| {
                (0..6).map(move |k| Line {
                    name: format!("{before}{}", names[k]),
                    quantity: kinds[k / 3],
                    sign: signs[k % 3],
                })
            };
            match sides {
                [_] => wheel(String::new()).collect(),
                _ => sides.iter().flat_map(|side| wheel(format!("{}_", side.name()))).collect(),
            }
        };
        (
            lines(DISPLACEMENTS, [Quantity::Length, Quantity::Angle]),
            lines(LOAD_COMPONENTS, [Quantity::Force, Quantity::Torque]),
        )
    }

    /// The entries in the axes and units of the report, row by row.
    fn values(&self, rows: &[Line], columns: &[Line]) -> impl Iterator<Item = Vec<f64>> {
        let entry = |(row, i): (&Line, usize), (column, j): (&Line, usize)| {
            let load = column.quantity.to_si(self.units, column.sign);
            row.sign * row.quantity.show(self.units, self.compliance.entry(i, j) * load)
        };
        rows.iter().enumerate().map(move |(i, row)| {
            let columns = columns.iter().enumerate();
            columns.map(|(j, column)| entry((row, i), (column, j))).collect()
        })
    }
}
