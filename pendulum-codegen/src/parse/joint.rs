//! Joints and their arguments.

use syn::parse::{Parse, ParseStream};
use syn::token::Bracket;
use syn::{Ident, Token};

use super::argument::Argument;
use super::once;
use super::token::{identifier, list, parentheses, starts_item};
use crate::ast::{Axis, Expr, Joint, JointKind, Read, Vector};
use crate::error::{Code, at, on};
use crate::words::{self, Advice, advice};

/// Word of a joint, its syntax, and the parser of its arguments: `None` if they do not fit.
type Row = (&'static str, &'static str, fn(&mut Arguments) -> Option<JointKind>);

const JOINTS: [Row; 7] = [
    ("revolute", "revolute(z)", |a| Some(JointKind::Revolute(a.axis()?))),
    ("prismatic", "prismatic(x)", |a| Some(JointKind::Prismatic(a.axis()?))),
    ("helical", "helical(z, pitch)", |a| {
        let (axis, pitch) = (a.axis()?, a.scalar()?);
        Some(JointKind::Helical { axis, pitch })
    }),
    ("screw", "screw([wx, wy, wz, vx, vy, vz])", |a| a.screw()),
    ("ball", "ball", |_| Some(JointKind::Ball)),
    ("free", "free", |_| Some(JointKind::Free)),
    ("fixed", "fixed", |_| Some(JointKind::Fixed)),
];

/// Words of all joints.
fn all() -> [&'static str; 7] {
    JOINTS.map(|(word, ..)| word)
}

/// `kind(arguments) at point rpy angles`
pub(super) fn joint(input: ParseStream, body: &Ident) -> syn::Result<Joint> {
    let mut joint = Joint {
        kind: kind(input, body, "joint: revolute(z) at [0, 0, 0]", &all())?,
        at: None,
        rpy: None,
    };
    // a word before a colon is the next field, after a missing comma
    while input.peek(Ident) && !starts_item(input) {
        let word: Ident = input.parse()?;
        match word.to_string().as_str() {
            "at" => once(&mut joint.at, input.parse::<Vector>()?, &word)?,
            "rpy" => once(&mut joint.rpy, input.parse::<Vector>()?, &word)?,
            other => {
                let fact = format!("unexpected `{other}` after the joint");
                let Advice { help, .. } = advice(other, ["at", "rpy"], words::AFTER_JOINT);
                return Err(at(Code::Syntax, word.span(), fact, help));
            }
        }
    }
    Ok(joint)
}

/// `kind(arguments)`; messages show the syntax `form`, and suggest the `known` joints for an unknown word
pub(super) fn kind(
    input: ParseStream,
    owner: &Ident,
    form: &str,
    known: &[&'static str],
) -> syn::Result<Read<JointKind>> {
    if input.peek(Bracket) {
        let help = "for several axes write a chain of massless bodies, with a joint each; `ball` turns about all axes";
        let fact = "a body has one joint, not a list";
        return Err(at(Code::Arguments, input.span(), fact, help));
    }
    let word = identifier(input, "a joint", form)?;
    let form = JOINTS.into_iter().find(|(known, ..)| word == known);
    let form = form.map_or("revolute(z)", |(_, form, _)| form);
    let arguments = match parentheses(input)? {
        Some(inner) => list(&inner, form, JointArgument::parse)?,
        None => Vec::new(),
    };
    Ok(of_arguments(owner, &word, arguments, known))
}

/// Returns the error for a word that is no joint.
fn unknown(word: &Ident, known: &[&'static str]) -> syn::Error {
    let text = word.to_string();
    let meant = words::synonym(&text, words::JOINTS).filter(|meant| all().contains(meant) && !known.contains(meant));
    let Advice { help, .. } = match meant {
        // a joint that is not allowed here would be no help
        Some(_) => advice("", known.iter().copied(), &[]),
        None => advice(&text, known.iter().copied(), words::JOINTS),
    };
    let fact = format_args!("unknown joint `{word}`");
    at(Code::UnknownWord, word.span(), fact, help)
}

fn of_arguments(body: &Ident, word: &Ident, arguments: Vec<JointArgument>, known: &[&'static str]) -> Read<JointKind> {
    let Some((_, form, read)) = JOINTS.into_iter().find(|(known, ..)| word == known) else {
        return Err(unknown(word, known));
    };
    let mut arguments = Arguments {
        body,
        word,
        rest: arguments.into_iter(),
    };
    let kind = read(&mut arguments).filter(|_| arguments.rest.len() == 0);
    let has_axis = form.contains('(') && !form.contains('[');
    let axis = if has_axis {
        "; an axis is x, y, z, -x, .. or a vector"
    } else {
        ""
    };
    kind.ok_or_else(|| {
        at(
            Code::Arguments,
            word.span(),
            format_args!("wrong arguments of a {word} joint"),
            format_args!("write `{form}`{axis}"),
        )
    })
}

/// An argument of a joint.
enum JointArgument {
    Axis(Axis),
    Other(Argument),
}

impl Parse for JointArgument {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let ahead = input.fork();
        let negative = ahead.parse::<Option<Token![-]>>()?.is_some();
        if let Ok(name) = ahead.parse::<Ident>()
            && let Some(number) = ["x", "y", "z"].iter().position(|axis| name == axis)
            && (ahead.is_empty() || ahead.peek(Token![,]))
        {
            input.parse::<Option<Token![-]>>()?;
            input.parse::<Ident>()?;
            return Ok(Self::Axis(Axis::Unit { number, negative }));
        }
        Ok(Self::Other(input.parse()?))
    }
}

/// Arguments of a joint, consumed in order.
struct Arguments<'a> {
    body: &'a Ident,
    word: &'a Ident,
    rest: std::vec::IntoIter<JointArgument>,
}

impl Arguments<'_> {
    fn scalar(&mut self) -> Option<Expr> {
        match self.rest.next()? {
            JointArgument::Other(Argument::Scalar(scalar)) => Some(scalar),
            _ => None,
        }
    }

    fn axis(&mut self) -> Option<Read<Axis>> {
        let argument = match self.rest.next()? {
            JointArgument::Axis(axis) => return Some(Ok(axis)),
            JointArgument::Other(argument) => argument,
        };
        Some(match argument.vector() {
            Ok(vector) => Ok(Axis::Vector(Box::new(vector))),
            Err(Argument::Scalar(e)) => Err(on(
                Code::Arguments,
                e,
                format_args!("invalid axis of the joint of `{}`", self.body),
                "an axis is x, y, z, -x, -y, -z or a vector `[x, y, z]`",
            )),
            Err(_) => Err(at(
                Code::Arguments,
                self.word.span(),
                format_args!("the axis of the joint of `{}` is not a vector", self.body),
                "write `[x, y, z]`",
            )),
        })
    }

    fn screw(&mut self) -> Option<JointKind> {
        let JointArgument::Other(Argument::List(entries, tokens)) = self.rest.next()? else {
            return None;
        };
        let components = entries.try_into().ok()?;
        Some(JointKind::Screw { components, tokens })
    }
}
