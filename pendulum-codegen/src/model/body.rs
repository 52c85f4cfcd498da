//! Bodies and the joints that carry them.

use super::{BodyId, Combination, CoordinateId, Figure, Law};
use crate::expr::{Expr, Formula, Level};
use crate::screw::{Mat3, SpatialInertia, Transform, Twist, Vec3};

/// A rigid body and the joint that carries it.
#[derive(Debug)]
pub(crate) struct Body<'g> {
    /// Name.
    pub name: String,
    /// The body that carries it; none for ground.
    pub parent: Option<BodyId>,
    /// Where the joint frame sits in the parent's frame: constant, but for an orientation.
    pub placement: Transform<'g>,
    /// The joint's screw axis in the joint frame, normalised; none for a fixed joint.
    pub screw: Option<Twist<'g>>,
    /// Of the three joints of an orientation, in a row on bodies without mass, the angular velocity that each adds: all
    /// of it by the first, whose placement is turned by the quaternion, and none by the others.
    pub spin: Option<Vec3<'g>>,
    /// The coordinate that this joint brings into the scene; a driven one has one too.
    pub coordinate: Option<CoordinateId>,
    /// The relative joint coordinate in terms of the scene's coordinates.
    pub motion: Combination,
    /// How the body is turned.
    pub heading: Heading<'g>,
    /// Inertia in the body frame.
    pub inertia: SpatialInertia<'g>,
    /// How it looks.
    pub figures: Vec<Figure<'g>>,
    /// Force of the joint along its relative coordinate: friction, spring and torque, and whatever holds it.
    pub force: Expr<'g>,
    /// The part of the force that is friction and spring, and whatever holds the joint.
    pub passive: Expr<'g>,
    /// The rest of it, the torque, as it was written.
    pub torque: Option<Formula>,
    /// Potential energy of the joint.
    pub potential: Expr<'g>,
    /// Dry friction and stops of the joint.
    pub law: Option<Law<'g>>,
}

/// The orientation of a body in its station: the rotation by `turn` about `axis`, after the constant rotation `rest`.
///
/// A station is a frame in which a group of bodies turns about one axis only: the ground, or the body before the first
/// joint of the group. Parallel joints so become one rotation by a sum of angles.
#[derive(Clone, Debug)]
pub(crate) struct Heading<'g> {
    /// The body whose frame is the station; none for ground.
    pub station: Option<BodyId>,
    /// Unit vector of the axis in the station, unless nothing turns yet.
    pub axis: Option<Vec3<'g>>,
    /// The angle.
    pub turn: Combination,
    /// The orientation at angle zero: constant, but for an orientation by a quaternion.
    pub rest: Mat3<'g>,
}

impl Heading<'_> {
    /// Whether a quaternion turns it.
    pub(crate) fn turns_freely(&self) -> bool {
        let entries = self.rest.0.iter().flat_map(|row| row.0);
        entries.into_iter().any(|entry| entry.level() == Level::State)
    }
}
