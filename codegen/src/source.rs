//! Relation files as they are read, and the mistakes found in them.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{fmt, fs, io};

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report,
};

/// A relation file.
#[derive(Clone, Debug)]
pub struct Source {
    /// Where it was read; messages name it.
    pub path: PathBuf,
    /// File name without its ending: the name of the relation.
    pub name: String,
    /// The whole text.
    pub text: String,
}

impl Source {
    /// A source from text, for a file that may not exist.
    pub fn new(path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        let path = path.into();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Self { path, name, text: text.into() }
    }
}

/// Reads all relation files (`*.toml`) of a folder in the order of their names.
///
/// # Errors
/// What the system says of a folder or file that cannot be read.
pub fn read_folder(folder: &Path) -> io::Result<Vec<Source>> {
    let mut paths = fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<io::Result<Vec<_>>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    paths
        .into_iter()
        .map(|path| fs::read_to_string(&path).map(|text| Source::new(path, text)))
        .collect()
}

/// One mistake in a relation file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// What is wrong.
    pub message: String,
    /// Where, in bytes of the file.
    pub span: Range<usize>,
    /// What to do.
    pub help: String,
}

impl Mistake {
    /// A mistake at a place of the file.
    pub fn new(span: Range<usize>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), span, help: help.into() }
    }
}

/// All mistakes of one file. Its display shows each with `path:line:column`,
/// the underlined source line and what to do.
#[derive(Clone, Debug)]
pub struct Mistakes {
    /// The file.
    pub source: Source,
    /// What is wrong with it, in the order of the file; at least one.
    pub mistakes: Vec<Mistake>,
}

impl fmt::Display for Mistakes {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
            .with_width(100)
            .without_syntax_highlighting();
        let path = self.source.path.display().to_string();
        for mistake in &self.mistakes {
            let end = self.source.text.len();
            let span = mistake.span.start.min(end)..mistake.span.end.min(end);
            let diagnostic = MietteDiagnostic::new(&mistake.message)
                .with_help(&mistake.help)
                .with_label(LabeledSpan::underline(span));
            let report = Report::new(diagnostic)
                .with_source_code(NamedSource::new(&path, self.source.text.clone()));
            handler.render_report(formatter, report.as_ref())?;
        }
        Ok(())
    }
}

impl std::error::Error for Mistakes {}
