//! Items that declare a name: parameters, inputs, `let`, outputs and events. The name is kept even if the rest is
//! wrong, so that its uses are not reported too.

use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Ident, Token, token};

use super::token::{braces, brackets, identifier, list, parentheses};
use super::{docs, read, skip_to};
use crate::ast::{Event, Expr, Input, Let, Output, OutputValue, Param, Read, without_unit};
use crate::error::{Code, Errors, at};
use crate::units::Unit;

/// Parses the braces of `params { .. }`.
pub(super) fn params<'a>(input: &ParseBuffer<'a>, errors: &mut Errors) -> syn::Result<ParseBuffer<'a>> {
    let ahead = input.fork();
    if ahead.parse::<Option<Token![:]>>()?.is_some() && ahead.peek(syn::token::Brace) {
        errors.at(
            Code::Syntax,
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
        errors.at(Code::NotInLanguage, word.span(), fact, "leave it out");
    }
    let name = identifier(input, "the name of a parameter", "name: unit = default")?;
    let unit = unit(input, "parameter", &name, "kg");
    if input.peek(Token![:]) && matches!(unit, Some(Ok(_))) {
        let help = format!("write `{name}: unit = default`");
        errors.at(
            Code::Syntax,
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
    if input.peek(Token![=]) && matches!(unit, Some(Ok(_))) {
        let help = "leave it out: the value is given at each evaluation";
        let fact = format_args!("input `{name}` has no default");
        errors.at(Code::Syntax, input.span(), fact, help);
        skip_to(input, |input| input.peek(Token![,]));
    }
    Ok(Input { docs, name, unit })
}

/// `name = value`, after the word `let`
pub(super) fn named_expression(input: ParseStream, errors: &mut Errors) -> syn::Result<Let> {
    let name = identifier(input, "a name", "let name = expression")?;
    if input.peek(Token![:]) {
        let help = format!("write `let {name} = ..`; only parameters and inputs declare units");
        let fact = format_args!("`let {name}` takes no unit");
        errors.at(Code::Syntax, input.span(), fact, help);
        skip_to(input, |input| input.peek(Token![=]) || input.peek(Token![,]));
    }
    let value = if input.parse::<Option<Token![=]>>()?.is_some() {
        read(input, |_| false)
    } else {
        let help = format!("write `let {name} = expression`");
        let fact = format_args!("expected `=` after `let {name}`");
        let error = at(Code::Syntax, input.span(), fact, help);
        skip_to(input, |input| input.peek(Token![,]));
        Err(error)
    };
    Ok(Let { name, value })
}

/// `name: value`, after the word `output`
pub(super) fn output(input: ParseStream, docs: Vec<String>) -> syn::Result<Output> {
    let form = "output height: tip.y";
    let name = identifier(input, "the name of an output", form)?;
    let value = valued(input, "output", &name, |input| {
        if !input.peek(token::Bracket) {
            return Ok(OutputValue::Scalar(input.parse()?));
        }
        let span = input.span();
        let inner = brackets(input, "the components", "output v: [dot(tip.x), dot(tip.y)]")?;
        let list = list(&inner, "[e, e]", |input| input.parse::<Expr>())?;
        if list.is_empty() {
            let fact = format_args!("output `{name}` has no components");
            return Err(at(Code::Arguments, span, fact, "list one or more expressions"));
        }
        Ok(OutputValue::List(list))
    });
    Ok(Output { docs, name, value })
}

/// `name: value`, after the word `event`
pub(super) fn event(input: ParseStream, docs: Vec<String>) -> syn::Result<Event> {
    let name = identifier(input, "the name of an event", "event lands: tip.y")?;
    let value = valued(input, "event", &name, |input| input.parse());
    Ok(Event { docs, name, value })
}

/// `: value` after the name of an output or an event
fn valued<T>(
    input: ParseStream,
    kind: &str,
    name: &Ident,
    parser: impl FnOnce(ParseStream) -> syn::Result<T>,
) -> Read<T> {
    let value = if input.parse::<Option<Token![:]>>()?.is_some() {
        parser(input)
    } else {
        let help = format_args!("write `{kind} {name}: expression`");
        Err(at(
            Code::Syntax,
            input.span(),
            format_args!("expected a colon after `{kind} {name}`"),
            help,
        ))
    };
    value.inspect_err(|_| skip_to(input, |input| input.peek(Token![,])))
}

/// `: unit` after the name of a parameter or an input, if it is there
fn unit(input: ParseStream, kind: &str, name: &Ident, such: &str) -> Option<Read<Unit>> {
    if input.peek(Token![:]) {
        let colon = input.parse::<Token![:]>();
        return Some(colon.and_then(|_| read(input, |input| input.peek(Token![=]))));
    }
    let is_next = |input: ParseStream| input.peek(Token![=]) || input.peek(Token![,]);
    if input.is_empty() || is_next(input) {
        return None;
    }
    skip_to(input, is_next);
    Some(Err(without_unit(kind, name, &name.to_string(), such)))
}
