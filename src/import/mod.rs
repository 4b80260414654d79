//! Files of other programs, made into model and mechanism files.
//!
//! An importer gives a text that [`Document::parse`](crate::model::Document::parse) reads, in the units
//! and axes of the source, and lists what it did not take over.

mod adams;
pub mod adm;
mod chrono;
mod csv;
mod draft;
mod json;
mod lotus;
mod names;
mod options;
mod own;
mod points;
mod sheet;

use std::ops::Range;

pub(crate) use adams::{adams_name, of_architecture};
pub use options::{Options, text_of};

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

/// Mistakes beyond this number are not told.
const MOST_MISTAKES: usize = 50;

/// Gathers the mistakes of a source, so that all are told at once.
pub(crate) struct Mistakes(Report);

impl Mistakes {
    /// None so far, in the text of a file.
    pub(crate) fn new(name: &str, text: &str) -> Self {
        Self(Report::new(SourceFile::new(name, text)))
    }

    /// Notes what is wrong with a line, counted from 1.
    pub(crate) fn note(&mut self, line: usize, what: impl Into<String>, help: impl Into<String>) {
        // Whoever has this many does not read more of them.
        if self.0.mistakes.len() >= MOST_MISTAKES {
            return;
        }
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
    import_with(name, text, &Options::default())
}

/// As [`import`], with what the source leaves open.
///
/// # Errors
/// As [`import`].
pub fn import_with(name: &str, text: &str, options: &Options) -> Result<Imported, ImportError> {
    if text.len() as u64 > options::LARGEST_FILE {
        return Err(ImportError::whole(
            name,
            "the file has more than 16 MiB",
            "check that it is the right one",
        ));
    }
    let source = Source { name, text };
    match Format::of(name, text) {
        Some(Format::Dataset) => adm::import(name, text, options.lenient),
        Some(Format::Json) => json::import(source, options),
        Some(Format::Adams) => adams::import(source, options),
        Some(Format::Csv) => csv::import(source, options),
        Some(Format::Lotus) => lotus::import(source, options),
        None => Err(ImportError::whole(
            name,
            "the format of this file is not known",
            "hardpoint imports .adm (Adams/Solver), .json (Project Chrono), .sub and .asy (Adams/Car), .shk and point tables \
             (Lotus), and .csv",
        )),
    }
}

/// A file to import: its path and its text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Source<'a> {
    name: &'a str,
    text: &'a str,
}

impl Source<'_> {
    /// One mistake in a line, counted from 1.
    fn mistake(self, line: usize, what: impl Into<String>, help: impl Into<String>) -> ImportError {
        ImportError::at_line(self.name, self.text, line, what, help)
    }

    /// One mistake of the whole file.
    fn fault(self, what: impl Into<String>, help: impl Into<String>) -> ImportError {
        ImportError::whole(self.name, what, help)
    }

    /// The name of the file without its folder.
    fn file_name(&self) -> &str {
        self.name.rsplit(['/', '\\']).next().unwrap_or(self.name)
    }
}

/// The formats that can be told from each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Dataset,
    Json,
    Adams,
    Csv,
    Lotus,
}

impl Format {
    /// By the ending of the name, or else by what the text starts with.
    fn of(name: &str, text: &str) -> Option<Self> {
        let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let ending = file.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        match ending.as_deref() {
            Some("adm") => return Some(Self::Dataset),
            Some("json") => return Some(Self::Json),
            Some("sub" | "asy" | "bus" | "spr" | "dpr" | "bum" | "reb") => {
                return Some(Self::Adams);
            }
            Some("csv" | "tsv") => return Some(Self::Csv),
            Some("shk") => return Some(Self::Lotus),
            _ => {}
        }
        let start = text.trim_start();
        if start.starts_with('{') || start.starts_with("//") || start.starts_with("/*") {
            Some(Self::Json)
        } else if text.lines().any(|line| line.trim() == "[MDI_HEADER]") {
            Some(Self::Adams)
        } else if lotus::is_lotus(text) {
            Some(Self::Lotus)
        } else if csv::is_points(text) {
            Some(Self::Csv)
        } else {
            None
        }
    }
}
