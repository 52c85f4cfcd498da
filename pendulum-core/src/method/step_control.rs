//! Step-size control of one trajectory: length of steps, acceptance, and failure.

use nalgebra::SVector;

use crate::error::Reason;
use crate::method::scheme::StepFailure;
use crate::method::stages::Called;
use crate::real::{Float, ulps};
use crate::step_size::{PiController, Tolerance};
use crate::system::System;

/// Settings of an [`Adaptive`](crate::method::Adaptive) method for an integration, with defaults filled in. All lengths
/// are positive.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct StepControl<T> {
    /// First step, if given.
    pub h0: Option<T>,
    /// Minimum step.
    pub h_min: T,
    /// Maximum step.
    pub h_max: T,
    /// Maximum number of steps, accepted and rejected.
    pub max_steps: usize,
    /// Order of the error estimate.
    pub error_order: usize,
    /// Tolerance of the errors.
    pub tolerance: Tolerance<T>,
    /// True if the integration goes on after the end of its span: a step that the end cuts short does not shorten the
    /// next one.
    pub(crate) keeps_pace: bool,
}

/// Step-size state of one trajectory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<T> {
    /// Length of the next step.
    pub(crate) h: T,
    pub(crate) controller: PiController,
}

/// Minimum step, in ulps of the time.
const LEAST_ULPS: f64 = 4.0;
/// Factor by which the last step may be longer than planned.
const STRETCH: f64 = 1.01;
/// Fraction of the planned length below which a step was cut short by the end of the span, not by rounding.
const CUT_SHORT: f64 = 0.99;
/// Maximum growth of a proposed step over the last one. A step no longer than the time since the last jump of the
/// right-hand side passes at most one jump, which the derivative at its end then reveals.
const GROW_PROPOSED: f64 = 2.0;

impl<T> Pace<T> {
    /// Pace of steps of a given length.
    #[cfg(feature = "std")]
    pub(crate) fn of_length(h: T) -> Self {
        Self {
            h,
            controller: PiController::new(1),
        }
    }

    /// Continues with an error estimate of another order.
    #[inline(always)]
    pub(crate) fn set_order(&mut self, order: usize) {
        self.controller.set_order(order);
    }
}

impl<T: Float> StepControl<T> {
    /// Initial pace: the longest step, until a first one is [chosen](Self::first_step) or proposed.
    pub(crate) fn start(&self) -> Pace<T> {
        Pace {
            h: self.h0.unwrap_or(self.h_max),
            controller: PiController::new(self.error_order),
        }
    }

    /// Minimum step at the time `t`: the setting, or the resolution of the time if that is larger.
    #[inline(always)]
    pub(crate) fn least(&self, t: T) -> T {
        self.h_min.max(ulps(LEAST_ULPS, t.abs())).max(T::MIN_POSITIVE)
    }

    /// Chooses a first step towards `t1`, unless it is given, from the initial point and its derivative, with one
    /// evaluation of the right-hand side.
    pub(crate) fn first_step<S, const N: usize>(
        &self,
        system: &S,
        start: (T, &SVector<T, N>, &SVector<T, N>),
        t1: T,
    ) -> Option<T>
    where
        S: System<T, N> + ?Sized,
    {
        let (h_max, direction) = self.bounds_of_first(t1 - start.0)?;
        let bounds = (self.error_order, h_max, direction);
        Some(self.tolerance.first_step(&Called(system), start, bounds))
    }

    /// Bound and direction of a first step, unless it is given.
    pub(crate) fn bounds_of_first(&self, span: T) -> Option<(T, T)> {
        let direction = T::from_f64(if span < T::default() { -1.0 } else { 1.0 });
        self.h0.is_none().then(|| (self.h_max.min(span.abs()), direction))
    }

    /// Plans the step from `t` towards `t1`, after this many `steps`, and returns the time at its end. `h` is the
    /// length suggested by the last step, and is updated.
    ///
    /// # Errors
    /// The reason not to take a step.
    #[inline(always)]
    pub(crate) fn plan(&self, h: &mut T, span: (T, T), steps: usize, proposed: Option<T>) -> Result<T, Reason> {
        let planned = self.planned(*h, span, steps, proposed);
        if planned.is_refused {
            return Err(if steps >= self.max_steps {
                Reason::TooManySteps {
                    max_steps: self.max_steps,
                }
            } else {
                underflow(planned.h, self.least(span.0))
            });
        }
        *h = planned.h;
        Ok(planned.end)
    }

