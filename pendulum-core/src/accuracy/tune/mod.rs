//! The fastest method and setting for a stated error.

mod candidate;
mod error;
mod fastest;
mod pilot;
mod search;

use std::fmt;

use nalgebra::SVector;

pub use candidate::Setting;
use candidate::{Candidate, Motion};
pub use error::TuneError;
use fastest::Found;
use pilot::Pilot;
use search::Tried;

use crate::accuracy::Failure;
use crate::error::SolveError;
use crate::method::{Adaptive, Fixed, OneStep};
use crate::solution::Solution;
use crate::step_size::Estimates;
use crate::system::{Canonical, IntoState, Jacobian, System};
use crate::taylor::TaylorSeries;
use crate::{
    Auto, Gauss4, Gauss6, Gauss16, Radau5, Radau9, Radau13, Rk4, Rk45, Rodas4, Rodas5P, Taylor, Tsit5, Vern7, Vern9,
};

/// Chooses the fastest method, and its tolerance or step, for trajectories whose states at the end of the `span` have
/// at most this `error`, relative to the larger of the size of each component and 1. It tries all adaptive methods and
/// [`Rk4`]; [`Tuning`] makes another choice of methods, and another scale than 1.
///
/// Pilot runs from the `starts` measure errors and times: from all of them, or from sixteen if there are more. Hence
/// the error is that of these trajectories, and of others that are like them. Two methods with tolerances far below the
/// error tell the end states. The search takes as long as some thousand trajectories, on one core. Give several starts:
/// from a single one a setting may be accurate by chance, and err much more from starts close by.
///
/// ```
/// use pendulum_core::accuracy::tune;
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Swing {
///         params { l: m = 1.0 }
///         gravity: [0, -9.81, 0],
///         generate: [rhs, jacobian, energy, taylor],
///         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
///     }
/// }
///
/// let swing = Swing::new(SwingParams::default())?;
/// let starts = [[1.0, 0.0], [2.0, 0.0]].map(SVector::from);
/// let tuned = tune(&swing, (0.0, 20.0), &starts, 1e-8)?;
/// println!("{tuned}");
/// let swung = tuned.solve(starts[0])?;
/// let known = Vern9::new().rtol(1e-13).atol(1e-13).solve(&swing, 0.0, 20.0, starts[0])?;
/// assert!((swung.end() - known.end()).amax() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// See [`Tuning::run`].
pub fn tune<'a, S, const N: usize>(
    system: &'a S,
    span: (f64, f64),
    starts: &[SVector<f64, N>],
    error: f64,
) -> Result<Tuned<'a, S, N>, TuneError>
where
    S: Jacobian<f64, N> + TaylorSeries<f64, N>,
{
    Tuning::new(system, span, starts, error)
        .explicit()
        .series()
        .implicit()
        .run()
}

/// A choice of methods for [`tune`], which adds the methods that the system has the functions for.
pub struct Tuning<'a, S, const N: usize> {
    motion: Motion<'a, S>,
    starts: Vec<SVector<f64, N>>,
    error: f64,
    candidates: Vec<Candidate<'a, S, N>>,
}

impl<'a, S: System<f64, N>, const N: usize> Tuning<'a, S, N> {
    /// Without methods, and with a scale of 1; the arguments are those of [`tune`].
    #[must_use]
    pub fn new(system: &'a S, span: (f64, f64), starts: &[SVector<f64, N>], error: f64) -> Self {
        Self {
            motion: Motion {
                system,
                span,
                scale: 1.0,
                cancel: None,
            },
            starts: starts.to_vec(),
            error,
            candidates: Vec::new(),
        }
    }

    /// Sets the size of a component of the state, in its unit, below which its error is relative to this size. Absolute
    /// tolerances are the relative ones times this size.
    #[must_use]
    pub fn scale(mut self, scale: f64) -> Self {
        self.motion.scale = scale;
        self
    }

