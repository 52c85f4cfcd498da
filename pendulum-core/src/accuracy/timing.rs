//! Times of short pieces of work on a machine that does other things as well.

use std::time::Instant;

/// A measurement shorter than this, in seconds, is mostly the clock's.
const LEAST: f64 = 50e-6;

/// Something to time.
pub(super) struct Timer<'a> {
    run: Box<dyn Fn() + 'a>,
    /// How often it is run in one measurement.
    repeats: u32,
    /// In seconds, for one run.
    times: Vec<f64>,
}

impl<'a> Timer<'a> {
    /// Runs it once, so that all is warm, and to see how long it takes.
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

    /// The minimum and the median.
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

/// Times all in turns, so that what disturbs the machine for a while hits all alike.
pub(super) fn in_turns<'a, 'w: 'a>(works: impl IntoIterator<Item = &'a mut Timer<'w>>, rounds: usize) {
    let mut works: Vec<_> = works.into_iter().collect();
    for _ in 0..rounds {
        for work in &mut works {
            work.measure();
        }
    }
}
