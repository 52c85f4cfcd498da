//! Joints that close loops.

use proc_macro2::TokenTree;
use syn::parse::ParseStream;
use syn::token::Bracket;
use syn::{Ident, Token};

use super::token::{colon, identifier, starts_item};
use super::{joint, once};
use crate::ast::{Closure, End, Vector};
use crate::error::{Code, Errors, at};

const FORM: &str = "close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z)";

/// Joints that can close a loop.
const CLOSING: [&str; 4] = ["revolute", "prismatic", "ball", "fixed"];

/// `body at [x, y, z] rpy [x, y, z] to body at [x, y, z] rpy [x, y, z]: revolute(z)`, after the word `close`
pub(super) fn close(input: ParseStream, word: Ident, errors: &mut Errors) -> syn::Result<Closure> {
    let first = end(input)?;
    let to: Option<Ident> = input.parse()?;
    if to.as_ref().is_none_or(|to| to != "to") {
        no_place(input, &first)?;
        let span = to.map_or(input.span(), |to| to.span());
        let fact = format_args!("expected `to` and the body to connect `{}` to", first.body);
        return Err(at(Code::Syntax, span, fact, format_args!("write `{FORM}`")));
    }
    let second = end(input)?;
    no_place(input, &second)?;
    if !input.peek(Token![:]) && !input.peek(Token![=]) {
        let fact = format_args!(
            "expected a colon and the joint between `{}` and `{}`",
            first.body, second.body
        );
        return Err(at(Code::Syntax, input.span(), fact, format_args!("write `{FORM}`")));
    }
    colon(input, &second.body, errors)?;
    let joint = joint::kind(input, &second.body, FORM, &CLOSING)?;
    if input.peek(Ident) && !starts_item(input) {
        let fact = "the joint that closes a loop has no position of its own";
        return Err(at(
            Code::Syntax,
            input.span(),
            fact,
            format_args!("write the positions after the bodies: `{FORM}`"),
        ));
    }
    Ok(Closure {
        word,
        ends: [first, second],
        joint,
    })
}

/// Rejects a place without the word `at`.
fn no_place(input: ParseStream, end: &End) -> syn::Result<()> {
    if input.peek(Bracket) {
        let fact = format_args!("expected `at` before the position on `{}`", end.body);
        return Err(at(Code::Syntax, input.span(), fact, format_args!("write `{FORM}`")));
    }
    Ok(())
}

/// `body at [x, y, z] rpy [roll, pitch, yaw]`
fn end(input: ParseStream) -> syn::Result<End> {
    let body = identifier(input, "a body that closes the loop", FORM)?;
    let mut end = End {
        body,
        at: None,
        rpy: None,
    };
    // elsewhere, a word before a colon would begin an item
    let at_end = |input: ParseStream| {
        let word = input.cursor().ident().map(|(word, _)| word);
        let is_next = word.is_some_and(|word| ["to", "at", "rpy"].iter().any(|next| word == next));
        is_next || input.peek(Token![:]) || input.peek(Token![,])
    };
    let vector = |input: ParseStream| {
        let read = input.parse::<Vector>();
        read.inspect_err(|_| while !at_end(input) && input.parse::<TokenTree>().is_ok() {})
    };
    loop {
        let ahead = input.fork().parse::<Ident>().map(|word| word.to_string());
        let place = match ahead.as_deref() {
            Ok("at") => &mut end.at,
            Ok("rpy") => &mut end.rpy,
            _ => return Ok(end),
        };
        let word: Ident = input.parse()?;
        once(place, vector(input), &word)?;
    }
}
