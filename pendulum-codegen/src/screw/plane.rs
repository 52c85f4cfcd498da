//! Vectors of a plane.

use std::ops::{Add, Mul, Neg, Sub};

use crate::expr::{Expr, Graph};

/// A vector of a plane, whose second axis follows the first by a quarter of a turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Vec2<'g>(pub [Expr<'g>; 2]);

impl<'g> Vec2<'g> {
    /// The zero vector.
    pub(crate) fn zero(g: &'g Graph) -> Self {
        Self([g.zero(); 2])
    }

    /// The scalar product.
    pub(crate) fn dot(self, other: Self) -> Expr<'g> {
        let (Self([a, b]), Self([c, d])) = (self, other);
        a * c + b * d
    }

    /// What of the product of two vectors stands across the plane.
    pub(crate) fn cross(self, other: Self) -> Expr<'g> {
        let (Self([a, b]), Self([c, d])) = (self, other);
        a * d - b * c
    }

    /// The vector after a quarter of a turn.
    pub(crate) fn quarter(self) -> Self {
        let Self([x, y]) = self;
        Self([-y, x])
    }

    /// The vector after the turn of this cosine and sine.
    pub(crate) fn turned(self, [cosine, sine]: [Expr<'g>; 2]) -> Self {
        let Self([x, y]) = self;
        Self([cosine * x - sine * y, sine * x + cosine * y])
    }

    /// Cosine and sine of the turn that takes the vector to another one of its length.
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

impl<'g> Add for Vec2<'g> {
    type Output = Self;
    fn add(self, Self([c, d]): Self) -> Self {
        let Self([a, b]) = self;
        Self([a + c, b + d])
    }
}

impl<'g> Sub for Vec2<'g> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<'g> Neg for Vec2<'g> {
    type Output = Self;
    fn neg(self) -> Self {
        let Self([a, b]) = self;
        Self([-a, -b])
    }
}

impl<'g> Mul<Vec2<'g>> for Expr<'g> {
    type Output = Vec2<'g>;
    fn mul(self, Vec2([a, b]): Vec2<'g>) -> Vec2<'g> {
        Vec2([self * a, self * b])
    }
}
