//! The engine of all methods: stepping without a record, and without a heap.

use std::fmt;

use nalgebra::SVector;

use crate::dense::{Dense, Step};
use crate::error::Reason;
use crate::method::grid::Grid;
use crate::method::input::{check_state, require};
use crate::method::pace::{Adaptation, Pace};
use crate::method::scheme::{Attempt, NonFinite, Scheme, Stalled};
use crate::real::Float;
use crate::solution::Statistics;
use crate::system::System;

/// An integration under way, one accepted step at a time and without a heap.
///
/// Made by the [`stepper`](crate::Method::stepper) of a method, whose `C` is. After an error it stays at the last good point.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::Reason;
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
pub struct Stepper<'s, C, S: ?Sized, T, const N: usize> {
    system: &'s S,
    scheme: C,
    pace: Pace<T>,
    /// Where it ends.
    t1: T,
    /// The last accepted step; of no length where there is none.
    last: Step<T, N>,
    statistics: Statistics,
}

/// Why an attempt was no step.
enum Failure {
    Stalled,
    NonFinite(usize),
}

impl From<Stalled> for Failure {
    fn from(Stalled: Stalled) -> Self {
        Self::Stalled
    }
}

impl From<NonFinite> for Failure {
    fn from(NonFinite(component): NonFinite) -> Self {
        Self::NonFinite(component)
    }
}

impl Failure {
    /// The reason to give up, after a step of length `h`.
    fn reason(&self, h: f64) -> Reason {
        match *self {
            Self::Stalled => Reason::NoConvergence { h },
            Self::NonFinite(component) => Reason::NonFinite { component, h },
        }
    }
}

