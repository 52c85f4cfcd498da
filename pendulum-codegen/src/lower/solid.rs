//! Solids of uniform density: mass, first moment and inertia about the origin of the body frame.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{Argument, Solid};
use crate::error::{Reported, suggestion};
use crate::expr::{Expr, ratio};
use crate::model::Requirement;
use crate::screw::{SpatialInertia, Symmetric3, Vec3};

impl<'g> Lower<'g> {
    /// The sum of solids.
    pub(super) fn solids(&mut self, owner: &Ident, solids: &[Solid]) -> Result<SpatialInertia<'g>, Reported> {
        if solids.is_empty() {
            let help =
                "list one or more, such as `point(m, [0, -l, 0])`, or leave the field out for a body without mass";
            return Err(self.errors.at(
                owner.span(),
                format_args!("the list of solids of `{owner}` is empty"),
                help,
            ));
        }
        let mut total = Ok(SpatialInertia::zero(self.graph));
        for solid in solids {
            let part = self.solid(owner, solid);
            total = total.and_then(|total| Ok(total + part?));
        }
        total
    }

    fn solid(&mut self, owner: &Ident, solid: &Solid) -> Result<SpatialInertia<'g>, Reported> {
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
                Ok(SpatialInertia::of_body(mass?, at?, Symmetric3::zero(self.graph)))
            }
            ("rod", [from, to]) => {
                let (from, to) = (self.triple(from, &place), self.triple(to, &place));
                Ok(rod(mass?, from?, to?))
            }
            ("disk", [Argument::Scalar(r), at]) => {
                let (r, at) = (radius(self, r), self.triple(at, &place));
                let quarter = times_square(mass?, r?, 4);
                let moments = Symmetric3::diagonal([quarter, quarter, 2 * quarter]);
                Ok(SpatialInertia::of_body(mass?, at?, moments))
            }
            ("sphere", [Argument::Scalar(r), at]) => {
                let (r, at) = (radius(self, r), self.triple(at, &place));
                let moment = 2 * times_square(mass?, r?, 5);
                let moments = Symmetric3::diagonal([moment; 3]);
                Ok(SpatialInertia::of_body(mass?, at?, moments))
            }
            ("cuboid", [size @ Argument::List(sides, _), at]) => {
                let (size, at) = (self.triple(size, &place), self.triple(at, &place));
                let (mass, size, at) = (mass?, size?, at?);
                for (side, value) in sides.iter().zip(size.0) {
                    self.require(
                        side,
                        value,
                        Requirement::NonNegative,
                        &format!("a side of a cuboid of `{owner}`"),
                    );
                }
                let [x, y, z] = size.0.map(|side| times_square(mass, side, 12));
                let moments = Symmetric3::diagonal([y + z, x + z, x + y]);
                Ok(SpatialInertia::of_body(mass, at, moments))
            }
            ("cylinder", [Argument::Scalar(r), from, to]) => {
                let (r, from, to) = (radius(self, r), self.triple(from, &place), self.triple(to, &place));
                let (mass, r, from, to) = (mass?, r?, from?, to?);
                let rod = rod(mass, from, to);
                let axis = to - from;
                let length2 = axis.dot(axis);
                if length2.is_zero() {
                    return Err(self.errors.at(
                        solid.kind.span(),
                        format_args!("a cylinder of `{owner}` has no length"),
                        "give two different ends, or write a disk",
                    ));
                }
                // a rod, and a disk about the rod's direction u: m r^2/4 (1 + u u^T)
                let quarter = times_square(mass, r, 4);
                let disk = Symmetric3::diagonal([quarter; 3]);
                let axial = Symmetric3::outer(quarter / length2, axis);
                Ok(SpatialInertia {
                    about_origin: rod.about_origin + disk + axial,
                    ..rod
                })
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

    fn triple(&mut self, argument: &Argument, place: &Place<'g>) -> Result<Vec3<'g>, Reported> {
        if let Argument::List(entries, _) = argument
            && let [x, y, z] = &entries[..]
        {
            let [x, y, z] = [x, y, z].map(|e| self.expr(e, place));
            return Ok(Vec3([x?, y?, z?]));
        }
        Err(self.errors.on(
            argument,
            format_args!("expected a point in {}", place.what),
            "write its three coordinates `[x, y, z]`",
        ))
    }
}

/// `mass * length^2 / divisor`
fn times_square<'g>(mass: Expr<'g>, length: Expr<'g>, divisor: i64) -> Expr<'g> {
    ratio(1, divisor) * (mass * length.powi(2))
}

fn rod<'g>(mass: Expr<'g>, from: Vec3<'g>, to: Vec3<'g>) -> SpatialInertia<'g> {
    let middle = ratio(1, 2) * (from + to);
    let moments = Symmetric3::of_point(ratio(1, 12) * mass, to - from);
    SpatialInertia::of_body(mass, middle, moments)
}
