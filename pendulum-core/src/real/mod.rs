//! The number types that a mechanism and its integration are generic over.
//!
//! There are two traits because there are two kinds of code. Generated code only computes: it accepts any [`Real`],
//! which may be a SIMD vector. An integrator also decides (is this step accurate enough?), so it needs an order: a
//! [`Float`].

pub mod lanes;

mod scalar;
mod sincos;

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The number type of generated code: `f64`, `f32` or [lanes](lanes::Lanes) of these.
///
/// It has no comparisons, since a vector of lanes has no single answer to `a < b`. `Default` is zero.
///
/// The methods are named after the inherent ones of `f64`, which take precedence where both apply. Results agree except
/// for [`signum`](Real::signum), which is 0 at 0, and for the last bits of the other functions but `sqrt` and `abs`.
///
/// For `f64` and `f32`, and lanes of these, all results have the same bits on every machine, in every build:
/// [`sin_cos`](Real::sin_cos) is our own, `tan`, `exp`, `ln`, `tanh`, `atan2` and `powf` are those of the crate
/// [libm](https://docs.rs/libm) in place of the platform's, and IEEE 754 defines the rest. The inherent methods of `f64`
/// promise no such thing.
pub trait Real:
    nalgebra::Scalar
    + Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// How many numbers stand side by side: 1, but in a vector of [lanes](lanes::Lanes).
    const LANES: usize = 1;

    /// The number nearest to `v`.
    fn from_f64(v: f64) -> Self;

    /// Sine and cosine of an angle in radians; NaN if it is not finite.
    ///
    /// For `f64` and `f32`, and lanes of these, the errors are below 1 ulp, and the bits are the same on every machine.
    /// Beyond 1e5 rad in `f64` and 6400 rad in `f32` they take longer.
    fn sin_cos(self) -> (Self, Self);

    /// Sines and cosines of two angles, equal to [`sin_cos`](Self::sin_cos) of each. Scalars compute them together in
    /// one vector register.
    #[inline(always)]
    fn sin_cos_pair(self, other: Self) -> [(Self, Self); 2] {
        [self.sin_cos(), other.sin_cos()]
    }

    /// Tangent of an angle in radians.
    fn tan(self) -> Self;

    /// `e` to the power of `self`.
    fn exp(self) -> Self;

    /// Natural logarithm; NaN below 0.
    fn ln(self) -> Self;

    /// Square root; NaN below 0.
    fn sqrt(self) -> Self;

    /// Hyperbolic tangent.
    fn tanh(self) -> Self;

    /// Absolute value.
    fn abs(self) -> Self;

    /// Sign: -1, 0 or 1; zero (of either sign) and NaN are returned unchanged.
    ///
    /// It differs from `f64::signum` because a friction law such as `-mu * signum(qd)` must vanish at rest.
    fn signum(self) -> Self;

    /// The larger of two numbers; `self` if they are equal, or if it is NaN.
    ///
    /// It differs from `f64::max`, which would hide a NaN.
    fn at_least(self, low: Self) -> Self;

    /// The smaller of two numbers; `self` if they are equal, or if it is NaN.
    fn at_most(self, high: Self) -> Self;

    /// The angle of the point `(x, self)`, in radians in (-pi, pi].
    fn atan2(self, x: Self) -> Self;

    /// `self` to the power of `exponent`; NaN for a negative number and an exponent that is not an integer.
    fn powf(self, exponent: Self) -> Self;
}

/// A [`Real`] with an order: what the integrators step on. It is a single lane.
pub trait Float: lanes::Lanes<Scalar = Self> + PartialOrd {
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;

    /// The smallest positive normal number.
    const MIN_POSITIVE: Self;

    /// The number as `f64`, for messages and for step-size control.
    fn to_f64(self) -> f64;

    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The larger of two numbers; if one is NaN, the other.
    fn max(self, other: Self) -> Self;

    /// The smaller of two numbers; if one is NaN, the other.
    fn min(self, other: Self) -> Self;
}
