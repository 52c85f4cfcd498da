//! Constraints: dry friction, stops and walls.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::Ident;

use super::Lower;
use super::expr::{Only, Place};
use super::freedom::freedom;
use super::joint_units::JointUnits;
use super::measure::Measure;
use super::written::written;
use crate::ast::{self, ExprKind};
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, Printer, SymbolKind};
use crate::model::{Action, BodyId, Combination, Constraint, Law, MAX_CONSTRAINTS, Requirement, Rule, Tree};

/// A wall, before the coordinates of points are known.
#[derive(Debug)]
pub(super) struct Wall<'g> {
    name: String,
    gap: Expr<'g>,
    law: Law<'g>,
}

/// Tokens of the constraints of a scene, in the order of the source: joints, then walls.
pub(super) fn constraints_of(items: &ast::Items) -> Vec<TokenStream> {
    // constraints of ball and free joints were rejected before
    let bodies = items.bodies.iter().filter(|body| freedom(body).is_none());
    let of_joints = bodies.filter_map(|body| {
        let stop = body.fields.stop.as_ref().map(|stop| &stop.tokens);
        body.fields.dry_friction.as_ref().map(|e| &e.tokens).or(stop)
    });
    let walls = items.walls.iter().map(|wall| wall.name.to_token_stream());
    of_joints.cloned().chain(walls).collect()
}

impl<'g> Lower<'g> {
    /// Rejects more constraints than the core supports.
    pub(super) fn check_conditions(&mut self, items: &ast::Items) {
        let constraints = constraints_of(items);
        if let Some(ninth) = constraints.get(MAX_CONSTRAINTS) {
            let fact = format_args!(
                "{} constraints are declared, but at most {MAX_CONSTRAINTS} are supported: a wall is one, and so is \
                 a joint with dry friction or a stop",
                constraints.len()
            );
            let help = self.left_out(
                ninth,
                "remove some, or use smooth laws: viscous friction, and a `potential` instead of a stop or a wall",
            );
            self.errors.on(Code::TooManyConstraints, ninth, fact, help);
        }
    }

    /// Help for a rejected constraint. For a constraint from a file, the help names the options that omit all of them.
    pub(super) fn left_out(&self, constraint: &TokenStream, help: &str) -> String {
        if self.errors.is_from_file(constraint) {
            let words = "leave out `limits` after the path of the robot, or write `without dry_friction` there";
            return format!("{words}; or else {help}");
        }
        help.to_owned()
    }

