//! New numbers in the text of a model file. Everything else of it stays, byte for byte.

use std::ops::Range;
use std::path::Path;

use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::model::{Model, ModelDiagnostics, Quantity, Side, read_file};

/// Decimals of the numbers that are written, in the units of the file.
const DECIMALS: usize = 6;

/// The text of a model file whose numbers are exchanged.
///
/// Only the digits of numbers that change are written anew; comments, order, spaces, line ends and the
/// numbers that do not change stay as they are. A file that the model names as its other side is not touched.
#[derive(Clone, Debug)]
pub struct ModelText {
    name: String,
    text: String,
    model: Model,
    decimals: usize,
}

/// Why a number was not exchanged.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum EditError {
    /// The file does not have it.
    #[error("{file} has no number `{path}` to change; write it into the file first")]
    Missing {
        /// The file.
        file: String,
        /// Keys and names, separated by dots.
        path: String,
    },
    /// There is something else.
    #[error("`{path}` of {file} is not a number that can be changed")]
    NotANumber {
        /// The file.
        file: String,
        /// Keys and names, separated by dots.
        path: String,
    },
    /// The new number is none.
    #[error("the new value of `{path}` is not a finite number")]
    NotFinite {
        /// Keys and names, separated by dots.
        path: String,
    },
}

impl ModelText {
    /// Reads the text of a model file.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] where the file cannot be read or is not that of a model.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, ModelDiagnostics> {
        let (name, text) = read_file(path.as_ref())?;
        Self::new(&name, &text)
    }

    /// The text of a model file; `name` is its path, which messages show.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] where the text is not that of a model.
    pub fn new(name: &str, text: &str) -> Result<Self, ModelDiagnostics> {
        let model = Model::parse(name, text)?;
        Ok(Self { name: name.to_owned(), text: text.to_owned(), model, decimals: DECIMALS })
    }

    /// The same with another number of decimals than six, in the units of the file.
    #[must_use]
    pub fn with_decimals(self, decimals: usize) -> Self {
        Self { decimals, ..self }
    }

    /// The text as it is by now.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Reads the text as it is by now: numbers have been rounded, so this is the model that a user of the file has.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] where the new numbers make no suspension.
    pub fn read(&self) -> Result<Model, ModelDiagnostics> {
        Model::parse(&self.name, &self.text)
    }

    /// Moves a point to a position (m, ISO 8855 axes) that belongs to a side of the vehicle. A file of the other side has
    /// its mirror image.
    ///
    /// # Errors
    /// [`EditError`] where the file has no such point; nothing has changed then.
    pub fn set_point(
        &mut self,
        name: &str,
        mut position: [f64; 3],
        side: Side,
    ) -> Result<(), EditError> {
        if side != self.model.side {
            position[1] = -position[1];
        }
        let before = self.text.clone();
        for (axis, coordinate) in ["0", "1", "2"].iter().zip(self.model.axes.from_iso(position)) {
            let set = self.set(&["points", name, axis], Quantity::Length, coordinate);
            if set.is_err() {
                self.text = before;
                return set;
            }
        }
        Ok(())
    }

    /// Sets a number to a value (SI). Its path has the keys from the outermost section on; sections of a list
    /// such as `[[forces]]` go by their names, values of a list by their places from 0:
    /// `["forces", "spring", "stiffness"]`, `["bushings", "front", "stiffness", "2"]`.
    ///
    /// # Errors
    /// [`EditError`] where the file has no such number; nothing has changed then.
    pub fn set(&mut self, path: &[&str], quantity: Quantity, value: f64) -> Result<(), EditError> {
        let new = quantity.show(self.model.units, value);
        if !new.is_finite() {
            return Err(EditError::NotFinite { path: path.join(".") });
        }
        let Some((place, old)) = self.number(path)? else {
            let (file, path) = (self.name.clone(), path.join("."));
            return Err(EditError::NotANumber { file, path });
        };
        let digits = written(new, self.decimals);
        // A number that differs by rounding only keeps its own digits.
        if (new - old).abs()
            > 0.5 * 10_f64.powf(-f64::from(u32::try_from(self.decimals).unwrap_or(u32::MAX)))
        {
            self.text.replace_range(place, &digits);
        }
        Ok(())
    }

    /// The place and the value of a number; `None` where there is something else.
    fn number(&self, path: &[&str]) -> Result<Option<(Range<usize>, f64)>, EditError> {
        // The text has been read before.
        let (table, _) = DeTable::parse_recoverable(&self.text);
        let Some(value) = find(table.get_ref(), path) else {
            return Err(EditError::Missing { file: self.name.clone(), path: path.join(".") });
        };
        let number = match value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        };
        Ok(number.map(|number| (value.span(), number)))
    }
}

fn find<'t>(table: &'t DeTable<'t>, path: &[&str]) -> Option<&'t Spanned<DeValue<'t>>> {
    let (first, rest) = path.split_first()?;
    rest.iter().try_fold(table.get(*first)?, |value, key| match value.get_ref() {
        DeValue::Table(table) => table.get(*key),
        DeValue::Array(list) => {
            let named = list.iter().find(|item| {
                let name = item.get_ref().as_table().and_then(|table| table.get("name"));
                name.is_some_and(|name| name.get_ref().as_str() == Some(*key))
            });
            named.or_else(|| list.get(key.parse::<usize>().ok()?))
        }
        _ => None,
    })
}

/// A number with at most so many decimals, and at least one.
fn written(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = match text.split_once('.') {
        Some((whole, part)) => {
            let part = part.trim_end_matches('0');
            format!("{whole}.{}", if part.is_empty() { "0" } else { part })
        }
        None => format!("{text}.0"),
    };
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn numbers_have_the_decimals_that_they_need() {
        assert_eq!(written(12.0, 6), "12.0");
        assert_eq!(written(-12.345_678_94, 6), "-12.345679");
        assert_eq!(written(-1e-9, 6), "0.0");
        assert_eq!(written(0.25, 0), "0.0");
        assert_eq!(written(1234.5, 0), "1234.0");
        assert_eq!(written(3.0e15, 2), "3000000000000000.0");
    }
}
