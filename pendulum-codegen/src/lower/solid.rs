//! Solids of uniform density: mass, first moment and inertia about the origin of the body frame.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{Argument, Solid};
use crate::error::{Reported, suggestion};
use crate::expr::{ExprId, ratio};
use crate::model::Requirement;
use crate::screw::{SpatialInertia, Symmetric3, Vec3, add, dot, scale, sub};

impl Lower {
    /// The sum of solids.
    pub(super) fn solids(&mut self, owner: &Ident, solids: &[Solid]) -> Result<SpatialInertia, Reported> {
        if solids.is_empty() {
            let help =
                "list one or more, such as `point(m, [0, -l, 0])`, or leave the field out for a body without mass";
            return Err(self.errors.at(
                owner.span(),
                format_args!("the list of solids of `{owner}` is empty"),
                help,
            ));
        }
        let mut total = Ok(SpatialInertia::zero(&self.graph));
        for solid in solids {
            let part = self.solid(owner, solid);
            total = total.and_then(|total| Ok(total.plus(&self.graph, &part?)));
        }
        total
    }

    fn solid(&mut self, owner: &Ident, solid: &Solid) -> Result<SpatialInertia, Reported> {
        const KINDS: [(&str, &str); 7] = [
            ("point", "point(mass, [x, y, z])"),
            ("rod", "rod(mass, [x, y, z], [x, y, z])"),
            ("disk", "disk(mass, radius, [x, y, z])"),
            ("plate", "plate(mass, [[x, y], [x, y], [x, y]])"),
            ("cuboid", "cuboid(mass, [dx, dy, dz], [x, y, z])"),
            ("cylinder", "cylinder(mass, radius, [x, y, z], [x, y, z])"),
            ("sphere", "sphere(mass, radius, [x, y, z])"),
        ];
        let kind = solid.kind.to_string();
        let Some((_, form)) = KINDS.iter().find(|(known, _)| *known == kind) else {
            let help = suggestion(&kind, KINDS.map(|(known, _)| known));
            return Err(self
                .errors
                .at(solid.kind.span(), format_args!("unknown solid `{kind}`"), help));
        };
        let place = Place::fixed(format!("a {kind} of `{owner}`"));
        let wrong = |lower: &mut Self| {
            Err(lower.errors.at(
                solid.kind.span(),
                format_args!("a {kind} takes other arguments"),
                format_args!("write `{form}`"),
            ))
        };
        let [Argument::Scalar(mass), rest @ ..] = &solid.arguments[..] else {
            return wrong(self);
        };
        let mass = self.positive(
            mass,
            &Place::fixed(format!("the mass of a {kind} of `{owner}`")),
            Requirement::Positive,
        );
        let radius = |lower: &mut Self, e| {
            lower.positive(
                e,
                &Place::fixed(format!("the radius of a {kind} of `{owner}`")),
                Requirement::NonNegative,
            )
        };
        match (kind.as_str(), rest) {
            ("point", [at]) => {
                let at = self.triple(at, &place);
                let zero = Symmetric3::zero(&self.graph);
                Ok(SpatialInertia::of_body(&self.graph, mass?, at?, zero))
            }
            ("rod", [from, to]) => {
                let (from, to) = (self.triple(from, &place), self.triple(to, &place));
                Ok(self.rod(mass?, from?, to?))
            }
            ("disk", [Argument::Scalar(r), at]) => {
                let (r, at) = (radius(self, r), self.triple(at, &place));
                let quarter = self.times_square(mass?, r?, 4);
                let half = self.graph.add(quarter, quarter);
                let moments = Symmetric3::diagonal(&self.graph, [quarter, quarter, half]);
                Ok(SpatialInertia::of_body(&self.graph, mass?, at?, moments))
            }
            ("sphere", [Argument::Scalar(r), at]) => {
                let (r, at) = (radius(self, r), self.triple(at, &place));
                let fifth = self.times_square(mass?, r?, 5);
                let moment = self.graph.add(fifth, fifth);
                let moments = Symmetric3::diagonal(&self.graph, [moment; 3]);
                Ok(SpatialInertia::of_body(&self.graph, mass?, at?, moments))
            }
            ("cuboid", [size @ Argument::List(sides, _), at]) => {
                let (size, at) = (self.triple(size, &place), self.triple(at, &place));
                let (mass, size, at) = (mass?, size?, at?);
                for (side, value) in sides.iter().zip(size) {
                    self.require(
                        side,
                        value,
                        Requirement::NonNegative,
                        &format!("a side of a cuboid of `{owner}`"),
                    );
                }
                let [x, y, z] = size.map(|side| self.times_square(mass, side, 12));
                let g = &self.graph;
                let moments = [g.add(y, z), g.add(x, z), g.add(x, y)];
                let moments = Symmetric3::diagonal(g, moments);
                Ok(SpatialInertia::of_body(g, mass, at, moments))
            }
            ("cylinder", [Argument::Scalar(r), from, to]) => {
                let (r, from, to) = (radius(self, r), self.triple(from, &place), self.triple(to, &place));
                let (mass, r, from, to) = (mass?, r?, from?, to?);
                let rod = self.rod(mass, from, to);
                let axis = sub(&self.graph, to, from);
                let length2 = dot(&self.graph, axis, axis);
                if self.graph.is_zero(length2) {
                    return Err(self.errors.at(
                        solid.kind.span(),
                        format_args!("a cylinder of `{owner}` has no length"),
                        "give two different ends, or write a disk",
                    ));
                }
                // a rod, and a disk about the rod's direction u: m r^2/4 (1 + u u^T)
                let quarter = self.times_square(mass, r, 4);
                let g = &self.graph;
                let along = g.div(quarter, length2);
                let round = Symmetric3::diagonal(g, [quarter; 3]);
                let axial = Symmetric3::outer(g, along, axis);
                let about_origin = rod.about_origin.plus(g, round).plus(g, axial);
                Ok(SpatialInertia { about_origin, ..rod })
            }
            ("plate", [Argument::Points(points, tokens)]) => {
                let corners: Vec<_> = points
                    .iter()
                    .map(|point| {
                        let [x, y] = &point[..] else {
                            let help = format!("write `{form}`");
                            return Err(self.errors.on(tokens, "a corner of a plate has two coordinates", help));
                        };
                        let (x, y) = (self.expr(x, &place), self.expr(y, &place));
                        Ok((x?, y?))
                    })
                    .collect();
                let corners: Vec<_> = corners.into_iter().collect::<Result<_, _>>()?;
                self.plate(owner, mass?, &corners, tokens)
            }
            _ => wrong(self),
        }
    }

