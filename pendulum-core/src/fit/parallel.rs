//! Work on all cores.

use std::panic::resume_unwind;
use std::thread;

/// Results of a function of the numbers from 0 to `count`, in order, computed on all cores.
pub(super) fn each<T: Send>(count: usize, function: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let part = count.div_ceil(cores).max(1);
    let of_part = |first: usize| (first..count.min(first + part)).map(&function).collect::<Vec<_>>();
    thread::scope(|scope| {
        let of_part = &of_part;
        let others = (part..count).step_by(part);
        let others: Vec<_> = others.map(|first| scope.spawn(move || of_part(first))).collect();
        let mut results = of_part(0);
        for other in others {
            results.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        results
    })
}

#[cfg(test)]
mod tests {
    use super::each;

    #[test]
    fn results_are_in_order() {
        for count in [0, 1, 2, 3, 7, 100] {
            assert!(each(count, |n| n * n).into_iter().eq((0..count).map(|n| n * n)));
        }
    }
}
