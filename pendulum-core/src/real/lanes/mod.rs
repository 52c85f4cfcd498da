//! Lanes: several numbers in one vector register.
//!
//! Code that is generic over [`Real`] runs on lanes unchanged, and each lane is bit-identical to a scalar computation.
//! [`F64x4`] and its siblings work on any machine, but use only the baseline instructions of the target. [`Isa`]
//! detects AVX2 and AVX-512 at run time and runs a [`Kernel`] on their registers. On 64-bit ARM it uses those of NEON,
//! and in WebAssembly those of `simd128`, if the compilation enables it:
//!
//! ```
//! use pendulum_core::real::Real;
//! use pendulum_core::real::lanes::{Isa, Kernel, Lanes};
//!
//! /// The heights of the ends of rods of length 1 m, from their angles.
//! struct Heights<'a>(&'a mut [f64]);
//!
//! impl Kernel<f64> for Heights<'_> {
//!     type Output = ();
//!
//!     #[inline(always)]
//!     fn run<V: Lanes<Scalar = f64>>(self) {
//!         for angles in self.0.chunks_mut(V::LANES) {
//!             // the last chunk may be shorter: fill it up with its last number
//!             let angle = V::from_fn(|i| angles[i.min(angles.len() - 1)]);
//!             let height = -angle.sin_cos().1;
//!             for (i, angle) in angles.iter_mut().enumerate() {
//!                 *angle = height.lane(i);
//!             }
//!         }
//!     }
//! }
//!
//! let mut rods = [0.0, 0.3, 1.0, 2.0, 3.0];
//! Isa::widest().run(Heights(&mut rods));
//! assert_eq!(rods[2], -Real::sin_cos(1.0_f64).1);
//! ```

mod isa;
#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
mod neon;
mod pack;
mod register;
mod target;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod wasm;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod x86;

pub(super) use isa::InLanes;
pub use isa::{Isa, Kernel, LaneElement};
#[doc(hidden)]
pub use isa::{Routine, Second, WideKernel};
pub use pack::{F32x8, F32x16, F64x4, F64x8, Pack};
pub(crate) use register::{Fuse, Pair, Precision, Register};
pub(super) use target::{Two32, Two64, Wide32, Wide64, Widest32, Widest64};

use super::{Float, Real};

/// Implements [`Lanes`] for a number that is a single lane, except for the methods that check its value.
macro_rules! single_lane {
    () => {
        type Scalar = Self;

        #[inline(always)]
        fn splat(v: Self) -> Self {
            v
        }

        #[inline(always)]
        fn from_fn(mut f: impl FnMut(usize) -> Self) -> Self {
            f(0)
        }

        #[inline(always)]
        fn lane(&self, i: usize) -> Self {
            assert!(i == 0, "lane {i} of one");
            *self
        }
    };
}
pub(crate) use single_lane;

/// A [`Real`] made of one or more scalars; a scalar is a single lane.
pub trait Lanes: Real {
    /// Type of one lane.
    type Scalar: Float;

    /// Twice as many lanes, in two registers. Interleaving the halves hides instruction latency.
    type Double: Lanes<Scalar = Self::Scalar>;

    /// Sets all lanes to the same number.
    fn splat(v: Self::Scalar) -> Self;

    /// Sets each lane to `f(lane)`, which may be called more than once for a lane.
    fn from_fn(f: impl FnMut(usize) -> Self::Scalar) -> Self;

    /// Returns the number in lane `i`.
    ///
    /// # Panics
    /// If `i` is out of range.
    fn lane(&self, i: usize) -> Self::Scalar;

    /// True if the numbers in all lanes are finite. May return false for finite numbers whose sum overflows.
    fn all_finite(self) -> bool;

    /// Selects `negative` in the lanes where the sign bit of `self` is set, `otherwise` in the others.
    #[must_use]
    fn select(self, negative: Self, otherwise: Self) -> Self;
}
