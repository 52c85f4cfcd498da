//! Bodies: joint, mass and forces.

use std::collections::BTreeMap;

use super::Lower;
use super::freedom::freedom;
use super::mass::{Mass, Turns};
use super::motion::Motion;
use super::order::Hung;
use super::written::written;
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Expr, Printer};
use crate::model::{Body, BodyId, Combination, Coordinate, CoordinateId, Heading};

impl<'g> Lower<'g> {
    /// Lowers the bodies, each after its parent. Bodies with an error are left out.
    pub(super) fn bodies(
        &mut self,
        declared: &[ast::Body],
        order: Vec<Hung>,
        coordinates: &[Coordinate<'g>],
        shapes: &BTreeMap<String, Result<Mass<'g>, Reported>>,
    ) -> Vec<Body<'g>> {
        let mut bodies = Vec::new();
        let mut placed = vec![None; declared.len()];
        self.bodies = vec![None; declared.len()];
        for (n, parent) in order {
            let body = &declared[n];
            let parent = parent.and_then(|parent| parent.and_then(|parent| placed[parent]).transpose());
            let motion = self.motions[n].clone().transpose();
            let lowered = match freedom(body) {
                Some(slides) => self.free_bodies(body, slides, parent, &bodies, coordinates, shapes),
                None => motion
                    .and_then(|motion| self.body(body, motion, parent, &bodies, coordinates, shapes))
                    .map(|body| vec![body]),
            };
            placed[n] = Some(lowered.map(|lowered| {
                self.spans.bodies.extend(lowered.iter().map(|_| body.name.span()));
                bodies.extend(lowered);
                BodyId::new(bodies.len() - 1)
            }));
            self.bodies[n] = placed[n].and_then(Result::ok);
        }
        bodies
    }

    fn body(
        &mut self,
        body: &ast::Body,
        motion: Option<Motion<'g>>,
        parent: Result<Option<BodyId>, Reported>,
        bodies: &[Body<'g>],
        coordinates: &[Coordinate<'g>],
        shapes: &BTreeMap<String, Result<Mass<'g>, Reported>>,
    ) -> Result<Body<'g>, Reported> {
        let (coordinate, own, start) = own_motion(body, motion.as_ref(), coordinates);
        // all parts are lowered before the first error returns, so that the errors of each are reported
        let mass = self.mass_of_body(body, shapes);
        let geometry = self.geometry(&body.name, body.fields.joint.as_ref());
        let moves = geometry.as_ref().is_ok_and(|geometry| geometry.screw.is_some());
        let geometry = geometry.map(|geometry| match motion {
            Some(Motion::Still(at)) => geometry.stopped(at),
            Some(Motion::Following(_, start)) => geometry.moved(start),
            _ => geometry,
        });
        let heading = geometry.as_ref().map_err(|reported| *reported).and_then(|geometry| {
            self.require_no_freedom(body)?;
            self.require_coordinate(body, moves)?;
            self.heading(body, bodies, parent?, geometry, own)
        });
        let motion = heading.as_ref().map(|(_, motion)| motion.clone()).unwrap_or_default();
        let position = motion.of(self.graph, |k| coordinates[k].position);
        let position = start.map_or(position, |start| position + start);
        let rate = motion.of(self.graph, |k| coordinates[k].rate);
        let forces = self.forces(body, position, rate);
        let law = self.law(body);
        let joint = [position, rate].map(|x| Printer::new(self.graph).formula(x.id()));
        let torque = body.fields.torque.as_ref().map(|torque| written(torque, Some(&joint)));
        let ((heading, motion), geometry, forces, law) = (heading?, geometry?, forces?, law?);
        let mass = mass?.map(|mass| (mass, turns(&heading)));
        let (inertia, figures) = self.inertia(&body.name, mass)?;
        Ok(Body {
            name: body.name.to_string(),
            parent: parent?,
            placement: geometry.placement,
            screw: geometry.screw,
            spin: None,
            coordinate,
            motion,
            heading,
            inertia,
            figures,
            force: forces.total,
            passive: forces.passive,
            torque,
            potential: forces.potential,
            law: law.filter(|_| geometry.screw.is_some()),
        })
    }

    /// Checks that a moving joint has a coordinate or a motion, and a fixed joint neither.
    fn require_coordinate(&mut self, body: &ast::Body, moves: bool) -> Result<(), Reported> {
        let name = &body.name;
        if let Some(reported) = body.unread {
            // the missing field may be one that could not be parsed
            let fits = moves == (body.fields.coordinate.is_some() || body.fields.motion.is_some());
            return if fits { Ok(()) } else { Err(reported) };
        }
        if let (true, Some(_)) = (moves, &body.fields.motion) {
            return Ok(());
        }
        if let (false, Some(motion)) = (moves, &body.fields.motion) {
            return Err(self.errors.on(
                Code::Motion,
                motion,
                format_args!("the joint of `{name}` is fixed, so it cannot follow a motion"),
                "remove the motion, or give the joint an axis: `joint: prismatic(x)`",
            ));
        }
        match (moves, &body.fields.coordinate) {
            (true, None) => Err(self.errors.at(
                Code::JointCoordinate,
                name.span(),
                format_args!("the joint of `{name}` moves but has no coordinate"),
                "add `coordinate: name`, or `motion: e(t)` for a driven joint, or make the joint `fixed`",
            )),
            (false, Some(coordinate)) => Err(self.errors.at(
                Code::JointCoordinate,
                coordinate.span(),
                format_args!("the joint of `{name}` is fixed, so it cannot have the coordinate `{coordinate}`"),
                "remove the coordinate, or give the joint an axis: `joint: revolute(z)`",
            )),
            (false, None) => {
                if let Some(stop) = &body.fields.stop {
                    self.errors.on(
                        Code::NoConstraint,
                        &stop.tokens,
                        format_args!("the joint of `{name}` is fixed, so it cannot have a stop"),
                        "remove it, or give the joint an axis and a coordinate",
                    );
                }
                if let Some(force) = body.fields.acting() {
                    self.errors.on(
                        Code::NoEffect,
                        force,
                        format_args!("the joint of `{name}` is fixed, so no force can act along it"),
                        "remove it, or give the joint an axis and a coordinate",
                    );
                }
                Ok(())
            }
            (true, Some(_)) => Ok(()),
        }
    }
}

/// Coordinate that a joint adds to the scene, its motion as a combination of coordinates, and the constant added to it.
fn own_motion<'g>(
    body: &ast::Body,
    motion: Option<&Motion<'g>>,
    coordinates: &[Coordinate<'g>],
) -> (Option<CoordinateId>, Combination, Option<Expr<'g>>) {
    let own = match motion {
        Some(Motion::Following(sum, start)) => return (None, sum.clone(), Some(*start)),
        Some(Motion::Driven(k)) => Some(*k),
        _ => {
            let named = body.fields.coordinate.as_ref();
            let named = named.and_then(|name| coordinates.iter().position(|c| name == &c.name));
            named.map(CoordinateId::new)
        }
    };
    (own, own.map(Combination::one).unwrap_or_default(), None)
}

/// Axes that a body turns about.
fn turns<'g>(heading: &Heading<'g>) -> Turns<'g> {
    match (heading.station, heading.axis) {
        _ if heading.turns_freely() => Turns::Freely,
        (None, None) => Turns::Never,
        (None, Some(axis)) => Turns::About(heading.rest.transpose() * axis),
        (Some(_), _) => Turns::Freely,
    }
}
