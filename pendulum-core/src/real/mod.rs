//! Number types for mechanisms and their integration.
//!
//! Generated code only computes and accepts any [`Real`], which may be a SIMD vector. An integrator also makes
//! decisions, such as accepting a step, so it needs an order: a [`Float`].

pub mod lanes;

mod fused;
mod scalar;
mod sincos;

pub use fused::Fused;

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use core::sync::atomic::{Ordering, compiler_fence};

use nalgebra::SVector;

use crate::taylor::DualKernel;

/// Number type of generated code: `f64`, `f32`, [`Fused`] or [lanes](lanes::Lanes) of these.
///
/// It has no comparisons, since `a < b` may differ between lanes. `Default` is zero.
///
/// The methods are named after the inherent ones of `f64`, which take precedence where both apply. Results agree up to
/// the last bits. The exceptions are [`signum`](Real::signum), which is 0 at 0, and `sqrt` and `abs`, which agree
/// exactly.
///
/// For `f64`, `f32` and `Fused<f64>`, and lanes of these, all results are bit-identical on every machine and in every
/// build. [`sin_cos`](Real::sin_cos) is implemented here; `tan`, `exp`, `ln`, `tanh`, `atan2` and `powf` come from the
/// crate [libm](https://docs.rs/libm) instead of the platform; IEEE 754 defines the rest. The inherent methods of `f64`
/// do not guarantee this.
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
    /// Number of lanes; 1 unless the type is a vector of [lanes](lanes::Lanes).
    const LANES: usize = 1;

    /// True for [dual numbers](crate::dual::Dual), whose derivatives may have errors of their own.
    #[doc(hidden)]
    const HAS_SLOPES: bool = false;

    /// True if [`sum_products`](Self::sum_products) and [`sum_stages`](Self::sum_stages) compute sums.
    #[doc(hidden)]
    const SUMS_WIDE: bool = false;

    /// True for `f64`, `f32` and [`Fused`] numbers, and lanes of these.
    #[doc(hidden)]
    const IS_PLAIN: bool = false;

    /// True if [`take_apart`](Self::take_apart) runs kernels.
    #[doc(hidden)]
    const TAKEN_APART: bool = false;

    /// Converts `v` to the nearest number of the type.
    fn from_f64(v: f64) -> Self;

    /// `self * a + b`, rounded once by [`Fused`] numbers only. Generated code and methods compute sums of products by
    /// this method and the next two. The inherent method of `f64` with this name, which takes precedence where the type
    /// is known, rounds once.
    #[inline(always)]
    #[must_use]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// `self * a - b`, like [`mul_add`](Self::mul_add).
    #[inline(always)]
    #[must_use]
    fn mul_sub(self, a: Self, b: Self) -> Self {
        self * a - b
    }

    /// `b - self * a`, like [`mul_add`](Self::mul_add).
    #[inline(always)]
    #[must_use]
    fn mul_neg_add(self, a: Self, b: Self) -> Self {
        b - self * a
    }

    /// True if the number carries no derivatives, or only zeros.
    #[inline(always)]
    fn is_constant(&self) -> bool {
        true
    }

    /// True if the number is zero, in all lanes.
    #[doc(hidden)]
    #[inline(always)]
    fn is_zero(self) -> bool {
        self == Self::default()
    }

    /// Product with a factor that [carries no derivatives](Self::is_constant).
    #[inline(always)]
    fn scaled(self, factor: Self) -> Self {
        factor * self
    }

    /// `sum` plus the product with a factor that [carries no derivatives](Self::is_constant).
    #[doc(hidden)]
    #[inline(always)]
    fn scaled_onto(self, factor: Self, sum: Self) -> Self {
        self.mul_add(factor, sum)
    }

    /// Computes the interior sums of products of series, given their factors of all lower orders.
    #[doc(hidden)]
    #[inline(always)]
    fn sum_products<const M: usize>(_left: &[[Self; M]], _right: &[[Self; M]], _sums: &mut [Self; M]) {}

    /// Computes `start + sum_i (h weights_i) stages_i`, or the sum alone, with an `h` without derivatives, skipping
    /// zero weights. Only for types that [sum](Self::SUMS_WIDE) so.
    #[doc(hidden)]
    #[inline(always)]
    fn sum_stages<const M: usize>(
        _h_and_weights: (Self, &[f64]),
        _stages: &[SVector<Self, M>],
        _start: Option<&SVector<Self, M>>,
        _sums: &mut SVector<Self, M>,
    ) {
        unreachable!("numbers of this type are summed otherwise");
    }

    /// Runs a kernel in registers of up to 256 bits, for `f64`, `f32` and [`Fused`] numbers.
    #[doc(hidden)]
    #[inline(always)]
    fn run_wide<K: lanes::WideKernel<Self>>(_kernel: K) {}

    /// Runs a kernel on numbers that are dual.
    #[doc(hidden)]
    #[inline(always)]
    fn take_apart<K: DualKernel<Self>>(_kernel: K) {}

    /// The number without its derivatives.
    #[doc(hidden)]
    #[inline(always)]
    fn without_slopes(self) -> Self {
        self
    }

    /// The number as a variable of [dual numbers](crate::dual::Dual), with the index `place` among them; unchanged in
    /// other types.
    #[doc(hidden)]
    #[inline]
    fn as_variable(self, _place: usize) -> Self {
        self
    }

    /// The largest ratio of the derivatives of `v` to `atol + rtol |x|`, with sums of absolute values over the
    /// components and the larger one of two `x`; `None` without derivatives, and if the relative tolerance has none, so
    /// that they do not count.
    #[doc(hidden)]
    #[inline(always)]
    fn ratio_of_slopes<const N: usize>(_tolerance: [Self; 2], _v: &[Self; N], _x: [&[Self; N]; 2]) -> Option<Self> {
        None
    }

    /// The number with itself as each derivative.
    #[doc(hidden)]
    #[inline]
    fn with_own_slopes(self) -> Self {
        self
    }

    /// Sums of the numbers of two arrays, in vector registers where these hold several.
    #[doc(hidden)]
    #[inline(always)]
    fn add_each<const N: usize>(mut a: [Self; N], b: [Self; N]) -> [Self; N] {
        for n in 0..N {
            a[n] += b[n];
        }
        a
    }

    /// Differences of the numbers of two arrays, like [`add_each`](Self::add_each).
    #[doc(hidden)]
    #[inline(always)]
    fn subtract_each<const N: usize>(mut a: [Self; N], b: [Self; N]) -> [Self; N] {
        for n in 0..N {
            a[n] -= b[n];
        }
        a
    }

    /// Products of a factor with the numbers of an array, like [`add_each`](Self::add_each).
    #[doc(hidden)]
    #[inline(always)]
    fn scale_each<const N: usize>(mut a: [Self; N], factor: Self) -> [Self; N] {
        for a in &mut a {
            *a = factor * *a;
        }
        a
    }

    /// Products of a factor with the numbers of one array plus those of another, by [`mul_add`](Self::mul_add).
    #[doc(hidden)]
    #[inline(always)]
    fn mul_add_each<const N: usize>(a: [Self; N], factor: Self, mut b: [Self; N]) -> [Self; N] {
        for n in 0..N {
            b[n] = a[n].mul_add(factor, b[n]);
        }
        b
    }

    /// Stores a number of a long function. Scalars are stored at once: compilers would combine the code of neighbours
    /// to store them together, and keep more numbers than there are registers in the meantime.
    #[doc(hidden)]
    #[inline(always)]
    fn put(place: &mut Self, value: Self) {
        *place = value;
        if const { Self::LANES == 1 } {
            compiler_fence(Ordering::SeqCst);
        }
    }

    /// Runs long code. Scalars [call](Self::call) it, lanes need it inlined.
    #[doc(hidden)]
    #[inline(always)]
    fn apart<A: ?Sized, B: ?Sized, R: lanes::Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
        if const { Self::LANES == 1 } {
            Self::call(routine, changed, read)
        } else {
            routine.run(changed, read)
        }
    }

    /// Runs long code in a function of its own, compiled for the instruction set of the lanes; scalars choose between
    /// the baseline and AVX2.
    #[doc(hidden)]
    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, R: lanes::Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
        lanes::Isa::run_routine(routine, changed, read)
    }

    /// Coefficients of a piecewise function, such as a table: those of the piece in which the number lies. They are
    /// constants, without derivatives.
    ///
    /// ```
    /// use pendulum_core::Real;
    ///
    /// /// 0 before 1 s, then 2 per second
    /// fn ramp<T: Real>(t: T) -> T {
    ///     let [from, slope] = t.piecewise(|t| if t < 1.0 { [0.0, 0.0] } else { [1.0, 2.0] });
    ///     (t - from) * slope
    /// }
    ///
    /// assert_eq!([0.5, 1.5].map(ramp), [0.0, 1.0]);
    /// ```
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C];

    /// Coefficients of a piecewise function that depends on the lane, whose index comes first.
    #[doc(hidden)]
    #[inline]
    fn piecewise_by_lane<const C: usize>(self, piece: impl Fn(usize, f64) -> [f64; C]) -> [Self; C] {
        self.piecewise(|number| piece(0, number))
    }

    /// Sine and cosine of an angle in radians; NaN if the angle is not finite.
    ///
    /// For `f64`, `f32` and `Fused<f64>`, and lanes of these, errors are below 1 ulp and results are bit-identical on
    /// every machine. Angles beyond 1e5 rad in `f64` and 6400 rad in `f32` take longer.
    fn sin_cos(self) -> (Self, Self);

    /// Sines and cosines of two angles, bit-identical to [`sin_cos`](Self::sin_cos) of each. Scalars compute both in
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

    /// Sign: -1, 0 or 1. Zero (of either sign) and NaN are returned unchanged.
    ///
    /// Unlike `f64::signum` it is zero at zero, because a friction law such as `-mu * signum(qd)` must vanish at rest.
    fn signum(self) -> Self;

    /// Maximum of two numbers; `self` if they are equal, or if `self` is NaN.
    ///
    /// Unlike `f64::max` it propagates a NaN in `self`.
    fn at_least(self, low: Self) -> Self;

    /// Minimum of two numbers; `self` if they are equal, or if `self` is NaN.
    fn at_most(self, high: Self) -> Self;

    /// Polar angle of the point `(x, self)`, in radians in (-pi, pi].
    fn atan2(self, x: Self) -> Self;

    /// `self` to the power of `exponent`; NaN for a negative number with a non-integer exponent.
    fn powf(self, exponent: Self) -> Self;
}

