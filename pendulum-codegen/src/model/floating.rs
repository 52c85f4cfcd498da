//! Bodies that move freely against the ground.

use num_traits::Zero;

use super::{BodyId, CoordinateId, Model, Poses};
use crate::expr::Expr;
use crate::screw::{Mat3, Vec3};

/// A free joint on the ground, or on what is fixed to it.
///
/// The acceleration of its position is `gravity + rotation a`. What is solved for is `a`, along the axes of the body:
/// in these the mass matrix does not depend on the orientation, nor on gravity what the acceleration takes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floating<'g> {
    /// The first of its three slides, and of its three turns.
    pub slide: BodyId,
    pub turn: BodyId,
    /// The coordinate of the first slide; those of the others follow.
    pub coordinate: CoordinateId,
    /// From the axes of the body to those of the position.
    pub rotation: Mat3<'g>,
    /// Along the axes of the position.
    pub gravity: Vec3<'g>,
}

impl<'g> Floating<'g> {
    /// The coordinates of the position.
    fn coordinates(&self) -> [CoordinateId; 3] {
        let first = usize::from(self.coordinate);
        [0, 1, 2].map(|n| CoordinateId::new(first + n))
    }

    /// Turns forces along the position to the axes of the body, within forces along all coordinates.
    pub(crate) fn turn_forces(&self, along: &mut [Expr<'g>]) {
        let forces = self.rotation.transpose() * self.of(along);
        self.set(along, forces);
    }

    /// Puts the acceleration of the position in place of `a`, within accelerations.
    pub(crate) fn accelerate(&self, solved: &mut [Expr<'g>]) {
        let acceleration = self.gravity + self.rotation * self.of(solved);
        self.set(solved, acceleration);
    }

    /// Puts a derivative of that in place of one of `a`; `beside` is the derivative where `a` stays as it is.
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
    /// The free joints on the ground; none where a loop ties one of them to something else, or where a joint follows
    /// its position: these move along the axes of the position.
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

    /// The free joint whose turns begin with a body, if it is on the ground.
    fn floating_from(&self, turn: BodyId) -> Option<Floating<'g>> {
        let turning = &self.bodies[turn];
        turning.spin?;
        let below: Vec<BodyId> = std::iter::successors(turning.parent, |&body| self.bodies[body].parent).collect();
        let (slides, ground) = below.split_at_checked(3)?;
        // those of one declaration have one name
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
