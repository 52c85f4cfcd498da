//! The vector registers as types: one row for each.
//!
//! Values of these types are made in kernels only, which run beyond [`enter`](super::enter): there the machine is known to have the
//! instructions. Nobody else can name the types. Those of `xmm` registers are on every x86-64 machine.

use std::arch::x86_64::*;
use std::array;
use std::mem::transmute;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::super::register::{Pair, Register, one_by_one};
use crate::real::sincos::Angle;

macro_rules! binary {
    ($name:ident, $($trait:ident $method:ident $intrinsic:ident),*) => { $(
        impl $trait for $name {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: there is a value of the type, so the machine has the instruction.
                unsafe { Self($intrinsic(self.0, other.0)) }
            }
        }
    )* };
}

macro_rules! register {
    ($(
        $(#[$doc:meta])*
        $name:ident = $lanes:literal $scalar:ident in $vector:ident,
        $splat:ident $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident, $widen:ident $narrow:ident $wide:ty;
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
                // SAFETY: a vector is its lanes one after the other, and any bits are a number.
                Self(unsafe { transmute::<[$scalar; $lanes], $vector>(array) })
            }

            #[inline(always)]
            fn to_array(self) -> [$scalar; $lanes] {
                // SAFETY: a vector is its lanes one after the other, and any bits are a number.
                unsafe { transmute::<$vector, [$scalar; $lanes]>(self.0) }
            }
        }

        impl Register for $name {
            type Scalar = $scalar;
            const LANES: usize = $lanes;

            #[inline(always)]
            fn splat(v: $scalar) -> Self {
                // SAFETY: kernels alone can ask for a value of the type, and they run where the machine has the instruction.
                unsafe { Self($splat(v)) }
            }

            #[inline(always)]
            fn from_fn(f: &mut impl FnMut(usize) -> $scalar) -> Self {
                Self::from_array(array::from_fn(f))
            }

            #[inline(always)]
            fn lane(self, i: usize) -> $scalar {
                self.to_array()[i]
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: there is a value of the type, so the machine has the instruction.
                unsafe { Self($sqrt(self.0)) }
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.clear(Self::splat(-0.0))
            }

            type Wide = $wide;

            #[inline(always)]
            fn widen(self) -> $wide {
                $widen(self)
            }

            #[inline(always)]
            fn narrow(wide: $wide) -> Self {
                $narrow(wide)
            }
        }
    )* };
}

register! {
    /// An `xmm` register of `f64`.
    Xmm64 = 2 f64 in __m128d,
    _mm_set1_pd _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd, same same Xmm64;
    /// A `ymm` register of `f64`.
    Ymm64 = 4 f64 in __m256d,
    _mm256_set1_pd _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd, same same Ymm64;
    /// A `zmm` register of `f64`.
    Zmm64 = 8 f64 in __m512d,
    _mm512_set1_pd _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd, same same Zmm64;
    /// A `ymm` register of `f32`.
    Ymm32 = 8 f32 in __m256,
    _mm256_set1_ps _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_sqrt_ps, widen_ymm narrow_ymm Pair<Ymm64>;
    /// A `zmm` register of `f32`.
    Zmm32 = 16 f32 in __m512,
    _mm512_set1_ps _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps _mm512_sqrt_ps, widen_zmm narrow_zmm Pair<Zmm64>;
}

/// Operations on bits, which have a name of their own for each register.
macro_rules! bits {
    ($($name:ident $cast:ident $back:ident $xor:ident $andnot:ident;)*) => { $(
        impl $name {
            /// Without the bits that are set in `bits`.
            #[inline(always)]
            fn clear(self, bits: Self) -> Self {
                // SAFETY: there is a value of the type, so the machine has the instructions.
                unsafe { Self($back($andnot($cast(bits.0), $cast(self.0)))) }
            }

            /// With the bits that are set in `bits` inverted.
            #[inline(always)]
            fn flip(self, bits: Self) -> Self {
                // SAFETY: there is a value of the type, so the machine has the instructions.
                unsafe { Self($back($xor($cast(bits.0), $cast(self.0)))) }
            }
        }
    )* };
}

bits! {
    Xmm64 _mm_castpd_si128 _mm_castsi128_pd _mm_xor_si128 _mm_andnot_si128;
    Ymm64 _mm256_castpd_si256 _mm256_castsi256_pd _mm256_xor_si256 _mm256_andnot_si256;
    Zmm64 _mm512_castpd_si512 _mm512_castsi512_pd _mm512_xor_si512 _mm512_andnot_si512;
    Ymm32 _mm256_castps_si256 _mm256_castsi256_ps _mm256_xor_si256 _mm256_andnot_si256;
    Zmm32 _mm512_castps_si512 _mm512_castsi512_ps _mm512_xor_si512 _mm512_andnot_si512;
}

/// Registers of `f64` are as wide as they get.
#[inline(always)]
fn same<R>(register: R) -> R {
    register
}

#[inline(always)]
fn widen_ymm(narrow: Ymm32) -> Pair<Ymm64> {
    // SAFETY: there is a value of the type, so the machine has the instructions.
    unsafe {
        Pair(
            Ymm64(_mm256_cvtps_pd(_mm256_castps256_ps128(narrow.0))),
            Ymm64(_mm256_cvtps_pd(_mm256_extractf128_ps::<1>(narrow.0))),
        )
    }
}

