//! Names of units: of the language, and others that may follow numbers.

use super::{Dimension, Scale, Unit};
use crate::words::advice;

/// Units of the language, with their powers of m, kg, s, A and K.
const NAMES: [(&str, [i32; 5]); 15] = [
    ("m", [1, 0, 0, 0, 0]),
    ("kg", [0, 1, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0]),
    ("A", [0, 0, 0, 1, 0]),
    ("K", [0, 0, 0, 0, 1]),
    ("rad", [0; 5]),
    ("N", [1, 1, -2, 0, 0]),
    ("J", [2, 1, -2, 0, 0]),
    ("W", [2, 1, -3, 0, 0]),
    ("Pa", [-1, 1, -2, 0, 0]),
    ("Hz", [0, 0, -1, 0, 0]),
    ("V", [2, 1, -3, -1, 0]),
    ("ohm", [2, 1, -3, -2, 0]),
    ("H", [2, 1, -2, -2, 0]),
    ("F", [-2, -1, 4, 2, 0]),
];

/// Other units: their names, the unit of the language in their place, and the factor to it, as numerator, denominator
/// and power of pi.
const OTHERS: &[(&[&str], &str, [i64; 3])] = &[
    (&["deg", "degree", "degrees"], "rad", [1, 180, 1]),
    (&["turn", "turns", "rev", "revolution", "revolutions"], "rad", [2, 1, 1]),
    (&["mrad"], "rad", [1, 1000, 0]),
    (&["rpm"], "rad/s", [1, 30, 1]),
    (&["mm"], "m", [1, 1000, 0]),
    (&["cm"], "m", [1, 100, 0]),
    (&["dm"], "m", [1, 10, 0]),
    (&["km"], "m", [1000, 1, 0]),
    (&["inch", "inches"], "m", [254, 10_000, 0]),
    (&["ft", "foot", "feet"], "m", [3048, 10_000, 0]),
    (&["g", "gram", "grams"], "kg", [1, 1000, 0]),
    (&["mg"], "kg", [1, 1_000_000, 0]),
    (&["ton", "tonne"], "kg", [1000, 1, 0]),
    (&["lb", "lbs"], "kg", [45_359_237, 100_000_000, 0]),
    (&["ms"], "s", [1, 1000, 0]),
    (&["us"], "s", [1, 1_000_000, 0]),
    (&["min", "minute", "minutes"], "s", [60, 1, 0]),
    (&["h", "hour", "hours"], "s", [3600, 1, 0]),
    (&["mN"], "N", [1, 1000, 0]),
    (&["kN"], "N", [1000, 1, 0]),
    (&["kgf"], "N", [980_665, 100_000, 0]),
    (&["lbf"], "N", [44_482_216_152_605, 10_000_000_000_000, 0]),
    (&["kPa"], "Pa", [1000, 1, 0]),
    (&["MPa"], "Pa", [1_000_000, 1, 0]),
    (&["bar"], "Pa", [100_000, 1, 0]),
    (&["mJ"], "J", [1, 1000, 0]),
    (&["kJ"], "J", [1000, 1, 0]),
    (&["mW"], "W", [1, 1000, 0]),
    (&["kW"], "W", [1000, 1, 0]),
    (&["kHz"], "Hz", [1000, 1, 0]),
    (&["mA"], "A", [1, 1000, 0]),
    (&["volt", "volts"], "V", [1, 1, 0]),
    (&["ohms"], "ohm", [1, 1, 0]),
    (&["mH"], "H", [1, 1000, 0]),
    (&["uF"], "F", [1, 1_000_000, 0]),
    (&["henry", "henrys", "henries"], "H", [1, 1, 0]),
    (&["farad", "farads"], "F", [1, 1, 0]),
    (&["meter", "meters", "metre", "metres"], "m", [1, 1, 0]),
    (&["kilogram", "kilograms", "kilo", "kgs"], "kg", [1, 1, 0]),
    (&["sec", "secs", "second", "seconds"], "s", [1, 1, 0]),
    (&["radian", "radians", "rads"], "rad", [1, 1, 0]),
    (&["newton", "newtons"], "N", [1, 1, 0]),
    (&["joule", "joules"], "J", [1, 1, 0]),
    (&["watt", "watts"], "W", [1, 1, 0]),
    (&["pascal", "pascals"], "Pa", [1, 1, 0]),
    (&["hertz"], "Hz", [1, 1, 0]),
    (&["ampere", "amperes", "amp", "amps"], "A", [1, 1, 0]),
    (&["kelvin"], "K", [1, 1, 0]),
];

