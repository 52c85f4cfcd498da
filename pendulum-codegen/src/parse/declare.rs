//! What declares a name: parameters, inputs and `let`. The name is kept even if the rest is wrong, so that its uses
//! are no errors too.

use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Ident, Token};

use super::token::{braces, identifier, parentheses};
use super::{docs, read, skip_to};
use crate::ast::{Input, Let, Param, Read};
use crate::error::{Errors, at};
use crate::units::Unit;

/// The braces of `params { .. }`.
pub(super) fn params<'a>(input: &ParseBuffer<'a>, errors: &mut Errors) -> syn::Result<ParseBuffer<'a>> {
    let ahead = input.fork();
    if ahead.parse::<Option<Token![:]>>()?.is_some() && ahead.peek(syn::token::Brace) {
        errors.at(
            input.span(),
            "`params` takes no colon",
            "write `params { m: kg = 1.0 }`",
        );
        input.parse::<Token![:]>()?;
    }
    let error = match braces(input, "the parameters", "params { m: kg = 1.0 }") {
        Ok(inner) => return Ok(inner),
        Err(error) => error,
    };
    let inner = parentheses(input)?.ok_or_else(|| error.clone())?;
    errors.push(error);
    Ok(inner)
}

/// `name: unit = default`
pub(super) fn param(input: ParseStream, errors: &mut Errors) -> syn::Result<Param> {
    let docs = docs(input)?;
    if (input.peek(Token![pub]) || input.peek(Token![let])) && input.peek2(Ident) {
        let word = input.call(Ident::parse_any)?;
        let fact = format_args!("a parameter takes no `{word}`");
        errors.at(word.span(), fact, "leave it out");
    }
    let name = identifier(input, "the name of a parameter", "name: unit = default")?;
    let unit = unit(input, "parameter", &name, "kg");
    if input.peek(Token![:]) && unit.is_ok() {
        let help = format!("write `{name}: unit = default`");
        errors.at(
            input.span(),
            format_args!("expected `=` before the default of `{name}`"),
            help,
        );
        input.parse::<Token![:]>()?;
        input.parse::<Option<Token![=]>>()?;
        return Ok(Param {
            docs,
            name,
            unit,
            default: Some(read(input, |_| false)),
        });
    }
    let default = input.parse::<Option<Token![=]>>()?.map(|_| read(input, |_| false));
    Ok(Param {
        docs,
        name,
        unit,
        default,
    })
}

/// `name: unit`, after the word `input`
pub(super) fn input(input: ParseStream, docs: Vec<String>, errors: &mut Errors) -> syn::Result<Input> {
    let name = identifier(input, "the name of an input", "input push: N")?;
    let unit = unit(input, "input", &name, "N");
    if input.peek(Token![=]) && unit.is_ok() {
        let help = "leave it out: the value is given at each evaluation";
        errors.at(input.span(), format_args!("input `{name}` has no default"), help);
        skip_to(input, |input| input.peek(Token![,]));
    }
    Ok(Input { docs, name, unit })
}

/// `name = value`, after the word `let`
pub(super) fn named_expression(input: ParseStream, errors: &mut Errors) -> syn::Result<Let> {
    let name = identifier(input, "a name", "let name = expression")?;
    if input.peek(Token![:]) {
        let help = format!("write `let {name} = ..`; units stand in `params` and at inputs only");
        errors.at(input.span(), format_args!("`let {name}` takes no unit"), help);
        skip_to(input, |input| input.peek(Token![=]) || input.peek(Token![,]));
    }
    let value = if input.parse::<Option<Token![=]>>()?.is_some() {
        read(input, |_| false)
    } else {
        let help = format!("write `let {name} = expression`");
        let error = at(input.span(), format_args!("expected `=` after `let {name}`"), help);
        skip_to(input, |input| input.peek(Token![,]));
        Err(error)
    };
    Ok(Let { name, value })
}

/// `: unit` after the name of a parameter or an input, of which `such` is one
fn unit(input: ParseStream, kind: &str, name: &Ident, such: &str) -> Read<Unit> {
    if input.parse::<Option<Token![:]>>()?.is_some() {
        return read(input, |input| input.peek(Token![=]));
    }
    skip_to(input, |input| input.peek(Token![=]) || input.peek(Token![,]));
    Err(at(
        name.span(),
        format_args!("{kind} `{name}` has no unit"),
        format_args!("write `{name}: {such}`, or `{name}: 1` for a plain number"),
    ))
}
