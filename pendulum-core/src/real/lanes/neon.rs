//! The vector registers of 64-bit ARM. Its baseline has their instructions (NEON), so that nothing is detected.
//!
//! The unsafe blocks rest on two facts: the module exists only for targets with NEON, and a vector has the memory
//! layout of the array of its lanes, for which every bit pattern is valid.
#![allow(
    unsafe_code,
    reason = "intrinsics are unsafe where the instruction set may be missing"
)]

use core::arch::aarch64::*;
use core::mem::transmute;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::register::{Fuse, Register, through_arrays};

macro_rules! operators {
    ($name:ident, $($trait:ident $method:ident $intrinsic:ident),*) => { $(
        impl $trait for $name {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($intrinsic(self.0, other.0)) }
            }
        }
    )* };
}

macro_rules! registers {
    ($(
        $(#[$doc:meta])*
        $name:ident = $lanes:literal $scalar:ident in $vector:ident,
        $splat:ident $add:ident $sub:ident $mul:ident $div:ident $neg:ident $sqrt:ident $abs:ident;
        $equal:ident $above:ident $as_words:ident $select:ident;
        $to_bits:ident $from_bits:ident $left:ident $is_negative:ident $and:ident $xor:ident of $bits:literal;
    )*) => { $(
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub(crate) struct $name($vector);

        operators!($name, Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for $name {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($neg(self.0)) }
            }
        }

        impl $name {
            #[inline(always)]
            fn from_array(array: [$scalar; $lanes]) -> Self {
                // SAFETY: a vector has the layout of the array of its lanes, and all bit patterns are valid.
                Self(unsafe { transmute::<[$scalar; $lanes], $vector>(array) })
            }

            #[inline(always)]
            fn to_array(self) -> [$scalar; $lanes] {
                // SAFETY: a vector has the layout of the array of its lanes, and all bit patterns are valid.
                unsafe { transmute::<$vector, [$scalar; $lanes]>(self.0) }
            }

            /// Shifts a bit, counted from the highest one, to the sign bit.
            #[inline(always)]
            fn to_sign<const PLACES: i32>(self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($from_bits($left::<PLACES>($to_bits(self.0)))) }
            }

            /// Keeps only the sign bit.
            #[inline(always)]
            fn sign(self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($from_bits($and($to_bits(self.0), $to_bits($splat(-0.0))))) }
            }

            /// Flips the bits that are set in `bits`.
            #[inline(always)]
            fn flip(self, bits: Self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($from_bits($xor($to_bits(self.0), $to_bits(bits.0)))) }
            }
        }

        impl Register for $name {
            type Scalar = $scalar;
            const LANES: usize = $lanes;

            #[inline(always)]
            fn splat(v: $scalar) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($splat(v)) }
            }

            through_arrays!($lanes $scalar);

            #[inline(always)]
            fn lane(&self, i: usize) -> $scalar {
                self.to_array()[i]
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($sqrt(self.0)) }
            }

            #[inline(always)]
            fn abs(self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($abs(self.0)) }
            }

            #[inline(always)]
            fn select(self, negative: Self, otherwise: Self) -> Self {
                // SAFETY: the target has NEON.
                unsafe { Self($select($is_negative($to_bits(self.0)), negative.0, otherwise.0)) }
            }

            #[inline(always)]
            fn all_finite(self) -> bool {
                // The product of 0 and a number that is not finite is NaN, and not equal to itself.
                let product = self * Self::splat(0.0);
                // SAFETY: the target has NEON.
                unsafe { vminvq_u32($as_words($equal(product.0, product.0))) != 0 }
            }

            #[inline(always)]
            fn any_beyond(self, limit: $scalar) -> bool {
                // SAFETY: the target has NEON.
                unsafe { vmaxvq_u32($as_words($above(self.abs().0, $splat(limit)))) != 0 }
            }

            #[inline(always)]
            fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
                // Moves each of the two lowest bits of the quotient to the sign bit.
                let (odd, second) = (self.to_sign::<{ $bits - 1 }>(), self.to_sign::<{ $bits - 2 }>());
                (
                    odd.select(cos, sin).flip(second.sign()),
                    odd.select(sin, cos).flip(second.flip(odd).sign()),
                )
            }
        }
    )* };
}

registers! {
    /// A register of `f64`.
    V64 = 2 f64 in float64x2_t,
    vdupq_n_f64 vaddq_f64 vsubq_f64 vmulq_f64 vdivq_f64 vnegq_f64 vsqrtq_f64 vabsq_f64;
    vceqq_f64 vcgtq_f64 vreinterpretq_u32_u64 vbslq_f64;
    vreinterpretq_s64_f64 vreinterpretq_f64_s64 vshlq_n_s64 vcltzq_s64 vandq_s64 veorq_s64 of 64;
    /// A register of `f32`.
    V32 = 4 f32 in float32x4_t,
    vdupq_n_f32 vaddq_f32 vsubq_f32 vmulq_f32 vdivq_f32 vnegq_f32 vsqrtq_f32 vabsq_f32;
    vceqq_f32 vcgtq_f32 words vbslq_f32;
    vreinterpretq_s32_f32 vreinterpretq_f32_s32 vshlq_n_s32 vcltzq_s32 vandq_s32 veorq_s32 of 32;
}

/// Masks of `f32` are words already.
#[inline(always)]
fn words(mask: uint32x4_t) -> uint32x4_t {
    mask
}

impl Fuse for V64 {
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        // SAFETY: the target has NEON.
        unsafe { Self(vfmaq_f64(b.0, self.0, a.0)) }
    }
}
