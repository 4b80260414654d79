//! Models as files of other programs.
//!
//! The numbers are those of the model file, not those in SI that come of them, so that an export that
//! is
//! imported again has the same.

mod adams;
mod csv;
mod json;

use toml::{Table, Value};

use crate::model::{Document, Mistake, Model, ModelDiagnostics};

/// A format to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// The points of a suspension as comma-separated values.
    Csv,
    /// A subsystem of Adams/Car (TeimOrbit): hard points and static angles.
    Adams,
    /// The whole model or mechanism as JSON.
    Json,
}

/// What became of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exported {
    /// The text of the file.
    pub text: String,
    /// What the format has no place for.
    pub left_out: Vec<String>,
}

/// Writes the text of a model or mechanism file in another format. `name` is the path that messages
/// show.
///
/// # Errors
/// [`ModelDiagnostics`] where the model has mistakes, or where the format cannot hold it.
pub fn export(name: &str, text: &str, format: Format) -> Result<Exported, ModelDiagnostics> {
    let document = Document::parse(name, text)?;
    let refuse = |what: &str, help: &str| {
        ModelDiagnostics::new(name, vec![Mistake::without_place(what, help)])
    };
    // A document that has been read is valid TOML.
    let table: Table =
        text.parse().map_err(|_| refuse("this is not valid TOML", "correct the file"))?;
    let model = match (format, document) {
        (Format::Json, _) => return Ok(Exported { text: json::write(table), left_out: vec![] }),
        (_, Document::Suspension(model)) => model,
        (_, Document::Mechanism(_)) => {
            let help = "export it with --to json";
            return Err(refuse("this file is a mechanism; this format holds suspensions", help));
        }
    };
    let suspension = Suspension { table: &table, model: &model };
    match format {
        Format::Adams => Ok(adams::write(&suspension)),
        _ => Ok(csv::write(&suspension)),
    }
}

/// A model with the text that it comes from.
struct Suspension<'a> {
    table: &'a Table,
    model: &'a Model,
}

impl Suspension<'_> {
    /// A value by its path, such as `wheel`, `radius`.
    fn get(&self, path: &[&str]) -> Option<&Value> {
        let (last, sections) = path.split_last()?;
        let table =
            sections.iter().try_fold(self.table, |table, key| table.get(*key)?.as_table())?;
        table.get(*last)
    }

    /// A number of the file.
    fn number(&self, path: &[&str]) -> Option<f64> {
        number(self.get(path)?)
    }

    fn text(&self, path: &[&str]) -> &str {
        self.get(path).and_then(Value::as_str).unwrap_or_default()
    }

    /// The points in the order of the file.
    fn points(&self) -> Vec<(&str, [f64; 3])> {
        let points = self.table.get("points").and_then(Value::as_table);
        let position = |value: &Value| {
            let numbers: Vec<f64> = value.as_array()?.iter().filter_map(number).collect();
            numbers.try_into().ok()
        };
        let points = points.into_iter().flatten();
        points.filter_map(|(name, value)| Some((name.as_str(), position(value)?))).collect()
    }

    /// The sections that have no place in a list of points.
    fn other_sections(&self, taken: &[&str]) -> Vec<String> {
        let sections = self.table.iter().filter(|(key, value)| {
            let is_section = value.is_table() || value.is_array() || key.as_str() == "gravity";
            is_section && !taken.contains(&key.as_str())
        });
        sections.map(|(key, _)| format!("`{key}`")).collect()
    }
}

/// Whole numbers may be written without a point.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Float(number) => Some(*number),
        #[allow(clippy::cast_precision_loss)] // As the model reads it.
        Value::Integer(number) => Some(*number as f64),
        _ => None,
    }
}
