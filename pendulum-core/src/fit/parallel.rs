//! Work on all cores.

/// Runs tasks beside the caller, which returns when all have ended. If each writes to a place of its own, the results
/// do not depend on the number of cores.
pub(super) use rayon::in_place_scope as scope;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Results of a function of the numbers below `count`, in order. They do not depend on the number of cores.
pub(super) fn each<T: Send>(count: usize, function: impl Fn(usize) -> T + Send + Sync) -> Vec<T> {
    (0..count).into_par_iter().map(function).collect()
}
