//! Tests of the rules for text in source files, which `CONTRIBUTING.md` states.

mod files;

use std::fs;

/// Columns of a line.
const WIDTH: usize = 120;
/// Words with which no comment opens.
const OPENINGS: [&str; 5] = ["What ", "Whether ", "How ", "That of ", "The same "];

#[test]
fn rust_files_keep_the_rules_for_text() {
    let (mut lines, mut against) = (0, Vec::new());
    for path in files::below("", ".rs") {
        // generated code, and a number of 500 digits
        if ["it/golden/", "ui/expressions/limits.rs"]
            .iter()
            .any(|part| path.to_string_lossy().contains(part))
        {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let mut before = "";
        for (n, line) in text.lines().enumerate() {
            lines += 1;
            let opens = comment(line).filter(|_| comment(before).is_none_or(str::is_empty));
            let place = format!("{}:{}", path.display(), n + 1);
            if line.chars().count() > WIDTH {
                against.push(format!("{place}: more than {WIDTH} columns"));
            }
            if opens.is_some_and(|text| OPENINGS.iter().any(|opening| text.starts_with(opening))) {
                against.push(format!("{place}: {}", line.trim()));
            }
            before = line;
        }
    }
    assert!(lines > 50_000, "only {lines} lines");
    assert!(against.is_empty(), "{}", against.join("\n"));
}

#[test]
fn pages_keep_the_width() {
    let (mut lines, mut against) = (0, Vec::new());
    for path in files::below("", ".md") {
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let mut is_code = false;
        for (n, line) in text.lines().enumerate() {
            lines += 1;
            is_code ^= line.trim_start().starts_with("```");
            // rows of tables and pictures have no line breaks
            let is_one_line = line.starts_with('|') || line.starts_with("![");
            if !is_code && !is_one_line && line.chars().count() > WIDTH {
                against.push(format!("{}:{}: more than {WIDTH} columns", path.display(), n + 1));
            }
        }
    }
    assert!(lines > 5_000, "only {lines} lines");
    assert!(against.is_empty(), "{}", against.join("\n"));
}

/// Text of a line that is a comment.
fn comment(line: &str) -> Option<&str> {
    let text = line.trim_start().strip_prefix("//")?;
    Some(text.trim_start_matches(['/', '!']).trim_start())
}
