//! Many trajectories with steps of the same length.

use std::array;

use nalgebra::SVector;

use super::adaptive::outcome as outcome_of;
use super::check::{first_not_finite, in_lane, sum};
use super::watch::{Watch, show_lane};
use super::{InLanes, MOST_LANES, Stopped, alone, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode};
use crate::method::{Accepted, Failure, Fixed, Grid, NonFinite, OneStep, Scheme, Stalled, place, toggle};
use crate::real::lanes::{Kernel, LaneElement, Lanes};
use crate::statistics::Statistics;
use crate::system::Cast;

/// Trajectories on their way from the states `x`, which are replaced.
pub struct March<'a, F, M, T, W, const N: usize> {
    pub(super) method: &'a Fixed<F>,
    pub(super) models: &'a [M],
    pub(super) grid: Grid<T>,
    pub(super) x: &'a mut [SVector<T, N>],
    pub(super) stopped: &'a mut Vec<Stopped<T>>,
    pub(super) watch: W,
}

impl<F, M, T, W, const N: usize> Kernel<T> for March<'_, F, M, T, W, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    type Output = Result<(), Reason>;

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        // Further lanes fill the gaps where operations wait for one another. A longer system has enough that are independent, and
        // needs the registers for itself.
        if const { !M::HYBRID && V::LANES > 1 && W::WATCHES } {
            self.watched::<V>()
        } else if const { !M::HYBRID && !F::NARROW && !W::WATCHES } {
            self.in_groups::<<V::Double as Lanes>::Double>()
        } else if const { !M::HYBRID && V::LANES > 1 && !W::WATCHES } {
            self.in_groups::<V>()
        } else {
            self.one_by_one();
            Ok(())
        }
    }
}

impl<F, M, T, W, const N: usize> March<'_, F, M, T, W, N>
where
    F: OneStep<M::In<T>, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Brings all to their ends, one after the other.
    pub(super) fn one_by_one(mut self) {
        self.alone(0..self.x.len());
    }

    /// The same with some of them.
    fn alone(&mut self, which: impl IntoIterator<Item = usize>) {
        let span = (self.grid.t0(), self.grid.t1());
        let states = (&mut *self.x, &mut self.watch);
        alone(self.method, self.models, span, which, states, self.stopped);
    }
}