    /// Dry friction and stop of a joint; none if it has neither.
    pub(super) fn law(&mut self, body: &ast::Body) -> Result<Option<Law<'g>>, Reported> {
        let (fields, units) = (&body.fields, JointUnits::of(body));
        let mut law = self.free();
        let friction = self.dry_friction(body, units, &mut law);
        let stop = match &fields.stop {
            Some(stop) => self.stop(body, units, stop, &mut law),
            None => Ok(()),
        };
        friction?;
        stop?;
        let is_constrained = !law.sticking.is_zero() || law.low.is_some();
        Ok(is_constrained.then_some(law))
    }

    fn dry_friction(&mut self, body: &ast::Body, units: JointUnits, law: &mut Law<'g>) -> Result<(), Reported> {
        let (fields, name) = (&body.fields, &body.name);
        let place = |what| Place::fixed(format!("the {what} of `{name}`")).in_unit(units.force());
        let Some(kinetic) = &fields.dry_friction else {
            let Some(at_rest) = &fields.static_friction else {
                return Ok(());
            };
            let fact = format_args!("`{name}` has `static_friction`, but no `dry_friction`");
            let help = "add `dry_friction: e`, the friction during sliding; if both are equal, write only \
                        `dry_friction`";
            return Err(self.errors.on(Code::Constraint, at_rest, fact, help));
        };
        let slipping = self.positive(kinetic, &place("dry friction"), Requirement::NonNegative);
        let at_rest = fields.static_friction.as_ref();
        let sticking = at_rest.map(|e| self.expr(e, &place("static friction"))).transpose();
        law.slipping = slipping?;
        law.sticking = sticking?.unwrap_or(law.slipping);
        if let Some(at_rest) = at_rest {
            let fact = format!("the static friction of `{name}` is less than its dry friction");
            let help = "`static_friction` must be at least `dry_friction`, the friction during sliding: swap the \
                        two, or remove it";
            let rule = format!("the static friction of `{name}` must not be below its dry friction");
            let difference = law.sticking - law.slipping;
            self.obeys(
                Code::Constraint,
                at_rest,
                (difference, Requirement::NonNegative),
                [&fact, help, &rule],
            )?;
        }
        Ok(())
    }

    fn stop(
        &mut self,
        body: &ast::Body,
        units: JointUnits,
        stop: &ast::Stop,
        law: &mut Law<'g>,
    ) -> Result<(), Reported> {
        let owner = format!("the stop of `{}`", body.name);
        let place = Place::fixed(owner.clone()).in_unit(units.coordinate());
        let limits = stop.limits.each_ref().map(|e| self.expr(e, &place));
        let (restitution, slow) = stop
            .restitution
            .as_ref()
            .map_or((None, None), |(e, slow)| (Some(e), slow.as_ref()));
        let impact = self.impact(&owner, units.rate(), (restitution, slow), law);
        let [low, high] = limits;
        let (low, high) = (low?, high?);
        impact?;
        let [from, to] = stop.limits.each_ref().map(|e| written(e, None).to_string());
        let fact = format!("{owner} has no range: its lower limit {from} is not below its upper limit {to}");
        let rule = format!("the upper limit of {owner} must be above its lower limit");
        let checked = (high - low, Requirement::Positive);
        let help = if self.errors.is_from_file(&stop.tokens) {
            format!(
                "set `lower` below `upper` in the `limit` of its joint (0 if left out), or write `stop: [low, \
                 high]` in a `body {}` of the scene",
                body.name
            )
        } else {
            "write `stop: [low, high]`, the lower limit first".to_owned()
        };
        self.obeys(Code::Constraint, &stop.tokens, checked, [&fact, &help, &rule])?;
        (law.low, law.high) = (Some(low), Some(high));
        Ok(())
    }

    /// Sets the restitution of impacts, and the rate below which nothing rebounds.
    fn impact(
        &mut self,
        owner: &str,
        unit_of_rate: Option<&'static str>,
        (restitution, slow): (Option<&ast::Expr>, Option<&ast::Expr>),
        law: &mut Law<'g>,
    ) -> Result<(), Reported> {
        if let Some(e) = restitution {
            let place = Place::fixed(format!("the restitution of {owner}"));
            let given = self.quantity(e, &place)?;
            self.require_plain(e, given, &place.what);
            let value = given.value;
            let help = "a restitution lies between 0 (no rebound) and 1 (no loss of energy)";
            let rule = format!("{} must lie between 0 and 1", place.what);
            for checked in [value, 1 - value] {
                let fact = format!("{} is {}", place.what, written(e, None));
                self.obeys(
                    Code::Constraint,
                    e,
                    (checked, Requirement::NonNegative),
                    [&fact, help, &rule],
                )?;
            }
            law.restitution = value;
        }
        if let Some(e) = slow {
            let place = Place::fixed(format!("the rebound threshold of {owner}")).in_unit(unit_of_rate);
            law.slow = self.positive(e, &place, Requirement::NonNegative)?;
        }
        Ok(())
    }

    /// Lowers the walls, with the symbols of points in their gaps.
    pub(super) fn walls(&mut self, items: &ast::Items) -> Vec<Wall<'g>> {
        let mut walls: Vec<Wall<'g>> = Vec::new();
        let coordinates = items.bodies.iter().filter_map(|body| body.fields.coordinate.as_ref());
        let coordinates: Vec<&Ident> = coordinates.collect();
        for (n, wall) in items.walls.iter().enumerate() {
            let name = &wall.name;
            // the core identifies a constraint by its name alone in messages
            if coordinates.contains(&name) {
                let fact = format_args!("`{name}` is the name of both a coordinate and a wall");
                self.errors
                    .at(Code::NameTaken, name.span(), fact, "choose another name");
            } else if items.walls[..n].iter().any(|other| other.name == *name) {
                let fact = format_args!("wall `{name}` is declared twice");
                self.errors
                    .at(Code::NameTaken, name.span(), fact, "rename one of the two");
            }
            walls.extend(self.wall(wall).ok());
        }
        walls
    }

    fn wall(&mut self, wall: &ast::Wall) -> Result<Wall<'g>, Reported> {
        let (name, fields) = (&wall.name, &wall.fields);
        let Some(gap) = &fields.gap else {
            return Err(wall.unread.unwrap_or_else(|| {
                let help = format_args!("write `wall {name} {{ gap: tip.y, restitution: 0.5 }}`");
                self.errors
                    .at(Code::NoGap, name.span(), format_args!("wall `{name}` has no gap"), help)
            }));
        };
        let mut law = self.free();
        let value = self.gap(name.span(), gap, format!("the gap of wall `{name}`"));
        let unit = value.as_ref().map_or(None, |(_, unit)| Some(*unit));
        let impact = (fields.restitution.as_ref(), fields.slow.as_ref());
        let impact = self.impact(&format!("wall `{name}`"), unit.map(rate_of), impact, &mut law);
        let (gap_value, _) = value?;
        impact?;
        law.low = Some(self.graph.zero());
        Ok(Wall {
            name: name.to_string(),
            gap: gap_value,
            law,
        })
    }

    /// Gap of a wall and its unit: a length or an angle.
    fn gap(&mut self, span: Span, gap: &ast::Expr, what: String) -> Result<(Expr<'g>, &'static str), Reported> {
        let place = Place {
            only: Only::Gap,
            ..Place::moving(what)
        };
        self.spans.walls.push(span);
        let quantity = self.quantity(gap, &place)?;
        let is_angle = quantity.measure.alike(Measure::ONE).is_some() && !matches!(gap.kind, ExprKind::Number(_));
        let unit = if is_angle { "rad" } else { "m" };
        let needed = Place {
            what: format!("a gap is a length or an angle: {}", place.what),
            ..place.clone().in_unit(unit)
        };
        self.fits(gap, quantity, &needed);
        let value = self.smooth(gap, quantity.value, 2, &place, "acceleration")?;
        Ok((value, unit))
    }

    fn free(&self) -> Law<'g> {
        let zero = self.graph.zero();
        Law {
            slipping: zero,
            sticking: zero,
            low: None,
            high: None,
            restitution: zero,
            slow: zero,
        }
    }

    /// Checks a constant now, with `fact` and `help` for its error, or adds a rule for `new` with the text `rule`.
    pub(super) fn obeys(
        &mut self,
        code: Code,
        at: &impl ToTokens,
        (value, requirement): (Expr<'g>, Requirement<'g>),
        [fact, help, rule]: [&str; 3],
    ) -> Result<(), Reported> {
        if self.broken_by(value, requirement).is_some() {
            return Err(self.errors.on(code, at, fact, help));
        }
        if value.level() == Level::Parameter {
            self.rule(Rule {
                value,
                requirement,
                name: Printer::new(self.graph).print(value.id()),
                text: rule.to_owned(),
            });
        }
        Ok(())
    }
}

