//! Vectors of three expressions.

use std::ops::{Add, Index, Mul, Neg, Sub};

use crate::expr::{Expr, Graph, Rational};

/// A vector of three expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Vec3<'g>(pub [Expr<'g>; 3]);

impl<'g> Vec3<'g> {
    /// Zero vector.
    pub fn zero(g: &'g Graph) -> Self {
        Self([g.zero(); 3])
    }

    /// Unit vector along a coordinate axis.
    pub fn unit(g: &'g Graph, axis: usize) -> Self {
        Self(std::array::from_fn(|i| if i == axis { g.one() } else { g.zero() }))
    }

    /// Unit vector along the third axis.
    pub fn z(g: &'g Graph) -> Self {
        Self::unit(g, 2)
    }

    /// True if all components are the number 0.
    pub fn is_zero(self) -> bool {
        self.0.iter().all(|x| x.is_zero())
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> Expr<'g> {
        let [x, y, z] = [0, 1, 2].map(|i| self[i] * other[i]);
        x + y + z
    }

    /// Vector product.
    pub fn cross(self, other: Self) -> Self {
        Self([(1, 2), (2, 0), (0, 1)].map(|(i, j)| self[i] * other[j] - self[j] * other[i]))
    }
}

impl<'g> Index<usize> for Vec3<'g> {
    type Output = Expr<'g>;
    fn index(&self, at: usize) -> &Expr<'g> {
        &self.0[at]
    }
}

impl Add for Vec3<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self[i] + other[i]))
    }
}

impl Sub for Vec3<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self[i] - other[i]))
    }
}

impl Neg for Vec3<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl<'g> Mul<Vec3<'g>> for Expr<'g> {
    type Output = Vec3<'g>;
    fn mul(self, v: Vec3<'g>) -> Vec3<'g> {
        Vec3(v.0.map(|x| self * x))
    }
}

impl<'g> Mul<Vec3<'g>> for Rational {
    type Output = Vec3<'g>;
    fn mul(self, v: Vec3<'g>) -> Vec3<'g> {
        Vec3(v.0.map(|x| self.clone() * x))
    }
}

impl<'g> Mul<Vec3<'g>> for i64 {
    type Output = Vec3<'g>;
    fn mul(self, v: Vec3<'g>) -> Vec3<'g> {
        Vec3(v.0.map(|x| self * x))
    }
}