/// A [`Real`] with an order, for the integrators. It has a single lane.
pub trait Float: lanes::Lanes<Scalar = Self> + PartialOrd {
    /// Distance from 1 to the next larger number.
    const EPSILON: Self;

    /// Smallest positive normal number.
    const MIN_POSITIVE: Self;

    /// Converts to `f64`, for messages and for step size control.
    fn to_f64(self) -> f64;

    /// True if the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// Maximum of two numbers; if one is NaN, the other.
    fn max(self, other: Self) -> Self;

    /// Minimum of two numbers; if one is NaN, the other.
    fn min(self, other: Self) -> Self;

    /// Completes a zero of a function that was located by comparisons: these determine its value, but no derivatives.
    /// `reach` is the distance over which the function is smooth. Numbers without derivatives are returned unchanged.
    #[inline(always)]
    #[must_use]
    fn zero_of(self, _reach: Self, _function: impl Fn(Self) -> Self) -> Self {
        self
    }

    /// Largest magnitude of the derivatives; zero for numbers that have none.
    #[inline(always)]
    fn largest_slope(&self) -> f64 {
        0.0
    }

    /// True if two numbers have the same derivatives, as all numbers do that have none.
    #[inline(always)]
    fn has_same_slopes(&self, _other: &Self) -> bool {
        true
    }
}

/// `count` units in the last place of a number of this size.
#[inline(always)]
pub(crate) fn ulps<T: Float>(count: f64, size: T) -> T {
    T::from_f64(count) * T::EPSILON * size
}
