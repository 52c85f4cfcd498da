//! Inertia as moments of mass.

use std::ops::{Add, Mul};

use super::{Mat3, SpatialInertia, Symmetric3, Twist, Vec3, Wrench};
use crate::expr::{Expr, Graph, ratio};

/// Mass, first moment `integral r dm` and second moments `integral r r^T dm` about the origin of a frame.
///
/// The second moments carry the same information as the rotational inertia `J = tr(S) 1 - S`, in a form that simplifies
/// displacements and the inertial moment of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MassMoments<'g> {
    /// Mass.
    pub mass: Expr<'g>,
    /// First moment.
    pub first: Vec3<'g>,
    /// Second moments.
    pub second: Symmetric3<'g>,
}

impl<'g> MassMoments<'g> {
    /// Zero mass.
    pub(crate) fn zero(g: &'g Graph) -> Self {
        Self {
            mass: g.zero(),
            first: Vec3::zero(g),
            second: Symmetric3::zero(g),
        }
    }

    /// Rotational inertia about the origin: `J = tr(S) 1 - S`.
    pub(crate) fn rotational(&self) -> Symmetric3<'g> {
        let Symmetric3([xx, yy, zz, xy, xz, yz]) = self.second;
        Symmetric3([yy + zz, xx + zz, xx + yy, -xy, -xz, -yz])
    }

    /// Moments in a frame in which the frame of these moments is rotated by `rotation`.
    #[must_use]
    pub(crate) fn rotated(&self, rotation: Mat3<'g>) -> Self {
        Self {
            mass: self.mass,
            first: rotation * self.first,
            second: self.second.rotated(rotation),
        }
    }

    /// Moments in a frame in which the frame of these moments has its origin at `p`: `S + (h + m p) p^T + p h^T`.
    #[must_use]
    pub(crate) fn moved(&self, p: Vec3<'g>) -> Self {
        let h = self.first;
        let first = h + self.mass * p;
        Self {
            mass: self.mass,
            first,
            second: self.second + Symmetric3::from_fn(|i, j| first[i] * p[j] + p[i] * h[j]),
        }
    }
}

/// The moments of a spatial inertia: `S = tr(J)/2 - J`.
impl<'g> From<SpatialInertia<'g>> for MassMoments<'g> {
    fn from(inertia: SpatialInertia<'g>) -> Self {
        let [xx, yy, zz, xy, xz, yz] = inertia.about_origin.0;
        let half = |twice: Expr<'g>| ratio(1, 2) * twice;
        let second = [
            half(yy + zz - xx),
            half(xx + zz - yy),
            half(xx + yy - zz),
            -xy,
            -xz,
            -yz,
        ];
        Self {
            mass: inertia.mass,
            first: inertia.moment,
            second: Symmetric3(second),
        }
    }
}

impl Add for MassMoments<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }
}

/// The momentum along a twist: `(J w + h x v ; w x h + m v)`.
impl<'g> Mul<Twist<'g>> for MassMoments<'g> {
    type Output = Wrench<'g>;
    fn mul(self, Twist { angular: w, linear: v }: Twist<'g>) -> Wrench<'g> {
        Wrench {
            moment: self.rotational() * w + self.first.cross(v),
            force: w.cross(self.first) + self.mass * v,
        }
    }
}
