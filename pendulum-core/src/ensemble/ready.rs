//! Trajectories that are ready to enter lanes: their derivatives and first steps are known.
//!
//! Trajectories with steps of their own end at different times, and the next ones enter one by one. To evaluate all
//! lanes for each of them would take as long as a stage of a step in all lanes. Instead, the next trajectories begin
//! side by side in lanes of their own, and wait.

use nalgebra::SVector;

use super::check::{in_lane, set_lanes};
use super::march::{March, Paced};
use super::members::Members;
use super::watch::Watch;
use super::{Expanded, InLanes, MOST_LANES, model_of};
use crate::method::{Method, Pace, StepControl};
use crate::real::lanes::{LaneElement, Lanes, Routine};
use crate::statistics::Statistics;
use crate::step_size::Trial;
use crate::system::{Cast, System};

/// Start of a trajectory.
#[derive(Clone, Copy)]
struct Start<T, const N: usize> {
    index: usize,
    slope: SVector<T, N>,
    pace: Pace<T>,
}

/// Starts, the next one last.
pub(super) struct Ready<T, const N: usize> {
    starts: [Option<Start<T, N>>; MOST_LANES],
    count: usize,
}

impl<T: Copy, const N: usize> Ready<T, N> {
    pub(super) fn none() -> Self {
        Self {
            starts: [None; MOST_LANES],
            count: 0,
        }
    }

    fn push(&mut self, start: Start<T, N>) {
        self.starts[self.count] = Some(start);
        self.count += 1;
    }

    fn pop(&mut self) -> Option<Start<T, N>> {
        self.count = self.count.checked_sub(1)?;
        self.starts[self.count]
    }
}

/// Lanes, and trajectories that enter them.
pub(super) struct Entrance<'e, 'm, A, M: Cast<N>, V: Lanes, W, const N: usize> {
    pub(super) march: &'e mut March<'m, A, M, V::Scalar, W, N>,
    pub(super) ready: &'e mut Ready<V::Scalar, N>,
    pub(super) members: &'e mut Members<V::Scalar>,
    /// States, and derivatives there.
    pub(super) x: SVector<V, N>,
    pub(super) slope: SVector<V, N>,
}

/// Fills free lanes with trajectories that are ready, and makes others ready if there are too few. Returns true if any
/// entered. It is compiled apart, since it would slow down the steps.
pub(super) struct Enter;

impl<'m, A, F, M, V, W, const N: usize> Routine<Entrance<'_, 'm, A, M, V, W, N>, StepControl<V::Scalar>> for Enter
where
    A: Paced<V::Scalar, Family = F> + Method<M::In<V::Scalar>, V::Scalar, N>,
    F: InLanes<M, V::Scalar, N>,
    M: Cast<N>,
    V: Lanes,
    V::Scalar: LaneElement,
    W: Watch<V::Scalar, N>,
{
    type Output = bool;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, into: &mut Entrance<'_, 'm, A, M, V, W, N>, control: &StepControl<V::Scalar>) -> bool {
        let (mut indices, mut slopes) = ([None; MOST_LANES], [None; MOST_LANES]);
        for lane in 0..V::LANES {
            if into.members.index(lane).is_some() {
                continue;
            }
            while into.ready.count == 0 && into.march.make_ready::<V>(into.ready, control) {}
            let Some(start) = into.ready.pop() else { break };
            into.members.enter(lane, start.index, into.march.span.0, start.pace);
            (indices[lane], slopes[lane]) = (Some(start.index), Some(start.slope));
        }
        if indices.iter().all(Option::is_none) {
            return false;
        }
        set_lanes(&mut into.x, |lane| indices[lane].map(|index| &into.march.x[index]));
        set_lanes(&mut into.slope, |lane| slopes[lane].as_ref());
        true
    }
}

impl<A, F, M, T, W, const N: usize> March<'_, A, M, T, W, N>
where
    A: Paced<T, Family = F> + Method<M::In<T>, T, N>,
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Evaluates the derivatives at the starts of the next trajectories, as many as there are lanes, and finds their
    /// first steps. Those that stop there are left out. Returns false if none is waiting.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn make_ready<V: Lanes<Scalar = T>>(&mut self, ready: &mut Ready<T, N>, control: &StepControl<T>) -> bool {
        let (mut indices, mut count) = ([0; MOST_LANES], 0);
        while count < V::LANES
            && let Some(index) = self.next()
        {
            (indices[count], count) = (index, count + 1);
        }
        if count == 0 {
            return false;
        }
        let index = |lane: usize| indices[lane.min(count - 1)];
        // another model than that of the lanes, which stays in registers
        let system = &Expanded::<M, V, N>::gather(|lane| model_of(self.models, index(lane)));
        let t0 = V::splat(self.span.0);
        let mut x = SVector::from([V::default(); N]);
        set_lanes(&mut x, |lane| Some(&self.x[index(lane)]));
        let slopes = system.rhs(t0, &x);
        let first = self.first_steps(control, system, (t0, &x, &slopes), index);
        for lane in (0..count).rev() {
            let (index, slope) = (indices[lane], in_lane(&slopes, lane));
            let mut pace = self.pace(index).unwrap_or(control.start());
            let mut work = Statistics {
                evaluations: 1,
                ..Statistics::default()
            };
            if let Some(h) = first[lane] {
                pace.h = h;
                work.evaluations += 1;
            }
            let point = (self.span.0, self.x[index], &slope);
            if self.starts(index, point, Some(control.tolerance), &work) {
                ready.push(Start { index, slope, pace });
            }
        }
        true
    }

    /// First steps of the trajectories that have not begun in an earlier span; `None` for all if the length is set.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn first_steps<V: Lanes<Scalar = T>>(
        &self,
        control: &StepControl<T>,
        system: &Expanded<M, V, N>,
        (t0, x, slopes): (V, &SVector<V, N>, &SVector<V, N>),
        index: impl Fn(usize) -> usize,
    ) -> [Option<T>; MOST_LANES] {
        let begins = |lane| self.pace(index(lane)).is_none();
        let bounds = control.bounds_of_first(self.span.1 - self.span.0);
        let Some((h_max, direction)) = bounds.filter(|_| (0..V::LANES).any(begins)) else {
            return [None; MOST_LANES];
        };
        let (tolerance, active) = (&control.tolerance, system.active());
        let mut trials = [Trial::default(); MOST_LANES];
        for (lane, trial) in trials.iter_mut().enumerate().take(V::LANES) {
            *trial = tolerance.trial((&self.x[index(lane)], &in_lane(slopes, lane)), active, h_max);
        }
        let signed = V::from_fn(|lane| trials[lane].length * direction);
        let mut after = *x;
        for (x, &slope) in after.data.0[0].iter_mut().zip(&slopes.data.0[0]) {
            *x += slope * signed;
        }
        let after = system.rhs(t0 + signed, &after);
        let mut first = [None; MOST_LANES];
        for (lane, first) in first.iter_mut().enumerate().take(V::LANES) {
            if begins(lane) {
                let vectors = (&self.x[index(lane)], &in_lane(slopes, lane), &in_lane(&after, lane));
                *first = Some(tolerance.first_after(trials[lane], vectors, active, (control.error_order, h_max)));
            }
        }
        first
    }
}
