//! TeimOrbit, the text format of Adams/Car: blocks of keys with values, and tables.

use crate::import::{ImportError, Mistakes, Source};
use crate::model::{AngleUnit, ForceUnit, LengthUnit, MassUnit, Units};

/// A file.
#[derive(Debug)]
pub(super) struct Orbit<'a> {
    pub(super) source: Source<'a>,
    pub(super) blocks: Vec<Block>,
}

/// `[NAME]` with all that follows it.
#[derive(Debug, Default)]
pub(super) struct Block {
    pub(super) name: String,
    pub(super) line: usize,
    keys: Vec<Key>,
    /// Rows of its tables.
    pub(super) rows: Vec<Row>,
}

/// `NAME = value`.
#[derive(Debug)]
struct Key {
    name: String,
    value: Cell,
    line: usize,
    /// Whether anybody has asked for it.
    read: std::cell::Cell<bool>,
}

/// A row of a table.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) line: usize,
    pub(super) cells: Vec<Cell>,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    /// In quotes, without the blanks at its ends.
    Text(String),
    Number(f64),
    /// Anything else.
    Word(String),
}

impl Cell {
    pub(super) fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    pub(super) fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) | Self::Word(text) => Some(text),
            Self::Number(_) => None,
        }
    }
}

impl Block {
    pub(super) fn get(&self, key: &str) -> Option<&Cell> {
        let found = self.keys.iter().find(|known| known.name.eq_ignore_ascii_case(key))?;
        found.read.set(true);
        Some(&found.value)
    }

    pub(super) fn text(&self, key: &str) -> Option<&str> {
        self.get(key)?.text()
    }

    pub(super) fn number(&self, key: &str) -> Option<f64> {
        self.get(key)?.number()
    }

    /// The keys that nobody has asked for, with their lines.
    pub(super) fn unread(&self) -> impl Iterator<Item = (&str, usize)> {
        self.keys.iter().filter(|key| !key.read.get()).map(|key| (key.name.as_str(), key.line))
    }

    /// The rows of two numbers, as curves have them.
    pub(super) fn curve(&self) -> Vec<[f64; 2]> {
        let pair = |row: &Row| match row.cells[..] {
            [Cell::Number(x), Cell::Number(y), ..] => Some([x, y]),
            _ => None,
        };
        self.rows.iter().filter_map(pair).collect()
    }
}

impl<'a> Orbit<'a> {
    /// Reads a file; lines that have no place in the format are mistakes.
    pub(super) fn parse(source: Source<'a>) -> Result<Self, ImportError> {
        let mut mistakes = Mistakes::new(source.name, source.text);
        let mut blocks: Vec<Block> = vec![];
        for (index, text) in source.text.lines().enumerate() {
            let line = index + 1;
            let text = without_comment(text).trim();
            if text.is_empty() {
                continue;
            }
            if let Some(name) = text.strip_prefix('[').and_then(|rest| rest.split(']').next()) {
                blocks.push(Block {
                    name: name.trim().to_ascii_uppercase(),
                    line,
                    ..Block::default()
                });
                continue;
            }
            let Some(block) = blocks.last_mut() else {
                mistakes.note(
                    line,
                    "this line stands before the first block",
                    "a file starts with [MDI_HEADER]",
                );
                break;
            };
            if text.starts_with(['(', '{']) {
                // Names of tables and of columns: every block here has those that it always has.
            } else if let Some((key, value)) = key_and_value(text) {
                let cell = cells(value).into_iter().next().unwrap_or(Cell::Word(String::new()));
                let read = std::cell::Cell::new(false);
                block.keys.push(Key { name: key.to_owned(), value: cell, line, read });
            } else {
                block.rows.push(Row { line, cells: cells(text) });
            }
        }
        mistakes.finish()?;
        Ok(Self { source, blocks })
    }

    /// The first block of this name.
    pub(super) fn block(&self, name: &str) -> Option<&Block> {
        self.blocks.iter().find(|block| block.name == name)
    }

