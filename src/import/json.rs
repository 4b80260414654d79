//! JSON with comments, as Project Chrono writes it, with the lines of its values.

use std::cell::Cell;

use jsonc_parser::ast;
use jsonc_parser::common::Ranged as _;

use super::options::Options;
use super::{ImportError, Imported, LeftOut, Mistakes, Source, chrono, own};

pub(super) fn import(source: Source, options: &Options) -> Result<Imported, ImportError> {
    let root = Json::parse(source)?;
    if root.has("format") && (root.has("architecture") || root.has("ground")) {
        own::import(source, &root)
    } else {
        chrono::import(source, &root, options)
    }
}

/// A value and its line.
#[derive(Debug)]
pub(super) struct Json {
    pub(super) line: usize,
    pub(super) kind: Kind,
    /// Whether it has been taken over.
    used: Cell<bool>,
}

/// What a value is.
#[derive(Debug)]
pub(super) enum Kind {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

impl Json {
    fn parse(source: Source) -> Result<Self, ImportError> {
        let options = jsonc_parser::ParseOptions::default();
        let parsed = jsonc_parser::parse_to_ast(
            source.text,
            &jsonc_parser::CollectOptions::default(),
            &options,
        );
        let starts = line_starts(source.text);
        let root = match parsed {
            Ok(root) => root.value,
            Err(error) => {
                let line = line_of(&starts, error.range().start);
                let what = format!("this is not valid JSON: {}", error.kind());
                return Err(source.mistake(
                    line,
                    what,
                    "correct the file; comments with // are allowed",
                ));
            }
        };
        let Some(root) = root else {
            return Err(source.fault("the file is empty", "name a file with a suspension"));
        };
        let mut mistakes = Mistakes::new(source.name, source.text);
        let value = convert(&root, &starts, &mut mistakes);
        mistakes.finish()?;
        Ok(value)
    }

    /// The member of an object.
    pub(super) fn get(&self, key: &str) -> Option<&Self> {
        match &self.kind {
            Kind::Object(members) => {
                members.iter().find(|(name, _)| name == key).map(|(_, value)| value)
            }
            _ => None,
        }
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// Marks the value as taken over, with all that is in it.
    pub(super) fn take(&self) -> &Self {
        self.used.set(true);
        self
    }

    /// The number of a member; a mistake where there is another value.
    pub(super) fn number(&self, key: &str, mistakes: &mut Mistakes) -> Option<f64> {
        let value = self.get(key)?.take();
        match value.kind {
            Kind::Number(number) => Some(number),
            _ => {
                mistakes.note(value.line, format!("`{key}` is no number"), "write a number");
                None
            }
        }
    }

    /// The text of a member.
    pub(super) fn text(&self, key: &str) -> Option<&str> {
        match &self.get(key)?.take().kind {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Three numbers of a member; a mistake where there is another value.
    pub(super) fn vector(&self, key: &str, mistakes: &mut Mistakes) -> Option<[f64; 3]> {
        let value = self.get(key)?.take();
        let numbers = value.numbers().and_then(|numbers| numbers.try_into().ok());
        if numbers.is_none() {
            mistakes.note(
                value.line,
                format!("`{key}` is no list of three numbers"),
                "write `[x, y, z]`",
            );
        }
        numbers
    }

    /// The numbers of a list.
    pub(super) fn numbers(&self) -> Option<Vec<f64>> {
        let Kind::List(items) = &self.kind else { return None };
        let number = |item: &Self| match item.kind {
            Kind::Number(number) => Some(number),
            _ => None,
        };
        items.iter().map(number).collect()
    }

    /// The rows of a member that is a table; a mistake where they are not of this length.
    pub(super) fn table(
        &self,
        key: &str,
        columns: usize,
        mistakes: &mut Mistakes,
    ) -> Option<Vec<Vec<f64>>> {
        let value = self.get(key)?.take();
        let Kind::List(items) = &value.kind else {
            mistakes.note(
                value.line,
                format!("`{key}` is no table"),
                "write `[[0.0, 0.0], [1.0, 2.0]]`",
            );
            return None;
        };
        let mut rows = vec![];
        for item in items {
            match item.numbers().filter(|numbers| numbers.len() == columns) {
                Some(numbers) => rows.push(numbers),
                None => {
                    let what = format!("a row of `{key}` is no list of {columns} numbers");
                    mistakes.note(item.line, what, "correct the row");
                    return None;
                }
            }
        }
        Some(rows)
    }

    /// Lists what has not been taken over: whole members, or parts of those of which a part has been.
    pub(super) fn unused(&self, path: &str, why: &str, left_out: &mut Vec<LeftOut>) {
        let members: Vec<(&str, &Self)> = match &self.kind {
            Kind::Object(members) => {
                members.iter().map(|(name, value)| (name.as_str(), value)).collect()
            }
            // The items of a list go by their names.
            Kind::List(items) => {
                items.iter().map(|item| (item.text("Name").unwrap_or("item"), item)).collect()
            }
            _ => return,
        };
        for (name, value) in members.into_iter().filter(|(_, value)| !value.used.get()) {
            let path = if path.is_empty() { name.to_owned() } else { format!("{path} / {name}") };
            if value.touched() {
                value.unused(&path, why, left_out);
            } else {
                left_out.push(LeftOut {
                    line: value.line,
                    what: format!("`{path}`"),
                    why: why.to_owned(),
                });
            }
        }
    }

    /// Whether the value or anything in it has been taken over.
    fn touched(&self) -> bool {
        let inside = match &self.kind {
            Kind::Object(members) => members.iter().any(|(_, value)| value.touched()),
            Kind::List(items) => items.iter().any(Self::touched),
            _ => false,
        };
        self.used.get() || inside
    }
}

/// The deepest nesting is that of the parser, so the recursion is bounded.
fn convert(value: &ast::Value, starts: &[usize], mistakes: &mut Mistakes) -> Json {
    let line = line_of(starts, value.start());
    let kind = match value {
        ast::Value::NullKeyword(_) => Kind::Null,
        ast::Value::BooleanLit(value) => Kind::Bool(value.value),
        ast::Value::StringLit(value) => Kind::Text(value.value.to_string()),
        ast::Value::NumberLit(value) => match value.value.parse::<f64>() {
            Ok(number) if number.is_finite() => Kind::Number(number),
            _ => {
                mistakes.note(
                    line,
                    format!("`{}` is no number that fits", value.value),
                    "correct it",
                );
                Kind::Null
            }
        },
        ast::Value::Array(array) => {
            Kind::List(array.elements.iter().map(|item| convert(item, starts, mistakes)).collect())
        }
        ast::Value::Object(object) => {
            let mut members: Vec<(String, Json)> = vec![];
            let mut seen = std::collections::HashSet::new();
            for member in &object.properties {
                let name = member.name.as_str().to_owned();
                if !seen.insert(name.clone()) {
                    let line = line_of(starts, member.start());
                    mistakes.note(
                        line,
                        format!("`{name}` stands twice in one object"),
                        "keep one of them",
                    );
                }
                members.push((name, convert(&member.value, starts, mistakes)));
            }
            Kind::Object(members)
        }
    };
    Json { line, kind, used: Cell::new(false) }
}

fn line_starts(text: &str) -> Vec<usize> {
    let newlines = text.match_indices('\n').map(|(place, _)| place + 1);
    std::iter::once(0).chain(newlines).collect()
}

fn line_of(starts: &[usize], place: usize) -> usize {
    starts.partition_point(|start| *start <= place)
}
