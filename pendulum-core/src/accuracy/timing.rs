//! Timing of short tasks on a machine with background load.

use std::time::Instant;

/// Minimum duration of a measurement, in seconds: shorter ones mostly measure the clock.
const LEAST: f64 = 50e-6;
/// Duration below which a task runs once before each measurement, in seconds: other tasks may have emptied the caches.
const SHORT: f64 = 1e-3;

/// A task to time.
pub(super) struct Timer<'a> {
    run: Box<dyn Fn() + 'a>,
    /// True if a run precedes each measurement.
    warms_up: bool,
    /// Number of runs in one measurement.
    repeats: u32,
    /// Measured times, in seconds per run.
    times: Vec<f64>,
}

impl<'a> Timer<'a> {
    /// Runs the task to estimate its duration, at first to warm up caches.
    pub(super) fn new(run: impl Fn() + 'a) -> Self {
        let timed = || {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        };
        let cold = timed();
        let warms_up = cold < SHORT;
        let once = if warms_up { timed() } else { cold };
        Self {
            run: Box::new(run),
            warms_up,
            repeats: (LEAST / once.max(1e-9)).ceil() as u32,
            times: Vec::new(),
        }
    }

    /// Minimum and median time, in seconds per run.
    pub(super) fn minimum_and_median(&mut self) -> (f64, f64) {
        self.times.sort_by(f64::total_cmp);
        (self.times[0], self.times[self.times.len() / 2])
    }

    fn measure(&mut self) {
        if self.warms_up {
            (self.run)();
        }
        let start = Instant::now();
        for _ in 0..self.repeats {
            (self.run)();
        }
        self.times.push(start.elapsed().as_secs_f64() / f64::from(self.repeats));
    }
}

/// Times all tasks in turn, so that transient load affects all of them alike.
pub(super) fn in_turns<'a, 'w: 'a>(works: impl IntoIterator<Item = &'a mut Timer<'w>>, rounds: usize) {
    let mut works: Vec<_> = works.into_iter().collect();
    for _ in 0..rounds {
        for work in &mut works {
            work.measure();
        }
    }
}
