//! Joints: placement and screw axis.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::measure::Measure;
use crate::ast::{self, Axis, ExprKind, JointKind, Measured, Read};
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, Printer, ratio};
use crate::model::{Requirement, Rule};
use crate::screw::{Mat3, Transform, Twist, Vec3};
use crate::units::Power;

/// The geometry of a joint.
#[derive(Debug)]
pub(super) struct Geometry<'g> {
    pub(super) placement: Transform<'g>,
    /// Screw axis; none for a fixed joint.
    pub(super) screw: Option<Twist<'g>>,
}

/// Rotation by roll, pitch and yaw, about the fixed x, then y, then z axis.
pub(super) fn rotation(Vec3(rpy): Vec3<'_>) -> Mat3<'_> {
    let g = rpy[0].graph();
    let [roll, pitch, yaw] = [0, 1, 2].map(|k| Mat3::rotation(Vec3::unit(g, k), rpy[k]));
    yaw * (pitch * roll)
}

impl<'g> Geometry<'g> {
    /// The joint with the origin of its coordinate moved to the value `at`.
    pub(super) fn moved(self, at: Expr<'g>) -> Self {
        let screw = self.screw;
        // motion along a screw leaves the screw unchanged
        Self {
            screw,
            ..self.stopped(at)
        }
    }

    /// The joint fixed at a value of its coordinate.
    pub(super) fn stopped(self, at: Expr<'g>) -> Self {
        let Some(Twist { angular: w, linear: v }) = self.screw else {
            return self;
        };
        // exp(s q) of a normalised screw: a rotation about the axis through w x v, and a translation along it
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
    /// Geometry of a joint. A body without a joint is fixed to its parent and shares its frame.
    pub(super) fn geometry(&mut self, body: &Ident, joint: Option<&ast::Joint>) -> Result<Geometry<'g>, Reported> {
        let Some(joint) = joint else {
            return Ok(Geometry {
                placement: Transform::identity(self.graph),
                screw: None,
            });
        };
        let place =
            |what: &str, unit: &'static str| Place::fixed(format!("the {what} of the joint of `{body}`")).in_unit(unit);
        let zero = Vec3::zero(self.graph);
        let at = joint
            .at
            .as_ref()
            .map_or(Ok(zero), |v| self.vector(v, &place("position", "m")));
        let rpy = joint
            .rpy
            .as_ref()
            .map_or(Ok(zero), |v| self.vector(v, &place("angle", "rad")));
        let screw = self.screw(body, &joint.kind);
        let (at, rpy) = (at?, rpy?);
        let placement = Transform {
            rotation: rotation(rpy),
            translation: at,
        };
        Ok(Geometry {
            placement,
            screw: screw?,
        })
    }

    /// Normalised screw axis in the joint frame; none for a fixed joint.
    fn screw(&mut self, body: &Ident, kind: &Read<JointKind>) -> Result<Option<Twist<'g>>, Reported> {
        let zero = Vec3::zero(self.graph);
        let place = |what: &str| Place::fixed(format!("the {what} of the joint of `{body}`"));
        let (angular, linear) = match self.read(kind)? {
            JointKind::Fixed | JointKind::Ball | JointKind::Free => return Ok(None),
            JointKind::Revolute(axis) => (self.axis(body, axis)?, zero),
            JointKind::Prismatic(axis) => (zero, self.axis(body, axis)?),
            JointKind::Helical { axis, pitch } => {
                if let ExprKind::Measured(measured) = &pitch.kind
                    && !measured
                        .unit
                        .names()
                        .any(|name| ["rad", "mrad", "deg", "turn"].contains(&name))
                {
                    let Measured { digits, unit, .. } = &**measured;
                    let fact = format_args!("the pitch of the joint of `{body}` is a length, not a length per angle");
                    let help = format_args!("write `{digits} {0}/turn` or `{digits} {0}/rad`", unit.text);
                    self.errors.on(Code::UnitMismatch, pitch, fact, help);
                }
                let pitch = self.expr(pitch, &place("pitch").in_unit("m/rad"));
                let angular = self.axis(body, axis)?;
                (angular, pitch? * angular)
            }
            JointKind::Screw { components, tokens } => {
                let [wx, wy, wz, vx, vy, vz] = &**components;
                let angular = self.direction([wx, wy, wz], &place("screw"));
                let linear = self.direction([vx, vy, vz], &place("screw"));
                let ((angular, of_angular), (linear, of_linear)) = (angular?, linear?);
                if !angular.is_zero() {
                    let needed = of_angular.times(Measure::of("m"), Power::from(1));
                    self.require_alike([wx, vx], [needed, of_linear], "parts of one screw");
                }
                let direction = if angular.is_zero() { linear } else { angular };
                let Some(length) = self.inverse_length(body, direction) else {
                    return Err(self.errors.on(
                        Code::OutOfBounds,
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

    pub(super) fn axis(&mut self, body: &Ident, axis: &Read<Axis>) -> Result<Vec3<'g>, Reported> {
        match self.read(axis)? {
            Axis::Unit { number, negative } => {
                let unit = Vec3::unit(self.graph, *number);
                Ok(if *negative { -unit } else { unit })
            }
            Axis::Vector(given) => {
                let place = Place::fixed(format!("the axis of the joint of `{body}`"));
                let (vector, _) = self.direction(given.components.each_ref(), &place)?;
                let Some(length) = self.inverse_length(body, vector) else {
                    return Err(self.errors.on(
                        Code::OutOfBounds,
                        &**given,
                        format_args!("the axis of the joint of `{body}` is zero"),
                        "give it a direction; any length will do",
                    ));
                };
                Ok(length * vector)
            }
        }
    }

    /// Three components in one common unit, and their measure.
    fn direction(&mut self, given: [&ast::Expr; 3], place: &Place<'g>) -> Result<(Vec3<'g>, Measure), Reported> {
        let [x, y, z] = given.map(|e| self.quantity(e, place));
        let [x, y, z] = [x?, y?, z?];
        let (mut first, mut measure) = (given[0], x.measure);
        for (e, other) in given.into_iter().zip([x, y, z]).skip(1) {
            if measure == Measure::Number {
                // a bare number, such as 0, takes any unit
                (first, measure) = (e, other.measure);
            }
            measure = self.require_alike([first, e], [measure, other.measure], "components of one direction");
        }
        Ok((Vec3([x.value, y.value, z.value]), measure))
    }

    /// `1 / |v|`; none for the zero vector. If `v` contains parameters, a rule requires that it is not zero.
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
