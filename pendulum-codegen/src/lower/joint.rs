//! Joints: where they sit, and their screw axes.

use std::f64::consts::TAU;

use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{self, Axis, JointKind, Read};
use crate::error::Reported;
use crate::expr::{Expr, Level, Printer, ratio};
use crate::model::{Requirement, Rule};
use crate::screw::{Mat3, Transform, Twist, Vec3};

/// The geometry of a joint.
#[derive(Debug)]
pub(super) struct Geometry<'g> {
    pub(super) placement: Transform<'g>,
    /// None for a fixed joint.
    pub(super) screw: Option<Twist<'g>>,
}

impl<'g> Geometry<'g> {
    /// A fixed joint, where this one is at a value of its coordinate.
    pub(super) fn stopped(self, at: Expr<'g>) -> Self {
        let Some(Twist { angular: w, linear: v }) = self.screw else {
            return self;
        };
        // exp(s q) of a normalised screw: a turn about the axis through w x v, and a slide along it
        let rotation = if w.is_zero() {
            Mat3::identity(at.graph())
        } else {
            Mat3::rotation(w, at)
        };
        let (arm, slide) = if w.is_zero() {
            (w, at * v)
        } else {
            (w.cross(v), (at * w.dot(v)) * w)
        };
        let moved = Transform {
            rotation,
            translation: arm - rotation * arm + slide,
        };
        Self {
            placement: self.placement * moved,
            screw: None,
        }
    }
}

impl<'g> Lower<'g> {
    /// The geometry of a joint; a body without one is fixed where its parent is.
    pub(super) fn geometry(&mut self, body: &Ident, joint: Option<&ast::Joint>) -> Result<Geometry<'g>, Reported> {
        let Some(joint) = joint else {
            return Ok(Geometry {
                placement: Transform::identity(self.graph),
                screw: None,
            });
        };
        let place = |what: &str| Place::fixed(format!("the {what} of the joint of `{body}`"));
        let zero = Vec3::zero(self.graph);
        let at = joint.at.as_ref().map_or(Ok(zero), |v| self.vector(v, &place("place")));
        let rpy = joint
            .rpy
            .as_ref()
            .map_or(Ok(zero), |v| self.vector(v, &place("roll, pitch and yaw")));
        let screw = self.screw(body, &joint.kind);
        let (at, Vec3(rpy)) = (at?, rpy?);
        for (angle, given) in rpy.iter().zip(joint.rpy.iter().flat_map(|rpy| &rpy.components)) {
            if let Some(angle) = angle.constant().filter(|angle| angle.abs() > TAU) {
                let fact = format_args!("an angle of the joint of `{body}` is larger than a turn");
                let help = format_args!("angles are in rad: write `{angle}*pi/180` for {angle} degrees");
                self.errors.on(given, fact, help);
            }
        }
        let [roll, pitch, yaw] = [0, 1, 2].map(|k| Mat3::rotation(Vec3::unit(self.graph, k), rpy[k]));
        let placement = Transform {
            rotation: yaw * (pitch * roll),
            translation: at,
        };
        Ok(Geometry {
            placement,
            screw: screw?,
        })
    }

    /// The normalised screw axis in the joint frame; none for a fixed joint.
    fn screw(&mut self, body: &Ident, kind: &Read<JointKind>) -> Result<Option<Twist<'g>>, Reported> {
        let zero = Vec3::zero(self.graph);
        let (angular, linear) = match self.read(kind)? {
            JointKind::Fixed => return Ok(None),
            JointKind::Revolute(axis) => (self.axis(body, axis)?, zero),
            JointKind::Prismatic(axis) => (zero, self.axis(body, axis)?),
            JointKind::Helical { axis, pitch } => {
                let pitch = self.expr(pitch, &Place::fixed(format!("the pitch of the joint of `{body}`")));
                let angular = self.axis(body, axis)?;
                (angular, pitch? * angular)
            }
            JointKind::Screw { components, tokens } => {
                let place = Place::fixed(format!("the screw of the joint of `{body}`"));
                let components = components.each_ref().map(|e| self.expr(e, &place));
                let [wx, wy, wz, vx, vy, vz] = components;
                let (angular, linear) = (Vec3([wx?, wy?, wz?]), Vec3([vx?, vy?, vz?]));
                let direction = if angular.is_zero() { linear } else { angular };
                let Some(length) = self.inverse_length(body, direction) else {
                    return Err(self.errors.on(
                        tokens,
                        format_args!("the screw of the joint of `{body}` is zero"),
                        "give it a direction to turn about or to slide along",
                    ));
                };
                (length * angular, length * linear)
            }
        };
        Ok(Some(Twist { angular, linear }))
    }

    fn axis(&mut self, body: &Ident, axis: &Read<Axis>) -> Result<Vec3<'g>, Reported> {
        match self.read(axis)? {
            Axis::Unit { number, negative } => {
                let unit = Vec3::unit(self.graph, *number);
                Ok(if *negative { -unit } else { unit })
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
                Ok(length * vector)
            }
        }
    }

    /// `1 / |v|`; none for the zero vector. A vector of parameters must not vanish either.
    fn inverse_length(&mut self, body: &Ident, v: Vec3<'g>) -> Option<Expr<'g>> {
        let square = v.dot(v);
        if square.constant().is_some_and(|square| square == 0.0) {
            return None;
        }
        let length = square.power(ratio(-1, 2));
        if square.level() == Level::Parameter {
            let name = Printer::new(self.graph).print(square.id());
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
