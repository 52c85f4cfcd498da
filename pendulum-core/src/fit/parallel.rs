//! Work on all cores.

use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Results of a function of the numbers below `count`, in order. They do not depend on the number of cores.
pub(super) fn each<T: Send>(count: usize, function: impl Fn(usize) -> T + Send + Sync) -> Vec<T> {
    (0..count).into_par_iter().map(function).collect()
}
