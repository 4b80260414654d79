//! Reads TOML tables key by key and notes every mistake instead of stopping at the first.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::diagnostics::{Report, SourceFile};
use super::suggest;

/// The only version of the file formats so far.
const FORMAT: f64 = 1.0;

/// Parses the text of a file, notes syntax errors, and hands the outermost table to `read`.
/// A text with syntax errors is not read further: what follows them is not reliable.
pub(crate) fn read_file<T>(
    file: &SourceFile,
    report: &mut Report,
    read: impl FnOnce(&mut Section, &mut Report) -> Option<T>,
) -> Option<T> {
    let (table, errors) = DeTable::parse_recoverable(&file.text);
    if !errors.is_empty() {
        note_syntax_errors(file, &errors, report);
        return None;
    }
    if table.get_ref().is_empty() {
        report
            .mistake(&(0..0), "the file is empty", "nothing here")
            .help("start from one of the files in `models/` or `architectures/`");
        return None;
    }
    let mut root = Section::new(None, 0..0, table.get_ref());
    check_format(&mut root, report);
    let result = read(&mut root, report);
    root.finish(report);
    result
}

/// Notes the first error of each line. After a bracket that is never closed
/// everything seems wrong, so then the first error stands alone.
fn note_syntax_errors(file: &SourceFile, errors: &[toml::de::Error], report: &mut Report) {
    let unclosed = errors.iter().any(|e| e.message().contains("unclosed"));
    let mut last_line = None;
    for error in errors {
        let span = error.span().unwrap_or(0..0);
        let before = &file.text[..file.text.floor_char_boundary(span.start)];
        let line = before.matches('\n').count();
        if last_line == Some(line) || (unclosed && last_line.is_some()) {
            continue;
        }
        last_line = Some(line);
        let message = format!("this is not valid TOML: {}", error.message().trim());
        let text = file.text.lines().nth(line).unwrap_or("");
        let hint = syntax_hint(error.message(), text, unclosed);
        report.mistake(&span, message, "here").help(hint);
    }
}

fn syntax_hint(message: &str, line: &str, unclosed: bool) -> &'static str {
    if unclosed {
        "a closing bracket or quote is missing here or on a line before"
    } else if message.contains("duplicate") {
        "keep one of the two"
    } else if line.trim_start().starts_with('[') || !line.contains('=') {
        "a line is `key = value`, a section starts with its name in brackets such as `[points]`"
    } else {
        "texts stand in double quotes, a point is `[x, y, z]`, decimals use a point: 0.5"
    }
}

fn check_format(root: &mut Section, report: &mut Report) {
    let Some(format) = root.required::<f64>("format", "write `format = 1`", report) else {
        return;
    };
    if *format.get_ref() != FORMAT {
        let message = format!("format {} is not supported", format.get_ref());
        let help = "this version of hardpoint reads `format = 1`";
        report
            .mistake(&format.span(), message, "unknown format")
            .help(help);
    }
}

/// A value that can be read from TOML.
pub(crate) trait FromToml: Sized {
    /// What is expected, with an example.
    const EXPECTED: &'static str;

    /// The value, or `None` after noting what is wrong with it.
    /// `what` names the value in messages, such as "`radius`".
    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self>;
}

fn wrong_type<T: FromToml>(value: &Spanned<DeValue>, what: &str, report: &mut Report) {
    let found = match value.get_ref() {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    };
    let message = format!("{what} must be {}, not {found}", T::EXPECTED);
    let help = match value.get_ref() {
        DeValue::String(_) => "numbers and lists stand without quotes".to_owned(),
        _ => format!("write {}", T::EXPECTED),
    };
    let label = format!("this is {found}");
    report.mistake(&value.span(), message, label).help(help);
}

