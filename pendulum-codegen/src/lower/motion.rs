//! Driven joints, and joints that follow others.

use super::Lower;
use super::expr::{Only, Place};
use super::joint_units::{JointUnits, is_zero};
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Derivative, Expr, Level, Rational, SymbolKind};
use crate::model::{Combination, Coordinate, CoordinateId, Drive};

/// Motion of a joint.
#[derive(Clone, Debug)]
pub(super) enum Motion<'g> {
    /// Fixed at a value.
    Still(Expr<'g>),
    /// Driven, by the coordinate of a drive.
    Driven(CoordinateId),
    /// Following other joints, by a combination of their coordinates plus a constant.
    Following(Combination, Expr<'g>),
}

impl<'g> Lower<'g> {
    /// Drives of a scene, numbered after its `dof` coordinates. Also records the motion of each joint.
    pub(super) fn drives(&mut self, bodies: &[ast::Body], dof: usize) -> Vec<Drive<'g>> {
        let mut drives: Vec<Drive<'g>> = Vec::new();
        for body in bodies {
            let motion = body.fields.motion.as_ref().map(|motion| {
                let law = self.motion(body, motion)?;
                if law.level() < Level::State {
                    return Ok(Motion::Still(law));
                }
                let coordinates = self.coordinates_of(law);
                if !coordinates.is_empty() {
                    return self.following(body, motion, law, &coordinates, dof);
                }
                let n = dof + drives.len();
                drives.push(self.drive(body, n, law));
                Ok(Motion::Driven(CoordinateId::new(n)))
            });
            self.motions.push(motion);
        }
        drives
    }

    /// Renumbers dependent coordinates to follow the drives, whose number is known only now.
    pub(super) fn number_behind(&mut self, dof: usize, drives: usize) {
        let behind = |k: CoordinateId| match usize::from(k) {
            k if k < dof => CoordinateId::new(k),
            k => CoordinateId::new(k + drives),
        };
        for motion in &mut self.motions {
            if let Some(Ok(Motion::Following(sum, _))) = motion {
                *sum = sum.renumbered(behind);
            }
        }
    }

    fn drive(&self, body: &ast::Body, n: usize, law: Expr<'g>) -> Drive<'g> {
        let name = body.name.to_string();
        let symbol = |form: &str, kind: fn(usize) -> SymbolKind| self.graph.symbol(&form.replace('_', &name), kind(n));
        let (position, rate, acceleration) = (
            symbol("_", SymbolKind::Coordinate),
            symbol("dot(_)", SymbolKind::Rate),
            symbol("ddot(_)", SymbolKind::Acceleration),
        );
        let mut by_time = Derivative::by(self.time);
        let first = by_time.of(law);
        Drive {
            coordinate: Coordinate::plain(name, [position, rate, acceleration]),
            law: [law, first, by_time.of(first)],
        }
    }

    /// Lowers the law of a motion.
    fn motion(&mut self, body: &ast::Body, motion: &ast::Expr) -> Result<Expr<'g>, Reported> {
        let name = &body.name;
        let place = Place {
            only: Only::Motion,
            ..Place::moving(format!("the motion of `{name}`")).in_unit(JointUnits::of(body).coordinate())
        };
        let law = self.expr(motion, &place);
        if let Some(coordinate) = &body.fields.coordinate {
            let fact =
                format_args!("the joint of `{name}` has a motion, so it cannot have the coordinate `{coordinate}`");
            let help = "write either `coordinate: name` for a degree of freedom, or `motion: e` for a prescribed \
                        motion";
            self.errors.at(Code::JointCoordinate, coordinate.span(), fact, help);
        }
        if law.as_ref().is_ok_and(|&law| !self.coordinates_of(law).is_empty()) {
            return law;
        }
        if let Some(stop) = &body.fields.stop {
            let fact = format_args!("the joint of `{name}` is driven, so it cannot have a stop");
            let help = "remove the stop, or drive the joint by a `torque`";
            self.errors.on(Code::NoConstraint, &stop.tokens, fact, help);
        }
        if let Some(force) = body.fields.acting() {
            let fact =
                format_args!("the joint of `{name}` is driven, so no force or friction along it changes the motion");
            let help = "remove it, or drive the joint by a `torque`";
            self.errors.on(Code::NoEffect, force, fact, help);
        }
        self.smooth(motion, law?, 2, &place, "acceleration")
    }

    /// Coordinates in a law, with their symbols.
    fn coordinates_of(&self, law: Expr<'g>) -> Vec<(CoordinateId, Expr<'g>)> {
        let all = self.graph.reachable(&[law]).into_iter().map(|id| self.graph.expr(id));
        let of = all.filter_map(|x| match x.as_symbol()?.kind {
            SymbolKind::Coordinate(k) => Some((CoordinateId::new(k), x)),
            _ => None,
        });
        of.collect()
    }

    /// Motion of a joint that follows others.
    fn following(
        &mut self,
        body: &ast::Body,
        motion: &ast::Expr,
        law: Expr<'g>,
        coordinates: &[(CoordinateId, Expr<'g>)],
        dof: usize,
    ) -> Result<Motion<'g>, Reported> {
        let fields = &body.fields;
        let frictions = [&fields.dry_friction, &fields.static_friction].into_iter().flatten();
        let mut constrained = frictions
            .filter(|friction| !is_zero(friction))
            .map(|friction| &friction.tokens);
        if let Some(constrained) = constrained.next().or(fields.stop.as_ref().map(|stop| &stop.tokens)) {
            let fact = format_args!(
                "the joint of `{}` follows others, so it cannot have dry friction or a stop",
                body.name
            );
            let help = "move it to a joint that this one follows";
            self.errors.on(Code::NoConstraint, constrained, fact, help);
        }
        let mut sum = Combination::default();
        for &(k, position) in coordinates {
            let factor = self.factor(body, motion, law, position, usize::from(k) >= dof)?;
            sum = sum.plus_multiple(factor, &Combination::one(k));
        }
        let zeros = coordinates
            .iter()
            .map(|&(_, position)| (position, self.graph.zero()))
            .collect();
        let start = self.graph.substitute(&[law], zeros)[0];
        if start.level() >= Level::State {
            let fact = format_args!("the motion of `{}` depends on the time and on other joints", body.name);
            let help = "use only one of them; for both, chain two joints, with a massless body between them";
            return Err(self.errors.on(Code::Motion, motion, fact, help));
        }
        Ok(Motion::Following(sum, start))
    }

    /// Factor by which a joint follows a coordinate.
    fn factor(
        &mut self,
        body: &ast::Body,
        motion: &ast::Expr,
        law: Expr<'g>,
        position: Expr<'g>,
        depends: bool,
    ) -> Result<&'g Rational, Reported> {
        let name = &body.name;
        if let Some(orientation) = self.orientation_of(position).map(str::to_owned) {
            let fact = format_args!("the motion of `{name}` follows the orientation `{orientation}`");
            let help = "the components of a quaternion are not joint coordinates: follow a joint that turns about \
                        one axis";
            return Err(self.errors.on(Code::Motion, motion, fact, help));
        }
        let slope = Derivative::by(position).of(law);
        let Some(factor) = slope.as_number() else {
            if let Some(value) = slope.constant() {
                let leader = position.as_symbol().map_or("", |symbol| &symbol.name);
                let fact = format_args!("`{name}` follows `{leader}` by a factor that contains pi");
                let help =
                    format!("write its value, {value}, with its unit: units with rad in place of turn have no pi");
                return Err(self.errors.on(Code::Motion, motion, fact, help));
            }
            let fact = format_args!("the motion of `{name}` is not a linear combination of coordinates");
            let help = "its coefficients must be numbers, as in `-a`, `0.5*a + 0.1` or `a - b`, where `a` and `b` \
                        are coordinates";
            return Err(self.errors.on(Code::Motion, motion, fact, help));
        };
        // dependent angles are determined up to whole turns only
        if depends && !factor.is_integer() {
            let leader = position.as_symbol().map_or("", |symbol| &symbol.name);
            let fact = format_args!("`{name}` follows the dependent coordinate `{leader}` by a factor of {factor}");
            let help = "use a whole number as the factor, or follow a coordinate without `depends`";
            return Err(self.errors.on(Code::Motion, motion, fact, help));
        }
        Ok(factor)
    }

    /// Rejects an expression with fewer than `needed` continuous derivatives; `what` is the quantity that would jump.
    pub(super) fn smooth(
        &mut self,
        given: &ast::Expr,
        value: Expr<'g>,
        needed: i64,
        place: &Place<'g>,
        what: &str,
    ) -> Result<Expr<'g>, Reported> {
        // a term of a potential in the time alone may jump: forces are derivatives by coordinates
        let by_time = place.only == Only::Motion;
        if value.continuous_derivatives(|kind| by_time || kind != SymbolKind::Time) >= needed {
            return Ok(value);
        }
        let corner = corner(given).unwrap_or(given);
        let is_clamp = matches!(&corner.kind, ast::ExprKind::Call(name, _) if name == "clamp");
        let (at, help) = if is_clamp {
            (
                "`clamp` reaches a limit",
                "use `limit*tanh(x/limit)`, which saturates smoothly",
            )
        } else {
            let help = "use the smooth `sqrt(x^2 + eps^2)` instead of `abs(x)`; `abs(x)^3` is smooth enough";
            ("`abs`, or the root of a square, passes 0", help)
        };
        let fact = format_args!("{} is not smooth where {at}: the {what} jumps there", place.what);
        Err(self.errors.on(Code::NotSmooth, corner, fact, help))
    }
}

/// First call of `abs`, `clamp` or `sqrt` in an expression.
fn corner(expr: &ast::Expr) -> Option<&ast::Expr> {
    use ast::ExprKind::{Binary, Call, Component, Measured, Name, Neg, Number, Power, RateComponent};
    match &expr.kind {
        Call(name, _) if ["abs", "clamp", "sqrt"].iter().any(|known| name == known) => Some(expr),
        Call(_, arguments) => arguments.iter().find_map(corner),
        Neg(a) => corner(a),
        Binary(_, a, b) | Power(a, b) => corner(a).or_else(|| corner(b)),
        Number(_) | Measured(..) | Name(_) | Component(..) | RateComponent(..) => None,
    }
}
