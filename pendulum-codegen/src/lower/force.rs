//! Forces along joints.

use super::Lower;
use super::expr::Place;
use crate::ast;
use crate::error::Reported;
use crate::expr::{ExprId, Level, ratio};
use crate::model::Requirement;

/// What acts along a joint.
#[derive(Debug)]
pub(super) struct Forces {
    /// Friction and spring.
    pub(super) passive: ExprId,
    /// Friction, spring and torque.
    pub(super) total: ExprId,
    /// Potential energy.
    pub(super) potential: ExprId,
}

impl Lower {
    /// The force of the joint along its coordinate.
    pub(super) fn forces(&mut self, body: &ast::Body, position: ExprId, rate: ExprId) -> Result<Forces, Reported> {
        let friction = self.friction(body, (position, rate));
        let spring = self.spring(body, position);
        let place = Place {
            what: format!("the torque of `{}`", body.name),
            most: Level::State,
            joint: Some((position, rate)),
        };
        let torque = body
            .fields
            .torque
            .as_ref()
            .map_or(Ok(self.graph.zero()), |torque| self.expr(torque, &place));
        let (spring, potential) = spring?;
        let passive = self.graph.add(friction?, spring);
        Ok(Forces {
            passive,
            total: self.graph.add(passive, torque?),
            potential,
        })
    }

    fn friction(&mut self, body: &ast::Body, joint: (ExprId, ExprId)) -> Result<ExprId, Reported> {
        let Some(friction) = &body.fields.friction else {
            return Ok(self.graph.zero());
        };
        // the rate is known here so that a law of friction gets the error that says where it belongs
        let place = Place {
            joint: Some(joint),
            ..Place::fixed(format!("the friction of `{}`", body.name))
        };
        let coefficient = self.positive(friction, &place, Requirement::NonNegative)?;
        let product = self.graph.mul(coefficient, joint.1);
        Ok(self.graph.neg(product))
    }

    fn spring(&mut self, body: &ast::Body, position: ExprId) -> Result<(ExprId, ExprId), Reported> {
        let Some((stiffness, rest)) = &body.fields.spring else {
            return Ok((self.graph.zero(), self.graph.zero()));
        };
        let stiffness = self.expr(stiffness, &Place::fixed(format!("the stiffness of `{}`", body.name)));
        let rest = self.expr(rest, &Place::fixed(format!("the rest position of `{}`", body.name)));
        let (stiffness, rest) = (stiffness?, rest?);
        let g = &self.graph;
        let stretch = g.sub(position, rest);
        let pull = g.mul(stiffness, stretch);
        let (square, half) = (g.mul(pull, stretch), g.number(ratio(1, 2)));
        Ok((g.neg(pull), g.mul(half, square)))
    }
}
