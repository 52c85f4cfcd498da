//! Twists, wrenches and the bracket of two twists.

use crate::expr::{ExprId, Graph};

use super::{Vec3, add, cross, dot, scale};

/// A twist, in rad/s and m/s, or a screw axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Twist {
    /// Angular velocity.
    pub angular: Vec3,
    /// Velocity of the point at the origin.
    pub linear: Vec3,
}

/// A wrench, in N m and N.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wrench {
    /// Moment about the origin.
    pub moment: Vec3,
    /// Force.
    pub force: Vec3,
}

impl Wrench {
    /// The sum of two wrenches about the same origin.
    pub fn plus(&self, g: &Graph, other: &Self) -> Self {
        Self {
            moment: add(g, self.moment, other.moment),
            force: add(g, self.force, other.force),
        }
    }

    /// `factor` times the wrench.
    pub fn scaled(&self, g: &Graph, factor: ExprId) -> Self {
        Self {
            moment: scale(g, factor, self.moment),
            force: scale(g, factor, self.force),
        }
    }

    /// The power of the wrench along a twist.
    pub fn power(&self, g: &Graph, twist: &Twist) -> ExprId {
        let rotation = dot(g, self.moment, twist.angular);
        let translation = dot(g, self.force, twist.linear);
        g.add(rotation, translation)
    }
}

/// `[a, b] = (a_w x b_w ; a_v x b_w + a_w x b_v)`.
pub fn bracket(g: &Graph, a: &Twist, b: &Twist) -> Twist {
    let angular = cross(g, a.angular, b.angular);
    let (left, right) = (cross(g, a.linear, b.angular), cross(g, a.angular, b.linear));
    Twist {
        angular,
        linear: add(g, left, right),
    }
}
