//! Times of a sampled controller.

use crate::real::{Float, ulps};

/// Fraction of a period within which a delay is a whole number of periods.
const ROUNDING: f64 = 1e-9;
/// Rest of the span, in ulps of its times, in which nothing more happens.
const SLACK_ULPS: f64 = 8.0;

/// Whole periods of a delay, and the rest as a fraction of a period.
pub(super) fn lag(delay: f64, period: f64) -> (usize, f64) {
    let periods = delay / period;
    let whole = libm::rint(periods);
    if (periods - whole).abs() <= ROUNDING * periods.max(1.0) {
        return (whole as usize, 0.0);
    }
    let whole = libm::floor(periods);
    (whole as usize, periods - whole)
}

/// A part of the span during which the inputs hold their values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg<T> {
    pub(super) from: T,
    pub(super) to: T,
    /// Number of the last sample.
    pub(super) sample: usize,
    /// True if that is taken at the start of the leg.
    pub(super) samples: bool,
    /// Number of samples since the one whose command acts.
    pub(super) lag: usize,
}

/// The parts of a span. Times are multiples of the period, without accumulated rounding errors.
#[derive(Clone, Debug)]
pub(super) struct Legs<T> {
    t0: T,
    t1: T,
    period: f64,
    /// Delay in whole periods, and the rest.
    lag: (usize, f64),
    /// Latest time before the end.
    latest: T,
    /// Start of the next leg.
    from: T,
    sample: usize,
    /// True if the next leg starts within a period.
    is_within: bool,
}

impl<T: Float> Legs<T> {
    pub(super) fn new((t0, t1): (T, T), period: f64, delay: f64) -> Self {
        Self {
            t0,
            t1,
            period,
            lag: lag(delay, period),
            latest: t1 - ulps(SLACK_ULPS, t0.abs().max(t1.abs())),
            from: t0,
            sample: 0,
            is_within: false,
        }
    }

    /// Time at which the command of a sample acts.
    #[inline(always)]
    pub(super) fn acts_from(&self, sample: usize) -> T {
        self.t0 + T::from_f64(self.period * ((sample + self.lag.0) as f64 + self.lag.1))
    }

    /// Time of a sample plus a fraction of the period, at most the end.
    #[inline(always)]
    fn time(&self, sample: usize, fraction: f64) -> T {
        // signed integers convert in one instruction
        let t = self.t0 + T::from_f64(self.period * (sample as i64 as f64 + fraction));
        if t < self.latest { t } else { self.t1 }
    }
}

impl<T: Float> Iterator for Legs<T> {
    type Item = Leg<T>;

    #[inline(always)]
    fn next(&mut self) -> Option<Leg<T>> {
        let (from, sample, (whole, rest), samples) = (self.from, self.sample, self.lag, !self.is_within);
        if from == self.t1 {
            return None;
        }
        self.is_within = samples && rest > 0.0;
        let lag = if self.is_within {
            self.from = self.time(sample, rest);
            whole + 1
        } else {
            self.sample += 1;
            self.from = self.time(sample + 1, 0.0);
            whole
        };
        Some(Leg {
            from,
            to: self.from,
            sample,
            samples,
            lag,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Legs, lag};

    #[test]
    fn a_delay_has_whole_periods_and_a_rest() {
        assert_eq!(
            [0.0, 0.003, 0.0071, 0.0069].map(|delay| lag(delay, 1e-3).0),
            [0, 3, 7, 6]
        );
        assert_eq!([0.0, 0.003, 0.3].map(|delay| lag(delay, 1e-3).1), [0.0; 3]);
        assert!((lag(0.0071, 1e-3).1 - 0.1).abs() < 1e-12);
    }

    #[test]
    fn legs_end_at_samples_and_where_commands_act() {
        let legs = |span, period, delay| -> Vec<(f64, f64, usize, bool, usize)> {
            let legs = Legs::new(span, period, delay);
            legs.map(|leg| (leg.from, leg.to, leg.sample, leg.samples, leg.lag))
                .collect()
        };
        assert_eq!(
            legs((1.0, 2.0), 0.5, 0.0),
            [(1.0, 1.5, 0, true, 0), (1.5, 2.0, 1, true, 0)]
        );
        assert_eq!(
            legs((1.0, 1.75), 0.5, 0.625),
            [
                (1.0, 1.125, 0, true, 2),
                (1.125, 1.5, 0, false, 1),
                (1.5, 1.625, 1, true, 2),
                (1.625, 1.75, 1, false, 1)
            ]
        );
        assert_eq!(legs((1.0, 1.0), 0.5, 0.0), []);
    }

    #[test]
    fn no_sample_is_taken_at_the_end_nor_within_its_rounding_errors() {
        let times: Vec<f64> = Legs::new((0.0, 10.0), 1e-3, 0.0).map(|leg| leg.to).collect();
        assert_eq!((times.len(), times.last()), (10_000, Some(&10.0)));
        let times: Vec<f64> = Legs::new((0.3, 0.6), 0.1, 0.0).map(|leg| leg.to).collect();
        assert_eq!((times.len(), times.last()), (3, Some(&0.6)));
    }
}
