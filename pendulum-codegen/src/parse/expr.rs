//! Expressions, with the precedence of mathematics: `-m * d^2` is `-(m * (d^2))`.

use num_traits::{Pow, Zero};
use proc_macro2::{TokenStream, TokenTree};
use syn::buffer::Cursor;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, Lit, Token, token};

use super::foreign;
use super::token::{end_of, identifier, list, parentheses, starts_item, unexpected};
use crate::ast::{Expr, ExprKind, Measured, Operator};
use crate::error::{Code, at};
use crate::expr::{Rational, ratio};
use crate::units::Unit;

/// Maximum length of an expression, in tokens: later stages work by recursion.
const MOST_TOKENS: usize = 2000;
/// Maximum nesting of brackets in an expression, for the same reason.
const MOST_NESTING: usize = 100;

/// Maximum number of digits of a number.
const MOST_DIGITS: usize = 500;

impl Parse for Expr {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let (tokens, nesting) = size_until_comma(input.cursor());
        if tokens > MOST_TOKENS || nesting > MOST_NESTING {
            let fact = "the expression is too long, or its brackets are nested too deeply";
            let help = format!(
                "at most {MOST_TOKENS} tokens and {MOST_NESTING} levels are allowed; name its parts with `let`"
            );
            return Err(at(Code::TooLong, input.span(), fact, help));
        }
        let expr = sum(input)?;
        let about = input.cursor().ident().is_some_and(|(word, _)| word == "about");
        if input.is_empty() || input.peek(Token![,]) || input.peek(Token![;]) || about || starts_item(input) {
            return Ok(expr);
        }
        Err(unexpected(input))
    }
}

/// Counts the tokens before the next comma and the depth of their nesting; stops beyond [`MOST_TOKENS`].
fn size_until_comma(mut rest: Cursor<'_>) -> (usize, usize) {
    let (mut count, mut deepest) = (0, 0);
    while let Some((token, next)) = rest.token_tree()
        && count <= MOST_TOKENS
    {
        let mut levels = match token {
            TokenTree::Punct(comma) if comma.as_char() == ',' => break,
            TokenTree::Group(group) => vec![group.stream().into_iter()],
            _ => Vec::new(),
        };
        count += 1;
        deepest = deepest.max(levels.len());
        while let Some(level) = levels.last_mut()
            && count <= MOST_TOKENS
        {
            match level.next() {
                None => _ = levels.pop(),
                Some(token) => {
                    count += 1;
                    if let TokenTree::Group(group) = token {
                        levels.push(group.stream().into_iter());
                        deepest = deepest.max(levels.len());
                    }
                }
            }
        }
        rest = next;
    }
    (count, deepest)
}

/// Parses with `parser`, and also returns the consumed tokens.
pub(super) fn recorded<T>(
    input: ParseStream,
    parser: impl FnOnce(ParseStream) -> syn::Result<T>,
) -> syn::Result<(T, TokenStream)> {
    let start = input.fork();
    let value = parser(input)?;
    let mut tokens = TokenStream::new();
    while start.cursor() != input.cursor() {
        tokens.extend([start.parse::<TokenTree>()?]);
    }
    Ok((value, tokens))
}

/// Parses an expression, and stores all of its tokens.
fn whole(input: ParseStream, parser: impl FnOnce(ParseStream) -> syn::Result<Expr>) -> syn::Result<Expr> {
    let (expr, tokens) = recorded(input, parser)?;
    Ok(Expr { tokens, ..expr })
}

/// Returns an expression with the tokens of its first operand only; [`whole`] completes them.
fn joined(first: TokenStream, kind: ExprKind) -> Expr {
    Expr { kind, tokens: first }
}

fn sum(input: ParseStream) -> syn::Result<Expr> {
    whole(input, |input| {
        let mut left = term(input)?;
        loop {
            let operator = if input.parse::<Option<Token![+]>>()?.is_some() {
                Operator::Add
            } else if input.parse::<Option<Token![-]>>()?.is_some() {
                Operator::Sub
            } else {
                return Ok(left);
            };
            let right = term(input)?;
            left = joined(
                left.tokens.clone(),
                ExprKind::Binary(operator, Box::new(left), Box::new(right)),
            );
        }
    })
}

fn term(input: ParseStream) -> syn::Result<Expr> {
    whole(input, |input| {
        if input.peek(Token![-]) {
            // iterate: the number of signs is unlimited, but the stack is not
            let mut negative = false;
            while input.parse::<Option<Token![-]>>()?.is_some() {
                negative = !negative;
            }
            let operand = term(input)?;
            return Ok(match negative {
                true => joined(operand.tokens.clone(), ExprKind::Neg(Box::new(operand))),
                false => operand,
            });
        }
        let mut left = power(input)?;
        loop {
            let operator = if input.parse::<Option<Token![*]>>()?.is_some() {
                Operator::Mul
            } else if input.parse::<Option<Token![/]>>()?.is_some() {
                Operator::Div
            } else {
                return Ok(left);
            };
            let right = if input.peek(Token![-]) {
                term(input)?
            } else {
                power(input)?
            };
            left = joined(
                left.tokens.clone(),
                ExprKind::Binary(operator, Box::new(left), Box::new(right)),
            );
        }
    })
}

