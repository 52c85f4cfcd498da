//! Joints that close loops, and their closure equations in space.

use super::pose::{between, carrier};
use super::{BodyId, Place, Tree};
use crate::expr::Expr;
use crate::screw::{Mat3, Vec3, Wrench};

/// A joint that closes a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Closure<'g> {
    /// Origins of the two joint frames.
    pub ends: [Place<'g>; 2],
    /// Axes of the joint frames in the frames of the bodies, as columns.
    pub axes: [Mat3<'g>; 2],
    /// Kind of joint between the frames.
    pub tie: Tie<'g>,
}

/// Kind of joint between two frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Tie<'g> {
    /// Revolute joint about this axis, which has the same components in both frames.
    Revolute(Vec3<'g>),
    /// Prismatic joint along this axis.
    Prismatic(Vec3<'g>),
    /// Ball joint: the origins coincide.
    Ball,
    /// Rigid connection: the frames coincide.
    Fixed,
}

/// One scalar closure equation: `value` vanishes where the loop is closed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<'g> {
    pub value: Expr<'g>,
    pub unit: &'static str,
    /// Wrench on the first end, about the origin of the second, from a unit constraint force along `value`, in the
    /// frame of the [carrier](Closure::carrier). The second end takes the opposite wrench.
    pub wrench: Wrench<'g>,
}

impl<'g> Closure<'g> {
    /// True if both tie the same frames in the same way, in either order.
    pub(crate) fn ties_the_same(&self, other: &Self) -> bool {
        let ([a, b], [of_a, of_b]) = (other.ends, other.axes);
        let reversed = Self {
            ends: [b, a],
            axes: [of_b, of_a],
            tie: other.tie,
        };
        *self == *other || *self == reversed
    }

    /// Names of the two bodies.
    pub(crate) fn bodies(&self, tree: &Tree<'g>) -> [String; 2] {
        let name = |end: &Place<'g>| end.body.map_or("ground", |body| &tree.bodies[body].name).to_owned();
        self.ends.each_ref().map(name)
    }

    /// Last body that carries both ends, or is one of them; the loop as a whole moves with it.
    pub(crate) fn carrier(&self, tree: &Tree<'g>) -> Option<BodyId> {
        carrier(tree, self.ends.map(|end| end.body))
    }

    /// Closure equations: differences of positions, and cosines of angles that are right angles where the loop is
    /// closed. The coordinates of the bodies that carry the loop do not occur in them.
    pub(crate) fn equations(&self, tree: &Tree<'g>) -> Vec<Row<'g>> {
        let frames = between(tree, self.ends.map(|end| end.body));
        let [(a, p), (b, r)] = [0, 1].map(|n| {
            let frame = frames[n];
            (frame.rotation * self.axes[n], frame.point(self.ends[n].at))
        });
        let apart = p - r;
        let zero = Vec3::zero(tree.graph);
        let [x, y, z] = [0, 1, 2].map(|n| Vec3::unit(tree.graph, n));
        let along = |force: Vec3<'g>| Row {
            value: force.dot(apart),
            unit: "m",
            wrench: Wrench { moment: zero, force },
        };
        let aligned = |[i, j]: [Vec3<'g>; 2]| Row {
            value: (a * i).dot(b * j),
            unit: "rad",
            wrench: Wrench {
                moment: (a * i).cross(b * j),
                force: zero,
            },
        };
        let across = |axis: Vec3<'g>| {
            let Mat3([u, v, _]) = Mat3::with_third_column(axis).transpose();
            [u, v]
        };
        let (forces, moments) = match self.tie {
            Tie::Ball => (vec![x, y, z], Vec::new()),
            Tie::Revolute(axis) => (vec![x, y, z], across(axis).map(|u| [u, axis]).to_vec()),
            Tie::Prismatic(axis) => (across(axis).map(|u| a * u).to_vec(), vec![[x, y], [y, z], [z, x]]),
            Tie::Fixed => (vec![x, y, z], vec![[x, y], [y, z], [z, x]]),
        };
        let forces = forces.into_iter().map(along);
        forces.chain(moments.into_iter().map(aligned)).collect()
    }
}
