//! Expressions, with the precedence of mathematics: `-m * d^2` is `-(m * (d^2))`.

use num_traits::{Pow, Zero};
use proc_macro2::{TokenStream, TokenTree};
use syn::parse::{Parse, ParseStream};
use syn::{Ident, Lit, Token, bracketed, parenthesized, token};

use crate::ast::{Argument, Expr, ExprKind, Operator, Vector};
use crate::error::at;
use crate::expr::{Rational, ratio};

impl Parse for Expr {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        sum(input)
    }
}

/// Parses with `parser` and keeps the tokens that it took.
fn recorded<T>(
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

fn sum(input: ParseStream) -> syn::Result<Expr> {
    let start = input.fork();
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
            &start,
            input,
            ExprKind::Binary(operator, Box::new(left), Box::new(right)),
        )?;
    }
}

fn term(input: ParseStream) -> syn::Result<Expr> {
    let start = input.fork();
    if input.parse::<Option<Token![-]>>()?.is_some() {
        let operand = term(input)?;
        return joined(&start, input, ExprKind::Neg(Box::new(operand)));
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
            &start,
            input,
            ExprKind::Binary(operator, Box::new(left), Box::new(right)),
        )?;
    }
}

fn power(input: ParseStream) -> syn::Result<Expr> {
    let start = input.fork();
    let base = atom(input)?;
    if input.parse::<Option<Token![^]>>()?.is_none() {
        return Ok(base);
    }
    let minus = input.fork();
    let exponent = if input.parse::<Option<Token![-]>>()?.is_some() {
        let operand = power(input)?;
        joined(&minus, input, ExprKind::Neg(Box::new(operand)))?
    } else {
        power(input)?
    };
    joined(&start, input, ExprKind::Power(Box::new(base), Box::new(exponent)))
}

fn joined(start: ParseStream, end: ParseStream, kind: ExprKind) -> syn::Result<Expr> {
    let (from, mut tokens) = (start.fork(), TokenStream::new());
    while from.cursor() != end.cursor() {
        tokens.extend([from.parse::<TokenTree>()?]);
    }
    Ok(Expr { kind, tokens })
}

fn atom(input: ParseStream) -> syn::Result<Expr> {
    let (kind, tokens) = recorded(input, |input| {
        if input.peek(token::Paren) {
            let inner;
            parenthesized!(inner in input);
            let inside: Expr = inner.parse()?;
            end_of(&inner)?;
            return Ok(inside.kind);
        }
        if input.peek(Lit) {
            return Ok(ExprKind::Number(number(&input.parse()?)?));
        }
        if !input.peek(Ident) {
            return Err(at(
                input.span(),
                "expected an expression",
                "write a number, a name, a function such as `sin(theta)`, or a formula of these",
            ));
        }
        let name: Ident = input.parse()?;
        if !input.peek(token::Paren) {
            return Ok(ExprKind::Name(name));
        }
        let inner;
        parenthesized!(inner in input);
        let arguments = inner.parse_terminated(Expr::parse, Token![,])?;
        Ok(ExprKind::Call(name, arguments.into_iter().collect()))
    })?;
    Ok(Expr { kind, tokens })
}

/// What is left inside brackets must be nothing.
pub(super) fn end_of(input: ParseStream) -> syn::Result<()> {
    if input.is_empty() {
        return Ok(());
    }
    Err(at(
        input.span(),
        "expected an operator or the end of the expression",
        "operators are + - * / ^; products need a `*`",
    ))
}

fn number(literal: &Lit) -> syn::Result<Rational> {
    let (digits, suffix) = match literal {
        Lit::Int(n) => (n.base10_digits(), n.suffix()),
        Lit::Float(n) => (n.base10_digits(), n.suffix()),
        _ => {
            return Err(at(
                literal.span(),
                "expected a number",
                "text, characters and booleans have no place in an expression",
            ));
        }
    };
    if !suffix.is_empty() {
        return Err(at(
            literal.span(),
            format_args!("a number takes no suffix `{suffix}`"),
            "leave it out: the generated code is generic over the number type",
        ));
    }
    decimal(digits).ok_or_else(|| {
        at(
            literal.span(),
            "the number is out of range",
            "write a number between 1e-300 and 1e300, or 0",
        )
    })
}

/// The exact value of decimal digits with an optional point and exponent.
fn decimal(digits: &str) -> Option<Rational> {
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (digits, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let integer: num_bigint::BigInt = format!("{whole}{fraction}").parse().ok()?;
    if integer.is_zero() {
        return Some(Rational::zero());
    }
    let size = exponent + i32::try_from(integer.to_string().len()).ok()?;
    (-300..=300)
        .contains(&size)
        .then(|| Rational::from(integer) * ratio(10, 1).pow(exponent))
}

impl Parse for Vector {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let (entries, tokens) = list(input)?;
        let count = entries.len();
        match <[Expr; 3]>::try_from(entries) {
            Ok(components) => Ok(Self { components, tokens }),
            Err(_) => Err(syn::Error::new_spanned(
                tokens,
                format!("a vector has three components, not {count}\nhelp: write `[x, y, z]`"),
            )),
        }
    }
}

/// `[e, e, ..]`
pub(super) fn list(input: ParseStream) -> syn::Result<(Vec<Expr>, TokenStream)> {
    if !input.peek(token::Bracket) {
        return Err(at(input.span(), "expected a list in brackets", "write `[x, y, z]`"));
    }
    recorded(input, |input| {
        let inner;
        bracketed!(inner in input);
        Ok(inner.parse_terminated(Expr::parse, Token![,])?.into_iter().collect())
    })
}

impl Parse for Argument {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        if !input.peek(token::Bracket) {
            return Ok(Self::Scalar(input.parse()?));
        }
        let ahead = input.fork();
        let inner;
        bracketed!(inner in ahead);
        if !inner.peek(token::Bracket) {
            let (entries, tokens) = list(input)?;
            return Ok(Self::List(entries, tokens));
        }
        let (points, tokens) = recorded(input, |input| {
            let inner;
            bracketed!(inner in input);
            let points = inner.parse_terminated(list, Token![,])?;
            Ok(points.into_iter().map(|(entries, _)| entries).collect())
        })?;
        Ok(Self::Points(points, tokens))
    }
}
