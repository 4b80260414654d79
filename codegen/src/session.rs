//! The one door to symbolica.
//!
//! Without a licence key symbolica allows one thread for each user and aborts a
//! process that would start a second one: another build, an editor, or two
//! tests of one binary. So every use goes through [`run`], which holds an
//! exclusive lock on one file for each user while the whole job runs in one
//! thread of its own.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::thread;

use thiserror::Error;

/// Why no session with symbolica could be had.
#[derive(Debug, Error)]
pub enum SessionError {
    /// The lock file cannot be made or locked.
    #[error(
        "symbolica may run once for each user, and the lock that sees to it cannot be taken: \
         {path}: {source}; make that folder writable, or build with `--no-default-features` \
         to use the committed kernels, which need no symbolica"
    )]
    Lock {
        /// The lock file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The user has no cache directory.
    #[error(
        "symbolica may run once for each user, and there is no cache directory for the lock \
         that sees to it; set HOME, or build with `--no-default-features` to use the committed \
         kernels, which need no symbolica"
    )]
    NoCacheDirectory,
    /// The thread of the job could not be started.
    #[error("the thread for the computer algebra cannot be started: {0}")]
    Thread(io::Error),
}

/// Runs `job` with symbolica to itself and returns its result.
///
/// Waits until no other process of this user holds the lock.
///
/// # Errors
/// [`SessionError`] where the lock cannot be taken.
///
/// # Panics
/// A panic of `job` continues in the caller, after the lock is released.
pub fn run<T: Send + 'static>(job: impl FnOnce() -> T + Send + 'static) -> Result<T, SessionError> {
    let directory = dirs::cache_dir().ok_or(SessionError::NoCacheDirectory)?.join("hardpoint");
    let _lock = lock(&directory)?;
    // The default stack is too small for the recursion over large expressions
    // in a build that is not optimised.
    let thread = thread::Builder::new()
        .name("symbolica".to_owned())
        .stack_size(64 << 20)
        .spawn(job)
        .map_err(SessionError::Thread)?;
    // Only a joined thread has given its place back; a scope would not wait for that.
    thread.join().or_else(|panic| std::panic::resume_unwind(panic))
}

fn lock(directory: &Path) -> Result<File, SessionError> {
    let path = directory.join("symbolica.lock");
    let locked = fs::create_dir_all(directory)
        .and_then(|()| OpenOptions::new().create(true).truncate(false).write(true).open(&path))
        .and_then(|file| file.lock().map(|()| file));
    locked.map_err(|source| SessionError::Lock { path, source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_directory_that_cannot_be_made_is_named_with_the_way_out() {
        let directory = std::env::temp_dir().join(format!("hardpoint-{}", std::process::id()));
        fs::write(&directory, "a file where a folder is wanted").unwrap();
        let error = lock(&directory).unwrap_err();
        fs::remove_file(&directory).unwrap();
        let message = error.to_string();
        assert!(message.contains("symbolica.lock"), "{message}");
        assert!(message.contains("--no-default-features"), "{message}");
    }
}
