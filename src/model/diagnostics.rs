//! What is wrong with a file, where, and what to do about it.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource};
use miette::{SourceCode, SourceSpan};
use thiserror::Error;

/// A text file under the name that messages show.
#[derive(Clone, Debug)]
pub(crate) struct SourceFile {
    pub(crate) name: String,
    pub(crate) text: Arc<str>,
}

impl SourceFile {
    pub(crate) fn new(name: &str, text: &str) -> Self {
        Self { name: name.to_owned(), text: text.into() }
    }
}

/// One mistake in a file: what is wrong, where, and what to do.
#[derive(Clone, Debug, Error)]
#[error("{message}")]
pub struct Mistake {
    message: String,
    help: Option<String>,
    labels: Vec<LabeledSpan>,
    file: Option<NamedSource<Arc<str>>>,
}

impl Mistake {
    /// A mistake that belongs to no place in a text, such as a file that is not there.
    pub(crate) fn without_place(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), help: Some(help.into()), labels: vec![], file: None }
    }

    /// Adds what to do.
    pub(crate) fn help(&mut self, help: impl Into<String>) -> &mut Self {
        self.help = Some(help.into());
        self
    }

    /// Underlines one more place.
    pub(crate) fn also(&mut self, span: &Range<usize>, label: impl Into<String>) -> &mut Self {
        let label = Some(label.into());
        self.labels.push(LabeledSpan::new_with_span(label, span.clone()));
        self
    }

    /// What is wrong, in one sentence.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// Line and column of the first underlined place, both counted from 1, columns in characters.
    /// `None` where the mistake belongs to no place in a text.
    pub fn line_and_column(&self) -> Option<(usize, usize)> {
        let text = self.file.as_ref()?.inner();
        let offset = self.labels.first()?.offset();
        let before = text.get(..offset)?;
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        Some((line, before[line_start..].chars().count() + 1))
    }

    fn sort_key(&self) -> (String, usize) {
        let file = self.file.as_ref().map_or("", |file| file.name());
        let offset = self.labels.first().map_or(0, LabeledSpan::offset);
        (file.to_owned(), offset)
    }
}

impl Diagnostic for Mistake {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.file.as_ref().map(|file| file as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}

/// Everything that is wrong with a model and the architecture it uses.
///
/// It is a [`miette::Diagnostic`]: any miette handler prints each mistake with
/// its file, line and column, the underlined source and what to do.
#[derive(Clone, Debug, Error, Diagnostic)]
#[error("{} in {file}", count(mistakes.len()))]
pub struct ModelDiagnostics {
    file: String,
    #[related]
    mistakes: Vec<Mistake>,
}

fn count(mistakes: usize) -> String {
    match mistakes {
        1 => "one mistake".to_owned(),
        many => format!("{many} mistakes"),
    }
}

impl ModelDiagnostics {
    /// Collects mistakes found while reading the file of this name, in the order of the text.
    pub(crate) fn new(file: &str, mut mistakes: Vec<Mistake>) -> Self {
        mistakes.sort_by_cached_key(Mistake::sort_key);
        Self { file: file.to_owned(), mistakes }
    }

    /// The mistakes, at least one, in the order of the text.
    pub fn mistakes(&self) -> &[Mistake] {
        &self.mistakes
    }

    /// The full message without colours, the same on every terminal.
    pub fn render(&self) -> String {
        let theme = GraphicalTheme::unicode_nocolor();
        let handler = GraphicalReportHandler::new_themed(theme);
        self.render_with(&handler.with_links(false).with_width(100))
    }

    /// The full message in the style of a handler: each mistake with its file,
    /// line and column, the underlined source and what to do, then their number.
    pub fn render_with(&self, handler: &GraphicalReportHandler) -> String {
        let mut text = String::new();
        for mistake in &self.mistakes {
            if handler.render_report(&mut text, mistake).is_err() {
                text.push_str(mistake.message());
            }
            text.push('\n');
        }
        text + &format!("{self}\n")
    }
}

/// Gathers the mistakes of one file, so that all are reported at once.
pub(crate) struct Report {
    file: SourceFile,
    pub(crate) mistakes: Vec<Mistake>,
}

impl Report {
    pub(crate) fn new(file: SourceFile) -> Self {
        Self { file, mistakes: vec![] }
    }

    pub(crate) fn file(&self) -> &SourceFile {
        &self.file
    }

    /// Notes a mistake and underlines `span` with `label`.
    pub(crate) fn mistake(
        &mut self,
        span: &Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> &mut Mistake {
        let end = self.file.text.len();
        let span = span.start.min(end)..span.end.min(end);
        let label = Some(label.into());
        let place = SourceSpan::from(span);
        self.mistakes.push(Mistake {
            message: message.into(),
            help: None,
            labels: vec![LabeledSpan::new_primary_with_span(label, place)],
            file: Some(NamedSource::new(&self.file.name, Arc::clone(&self.file.text))),
        });
        let last = self.mistakes.len() - 1;
        &mut self.mistakes[last]
    }

    /// The mistakes as an error, or `Ok` when there are none.
    pub(crate) fn finish(self) -> Result<(), ModelDiagnostics> {
        if self.mistakes.is_empty() {
            return Ok(());
        }
        Err(ModelDiagnostics::new(&self.file.name, self.mistakes))
    }
}
