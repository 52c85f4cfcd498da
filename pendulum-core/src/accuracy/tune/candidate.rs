//! Methods to choose from.

use std::time::Instant;

use nalgebra::SVector;

use crate::accuracy::Failure;
use crate::error::{Reason, SolveError};
use crate::method::{Adaptive, Fixed, Method, OneStep};
use crate::solution::Solution;
use crate::statistics::Statistics;
use crate::step_size::Estimates;
use crate::system::System;

/// Setting that decides the accuracy of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Setting {
    /// The tolerances of an adaptive method.
    Tolerance {
        /// Relative tolerance.
        rtol: f64,
        /// Absolute tolerance, in the units of the state.
        atol: f64,
    },
    /// The length of the steps of a method with fixed steps.
    Step(f64),
}

/// Kind of setting of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Control {
    Tolerance,
    Step,
}

/// A system and a time span.
pub(super) struct Motion<'a, S> {
    pub(super) system: &'a S,
    pub(super) span: (f64, f64),
    /// Size of a component below which its error is absolute.
    pub(super) scale: f64,
    /// Ends the runs when it returns true.
    pub(super) cancel: Option<&'a (dyn Fn() -> bool + Sync)>,
}

/// A method for any setting: a relative tolerance or a step.
pub(super) struct Candidate<'a, S, const N: usize> {
    pub(super) name: &'static str,
    pub(super) control: Control,
    end: Box<End<'a, S, N>>,
    solve: Box<Solve<'a, S, N>>,
}

/// Integrates to the end with a setting, with at most this many steps.
type End<'a, S, const N: usize> =
    dyn Fn(&Motion<'_, S>, f64, usize, SVector<f64, N>) -> Result<(SVector<f64, N>, Statistics), Failure> + 'a;
type Solve<'a, S, const N: usize> =
    dyn Fn(&Motion<'_, S>, f64, SVector<f64, N>) -> Result<Solution<f64, N>, SolveError<f64, N>> + 'a;

/// An integration that reached the end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finished<const N: usize> {
    pub(super) end: SVector<f64, N>,
    pub(super) statistics: Statistics,
    /// In seconds.
    pub(super) time: f64,
}

impl<'a, S: System<f64, N>, const N: usize> Candidate<'a, S, N> {
    pub(super) fn adaptive<F>(name: &'static str, method: Adaptive<F>) -> Self
    where
        F: OneStep<S, f64, N> + Estimates + Copy + 'a,
    {
        Self::new(name, Control::Tolerance, move |rtol, scale| {
            method.rtol(rtol).atol(rtol * scale)
        })
    }

    pub(super) fn fixed<F>(name: &'static str, method: Fixed<F>) -> Self
    where
        F: OneStep<S, f64, N> + Copy + 'a,
    {
        Self::new(name, Control::Step, move |h, _| Fixed { h, ..method })
    }

    fn new<M: Method<S, f64, N>>(
        name: &'static str,
        control: Control,
        make: impl Fn(f64, f64) -> M + Copy + 'a,
    ) -> Self {
        Self {
            name,
            control,
            end: Box::new(move |motion, value, most, x0| {
                let (t0, t1) = motion.span;
                let stepper = make(value, motion.scale).stepper(motion.system, t0, t1, x0);
                let mut stepper = stepper.map_err(|reason| Failure { t: t0, reason })?;
                for _ in 0..most {
                    if motion.cancel.is_some_and(|cancel| cancel()) {
                        let (t, reason) = (stepper.t(), Reason::Cancelled);
                        return Err(Failure { t, reason });
                    }
                    match stepper.step() {
                        Ok(Some(_)) => {}
                        Ok(None) => return Ok((stepper.x(), stepper.statistics())),
                        Err(reason) => return Err(Failure { t: stepper.t(), reason }),
                    }
                }
                Err(Failure {
                    t: stepper.t(),
                    reason: Reason::TooManySteps { max_steps: most },
                })
            }),
            solve: Box::new(move |motion, value, x0| {
                let (t0, t1) = motion.span;
                make(value, motion.scale).solve(motion.system, t0, t1, x0)
            }),
        }
    }

    pub(super) fn run(
        &self,
        motion: &Motion<'_, S>,
        value: f64,
        most_steps: usize,
        x0: SVector<f64, N>,
    ) -> Result<Finished<N>, Failure> {
        let start = Instant::now();
        let (end, statistics) = (self.end)(motion, value, most_steps, x0)?;
        Ok(Finished {
            end,
            statistics,
            time: start.elapsed().as_secs_f64(),
        })
    }

    pub(super) fn solve(
        &self,
        motion: &Motion<'_, S>,
        value: f64,
        x0: SVector<f64, N>,
    ) -> Result<Solution<f64, N>, SolveError<f64, N>> {
        (self.solve)(motion, value, x0)
    }

    pub(super) fn setting(&self, value: f64, scale: f64) -> Setting {
        match self.control {
            Control::Tolerance => Setting::Tolerance {
                rtol: value,
                atol: value * scale,
            },
            Control::Step => Setting::Step(value),
        }
    }
}
