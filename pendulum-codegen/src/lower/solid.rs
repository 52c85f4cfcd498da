//! Solids of uniform density: mass, first moment and inertia about the origin of the body frame.

use proc_macro2::TokenStream;
use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{self, Read, Solid, SolidKind, Vector};
use crate::error::{Code, Reported};
use crate::expr::{Expr, ratio};
use crate::model::{Figure, FigureKind, Requirement};
use crate::screw::{SpatialInertia, Symmetric3, Vec3};

/// Data common to all solids. An error in the mass does not stop the lowering of the rest.
struct Common<'g, 'a> {
    /// Body or shape that the solid belongs to.
    owner: &'a Ident,
    word: &'a Ident,
    /// Name in errors: ``a rod of `arm` ``.
    what: String,
    mass: Result<Expr<'g>, Reported>,
}

impl<'g> Lower<'g> {
    /// Sum of the solids of a body or shape.
    pub(super) fn solids(&mut self, owner: &Ident, solids: &[Read<Solid>]) -> Result<SpatialInertia<'g>, Reported> {
        if solids.is_empty() {
            let help = "list one or more, such as `point(m, [0, -l, 0])`, or leave the field out for a massless body";
            return Err(self.errors.at(
                Code::Arguments,
                owner.span(),
                format_args!("the list of solids of `{owner}` is empty"),
                help,
            ));
        }
        self.figures.clear();
        let mut total = Ok(SpatialInertia::zero(self.graph));
        for solid in solids {
            let part = self.solid(owner, solid);
            total = total.and_then(|total| Ok(total + part?));
        }
        total
    }

    fn solid(&mut self, owner: &Ident, solid: &Read<Solid>) -> Result<SpatialInertia<'g>, Reported> {
        let Solid { word, mass, kind } = self.read(solid)?;
        let what = format!("a {word} of `{owner}`");
        let of_mass = Place::fixed(format!("the mass of {what}")).in_unit("kg");
        let mass = self.positive(mass, &of_mass, Requirement::Positive);
        let common = Common {
            owner,
            word,
            what,
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

    fn point(&mut self, solid: &Common<'g, '_>, at: &Read<Vector>) -> Result<SpatialInertia<'g>, Reported> {
        let at = self.vector_of(solid, at)?;
        self.show(FigureKind::Mass, vec![at, Vec3::zero(self.graph)]);
        Ok(SpatialInertia::of_body(solid.mass?, at, Symmetric3::zero(self.graph)))
    }

    fn rod(
        &mut self,
        solid: &Common<'g, '_>,
        from: &Read<Vector>,
        to: &Read<Vector>,
    ) -> Result<SpatialInertia<'g>, Reported> {
        let (from, to) = (self.vector_of(solid, from), self.vector_of(solid, to));
        let (from, to) = (from?, to?);
        self.show(FigureKind::Rod, vec![from, to]);
        Ok(uniform_rod(solid.mass?, from, to))
    }

    fn disk(
        &mut self,
        solid: &Common<'g, '_>,
        radius: &ast::Expr,
        at: &Read<Vector>,
    ) -> Result<SpatialInertia<'g>, Reported> {
        let (radius, at) = (self.radius(solid, radius), self.vector_of(solid, at));
        let (mass, radius, at) = (solid.mass?, radius?, at?);
        self.show(FigureKind::Disk, vec![at, at + radius * Vec3::unit(self.graph, 0)]);
        let quarter = times_square(mass, radius, 4);
        let moments = Symmetric3::diagonal([quarter, quarter, 2 * quarter]);
        Ok(SpatialInertia::of_body(mass, at, moments))
    }

    fn sphere(
        &mut self,
        solid: &Common<'g, '_>,
        radius: &ast::Expr,
        at: &Read<Vector>,
    ) -> Result<SpatialInertia<'g>, Reported> {
        let (radius, at) = (self.radius(solid, radius), self.vector_of(solid, at));
        let (mass, radius, at) = (solid.mass?, radius?, at?);
        self.show(FigureKind::Sphere, vec![at, at + radius * Vec3::unit(self.graph, 0)]);
        let moment = 2 * times_square(mass, radius, 5);
        Ok(SpatialInertia::of_body(mass, at, Symmetric3::diagonal([moment; 3])))
    }

    fn cuboid(
        &mut self,
        solid: &Common<'g, '_>,
        sides: &Read<Vector>,
        at: &Read<Vector>,
    ) -> Result<SpatialInertia<'g>, Reported> {
        let what = format!("a side of {}", solid.what);
        let of_sides = Place::fixed(what.as_str()).in_unit("m");
        let lengths = self.read(sides).and_then(|sides| self.vector(sides, &of_sides));
        let at = self.vector_of(solid, at);
        let (mass, lengths, at) = (solid.mass?, lengths?, at?);
        for (side, length) in self.read(sides)?.components.iter().zip(lengths.0) {
            self.require(side, length, Requirement::NonNegative, &what);
        }
        let corner = |n: usize| {
            let half = |axis: usize| if n >> axis & 1 == 0 { ratio(1, 2) } else { ratio(-1, 2) };
            at + Vec3([0, 1, 2].map(|axis| half(axis) * lengths[axis]))
        };
        self.show(FigureKind::Cuboid, (0..8).map(corner).collect());
        let [x, y, z] = lengths.0.map(|side| times_square(mass, side, 12));
        let moments = Symmetric3::diagonal([y + z, x + z, x + y]);
        Ok(SpatialInertia::of_body(mass, at, moments))
    }

    fn cylinder(
        &mut self,
        solid: &Common<'g, '_>,
        radius: &ast::Expr,
        from: &Read<Vector>,
        to: &Read<Vector>,
    ) -> Result<SpatialInertia<'g>, Reported> {
        let radius = self.radius(solid, radius);
        let (from, to) = (self.vector_of(solid, from), self.vector_of(solid, to));
        let (mass, radius, from, to) = (solid.mass?, radius?, from?, to?);
        let rod = uniform_rod(mass, from, to);
        let axis = to - from;
        let length2 = axis.dot(axis);
        if length2.is_zero() {
            return Err(self.errors.at(
                Code::DegenerateSolid,
                solid.word.span(),
                format_args!("{} has no length", solid.what),
                "give two different ends, or write a disk",
            ));
        }
        self.figures.push(Figure {
            kind: FigureKind::Cylinder,
            points: vec![from, to],
            radius: Some(radius),
        });
        // a rod, plus a disk about the direction u of the rod: m r^2/4 (1 + u u^T)
        let quarter = times_square(mass, radius, 4);
        let round = Symmetric3::diagonal([quarter; 3]);
        let axial = Symmetric3::outer(quarter / length2, axis);
        Ok(SpatialInertia {
            about_origin: rod.about_origin + round + axial,
            ..rod
        })
    }

    fn plate(
        &mut self,
        solid: &Common<'g, '_>,
        corners: &[Read<[ast::Expr; 2]>],
        tokens: &TokenStream,
    ) -> Result<SpatialInertia<'g>, Reported> {
        let place = Place::fixed(format!("a corner of {}", solid.what)).in_unit("m");
        let corner = |corner: &Read<[ast::Expr; 2]>| {
            let [x, y] = self.read(corner)?;
            let (x, y) = (self.expr(x, &place), self.expr(y, &place));
            Ok((x?, y?))
        };
        // all corners are lowered before the first error returns
        let corners: Vec<_> = corners.iter().map(corner).collect();
        let corners: Vec<_> = corners.into_iter().collect::<Result<_, _>>()?;
        let zero = self.graph.zero();
        self.show(
            FigureKind::Plate,
            corners.iter().map(|&(x, y)| Vec3([x, y, zero])).collect(),
        );
        self.uniform_plate(solid.owner, solid.mass?, &corners, tokens)
    }

    fn show(&mut self, kind: FigureKind, points: Vec<Vec3<'g>>) {
        self.figures.push(Figure {
            kind,
            points,
            radius: None,
        });
    }

    fn radius(&mut self, solid: &Common<'g, '_>, radius: &ast::Expr) -> Result<Expr<'g>, Reported> {
        let place = Place::fixed(format!("the radius of {}", solid.what)).in_unit("m");
        self.positive(radius, &place, Requirement::NonNegative)
    }

    fn vector_of(&mut self, solid: &Common<'g, '_>, vector: &Read<Vector>) -> Result<Vec3<'g>, Reported> {
        let vector = self.read(vector)?;
        let place = Place::fixed(format!("a point of {}", solid.what)).in_unit("m");
        self.vector(vector, &place)
    }
}

/// `mass * length^2 / divisor`
fn times_square<'g>(mass: Expr<'g>, length: Expr<'g>, divisor: i64) -> Expr<'g> {
    ratio(1, divisor) * (mass * length.powi(2))
}

fn uniform_rod<'g>(mass: Expr<'g>, from: Vec3<'g>, to: Vec3<'g>) -> SpatialInertia<'g> {
    let middle = ratio(1, 2) * (from + to);
    let moments = Symmetric3::of_point(ratio(1, 12) * mass, to - from);
    SpatialInertia::of_body(mass, middle, moments)
}
