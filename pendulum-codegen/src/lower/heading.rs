//! Orientations of bodies, as their joints determine them.

use super::Lower;
use super::joint::Geometry;
use crate::ast;
use crate::error::{Code, Reported};
use crate::loops::parallel;
use crate::model::{Body, BodyId, Combination, Heading};
use crate::screw::{Mat3, Twist, Vec3};

impl<'g> Lower<'g> {
    /// Orientation of a body, and its relative joint coordinate as a combination of the coordinates of the scene.
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
            None => Heading::unturned(None, Mat3::identity(self.graph)),
        };
        let rest = before.rest * geometry.placement.rotation;
        let absolute = body.fields.absolute.as_ref();
        let Some(screw) = geometry.screw.filter(Twist::turns) else {
            let Some(word) = absolute else {
                return Ok((Heading { rest, ..before }, own));
            };
            let fact = format_args!("the coordinate of `{}` is not an angle", body.name);
            let help = "remove `absolute`: it is for angles measured from ground";
            return Err(self.errors.at(Code::Absolute, word.span(), fact, help));
        };
        let axis = rest * screw.angular;
        let sign = before.sign_about(axis);
        if let Some(word) = absolute
            && (before.station.is_some() || sign.is_none())
        {
            let fact = format_args!(
                "`{}` cannot be measured from ground: a joint between them turns about another axis, or is a ball \
                 or free joint",
                body.name
            );
            let help = "remove `absolute`: the coordinate is then relative to the parent";
            return Err(self.errors.at(Code::Absolute, word.span(), fact, help));
        }
        let Some(sign) = sign else {
            let mut heading = Heading::unturned(parent, geometry.placement.rotation);
            heading.axis = Some(heading.rest * screw.angular);
            heading.turn = own.clone();
            return Ok((heading, own));
        };
        // turn = turn before + sign * motion; an absolute coordinate is the whole turn, about its own axis
        let (turn, motion) = if absolute.is_some() {
            (own.scaled(sign), own.plus_scaled(-sign, &before.turn))
        } else {
            (before.turn.plus_scaled(sign, &own), own)
        };
        let axis = before.axis.or(Some(axis));
        let heading = Heading {
            axis,
            turn,
            rest,
            ..before
        };
        Ok((heading, motion))
    }
}

impl<'g> Heading<'g> {
    /// An orientation without any turn in its station.
    pub(super) fn unturned(station: Option<BodyId>, rest: Mat3<'g>) -> Self {
        Self {
            station,
            axis: None,
            turn: Combination::default(),
            rest,
        }
    }

    /// Sign of a further turn about an axis; none if it is not parallel to the axis of the turns before it.
    fn sign_about(&self, axis: Vec3<'g>) -> Option<i64> {
        match self.axis {
            // after a quaternion, an axis is fixed only in the frame of the body
            _ if self.turns_freely() => None,
            None => Some(1),
            Some(group) => parallel(group, axis),
        }
    }
}
