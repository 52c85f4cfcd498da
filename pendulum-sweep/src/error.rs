//! Errors of a sweep as a whole.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::PathBuf;

use pendulum_core::Reason;

/// Error that stops a sweep or keeps it from starting. A failed trajectory is no error, but a row with a reason.
///
/// `Debug` prints the same message as `Display`, for a `main` that returns the error.
#[non_exhaustive]
pub enum SweepError {
    /// The design, the columns, the settings of the method or the arguments are invalid.
    Invalid(String),
    /// A file could not be read or written.
    File(PathBuf, io::Error),
    /// The path holds results of another sweep.
    Other {
        /// The path.
        path: PathBuf,
        /// Differences between the declarations.
        differs: Vec<String>,
    },
    /// Another process is working on this file.
    Busy(PathBuf),
    /// A device cannot be used, or not for this scene.
    #[cfg(feature = "opencl")]
    Device(String),
    /// Shards that belong to other shares are missing.
    Incomplete {
        /// Number of shards present.
        present: usize,
        /// Total number of shards.
        of: usize,
        /// Index of the first missing shard.
        missing: usize,
    },
}

impl SweepError {
    pub(crate) fn file(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |error| Self::File(path, error)
    }
}

impl From<Reason> for SweepError {
    fn from(reason: Reason) -> Self {
        Self::Invalid(reason.to_string())
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid(reason) => f.write_str(reason),
            #[cfg(feature = "opencl")]
            Self::Device(reason) => f.write_str(reason),
            Self::File(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Busy(path) => write!(
                f,
                "another process is working on {}; wait for it, give this sweep another name, or let both compute \
                 shares",
                path.display()
            ),
            Self::Other { path, differs } => write!(
                f,
                "{} holds another sweep; remove it, or give this one another name. It has\n  {}",
                path.display(),
                differs.join("\n  ")
            ),
            Self::Incomplete { present, of, missing } => write!(
                f,
                "{present} of {of} shards are there; shard {missing} is the first that is missing: run the remaining \
                 shares, or run without `--shard`"
            ),
        }
    }
}

impl fmt::Debug for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Error for SweepError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::File(_, error) => Some(error),
            _ => None,
        }
    }
}
