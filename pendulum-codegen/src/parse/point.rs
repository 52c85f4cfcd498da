//! Points of bodies.

use syn::parse::ParseStream;
use syn::{Ident, Token, token};

use super::token::identifier;
use super::{read, skip_to};
use crate::ast::{Point, Vector};
use crate::error::{Code, at};

/// `name on body at [x, y, z]`, after the word `point`
pub(super) fn point(input: ParseStream) -> syn::Result<Point> {
    let name = identifier(input, "the name of a point", "point tip on arm at [0, -l, 0]")?;
    let form = format!("point {name} on arm at [0, -l, 0]");
    let on: Option<Ident> = input.parse()?;
    let body = if on.as_ref().is_some_and(|on| on == "on") {
        identifier(input, "the body of the point", &form)
    } else {
        skip_to(input, |input| input.peek(Token![,]));
        Err(at(
            Code::Syntax,
            name.span(),
            format_args!("point `{name}` has no body"),
            format_args!("write `{form}`, with a body or `ground` after `on`"),
        ))
    };
    let mut place = None;
    if input.peek(token::Bracket) {
        let fact = format_args!("expected `at` before the position of `{name}`");
        return Err(at(Code::Syntax, input.span(), fact, format_args!("write `{form}`")));
    }
    if let Some((word, _)) = input.cursor().ident()
        && body.is_ok()
    {
        if word != "at" {
            let fact = format_args!("unexpected `{word}` after the body of `{name}`");
            return Err(at(Code::Syntax, word.span(), fact, format_args!("write `{form}`")));
        }
        input.parse::<Ident>()?;
        place = Some(read::<Vector>(input, |_| false));
    }
    Ok(Point { name, body, at: place })
}
