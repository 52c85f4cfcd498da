//! Actions outside of joints: forces, springs and dampers between points, potentials.

use syn::parse::ParseStream;
use syn::{Ident, Token, token};

use super::token::{colon, identifier, list, parentheses};
use super::{read, skip_to};
use crate::ast::{Action, ActionKind, Expr, Read};
use crate::error::{Code, Errors, at};

/// Parses an action after its first word.
pub(super) fn action(input: ParseStream, word: Ident, errors: &mut Errors) -> syn::Result<Action> {
    let kind = match word.to_string().as_str() {
        "force" => force(input, errors)?,
        "spring" => spring(input, &word, errors)?,
        "damper" => damper(input, &word, errors)?,
        "potential" => {
            colon(input, &word, errors)?;
            ActionKind::Potential(input.parse()?)
        }
        _ => {
            colon(input, &word, errors)?;
            ActionKind::Dissipation(input.parse()?)
        }
    };
    Ok(Action { word, kind })
}

/// `on point: [fx, fy, fz] in body`, or `coordinate: e`
fn force(input: ParseStream, errors: &mut Errors) -> syn::Result<ActionKind> {
    let form = "force on tip: [fx, fy, fz]";
    let name = identifier(input, "`on` and a point, or a coordinate", form)?;
    if name != "on" {
        if input.peek(Token![.]) || name == "dot" && input.peek(token::Paren) {
            let fact = "a force acts along a coordinate, or on a point";
            let help = "write `force theta: e`, or `force on tip: [fx, fy, fz]`; \
                        a moment `m` about the x axis of a body with the orientation `o` is `dissipation: -m*dot(o).x`";
            return Err(at(Code::Syntax, name.span(), fact, help));
        }
        colon(input, &name, errors)?;
        return Ok(ActionKind::Along {
            coordinate: name,
            force: read(input, |_| false),
        });
    }
    let point = identifier(input, "the point that it acts on", form)?;
    let next = input.fork().parse::<Ident>();
    if next.is_ok_and(|next| next == "at") {
        let help = format!("declare the point: `point tip on {point} at [x, y, z],` and write `{form}`");
        let fact = "a force acts on a named point";
        return Err(at(Code::Syntax, input.span(), fact, help));
    }
    if !input.peek(Token![:]) {
        let fact = format_args!("expected a colon after `{point}`");
        return Err(at(
            Code::Syntax,
            input.span(),
            fact,
            format_args!("write `force on {point}: [fx, fy, fz]`"),
        ));
    }
    input.parse::<Token![:]>()?;
    let force = read(input, |input| input.peek(Token![in]));
    let mut frame = None;
    if input.parse::<Option<Token![in]>>()?.is_some() {
        let form = "force on tip: [fx, fy, fz] in arm";
        frame = Some(identifier(input, "the body in whose frame it is given", form)?);
    }
    Ok(ActionKind::Push { point, force, frame })
}

/// `between a and b: (stiffness, length)`
fn spring(input: ParseStream, word: &Ident, errors: &mut Errors) -> syn::Result<ActionKind> {
    let form = "spring between a and b: (stiffness, length)";
    let ends = between(input, word, form, errors)?;
    let span = input.span();
    let law = (|| {
        let numbers = match parentheses(input)? {
            Some(inner) => list(&inner, form, |input| input.parse::<Expr>())?,
            None => Vec::new(),
        };
        match <[Expr; 2]>::try_from(numbers) {
            Ok([stiffness, length]) => Ok((stiffness, length)),
            Err(_) => {
                let fact = "a spring takes a stiffness and a rest length";
                Err(at(Code::Arguments, span, fact, format_args!("write `{form}`")))
            }
        }
    })();
    let law: Read<(Expr, Expr)> = law.inspect_err(|_| skip_to(input, |input| input.peek(Token![,])));
    Ok(ActionKind::Spring { ends, law })
}

/// `between a and b: coefficient`
fn damper(input: ParseStream, word: &Ident, errors: &mut Errors) -> syn::Result<ActionKind> {
    let ends = between(input, word, "damper between a and b: c", errors)?;
    Ok(ActionKind::Damper {
        ends,
        coefficient: read(input, |_| false),
    })
}

/// `between a and b:`
fn between(input: ParseStream, word: &Ident, form: &str, errors: &mut Errors) -> syn::Result<[Ident; 2]> {
    let expected = |input: ParseStream, what: &str| {
        let found: Option<Ident> = input.parse()?;
        let Some(_) = found.filter(|found| found == what) else {
            // leave the rest of the item unparsed
            skip_to(input, |input| input.peek(Token![:]));
            let fact = format_args!("a {word} of the scene acts between two points");
            return Err(at(Code::Syntax, word.span(), fact, format_args!("write `{form}`")));
        };
        Ok(())
    };
    expected(input, "between")?;
    let first = identifier(input, "a point", form)?;
    expected(input, "and")?;
    let second = identifier(input, "a point", form)?;
    colon(input, &second, errors)?;
    Ok([first, second])
}
