//! Times of several functions measured in turn, so that disturbances of the machine affect all of them.

use std::time::{Duration, Instant};

use serde::{Serialize, Serializer};

/// Number of rounds, clamped to this range: a median of fewer is unreliable, and more do not improve it.
const ROUNDS: [usize; 2] = [31, 4001];

/// Times of one function, in nanoseconds per evaluation, one per round.
pub(crate) struct Times(Vec<f64>);

/// Number of untimed passes, which warm up caches and branch prediction, and number of timed passes.
const PASSES: [usize; 2] = [3, 4];

/// Runs the functions in rounds for about the time `budget`; one pass of a function makes `evaluations` evaluations.
pub(crate) fn in_turns(functions: &[&dyn Fn()], evaluations: usize, budget: Duration) -> Vec<Times> {
    let start = Instant::now();
    functions.iter().for_each(|function| {
        time(function);
    });
    let rounds = (budget.as_secs_f64() / start.elapsed().as_secs_f64()) as usize;
    let rounds = rounds.clamp(ROUNDS[0], ROUNDS[1]);
    let mut times: Vec<Times> = functions.iter().map(|_| Times(Vec::with_capacity(rounds))).collect();
    for round in 0..rounds {
        // Each function comes first in some round; balancing all orders would not be worth the effort.
        for n in 0..functions.len() {
            let which = (n + round) % functions.len();
            let nanoseconds = 1e9 * time(functions[which]).as_secs_f64();
            times[which].0.push(nanoseconds / (PASSES[1] * evaluations) as f64);
        }
    }
    times
}

fn time(function: &dyn Fn()) -> Duration {
    (0..PASSES[0]).for_each(|_| function());
    let start = Instant::now();
    (0..PASSES[1]).for_each(|_| function());
    start.elapsed()
}

impl Times {
    pub(crate) fn least(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    pub(crate) fn median(&self) -> f64 {
        median(self.0.clone())
    }

    /// Median over the rounds of the difference of this time and the other one.
    pub(crate) fn minus(&self, other: &Self) -> f64 {
        median(self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect())
    }

    /// Median over the rounds of the ratio of this time to the other one.
    pub(crate) fn over(&self, other: &Self) -> f64 {
        median(self.0.iter().zip(&other.0).map(|(a, b)| a / b).collect())
    }

    /// Ratio of the least time to the other one.
    pub(crate) fn over_in_least(&self, other: &Self) -> f64 {
        self.least() / other.least()
    }
}

impl From<Vec<f64>> for Times {
    fn from(times: Vec<f64>) -> Self {
        Self(times)
    }
}

/// To a thousandth of a nanosecond, which is finer than the clock.
impl Serialize for Times {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(|time| (1e3 * time).round() / 1e3))
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
