//! The engine of single steps of a smooth system: time, state, step size, failure.

use core::mem;

use nalgebra::SVector;

use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode, Modes};
use crate::method::grid::Grid;
use crate::method::jump;
use crate::method::scheme::{Accepted, NonFinite, Scheme, StepFailure};
use crate::method::step_control::{Pace, StepControl, is_within_tolerance};
use crate::method::toggle;
use crate::real::Float;
use crate::real::lanes::{Isa, Routine};
use crate::statistics::Statistics;
use crate::system::System;

/// Choice of the step lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Steps<T> {
    /// From one time of a grid to the next.
    Equal(Grid<T>),
    /// Adaptive steps within a tolerance.
    Controlled { control: StepControl<T>, pace: Pace<T> },
}

impl<T: Float> Steps<T> {
    pub(crate) fn controlled(control: StepControl<T>) -> Self {
        let pace = control.start();
        Self::Controlled { control, pace }
    }
}

/// An integration of smooth equations, one accepted step at a time.
#[derive(Clone)]
pub(super) struct Smooth<C, T, const N: usize> {
    pub(super) scheme: C,
    pub(super) steps: Steps<T>,
    /// End of the span.
    pub(super) t1: T,
    /// Last accepted step; of zero length if there is none.
    pub(super) last: Step<T, N>,
    /// State at the end of the last attempt.
    tried: SVector<T, N>,
    /// Number of steps before the end was moved last: these do not count towards the maximum.
    pub(super) before: usize,
    /// True if nothing needs the derivative at the end of the span: the right-hand side may jump there.
    pub(super) leaves_end: bool,
    pub(super) statistics: Statistics,
}

impl<C, T: Float, const N: usize> Smooth<C, T, N> {
    pub(super) fn at(scheme: C, (t, t1): (T, T), x: SVector<T, N>, steps: Steps<T>) -> Self {
        Self {
            scheme,
            steps,
            t1,
            last: Step::at_rest(t, x),
            tried: x,
            before: 0,
            leaves_end: false,
            statistics: Statistics::default(),
        }
    }

    #[inline]
    pub(super) fn t(&self) -> T {
        self.last.t1
    }

    #[inline]
    pub(super) fn x(&self) -> SVector<T, N> {
        self.last.x1
    }

    /// Moves the grid, if there is one, to the time `t`.
    pub(super) fn go_to(&mut self, t: T) {
        if let Steps::Equal(grid) = &mut self.steps {
            grid.go_to(t);
        }
    }

    /// Evaluates and returns the derivative at the point reached.
    pub(super) fn begin<S>(&mut self, system: &S, hold: &Hold<T>) -> Result<SVector<T, N>, Reason>
    where
        C: Scheme<S, T, N>,
        S: ?Sized,
    {
        Isa::run_routine(Begin(hold), self, system)
    }

    /// Adds the length of the last step to the failure to begin at its end.
    #[inline]
    pub(super) fn begun_anew(&self, begun: Result<SVector<T, N>, Reason>) -> Result<(), Reason> {
        let h = self.last.h.to_f64();
        begun.map(drop).map_err(|reason| NonFinite::after(reason, h))
    }

    /// Computes the dense output of the last step.
    pub(super) fn find_dense<S>(&mut self, system: &S, hold: &Hold<T>)
    where
        C: Scheme<S, T, N>,
        S: ?Sized,
    {
        Isa::run_routine(FindDense(hold), self, system);
    }

    /// Chooses the first step, given the derivative at its start.
    pub(super) fn choose_first_step<S>(&mut self, system: &InMode<'_, S, T>, slope: &SVector<T, N>)
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        if let Steps::Controlled { control, pace } = &mut self.steps
            && !C::PROPOSES
            && let Some(h) = control.first_step(system, (self.last.t1, &self.last.x1, slope), self.t1)
        {
            pace.h = h;
            self.statistics.evaluations += 1;
        }
    }

