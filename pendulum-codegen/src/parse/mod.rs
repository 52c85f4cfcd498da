//! Parses tokens to a syntax tree. A mistake costs only its item or field: parsing continues after it.

mod action;
mod argument;
mod body;
mod close;
mod declare;
mod expr;
mod foreign;
mod joint;
mod point;
mod robot;
mod solid;
mod state;
mod token;
mod wall;

pub(crate) use body::HINGES;
pub(crate) use token::{is_identifier, starts_item};

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Parser};
use syn::token::Brace;
use syn::{Attribute, Expr, ExprLit, Ident, Lit, Meta, MetaNameValue, Token, Visibility, braced};

use crate::ast::{Body, Head, Items, Read, Scene};
use crate::error::{Code, Errors, Reported, at, on};
use crate::words::{self, Advice, advice};
use token::{brackets, colon, identifier, list, starts_known, unexpected};

/// Names of the items of a scene.
const ITEMS: [&str; 20] = [
    "units",
    "params",
    "gravity",
    "let",
    "input",
    "state",
    "shape",
    "robot",
    "body",
    "point",
    "force",
    "spring",
    "damper",
    "potential",
    "dissipation",
    "output",
    "event",
    "wall",
    "close",
    "generate",
];

/// Maximum nesting of brackets in a declaration. It exceeds the limit for expressions, which has its own message.
const MOST_LEVELS: usize = 256;

/// Names used by the generated code; a scene of this name does not even get a stand-in.
const USED: [&str; 9] = ["T", "N", "M", "D", "bool", "f64", "usize", "__Code", "__Part"];

/// Traits in the prelude of the core; a model of this name would hide the trait and its methods.
const HIDDEN: [&str; 6] = ["Controlled", "Energy", "Ensemble", "Jacobian", "Method", "System"];

/// Parses a declaration. Returns its scene unless the head could not be parsed, and all errors.
pub(crate) fn parse(tokens: TokenStream) -> (Option<Scene>, Errors) {
    let mut errors = Errors::default();
    if let Some(bracket) = too_deep(tokens.clone()) {
        let help = format!("at most {MOST_LEVELS} levels are allowed; name parts of expressions with `let`");
        errors.at(Code::TooLong, bracket, "brackets are nested too deeply", help);
        return (None, errors);
    }
    let clamps = occurrences(tokens.clone(), "clamp");
    let scene = (|whole: ParseStream| {
        // syn reports tokens left in brackets at the end of a stream, but not of a fork; mistakes have their own errors
        let input = &whole.fork();
        whole.parse::<TokenStream>()?;
        let head = head(input)?;
        let name = &head.name;
        if !input.peek(Brace) {
            let (fact, help) = match input.parse::<Ident>() {
                Ok(word) => (
                    "the name of a scene is one word".to_owned(),
                    format!("write `pub {word} {{ body .. }}`"),
                ),
                Err(_) => (
                    format!("`{name}` has no items in braces"),
                    format!("write `{name} {{ body .. }}`"),
                ),
            };
            return Err(at(Code::NoScene, name.span(), fact, help));
        }
        let inner;
        braced!(inner in input);
        let mut items = Items {
            clamps,
            ..Items::default()
        };
        each(&inner, &mut errors, |input, errors| item(input, &mut items, errors));
        if !input.is_empty() {
            let help = "write another `mechanism!` for another scene";
            errors.at(Code::Syntax, input.span(), "one declaration holds one scene", help);
        }
        Ok(Scene { head, items })
    })
    .parse2(tokens);
    let scene = errors.keep(scene).ok();
    (scene, errors)
}

/// Counts the occurrences of a word among the tokens.
fn occurrences(tokens: TokenStream, word: &str) -> usize {
    let of = |token| match token {
        TokenTree::Group(group) => occurrences(group.stream(), word),
        TokenTree::Ident(ident) => usize::from(ident == word),
        _ => 0,
    };
    tokens.into_iter().map(of).sum()
}

/// Parses the bodies of a robot.
pub(crate) fn bodies(tokens: TokenStream, errors: &mut Errors) -> Result<Vec<Body>, Reported> {
    let mut items = Items::default();
    let read = |whole: ParseStream| {
        // forked as in `parse`
        let input = &whole.fork();
        whole.parse::<TokenStream>()?;
        Ok(each(input, errors, |input, errors| item(input, &mut items, errors)))
    };
    let reported = read.parse2(tokens);
    match errors.keep(reported)? {
        Some(reported) => Err(reported),
        None => Ok(items.bodies),
    }
}

/// Returns the first bracket that is nested too deep: `syn` parses brackets by recursion.
fn too_deep(tokens: TokenStream) -> Option<Span> {
    let mut levels = vec![tokens.into_iter()];
    while let Some(level) = levels.last_mut() {
        match level.next() {
            None => _ = levels.pop(),
            Some(TokenTree::Group(group)) if levels.len() > MOST_LEVELS => return Some(group.span_open()),
            Some(TokenTree::Group(group)) => levels.push(group.stream().into_iter()),
            Some(_) => {}
        }
    }
    None
}

