//! Path of the Python with the peers.

use std::path::{Path, PathBuf};

/// `$PYTHON`, otherwise the Python of the environment beside the README, otherwise of the system.
pub(crate) fn python(root: &Path) -> PathBuf {
    let local = root.join(".venv/bin/python");
    match std::env::var_os("PYTHON") {
        Some(python) => python.into(),
        None if local.exists() => local,
        None => "python3".into(),
    }
}
