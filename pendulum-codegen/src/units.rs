//! Units of measure, as powers of the SI base units that mechanics needs.

use quote::ToTokens;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, Lit, LitFloat, LitInt, Token, token};

use crate::error::at;
use crate::parse::starts_item;
use crate::words::advice;

/// A product of powers of metre, kilogram, second, ampere and kelvin; the radian is 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) struct Dimension {
    /// The powers of m, kg, s, A and K.
    pub powers: [i32; 5],
}

const NAMES: [(&str, [i32; 5]); 11] = [
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
];

/// Other units: the words for one, the unit in its place, and how many of that it is.
const OTHERS: &[(&[&str], &str, &str)] = &[
    (&["deg", "degree", "degrees"], "rad", "pi/180"),
    (&["turn", "turns", "rev", "revolution", "revolutions"], "rad", "2*pi"),
    (&["mrad"], "rad", "0.001"),
    (&["rpm"], "rad/s", "pi/30"),
    (&["mm"], "m", "0.001"),
    (&["cm"], "m", "0.01"),
    (&["dm"], "m", "0.1"),
    (&["km"], "m", "1000"),
    (&["inch", "inches"], "m", "0.0254"),
    (&["ft", "foot", "feet"], "m", "0.3048"),
    (&["g", "gram", "grams"], "kg", "0.001"),
    (&["mg"], "kg", "1e-6"),
    (&["t", "ton", "tonne"], "kg", "1000"),
    (&["lb", "lbs"], "kg", "0.45359237"),
    (&["ms"], "s", "0.001"),
    (&["us"], "s", "1e-6"),
    (&["min", "minute", "minutes"], "s", "60"),
    (&["h", "hour", "hours"], "s", "3600"),
    (&["mN"], "N", "0.001"),
    (&["kN"], "N", "1000"),
    (&["kgf"], "N", "9.80665"),
    (&["lbf"], "N", "4.4482216152605"),
    (&["kPa"], "Pa", "1000"),
    (&["MPa"], "Pa", "1e6"),
    (&["bar"], "Pa", "1e5"),
    (&["mJ"], "J", "0.001"),
    (&["kJ"], "J", "1000"),
    (&["mW"], "W", "0.001"),
    (&["kW"], "W", "1000"),
    (&["kHz"], "Hz", "1000"),
    (&["mA"], "A", "0.001"),
    (&["V", "volt", "volts"], "W/A", "1"),
    (&["ohm", "ohms"], "W/A^2", "1"),
    (&["meter", "meters", "metre", "metres"], "m", "1"),
    (&["kilogram", "kilograms", "kilo", "kgs"], "kg", "1"),
    (&["sec", "secs", "second", "seconds"], "s", "1"),
    (&["radian", "radians", "rads"], "rad", "1"),
    (&["newton", "newtons"], "N", "1"),
    (&["joule", "joules"], "J", "1"),
    (&["watt", "watts"], "W", "1"),
    (&["pascal", "pascals"], "Pa", "1"),
    (&["hertz"], "Hz", "1"),
    (&["ampere", "amperes", "amp", "amps"], "A", "1"),
    (&["kelvin"], "K", "1"),
    (
        &[
            "f64",
            "f32",
            "float",
            "number",
            "real",
            "scalar",
            "none",
            "unitless",
            "dimensionless",
        ],
        "1",
        "1",
    ),
];

fn other(word: &str) -> Option<(&'static str, &'static str)> {
    let any_case = |known: &&str| word.len() > 2 && known.eq_ignore_ascii_case(word);
    let exact = OTHERS.iter().find(|(words, ..)| words.contains(&word));
    let row = exact.or_else(|| OTHERS.iter().find(|(words, ..)| words.iter().any(any_case)));
    row.map(|(_, unit, factor)| (*unit, *factor))
}

/// What to do about a unit after a number, if it is one.
pub(crate) fn of_number(number: &impl std::fmt::Display, word: &str) -> Option<String> {
    if NAMES.iter().any(|(known, _)| *known == word) || written_together(word).is_some() {
        return Some(format!("leave out `{word}`; a product needs a `*`"));
    }
    let (unit, factor) = other(word)?;
    (unit != "1").then(|| match factor {
        "1" => format!("leave out `{word}`: it is in {unit}"),
        _ => format!("write `{number}*{factor}`, in {unit}"),
    })
}