fn power(input: ParseStream) -> syn::Result<Expr> {
    whole(input, |input| {
        let base = atom(input)?;
        if input.parse::<Option<Token![^]>>()?.is_none() {
            return Ok(base);
        }
        let exponent = whole(input, |input| {
            if input.parse::<Option<Token![-]>>()?.is_none() {
                return power(input);
            }
            let operand = power(input)?;
            Ok(joined(operand.tokens.clone(), ExprKind::Neg(Box::new(operand))))
        })?;
        Ok(joined(
            base.tokens.clone(),
            ExprKind::Power(Box::new(base), Box::new(exponent)),
        ))
    })
}

fn atom(input: ParseStream) -> syn::Result<Expr> {
    let (kind, tokens) = recorded(input, |input| {
        if let Some(inner) = parentheses(input)? {
            let inside = sum(&inner)?;
            end_of(&inner)?;
            return Ok(inside.kind);
        }
        if input.peek(Lit) {
            return number(input);
        }
        if !input.peek(Ident) {
            return Err(foreign::no_operand(input));
        }
        let name = identifier(input, "a name", "theta")?;
        foreign::no_path(input, &name)?;
        let Some(inner) = parentheses(input)? else {
            return Ok(match component(input) {
                Some(component) => ExprKind::Component(name, component?),
                None => ExprKind::Name(name),
            });
        };
        let arguments = list(&inner, &format!("{name}(x)"), sum)?;
        if name == "dot"
            && let [
                Expr {
                    kind: ExprKind::Name(of),
                    ..
                },
            ] = &arguments[..]
            && let Some(component) = component(input)
        {
            return Ok(ExprKind::RateComponent(of.clone(), component?));
        }
        Ok(ExprKind::Call(name, arguments))
    })?;
    foreign::nothing_after(input, &kind, &tokens)?;
    Ok(Expr { kind, tokens })
}

/// Parses `.x` after the name of a point. Leaves a method call, as in other languages, unparsed.
fn component(input: ParseStream) -> Option<syn::Result<Ident>> {
    let ahead = input.fork();
    ahead.parse::<Token![.]>().ok()?;
    ahead.parse::<Ident>().ok()?;
    (!ahead.peek(token::Paren)).then(|| {
        input.parse::<Token![.]>()?;
        input.parse()
    })
}

/// Parses a number, optionally with a unit.
fn number(input: ParseStream) -> syn::Result<ExprKind> {
    let literal: Lit = input.parse()?;
    let (digits, suffix) = match &literal {
        Lit::Int(n) => (n.base10_digits(), n.suffix()),
        Lit::Float(n) => (n.base10_digits(), n.suffix()),
        _ => {
            return Err(at(
                Code::NotInLanguage,
                literal.span(),
                "expected a number",
                "strings, characters and booleans are not allowed in an expression",
            ));
        }
    };
    let count = digits.bytes().take_while(|digit| !b"eE".contains(digit));
    if count.filter(u8::is_ascii_digit).count() > MOST_DIGITS {
        let help = format!("at most {MOST_DIGITS} are allowed; a double holds 17");
        return Err(at(Code::TooLong, literal.span(), "a number has too many digits", help));
    }
    let number = decimal(digits).ok_or_else(|| {
        at(
            Code::NumberRange,
            literal.span(),
            "the number is out of range",
            "write a number between 1e-300 and 1e300, or 0",
        )
    })?;
    foreign::no_suffix(&literal, digits, suffix)?;
    let unit = Unit::after_number(input, (!suffix.is_empty()).then_some((suffix, literal.span())))?;
    Ok(match unit {
        Some(unit) => ExprKind::Measured(Box::new(Measured {
            digits: digits.to_owned(),
            number,
            unit,
        })),
        None => ExprKind::Number(number),
    })
}

/// Returns the exact value of decimal digits with an optional point and exponent, if it is in range.
fn decimal(digits: &str) -> Option<Rational> {
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (digits, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let integer: num_bigint::BigInt = format!("{whole}{fraction}").parse().ok()?;
    if integer.is_zero() {
        return Some(Rational::zero());
    }
    // a value with an exponent beyond this is out of range, whatever its digits
    let range = -2000..=2000;
    let exponent = exponent.clamp(*range.start(), *range.end()) - i32::try_from(fraction.len()).ok()?;
    let value = Rational::from(integer) * ratio(10, 1).pow(exponent);
    (ratio(10, 1).pow(-300)..=ratio(10, 1).pow(300))
        .contains(&value)
        .then_some(value)
}
