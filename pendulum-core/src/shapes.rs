//! How a mechanism looks: the solids, joints, springs and points of its declaration, placed in the ground frame.

use nalgebra::{Point3, SVector};

/// A model that knows how it looks.
///
/// [`mechanism!`](crate::mechanism) implements it where `generate` has `shapes`.
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
    message = "`{Self}` does not know how it looks",
    note = "`mechanism!` generates it where `generate` has `shapes`"
)]
pub trait Shapes<const N: usize> {
    /// What there is to see at the time `t` in the state `x`, in the order of the declaration: the solids of the bodies, then
    /// their joints, then springs and dampers, then points.
    fn shapes(&self, t: f64, x: &SVector<f64, N>) -> Vec<Shape<'_>>;
}

/// Something to see.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape<'a> {
    /// The body that it belongs to, or the point that it is; for springs and dampers the body of their first end.
    pub name: &'a str,
    /// What it is.
    pub kind: ShapeKind,
    /// Its points in the ground frame, in m; the kind says which.
    pub points: Vec<Point3<f64>>,
    /// The radius of what is round, in m; 0 otherwise.
    pub radius: f64,
}

/// Kinds of [`Shape`], and their points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShapeKind {
    /// A point mass: where it is, and the origin of its body.
    Mass,
    /// A thin rod: its ends.
    Rod,
    /// A disk: its centre, and a point of its rim.
    Disk,
    /// A flat plate: its corners in order.
    Plate,
    /// A cuboid: its eight corners.
    Cuboid,
    /// A cylinder: the centres of its ends.
    Cylinder,
    /// A sphere: its centre, and a point of its surface.
    Sphere,
    /// The joint of a body that turns: its place. A body that moves freely has none.
    Pivot,
    /// A spring between two points.
    Spring,
    /// A damper between two points.
    Damper,
    /// A point with a name of its own, on a body that moves.
    Point,
    /// A point with a name of its own that stays where it is.
    Anchor,
}

// For generated code, which may be without `std` where this crate is not.
#[doc(hidden)]
pub use std::vec::Vec;

/// A shape before it is placed: a row of what the generated code knows.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Outline<'a> {
    pub name: &'a str,
    pub kind: ShapeKind,
    /// The number of points, whose coordinates are listed one after the other.
    pub points: usize,
    /// Whether a radius is listed after them.
    pub radius: bool,
}

/// The shapes of outlines, from the values that generated code computes for them.
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
            kind: outline.kind,
            points,
            radius,
        }
    };
    outlines.iter().map(shape).collect()
}
