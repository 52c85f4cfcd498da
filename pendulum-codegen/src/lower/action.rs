//! Forces, potentials and dissipation other than those of the joints.

use proc_macro2::Span;
use syn::Ident;

use super::Lower;
use super::expr::{Only, Place};
use super::joint_units::JointUnits;
use super::point::{Declared, square_of};
use super::scope::Kind;
use super::written::written;
use crate::ast::{self, ActionKind, Read};
use crate::error::{Code, Reported};
use crate::expr::{Expr, SymbolKind, ratio};
use crate::model::{self, Action, CoordinateId, Point, Push, Requirement};
use crate::screw::Vec3;

impl<'g> Lower<'g> {
    /// Lowers the actions of a scene with the given points. Actions with an error are left out.
    pub(super) fn actions(&mut self, items: &ast::Items, points: &[Point<'g>]) -> Vec<Action<'g>> {
        let mut actions = Vec::new();
        for action in &items.actions {
            actions.extend(self.action(action, items, points).ok().flatten());
        }
        actions
    }

    /// Lowers an action; none if it needs a body that has an error.
    fn action(
        &mut self,
        action: &ast::Action,
        items: &ast::Items,
        points: &[Point<'g>],
    ) -> Result<Option<Action<'g>>, Reported> {
        let place_of = |name: &Ident| points.iter().find(|point| name == &point.name).map(|point| point.place);
        match &action.kind {
            ActionKind::Potential(e) => self.potential(e).map(Some),
            ActionKind::Dissipation(e) => self.dissipation(e).map(Some),
            ActionKind::Along { coordinate, force } => self.along(coordinate, force, items).map(Some),
            ActionKind::Push { point, force, frame } => {
                let (force, frame) = self.push(point, force, frame.as_ref(), &items.bodies)?;
                let whole = place_of(point).zip(self.placed(frame));
                Ok(whole.map(|(place, frame)| Action::Push(Push { place, force, frame })))
            }
            ActionKind::Spring { ends: [a, b], law } => {
                let (factor, potential) = self.spring_between([a, b], action.word.span(), law)?;
                Ok(between([place_of(a), place_of(b)], factor, Some(potential)))
            }
            ActionKind::Damper {
                ends: [a, b],
                coefficient,
            } => {
                let factor = self.damper_between([a, b], action.word.span(), coefficient)?;
                Ok(between([place_of(a), place_of(b)], factor, None))
            }
        }
    }

    fn potential(&mut self, e: &ast::Expr) -> Result<Action<'g>, Reported> {
        let place = Place {
            only: Only::Positions,
            ..Place::moving("a potential energy").in_unit("J")
        };
        let value = self.expr(e, &place)?;
        self.smooth(e, value, 1, &place, "force").map(Action::Potential)
    }

    fn dissipation(&mut self, e: &ast::Expr) -> Result<Action<'g>, Reported> {
        let place = Place::moving("a dissipation").in_unit("W");
        let value = self.expr(e, &place)?;
        let value = self.smooth(e, value, 1, &place, "force")?;
        if !value.is_zero() && !self.has_rates(value) {
            let help = "the force is minus its derivative with respect to the rate: write `c/2*dot(theta)^2` for \
                        viscous friction";
            let fact = "the dissipation depends on no rate, so it has no effect";
            return Err(self.errors.on(Code::NoEffect, e, fact, help));
        }
        Ok(Action::Dissipation(value))
    }

