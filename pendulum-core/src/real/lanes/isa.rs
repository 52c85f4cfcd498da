//! Instruction sets: detection, and dispatch of code to their registers.

use core::fmt;
use core::marker::PhantomData;

use super::target::{Least32, Least64};
use super::{Lanes, Pack};
use crate::dual::Dual;
use crate::real::{Float, Fused};

/// True if the machine has all of these features. Without `std`, the target features of the compilation decide.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
macro_rules! has {
    ($($feature:tt)+) => {{
        #[cfg(feature = "std")]
        let has = $(is_x86_feature_detected!($feature))&&+;
        #[cfg(not(feature = "std"))]
        let has = cfg!(all($(target_feature = $feature),+));
        has
    }};
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(super) use has;

/// Code of builds that check for AVX2 when they run: optimised ones, for a target without it.
macro_rules! where_checked {
    ($($code:tt)*) => {
        #[cfg(all(
            target_arch = "x86_64",
            target_feature = "sse2",
            feature = "std",
            not(debug_assertions),
            not(all(target_feature = "avx2", target_feature = "fma"))
        ))]
        $($code)*
    };
}

/// Code that runs on any number of lanes of `T`.
pub trait Kernel<T> {
    /// Result type.
    type Output;

    /// Runs the code. It must be `#[inline(always)]`, as must all time-critical functions it calls: a function that is
    /// not inlined is compiled for the baseline target, without newer instructions.
    fn run<V: Lanes<Scalar = T>>(self) -> Self::Output;
}

/// Code that runs on lanes of `T` of two widths: the narrow ones are for what the others leave.
///
/// The trait is public because it bounds a public method.
pub trait WideKernel<T> {
    /// Runs the code, as in a [`Kernel`].
    fn run<V, Narrow>(self)
    where
        T: Lanes<Scalar = T>,
        V: Lanes<Scalar = T>,
        Narrow: Lanes<Scalar = T>;
}

/// A kernel with its narrow lanes.
pub(in crate::real) struct InLanes<K, Narrow> {
    kernel: K,
    narrow: PhantomData<Narrow>,
}

impl<K, Narrow> InLanes<K, Narrow> {
    #[inline(always)]
    pub(in crate::real) fn new(kernel: K) -> Self {
        Self {
            kernel,
            narrow: PhantomData,
        }
    }
}

impl<T, K, Narrow> Kernel<T> for InLanes<K, Narrow>
where
    T: Lanes<Scalar = T>,
    K: WideKernel<T>,
    Narrow: Lanes<Scalar = T>,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        self.kernel.run::<V, Narrow>();
    }
}

/// Code that is compiled apart from its callers: see [`Real::call`](crate::Real::call).
///
/// The trait is public because it bounds a public method.
///
/// Separate arguments for the data that it changes and the data that it only reads tell the compiler that these do not
/// overlap.
pub trait Routine<A: ?Sized, B: ?Sized> {
    /// Result type.
    type Output;

    /// Runs the code. It must be `#[inline(always)]`, as in a [`Kernel`].
    fn run(self, changed: &mut A, read: &B) -> Self::Output;
}

/// The second of the results of a routine.
pub struct Second<R>(pub R);

impl<A: ?Sized, B: ?Sized, First, Output, R: Routine<A, B, Output = (First, Output)>> Routine<A, B> for Second<R> {
    type Output = Output;

    #[inline(always)]
    fn run(self, changed: &mut A, read: &B) -> Output {
        self.0.run(changed, read).1
    }
}

/// An instruction set. A value of this type proves that the machine supports it.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Isa(Set);

/// Variants in ascending order of register width.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Set {
    Portable,
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    /// AVX2 and fused operations: every x86-64 machine of note has both or neither.
    Avx2,
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    Avx512,
}

impl Isa {
    /// Instruction sets of this machine, widest registers first. The last one exists on every machine and has a single
    /// lane, on 64-bit ARM two of `f64` or four of `f32`, in WebAssembly with `simd128` two of `f64`. Without the
    /// feature `std`, only sets enabled at compile time are listed.
    ///
    /// Results are bit-identical on each. To try a narrower set, set the environment variable `PENDULUM_ISA` to `Avx2`
    /// or `Portable` before the program starts: wider sets are then unavailable.
    pub fn available() -> impl Iterator<Item = Self> {
        Self::of_machine().filter(|isa| isa.is_allowed())
    }

    /// True if the set is not wider than the environment variable allows.
    #[cfg(feature = "std")]
    fn is_allowed(self) -> bool {
        use std::sync::LazyLock;

        static WIDEST: LazyLock<Option<Isa>> = LazyLock::new(|| {
            let name = std::env::var("PENDULUM_ISA").ok()?;
            Isa::of_machine().find(|isa| format!("{isa:?}").eq_ignore_ascii_case(&name))
        });
        WIDEST.is_none_or(|widest| self.0 as u8 <= widest.0 as u8)
    }

