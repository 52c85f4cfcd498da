//! Numbers whose sine and cosine cost nearly nothing, to see what the rest of a function takes.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use pendulum_core::real::Real;

/// An `f64` with `x / 2` for the sine and `x + 1/4` for the cosine; the results mean nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(transparent)]
pub(crate) struct Cheap(pub f64);

/// The same in C, for the peers: included before all else.
pub(crate) const IN_C: &str = "\
#include <math.h>
static inline double cheap_sin(double x) { return 0.5 * x; }
static inline double cheap_cos(double x) { return x + 0.25; }
#define sin cheap_sin
#define cos cheap_cos
";

macro_rules! operators {
    ($($operator:ident $method:ident, $assign:ident $in_place:ident;)*) => {
        $(
            impl $operator for Cheap {
                type Output = Self;

                #[inline]
                fn $method(self, other: Self) -> Self {
                    Self($operator::$method(self.0, other.0))
                }
            }

            impl $assign for Cheap {
                #[inline]
                fn $in_place(&mut self, other: Self) {
                    $assign::$in_place(&mut self.0, other.0);
                }
            }
        )*
    };
}

operators! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
    Div div, DivAssign div_assign;
}

impl Neg for Cheap {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! forward {
    ($($method:ident)*) => {
        $(
            fn $method(self) -> Self {
                Self(Real::$method(self.0))
            }
        )*
    };
}

impl Real for Cheap {
    #[inline]
    fn from_f64(v: f64) -> Self {
        Self(v)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        (Self(0.5 * self.0), Self(self.0 + 0.25))
    }

    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }

    fn powf(self, exponent: Self) -> Self {
        Self(self.0.powf(exponent.0))
    }

    forward! { tan exp ln sqrt tanh abs signum }
}