impl FromToml for String {
    const EXPECTED: &'static str = "a text in double quotes";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let Some(text) = value.get_ref().as_str() else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        if text.trim().is_empty() {
            let message = format!("{what} is empty");
            report
                .mistake(&value.span(), message, "empty")
                .help("write something between the quotes");
            return None;
        }
        Some(text.to_owned())
    }
}

impl FromToml for bool {
    const EXPECTED: &'static str = "true or false";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let flag = value.get_ref().as_bool();
        if flag.is_none() {
            wrong_type::<Self>(value, what, report);
        }
        flag
    }
}

impl FromToml for f64 {
    const EXPECTED: &'static str = "a number such as 12.5";

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        };
        let Some(number) = number else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        if !f64::is_finite(number) {
            report
                .mistake(
                    &value.span(),
                    format!("{what} is not a finite number"),
                    "not finite",
                )
                .help("write the measured value");
            return None;
        }
        Some(number)
    }
}

/// A list of exactly `N` values.
impl<T: FromToml, const N: usize> FromToml for [T; N] {
    const EXPECTED: &'static str = match N {
        2 => "a list of two",
        3 => "three numbers `[x, y, z]`",
        _ => "a list",
    };

    fn read(value: &Spanned<DeValue>, what: &str, report: &mut Report) -> Option<Self> {
        let Some(list) = value.get_ref().as_array() else {
            wrong_type::<Self>(value, what, report);
            return None;
        };
        let items: Vec<T> = list
            .iter()
            .filter_map(|item| T::read(item, what, report))
            .collect();
        if list.len() != N {
            let message = format!("{what} must be {}, not {}", Self::EXPECTED, list.len());
            let label = format!("{} values here", list.len());
            let help = if list.len() == 2 * N {
                "decimals use a point, not a comma: write 420.5, not 420,5".to_owned()
            } else {
                format!("write {}", Self::EXPECTED)
            };
            report.mistake(&value.span(), message, label).help(help);
            return None;
        }
        items.try_into().ok()
    }
}

/// A table being read. Keys asked for are known; [`Section::finish`] refuses the others.
pub(crate) struct Section<'t> {
    /// The name in brackets; `None` for the outermost table.
    name: Option<String>,
    span: Range<usize>,
    table: &'t DeTable<'t>,
    known: Vec<&'static str>,
    /// Required keys that are not there, each with what to write.
    missing: Vec<(&'static str, String)>,
}

impl<'t> Section<'t> {
    fn new(name: Option<String>, span: Range<usize>, table: &'t DeTable<'t>) -> Self {
        Self {
            name,
            span,
            table,
            known: vec![],
            missing: vec![],
        }
    }

    /// Where a missing key belongs: the header of the table, or the start of the file.
    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The keys and values in the order of the text; the section then has no unknown keys.
    pub(crate) fn entries(
        &self,
    ) -> impl Iterator<Item = (Spanned<String>, &'t Spanned<DeValue<'t>>)> {
        self.table
            .iter()
            .map(|(key, value)| (Spanned::new(key.span(), key.get_ref().to_string()), value))
    }

    /// Notes that a section must have at least one line.
    pub(crate) fn not_empty(&self, help: &str, report: &mut Report) {
        if self.table.is_empty() {
            let message = format!("{} is empty", self.name.as_deref().unwrap_or("the file"));
            report.mistake(&self.span, message, "empty").help(help);
        }
    }

    /// Whether the key is there, valid or not.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// The value of a key that may be absent.
    pub(crate) fn value(&mut self, key: &'static str) -> Option<&'t Spanned<DeValue<'t>>> {
        self.known.push(key);
        self.table.get(key)
    }

    /// A value that may be absent.
    pub(crate) fn optional<T: FromToml>(
        &mut self,
        key: &'static str,
        report: &mut Report,
    ) -> Option<Spanned<T>> {
        let value = self.value(key)?;
        let read = T::read(value, &format!("`{key}`"), report)?;
        Some(Spanned::new(value.span(), read))
    }

