//! The Python that has the peers.

use std::path::{Path, PathBuf};

/// `$PYTHON`, or that of the environment beside the README, or the system's.
pub(crate) fn python(root: &Path) -> PathBuf {
    let local = root.join(".venv/bin/python");
    match std::env::var_os("PYTHON") {
        Some(python) => python.into(),
        None if local.exists() => local,
        None => "python3".into(),
    }
}
