//! Three-by-three matrices of expressions.

use std::ops::{Add, Index, Mul};

use super::Vec3;
use crate::expr::{Expr, Graph, ratio};

/// A matrix, stored row by row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mat3<'g>(pub [Vec3<'g>; 3]);

impl<'g> Mat3<'g> {
    /// Identity matrix.
    pub(crate) fn identity(g: &'g Graph) -> Self {
        Self([0, 1, 2].map(|i| Vec3::unit(g, i)))
    }

    /// The matrix with entries `entry(row, column)`, built row by row.
    pub(crate) fn from_fn(mut entry: impl FnMut(usize, usize) -> Expr<'g>) -> Self {
        Self(std::array::from_fn(|i| Vec3(std::array::from_fn(|j| entry(i, j)))))
    }

    /// The matrix of the vector product: `[v] u = v x u`.
    pub(crate) fn cross(v: Vec3<'g>) -> Self {
        let (zero, Vec3([x, y, z]), Vec3([nx, ny, nz])) = (v[0].graph().zero(), v, -v);
        Self([Vec3([zero, nz, y]), Vec3([z, zero, nx]), Vec3([ny, x, zero])])
    }

    /// The rotation by `angle` about a unit vector (Rodrigues).
    pub(crate) fn rotation(axis: Vec3<'g>, angle: Expr<'g>) -> Self {
        let (sine, cosine) = (angle.sin(), angle.cos());
        let versine = 1 - cosine;
        let identity = Self::identity(angle.graph());
        Self::from_fn(|i, j| {
            let outer = axis[i] * axis[j];
            // the diagonal entry of a coordinate axis is 1, with no need for simplification
            let symmetric = if outer.is_one() {
                outer
            } else {
                outer * versine + identity[i][j] * cosine
            };
            if i == j {
                return symmetric;
            }
            let turned = sine * axis[3 - i - j];
            if (i + 1) % 3 == j {
                symmetric - turned
            } else {
                symmetric + turned
            }
        })
    }

    /// A rotation whose third column is a given unit vector: a permutation if that is a coordinate axis.
    pub(crate) fn with_third_column(z: Vec3<'g>) -> Self {
        let g = z[0].graph();
        let axis = (0..3).find(|&k| (0..3).all(|i| i == k || z[i].is_zero()));
        let x = match axis {
            // any perpendicular coordinate axis will do
            Some(k) => Vec3::unit(g, (k + 1) % 3),
            None => {
                // part of a coordinate axis perpendicular to z, normalised; best is an axis along which z has no
                // component
                let k = (0..3).find(|&k| z[k].is_zero()).unwrap_or(0);
                let across = Vec3::unit(g, k) - z[k] * z;
                across.dot(across).power(ratio(-1, 2)) * across
            }
        };
        Self([x, z.cross(x), z]).transpose()
    }

    /// Rotation matrix of a unit quaternion, scalar first.
    pub(crate) fn of_quaternion([w, x, y, z]: [Expr<'g>; 4]) -> Self {
        let [xx, yy, zz] = [x, y, z].map(|x| x * x);
        let twice = |a: Expr<'g>, b: Expr<'g>| 2 * (a + b);
        let less = |a: Expr<'g>, b: Expr<'g>| 2 * (a - b);
        Self([
            Vec3([1 - twice(yy, zz), less(x * y, w * z), twice(x * z, w * y)]),
            Vec3([twice(x * y, w * z), 1 - twice(xx, zz), less(y * z, w * x)]),
            Vec3([less(x * z, w * y), twice(y * z, w * x), 1 - twice(xx, yy)]),
        ])
    }

    /// Transpose.
    #[must_use]
    pub(crate) fn transpose(self) -> Self {
        Self::from_fn(|i, j| self[j][i])
    }

    /// Column `j`.
    pub(crate) fn column(self, j: usize) -> Vec3<'g> {
        Vec3(self.0.map(|row| row[j]))
    }

    /// The matrix with a function applied to each row.
    #[must_use]
    pub(crate) fn map_rows(self, f: impl FnMut(Vec3<'g>) -> Vec3<'g>) -> Self {
        Self(self.0.map(f))
    }
}

impl<'g> Index<usize> for Mat3<'g> {
    type Output = Vec3<'g>;
    fn index(&self, row: usize) -> &Vec3<'g> {
        &self.0[row]
    }
}

impl Add for Mat3<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self[i] + other[i]))
    }
}

impl<'g> Mul<Vec3<'g>> for Mat3<'g> {
    type Output = Vec3<'g>;
    fn mul(self, v: Vec3<'g>) -> Vec3<'g> {
        Vec3(self.0.map(|row| row.dot(v)))
    }
}

impl Mul for Mat3<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let columns = other.transpose();
        self.map_rows(|row| Vec3(columns.0.map(|column| row.dot(column))))
    }
}
