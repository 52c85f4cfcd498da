//! Bodies and shapes.

use syn::parse::{Parse, ParseStream};
use syn::{Ident, Token, braced, bracketed, parenthesized, token};

use super::{End, docs, each, once};
use crate::ast::{Argument, Body, Inertia, Joint, JointArgument, Properties, Solid, Vector};
use crate::error::{Errors, at, suggestion};

const SHAPE_FIELDS: [&str; 4] = ["mass", "com", "inertia", "solids"];
const BODY_FIELDS: [&str; 9] = [
    "mass",
    "com",
    "inertia",
    "solids",
    "joint",
    "coordinate",
    "friction",
    "spring",
    "torque",
];

/// `name on parent: shape { fields }`, behind the word `body`
pub(super) fn body(input: ParseStream, errors: &mut Errors) -> syn::Result<Body> {
    let name: Ident = input.parse().map_err(|e| {
        at(
            e.span(),
            "expected the name of a body",
            "write `body name on parent { .. }`",
        )
    })?;
    let on: Option<Ident> = input.parse()?;
    let parent: Option<Ident> = match on {
        Some(on) if on == "on" => input.parse()?,
        _ => None,
    };
    let Some(parent) = parent else {
        let help = format!("write `body {name} on ground {{ .. }}`, or name the body that carries it");
        return Err(at(name.span(), format_args!("body `{name}` hangs on nothing"), help));
    };
    let shape = if input.parse::<Option<Token![:]>>()?.is_some() {
        Some(input.parse()?)
    } else {
        None
    };
    if !input.peek(token::Brace) {
        return Err(at(
            input.span(),
            format_args!("expected the fields of body `{name}`"),
            "write them in braces: `{ joint: .., coordinate: .. }`",
        ));
    }
    let inner;
    braced!(inner in input);
    let mut body = Body {
        name,
        parent,
        shape,
        properties: Properties::default(),
        joint: None,
        coordinate: None,
        absolute: None,
        friction: None,
        spring: None,
        torque: None,
        unread: None,
    };
    body.unread = each(&inner, errors, |input, _| body_field(input, &mut body));
    Ok(body)
}

fn key(input: ParseStream, known: &[&str]) -> syn::Result<Ident> {
    docs(input)?;
    let key: Ident = input.parse().map_err(|e| {
        at(
            e.span(),
            "expected a field",
            format_args!("known here: {}", known.join(", ")),
        )
    })?;
    let text = key.to_string();
    if !known.contains(&text.as_str()) {
        return Err(at(
            key.span(),
            format_args!("unknown field `{text}`"),
            suggestion(&text, known.iter().copied()),
        ));
    }
    input.parse::<Token![:]>()?;
    Ok(key)
}

/// One field of a shape.
pub(super) fn shape_field(input: ParseStream, properties: &mut Properties) -> syn::Result<End> {
    let key = key(input, &SHAPE_FIELDS)?;
    property(input, &key, properties)?;
    Ok(End::Comma)
}

fn body_field(input: ParseStream, body: &mut Body) -> syn::Result<End> {
    let key = key(input, &BODY_FIELDS)?;
    match key.to_string().as_str() {
        "joint" => once(&mut body.joint, input.parse()?, &key)?,
        "coordinate" => {
            once(&mut body.coordinate, input.parse()?, &key)?;
            if input.peek(Ident) {
                let word: Ident = input.parse()?;
                if word != "absolute" {
                    return Err(at(
                        word.span(),
                        format_args!("unexpected `{word}` behind the coordinate"),
                        "the only word that may stand here is `absolute`",
                    ));
                }
                body.absolute = Some(word);
            }
        }
        "friction" => once(&mut body.friction, input.parse()?, &key)?,
        "torque" => once(&mut body.torque, input.parse()?, &key)?,
        "spring" => {
            if !input.peek(token::Paren) {
                return Err(at(
                    input.span(),
                    "a spring has a stiffness and a rest position",
                    "write `spring: (stiffness, rest)`",
                ));
            }
            let inner;
            parenthesized!(inner in input);
            let stiffness = inner.parse()?;
            inner.parse::<Token![,]>()?;
            let rest = inner.parse()?;
            super::expr::end_of(&inner)?;
            once(&mut body.spring, (stiffness, rest), &key)?;
        }
        _ => property(input, &key, &mut body.properties)?,
    }
    Ok(End::Comma)
}

