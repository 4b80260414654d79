//! Where results go, and names that several commands share.

use std::fs;
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use hardpoint::model::{Drive, Side};

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

/// How results are written.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Aligned columns with the meaning of each.
    Table,
    /// Comma-separated values in full precision.
    Csv,
    /// JSON with definitions, Newton iterations and residuals.
    Json,
}

impl Format {
    /// The format that the ending of a file names.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()? {
            "csv" => Some(Self::Csv),
            "json" => Some(Self::Json),
            "txt" => Some(Self::Table),
            _ => None,
        }
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
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = BufWriter::new(builder.tempfile_in(folder)?);
    write(&mut file)?;
    let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
    // A file that exists keeps its permissions.
    if let Ok(old) = fs::metadata(path) {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.persist(path).map(drop).map_err(|error| error.error)
}
