//! Stepping without a record: no heap at all.

use std::fmt;
use std::marker::PhantomData;

use nalgebra::SVector;

use crate::control::{Controller, Tolerance};
use crate::dense::Step;
use crate::error::{Reason, SolveError};
use crate::method::explicit::{SHORT, attempt, weighted_sum};
use crate::method::grid::Grid;
use crate::real::Float;
use crate::solution::{Solution, Statistics};
use crate::system::System;
use crate::tableau::Tableau;

/// An integration under way, one accepted step at a time and without a heap.
///
/// Made by the `stepper` of a method. After an error it stays at the last good point.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let mut stepper = Rk45::new().stepper(&swing, 0.0, 100.0, [0.5, 0.0])?;
/// while let Some(step) = stepper.step()? {
///     if step.x1[0] < 0.0 {
///         break;
///     }
/// }
/// assert!(stepper.t() > 1.5 && stepper.x()[0] < 0.0);
/// # Ok::<(), Reason>(())
/// ```
#[derive(Clone)]
pub struct Stepper<'s, S: ?Sized, B, const STAGES: usize, const N: usize, T = f64> {
    system: &'s S,
    /// Where it starts, ends and is.
    t0: T,
    t1: T,
    t: T,
    x: SVector<T, N>,
    /// The derivative at `(t, x)`.
    slope: SVector<T, N>,
    /// The start of the last accepted step, and its stages.
    previous: (T, SVector<T, N>),
    stages: [SVector<T, N>; STAGES],
    pace: Pace<T>,
    statistics: Statistics,
    tableau: PhantomData<B>,
}

/// How the next step is chosen. All lengths are positive.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pace<T> {
    /// A grid from the start on.
    Fixed(Grid<T>),
    /// As the tolerance asks.
    Adaptive(Adaptation<T>),
}

/// The state of an adaptive pace.
#[derive(Clone, Copy, Debug)]
pub(super) struct Adaptation<T> {
    /// The next step; 0 before the first.
    pub(super) h: T,
    pub(super) h_min: T,
    pub(super) h_max: T,
    pub(super) max_steps: usize,
    pub(super) tolerance: Tolerance<T>,
    pub(super) controller: Controller,
}

/// The least adaptive step in ulps of the time.
const LEAST_ULPS: f64 = 4.0;
/// The last adaptive step may be longer than planned by this factor.
const STRETCH: f64 = 1.01;

