//! Code on scalars with AVX2.

use std::sync::LazyLock;

use super::super::{Isa, Routine};

/// Proof that the machine has AVX2 and fused operations, and that the environment variable allows it.
pub(in super::super) struct Avx2(());

impl Avx2 {
    #[inline(always)]
    pub(in super::super) fn available() -> Option<Self> {
        static IS_AVAILABLE: LazyLock<bool> = LazyLock::new(Isa::has_avx2);
        IS_AVAILABLE.then_some(Self(()))
    }

    /// Runs a routine with AVX2.
    #[inline(always)]
    pub(in super::super) fn run<A: ?Sized, B: ?Sized, R: Routine<A, B>>(
        self,
        routine: R,
        changed: &mut A,
        read: &B,
    ) -> R::Output {
        #[inline(never)]
        #[target_feature(enable = "avx2,fma")]
        fn inside<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
            routine.run(changed, read)
        }
        // SAFETY: a value of the type exists, so the machine has the features.
        unsafe { inside(routine, changed, read) }
    }
}
