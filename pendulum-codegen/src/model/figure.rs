//! How bodies look.

use crate::expr::Expr;
use crate::screw::Vec3;

/// Something to see of a body, in its frame.
#[derive(Clone, Debug)]
pub(crate) struct Figure<'g> {
    /// What it is.
    pub kind: FigureKind,
    /// Its points.
    pub points: Vec<Vec3<'g>>,
    /// The radius of a cylinder.
    pub radius: Option<Expr<'g>>,
}

/// What is seen: the names are those of the core.
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
    /// A joint that turns.
    Pivot,
    /// A spring between two points.
    Spring,
    /// A damper between two points.
    Damper,
    /// A named point that moves.
    Point,
    /// A named point that does not.
    Anchor,
}
