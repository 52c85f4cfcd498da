//! Three-vectors and three-by-three matrices of expressions.

use crate::expr::{ExprId, Graph};

/// A vector.
pub type Vec3 = [ExprId; 3];

/// A matrix, row by row.
pub type Mat3 = [Vec3; 3];

/// A symmetric matrix as `[xx, yy, zz, xy, xz, yz]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetric3(pub [ExprId; 6]);

/// The sum of all terms.
pub fn sum(g: &Graph, terms: impl IntoIterator<Item = ExprId>) -> ExprId {
    let zero = g.zero();
    terms.into_iter().fold(zero, |sum, term| g.add(sum, term))
}

/// `a + b`.
pub fn add(g: &Graph, a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| g.add(a[i], b[i]))
}

/// `a - b`.
pub fn sub(g: &Graph, a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| g.sub(a[i], b[i]))
}

/// `factor * a`.
pub fn scale(g: &Graph, factor: ExprId, a: Vec3) -> Vec3 {
    a.map(|x| g.mul(factor, x))
}

/// The scalar product.
pub fn dot(g: &Graph, a: Vec3, b: Vec3) -> ExprId {
    let products = [0, 1, 2].map(|i| g.mul(a[i], b[i]));
    sum(g, products)
}

/// The vector product.
pub fn cross(g: &Graph, a: Vec3, b: Vec3) -> Vec3 {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (positive, negative) = (g.mul(a[i], b[j]), g.mul(a[j], b[i]));
        g.sub(positive, negative)
    })
}

/// The product of a matrix and a vector.
pub fn mat_vec(g: &Graph, m: Mat3, v: Vec3) -> Vec3 {
    m.map(|row| dot(g, row, v))
}

/// The transposed matrix.
pub fn transpose(m: Mat3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

/// The product of two matrices.
pub fn mat_mul(g: &Graph, a: Mat3, b: Mat3) -> Mat3 {
    let columns = transpose(b);
    a.map(|row| columns.map(|column| dot(g, row, column)))
}

impl Symmetric3 {
    /// Row and column of each entry, in the order in which they are stored.
    pub const PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

    /// The matrix of zeros.
    pub fn zero(g: &Graph) -> Self {
        Self([g.zero(); 6])
    }

    /// A matrix that is zero off its diagonal.
    pub fn diagonal(g: &Graph, d: Vec3) -> Self {
        let zero = g.zero();
        Self([d[0], d[1], d[2], zero, zero, zero])
    }

    /// `factor a a^T`.
    pub fn outer(g: &Graph, factor: ExprId, a: Vec3) -> Self {
        Self(Self::PLACES.map(|(i, j)| {
            let product = g.mul(a[i], a[j]);
            g.mul(factor, product)
        }))
    }

    /// `factor (|a|^2 1 - a a^T)`: the rotational inertia of a point of that mass at `a`.
    pub fn of_point(g: &Graph, factor: ExprId, a: Vec3) -> Self {
        let square = dot(g, a, a);
        let square = g.mul(factor, square);
        let outer = Self::outer(g, factor, a);
        Self::diagonal(g, [square; 3]).minus(g, outer)
    }

    /// The sum of two matrices.
    pub fn plus(self, g: &Graph, other: Self) -> Self {
        Self(std::array::from_fn(|i| g.add(self.0[i], other.0[i])))
    }

    /// The difference of two matrices.
    pub fn minus(self, g: &Graph, other: Self) -> Self {
        Self(std::array::from_fn(|i| g.sub(self.0[i], other.0[i])))
    }

    /// The full matrix.
    pub fn full(self) -> Mat3 {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }

    /// `rotation * self * rotation^T`.
    pub fn rotated(self, g: &Graph, rotation: Mat3) -> Self {
        let left = mat_mul(g, rotation, self.full());
        Self(Self::PLACES.map(|(i, j)| dot(g, left[i], rotation[j])))
    }
}
