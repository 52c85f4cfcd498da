//! Solids of uniform density: mass, first moment and inertia about the origin of the body frame.

use proc_macro2::TokenStream;
use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{Expr, Read, Solid, SolidKind, Vector};
use crate::error::Reported;
use crate::expr::{ExprId, ratio};
use crate::model::Requirement;
use crate::screw::{SpatialInertia, Symmetric3, Vec3, add, dot, scale, sub};

/// What all solids have: a name for errors, and a mass, whose error does not keep the rest from being read.
struct Common<'a> {
    /// The body or shape.
    owner: &'a Ident,
    word: &'a Ident,
    /// ``a rod of `arm` ``
    place: Place,
    mass: Result<ExprId, Reported>,
}

impl Lower {
    /// The sum of solids.
    pub(super) fn solids(&mut self, owner: &Ident, solids: &[Read<Solid>]) -> Result<SpatialInertia, Reported> {
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

    fn solid(&mut self, owner: &Ident, solid: &Read<Solid>) -> Result<SpatialInertia, Reported> {
        let Solid { word, mass, kind } = self.read(solid)?;
        let place = Place::fixed(format!("a {word} of `{owner}`"));
        let of_mass = Place::fixed(format!("the mass of {}", place.what));
        let mass = self.positive(mass, &of_mass, Requirement::Positive);
        let common = Common {
            owner,
            word,
            place,
            mass,
        };
        match self.read(kind)? {
            SolidKind::Point { at } => self.point(&common, at),
            SolidKind::Rod { from, to } => self.rod(&common, from, to),
            SolidKind::Disk { radius, at } => self.disk(&common, radius, at),
            SolidKind::Plate { corners, tokens } => self.plate(&common, corners, tokens),
            SolidKind::Cuboid { sides, at } => self.cuboid(&common, sides, at),
            SolidKind::Cylinder { radius, from, to } => self.cylinder(&common, radius, from, to),
            SolidKind::Sphere { radius, at } => self.sphere(&common, radius, at),
        }
    }

    fn point(&mut self, solid: &Common, at: &Read<Vector>) -> Result<SpatialInertia, Reported> {
        let at = self.vector_of(solid, at)?;
        let zero = Symmetric3::zero(&self.graph);
        Ok(SpatialInertia::of_body(&self.graph, solid.mass?, at, zero))
    }

    fn rod(&mut self, solid: &Common, from: &Read<Vector>, to: &Read<Vector>) -> Result<SpatialInertia, Reported> {
        let (from, to) = (self.vector_of(solid, from), self.vector_of(solid, to));
        Ok(self.uniform_rod(solid.mass?, from?, to?))
    }

    fn disk(&mut self, solid: &Common, radius: &Expr, at: &Read<Vector>) -> Result<SpatialInertia, Reported> {
        let (radius, at) = (self.radius(solid, radius), self.vector_of(solid, at));
        let (mass, radius, at) = (solid.mass?, radius?, at?);
        let quarter = self.times_square(mass, radius, 4);
        let half = self.graph.add(quarter, quarter);
        let moments = Symmetric3::diagonal(&self.graph, [quarter, quarter, half]);
        Ok(SpatialInertia::of_body(&self.graph, mass, at, moments))
    }

    fn sphere(&mut self, solid: &Common, radius: &Expr, at: &Read<Vector>) -> Result<SpatialInertia, Reported> {
        let (radius, at) = (self.radius(solid, radius), self.vector_of(solid, at));
        let (mass, radius, at) = (solid.mass?, radius?, at?);
        let fifth = self.times_square(mass, radius, 5);
        let moment = self.graph.add(fifth, fifth);
        let moments = Symmetric3::diagonal(&self.graph, [moment; 3]);
        Ok(SpatialInertia::of_body(&self.graph, mass, at, moments))
    }

    fn cuboid(&mut self, solid: &Common, sides: &Read<Vector>, at: &Read<Vector>) -> Result<SpatialInertia, Reported> {
        let (lengths, at) = (self.vector_of(solid, sides), self.vector_of(solid, at));
        let (mass, lengths, at) = (solid.mass?, lengths?, at?);
        let what = format!("a side of {}", solid.place.what);
        for (side, length) in self.read(sides)?.components.iter().zip(lengths) {
            self.require(side, length, Requirement::NonNegative, &what);
        }
        let [x, y, z] = lengths.map(|side| self.times_square(mass, side, 12));
        let g = &self.graph;
        let moments = [g.add(y, z), g.add(x, z), g.add(x, y)];
        let moments = Symmetric3::diagonal(g, moments);
        Ok(SpatialInertia::of_body(g, mass, at, moments))
    }

    fn cylinder(
        &mut self,
        solid: &Common,
        radius: &Expr,
        from: &Read<Vector>,
        to: &Read<Vector>,
    ) -> Result<SpatialInertia, Reported> {
        let radius = self.radius(solid, radius);
        let (from, to) = (self.vector_of(solid, from), self.vector_of(solid, to));
        let (mass, radius, from, to) = (solid.mass?, radius?, from?, to?);
        let rod = self.uniform_rod(mass, from, to);
        let axis = sub(&self.graph, to, from);
        let length2 = dot(&self.graph, axis, axis);
        if self.graph.is_zero(length2) {
            return Err(self.errors.at(
                solid.word.span(),
                format_args!("{} has no length", solid.place.what),
                "give two different ends, or write a disk",
            ));
        }
        // a rod, and a disk about the rod's direction u: m r^2/4 (1 + u u^T)
        let quarter = self.times_square(mass, radius, 4);
        let g = &self.graph;
        let along = g.div(quarter, length2);
        let round = Symmetric3::diagonal(g, [quarter; 3]);
        let axial = Symmetric3::outer(g, along, axis);
        let about_origin = rod.about_origin.plus(g, round).plus(g, axial);
        Ok(SpatialInertia { about_origin, ..rod })
    }

    fn plate(
        &mut self,
        solid: &Common,
        corners: &[Read<[Expr; 2]>],
        tokens: &TokenStream,
    ) -> Result<SpatialInertia, Reported> {
        let corner = |corner: &Read<[Expr; 2]>| {
            let [x, y] = self.read(corner)?;
            let (x, y) = (self.expr(x, &solid.place), self.expr(y, &solid.place));
            Ok((x?, y?))
        };
        // all of them are read before the first error ends it
        let corners: Vec<_> = corners.iter().map(corner).collect();
        let corners: Vec<_> = corners.into_iter().collect::<Result<_, _>>()?;
        self.uniform_plate(solid.owner, solid.mass?, &corners, tokens)
    }

    fn radius(&mut self, solid: &Common, radius: &Expr) -> Result<ExprId, Reported> {
        let place = Place::fixed(format!("the radius of {}", solid.place.what));
        self.positive(radius, &place, Requirement::NonNegative)
    }

    fn vector_of(&mut self, solid: &Common, vector: &Read<Vector>) -> Result<Vec3, Reported> {
        let vector = self.read(vector)?;
        self.vector(vector, &solid.place)
    }

    /// `mass * length^2 / divisor`
    fn times_square(&mut self, mass: ExprId, length: ExprId, divisor: i64) -> ExprId {
        let g = &self.graph;
        let square = g.powi(length, 2);
        let product = g.mul(mass, square);
        let factor = g.number(ratio(1, divisor));
        g.mul(factor, product)
    }

    fn uniform_rod(&mut self, mass: ExprId, from: Vec3, to: Vec3) -> SpatialInertia {
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
}
