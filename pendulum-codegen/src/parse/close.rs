//! Joints that close loops.

use syn::parse::ParseStream;
use syn::{Ident, Token};

use super::token::{colon, identifier};
use super::{joint, once, read};
use crate::ast::{Closure, End, Vector};
use crate::error::{Errors, at};

const FORM: &str = "close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z)";

/// `body at [x, y, z] rpy [x, y, z] to body at [x, y, z] rpy [x, y, z]: revolute(z)`, after the word `close`
pub(super) fn close(input: ParseStream, word: Ident, errors: &mut Errors) -> syn::Result<Closure> {
    let first = end(input)?;
    let to: Option<Ident> = input.parse()?;
    if to.as_ref().is_none_or(|to| to != "to") {
        let span = to.map_or(input.span(), |to| to.span());
        let fact = format_args!("expected `to`, and what `{}` is tied to", first.body);
        return Err(at(span, fact, format_args!("write `{FORM}`")));
    }
    let second = end(input)?;
    colon(input, &second.body, errors)?;
    let joint = joint::kind(input, &second.body, FORM)?;
    Ok(Closure {
        word,
        ends: [first, second],
        joint,
    })
}

/// `body at [x, y, z] rpy [roll, pitch, yaw]`
fn end(input: ParseStream) -> syn::Result<End> {
    let body = identifier(input, "a body that closes the loop", FORM)?;
    let mut end = End {
        body,
        at: None,
        rpy: None,
    };
    let at_end = |input: ParseStream| input.peek(Token![:]) || input.peek(Ident);
    loop {
        let ahead = input.fork().parse::<Ident>().map(|word| word.to_string());
        let place = match ahead.as_deref() {
            Ok("at") => &mut end.at,
            Ok("rpy") => &mut end.rpy,
            _ => return Ok(end),
        };
        let word: Ident = input.parse()?;
        once(place, read::<Vector>(input, at_end), &word)?;
    }
}
