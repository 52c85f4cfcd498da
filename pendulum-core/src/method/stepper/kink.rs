//! Kinks of a right-hand side: steps end there.

use super::Stepper;
use crate::dense::Step;
use crate::hybrid::Witnesses;
use crate::method::scheme::Scheme;
use crate::method::search::Search;
use crate::real::Float;
use crate::system::System;

/// Maximum number of times that a step is retaken to a kink: convergence is about quadratic.
const MOST_RETAKEN: usize = 6;
/// Distance from a kink at which it is reached, in ulps of t.
const REACHED_ULPS: f64 = 4.0;
/// Distance of the difference quotient of an event function, in fractions of the step.
const SLOPE_OVER: f64 = 1e-3;

impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Retakes the last step up to the first kink in it, if there is one, and returns the step.
    ///
    /// The dense output of a step across a kink is inaccurate, so the time of the kink is found by Newton's method on
    /// the ends of retaken steps.
    pub(in crate::method) fn end_at_kink(&mut self, search: &Search<'_, '_, T, N>, whole: Step<T, N>) -> Step<T, N> {
        let dense = self.dense();
        let Some((event, theta)) = search.first_kink(&dense) else {
            return whole;
        };
        let value = |theta: T| (event.function)(dense.time(theta), &dense.at_fraction(theta));
        let before = (theta - T::from_f64(SLOPE_OVER)).max(T::default());
        let after = (theta + T::from_f64(SLOPE_OVER)).min(T::from_f64(1.0));
        let slope = (value(after) - value(before)) / (dense.time(after) - dense.time(before));
        let mut t = dense.time(theta);
        let (scheme, modes) = (self.smooth.scheme.clone(), self.modes);
        for _ in 0..MOST_RETAKEN {
            if !self.retake(&whole, t) {
                (self.smooth.last, self.smooth.scheme, self.modes) = (whole, scheme, modes);
                return whole;
            }
            let correction = -(event.function)(t, &self.smooth.last.x1) / slope;
            let reached = T::from_f64(REACHED_ULPS) * T::EPSILON * t.abs().max(whole.h.abs());
            let next = t + correction;
            let is_within = (next - whole.t0) * (whole.t1 - next) > T::default();
            if !is_within || correction.abs() <= reached {
                break;
            }
            t = next;
        }
        self.smooth.go_to(self.smooth.last.t1);
        (self.modes.cut, self.modes.fired) = (T::from_f64(1.0), Witnesses::default());
        if self.system.hybrid().is_some() {
            self.dense_and_mode();
        }
        self.smooth.last
    }
}
