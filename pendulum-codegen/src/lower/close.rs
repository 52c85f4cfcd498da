//! Closed loops, and the coordinates that depend on others because of them.

use proc_macro2::{Ident, Span};

use super::Lower;
use super::constraint::hindering;
use super::expr::Place;
use super::joint::rotation;
use super::joint_units::JointUnits;
use crate::ast::{self, ExprKind, JointKind};
use crate::error::Reported;
use crate::expr::{Expr, Level, SymbolKind};
use crate::model::{self, BodyId, Cause, Closure, Combination, Coordinate, Declared, Loop, Model, NoPlane, Open, Tie};
use crate::parse::HINGES;
use crate::screw::Vec3;

/// How many coordinates a loop in a plane determines.
const IN_PLANE: usize = 2;

impl<'g> Lower<'g> {
    /// Closes the loops of a model: coordinates that depend become symbols with values in the state.
    pub(super) fn close(&mut self, items: &ast::Items, model: &mut Model<'g>, declared: Vec<Coordinate<'g>>) {
        let near: Vec<Result<Expr<'g>, Reported>> = items.bodies.iter().map(|body| self.near(body)).collect();
        let closures = items.closures.iter().map(|closure| self.closure(closure, items));
        let closures: Vec<Result<(Closure<'g>, Span), Reported>> = closures.collect();
        if items.closures.is_empty() && declared.is_empty() {
            if let Some(near) = items.bodies.iter().find_map(|body| body.fields.near.as_ref()) {
                let help = "leave it out: `near` says where closed loops are assembled, and there are none";
                self.errors.on(near, "there is nothing to assemble", help);
            }
            return;
        }
        for body in &items.bodies {
            self.refuse_to_hold(body);
        }
        // so they stand until the loops are closed, and after an error
        let zero = self.graph.zero();
        let unsolved = declared.iter().cloned().map(|coordinate| model::Dependent {
            coordinate,
            slopes: Vec::new(),
            drift: zero,
            in_state: false,
        });
        model.dependents = unsolved.collect();
        let solved = closures
            .into_iter()
            .collect::<Result<Vec<_>, _>>()
            .and_then(|closures| {
                let near = near.into_iter().collect::<Result<Vec<_>, _>>()?;
                // orientations and positions have no guess: loops do not depend on where they are carried
                let near = |coordinate: &Coordinate<'g>| {
                    let mut bodies = items.bodies.iter().zip(&near);
                    let own = |body: &ast::Body| {
                        body.fields
                            .coordinate
                            .as_ref()
                            .is_some_and(|own| *own == coordinate.name)
                    };
                    bodies.find(|(body, _)| own(body)).map_or(zero, |(_, near)| *near)
                };
                let of_state: Vec<Expr<'g>> = model.coordinates.iter().map(near).collect();
                let dependents = declared.iter().cloned().map(|coordinate| Declared {
                    near: near(&coordinate),
                    coordinate,
                });
                let dependents: Vec<Declared<'g>> = dependents.collect();
                self.solve(items, model, &closures, &dependents, &of_state)
            });
        let Ok(closed) = solved else { return };
        let first = model.independent();
        let in_new = |sum: &Combination| {
            sum.terms().fold(Combination::default(), |new, (k, factor)| {
                match usize::from(k).checked_sub(first) {
                    Some(n) => new.plus_multiple(factor, &closed.combinations[n]),
                    None => new.plus_multiple(factor, &Combination::one(k)),
                }
            })
        };
        for body in &mut model.bodies {
            body.motion = in_new(&body.motion);
            body.heading.turn = in_new(&body.heading.turn);
        }
        model.dependents = closed.dependents;
        model.dependence = closed.dependence;
        for ((_, symbol), &margin) in self.margins.iter().zip(&closed.margins) {
            self.graph.set_changes(*symbol, &[(margin, self.graph.one())], false);
            model.dependence.set(*symbol, margin);
        }
        model.margins = closed.margins;
        model.closings = closed.closings;
        model.corrections = closed.corrections;
        if model.in_state().next().is_some() {
            self.refuse_in_state(items);
        }
    }

