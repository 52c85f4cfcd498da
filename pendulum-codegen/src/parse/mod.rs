//! Tokens to syntax tree. A mistake costs only the item or field it stands in: reading goes on after it.

mod argument;
mod body;
mod expr;
mod joint;
mod solid;

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, MetaNameValue, Token, Visibility, braced, bracketed, token};

use crate::ast::{Head, Input, Items, Let, Param, Scene};
use crate::error::{Errors, Reported, at, on, suggestion};

/// Reads a declaration. The scene is there unless its head could not be read; errors may stand beside it.
pub(crate) fn parse(tokens: TokenStream) -> (Option<Scene>, Errors) {
    let mut errors = Errors::default();
    let scene = (|input: ParseStream| {
        let docs = docs(input)?;
        let vis = input.parse::<Visibility>()?.into_token_stream();
        let name: Ident = input.parse().map_err(|e| {
            at(
                e.span(),
                "expected the name of the model",
                "write `mechanism! { pub DoublePendulum { body .. } }`",
            )
        })?;
        if ["T", "bool", "f64", "str", "usize"].iter().any(|taken| name == taken) {
            // no stand-in can be made under such a name either
            let fact = format!("`{name}` is a type that the generated code uses itself");
            return Err(at(name.span(), fact, "choose another name, such as `DoublePendulum`"));
        }
        if !input.peek(token::Brace) {
            let help = format!("write `{name} {{ body .. }}`");
            return Err(at(name.span(), format_args!("`{name}` has no items in braces"), help));
        }
        let inner;
        braced!(inner in input);
        let mut items = Items::default();
        each(&inner, &mut errors, |input, errors| item(input, &mut items, errors));
        if !input.is_empty() {
            errors.at(
                input.span(),
                "one declaration holds one model",
                "write another `mechanism!` for another model",
            );
            input.parse::<TokenStream>()?;
        }
        let head = Head { docs, vis, name };
        Ok(Scene { head, items })
    })
    .parse2(tokens);
    let scene = errors.keep(scene).ok();
    (scene, errors)
}

/// How an item ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// With a comma.
    Comma,
    /// With its own braces; a comma may follow.
    Braces,
}

/// Reads items until the end. After a mistake it skips to the next item. Returns the last error, if there was one.
fn each(
    input: ParseStream,
    errors: &mut Errors,
    mut item: impl FnMut(ParseStream, &mut Errors) -> syn::Result<End>,
) -> Option<Reported> {
    let mut reported = None;
    while !input.is_empty() {
        match item(input, errors).and_then(|end| Ok((end, input.parse::<Option<Token![,]>>()?))) {
            Ok((End::Comma, None)) if !input.is_empty() => {
                let help = "items end in a comma; products need a `*`";
                reported = Some(errors.at(input.span(), "expected a comma", help));
                // where the comma alone is missing, the next item can be read
                if !(input.peek(Ident) && input.peek2(Token![:])) {
                    skip(input);
                }
            }
            Ok(_) => {}
            Err(error) => {
                reported = Some(errors.push(error));
                skip(input);
            }
        }
    }
    reported
}

fn skip(input: ParseStream) {
    while let Ok(token) = input.parse::<TokenTree>() {
        match token {
            TokenTree::Punct(comma) if comma.as_char() == ',' => return,
            TokenTree::Group(group) if group.delimiter() == proc_macro2::Delimiter::Brace => {
                // a parse of nothing cannot fail here: the comma is optional
                let _ = input.parse::<Option<Token![,]>>();
                return;
            }
            _ => {}
        }
    }
}

/// The lines of documentation comments; no other attribute has a meaning here.
fn docs(input: ParseStream) -> syn::Result<Vec<String>> {
    let line = |attribute: Attribute| match &attribute.meta {
        Meta::NameValue(MetaNameValue {
            path,
            value: Expr::Lit(ExprLit {
                lit: Lit::Str(text), ..
            }),
            ..
        }) if path.is_ident("doc") => Ok(text.value()),
        _ => Err(on(
            attribute,
            "only documentation comments may stand here",
            "remove the attribute",
        )),
    };
    input.call(Attribute::parse_outer)?.into_iter().map(line).collect()
}

