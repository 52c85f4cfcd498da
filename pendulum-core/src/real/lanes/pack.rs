//! Lanes as a [`Real`].

use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::register::{Pair, Register};
use super::{Lanes, Routine};
use crate::real::{Real, sincos};

/// Lanes stored in registers `R`: see [`F64x4`], [`F64x8`], [`F32x8`] and [`F32x16`].
#[derive(Clone, Copy)]
pub struct Pack<R>(R);

/// Four lanes of `f64`, on any machine; [`Isa`](super::Isa) selects faster ones.
pub type F64x4 = Pack<Pair<Pair<f64>>>;
/// Eight lanes of `f64`, on any machine; [`Isa`](super::Isa) selects faster ones.
pub type F64x8 = Pack<Pair<Pair<Pair<f64>>>>;
/// Eight lanes of `f32`, on any machine; [`Isa`](super::Isa) selects faster ones.
pub type F32x8 = Pack<Pair<Pair<Pair<f32>>>>;
/// Sixteen lanes of `f32`, on any machine; [`Isa`](super::Isa) selects faster ones.
pub type F32x16 = Pack<Pair<Pair<Pair<Pair<f32>>>>>;

impl<R: Register> Pack<R> {
    /// Applies `f` to each lane.
    #[inline(always)]
    fn map(self, f: impl Fn(R::Scalar) -> R::Scalar) -> Self {
        Self::from_fn(|i| f(self.lane(i)))
    }

    /// Applies `f` to each pair of lanes.
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(R::Scalar, R::Scalar) -> R::Scalar) -> Self {
        Self::from_fn(|i| f(self.lane(i), other.lane(i)))
    }
}

impl<R: Register> Lanes for Pack<R> {
    type Scalar = R::Scalar;
    type Double = Pack<Pair<R>>;

    #[inline(always)]
    fn splat(v: R::Scalar) -> Self {
        Self(R::splat(v))
    }

    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> R::Scalar) -> Self {
        Self(R::from_fn(&mut f))
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> R::Scalar {
        assert!(i < R::LANES, "a lane below {}, not {i}", R::LANES);
        self.0.lane(i)
    }

    #[inline(always)]
    fn all_finite(self) -> bool {
        self.0.all_finite()
    }

    #[inline(always)]
    fn select(self, negative: Self, otherwise: Self) -> Self {
        Self(self.0.select(negative.0, otherwise.0))
    }
}

/// Operations of the registers.
macro_rules! in_registers {
    ($($method:ident($($argument:ident),*);)*) => { $(
        #[inline(always)]
        fn $method(self, $($argument: Self),*) -> Self {
            Self(self.0.$method($($argument.0),*))
        }
    )* };
}

/// Functions that registers do not have.
macro_rules! by_lanes {
    ($over:ident: $($method:ident($($argument:ident)?);)*) => { $(
        #[inline]
        fn $method(self, $($argument: Self)?) -> Self {
            self.$over($($argument,)? Real::$method)
        }
    )* };
}

impl<R: Register> Real for Pack<R> {
    const LANES: usize = R::LANES;
    const IS_PLAIN: bool = R::Scalar::IS_PLAIN;

    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, C: Routine<A, B>>(routine: C, changed: &mut A, read: &B) -> C::Output {
        R::call(routine, changed, read)
    }

    #[inline(always)]
    fn from_f64(v: f64) -> Self {
        Self::splat(R::Scalar::from_f64(v))
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.0.all_finite() && !self.0.any_beyond(R::Scalar::default())
    }

    #[inline]
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.piecewise_by_lane(|_, number| piece(number))
    }

    #[inline]
    fn piecewise_by_lane<const C: usize>(self, piece: impl Fn(usize, f64) -> [f64; C]) -> [Self; C] {
        let of_lane = |lane| self.lane(lane).piecewise(|number| piece(lane, number));
        core::array::from_fn(|c| Self::from_fn(|lane| of_lane(lane)[c]))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = sincos::sin_cos(self.0);
        (Self(sin), Self(cos))
    }

    in_registers! { mul_add(a, b); mul_sub(a, b); mul_neg_add(a, b); sqrt(); abs(); }
    by_lanes! { map: tan(); exp(); ln(); tanh(); signum(); }
    by_lanes! { zip: at_least(low); at_most(high); atan2(x); powf(exponent); }
}

macro_rules! operators {
    ($($trait:ident, $method:ident, $assign:ident, $assigned:ident;)*) => { $(
        impl<R: Register> $trait for Pack<R> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0))
            }
        }

        impl<R: Register> $assign for Pack<R> {
            #[inline(always)]
            fn $assigned(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    )* };
}

operators! {
    Add, add, AddAssign, add_assign;
    Sub, sub, SubAssign, sub_assign;
    Mul, mul, MulAssign, mul_assign;
    Div, div, DivAssign, div_assign;
}

impl<R: Register> Neg for Pack<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Zero in all lanes.
impl<R: Register> Default for Pack<R> {
    #[inline(always)]
    fn default() -> Self {
        Self::splat(R::Scalar::default())
    }
}

/// Equality in all lanes.
impl<R: Register> PartialEq for Pack<R> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        (0..R::LANES).all(|i| self.lane(i) == other.lane(i))
    }
}

impl<R: Register> fmt::Debug for Pack<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries((0..R::LANES).map(|i| self.lane(i))).finish()
    }
}