    /// What is not known where dependent coordinates are in the state.
    fn refuse_in_state(&mut self, items: &ast::Items) {
        let words = items.generate.iter().flat_map(|(_, list)| list);
        if let Some(word) = words.into_iter().find(|word| **word == "canonical") {
            let fact = "a scene with loops that are no triangles has no canonical equations: more positions than momenta are in its state";
            let help = "leave out `canonical`, or let other coordinates depend; explicit methods, `Rodas5P` and `Taylor` keep the loops closed";
            self.errors.at(word.span(), fact, help);
        }
        if let Some(first) = hindering(items).first() {
            let fact = "dry friction, stops and walls are not supported in a scene with loops that are no triangles";
            let help = "let other coordinates depend, so that the loops are triangles, or write smooth laws: viscous friction, and a `potential` \
                        in the place of a stop or a wall";
            let help = self.left_out(first, help);
            self.errors.on(first, fact, help);
        }
    }

    /// Declares what stands for the margin of each loop until the loops are closed.
    pub(super) fn declare_margins(&mut self, items: &ast::Items) {
        for (n, closure) in items.closures.iter().enumerate() {
            let [a, b] = closure.ends.each_ref().map(|end| end.body.to_string());
            let symbol = self
                .graph
                .symbol(&format!("margin({a}, {b})"), SymbolKind::Dependent(n));
            self.margins.push(([a, b], symbol));
        }
    }

