//! Observation of the trajectories of an ensemble.

use nalgebra::SVector;

use super::check::in_lane;
use crate::dense::{Dense, Step};
use crate::error::Reason;
use crate::event::Event;
use crate::method::{Early, Scheme, Search, Stepper, see};
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::solution::{Need, Observer};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::System;

/// Observer of all trajectories of an ensemble, which are identified by their index. By default there are no observers.
pub trait Watch<T: Float, const N: usize> {
    /// True if there are observers.
    const WATCHES: bool = false;

    /// True if some observer keeps every step of its trajectory.
    fn keeps_all(&self) -> bool {
        false
    }

    /// True if a trajectory must be integrated alone.
    fn is_alone(&self, _index: usize) -> bool {
        false
    }

    /// Integrates a trajectory alone and returns its final state.
    ///
    /// # Errors
    /// Reason and place of an early stop.
    fn run<C, S>(
        &mut self,
        _start: (usize, SVector<T, N>),
        stepper: &mut Stepper<'_, C, S, T, N>,
        _tolerance: Option<Tolerance<T>>,
    ) -> Result<SVector<T, N>, Early<T, N>>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let ended = stepper.run();
        ended.map_err(Early::at((stepper.t(), stepper.x())))
    }

    /// Integrates a trajectory that has left its lane after this many steps, because it switched to another method, and
    /// returns its final state.
    ///
    /// # Errors
    /// Reason and place of an early stop.
    fn go_on<C, S>(
        &mut self,
        index: usize,
        stepper: &mut Stepper<'_, C, S, T, N>,
        steps: usize,
    ) -> Result<SVector<T, N>, Early<T, N>>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        let ended = loop {
            let step = match stepper.step() {
                Ok(Some(step)) => step,
                Ok(None) => break Ok(stepper.x()),
                Err(reason) => break Err(Early::at((stepper.t(), stepper.x()))(reason)),
            };
            let seen = match self.needs(index, (step.t0, step.t1)) {
                Need::Nothing => Ok(None),
                Need::Ends => self.see(index, &Dense::new(step, &[])),
                Need::Inside => self.see(index, &stepper.dense()),
            };
            match seen {
                Ok(None) if self.is_cancelled(index) => {
                    break Err(Early::at((step.t1, step.x1))(Reason::Cancelled));
                }
                Ok(None) => {}
                Ok(Some(x)) => break Ok(x),
                Err(early) => break Err(early),
            }
        };
        let mut work = stepper.statistics();
        (work.accepted, work.switches) = (work.accepted - steps, work.switches + 1);
        self.work(index, &work);
        ended
    }

    /// Called when a trajectory starts in a lane. `work` counts the evaluations so far.
    fn start(
        &mut self,
        _index: usize,
        _at: (T, &SVector<T, N>),
        _tolerance: Option<Tolerance<T>>,
        _work: &Statistics,
    ) -> Result<(), Reason> {
        Ok(())
    }

    /// The part of a step that will be evaluated.
    fn needs(&self, _index: usize, _span: (T, T)) -> Need {
        Need::Nothing
    }

    /// True if a trajectory is stopped by its observer.
    fn is_cancelled(&self, _index: usize) -> bool {
        false
    }

    /// Receives a step of a lane. Returns the state at a terminal event in this step, if there is one.
    fn see(&mut self, _index: usize, _dense: &Dense<'_, T, N>) -> Result<Option<SVector<T, N>>, Early<T, N>> {
        Ok(None)
    }

    /// Adds evaluations made in a lane.
    fn work(&mut self, _index: usize, _work: &Statistics) {}

    /// Called when a trajectory leaves its lane, at its end or earlier.
    fn finish(&mut self, _index: usize) {}
}

