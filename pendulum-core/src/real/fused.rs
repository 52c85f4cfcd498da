//! Fused arithmetic: products and sums in one operation, rounded once.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::lanes::{
    Fuse, InLanes, Isa, Lanes, Pack, Pair, Precision, Register, Routine, Two64, Wide64, WideKernel, Widest64,
    single_lane,
};
use super::scalar::{each, in_registers};
use super::sincos;
use super::{Float, Real};

/// A number whose sums with a product, [`Real::mul_add`] and its siblings, are rounded once instead of twice.
///
/// Generated code, methods and sines take fewer instructions in this type, and sums in which a product cancels keep
/// more digits. Results differ from those of `f64` in the last bits, and are bit-identical on every machine: where the
/// processor has no fused operation, a function computes it, many times slower. [`fused`](crate::Rk45::fused) runs an
/// integration in fused arithmetic, and passes times, states and events as `f64`.
///
/// ```
/// use pendulum_core::real::{Fused, Real};
///
/// let third = 1.0 / 3.0;
/// // the product is rounded to 1
/// assert_eq!(Real::mul_sub(third, 3.0, 1.0), 0.0);
/// assert_eq!(Fused(third).mul_sub(Fused(3.0), Fused(1.0)), Fused(-2_f64.powi(-54)));
/// ```
///
/// Only `Fused<f64>` and its lanes are a [`Real`]. [Dual numbers](crate::dual::Dual) of them have the same values, and
/// fuse the sums of derivatives, too. The operations are inlined in code for processors that have them: in the steps of
/// integrations, in a [kernel](super::lanes::Kernel), and in builds with `-C target-cpu=native`. Elsewhere on x86-64,
/// in builds with debug assertions and without `std`, each is a call.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fused<T>(pub T);

/// The numbers as `f64`. Loops that copy them, one for each operation on derivatives, take compilers minutes to unroll.
#[allow(unsafe_code, reason = "safe code would copy the numbers")]
#[inline(always)]
fn plain(fused: &[Fused<f64>]) -> &[f64] {
    // SAFETY: the type is transparent.
    unsafe { core::slice::from_raw_parts(fused.as_ptr().cast(), fused.len()) }
}

/// Like [`plain`], for changes.
#[allow(unsafe_code, reason = "safe code would copy the numbers")]
#[inline(always)]
fn plain_mut(fused: &mut [Fused<f64>]) -> &mut [f64] {
    // SAFETY: the type is transparent.
    unsafe { core::slice::from_raw_parts_mut(fused.as_mut_ptr().cast(), fused.len()) }
}

macro_rules! operator {
    ($($trait:ident $method:ident $assign:ident $assigned:ident;)*) => { $(
        impl<T: $trait<Output = T>> $trait for Fused<T> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0))
            }
        }

        impl<T: $trait<Output = T> + Copy> $assign for Fused<T> {
            #[inline(always)]
            fn $assigned(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    )* };
}

operator! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}

impl<T: Neg<Output = T>> Neg for Fused<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<R: Fuse> Register for Fused<R> {
    type Scalar = Fused<f64>;
    const LANES: usize = R::LANES;

    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, C: Routine<A, B>>(routine: C, changed: &mut A, read: &B) -> C::Output {
        R::call(routine, changed, read)
    }

    #[inline(always)]
    fn splat(v: Fused<f64>) -> Self {
        Self(R::splat(v.0))
    }

