//! A table for people, with the meaning of every column below it.

use std::io;

use super::SweepReport;

impl SweepReport<'_> {
    /// Writes the columns aligned, lengths and angles to four decimals.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write_table(&self, mut writer: impl io::Write) -> io::Result<()> {
        let units = self.units;
        let axes = self.axes.name();
        match self.sides {
            [] => writeln!(writer, "{}", self.name)?,
            [side] => writeln!(writer, "{}, {} side, {axes} axes", self.name, side.name())?,
            _ => writeln!(writer, "{}, axle, {axes} axes", self.name)?,
        }
        writeln!(writer)?;
        // Names in two lines keep the columns narrow: wheel_center_x becomes `wheel center_x`.
        let columns = self.columns();
        let case = self.cases.map(|_| ("", "case".to_owned()));
        let heads: Vec<(&str, String)> = case
            .into_iter()
            .chain(columns.iter().map(|column| match column.name.split_once('_') {
                Some((first, rest)) => (first, rest.to_owned()),
                None => ("", column.name.clone()),
            }))
            .collect();
        let cells: Vec<Vec<String>> = self
            .sweep
            .rows
            .iter()
            .map(|row| {
                let name = self.case(row).map(str::to_owned);
                name.into_iter().chain(self.values(&columns, row).into_iter().map(cell)).collect()
            })
            .collect();
        let blank = self.cases.map(|_| String::new());
        let symbols = columns.iter().map(|column| column.quantity.symbol(units));
        let symbols: Vec<String> = blank.into_iter().chain(symbols).collect();
        let widths: Vec<usize> = (0..heads.len())
            .map(|k| {
                let values = cells.iter().map(|row| row[k].chars().count());
                let head = [heads[k].0, &heads[k].1, &symbols[k]].map(|word| word.chars().count());
                values.chain(head).max().unwrap_or(0)
            })
            .collect();
        let mut line = |fields: &mut dyn Iterator<Item = &str>| {
            let padded: Vec<String> =
                fields.zip(&widths).map(|(field, width)| format!("{field:>width$}")).collect();
            writeln!(writer, "{}", padded.join("  ").trim_end())
        };
        line(&mut heads.iter().map(|head| head.0))?;
        line(&mut heads.iter().map(|head| head.1.as_str()))?;
        line(&mut symbols.iter().map(String::as_str))?;
        for row in &cells {
            line(&mut row.iter().map(String::as_str))?;
        }
        writeln!(writer)?;
        let width = columns.iter().map(|column| column.name.chars().count()).max().unwrap_or(0);
        for column in &columns {
            let unit = format!("[{}]", column.quantity.symbol(units));
            let (name, sign, formula) = (&column.name, &column.sign, &column.formula);
            writeln!(writer, "{name:<width$} {unit:<6} {sign}; {formula}")?;
        }
        Ok(())
    }
}

/// Four decimals; a value that rounds to zero has no sign, a missing one is a dash.
pub(super) fn cell(value: Option<f64>) -> String {
    cell_to(value, 4)
}

/// So many decimals.
pub(super) fn cell_to(value: Option<f64>, decimals: usize) -> String {
    value.map_or_else(
        || "–".to_owned(),
        |value| {
            let text = format!("{value:.decimals$}");
            if text.trim_start_matches('-').trim_matches(['0', '.']).is_empty() {
                text.trim_start_matches('-').to_owned()
            } else {
                text
            }
        },
    )
}

/// Writes columns, those of numbers to the right.
pub(super) fn write_aligned(
    writer: &mut impl io::Write,
    lines: &[Vec<String>],
    numbers: std::ops::Range<usize>,
) -> io::Result<()> {
    let width = |k: usize| lines.iter().map(|line| line[k].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..lines[0].len()).map(width).collect();
    for line in lines {
        let cells = line.iter().zip(&widths).enumerate().map(|(k, (cell, width))| {
            if numbers.contains(&k) { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
        });
        writeln!(writer, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
    }
    Ok(())
}

/// Five significant digits, with an exponent for what is very small or very large.
pub(super) fn five_digits(value: f64) -> String {
    let text = format!("{value:.4e}");
    let exponent = text.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent {
        Some(exponent @ -4..=6) if value != 0.0 => {
            format!("{value:.*}", usize::try_from(4 - exponent).unwrap_or(0))
        }
        _ if value == 0.0 => "0".to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::{cell, five_digits};

    #[test]
    fn cells_have_no_negative_zero() {
        assert_eq!(cell(Some(-0.00001)), "0.0000");
        assert_eq!(cell(Some(-0.0001)), "-0.0001");
        assert_eq!(cell(Some(-10.0)), "-10.0000");
        assert_eq!(cell(None), "–");
    }

    #[test]
    fn five_digits_are_shown_at_any_size() {
        assert_eq!(five_digits(0.0), "0");
        assert_eq!(five_digits(-0.123_456_7), "-0.12346");
        assert_eq!(five_digits(1234.567), "1234.6");
        assert_eq!(five_digits(1_234_567.0), "1234567");
        assert_eq!(five_digits(1e-7), "1.0000e-7");
        assert_eq!(five_digits(1.0), "1.0000");
    }
}
