//! Symmetric three-by-three matrices.

use std::ops::{Add, Mul, Sub};

use super::{Mat3, Vec3};
use crate::expr::{Expr, Graph};

/// A symmetric matrix, stored as `[xx, yy, zz, xy, xz, yz]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Symmetric3<'g>(pub [Expr<'g>; 6]);

impl<'g> Symmetric3<'g> {
    /// Row and column of each entry, in storage order.
    pub(crate) const PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

    /// Zero matrix.
    pub(crate) fn zero(g: &'g Graph) -> Self {
        Self([g.zero(); 6])
    }

    /// The matrix with entries `entry(row, column)`, built in storage order.
    pub(crate) fn from_fn(mut entry: impl FnMut(usize, usize) -> Expr<'g>) -> Self {
        Self(Self::PLACES.map(|(i, j)| entry(i, j)))
    }

    /// Diagonal matrix.
    pub(crate) fn diagonal([x, y, z]: [Expr<'g>; 3]) -> Self {
        let zero = x.graph().zero();
        Self([x, y, z, zero, zero, zero])
    }

    /// `factor a a^T`
    pub(crate) fn outer(factor: Expr<'g>, a: Vec3<'g>) -> Self {
        Self::from_fn(|i, j| factor * (a[i] * a[j]))
    }

    /// `mass (|a|^2 1 - a a^T)`: the rotational inertia of a point at `a`.
    pub(crate) fn of_point(mass: Expr<'g>, a: Vec3<'g>) -> Self {
        Self::diagonal([mass * a.dot(a); 3]) - Self::outer(mass, a)
    }

    /// The full matrix.
    pub(crate) fn full(self) -> Mat3<'g> {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        Mat3([Vec3([xx, xy, xz]), Vec3([xy, yy, yz]), Vec3([xz, yz, zz])])
    }

    /// `rotation * self * rotation^T`
    #[must_use]
    pub(crate) fn rotated(self, rotation: Mat3<'g>) -> Self {
        let left = rotation * self.full();
        Self::from_fn(|i, j| left[i].dot(rotation[j]))
    }
}

impl Add for Symmetric3<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|n| self.0[n] + other.0[n]))
    }
}

impl Sub for Symmetric3<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|n| self.0[n] - other.0[n]))
    }
}

impl<'g> Mul<Vec3<'g>> for Symmetric3<'g> {
    type Output = Vec3<'g>;
    fn mul(self, v: Vec3<'g>) -> Vec3<'g> {
        self.full() * v
    }
}