    fn along(
        &mut self,
        coordinate: &Ident,
        force: &Read<ast::Expr>,
        items: &ast::Items,
    ) -> Result<Action<'g>, Reported> {
        self.require_one_number(coordinate, items)?;
        let place = Place::moving(format!("the force along `{coordinate}`"));
        let own = |body: &&ast::Body| body.fields.coordinate.as_ref() == Some(coordinate);
        let place = place.in_unit(
            items
                .bodies
                .iter()
                .find(own)
                .and_then(|body| JointUnits::of(body).force()),
        );
        let k = self.coordinate(coordinate, items);
        let force = self.read(force)?;
        let value = self.expr(force, &place)?;
        Ok(match k? {
            Some(k) => Action::Along(k, value, written(force, None)),
            None => Action::Press(value, self.name(coordinate, &Place::moving(""))?.value),
        })
    }

    /// Rejects a force along an orientation or a position, which a single number cannot specify.
    fn require_one_number(&mut self, name: &Ident, items: &ast::Items) -> Result<(), Reported> {
        let kind = self.names.kind(&name.to_string());
        let is_own = |own: &Option<Ident>| own.as_ref() == Some(name);
        let mut bodies = items.bodies.iter();
        let body = bodies.find(|body| is_own(&body.fields.orientation) || is_own(&body.fields.position));
        let (Some(kind @ (Kind::Orientation | Kind::Position)), Some(body)) = (kind, body) else {
            return Ok(());
        };
        let (fact, body) = (format!("`{name}` is {}, not a coordinate", kind.one()), &body.name);
        let help = match kind {
            Kind::Orientation => format!(
                "write `dissipation: -m*dot({name}).x` for a moment `m`, such as `2 N m`, about the x axis of \
                 `{body}`, and `dot({name}).y` or `dot({name}).z` for the other axes"
            ),
            _ => format!("apply the force to a point: `point middle on {body},` and `force on middle: [fx, fy, fz]`"),
        };
        Err(self.errors.at(Code::WrongKind, name.span(), fact, help))
    }

    /// Force on a point, and the index of the declared body in whose frame it is given.
    fn push(
        &mut self,
        point: &Ident,
        force: &Read<ast::Vector>,
        frame: Option<&Ident>,
        bodies: &[ast::Body],
    ) -> Result<(Vec3<'g>, Option<usize>), Reported> {
        let declared = self.point_named(point);
        let place = Place::moving(format!("the force on `{point}`")).in_unit("N");
        let force = self.read(force).and_then(|force| self.vector(force, &place));
        let frame = frame.map_or(Ok(None), |frame| self.body_named(frame, bodies));
        self.can_move(&[declared?], point)?;
        Ok((force?, frame?))
    }

    /// Force of a spring per unit of distance, and its potential energy.
    fn spring_between(
        &mut self,
        [a, b]: [&Ident; 2],
        at: Span,
        law: &Read<(ast::Expr, ast::Expr)>,
    ) -> Result<(Expr<'g>, Expr<'g>), Reported> {
        let ends = self.ends([a, b], at);
        let what = format!("the spring between `{a}` and `{b}`");
        let (stiffness, length) = self.read(law)?;
        let instead = "it must not be negative: write a repelling force by its `potential: ..`";
        let of_stiffness = Place::fixed(format!("the stiffness of {what}")).in_unit("N/m");
        let k = self.stiffness(stiffness, &of_stiffness, instead);
        let of_length = Place::fixed(format!("the length of {what}")).in_unit("m");
        let length = self.positive(length, &of_length, Requirement::NonNegative);
        let ends = ends?;
        self.can_move(&ends, a)?;
        let (k, length) = (k?, length?);
        let square = square_of_distance(&ends);
        if length.is_zero() {
            return Ok((k, ratio(1, 2) * (k * square)));
        }
        let distance = square.sqrt();
        let stretch = distance - length;
        Ok((k * (1 - length / distance), ratio(1, 2) * (k * stretch.powi(2))))
    }

    /// Force of a damper per unit of distance.
    fn damper_between(
        &mut self,
        [a, b]: [&Ident; 2],
        at: Span,
        coefficient: &Read<ast::Expr>,
    ) -> Result<Expr<'g>, Reported> {
        let ends = self.ends([a, b], at);
        let place = Place::fixed(format!("the coefficient of the damper between `{a}` and `{b}`")).in_unit("N s/m");
        let coefficient = self.read(coefficient);
        let coefficient = coefficient.and_then(|c| self.positive(c, &place, Requirement::NonNegative));
        let ends = ends?;
        self.can_move(&ends, a)?;
        let [[from, from_rate], [to, to_rate]] = ends.each_ref().map(Declared::symbols);
        let approach = (to - from).dot(to_rate - from_rate);
        Ok(coefficient? * approach / square_of_distance(&ends))
    }

    /// Looks up a coordinate of the state; none for a dependent one.
    fn coordinate(&mut self, name: &Ident, items: &ast::Items) -> Result<Option<CoordinateId>, Reported> {
        let own = items
            .bodies
            .iter()
            .find(|body| body.fields.coordinate.as_ref() == Some(name));
        if let Some(body) = own {
            // coordinates are numbered in order of declaration, orientations included
            let value = self.names.value(&name.to_string()).map(|quantity| quantity.value);
            let number = match value.and_then(Expr::as_symbol).map(|symbol| symbol.kind) {
                Some(SymbolKind::Coordinate(k)) => Some(CoordinateId::new(k)),
                _ => None,
            };
            return Ok(number.filter(|_| body.fields.depends.is_none()));
        }
        let coordinates = items.bodies.iter().filter_map(|body| body.fields.coordinate.as_ref());
        let coordinates: Vec<String> = coordinates.map(Ident::to_string).collect();
        if self.points.contains_key(&name.to_string()) {
            let fact = format_args!("`{name}` is a point, not a coordinate");
            let help = format_args!("write `force on {name}: [fx, fy, fz]`");
            return Err(self.errors.at(Code::WrongKind, name.span(), fact, help));
        }
        let driven = items
            .bodies
            .iter()
            .any(|body| body.name == *name && body.fields.motion.is_some());
        if driven {
            let fact = format_args!("the joint of `{name}` is driven, so no force along it changes the motion");
            let help = "remove the force, or drive the joint by a `torque`";
            return Err(self.errors.at(Code::NoEffect, name.span(), fact, help));
        }
        let fact = format_args!("no coordinate named `{name}`");
        Err(self.errors.unknown(
            Code::UnknownName,
            name,
            fact,
            coordinates.iter().map(String::as_str),
            &[],
        ))
    }

    /// Rejects forces on points that cannot move, or between points of one body.
    fn can_move(&mut self, ends: &[Declared<'g>], at: &Ident) -> Result<(), Reported> {
        let same = ends.windows(2).any(|pair| pair[0].body == pair[1].body);
        if same && ends[0].moves {
            let fact = "the two points belong to one body, so their distance never changes";
            return Err(self
                .errors
                .at(Code::NoEffect, at.span(), fact, "name points of two bodies"));
        }
        if ends.iter().any(|end| end.moves) {
            return Ok(());
        }
        let fact = match ends {
            [_] => format!("`{at}` does not move, so a force on it has no effect"),
            _ => "neither point moves, so a force between them has no effect".to_owned(),
        };
        Err(self
            .errors
            .at(Code::NoEffect, at.span(), fact, "name a point of a body that moves"))
    }

    fn has_rates(&self, x: Expr<'g>) -> bool {
        let mut symbols = self.graph.symbols_of(&[x]);
        symbols.any(|symbol| matches!(symbol.kind, SymbolKind::Rate(_) | SymbolKind::PointRate(_)))
    }
}

fn square_of_distance<'g>([a, b]: &[Declared<'g>; 2]) -> Expr<'g> {
    square_of(b.symbols()[0] - a.symbols()[0])
}

fn between<'g>(
    ends: [Option<model::Place<'g>>; 2],
    factor: Expr<'g>,
    potential: Option<Expr<'g>>,
) -> Option<Action<'g>> {
    let [a, b] = ends;
    a.zip(b).map(|(a, b)| Action::Between {
        ends: [a, b],
        factor,
        potential,
    })
}
