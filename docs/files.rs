//! The files of the repository.

use std::fs;
use std::path::{Path, PathBuf};

/// All files below a folder of the repository whose names have this ending, except build outputs and packages.
pub(crate) fn below(folder: &str, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    collect(&root.join(folder), ending, &mut found);
    found
}

fn collect(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
    {
        let name = entry.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if entry.is_dir() && !name.starts_with('.') && !["target", "out", "node_modules"].contains(&name) {
            collect(&entry, ending, found);
        } else if name.ends_with(ending) {
            found.push(entry);
        }
    }
}
