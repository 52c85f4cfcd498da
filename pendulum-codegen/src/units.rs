//! Units of measure, as powers of the SI base units that mechanics needs.

use syn::parse::{Parse, ParseStream};
use syn::{Ident, LitInt, Token};

use crate::error::{at, suggestion};

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

/// A unit as it is written, and what it means.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    /// The text, as it goes into the documentation of the field.
    pub text: String,
    /// Its dimension.
    pub dimension: Dimension,
}

impl Parse for Unit {
    /// `kg m^2`, `N*m*s`, `m/s^2`, `1`: juxtaposed or multiplied names with integer powers; a `/` takes the next name only.
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
            let more = input.peek(Token![/]) || input.peek(Token![*]) || input.peek(Ident) || input.peek(LitInt);
            if !more {
                return Ok(unit);
            }
        }
    }
}

impl Unit {
    fn factor(&mut self, input: ParseStream, sign: i32) -> syn::Result<()> {
        if input.peek(LitInt) {
            let one: LitInt = input.parse()?;
            if one.base10_digits() != "1" {
                return Err(at(
                    one.span(),
                    "a unit has no number but 1",
                    "write the factor into the value, in SI units",
                ));
            }
            self.text.push('1');
            return Ok(());
        }
        let Ok(name) = input.parse::<Ident>() else {
            let help = "write an SI unit such as `kg m^2`, `N m s`, `m/s^2`, or `1` for a plain number";
            return Err(at(input.span(), "expected a unit", help));
        };
        let text = name.to_string();
        let Some((_, base)) = NAMES.iter().find(|(known, _)| *known == text) else {
            let help = suggestion(&text, NAMES.map(|(known, _)| known));
            return Err(at(name.span(), format_args!("unknown unit `{text}`"), help));
        };
        self.text.push_str(&text);
        let mut power = 1;
        if input.peek(Token![^]) {
            input.parse::<Token![^]>()?;
            let negative = input.parse::<Option<Token![-]>>()?.is_some();
            let exponent: LitInt = input.parse()?;
            power = exponent
                .base10_parse::<i32>()
                .ok()
                .filter(|n| (1..=9).contains(n))
                .ok_or_else(|| {
                    at(
                        exponent.span(),
                        "the power of a unit is out of range",
                        "write an integer from 1 to 9, with or without a minus",
                    )
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
