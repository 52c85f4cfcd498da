//! The engine of all methods: steps without a record and without heap allocation.

#[cfg(feature = "std")]
mod events;
mod switching;

use core::fmt;

use nalgebra::SVector;

use crate::dense::{Dense, Step};
use crate::error::Reason;
use crate::hybrid::{self, Ambiguity, InMode, MAX_CONSTRAINTS, Mode, Modes};
use crate::method::input::{place, require};
use crate::method::scheme::Scheme;
use crate::method::smooth::{Smooth, Steps};
#[cfg(feature = "std")]
use crate::method::step_control::{Pace, StepControl};
use crate::real::Float;
use crate::statistics::Statistics;
use crate::system::System;

/// An integration in progress, one accepted step at a time, without heap allocation.
///
/// Created by [`Method::stepper`](crate::Method::stepper); `C` is the scheme of the method. After an error it stays at
/// the last good point.
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
    smooth: Smooth<C, T, N>,
    modes: Modes<T, N>,
}

/// A trajectory within a tolerance, between two steps.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress<T, const N: usize> {
    pub(crate) t: T,
    pub(crate) x: SVector<T, N>,
    pub(crate) pace: Pace<T>,
    /// Number of steps so far, including rejected ones.
    pub(crate) steps: usize,
    pub(crate) modes: Modes<T, N>,
}

