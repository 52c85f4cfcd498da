//! Figures that represent bodies in drawings.

use crate::expr::Expr;
use crate::screw::Vec3;

/// A figure that represents a body, in the body frame.
#[derive(Clone, Debug)]
pub(crate) struct Figure<'g> {
    /// Kind of figure.
    pub kind: FigureKind,
    /// Points of the figure, as its kind requires.
    pub points: Vec<Vec3<'g>>,
    /// Radius of a cylinder.
    pub radius: Option<Expr<'g>>,
}

/// Kind of a figure. The names match those in the core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// A point mass.
    Mass,
    /// A thin rod, from end to end.
    Rod,
    /// A disk: its centre, and a point of its rim.
    Disk,
    /// A plate: its corners.
    Plate,
    /// A cuboid: its corners.
    Cuboid,
    /// A cylinder: the centres of its ends.
    Cylinder,
    /// A sphere: its centre, and a point of its surface.
    Sphere,
    /// A joint that turns, on a moving body.
    Pivot,
    /// A joint that turns, on a body at rest.
    Support,
    /// The axis of a joint that slides on a body at rest: two points of it.
    Guide,
    /// A spring between two points.
    Spring,
    /// A damper between two points.
    Damper,
    /// A named point that moves.
    Point,
    /// A named point that does not move.
    Anchor,
    /// A flat wall: the foot of the point that it keeps off, and a point 1 m away on its side.
    Wall,
}