    /// Plans the step from `t` towards `t1`. Without branches, so that it vectorizes over lanes.
    ///
    /// Its length is the one suggested by the last step, or the proposal of the method if that is shorter. To avoid a
    /// tiny last step, this one is stretched a little to the end, or the remaining time is split into two steps.
    #[inline(always)]
    pub(crate) fn planned(&self, h: T, (t, t1): (T, T), steps: usize, proposed: Option<T>) -> Planned<T> {
        let (least, remaining) = (self.least(t), (t1 - t).abs());
        let is_too_short = proposed.is_some_and(|h| (h < least) & (h < remaining));
        let is_refused = (steps >= self.max_steps) | is_too_short;
        let length = proposed.map_or(h, |proposed| proposed.min(h));
        let h = if is_refused { length } else { length.max(least) };
        let direction = T::from_f64(if t1 < t { -1.0 } else { 1.0 });
        let half = t + direction * (remaining * T::from_f64(0.5));
        let whole = t + direction * h;
        let end = if remaining < h + h { half } else { whole };
        let end = if remaining <= h * T::from_f64(STRETCH) { t1 } else { end };
        Planned { h, end, is_refused }
    }

    /// Decides from the mean square of its error if the step from `t` to `t_new` is accepted, and chooses the length of
    /// the next attempt: the same if the change is within the range `kept`.
    ///
    /// # Errors
    /// The reason to stop, if the next attempt would be shorter than the minimum step.
    #[inline(always)]
    pub(crate) fn judge(
        &self,
        pace: &mut Pace<T>,
        (t, t_new): (T, T),
        outcome: Result<T, StepFailure>,
        method_proposes: bool,
        kept: (f64, f64),
    ) -> Result<bool, Reason> {
        let mean_square = outcome.unwrap_or(T::from_f64(f64::NAN));
        let judged = self.judged((&mut pace.controller, pace.h), (t, t_new), mean_square, method_proposes);
        let (least, most) = (T::from_f64(kept.0) * pace.h, T::from_f64(kept.1) * pace.h);
        if !(judged.is_accepted && least <= judged.h && judged.h <= most) {
            pace.h = judged.h;
        }
        if judged.is_hopeless {
            return Err(self.hopeless(outcome, (t, t_new), judged.h));
        }
        Ok(judged.is_accepted)
    }

    /// Like [`judge`](Self::judge), but takes a mean square that is NaN for a failed attempt, and the planned length of
    /// the step. Without branches, so that it vectorizes over lanes.
    #[inline(always)]
    pub(crate) fn judged(
        &self,
        (controller, planned): (&mut PiController, T),
        (t, t_new): (T, T),
        mean_square: T,
        method_proposes: bool,
    ) -> Judged<T> {
        let is_accepted = is_within_tolerance(mean_square);
        let factor = controller.next(mean_square.to_f64());
        let factor = if method_proposes & is_accepted {
            GROW_PROPOSED
        } else {
            factor
        };
        let length = (t_new - t).abs();
        let h = length * T::from_f64(factor);
        let is_cut_short = self.keeps_pace & (length < T::from_f64(CUT_SHORT) * planned) & (h > length);
        let h = if is_accepted & is_cut_short { h.max(planned) } else { h };
        Judged {
            is_accepted,
            h: if is_accepted { h.min(self.h_max) } else { h },
            is_hopeless: !is_accepted & (h < self.least(t)),
        }
    }

    /// Reason to stop after an attempt from `t` to `t_new`, if the next one would be as short as `h`.
    #[cold]
    pub(crate) fn hopeless(&self, outcome: Result<T, StepFailure>, (t, t_new): (T, T), h: T) -> Reason {
        match outcome {
            Ok(_) => underflow(h, self.least(t)),
            Err(failure) => failure.reason((t_new - t).to_f64()),
        }
    }
}

/// A planned step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Planned<T> {
    /// Length for the step-size control, before adjustments near the end of the span.
    pub(crate) h: T,
    /// Time at the end of the step.
    pub(crate) end: T,
    /// True if no further step may be taken.
    pub(crate) is_refused: bool,
}