impl<'s, C, S, T, const N: usize> Stepper<'s, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Creates a stepper at its start.
    pub(super) fn new(
        system: &'s S,
        scheme: C,
        (t0, t1): (T, T),
        x0: SVector<T, N>,
        steps: Steps<T>,
    ) -> Result<Self, Reason> {
        let x0 = place(system, t0, &x0)?;
        let mut stepper = Self {
            system,
            smooth: Smooth::at(scheme, (t0, t1), x0, steps),
            modes: Modes::none(t0),
        };
        if let Some(hybrid) = system.hybrid() {
            let rule = "a hybrid system can only be integrated forward in time: a state at rest has no unique past";
            require(t0 <= t1, "t1", t1.to_f64(), rule)?;
            let pass = |passage: &_| stepper.smooth.scheme.pass(system, passage);
            let (t, settled) = hybrid::start((hybrid, system.layout()), t0, &x0, pass)?;
            stepper.enter(t, settled);
        }
        if t0 != t1 {
            let slope = stepper.begin()?;
            let system = InMode::new(system, &stepper.modes.hold);
            stepper.smooth.choose_first_step(&system, &slope);
        }
        Ok(stepper)
    }

    /// Time reached.
    #[must_use]
    #[inline]
    pub fn t(&self) -> T {
        self.smooth.last.t1
    }

    /// Length of the next attempt, without its sign.
    #[must_use]
    pub fn h(&self) -> T {
        match &self.smooth.steps {
            Steps::Equal(grid) => grid.h(),
            Steps::Controlled { pace, .. } => pace.h,
        }
    }

    /// State reached.
    #[must_use]
    #[inline]
    pub fn x(&self) -> SVector<T, N> {
        self.smooth.last.x1
    }

    /// Mode of a [hybrid](crate::hybrid) system, and the time at which it began; `None` for other systems.
    ///
    /// The last step ends where a mode ends. The next one starts in another mode, and after an impact from another
    /// state.
    #[must_use]
    pub fn mode(&self) -> Option<(T, Mode)> {
        self.system.hybrid().map(|_| (self.modes.from, self.modes.mode))
    }

    /// Impulses along the constraints of a [hybrid](crate::hybrid) system at the beginning of its mode, in N s or N m
    /// s; `None` if it began without an impact, and for other systems.
    #[must_use]
    pub fn impulses(&self) -> Option<[T; MAX_CONSTRAINTS]> {
        let impulses = self.system.hybrid().map(|_| self.modes.impulses);
        impulses.filter(|impulses| impulses.iter().any(|&impulse| impulse != T::default()))
    }

    /// Impacts at the beginning of the mode of a [hybrid](crate::hybrid) system, if their order affects the motion
    /// afterwards but could not be resolved. [`Statistics::ambiguities`] counts them.
    #[must_use]
    pub fn ambiguity(&self) -> Option<Ambiguity<T>> {
        self.modes.ambiguity
    }

    /// Work so far.
    #[must_use]
    #[inline]
    pub fn statistics(&self) -> Statistics {
        self.smooth.statistics
    }

    /// Takes one step and returns it, or `None` if the end is reached.
    ///
    /// The last step ends exactly at the end of the span.
    ///
    /// # Errors
    /// [`Reason::NonFinite`] and, from implicit methods, [`Reason::NoConvergence`]; if the method chooses its steps,
    /// [`Reason::StepUnderflow`] and [`Reason::TooManySteps`].
    #[inline]
    pub fn step(&mut self) -> Result<Option<Step<T, N>>, Reason> {
        if self.t() == self.smooth.t1 {
            return Ok(None);
        }
        if self.system.hybrid().is_some() && !self.modes.fired.is_empty() {
            self.change_mode()?;
        }
        self.smooth.step(self.system, &self.modes)?;
        self.look_for_the_end_of_the_mode()
            .inspect_err(|_| self.smooth.last = Step::at_rest(self.smooth.last.t0, self.smooth.last.x0))?;
        Ok(Some(self.smooth.last))
    }

    /// Dense output of the last step. Some methods evaluate the right-hand side a few more times for it. Before the
    /// first step, and after a failed one, it is the point reached.
    pub fn dense(&mut self) -> Dense<'_, T, N> {
        let Step { t0, t1, .. } = self.smooth.last;
        // in a hybrid system the search for the end of the mode has computed it
        if t0 != t1 && self.system.hybrid().is_none() {
            self.smooth.find_dense(self.system, &self.modes.hold);
        }
        self.known_dense()
    }

    /// Dense output of the last step, once [`dense`](Self::dense) has computed it.
    pub(super) fn known_dense(&self) -> Dense<'_, T, N> {
        let (last, coefficients) = (self.smooth.last, self.smooth.scheme.coefficients());
        if last.t0 == last.t1 {
            Dense::new(last, &[])
        } else if self.system.hybrid().is_some() {
            Dense::cut_off(last, coefficients, self.modes.cut)
        } else {
            Dense::new(last, coefficients)
        }
    }

    /// Integrates to the end, and returns the state there.
    ///
    /// # Errors
    /// Errors of [`step`](Self::step).
    #[inline]
    pub fn run(&mut self) -> Result<SVector<T, N>, Reason> {
        while self.step()?.is_some() {}
        Ok(self.x())
    }

    /// Continues from the state `x` at the time `t`, after a reset or for another try.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if `t` does not lie between the start of the last step and the end of the span, or if
    /// the state is not finite; [`Reason::NonFinite`] if its derivative is not finite. The stepper then remains
    /// unchanged.
    pub fn restart(&mut self, t: T, x: SVector<T, N>) -> Result<(), Reason> {
        let (from, to) = (
            self.smooth.last.t0.min(self.smooth.t1),
            self.smooth.last.t0.max(self.smooth.t1),
        );
        let rule = "the time must lie between the start of the last step and the end";
        require(from <= t && t <= to, "t", t.to_f64(), rule)?;
        let x = place(self.system, t, &x)?;
        let settled = self
            .system
            .hybrid()
            .map(|hybrid| hybrid::start((hybrid, self.system.layout()), t, &x, |_| {}))
            .transpose()?;
        let (before, steps, modes) = ((self.t(), self.x()), self.smooth.steps, self.modes);
        match settled {
            Some((t, settled)) => {
                self.enter(t, settled);
                self.modes.changes = (0, t);
            }
            None => self.smooth.last = Step::at_rest(t, x),
        }
        self.smooth.go_to(t);
        if t == self.smooth.t1 {
            return Ok(());
        }
        self.begin().map(drop).inspect_err(|_| {
            // the scheme moved to the new point, and its last step is lost
            self.smooth.last = Step::at_rest(before.0, before.1);
            (self.smooth.steps, self.modes) = (steps, modes);
            _ = self.begin();
        })
    }

    /// Moves the end of the span to `t1`, ahead of the point reached, where the stepper then [begins](Self::begin_anew)
    /// or [runs](Self::run_anew) anew with steps as long as before. The number of steps is counted anew.
    #[inline]
    pub(crate) fn move_end(&mut self, t1: T) -> Result<(), Reason> {
        if let Steps::Equal(grid) = &mut self.smooth.steps {
            grid.go_on_to(self.smooth.last.t1, t1)?;
        }
        self.smooth.t1 = t1;
        self.smooth.before = self.smooth.statistics.accepted + self.smooth.statistics.rejected;
        Ok(())
    }

    /// True before the first step, and after a restart.
    #[cfg(feature = "std")]
    pub(crate) fn is_at_rest(&self) -> bool {
        self.smooth.last.t0 == self.smooth.last.t1
    }

    /// Begins anew where the right-hand side has changed. If it `jumps`, a hybrid system enters the mode that follows.
    pub(crate) fn begin_anew(&mut self, jumps: bool) -> Result<(), Reason> {
        if self.system.hybrid().is_none() {
            let begun = self.begin();
            self.smooth.begun_anew(begun)?;
        } else if jumps {
            self.restart(self.t(), self.x())?;
        }
        Ok(())
    }

    /// [Begins anew](Self::begin_anew), and integrates to the end.
    #[inline]
    pub(crate) fn run_anew(&mut self, jumps: bool) -> Result<(), Reason> {
        if self.system.hybrid().is_none() {
            self.smooth.step_anew(self.system, &self.modes)?;
        } else {
            self.begin_anew(jumps)?;
        }
        self.run().map(drop)
    }

    /// Keeps the length of steps that the end of the span cuts short, for an integration that
    /// [goes on](Self::move_end) after it.
    #[inline]
    pub(crate) fn keep_pace(&mut self) {
        if let Steps::Controlled { control, .. } = &mut self.smooth.steps {
            control.keeps_pace = true;
        }
    }

    /// Sets whether steps may leave out the derivative at the end of the span. The dense output of the last one is then
    /// not available.
    #[inline]
    pub(crate) fn leave_end(&mut self, leaves: bool) {
        self.smooth.leaves_end = leaves && self.system.hybrid().is_none();
    }

    /// The system.
    #[cfg(feature = "std")]
    pub(super) fn system(&self) -> &'s S {
        self.system
    }

    /// Evaluates and returns the derivative at the point reached.
    pub(super) fn begin(&mut self) -> Result<SVector<T, N>, Reason> {
        self.smooth.begin(self.system, &self.modes.hold)
    }
}

