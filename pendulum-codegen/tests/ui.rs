//! Wrong declarations, one file for each mistake, in folders by kind, and the messages of the generator.
//!
//! `UPDATE_EXPECT=1 cargo test -p pendulum-codegen --test ui` rewrites the expected messages. Mistakes that only a
//! compiler reports, such as a wrong use of a model, are in `tests/ui` of the workspace.

use std::fmt::Write;
use std::fs;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

use expect_test::expect_file;
use pendulum_codegen::Code;

use declarations::declarations;

#[path = "common/declarations.rs"]
mod declarations;

#[test]
fn wrong_declarations_are_explained() {
    let files = files();
    let (cases, expected): (Vec<_>, Vec<_>) = files
        .iter()
        .partition(|path| path.extension().is_some_and(|e| e == "rs"));
    let left: Vec<_> = expected
        .iter()
        .filter(|path| !path.with_extension("rs").exists())
        .collect();
    assert!(left.is_empty(), "expected messages without a case: {left:?}");
    // show every difference, not only the first
    let differs = |case: &PathBuf| {
        catch_unwind(|| expect_file![case.with_extension("stderr")].assert_eq(&messages(case))).is_err()
    };
    let wrong: Vec<_> = cases.into_iter().filter(|case| differs(case)).collect();
    assert!(wrong.is_empty(), "{} cases differ: {wrong:#?}", wrong.len());
}

#[test]
fn each_code_has_a_case() {
    let expected = files()
        .into_iter()
        .filter(|path| path.extension().is_some_and(|e| e == "stderr"));
    let all: String = expected
        .map(|path| fs::read_to_string(path).expect("messages"))
        .collect();
    let without: Vec<&str> = Code::ALL
        .iter()
        .map(|code| code.text())
        .filter(|code| !all.contains(&format!(" [{code}]\n")))
        .collect();
    assert!(without.is_empty(), "no case has the codes {without:?}");
}

/// Returns the cases and their expected messages.
fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
    let kinds = paths(&folder);
    assert!(kinds.iter().all(|kind| kind.is_dir()), "cases stand in folders by kind");
    kinds.iter().flat_map(|kind| paths(kind)).collect()
}

/// Returns the entries of a folder, in order.
fn paths(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    paths
}

/// Returns all errors of a file, as the compiler prints them.
fn messages(case: &Path) -> String {
    let source = fs::read_to_string(case).expect("a case");
    let name = case.file_name().and_then(|name| name.to_str()).expect("a name");
    let mut text = String::new();
    for declaration in declarations(source.parse().expect("tokens")) {
        let Err(errors) = pendulum_codegen::program(declaration) else {
            panic!("{name} has a declaration without a mistake");
        };
        for error in errors.iter() {
            let gap = if text.is_empty() { "" } else { "\n" };
            write!(text, "{gap}{}", message(error, name, &source)).expect("memory");
        }
    }
    text
}

/// Formats an error with its line, and marks under the tokens at fault.
fn message(error: &syn::Error, file: &str, source: &str) -> String {
    let (start, end) = (error.span().start(), error.span().end());
    let line = source.lines().nth(start.line - 1).unwrap_or_default();
    // of an error over several lines, only the first is shown
    let last = if end.line == start.line {
        end.column
    } else {
        line.chars().count()
    };
    let (margin, marks) = (
        " ".repeat(start.line.to_string().len()),
        "^".repeat((last - start.column).max(1)),
    );
    let error = error.to_string().replace('\n', "\n       ");
    format!(
        "error: {error}\n{margin}--> {file}:{row}:{column}\n{margin} |\n{row} | {line}\n{margin} | {indent}{marks}\n",
        row = start.line,
        column = start.column + 1,
        indent = " ".repeat(start.column),
    )
}
