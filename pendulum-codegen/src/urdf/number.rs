//! Numbers of a URDF file, as text of the language.

use std::f64::consts::{FRAC_PI_4, PI};

/// Text of the number zero, in whatever form it was written.
pub(super) const ZERO: &str = "0";

/// Minimum magnitude of an angle or a length, in rad or m: smaller values are rounded zeros of an exporter.
const DUST: f64 = 1e-12;

/// Minimum magnitude of a number of the language, except for zero.
const LEAST: f64 = 1e-300;
/// Maximum magnitude of a number of the language.
const MOST: f64 = 1e300;

/// Minimum tolerance, in rad, for rounding an angle to a multiple of 45 degrees, however many digits it has: some files
/// have 1.570796325.
const NEAR: f64 = 1e-8;

/// Minimum number of decimals of a rounded multiple of 45 degrees.
const FEWEST_DECIMALS: i32 = 4;

/// Converts a number, digit for digit. Returns `None` if it is not a number, not finite, or if it underflows.
pub(super) fn number(text: &str) -> Option<String> {
    let value: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
    if value == 0.0 {
        // a nonzero number that underflows has a nonzero digit
        let mut digits = text.chars().take_while(|c| !matches!(c, 'e' | 'E'));
        return digits.all(|c| !matches!(c, '1'..='9')).then(|| ZERO.to_owned());
    }
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => ("-", digits),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    // Rust has no `.5`, and parses `1.e3` as a field or method `e3`
    let (mantissa, exponent) = digits.find(['e', 'E']).map_or((digits, ""), |at| digits.split_at(at));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    let part = |digits: &str| {
        if digits.is_empty() {
            "0".to_owned()
        } else {
            digits.to_owned()
        }
    };
    Some(format!("{sign}{}.{}{exponent}", part(whole), part(fraction)))
}

/// True if a text is a number, of whatever size. `inf` and `nan`, which Rust parses as well, are not numbers.
pub(super) fn is_number(text: &str) -> bool {
    let text = text.trim();
    text.parse::<f64>().is_ok() && text.contains(|c: char| c.is_ascii_digit())
}

/// True if all numbers are zero.
pub(super) fn are_zero(numbers: &[String]) -> bool {
    numbers.iter().all(|number| number == ZERO)
}

/// True if the language has a number of this magnitude.
pub(super) fn is_in_range(text: &str) -> bool {
    let size = text.trim().parse().map_or(f64::NAN, f64::abs);
    (LEAST..=MOST).contains(&size)
}

/// Converts a length or a component of a direction.
pub(super) fn length(text: &str) -> Option<String> {
    let value: f64 = text.parse().ok()?;
    if value.abs() < DUST {
        Some(ZERO.to_owned())
    } else {
        number(text)
    }
}

/// Converts an angle: a rounded or truncated multiple of 45 degrees becomes that multiple of pi. Its sine and cosine
/// are then exact, and terms with zeros drop out.
pub(super) fn angle(text: &str) -> Option<String> {
    let value: f64 = text.parse().ok()?;
    let count = (value / FRAC_PI_4).round();
    if count == 0.0 || (value - count * FRAC_PI_4).abs() > last_decimal(text).max(NEAR) {
        return length(text);
    }
    let sign = if count < 0.0 { "-" } else { "" };
    Some(match count.abs() {
        1.0 => format!("{sign}pi/4"),
        2.0 => format!("{sign}pi/2"),
        4.0 => format!("{sign}pi"),
        quarters => format!("{sign}{quarters}*pi/4"),
    })
}

/// Returns the value of a text from [`number`], [`length`] or [`angle`].
pub(super) fn value(text: &str) -> f64 {
    let Some(at) = text.find("pi") else {
        return text.parse().unwrap_or(f64::NAN);
    };
    let (before, behind) = (text[..at].trim_end_matches('*'), text[at + 2..].trim_start_matches('/'));
    let factor = match before {
        "" => 1.0,
        "-" => -1.0,
        factor => factor.parse().unwrap_or(f64::NAN),
    };
    factor * PI / behind.parse().unwrap_or(1.0)
}

/// Returns one unit in the last decimal of a number, or 0 if it has too few decimals.
fn last_decimal(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let fraction = mantissa.split_once('.').map_or("", |(_, fraction)| fraction);
    let decimals = i32::try_from(fraction.len()).ok();
    let decimals = decimals.and_then(|decimals| decimals.checked_sub(exponent.parse().ok()?));
    match decimals {
        Some(decimals) if decimals >= FEWEST_DECIMALS => 10.0_f64.powi(-decimals),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{angle, is_number, number, value};

    #[test]
    fn numbers_keep_their_digits() {
        let known = [
            ("0.00666", "0.00666"),
            ("-0.0", "0"),
            ("0e7", "0"),
            (".5", "0.5"),
            ("1.", "1.0"),
            ("+2", "2.0"),
            ("-1.5E-07", "-1.5E-07"),
            ("1.e3", "1.0e3"),
            ("5e-324", "5.0e-324"),
        ];
        for (text, ours) in known {
            assert_eq!(number(text).as_deref(), Some(ours), "{text}");
        }
        for text in ["", "nan", "inf", "1e999", "1e-999", "1,5", "${m}", "0x1p3"] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn numbers_may_be_too_large_or_small() {
        for text in ["1e999", " -1e-999 ", "5", ".5"] {
            assert!(is_number(text), "{text}");
        }
        for text in ["", "nan", "-inf", "infinity", "1,5", "0x1p3"] {
            assert!(!is_number(text), "{text}");
        }
    }

    #[test]
    fn rounded_multiples_of_45_degrees_are_exact() {
        let known = [
            ("1.57079632679", "pi/2"),
            ("1.570796325", "pi/2"),
            ("-1.5708", "-pi/2"),
            ("1.57079", "pi/2"),
            ("1.570796e0", "pi/2"),
            ("3.14159", "pi"),
            ("-3.1415926535897931", "-pi"),
            ("-0.785398163397", "-pi/4"),
            ("2.356194490192345", "3*pi/4"),
            ("4.7124", "6*pi/4"),
            // too few decimals, or other digits: another angle
            ("1.571", "1.571"),
            ("1.5703", "1.5703"),
            ("1.57081234", "1.57081234"),
            ("1.57", "1.57"),
            ("2", "2.0"),
            ("0.0001", "0.0001"),
            // rounded zeros
            ("-6.12303176911189e-17", "0"),
            ("0", "0"),
        ];
        for (text, ours) in known {
            assert_eq!(angle(text).as_deref(), Some(ours), "{text}");
            let given: f64 = text.parse().expect("a number");
            assert!((value(ours) - given).abs() < 1e-4, "{text}");
        }
    }
}
