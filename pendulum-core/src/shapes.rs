//! Geometry of a mechanism for drawing: solids, joints, springs and points of its declaration, placed in the ground
//! frame.

use nalgebra::{Point3, SVector};

/// A model with geometry for drawing.
///
/// [`mechanism!`](crate::mechanism) implements it if `generate` lists `shapes`.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::shapes::{ShapeKind, Shapes};
///
/// mechanism! {
///     pub Swing {
///         gravity: [0, -9.81, 0],
///         body bob on ground { solids: [rod(1, [0, 0, 0], [0, -2, 0])], joint: revolute(z), coordinate: theta }
///         generate: [rhs, shapes],
///     }
/// }
///
/// let swing = Swing::new(SwingParams {})?;
/// let rod = &swing.shapes(0.0, &SVector::from([0.5, 0.0]))[0];
/// assert_eq!((rod.name, rod.kind), ("bob", ShapeKind::Rod));
/// assert!((rod.points[1].x - 2.0 * 0.5_f64.sin()).abs() < 1e-15);
/// # Ok::<(), pendulum_core::ParameterError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no shapes to draw",
    note = "`mechanism!` generates them where `generate` has `shapes`"
)]
pub trait Shapes<const N: usize> {
    /// Returns the shapes at the time `t` in the state `x`, in the order of declaration: the solids of the bodies, then
    /// their joints, then springs and dampers, then points, then walls.
    fn shapes(&self, t: f64, x: &SVector<f64, N>) -> Vec<Shape<'_>>;
}

/// A shape to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape<'a> {
    /// Name of its body, of the point, or of the wall; for springs and dampers, the body of their first end.
    pub name: &'a str,
    /// Body to which it belongs, for springs and dampers that of the first end; `ground` if the body is at rest.
    pub body: &'a str,
    /// Kind of the shape.
    pub kind: ShapeKind,
    /// Points in the ground frame, in m. The kind defines their meaning.
    pub points: Vec<Point3<f64>>,
    /// Radius of a round shape, in m; otherwise 0.
    pub radius: f64,
}

/// Kinds of [`Shape`], and the meaning of their points.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShapeKind {
    /// A point mass: its position, and the origin of its body.
    Mass,
    /// A thin rod: its ends.
    Rod,
    /// A disk: its centre, and a point on its rim.
    Disk,
    /// A flat plate: its corners in order.
    Plate,
    /// A cuboid: its eight corners.
    Cuboid,
    /// A cylinder: the centres of its ends.
    Cylinder,
    /// A sphere: its centre, and a point on its surface.
    Sphere,
    /// A joint that rotates, on a moving body: its position. A free body has none.
    Pivot,
    /// A joint that rotates, on ground or on a body fixed to it: its position.
    Support,
    /// The axis of a joint that slides on ground, or on a body fixed to it: a point, and another 1 m further along.
    Guide,
    /// A spring between two points.
    Spring,
    /// A damper between two points.
    Damper,
    /// A named point on a moving body.
    Point,
    /// A named point at rest.
    Anchor,
    /// A flat [wall](crate::mechanism#walls) that keeps off a point, the origin of a body, or a sphere about it: the
    /// foot of this point on the wall, and a point 1 m away on the side where the gap is positive. Walls of other forms
    /// have no shape.
    Wall,
}

impl ShapeKind {
    /// All kinds.
    pub const ALL: [Self; 15] = [
        Self::Mass,
        Self::Rod,
        Self::Disk,
        Self::Plate,
        Self::Cuboid,
        Self::Cylinder,
        Self::Sphere,
        Self::Pivot,
        Self::Support,
        Self::Guide,
        Self::Spring,
        Self::Damper,
        Self::Point,
        Self::Anchor,
        Self::Wall,
    ];
}

// Generated code may be in a `no_std` crate even if this crate has `std`.
#[doc(hidden)]
pub use std::vec::Vec;

/// A shape before placement: a row of a generated table.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outline<'a> {
    pub name: &'a str,
    pub body: &'a str,
    pub kind: ShapeKind,
    /// Number of points. Their coordinates are listed one after the other.
    pub points: usize,
    /// True if a radius follows the coordinates.
    pub radius: bool,
}

/// Builds shapes from outlines and the values that generated code computes for them.
#[doc(hidden)]
pub fn placed<'a>(outlines: &[Outline<'a>], values: &[f64]) -> Vec<Shape<'a>> {
    let mut rest = values.iter().copied();
    let mut next = || rest.next().unwrap_or(f64::NAN);
    let shape = |outline: &Outline<'a>| {
        let points: Vec<Point3<f64>> = (0..outline.points)
            .map(|_| Point3::new(next(), next(), next()))
            .collect();
        let radius = match outline.kind {
            ShapeKind::Disk | ShapeKind::Sphere => nalgebra::distance(&points[0], &points[1]),
            _ if outline.radius => next(),
            _ => 0.0,
        };
        Shape {
            name: outline.name,
            body: outline.body,
            kind: outline.kind,
            points,
            radius,
        }
    };
    outlines.iter().map(shape).collect()
}
