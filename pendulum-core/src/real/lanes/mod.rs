//! Lanes: several numbers that are computed with at once, in the vector registers of the machine.
//!
//! Code that is generic over [`Real`] runs on lanes as it stands, and gives in each lane what it gives for a scalar, bit for bit.
//! [`F64x4`] and its like work on any machine. They are as fast as the code that a compiler makes for all machines; where AVX2 or AVX-512
//! are there at run time, [`Isa`] lends registers of these to a [`Kernel`]:
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
//!             // a number too few: the last again
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
mod pack;
mod register;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use isa::{Isa, Kernel, LaneElement};
pub(super) use register::{Pair, Register};
#[cfg(target_arch = "x86_64")]
pub(super) use x86::Xmm64;

pub use pack::{F32x8, F32x16, F64x4, F64x8, Pack};

use super::{Float, Real};

/// A [`Real`] that is scalars side by side; a scalar is one lane.
pub trait Lanes: Real {
    /// The type of one lane.
    type Scalar: Float;

    /// The same lanes twice, computed in turns: what waits for a result in one half, the other half can use.
    type Double: Lanes<Scalar = Self::Scalar>;

    /// The same number in all lanes.
    fn splat(v: Self::Scalar) -> Self;

    /// A number for each lane.
    fn from_fn(f: impl FnMut(usize) -> Self::Scalar) -> Self;

    /// The number in lane `i`.
    ///
    /// # Panics
    /// If there is no such lane.
    fn lane(&self, i: usize) -> Self::Scalar;
}
