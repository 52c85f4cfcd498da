//! What can go wrong with a sweep as a whole.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::PathBuf;

use pendulum_core::Reason;

/// Why a sweep did not run, or did not reach its end. A trajectory that fails is a row with a reason, and no error.
///
/// `Debug` prints the same message as `Display`, for a `main` that returns the error.
#[non_exhaustive]
pub enum SweepError {
    /// The design, the columns, the settings of the method or the arguments are not valid.
    Invalid(String),
    /// A file could not be read or written.
    File(PathBuf, io::Error),
    /// There are results of another sweep at this place.
    Other {
        /// Where.
        path: PathBuf,
        /// Where the declarations differ, and how.
        differs: Vec<String>,
    },
    /// Another process is at work on this file.
    Busy(PathBuf),
    /// A device could not be used, or not for this.
    #[cfg(feature = "opencl")]
    Device(String),
    /// Shards are missing, which other shares have to compute.
    Incomplete {
        /// How many there are.
        present: usize,
        /// Of how many.
        of: usize,
        /// The first one that is missing.
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
                "another process is at work on {}; wait for it, give this sweep another name, or let both compute shares",
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
