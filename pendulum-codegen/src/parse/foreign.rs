//! Syntax of other languages in expressions, and what to write instead.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Lit, Token, token};

use super::token::{is_keyword, parentheses};
use crate::ast::ExprKind;
use crate::error::{Code, at, on};
use crate::units::{self, Unit};
use crate::words::{SYMBOLS, synonym};

/// Returns the error for a token that cannot begin an operand.
pub(super) fn no_operand(input: ParseStream) -> syn::Error {
    let span = input.span();
    if let Ok(keyword) = input.call(Ident::parse_any) {
        if keyword != "if" && keyword != "match" {
            return is_keyword(&keyword);
        }
        let help = "use a smooth law: `(1 + tanh(x/eps))/2` is a step at x = 0";
        let fact = format_args!("`{keyword}` is not allowed in an expression");
        return at(Code::NotInLanguage, span, fact, help);
    }
    let (fact, help) = if input.peek(Token![*]) {
        (
            "expected an expression, not a second operator",
            "write a power as `x^2`, not `x**2`",
        )
    } else if input.peek(Token![+]) {
        ("expected a term before `+`", "remove the `+`")
    } else if input.peek(Token![.]) {
        ("a number begins with a digit", "write `0.5`")
    } else if input.peek(Token![|]) {
        ("`|` is not an operator", "write `abs(x)`")
    } else if input.peek(token::Bracket) {
        ("expected one number, not a list", "write a number, a name or a formula")
    } else {
        (
            "expected an expression",
            "write a number, a name, a function such as `sin(theta)`, or a formula of these",
        )
    };
    at(Code::Syntax, span, fact, help)
}

/// Rejects paths such as `f64::sin` and `std::f64::consts::PI`; the `first` word has been parsed.
pub(super) fn no_path(input: ParseStream, first: &Ident) -> syn::Result<()> {
    if !input.peek(Token![::]) {
        return Ok(());
    }
    let (mut text, mut last) = (first.to_token_stream(), first.clone());
    while input.peek(Token![::]) {
        input.parse::<Token![::]>()?.to_tokens(&mut text);
        if let Ok(word) = input.call(Ident::parse_any) {
            word.to_tokens(&mut text);
            last = word;
        }
    }
    let help = match synonym(&last.to_string(), SYMBOLS) {
        Some(sentence) if sentence.contains(' ') => sentence.to_owned(),
        meaning => format!("write `{}` alone", meaning.unwrap_or(&last.to_string())),
    };
    let fact = "paths are not allowed in an expression";
    Err(on(Code::NotInLanguage, text, fact, help))
}

/// Rejects what follows an operand in other languages: `theta.sin()`, `3 Nm`.
pub(super) fn nothing_after(input: ParseStream, kind: &ExprKind, operand: &TokenStream) -> syn::Result<()> {
    if input.peek(Token![.]) {
        return Err(method(input, operand));
    }
    let number = match kind {
        ExprKind::Number(_) => operand.to_string(),
        ExprKind::Measured(measured) => measured.to_string(),
        _ => return Ok(()),
    };
    if let Some((unit, _)) = input.cursor().ident()
        && !super::token::starts_item(input)
        && unit != "about"
    {
        let help = units::help_after_number(&number, &unit.to_string());
        let help = help.unwrap_or_else(|| format!("write a product as `{number}*{unit}`, and units as in `90 deg`"));
        let fact = format_args!("`{unit}` is not a unit");
        return Err(at(Code::UnknownUnit, unit.span(), fact, help));
    }
    Ok(())
}

fn method(input: ParseStream, operand: &TokenStream) -> syn::Error {
    let mut text = operand.clone();
    let mut read = || -> syn::Result<(Ident, Option<TokenStream>)> {
        input.parse::<Token![.]>()?.to_tokens(&mut text);
        let name = input.call(Ident::parse_any)?;
        name.to_tokens(&mut text);
        let arguments = parentheses(input)?.map(|inner| inner.parse()).transpose()?;
        Ok((name, arguments))
    };
    let mut trees = operand.clone().into_iter();
    let operand = match (trees.next(), trees.next()) {
        (Some(TokenTree::Group(group)), None) => group.stream().to_string(),
        _ => operand.to_string(),
    };
    let (fact, help) = match read() {
        Ok((name, Some(arguments))) => {
            let name = name.to_string();
            let help = match name.as_str() {
                "powi" | "powf" | "pow" => format!("write `{operand}^{arguments}`"),
                "atan2" => format!("write `atan2({operand}, {arguments})`"),
                _ if arguments.is_empty() => format!("write `{name}({operand})`"),
                _ => format!("write `{name}({operand}, {arguments})`"),
            };
            ("expressions have no methods", help)
        }
        _ => (
            "names have no fields",
            "write one name; `dot(theta)` is the rate of `theta`".to_owned(),
        ),
    };
    on(Code::NotInLanguage, text, fact, help)
}

/// Rejects a suffix of a number that is not a unit.
pub(super) fn no_suffix(literal: &Lit, digits: &str, suffix: &str) -> syn::Result<()> {
    if suffix.is_empty() || Unit::is_name(suffix) {
        return Ok(());
    }
    if let Some(help) = units::help_after_number(&digits, suffix) {
        let fact = format_args!("`{suffix}` is not a unit");
        return Err(at(Code::UnknownUnit, literal.span(), fact, help));
    }
    let fact = format_args!("a number takes no suffix `{suffix}`");
    let help = "leave it out: the generated code is generic over the number type";
    Err(at(Code::NotInLanguage, literal.span(), fact, help))
}