fn property(input: ParseStream, key: &Ident, properties: &mut Properties) -> syn::Result<()> {
    match key.to_string().as_str() {
        "mass" => once(&mut properties.mass, input.parse()?, key),
        "com" => once(&mut properties.com, input.parse()?, key),
        "inertia" => once(&mut properties.inertia, input.parse()?, key),
        _ => {
            if !input.peek(token::Bracket) {
                return Err(at(
                    input.span(),
                    "expected a list of solids",
                    "write `solids: [rod(m, [0, 0, 0], [0, -l, 0])]`",
                ));
            }
            let inner;
            bracketed!(inner in input);
            let solids = inner.parse_terminated(Solid::parse, Token![,])?;
            once(&mut properties.solids, solids.into_iter().collect(), key)
        }
    }
}

impl Parse for Inertia {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let (entries, tokens) = match input.parse()? {
            Argument::Scalar(scalar) => (vec![scalar], None),
            Argument::List(entries, tokens) => (entries, Some(tokens)),
            Argument::Points(_, tokens) => {
                return Err(syn::Error::new_spanned(
                    tokens,
                    "an inertia is not written as a matrix\nhelp: write the six `[ixx, iyy, izz, ixy, ixz, iyz]`, with the off-diagonal entries of the matrix",
                ));
            }
        };
        let tokens = tokens.unwrap_or_else(|| entries[0].tokens.clone());
        let mut about_joint = false;
        if input.peek(Ident) {
            let about: Ident = input.parse()?;
            let joint: Option<Ident> = input.parse()?;
            if about != "about" || joint.is_none_or(|word| word != "joint") {
                return Err(at(
                    about.span(),
                    format_args!("unexpected `{about}` behind the inertia"),
                    "write `about joint`, or nothing for the centre of mass",
                ));
            }
            about_joint = true;
        }
        Ok(Self {
            entries,
            about_joint,
            tokens,
        })
    }
}

impl Parse for Solid {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let kind: Ident = input
            .parse()
            .map_err(|e| at(e.span(), "expected a solid", "write one such as `point(m, [0, -l, 0])`"))?;
        let inner;
        parenthesized!(inner in input);
        let arguments = inner.parse_terminated(Argument::parse, Token![,])?;
        Ok(Self {
            kind,
            arguments: arguments.into_iter().collect(),
        })
    }
}

impl Parse for Joint {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let kind: Ident = input.parse().map_err(|e| {
            at(
                e.span(),
                "expected a joint",
                "write one such as `revolute(z) at [0, 0, 0]`",
            )
        })?;
        let mut arguments = Vec::new();
        if input.peek(token::Paren) {
            let inner;
            parenthesized!(inner in input);
            arguments = inner
                .parse_terminated(JointArgument::parse, Token![,])?
                .into_iter()
                .collect();
        }
        let mut joint = Self {
            kind,
            arguments,
            at: None,
            rpy: None,
        };
        // a word before a colon is the next field, behind a comma that is missing
        while input.peek(Ident) && !input.peek2(Token![:]) {
            let word: Ident = input.parse()?;
            match word.to_string().as_str() {
                "at" => once(&mut joint.at, input.parse::<Vector>()?, &word)?,
                "rpy" => once(&mut joint.rpy, input.parse::<Vector>()?, &word)?,
                other => {
                    return Err(at(
                        word.span(),
                        format_args!("unexpected `{other}` behind the joint"),
                        suggestion(other, ["at", "rpy"]),
                    ));
                }
            }
        }
        Ok(joint)
    }
}

impl Parse for JointArgument {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let ahead = input.fork();
        let negative = ahead.parse::<Option<Token![-]>>()?.is_some();
        if let Ok(name) = ahead.parse::<Ident>()
            && let Some(axis) = ["x", "y", "z"].iter().position(|axis| name == axis)
            && (ahead.is_empty() || ahead.peek(Token![,]))
        {
            input.parse::<Option<Token![-]>>()?;
            input.parse::<Ident>()?;
            return Ok(Self::Axis(axis, negative, name));
        }
        Ok(Self::Other(input.parse()?))
    }
}
