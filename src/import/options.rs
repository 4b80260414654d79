//! What a user says of a source that the source does not say itself.

use std::fs;
use std::path::{Path, PathBuf};

use crate::model::{Axes, Axle, LengthUnit, Side};

/// What a source may leave open. Where it does not, what it says counts.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// A built-in architecture, or a path ending in `.toml` as the model shall have it.
    pub architecture: Option<String>,
    /// The unit of lengths.
    pub length: Option<LengthUnit>,
    /// The axes.
    pub axes: Option<Axes>,
    /// The side to take, where the source has two.
    pub side: Option<Side>,
    /// The axle to take, where the source has two.
    pub axle: Option<Axle>,
    /// The rolling radius of the tyre, in the unit of the source.
    pub wheel_radius: Option<f64>,
    /// Folders of Adams databases by their names: `mdids://NAME/…` and `<NAME>/…` lie there.
    pub databases: Vec<(String, PathBuf)>,
    /// Whether what an Adams/Solver dataset has and hardpoint does not is left out although that changes the
    /// mechanism; otherwise it is a mistake.
    pub lenient: bool,
}

/// Files larger than this are no suspension.
pub(crate) const LARGEST_FILE: u64 = 16 << 20;

/// The text of a file that a source names, or why there is none.
pub(crate) fn read_text(path: &Path) -> Result<String, String> {
    let name = path.display();
    // A device or a pipe might never end.
    let about = fs::metadata(path).map_err(|error| format!("`{name}` cannot be read: {error}"))?;
    if !about.is_file() || about.len() > LARGEST_FILE {
        return Err(format!("`{name}` is no file of at most 16 MiB"));
    }
    let bytes = fs::read(path).map_err(|error| format!("`{name}` cannot be read: {error}"))?;
    Ok(text_of(bytes))
}

/// The text of the bytes of a file. Old programs write Latin-1, in comments for the most part: bytes
/// that
/// are no UTF-8 are read as that.
pub fn text_of(bytes: Vec<u8>) -> String {
    let text = String::from_utf8(bytes)
        .unwrap_or_else(|error| error.into_bytes().into_iter().map(char::from).collect());
    text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text)
}
