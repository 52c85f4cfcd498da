//! The vector registers as types, one table row each.
//!
//! The unsafe blocks are justified in [`x86`](super).

use core::arch::x86_64::*;
use core::mem::transmute;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::super::Routine;
use super::super::register::{Fuse, Register, through_arrays};

macro_rules! binary {
    ($name:ident, $($trait:ident $method:ident $intrinsic:ident),*) => { $(
        impl $trait for $name {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instruction.
                unsafe { Self($intrinsic(self.0, other.0)) }
            }
        }
    )* };
}

macro_rules! register {
    ($(
        $(#[$doc:meta])*
        $name:ident = $lanes:literal $scalar:ident in $vector:ident by $features:literal,
        $splat:ident $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident;
    )*) => { $(
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub(crate) struct $name($vector);

        binary!($name, Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for $name {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                self.flip(Self::splat(-0.0))
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

            #[inline(always)]
            fn as_array(&self) -> &[$scalar; $lanes] {
                // SAFETY: as above, and a vector is aligned to more than its lanes.
                unsafe { transmute::<&$vector, &[$scalar; $lanes]>(&self.0) }
            }
        }

        impl Register for $name {
            type Scalar = $scalar;
            const LANES: usize = $lanes;

            #[inline(always)]
            fn call<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
                #[inline(never)]
                #[target_feature(enable = $features)]
                fn inside<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
                    routine.run(changed, read)
                }
                // SAFETY: code that can name the type runs only on machines with the instructions.
                unsafe { inside(routine, changed, read) }
            }

            #[inline(always)]
            fn splat(v: $scalar) -> Self {
                // SAFETY: code that can name the type runs only on machines with the instruction.
                unsafe { Self($splat(v)) }
            }

            through_arrays!($lanes $scalar);

            #[inline(always)]
            fn lane(&self, i: usize) -> $scalar {
                // by reference, so that vectors in memory are not copied for each of their lanes
                self.as_array()[i]
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instruction.
                unsafe { Self($sqrt(self.0)) }
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.clear(Self::splat(-0.0))
            }

            #[inline(always)]
            fn select(self, negative: Self, otherwise: Self) -> Self {
                self.where_negative(negative, otherwise)
            }

            #[inline(always)]
            fn all_finite(self) -> bool {
                // The product of 0 and a number that is not finite is NaN.
                !(self * Self::splat(0.0)).any_nan()
            }

            #[inline(always)]
            fn any_beyond(self, limit: $scalar) -> bool {
                self.abs().any_above(Self::splat(limit))
            }

            #[inline(always)]
            fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
                // Moves each of the two lowest bits of the quotient to the sign bit.
                let (odd, second) = (self.lowest_to_sign(), self.second_to_sign());
                (
                    odd.where_negative(cos, sin).flip(second.sign()),
                    odd.where_negative(sin, cos).flip(second.flip(odd).sign()),
                )
            }
        }
    )* };
}

register! {
    /// An `xmm` register of `f64`.
    Xmm64 = 2 f64 in __m128d by "sse2",
    _mm_set1_pd _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd;
    /// An `xmm` register of `f32`.
    Xmm32 = 4 f32 in __m128 by "sse2",
    _mm_set1_ps _mm_add_ps _mm_sub_ps _mm_mul_ps _mm_div_ps _mm_sqrt_ps;
    /// A `ymm` register of `f64`.
    Ymm64 = 4 f64 in __m256d by "avx2,fma",
    _mm256_set1_pd _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd;
    /// A `ymm` register of `f32`.
    Ymm32 = 8 f32 in __m256 by "avx2,fma",
    _mm256_set1_ps _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_sqrt_ps;
    /// A `zmm` register of `f64`.
    Zmm64 = 8 f64 in __m512d by "avx512f",
    _mm512_set1_pd _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd;
    /// A `zmm` register of `f32`.
    Zmm32 = 16 f32 in __m512 by "avx512f",
    _mm512_set1_ps _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps _mm512_sqrt_ps;
}

impl Fuse for Xmm64 {
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        #[cfg(target_feature = "fma")]
        // SAFETY: every machine with the target of the compilation has the instruction.
        return unsafe { Self(_mm_fmadd_pd(self.0, a.0, b.0)) };
        // Lane by lane, since code that can name the type runs on machines without the instruction, too.
        #[cfg(not(target_feature = "fma"))]
        return Self::from_array([
            self.lane(0).fused_mul_add(a.lane(0), b.lane(0)),
            self.lane(1).fused_mul_add(a.lane(1), b.lane(1)),
        ]);
    }
}

impl Fuse for Ymm64 {
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        // SAFETY: a value of the type exists, so the machine has the instruction.
        unsafe { Self(_mm256_fmadd_pd(self.0, a.0, b.0)) }
    }
}

impl Fuse for Zmm64 {
    #[inline(always)]
    fn fused_mul_add(self, a: Self, b: Self) -> Self {
        // SAFETY: a value of the type exists, so the machine has the instruction.
        unsafe { Self(_mm512_fmadd_pd(self.0, a.0, b.0)) }
    }
}

