//! The relation file as TOML, before any of its expressions is understood.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::source::{Mistake, Source};

/// The only version of the file format.
pub const FORMAT: &str = "1";

/// A text and its place in the file, in bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// The text.
    pub text: String,
    /// Its place: for a value the characters between the quotes.
    pub span: Range<usize>,
}

/// What a file states.
#[derive(Clone, Debug)]
pub enum Statement {
    /// A relation.
    Relation {
        /// Φ(q; h).
        residual: Text,
        /// The virtual motion that the force works on, linear in `delta_*`.
        work: Option<Text>,
    },
    /// The kinetic energy T(q, q̇; h) of a body.
    Energy(Text),
}

impl Statement {
    /// The expression that every file of its kind has.
    pub fn text(&self) -> &Text {
        match self {
            Self::Relation { residual, .. } => residual,
            Self::Energy(energy) => energy,
        }
    }
}

/// A relation file: names and texts, unchecked.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Title in words.
    pub title: Text,
    /// The equation for readers.
    pub equation: Text,
    /// Where the equation comes from.
    pub reference: Text,
    /// What it states.
    pub statement: Statement,
    /// Named intermediate expressions, in order: name, expression.
    pub definitions: Vec<(Text, Text)>,
    /// Parameters h, in order.
    pub parameters: Vec<ParameterDefinition>,
}

/// One parameter of a relation. What is missing was told as a mistake.
#[derive(Clone, Debug)]
pub struct ParameterDefinition {
    /// The name that expressions use.
    pub name: Text,
    /// Number of components: 1 or 3.
    pub size: Option<usize>,
    /// SI unit.
    pub unit: Option<Text>,
    /// The frame of the components of a vector.
    pub frame: Option<Text>,
    /// What it is, in words.
    pub meaning: Option<Text>,
}

/// Reads the TOML of a relation file: what could be read of it, and all
/// mistakes of syntax and structure.
pub fn read(source: &Source) -> (Option<Definition>, Vec<Mistake>) {
    let (table, errors) = DeTable::parse_recoverable(&source.text);
    let mut reader = Reader { text: &source.text, mistakes: Vec::new() };
    for error in errors {
        reader.report(
            error.span().unwrap_or(0..0),
            format!("this is not TOML: {}", error.message().trim()),
            "write the file as constraints/README.md shows",
        );
    }
    // After a mistake of syntax the tables that were read may not be those that were meant.
    let definition = if reader.mistakes.is_empty() { reader.definition(&table) } else { None };
    (definition, reader.mistakes)
}

struct Reader<'a> {
    text: &'a str,
    mistakes: Vec<Mistake>,
}

type Table<'a> = DeTable<'a>;

