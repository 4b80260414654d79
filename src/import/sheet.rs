//! Writes the text of model and mechanism files.

use std::fmt::Write as _;

/// A value of a key.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Text(String),
    Texts(Vec<String>),
    Number(f64),
    Numbers(Vec<f64>),
    Rows(Vec<[f64; 2]>),
    /// Tables of rows by component.
    Tables(Vec<(&'static str, Vec<[f64; 2]>)>),
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl<const N: usize> From<[f64; N]> for Value {
    fn from(numbers: [f64; N]) -> Self {
        Self::Numbers(numbers.to_vec())
    }
}

impl<const N: usize> From<[&str; N]> for Value {
    fn from(texts: [&str; N]) -> Self {
        Self::Texts(texts.map(str::to_owned).to_vec())
    }
}

impl Value {
    /// The value as TOML.
    fn text(&self) -> String {
        match self {
            Self::Text(text) => quoted(text),
            Self::Texts(texts) => list(texts.iter().map(|text| quoted(text))),
            Self::Number(number) => format!("{number:?}"),
            Self::Numbers(numbers) => list(numbers.iter().map(|number| format!("{number:?}"))),
            Self::Rows(table) => {
                let rows = table.iter().map(|[x, y]| format!("    [{x:?}, {y:?}],\n"));
                format!("[\n{}]", rows.collect::<String>())
            }
            Self::Tables(tables) => {
                let row = |[x, y]: &[f64; 2]| format!("[{x:?}, {y:?}]");
                let table = |table: &[[f64; 2]]| list(table.iter().map(row));
                let tables = tables.iter().map(|(key, rows)| format!("{key} = {}", table(rows)));
                format!("{{ {} }}", tables.collect::<Vec<_>>().join(", "))
            }
        }
    }
}

fn list(items: impl Iterator<Item = String>) -> String {
    format!("[{}]", items.collect::<Vec<_>>().join(", "))
}

fn quoted(text: &str) -> String {
    toml::Value::String(one_line(text)).to_string()
}

/// The text without line breaks and other controls, which have no place in a comment or a name.
fn one_line(text: &str) -> String {
    let words = text.split(|c: char| c.is_control() || c.is_whitespace());
    words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// A word that can be a key without quotes: lower-case letters, digits and `_`.
pub(crate) fn word(text: &str) -> String {
    let mut word = String::new();
    for c in text.trim().chars() {
        match c {
            c if c.is_ascii_alphanumeric() => word.push(c.to_ascii_lowercase()),
            _ if !word.ends_with('_') => word.push('_'),
            _ => {}
        }
    }
    let word = word.trim_matches('_');
    if word.is_empty() { "unnamed".to_owned() } else { word.to_owned() }
}

/// The text of a file as it grows.
#[derive(Debug, Default)]
pub(crate) struct Sheet(String);

impl Sheet {
    /// A comment on lines of its own.
    pub(crate) fn comment(&mut self, text: &str) {
        let mut line = String::from("#");
        for word in one_line(text).split(' ') {
            if line.len() + word.len() > 96 && line != "#" {
                self.line(&line);
                line = String::from("#");
            }
            line.push(' ');
            line.push_str(word);
        }
        self.line(&line);
    }

    /// The heading of a section, such as `[points]`.
    pub(crate) fn section(&mut self, heading: &str) {
        if !self.0.is_empty() {
            self.line("");
        }
        self.line(heading);
    }

    /// A key with its value, and what there is to say of it.
    pub(crate) fn set(&mut self, key: &str, value: &Value, comment: &str) {
        let (value, comment) = (value.text(), one_line(comment));
        let line = format!("{key} = {value}");
        if comment.is_empty() {
            self.line(&line);
        } else {
            self.line(&format!("{line}  # {comment}"));
        }
    }

    fn line(&mut self, line: &str) {
        // Writing into a text cannot fail.
        let _ = writeln!(self.0, "{line}");
    }

    pub(crate) fn into_text(self) -> String {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_can_be_read_again() {
        let mut sheet = Sheet::default();
        sheet.comment("a\u{7}b\nc");
        sheet.set("text", &Value::from("a \"b\"\\ 'c'\n\u{1}d"), "why\nnot");
        sheet.set("number", &Value::from(1e-300), "");
        sheet.set("large", &Value::from(-1e300), "");
        sheet.set("list", &Value::from([0.1, -0.0, 797.9]), "");
        sheet.set("rows", &Value::Rows(vec![[0.0, 1.0], [2.5, 3.0]]), "rows");
        sheet.set("tables", &Value::Tables(vec![("x", vec![[0.0, 1.0]]), ("rz", vec![])]), "");
        let text = sheet.into_text();
        let table: toml::Table = text.parse().unwrap_or_else(|error| panic!("{text}\n{error}"));
        assert_eq!(table["text"].as_str(), Some("a \"b\"\\ 'c' d"));
        assert_eq!(table["number"].as_float(), Some(1e-300));
        assert_eq!(table["large"].as_float(), Some(-1e300));
        assert_eq!(table["list"][2].as_float(), Some(797.9));
        assert_eq!(table["rows"][1][0].as_float(), Some(2.5));
        assert_eq!(table["tables"]["x"][0][1].as_float(), Some(1.0));
    }

    #[test]
    fn words_are_keys() {
        assert_eq!(word("  F LCA-Outer.x "), "f_lca_outer_x");
        assert_eq!(word("'ä'"), "unnamed");
    }
}
