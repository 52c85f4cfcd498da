//! How joints turn the bodies that they carry.

use super::Lower;
use super::joint::Geometry;
use crate::ast;
use crate::error::Reported;
use crate::loops::parallel;
use crate::model::{Body, BodyId, Combination, Heading};
use crate::screw::{Mat3, Twist};

impl<'g> Lower<'g> {
    /// How the joint turns its body, and what its relative coordinate is in the coordinates of the scene.
    pub(super) fn heading(
        &mut self,
        body: &ast::Body,
        bodies: &[Body<'g>],
        parent: Option<BodyId>,
        geometry: &Geometry<'g>,
        own: Combination,
    ) -> Result<(Heading<'g>, Combination), Reported> {
        let before = match parent {
            Some(parent) => bodies[parent].heading.clone(),
            None => Heading {
                station: None,
                axis: None,
                turn: Combination::default(),
                rest: Mat3::identity(self.graph),
            },
        };
        let rest = before.rest * geometry.placement.rotation;
        let turning = geometry.screw.filter(Twist::turns);
        let Some(screw) = turning else {
            if let Some(word) = &body.fields.absolute {
                return Err(self.errors.at(
                    word.span(),
                    format_args!("the coordinate of `{}` is no angle", body.name),
                    "`absolute` is for angles measured from ground; leave it out",
                ));
            }
            return Ok((Heading { rest, ..before }, own));
        };
        let axis = rest * screw.angular;
        let sign = match before.axis {
            // the axis stands still in the frame of the body alone
            _ if before.turns_freely() => None,
            None => Some(1),
            Some(group) => parallel(group, axis),
        };
        if let Some(word) = &body.fields.absolute
            && (before.station.is_some() || sign.is_none())
        {
            let fact = format!(
                "`{}` cannot be measured from ground: a joint below it turns about another axis",
                body.name
            );
            return Err(self.errors.at(
                word.span(),
                fact,
                "leave out `absolute`; the coordinate is then relative to the parent",
            ));
        }
        let Some(sign) = sign else {
            let placed = geometry.placement.rotation;
            let axis = placed * screw.angular;
            let heading = Heading {
                station: parent,
                axis: Some(axis),
                turn: own.clone(),
                rest: placed,
            };
            return Ok((heading, own));
        };
        // turn = turn before + sign * motion; an absolute coordinate is the whole turn, seen along its own axis
        let (turn, motion) = if body.fields.absolute.is_some() {
            (own.scaled(sign), own.plus_scaled(-sign, &before.turn))
        } else {
            (before.turn.plus_scaled(sign, &own), own)
        };
        Ok((
            Heading {
                station: before.station,
                axis: before.axis.or(Some(axis)),
                turn,
                rest,
            },
            motion,
        ))
    }
}
