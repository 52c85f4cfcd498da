//! The engine of all methods: stepping without a record, and without a heap.

use core::fmt;

use nalgebra::SVector;

use crate::control::Tolerance;
use crate::dense::{Dense, Step};
use crate::error::Reason;
use crate::hybrid::{self, Ambiguity, Fired, Hold, InMode, MOST, Mode, Settled, Watch};
use crate::method::grid::Grid;
use crate::method::input::{place, require};
use crate::method::scheme::{Accepted, Failure, NonFinite, Scheme, Stalled};
use crate::method::step_control::{Pace, StepControl, is_within_tolerance};
use crate::method::toggle;
use crate::real::Float;
use crate::statistics::Statistics;
use crate::system::System;

/// An integration in progress, one accepted step at a time, without a heap.
///
/// Made by [`Method::stepper`](crate::Method::stepper); `C` is the scheme of the method. After an error it stays at the
/// last good point.
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
    steps: Steps<T>,
    /// Where it ends.
    t1: T,
    /// The last accepted step; of no length where there is none.
    last: Step<T, N>,
    /// Where the last attempt arrived.
    tried: SVector<T, N>,
    modes: Modes<T>,
    statistics: Statistics,
}

/// The mode of a hybrid system; of no meaning for others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Modes<T> {
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// From when on it holds.
    from: T,
    /// The impulses along the constraints with which it began.
    impulses: [T; MOST],
    /// The impacts among these whose order is not known.
    ambiguity: Option<Ambiguity<T>>,
    pub(crate) watch: Watch<T>,
    /// What ended it, where the last step ended.
    fired: Fired,
    /// Of the last step, the fraction of what was integrated: less than one where a mode ended.
    cut: T,
    /// Whether the dense output of the last step is known.
    is_dense: bool,
    /// How often modes have changed since some time, and that time.
    changes: (usize, T),
}

/// A trajectory within a tolerance, between two steps.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress<T, const N: usize> {
    pub(crate) t: T,
    pub(crate) x: SVector<T, N>,
    pub(crate) pace: Pace<T>,
    /// The steps so far, rejected ones included.
    pub(crate) steps: usize,
    pub(crate) modes: Modes<T>,
}

/// So many changes of modes are too many if they take, on average, no longer than the times below: the rebounds of a
/// ball are no longer followed before they are so short.
const MANY_CHANGES: usize = 1000;
/// This part of a fixed step, or else of all the time that remains.
const HURRIED_OF_STEP: f64 = 1e-7;
const HURRIED_OF_REST: f64 = 1e-13;
/// So many ulps of the time.
const HURRIED_ULPS: f64 = 4.0;
/// Steps to the end of a mode that are shorter than so many ulps of the time are not taken again.
const SHORTEST_ULPS: f64 = 64.0;
/// The end of a mode this part of a step before its end takes another, shorter step.
const FAR_FROM_THE_END: f64 = 1e-3;
/// But no more than so many: where ends lie so close together that each step shows another one first.
const MOST_RETAKEN: usize = 16;
/// An order of impacts matters if it makes a difference of more than this many tolerances.
const LEAST_AMBIGUITY: f64 = 10.0;

/// How long the steps are.
#[derive(Clone, Copy, Debug)]
pub(super) enum Steps<T> {
    /// From one time of a grid to the next.
    Equal(Grid<T>),
    /// As long as the tolerance allows.
    Controlled { control: StepControl<T>, pace: Pace<T> },
}

