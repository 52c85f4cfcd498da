//! Vectors in a plane.

use std::ops::{Add, Mul, Neg, Sub};

use crate::expr::{Expr, Graph};

/// A vector in a plane, of expressions or of numbers. A quarter turn takes the first axis of the plane to the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Vec2<T>(pub [T; 2]);

impl<T: Scalar> Vec2<T> {
    /// Scalar product.
    pub(crate) fn dot(self, other: Self) -> T {
        let (Self([a, b]), Self([c, d])) = (self, other);
        a * c + b * d
    }

    /// Component of the vector product normal to the plane.
    pub(crate) fn cross(self, other: Self) -> T {
        let (Self([a, b]), Self([c, d])) = (self, other);
        a * d - b * c
    }

    /// The vector scaled by a factor.
    pub(crate) fn times(self, factor: T) -> Self {
        Self(self.0.map(|x| factor * x))
    }

    /// The vector rotated by a quarter turn.
    pub(crate) fn quarter(self) -> Self {
        let Self([x, y]) = self;
        Self([-y, x])
    }

    /// The vector rotated by the angle with this cosine and sine.
    pub(crate) fn turned(self, [cosine, sine]: [T; 2]) -> Self {
        let Self([x, y]) = self;
        Self([cosine * x - sine * y, sine * x + cosine * y])
    }
}

impl<'g> Vec2<Expr<'g>> {
    /// Zero vector.
    pub(crate) fn zero(g: &'g Graph) -> Self {
        Self([g.zero(); 2])
    }

    /// Sum of vectors, in order.
    pub(crate) fn sum(g: &'g Graph, vectors: impl IntoIterator<Item = Self>) -> Self {
        vectors.into_iter().fold(Self::zero(g), Add::add)
    }

    /// Cosine and sine of the rotation that takes the vector to another of the same length.
    pub(crate) fn turn_to(self, other: Self) -> [Expr<'g>; 2] {
        let (Self([x, y]), Self([u, v])) = (self, other);
        if y.is_zero() {
            return [u / x, v / x];
        }
        if x.is_zero() {
            return [v / y, -u / y];
        }
        let square = self.dot(self);
        [self.dot(other) / square, self.cross(other) / square]
    }
}

impl Vec2<f64> {
    /// Length.
    pub(crate) fn norm(self) -> f64 {
        self.0[0].hypot(self.0[1])
    }

    /// Angle from the vector to another.
    pub(crate) fn angle_to(self, other: Self) -> f64 {
        self.cross(other).atan2(self.dot(other))
    }
}

/// Component of a vector: an expression or a number.
pub(crate) trait Scalar:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl Scalar for Expr<'_> {}

impl Scalar for f64 {}

impl<T: Scalar> Add for Vec2<T> {
    type Output = Self;
    fn add(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a + c, b + d])
    }
}

impl<T: Scalar> Sub for Vec2<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Scalar> Neg for Vec2<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}
