//! Times of several functions taken in turns, so that whatever disturbs the machine meets all of them.

use std::time::{Duration, Instant};

/// Rounds below which a median says little, and above which it does not get better.
const ROUNDS: [usize; 2] = [31, 4001];

/// The times of one function, in nanoseconds per evaluation, round by round.
pub(crate) struct Times(Vec<f64>);

/// Passes of a function before its time is taken, so that caches and branch prediction are its own, and passes that are timed.
const PASSES: [usize; 2] = [3, 4];

/// Runs the functions in rounds for about as long as `budget`; one pass of a function is that many evaluations.
pub(crate) fn in_turns(functions: &[&dyn Fn()], evaluations: usize, budget: Duration) -> Vec<Times> {
    let start = Instant::now();
    functions.iter().for_each(|function| {
        time(function);
    });
    let rounds = (budget.as_secs_f64() / start.elapsed().as_secs_f64()) as usize;
    let rounds = rounds.clamp(ROUNDS[0], ROUNDS[1]);
    let mut times: Vec<Times> = functions.iter().map(|_| Times(Vec::with_capacity(rounds))).collect();
    for round in 0..rounds {
        // Each comes first in some round, and after each other one equally often is not worth the trouble.
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

    /// The median over the rounds of this time less the other one of the same round.
    pub(crate) fn minus(&self, other: &Self) -> f64 {
        median(self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect())
    }

    /// The median over the rounds of this time divided by the other one of the same round.
    pub(crate) fn over(&self, other: &Self) -> f64 {
        median(self.0.iter().zip(&other.0).map(|(a, b)| a / b).collect())
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