    #[inline(always)]
    fn from_fn(f: &mut impl FnMut(usize) -> Fused<f64>) -> Self {
        Self(R::from_fn(&mut |i| f(i).0))
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> Fused<f64> {
        Fused(self.0.lane(i))
    }

    #[inline(always)]
    fn load(from: &[Fused<f64>]) -> Self {
        Self(R::load(plain(from)))
    }

    #[inline(always)]
    fn store(self, to: &mut [Fused<f64>]) {
        self.0.store(plain_mut(to));
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(self.0.fused_mul_add(a.0, b.0))
    }

    #[inline(always)]
    fn mul_sub(self, a: Self, b: Self) -> Self {
        Self(self.0.fused_mul_add(a.0, -b.0))
    }

    #[inline(always)]
    fn mul_neg_add(self, a: Self, b: Self) -> Self {
        Self((-self.0).fused_mul_add(a.0, b.0))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn select(self, negative: Self, otherwise: Self) -> Self {
        Self(self.0.select(negative.0, otherwise.0))
    }

    #[inline(always)]
    fn all_finite(self) -> bool {
        self.0.all_finite()
    }

    #[inline(always)]
    fn any_beyond(self, limit: Fused<f64>) -> bool {
        self.0.any_beyond(limit.0)
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        let (sin, cos) = self.0.turn(sin.0, cos.0);
        (Self(sin), Self(cos))
    }
}

/// Numbers as fused ones.
const fn fused<const N: usize>(numbers: &[f64]) -> [Fused<f64>; N] {
    let mut fused = [Fused(0.0); N];
    let mut i = 0;
    while i < N {
        fused[i] = Fused(numbers[i]);
        i += 1;
    }
    fused
}

/// The kernel of `f64`, with fused operations.
impl Precision for Fused<f64> {
    const LIMIT: Self = Fused(f64::LIMIT);
    const HALF_PI: (&'static [Self], [Self; 2]) = (
        &fused::<{ f64::HALF_PI.0.len() }>(f64::HALF_PI.0),
        fused(&f64::HALF_PI.1),
    );
    const SHIFT: Self = Fused(f64::SHIFT);
    const SIN: &'static [Self] = &fused::<{ f64::SIN.len() }>(f64::SIN);
    const COS: &'static [Self] = &fused::<{ f64::COS.len() }>(f64::COS);

    #[inline]
    fn far(self) -> (Self, Self) {
        let (sin, cos) = self.0.far();
        (Fused(sin), Fused(cos))
    }
}

macro_rules! forward {
    ($($method:ident($($argument:ident),*);)*) => { $(
        #[inline(always)]
        fn $method(self, $($argument: Self),*) -> Self {
            Self(Real::$method(self.0, $($argument.0),*))
        }
    )* };
}

impl Real for Fused<f64> {
    const IS_PLAIN: bool = true;

    #[inline(always)]
    fn from_f64(v: f64) -> Self {
        Self(v)
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Register::mul_add(self, a, b)
    }

    #[inline(always)]
    fn mul_sub(self, a: Self, b: Self) -> Self {
        Register::mul_sub(self, a, b)
    }

    #[inline(always)]
    fn mul_neg_add(self, a: Self, b: Self) -> Self {
        Register::mul_neg_add(self, a, b)
    }

    #[inline]
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        piece(self.0).map(Self)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        sincos::sin_cos(self)
    }

    #[inline(always)]
    fn sin_cos_pair(self, other: Self) -> [(Self, Self); 2] {
        sincos::sin_cos_pair::<Fused<Two64>>([self, other])
    }

    in_registers!(Fused<Two64>, Fused<Wide64>, Fused<Widest64>);

    #[inline(always)]
    fn mul_add_each<const N: usize>(a: [Self; N], factor: Self, b: [Self; N]) -> [Self; N] {
        let (narrow, wide) = (<Fused<Two64>>::splat(factor), <Fused<Wide64>>::splat(factor));
        each::<Fused<Two64>, Fused<Wide64>, N>(
            a,
            b,
            |a, b| a.mul_add(wide, b),
            |a, b| a.mul_add(narrow, b),
            |a, b| Real::mul_add(a, factor, b),
        )
    }

    forward! {
        tan();
        exp();
        ln();
        sqrt();
        tanh();
        abs();
        signum();
        at_least(low);
        at_most(high);
        atan2(x);
        powf(exponent);
    }
}

/// A single lane.
impl Lanes for Fused<f64> {
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

impl Float for Fused<f64> {
    const EPSILON: Self = Self(f64::EPSILON);
    const MIN_POSITIVE: Self = Self(f64::MIN_POSITIVE);

    #[inline]
    fn to_f64(self) -> f64 {
        self.0
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
}

#[cfg(test)]
mod tests {
    use super::Fused;
    use crate::real::Real;

    /// Numbers in [-0.5, 0.5), times a power of 2.
    fn numbers(seed: u64) -> impl FnMut(i32) -> f64 {
        let mut bits = seed;
        move |magnitude| {
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            let number = f64::from_bits(bits >> 12 | 0x3ff0_0000_0000_0000) - 1.5;
            number * 2_f64.powi((bits % 64) as i32 * magnitude)
        }
    }

    /// A number as the exact sum of two numbers of 26 bits. T. J. Dekker, "A floating-point technique for extending the
    /// available precision" (1971).
    fn halves(a: f64) -> [f64; 2] {
        let scaled = 134_217_729.0 * a;
        let high = scaled - (scaled - a);
        [high, a - high]
    }

    #[test]
    fn the_rest_of_a_product_is_exact() {
        let mut next = numbers(0x9e37_79b9_7f4a_7c15);
        for _ in 0..100_000 {
            let (a, b) = (next(1), next(-1));
            let product = a * b;
            let ([a1, a0], [b1, b0]) = (halves(a), halves(b));
            let rest = ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0;
            assert_eq!(Fused(a).mul_sub(Fused(b), Fused(product)).0, rest, "{a:e} {b:e}");
            assert_eq!(Fused(a).mul_neg_add(Fused(b), Fused(product)).0, -rest, "{a:e} {b:e}");
            assert_eq!(Fused(a).mul_add(Fused(b), Fused(-product)).0, rest, "{a:e} {b:e}");
        }
    }

    #[test]
    fn the_function_of_libm_rounds_alike() {
        let mut next = numbers(0x2545_f491_4f6c_dd1d);
        let special = [
            0.0,
            -0.0,
            1.0,
            f64::MIN_POSITIVE,
            5e-324,
            f64::MAX,
            f64::INFINITY,
            f64::NAN,
        ];
        let check = |a: f64, b: f64, c: f64| {
            let [own, expected] = [Fused(a).mul_add(Fused(b), Fused(c)).0, libm::fma(a, b, c)];
            let agree = own.to_bits() == expected.to_bits() || own.is_nan() && expected.is_nan();
            assert!(agree, "{a:e} * {b:e} + {c:e}: {own:e}, not {expected:e}");
        };
        for _ in 0..10_000 {
            check(next(1), next(-1), next(1));
            check(next(-15), next(-15), next(-16));
        }
        for a in special {
            for b in special {
                special.iter().for_each(|&c| check(a, b, c));
            }
        }
    }
}
