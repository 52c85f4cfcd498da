//! Entry points to code compiled for an instruction set.

use super::super::isa::has;
use super::super::{Kernel, Lanes};

macro_rules! enter {
    ($(#[$doc:meta])* $name:ident, $features:tt, $($feature:tt)+) => {
        $(#[$doc])*
        pub(in super::super) fn $name<K: Kernel<V::Scalar>, V: Lanes>(kernel: K) -> K::Output {
            #[target_feature(enable = $features)]
            fn inside<K: Kernel<V::Scalar>, V: Lanes>(kernel: K) -> K::Output {
                kernel.run::<V>()
            }
            assert!(has!($($feature)+));
            // SAFETY: the line above checks that the machine has the features.
            unsafe { inside::<K, V>(kernel) }
        }
    };
}

enter! {
    /// Runs a kernel on lanes `V` with AVX2 and fused operations.
    avx2, "avx2,fma", "avx2" "fma"
}
enter! {
    /// Runs a kernel on lanes `V` with AVX-512.
    avx512, "avx512f", "avx512f"
}
