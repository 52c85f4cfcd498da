//! Reproducible random numbers.

use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Generator of uniform random numbers (SplitMix64, Steele et al. 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns a number between `low` and `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// Returns a normal number of mean 0 and standard deviation 1 (Box and Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let [radius, angle] = [
            self.between(f64::MIN_POSITIVE, 1.0),
            self.between(0.0, std::f64::consts::TAU),
        ];
        (-2.0 * radius.ln()).sqrt() * angle.cos()
    }

    /// Returns an integer below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    /// Returns a random element of a list.
    pub fn of<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

/// Returns `cases` if the environment variable `PENDULUM_THOROUGH` is set, and otherwise a fourth of it, at least one.
#[must_use]
pub fn share(cases: usize) -> usize {
    if std::env::var_os("PENDULUM_THOROUGH").is_some() {
        cases
    } else {
        cases.div_ceil(4)
    }
}

/// Reads a number from an environment variable.
#[must_use]
pub fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |text| text.parse().expect("a number"))
}

/// Stack size of each thread, in bytes: the same as in the compiler, as the generator runs there.
const STACK: usize = 8 << 20;

/// Calls `tried` for all seeds on all cores, and `take` with each outcome.
pub fn each_seed<T>(seeds: Range<u64>, tried: impl Fn(u64) -> T + Sync, take: impl FnMut(u64, T) + Send) {
    let (next, take) = (AtomicU64::new(seeds.start), Mutex::new(take));
    let work = || {
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= seeds.end {
                break;
            }
            let outcome = tried(seed);
            take.lock().expect("no other has failed")(seed, outcome);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            let thread = std::thread::Builder::new().stack_size(STACK);
            thread.spawn_scoped(scope, work).expect("a thread");
        }
    });
}
