//! Tables and files.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// A table in Markdown; all columns but the first `words` ones are aligned to the right.
pub(crate) fn table(head: &[&str], words: usize, rows: &[Vec<String>]) -> String {
    let line = |cells: Vec<&str>| format!("| {} |\n", cells.join(" | "));
    let rule = (0..head.len())
        .map(|n| if n < words { "---" } else { "---:" })
        .collect();
    let mut text = line(head.to_vec()) + &line(rule);
    for row in rows {
        text += &line(row.iter().map(String::as_str).collect());
    }
    text
}

pub(crate) fn list(lines: &[String]) -> String {
    lines.iter().map(|line| format!("- {line}\n")).collect()
}

/// Formats three significant digits; empty if not measured.
pub(crate) fn number(value: Option<f64>) -> String {
    match value {
        None => String::new(),
        Some(value) if value >= 100.0 => format!("{value:.0}"),
        Some(value) if value >= 10.0 => format!("{value:.1}"),
        Some(value) => format!("{value:.2}"),
    }
}

pub(crate) fn count(value: Option<usize>) -> String {
    value.map_or(String::new(), |value| value.to_string())
}

pub(crate) fn write(path: PathBuf, text: &str) -> Result<PathBuf, Box<dyn Error>> {
    fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
    fs::write(&path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    Ok(path)
}