impl Reader<'_> {
    fn report(&mut self, span: Range<usize>, message: impl Into<String>, help: &str) {
        self.mistakes.push(Mistake::new(span, message, help));
    }

    fn definition(&mut self, table: &Spanned<Table<'_>>) -> Option<Definition> {
        let keys = [
            "format",
            "title",
            "equation",
            "reference",
            "residual",
            "work",
            "energy",
            "definitions",
            "parameters",
        ];
        let whole = 0..self.text.lines().next().map_or(0, str::len);
        let table = table.get_ref();
        self.known_keys(table, &keys, "a relation file");
        match table.get("format").map(|value| (value.get_ref().as_integer(), value.span())) {
            Some((Some(format), _)) if format.as_str() == FORMAT => {}
            Some((_, span)) => self.report(
                span,
                "this version of the file format is not known",
                "write `format = 1`",
            ),
            None => self.report(
                whole.clone(),
                "`format` is missing",
                "begin the file with `format = 1`",
            ),
        }
        let [title, equation, reference] = ["title", "equation", "reference"]
            .map(|key| self.required(table, key, &whole, "the file"));
        let statement = self.statement(table, &whole);
        let definitions = self.table(table, "definitions").map_or_else(Vec::new, |table| {
            table
                .iter()
                .filter_map(|(key, value)| {
                    let name = Text { text: key.get_ref().to_string(), span: key.span() };
                    self.string(value, &name.text).map(|text| (name, text))
                })
                .collect()
        });
        let parameters = self.table(table, "parameters").map_or_else(Vec::new, |table| {
            table.iter().map(|(key, value)| self.parameter(key, value)).collect()
        });
        Some(Definition {
            title: title?,
            equation: equation?,
            reference: reference?,
            statement: statement?,
            definitions,
            parameters,
        })
    }

    fn statement(&mut self, table: &Table<'_>, whole: &Range<usize>) -> Option<Statement> {
        if !table.contains_key("energy") {
            let residual = self.required(table, "residual", whole, "the file");
            let work = table.get("work").and_then(|value| self.string(value, "work"));
            return Some(Statement::Relation { residual: residual?, work });
        }
        for key in ["residual", "work"] {
            if let Some(value) = table.get(key) {
                self.report(
                    value.span(),
                    format!("a file with `energy` has no `{key}`"),
                    "state the kinetic energy of a body and a relation in two files",
                );
            }
        }
        self.required(table, "energy", whole, "the file").map(Statement::Energy)
    }

    fn parameter(
        &mut self,
        key: &Spanned<impl ToString>,
        value: &Spanned<DeValue<'_>>,
    ) -> ParameterDefinition {
        let name = Text { text: key.get_ref().to_string(), span: key.span() };
        let Some(table) = value.get_ref().as_table() else {
            self.report(
                value.span(),
                format!("parameter `{}` is not described by a table", name.text),
                "write `{ shape = 3, unit = \"m\", frame = \"body i\", meaning = \"…\" }`",
            );
            return ParameterDefinition {
                name,
                size: None,
                unit: None,
                frame: None,
                meaning: None,
            };
        };
        self.known_keys(table, &["shape", "unit", "frame", "meaning"], "a parameter");
        let what = format!("parameter `{}`", name.text);
        let size = match table.get("shape") {
            None => {
                self.report(
                    key.span(),
                    format!("{what} has no `shape`"),
                    "add `shape = 1` for a number or `shape = 3` for a vector",
                );
                None
            }
            Some(shape) => match shape.get_ref().as_integer().map(toml::de::DeInteger::as_str) {
                Some("1") => Some(1),
                Some("3") => Some(3),
                _ => {
                    self.report(
                        shape.span(),
                        "the shape of a parameter is 1 or 3",
                        "write `shape = 1` for a number or `shape = 3` for a vector",
                    );
                    None
                }
            },
        };
        let [unit, meaning] =
            ["unit", "meaning"].map(|field| self.required(table, field, &key.span(), &what));
        let frame = table.get("frame").and_then(|value| self.string(value, "frame"));
        ParameterDefinition { name, size, unit, frame, meaning }
    }

    fn known_keys(&mut self, table: &Table<'_>, known: &[&str], what: &str) {
        for key in table.keys() {
            let name: &str = key.get_ref();
            if !known.contains(&name) {
                let help = match closest(name, known.iter().copied()) {
                    Some(close) => format!("did you mean `{close}`?"),
                    None => format!("its keys are {}", known.join(", ")),
                };
                self.report(key.span(), format!("{what} has no key `{name}`"), &help);
            }
        }
    }

    fn table<'t, 'i>(&mut self, table: &'t Table<'i>, key: &str) -> Option<&'t Table<'i>> {
        let value = table.get(key)?;
        let found = value.get_ref().as_table();
        if found.is_none() {
            self.report(value.span(), format!("`{key}` is not a table"), "write it as a table");
        }
        found
    }

    fn required(
        &mut self,
        table: &Table<'_>,
        key: &str,
        place: &Range<usize>,
        what: &str,
    ) -> Option<Text> {
        let Some(value) = table.get(key) else {
            let help = format!("add `{key} = \"…\"`");
            self.report(place.clone(), format!("{what} has no `{key}`"), &help);
            return None;
        };
        let text = self.string(value, key)?;
        if text.text.trim().is_empty() {
            self.report(value.span(), format!("`{key}` is empty"), "say it in a few words");
            return None;
        }
        Some(text)
    }

    fn string(&mut self, value: &Spanned<DeValue<'_>>, key: &str) -> Option<Text> {
        let span = value.span();
        let Some(text) = value.get_ref().as_str() else {
            self.report(span, format!("`{key}` is not a string"), "put it in double quotes");
            return None;
        };
        // Positions inside an expression are positions in the file only where
        // the file holds the very characters of the value.
        let raw = &self.text[span.clone()];
        let quote = if raw.starts_with("\"\"\"") || raw.starts_with("'''") { 3 } else { 1 };
        let inner = &raw[quote..raw.len() - quote];
        let skipped = if quote == 3 && inner.starts_with("\r\n") {
            2
        } else {
            usize::from(quote == 3 && inner.starts_with('\n'))
        };
        if inner[skipped..] != *text {
            self.report(span, format!("`{key}` has an escape"), "write it without a backslash");
            return None;
        }
        let start = span.start + quote + skipped;
        Some(Text { text: text.to_owned(), span: start..start + text.len() })
    }
}

/// The known name that `name` was probably meant to be.
pub fn closest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    known
        .map(|candidate| (strsim::damerau_levenshtein(name, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= 1 + candidate.len() / 4)
        .min()
        .map(|(_, candidate)| candidate)
}
