//! Ratios of times that are measured in turn, which are more reliable on a noisy machine than the times themselves.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Median over `pairs` of the ratio of the times of two functions, each called `batch` times between two readings of
/// the clock.
pub(crate) fn ratio<A, B>(pairs: usize, batch: usize, first: impl Fn() -> A, second: impl Fn() -> B) -> f64 {
    let mut ratios: Vec<f64> = (0..pairs)
        .map(|_| time(batch, &first).as_secs_f64() / time(batch, &second).as_secs_f64())
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios[pairs / 2]
}

fn time<A>(batch: usize, function: impl Fn() -> A) -> Duration {
    let start = Instant::now();
    for _ in 0..batch {
        black_box(function());
    }
    start.elapsed()
}
