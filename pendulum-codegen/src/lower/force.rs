//! Forces along joints.

use super::Lower;
use super::expr::Place;
use super::joint_units::JointUnits;
use super::measure::Quantity;
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, ratio};
use crate::model::{Requirement, Rule};

/// Forces along a joint.
#[derive(Debug)]
pub(super) struct Forces<'g> {
    /// Friction and spring.
    pub(super) passive: Expr<'g>,
    /// Friction, spring and torque.
    pub(super) total: Expr<'g>,
    /// Potential energy.
    pub(super) potential: Expr<'g>,
}

impl<'g> Lower<'g> {
    /// Lowers the forces of a joint along its coordinate.
    pub(super) fn forces(
        &mut self,
        body: &ast::Body,
        position: Expr<'g>,
        rate: Expr<'g>,
    ) -> Result<Forces<'g>, Reported> {
        let units = JointUnits::of(body);
        let measure = units.measure();
        let joint = [(position, measure), (rate, measure.rate())].map(|(value, measure)| Quantity { value, measure });
        let friction = self.friction(body, units, joint);
        let spring = self.spring(body, units, position);
        let place = Place {
            joint: Some(joint),
            ..Place::moving(format!("the torque of `{}`", body.name)).in_unit(units.force())
        };
        let torque = body
            .fields
            .torque
            .as_ref()
            .map_or(Ok(self.graph.zero()), |torque| self.expr(torque, &place));
        let (spring, potential) = spring?;
        let passive = friction? + spring;
        Ok(Forces {
            passive,
            total: passive + torque?,
            potential,
        })
    }

    fn friction(
        &mut self,
        body: &ast::Body,
        units: JointUnits,
        joint: [Quantity<'g>; 2],
    ) -> Result<Expr<'g>, Reported> {
        let Some(friction) = &body.fields.friction else {
            return Ok(self.graph.zero());
        };
        // `q` and `qd` are allowed, so that a friction law gets the error with help on how to write it
        let place = Place {
            joint: Some(joint),
            ..Place::fixed(format!("the friction of `{}`", body.name)).in_unit(units.friction())
        };
        let coefficient = self.positive(friction, &place, Requirement::NonNegative)?;
        Ok(-(coefficient * joint[1].value))
    }

    fn spring(
        &mut self,
        body: &ast::Body,
        units: JointUnits,
        position: Expr<'g>,
    ) -> Result<(Expr<'g>, Expr<'g>), Reported> {
        let Some((stiffness, rest)) = &body.fields.spring else {
            return Ok((self.graph.zero(), self.graph.zero()));
        };
        let instead = "it must not be negative: write a repelling force as `torque: ..`";
        let of_stiffness = Place::fixed(format!("the stiffness of `{}`", body.name)).in_unit(units.stiffness());
        let of_rest = Place::fixed(format!("the rest position of `{}`", body.name)).in_unit(units.coordinate());
        let stiffness = self.stiffness(stiffness, &of_stiffness, instead);
        let rest = self.expr(rest, &of_rest);
        let (stiffness, rest) = (stiffness?, rest?);
        let stretch = position - rest;
        let pull = stiffness * stretch;
        Ok((-pull, ratio(1, 2) * (pull * stretch)))
    }

    /// Lowers the stiffness of a spring, which must not be negative.
    pub(super) fn stiffness(
        &mut self,
        stiffness: &ast::Expr,
        place: &Place<'g>,
        instead: &str,
    ) -> Result<Expr<'g>, Reported> {
        self.expr(stiffness, place).and_then(|value| match value.constant() {
            Some(number) if number < 0.0 => Err(self.errors.on(
                Code::OutOfBounds,
                stiffness,
                format_args!("{} is {number}", place.what),
                instead,
            )),
            _ => {
                if value.level() == Level::Parameter {
                    self.for_defaults.push(Rule {
                        value,
                        requirement: Requirement::NonNegative,
                        name: String::new(),
                        text: format!("{} must not be negative", place.what),
                    });
                }
                Ok(value)
            }
        })
    }
}
