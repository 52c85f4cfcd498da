//! Bodies: joint, mass and forces together.

use std::collections::BTreeMap;

use super::Lower;
use super::mass::{Mass, Turns};
use crate::ast;
use crate::model::{Body, Coordinate, combine};
use crate::screw::{SpatialInertia, mat_vec, transpose};

impl Lower {
    /// The bodies, each after its parent. Those with an error are left out.
    pub(super) fn bodies(
        &mut self,
        declared: &[ast::Body],
        order: Vec<usize>,
        coordinates: &[Coordinate],
        shapes: &BTreeMap<String, Option<Mass>>,
    ) -> Vec<Body> {
        let mut bodies = Vec::new();
        for body in order.into_iter().map(|n| &declared[n]) {
            if let Some(lowered) = self.body(body, &bodies, coordinates, shapes) {
                self.placed.insert(lowered.name.clone(), bodies.len());
                bodies.push(lowered);
            }
        }
        bodies
    }

    fn body(
        &mut self,
        body: &ast::Body,
        bodies: &[Body],
        coordinates: &[Coordinate],
        shapes: &BTreeMap<String, Option<Mass>>,
    ) -> Option<Body> {
        let own = body
            .coordinate
            .as_ref()
            .and_then(|name| coordinates.iter().position(|c| name == &c.name));
        let mass = self.mass_of_body(body, shapes);
        let geometry = self.geometry(&body.name, body.joint.as_ref());
        let joint_works = self.joint_fits_coordinate(body, geometry.as_ref().map(|g| g.screw.is_some()));
        let parent = self.index_of_parent(body);
        let parent_known = body.parent == "ground" || parent.is_some();
        let heading = geometry
            .as_ref()
            .filter(|_| parent_known && joint_works)
            .and_then(|geometry| {
                let parent = parent.map(|p| &bodies[p]);
                self.heading(body, parent, geometry, own)
            });
        let motion = heading.as_ref().map(|(_, motion)| motion.clone()).unwrap_or_default();
        let position = combine(&self.graph, coordinates, &motion, |c| c.position);
        let rate = combine(&self.graph, coordinates, &motion, |c| c.rate);
        let forces = self.forces(body, position, rate);
        let ((heading, motion), geometry, (force, potential)) = (heading?, geometry?, forces?);
        let inertia = match mass? {
            None => SpatialInertia::zero(&self.graph),
            Some(mass) => {
                let turns = match (heading.station, heading.axis) {
                    (None, Some(axis)) => {
                        let back = transpose(heading.rest);
                        Turns::About(mat_vec(&self.graph, back, axis))
                    }
                    (None, None) => Turns::Never,
                    (Some(_), _) => Turns::Freely,
                };
                mass.of_body(self, &body.name, turns)?
            }
        };
        Some(Body {
            name: body.name.to_string(),
            parent,
            placement: geometry.placement,
            screw: geometry.screw,
            coordinate: own,
            motion,
            heading,
            inertia,
            force,
            potential,
        })
    }

    fn joint_fits_coordinate(&mut self, body: &ast::Body, moves: Option<bool>) -> bool {
        let name = &body.name;
        if body.unread {
            return moves == Some(body.coordinate.is_some());
        }
        match (moves, &body.coordinate) {
            (Some(true), None) => {
                self.errors.at(
                    name.span(),
                    format_args!("the joint of `{name}` moves but has no coordinate"),
                    "add `coordinate: name`, or make the joint `fixed`",
                );
                false
            }
            (Some(false), Some(coordinate)) => {
                self.errors.at(
                    coordinate.span(),
                    format_args!("the joint of `{name}` is fixed, so `{coordinate}` cannot change"),
                    "remove the coordinate, or give the joint an axis: `joint: revolute(z)`",
                );
                false
            }
            (Some(false), None) => {
                let spring = body.spring.as_ref().map(|(stiffness, _)| stiffness);
                if let Some(force) = body.friction.as_ref().or(spring).or(body.torque.as_ref()) {
                    self.errors.on(
                        force,
                        format_args!("the joint of `{name}` is fixed, so no force can act along it"),
                        "remove it, or give the joint an axis and a coordinate",
                    );
                }
                true
            }
            _ => true,
        }
    }

    pub(super) fn index_of_parent(&self, body: &ast::Body) -> Option<usize> {
        self.placed.get(&body.parent.to_string()).copied()
    }
}
