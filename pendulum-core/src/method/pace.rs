//! How long the next step is.

use nalgebra::SVector;

use crate::control::{Controller, Tolerance};
use crate::error::Reason;
use crate::method::grid::Grid;
use crate::real::Float;
use crate::system::System;

/// How the next step is chosen. All lengths are positive.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Pace<T> {
    /// A grid from the start on.
    Fixed(Grid<T>),
    /// As the tolerance asks.
    Adaptive(Adaptation<T>),
}

/// The state of an adaptive pace.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Adaptation<T> {
    /// The next step; 0 before the first.
    pub(crate) h: T,
    pub(crate) h_min: T,
    pub(crate) h_max: T,
    pub(crate) max_steps: usize,
    /// The order of the error estimate.
    pub(crate) error_order: usize,
    pub(crate) tolerance: Tolerance<T>,
    pub(crate) controller: Controller,
}

/// The least adaptive step in ulps of the time.
const LEAST_ULPS: f64 = 4.0;
/// The last adaptive step may be longer than planned by this factor.
const STRETCH: f64 = 1.01;

impl<T: Float> Adaptation<T> {
    /// The least step at the time `t`: what was asked for, but no less than the time resolves.
    #[inline(always)]
    pub(crate) fn least(&self, t: T) -> T {
        self.h_min
            .max(T::from_f64(LEAST_ULPS) * T::EPSILON * t.abs())
            .max(T::MIN_POSITIVE)
    }

    /// Takes the length that a method proposes for the step from `t`, with `remaining` to go.
    #[inline(always)]
    pub(crate) fn propose(&mut self, h: T, t: T, remaining: T) -> Result<(), Reason> {
        self.h = h.min(self.h_max);
        let least = self.least(t);
        if self.h < least && self.h < remaining {
            return Err(Reason::StepUnderflow {
                h: self.h.to_f64(),
                least: least.to_f64(),
            });
        }
        Ok(())
    }

    /// A first step on the way to `t1`, from the initial point and the derivative there; one evaluation of the right-hand side.
    pub(crate) fn first_step<S, const N: usize>(
        &self,
        system: &S,
        start: (T, &SVector<T, N>, &SVector<T, N>),
        t1: T,
    ) -> T
    where
        S: System<T, N> + ?Sized,
    {
        let span = t1 - start.0;
        let direction = T::from_f64(if span < T::default() { -1.0 } else { 1.0 });
        let bounds = (self.error_order, self.h_max.min(span.abs()), direction);
        self.tolerance.first_step(system, start, bounds)
    }

    /// An error if no more steps are allowed after so many.
    #[inline(always)]
    pub(crate) fn check_steps(&self, steps: usize) -> Result<(), Reason> {
        let max_steps = self.max_steps;
        if steps < max_steps {
            Ok(())
        } else {
            Err(Reason::TooManySteps { max_steps })
        }
    }

    /// The end of the step from `t` on the way to `t1`. There is no tiny last step: this one is stretched a little to the end, or what
    /// remains is shared between two.
    #[inline(always)]
    pub(crate) fn end_of_step(&self, t: T, t1: T) -> T {
        let remaining = (t1 - t).abs();
        let direction = T::from_f64(if t1 < t { -1.0 } else { 1.0 });
        if remaining <= self.h * T::from_f64(STRETCH) {
            t1
        } else if remaining < self.h + self.h {
            t + direction * (remaining * T::from_f64(0.5))
        } else {
            t + direction * self.h
        }
    }

    /// Chooses the next step after one of length `h` with this mean square error.
    #[inline(always)]
    pub(crate) fn accept(&mut self, h: T, mean_square: T) {
        let factor = T::from_f64(self.controller.accept(mean_square.to_f64()));
        self.h = (h * factor).min(self.h_max);
    }

    /// Chooses a shorter one after an attempt of length `h` with this mean square error, or with none.
    pub(crate) fn reject(&mut self, h: T, mean_square: Option<T>) {
        let factor = match mean_square {
            Some(mean_square) => self.controller.reject(mean_square.to_f64()),
            None => self.controller.reject_failed(),
        };
        self.h = h * T::from_f64(factor);
    }
}
