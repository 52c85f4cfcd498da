//! Entry points to code compiled for an instruction set.

use super::super::isa::has;
use super::super::{Kernel, Lanes};

macro_rules! enter {
    ($(#[$doc:meta])* $name:ident, $feature:tt) => {
        $(#[$doc])*
        pub(in super::super) fn $name<K: Kernel<V::Scalar>, V: Lanes>(kernel: K) -> K::Output {
            #[target_feature(enable = $feature)]
            fn inside<K: Kernel<V::Scalar>, V: Lanes>(kernel: K) -> K::Output {
                kernel.run::<V>()
            }
            assert!(has!($feature));
            // SAFETY: the line above checks that the machine has the feature.
            unsafe { inside::<K, V>(kernel) }
        }
    };
}

enter! {
    /// Runs a kernel on lanes `V` with AVX2.
    avx2, "avx2"
}
enter! {
    /// Runs a kernel on lanes `V` with AVX-512.
    avx512, "avx512f"
}