impl<F, M, T, W, const N: usize> March<'_, F, M, T, W, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// As many trajectories at a time as there are lanes; where they run out, the last fills the group.
    ///
    /// What is not finite stays so to the end. Such a trajectory is integrated alone, which tells where it stopped and
    /// why: to ask in every step would take a tenth of the time.
    #[inline(always)]
    fn in_groups<V: Lanes<Scalar = T>>(mut self) -> Result<(), Reason> {
        let mut failed = Vec::new();
        for (number, states) in self.x.chunks_mut(V::LANES).enumerate() {
            let first = number * V::LANES;
            let before = failed.len();
            for (lane, state) in states.iter_mut().enumerate() {
                let model = model_of(self.models, first + lane).cast::<T>();
                match place(&model, self.grid.t0(), state) {
                    Ok(placed) => *state = placed,
                    // alone it tells why
                    Err(_) => failed.push(first + lane),
                }
            }
            let refused = before..failed.len();
            let member = |lane: usize| lane.min(states.len() - 1);
            let system = F::gather::<V>(|lane| model_of(self.models, first + member(lane)));
            let scheme = self.method.family.stages::<V>(&system, None, false)?;
            let x = SVector::from_fn(|k, _| V::from_fn(|lane| states[member(lane)][k]));
            let ends = march(&system, scheme, x, self.grid);
            let all_are_finite = ends
                .as_ref()
                .is_ok_and(|(x, slope)| sum(x, slope.as_ref()).all_finite());
            for (lane, state) in states.iter_mut().enumerate() {
                if failed[refused.clone()].contains(&(first + lane)) {
                    continue;
                }
                match &ends {
                    Ok((x, slope)) if all_are_finite || first_not_finite(x, slope.as_ref(), lane).is_none() => {
                        *state = in_lane(x, lane);
                    }
                    _ => failed.push(first + lane),
                }
            }
        }
        self.alone(failed);
        Ok(())
    }

    /// The same where each step is seen, and a trajectory may end before the others of its group.
    #[inline(always)]
    fn watched<V: Lanes<Scalar = T>>(mut self) -> Result<(), Reason> {
        let mut alone = Vec::new();
        let mut others = Vec::new();
        for (index, x) in self.x.iter_mut().enumerate() {
            let model = model_of(self.models, index).cast::<T>();
            let placed = place(&model, self.grid.t0(), x).ok();
            match placed.filter(|_| !self.watch.is_alone(index) && self.grid.t0() != self.grid.t1()) {
                Some(placed) => {
                    *x = placed;
                    others.push(index);
                }
                None => alone.push(index),
            }
        }
        self.alone(alone);
        let mut within = Vec::new();
        for group in others.chunks(V::LANES) {
            let member = |lane: usize| group[lane.min(group.len() - 1)];
            let system = F::gather::<V>(|lane| model_of(self.models, member(lane)));
            let mut scheme = self.method.family.stages::<V>(&system, None, true)?;
            let hold = Hold::default();
            let system = &InMode::new(&system, &hold);
            let mut x = SVector::from_fn(|k, _| V::from_fn(|lane| self.x[member(lane)][k]));
            let mut x_new = x;
            let mut grid = self.grid;
            let mut t = grid.t0();
            let mut work = Statistics::default();
            let slope = scheme.begin(system, V::splat(t), &x, &mut work);
            let mut busy = [false; MOST_LANES];
            for (lane, &index) in group.iter().enumerate() {
                let started = NonFinite::check(&in_lane(&slope, lane)).map_err(NonFinite::at_start);
                let start = self.x[index];
                busy[lane] = started.is_ok();
                if let Err(reason) = started {
                    self.stopped.push(Stopped { index, t, reason });
                } else if let Err(reason) = self.watch.start(index, (t, &start), None, &work) {
                    busy[lane] = false;
                    self.end(index, start, Some((t, reason)));
                }
            }
            while t != grid.t1() && busy.contains(&true) {
                let t_new = grid.next();
                let (start, end) = (V::splat(t), V::splat(t_new));
                let [mut tried, mut at_end, mut of_dense] = [Statistics::default(); 3];
                let attempt = scheme.attempt(system, (start, &x), (end, &mut x_new), &mut tried);
                let slope = scheme.arrive(system, (end, &x_new), &mut at_end).copied();
                let step = Step::new((start, x), (end, x_new));
                let looks: [bool; MOST_LANES] =
                    array::from_fn(|lane| busy[lane] && self.watch.looks_into(group[lane], (t, t_new)));
                let coefficients = if looks.contains(&true) {
                    scheme.dense(system, &step, &mut of_dense)
                } else {
                    &[]
                };
                for (lane, &index) in group.iter().enumerate() {
                    if !busy[lane] {
                        continue;
                    }
                    let before = in_lane(&x, lane);
                    let outcome = attempt.map_err(Failure::from);
                    let outcome =
                        outcome.and_then(|error| outcome_of((&x_new, slope.as_ref()), error.lane(lane), lane));
                    let mut work = tried;
                    if NonFinite::check(&in_lane(&x_new, lane)).is_ok() {
                        work.add(&at_end);
                    }
                    (work.accepted, work.rejected) = (usize::from(outcome.is_ok()), usize::from(outcome.is_err()));
                    self.watch.work(index, &work);
                    if let Err(failure) = outcome {
                        busy[lane] = false;
                        let reason = failure.reason((t_new - t).to_f64());
                        let reason = toggle::behind(reason, &model_of(self.models, index).cast::<T>(), t, &before);
                        self.end(index, before, Some((t, reason)));
                        continue;
                    }
                    let looks_into = looks[lane].then_some((coefficients, of_dense));
                    let after = in_lane(&x_new, lane);
                    match show_lane(&mut self.watch, (lane, index), &step, looks_into, &mut within) {
                        Ok(None) if t_new != grid.t1() => continue,
                        Ok(end) => self.end(index, end.unwrap_or(after), None),
                        Err(early) => self.end(index, early.x, Some((early.t, early.reason))),
                    }
                    busy[lane] = false;
                }
                scheme.accept(system, &step, Accepted::All, &mut work);
                (x, t) = (x_new, t_new);
            }
        }
        Ok(())
    }

    /// Ends a trajectory in a state, perhaps before its time.
    fn end(&mut self, index: usize, x: SVector<T, N>, early: Option<(T, Reason)>) {
        self.x[index] = x;
        self.stopped
            .extend(early.map(|(t, reason)| Stopped { index, t, reason }));
        self.watch.finish(index);
    }
}

/// Goes from the states `x` to the end of the grid: the states there, and their derivatives from methods that need them.
#[inline(always)]
#[allow(clippy::type_complexity, reason = "a state and a derivative")]
fn march<C, S, V, const N: usize>(
    system: &S,
    mut scheme: C,
    x: SVector<V, N>,
    mut grid: Grid<V::Scalar>,
) -> Result<(SVector<V, N>, Option<SVector<V, N>>), Stalled>
where
    C: Scheme<S, V, N>,
    V: Lanes,
{
    let hold = Hold::default();
    let system = &InMode::new(system, &hold);
    let work = &mut Statistics::default();
    let mut t = grid.t0();
    let (mut states, mut others) = (x, x);
    // They change places with each step, where copies would take their time.
    let (mut x, mut x_new) = (&mut states, &mut others);
    let mut slope = None;
    if t != grid.t1() {
        scheme.begin(system, V::splat(t), x, work);
    }
    while t != grid.t1() {
        let t_new = grid.next();
        let (start, end) = (V::splat(t), V::splat(t_new));
        scheme.attempt(system, (start, x), (end, x_new), work)?;
        let arrived = scheme.arrive(system, (end, x_new), work);
        if t_new == grid.t1() {
            slope = arrived.copied();
        }
        scheme.accept(system, &Step::new((start, *x), (end, *x_new)), Accepted::All, work);
        std::mem::swap(&mut x, &mut x_new);
        t = t_new;
    }
    Ok((*x, slope))
}
