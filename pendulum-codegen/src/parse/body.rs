//! Bodies and shapes, and their fields.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseBuffer, ParseStream};
use syn::token::{Brace, Bracket};
use syn::{Ident, Token};

use super::argument::Argument;
use super::joint::joint;
use super::solid::solids;
use super::token::{braces, colon, identifier, is_field, list, parentheses, starts_item};
use super::{End, ITEMS, docs, each, once, skip_to};
use crate::ast::{Body, BodyFields, Expr, Inertia, Properties, Read, Shape, Vector};
use crate::error::{Code, Errors, at, on};
use crate::words::{self, Advice, advice};

/// A field to be parsed into a `T`, after its name and the colon.
struct Field<'a> {
    input: ParseStream<'a>,
    key: &'a Ident,
    /// The body or shape.
    owner: &'a Ident,
}

/// Name of a field, and its parser.
type Row<T> = (&'static str, fn(&Field, &mut T) -> syn::Result<()>);

/// Fields of shapes and bodies.
const PROPERTIES: [Row<Properties>; 4] = [
    ("mass", |field, properties| field.value(&mut properties.mass)),
    ("com", |field, properties| field.value(&mut properties.com)),
    ("inertia", |field, properties| field.value(&mut properties.inertia)),
    ("solids", |field, properties| {
        let solids = solids(field.input, field.owner)?;
        once(&mut properties.solids, solids, field.key)
    }),
];

/// Fields of bodies only.
const BODY_FIELDS: [Row<BodyFields>; 11] = [
    ("joint", |field, body| {
        let joint = joint(field.input, field.owner)?;
        once(&mut body.joint, joint, field.key)
    }),
    ("coordinate", |field, body| field.coordinate(body)),
    ("orientation", |field, body| {
        let own = (&mut body.orientation, &mut body.turned);
        field.name(own, "an orientation", "orientation: o near [roll, pitch, yaw]")
    }),
    ("position", |field, body| {
        let own = (&mut body.position, &mut body.placed);
        field.name(own, "a position", "position: p near [x, y, z]")
    }),
    ("motion", |field, body| field.value(&mut body.motion)),
    ("friction", |field, body| field.value(&mut body.friction)),
    ("spring", |field, body| field.spring(body)),
    ("torque", |field, body| {
        if field.input.peek(Bracket) {
            let help = "write one number, the torque about the joint axis; a moment `m` about the x axis of a body \
                        with the orientation `o` is `dissipation: -m*dot(o).x,` among the items of the scene";
            return Err(at(
                Code::Arguments,
                field.key.span(),
                "a torque is a number, not a list",
                help,
            ));
        }
        field.value(&mut body.torque)
    }),
    ("dry_friction", |field, body| field.value(&mut body.dry_friction)),
    ("static_friction", |field, body| field.value(&mut body.static_friction)),
    ("stop", |field, body| field.value(&mut body.stop)),
];

/// Help text on replacing a ball joint that depends on a closed loop by hinges.
pub(crate) const HINGES: &str = "close the loop by one of its ball joints, `close a at [..] to b at [..]: ball`, \
                                 and replace each other ball joint by three revolute joints on massless bodies: \
                                 `joint: revolute(x), coordinate: u depends near 0.3`, then one about y, and one \
                                 about z";

fn names<T>(rows: &'static [Row<T>]) -> impl Iterator<Item = &'static str> {
    rows.iter().map(|(name, _)| *name)
}

/// `name on parent: shape { fields }`, after the word `body`
pub(super) fn body(input: ParseStream, errors: &mut Errors) -> syn::Result<Body> {
    let name = identifier(input, "the name of a body", "body name on ground { .. }")?;
    let parent = parent(input, &name);
    let mut shape = None;
    if input.parse::<Option<Token![:]>>()?.is_some() && !input.peek(Brace) {
        let word = identifier(
            input,
            "the name of a shape",
            &format!("body {name} on ground: shape {{ .. }}"),
        )?;
        // without a parent, this word may be the parent
        shape = parent.is_ok().then_some(word);
    }
    let form = format!("body {name} on ground {{ joint: .., coordinate: .. }}");
    let inner = fields_of(input, &format!("the fields of body `{name}`"), &form, errors)?;
    let mut fields = BodyFields::default();
    let unread = each(&inner, errors, |input, errors| {
        body_field(input, &name, &mut fields, errors)
    });
    Ok(Body {
        name,
        parent,
        shape,
        fields,
        unread,
    })
}

/// `on parent`
fn parent(input: ParseStream, name: &Ident) -> Read<Ident> {
    let on: Option<Ident> = input.parse()?;
    if on.as_ref().is_some_and(|on| on == "on") {
        return identifier(
            input,
            "the parent of the body",
            &format!("body {name} on ground {{ .. }}"),
        );
    }
    skip_to(input, |input| input.peek(Brace) || input.peek(Token![:]));
    if name == "on" {
        return Err(at(
            Code::Syntax,
            name.span(),
            "the body has no name",
            "write `body name on ground { .. }`",
        ));
    }
    let help = format!("write `body {name} on ground {{ .. }}`, or another parent after `on`");
    let fact = format_args!("body `{name}` has no parent");
    Err(at(Code::Syntax, name.span(), fact, help))
}

/// `name { fields }`, after the word `shape`
pub(super) fn shape(input: ParseStream, errors: &mut Errors) -> syn::Result<Shape> {
    let name = identifier(input, "the name of a shape", "shape name { mass: .. }")?;
    let form = format!("shape {name} {{ mass: .. }}");
    let inner = fields_of(input, &format!("the fields of shape `{name}`"), &form, errors)?;
    let mut properties = Properties::default();
    let unread = each(&inner, errors, |input, errors| {
        shape_field(input, &name, &mut properties, errors)
    });
    Ok(Shape {
        name,
        properties,
        unread,
    })
}

/// Parses the braces; reports and skips other tokens before them.
fn fields_of<'a>(input: &ParseBuffer<'a>, what: &str, form: &str, errors: &mut Errors) -> syn::Result<ParseBuffer<'a>> {
    braces(input, what, form).or_else(|error| {
        skip_to(input, |input| input.peek(Brace));
        if input.peek(Brace) {
            errors.push(error.clone());
        }
        braces(input, what, form).map_err(|_| error)
    })
}