#[inline(always)]
fn narrow_ymm(Pair(low, high): Pair<Ymm64>) -> Ymm32 {
    // SAFETY: there are values of the type, so the machine has the instructions.
    unsafe { Ymm32(_mm256_set_m128(_mm256_cvtpd_ps(high.0), _mm256_cvtpd_ps(low.0))) }
}

#[inline(always)]
fn widen_zmm(narrow: Zmm32) -> Pair<Zmm64> {
    // SAFETY: there is a value of the type, so the machine has the instructions.
    unsafe {
        let high = _mm512_extractf64x4_pd::<1>(_mm512_castps_pd(narrow.0));
        Pair(
            Zmm64(_mm512_cvtps_pd(_mm512_castps512_ps256(narrow.0))),
            Zmm64(_mm512_cvtps_pd(_mm256_castpd_ps(high))),
        )
    }
}

#[inline(always)]
fn narrow_zmm(Pair(low, high): Pair<Zmm64>) -> Zmm32 {
    // SAFETY: there are values of the type, so the machine has the instructions.
    unsafe {
        let low = _mm512_castpd256_pd512(_mm256_castps_pd(_mm512_cvtpd_ps(low.0)));
        let high = _mm256_castps_pd(_mm512_cvtpd_ps(high.0));
        Zmm32(_mm512_castpd_ps(_mm512_insertf64x4::<1>(low, high)))
    }
}

impl Angle for Xmm64 {
    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        // SAFETY: every x86-64 machine has the instructions.
        unsafe { _mm_movemask_pd(_mm_cmpgt_pd(self.abs().0, _mm_set1_pd(limit))) != 0 }
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        // SAFETY: every x86-64 machine has the instructions.
        unsafe {
            let (n, one) = (_mm_castpd_si128(self.0), _mm_set1_epi64x(1));
            let (sin, cos) = (_mm_castpd_si128(sin.0), _mm_castpd_si128(cos.0));
            let odd = _mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(n, one));
            let swap = _mm_and_si128(_mm_xor_si128(sin, cos), odd);
            let turned = |v: __m128i, n: __m128i| {
                let sign = _mm_and_si128(_mm_slli_epi64::<62>(n), _mm_set1_epi64x(i64::MIN));
                Self(_mm_castsi128_pd(_mm_xor_si128(_mm_xor_si128(v, swap), sign)))
            };
            (turned(sin, n), turned(cos, _mm_add_epi64(n, one)))
        }
    }

    #[inline(always)]
    fn far(self) -> (Self, Self) {
        one_by_one(self)
    }
}

impl Angle for Ymm64 {
    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        // SAFETY: there is a value of the type, so the machine has the instructions.
        unsafe {
            let limit = _mm256_set1_pd(limit);
            _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(self.abs().0, limit)) != 0
        }
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        // SAFETY: there is a value of the type, so the machine has the instructions.
        unsafe {
            let n = _mm256_castpd_si256(self.0);
            // The lowest bit in the place of the sign, which decides in a blend.
            let odd = _mm256_castsi256_pd(_mm256_slli_epi64::<63>(n));
            let second = _mm256_castsi256_pd(_mm256_slli_epi64::<62>(n));
            let minus = _mm256_set1_pd(-0.0);
            let sign = _mm256_and_pd(second, minus);
            let sin_or_cos = _mm256_blendv_pd(sin.0, cos.0, odd);
            let cos_or_sin = _mm256_blendv_pd(cos.0, sin.0, odd);
            let sign_cos = _mm256_and_pd(_mm256_xor_pd(second, odd), minus);
            (
                Self(_mm256_xor_pd(sin_or_cos, sign)),
                Self(_mm256_xor_pd(cos_or_sin, sign_cos)),
            )
        }
    }

    #[inline(always)]
    fn far(self) -> (Self, Self) {
        one_by_one(self)
    }
}

impl Angle for Zmm64 {
    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        // SAFETY: there is a value of the type, so the machine has the instructions.
        unsafe { _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.abs().0, _mm512_set1_pd(limit)) != 0 }
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        /// `a ^ (b & c)` as a table of truth.
        const FLIP: i32 = 0x78;
        // SAFETY: there is a value of the type, so the machine has the instructions.
        unsafe {
            let n = _mm512_castpd_si512(self.0);
            let odd = _mm512_test_epi64_mask(n, _mm512_set1_epi64(1));
            let minus = _mm512_set1_epi64(i64::MIN);
            let turned = |v: __m512d, second: __m512i| {
                let flipped = _mm512_ternarylogic_epi64::<FLIP>(_mm512_castpd_si512(v), second, minus);
                Self(_mm512_castsi512_pd(flipped))
            };
            let next = _mm512_add_epi64(n, _mm512_set1_epi64(1));
            (
                turned(_mm512_mask_blend_pd(odd, sin.0, cos.0), _mm512_slli_epi64::<62>(n)),
                turned(_mm512_mask_blend_pd(odd, cos.0, sin.0), _mm512_slli_epi64::<62>(next)),
            )
        }
    }

    #[inline(always)]
    fn far(self) -> (Self, Self) {
        one_by_one(self)
    }
}
