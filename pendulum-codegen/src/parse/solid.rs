//! Solids and their arguments.

use syn::Ident;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};

use super::argument::Argument;
use super::token::{brackets, list, parentheses};
use crate::ast::{Expr, Read, Solid, SolidKind, Vector};
use crate::error::{Code, at, on};
use crate::words::{self, Advice, advice};

/// Word of a solid, its syntax, and the parser of its arguments after the mass: `None` if they do not fit.
type Row = (&'static str, &'static str, fn(&mut Arguments) -> Option<SolidKind>);

const SOLIDS: [Row; 7] = [
    ("point", "point(mass, [x, y, z])", |a| {
        Some(SolidKind::Point { at: a.point()? })
    }),
    ("rod", "rod(mass, [x, y, z], [x, y, z])", |a| {
        let (from, to) = (a.point()?, a.point()?);
        Some(SolidKind::Rod { from, to })
    }),
    ("disk", "disk(mass, radius, [x, y, z])", |a| {
        let (radius, at) = (a.scalar()?, a.point()?);
        Some(SolidKind::Disk { radius, at })
    }),
    ("plate", "plate(mass, [[x, y], [x, y], [x, y]])", |a| a.plate()),
    ("cuboid", "cuboid(mass, [dx, dy, dz], [x, y, z])", |a| {
        let (sides, at) = (a.sides()?, a.point()?);
        Some(SolidKind::Cuboid { sides, at })
    }),
    ("cylinder", "cylinder(mass, radius, [x, y, z], [x, y, z])", |a| {
        let (radius, from, to) = (a.scalar()?, a.point()?, a.point()?);
        Some(SolidKind::Cylinder { radius, from, to })
    }),
    ("sphere", "sphere(mass, radius, [x, y, z])", |a| {
        let (radius, at) = (a.scalar()?, a.point()?);
        Some(SolidKind::Sphere { radius, at })
    }),
];

/// `[solid, solid, ..]` of a body or a shape
pub(super) fn solids(input: ParseStream, owner: &Ident) -> syn::Result<Vec<Read<Solid>>> {
    let form = "solids: [rod(m, [0, 0, 0], [0, -l, 0])]";
    let inner = brackets(input, "a list of solids", form)?;
    let solids = list(&inner, form, call)?.into_iter();
    Ok(solids.map(|(word, arguments)| solid(owner, word, arguments)).collect())
}

fn call(input: ParseStream) -> syn::Result<(Ident, Vec<Argument>)> {
    // any identifier, since `box` is a keyword
    let help = "write one such as `point(m, [0, -l, 0])`";
    let word = input
        .call(Ident::parse_any)
        .map_err(|e| at(Code::Syntax, e.span(), "expected a solid", help))?;
    let known = SOLIDS.into_iter().find(|(known, ..)| word == known);
    let form = known.map_or("point(m, [0, -l, 0])", |(_, form, _)| form);
    let arguments = match parentheses(input)? {
        Some(inner) => list(&inner, form, Argument::parse)?,
        None => Vec::new(),
    };
    Ok((word, arguments))
}

fn solid(owner: &Ident, word: Ident, arguments: Vec<Argument>) -> Read<Solid> {
    let Some((_, form, read)) = SOLIDS.into_iter().find(|(known, ..)| word == known) else {
        let Advice { help, .. } = advice(&word.to_string(), SOLIDS.map(|(known, ..)| known), words::SOLIDS);
        let fact = format_args!("unknown solid `{word}`");
        return Err(at(Code::UnknownWord, word.span(), fact, help));
    };
    let mut arguments = Arguments {
        what: format!("a {word} of `{owner}`"),
        form,
        rest: arguments.into_iter(),
    };
    let wrong = || {
        at(
            Code::Arguments,
            word.span(),
            format_args!("wrong arguments of `{word}`"),
            format_args!("write `{form}`"),
        )
    };
    let mass = arguments.scalar().ok_or_else(wrong)?;
    let kind = read(&mut arguments).filter(|_| arguments.rest.len() == 0);
    let kind = kind.ok_or_else(wrong);
    Ok(Solid { word, mass, kind })
}

/// Arguments of a solid, consumed in order.
struct Arguments {
    /// ``a rod of `arm` ``
    what: String,
    form: &'static str,
    rest: std::vec::IntoIter<Argument>,
}

impl Arguments {
    fn scalar(&mut self) -> Option<Expr> {
        match self.rest.next()? {
            Argument::Scalar(scalar) => Some(scalar),
            _ => None,
        }
    }

    fn point(&mut self) -> Option<Read<Vector>> {
        let argument = self.rest.next()?;
        Some(argument.vector().map_err(|other| {
            let fact = format_args!("expected a point in {}", self.what);
            on(Code::Arguments, other, fact, "write its three coordinates `[x, y, z]`")
        }))
    }

    fn sides(&mut self) -> Option<Read<Vector>> {
        let is_list = matches!(self.rest.as_slice(), [Argument::List(..), ..]);
        if is_list { self.point() } else { None }
    }

    fn plate(&mut self) -> Option<SolidKind> {
        let Argument::Points(points, tokens) = self.rest.next()? else {
            return None;
        };
        let corner = |point: Vec<Expr>| {
            <[Expr; 2]>::try_from(point).map_err(|_| {
                let help = format_args!("write `{}`", self.form);
                let fact = "a corner of a plate has two coordinates";
                on(Code::Arguments, &tokens, fact, help)
            })
        };
        let corners = points.into_iter().map(corner).collect();
        Some(SolidKind::Plate { corners, tokens })
    }
}
