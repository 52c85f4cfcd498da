//! C code in single precision, made from that in double precision.

use super::block::Calls;
use super::functions::{functions, is_function};

/// Limit of the angles whose sine and cosine are computed without the platform, in double and in single precision.
const ANGLES: [&str; 2] = ["1e5", "6400"];

/// Code for `double` as code for `float`: its types, its literals, the limits of its numbers, and the names of called
/// functions, which end in `f` or `F`. Comments stay as they are.
pub(super) fn single(code: &str) -> String {
    let line = |line: &str| {
        let (code, comment) = line.split_at(line.find("//").unwrap_or(line.len()));
        let mut text: String = words(code).map(of_word).collect();
        let defined = code.strip_prefix("#define ").and_then(|rest| rest.split(' ').next());
        // the function of the platform
        if defined.is_some_and(is_function) {
            text.push('f');
        }
        text + comment + "\n"
    };
    code.lines().map(line).collect()
}

/// Heads and code of the called functions, in single precision.
pub(super) fn single_functions(calls: &Calls) -> impl Iterator<Item = (String, String)> {
    functions(calls).map(|(head, code)| {
        let head = match head.split_once(": ") {
            None => format!("{head}f"),
            Some((name, platform)) => {
                let (function, rest) = platform.split_once(',').unwrap_or((platform, ""));
                let rest = rest.replace(ANGLES[0], ANGLES[1]);
                let comma = if rest.is_empty() { "" } else { "," };
                format!("{name}F: {function}f{comma}{rest}")
            }
        };
        // sines differ in more than the type
        let own = functions(&Calls::from([head.clone()])).next();
        let code = own.map_or_else(|| single(code), |(_, code)| code.to_owned());
        (head, code)
    })
}

/// Splits code into names, numbers, and single characters between them.
fn words(code: &str) -> impl Iterator<Item = &str> {
    let mut rest = code;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let is_number = first.is_ascii_digit();
        let goes_on = |at: usize, letter: char| {
            let is_exponent = is_number && rest[..at].ends_with('e');
            letter.is_ascii_alphanumeric()
                || letter == '_'
                || is_number && letter == '.'
                || is_exponent && letter == '-'
        };
        let end = rest.char_indices().find(|(at, letter)| !goes_on(*at, *letter));
        let length = end.map_or(rest.len(), |(at, _)| at.max(first.len_utf8()));
        let (word, after) = rest.split_at(length);
        rest = after;
        Some(word)
    })
}

fn of_word(word: &str) -> String {
    if let Some(limit) = word.strip_prefix("DBL_") {
        return format!("FLT_{limit}");
    }
    if word.starts_with(|letter: char| letter.is_ascii_digit()) && word.contains(['.', 'e']) {
        return word.parse().map_or_else(|_| word.to_owned(), literal);
    }
    match word {
        "double" => "float".to_owned(),
        "HUGE_VAL" => "HUGE_VALF".to_owned(),
        _ if !is_function(word) => word.to_owned(),
        _ if word.starts_with("PENDULUM") => format!("{word}F"),
        _ => format!("{word}f"),
    }
}

/// Literal of a number as Rust converts it, which rounds twice.
fn literal(number: f64) -> String {
    match number as f32 {
        f32::INFINITY => "HUGE_VALF".to_owned(),
        number => format!("{number:?}f"),
    }
}

#[cfg(test)]
mod tests {
    use super::single;

    #[test]
    fn only_code_becomes_single() {
        let code = "double a1 = 1e-7 * x[10] + 0.1 - 1e39; // a double of 0.1\n#define PENDULUM_SQRT sqrt\n\
                    #define PENDULUM_STATES 2\n\
                    if (a > DBL_MAX) return Pendulum_abs(pendulum_rhs) + PENDULUM_SQRT(2.0);\n";
        let expected = "float a1 = 1e-7f * x[10] + 0.1f - HUGE_VALF; // a double of 0.1\n#define PENDULUM_SQRTF sqrtf\n\
                        #define PENDULUM_STATES 2\n\
                        if (a > FLT_MAX) return Pendulum_absf(pendulum_rhs) + PENDULUM_SQRTF(2.0f);\n";
        assert_eq!(single(code), expected);
    }
}
