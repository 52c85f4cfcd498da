//! Work on all cores.

use std::iter;
use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::thread;
use std::time::{Duration, Instant};

/// Number of cores, which takes reading files to find out.
static CORES: OnceLock<usize> = OnceLock::new();
/// Work that is worth starting threads, which takes some 0.1 ms each, and longer on a busy machine.
const WORTH_A_THREAD: Duration = Duration::from_millis(2);

/// Results of a function of the numbers below `count`, in order, computed on all cores if it takes long enough. The
/// results do not depend on the number of cores.
pub(super) fn each<T: Send>(count: usize, function: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let cores = *CORES.get_or_init(|| thread::available_parallelism().map_or(1, usize::from));
    if cores == 1 || count < 2 {
        return (0..count).map(function).collect();
    }
    let begin = Instant::now();
    let first = function(0);
    let others = count - 1;
    if begin.elapsed() * u32::try_from(others).unwrap_or(u32::MAX) < WORTH_A_THREAD {
        return iter::once(first).chain((1..count).map(function)).collect();
    }
    let part = others.div_ceil(cores);
    let of_part = |from: usize| (from..count.min(from + part)).map(&function).collect::<Vec<_>>();
    thread::scope(|scope| {
        let of_part = &of_part;
        let parts = (1 + part..count).step_by(part);
        let parts: Vec<_> = parts.map(|from| scope.spawn(move || of_part(from))).collect();
        let mut results = vec![first];
        results.extend(of_part(1));
        for part in parts {
            results.extend(part.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        results
    })
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;
    use std::time::Duration;

    use super::each;

    #[test]
    fn results_are_in_order() {
        for (count, time) in [0, 1, 2, 3, 7, 20]
            .into_iter()
            .flat_map(|count| [(count, 0), (count, 1500)])
        {
            let squares = each(count, |n| {
                sleep(Duration::from_micros(time));
                n * n
            });
            assert!(squares.into_iter().eq((0..count).map(|n| n * n)));
        }
    }
}
