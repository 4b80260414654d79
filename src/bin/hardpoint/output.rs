//! Where results go, and names that several commands share.

use std::fs;
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use hardpoint::factors::Convention;
use hardpoint::model::{Axes, Drive, Side};

use crate::failure::Failure;

/// A side of the vehicle.
#[derive(Clone, Copy, ValueEnum)]
pub enum SideName {
    /// The left wheel.
    Left,
    /// The right wheel.
    Right,
}

impl From<SideName> for Side {
    fn from(side: SideName) -> Self {
        match side {
            SideName::Left => Self::Left,
            SideName::Right => Self::Right,
        }
    }
}

/// Which height the travel drives.
#[derive(Clone, Copy, ValueEnum)]
pub enum DriveName {
    /// Height of the wheel centre, as Adams/Car.
    WheelCenter,
    /// Height of the contact patch, as Lotus.
    ContactPatch,
}

impl From<DriveName> for Drive {
    fn from(drive: DriveName) -> Self {
        match drive {
            DriveName::WheelCenter => Self::WheelCenter,
            DriveName::ContactPatch => Self::ContactPatch,
        }
    }
}

/// Whose definitions of factors are followed where programs differ.
#[derive(Clone, Copy, Default, ValueEnum)]
pub enum ConventionName {
    /// ISO 8855.
    #[default]
    Iso,
    /// Adams/Car.
    Adams,
    /// Lotus Suspension Analysis: camber as seen from the front, gradients by the patch, trails
    /// from the wheel centre, the height of the centre of gravity less the bump.
    Lotus,
}

impl From<ConventionName> for Convention {
    fn from(convention: ConventionName) -> Self {
        match convention {
            ConventionName::Iso => Self::Iso,
            ConventionName::Adams => Self::Adams,
            ConventionName::Lotus => Self::Lotus,
        }
    }
}

/// How results are written.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Aligned columns with the meaning of each.
    Table,
    /// Comma-separated values to 15 significant digits.
    Csv,
    /// JSON with definitions, Newton iterations and residuals.
    Json,
}

/// How a result is written that is no table of one kind of rows.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Sheet {
    /// For people.
    Table,
    /// JSON to 15 significant digits.
    Json,
}

impl Sheet {
    /// The format that the ending of a file names.
    pub fn of(path: &Path) -> Result<Option<Self>, Failure> {
        match Format::of(path) {
            Some(Format::Csv) => Err(Failure::Usage(
                "this result is no table of one kind of rows; name a file that ends in .json or .txt"
                    .into(),
            )),
            Some(Format::Json) => Ok(Some(Self::Json)),
            Some(Format::Table) => Ok(Some(Self::Table)),
            None => Ok(None),
        }
    }
}

impl Format {
    /// The format that the ending of a file names.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "csv" => Some(Self::Csv),
            "json" => Some(Self::Json),
            "txt" => Some(Self::Table),
            _ => None,
        }
    }
}

/// The words for motions have numbers in ISO 8855 axes; says so where the model has others.
pub fn axes_of_words(axes: Axes, words: &str) -> &'static str {
    let numbers = words.contains("along (") || words.contains("through (");
    if numbers && axes != Axes::Iso8855 { " (numbers in iso8855 axes)" } else { "" }
}

/// Warns of motions of the wheel that nothing holds, in words.
pub fn warn_of_free<'a>(motions: impl Iterator<Item = &'a str>, axes: Axes) {
    for motion in motions {
        let axes = axes_of_words(axes, motion);
        eprintln!(
            "warning: no joint holds this motion: {motion}{axes}; values that depend on it are not \
             determined by the model. Add a joint"
        );
    }
}

/// Where results go.
pub enum Output {
    /// To the terminal or a pipe.
    Stdout,
    /// To a file.
    File(PathBuf),
}

impl Output {
    /// Where `-o` sends the result of a model, which must not take the place of the model.
    pub fn beside(model: &Path, file: Option<&Path>) -> Result<Self, Failure> {
        let Some(file) = file else { return Ok(Self::Stdout) };
        let place = fs::canonicalize(file).ok();
        if place.is_some() && place == fs::canonicalize(model).ok() {
            return Err(Failure::Usage(
                "-o would overwrite the model; name another file".to_owned(),
            ));
        }
        Ok(Self::File(file.to_owned()))
    }

    /// Writes all of it or nothing: a file takes its name only when it is complete.
    pub fn write(
        &self,
        write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        match self {
            Self::Stdout => {
                let mut stdout = BufWriter::new(io::stdout().lock());
                write(&mut stdout)
                    .and_then(|()| stdout.flush())
                    .map_err(|error| Failure::Output("the result".to_owned(), error))
            }
            Self::File(path) => write_file(path, write)
                .map_err(|error| Failure::Output(path.display().to_string(), error)),
        }
    }
}

fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
) -> io::Result<()> {
    // The file that a link leads to takes the new text, not the link.
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(path).ok();
    // A pipe or a device cannot be exchanged for a file; it takes the text as it comes.
    if old.as_ref().is_some_and(|old| !old.is_file() && !old.is_dir()) {
        let mut device = BufWriter::new(fs::OpenOptions::new().write(true).open(path)?);
        return write(&mut device).and_then(|()| device.flush());
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The name of the temporary file, which the full error has, says nothing to a user.
    let file = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
    let mut file = BufWriter::new(file);
    write(&mut file)?;
    let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
    // A file that exists keeps its permissions.
    if let Some(old) = old {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.persist(path).map(drop).map_err(|error| error.error)
}
