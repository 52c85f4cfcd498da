//! Integration of a trajectory to its end, with events and an observer.

use nalgebra::SVector;

use crate::dense::{Dense, Step};
use crate::error::{Reason, SolveError};
use crate::event::{Event, Occurrence};
use crate::hybrid::{Impact, Mode};
use crate::method::Stepper;
use crate::method::input::{of_reset, place};
use crate::method::scheme::Scheme;
use crate::method::search::{Found, Search, What};
use crate::real::{Float, ulps};
use crate::solution::{Need, Observer, Solution};
use crate::step_size::Tolerance;
use crate::system::System;

/// Spacing within which events are simultaneous, in ulps of t. An event that acts twice within it never ends.
const SIMULTANEOUS_ULPS: f64 = 4.0;
/// A kink at less than this fraction of a step from its start leaves a short step.
const SHORT: f64 = 0.01;
/// Number of consecutive kinks, each of which leaves a short step, after which steps no longer end at kinks: an
/// unstable step crosses a limit again and again.
const MOST_CROWDED: usize = 100;

/// Premature end of a trajectory, at the last point that its observer received.
pub struct Early<T, const N: usize> {
    pub(crate) reason: Reason,
    pub(crate) t: T,
    pub(crate) x: SVector<T, N>,
}

impl<T: Float, const N: usize> Early<T, N> {
    /// Attaches a point to a reason.
    pub(crate) fn at((t, x): (T, SVector<T, N>)) -> impl Fn(Reason) -> Self {
        move |reason| Self { reason, t, x }
    }
}

/// Solution of an integration that ended in this way, whose numbers may be of another type.
pub(super) fn concluded<T, U, const N: usize>(
    ended: Result<SVector<T, N>, Early<T, N>>,
    solution: Solution<U, N>,
) -> Result<Solution<U, N>, SolveError<U, N>> {
    match ended {
        Ok(_) => Ok(solution),
        Err(early) => Err(SolveError {
            reason: early.reason,
            solution: Box::new(solution),
        }),
    }
}

impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Integrates to the end from the state `x0`, with events if there are any, and stores the trajectory.
    pub(super) fn collect(
        mut self,
        x0: SVector<T, N>,
        events: &[Event<'_, T, N>],
        tolerance: Option<Tolerance<T>>,
    ) -> Result<Solution<T, N>, SolveError<T, N>> {
        let mut solution = Solution::start(self.t(), self.start(x0));
        let ended = self.watched(x0, events, tolerance, &mut solution);
        concluded(ended, solution)
    }

    /// Like [`follow`](Self::follow), but also passes the tolerance and the statistics to the observer.
    pub(crate) fn watched(
        &mut self,
        x0: SVector<T, N>,
        events: &[Event<'_, T, N>],
        tolerance: Option<Tolerance<T>>,
        observer: &mut impl Observer<T, N>,
    ) -> Result<SVector<T, N>, Early<T, N>> {
        tolerance.into_iter().for_each(|tolerance| observer.within(tolerance));
        let ended = self.follow(x0, events, observer);
        observer.finish(self.statistics());
        ended
    }

    /// Actual initial state for the given `x0`: the state before an impact at the start, if there is one.
    pub(super) fn start(&self, x0: SVector<T, N>) -> SVector<T, N> {
        if self.impulses().is_some() { x0 } else { self.x() }
    }

    /// Integrates to the end, and passes the trajectory to `observer`. Returns the final state, which is the one of a
    /// terminal event if one occurred. The stepper was created with the initial state `x0`.
    pub(crate) fn follow(
        &mut self,
        x0: SVector<T, N>,
        events: &[Event<'_, T, N>],
        observer: &mut impl Observer<T, N>,
    ) -> Result<SVector<T, N>, Early<T, N>> {
        let search = Search::new(events, self.t(), &self.x());
        let mut search = search.map_err(|reason| self.end_here(reason))?;
        self.follow_on(x0, &mut search, observer).map(|(x, _)| x)
    }

    /// Like [`follow`](Self::follow), with a search for events that may have gone through an earlier part of the
    /// trajectory. Also returns true if a terminal event occurred.
    pub(crate) fn follow_on(
        &mut self,
        x0: SVector<T, N>,
        search: &mut Search<'_, '_, T, N>,
        observer: &mut impl Observer<T, N>,
    ) -> Result<(SVector<T, N>, bool), Early<T, N>> {
        if observer.keeps_all() {
            self.check_to_keep().map_err(|reason| self.end_here(reason))?;
        }
        let system = self.system();
        let placed = |t: T, x: &SVector<T, N>| place(system, t, x);
        let start = self.start(x0);
        observer.start(self.t(), &start);
        let mut reached = self.reach(start, observer);
        let mut crowded = 0;
        loop {
            if observer.is_cancelled() {
                return Err(self.end_here(Reason::Cancelled));
            }
            let step = match self.step() {
                Ok(Some(step)) => step,
                Ok(None) => return Ok((self.x(), false)),
                Err(reason) => return Err(self.end_here(reason)),
            };
            let changes = self.enter_at((step.t0, step.x0), &mut reached, observer);
            reached.x = step.x1;
            if changes {
                let times = (step.t0, self.t1(), step.scale(step.t0));
                let restarted = search.restart(times, &step.x0, &[]);
                restarted.map_err(Early::at((step.t0, step.x0)))?;
            }
            if search.is_empty() {
                match observer.needs(step.t0, step.t1) {
                    Need::Nothing => {}
                    Need::Ends => observer.step(&Dense::new(step, &[])),
                    Need::Inside => observe(&self.dense(), T::from_f64(1.0), observer),
                }
                continue;
            }
            let (found, is_retaken) = self.look_for_events(search, step);
            let dense = self.known_dense().retaken(is_retaken);
            let Some(mut stop) = pass(found, search, &dense, observer, placed)? else {
                reached.x = self.x();
                continue;
            };
            if stop.is_the_end {
                return Ok((stop.x, true));
            }
            let at_stop = Early::at((stop.t, stop.x));
            if !stop.changes {
                let is_short = (stop.t - step.t0).abs() < T::from_f64(SHORT) * step.h.abs();
                crowded = if is_short { crowded + 1 } else { 0 };
                search.ends_at_kinks = crowded < MOST_CROWDED;
                system.project(stop.t, &mut stop.x);
            }
            self.restart(stop.t, stop.x).map_err(&at_stop)?;
            if stop.changes {
                reached = self.reach(stop.x, observer);
            } else {
                self.go_on_at(stop.x, &mut reached);
            }
            search
                .restart((stop.t, self.t1(), stop.scale), &self.x(), &stop.fired)
                .map_err(at_stop)?;
        }
    }

    /// Ends the trajectory at the point reached.
    fn end_here(&self, reason: Reason) -> Early<T, N> {
        Early::at((self.t(), self.x()))(reason)
    }

    /// Point reached at the start, or at a restart, from the state `x`.
    fn reach(&self, x: SVector<T, N>, observer: &mut impl Observer<T, N>) -> Reached<T, N> {
        let mut reached = Reached { x, mode: None };
        self.enter_at((self.t(), self.x()), &mut reached, observer);
        reached
    }

    /// Continues from the end of a step at a kink, in the mode there if no other one begins.
    fn go_on_at(&self, x: SVector<T, N>, reached: &mut Reached<T, N>) {
        reached.x = x;
        if let (Some((_, before)), Some((from, mode))) = (reached.mode, self.mode())
            && before == mode
            && self.impulses().is_none()
        {
            reached.mode = Some((from, mode));
        }
    }

    /// Reports the mode from a point on, the state there and the impact, as far as they are new. Returns true if they
    /// are.
    fn enter_at(
        &self,
        (t, x): (T, SVector<T, N>),
        reached: &mut Reached<T, N>,
        observer: &mut impl Observer<T, N>,
    ) -> bool {
        let Some((from, mode)) = self.mode() else {
            return false;
        };
        let before = reached.x;
        let is_same = x
            .iter()
            .zip(&before)
            .all(|(x, before)| x == before && x.has_same_slopes(before));
        let (jumps, changes) = (!is_same, reached.mode != Some((from, mode)));
        if jumps {
            observer.jump(t, x);
        }
        if changes {
            observer.mode(from, mode);
        }
        if (jumps || changes)
            && let Some(impulses) = self.impulses()
        {
            observer.impact(Impact {
                t,
                impulses,
                before,
                after: x,
            });
            if let Some(ambiguity) = self.ambiguity() {
                observer.ambiguity(ambiguity);
            }
        }
        *reached = Reached {
            x,
            mode: Some((from, mode)),
        };
        jumps || changes
    }
}

/// Searches a step for events, and passes it to an observer up to the first event that acts. Returns the consequences
/// of that event. `place` projects the state that a reset returns onto the constraints of the system.
pub(crate) fn see<T: Float, const N: usize>(
    search: &mut Search<'_, '_, T, N>,
    dense: &Dense<'_, T, N>,
    observer: &mut impl Observer<T, N>,
    place: impl Fn(T, &SVector<T, N>) -> Result<SVector<T, N>, Reason>,
) -> Result<Option<Stop<T, N>>, Early<T, N>> {
    let found = search.look(dense);
    pass(found, search, dense, observer, place)
}

/// Passes a step to an observer up to the first event of those found that acts. Returns the consequences of that event.
fn pass<T: Float, const N: usize>(
    found: Vec<Found<T>>,
    search: &Search<'_, '_, T, N>,
    dense: &Dense<'_, T, N>,
    observer: &mut impl Observer<T, N>,
    place: impl Fn(T, &SVector<T, N>) -> Result<SVector<T, N>, Reason>,
) -> Result<Option<Stop<T, N>>, Early<T, N>> {
    let step = dense.step();
    let at_start = Early::at((step.t0, step.x0));
    let acts = |found: &&Found<T>| matches!(found.what, What::Passage(_)) && search.acts(found, dense);
    let Some(cut) = found.iter().find(acts).map(|found| found.theta) else {
        let occurred: Vec<_> = found
            .iter()
            .map(|found| found.occurrence(dense))
            .collect::<Result<_, _>>()
            .map_err(at_start)?;
        observe(dense, T::from_f64(1.0), observer);
        occurred.into_iter().for_each(|event| observer.event(event));
        search.missed(dense, step.t1).for_each(|missed| observer.missed(missed));
        return Ok(None);
    };
    let mut stop = Stop::new(dense, cut);
    observe(dense, cut, observer);
    for found in found {
        if found.theta > cut && !stop.is_simultaneous(dense.time(found.theta)) {
            break;
        }
        let before = Early::at((stop.t, stop.x));
        let occurrence = found.occurrence(dense).map_err(&before)?;
        stop.act(found, occurrence, search, observer, &place).map_err(before)?;
    }
    search.missed(dense, stop.t).for_each(|missed| observer.missed(missed));
    Ok(Some(stop))
}

/// Passes the part of a step up to the fraction `theta` to the observer, with its own polynomial.
fn observe<T: Float, const N: usize>(dense: &Dense<'_, T, N>, theta: T, observer: &mut impl Observer<T, N>) {
    let step = dense.step();
    if theta == T::from_f64(1.0) && theta.is_constant() && !dense.is_cut_off() {
        return observer.step(dense);
    }
    let t = dense.time(theta);
    if t != step.t0 {
        let part = Step::new((step.t0, step.x0), (t, dense.located(theta)));
        let coefficients: Vec<_> = dense.coefficients_to(theta).collect();
        observer.step(&Dense::new(part, &coefficients));
    }
}

/// Point reached by a trajectory.
struct Reached<T, const N: usize> {
    x: SVector<T, N>,
    mode: Option<(T, Mode)>,
}

/// A point within a step at which events act, one after the other.
pub(crate) struct Stop<T, const N: usize> {
    /// Position in fractions of the step.
    theta: T,
    t: T,
    /// State after the events that have acted so far.
    pub(crate) x: SVector<T, N>,
    /// Size of times, relative to which their resolution is measured.
    scale: T,
    /// Events here, with the values of their functions before them.
    fired: Vec<(Found<T>, T)>,
    /// True if an event resets the state, or ends the integration.
    changes: bool,
    is_the_end: bool,
}

impl<T: Float, const N: usize> Stop<T, N> {
    fn new(dense: &Dense<'_, T, N>, theta: T) -> Self {
        let t = dense.time(theta);
        Self {
            theta,
            t,
            x: dense.located(theta),
            scale: dense.step().scale(t),
            fired: Vec::new(),
            changes: false,
            is_the_end: false,
        }
    }

    fn resolution(&self) -> T {
        ulps(SIMULTANEOUS_ULPS, self.scale)
    }

    fn is_simultaneous(&self, t: T) -> bool {
        (t - self.t).abs() <= self.resolution()
    }

    /// Records an event and applies it to the state that the events before it left.
    fn act(
        &mut self,
        found: Found<T>,
        mut occurrence: Occurrence<T, N>,
        search: &Search<'_, '_, T, N>,
        observer: &mut impl Observer<T, N>,
        place: impl Fn(T, &SVector<T, N>) -> Result<SVector<T, N>, Reason>,
    ) -> Result<(), Reason> {
        let event = search.event(&found);
        if found.theta >= self.theta {
            occurrence.x = self.x;
        }
        if self.is_simultaneous(occurrence.t) {
            self.fired.push((found, (event.function)(self.t, &self.x)));
        }
        observer.event(occurrence);
        if !event.changes() {
            return Ok(());
        }
        search.check_progress(found.index, self.t, self.resolution())?;
        self.changes = true;
        self.is_the_end |= event.terminal;
        if let Some(reset) = &event.reset {
            let placed = place(self.t, &reset(self.t, &self.x));
            self.x = placed.map_err(|reason| of_reset(reason, found.index, self.t.to_f64()))?;
            observer.jump(self.t, self.x);
        }
        Ok(())
    }
}
