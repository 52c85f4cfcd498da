//! Steps of equal length.

use crate::error::Reason;
use crate::method::input::require;
use crate::real::Float;

/// Times `t0 + i h` on the way from `t0` to `t1`, of which the last is `t1` exactly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid<T> {
    t0: T,
    t1: T,
    /// Positive, whatever the direction of time.
    h: T,
}

/// The least step in ulps of the time: a shorter one would be mostly rounding error.
const LEAST_ULPS: f64 = 16.0;
/// What remains of a span shorter than this many ulps of its times is added to the last step.
const SLACK_ULPS: f64 = 8.0;

impl<T: Float> Grid<T> {
    /// The grid over a span of finite times.
    pub(crate) fn new(h: f64, t0: T, t1: T) -> Result<Self, Reason> {
        require(h.is_finite() && h > 0.0, "h", h, "the step must be positive and finite")?;
        let grid = Self {
            t0,
            t1,
            h: T::from_f64(h),
        };
        require(
            grid.h >= T::from_f64(LEAST_ULPS) * T::EPSILON * grid.largest(),
            "h",
            h,
            "the step is too short for the times to resolve; count time from a nearer origin or lengthen it",
        )?;
        Ok(grid)
    }

    pub(crate) fn t0(&self) -> T {
        self.t0
    }

    pub(crate) fn t1(&self) -> T {
        self.t1
    }

    /// The time at which step `i` ends, counted from 1.
    #[inline]
    pub(crate) fn end_of(&self, i: usize) -> T {
        let direction = T::from_f64(if self.t1 < self.t0 { -1.0 } else { 1.0 });
        // Multiples of h from the start on: adding h again and again would gather its rounding errors.
        let time = self.t0 + direction * (self.h * T::from_f64(i as f64));
        let slack = T::from_f64(SLACK_ULPS) * T::EPSILON * self.largest();
        let is_last = (self.t1 - time) * direction <= slack;
        if is_last { self.t1 } else { time }
    }

    fn largest(&self) -> T {
        self.t0.abs().max(self.t1.abs())
    }
}