/// Passes the step of a lane to [`Watch::see`] and returns its result. `inside` holds the coefficients of the dense
/// output and the evaluations they took, if the states within the step will be evaluated.
#[inline(always)]
pub(super) fn show_lane<V: Lanes, W: Watch<V::Scalar, N>, const N: usize>(
    watch: &mut W,
    (lane, index): (usize, usize),
    step: &Step<V, N>,
    inside: Option<(&[SVector<V, N>], Statistics)>,
    within: &mut Vec<SVector<V::Scalar, N>>,
) -> Result<Option<SVector<V::Scalar, N>>, Early<V::Scalar, N>> {
    let end = |t: V, x: &SVector<V, N>| (t.lane(lane), in_lane(x, lane));
    let step = Step::new(end(step.t0, &step.x0), end(step.t1, &step.x1));
    within.clear();
    if let Some((coefficients, work)) = inside {
        for coefficient in coefficients {
            within.push(in_lane(coefficient, lane));
        }
        watch.work(index, &work);
    }
    watch.see(index, &Dense::new(step, within))
}

/// No observers.
pub(super) struct Unwatched;

impl<T: Float, const N: usize> Watch<T, N> for Unwatched {}

/// One observer per trajectory, with its events.
pub(super) struct Watched<'o, 'w, 'e, O, T, const N: usize> {
    observers: &'o mut [O],
    events: Vec<&'w [Event<'e, T, N>]>,
    /// Searches of the trajectories in lanes.
    searches: Vec<Option<Search<'w, 'e, T, N>>>,
    work: Vec<Statistics>,
}

impl<'o, 'w, 'e, O, T, const N: usize> Watched<'o, 'w, 'e, O, T, N> {
    pub(super) fn new(observers: &'o mut [O], events: impl Fn(usize) -> &'w [Event<'e, T, N>]) -> Self {
        let count = observers.len();
        Self {
            observers,
            events: (0..count).map(events).collect(),
            searches: (0..count).map(|_| None).collect(),
            work: vec![Statistics::default(); count],
        }
    }
}

impl<O: Observer<T, N>, T: Float, const N: usize> Watch<T, N> for Watched<'_, '_, '_, O, T, N> {
    const WATCHES: bool = true;

    fn keeps_all(&self) -> bool {
        self.observers.iter().any(Observer::keeps_all)
    }

    /// True for trajectories with events that reset the state or require steps to be retaken.
    fn is_alone(&self, index: usize) -> bool {
        self.events[index].iter().any(Event::begins_anew)
    }

    fn run<C, S>(
        &mut self,
        (index, x0): (usize, SVector<T, N>),
        stepper: &mut Stepper<'_, C, S, T, N>,
        tolerance: Option<Tolerance<T>>,
    ) -> Result<SVector<T, N>, Early<T, N>>
    where
        C: Scheme<S, T, N>,
        S: System<T, N> + ?Sized,
    {
        stepper.watched(x0, self.events[index], tolerance, &mut self.observers[index])
    }

    fn start(
        &mut self,
        index: usize,
        (t, x): (T, &SVector<T, N>),
        tolerance: Option<Tolerance<T>>,
        work: &Statistics,
    ) -> Result<(), Reason> {
        let observer = &mut self.observers[index];
        tolerance.into_iter().for_each(|tolerance| observer.within(tolerance));
        observer.start(t, x);
        self.work[index].add(work);
        self.searches[index] = Some(Search::new(self.events[index], t, x)?);
        Ok(())
    }

    fn needs(&self, index: usize, (t0, t1): (T, T)) -> Need {
        if self.events[index].is_empty() {
            self.observers[index].needs(t0, t1)
        } else {
            Need::Inside
        }
    }

    fn is_cancelled(&self, index: usize) -> bool {
        self.observers[index].is_cancelled()
    }

    fn see(&mut self, index: usize, dense: &Dense<'_, T, N>) -> Result<Option<SVector<T, N>>, Early<T, N>> {
        let observer = &mut self.observers[index];
        match &mut self.searches[index] {
            Some(search) if !self.events[index].is_empty() => {
                // Trajectories with resets are integrated alone, so the state is kept here.
                Ok(see(search, dense, observer, |_, x| Ok(*x))?.map(|stop| stop.x))
            }
            _ => {
                observer.step(dense);
                Ok(None)
            }
        }
    }

    fn work(&mut self, index: usize, work: &Statistics) {
        self.work[index].add(work);
    }

    fn finish(&mut self, index: usize) {
        self.searches[index] = None;
        self.observers[index].finish(self.work[index]);
    }
}
