//! Discontinuous right-hand sides without events.

use pendulum_core::method::{Adaptive, Estimates, OneStep};
use pendulum_core::prelude::*;

use crate::methods::{Driven, each_adaptive};

/// `x' = drive(t) - rate x` from 0, with its exact solution.
struct Switched {
    rate: f64,
    /// Drive from 0 on.
    first: f64,
    /// Times at which the drive changes, with its new values.
    then: Vec<(f64, f64)>,
}

impl Switched {
    /// Square wave between 1 and -1 of `frequency` Hz, from a fraction `phase` of the period on, over `periods`
    /// periods.
    fn square(rate: f64, frequency: f64, phase: f64, periods: f64) -> Self {
        let level = |half: usize| if half.is_multiple_of(2) { 1.0 } else { -1.0 };
        let time = |half: usize| (0.5 * half as f64 - phase) / frequency;
        let then = (1..).map(|half| (time(half), level(half)));
        let then = then.take_while(|&(t, _)| t * frequency < periods);
        Self {
            rate,
            first: 1.0,
            then: then.collect(),
        }
    }

    /// A pulse of area 1.
    fn pulse(rate: f64, (from, to): (f64, f64)) -> Self {
        Self {
            rate,
            first: 0.0,
            then: vec![(from, 1.0 / (to - from)), (to, 0.0)],
        }
    }

    fn drive(&self, t: f64) -> f64 {
        match self.then.partition_point(|&(from, _)| from <= t) {
            0 => self.first,
            count => self.then[count - 1].1,
        }
    }

    fn exact(&self, end: f64) -> f64 {
        let (mut x, mut t, mut level) = (0.0, 0.0, self.first);
        for &(to, next) in self.then.iter().filter(|&&(to, _)| to < end).chain([&(end, 0.0)]) {
            let h = to - t;
            x = if self.rate == 0.0 {
                x + level * h
            } else {
                level / self.rate + (x - level / self.rate) * (-self.rate * h).exp()
            };
            (t, level) = (to, next);
        }
        x
    }

    /// Largest error at a hundred times up to `end`, and the number of evaluations.
    fn error<F>(&self, method: Adaptive<F>, end: f64) -> (f64, usize)
    where
        F: for<'a> OneStep<Driven<Drive<'a>, 1>, f64, 1> + Estimates,
    {
        let u: Drive<'_> = Box::new(|t, x| SVector::from([self.drive(t) - self.rate * x[0]]));
        let system = Driven::new(SMatrix::from([[-self.rate]]), u);
        let solution = method.solve(&system, 0.0, end, [0.0]).expect("finite");
        let times = (1..=100).map(|i| 0.01 * f64::from(i) * end);
        let error = |t: f64| (solution.at(t).expect("within")[0] - self.exact(t)).abs();
        (times.map(error).fold(0.0, f64::max), solution.statistics().evaluations)
    }
}

type Drive<'a> = Box<dyn Fn(f64, &SVector<f64, 1>) -> SVector<f64, 1> + 'a>;

/// Error bound: the default tolerance of 1e-6 for a state below 1, times 100 for the error estimate at a discontinuity.
const NEAR: f64 = 1e-4;

#[test]
fn square_waves_are_followed_at_the_default_tolerance() {
    fn check<F>(name: &str, rate: f64, frequency: f64)
    where
        F: for<'a> OneStep<Driven<Drive<'a>, 1>, f64, 1> + Estimates + Default,
    {
        for phase in [0.0, 0.1, 0.3] {
            let periods = frequency.min(8.0);
            let wave = Switched::square(rate, frequency, phase, periods);
            // The power series treats the drive as constant, so the first step must not skip the wave.
            let method = Adaptive::<F>::new();
            let method = if name == "Taylor" {
                method.h0(0.1 / frequency)
            } else {
                method
            };
            let (error, evaluations) = wave.error(method, periods / frequency);
            assert!(
                error < NEAR,
                "{name} {rate} {frequency} {phase}: {error:e}, {evaluations}"
            );
        }
    }
    for rate in [0.0, 1.0] {
        for frequency in [1.0, 7.0, 100.0, 1000.0] {
            each_adaptive!(check(rate, frequency));
        }
    }
}

#[test]
fn square_waves_drive_stiff_systems() {
    fn check<F>(name: &str)
    where
        F: for<'a> OneStep<Driven<Drive<'a>, 1>, f64, 1> + Estimates + Default,
    {
        for frequency in [7.0, 100.0] {
            let wave = Switched::square(1e4, frequency, 0.1, 4.0);
            let method = Adaptive::<F>::new();
            let method = if name == "Taylor" {
                method.h0(0.1 / frequency)
            } else {
                method
            };
            let (error, evaluations) = wave.error(method, 4.0 / frequency);
            // The state goes to 1e-4 and back.
            assert!(error < 1e-2 * NEAR, "{name} {frequency}: {error:e}, {evaluations}");
        }
    }
    each_adaptive!(check());
}

#[test]
fn pulses_are_seen_by_steps_that_are_no_longer() {
    fn check<F>(name: &str)
    where
        F: for<'a> OneStep<Driven<Drive<'a>, 1>, f64, 1> + Estimates + Default,
    {
        for (from, to) in [(0.123, 0.133), (0.3141, 0.3161), (0.777, 0.778)] {
            let pulse = Switched::pulse(1.0, (from, to));
            let (error, evaluations) = pulse.error(Adaptive::<F>::new().h_max(0.98 * (to - from)), 1.0);
            assert!(error < 10.0 * NEAR, "{name} {from}: {error:e}, {evaluations}");
        }
        // A short pulse between the evaluations of a method goes undetected.
        let (error, _) = Switched::pulse(1.0, (0.777, 0.778)).error(Adaptive::<F>::new(), 1.0);
        assert!(error > 0.5, "{name}: {error:e}");
    }
    each_adaptive!(check());
}
