//! The decisions about the steps of one trajectory within a tolerance: how long, whether accepted, and when to give up.

use nalgebra::SVector;

use crate::control::{PiController, Tolerance};
use crate::error::Reason;
use crate::method::scheme::Failure;
use crate::real::Float;
use crate::system::System;

/// The settings of all trajectories of a method. All lengths are positive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepControl<T> {
    /// The first step, where it is given.
    pub(crate) h0: Option<T>,
    pub(crate) h_min: T,
    pub(crate) h_max: T,
    pub(crate) max_steps: usize,
    /// The order of the error estimate.
    pub(crate) error_order: usize,
    pub(crate) tolerance: Tolerance<T>,
}

/// What one trajectory has learnt on its way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<T> {
    /// The length of the next step.
    pub(crate) h: T,
    pub(crate) controller: PiController,
}

/// The least step in ulps of the time.
const LEAST_ULPS: f64 = 4.0;
/// The last step may be longer than planned by this factor.
const STRETCH: f64 = 1.01;
/// The most by which a proposed step may be longer than the last one. No longer than the way since a jump of the
/// right-hand side, it does not pass two, and where it ends the derivative shows that it passed one.
const GROW_PROPOSED: f64 = 2.0;

impl<T> Pace<T> {
    /// Goes on with an error estimate of another order.
    #[inline(always)]
    pub(crate) fn set_order(&mut self, order: usize) {
        self.controller.set_order(order);
    }
}

impl<T: Float> StepControl<T> {
    /// The pace at the start: the longest step, until a first one is [found](Self::find_first_step) or proposed.
    pub(crate) fn start(&self) -> Pace<T> {
        Pace {
            h: self.h0.unwrap_or(self.h_max),
            controller: PiController::new(self.error_order),
        }
    }

    /// The least step at the time `t`: the setting, but no less than the time resolves.
    #[inline(always)]
    pub(crate) fn least(&self, t: T) -> T {
        self.h_min
            .max(T::from_f64(LEAST_ULPS) * T::EPSILON * t.abs())
            .max(T::MIN_POSITIVE)
    }

    /// A first step on the way to `t1`, unless it is given, from the initial point and the derivative there, by one
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
        if self.h0.is_some() {
            return None;
        }
        let span = t1 - start.0;
        let direction = T::from_f64(if span < T::default() { -1.0 } else { 1.0 });
        let bounds = (self.error_order, self.h_max.min(span.abs()), direction);
        Some(self.tolerance.first_step(system, start, bounds))
    }

    /// Plans the step from `t` on the way to `t1`, after this many `steps`: the time at its end. `h` is the length that
    /// followed from the last step, and becomes the one to go on with.
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

    /// The step from `t` on the way to `t1`. Without branches, so that lanes decide together.
    ///
    /// Its length is what followed from the last step, or what the method proposes if that is less. There is no tiny
    /// last step: this one is stretched a little to the end, or what remains is shared between two.
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

    /// Whether the step from `t` to `t_new` is accepted, from the mean square of its error; and how long the next
    /// attempt is.
    ///
    /// # Errors
    /// If the next attempt would be shorter than the least step: the reason to give up.
    #[inline(always)]
    pub(crate) fn judge(
        &self,
        pace: &mut Pace<T>,
        (t, t_new): (T, T),
        outcome: Result<T, Failure>,
        method_proposes: bool,
    ) -> Result<bool, Reason> {
        let mean_square = outcome.unwrap_or(T::from_f64(f64::NAN));
        let judged = self.judged(&mut pace.controller, (t, t_new), mean_square, method_proposes);
        pace.h = judged.h;
        if judged.is_hopeless {
            return Err(self.hopeless(outcome, (t, t_new), judged.h));
        }
        Ok(judged.is_accepted)
    }

    /// As [`judge`](Self::judge), from a mean square that is NaN where the attempt arrived nowhere. Without branches, so
    /// that lanes decide together.
    #[inline(always)]
    pub(crate) fn judged(
        &self,
        controller: &mut PiController,
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
        let h = (t_new - t).abs() * T::from_f64(factor);
        Judged {
            is_accepted,
            h: if is_accepted { h.min(self.h_max) } else { h },
            is_hopeless: !is_accepted & (h < self.least(t)),
        }
    }

    /// The reason to give up after an attempt from `t` to `t_new`, since the next one would be as short as `h`.
    #[cold]
    pub(crate) fn hopeless(&self, outcome: Result<T, Failure>, (t, t_new): (T, T), h: T) -> Reason {
        match outcome {
            Ok(_) => underflow(h, self.least(t)),
            Err(failure) => failure.reason((t_new - t).to_f64()),
        }
    }
}

/// A step to be tried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Planned<T> {
    /// Its length, but for the last ones.
    pub(crate) h: T,
    /// The time at its end.
    pub(crate) end: T,
    /// Whether there must be no further step.
    pub(crate) is_refused: bool,
}

/// What is made of an attempt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Judged<T> {
    pub(crate) is_accepted: bool,
    /// The length of the next attempt.
    pub(crate) h: T,
    /// Whether that is too short.
    pub(crate) is_hopeless: bool,
}

/// Whether an error with this mean square in units of the tolerance is within it; NaN is not.
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
