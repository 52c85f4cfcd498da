//! Timing of short tasks on a machine with background load.

use std::time::Instant;

/// Minimum duration of a measurement, in seconds: shorter ones mostly measure the clock.
const LEAST: f64 = 50e-6;

/// A task to time.
pub(super) struct Timer<'a> {
    run: Box<dyn Fn() + 'a>,
    /// Number of runs in one measurement.
    repeats: u32,
    /// Measured times, in seconds per run.
    times: Vec<f64>,
}

impl<'a> Timer<'a> {
    /// Runs the task once, to warm up caches and to estimate its duration.
    pub(super) fn new(run: impl Fn() + 'a) -> Self {
        let start = Instant::now();
        run();
        let once = start.elapsed().as_secs_f64();
        Self {
            run: Box::new(run),
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
