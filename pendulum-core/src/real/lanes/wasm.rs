//! The vector register of WebAssembly with the feature `simd128`. Its functions are safe: a module with instructions
//! that a machine does not have is refused as a whole.

use core::arch::wasm32::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::register::{Fuse, Register};

/// A register of two `f64`.
#[derive(Clone, Copy)]
pub(crate) struct V64(v128);

macro_rules! operators {
    ($($trait:ident $method:ident $function:ident;)*) => { $(
        impl $trait for V64 {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($function(self.0, other.0))
            }
        }
    )* };
}

operators! {
    Add add f64x2_add;
    Sub sub f64x2_sub;
    Mul mul f64x2_mul;
    Div div f64x2_div;
}

impl Neg for V64 {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(f64x2_neg(self.0))
    }
}

impl V64 {
    /// Selects `then` where the sign bit is set, `otherwise` elsewhere.
    #[inline(always)]
    fn where_negative(sign: v128, then: v128, otherwise: v128) -> v128 {
        v128_bitselect(then, otherwise, i64x2_shr(sign, 63))
    }
}

impl Register for V64 {
    type Scalar = f64;
    const LANES: usize = 2;

    #[inline(always)]
    fn splat(v: f64) -> Self {
        Self(f64x2_splat(v))
    }

    #[inline(always)]
    fn from_fn(f: &mut impl FnMut(usize) -> f64) -> Self {
        Self(f64x2(f(0), f(1)))
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> f64 {
        if i == 0 {
            f64x2_extract_lane::<0>(self.0)
        } else {
            f64x2_extract_lane::<1>(self.0)
        }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(f64x2_sqrt(self.0))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(f64x2_abs(self.0))
    }

    #[inline(always)]
    fn select(self, negative: Self, otherwise: Self) -> Self {
        Self(Self::where_negative(self.0, negative.0, otherwise.0))
    }

    #[inline(always)]
    fn all_finite(self) -> bool {
        // The product of 0 and a number that is not finite is NaN.
        let product = f64x2_mul(self.0, f64x2_splat(0.0));
        !v128_any_true(f64x2_ne(product, product))
    }

    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        v128_any_true(f64x2_gt(f64x2_abs(self.0), f64x2_splat(limit)))
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        // Moves each of the two lowest bits of the quotient to the sign bit.
        let (odd, second) = (i64x2_shl(self.0, 63), i64x2_shl(self.0, 62));
        let sign = |bits| v128_and(bits, f64x2_splat(-0.0));
        (
            Self(v128_xor(Self::where_negative(odd, cos.0, sin.0), sign(second))),
            Self(v128_xor(
                Self::where_negative(odd, sin.0, cos.0),
                sign(v128_xor(second, odd)),
            )),
        )
    }
}

/// Computed lane by lane, since WebAssembly has no fused instruction.
impl Fuse for V64 {
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        Self::from_fn(&mut |i| self.lane(i).fused_mul_add(a.lane(i), b.lane(i)))
    }
}