/// Words that people write for the unit of a plain number.
const PLAIN: [&str; 9] = [
    "f64",
    "f32",
    "float",
    "number",
    "real",
    "scalar",
    "none",
    "unitless",
    "dimensionless",
];

/// Returns the dimension of a unit of the language.
pub(super) fn dimension(name: &str) -> Option<Dimension> {
    let row = NAMES.iter().find(|(known, _)| *known == name);
    row.map(|(_, powers)| Dimension::new(*powers))
}

/// Returns the unit of the language in place of another unit, and the factor to it.
pub(super) fn other(word: &str) -> Option<(&'static str, Scale)> {
    let row = OTHERS.iter().find(|(words, ..)| words.contains(&word));
    row.map(|(_, unit, scale)| (*unit, Scale::new(*scale)))
}

/// Returns the dimension and the scale of any unit, of the language or other.
pub(super) fn meaning(name: &str) -> Option<(Dimension, Scale)> {
    if let Some(dimension) = dimension(name) {
        return Some((dimension, Scale::new([1, 1, 0])));
    }
    let (unit, scale) = other(name)?;
    Some((Unit::of(unit)?.dimension, scale))
}

/// Returns the help text for an unknown unit of a declared quantity.
pub(super) fn help(word: &str) -> String {
    let any_case = |known: &str| word.len() > 2 && known.eq_ignore_ascii_case(word);
    if PLAIN.into_iter().any(|plain| plain == word || any_case(plain)) {
        return "write `1` for a plain number".to_owned();
    }
    let similar = || {
        OTHERS
            .iter()
            .flat_map(|(words, ..)| *words)
            .find(|known| any_case(known))
    };
    if let Some((unit, scale)) = other(word).or_else(|| other(similar()?)) {
        return if scale.is_one() {
            format!("write `{unit}`")
        } else {
            format!("declare `{unit}`; its values may be in {word}, as in `{unit} = 3 {word}`")
        };
    }
    match written_together(word, &NAMES.map(|(name, _)| name)) {
        Some(apart) => format!("write `{apart}`, with spaces between the units"),
        None => advice(word, NAMES.map(|(known, _)| known), &[]).help,
    }
}

/// Separates names of units that are written as one word, such as `Nms` or `kgm2`.
fn written_together(word: &str, known: &[&str]) -> Option<String> {
    if word.is_empty() {
        return Some(String::new());
    }
    // longest first; a shorter name where the rest after a longer one is no unit: `kgm` is `kg m`
    let mut names = known.to_vec();
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    names.into_iter().find_map(|name| {
        let rest = word.strip_prefix(name)?;
        let (power, rest) = match rest.chars().next().filter(char::is_ascii_digit) {
            Some(digit) => (format!("^{digit}"), &rest[1..]),
            None => (String::new(), rest),
        };
        let rest = written_together(rest, known)?;
        let gap = if rest.is_empty() { "" } else { " " };
        Some(format!("{name}{power}{gap}{rest}"))
    })
}

/// Returns the unit that is meant by a word after a number: its case may differ, and spaces and `^` may be missing.
pub(super) fn meant(word: &str) -> Option<String> {
    let names = NAMES.iter().map(|(name, _)| *name);
    let others = OTHERS.iter().flat_map(|(words, ..)| *words).copied();
    let known: Vec<&str> = names.clone().chain(others.clone()).collect();
    if known.contains(&word) {
        return Some(word.to_owned());
    }
    // case matters in names of two letters: `MW` and `mW` are both units
    let mut in_any_case = names.chain(others.filter(|word| word.len() > 2));
    let in_case = in_any_case.find(|known| known.eq_ignore_ascii_case(word));
    in_case.map(str::to_owned).or_else(|| written_together(word, &known))
}
