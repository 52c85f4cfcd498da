//! How joints turn the bodies that they carry.

use super::Lower;
use super::joint::Geometry;
use crate::ast;
use crate::error::Reported;
use crate::expr::{Graph, Normalizer};
use crate::model::{Body, Combination, Heading, plus_scaled};
use crate::screw::{Vec3, add, identity, mat_mul, mat_vec, sub};

/// How far the small normal forms of axes may grow.
const BUDGET: usize = 100_000;

impl Lower {
    /// How the joint turns its body, and what its relative coordinate is in the coordinates of the scene.
    pub(super) fn heading(
        &mut self,
        body: &ast::Body,
        bodies: &[Body],
        parent: Option<usize>,
        geometry: &Geometry,
        coordinate: Option<usize>,
    ) -> Result<(Heading, Combination), Reported> {
        let own: Combination = coordinate.map(|k| (k, 1)).into_iter().collect();
        let g = &self.graph;
        let before = match parent {
            Some(parent) => bodies[parent].heading.clone(),
            None => Heading {
                station: None,
                axis: None,
                turn: Vec::new(),
                rest: identity(g),
            },
        };
        let rest = mat_mul(g, before.rest, geometry.placement.rotation);
        let zero = [g.zero(); 3];
        let turning = geometry.screw.filter(|screw| screw.angular != zero);
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
        let axis = mat_vec(g, rest, screw.angular);
        let sign = match before.axis {
            None => Some(1),
            Some(group) => parallel(g, group, axis),
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
            let axis = mat_vec(&self.graph, placed, screw.angular);
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
            let turn = plus_scaled(&Vec::new(), &own, sign);
            let motion = plus_scaled(&own, &before.turn, -sign);
            (turn, motion)
        } else {
            (plus_scaled(&before.turn, &own, sign), own)
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

/// Whether two unit vectors are equal for all parameters: 1, or -1 if they are opposite; none where that cannot be proved.
fn parallel(g: &Graph, a: Vec3, b: Vec3) -> Option<i64> {
    let mut normalizer = Normalizer::new(BUDGET);
    let mut vanishes = |g: &Graph, v: Vec3| v.into_iter().all(|x| normalizer.is_zero(g, x) == Ok(true));
    let difference = sub(g, a, b);
    if vanishes(g, difference) {
        return Some(1);
    }
    let sum = add(g, a, b);
    vanishes(g, sum).then_some(-1)
}
