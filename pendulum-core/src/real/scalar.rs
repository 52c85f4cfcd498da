//! `Real` and `Float` for the primitive floating-point types.

use super::lanes::{
    InLanes, Isa, Lanes, Pack, Pair, Register, Two32, Two64, Wide32, Wide64, WideKernel, Widest32, Widest64,
    single_lane,
};
use super::{Float, Real, sincos};

/// Implements a method by a function.
macro_rules! forward {
    ($function:path, $method:ident($($argument:ident: $kind:ty),*) -> $output:ty) => {
        #[inline]
        fn $method(self, $($argument: $kind),*) -> $output {
            $function(self, $($argument),*)
        }
    };
}

/// Operations on arrays of numbers, and kernels, in registers of three widths.
macro_rules! in_registers {
    ($narrow:ty, $wide:ty, $widest:ty) => {
        #[inline(always)]
        fn add_each<const N: usize>(a: [Self; N], b: [Self; N]) -> [Self; N] {
            each::<$narrow, $wide, N>(a, b, |a, b| a + b, |a, b| a + b, |a, b| a + b)
        }

        #[inline(always)]
        fn subtract_each<const N: usize>(a: [Self; N], b: [Self; N]) -> [Self; N] {
            each::<$narrow, $wide, N>(a, b, |a, b| a - b, |a, b| a - b, |a, b| a - b)
        }

        #[inline(always)]
        fn scale_each<const N: usize>(a: [Self; N], factor: Self) -> [Self; N] {
            let (narrow, wide) = (
                <$narrow as Register>::splat(factor),
                <$wide as Register>::splat(factor),
            );
            each::<$narrow, $wide, N>(a, a, |a, _| wide * a, |a, _| narrow * a, |a, _| factor * a)
        }

        #[inline(always)]
        fn run_wide<K: WideKernel<Self>>(kernel: K) {
            Isa::run_wide::<Pack<$widest>, Pack<$wide>, _>(InLanes::<_, Pack<$narrow>>::new(kernel));
        }
    };
}
pub(super) use in_registers;

macro_rules! scalar {
    (
        $float:ident, in $narrow:ident, $wide:ident, $widest:ident,
        by libm $tan:ident $exp:ident $ln:ident $tanh:ident $atan2:ident $powf:ident $sqrt:ident
    ) => {
        impl Real for $float {
            const IS_PLAIN: bool = true;

            #[inline]
            #[allow(
                clippy::cast_possible_truncation,
                reason = "rounding to the nearest is what `from_f64` promises"
            )]
            fn from_f64(v: f64) -> Self {
                v as $float
            }

            #[inline]
            fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
                piece(f64::from(self)).map(Self::from_f64)
            }

            // Inlined, since a function of its own would be compiled for the baseline.
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn sin_cos(self) -> (Self, Self) {
                sincos::sin_cos(self)
            }

            // Inlined, since passing an array through memory takes as long as a sine.
            #[inline(always)]
            fn sin_cos_pair(self, other: Self) -> [(Self, Self); 2] {
                sincos::sin_cos_pair::<$narrow>([self, other])
            }

            in_registers!($narrow, $wide, $widest);

            #[inline(always)]
            fn mul_add_each<const N: usize>(a: [Self; N], factor: Self, b: [Self; N]) -> [Self; N] {
                Self::add_each(Self::scale_each(a, factor), b)
            }

            #[inline]
            fn signum(self) -> Self {
                if self > 0.0 {
                    1.0
                } else if self < 0.0 {
                    -1.0
                } else {
                    self
                }
            }

            #[inline]
            fn at_least(self, low: Self) -> Self {
                if self < low { low } else { self }
            }

            #[inline]
            fn at_most(self, high: Self) -> Self {
                if self > high { high } else { self }
            }

            // Compiles to one instruction where available. IEEE 754 rounds square roots correctly, so both versions are
            // bit-identical.
            #[cfg(feature = "std")]
            forward!($float::sqrt, sqrt() -> Self);
            #[cfg(not(feature = "std"))]
            forward!(libm::$sqrt, sqrt() -> Self);

            // Functions of the platform differ in their last bits between platforms.
            forward!(libm::$tan, tan() -> Self);
            forward!(libm::$exp, exp() -> Self);
            forward!(libm::$ln, ln() -> Self);
            forward!(libm::$tanh, tanh() -> Self);
            forward!(libm::$atan2, atan2(x: Self) -> Self);
            forward!(libm::$powf, powf(exponent: Self) -> Self);

            forward!($float::abs, abs() -> Self);
        }

        /// A single lane.
        impl Lanes for $float {
            single_lane!();
            type Double = Pack<Pair<Self>>;

            #[inline(always)]
            fn all_finite(self) -> bool {
                Register::all_finite(self)
            }

            #[inline(always)]
            fn select(self, negative: Self, otherwise: Self) -> Self {
                Register::select(self, negative, otherwise)
            }
        }

        impl Float for $float {
            const EPSILON: Self = $float::EPSILON;
            const MIN_POSITIVE: Self = $float::MIN_POSITIVE;

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            forward!($float::is_finite, is_finite() -> bool);
            forward!($float::max, max(other: Self) -> Self);
            forward!($float::min, min(other: Self) -> Self);
        }
    };
}

scalar!(f64, in Two64, Wide64, Widest64, by libm tan exp log tanh atan2 pow sqrt);
scalar!(f32, in Two32, Wide32, Widest32, by libm tanf expf logf tanhf atan2f powf sqrtf);

/// Applies an operation to each pair of numbers: in wide registers, then in narrow ones, and the last ones as scalars.
#[inline(always)]
pub(super) fn each<R: Register, W: Register<Scalar = R::Scalar>, const N: usize>(
    a: [R::Scalar; N],
    b: [R::Scalar; N],
    in_wide: impl Fn(W, W) -> W,
    in_narrow: impl Fn(R, R) -> R,
    in_scalars: impl Fn(R::Scalar, R::Scalar) -> R::Scalar,
) -> [R::Scalar; N] {
    let mut result = a;
    let mut start = 0;
    if const { W::LANES > R::LANES } {
        while start + W::LANES <= N {
            in_wide(W::load(&a[start..]), W::load(&b[start..])).store(&mut result[start..]);
            start += W::LANES;
        }
    }
    while start + R::LANES <= N {
        in_narrow(R::load(&a[start..]), R::load(&b[start..])).store(&mut result[start..]);
        start += R::LANES;
    }
    while start < N {
        result[start] = in_scalars(a[start], b[start]);
        start += 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::Real;

    #[test]
    fn the_sign_of_zero_is_zero() {
        assert_eq!(Real::signum(0.0_f64), 0.0);
        assert_eq!(Real::signum(-0.0_f32), 0.0);
        assert_eq!(Real::signum(1e-300_f64), 1.0);
        assert_eq!(Real::signum(-3.0_f32), -1.0);
        assert!(Real::signum(f64::NAN).is_nan());
    }

    #[test]
    fn constants_round_to_the_nearest() {
        assert_eq!(<f32 as Real>::from_f64(0.1), 0.1_f32);
        assert_eq!(<f64 as Real>::from_f64(0.1), 0.1);
    }
}
