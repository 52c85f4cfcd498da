//! Bodies and shapes, and their fields.

use syn::parse::{Parse, ParseStream};
use syn::{Ident, Token, braced, parenthesized, token};

use super::argument::Argument;
use super::joint::joint;
use super::solid::solids;
use super::{End, docs, each, expr, once};
use crate::ast::{Body, BodyFields, Inertia, Properties, Shape};
use crate::error::{Errors, at, on, suggestion};

/// A field that is being read into a `T`, after its name and the colon.
struct Field<'a> {
    input: ParseStream<'a>,
    key: &'a Ident,
    /// The body or shape.
    owner: &'a Ident,
}

/// The name of a field, and how it is read.
type Row<T> = (&'static str, fn(&Field, &mut T) -> syn::Result<()>);

/// The fields of shapes, and of bodies too.
const PROPERTIES: [Row<Properties>; 4] = [
    ("mass", |field, properties| field.value(&mut properties.mass)),
    ("com", |field, properties| field.value(&mut properties.com)),
    ("inertia", |field, properties| field.value(&mut properties.inertia)),
    ("solids", |field, properties| {
        let solids = solids(field.input, field.owner)?;
        once(&mut properties.solids, solids, field.key)
    }),
];

/// The other fields of bodies.
const BODY_FIELDS: [Row<BodyFields>; 5] = [
    ("joint", |field, body| {
        let joint = joint(field.input, field.owner)?;
        once(&mut body.joint, joint, field.key)
    }),
    ("coordinate", |field, body| field.coordinate(body)),
    ("friction", |field, body| field.value(&mut body.friction)),
    ("spring", |field, body| field.spring(body)),
    ("torque", |field, body| field.value(&mut body.torque)),
];

/// `name on parent: shape { fields }`, after the word `body`
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
    let mut fields = BodyFields::default();
    let unread = each(&inner, errors, |input, _| body_field(input, &name, &mut fields));
    Ok(Body {
        name,
        parent,
        shape,
        fields,
        unread,
    })
}

/// `name { fields }`, after the word `shape`
pub(super) fn shape(input: ParseStream, errors: &mut Errors) -> syn::Result<Shape> {
    let name = input.parse()?;
    let inner;
    braced!(inner in input);
    let mut properties = Properties::default();
    let unread = each(&inner, errors, |input, _| shape_field(input, &name, &mut properties));
    Ok(Shape {
        name,
        properties,
        unread,
    })
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

fn shape_field(input: ParseStream, owner: &Ident, properties: &mut Properties) -> syn::Result<End> {
    let key = key(input, &PROPERTIES.map(|(name, _)| name))?;
    let field = Field {
        input,
        key: &key,
        owner,
    };
    field.read(&PROPERTIES, properties)?;
    Ok(End::Comma)
}

fn body_field(input: ParseStream, owner: &Ident, body: &mut BodyFields) -> syn::Result<End> {
    let (properties, others) = (PROPERTIES.map(|(name, _)| name), BODY_FIELDS.map(|(name, _)| name));
    let key = key(input, &[&properties[..], &others].concat())?;
    let field = Field {
        input,
        key: &key,
        owner,
    };
    field.read(&PROPERTIES, &mut body.properties)?;
    field.read(&BODY_FIELDS, body)?;
    Ok(End::Comma)
}

impl Field<'_> {
    /// Reads the field by its row, if it has one here.
    fn read<T>(&self, rows: &[Row<T>], target: &mut T) -> syn::Result<()> {
        let row = rows.iter().find(|(name, _)| self.key == name);
        row.map_or(Ok(()), |(_, read)| read(self, target))
    }

    fn value<T: Parse>(&self, place: &mut Option<T>) -> syn::Result<()> {
        once(place, self.input.parse()?, self.key)
    }

    fn coordinate(&self, body: &mut BodyFields) -> syn::Result<()> {
        self.value(&mut body.coordinate)?;
        if self.input.peek(Ident) {
            let word: Ident = self.input.parse()?;
            if word != "absolute" {
                return Err(at(
                    word.span(),
                    format_args!("unexpected `{word}` behind the coordinate"),
                    "the only word that may stand here is `absolute`",
                ));
            }
            body.absolute = Some(word);
        }
        Ok(())
    }

    fn spring(&self, body: &mut BodyFields) -> syn::Result<()> {
        if !self.input.peek(token::Paren) {
            return Err(at(
                self.input.span(),
                "a spring has a stiffness and a rest position",
                "write `spring: (stiffness, rest)`",
            ));
        }
        let inner;
        parenthesized!(inner in self.input);
        let stiffness = inner.parse()?;
        inner.parse::<Token![,]>()?;
        let rest = inner.parse()?;
        expr::end_of(&inner)?;
        once(&mut body.spring, (stiffness, rest), self.key)
    }
}

impl Parse for Inertia {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let (entries, tokens) = match input.parse()? {
            Argument::Scalar(scalar) => (vec![scalar], None),
            Argument::List(entries, tokens) => (entries, Some(tokens)),
            Argument::Points(_, tokens) => {
                let help =
                    "write the six `[ixx, iyy, izz, ixy, ixz, iyz]`, with the off-diagonal entries of the matrix";
                return Err(on(tokens, "an inertia is not written as a matrix", help));
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