impl<T: Float> Steps<T> {
    pub(super) fn controlled(control: StepControl<T>) -> Self {
        let pace = control.start();
        Self::Controlled { control, pace }
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
        steps: Steps<T>,
    ) -> Result<Self, Reason> {
        let x0 = place(system, t0, &x0)?;
        let mut stepper = Self {
            system,
            scheme,
            steps,
            t1,
            last: Step::at_rest(t0, x0),
            tried: x0,
            modes: Modes {
                mode: Mode::default(),
                hold: Hold::default(),
                from: t0,
                impulses: [T::default(); MOST],
                ambiguity: None,
                watch: Watch::new(),
                fired: Fired::default(),
                cut: T::from_f64(1.0),
                is_dense: false,
                changes: (0, t0),
            },
            statistics: Statistics::default(),
        };
        if let Some(hybrid) = system.hybrid() {
            let rule = "a hybrid system runs forward: what has come to rest does not tell from where";
            require(t0 <= t1, "t1", t1.to_f64(), rule)?;
            let settled = hybrid::start((hybrid, system.layout()), t0, &x0)?;
            stepper.enter(t0, settled);
        }
        if t0 != t1 {
            let slope = stepper.begin()?;
            let system = InMode::new(system, &stepper.modes.hold);
            if let Steps::Controlled { control, pace } = &mut stepper.steps
                && !C::PROPOSES
                && let Some(h) = control.first_step(&system, (t0, &stepper.last.x1, &slope), t1)
            {
                pace.h = h;
                stepper.statistics.evaluations += 1;
            }
        }
        Ok(stepper)
    }

    /// The time reached.
    #[must_use]
    #[inline]
    pub fn t(&self) -> T {
        self.last.t1
    }

    /// The length of the step that is tried next, without its sign.
    #[must_use]
    pub fn h(&self) -> T {
        match &self.steps {
            Steps::Equal(grid) => grid.h(),
            Steps::Controlled { pace, .. } => pace.h,
        }
    }

    /// The state reached.
    #[must_use]
    #[inline]
    pub fn x(&self) -> SVector<T, N> {
        self.last.x1
    }

    /// The mode of a [hybrid](crate::hybrid) system, and the time from which on it holds; `None` for other systems.
    ///
    /// Where a mode ends, the last step does; the next one starts in another mode, and after an impact in another
    /// state.
    #[must_use]
    pub fn mode(&self) -> Option<(T, Mode)> {
        self.system.hybrid().map(|_| (self.modes.from, self.modes.mode))
    }

    /// The impulses along the constraints of a [hybrid](crate::hybrid) system with which its mode began, in N s or
    /// N m s; `None` where it began without an impact, and for other systems.
    #[must_use]
    pub fn impulses(&self) -> Option<[T; MOST]> {
        let impulses = self.system.hybrid().map(|_| self.modes.impulses);
        impulses.filter(|impulses| impulses.iter().any(|&impulse| impulse != T::default()))
    }

    /// The impacts with which the mode of a [hybrid](crate::hybrid) system began, if their order decided how it goes on
    /// and could not be resolved. [`Statistics::ambiguities`] counts all so far.
    #[must_use]
    pub fn ambiguity(&self) -> Option<Ambiguity<T>> {
        self.modes.ambiguity
    }

