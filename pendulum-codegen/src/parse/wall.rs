//! Stops of joints, and walls.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, token};

use super::expr::recorded;
use super::token::{braces, brackets, colon, identifier, list, parentheses, starts_item, unexpected};
use super::{End, docs, each, once};
use crate::ast::{Expr, Stop, Wall, WallFields};
use crate::error::{Code, Errors, at};
use crate::words::{self, Advice, advice};

const FORM: &str = "wall floor { gap: tip.y, restitution: 0.5 }";
const STOP: &str = "stop: [low, high] restitution(0.5)";
const FIELDS: [&str; 3] = ["gap", "restitution", "slow"];

/// `name { fields }`, after the word `wall`
pub(super) fn wall(input: ParseStream, errors: &mut Errors) -> syn::Result<Wall> {
    let name = identifier(input, "the name of a wall", FORM)?;
    let inner = braces(input, &format!("the fields of wall `{name}`"), FORM)?;
    let mut fields = WallFields::default();
    let unread = each(&inner, errors, |input, errors| field(input, &mut fields, errors));
    Ok(Wall { name, fields, unread })
}

fn field(input: ParseStream, fields: &mut WallFields, errors: &mut Errors) -> syn::Result<End> {
    docs(input)?;
    let help = format!("known here: {}", FIELDS.join(", "));
    let mut key = input
        .call(Ident::parse_any)
        .map_err(|e| at(Code::Syntax, e.span(), "expected a field", &help))?;
    if !FIELDS.iter().any(|known| key == known) {
        let Advice { meant, help } = advice(&key.to_string(), FIELDS, words::WALL);
        let fact = format_args!("unknown field `{key}`");
        let error = at(Code::UnknownWord, key.span(), fact, help);
        let meant = meant.ok_or_else(|| error.clone())?;
        errors.push(error);
        key = Ident::new(meant, key.span());
    }
    colon(input, &key, errors)?;
    let place = match key.to_string().as_str() {
        "gap" => &mut fields.gap,
        "restitution" => &mut fields.restitution,
        _ => &mut fields.slow,
    };
    once(place, input.parse()?, &key)?;
    Ok(End::Comma)
}

impl Parse for Stop {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let span = input.span();
        let (limits, tokens) = recorded(input, |input| {
            let inner = brackets(input, "the limits of the coordinate", STOP)?;
            list(&inner, STOP, Expr::parse)
        })?;
        let limits = <[Expr; 2]>::try_from(limits).map_err(|_| {
            at(
                Code::Arguments,
                span,
                "a stop has a lower and an upper limit",
                format_args!("write `{STOP}`"),
            )
        })?;
        let mut restitution = None;
        if input.peek(Ident) && !starts_item(input) {
            let word: Ident = input.parse()?;
            if word != "restitution" {
                let fact = format_args!("unexpected `{word}` after the stop");
                return Err(at(Code::Syntax, word.span(), fact, format_args!("write `{STOP}`")));
            }
            let mut numbers = match parentheses(input)? {
                Some(inner) => list(&inner, STOP, Expr::parse)?.into_iter(),
                None => Vec::new().into_iter(),
            };
            restitution = match (numbers.next(), numbers.next(), numbers.next()) {
                (Some(coefficient), slow, None) => Some((coefficient, slow)),
                _ => {
                    let fact = "`restitution` takes a number and, optionally, the rate below which nothing rebounds";
                    return Err(at(
                        Code::Arguments,
                        word.span(),
                        fact,
                        format_args!("write `{STOP}`, or `restitution(0.5, 0.01)`"),
                    ));
                }
            };
        } else if input.peek(token::Paren) {
            return Err(unexpected(input));
        }
        Ok(Self {
            limits,
            tokens,
            restitution,
        })
    }
}
