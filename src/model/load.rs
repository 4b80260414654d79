//! Finds and opens files.

use std::io;
use std::path::Path;

use super::architecture::Architecture;
use super::diagnostics::{Mistake, ModelDiagnostics, Report, SourceFile};
use super::fittings::other_side;
use super::read::Section;
use super::suggest;
use super::{MechanismModel, Model};
use toml::Spanned;

impl Model {
    /// Reads a model file.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the file and of its architecture.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, ModelDiagnostics> {
        let (name, text) = read_file(path.as_ref())?;
        Self::parse(&name, &text)
    }

    /// Reads a model from the text of a file. `name` is the file name that messages show, and
    /// the paths of an architecture and of the other side are relative to it.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the text and of its architecture.
    pub fn parse(name: &str, text: &str) -> Result<Self, ModelDiagnostics> {
        Self::read(name, text, model)
    }

    fn read(
        name: &str,
        text: &str,
        model: impl FnOnce(&mut Section, &mut Report) -> Option<Self>,
    ) -> Result<Self, ModelDiagnostics> {
        let file = SourceFile::new(name, text);
        let mut report = Report::new(file.clone());
        let model = super::read::read_file(&file, &mut report, |root, report| {
            if is_mechanism(root) {
                note_mechanism(root, report);
                return None;
            }
            model(root, report)
        });
        super::finish(model, report)
    }
}

/// What a file describes.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant)] // One of them is loaded at a time.
pub enum Document {
    /// One corner of a vehicle, with an architecture.
    Suspension(Model),
    /// A mechanism of one's own.
    Mechanism(MechanismModel),
}

impl Document {
    /// Reads a suspension or a mechanism file.
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the file.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, ModelDiagnostics> {
        let (name, text) = read_file(path.as_ref())?;
        Self::parse(&name, &text)
    }

    /// Reads the text of a file, as [`Model::parse`].
    ///
    /// # Errors
    /// [`ModelDiagnostics`] with every mistake of the text.
    pub fn parse(name: &str, text: &str) -> Result<Self, ModelDiagnostics> {
        let file = SourceFile::new(name, text);
        let mut report = Report::new(file.clone());
        let document = super::read::read_file(&file, &mut report, |root, report| {
            if is_mechanism(root) {
                return super::mechanism_file::read(root, report).map(Self::Mechanism);
            }
            if !root.has("architecture") {
                let span = root.span();
                report
                    .mistake(&span, "the file names neither `architecture` nor `ground`", "in this file")
                    .help(
                        "a suspension names its `architecture`, such as `architecture = \"double-wishbone\"`; \
                         a mechanism of its own names the body that never moves: `ground = \"ground\"`",
                    );
                root.skip();
                return None;
            }
            model(root, report).map(Self::Suspension)
        });
        super::finish(document, report)
    }
}

fn model(root: &mut Section, report: &mut Report) -> Option<Model> {
    let named = root.optional::<String>("other_side", report);
    let file = super::file::read(root, report);
    let model = super::resolve::resolve(root, file, report);
    let other = named.as_ref().and_then(|named| other_side::read(named, report));
    let mut model = model?;
    if let (Some(named), Some(other)) = (named, other) {
        other_side::join(&mut model, other, &named, report);
    }
    Some(model)
}

/// Reads a model without the other side that it may name, which would name this one again.
pub(super) fn alone(name: &str, text: &str) -> Result<Model, ModelDiagnostics> {
    Model::read(name, text, |root, report| {
        root.value("other_side");
        let file = super::file::read(root, report);
        super::resolve::resolve(root, file, report)
    })
}

/// A mechanism has a ground of its own; that of a suspension comes with the architecture.
fn is_mechanism(root: &Section) -> bool {
    root.has("ground") && !root.has("architecture")
}

fn note_mechanism(root: &mut Section, report: &mut Report) {
    let span = root.value("ground").map_or(root.span(), Spanned::span);
    report
        .mistake(&span, "this file is a mechanism, not a suspension", "a ground of its own")
        .help("only a suspension will do here; one names its `architecture`, such as `architecture = \"double-wishbone\"`");
    root.skip();
}

/// The name and the text of a file.
pub(crate) fn read_file(path: &Path) -> Result<(String, String), ModelDiagnostics> {
    let name = path.display().to_string();
    match read_text(path) {
        Ok(text) => Ok((name, text)),
        Err((message, help)) => {
            Err(ModelDiagnostics::new(&name, vec![Mistake::without_place(message, help)]))
        }
    }
}

/// The architecture that a model names; mistakes in it are added to the report.
pub(super) fn architecture(named: &Spanned<String>, report: &mut Report) -> Option<Architecture> {
    let word = named.get_ref().as_str();
    let result = if Path::new(word).extension().is_some_and(|end| end == "toml") {
        let model = Path::new(&report.file().name);
        let path = model.parent().unwrap_or(Path::new("")).join(word);
        match read_text(&path) {
            Ok(text) => Architecture::parse(&path.display().to_string(), &text),
            Err((message, help)) => {
                let help = format!("{help}; the path is relative to the model file");
                report.mistake(&named.span(), message, "the architecture").help(help);
                return None;
            }
        }
    } else if let Some(result) = Architecture::built_in(word) {
        result
    } else {
        let help = format!(
            "{}; a file of your own is a path that ends in .toml",
            suggest::choices(word, &Architecture::built_in_names())
        );
        let message = format!("there is no built-in architecture `{word}`");
        report.mistake(&named.span(), message, "unknown architecture").help(help);
        return None;
    };
    match result {
        Ok(architecture) => Some(architecture),
        Err(diagnostics) => {
            report.mistakes.extend_from_slice(diagnostics.mistakes());
            None
        }
    }
}

/// The text of a file, or what is wrong and what to do.
pub(crate) fn read_text(path: &Path) -> Result<String, (String, String)> {
    let name = path.display();
    if path.is_dir() {
        let message = format!("`{name}` is a folder, not a file");
        return Err((message, "name a file in it that ends in .toml".to_owned()));
    }
    let bytes = std::fs::read(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => {
            (format!("there is no file `{name}`"), "check the path".to_owned())
        }
        _ => (
            format!("`{name}` cannot be read: {error}"),
            "check that you may read the file".to_owned(),
        ),
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let good = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = good.iter().filter(|byte| **byte == b'\n').count() + 1;
        (
            format!("`{name}` is not a UTF-8 text, see line {line}"),
            "save it as UTF-8 in your editor".to_owned(),
        )
    })
}