    /// A value that must be there; `help` says what to write.
    pub(crate) fn required<T: FromToml>(
        &mut self,
        key: &'static str,
        help: &str,
        report: &mut Report,
    ) -> Option<Spanned<T>> {
        if !self.has(key) {
            self.known.push(key);
            self.missing.push((key, help.to_owned()));
            return None;
        }
        self.optional(key, report)
    }

    /// One of a few words. `what` names the kind of word, `hint` explains the choices.
    pub(crate) fn choice<T: Copy>(
        &mut self,
        key: &'static str,
        what: &str,
        choices: &[(&str, T)],
        hint: &str,
        report: &mut Report,
    ) -> Option<Spanned<T>> {
        let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
        let help = format!("`{key}` is one of {}{hint}", suggest::listed(&words));
        let text = self.required::<String>(key, &help, report)?;
        let found = choices.iter().find(|(word, _)| word == text.get_ref());
        if found.is_none() {
            let message = format!("there is no {what} `{}`", text.get_ref());
            let help = suggest::choices(text.get_ref(), &words) + hint;
            report.mistake(&text.span(), message, "unknown").help(help);
        }
        found.map(|(_, value)| Spanned::new(text.span(), *value))
    }

    /// A table that must be there; `help` says what to write.
    pub(crate) fn section(
        &mut self,
        key: &'static str,
        help: &str,
        report: &mut Report,
    ) -> Option<Section<'t>> {
        if !self.has(key) {
            self.known.push(key);
            self.missing.push((key, help.to_owned()));
            return None;
        }
        as_section(self.value(key)?, self.nested(key), help, report)
    }

    /// A table that may be absent; `help` says what to write.
    pub(crate) fn optional_section(
        &mut self,
        key: &'static str,
        help: &str,
        report: &mut Report,
    ) -> Option<Section<'t>> {
        as_section(self.value(key)?, self.nested(key), help, report)
    }

    /// The name of a table in this one: a section of the file has brackets.
    fn nested(&self, key: &str) -> String {
        match self.name {
            None => format!("[{key}]"),
            Some(_) => format!("`{key}`"),
        }
    }

    /// Notes the keys that are missing and those that were never asked for.
    /// A key under a misspelt name is one mistake, not two.
    pub(crate) fn finish(mut self, report: &mut Report) {
        for key in self.table.keys() {
            let word = key.get_ref().as_ref();
            if self.known.contains(&word) {
                continue;
            }
            let unused = self.known.iter().copied().filter(|known| !self.has(known));
            let meant = suggest::closest(word, unused);
            self.missing.retain(|(missing, _)| Some(*missing) != meant);
            let place = self.name.as_deref().unwrap_or("the file");
            let help = match meant {
                Some(known) => format!("did you mean `{known}`?"),
                None => format!("{place} may hold {}", suggest::listed(&self.known)),
            };
            let message = format!("{place} has no key `{word}`");
            report
                .mistake(&key.span(), message, "unknown key")
                .help(help);
        }
        self.finish_open(report);
    }

    /// Notes the keys that are missing only, where the others are not known.
    pub(crate) fn finish_open(self, report: &mut Report) {
        for (key, help) in &self.missing {
            let (message, label) = match &self.name {
                Some(name) => (format!("{name} lacks `{key}`"), "in this section"),
                None => (format!("`{key}` is missing"), "in this file"),
            };
            report
                .mistake(&self.span, message, label)
                .help(help.as_str());
        }
    }
}

/// The value as a table, or `None` after noting that it is none.
pub(crate) fn as_section<'t>(
    value: &'t Spanned<DeValue<'t>>,
    name: String,
    help: &str,
    report: &mut Report,
) -> Option<Section<'t>> {
    let Some(table) = value.get_ref().as_table() else {
        let message = format!("{name} must be a section with `key = value` lines");
        report
            .mistake(&value.span(), message, "not a section")
            .help(help);
        return None;
    };
    Some(Section::new(Some(name), value.span(), table))
}
