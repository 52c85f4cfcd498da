//! States of trajectories at given times.

use nalgebra::SVector;
use pendulum_core::dense::Dense;

use crate::error::Error;

/// Checks that times are finite and ascend, or descend if the integration is backward, within the span.
pub(crate) fn check_times(times: &[f64], [t0, t1]: [f64; 2]) -> Result<(), Error> {
    let direction = if t1 < t0 { -1.0 } else { 1.0 };
    let wrong = |rule: &str| Err(Error::setting("times", rule));
    if times.iter().any(|t| !t.is_finite()) {
        return wrong("they must be finite");
    }
    if times.windows(2).any(|pair| (pair[1] - pair[0]) * direction < 0.0) {
        return wrong("they must be sorted in the direction of the integration");
    }
    let outside = |t: &f64| (t - t0) * direction < 0.0 || (t - t1) * direction > 0.0;
    if times.iter().any(outside) {
        return wrong("they must lie within the span of the integration");
    }
    Ok(())
}

/// Samples of a trajectory at given times.
pub(crate) struct Sampler<'t> {
    pub(crate) times: &'t [f64],
    forward: bool,
    pub(crate) taken: usize,
    length: usize,
    pub(crate) x: Vec<f64>,
}

impl<'t> Sampler<'t> {
    pub(crate) fn new(times: &'t [f64], [t0, t1]: [f64; 2], length: usize) -> Self {
        Self {
            times,
            forward: t1 >= t0,
            taken: 0,
            length,
            x: Vec::with_capacity(times.len() * length),
        }
    }

    /// Takes the samples at the start.
    pub(crate) fn start<const N: usize>(&mut self, t0: f64, x0: &SVector<f64, N>) {
        while self.next().is_some_and(|t| t == t0) {
            self.take(x0);
        }
    }

    fn next(&self) -> Option<f64> {
        self.times.get(self.taken).copied()
    }

    fn take<const N: usize>(&mut self, x: &SVector<f64, N>) {
        self.x.extend_from_slice(&x.as_slice()[..self.length]);
        self.taken += 1;
    }

    /// True if there are samples in a step to this time.
    pub(crate) fn has_any_until(&self, t1: f64) -> bool {
        self.next()
            .is_some_and(|t| if self.forward { t <= t1 } else { t >= t1 })
    }

    pub(crate) fn step<const N: usize>(&mut self, dense: &Dense<'_, f64, N>) {
        let step = dense.step();
        while self.has_any_until(step.t1) {
            let Some(t) = self.next() else { return };
            let x = if t == step.t1 { step.x1 } else { dense.at(t) };
            self.take(&x);
        }
    }
}
