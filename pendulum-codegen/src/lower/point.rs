//! Points of bodies.

use std::collections::BTreeMap;

use proc_macro2::Span;
use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::measure::{Measure, Quantity};
use super::scope::Kind;
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Expr, SymbolKind};
use crate::model::{self, BodyId};
use crate::screw::Vec3;

/// A declared point, before the place of its body is known.
#[derive(Clone, Debug)]
pub(super) struct Declared<'g> {
    /// Index of the declared body; none for ground.
    pub(super) body: Option<usize>,
    /// True if the body can move.
    pub(super) moves: bool,
    position: Vec3<'g>,
    velocity: Vec3<'g>,
}

impl<'g> Declared<'g> {
    /// Symbols of the position, and of the velocity.
    pub(super) fn symbols(&self) -> [Vec3<'g>; 2] {
        [self.position, self.velocity]
    }
}

impl<'g> Lower<'g> {
    /// Declares the names of points, and the symbols that represent their coordinates until all bodies are known.
    pub(super) fn declare_points(&mut self, items: &ast::Items) {
        let (points, bodies, moves) = (&items.points, &items.bodies, moving(items));
        for point in points {
            let name = point.name.to_string();
            self.names
                .declare(&mut self.errors, Kind::Point, &point.name, (Measure::Unknown, None));
            let body = self
                .read(&point.body)
                .cloned()
                .and_then(|body| self.body_named(&body, bodies));
            let first = 3 * self.points.len();
            let axes = ["x", "y", "z"].map(|axis| format!("{name}.{axis}"));
            let symbols = |form: fn(&str) -> String, kind: fn(usize) -> SymbolKind| {
                let symbol = |n: usize| self.graph.symbol(&form(&axes[n]), kind(first + n));
                Vec3([symbol(0), symbol(1), symbol(2)])
            };
            let position = symbols(str::to_owned, SymbolKind::Point);
            let velocity = symbols(|axis| format!("dot({axis})"), SymbolKind::PointRate);
            match body {
                Ok(body) => {
                    let moves = body.is_some_and(|body| moves[body]);
                    let declared = Declared {
                        body,
                        moves,
                        position,
                        velocity,
                    };
                    self.points.insert(name, declared);
                }
                Err(reported) => _ = self.broken.insert(name, reported),
            }
        }
    }

