//! From Rust tokens to files.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

use proc_macro2::TokenStream;

/// The name of the file that includes all others.
pub const INDEX: &str = "kernels.rs";

const HEADER: &str = "// Generated from constraints/ by hardpoint-codegen; changes here are lost.\n\
    // Rewrite with: cargo run -p hardpoint-codegen -- write\n\n";

/// A generated file: name and text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Name without a folder.
    pub name: String,
    /// The whole text.
    pub text: String,
}

/// Formats tokens as a file.
///
/// # Panics
/// Tokens that are not Rust are a mistake of the emitter and panic.
pub fn file(name: &str, tokens: TokenStream) -> File {
    let tree = syn::parse2(tokens).expect("the emitter makes Rust");
    File { name: name.to_owned(), text: format!("{HEADER}{}", prettyplease::unparse(&tree)) }
}

/// Writes files into a folder and removes what else ends in `.rs` there.
///
/// A file that has its text already is not touched, and a new text takes its
/// place only when it is complete, so nothing half-written is left behind.
///
/// # Errors
/// What the system says; the message names the file.
pub fn write(files: &[File], folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    for file in files {
        let path = folder.join(&file.name);
        if fs::read(&path).is_ok_and(|old| old == file.text.as_bytes()) {
            continue;
        }
        let fresh = folder.join(format!(".{}.new", file.name));
        fs::File::create(&fresh)
            .and_then(|mut writer| writer.write_all(file.text.as_bytes()))
            .and_then(|()| fs::rename(&fresh, &path))
            .map_err(|error| {
                io::Error::new(error.kind(), format!("{}: {error}", path.display()))
            })?;
    }
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default();
        let stale = path.extension().is_some_and(|extension| extension == "rs")
            && !files.iter().any(|file| file.name.as_str() == name);
        if stale {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}
