//! Spatial inertia.

use std::ops::{Add, Mul};

use super::{Symmetric3, Twist, Vec3, Wrench};
use crate::expr::{Expr, Graph};

/// Spatial inertia of one or several rigid bodies, about the origin of the frame it is written in.
///
/// With `c` the centre of mass and `J` the rotational inertia about it, the three parts are `m`, `m c` and
/// `J + m [c][c]^T`. They are sums over bodies, so the inertias of parts add up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SpatialInertia<'g> {
    /// Mass, in kg.
    pub mass: Expr<'g>,
    /// First moment of mass, in kg m.
    pub moment: Vec3<'g>,
    /// Rotational inertia about the origin, in kg m^2.
    pub about_origin: Symmetric3<'g>,
}

impl<'g> SpatialInertia<'g> {
    /// Zero inertia.
    pub(crate) fn zero(g: &'g Graph) -> Self {
        Self {
            mass: g.zero(),
            moment: Vec3::zero(g),
            about_origin: Symmetric3::zero(g),
        }
    }

    /// Spatial inertia of a body from its mass, its centre of mass and its rotational inertia about the centre of mass.
    pub(crate) fn of_body(mass: Expr<'g>, com: Vec3<'g>, about_com: Symmetric3<'g>) -> Self {
        let shift = Symmetric3::of_point(mass, com);
        Self {
            mass,
            moment: mass * com,
            about_origin: about_com + shift,
        }
    }
}

impl Add for SpatialInertia<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            moment: self.moment + other.moment,
            about_origin: self.about_origin + other.about_origin,
        }
    }
}

/// The momentum along a twist: `(I w + h x v ; m v - h x w)`.
impl<'g> Mul<Twist<'g>> for SpatialInertia<'g> {
    type Output = Wrench<'g>;
    fn mul(self, Twist { angular: w, linear: v }: Twist<'g>) -> Wrench<'g> {
        let (spin, shift) = (self.about_origin * w, self.moment.cross(v));
        let (slide, sweep) = (self.mass * v, self.moment.cross(w));
        Wrench {
            moment: spin + shift,
            force: slide - sweep,
        }
    }
}