fn head(input: ParseStream) -> syn::Result<Head> {
    let docs = docs(input)?;
    let vis = input.parse::<Visibility>().map_err(|error| {
        let fact = "expected the visibility of the scene";
        at(Code::Syntax, error.span(), fact, "write `pub`, `pub(crate)` or nothing")
    })?;
    let (span, ahead) = (input.span(), input.fork().call(Ident::parse_any));
    let unnamed = |help: String| at(Code::NoScene, span, "expected the name of the scene", help);
    let form = "mechanism! { pub DoublePendulum { body .. } }";
    let word = ahead.map_err(|_| unnamed(format!("write `{form}`")))?;
    if ITEMS.iter().any(|item| word == item) {
        let help = "write `mechanism! { pub Name { .. } }`, with the items in the inner braces";
        return Err(at(Code::NoScene, span, "the scene has no name", help));
    }
    if ["struct", "enum", "mod", "fn", "impl", "type"]
        .iter()
        .any(|keyword| word == keyword)
    {
        return Err(unnamed(format!("leave out `{word}`: write `pub Name {{ .. }}`")));
    }
    let name = identifier(input, "the name of the scene", form)?;
    if USED.iter().any(|used| name == used) || name.to_string().starts_with("__X") {
        let fact = format!("`{name}` is reserved for the generated code");
        let help = "choose another name, such as `DoublePendulum`";
        return Err(at(Code::NameTaken, span, fact, help));
    }
    if HIDDEN.iter().any(|hidden| name == hidden) {
        let fact = format!("`{name}` would shadow the trait of `pendulum_core::prelude`, and its methods");
        let help = "choose another name, such as `DoublePendulum`";
        return Err(at(Code::NameTaken, span, fact, help));
    }
    Ok(Head {
        docs,
        vis: vis.into_token_stream(),
        name,
    })
}

/// Delimiter at the end of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Comma,
    /// The item's own braces; a comma may follow.
    Braces,
}

/// Parses items up to the end of the input. After a mistake, skips to the next item. Returns the last error, if any.
fn each(
    input: ParseStream,
    errors: &mut Errors,
    mut item: impl FnMut(ParseStream, &mut Errors) -> syn::Result<End>,
) -> Option<Reported> {
    let mut reported = None;
    while !input.is_empty() {
        let start = input.cursor();
        match item(input, errors).and_then(|end| Ok((end, input.parse::<Option<Token![,]>>()?))) {
            // if only a comma is missing, the next item can be parsed
            Ok((End::Comma, None)) if !input.is_empty() => {
                reported = Some(errors.push(unexpected(input)));
                if !starts_item(input) {
                    skip(input);
                }
            }
            Ok((End::Braces, None)) if input.peek(Token![;]) => {
                reported = Some(errors.push(unexpected(input)));
                skip(input);
            }
            Ok(_) => {}
            Err(error) => {
                reported = Some(errors.push(error));
                if input.cursor() == start {
                    // consume at least one token, or the loop would not end
                    let _ = input.parse::<TokenTree>();
                }
                skip(input);
            }
        }
    }
    reported
}

/// Skips to the next possible start of an item.
fn skip(input: ParseStream) {
    while !starts_known(input)
        && let Ok(token) = input.parse::<TokenTree>()
    {
        match token {
            TokenTree::Punct(end) if [',', ';'].contains(&end.as_char()) => return,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace && !input.peek(Token![else]) => {
                // this cannot fail: the comma is optional
                let _ = input.parse::<Option<Token![,]>>();
                return;
            }
            _ => {}
        }
    }
}

/// Parses a part of an item. After a mistake, skips to the end of the part, where `ends` holds, or of the item.
fn read<T: Parse>(input: ParseStream, ends: impl Fn(ParseStream) -> bool) -> Read<T> {
    input
        .parse()
        .inspect_err(|_| skip_to(input, |input| ends(input) || input.peek(Token![,])))
}

fn skip_to(input: ParseStream, ends: impl Fn(ParseStream) -> bool) {
    while !ends(input) && !starts_item(input) && input.parse::<TokenTree>().is_ok() {}
}

/// Parses the lines of documentation comments; rejects all other attributes.
fn docs(input: ParseStream) -> syn::Result<Vec<String>> {
    const FACT: &str = "only documentation comments are allowed here";
    const HELP: &str = "remove the attribute";
    let line = |attribute: Attribute| match &attribute.meta {
        Meta::NameValue(MetaNameValue {
            path,
            value: Expr::Lit(ExprLit {
                lit: Lit::Str(text), ..
            }),
            ..
        }) if path.is_ident("doc") => Ok(text.value()),
        _ => Err(on(Code::NotInLanguage, attribute, FACT, HELP)),
    };
    let attributes = input.call(Attribute::parse_outer);
    let attributes = attributes.map_err(|error| at(Code::NotInLanguage, error.span(), FACT, HELP))?;
    attributes.into_iter().map(line).collect()
}