/// Decision about an attempt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Judged<T> {
    pub(crate) is_accepted: bool,
    /// Length of the next attempt.
    pub(crate) h: T,
    /// True if the next attempt would be too short.
    pub(crate) is_hopeless: bool,
}

/// True if an error with this mean square, in units of the tolerance, is within it; false for NaN.
#[inline(always)]
pub(crate) fn is_within_tolerance<T: Float>(mean_square: T) -> bool {
    mean_square <= T::from_f64(1.0)
}

fn underflow<T: Float>(h: T, least: T) -> Reason {
    Reason::StepUnderflow {
        h: h.to_f64(),
        least: least.to_f64(),
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{StepControl, is_within_tolerance};
    use crate::error::Reason;
    use crate::method::scheme::Stalled;
    use crate::step_size::Tolerance;
    use crate::system::FnSystem;

    const CONTROL: StepControl<f64> = StepControl {
        h0: None,
        h_min: 0.0,
        h_max: 100.0,
        max_steps: 1000,
        error_order: 4,
        tolerance: Tolerance { rtol: 0.0, atol: 1.0 },
        keeps_pace: false,
    };

    #[test]
    fn the_least_step_is_the_longest_of_three() {
        let least = |h_min, t| StepControl { h_min, ..CONTROL }.least(t);
        assert_eq!(least(0.5, -100.0), 0.5);
        assert_eq!(least(0.0, -100.0), 400.0 * f64::EPSILON);
        assert_eq!(least(0.0, 0.0), f64::MIN_POSITIVE);
    }

    #[test]
    fn the_first_step_is_no_longer_than_the_span() {
        let system = FnSystem(|t: f64, x: &SVector<f64, 1>| SVector::from([if t < 3.0 { 1e3 } else { 0.0 } - x[0]]));
        let first = |control: StepControl<f64>, t1: f64| {
            control.first_step(&system, (3.0, &SVector::from([1.0]), &SVector::from([-1.0])), 3.0 + t1)
        };
        let given = StepControl {
            h0: Some(0.1),
            ..CONTROL
        };
        assert_eq!(
            (first(given, 2.0), given.start().h, CONTROL.start().h),
            (None, 0.1, 100.0)
        );
        // Hairer's formula: d1 = 1 and forward d2 = 1, backward |999 + 1.01| / 0.01
        let near = |found: Option<f64>, expected: f64| found.is_some_and(|h| (h / expected - 1.0).abs() < 1e-12);
        assert!(near(first(CONTROL, 2.0), 0.01_f64.powf(0.2)));
        assert!(
            near(first(CONTROL, -2.0), (0.01_f64 / (999.99 / 0.01)).powf(0.2)),
            "{:?}",
            first(CONTROL, -2.0)
        );
        assert_eq!(first(CONTROL, 0.25), Some(0.25));
        assert_eq!(
            first(
                StepControl {
                    h_max: 0.125,
                    ..CONTROL
                },
                0.25
            ),
            Some(0.125)
        );
    }

    #[test]
    fn the_last_steps_are_shared_or_stretched() {
        for direction in [1.0, -1.0] {
            let end = |h: f64, remaining: f64| {
                let mut h = h;
                let span = (3.0, 3.0 + direction * remaining);
                (CONTROL.plan(&mut h, span, 0, None).expect("a step") - 3.0) * direction
            };
            assert_eq!((end(1.0, 8.0), end(1.0, 2.125)), (1.0, 1.0));
            assert_eq!((end(1.0, 1.5), end(1.0, 1.03125)), (0.75, 0.515_625));
            assert_eq!(
                (end(1.0, 1.0078125), end(1.0, 1.0), end(1.0, 0.25)),
                (1.0078125, 1.0, 0.25)
            );
        }
        // 1.01 is included
        assert_eq!(CONTROL.planned(1.0, (0.0, 1.01), 0, None).end, 1.01);
    }

    #[test]
    fn what_a_method_proposes_is_no_more_than_twice_the_last_step() {
        let mut pace = CONTROL.start();
        assert_eq!(CONTROL.planned(pace.h, (0.0, 1e3), 0, Some(5.0)).h, 5.0);
        assert_eq!(CONTROL.planned(pace.h, (0.0, 1e3), 0, Some(500.0)).h, 100.0);
        assert_eq!(
            CONTROL.judge(&mut pace, (0.0, 5.0), Ok(0.0), true, (1.0, 1.0)),
            Ok(true)
        );
        assert_eq!(CONTROL.planned(pace.h, (0.0, 1e3), 0, Some(500.0)).h, 10.0);
        assert_eq!(
            CONTROL.judge(&mut pace, (5.0, 15.0), Ok(1e9), true, (1.0, 1.0)),
            Ok(false)
        );
        assert_eq!(pace.h, 2.0, "a rejected one is shortened like any other");
        assert_eq!(
            CONTROL.judge(&mut pace, (5.0, 7.0), Ok(1e-9), false, (1.0, 1.0)),
            Ok(true)
        );
        assert_eq!(pace.h, 2.0, "without proposals there is no growth after a rejection");
    }

    #[test]
    fn the_order_of_the_estimate_is_that_of_the_exponent() {
        for order in [4, 9] {
            let mut pace = CONTROL.start();
            pace.set_order(order);
            assert_eq!(
                CONTROL.judge(&mut pace, (0.0, 1.0), Ok(4.0), false, (1.0, 1.0)),
                Ok(false)
            );
            // 0.9 e^-alpha for an error of 2
            let expected = 0.9 * 2.0_f64.powf(0.03 - 1.0 / (order as f64 + 1.0));
            assert!((pace.h / expected - 1.0).abs() < 2e-4, "{} {expected}", pace.h);
        }
    }

    #[test]
    fn no_step_is_shorter_than_the_least_but_the_last() {
        let control = StepControl { h_min: 0.5, ..CONTROL };
        let plan = |proposed, remaining: f64| {
            let mut h = 1.0;
            control
                .plan(&mut h, (3.0, 3.0 + remaining), 999, proposed)
                .map(|end| (h, end))
        };
        assert_eq!(plan(Some(0.5), 8.0), Ok((0.5, 3.5)));
        assert_eq!(
            plan(Some(0.25), 8.0),
            Err(Reason::StepUnderflow { h: 0.25, least: 0.5 })
        );
        assert_eq!(plan(Some(0.25), 0.25), Ok((0.5, 3.25)));
        let mut h = 0.25;
        assert_eq!(control.plan(&mut h, (3.0, 8.0), 0, None), Ok(3.5));
        // nor after the maximum number of steps
        let mut h = 1.0;
        let too_many = Err(Reason::TooManySteps { max_steps: 1000 });
        assert_eq!(control.plan(&mut h, (3.0, 8.0), 1000, None), too_many);
        assert_eq!(control.plan(&mut h, (3.0, 8.0), 1001, Some(0.25)), too_many);
    }

    #[test]
    fn an_attempt_is_hopeless_if_the_next_would_be_too_short() {
        let control = StepControl { h_min: 0.5, ..CONTROL };
        let judge = |t_new: f64, outcome| control.judge(&mut control.start(), (3.0, t_new), outcome, false, (1.0, 1.0));
        // a large error shortens the next attempt to a fifth, a failed one to a quarter
        assert_eq!(judge(5.5, Ok(1e9)), Ok(false));
        assert_eq!(judge(0.5, Ok(1e9)), Ok(false));
        assert_eq!(judge(5.25, Ok(1e9)), Err(Reason::StepUnderflow { h: 0.45, least: 0.5 }));
        assert_eq!(judge(5.0, Err(Stalled.into())), Ok(false));
        assert_eq!(judge(4.0, Err(Stalled.into())), Err(Reason::NoConvergence { h: 1.0 }));
        // an accepted step may be short, and the next one is at most the maximum
        assert_eq!(judge(3.125, Ok(1.0)), Ok(true));
        let mut pace = control.start();
        assert_eq!(
            (
                control.judge(&mut pace, (3.0, 83.0), Ok(0.0), false, (1.0, 1.0)),
                pace.h
            ),
            (Ok(true), 100.0)
        );
        assert!(is_within_tolerance(1.0) && !is_within_tolerance(1.0_f64.next_up()) && !is_within_tolerance(f64::NAN));
    }
}
