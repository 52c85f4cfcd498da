//! Wrong programs in a real compilation: errors are on the right tokens, and uses of a wrong model add none.
//!
//! `UPDATE_EXPECT=1 cargo test -p tests compile_errors` rewrites the expected messages.

use std::ffi::OsStr;
use std::fs::{self, DirEntry};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, panic};

use expect_test::expect_file;

#[test]
fn are_the_expected_ones() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut cases = files(&folder.join("ui"));
    cases.retain(|path| path.extension() == Some(OsStr::new("rs")));
    // show every difference, not only the first
    let differs = |case: &PathBuf| {
        let messages = messages(folder, case);
        panic::catch_unwind(|| expect_file![case.with_extension("stderr")].assert_eq(&messages)).is_err()
    };
    let count = cases.len();
    cases.retain(differs);
    assert!(cases.is_empty(), "{} of {count} cases differ: {cases:#?}", cases.len());
}

/// The programs of the book, each with an error added to its declarations, compile without further errors.
#[test]
fn of_a_declaration_are_the_only_ones() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let pages = [
        root.join("docs/src"),
        root.join("docs/src/recipes"),
        root.join("pendulum-core/src"),
    ];
    let pages = pages.iter().flat_map(|folder| files(folder));
    let pages = pages.filter(|path| path.extension() == Some(OsStr::new("md")));
    let case = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mistaken.rs");
    let (mut count, mut wrong) = (0, Vec::new());
    for page in pages {
        let text = fs::read_to_string(&page).expect("a page");
        for program in text.split("```rust\n").skip(1) {
            let program = program.split("```").next().unwrap_or_default();
            let Some(program) = mistaken(program) else { continue };
            fs::write(&case, program).expect("a file");
            let messages = compile(&root.join("tests"), &case, &["--error-format=short"]);
            let errors = messages.lines().filter(|line| line.contains(": error"));
            wrong.extend(
                errors
                    .filter(|error| !error.contains("`oops`"))
                    .map(|error| format!("{}: {error}", page.display())),
            );
            count += 1;
        }
    }
    assert!(count > 20, "{count} programs");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Program with an error added to each of its declarations. Returns `None` if it needs other crates or files.
fn mistaken(program: &str) -> Option<String> {
    let others = [
        "plotters",
        "rayon",
        "indicatif",
        "pendulum_draw",
        "pendulum_codegen",
        "src/arm.urdf",
    ];
    if !program.contains("fn main") || others.iter().any(|other| program.contains(other)) {
        return None;
    }
    let mut parts = program.split("mechanism! {");
    let mut mistaken = parts.next()?.to_owned();
    let mut is_changed = false;
    for part in parts {
        let (head, items) = part.split_once('{')?;
        mistaken += &format!("mechanism! {{{head}{{ oops: 1, {items}");
        is_changed = true;
    }
    // lines hidden by the book
    let shown = mistaken
        .lines()
        .map(|line| line.strip_prefix("# ").unwrap_or(line).trim_start_matches("#\n"));
    is_changed.then(|| shown.collect::<Vec<_>>().join("\n"))
}

/// Compiler messages for a program, without the summary.
fn messages(folder: &Path, case: &Path) -> String {
    let case = case.strip_prefix(folder).expect("a case");
    let text = compile(folder, case, &["--diagnostic-width=140"]);
    let is_summary = |part: &&str| {
        ["error: aborting", "Some errors have", "For more information"]
            .iter()
            .any(|start| part.starts_with(start))
    };
    let parts: Vec<&str> = text.trim().split("\n\n").filter(|part| !is_summary(part)).collect();
    parts.join("\n\n").lines().map(without_line_of_core).collect()
}

/// Compiler output for a wrong program that depends on `pendulum-core`.
fn compile(folder: &Path, case: &Path, options: &[&str]) -> String {
    let program = env::current_exe().expect("a program");
    let built = program.parent().expect("the folder of what cargo built");
    let output = Command::new("rustc")
        .args(["--edition=2024", "--crate-type=bin", "--emit=metadata"])
        .args(options)
        .args(["--out-dir", env!("CARGO_TARGET_TMPDIR")])
        .arg("-L")
        .arg(format!("dependency={}", built.display()))
        .arg("--extern")
        .arg(format!(
            "pendulum_core={}",
            newest(built, "libpendulum_core-").display()
        ))
        .arg(case)
        .current_dir(folder)
        .output();
    let output = output.expect("a compiler");
    assert!(!output.status.success(), "{} compiles", case.display());
    String::from_utf8(output.stderr).expect("text")
}

/// Line of a message. A location in the core loses its line number, which unrelated changes may move.
fn without_line_of_core(line: &str) -> String {
    let file = line
        .contains(" pendulum-core/")
        .then(|| line.split_once(".rs:"))
        .flatten();
    match file {
        Some((file, _)) => format!("{file}.rs\n"),
        None => format!("{line}\n"),
    }
}

/// Most recently built library of that name.
fn newest(folder: &Path, name: &str) -> PathBuf {
    let is_library = |path: &PathBuf| {
        let file = path.file_name().and_then(OsStr::to_str).unwrap_or_default();
        file.starts_with(name) && file.ends_with(".rlib")
    };
    let libraries = files(folder).into_iter().filter(is_library);
    let built = |path: &PathBuf| fs::metadata(path).and_then(|data| data.modified()).expect("a time");
    libraries.max_by_key(built).expect("a library that cargo built")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry: Result<DirEntry, _>| entry.expect("a file").path())
        .collect();
    paths.sort();
    paths
}
