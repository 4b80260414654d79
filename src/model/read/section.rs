//! A table read key by key.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::FromToml;
use crate::model::diagnostics::Report;
use crate::model::suggest;

/// A table being read. Keys asked for are known; [`Section::finish`] refuses the others.
pub(crate) struct Section<'t> {
    /// The name in brackets; `None` for the outermost table.
    name: Option<String>,
    span: Range<usize>,
    table: &'t DeTable<'t>,
    known: Vec<&'static str>,
    /// Required keys that are not there, each with what to write.
    missing: Vec<(&'static str, String)>,
    skipped: bool,
}

impl<'t> Section<'t> {
    pub(super) fn new(name: Option<String>, span: Range<usize>, table: &'t DeTable<'t>) -> Self {
        Self { name, span, table, known: vec![], missing: vec![], skipped: false }
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

    /// One of a few words on which the other keys of the section depend.
    pub(crate) fn word(
        &mut self,
        key: &'static str,
        what: &str,
        words: &[&'static str],
        report: &mut Report,
    ) -> Option<&'static str> {
        let help = format!("write `{key} = …` with one of {}", suggest::listed(words));
        let text = self.required::<String>(key, &help, report)?;
        let found = words.iter().copied().find(|word| word == text.get_ref());
        if found.is_none() {
            let help = suggest::choices(text.get_ref(), words);
            let message = format!("there is no {what} `{}`", text.get_ref());
            report.mistake(&text.span(), message, format!("unknown {key}")).help(help);
        }
        found
    }

    /// As [`Section::choice`], with a default where the key is absent.
    pub(crate) fn choice_or<T: Copy>(
        &mut self,
        key: &'static str,
        what: &str,
        choices: &[(&str, T)],
        default: T,
        report: &mut Report,
    ) -> Option<T> {
        if !self.has(key) {
            self.known.push(key);
            return Some(default);
        }
        self.choice(key, what, choices, "", report).map(Spanned::into_inner)
    }

    /// Which of some keys is there, of which there must be exactly one; `help` says what to write.
    pub(crate) fn one_of(
        &mut self,
        keys: &[&'static str],
        help: &str,
        report: &mut Report,
    ) -> Option<&'static str> {
        self.known.extend_from_slice(keys);
        let given: Vec<&'static str> = keys.iter().copied().filter(|key| self.has(key)).collect();
        let place = self.name.as_deref().unwrap_or("the file");
        match given[..] {
            [key] => Some(key),
            [] => {
                let keys: Vec<String> = keys.iter().map(|key| format!("`{key}`")).collect();
                let message = format!("{place} lacks {}", keys.join(" or "));
                report.mistake(&self.span, message, "in this section").help(help);
                None
            }
            [first, second, ..] => {
                self.clash(first, second, help, report);
                None
            }
        }
    }

    /// Notes two keys that exclude each other.
    pub(crate) fn clash(&self, first: &str, second: &str, help: &str, report: &mut Report) {
        let span = |key| self.table.get(key).map_or(self.span(), Spanned::span);
        let message = format!("`{first}` and `{second}` exclude each other");
        report
            .mistake(&span(second), message, format!("`{second}`"))
            .also(&span(first), format!("`{first}`"))
            .help(help);
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

    /// Gives up reading: nothing more is noted of this section.
    pub(crate) fn skip(&mut self) {
        self.skipped = true;
    }

    /// Notes the keys that are missing and those that were never asked for.
    /// A key under a misspelt name is one mistake, not two.
    pub(crate) fn finish(mut self, report: &mut Report) {
        if self.skipped {
            return;
        }
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
                None => format!("{place} may hold {}", suggest::listed(&self.known())),
            };
            let message = format!("{place} has no key `{word}`");
            report.mistake(&key.span(), message, "unknown key").help(help);
        }
        self.finish_open(report);
    }

    /// The keys that were asked for, each once.
    fn known(&self) -> Vec<&'static str> {
        let mut known: Vec<&'static str> = vec![];
        for key in &self.known {
            if !known.contains(key) {
                known.push(key);
            }
        }
        known
    }

    /// Notes the keys that are missing only, where the others are not known.
    pub(crate) fn finish_open(self, report: &mut Report) {
        for (key, help) in &self.missing {
            let (message, label) = match &self.name {
                Some(name) => (format!("{name} lacks `{key}`"), "in this section"),
                None => (format!("`{key}` is missing"), "in this file"),
            };
            report.mistake(&self.span, message, label).help(help.as_str());
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
        report.mistake(&value.span(), message, "not a section").help(help);
        return None;
    };
    Some(Section::new(Some(name), value.span(), table))
}