    /// Lowers the points with their bodies. Points with an error are left out.
    pub(super) fn points(&mut self, points: &[ast::Point]) -> Vec<model::Point<'g>> {
        let mut placed = Vec::new();
        for point in points {
            let name = point.name.to_string();
            let place = Place::fixed(format!("the position of `{}`", point.name)).in_unit("m");
            let at = match &point.at {
                Some(at) => self.read(at).and_then(|at| self.vector(at, &place)),
                None => Ok(Vec3::zero(self.graph)),
            };
            let (Some(declared), Ok(at)) = (self.points.get(&name).cloned(), at) else {
                continue;
            };
            let Some(body) = self.placed(declared.body) else {
                continue;
            };
            placed.push(model::Point {
                name,
                place: model::Place { body, at },
                moves: declared.moves,
                position: declared.position,
                velocity: declared.velocity,
            });
        }
        placed
    }

    /// Index in the model of a declared body: `Some(None)` for ground, and none if the body has an error.
    pub(super) fn placed(&self, body: Option<usize>) -> Option<Option<BodyId>> {
        match body {
            Some(body) => self.bodies.get(body).copied().flatten().map(Some),
            None => Some(None),
        }
    }

    /// Index of a declared body; none for ground.
    pub(super) fn body_named(&mut self, name: &Ident, bodies: &[ast::Body]) -> Result<Option<usize>, Reported> {
        if name == "ground" {
            return Ok(None);
        }
        if let Some(n) = bodies.iter().position(|body| body.name == *name) {
            return Ok(Some(n));
        }
        let text = name.to_string();
        if let (Some(kind), Some(owner)) = (self.names.kind(&text), self.owner(name, bodies)) {
            let fact = format_args!("`{name}` is {}, not a body", kind.one());
            let help = format_args!("write `{owner}`, the body that it belongs to");
            return Err(self.errors.at(Code::WrongKind, name.span(), fact, help));
        }
        let known: Vec<String> = bodies.iter().map(|body| body.name.to_string()).collect();
        let known = known.iter().map(String::as_str).chain(["ground"]);
        let fact = format_args!("no body named `{name}`");
        Err(self.errors.unknown(Code::UnknownName, name, fact, known, &[]))
    }

    /// Name of the body that has a point, coordinate, orientation or position of this name.
    fn owner(&self, name: &Ident, bodies: &[ast::Body]) -> Option<String> {
        if let Some(point) = self.points.get(&name.to_string()) {
            return Some(point.body.map_or("ground".to_owned(), |n| bodies[n].name.to_string()));
        }
        let has = |body: &&ast::Body| {
            let ast::BodyFields {
                coordinate,
                orientation,
                position,
                ..
            } = &body.fields;
            [coordinate, orientation, position].contains(&&Some(name.clone()))
        };
        bodies.iter().find(has).map(|body| body.name.to_string())
    }

    /// Looks up a declared point, and marks it as used.
    pub(super) fn point_named(&mut self, name: &Ident) -> Result<Declared<'g>, Reported> {
        let text = name.to_string();
        self.names.mark_used(&text);
        if let Some(point) = self.points.get(&text) {
            return Ok(point.clone());
        }
        if let Some(reported) = self.broken.get(&text) {
            return Err(*reported);
        }
        if let Some(kind) = self.names.kind(&text) {
            let fact = format_args!("`{text}` is {}, not a point", kind.one());
            let help = format_args!("declare a point: `point {text}_end on body at [x, y, z],`");
            return Err(self.errors.at(Code::WrongKind, name.span(), fact, help));
        }
        let fact = format_args!("no point named `{text}`");
        if text == "ground" || self.body_names.contains(&text) {
            let help =
                format_args!("`{text}` is a body: declare a point on it, `point {text}_end on {text} at [x, y, z],`");
            return Err(self.errors.at(Code::WrongKind, name.span(), fact, help));
        }
        let known: Vec<String> = self.points.keys().cloned().collect();
        if known.is_empty() {
            let help = format_args!("declare it: `point {text} on body at [x, y, z],`");
            return Err(self.errors.at(Code::UnknownName, name.span(), fact, help));
        }
        Err(self
            .errors
            .unknown(Code::UnknownName, name, fact, known.iter().map(String::as_str), &[]))
    }

    /// `point.x`, `orientation.w` or `position.x`
    pub(super) fn component(
        &mut self,
        point: &Ident,
        axis: &Ident,
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        if let Some(found) = self.component_of_joint(point, axis) {
            let quantity = found?;
            self.permit(quantity.value, point.span(), place)?;
            return Ok(quantity);
        }
        if let Some(kind) = self.names.kind(&point.to_string()).filter(|kind| *kind != Kind::Point) {
            let fact = format_args!("`{point}` is {}, and only points have components", kind.one());
            let help = format_args!("`dot({point})` is the rate of `{point}`; a point `p` has `p.x`, `p.y` and `p.z`");
            return Err(self.errors.at(Code::WrongKind, point.span(), fact, help));
        }
        let declared = self.point_named(point)?;
        let Some(n) = ["x", "y", "z"].iter().position(|known| axis == known) else {
            let fact = format_args!("a point has no component `{axis}`");
            let help = format_args!("write `{point}.x`, `{point}.y` or `{point}.z`");
            return Err(self.errors.at(Code::UnknownName, axis.span(), fact, help));
        };
        Ok(Quantity {
            value: self.permit(declared.position[n], point.span(), place)?,
            measure: Measure::of("m"),
        })
    }

    /// `distance(a, b)`
    pub(super) fn distance(
        &mut self,
        expr: &ast::Expr,
        arguments: &[ast::Expr],
        place: &Place<'g>,
    ) -> Result<Expr<'g>, Reported> {
        let name = |argument: &ast::Expr| match &argument.kind {
            ast::ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        };
        let names: Option<Vec<Ident>> = arguments.iter().map(name).collect();
        let Some([first, second]) = names.as_deref().and_then(|names| <&[Ident; 2]>::try_from(names).ok()) else {
            let fact = "`distance` takes the names of two points";
            return Err(self.errors.on(Code::Arguments, expr, fact, "write `distance(a, b)`"));
        };
        let [a, b] = self.ends([first, second], expr.span())?;
        let square = self.permit(square_of(b.position - a.position), expr.span(), place)?;
        Ok(square.sqrt())
    }

    /// Looks up two points, which must differ.
    pub(super) fn ends(&mut self, [first, second]: [&Ident; 2], span: Span) -> Result<[Declared<'g>; 2], Reported> {
        let (a, b) = (self.point_named(first), self.point_named(second));
        let ends = [a?, b?];
        if first == second {
            let fact = format_args!("both points are `{first}`");
            return Err(self.errors.at(Code::Arguments, span, fact, "name two different points"));
        }
        Ok(ends)
    }
}

/// `v . v`
pub(super) fn square_of(v: Vec3<'_>) -> Expr<'_> {
    v.dot(v)
}

/// True for each body with a moving joint between it and ground.
fn moving(items: &ast::Items) -> Vec<bool> {
    let bodies = &items.bodies;
    let names: BTreeMap<&Ident, usize> = bodies
        .iter()
        .enumerate()
        .map(|(n, body)| (&body.name, n))
        .rev()
        .collect();
    let parent = |body: &ast::Body| names.get(body.parent.as_ref().ok()?).copied();
    let parents: Vec<Option<usize>> = bodies.iter().map(parent).collect();
    let own = |body: &ast::Body| body.fields.moves() || items.is_driven(body) || items.follows(body);
    let mut moves: Vec<bool> = bodies.iter().map(own).collect();
    loop {
        let before = moves.clone();
        for (n, parent) in parents.iter().enumerate() {
            moves[n] |= parent.is_some_and(|parent| moves[parent]);
        }
        if moves == before {
            return moves;
        }
    }
}
