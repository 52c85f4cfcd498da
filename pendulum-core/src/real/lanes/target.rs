//! Registers that every machine with the target of the compilation has, by their purpose.
//!
//! - `Least`: lanes where no instruction set is detected. On x86-64 these are scalars.
//! - `Two`: pairs of sines, in at least two lanes.
//! - `Wide`: arrays of numbers, as the slopes of dual numbers, in the widest register.
//! - `Widest`: such arrays in code for AVX2, which every machine has or a check has found.

cfg_select! {
    all(target_arch = "x86_64", target_feature = "sse2") => {
        pub(super) type Least32 = f32;
        pub(super) type Least64 = f64;
        pub(in crate::real) use super::x86::{Xmm32 as Two32, Xmm64 as Two64};
        pub(in crate::real) use super::x86::{Ymm32 as Widest32, Ymm64 as Widest64};
        #[cfg(not(target_feature = "avx2"))]
        pub(in crate::real) use super::x86::{Xmm32 as Wide32, Xmm64 as Wide64};
        #[cfg(target_feature = "avx2")]
        pub(in crate::real) use super::x86::{Ymm32 as Wide32, Ymm64 as Wide64};
    }
    all(target_arch = "aarch64", target_feature = "neon") => {
        pub(super) use super::neon::{V32 as Least32, V64 as Least64};
        pub(in crate::real) use super::neon::{V32 as Two32, V32 as Wide32, V64 as Two64, V64 as Wide64};
        pub(in crate::real) use super::neon::{V32 as Widest32, V64 as Widest64};
    }
    all(target_arch = "wasm32", target_feature = "simd128") => {
        pub(super) type Least32 = f32;
        pub(super) use super::wasm::V64 as Least64;
        pub(in crate::real) type Two32 = super::Pair<f32>;
        pub(in crate::real) type Wide32 = super::Pair<f32>;
        pub(in crate::real) type Widest32 = super::Pair<f32>;
        pub(in crate::real) use super::wasm::{V64 as Two64, V64 as Wide64, V64 as Widest64};
    }
    _ => {
        pub(super) type Least32 = f32;
        pub(super) type Least64 = f64;
        pub(in crate::real) type Two32 = super::Pair<f32>;
        pub(in crate::real) type Two64 = super::Pair<f64>;
        pub(in crate::real) type Wide32 = super::Pair<f32>;
        pub(in crate::real) type Wide64 = super::Pair<f64>;
        pub(in crate::real) type Widest32 = super::Pair<f32>;
        pub(in crate::real) type Widest64 = super::Pair<f64>;
    }
}