impl<'s, S, B, T, const STAGES: usize, const N: usize> Stepper<'s, S, B, STAGES, N, T>
where
    S: System<T, N> + ?Sized,
    B: Tableau<STAGES>,
    T: Float,
{
    /// A stepper at its start. An adaptive `pace` whose `h` is 0 finds its first step itself.
    pub(super) fn new(system: &'s S, t0: T, t1: T, x0: SVector<T, N>, pace: Pace<T>) -> Result<Self, Reason> {
        let mut stepper = Self {
            system,
            t0,
            t1,
            t: t0,
            x: x0,
            slope: SVector::from_element(T::default()),
            previous: (t0, x0),
            stages: [SVector::from_element(T::default()); STAGES],
            pace,
            statistics: Statistics::default(),
            tableau: PhantomData,
        };
        if t0 != t1 {
            stepper.begin()?;
        }
        Ok(stepper)
    }

    /// The time reached.
    #[must_use]
    pub fn t(&self) -> T {
        self.t
    }

    /// The state reached.
    #[must_use]
    pub fn x(&self) -> SVector<T, N> {
        self.x
    }

    /// How much work it was so far.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Takes one step: the step, or `None` if the end is reached.
    ///
    /// The last step ends at the end of the span exactly.
    ///
    /// # Errors
    /// [`Reason::NonFinite`], and from adaptive methods [`Reason::StepUnderflow`] and [`Reason::TooManySteps`].
    #[inline]
    pub fn step(&mut self) -> Result<Option<Step<'_, N, T>>, Reason> {
        if self.t == self.t1 {
            return Ok(None);
        }
        match self.pace {
            Pace::Fixed(grid) => self.step_on_grid(&grid)?,
            Pace::Adaptive(pace) => self.step_within_tolerance(pace)?,
        }
        Ok(Some(Step {
            t0: self.previous.0,
            t1: self.t,
            h: self.t - self.previous.0,
            x0: self.previous.1,
            x1: self.x,
            stages: &self.stages,
            weights: B::TABLEAU.dense.as_flattened(),
        }))
    }

    /// Goes on to the end and keeps a record.
    pub(super) fn collect(mut self) -> Result<Solution<N, T>, SolveError<N, T>> {
        let mut solution = Solution::start(self.t, self.x);
        loop {
            match self.step() {
                Ok(Some(step)) => solution.push(&step),
                Ok(None) => {
                    solution.set_statistics(self.statistics);
                    return Ok(solution);
                }
                Err(reason) => {
                    solution.set_statistics(self.statistics);
                    return Err(SolveError {
                        reason,
                        solution: Box::new(solution),
                    });
                }
            }
        }
    }

    fn begin(&mut self) -> Result<(), Reason> {
        self.slope = self.system.rhs(self.t0, &self.x);
        self.statistics.evaluations = 1;
        if let Some(component) = non_finite(&self.slope) {
            return Err(Reason::NonFinite { component, h: 0.0 });
        }
        let direction = self.direction();
        let span = (self.t1 - self.t0).abs();
        if let Pace::Adaptive(pace) = &mut self.pace
            && pace.h == T::default()
        {
            let start = (self.t0, &self.x, &self.slope);
            let bounds = (B::TABLEAU.order_hat, pace.h_max.min(span), direction);
            pace.h = pace.tolerance.first_step(self.system, start, bounds);
            self.statistics.evaluations += 1;
        }
        Ok(())
    }

    fn direction(&self) -> T {
        T::from_f64(if self.t1 < self.t0 { -1.0 } else { 1.0 })
    }

    fn step_on_grid(&mut self, grid: &Grid<T>) -> Result<(), Reason> {
        let t_new = grid.end_of(self.statistics.accepted + 1);
        let x_new = self.attempt(t_new);
        match self.non_finite(&x_new) {
            None => {
                self.advance(t_new, x_new);
                Ok(())
            }
            Some(component) => {
                self.statistics.rejected += 1;
                Err(Reason::NonFinite {
                    component,
                    h: (t_new - self.t).to_f64(),
                })
            }
        }
    }

    fn step_within_tolerance(&mut self, mut pace: Adaptation<T>) -> Result<(), Reason> {
        let direction = self.direction();
        let least = least_step(pace.h_min, self.t);
        let remaining = (self.t1 - self.t).abs();
        pace.h = pace.h.max(least);
        loop {
            if self.statistics.accepted + self.statistics.rejected >= pace.max_steps {
                return Err(Reason::TooManySteps {
                    max_steps: pace.max_steps,
                });
            }
            // No tiny last step: stretch this one a little to the end, or share what remains between two.
            let t_new = if remaining <= pace.h * T::from_f64(STRETCH) {
                self.t1
            } else if remaining < pace.h + pace.h {
                self.t + direction * (remaining * T::from_f64(0.5))
            } else {
                self.t + direction * pace.h
            };
            let h = (t_new - self.t).abs();
            let x_new = self.attempt(t_new);
            let not_finite = self.non_finite(&x_new);
            let factor = if not_finite.is_some() {
                pace.controller.reject_non_finite()
            } else {
                let weights = const { &B::TABLEAU.error_weights() };
                let error = weighted_sum(h, weights, STAGES, &self.stages);
                let mean_square = pace.tolerance.mean_square(&error, &self.x, &x_new).to_f64();
                if mean_square <= 1.0 {
                    let factor = T::from_f64(pace.controller.accept(mean_square));
                    pace.h = (h * factor).min(pace.h_max);
                    self.pace = Pace::Adaptive(pace);
                    self.advance(t_new, x_new);
                    return Ok(());
                }
                pace.controller.reject(mean_square)
            };
            self.statistics.rejected += 1;
            pace.h = h * T::from_f64(factor);
            if pace.h < least {
                return Err(match not_finite {
                    Some(component) => Reason::NonFinite {
                        component,
                        h: (t_new - self.t).to_f64(),
                    },
                    None => Reason::StepUnderflow {
                        h: pace.h.to_f64(),
                        least: least.to_f64(),
                    },
                });
            }
        }
    }

    #[inline]
    fn attempt(&mut self, t_new: T) -> SVector<T, N> {
        self.statistics.evaluations += STAGES - 1;
        self.stages[0] = self.slope;
        let (start, stages) = ((self.t, &self.x), &mut self.stages);
        if const { N <= SHORT } {
            attempt::<B, S, _, _, _>(self.system, start, t_new, stages)
        } else {
            // The right-hand side of a reference may stay a function of its own, where that of a generated model is always inlined: many
            // copies of a long one are slower than calls.
            attempt::<B, &S, _, _, _>(&self.system, start, t_new, stages)
        }
    }

    /// The first component in which the state or the derivative at the end of an attempt is not finite.
    #[inline]
    fn non_finite(&self, x_new: &SVector<T, N>) -> Option<usize> {
        non_finite(x_new).or_else(|| non_finite(&self.stages[STAGES - 1]))
    }

    #[inline]
    fn advance(&mut self, t_new: T, x_new: SVector<T, N>) {
        self.statistics.accepted += 1;
        self.previous = (self.t, self.x);
        self.t = t_new;
        self.x = x_new;
        self.slope = self.stages[STAGES - 1];
    }
}

#[inline]
fn non_finite<T: Float, const N: usize>(v: &SVector<T, N>) -> Option<usize> {
    v.iter().position(|component| !component.is_finite())
}

/// The least adaptive step at the time `t`: what was asked for, but no less than the time resolves.
pub(super) fn least_step<T: Float>(h_min: T, t: T) -> T {
    h_min
        .max(T::from_f64(LEAST_ULPS) * T::EPSILON * t.abs())
        .max(T::MIN_POSITIVE)
}

impl<S, B, T, const STAGES: usize, const N: usize> fmt::Debug for Stepper<'_, S, B, STAGES, N, T>
where
    S: ?Sized,
    T: Float,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stepper")
            .field("t", &self.t)
            .field("x", &self.x)
            .field("t1", &self.t1)
            .field("statistics", &self.statistics)
            .finish_non_exhaustive()
    }
}