/// Stores a value, or rejects it if there already is one.
fn once<T>(place: &mut Option<T>, value: T, key: &Ident) -> syn::Result<()> {
    if place.is_some() {
        return Err(at(
            Code::GivenTwice,
            key.span(),
            format_args!("`{key}` is given twice"),
            "keep one of the two",
        ));
    }
    *place = Some(value);
    Ok(())
}

fn item(input: ParseStream, items: &mut Items, errors: &mut Errors) -> syn::Result<End> {
    let docs = docs(input)?;
    let key = item_key(input, errors)?;
    match key.to_string().as_str() {
        "params" => {
            let inner = declare::params(input, errors)?;
            each(&inner, errors, |input, errors| {
                items.params.push(declare::param(input, errors)?);
                Ok(End::Comma)
            });
            return Ok(End::Braces);
        }
        "units" => {
            colon(input, &key, errors)?;
            once(&mut items.without_units, no_units(input)?, &key)?;
        }
        "let" => items.lets.push(declare::named_expression(input, errors)?),
        "input" => items.inputs.push(declare::input(input, docs, errors)?),
        "state" => {
            items.states.push(state::state(input, docs, errors)?);
            return Ok(End::Braces);
        }
        "gravity" => {
            colon(input, &key, errors)?;
            once(&mut items.gravity, input.parse()?, &key)?;
        }
        "shape" => {
            items.shapes.push(body::shape(input, errors)?);
            return Ok(End::Braces);
        }
        "robot" => {
            colon(input, &key, errors)?;
            once(&mut items.robot, robot::robot(input)?, &key)?;
        }
        "body" => {
            items.bodies.push(body::body(input, errors)?);
            return Ok(End::Braces);
        }
        "point" => items.points.push(point::point(input)?),
        "output" => items.outputs.push(declare::output(input, docs)?),
        "event" => items.events.push(declare::event(input, docs)?),
        "wall" => {
            items.walls.push(wall::wall(input, errors)?);
            return Ok(End::Braces);
        }
        "close" => {
            let closure = close::close(input, key, errors);
            items.unread_closures |= closure.is_err();
            items.closures.push(closure?);
        }
        "force" | "spring" | "damper" | "potential" | "dissipation" => {
            items.actions.push(action::action(input, key, errors)?);
        }
        _ => {
            colon(input, &key, errors)?;
            once(&mut items.generate, (key.clone(), routines(input)?), &key)?;
        }
    }
    Ok(End::Comma)
}

/// `none`, after the word `units`
fn no_units(input: ParseStream) -> syn::Result<()> {
    let word = identifier(input, "`none`", "units: none")?;
    if word != "none" {
        let help = "leave it out: units are SI; `units: none` is for dimensionless equations";
        let fact = format_args!("unknown units `{word}`");
        return Err(at(Code::UnknownWord, word.span(), fact, help));
    }
    Ok(())
}

/// `[routine, ..]`, after the word `generate`
fn routines(input: ParseStream) -> syn::Result<Vec<Ident>> {
    let form = "generate: [rhs, jacobian, energy]";
    let inner = brackets(input, "the routines to generate", form)?;
    list(&inner, form, |input| {
        let word = identifier(input, "the name of a routine", form)?;
        if input.peek(Token![-]) && input.peek2(Ident) {
            let span = input.span();
            input.parse::<Token![-]>()?;
            let rest: Ident = input.parse()?;
            let fact = format_args!("`{word}-{rest}` is not a name");
            return Err(at(Code::Syntax, span, fact, format_args!("write `{word}_{rest}`")));
        }
        Ok(word)
    })
}

/// Parses the first word of an item. If a wrong word has an obvious meaning, reports it and returns the intended word.
fn item_key(input: ParseStream, errors: &mut Errors) -> syn::Result<Ident> {
    let key = input.call(Ident::parse_any).map_err(|e| {
        let help = format_args!("known here: {}", ITEMS.join(", "));
        at(Code::Syntax, e.span(), "expected an item of the scene", help)
    })?;
    let text = key.to_string();
    let is_item = ITEMS.contains(&text.as_str());
    if is_item && !(text == "spring" && input.peek(Token![:])) {
        return Ok(key);
    }
    if token::is_field(&text) {
        let between = match text.as_str() {
            "spring" => ", or `spring between a and b: (stiffness, length)` for one between two points",
            "torque" => {
                "; a moment `m` about the x axis of a body with the orientation `o` is `dissipation: -m*dot(o).x,`"
            }
            _ => "",
        };
        let help = format!("write it in the braces of a body: `body name on ground {{ {text}: .. }}`{between}");
        let fact = format_args!("`{text}` is a field of a body");
        return Err(at(Code::Misplaced, key.span(), fact, help));
    }
    let fact = format!("unknown item `{text}`");
    if input.peek(Token![=]) {
        let help = format!("write `let {text} = ..` to name an expression");
        return Err(at(Code::UnknownWord, key.span(), fact, help));
    }
    let Advice { meant, help } = advice(&text, ITEMS, words::ITEMS);
    let error = at(Code::UnknownWord, key.span(), fact, help);
    let meant = meant.ok_or_else(|| error.clone())?;
    errors.push(error);
    Ok(Ident::new_raw(meant, key.span()).unraw())
}
