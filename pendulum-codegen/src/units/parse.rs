//! Parses units in the text of a declaration.

use proc_macro2::Span;
use quote::ToTokens;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, Lit, LitFloat, LitInt, Token, token};

use super::dimension::Power;
use super::{Dimension, Unit, names};
use crate::error::{Code, at};
use crate::parse::starts_item;

/// Maximum number of names in a unit.
const MOST_NAMES: usize = 8;

impl Parse for Unit {
    /// Parses `kg m^2`, `N*m*s`, `m/s^2` or `1`: names with integer powers, side by side or multiplied. A `/` applies
    /// to the next name only.
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let mut unit = Self::empty();
        let sign = unit.joint(input)?;
        unit.factor(input, sign)?;
        // a word that begins an item comes after a missing comma, and is no unit
        let name = |input: ParseStream| input.peek(Ident) && !starts_item(input);
        let more =
            |input: ParseStream| input.peek(Token![/]) || input.peek(Token![*]) || input.peek(LitInt) || name(input);
        unit.rest(input, more, Self::factor)
    }
}

impl Unit {
    /// Parses the unit after a number, if there is one: `90 deg`, `0.2 N m/rad`. Its first name may be the suffix of
    /// the number, as in `90deg`. A `*` ends the unit: a factor follows.
    pub(crate) fn after_number(input: ParseStream, suffix: Option<(&str, Span)>) -> syn::Result<Option<Self>> {
        let mut unit = Self::empty();
        match suffix {
            Some((name, span)) => unit.named(input, name, span, 1)?,
            None if begins(input) => unit.name(input, 1)?,
            None => return Ok(None),
        }
        let more = |input: ParseStream| {
            let ahead = input.fork();
            ahead.parse::<Option<Token![/]>>().is_ok() && begins(&ahead)
        };
        unit.rest(input, more, Self::name).map(Some)
    }

    /// Parses the names after the first one, each with its separator, as long as there are `more`.
    fn rest(
        mut self,
        input: ParseStream,
        more: impl Fn(ParseStream) -> bool,
        read: fn(&mut Self, ParseStream, i32) -> syn::Result<()>,
    ) -> syn::Result<Self> {
        while more(input) {
            let sign = self.joint(input)?;
            read(&mut self, input, sign)?;
        }
        Ok(self)
    }

    fn empty() -> Self {
        Self {
            text: String::new(),
            ..Self::default()
        }
    }

    /// Parses the separator before the next name, and returns the sign of its power.
    fn joint(&mut self, input: ParseStream) -> syn::Result<i32> {
        if input.parse::<Option<Token![/]>>()?.is_some() {
            self.text.push('/');
            return Ok(-1);
        }
        if input.parse::<Option<Token![*]>>()?.is_some() || !self.text.is_empty() {
            self.text.push(' ');
        }
        Ok(1)
    }

    /// Parses a name of the language, or 1.
    fn factor(&mut self, input: ParseStream, sign: i32) -> syn::Result<()> {
        if input.peek(LitInt) || input.peek(LitFloat) {
            let one: Lit = input.parse()?;
            if one.to_token_stream().to_string() != "1" {
                let fact = "expected a unit, not a value";
                let value = one.to_token_stream().to_string().replace(' ', "");
                let help = format!("write the unit first, such as `kg = {value}`, or `1 = {value}` for a plain number");
                return Err(at(Code::MissingUnit, one.span(), fact, help));
            }
            self.text.push('1');
            return Ok(());
        }
        if input.peek(token::Paren) {
            let help = "`/` applies to the next unit only: write `N/(m s)` as `N/m/s`";
            return Err(at(
                Code::UnknownUnit,
                input.span(),
                "parentheses are not allowed in a unit",
                help,
            ));
        }
        let Ok(name) = input.parse::<Ident>() else {
            let help = "write an SI unit such as `kg m^2`, `N m s`, `m/s^2`, or `1` for a plain number";
            return Err(at(Code::MissingUnit, input.span(), "expected a unit", help));
        };
        let text = name.to_string();
        if names::dimension(&text).is_none() {
            return Err(at(
                Code::UnknownUnit,
                name.span(),
                format_args!("unknown unit `{text}`"),
                names::help(&text),
            ));
        }
        self.named(input, &text, name.span(), sign)
    }

    /// Parses a name that may follow a number, with its power.
    fn name(&mut self, input: ParseStream, sign: i32) -> syn::Result<()> {
        let name: Ident = input.parse()?;
        self.named(input, &name.to_string(), name.span(), sign)
    }

    /// Multiplies the unit by a name that was parsed, raised to the power that follows it.
    fn named(&mut self, input: ParseStream, name: &str, span: Span, sign: i32) -> syn::Result<()> {
        let Some((dimension, scale)) = names::meaning(name) else {
            let fact = format_args!("unknown unit `{name}`");
            return Err(at(Code::UnknownUnit, span, fact, names::help(name)));
        };
        if self.names().count() == MOST_NAMES {
            let fact = format_args!("a unit has more than {MOST_NAMES} factors");
            return Err(at(Code::UnknownUnit, span, fact, "write powers, such as `m^2`"));
        }
        self.text.push_str(name);
        let power = sign * self.power(input)?;
        let product = self.dimension.times(dimension, Power::from(power));
        self.dimension = product.unwrap_or(Dimension::ONE);
        self.scale.times(&scale, power);
        Ok(())
    }

    fn power(&mut self, input: ParseStream) -> syn::Result<i32> {
        if input.parse::<Option<Token![^]>>()?.is_none() {
            return Ok(1);
        }
        let negative = input.parse::<Option<Token![-]>>()?.is_some();
        let span = input.span();
        let exponent = input.parse::<LitInt>().ok().and_then(|n| n.base10_parse::<i32>().ok());
        let power = exponent.filter(|n| (1..=9).contains(n)).ok_or_else(|| {
            let fact = "the exponent of a unit is not a whole number from 1 to 9";
            at(Code::UnknownUnit, span, fact, "write it as in `m^2` or `s^-1`")
        })?;
        let power = if negative { -power } else { power };
        self.text.push_str(&format!("^{power}"));
        Ok(power)
    }
}

/// True if the name of a unit comes next.
fn begins(input: ParseStream) -> bool {
    let name = input.cursor().ident();
    name.is_some_and(|(name, _)| Unit::is_name(&name.to_string())) && !starts_item(input)
}

/// Returns the help text for a word after a number that is no unit: `Kg` for `kg`, or `kgm2` for `kg m^2`.
pub(crate) fn help_after_number(number: &impl std::fmt::Display, word: &str) -> Option<String> {
    let meant = names::meant(word)?;
    let apart = if meant.contains(' ') {
        ", with spaces between the units"
    } else {
        ""
    };
    Some(format!("write `{number} {meant}`{apart}"))
}

/// Returns the help text for a factor or divisor of a measured number, if it is meant as a part of its unit: `s` in
/// `2 N m*s`, `s2` in `9.81 m/s2`.
pub(crate) fn help_in_product(number: &impl std::fmt::Display, is_divisor: bool, word: &str) -> Option<String> {
    let meant = names::meant(word)?;
    match is_divisor {
        false => Some(format!("write `{number} {meant}` for a unit")),
        true if !meant.contains(' ') => Some(format!("write `{number}/{meant}` for a unit")),
        true => None,
    }
}
