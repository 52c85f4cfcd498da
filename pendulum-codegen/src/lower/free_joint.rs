//! Ball and free joints, as series of single joints.

use std::collections::BTreeMap;
use std::mem::replace;

use syn::Ident;

use super::Lower;
use super::components::first_of;
use super::expr::Place;
use super::freedom::ORIENTATION;
use super::joint_units::JointUnits;
use super::mass::{Mass, Turns};
use super::scope::Kind;
use crate::ast;
use crate::error::Reported;
use crate::expr::Expr;
use crate::model::{Body, BodyId, Combination, Coordinate, CoordinateId, Heading, Requirement};
use crate::screw::{Mat3, SpatialInertia, Transform, Twist, Vec3};

impl<'g> Lower<'g> {
    /// Lowers a ball or free joint to bodies in series, massless except the last: three slides for a free joint, then
    /// three turns. The rotation by the quaternion belongs to the first turn.
    pub(super) fn free_bodies(
        &mut self,
        body: &ast::Body,
        slides: bool,
        parent: Result<Option<BodyId>, Reported>,
        bodies: &[Body<'g>],
        coordinates: &[Coordinate<'g>],
        shapes: &BTreeMap<String, Result<Mass<'g>, Reported>>,
    ) -> Result<Vec<Body<'g>>, Reported> {
        // all parts are lowered before the first error returns, so that the errors of each are reported
        let mass = self.mass_of_body(body, shapes);
        let geometry = self.geometry(&body.name, body.fields.joint.as_ref());
        let fits = self.check_freedom(body, slides);
        let friction = self.friction_of_turns(body, slides);
        let (mass, placement, friction, parent) = (mass?, geometry?.placement, friction?, parent?);
        fits?;
        let (inertia, figures) = self.inertia(&body.name, mass.map(|mass| (mass, Turns::Freely)))?;
        let first = |name: &Option<Ident>, kind| first_of(coordinates, name.as_ref()?, kind);
        let Some(turning) = first(&body.fields.orientation, Kind::Orientation) else {
            return Err(self.missing(body, ORIENTATION));
        };
        let mut row = Row {
            name: body.name.to_string(),
            behind: bodies.len(),
            coordinates,
            friction,
            parent,
            carried_by: parent.map(|parent| bodies[parent].heading.clone()),
            placement,
            bodies: Vec::new(),
        };
        if let Some(sliding) = first(&body.fields.position, Kind::Position) {
            row.slide(sliding);
        }
        row.turn(turning);
        let mut bodies = row.bodies;
        if let Some(last) = bodies.last_mut() {
            (last.inertia, last.figures) = (inertia, figures);
        }
        Ok(bodies)
    }

    /// Friction of a ball joint; zero for a free joint, which touches nothing.
    fn friction_of_turns(&mut self, body: &ast::Body, slides: bool) -> Result<Expr<'g>, Reported> {
        let place = Place::fixed(format!("the friction of `{}`", body.name)).in_unit(JointUnits::Turns.friction());
        let friction = body.fields.friction.as_ref().filter(|_| !slides);
        friction.map_or(Ok(self.graph.zero()), |e| {
            self.positive(e, &place, Requirement::NonNegative)
        })
    }
}

/// A series of massless bodies, each the parent of the next.
struct Row<'c, 'g> {
    name: String,
    /// Index of the first body of the series.
    behind: usize,
    coordinates: &'c [Coordinate<'g>],
    friction: Expr<'g>,
    /// Parent of the next body.
    parent: Option<BodyId>,
    /// Orientation of that parent.
    carried_by: Option<Heading<'g>>,
    /// Placement of the next joint.
    placement: Transform<'g>,
    bodies: Vec<Body<'g>>,
}

impl<'g> Row<'_, 'g> {
    /// Appends three slides along the axes of the joint.
    fn slide(&mut self, first: usize) {
        let g = self.friction.graph();
        for (n, k) in (0..3).zip(first..) {
            let screw = Twist {
                angular: Vec3::zero(g),
                linear: Vec3::unit(g, n),
            };
            self.hang(k, screw, None, None);
        }
    }

    /// Appends three turns, the first of which has the quaternion and the whole angular velocity.
    fn turn(&mut self, first: usize) {
        let g = self.friction.graph();
        let rotation = Mat3::of_quaternion([0, 1, 2, 3].map(|n| self.coordinates[first].changes[n].0));
        let mut turned = Some(rotation);
        let mut spin = Vec3([0, 1, 2].map(|n| self.coordinates[first + n].rate));
        for (n, k) in (0..3).zip(first..) {
            let screw = Twist {
                angular: Vec3::unit(g, n),
                linear: Vec3::zero(g),
            };
            self.hang(k, screw, turned.take(), Some(spin));
            spin = Vec3::zero(g);
        }
    }

    /// Appends a body whose joint has the coordinate of number `k`.
    fn hang(&mut self, k: usize, screw: Twist<'g>, turned: Option<Mat3<'g>>, spin: Option<Vec3<'g>>) {
        let g = self.friction.graph();
        let identity = Transform::identity(g);
        let placement = replace(&mut self.placement, identity)
            * Transform {
                rotation: turned.unwrap_or(identity.rotation),
                ..identity
            };
        let heading = match self.carried_by.take() {
            Some(before) if turned.is_none() => Heading {
                rest: before.rest * placement.rotation,
                ..before
            },
            _ => Heading::unturned(self.parent, placement.rotation),
        };
        let force = spin.map_or(g.zero(), |_| -(self.friction * self.coordinates[k].rate));
        let (own, k) = (BodyId::new(self.behind + self.bodies.len()), CoordinateId::new(k));
        self.bodies.push(Body {
            name: self.name.clone(),
            parent: self.parent.replace(own),
            placement,
            screw: Some(screw),
            spin,
            coordinate: Some(k),
            motion: Combination::one(k),
            heading: heading.clone(),
            inertia: SpatialInertia::zero(g),
            figures: Vec::new(),
            force,
            passive: force,
            torque: None,
            potential: g.zero(),
            law: None,
        });
        self.carried_by = Some(heading);
    }
}
