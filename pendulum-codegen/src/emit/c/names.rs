//! Names that C can take.

use std::collections::BTreeSet;

/// Names as identifiers, no two the same, and none a word of C or C++, or a macro that compilers define.
pub(super) fn identifiers<'a>(names: impl IntoIterator<Item = &'a String>) -> Vec<String> {
    let words = include_str!("templates/words.txt").split_whitespace();
    let mut taken: BTreeSet<String> = words.map(String::from).collect();
    let identifier = |name: &String| {
        let mut identifier = ascii(name);
        // macros of <float.h>
        if ["DBL_", "FLT_", "LDBL_", "DECIMAL_"]
            .iter()
            .any(|prefix| identifier.starts_with(prefix))
        {
            identifier.push('_');
        }
        while !taken.insert(identifier.clone()) {
            identifier.push('_');
        }
        identifier
    };
    names.into_iter().map(identifier).collect()
}

/// The name of a type as the start of names of functions and files: `DoublePendulum` as `double_pendulum`. No file takes the place of
/// a header of the standard library.
pub(super) fn snake_case(name: &str) -> String {
    const HEADERS: [&str; 14] = [
        "assert", "complex", "ctype", "errno", "float", "limits", "locale", "math", "signal", "stddef", "stdint",
        "stdio", "string", "time",
    ];
    let letters: Vec<char> = ascii(name).chars().collect();
    let mut text = String::new();
    for (n, letter) in letters.iter().enumerate() {
        let before = n.checked_sub(1).map_or('_', |n| letters[n]);
        let ends_capitals = letters.get(n + 1).is_some_and(char::is_ascii_lowercase);
        if letter.is_ascii_uppercase() && before != '_' && (!before.is_ascii_uppercase() || ends_capitals) {
            text.push('_');
        }
        text.push(letter.to_ascii_lowercase());
    }
    if HEADERS.contains(&text.as_str()) {
        text.push('_');
    }
    text
}

/// A name of Rust with its letters beyond ASCII as numbers: `θ` as `u03b8`.
fn ascii(name: &str) -> String {
    let spelled = |letter: char| match u32::from(letter) {
        0..128 => letter.to_string(),
        number => format!("u{number:04x}"),
    };
    name.trim_start_matches("r#").chars().map(spelled).collect()
}

#[cfg(test)]
mod tests {
    use super::{identifiers, snake_case};

    #[test]
    fn names_are_words_of_no_language() {
        let names = ["x", "double", "r#in", "r#for", "θ", "u03b8", "double_"];
        let expected = ["x", "double_", "in", "for_", "u03b8", "u03b8_", "double__"];
        assert_eq!(identifiers(&names.map(str::to_owned)), expected);
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
        ];
        let expected = [
            "double_pendulum",
            "ur5",
            "ur5_arm",
            "http_server",
            "eq22_joint",
            "snake_case",
            "a",
        ];
        assert_eq!(names.map(snake_case), expected);
    }
}
