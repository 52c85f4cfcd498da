//! Closed loops and their dependent coordinates.

use std::f64::consts::{FRAC_PI_2, TAU};

use proc_macro2::Span;

use super::Lower;
use super::constraint::constraints_of;
use super::expr::Place;
use super::joint::rotation;
use super::joint_units::JointUnits;
use crate::ast::{self, ExprKind, JointKind};
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, SymbolKind, ratio};
use crate::loops::{self, Cause, Closed, Declared, Loop, NoPlane, Open};
use crate::model::{self, BodyId, Closure, Combination, Coordinate, Loops, Tie, Tree};
use crate::screw::Vec3;

/// Maximum distance of an angle from its guess, in rad. Farther away, the guess is closer to the other assembly.
const FAR: f64 = FRAC_PI_2;

/// A component of an orientation or of a position, and its guess for the assembly of the loops.
type Start<'g> = (Expr<'g>, Expr<'g>);

/// Number of coordinates that a planar loop determines.
const IN_PLANE: usize = 2;

impl<'g> Lower<'g> {
    /// Closes the loops of a tree: dependent coordinates become symbols with values in terms of the state. After an
    /// error they stay as declared.
    pub(super) fn close(&mut self, items: &ast::Items, tree: &mut Tree<'g>) -> Loops<'g> {
        let near: Vec<Result<Expr<'g>, Reported>> = items.bodies.iter().map(|body| self.near(body)).collect();
        let free: Vec<Result<Vec<Start<'g>>, Reported>> =
            items.bodies.iter().map(|body| self.near_freely(body)).collect();
        let closures = items.closures.iter().map(|closure| self.closure(closure, items));
        let closures: Vec<Result<(Closure<'g>, Span), Reported>> = closures.collect();
        if items.closures.is_empty() && tree.dependents.is_empty() {
            self.refuse_guesses(items);
            return Loops::default();
        }
        for body in &items.bodies {
            self.refuse_to_hold(body);
        }
        let closures: Result<Vec<_>, Reported> = closures.into_iter().collect();
        let solved = closures.and_then(|closures| {
            let near = near.into_iter().collect::<Result<Vec<_>, _>>()?;
            let free = free.into_iter().collect::<Result<Vec<_>, _>>()?.concat();
            self.solve(items, tree, &closures, (&near, &free))
        });
        let Ok(closed) = solved else { return Loops::default() };
        let loops = self.put_in(tree, closed);
        if loops.dependents.iter().any(|dependent| dependent.in_state) {
            self.refuse_in_state(items);
            // an added word that the scene cannot have is left out
            tree.generate.remove("canonical");
        }
        loops
    }

    /// Replaces the declared dependent coordinates by the ones that the loops determine.
    fn put_in(&self, tree: &mut Tree<'g>, closed: Closed<'g>) -> Loops<'g> {
        let first = tree.independent();
        let in_new = |sum: &Combination| {
            sum.terms().fold(Combination::default(), |new, (k, factor)| {
                match usize::from(k).checked_sub(first) {
                    Some(n) => new.plus_multiple(factor, &closed.combinations[n]),
                    None => new.plus_multiple(factor, &Combination::one(k)),
                }
            })
        };
        for body in &mut tree.bodies {
            body.motion = in_new(&body.motion);
            body.heading.turn = in_new(&body.heading.turn);
        }
        tree.dependents = closed.dependents;
        let mut loops = closed.loops;
        for ((_, symbol), &margin) in self.margins.iter().zip(&loops.margins) {
            self.graph.set_changes(*symbol, &[(margin, self.graph.one())], false);
            loops.dependence.set(*symbol, margin);
        }
        let taken = tree.turns_in_forces(&loops.dependence);
        loops.uncounted.retain(|own| taken.contains(&own.coordinate.position));
        loops
    }

    /// Rejects guesses in a scene without loops.
    fn refuse_guesses(&mut self, items: &ast::Items) {
        let guesses = |body: &ast::Body| {
            let fields = &body.fields;
            let near = fields.near.as_ref().map(|near| near.tokens.clone());
            let vectors = [&fields.turned, &fields.placed].into_iter().flatten();
            near.or(vectors.map(|near| near.tokens.clone()).next())
        };
        if let Some(near) = items.bodies.iter().find_map(guesses) {
            let help = "remove it: `near` is the guess from which closed loops are assembled";
            self.errors.on(
                Code::LoopCount,
                near,
                "`near` has no effect: there are no closed loops",
                help,
            );
        }
    }

    /// Rejects features that a scene with dependent coordinates in its state does not support.
    fn refuse_in_state(&mut self, items: &ast::Items) {
        let words = items.generate.iter().flat_map(|(_, list)| list);
        if let Some(word) = words.into_iter().find(|word| **word == "canonical") {
            let fact = "canonical equations are not available for loops without a closed form: the state has more \
                        positions than momenta";
            let help = "leave out `canonical`, or mark other coordinates `depends`, so that each loop is a \
                        triangle; explicit methods, `Rodas5P` and `Taylor` keep the loops closed";
            self.errors.at(Code::NotGenerated, word.span(), fact, help);
        }
        if let Some(first) = constraints_of(items).first() {
            let fact = "dry friction, stops and walls are not supported in a scene with loops without a closed form";
            let help = "mark other coordinates `depends`, so that each loop is a triangle, or use smooth laws: \
                        viscous friction, and a `potential` instead of a stop or a wall";
            let help = self.left_out(first, help);
            self.errors.on(Code::NoConstraint, first, fact, help);
        }
    }

    /// Declares the symbol that represents the margin of each loop until the loops are closed.
    pub(super) fn declare_margins(&mut self, items: &ast::Items) {
        for (n, closure) in items.closures.iter().enumerate() {
            let [a, b] = closure.ends.each_ref().map(|end| end.body.to_string());
            let symbol = self
                .graph
                .symbol(&format!("margin({a}, {b})"), SymbolKind::Dependent(n));
            self.margins.push(([a, b], symbol));
        }
    }

    /// `margin(a, b)`: distance of the loop from `a` to `b` from its singularity (toggle).
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
            [] => "there are no closed loops: `close a at [..] to b at [..]: revolute(z)` closes one".to_owned(),
            known => format!("write {}", known.join(" or ")),
        };
        Err(self.errors.on(Code::Arguments, expr, fact, help))
    }

    /// Guess of the coordinate of a body for the assembly of the loops; 0 if omitted.
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

    /// Guesses of the components of an orientation and of a position for the assembly of the loops.
    fn near_freely(&mut self, body: &ast::Body) -> Result<Vec<Start<'g>>, Reported> {
        let ast::BodyFields {
            orientation,
            position,
            turned,
            placed,
            ..
        } = &body.fields;
        let place = |what: &str, unit: &'static str| Place {
            most: Level::Constant,
            ..Place::fixed(format!("the guess for the {what} of `{}`", body.name)).in_unit(unit)
        };
        let mut starts = Vec::new();
        if let (Some(name), Some(near)) = (orientation, turned) {
            let near = self.vector(near, &place("orientation", "rad"))?;
            starts.extend(self.components_of(name).zip(quaternion(near)));
        }
        if let (Some(name), Some(near)) = (position, placed) {
            let near = self.vector(near, &place("position", "m"))?;
            starts.extend(self.components_of(name).zip(near.0));
        }
        Ok(starts)
    }

    /// Rejects dry friction and stops of a dependent coordinate.
    fn refuse_to_hold(&mut self, body: &ast::Body) {
        let (fields, name) = (&body.fields, &body.name);
        let friction = fields.dry_friction.as_ref().map(|e| &e.tokens);
        let Some(held) = friction.or(fields.stop.as_ref().map(|stop| &stop.tokens)) else {
            return;
        };
        if fields.depends.is_some() {
            let fact =
                format_args!("the coordinate of `{name}` depends on others, so it cannot have dry friction or a stop");
            let help = self.left_out(
                held,
                "mark another coordinate of the loop `depends`, or limit this one by a `wall`",
            );
            self.errors.on(Code::NoConstraint, held, fact, help);
        }
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
            let fact = format_args!("the loop connects `{owner}` to itself");
            let help = "name two bodies: `close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z)`";
            return Err(self.errors.at(Code::LoopJoint, closure.ends[1].body.span(), fact, help));
        }
        let tie = match self.read(&closure.joint)? {
            JointKind::Revolute(axis) => Tie::Revolute(self.axis(owner, axis)?),
            JointKind::Prismatic(axis) => Tie::Prismatic(self.axis(owner, axis)?),
            JointKind::Ball => Tie::Ball,
            JointKind::Fixed => Tie::Fixed,
            _ => {
                let fact = "this kind of joint cannot close a loop";
                let help = "write `revolute(z)`, `prismatic(x)`, `ball` or `fixed`";
                return Err(self.errors.at(Code::LoopJoint, closure.word.span(), fact, help));
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

    /// Index in the model of a declared body. A body with an error has been reported already.
    fn at_body(&mut self, body: Option<usize>) -> Result<Option<BodyId>, Reported> {
        match self.placed(body) {
            Some(placed) => Ok(placed),
            None => Err(self.errors.noted()),
        }
    }

    /// Solves the loops, with guesses for the coordinates of the bodies and for the components of orientations and
    /// positions.
    fn solve(
        &mut self,
        items: &ast::Items,
        tree: &mut Tree<'g>,
        closures: &[(Closure<'g>, Span)],
        (near, free): (&[Expr<'g>], &[Start<'g>]),
    ) -> Result<Closed<'g>, Reported> {
        if !self.errors.is_empty() {
            return Err(self.errors.noted());
        }
        self.refuse_twice(items, closures)?;
        let near = |coordinate: &Coordinate<'g>| {
            let is_own = |body: &ast::Body| {
                let own = body.fields.coordinate.as_ref();
                own.is_some_and(|own| *own == coordinate.name)
            };
            let mut bodies = items.bodies.iter().zip(near);
            let own = bodies.find(|(body, _)| is_own(body));
            own.map_or(self.graph.zero(), |(_, near)| *near)
        };
        let of_state: Vec<Expr<'g>> = tree.coordinates.iter().map(near).collect();
        let declared = tree.dependents.iter().map(|coordinate| Declared {
            near: near(coordinate),
            coordinate: coordinate.clone(),
        });
        let declared: Vec<Declared<'g>> = declared.collect();
        let planes: Vec<Result<Loop<'g>, NoPlane>> =
            closures.iter().map(|(closure, _)| Loop::new(tree, closure)).collect();
        tree.closures = closures.iter().map(|(closure, _)| *closure).collect();
        let vectors: Vec<Option<Loop<'g>>> = planes.iter().map(|plane| plane.clone().ok()).collect();
        let closed = loops::close(tree, &vectors, &declared, (&of_state, free));
        let closed = closed.map_err(|Open { number, cause }| {
            let in_plane = planes.iter().all(Result::is_ok);
            // planar loops may determine fewer coordinates if lengths agree, and are then closed
            if in_plane && !matches!(cause, Cause::Determines(_)) {
                let at = closures.get(declared.len() / IN_PLANE).or(closures.first());
                let at = at.map_or(Span::call_site(), |(_, span)| *span);
                if let Err(reported) = self.count(items, IN_PLANE * planes.len(), at) {
                    return reported;
                }
            }
            let plane = planes[number].as_ref().err();
            self.open(items, number, &cause, plane, closures[number].1)
        })?;
        self.count(items, closed.combinations.len(), Span::call_site())?;
        self.check_guesses(items, &closed)?;
        Ok(closed)
    }

    /// Rejects a guess far from where the loops close, because another assembly may be intended.
    fn check_guesses(&mut self, items: &ast::Items, closed: &Closed<'g>) -> Result<(), Reported> {
        let bodies = items.bodies.iter().filter(|body| body.fields.depends.is_some());
        for (body, &[guess, found]) in bodies.zip(&closed.assembled) {
            let beside = (found - guess).rem_euclid(TAU);
            let turns = JointUnits::of(body).coordinate() == Some("rad");
            let (Some(name), Some(depends)) = (&body.fields.coordinate, &body.fields.depends) else {
                continue;
            };
            if turns && beside.min(TAU - beside) > FAR {
                // reduce to within half a turn
                let found = found - TAU * (found / TAU).round();
                let fact = format_args!("the loops close at `{name}` = {found:.2}, far from its guess {guess}");
                let help = format_args!(
                    "write `coordinate: {name} depends near {found:.2}`, or, for the other assembly, guesses near \
                     it for all coordinates of the loop"
                );
                return Err(self.errors.at(Code::AmbiguousLoop, depends.span(), fact, help));
            }
        }
        Ok(())
    }

    /// Rejects a loop that is closed twice, because the second closure determines nothing.
    fn refuse_twice(&mut self, items: &ast::Items, closures: &[(Closure<'g>, Span)]) -> Result<(), Reported> {
        let is_known = |n: usize| {
            closures[..n]
                .iter()
                .any(|(known, _)| known.ties_the_same(&closures[n].0))
        };
        let Some(n) = (0..closures.len()).find(|n| is_known(*n)) else {
            return Ok(());
        };
        let [a, b] = items.closures[n].ends.each_ref().map(|end| &end.body);
        let fact = format_args!("the loop from `{a}` to `{b}` is closed twice at the same place");
        Err(self
            .errors
            .at(Code::GivenTwice, closures[n].1, fact, "remove one of the two"))
    }
}

/// Quaternion of roll, pitch and yaw, scalar first.
fn quaternion<'g>(Vec3(rpy): Vec3<'g>) -> [Expr<'g>; 4] {
    let [(cr, sr), (cp, sp), (cy, sy)] = rpy.map(|angle| {
        let half = ratio(1, 2) * angle;
        (half.cos(), half.sin())
    });
    [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
}
