//! Kinks of a right-hand side: steps end there.

use nalgebra::SVector;

use super::Stepper;
use crate::dense::Step;
use crate::method::scheme::Scheme;
use crate::method::search::{Found, Search};
use crate::real::{Float, ulps};
use crate::system::System;

/// Maximum number of times that a step is retaken to a kink: convergence is superlinear.
const MOST_RETAKEN: usize = 10;
/// Distance beyond a kink at which it is reached, in ulps of t.
const REACHED_ULPS: f64 = 8.0;
/// Distance beyond a kink at which the step is aimed, in ulps of t: the event lies within the step.
const BEYOND_ULPS: f64 = 2.0;
/// Half the interval over which the slope of an event function is measured, in fractions of the step.
const SLOPE_OVER: f64 = 1e-3;

impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Searches the last step for events. If a kink comes first, retakes the step up to the kink, and searches again.
    pub(in crate::method) fn look_for_events(
        &mut self,
        search: &mut Search<'_, '_, T, N>,
        step: Step<T, N>,
    ) -> Vec<Found<T>> {
        if !search.has_kinks() {
            return search.look(&self.dense());
        }
        let before = search.mark();
        let dense = self.dense();
        let found = search.look(&dense);
        let Some((event, kink)) = search.first_kink(&found, &dense) else {
            return found;
        };
        let value = |theta: T| (event.function)(dense.time(theta), &dense.at_fraction(theta));
        let near = (kink.theta - T::from_f64(SLOPE_OVER)).max(T::default());
        let far = (kink.theta + T::from_f64(SLOPE_OVER)).min(T::from_f64(1.0));
        let slope = (value(far) - value(near)) / (dense.time(far) - dense.time(near));
        let t = dense.time(kink.theta);
        if !self.retake_to_zero(&step, t, slope, &event.function) {
            return found;
        }
        search.go_back(before);
        search.look(&self.dense())
    }

    /// Retakes a step to a zero of a function near `t`, where it has about this slope, or just beyond the zero. Returns
    /// false if that is not possible; the step is then as it was.
    ///
    /// The dense output of a step across a kink is inaccurate, so the zero is found by the secant method on the ends of
    /// retaken steps, which starts from the slope of the dense output.
    fn retake_to_zero(
        &mut self,
        whole: &Step<T, N>,
        mut t: T,
        mut slope: T,
        function: &impl Fn(T, &SVector<T, N>) -> T,
    ) -> bool {
        let (scheme, modes) = (self.smooth.scheme.clone(), self.modes);
        let ahead = T::from_f64(if whole.h < T::default() { -1.0 } else { 1.0 });
        let mut last: Option<(T, T)> = None;
        for _ in 0..MOST_RETAKEN {
            if !self.retake(whole, t) {
                break;
            }
            let value = function(t, &self.smooth.last.x1);
            if let Some((before, value_before)) = last
                && before != t
                && value_before != value
            {
                slope = (value - value_before) / (t - before);
            }
            last = Some((t, value));
            let correction = -value / slope;
            let scale = whole.scale(t);
            if correction * whole.h <= T::default() && correction.abs() <= ulps(REACHED_ULPS, scale) {
                self.smooth.go_to(t);
                self.end_as_taken();
                return true;
            }
            t += correction + ahead * ulps(BEYOND_ULPS, scale);
            if (t - whole.t0) * (whole.t1 - t) <= T::default() {
                break;
            }
        }
        (self.smooth.last, self.smooth.scheme, self.modes) = (*whole, scheme, modes);
        false
    }
}
