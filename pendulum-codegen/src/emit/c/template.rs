//! Templates of C code.

/// Fills the `@keys@` of a template with values. A key at the end of a line, after only spaces or a comment mark, may
/// have any number of lines; each repeats that start.
pub(in crate::emit) fn fill(template: &str, values: &[(&str, String)]) -> String {
    let filled = template.lines().map(|line| {
        let ends = |(key, value): &'_ (&str, String)| {
            let mark = line.strip_suffix(&format!("@{key}@"))?;
            // a backslash at the end, or its trigraph, would pull the next line into a comment
            let line = |line: &str| {
                let text = format!("{mark}{line}").replace("??/", "?? /");
                text.trim_end_matches(|c: char| c.is_whitespace() || c == '\\')
                    .to_owned()
            };
            let fits = mark.trim_matches([' ', '/']).is_empty();
            fits.then(|| lines(value.lines().map(line)))
        };
        let set = |line: String, (key, value): &(&str, String)| line.replace(&format!("@{key}@"), value);
        let within = || values.iter().fold(format!("{line}\n"), set);
        values.iter().find_map(ends).unwrap_or_else(within)
    });
    filled.collect()
}

/// Terminates each line and concatenates them.
pub(in crate::emit) fn lines(lines: impl IntoIterator<Item = String>) -> String {
    lines.into_iter().map(|line| line + "\n").collect()
}

#[cfg(test)]
mod tests {
    use super::fill;

    #[test]
    fn lines_take_the_marks_of_their_key() {
        let values = [
            ("a", "x \\\ny".to_owned()),
            ("b", "z".to_owned()),
            ("none", String::new()),
        ];
        let text = fill("@a@ @b@\n  /// @a@\n  @none@\nf(@b@);", &values);
        assert_eq!(text, "x \\\ny z\n  /// x\n  /// y\nf(z);\n");
    }
}
