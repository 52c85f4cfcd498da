//! Numbers with nearly free sines and cosines, or divisions, to measure the cost of the other operations.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use pendulum_core::real::Real;

/// An `f64` with cheap replacements: without `SINES`, the sine is `x / 2` and the cosine `x + 1/4`; without
/// `DIVISIONS`, division multiplies. The results are meaningless.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(transparent)]
pub struct Cheap<const SINES: bool = false, const DIVISIONS: bool = true>(pub f64);

/// C version of the replacements, for the peers; included before all other code.
pub const IN_C: &str = "\
#include <math.h>
static inline double cheap_sin(double x) { return 0.5 * x; }
static inline double cheap_cos(double x) { return x + 0.25; }
#define sin cheap_sin
#define cos cheap_cos
";

macro_rules! operators {
    ($($operator:ident $method:ident, $assign:ident $in_place:ident;)*) => {
        $(
            impl<const SINES: bool, const DIVISIONS: bool> $operator for Cheap<SINES, DIVISIONS> {
                type Output = Self;

                #[inline]
                fn $method(self, other: Self) -> Self {
                    Self($operator::$method(self.0, other.0))
                }
            }

            impl<const SINES: bool, const DIVISIONS: bool> $assign for Cheap<SINES, DIVISIONS> {
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
}

impl<const SINES: bool, const DIVISIONS: bool> Div for Cheap<SINES, DIVISIONS> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        Self(if DIVISIONS { self.0 / other.0 } else { self.0 * other.0 })
    }
}

impl<const SINES: bool, const DIVISIONS: bool> DivAssign for Cheap<SINES, DIVISIONS> {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl<const SINES: bool, const DIVISIONS: bool> Neg for Cheap<SINES, DIVISIONS> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! forward {
    ($($method:ident)*) => {
        $(
            #[inline]
            fn $method(self) -> Self {
                Self(Real::$method(self.0))
            }
        )*
    };
}

impl<const SINES: bool, const DIVISIONS: bool> Real for Cheap<SINES, DIVISIONS> {
    #[inline]
    fn from_f64(v: f64) -> Self {
        Self(v)
    }

    #[inline]
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.0.piecewise(piece).map(Self)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if SINES {
            let (sin, cos) = Real::sin_cos(self.0);
            (Self(sin), Self(cos))
        } else {
            (Self(0.5 * self.0), Self(self.0 + 0.25))
        }
    }

    // `f64` computes both pairs together.
    #[inline(always)]
    fn sin_cos_pair(self, other: Self) -> [(Self, Self); 2] {
        if SINES {
            self.0.sin_cos_pair(other.0).map(|(sin, cos)| (Self(sin), Self(cos)))
        } else {
            [self.sin_cos(), other.sin_cos()]
        }
    }

    fn at_least(self, low: Self) -> Self {
        Self(self.0.at_least(low.0))
    }

    fn at_most(self, high: Self) -> Self {
        Self(self.0.at_most(high.0))
    }

    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }

    fn powf(self, exponent: Self) -> Self {
        Self(self.0.powf(exponent.0))
    }

    forward! { tan exp ln sqrt tanh abs signum }
}
