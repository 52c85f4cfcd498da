//! Following a trajectory to its end: events act, and what is asked for is kept.

use nalgebra::SVector;

use crate::dense::{Dense, Step};
use crate::error::{Reason, SolveError};
use crate::event::{Event, Occurrence};
use crate::hybrid::{Impact, Mode};
use crate::method::Stepper;
use crate::method::scheme::{NonFinite, Scheme};
use crate::method::search::{Found, Search, What};
use crate::real::Float;
use crate::solution::{Record, Solution};
use crate::system::System;

/// Events within this many ulps of the time are simultaneous, and one that acts twice within them never ends.
const SIMULTANEOUS_ULPS: f64 = 4.0;

/// Goes on to the end from the state `x0`, with events if there are any, and keeps the trajectory.
pub(super) fn collect<C, S, T, const N: usize>(
    mut stepper: Stepper<'_, C, S, T, N>,
    x0: SVector<T, N>,
    events: &[Event<'_, T, N>],
) -> Result<Solution<T, N>, SolveError<T, N>>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    let start = if stepper.impulses().is_some() { x0 } else { stepper.x() };
    let mut solution = Solution::start(stepper.t(), start);
    let ended = stepper
        .check_to_keep()
        .and_then(|()| follow(&mut stepper, start, events, &mut solution));
    solution.set_statistics(stepper.statistics());
    match ended {
        Ok(()) => Ok(solution),
        Err(reason) => Err(SolveError {
            reason,
            solution: Box::new(solution),
        }),
    }
}

/// Goes on to the end from the state `start`, and keeps what `record` asks for.
pub(crate) fn follow<C, S, T, const N: usize>(
    stepper: &mut Stepper<'_, C, S, T, N>,
    start: SVector<T, N>,
    events: &[Event<'_, T, N>],
    record: &mut impl Record<T, N>,
) -> Result<(), Reason>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    let mut search = Search::new(events, stepper.t(), &stepper.x())?;
    let mut reached = Reached::start(stepper, start, record);
    while let Some(step) = stepper.step()? {
        if reached.changes(stepper, &step, record) {
            search.restart((step.t0, stepper.t1(), step.t0.abs().max(step.h.abs())), &step.x0, &[])?;
        }
        let dense = stepper.dense();
        let found = search.look(&dense);
        let acts = |found: &&Found<T>| matches!(found.what, What::Passage(_)) && events[found.index].acts();
        let Some(cut) = found.iter().find(acts).map(|found| found.theta) else {
            let occurred: Vec<_> = found
                .iter()
                .map(|found| found.occurrence(&dense))
                .collect::<Result<_, _>>()?;
            record.push(&dense);
            occurred.into_iter().for_each(|event| record.note(event));
            continue;
        };
        let mut stop = Stop::new(&dense, cut);
        record.push_part(&dense, cut);
        for found in found {
            if found.theta > cut && !stop.is_simultaneous(dense.time(found.theta)) {
                break;
            }
            stop.act(found, found.occurrence(&dense)?, &events[found.index], &search, record)?;
        }
        if stop.is_the_end {
            return Ok(());
        }
        stepper.restart(stop.t, stop.x)?;
        reached = Reached::start(stepper, stop.x, record);
        search.restart((stop.t, stepper.t1(), stop.scale), &stop.x, &stop.fired)?;
    }
    Ok(())
}

/// Where the record has arrived.
struct Reached<T, const N: usize> {
    x: SVector<T, N>,
    mode: Option<(T, Mode)>,
}

impl<T: Float, const N: usize> Reached<T, N> {
    /// At the start of a stepper, which was asked to start from the state `x`.
    fn start<C, S>(stepper: &Stepper<'_, C, S, T, N>, x: SVector<T, N>, record: &mut impl Record<T, N>) -> Self
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let mut reached = Self { x, mode: None };
        reached.enter(stepper, (stepper.t(), stepper.x()), record);
        reached
    }

    /// Goes on to the end of a step; tells whether it started in another mode or from another state.
    fn changes<C, S>(
        &mut self,
        stepper: &Stepper<'_, C, S, T, N>,
        step: &Step<T, N>,
        record: &mut impl Record<T, N>,
    ) -> bool
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let changes = self.enter(stepper, (step.t0, step.x0), record);
        self.x = step.x1;
        changes
    }

    /// Records the mode of a stepper from a point on, the state there and the impact, where these are new; tells
    /// whether they were.
    fn enter<C, S>(
        &mut self,
        stepper: &Stepper<'_, C, S, T, N>,
        (t, x): (T, SVector<T, N>),
        record: &mut impl Record<T, N>,
    ) -> bool
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let Some((from, mode)) = stepper.mode() else {
            return false;
        };
        let (jumps, changes) = (x != self.x, self.mode != Some((from, mode)));
        if jumps {
            record.jump(t, x);
        }
        if changes {
            record.mode(from, mode);
        }
        if (jumps || changes)
            && let Some(impulses) = stepper.impulses()
        {
            let before = self.x;
            record.impact(Impact {
                t,
                impulses,
                before,
                after: x,
            });
        }
        (self.x, self.mode) = (x, Some((from, mode)));
        jumps || changes
    }
}

/// A point within a step at which events act, one after the other.
struct Stop<T, const N: usize> {
    /// In fractions of the step.
    theta: T,
    t: T,
    /// The state after the events that have acted.
    x: SVector<T, N>,
    /// The size of times, to which their resolution is relative.
    scale: T,
    /// The events here, with the values of their functions before them.
    fired: Vec<(Found<T>, T)>,
    is_the_end: bool,
}

impl<T: Float, const N: usize> Stop<T, N> {
    fn new(dense: &Dense<'_, T, N>, theta: T) -> Self {
        let t = dense.time(theta);
        Self {
            theta,
            t,
            x: dense.at_fraction(theta),
            scale: t.abs().max(dense.step().h.abs()),
            fired: Vec::new(),
            is_the_end: false,
        }
    }

    fn resolution(&self) -> T {
        T::from_f64(SIMULTANEOUS_ULPS) * T::EPSILON * self.scale
    }

    fn is_simultaneous(&self, t: T) -> bool {
        (t - self.t).abs() <= self.resolution()
    }

    /// Notes an event and lets it act: it sees what those before it did.
    fn act(
        &mut self,
        found: Found<T>,
        mut occurrence: Occurrence<T, N>,
        event: &Event<'_, T, N>,
        search: &Search<'_, '_, T, N>,
        record: &mut impl Record<T, N>,
    ) -> Result<(), Reason> {
        if found.theta >= self.theta {
            occurrence.x = self.x;
        }
        if self.is_simultaneous(occurrence.t) {
            self.fired.push((found, (event.function)(self.t, &self.x)));
        }
        record.note(occurrence);
        if !event.acts() {
            return Ok(());
        }
        search.check_progress(found.index, self.t, self.resolution())?;
        self.is_the_end |= event.terminal;
        if let Some(reset) = &event.reset {
            self.x = reset(self.t, &self.x);
            NonFinite::check(&self.x).map_err(NonFinite::at_start)?;
            record.jump(self.t, self.x);
        }
        Ok(())
    }
}
