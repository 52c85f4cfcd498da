//! Bodies that move freely relative to ground.

use num_traits::Zero;

use super::{BodyId, CoordinateId, Model, Poses};
use crate::expr::Expr;
use crate::screw::{Mat3, Vec3};

/// A free joint on ground, or on a body fixed to it.
///
/// The acceleration of its position is `gravity + rotation a`, and the unknown solved for is `a`, along the axes of the
/// body. With this choice the mass matrix does not depend on the orientation, and the forces that `a` requires do not
/// depend on gravity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floating<'g> {
    /// First of its three slides.
    pub slide: BodyId,
    /// First of its three turns.
    pub turn: BodyId,
    /// Coordinate of the first slide; those of the other two follow.
    pub coordinate: CoordinateId,
    /// Rotation from the axes of the body to those of the position.
    pub rotation: Mat3<'g>,
    /// Acceleration of gravity, along the axes of the position.
    pub gravity: Vec3<'g>,
}

impl<'g> Floating<'g> {
    /// Coordinates of the position.
    fn coordinates(&self) -> [CoordinateId; 3] {
        let first = usize::from(self.coordinate);
        [0, 1, 2].map(|n| CoordinateId::new(first + n))
    }

    /// Rotates the forces along the position into the axes of the body, within the forces along all coordinates.
    pub(crate) fn turn_forces(&self, along: &mut [Expr<'g>]) {
        let forces = self.rotation.transpose() * self.of(along);
        self.set(along, forces);
    }

    /// Replaces `a` by the acceleration of the position, within all accelerations.
    pub(crate) fn accelerate(&self, solved: &mut [Expr<'g>]) {
        let acceleration = self.gravity + self.rotation * self.of(solved);
        self.set(solved, acceleration);
    }

    /// Replaces a derivative of `a` by that of the acceleration of the position; `beside` is the latter at constant
    /// `a`.
    pub(crate) fn differentiate(&self, column: &mut [Expr<'g>], beside: &[Expr<'g>]) {
        let derivative = self.rotation * self.of(column) + self.of(beside);
        self.set(column, derivative);
    }

    fn of(&self, all: &[Expr<'g>]) -> Vec3<'g> {
        Vec3(self.coordinates().map(|k| all[k]))
    }

    fn set(&self, all: &mut [Expr<'g>], own: Vec3<'g>) {
        self.coordinates().into_iter().zip(own.0).for_each(|(k, x)| all[k] = x);
    }
}

impl<'g> Model<'g> {
    /// Free joints on ground. Empty if a loop ties one of them to another body or a joint follows its position: the
    /// accelerations of all are then solved for along the axes of the position.
    pub(crate) fn floating(&self) -> Vec<Floating<'g>> {
        let floating: Vec<Floating<'g>> = self.bodies().filter_map(|(turn, _)| self.floating_from(turn)).collect();
        let is_followed = |k: CoordinateId| {
            let mut followers = self.bodies.iter().filter(|body| body.coordinate != Some(k));
            let of_loops = self
                .loops
                .dependents
                .iter()
                .any(|dependent| !dependent.slopes[k].is_zero());
            of_loops || followers.any(|body| !body.motion.factor(k).is_zero())
        };
        let is_tied = |joint: &Floating<'g>| joint.coordinates().into_iter().any(is_followed);
        if floating.iter().any(is_tied) {
            return Vec::new();
        }
        floating
    }

    /// The free joint on ground whose turns start at the given body; none if there is none.
    fn floating_from(&self, turn: BodyId) -> Option<Floating<'g>> {
        let turning = &self.bodies[turn];
        turning.spin?;
        let below: Vec<BodyId> = std::iter::successors(turning.parent, |&body| self.bodies[body].parent).collect();
        let (slides, ground) = below.split_at_checked(3)?;
        // all bodies of one declaration have the same name
        let is_slide = |&body: &BodyId| {
            let body = &self.bodies[body];
            body.name == turning.name && body.screw.is_some_and(|screw| !screw.turns())
        };
        let is_fixed = |&body: &BodyId| self.bodies[body].screw.is_none();
        if !slides.iter().all(is_slide) || !ground.iter().all(is_fixed) {
            return None;
        }
        let slide = slides[2];
        Some(Floating {
            slide,
            turn,
            coordinate: self.bodies[slide].coordinate?,
            rotation: turning.placement.rotation,
            gravity: Poses::new(self).rotation(Some(slide)).transpose() * self.gravity,
        })
    }
}
