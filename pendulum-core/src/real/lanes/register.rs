//! Storage of lanes: scalars, vector registers of the machine, and pairs of these.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Routine;
use crate::real::{Float, Real};

/// One or more numbers on which operations act at once.
///
/// The trait is public because it bounds a public type. Its module is private, so that a register cannot be created on
/// a machine without its instruction set.
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
    /// Type of one lane.
    type Scalar: Precision;
    /// Number of lanes.
    const LANES: usize;

    /// Sets all lanes to the same number.
    fn splat(v: Self::Scalar) -> Self;
    /// Sets each lane to `f(lane)`.
    fn from_fn(f: &mut impl FnMut(usize) -> Self::Scalar) -> Self;
    /// Returns the number in lane `i < LANES`.
    fn lane(&self, i: usize) -> Self::Scalar;
    /// Sets the lanes to the first numbers of a slice.
    #[inline(always)]
    fn load(from: &[Self::Scalar]) -> Self {
        Self::from_fn(&mut |lane| from[lane])
    }
    /// Writes the lanes to the front of a slice.
    #[inline(always)]
    fn store(self, to: &mut [Self::Scalar]) {
        for (lane, to) in to.iter_mut().enumerate().take(Self::LANES) {
            *to = self.lane(lane);
        }
    }
    /// `self * a + b`.
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    /// `self * a - b`.
    #[inline(always)]
    fn mul_sub(self, a: Self, b: Self) -> Self {
        self * a - b
    }
    /// `b - self * a`.
    #[inline(always)]
    fn mul_neg_add(self, a: Self, b: Self) -> Self {
        b - self * a
    }
    /// Runs code in a function of its own, compiled for the instructions of the register.
    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
        #[inline(never)]
        fn alone<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
            routine.run(changed, read)
        }
        alone(routine, changed, read)
    }
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Selects `negative` in the lanes where the sign bit of `self` is set, `otherwise` in the others.
    fn select(self, negative: Self, otherwise: Self) -> Self;

    /// True if the numbers in all lanes are finite. May return false for finite numbers whose sum overflows.
    fn all_finite(self) -> bool;
    /// True if the absolute value of any lane exceeds the limit; NaN does not.
    fn any_beyond(self, limit: Self::Scalar) -> bool;
    /// Returns `(sin(x + n pi/2), cos(x + n pi/2))`, given `sin x`, `cos x`, and `n` in the lowest bits of `self`.
    fn turn(self, sin: Self, cos: Self) -> (Self, Self);
}

/// Implements the access of a [`Register`] to memory by its conversions from and to an array.
#[cfg(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "aarch64", target_feature = "neon")
))]
macro_rules! through_arrays {
    ($lanes:literal $scalar:ident) => {
        #[inline(always)]
        fn load(from: &[$scalar]) -> Self {
            Self::from_array(*from.first_chunk().expect("enough numbers"))
        }

        #[inline(always)]
        fn store(self, to: &mut [$scalar]) {
            *to.first_chunk_mut().expect("enough numbers") = self.to_array();
        }

        #[inline(always)]
        fn from_fn(f: &mut impl FnMut(usize) -> $scalar) -> Self {
            // The compiler does not inline the calls of `f` in `array::from_fn`.
            let mut array = [0.0; $lanes];
            for (i, lane) in array.iter_mut().enumerate() {
                *lane = f(i);
            }
            Self::from_array(array)
        }
    };
}
#[cfg(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "aarch64", target_feature = "neon")
))]
pub(super) use through_arrays;

/// Scalar type of lanes, with the range and the constants of the kernel of [sine and cosine](crate::real::sincos).
pub trait Precision: Float + Register<Scalar = Self> {
    /// Largest angle that the kernel reduces: up to this limit the products of the quotient with all but the last part
    /// of pi/2 are exact.
    const LIMIT: Self;

