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
    h: T,
    controller: PiController,
}

/// The least step in ulps of the time.
const LEAST_ULPS: f64 = 4.0;
/// The last step may be longer than planned by this factor.
const STRETCH: f64 = 1.01;

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

    /// Finds a first step on the way to `t1`, unless it is given, from the initial point and the derivative there:
    /// whether that took an evaluation of the right-hand side.
    pub(crate) fn find_first_step<S, const N: usize>(
        &self,
        pace: &mut Pace<T>,
        system: &S,
        start: (T, &SVector<T, N>, &SVector<T, N>),
        t1: T,
    ) -> bool
    where
        S: System<T, N> + ?Sized,
    {
        if self.h0.is_some() {
            return false;
        }
        let span = t1 - start.0;
        let direction = T::from_f64(if span < T::default() { -1.0 } else { 1.0 });
        let bounds = (self.error_order, self.h_max.min(span.abs()), direction);
        pace.h = self.tolerance.first_step(system, start, bounds);
        true
    }

    /// Plans the step from `t` on the way to `t1`, after this many `steps`: the time at its end.
    ///
    /// Its length is what the method proposes, if it does, else what followed from the last step. There is no tiny last
    /// step: this one is stretched a little to the end, or what remains is shared between two.
    #[inline(always)]
    pub(crate) fn plan(
        &self,
        pace: &mut Pace<T>,
        (t, t1): (T, T),
        steps: usize,
        proposed: Option<T>,
    ) -> Result<T, Reason> {
        let (least, remaining) = (self.least(t), (t1 - t).abs());
        if let Some(proposed) = proposed {
            pace.h = proposed.min(self.h_max);
            if pace.h < least && pace.h < remaining {
                return Err(underflow(pace.h, least));
            }
        }
        if steps >= self.max_steps {
            return Err(Reason::TooManySteps {
                max_steps: self.max_steps,
            });
        }
        let h = pace.h.max(least);
        pace.h = h;
        let direction = T::from_f64(if t1 < t { -1.0 } else { 1.0 });
        Ok(if remaining <= h * T::from_f64(STRETCH) {
            t1
        } else if remaining < h + h {
            t + direction * (remaining * T::from_f64(0.5))
        } else {
            t + direction * h
        })
    }

    /// Whether the step from `t` to `t_new` is accepted, from the mean square of its error; and how long the next
    /// attempt is.
    ///
    /// Methods that propose their steps do not need the length after an accepted one.
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
        let h = (t_new - t).abs();
        match outcome {
            Ok(mean_square) if is_within_tolerance(mean_square) => {
                if !method_proposes {
                    let factor = T::from_f64(pace.controller.accept(mean_square.to_f64()));
                    pace.h = (h * factor).min(self.h_max);
                }
                Ok(true)
            }
            _ => self.reject(pace, (t, t_new), outcome).map(|()| false),
        }
    }

    fn reject(&self, pace: &mut Pace<T>, (t, t_new): (T, T), outcome: Result<T, Failure>) -> Result<(), Reason> {
        let factor = match outcome {
            Ok(mean_square) => pace.controller.reject(mean_square.to_f64()),
            Err(_) => pace.controller.reject_failed(),
        };
        let (h, least) = ((t_new - t).abs() * T::from_f64(factor), self.least(t));
        pace.h = h;
        if h < least {
            return Err(match outcome {
                Ok(_) => underflow(h, least),
                Err(failure) => failure.reason((t_new - t).to_f64()),
            });
        }
        Ok(())
    }
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
