//! Spatial inertia.

use crate::expr::{ExprId, Graph};

use super::{Symmetric3, Twist, Vec3, Wrench, add, cross, mat_vec, scale, sub};

/// The inertia of a rigid body or of several, about the origin of the frame it is written in.
///
/// With `c` the centre of mass and `J` the rotational inertia about it, the three parts are `m`, `m c` and
/// `J + m [c][c]^T`: sums over bodies, so inertias of parts add up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpatialInertia {
    /// Mass, in kg.
    pub mass: ExprId,
    /// First moment of mass, in kg m.
    pub moment: Vec3,
    /// Rotational inertia about the origin, in kg m^2.
    pub about_origin: Symmetric3,
}

impl SpatialInertia {
    /// Nothing.
    pub fn zero(g: &Graph) -> Self {
        let zero = g.zero();
        Self {
            mass: zero,
            moment: [zero; 3],
            about_origin: Symmetric3::zero(g),
        }
    }

    /// A body by its mass, its centre of mass and its rotational inertia about the centre of mass.
    pub fn of_body(g: &Graph, mass: ExprId, com: Vec3, about_com: Symmetric3) -> Self {
        let shift = Symmetric3::of_point(g, mass, com);
        Self {
            mass,
            moment: scale(g, mass, com),
            about_origin: about_com.plus(g, shift),
        }
    }

    /// The sum of two inertias written in the same frame.
    pub fn plus(&self, g: &Graph, other: &Self) -> Self {
        Self {
            mass: g.add(self.mass, other.mass),
            moment: add(g, self.moment, other.moment),
            about_origin: self.about_origin.plus(g, other.about_origin),
        }
    }

    /// The momentum along a twist: `(I w + h x v ; m v - h x w)`.
    pub fn momentum(&self, g: &Graph, twist: &Twist) -> Wrench {
        let spin = mat_vec(g, self.about_origin.full(), twist.angular);
        let shift = cross(g, self.moment, twist.linear);
        let linear = scale(g, self.mass, twist.linear);
        let sweep = cross(g, self.moment, twist.angular);
        Wrench {
            moment: add(g, spin, shift),
            force: sub(g, linear, sweep),
        }
    }
}