/// Puts a value where none was, or refuses the second one.
fn once<T>(place: &mut Option<T>, value: T, key: &Ident) -> syn::Result<()> {
    if place.is_some() {
        return Err(at(
            key.span(),
            format_args!("`{key}` is given twice"),
            "keep one of the two",
        ));
    }
    *place = Some(value);
    Ok(())
}

const ITEMS: [&str; 7] = ["params", "gravity", "let", "input", "shape", "body", "generate"];

fn item(input: ParseStream, items: &mut Items, errors: &mut Errors) -> syn::Result<End> {
    let docs = docs(input)?;
    if input.parse::<Option<Token![let]>>()?.is_some() {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        items.lets.push(Let {
            name,
            value: input.parse()?,
        });
        return Ok(End::Comma);
    }
    let key: Ident = input.parse().map_err(|e| {
        at(
            e.span(),
            "expected an item of the scene",
            format_args!("known here: {}", ITEMS.join(", ")),
        )
    })?;
    match key.to_string().as_str() {
        "params" => {
            let inner;
            braced!(inner in input);
            each(&inner, errors, |input, _| {
                items.params.push(named(input, &mut items.unread)?);
                Ok(End::Comma)
            });
            return Ok(End::Braces);
        }
        "gravity" => {
            input.parse::<Token![:]>()?;
            once(&mut items.gravity, input.parse()?, &key)?;
        }
        "input" => {
            let mut input = named::<Input>(input, &mut items.unread)?;
            input.docs = docs;
            items.inputs.push(input);
        }
        "shape" => {
            items.shapes.push(body::shape(input, errors)?);
            return Ok(End::Braces);
        }
        "body" => {
            items.bodies.push(body::body(input, errors)?);
            return Ok(End::Braces);
        }
        "generate" => {
            input.parse::<Token![:]>()?;
            let inner;
            bracketed!(inner in input);
            let list = inner.parse_terminated(Ident::parse, Token![,])?;
            once(&mut items.generate, list.into_iter().collect(), &key)?;
        }
        other => {
            return Err(at(
                key.span(),
                format_args!("unknown item `{other}`"),
                suggestion(other, ITEMS),
            ));
        }
    }
    Ok(End::Comma)
}

/// Reads something that begins with its name. The name is kept even if the rest is wrong, so that its uses are no errors too.
fn named<T: Parse>(input: ParseStream, unread: &mut Vec<Ident>) -> syn::Result<T> {
    let ahead = input.fork();
    let read = input.parse();
    if read.is_err()
        && docs(&ahead).is_ok()
        && let Ok(name) = ahead.parse()
    {
        unread.push(name);
    }
    read
}

impl Parse for Input {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![:]>()?;
        Ok(Self {
            docs: Vec::new(),
            name,
            unit: input.parse()?,
        })
    }
}

impl Parse for Param {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let docs = docs(input)?;
        let name: Ident = input.parse().map_err(|e| {
            at(
                e.span(),
                "expected the name of a parameter",
                "write `name: unit = default`",
            )
        })?;
        if !input.peek(Token![:]) {
            return Err(at(
                name.span(),
                format_args!("parameter `{name}` has no unit"),
                format_args!("write `{name}: kg`, or `{name}: 1` for a plain number"),
            ));
        }
        input.parse::<Token![:]>()?;
        let unit = input.parse()?;
        let default = if input.parse::<Option<Token![=]>>()?.is_some() {
            Some(input.parse()?)
        } else {
            None
        };
        Ok(Self {
            docs,
            name,
            unit,
            default,
        })
    }
}