    /// The work so far.
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
        if self.system.hybrid().is_some() && !self.modes.fired.is_empty() {
            self.change_mode()?;
        }
        match self.steps {
            Steps::Equal(grid) => self.step_on_grid(grid),
            Steps::Controlled { control, pace } => self.step_within_tolerance(&control, pace),
        }
        .map_err(|reason| {
            self.last = Step::at_rest(self.t(), self.x());
            toggle::behind(reason, self.system, self.t(), &self.x())
        })?;
        self.statistics.accepted += 1;
        self.look_for_the_end_of_the_mode()
            .inspect_err(|_| self.last = Step::at_rest(self.last.t0, self.last.x0))?;
        Ok(Some(self.last))
    }

    /// Cuts the last step of a hybrid system off where its mode ends.
    #[inline(always)]
    fn look_for_the_end_of_the_mode(&mut self) -> Result<(), Reason> {
        let Some(hybrid) = self.system.hybrid() else {
            return Ok(());
        };
        (self.modes.cut, self.modes.is_dense) = (T::from_f64(1.0), false);
        let (dense, modes, work) = self.dense_and_mode();
        let found = modes.watch.look((hybrid, &modes.mode, &modes.hold), &dense, work)?;
        let Some((mut cut, mut fired)) = found else {
            return Ok(());
        };
        let mut t = dense.time(cut);
        // The ends of steps are more exact than what is between them: a step that ends there shows where it is.
        let mut retaken = 0;
        let mut x = loop {
            let is_exact = self.retake(t);
            let (dense, modes, work) = self.dense_and_mode();
            if !is_exact {
                break dense.at_fraction(cut);
            }
            let scene = (hybrid, &modes.mode, &modes.hold);
            let Some((by, first)) = modes.watch.locate(scene, &dense, fired, work) else {
                // and that there is none
                if let Steps::Equal(grid) = &mut self.steps {
                    grid.go_to(t);
                }
                return Ok(());
            };
            (t, cut, fired) = (dense.step().t1 + by * dense.step().h, T::from_f64(1.0) + by, first);
            retaken += 1;
            if by > T::from_f64(-FAR_FROM_THE_END) || retaken == MOST_RETAKEN {
                break dense.about_end(by);
            }
        };
        self.system.project(t, &mut x);
        let modes = &mut self.modes;
        (modes.cut, modes.fired) = (cut, fired);
        if modes.hold.held != 0 {
            hybrid::project(hybrid, &modes.hold, &fired.touching(&modes.mode), t, &mut x);
        }
        self.last = Step::new((self.last.t0, self.last.x0), (t, x));
        Ok(())
    }

    /// The states within the last step, before it is cut off.
    fn dense_and_mode(&mut self) -> (Dense<'_, T, N>, &mut Modes<T>, &mut Statistics) {
        let coefficients = if self.modes.is_dense {
            self.scheme.coefficients()
        } else {
            let system = InMode::new(self.system, &self.modes.hold);
            self.scheme.dense(&system, &self.last, &mut self.statistics)
        };
        self.modes.is_dense = true;
        (
            Dense::new(self.last, coefficients),
            &mut self.modes,
            &mut self.statistics,
        )
    }

    /// Takes the last step again, to the time `t` within it; whether that was possible. If not, it stays as it was.
    fn retake(&mut self, t: T) -> bool {
        let whole = self.last;
        if t == whole.t1 {
            return true;
        }
        if (t - whole.t0).abs() <= T::from_f64(SHORTEST_ULPS) * T::EPSILON * t.abs().max(whole.h.abs()) {
            return false;
        }
        let scheme = self.scheme.clone();
        self.last = Step::at_rest(whole.t0, whole.x0);
        self.scheme.go_back();
        let begun = self.begin().is_ok();
        if begun && self.attempt(t).and_then(|_| self.advance(t)).is_ok() {
            self.modes.is_dense = false;
            return true;
        }
        (self.last, self.scheme) = (whole, scheme);
        false
    }

    /// Goes to the mode after the one that has ended.
    fn change_mode(&mut self) -> Result<(), Reason> {
        let Some(hybrid) = self.system.hybrid() else {
            return Ok(());
        };
        let Modes {
            mode,
            hold,
            fired,
            watch,
            changes: (count, since),
            ..
        } = self.modes;
        let (t, x) = (self.t(), self.x());
        let pass = |passage: &_| self.scheme.pass(self.system, passage);
        let settled = hybrid::switch(hybrid, (t, &x), (&mode, &hold), fired, &watch, pass);
        self.statistics.evaluations += 1;
        if let Some(n) = settled.contradiction() {
            let constraint = hybrid.constraints()[n].name;
            return Err(Reason::ModesAccumulate { constraint });
        }
        let changes = if count < MANY_CHANGES {
            (count + 1, since)
        } else {
            (1, t)
        };
        if count == MANY_CHANGES {
            let shortest = match &self.steps {
                Steps::Equal(grid) => T::from_f64(HURRIED_OF_STEP) * grid.h(),
                Steps::Controlled { .. } => T::from_f64(HURRIED_OF_REST) * (self.t1 - t),
            };
            let resolved = T::from_f64(HURRIED_ULPS) * T::EPSILON * t.abs().max(self.last.h.abs());
            if t - since <= T::from_f64(MANY_CHANGES as f64) * shortest.max(resolved) {
                let constraint = hybrid.constraints()[fired.first()].name;
                return Err(Reason::ModesAccumulate { constraint });
            }
        }
        self.modes.changes = changes;
        if let Steps::Equal(grid) = &mut self.steps {
            grid.go_to(t);
        }
        self.enter(t, settled);
        self.begin().map(drop)
    }

    /// Stands at a point in a mode.
    fn enter(&mut self, t: T, settled: Settled<T, N>) {
        let ambiguity = settled
            .ambiguity()
            .and_then(|found| self.check_ambiguity(t, found, &settled.x));
        self.statistics.ambiguities += usize::from(ambiguity.is_some());
        let Settled {
            x,
            mode,
            hold,
            delay,
            impulses,
            gains,
            sizes,
            ..
        } = settled;
        (self.modes.mode, self.modes.hold, self.modes.from) = (mode, hold, (t + delay).min(self.t1));
        (self.modes.impulses, self.modes.ambiguity) = (impulses, ambiguity);
        self.modes.fired = Fired::default();
        self.modes.watch.restart(&mode, gains, sizes);
        self.last = Step::at_rest(t, x);
    }

    /// The impacts at `t` whose order is not known, from the differences that it makes to the state `x` after them; none
    /// if these are within the tolerance.
    fn check_ambiguity(
        &self,
        t: T,
        (set, differences): (u8, SVector<T, N>),
        x: &SVector<T, N>,
    ) -> Option<Ambiguity<T>> {
        let matters = |difference: T, x: T| match &self.steps {
            Steps::Equal(_) => true,
            Steps::Controlled { control, .. } => {
                let Tolerance { rtol, atol } = control.tolerance;
                difference > T::from_f64(LEAST_AMBIGUITY) * (atol + rtol * x.abs())
            }
        };
        let rates = || differences.iter().zip(x.iter()).skip(N / 2);
        let difference = rates().fold(T::default(), |most, (&difference, _)| most.max(difference));
        let matters = rates().any(|(&difference, &x)| matters(difference, x));
        matters.then_some(Ambiguity { t, difference, set })
    }

    /// The states within the last step, by the dense output of the method. Some methods evaluate the right-hand side a
    /// few more times for it. Before the first step, and after a failed one, it is the point reached.
    pub fn dense(&mut self) -> Dense<'_, T, N> {
        if self.last.t0 == self.last.t1 {
            return Dense::new(self.last, &[]);
        }
        if self.system.hybrid().is_some() {
            // the search for the end of the mode has found it
            return Dense::cut_off(self.last, self.scheme.coefficients(), self.modes.cut);
        }
        let system = InMode::new(self.system, &self.modes.hold);
        let coefficients = self.scheme.dense(&system, &self.last, &mut self.statistics);
        Dense::new(self.last, coefficients)
    }

    /// Integrates to the end, and returns the state there.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    #[inline]
    pub fn run(&mut self) -> Result<SVector<T, N>, Reason> {
        while self.step()?.is_some() {}
        Ok(self.x())
    }

    /// Continues from the state `x` at the time `t`: a reset, or another try.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if `t` does not lie between the start of the last step and the end of the span, or if
    /// the state is not finite; [`Reason::NonFinite`] if its derivative is not. The stepper then stays where it was.
    pub fn restart(&mut self, t: T, x: SVector<T, N>) -> Result<(), Reason> {
        let (from, to) = (self.last.t0.min(self.t1), self.last.t0.max(self.t1));
        let rule = "the time must lie between the start of the last step and the end";
        require(from <= t && t <= to, "t", t.to_f64(), rule)?;
        let x = place(self.system, t, &x)?;
        let settled = self
            .system
            .hybrid()
            .map(|hybrid| hybrid::start((hybrid, self.system.layout()), t, &x))
            .transpose()?;
        let (before, steps, modes) = ((self.t(), self.x()), self.steps, self.modes);
        match settled {
            Some(settled) => {
                self.enter(t, settled);
                self.modes.changes = (0, t);
            }
            None => self.last = Step::at_rest(t, x),
        }
        if let Steps::Equal(grid) = &mut self.steps {
            grid.go_to(t);
        }
        if t == self.t1 {
            return Ok(());
        }
        self.begin().map(drop).inspect_err(|_| {
            // The scheme went to the new point, and its last step is lost.
            self.last = Step::at_rest(before.0, before.1);
            (self.steps, self.modes) = (steps, modes);
            let system = InMode::new(self.system, &self.modes.hold);
            self.scheme.begin(&system, before.0, &before.1, &mut self.statistics);
        })
    }

    /// What moves.
    #[cfg(feature = "std")]
    pub(super) fn system(&self) -> &'s S {
        self.system
    }

    /// Evaluates the point reached: the derivative there.
    fn begin(&mut self) -> Result<SVector<T, N>, Reason> {
        let (t, x) = (self.t(), self.x());
        let system = InMode::new(self.system, &self.modes.hold);
        let slope = self.scheme.begin(&system, t, &x, &mut self.statistics);
        NonFinite::check(&slope).map_err(NonFinite::at_start)?;
        Ok(slope)
    }

    #[inline]
    fn step_on_grid(&mut self, mut grid: Grid<T>) -> Result<(), Reason> {
        let t_new = grid.next();
        match self.attempt(t_new).and_then(|_| self.advance(t_new)) {
            Ok(()) => {
                self.steps = Steps::Equal(grid);
                Ok(())
            }
            Err(failure) => {
                self.statistics.rejected += 1;
                Err(failure.reason((t_new - self.t()).to_f64()))
            }
        }
    }

    #[inline]
    fn step_within_tolerance(&mut self, control: &StepControl<T>, mut pace: Pace<T>) -> Result<(), Reason> {
        let t = self.t();
        let system = InMode::new(self.system, &self.modes.hold);
        let mut proposed = self.scheme.prepare(&system, t, &self.last.x1, &mut self.statistics);
        pace.set_order(self.scheme.error_order());
        loop {
            let steps = self.statistics.accepted + self.statistics.rejected;
            let t_new = control.plan(&mut pace.h, (t, self.t1), steps, proposed.take())?;
            let outcome = self.attempt(t_new).and_then(|mean_square| {
                if is_within_tolerance(mean_square) {
                    self.advance(t_new)?;
                }
                Ok(mean_square)
            });
            let failure = outcome.err();
            let verdict = control.judge(&mut pace, (t, t_new), outcome, C::PROPOSES);
            if let Ok(true) = verdict {
                if let Steps::Controlled { pace: before, .. } = &mut self.steps {
                    *before = pace;
                }
                return Ok(());
            }
            self.statistics.rejected += 1;
            verdict?;
            if let Some(failure) = failure.filter(|_| toggle::creeps(pace.h, t)) {
                toggle::reached(failure, self.system, (t, t_new), &self.last.x1)?;
            }
        }
    }

    /// Tries a step to `t_new`, where it arrives at finite numbers: the mean square of its error.
    #[inline]
    fn attempt(&mut self, t_new: T) -> Result<T, Failure> {
        let (start, end) = ((self.last.t1, &self.last.x1), (t_new, &mut self.tried));
        let system = (self.system, &self.modes.hold);
        let mean_square = attempt(&mut self.scheme, system, start, end, &mut self.statistics)?;
        NonFinite::check(&self.tried)?;
        if let Some(hybrid) = self.system.hybrid()
            && self.modes.hold.held != 0
        {
            hybrid::project(hybrid, &self.modes.hold, &self.modes.mode.0, t_new, &mut self.tried);
        }
        Ok(mean_square)
    }

    /// Makes an attempt the last step.
    #[inline]
    fn advance(&mut self, t_new: T) -> Result<(), Failure> {
        let end = (t_new, &self.tried);
        let system = InMode::new(self.system, &self.modes.hold);
        if let Some(slope) = self.scheme.arrive(&system, end, &mut self.statistics) {
            NonFinite::check(slope)?;
        }
        let step = Step::new((self.last.t1, self.last.x1), (t_new, self.tried));
        self.scheme.accept(&system, &step, Accepted::All, &mut self.statistics);
        self.last = step;
        Ok(())
    }
}

