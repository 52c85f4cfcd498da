//! The number types that a mechanism and its integration are generic over.
//!
//! Two traits, because two kinds of code ask for different things. Generated code only ever computes: it takes any [`Real`],
//! and a SIMD vector of lanes can be one. An integrator also decides (is this step good enough?), which takes an order:
//! it wants a [`Float`].

pub mod lanes;

mod scalar;
mod sincos;

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The number type of generated code: `f64`, `f32` or [lanes](lanes::Lanes) of these.
///
/// There is deliberately no comparison here, so that a vector of lanes, which has no single answer to `a < b`, can be a `Real`.
/// `Default` is the number zero.
///
/// The methods bear the names of the inherent ones of `f64`, which take precedence where both apply. They agree,
/// but for [`signum`](Real::signum), which is 0 at 0 here, and for the last bit of [`sin_cos`](Real::sin_cos), which here is
/// the same on every machine.
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

    /// Sine and cosine of an angle in radians; NaN where it is not finite.
    ///
    /// For `f64` and `f32` the errors are below 1 ulp, and the bits are the same on every machine.
    fn sin_cos(self) -> (Self, Self);

    /// Sine and cosine of two angles: the same as those of each. Scalars compute them together, in one vector register.
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

    /// Sign: -1, 0 or 1; zero (of either sign) and NaN are returned as they are.
    ///
    /// A friction law such as `-mu * signum(qd)` must vanish at rest, which is why this differs from `f64::signum`.
    fn signum(self) -> Self;

    /// The angle, in radians in (-pi, pi], of the point whose ordinate is `self` and whose abscissa is `x`.
    fn atan2(self, x: Self) -> Self;

    /// `self` to the power of `exponent`; NaN where a negative number meets an exponent that is not whole.
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