    #[cfg(not(feature = "std"))]
    fn is_allowed(self) -> bool {
        true
    }

    fn of_machine() -> impl Iterator<Item = Self> {
        [
            #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
            has!("avx512f").then_some(Self(Set::Avx512)),
            #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
            has!("avx2" "fma").then_some(Self(Set::Avx2)),
            Some(Self(Set::Portable)),
        ]
        .into_iter()
        .flatten()
    }

    /// Instruction set with the widest registers.
    #[must_use]
    pub fn widest() -> Self {
        Self::available().next().unwrap_or(Self(Set::Portable))
    }

    where_checked! {
        /// True if AVX2 and fused operations are available.
        pub(super) fn has_avx2() -> bool {
            Self::available().any(|isa| isa.0 == Set::Avx2)
        }
    }

    /// Runs a routine with AVX2 if the machine has it: the same operations, in instructions with a separate
    /// destination, which save copies between registers. Code with debug assertions, or for a target with AVX2, has
    /// one version only.
    #[inline(always)]
    pub(crate) fn run_routine<A: ?Sized, B: ?Sized, R: Routine<A, B>>(
        routine: R,
        changed: &mut A,
        read: &B,
    ) -> R::Output {
        #[inline(never)]
        fn baseline<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
            routine.run(changed, read)
        }
        where_checked! {
            if let Some(avx2) = super::x86::Avx2::available() {
                return avx2.run(routine, changed, read);
            }
        }
        baseline(routine, changed, read)
    }

    /// Runs a kernel in a function of its own: with AVX2 on lanes `In` where [routines](Self::run_routine) run with it,
    /// else on lanes `Out`.
    #[inline(always)]
    pub(crate) fn run_wide<In: Lanes, Out: Lanes<Scalar = In::Scalar>, K: Kernel<In::Scalar>>(kernel: K) -> K::Output {
        #[inline(never)]
        fn baseline<V: Lanes, K: Kernel<V::Scalar>>(kernel: K) -> K::Output {
            kernel.run::<V>()
        }
        where_checked! {
            if super::x86::Avx2::available().is_some() {
                return super::x86::avx2::<K, In>(kernel);
            }
        }
        baseline::<Out, K>(kernel)
    }

    /// Runs a kernel whose lanes fill one register.
    #[inline]
    pub fn run<T: LaneElement, K: Kernel<T>>(self, kernel: K) -> K::Output {
        T::run(self, kernel)
    }
}

/// Name of the instruction set.
impl fmt::Debug for Isa {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A scalar type of lanes: `f64`, `f32`, [fused](Fused) `f64`, or [dual numbers](Dual) of these.
pub trait LaneElement: Float {
    /// Runs a kernel whose lanes fill one register.
    fn run<K: Kernel<Self>>(isa: Isa, kernel: K) -> K::Output;
}

macro_rules! lane {
    ($($scalar:ident: $portable:ident $avx2:ident $avx512:ident;)*) => { $(
        lane!([] $scalar: Pack<$portable>, Pack<super::x86::$avx2>, Pack<super::x86::$avx512>);
        lane!(
            [const N: usize] Dual<$scalar, N>:
            Dual<Pack<$portable>, N>, Dual<Pack<super::x86::$avx2>, N>, Dual<Pack<super::x86::$avx512>, N>
        );
    )* };
    ([$($length:tt)*] $scalar:ty: $portable:ty, $avx2:ty, $avx512:ty) => {
        impl<$($length)*> LaneElement for $scalar {
            #[inline]
            fn run<K: Kernel<Self>>(isa: Isa, kernel: K) -> K::Output {
                match isa.0 {
                    Set::Portable => kernel.run::<$portable>(),
                    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
                    Set::Avx2 => super::x86::avx2::<K, $avx2>(kernel),
                    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
                    Set::Avx512 => super::x86::avx512::<K, $avx512>(kernel),
                }
            }
        }
    };
}

lane! {
    f64: Least64 Ymm64 Zmm64;
    f32: Least32 Ymm32 Zmm32;
}
lane!([] Fused<f64>: Pack<Fused<Least64>>, Pack<Fused<super::x86::Ymm64>>, Pack<Fused<super::x86::Zmm64>>);
lane!(
    [const N: usize] Dual<Fused<f64>, N>:
    Dual<Pack<Fused<Least64>>, N>, Dual<Pack<Fused<super::x86::Ymm64>>, N>, Dual<Pack<Fused<super::x86::Zmm64>>, N>
);
