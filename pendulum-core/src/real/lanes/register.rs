//! What lanes are made of: scalars, vector registers of the machine, and pairs of these.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::sincos::{Angle, sin_cos};
use crate::real::{Float, Real};

/// Some numbers that are computed with at once.
///
/// Public, since it bounds a public type, but out of reach: a register type of some instruction set must not be made where
/// the machine lacks it.
pub trait Register:
    Copy
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The type of one lane.
    type Scalar: Float;
    /// The number of lanes.
    const LANES: usize;

    /// The same number in all lanes.
    fn splat(v: Self::Scalar) -> Self;
    /// A number for each lane.
    fn from_fn(f: &mut impl FnMut(usize) -> Self::Scalar) -> Self;
    /// The number in lane `i < LANES`.
    fn lane(self, i: usize) -> Self::Scalar;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;

    /// The same lanes in `f64`, in which sine and cosine are computed.
    type Wide: Angle;
    /// In `f64`.
    fn widen(self) -> Self::Wide;
    /// Rounded to the type of the lanes.
    fn narrow(wide: Self::Wide) -> Self;
}

macro_rules! one_lane {
    ($float:ident) => {
        impl Register for $float {
            type Scalar = Self;
            const LANES: usize = 1;

            #[inline(always)]
            fn splat(v: Self) -> Self {
                v
            }

            #[inline(always)]
            fn from_fn(f: &mut impl FnMut(usize) -> Self) -> Self {
                f(0)
            }

            #[inline(always)]
            fn lane(self, _: usize) -> Self {
                self
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Real::sqrt(self)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                Real::abs(self)
            }

            type Wide = f64;

            #[inline(always)]
            fn widen(self) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn narrow(wide: f64) -> Self {
                Self::from_f64(wide)
            }
        }
    };
}

one_lane!(f64);
one_lane!(f32);

/// Two registers in the place of one of twice the width.
#[derive(Clone, Copy)]
pub struct Pair<R>(pub(super) R, pub(super) R);

macro_rules! halves {
    ($($trait:ident, $method:ident;)*) => { $(
        impl<R: Register> $trait for Pair<R> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0), $trait::$method(self.1, other.1))
            }
        }
    )* };
}

halves! { Add, add; Sub, sub; Mul, mul; Div, div; }

impl<R: Register> Neg for Pair<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<R: Register> Register for Pair<R> {
    type Scalar = R::Scalar;
    const LANES: usize = 2 * R::LANES;

    #[inline(always)]
    fn splat(v: R::Scalar) -> Self {
        Self(R::splat(v), R::splat(v))
    }

    #[inline(always)]
    fn from_fn(f: &mut impl FnMut(usize) -> R::Scalar) -> Self {
        Self(R::from_fn(f), R::from_fn(&mut |i| f(R::LANES + i)))
    }

    #[inline(always)]
    fn lane(self, i: usize) -> R::Scalar {
        if i < R::LANES {
            self.0.lane(i)
        } else {
            self.1.lane(i - R::LANES)
        }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }

    type Wide = Pair<R::Wide>;

    #[inline(always)]
    fn widen(self) -> Self::Wide {
        Pair(self.0.widen(), self.1.widen())
    }

    #[inline(always)]
    fn narrow(wide: Self::Wide) -> Self {
        Self(R::narrow(wide.0), R::narrow(wide.1))
    }
}

/// Operation by operation, and not one half after the other: so the two wait for each other's results, and not for their own.
impl<R: Angle> Angle for Pair<R> {
    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        self.0.any_beyond(limit) | self.1.any_beyond(limit)
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        let ((sin0, cos0), (sin1, cos1)) = (self.0.turn(sin.0, cos.0), self.1.turn(sin.1, cos.1));
        (Self(sin0, sin1), Self(cos0, cos1))
    }

    #[inline(always)]
    fn far(self) -> (Self, Self) {
        one_by_one(self)
    }
}

/// Sine and cosine of each lane as of a scalar: lanes within the range of the kernel must give what they always give.
#[inline(always)]
pub(super) fn one_by_one<R: Register<Scalar = f64>>(x: R) -> (R, R) {
    #[cold]
    #[inline(never)]
    fn replace<R: Register<Scalar = f64>>(x_sin: &mut R, cos: &mut R) {
        let x = *x_sin;
        *x_sin = R::from_fn(&mut |i| sin_cos(x.lane(i)).0);
        *cos = R::from_fn(&mut |i| sin_cos(x.lane(i)).1);
    }
    // Copies, which go to memory for the call; `x` itself can stay in its register where there is none.
    let (mut sin, mut cos) = (x, x);
    replace(&mut sin, &mut cos);
    (sin, cos)
}