/// Constraints of a tree: joints in the order of their bodies, then walls. Adds their forces to the tree.
pub(super) fn constrain<'g>(tree: &mut Tree<'g>, walls: Vec<Wall<'g>>) -> Vec<Constraint<'g>> {
    let graph = tree.graph;
    let mut constraints: Vec<Constraint<'g>> = Vec::new();
    let force = |n: usize, name: &str| {
        let name = name.trim_start_matches("r#");
        (
            name.to_owned(),
            graph.symbol(&format!("force({name})"), SymbolKind::Force(n)),
        )
    };
    for n in BodyId::all(tree.bodies.len()) {
        let body = &tree.bodies[n];
        let (Some(law), Some(own)) = (body.law, body.coordinate) else {
            continue;
        };
        let (name, force) = force(constraints.len(), &tree.coordinate(own).name);
        constraints.push(Constraint {
            name,
            coordinate: Some(own),
            motion: body.motion.clone(),
            value: tree.position_of(&body.motion),
            declared: tree.position_of(&body.motion),
            force,
            law,
        });
        let body = &mut tree.bodies[n];
        body.force += force;
        body.passive += force;
    }
    for Wall { name, gap, law } in walls {
        let (name, force) = force(constraints.len(), &name);
        tree.actions.push(Action::Press(force, gap));
        constraints.push(Constraint {
            name,
            coordinate: None,
            motion: Combination::default(),
            value: gap,
            declared: gap,
            force,
            law,
        });
    }
    constraints
}

fn rate_of(unit: &str) -> &'static str {
    if unit == "rad" { "rad/s" } else { "m/s" }
}