    /// Ends the search with [`TuneError::Cancelled`] when `cancel` returns true, which is asked at each step.
    #[must_use]
    pub fn cancel(mut self, cancel: &'a (dyn Fn() -> bool + Sync)) -> Self {
        self.motion.cancel = Some(cancel);
        self
    }

    /// Adds [`Tsit5`], [`Vern7`], [`Vern9`], [`Rk45`] and [`Rk4`].
    #[must_use]
    pub fn explicit(self) -> Self {
        self.adaptive("Vern9", Vern9::new())
            .adaptive("Vern7", Vern7::new())
            .adaptive("Tsit5", Tsit5::new())
            .adaptive("Rk45", Rk45::new())
            .fixed("Rk4", Rk4::new(1.0))
    }

    /// Adds [`Radau5`], [`Radau9`], [`Radau13`], [`Rodas4`], [`Rodas5P`] and [`Auto`].
    #[must_use]
    pub fn implicit(self) -> Self
    where
        S: Jacobian<f64, N>,
    {
        self.adaptive("Radau13", Radau13::new())
            .adaptive("Radau9", Radau9::new())
            .adaptive("Radau5", Radau5::new())
            .adaptive("Rodas5P", Rodas5P::new())
            .adaptive("Rodas4", Rodas4::new())
            .adaptive("Auto", Auto::new())
    }

    /// Adds [`Taylor`].
    #[must_use]
    pub fn series(self) -> Self
    where
        S: TaylorSeries<f64, N>,
    {
        self.adaptive("Taylor", Taylor::new())
    }

    /// Adds [`Gauss4`], [`Gauss6`] and [`Gauss16`].
    #[must_use]
    pub fn canonical(self) -> Self
    where
        S: Canonical<f64, N>,
    {
        self.fixed("Gauss16", Gauss16::new(1.0))
            .fixed("Gauss6", Gauss6::new(1.0))
            .fixed("Gauss4", Gauss4::new(1.0))
    }

    /// Adds an adaptive method, whose tolerances will be set; its other settings remain, such as a maximum step.
    #[must_use]
    pub fn adaptive<F>(mut self, name: &'static str, method: Adaptive<F>) -> Self
    where
        F: OneStep<S, f64, N> + Estimates + Copy + 'a,
    {
        self.candidates.push(Candidate::adaptive(name, method));
        self
    }

    /// Adds a method with fixed steps, whose length will be set.
    #[must_use]
    pub fn fixed<F>(mut self, name: &'static str, method: Fixed<F>) -> Self
    where
        F: OneStep<S, f64, N> + Copy + 'a,
    {
        self.candidates.push(Candidate::fixed(name, method));
        self
    }

    /// Chooses the method and its setting.
    ///
    /// # Errors
    /// [`TuneError::InvalidInput`] if there are no starts or fewer than two adaptive methods, or if a time, a start,
    /// the error or the scale is out of range; [`TuneError::TooFewSucceeded`] if fewer than two reach the end;
    /// [`TuneError::BelowUncertainty`] and [`TuneError::NotReached`] if the error is too small.
    pub fn run(self) -> Result<Tuned<'a, S, N>, TuneError> {
        let pilot = Pilot::new(&self.motion, &self.candidates, &self.starts, self.error)?;
        let (found, dropped) = pilot.search()?;
        let ((chosen, Tried { value, .. }), scale) = (found[0], self.motion.scale);
        let alternatives = found
            .iter()
            .map(|found| Alternative::of(found, &self.candidates, scale));
        let names = |n: usize| self.candidates[n].name;
        Ok(Tuned {
            alternatives: alternatives.collect(),
            dropped: dropped.into_iter().map(|(n, why)| (names(n), why)).collect(),
            value,
            method: self.candidates.into_iter().nth(chosen).expect("one of them"),
            motion: self.motion,
        })
    }
}

/// The method chosen by [`tune`]. Printed as a table of all methods that keep within the error, the fastest one first.
pub struct Tuned<'a, S, const N: usize> {
    /// Methods that keep within the error, the fastest and chosen one first.
    pub alternatives: Vec<Alternative>,
    /// Methods that are slower, or do not reach the error or the end, with the reason.
    pub dropped: Vec<(&'static str, String)>,
    motion: Motion<'a, S>,
    method: Candidate<'a, S, N>,
    value: f64,
}

/// A method that keeps within the error. Printed as code: `Vern9::new().rtol(2e-9).atol(2e-9)`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Alternative {
    /// Name of the method.
    pub name: &'static str,
    /// Its setting.
    pub setting: Setting,
    /// Largest relative error at the end of the pilot runs.
    pub error: f64,
    /// Evaluations of the right-hand side for a trajectory, on average.
    pub evaluations: f64,
    /// Time for a trajectory, on average, without a record, in seconds.
    pub time: f64,
}