    /// `margin(a, b)`: how far the loop from `a` to `b` is from its toggle.
    pub(super) fn margin(
        &mut self,
        expr: &ast::Expr,
        arguments: &[ast::Expr],
        place: &Place<'g>,
    ) -> Result<Expr<'g>, Reported> {
        let named = |argument: &ast::Expr| match &argument.kind {
            ExprKind::Name(name) => Some(name.to_string()),
            _ => None,
        };
        let names: Vec<String> = arguments.iter().filter_map(named).collect();
        let closes =
            |ends: &[String; 2]| names == *ends || (names.len() == 2 && names[0] == ends[1] && names[1] == ends[0]);
        if let Some(&(_, symbol)) = self.margins.iter().find(|(ends, _)| closes(ends)) {
            return self.permit(symbol, expr.span(), place);
        }
        if !self.has_all_loops {
            return Err(self.errors.noted());
        }
        let fact = "`margin` takes the two bodies that close a loop";
        let known: Vec<String> = self
            .margins
            .iter()
            .map(|([a, b], _)| format!("`margin({a}, {b})`"))
            .collect();
        let help = match &known[..] {
            [] => "no loop is closed here: `close a at [..] to b at [..]: revolute(z)`".to_owned(),
            known => format!("write {}", known.join(" or ")),
        };
        Err(self.errors.on(expr, fact, help))
    }

    /// Where a coordinate is when the loops are assembled: 0 if left out.
    fn near(&mut self, body: &ast::Body) -> Result<Expr<'g>, Reported> {
        let Some(near) = &body.fields.near else {
            return Ok(self.graph.zero());
        };
        let place = Place {
            most: Level::Constant,
            ..Place::fixed(format!("the guess for the joint of `{}`", body.name))
                .in_unit(JointUnits::of(body).coordinate())
        };
        self.expr(near, &place)
    }

    /// A dependent coordinate has no friction that holds it, and no stop.
    fn refuse_to_hold(&mut self, body: &ast::Body) {
        let (fields, name) = (&body.fields, &body.name);
        let friction = fields.dry_friction.as_ref().map(|e| &e.tokens);
        let Some(held) = friction.or(fields.stop.as_ref().map(|stop| &stop.tokens)) else {
            return;
        };
        if fields.depends.is_some() {
            let fact = format_args!("the coordinate of `{name}` depends on others, so nothing can hold it by itself");
            let help = "let another coordinate of the loop depend; a `wall` limits anything";
            self.errors.on(held, fact, help);
        }
    }

    /// So many coordinates must depend.
    fn count(&mut self, items: &ast::Items, needed: usize, at: Span) -> Result<(), Reported> {
        let depending: Vec<&ast::Body> = items
            .bodies
            .iter()
            .filter(|body| body.fields.depends.is_some())
            .collect();
        let given = depending.len();
        if given > needed {
            let word = depending
                .into_iter()
                .filter_map(|body| body.fields.depends.as_ref())
                .nth(needed);
            let many = if needed == 0 {
                "none".to_owned()
            } else {
                needed.to_string()
            };
            let fact = format!("{}, but closed loops determine {many}", depend(given));
            let help = "leave out `depends` where a joint moves by itself, or close another loop: `close a at [..] to b at [..]: revolute(z)`";
            let at = word.map_or(Span::call_site(), proc_macro2::Ident::span);
            return Err(self.errors.at(at, fact, help));
        }
        if given < needed {
            let many = if needed == 1 { "coordinate" } else { "coordinates" };
            let fact = match given {
                0 => format!("closed loops determine {needed} {many}, but none depends"),
                _ => format!("closed loops determine {needed} {many}, but only {}", depend(given)),
            };
            // orientations do not depend, so other joints are missing
            let coordinates = items
                .bodies
                .iter()
                .filter(|body| body.fields.coordinate.is_some())
                .count();
            let mut closures = items.closures.iter();
            let has_orientations = closures.any(|closure| has_orientation(closure, &items.bodies));
            let help = if coordinates < needed && has_orientations {
                HINGES
            } else {
                "a loop in a plane determines two, and one in space up to six: write `coordinate: phi depends near 0.3`, \
                 where the number says in which assembly"
            };
            return Err(self.errors.at(at, fact, help));
        }
        Ok(())
    }

    fn closure(&mut self, closure: &ast::Closure, items: &ast::Items) -> Result<(Closure<'g>, Span), Reported> {
        let place =
            |body: &dyn std::fmt::Display| Place::fixed(format!("the end of the loop on `{body}`")).in_unit("m");
        let [first, second] = closure.ends.each_ref().map(|end| {
            let body = self.body_named(&end.body, &items.bodies);
            let at = end.at.as_ref().map_or(Ok(Vec3::zero(self.graph)), |at| {
                let at = self.read(at)?;
                self.vector(at, &place(&end.body))
            });
            Ok(model::Place {
                body: self.at_body(body?)?,
                at: at?,
            })
        });
        let axes = closure.ends.each_ref().map(|end| {
            let place = Place::fixed(format!("the angle of the end on `{}`", end.body)).in_unit("rad");
            let rpy = end.rpy.as_ref().map_or(Ok(Vec3::zero(self.graph)), |rpy| {
                let rpy = self.read(rpy)?;
                self.vector(rpy, &place)
            });
            rpy.map(rotation)
        });
        let owner = &closure.ends[0].body;
        if *owner == closure.ends[1].body {
            let fact = format_args!("`{owner}` is tied to itself");
            let help = "name two bodies: `close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z)`";
            return Err(self.errors.at(closure.ends[1].body.span(), fact, help));
        }
        let tie = match self.read(&closure.joint)? {
            JointKind::Revolute(axis) => Tie::Revolute(self.axis(owner, axis)?),
            JointKind::Prismatic(axis) => Tie::Prismatic(self.axis(owner, axis)?),
            JointKind::Ball => Tie::Ball,
            JointKind::Fixed => Tie::Fixed,
            _ => {
                let fact = "no joint of this kind closes a loop";
                let help = "write `revolute(z)`, `prismatic(x)`, `ball` or `fixed`";
                return Err(self.errors.at(closure.word.span(), fact, help));
            }
        };
        let closure_span = closure.word.span();
        let ([first, second], [a, b]) = ([first?, second?], axes);
        Ok((
            Closure {
                ends: [first, second],
                axes: [a?, b?],
                tie,
            },
            closure_span,
        ))
    }

    /// The body of a number in the text; an error that is known where it could not be read.
    fn at_body(&mut self, body: Option<usize>) -> Result<Option<BodyId>, Reported> {
        match self.placed(body) {
            Some(placed) => Ok(placed),
            None => Err(self.errors.noted()),
        }
    }

    fn solve(
        &mut self,
        items: &ast::Items,
        model: &mut Model<'g>,
        closures: &[(Closure<'g>, Span)],
        declared: &[Declared<'g>],
        near: &[Expr<'g>],
    ) -> Result<model::Closed<'g>, Reported> {
        if !self.errors.is_empty() {
            return Err(self.errors.noted());
        }
        let planes: Vec<Result<Loop<'g>, NoPlane>> =
            closures.iter().map(|(closure, _)| Loop::new(model, closure)).collect();
        let (first, loops) = (
            closures.first().map_or(Span::call_site(), |(_, span)| *span),
            planes.len(),
        );
        if planes.iter().all(Result::is_ok) {
            let at = closures.get(declared.len() / IN_PLANE).map_or(first, |(_, span)| *span);
            self.count(items, IN_PLANE * loops, at)?;
        }
        model.closures = closures.iter().map(|(closure, _)| *closure).collect();
        let vectors: Vec<Option<Loop<'g>>> = planes.iter().map(|plane| plane.clone().ok()).collect();
        model::close(model, &vectors, declared, near).map_err(|Open { number, cause }| {
            let plane = planes[number].as_ref().err();
            self.open(items, number, &cause, plane, closures[number].1)
        })
    }

    /// Reports what keeps a loop open.
    fn open(
        &mut self,
        items: &ast::Items,
        number: usize,
        cause: &Cause,
        no_plane: Option<&NoPlane>,
        at: Span,
    ) -> Reported {
        if let Cause::Determines(needed) = *cause
            && let Err(reported) = self.count(items, needed, at)
        {
            return reported;
        }
        let [a, b] = items.closures[number].ends.each_ref().map(|end| &end.body);
        let help = match no_plane {
            Some(_) if has_orientation(&items.closures[number], &items.bodies) => HINGES,
            no_plane => no_plane.map_or(ASSEMBLED, NoPlane::help),
        };
        let (what, help) = match *cause {
            Cause::TooShort { by } => (
                format!(
                    "cannot close: where it is assembled, its sides miss each other by {} m",
                    readable(by)
                ),
                help,
            ),
            Cause::AtToggle => (
                "is at its toggle where it is assembled".to_owned(),
                "there it does not determine what depends: assemble it elsewhere, as by `coordinate: theta near 0.5`",
            ),
            Cause::Undecided => (
                "can be assembled in two ways, and the guess is as near to both".to_owned(),
                "say in which: `coordinate: phi depends near 0.3`",
            ),
            Cause::AlwaysOpen { by, unit } => (
                format!(
                    "cannot close: its ends are {} {unit} apart wherever it moves",
                    readable(by)
                ),
                help,
            ),
            Cause::ClosedByChance => (
                "closes for the default values of the parameters alone".to_owned(),
                "give both ends one parameter where they must agree in order to close",
            ),
            Cause::NotAssembled { by, unit } => (
                format!(
                    "cannot be assembled near the guess: its ends stay {} {unit} apart",
                    readable(by)
                ),
                help,
            ),
            Cause::Determines(_) | Cause::DeterminesOthers => (
                "does not determine the coordinates that depend".to_owned(),
                "let coordinates of the joints in the loop depend, and assemble it away from its toggle: `coordinate: phi depends near 0.3`",
            ),
        };
        self.errors
            .at(at, format_args!("the loop from `{a}` to `{b}` {what}"), help)
    }
}

/// Whether a body between the ends of a loop has an orientation, which cannot depend.
fn has_orientation(closure: &ast::Closure, bodies: &[ast::Body]) -> bool {
    let [first, second] = closure.ends.each_ref().map(|end| {
        let named = |name: &Ident| bodies.iter().position(|body| body.name == *name);
        let carrier = |n: &usize| bodies[*n].parent.as_ref().ok().and_then(named);
        // as many as there are, should they carry one another
        let chain = std::iter::successors(named(&end.body), carrier).take(bodies.len());
        chain.collect::<Vec<usize>>()
    });
    let own = first.iter().filter(|n| !second.contains(n));
    let mut between = own.chain(second.iter().filter(|n| !first.contains(n)));
    between.any(|n| bodies[*n].fields.orientation.is_some())
}

/// How many coordinates depend, in words.
fn depend(count: usize) -> String {
    match count {
        1 => "1 coordinate depends".to_owned(),
        _ => format!("{count} coordinates depend"),
    }
}

/// Three digits of a positive number, with an exponent where many zeros would stand before or behind them.
fn readable(number: f64) -> String {
    let rounded = format!("{number:.2e}");
    let exponent = rounded.split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        Some(exponent @ -4..=5) => format!("{number:.*}", usize::try_from(2 - exponent).unwrap_or(0)),
        _ => rounded,
    }
}

/// What to do about a loop in a plane that does not close.
const ASSEMBLED: &str =
    "check lengths and places, or say where the mechanism can be assembled: `coordinate: theta near 0.5`";

impl NoPlane {
    /// What to do about a loop in space that does not close: it may be meant to lie in a plane.
    fn help(&self) -> &'static str {
        match self {
            Self::Axes => {
                "check lengths, places and axes, and say near which values of all coordinates of the loop it can be assembled; where these are \
                 right, more of them must depend"
            }
            Self::Joint => {
                "give the joint that closes the loop the axis of the others, or say where the mechanism can be assembled: `coordinate: theta near 0.5`"
            }
            Self::Apart => {
                "check the places along the axis of the joints, and in which directions they slide: the ends do not lie in one plane"
            }
        }
    }
}