impl<'s, C, S, T, const N: usize> Stepper<'s, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// A stepper at its start.
    pub(super) fn new(
        system: &'s S,
        scheme: C,
        (t0, t1): (T, T),
        x0: SVector<T, N>,
        pace: Pace<T>,
    ) -> Result<Self, Reason> {
        let mut stepper = Self {
            system,
            scheme,
            pace,
            t1,
            last: Step::at_rest(t0, x0),
            statistics: Statistics::default(),
        };
        if t0 != t1 {
            stepper.begin()?;
        }
        Ok(stepper)
    }

    /// The time reached.
    #[must_use]
    #[inline]
    pub fn t(&self) -> T {
        self.last.t1
    }

    /// The state reached.
    #[must_use]
    #[inline]
    pub fn x(&self) -> SVector<T, N> {
        self.last.x1
    }

    /// What the method works with, for those who know more of it than the engine.
    pub(crate) fn scheme_mut(&mut self) -> &mut C {
        &mut self.scheme
    }

    /// How much work it was so far.
    #[must_use]
    #[inline]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Takes one step: the step, or `None` if the end is reached.
    ///
    /// The last step ends at the end of the span exactly.
    ///
    /// # Errors
    /// [`Reason::NonFinite`] and, from implicit methods, [`Reason::NoConvergence`]; where the method chooses its steps,
    /// [`Reason::StepUnderflow`] and [`Reason::TooManySteps`].
    #[inline]
    pub fn step(&mut self) -> Result<Option<Step<T, N>>, Reason> {
        if self.t() == self.t1 {
            return Ok(None);
        }
        match self.pace {
            Pace::Fixed(grid) => self.step_on_grid(grid),
            Pace::Adaptive(pace) => self.step_within_tolerance(pace),
        }
        .inspect_err(|_| self.last = Step::at_rest(self.t(), self.x()))?;
        self.statistics.accepted += 1;
        Ok(Some(self.last))
    }

    /// The states within the step that was taken last, by the dense output of the method. Some methods evaluate the right-hand side a
    /// few more times for it. Before the first step, and after a failed one, it is the point reached.
    pub fn dense(&mut self) -> Dense<'_, T, N> {
        let coefficients = if self.last.t0 == self.last.t1 {
            &[]
        } else {
            self.scheme.dense(self.system, &self.last, &mut self.statistics)
        };
        Dense::new(self.last, coefficients)
    }

    /// Goes on to the end, without a record: the state there.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    #[inline]
    pub fn run(&mut self) -> Result<SVector<T, N>, Reason> {
        while self.step()?.is_some() {}
        Ok(self.x())
    }

    /// Jumps to the state `x` at the time `t`, and goes on from there to the end: a reset, or another try.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if `t` does not lie between the start of the last step and the end of the span, or if the state is not
    /// finite; [`Reason::NonFinite`] if its derivative is not. The stepper then stays where it was.
    pub fn restart(&mut self, t: T, x: SVector<T, N>) -> Result<(), Reason> {
        let (from, to) = (self.last.t0.min(self.t1), self.last.t0.max(self.t1));
        let rule = "the time to go on from must lie between the start of the last step and the end";
        require(from <= t && t <= to, "t", t.to_f64(), rule)?;
        check_state(&x)?;
        let (before, pace) = ((self.t(), self.x()), self.pace);
        self.last = Step::at_rest(t, x);
        if let Pace::Fixed(grid) = &mut self.pace {
            grid.go_to(t);
        }
        if t == self.t1 {
            return Ok(());
        }
        self.begin().inspect_err(|_| {
            // The scheme went to the new point, and its last step is lost.
            self.last = Step::at_rest(before.0, before.1);
            self.pace = pace;
            self.scheme
                .begin(self.system, before.0, &before.1, &mut self.statistics);
        })
    }

    /// Evaluates the initial point, and finds the length of a first step where none is known.
    fn begin(&mut self) -> Result<(), Reason> {
        let (t, x) = (self.t(), self.x());
        let slope = self.scheme.begin(self.system, t, &x, &mut self.statistics);
        NonFinite::check(&slope).map_err(NonFinite::at_start)?;
        if let Pace::Adaptive(pace) = &mut self.pace
            && pace.h == T::default()
            && !C::PROPOSES
        {
            pace.h = pace.first_step(self.system, (t, &x, &slope), self.t1);
            self.statistics.evaluations += 1;
        }
        Ok(())
    }

    #[inline]
    fn step_on_grid(&mut self, mut grid: Grid<T>) -> Result<(), Reason> {
        let t_new = grid.next();
        match self.attempt(t_new).and_then(|attempt| self.advance(t_new, &attempt)) {
            Ok(()) => {
                self.pace = Pace::Fixed(grid);
                Ok(())
            }
            Err(failure) => {
                self.statistics.rejected += 1;
                Err(failure.reason((t_new - self.t()).to_f64()))
            }
        }
    }

    #[inline]
    fn step_within_tolerance(&mut self, mut pace: Adaptation<T>) -> Result<(), Reason> {
        let t = self.t();
        if let Some(h) = self.scheme.prepare(self.system, t, &self.last.x1, &mut self.statistics) {
            pace.propose(h, t, (self.t1 - t).abs())?;
        }
        pace.controller.set_order(self.scheme.error_order());
        let least = pace.least(t);
        pace.h = pace.h.max(least);
        loop {
            pace.check_steps(self.statistics.accepted + self.statistics.rejected)?;
            let t_new = pace.end_of_step(t, self.t1);
            let h = (t_new - t).abs();
            let failure = match self.attempt(t_new) {
                Ok(attempt) if attempt.mean_square <= T::from_f64(1.0) => match self.advance(t_new, &attempt) {
                    Ok(()) => {
                        if !C::PROPOSES {
                            pace.accept(h, attempt.mean_square);
                        }
                        self.pace = Pace::Adaptive(pace);
                        return Ok(());
                    }
                    Err(failure) => Some(failure),
                },
                Ok(attempt) => {
                    pace.reject(h, Some(attempt.mean_square));
                    None
                }
                Err(failure) => Some(failure),
            };
            self.statistics.rejected += 1;
            if failure.is_some() {
                pace.reject(h, None);
            }
            if pace.h < least {
                let underflow = Reason::StepUnderflow {
                    h: pace.h.to_f64(),
                    least: least.to_f64(),
                };
                return Err(failure.map_or(underflow, |failure| failure.reason((t_new - t).to_f64())));
            }
        }
    }

    /// Tries a step to `t_new`: where it arrives is finite, and so is its error.
    #[inline]
    fn attempt(&mut self, t_new: T) -> Result<Attempt<T, N>, Failure> {
        let start = (self.last.t1, &self.last.x1);
        let attempt = self.scheme.attempt(self.system, start, t_new, &mut self.statistics)?;
        NonFinite::check(&attempt.x)?;
        Ok(attempt)
    }

    /// Makes an attempt the last step.
    #[inline]
    fn advance(&mut self, t_new: T, attempt: &Attempt<T, N>) -> Result<(), Failure> {
        let step = Step::new((self.last.t1, self.last.x1), (t_new, attempt.x));
        self.scheme.finish(self.system, &step, &mut self.statistics)?;
        self.last = step;
        Ok(())
    }
}

impl<C, S, T, const N: usize> fmt::Debug for Stepper<'_, C, S, T, N>
where
    S: ?Sized,
    T: Float,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stepper")
            .field("t", &self.last.t1)
            .field("x", &self.last.x1)
            .field("t1", &self.t1)
            .field("statistics", &self.statistics)
            .finish_non_exhaustive()
    }
}
