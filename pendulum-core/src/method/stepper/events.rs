//! Events at which a method begins anew, such as resets and kinks of the right-hand side: steps end there.

use nalgebra::SVector;

use super::Stepper;
use crate::dense::Step;
use crate::method::scheme::Scheme;
use crate::method::search::{Found, Search};
use crate::real::{Float, ulps};
use crate::system::System;

/// Maximum number of times that a step is retaken to an event: convergence is superlinear.
const MOST_RETAKEN: usize = 10;
/// Distances beyond an event, in fractions of the step, or in ulps of t if that is more: at which it is reached, and at
/// which the step is aimed, so that the event lies within it. So near its end, dense output is as accurate as the end.
const NEAR: [(f64, f64); 2] = [(1e-8, 8.0), (1e-9, 2.0)];
/// Distances at kinks, beyond which no stage should be evaluated: there the right-hand side is another.
const NEAR_KINKS: [(f64, f64); 2] = [(0.0, 8.0), (0.0, 2.0)];
/// Interval over which the slope of an event function is measured, in fractions of the step up to the event.
const SLOPE_OVER: f64 = 1e-3;

impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Searches the last step for events. If the method begins anew at the first one that acts, retakes the step up to
    /// it, and searches again: the shorter step may show that another event comes first. Also returns true if the step
    /// was retaken.
    pub(in crate::method) fn look_for_events(
        &mut self,
        search: &mut Search<'_, '_, T, N>,
        mut step: Step<T, N>,
    ) -> (Vec<Found<T>>, bool) {
        if C::DENSE_IS_EXACT || !search.ends_steps() {
            return (search.look(&self.dense()), false);
        }
        search.mark();
        let mut found = search.look(&self.dense());
        let mut is_retaken = false;
        for _ in 0..MOST_RETAKEN {
            let dense = self.known_dense();
            let Some((event, first)) = search.first_end(&found, &dense) else {
                break;
            };
            let t = dense.time(first.theta);
            let near = if event.restarts() { NEAR_KINKS } else { NEAR };
            if (step.t1 - t).abs() <= distance(near[0], &step, t) {
                break;
            }
            let value = |theta: T| (event.function)(dense.time(theta), &dense.at_fraction(theta));
            let before = first.theta * T::from_f64(1.0 - SLOPE_OVER);
            let here = value(first.theta);
            let slope = (here - value(before)) / (t - dense.time(before));
            // a function that jumps, or has no slope, has no zero to go to
            let passes = here.abs() < slope.abs() * distance(NEAR[0], &step, t) && slope.is_finite();
            if !passes || !self.retake_to_zero(&step, (t, slope), near, &event.function) {
                break;
            }
            (step, is_retaken) = (self.smooth.last, true);
            search.go_back();
            found = search.look(&self.dense().retaken(true));
        }
        (found, is_retaken)
    }

    /// Retakes a step to a zero of a function near `t`, where it has about this slope, or just beyond the zero. Returns
    /// false if that is not possible; the step is then as it was.
    ///
    /// Ends of steps are more accurate than dense output, by far if the step crosses a kink. So the secant method finds
    /// the zero on the ends of retaken steps, from the slope of the dense output on. The times of these ends have the
    /// derivatives of the zero.
    fn retake_to_zero(
        &mut self,
        whole: &Step<T, N>,
        (mut t, mut slope): (T, T),
        [reached, beyond]: [(f64, f64); 2],
        function: &impl Fn(T, &SVector<T, N>) -> T,
    ) -> bool {
        let (scheme, modes) = (self.smooth.scheme.clone(), self.modes);
        let ahead = T::from_f64(if whole.h < T::default() { -1.0 } else { 1.0 });
        let mut last: Option<(T, T)> = None;
        t += ahead * distance(beyond, whole, t);
        for _ in 0..MOST_RETAKEN {
            let is_within = (t - whole.t0) * (whole.t1 - t) > T::default();
            if !(is_within && t.is_finite() && self.retake(whole, t)) {
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
            if correction * whole.h <= T::default() && correction.abs() <= distance(reached, whole, t) {
                self.smooth.go_to(t);
                self.end_as_taken();
                return true;
            }
            t += correction + ahead * distance(beyond, whole, t);
        }
        (self.smooth.last, self.smooth.scheme, self.modes) = (*whole, scheme, modes);
        false
    }
}

/// A distance in fractions of a step up to the time `t`, but at least a number of ulps of the time.
fn distance<T: Float, const N: usize>((fraction, count): (f64, f64), step: &Step<T, N>, t: T) -> T {
    (T::from_f64(fraction) * (t - step.t0).abs()).max(ulps(count, step.scale(t)))
}