/// For those who set a trajectory aside, and go on with it later.
#[cfg(feature = "std")]
impl<'s, C, S, T, const N: usize> Stepper<'s, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// A stepper within a tolerance that goes on where another one was.
    pub(crate) fn resume(
        system: &'s S,
        scheme: C,
        t1: T,
        control: StepControl<T>,
        progress: &Progress<T, N>,
    ) -> Result<Self, Reason> {
        let mut stepper = Self {
            system,
            scheme,
            steps: Steps::Controlled {
                control,
                pace: progress.pace,
            },
            t1,
            last: Step::at_rest(progress.t, progress.x),
            tried: progress.x,
            modes: progress.modes,
            statistics: Statistics {
                accepted: progress.steps,
                ..Statistics::default()
            },
        };
        stepper.begin()?;
        Ok(stepper)
    }

    /// Where it is, between two steps; only of one within a tolerance.
    pub(crate) fn progress(&self) -> Option<Progress<T, N>> {
        let Steps::Controlled { pace, .. } = self.steps else {
            return None;
        };
        Some(Progress {
            t: self.t(),
            x: self.x(),
            pace,
            steps: self.statistics.accepted + self.statistics.rejected,
            modes: self.modes,
        })
    }

    /// Whether nothing is held, and nothing of the mode is left to find out: see [`Watch::is_settled`].
    pub(crate) fn is_settled(&self) -> bool {
        let Modes { mode, hold, watch, .. } = &self.modes;
        let hybrid = self.system.hybrid().filter(|_| hold.held == 0);
        hybrid.is_some_and(|hybrid| watch.is_settled(&hybrid.laws(), mode))
    }

    /// Takes one step, and goes to the next mode at once where one ends before the end is reached.
    pub(crate) fn step_to_a_mode(&mut self) -> Result<(), Reason> {
        self.step()?;
        if self.t() != self.t1 && !self.modes.fired.is_empty() {
            self.change_mode()?;
        }
        Ok(())
    }
}

/// For those who record the steps.
#[cfg(feature = "std")]
impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    S: ?Sized,
    T: Float,
{
    /// Whether all points can be kept. Methods that choose their steps have a limit of their own.
    pub(super) fn check_to_keep(&self) -> Result<(), Reason> {
        match &self.steps {
            Steps::Equal(grid) => grid.check_to_keep(),
            Steps::Controlled { .. } => Ok(()),
        }
    }

    /// Where it ends.
    pub(super) fn t1(&self) -> T {
        self.t1
    }

    /// The scheme, for code that knows which one it is.
    pub(crate) fn scheme_mut(&mut self) -> &mut C {
        &mut self.scheme
    }
}

/// [`Scheme::attempt`] as a function of its own, so that the compiler knows that what a step writes is not what the
/// system reads.
#[inline(never)]
fn attempt<C, S, T, const N: usize>(
    scheme: &mut C,
    (system, hold): (&S, &Hold<T>),
    start: (T, &SVector<T, N>),
    end: (T, &mut SVector<T, N>),
    work: &mut Statistics,
) -> Result<T, Stalled>
where
    C: Scheme<S, T, N>,
    S: ?Sized,
    T: Float,
{
    scheme.attempt(&InMode::new(system, hold), start, end, work)
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
