//! Bodies and their joints.

use super::{BodyId, Combination, CoordinateId, Figure, Law};
use crate::expr::{Expr, Formula, Level};
use crate::screw::{Mat3, SpatialInertia, Transform, Twist, Vec3};

/// A rigid body and the joint that connects it to its parent.
#[derive(Debug)]
pub(crate) struct Body<'g> {
    /// Name.
    pub name: String,
    /// Parent body; none for ground.
    pub parent: Option<BodyId>,
    /// Pose of the joint frame in the parent frame: constant unless it includes the rotation by a quaternion.
    pub placement: Transform<'g>,
    /// Screw axis of the joint in the joint frame, normalised; none for a fixed joint.
    pub screw: Option<Twist<'g>>,
    /// Angular velocity that the joint adds, if it is one of the three joints of an orientation. They stand in series
    /// on massless bodies: the first adds all of the angular velocity, and its placement includes the rotation by the
    /// quaternion; the other two add none.
    pub spin: Option<Vec3<'g>>,
    /// Coordinate that the joint adds to the scene. A driven joint adds one too, a joint that follows others does not.
    pub coordinate: Option<CoordinateId>,
    /// Relative joint coordinate, as a combination of the coordinates of the scene.
    pub motion: Combination,
    /// Orientation in its station.
    pub heading: Heading<'g>,
    /// Inertia in the body frame.
    pub inertia: SpatialInertia<'g>,
    /// Figures to draw.
    pub figures: Vec<Figure<'g>>,
    /// Force of the joint along its relative coordinate: friction, spring, torque and constraint force.
    pub force: Expr<'g>,
    /// Part of the force without the torque: friction, spring and constraint force.
    pub passive: Expr<'g>,
    /// Torque, as written.
    pub torque: Option<Formula>,
    /// Potential energy of the joint.
    pub potential: Expr<'g>,
    /// Dry friction and stops of the joint.
    pub law: Option<Law<'g>>,
}

/// Orientation of a body in its station: the constant rotation `rest`, followed by the rotation by `turn` about `axis`.
///
/// A station is a frame in which a group of bodies turns about a single axis: ground, or the body before the first
/// joint of the group. The rotations of parallel joints thus combine into one rotation by a sum of angles.
#[derive(Clone, Debug)]
pub(crate) struct Heading<'g> {
    /// Body whose frame is the station; none for ground.
    pub station: Option<BodyId>,
    /// Unit vector along the axis in the station; none if nothing turns yet.
    pub axis: Option<Vec3<'g>>,
    /// Angle of the rotation about the axis.
    pub turn: Combination,
    /// Orientation at angle zero: constant unless it includes the rotation by a quaternion.
    pub rest: Mat3<'g>,
}

impl Heading<'_> {
    /// True if a quaternion turns the body.
    pub(crate) fn turns_freely(&self) -> bool {
        let entries = self.rest.0.iter().flat_map(|row| row.0);
        entries.into_iter().any(|entry| entry.level() == Level::State)
    }
}
