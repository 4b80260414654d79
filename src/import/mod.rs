//! Files of other programs, made into model and mechanism files.
//!
//! An importer gives a text that [`Document::parse`](crate::model::Document::parse) reads, in the units
//! and axes of the source, and lists what it did not take over.

pub mod adm;

use std::ops::Range;
use std::path::Path;

use thiserror::Error;

use crate::model::{Mistake, ModelDiagnostics, Report, SourceFile};

/// What became of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// The text of a model or mechanism file.
    pub text: String,
    /// What was not taken over, in the order of the source.
    pub left_out: Vec<LeftOut>,
    /// What the source does not say and the file needs: what was assumed, and what to write instead.
    pub assumed: Vec<String>,
}

/// A part of the source that was not taken over.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LeftOut {
    /// Its line in the source, counted from 1.
    pub line: usize,
    /// What it is, in the words of the source.
    pub what: String,
    /// Why it is not there, or what to do.
    pub why: String,
}

/// Why a file cannot be imported: every mistake with its place and what to do.
#[derive(Clone, Debug, Error)]
#[error(transparent)]
pub struct ImportError(ModelDiagnostics);

impl ImportError {
    /// The mistakes, for messages with the underlined source.
    pub fn diagnostics(&self) -> &ModelDiagnostics {
        &self.0
    }

    /// One mistake of the whole file.
    pub(crate) fn whole(name: &str, what: impl Into<String>, help: impl Into<String>) -> Self {
        Self(ModelDiagnostics::new(name, vec![Mistake::without_place(what, help)]))
    }

    /// One mistake in a line of the text, counted from 1.
    pub(crate) fn at_line(
        name: &str,
        text: &str,
        line: usize,
        what: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        let mut mistakes = Mistakes::new(name, text);
        mistakes.note(line, what, help);
        match mistakes.finish() {
            Err(error) => error,
            Ok(()) => Self::whole(name, "nothing is wrong", "report this to hardpoint"),
        }
    }
}

impl From<ModelDiagnostics> for ImportError {
    fn from(diagnostics: ModelDiagnostics) -> Self {
        Self(diagnostics)
    }
}

/// Gathers the mistakes of a source, so that all are told at once.
pub(crate) struct Mistakes(Report);

impl Mistakes {
    /// None so far, in the text of a file.
    pub(crate) fn new(name: &str, text: &str) -> Self {
        Self(Report::new(SourceFile::new(name, text)))
    }

    /// Notes what is wrong with a line, counted from 1.
    pub(crate) fn note(&mut self, line: usize, what: impl Into<String>, help: impl Into<String>) {
        let span = line_span(&self.0.file().text, line);
        self.0.mistake(&span, what, "here").help(help);
    }

    /// The mistakes as an error, or `Ok` where there are none.
    pub(crate) fn finish(self) -> Result<(), ImportError> {
        Ok(self.0.finish()?)
    }
}

/// The place of a line, counted from 1, without the blanks around it.
fn line_span(text: &str, line: usize) -> Range<usize> {
    let start = match line {
        0 | 1 => 0,
        _ => text.match_indices('\n').nth(line - 2).map_or(text.len(), |(newline, _)| newline + 1),
    };
    let content = text[start..].split('\n').next().unwrap_or("");
    let indent = content.len() - content.trim_start().len();
    start + indent..start + content.trim_end().len().max(indent)
}

/// Makes a model or mechanism file of a text of another program. `name` is the path that messages show;
/// files that the text names are looked for beside it.
///
/// # Errors
/// [`ImportError`] with every mistake that leaves no model.
pub fn import(name: &str, text: &str) -> Result<Imported, ImportError> {
    let ending = Path::new(name).extension().map(std::ffi::OsStr::to_ascii_lowercase);
    if ending.is_some_and(|ending| ending == "adm") {
        return adm::import(name, text, false);
    }
    Err(ImportError::whole(
        name,
        "this is no file that hardpoint can import",
        "the formats are those of docs/import.md",
    ))
}