impl<S: System<f64, N>, const N: usize> Tuned<'_, S, N> {
    /// The chosen method.
    #[must_use]
    pub fn chosen(&self) -> &Alternative {
        &self.alternatives[0]
    }

    /// Integrates over the span from another start, and returns only the final state.
    ///
    /// # Errors
    /// See [`Stepper::run`](crate::Stepper::run).
    pub fn run(&self, x0: impl IntoState<f64, N>) -> Result<SVector<f64, N>, Failure> {
        let run = self.method.run(&self.motion, self.value, usize::MAX, x0.into_state());
        run.map(|finished| finished.end)
    }

    /// Integrates over the span from another start, by the chosen method.
    ///
    /// # Errors
    /// See [`Method::solve`](crate::Method::solve).
    pub fn solve(&self, x0: impl IntoState<f64, N>) -> Result<Solution<f64, N>, SolveError<f64, N>> {
        self.method.solve(&self.motion, self.value, x0.into_state())
    }
}

impl Alternative {
    fn of<S: System<f64, N>, const N: usize>(
        (candidate, kept): &Found,
        candidates: &[Candidate<'_, S, N>],
        scale: f64,
    ) -> Self {
        let candidate = &candidates[*candidate];
        Self {
            name: candidate.name,
            setting: candidate.setting(kept.value, scale),
            error: kept.error,
            evaluations: kept.evaluations,
            time: kept.time,
        }
    }
}

impl fmt::Display for Alternative {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.setting {
            Setting::Tolerance { rtol, atol } => write!(f, "{}::new().rtol({rtol:e}).atol({atol:e})", self.name),
            Setting::Step(h) => write!(f, "{}::new({h:?})", self.name),
        }
    }
}

impl<S, const N: usize> fmt::Display for Tuned<'_, S, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self
            .alternatives
            .iter()
            .map(|of| of.to_string().len())
            .fold(6, usize::max);
        write!(
            f,
            "{:<width$}  {:>8} {:>11} {:>9}",
            "method", "error", "evaluations", "us"
        )?;
        for of in &self.alternatives {
            let (error, evaluations, time) = (of.error, of.evaluations, 1e6 * of.time);
            write!(
                f,
                "\n{:<width$}  {error:>8.1e} {evaluations:>11.0} {time:>9.1}",
                of.to_string()
            )?;
        }
        for (name, why) in &self.dropped {
            write!(f, "\n{name:<width$}  {why}")?;
        }
        Ok(())
    }
}

impl<S, const N: usize> fmt::Debug for Tuned<'_, S, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tuned")
            .field("alternatives", &self.alternatives)
            .field("dropped", &self.dropped)
            .finish_non_exhaustive()
    }
}

impl<S, const N: usize> fmt::Debug for Tuning<'_, S, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.candidates.iter().map(|candidate| candidate.name);
        f.debug_struct("Tuning")
            .field("span", &self.motion.span)
            .field("starts", &self.starts.len())
            .field("error", &self.error)
            .field("scale", &self.motion.scale)
            .field("methods", &names.collect::<Vec<_>>())
            .finish()
    }
}
