//! Joints: where they sit, and their screw axes.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{self, Axis, JointKind, Read};
use crate::error::Reported;
use crate::expr::{ExprId, Level, Printer};
use crate::model::{Requirement, Rule};
use crate::screw::{Transform, Twist, Vec3, dot, identity, mat_mul, rotation, scale};

/// The geometry of a joint.
#[derive(Debug)]
pub(super) struct Geometry {
    pub(super) placement: Transform,
    /// None for a fixed joint.
    pub(super) screw: Option<Twist>,
}

impl Lower {
    /// The geometry of a joint; a body without one is fixed where its parent is.
    pub(super) fn geometry(&mut self, body: &Ident, joint: Option<&ast::Joint>) -> Result<Geometry, Reported> {
        let Some(joint) = joint else {
            return Ok(Geometry {
                placement: Transform::identity(&self.graph),
                screw: None,
            });
        };
        let place = |what: &str| Place::fixed(format!("the {what} of the joint of `{body}`"));
        let zero = self.graph.zero();
        let at = joint
            .at
            .as_ref()
            .map_or(Ok([zero; 3]), |v| self.vector(v, &place("place")));
        let rpy = joint
            .rpy
            .as_ref()
            .map_or(Ok([zero; 3]), |v| self.vector(v, &place("roll, pitch and yaw")));
        let screw = self.screw(body, &joint.kind);
        let (at, [roll, pitch, yaw]) = (at?, rpy?);
        let g = &self.graph;
        let [x, y, z] = identity(g);
        let (roll, pitch, yaw) = (rotation(g, x, roll), rotation(g, y, pitch), rotation(g, z, yaw));
        let turned = mat_mul(g, pitch, roll);
        let placement = Transform {
            rotation: mat_mul(g, yaw, turned),
            translation: at,
        };
        Ok(Geometry {
            placement,
            screw: screw?,
        })
    }

    /// The normalised screw axis in the joint frame; none for a fixed joint.
    fn screw(&mut self, body: &Ident, kind: &Read<JointKind>) -> Result<Option<Twist>, Reported> {
        let zero = [self.graph.zero(); 3];
        let (angular, linear) = match self.read(kind)? {
            JointKind::Fixed => return Ok(None),
            JointKind::Revolute(axis) => (self.axis(body, axis)?, zero),
            JointKind::Prismatic(axis) => (zero, self.axis(body, axis)?),
            JointKind::Helical { axis, pitch } => {
                let pitch = self.expr(pitch, &Place::fixed(format!("the pitch of the joint of `{body}`")));
                let angular = self.axis(body, axis)?;
                (angular, scale(&self.graph, pitch?, angular))
            }
            JointKind::Screw { components, tokens } => {
                let place = Place::fixed(format!("the screw of the joint of `{body}`"));
                let components = components.each_ref().map(|e| self.expr(e, &place));
                let [wx, wy, wz, vx, vy, vz] = components;
                let (angular, linear) = ([wx?, wy?, wz?], [vx?, vy?, vz?]);
                let turns = angular != zero;
                let Some(length) = self.inverse_length(body, if turns { angular } else { linear }) else {
                    return Err(self.errors.on(
                        tokens,
                        format_args!("the screw of the joint of `{body}` is zero"),
                        "give it a direction to turn about or to slide along",
                    ));
                };
                let g = &self.graph;
                (scale(g, length, angular), scale(g, length, linear))
            }
        };
        Ok(Some(Twist { angular, linear }))
    }

    fn axis(&mut self, body: &Ident, axis: &Read<Axis>) -> Result<Vec3, Reported> {
        match self.read(axis)? {
            Axis::Unit { number, negative } => {
                let mut unit = [self.graph.zero(); 3];
                unit[*number] = self.graph.integer(if *negative { -1 } else { 1 });
                Ok(unit)
            }
            Axis::Vector(given) => {
                let place = Place::fixed(format!("the axis of the joint of `{body}`"));
                let vector = self.vector(given, &place)?;
                let Some(length) = self.inverse_length(body, vector) else {
                    return Err(self.errors.on(
                        &**given,
                        format_args!("the axis of the joint of `{body}` is zero"),
                        "give it a direction; any length will do",
                    ));
                };
                Ok(scale(&self.graph, length, vector))
            }
        }
    }

    /// `1 / |v|`; none for the zero vector. A vector of parameters must not vanish either.
    fn inverse_length(&mut self, body: &Ident, v: Vec3) -> Option<ExprId> {
        let g = &self.graph;
        let square = dot(g, v, v);
        if g.constant(square).is_some_and(|square| square == 0.0) {
            return None;
        }
        let length = g.power(square, crate::expr::ratio(-1, 2));
        if g.level(square) == Level::Parameter {
            let name = Printer::new(g).print(square);
            let text = format!("the axis of the joint of `{body}` must not be zero");
            self.rule(Rule {
                value: square,
                requirement: Requirement::Positive,
                name,
                text,
            });
        }
        Some(length)
    }
}