/// Suspension of a trajectory, for engines that resume it later.
#[cfg(feature = "std")]
impl<'s, C, S, T, const N: usize> Stepper<'s, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Creates a stepper within a tolerance that continues the trajectory of another one.
    pub(crate) fn resume(
        system: &'s S,
        scheme: C,
        t1: T,
        control: StepControl<T>,
        progress: &Progress<T, N>,
    ) -> Result<Self, Reason> {
        let pace = progress.pace;
        let steps = Steps::Controlled { control, pace };
        let mut smooth = Smooth::at(scheme, (progress.t, t1), progress.x, steps);
        smooth.statistics.accepted = progress.steps;
        let mut stepper = Self {
            system,
            smooth,
            modes: progress.modes,
        };
        stepper.begin()?;
        Ok(stepper)
    }

    /// Progress between two steps; `None` for steps of fixed length.
    pub(crate) fn progress(&self) -> Option<Progress<T, N>> {
        let Steps::Controlled { pace, .. } = self.smooth.steps else {
            return None;
        };
        Some(Progress {
            t: self.t(),
            x: self.x(),
            pace,
            steps: self.smooth.statistics.accepted + self.smooth.statistics.rejected,
            modes: self.modes,
        })
    }

    /// True if nothing is held and all witnesses of the mode have been positive: see `ModeWatch::is_settled`.
    pub(crate) fn is_settled(&self) -> bool {
        let Modes { hold, watch, .. } = &self.modes;
        hold.held == 0 && self.system.hybrid().is_some() && watch.is_settled()
    }

    /// Takes one step, and switches the mode at once if it ends before the end of the span.
    pub(crate) fn step_to_a_mode(&mut self) -> Result<(), Reason> {
        self.step()?;
        if self.t() != self.smooth.t1 && !self.modes.fired.is_empty() {
            self.change_mode()?;
        }
        Ok(())
    }
}

/// Access for engines that record the steps.
#[cfg(feature = "std")]
impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    S: ?Sized,
    T: Float,
{
    /// Checks that the number of points fits into a solution. Methods that choose their steps have their own limit.
    pub(super) fn check_to_keep(&self) -> Result<(), Reason> {
        match &self.smooth.steps {
            Steps::Equal(grid) => grid.check_to_keep(),
            Steps::Controlled { .. } => Ok(()),
        }
    }

    /// Moves the end of the span of a method that chooses its steps. Those of fixed length remain on their grid.
    pub(crate) fn stop_at(&mut self, t1: T) {
        if let Steps::Controlled { .. } = self.smooth.steps {
            self.smooth.t1 = t1;
        }
    }

    /// End of the span.
    pub(crate) fn t1(&self) -> T {
        self.smooth.t1
    }

    /// The scheme, for code specific to it.
    pub(crate) fn scheme_mut(&mut self) -> &mut C {
        &mut self.smooth.scheme
    }
}

impl<C, S, T, const N: usize> fmt::Debug for Stepper<'_, C, S, T, N>
where
    S: ?Sized,
    T: Float,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stepper")
            .field("t", &self.smooth.last.t1)
            .field("x", &self.smooth.last.x1)
            .field("t1", &self.smooth.t1)
            .field("statistics", &self.smooth.statistics)
            .finish_non_exhaustive()
    }
}
