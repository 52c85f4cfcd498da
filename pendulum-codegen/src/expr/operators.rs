//! Operators of expressions.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Binary, Expr, Graph, Rational};

macro_rules! operators {
    ($($operator:ident $method:ident;)*) => {$(
        impl<'g> $operator for Expr<'g> {
            type Output = Expr<'g>;
            fn $method(self, other: Expr<'g>) -> Expr<'g> {
                self.combine(Binary::$operator, other)
            }
        }

        impl<'g> $operator<Expr<'g>> for i64 {
            type Output = Expr<'g>;
            fn $method(self, other: Expr<'g>) -> Expr<'g> {
                other.graph().integer(self).$method(other)
            }
        }

        impl<'g> $operator<Expr<'g>> for Rational {
            type Output = Expr<'g>;
            fn $method(self, other: Expr<'g>) -> Expr<'g> {
                other.graph().number(self).$method(other)
            }
        }

        impl<'g> $operator<Expr<'g>> for &Rational {
            type Output = Expr<'g>;
            fn $method(self, other: Expr<'g>) -> Expr<'g> {
                self.clone().$method(other)
            }
        }
    )*};
}

operators! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl<'g> Neg for Expr<'g> {
    type Output = Expr<'g>;
    fn neg(self) -> Expr<'g> {
        self.negated()
    }
}

impl AddAssign for Expr<'_> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Expr<'_> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Graph {
    /// Sum of terms, from the first to the last.
    pub fn sum<'g>(&'g self, terms: impl IntoIterator<Item = Expr<'g>>) -> Expr<'g> {
        terms.into_iter().fold(self.zero(), Add::add)
    }
}
