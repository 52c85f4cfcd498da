//! Which registers the machine has, and code that runs on any of them.

use std::fmt;

use super::{Lanes, Pack};
use crate::real::Float;

/// Code that runs on lanes of `T`, however many.
pub trait Kernel<T> {
    /// What it returns.
    type Output;

    /// The code. It must be `#[inline(always)]`, and whatever is to be fast in it must be inlined as well: a function
    /// that stands for itself is compiled for all machines, and uses no instruction of a newer one.
    fn run<V: Lanes<Scalar = T>>(self) -> Self::Output;
}

/// An instruction set that this machine has, which a value of the type is the proof of.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Isa(Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Set {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Isa {
    /// The instruction sets of this machine, those with the widest registers first. The last one, of a single lane, is that
    /// of every machine.
    pub fn available() -> impl Iterator<Item = Self> {
        [
            #[cfg(target_arch = "x86_64")]
            is_x86_feature_detected!("avx512f").then_some(Self(Set::Avx512)),
            #[cfg(target_arch = "x86_64")]
            is_x86_feature_detected!("avx2").then_some(Self(Set::Avx2)),
            Some(Self(Set::Portable)),
        ]
        .into_iter()
        .flatten()
    }

    /// The instruction set with the widest registers.
    #[must_use]
    pub fn widest() -> Self {
        Self::available().next().unwrap_or(Self(Set::Portable))
    }

    /// An instruction set for scalar code whose loops compilers turn into vectors: such loops are short, and the widest registers gain nothing.
    pub(crate) fn for_scalars() -> Self {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            return Self(Set::Avx2);
        }
        Self(Set::Portable)
    }

    /// Runs a kernel on lanes of one register each.
    #[inline]
    pub fn run<T: LaneElement, K: Kernel<T>>(self, kernel: K) -> K::Output {
        T::run(self, kernel)
    }
}

/// The name of the instruction set.
impl fmt::Debug for Isa {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A scalar that comes in lanes: `f64` and `f32`.
pub trait LaneElement: Float {
    /// Runs a kernel on lanes of one register each.
    fn run<K: Kernel<Self>>(isa: Isa, kernel: K) -> K::Output;
}

macro_rules! lane {
    ($($scalar:ident: $avx2:ident $avx512:ident;)*) => { $(
        impl LaneElement for $scalar {
            #[inline]
            fn run<K: Kernel<Self>>(isa: Isa, kernel: K) -> K::Output {
                match isa.0 {
                    Set::Portable => kernel.run::<Pack<Self>>(),
                    #[cfg(target_arch = "x86_64")]
                    Set::Avx2 => super::x86::avx2::<K, Pack<super::x86::$avx2>>(kernel),
                    #[cfg(target_arch = "x86_64")]
                    Set::Avx512 => super::x86::avx512::<K, Pack<super::x86::$avx512>>(kernel),
                }
            }
        }
    )* };
}

lane! {
    f64: Ymm64 Zmm64;
    f32: Ymm32 Zmm32;
}