/// What to do about an unknown unit.
fn help(word: &str) -> String {
    match (other(word), written_together(word)) {
        (Some(("1", _)), _) => "write `1` for a plain number".to_owned(),
        (Some((unit, "1")), _) => format!("write `{unit}`"),
        (Some((unit, factor)), _) => {
            format!("write `{unit}`, and numbers in that unit: 1 {word} is `{factor}` {unit}")
        }
        (None, Some(apart)) => format!("write `{apart}`, with the names apart"),
        (None, None) => advice(word, NAMES.map(|(known, _)| known), &[]).help,
    }
}

/// Names of units written as one word, such as `Nms` or `kgm2`, apart.
fn written_together(word: &str) -> Option<String> {
    if word.is_empty() {
        return Some(String::new());
    }
    // a shorter name where a longer one leaves a rest that is none: `kgm` is `kg m`
    let mut names = NAMES.map(|(name, _)| name);
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    names.into_iter().find_map(|name| {
        let rest = word.strip_prefix(name)?;
        let (power, rest) = match rest.chars().next().filter(char::is_ascii_digit) {
            Some(digit) => (format!("^{digit}"), &rest[1..]),
            None => (String::new(), rest),
        };
        let rest = written_together(rest)?;
        let gap = if rest.is_empty() { "" } else { " " };
        Some(format!("{name}{power}{gap}{rest}"))
    })
}

/// A unit as it is written, and what it means.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unit {
    /// The text, as it goes into the documentation of the field.
    pub text: String,
    /// Its dimension.
    pub dimension: Dimension,
}

impl Parse for Unit {
    /// `kg m^2`, `N*m*s`, `m/s^2`, `1`: names with integer powers, side by side or multiplied; a `/` takes the next
    /// name only.
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let mut unit = Self {
            text: String::new(),
            dimension: Dimension::default(),
        };
        loop {
            let sign = if input.peek(Token![/]) {
                input.parse::<Token![/]>()?;
                unit.text.push('/');
                -1
            } else if input.peek(Token![*]) {
                input.parse::<Token![*]>()?;
                unit.text.push(' ');
                1
            } else {
                if !unit.text.is_empty() {
                    unit.text.push(' ');
                }
                1
            };
            unit.factor(input, sign)?;
            // what begins something else stands after a comma that is missing
            let name = input.peek(Ident) && !starts_item(input);
            let more = input.peek(Token![/]) || input.peek(Token![*]) || name || input.peek(LitInt);
            if !more {
                return Ok(unit);
            }
        }
    }
}

impl Unit {
    fn factor(&mut self, input: ParseStream, sign: i32) -> syn::Result<()> {
        if input.peek(LitInt) || input.peek(LitFloat) {
            let one: Lit = input.parse()?;
            if one.to_token_stream().to_string() != "1" {
                let fact = "expected a unit, not a value";
                let value = one.to_token_stream().to_string().replace(' ', "");
                let help = format!("write the unit first, such as `kg = {value}`, or `1 = {value}` for a plain number");
                return Err(at(one.span(), fact, help));
            }
            self.text.push('1');
            return Ok(());
        }
        if input.peek(token::Paren) {
            let help = "a `/` takes the next name only: `N/(m s)` is `N/m/s`";
            return Err(at(input.span(), "a unit has no parentheses", help));
        }
        let Ok(name) = input.parse::<Ident>() else {
            let help = "write an SI unit such as `kg m^2`, `N m s`, `m/s^2`, or `1` for a plain number";
            return Err(at(input.span(), "expected a unit", help));
        };
        let text = name.to_string();
        let Some((_, base)) = NAMES.iter().find(|(known, _)| *known == text) else {
            return Err(at(name.span(), format_args!("unknown unit `{text}`"), help(&text)));
        };
        self.text.push_str(&text);
        let mut power = 1;
        if input.peek(Token![^]) {
            input.parse::<Token![^]>()?;
            let negative = input.parse::<Option<Token![-]>>()?.is_some();
            let span = input.span();
            let exponent = input.parse::<LitInt>().ok().and_then(|n| n.base10_parse::<i32>().ok());
            power = exponent.filter(|n| (1..=9).contains(n)).ok_or_else(|| {
                let fact = "the power of a unit is not a whole number from 1 to 9";
                at(span, fact, "write such as `m^2` or `s^-1`")
            })?;
            power = if negative { -power } else { power };
            self.text.push_str(&format!("^{power}"));
        }
        for (sum, of_base) in self.dimension.powers.iter_mut().zip(base) {
            *sum += sign * power * of_base;
        }
        Ok(())
    }
}