    /// Takes one step.
    #[inline]
    pub(super) fn step<S>(&mut self, system: &S, modes: &Modes<T, N>) -> Result<(), Reason>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        Isa::run_routine(TakeStep(modes), self, system)
    }

    /// Begins anew where the right-hand side has changed, and takes one step, in one routine.
    #[inline]
    pub(super) fn step_anew<S>(&mut self, system: &S, modes: &Modes<T, N>) -> Result<(), Reason>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        Isa::run_routine(StepAnew(modes), self, system)
    }

    /// Takes one step to the time `t`, whatever its error, from a point where it has begun. It is not counted, and runs
    /// as one on a grid, so that an attempt is not compiled once more.
    pub(super) fn step_to<S>(&mut self, system: &S, modes: &Modes<T, N>, t: T) -> Result<(), Reason>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let Statistics { accepted, rejected, .. } = self.statistics;
        let grid = Grid::of_one_step(self.t(), t);
        let steps = mem::replace(&mut self.steps, Steps::Equal(grid));
        let outcome = self.step(system, modes);
        self.steps = steps;
        (self.statistics.accepted, self.statistics.rejected) = (accepted, rejected);
        outcome
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn step_on_grid<S>(&mut self, model: (&S, &Modes<T, N>), mut grid: Grid<T>) -> Result<(), Reason>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let t_new = grid.next();
        match self.attempt_and_advance(model, t_new, |_| true) {
            Ok(_) => {
                self.steps = Steps::Equal(grid);
                Ok(())
            }
            Err(failure) => {
                self.statistics.rejected += 1;
                Err(failure.reason((t_new - self.t()).to_f64()))
            }
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn step_within_tolerance<S>(
        &mut self,
        model: (&S, &Modes<T, N>),
        control: &StepControl<T>,
        mut pace: Pace<T>,
    ) -> Result<(), Reason>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let t = self.t();
        let system = InMode::new(model.0, &model.1.hold);
        let mut proposed = self.scheme.prepare(&system, t, &self.last.x1, &mut self.statistics);
        loop {
            let steps = self.statistics.accepted + self.statistics.rejected - self.before;
            let t_new = control.plan(&mut pace.h, (t, self.t1), steps, proposed.take())?;
            let outcome = self.attempt_and_advance(model, t_new, is_within_tolerance);
            let failure = outcome.err();
            pace.set_order(self.scheme.error_order());
            let kept = self.scheme.keeps_length();
            let verdict = control.judge(&mut pace, (t, t_new), outcome, C::PROPOSES, kept);
            if let Ok(true) = verdict {
                if let Steps::Controlled { pace: before, .. } = &mut self.steps {
                    *before = pace;
                }
                return Ok(());
            }
            self.statistics.rejected += 1;
            verdict?;
            if let Some(failure) = failure.filter(|_| toggle::creeps(pace.h, t)) {
                toggle::reached(failure, model.0, (t, t_new), &self.last.x1)?;
            }
        }
    }

    /// Attempts a step to `t_new`, accepts it if `is_good` holds for the mean square of its error, and returns that.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt_and_advance<S>(
        &mut self,
        model: (&S, &Modes<T, N>),
        t_new: T,
        is_good: impl Fn(T) -> bool,
    ) -> Result<T, StepFailure>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let mean_square = self.attempt(model, t_new)?;
        if is_good(mean_square) {
            self.advance(model, t_new)?;
        }
        Ok(mean_square)
    }

    /// Attempts a step to `t_new`, and returns the mean square of its error. Fails if the state is not finite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt<S>(&mut self, (system, modes): (&S, &Modes<T, N>), t_new: T) -> Result<T, StepFailure>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let (start, end) = ((self.last.t1, &self.last.x1), (t_new, &mut self.tried));
        let in_mode = InMode::new(system, &modes.hold);
        let mean_square = self.scheme.attempt(&in_mode, start, end, &mut self.statistics)?;
        NonFinite::check(&self.tried)?;
        modes.place(system, t_new, &mut self.tried);
        Ok(mean_square)
    }

    /// Turns the last attempt into the last step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn advance<S>(&mut self, (system, modes): (&S, &Modes<T, N>), t_new: T) -> Result<(), StepFailure>
    where
        C: Scheme<S, T, N>,
        S: ?Sized,
    {
        let end = (t_new, &self.tried);
        let system = InMode::new(system, &modes.hold);
        let leaves = const { C::LEAVES_END } && self.leaves_end && t_new == self.t1;
        if !leaves && let Some(slope) = self.scheme.arrive(&system, end, &mut self.statistics) {
            NonFinite::check(slope)?;
        }
        self.last.go_on((t_new, &self.tried));
        self.scheme
            .accept(&system, &self.last, Accepted::All, &mut self.statistics);
        Ok(())
    }
}

/// Evaluation of the derivative at the point reached.
struct Begin<'a, T>(&'a Hold<T>);

impl<C, S, T, const N: usize> Routine<Smooth<C, T, N>, S> for Begin<'_, T>
where
    C: Scheme<S, T, N>,
    S: ?Sized,
    T: Float,
{
    type Output = Result<SVector<T, N>, Reason>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, smooth: &mut Smooth<C, T, N>, system: &S) -> Self::Output {
        let (t, x, system) = (smooth.t(), smooth.x(), InMode::new(system, self.0));
        let slope = smooth.scheme.begin(&system, t, &x, &mut smooth.statistics);
        NonFinite::check(&slope).map_err(NonFinite::at_start)?;
        Ok(slope)
    }
}

/// Computation of the dense output of the last step.
struct FindDense<'a, T>(&'a Hold<T>);

impl<C, S, T, const N: usize> Routine<Smooth<C, T, N>, S> for FindDense<'_, T>
where
    C: Scheme<S, T, N>,
    S: ?Sized,
    T: Float,
{
    type Output = ();

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, smooth: &mut Smooth<C, T, N>, system: &S) {
        let system = InMode::new(system, self.0);
        smooth.scheme.dense(&system, &smooth.last, &mut smooth.statistics);
    }
}

/// One step.
struct TakeStep<'a, T, const N: usize>(&'a Modes<T, N>);

impl<C, S, T, const N: usize> Routine<Smooth<C, T, N>, S> for TakeStep<'_, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    type Output = Result<(), Reason>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, smooth: &mut Smooth<C, T, N>, system: &S) -> Self::Output {
        let modes = self.0;
        match smooth.steps {
            Steps::Equal(grid) => smooth.step_on_grid((system, modes), grid),
            Steps::Controlled { control, pace } => smooth.step_within_tolerance((system, modes), &control, pace),
        }
        .map_err(|reason| {
            smooth.last = Step::at_rest(smooth.t(), smooth.x());
            let reason = toggle::behind(reason, system, smooth.t(), &smooth.x());
            jump::behind(reason, system, smooth.t(), &smooth.x())
        })?;
        smooth.statistics.accepted += 1;
        Ok(())
    }
}

/// One step from a point where the right-hand side has changed.
struct StepAnew<'a, T, const N: usize>(&'a Modes<T, N>);

impl<C, S, T, const N: usize> Routine<Smooth<C, T, N>, S> for StepAnew<'_, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    type Output = Result<(), Reason>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, smooth: &mut Smooth<C, T, N>, system: &S) -> Self::Output {
        let begun = Begin(&self.0.hold).run(smooth, system);
        smooth.begun_anew(begun)?;
        TakeStep(self.0).run(smooth, system)
    }
}
