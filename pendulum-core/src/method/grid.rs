//! Grid of times for steps of equal length.

use crate::error::Reason;
use crate::method::input::require;
use crate::real::{Float, ulps};

/// Times `t0 + i h` from `t0` towards `t1`; the last one is exactly `t1`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid<T> {
    t0: T,
    t1: T,
    /// Step, positive in both directions of time.
    h: T,
    /// Index of the last time reached.
    reached: usize,
}

/// Minimum step, in ulps of the time: a shorter one would be mostly rounding error.
const LEAST_ULPS: f64 = 16.0;
/// Rest of the span, in ulps of its times, below which it is added to the last step.
const SLACK_ULPS: f64 = 8.0;
/// Maximum number of points of a solution: for a pendulum they take 800 MB.
#[cfg(feature = "std")]
const MOST_KEPT: f64 = 1e7;

impl<T: Float> Grid<T> {
    /// Creates the grid over a span of finite times.
    pub(crate) fn new(h: f64, t0: T, t1: T) -> Result<Self, Reason> {
        require(h.is_finite() && h > 0.0, "h", h, "the step must be positive and finite")?;
        let grid = Self {
            t0,
            t1,
            h: T::from_f64(h),
            reached: 0,
        };
        grid.check()?;
        Ok(grid)
    }

    /// Creates the grid of a single step between different times, which may be shorter than other steps.
    pub(crate) fn of_one_step(t0: T, t1: T) -> Self {
        Self {
            t0,
            t1,
            h: (t1 - t0).abs(),
            reached: 0,
        }
    }

    /// Checks that the times resolve the step.
    #[inline]
    fn check(&self) -> Result<(), Reason> {
        require(
            self.h >= ulps(LEAST_ULPS, self.largest()),
            "h",
            self.h.to_f64(),
            "the step is below the resolution of the time; lengthen it, or count time from a closer origin",
        )
    }

    /// Advances by one step, and returns the time there.
    #[inline]
    pub(crate) fn next(&mut self) -> T {
        self.reached += 1;
        self.time(self.reached)
    }

    /// Starts anew at the time `t`, towards another end.
    #[inline]
    pub(crate) fn go_on_to(&mut self, t: T, t1: T) -> Result<(), Reason> {
        (self.t0, self.t1, self.reached) = (t, t1, 0);
        self.check()
    }

    /// Moves to the time `t` within the span: the next time lies after it.
    pub(crate) fn go_to(&mut self, t: T) {
        self.reached = ((t - self.t0).abs() / self.h).to_f64() as usize;
        // rounding errors may put the quotient on either side, and no step should end at a time almost reached
        let next = self.time(self.reached + 1);
        let near = ulps(LEAST_ULPS, self.largest());
        if next != self.t1 && (next - t).abs() <= near {
            self.reached += 1;
        }
    }

    pub(crate) fn h(&self) -> T {
        self.h
    }

    fn direction(&self) -> T {
        T::from_f64(if self.t1 < self.t0 { -1.0 } else { 1.0 })
    }

    /// Time `i`; the end beyond the last one.
    #[inline]
    fn time(&self, i: usize) -> T {
        let direction = self.direction();
        // multiples of h from the start on: repeated additions of h would accumulate their rounding errors
        let time = self.t0 + direction * (self.h * T::from_f64(i as f64));
        let slack = ulps(SLACK_ULPS, self.largest());
        let is_last = (self.t1 - time) * direction <= slack;
        if is_last { self.t1 } else { time }
    }

    fn largest(&self) -> T {
        let [start, end] = [self.t0, self.t1].map(T::abs);
        // unlike `max`, without a case for NaN
        if start < end { end } else { start }
    }
}

/// Limits for solutions, which store the times.
#[cfg(feature = "std")]
impl<T: Float> Grid<T> {
    /// Checks that the number of times fits into a solution.
    pub(crate) fn check_to_keep(&self) -> Result<(), Reason> {
        let steps = ((self.t1 - self.t0).abs() / self.h).to_f64();
        require(
            steps <= MOST_KEPT,
            "h",
            self.h.to_f64(),
            "more than ten million points to store; lengthen the step, or use `stepper`, which stores none",
        )
    }

    pub(crate) fn t0(&self) -> T {
        self.t0
    }

    pub(crate) fn t1(&self) -> T {
        self.t1
    }
}