    /// The units of the file.
    pub(super) fn units(&self) -> Result<Units, ImportError> {
        let Some(block) = self.block("UNITS") else {
            return Err(self
                .source
                .fault("the file has no block [UNITS]", "nothing is guessed: add it"));
        };
        let length = self.unit(
            block,
            "LENGTH",
            &[
                ("mm", LengthUnit::Millimetre),
                ("millimeter", LengthUnit::Millimetre),
                ("cm", LengthUnit::Centimetre),
                ("centimeter", LengthUnit::Centimetre),
                ("meter", LengthUnit::Metre),
                ("m", LengthUnit::Metre),
                ("inch", LengthUnit::Inch),
            ],
        )?;
        let angle = self.unit(
            block,
            "ANGLE",
            &[
                ("deg", AngleUnit::Degree),
                ("degree", AngleUnit::Degree),
                ("rad", AngleUnit::Radian),
                ("radian", AngleUnit::Radian),
            ],
        )?;
        let force = self.unit(
            block,
            "FORCE",
            &[
                ("newton", ForceUnit::Newton),
                ("n", ForceUnit::Newton),
                ("knewton", ForceUnit::Kilonewton),
                ("kilonewton", ForceUnit::Kilonewton),
                ("pound_force", ForceUnit::PoundForce),
                ("lbf", ForceUnit::PoundForce),
            ],
        )?;
        let mass = self.unit(
            block,
            "MASS",
            &[
                ("kg", MassUnit::Kilogram),
                ("kilogram", MassUnit::Kilogram),
                ("gram", MassUnit::Gram),
                ("tonne", MassUnit::Tonne),
                ("pound_mass", MassUnit::Pound),
                ("lbm", MassUnit::Pound),
            ],
        )?;
        self.unit(block, "TIME", &[("sec", ()), ("second", ()), ("s", ())])?;
        Ok(Units { length, angle, force, mass })
    }

    fn unit<T: Copy>(
        &self,
        block: &Block,
        key: &str,
        known: &[(&str, T)],
    ) -> Result<T, ImportError> {
        let Some(word) = block.text(key) else {
            return Err(self.source.mistake(block.line, format!("[UNITS] lacks {key}"), "add it"));
        };
        let plain = word.to_ascii_lowercase();
        let plain = plain.strip_suffix('s').filter(|single| !single.is_empty()).unwrap_or(&plain);
        let found =
            known.iter().find(|(name, _)| *name == plain || *name == word.to_ascii_lowercase());
        found.map(|(_, unit)| *unit).ok_or_else(|| {
            let words: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
            let help = format!("the units that are known here: {}", words.join(", "));
            self.source.mistake(
                block.line,
                format!("the unit `{word}` of {key} is not known"),
                help,
            )
        })
    }
}

/// The text before `$`, which starts a comment outside of quotes, as does `!` at the start of a line.
fn without_comment(text: &str) -> &str {
    if text.trim_start().starts_with('!') {
        return "";
    }
    let mut quoted = false;
    for (place, c) in text.char_indices() {
        match c {
            '\'' => quoted = !quoted,
            '$' if !quoted => return &text[..place],
            _ => {}
        }
    }
    text
}

/// `KEY = value`, where the line is that and no row with an equals sign in quotes.
fn key_and_value(text: &str) -> Option<(&str, &str)> {
    let (key, value) = text.split_once('=')?;
    let key = key.trim();
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    (!key.is_empty() && key.chars().all(is_name)).then_some((key, value.trim()))
}

/// The values of a line, separated by blanks or commas.
fn cells(text: &str) -> Vec<Cell> {
    let mut cells = vec![];
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        if let Some(quoted) = rest.strip_prefix('\'') {
            let (inside, after) = quoted.split_once('\'').unwrap_or((quoted, ""));
            cells.push(Cell::Text(inside.trim().to_owned()));
            rest = after;
        } else {
            let end = rest
                .find(|c: char| c.is_whitespace() || c == ',' || c == '\'')
                .unwrap_or(rest.len());
            let (word, after) = rest.split_at(end);
            if !word.is_empty() {
                let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
                cells.push(number.map_or_else(|| Cell::Word(word.to_owned()), Cell::Number));
            }
            rest = after;
        }
        rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_have_keys_and_rows() {
        let text = "$ a comment\n[UNITS]\n LENGTH = 'mm  '  $ millimetres\n[CURVE]\n{disp force}\n-1.0 -2e3\n 1, 2\n\
                    [CURVE]\n(PART)\n'name of  ' 'left/right' 3 \n";
        let orbit = Orbit::parse(Source { name: "x", text }).unwrap();
        let names: Vec<&str> = orbit.blocks.iter().map(|block| block.name.as_str()).collect();
        assert_eq!(names, ["UNITS", "CURVE", "CURVE"]);
        assert_eq!(orbit.blocks[0].text("length"), Some("mm"));
        assert_eq!(orbit.blocks[1].curve(), [[-1.0, -2000.0], [1.0, 2.0]]);
        let row = &orbit.blocks[2].rows[0];
        assert_eq!((row.cells[0].text(), row.line), (Some("name of"), 10));
        assert_eq!(row.cells[2].number(), Some(3.0));
    }
}