/// Parses the name of a field and the colon. If a wrong name has an obvious meaning, reports it and returns the
/// intended one.
fn key(input: ParseStream, owner: &Ident, known: &[&'static str], errors: &mut Errors) -> syn::Result<Ident> {
    docs(input)?;
    let mut key = input.call(Ident::parse_any).map_err(|e| {
        let help = format_args!("known here: {}", known.join(", "));
        at(Code::Syntax, e.span(), "expected a field", help)
    })?;
    let text = key.to_string();
    if !known.contains(&text.as_str()) {
        // in a body, `force: e` means the force of its joint
        let means_field = input.peek(Token![:]) && words::synonym(&text, words::FIELDS).is_some();
        if ITEMS.contains(&text.as_str()) && text != "let" && !means_field {
            let help = format!("write it outside of the braces of `{owner}`");
            let fact = format_args!("`{text}` is an item of the scene");
            return Err(at(Code::Misplaced, key.span(), fact, help));
        }
        if is_field(&text) {
            let help = "a shape has mass properties only; write it in the braces of a body";
            let fact = format_args!("`{text}` is a field of a body");
            return Err(at(Code::Misplaced, key.span(), fact, help));
        }
        let Advice { meant, help } = advice(&text, known.iter().copied(), words::FIELDS);
        let fact = format_args!("unknown field `{text}`");
        let error = at(Code::UnknownWord, key.span(), fact, help);
        let meant = meant.ok_or_else(|| error.clone())?;
        errors.push(error);
        key = Ident::new(meant, key.span());
    }
    colon(input, &key, errors)?;
    Ok(key)
}

fn shape_field(
    input: ParseStream,
    owner: &Ident,
    properties: &mut Properties,
    errors: &mut Errors,
) -> syn::Result<End> {
    let known: Vec<_> = names(&PROPERTIES).collect();
    let key = key(input, owner, &known, errors)?;
    let field = Field {
        input,
        key: &key,
        owner,
    };
    field.read(&PROPERTIES, properties)?;
    Ok(End::Comma)
}

fn body_field(input: ParseStream, owner: &Ident, body: &mut BodyFields, errors: &mut Errors) -> syn::Result<End> {
    let known: Vec<_> = names(&PROPERTIES).chain(names(&BODY_FIELDS)).collect();
    let key = key(input, owner, &known, errors)?;
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
    /// Parses the field with its parser in `rows`, if it has one there.
    fn read<T>(&self, rows: &[Row<T>], target: &mut T) -> syn::Result<()> {
        let row = rows.iter().find(|(name, _)| self.key == name);
        row.map_or(Ok(()), |(_, read)| read(self, target))
    }

    fn value<T: Parse>(&self, place: &mut Option<T>) -> syn::Result<()> {
        once(place, self.input.parse()?, self.key)
    }

    /// Parses the name of an orientation or a position, and its guess; `guessed` is the syntax with the guess.
    fn name(
        &self,
        (place, near): (&mut Option<Ident>, &mut Option<Vector>),
        what: &str,
        guessed: &str,
    ) -> syn::Result<()> {
        let form = guessed.split(" near").next().unwrap_or(guessed);
        if self.input.peek(Bracket) {
            let fact = format_args!("expected a name for the {}", self.key);
            let place = if self.key == "position" {
                "at [x, y, z]"
            } else {
                "rpy [roll, pitch, yaw]"
            };
            let help = format!(
                "write `{form}`; the initial condition is an argument of `solve`, and an offset of the joint frame \
                 is `joint: .. {place}`"
            );
            return Err(at(Code::Syntax, self.key.span(), fact, help));
        }
        let name = identifier(self.input, &format!("the name of {what}"), form)?;
        if self.input.peek(Ident) && !starts_item(self.input) {
            let word: Ident = self.input.parse()?;
            // stored so that its uses are not reported too
            once(place, name, self.key)?;
            return Err(match word.to_string().as_str() {
                "depends" if self.key == "position" => {
                    let help = "replace the joint by prismatic and revolute joints on massless bodies: `joint: \
                                prismatic(x), coordinate: u depends near 0.3`, and so on";
                    let fact = format_args!("{what} cannot be marked `depends`");
                    at(Code::FreeRotation, word.span(), fact, help)
                }
                "depends" => at(
                    Code::FreeRotation,
                    word.span(),
                    format_args!("{what} cannot be marked `depends`"),
                    HINGES,
                ),
                "near" if self.input.peek(Bracket) => return once(near, self.input.parse()?, &word),
                "near" => {
                    let fact = format_args!("the guess for {what} takes three numbers");
                    at(Code::Arguments, word.span(), fact, format_args!("write `{guessed}`"))
                }
                _ => {
                    let fact = format_args!("unexpected `{word}` after the {}", self.key);
                    let help = format_args!("write `{form}`, and a comma");
                    at(Code::Syntax, word.span(), fact, help)
                }
            });
        }
        once(place, name, self.key)
    }

    fn coordinate(&self, body: &mut BodyFields) -> syn::Result<()> {
        let coordinate = identifier(self.input, "the name of a coordinate", "coordinate: theta")?;
        once(&mut body.coordinate, coordinate, self.key)?;
        while self.input.peek(Ident) && !starts_item(self.input) {
            let word: Ident = self.input.parse()?;
            match word.to_string().as_str() {
                "absolute" => once(&mut body.absolute, word.clone(), &word)?,
                "depends" => once(&mut body.depends, word.clone(), &word)?,
                "near" => once(&mut body.near, self.input.parse()?, &word)?,
                _ => {
                    let fact = format_args!("unexpected `{word}` after the coordinate");
                    let help = "a coordinate is relative to the parent, or measured from ground with `absolute`; \
                                `depends near 0.3` marks one that closed loops determine";
                    return Err(at(Code::Syntax, word.span(), fact, help));
                }
            }
        }
        Ok(())
    }

    fn spring(&self, body: &mut BodyFields) -> syn::Result<()> {
        let form = "spring: (stiffness, rest)";
        let span = self.input.span();
        let numbers = match parentheses(self.input)? {
            Some(inner) => list(&inner, form, Expr::parse)?,
            None => Vec::new(),
        };
        let [stiffness, rest] = <[Expr; 2]>::try_from(numbers).map_err(|_| {
            let help = format_args!("write `{form}`");
            let fact = "a spring takes a stiffness and a rest position";
            at(Code::Arguments, span, fact, help)
        })?;
        once(&mut body.spring, (stiffness, rest), self.key)
    }
}

impl Parse for Inertia {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let (entries, tokens) = match input.parse()? {
            Argument::Scalar(scalar) => (vec![scalar], None),
            Argument::List(entries, tokens) => (entries, Some(tokens)),
            Argument::Points(_, tokens) => {
                let help = "write the six entries `[ixx, iyy, izz, ixy, ixz, iyz]` of the matrix";
                let fact = "an inertia is not written as a matrix";
                return Err(on(Code::Arguments, tokens, fact, help));
            }
        };
        let tokens = tokens.unwrap_or_else(|| entries[0].tokens.clone());
        let (mut rpy, mut about_joint) = (None, false);
        while input.peek(Ident) && !starts_item(input) {
            let word: Ident = input.parse()?;
            if word == "rpy" {
                once(&mut rpy, input.parse()?, &word)?;
                continue;
            }
            let joint: Option<Ident> = input.parse()?;
            if word != "about" || joint.is_none_or(|joint| joint != "joint") {
                return Err(at(
                    Code::Syntax,
                    word.span(),
                    format_args!("unexpected `{word}` after the inertia"),
                    "write `rpy [roll, pitch, yaw]`, `about joint`, or nothing for the centre of mass",
                ));
            }
            about_joint = true;
        }
        Ok(Self {
            entries,
            rpy,
            about_joint,
            judged: false,
            tokens,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{BODY_FIELDS, PROPERTIES, names};
    use crate::parse::token::FIELDS;

    #[test]
    fn fields_are_the_words_that_begin_them() {
        assert!(names(&PROPERTIES).chain(names(&BODY_FIELDS)).eq(FIELDS));
    }
}