    /// pi/2 as a sum. Subtracting multiples of the first parts from the angle is exact; the rounding error of the last
    /// two is carried along.
    const HALF_PI: (&'static [Self], [Self; 2]);

    /// 1.5 times the smallest power of 2 above which all numbers are integers. Adding it to the quotient rounds the
    /// quotient to an integer, in the lowest bits.
    const SHIFT: Self;

    /// `(x - sin x) / x^3` in ascending powers of `x^2`.
    const SIN: &'static [Self];

    /// `(cos x - 1 + x^2 / 2) / x^4` in ascending powers of `x^2`.
    const COS: &'static [Self];

    /// Sine and cosine of an angle beyond [`LIMIT`](Self::LIMIT).
    fn far(self) -> (Self, Self);
}

macro_rules! one_lane {
    ($float:ident of $bits:literal bits) => {
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
            fn lane(&self, _: usize) -> Self {
                *self
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Real::sqrt(self)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                Real::abs(self)
            }

            #[inline(always)]
            fn select(self, negative: Self, otherwise: Self) -> Self {
                if self.is_sign_negative() {
                    negative
                } else {
                    otherwise
                }
            }

            #[inline(always)]
            fn all_finite(self) -> bool {
                self.is_finite()
            }

            #[inline(always)]
            fn any_beyond(self, limit: Self) -> bool {
                Real::abs(self) > limit
            }

            #[inline(always)]
            fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
                let n = self.to_bits();
                let odd = (n & 1).wrapping_neg();
                let (sin, cos) = (sin.to_bits(), cos.to_bits());
                let swap = (sin ^ cos) & odd;
                let sign = |quarter| (quarter & 2) << ($bits - 2);
                (
                    Self::from_bits((sin ^ swap) ^ sign(n)),
                    Self::from_bits((cos ^ swap) ^ sign(n.wrapping_add(1))),
                )
            }
        }
    };
}

one_lane!(f64 of 64 bits);
one_lane!(f32 of 32 bits);

/// A register with a fused operation.
pub trait Fuse: Register<Scalar = f64> {
    /// `self * a + b`, rounded once.
    fn fused_mul_add(self, a: Self, b: Self) -> Self;
}

impl Fuse for f64 {
    // IEEE 754 rounds it correctly, so that all versions are bit-identical. The C library of MinGW does not.
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        #[cfg(all(feature = "std", any(target_feature = "fma", not(all(windows, target_env = "gnu")))))]
        return f64::mul_add(self, a, b);
        #[cfg(not(all(feature = "std", any(target_feature = "fma", not(all(windows, target_env = "gnu"))))))]
        return libm::fma(self, a, b);
    }
}

impl<R: Fuse> Fuse for Pair<R> {
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        Self(self.0.fused_mul_add(a.0, b.0), self.1.fused_mul_add(a.1, b.1))
    }
}

/// Two registers used as one of twice the width.
///
/// Each operation is applied to both halves before the next one, which hides instruction latency.
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

macro_rules! both {
    ($($method:ident($($argument:ident),*);)*) => { $(
        #[inline(always)]
        fn $method(self, $($argument: Self),*) -> Self {
            Self(self.0.$method($($argument.0),*), self.1.$method($($argument.1),*))
        }
    )* };
}

impl<R: Register> Register for Pair<R> {
    type Scalar = R::Scalar;
    const LANES: usize = 2 * R::LANES;

    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, C: Routine<A, B>>(routine: C, changed: &mut A, read: &B) -> C::Output {
        R::call(routine, changed, read)
    }

    #[inline(always)]
    fn splat(v: R::Scalar) -> Self {
        Self(R::splat(v), R::splat(v))
    }

    #[inline(always)]
    fn from_fn(f: &mut impl FnMut(usize) -> R::Scalar) -> Self {
        Self(R::from_fn(f), R::from_fn(&mut |i| f(R::LANES + i)))
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> R::Scalar {
        if i < R::LANES {
            self.0.lane(i)
        } else {
            self.1.lane(i - R::LANES)
        }
    }

    both! { mul_add(a, b); mul_sub(a, b); mul_neg_add(a, b); sqrt(); abs(); select(negative, otherwise); }

    #[inline(always)]
    fn all_finite(self) -> bool {
        (self.0 + self.1).all_finite()
    }

    #[inline(always)]
    fn any_beyond(self, limit: R::Scalar) -> bool {
        self.0.any_beyond(limit) | self.1.any_beyond(limit)
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        let ((sin0, cos0), (sin1, cos1)) = (self.0.turn(sin.0, cos.0), self.1.turn(sin.1, cos.1));
        (Self(sin0, sin1), Self(cos0, cos1))
    }
}
