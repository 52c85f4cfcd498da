//! Work on all cores.

use std::iter;
use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Number of cores, which takes reading files to find out.
static CORES: OnceLock<usize> = OnceLock::new();
/// Work that is worth starting a thread, which takes some 0.1 ms, and longer on a busy machine.
const WORTH_A_THREAD: Duration = Duration::from_micros(500);

/// Calls of one kind, on all cores.
#[derive(Debug, Default)]
pub(super) struct Parallel {
    /// Time that one result took last, in ns; 0 before the first.
    of_one: AtomicU64,
}

impl Parallel {
    /// Results of a function of the numbers below `count`, in order, computed on all cores if it takes long enough. The
    /// results do not depend on the number of cores.
    pub(super) fn each<T: Send>(&self, count: usize, function: impl Fn(usize) -> T + Sync) -> Vec<T> {
        let cores = *CORES.get_or_init(|| thread::available_parallelism().map_or(1, usize::from));
        if cores == 1 || count < 2 {
            return (0..count).map(function).collect();
        }
        // threads take one number after the other, since some take longer than others
        let next = AtomicUsize::new(0);
        let take = |most: usize| {
            let begin = Instant::now();
            let numbers = iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed)).take(most);
            let own = numbers.take_while(|&n| n < count).map(|n| (n, function(n)));
            let own: Vec<_> = own.collect();
            if !own.is_empty() {
                let of_one = begin.elapsed().as_nanos() / own.len() as u128;
                self.of_one
                    .store(u64::try_from(of_one).unwrap_or(u64::MAX), Ordering::Relaxed);
            }
            own
        };
        let mut results = match self.of_one.load(Ordering::Relaxed) {
            0 => take(1),
            _ => Vec::new(),
        };
        let left = count - results.len();
        let time = Duration::from_nanos(self.of_one.load(Ordering::Relaxed))
            .saturating_mul(u32::try_from(left).unwrap_or(u32::MAX));
        let worth = time.as_nanos() / WORTH_A_THREAD.as_nanos();
        let threads = cores.min(left).min(usize::try_from(worth).unwrap_or(usize::MAX));
        thread::scope(|scope| {
            let helpers: Vec<_> = (1..threads).map(|_| scope.spawn(|| take(count))).collect();
            results.extend(take(count));
            for helper in helpers {
                results.extend(helper.join().unwrap_or_else(|panic| resume_unwind(panic)));
            }
        });
        results.sort_unstable_by_key(|&(n, _)| n);
        results.into_iter().map(|(_, result)| result).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;
    use std::time::Duration;

    use super::Parallel;

    #[test]
    fn results_are_in_order() {
        for time in [0, 1500] {
            let calls = Parallel::default();
            for count in [0, 1, 2, 3, 7, 20, 3] {
                let squares = calls.each(count, |n| {
                    sleep(Duration::from_micros(time));
                    n * n
                });
                assert!(squares.into_iter().eq((0..count).map(|n| n * n)));
            }
        }
    }
}