/// Bitwise operations, selection and comparison, whose intrinsics differ between registers.
macro_rules! bits {
    ($(
        $name:ident: $cast:ident $back:ident $xor:ident $and:ident $andnot:ident $shift:ident from $bits:literal,
        |$sign:ident, $then:ident, $otherwise:ident| $select:expr,
        |$left:ident, $right:ident| $any_above:expr,
        |$value:ident| $any_nan:expr;
    )*) => { $(
        impl $name {
            /// Clears the bits that are set in `bits`.
            #[inline(always)]
            fn clear(self, bits: Self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { Self($back($andnot($cast(bits.0), $cast(self.0)))) }
            }

            /// Flips the bits that are set in `bits`.
            #[inline(always)]
            fn flip(self, bits: Self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { Self($back($xor($cast(bits.0), $cast(self.0)))) }
            }

            /// Keeps only the sign bit.
            #[inline(always)]
            fn sign(self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { Self($back($and($cast(self.0), $cast(Self::splat(-0.0).0)))) }
            }

            /// Shifts the lowest bit to the sign bit.
            #[inline(always)]
            fn lowest_to_sign(self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { Self($back($shift::<{ $bits - 1 }>($cast(self.0)))) }
            }

            /// Shifts the second lowest bit to the sign bit.
            #[inline(always)]
            fn second_to_sign(self) -> Self {
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { Self($back($shift::<{ $bits - 2 }>($cast(self.0)))) }
            }

            /// Selects `then` where the sign bit is set, `otherwise` elsewhere.
            #[inline(always)]
            fn where_negative(self, Self($then): Self, Self($otherwise): Self) -> Self {
                let $sign = self.0;
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { Self($select) }
            }

            /// True if any lane exceeds the corresponding lane of the other register.
            #[inline(always)]
            fn any_above(self, Self($right): Self) -> bool {
                let $left = self.0;
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { $any_above }
            }

            /// True if any lane is NaN.
            #[inline(always)]
            fn any_nan(self) -> bool {
                let $value = self.0;
                // SAFETY: a value of the type exists, so the machine has the instructions.
                unsafe { $any_nan }
            }
        }
    )* };
}

bits! {
    Xmm64: _mm_castpd_si128 _mm_castsi128_pd _mm_xor_si128 _mm_and_si128 _mm_andnot_si128
    _mm_slli_epi64 from 64,
    |sign, then, otherwise| {
        let high = _mm_srai_epi32::<31>(_mm_castpd_si128(sign));
        let mask = _mm_castsi128_pd(_mm_shuffle_epi32::<0b11_11_01_01>(high));
        _mm_xor_pd(otherwise, _mm_and_pd(_mm_xor_pd(then, otherwise), mask))
    },
    |left, right| _mm_movemask_pd(_mm_cmpgt_pd(left, right)) != 0,
    |value| _mm_movemask_pd(_mm_cmpunord_pd(value, value)) != 0;
    Xmm32: _mm_castps_si128 _mm_castsi128_ps _mm_xor_si128 _mm_and_si128 _mm_andnot_si128
    _mm_slli_epi32 from 32,
    |sign, then, otherwise| {
        let mask = _mm_castsi128_ps(_mm_srai_epi32::<31>(_mm_castps_si128(sign)));
        _mm_xor_ps(otherwise, _mm_and_ps(_mm_xor_ps(then, otherwise), mask))
    },
    |left, right| _mm_movemask_ps(_mm_cmpgt_ps(left, right)) != 0,
    |value| _mm_movemask_ps(_mm_cmpunord_ps(value, value)) != 0;
    Ymm64: _mm256_castpd_si256 _mm256_castsi256_pd _mm256_xor_si256 _mm256_and_si256 _mm256_andnot_si256
    _mm256_slli_epi64 from 64,
    |sign, then, otherwise| _mm256_blendv_pd(otherwise, then, sign),
    |left, right| _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(left, right)) != 0,
    |value| _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_UNORD_Q>(value, value)) != 0;
    Ymm32: _mm256_castps_si256 _mm256_castsi256_ps _mm256_xor_si256 _mm256_and_si256 _mm256_andnot_si256
    _mm256_slli_epi32 from 32,
    |sign, then, otherwise| _mm256_blendv_ps(otherwise, then, sign),
    |left, right| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(left, right)) != 0,
    |value| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_UNORD_Q>(value, value)) != 0;
    Zmm64: _mm512_castpd_si512 _mm512_castsi512_pd _mm512_xor_si512 _mm512_and_si512 _mm512_andnot_si512
    _mm512_slli_epi64 from 64,
    |sign, then, otherwise| {
        let minus = _mm512_test_epi64_mask(_mm512_castpd_si512(sign), _mm512_set1_epi64(i64::MIN));
        _mm512_mask_blend_pd(minus, otherwise, then)
    },
    |left, right| _mm512_cmp_pd_mask::<_CMP_GT_OQ>(left, right) != 0,
    |value| _mm512_cmp_pd_mask::<_CMP_UNORD_Q>(value, value) != 0;
    Zmm32: _mm512_castps_si512 _mm512_castsi512_ps _mm512_xor_si512 _mm512_and_si512 _mm512_andnot_si512
    _mm512_slli_epi32 from 32,
    |sign, then, otherwise| {
        let minus = _mm512_test_epi32_mask(_mm512_castps_si512(sign), _mm512_set1_epi32(i32::MIN));
        _mm512_mask_blend_ps(minus, otherwise, then)
    },
    |left, right| _mm512_cmp_ps_mask::<_CMP_GT_OQ>(left, right) != 0,
    |value| _mm512_cmp_ps_mask::<_CMP_UNORD_Q>(value, value) != 0;
}
