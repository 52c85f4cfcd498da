//! Names that are valid in C.

use std::collections::BTreeSet;

use heck::ToSnakeCase;

/// Keywords of C and C++, macros defined by compilers and headers, and the headers of C.
const WORDS: &str = include_str!("templates/words.txt");

/// Identifiers for names, all distinct and none reserved.
pub(super) fn identifiers<'a>(names: impl IntoIterator<Item = &'a String>) -> Vec<String> {
    let mut taken: BTreeSet<String> = WORDS.split_whitespace().map(String::from).collect();
    let identifier = |name: &String| {
        let mut identifier = ascii(name);
        while !taken.insert(identifier.clone()) {
            identifier.push('_');
        }
        identifier
    };
    names.into_iter().map(identifier).collect()
}

/// Functions and types of a header, after its prefix, that no routine has.
const OWN: [&str; 19] = [
    "defaults",
    "error",
    "ilqr",
    "ilqr_command",
    "ilqr_pass",
    "ilqr_plan",
    "ilqr_sample",
    "ilqr_shift",
    "ilqr_start",
    "inputs",
    "linear_law",
    "model",
    "new",
    "params",
    "project",
    "rk4_step",
    "rounds_once",
    "series",
    "work",
];

/// Name of the function of a routine, after the prefix: that in Rust, with an underscore if the header has another
/// function or type of this name.
pub(in crate::emit) fn function(routine: &str) -> String {
    match routine {
        // in Rust, `jacobian` returns the matrix alone
        "jacobian" => "rhs_and_jacobian".to_owned(),
        name => {
            let name = ascii(name);
            // also after underscores, so that names stay distinct
            let is_taken = OWN.contains(&name.trim_end_matches('_'));
            name + if is_taken { "_" } else { "" }
        }
    }
}

/// Prefix of functions and files for the name of a type: `DoublePendulum` as `double_pendulum`. No file takes the name
/// of a standard header.
pub(super) fn snake_case(name: &str) -> String {
    let text = ascii(name).to_snake_case();
    let is_header = WORDS
        .split_whitespace()
        .any(|word| word.strip_suffix(".h") == Some(&text));
    text + if is_header { "_" } else { "" }
}

/// Names and numbers of an expression, joined by underscores.
pub(super) fn words(expression: &str) -> String {
    let text = ascii(expression);
    let words = text
        .split(|letter: char| !letter.is_ascii_alphanumeric())
        .filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_")
}

/// ASCII spelling of a Rust name, with other letters as numbers: `θ` as `u03b8`.
fn ascii(name: &str) -> String {
    let spelled = |letter: char| match u32::from(letter) {
        0..128 => letter.to_string(),
        number => format!("u{number:04x}"),
    };
    name.trim_start_matches("r#")
        .replace('.', "_")
        .chars()
        .map(spelled)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{OWN, function, identifiers, snake_case};
    use crate::program::is_function;

    /// Templates of what a header declares.
    const HEADERS: [&str; 8] = [
        include_str!("templates/controller.h"),
        include_str!("templates/defaults.h"),
        include_str!("templates/fused.h"),
        include_str!("templates/header.h"),
        include_str!("templates/ilqr.h"),
        include_str!("templates/inputs.h"),
        include_str!("templates/linear.h"),
        include_str!("templates/series.h"),
    ];

    #[test]
    fn names_are_words_of_no_language() {
        let names = [
            "x", "double", "r#in", "r#for", "θ", "u03b8", "double_", "DBL_MAX", "_Bool", "time",
        ];
        let expected = [
            "x", "double_", "in", "for_", "u03b8", "u03b8_", "double__", "DBL_MAX_", "_Bool_", "time",
        ];
        assert_eq!(identifiers(&names.map(str::to_owned)), expected);
    }

    #[test]
    fn routines_take_no_name_of_the_header() {
        let names = ["height", "error", "error_", "r#in", "jacobian", "θ"];
        let expected = ["height", "error_", "error__", "in", "rhs_and_jacobian", "u03b8"];
        assert_eq!(names.map(function), expected);
        let declared = HEADERS.iter().flat_map(|header| header.split("@name@_").skip(1));
        for text in declared {
            let end = text.find(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_'));
            let name = text.split_at(end.unwrap_or(text.len())).0;
            assert!(OWN.contains(&name) || is_function(name, false), "{name}");
        }
    }

    #[test]
    fn types_become_prefixes() {
        let names = [
            "DoublePendulum",
            "Ur5",
            "UR5Arm",
            "HTTPServer",
            "Eq22Joint",
            "Snake_Case",
            "A",
            "Math",
        ];
        let expected = [
            "double_pendulum",
            "ur5",
            "ur5_arm",
            "http_server",
            "eq22_joint",
            "snake_case",
            "a",
            "math_",
        ];
        assert_eq!(names.map(snake_case), expected);
    }
}