    /// `mass * length^2 / divisor`
    fn times_square(&mut self, mass: ExprId, length: ExprId, divisor: i64) -> ExprId {
        let g = &self.graph;
        let square = g.powi(length, 2);
        let product = g.mul(mass, square);
        let factor = g.number(ratio(1, divisor));
        g.mul(factor, product)
    }

    fn rod(&mut self, mass: ExprId, from: Vec3, to: Vec3) -> SpatialInertia {
        let g = &self.graph;
        let both = add(g, from, to);
        let half = g.number(ratio(1, 2));
        let middle = scale(g, half, both);
        let twelfth = g.number(ratio(1, 12));
        let twelfth = g.mul(twelfth, mass);
        let length = sub(g, to, from);
        let moments = Symmetric3::of_point(g, twelfth, length);
        SpatialInertia::of_body(g, mass, middle, moments)
    }

    fn triple(&mut self, argument: &Argument, place: &Place) -> Result<Vec3, Reported> {
        if let Argument::List(entries, _) = argument
            && let [x, y, z] = &entries[..]
        {
            let [x, y, z] = [x, y, z].map(|e| self.expr(e, place));
            return Ok([x?, y?, z?]);
        }
        Err(self.errors.on(
            argument,
            format_args!("expected a point in {}", place.what),
            "write its three coordinates `[x, y, z]`",
        ))
    }
}
