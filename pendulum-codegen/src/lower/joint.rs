//! Joints: where they sit, and their screw axes.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{self, Argument, JointArgument};
use crate::error::{Reported, suggestion};
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
        let screw = self.screw(body, joint);
        let (at, Vec3(rpy)) = (at?, rpy?);
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
    fn screw(&mut self, body: &Ident, joint: &ast::Joint) -> Result<Option<Twist<'g>>, Reported> {
        const KINDS: [(&str, &str); 5] = [
            ("revolute", "revolute(z)"),
            ("prismatic", "prismatic(x)"),
            ("helical", "helical(z, pitch)"),
            ("screw", "screw([wx, wy, wz, vx, vy, vz])"),
            ("fixed", "fixed"),
        ];
        let kind = joint.kind.to_string();
        let Some((_, form)) = KINDS.iter().find(|(known, _)| *known == kind) else {
            return Err(self.errors.at(
                joint.kind.span(),
                format_args!("unknown joint `{kind}`"),
                suggestion(&kind, KINDS.map(|(known, _)| known)),
            ));
        };
        let still = Vec3::zero(self.graph);
        match (kind.as_str(), &joint.arguments[..]) {
            ("fixed", []) => Ok(None),
            ("revolute", [axis]) => {
                let angular = self.axis(body, joint, axis)?;
                Ok(Some(Twist { angular, linear: still }))
            }
            ("prismatic", [axis]) => {
                let linear = self.axis(body, joint, axis)?;
                Ok(Some(Twist { angular: still, linear }))
            }
            ("helical", [axis, JointArgument::Other(Argument::Scalar(pitch))]) => {
                let pitch = self.expr(pitch, &Place::fixed(format!("the pitch of the joint of `{body}`")));
                let angular = self.axis(body, joint, axis)?;
                let linear = pitch? * angular;
                Ok(Some(Twist { angular, linear }))
            }
            ("screw", [JointArgument::Other(Argument::List(entries, tokens))]) if entries.len() == 6 => {
                let place = Place::fixed(format!("the screw of the joint of `{body}`"));
                let entries: Vec<_> = entries.iter().map(|e| self.expr(e, &place)).collect();
                let entries: Vec<_> = entries.into_iter().collect::<Result<_, _>>()?;
                let screw = Twist {
                    angular: Vec3([entries[0], entries[1], entries[2]]),
                    linear: Vec3([entries[3], entries[4], entries[5]]),
                };
                let direction = if screw.turns() { screw.angular } else { screw.linear };
                let Some(length) = self.inverse_length(body, direction) else {
                    return Err(self.errors.on(
                        tokens,
                        format_args!("the screw of the joint of `{body}` is zero"),
                        "give it a direction to turn about or to slide along",
                    ));
                };
                Ok(Some(length * screw))
            }
            _ => Err(self.errors.at(
                joint.kind.span(),
                format_args!("a {kind} joint takes other arguments"),
                format_args!("write `{form}`; an axis is x, y, z, -x, .. or a vector"),
            )),
        }
    }

    fn axis(&mut self, body: &Ident, joint: &ast::Joint, axis: &JointArgument) -> Result<Vec3<'g>, Reported> {
        match axis {
            JointArgument::Axis(n, negative, _) => {
                let unit = Vec3::unit(self.graph, *n);
                Ok(if *negative { -unit } else { unit })
            }
            JointArgument::Other(Argument::List(entries, tokens)) if entries.len() == 3 => {
                let place = Place::fixed(format!("the axis of the joint of `{body}`"));
                let entries: Vec<_> = entries.iter().map(|e| self.expr(e, &place)).collect();
                let entries: Vec<_> = entries.into_iter().collect::<Result<_, _>>()?;
                let vector = Vec3([entries[0], entries[1], entries[2]]);
                let Some(length) = self.inverse_length(body, vector) else {
                    return Err(self.errors.on(
                        tokens,
                        format_args!("the axis of the joint of `{body}` is zero"),
                        "give it a direction; any length will do",
                    ));
                };
                Ok(length * vector)
            }
            JointArgument::Other(Argument::Scalar(e)) => Err(self.errors.on(
                e,
                format_args!("the joint of `{body}` has no such axis"),
                "an axis is x, y, z, -x, -y, -z or a vector `[x, y, z]`",
            )),
            JointArgument::Other(_) => Err(self.errors.at(
                joint.kind.span(),
                format_args!("the axis of the joint of `{body}` is no vector"),
                "write `[x, y, z]`",
            )),
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
