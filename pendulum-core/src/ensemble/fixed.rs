//! Many trajectories with steps of the same length.

use nalgebra::SVector;

use super::check::{all_finite, first_not_finite, in_lane};
use super::{Ensemble, EnsembleError, InLanes, MOST_LANES, Stopped, check_models, conclude, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::method::{Accepted, Failure, Fixed, Grid, NonFinite, Scheme, check_span, check_state};
use crate::real::Float;
use crate::real::lanes::{Isa, Kernel, LaneElement, Lanes};
use crate::solution::Statistics;
use crate::system::Cast;

impl<M, F, T, const N: usize> Ensemble<M, T, N> for Fixed<F>
where
    M: Cast<N>,
    F: InLanes<M, T, N>,
    T: LaneElement,
{
    fn ensemble_on(
        &self,
        isa: Isa,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>> {
        check_span(t0, t1)?;
        let grid = Grid::new(self.h, t0, t1)?;
        check_models(models, starts)?;
        let mut x = starts.to_vec();
        let mut stopped = Vec::new();
        isa.run(March {
            family: &self.family,
            models,
            grid,
            x: &mut x,
            stopped: &mut stopped,
        })?;
        conclude(x, stopped)
    }
}

/// Trajectories on their way from the states `x`, which are replaced.
struct March<'a, F, M, T, const N: usize> {
    family: &'a F,
    models: &'a [M],
    grid: Grid<T>,
    x: &'a mut [SVector<T, N>],
    stopped: &'a mut Vec<Stopped<T>>,
}

impl<F, M, T, const N: usize> Kernel<T> for March<'_, F, M, T, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
{
    type Output = Result<(), Reason>;

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        // Further lanes fill the gaps where operations wait for one another, but that of `f32` is two already where it
        // computes sines. A longer system has enough that are independent, and needs the registers for itself.
        if const { F::NARROW } {
            self.in_groups::<V>()
        } else if const { size_of::<T>() < size_of::<f64>() } {
            self.in_groups::<V::Double>()
        } else {
            self.in_groups::<<V::Double as Lanes>::Double>()
        }
    }
}

impl<F, M, T, const N: usize> March<'_, F, M, T, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
{
    /// As many trajectories at a time as there are lanes; where they run out, the last fills the group.
    #[inline(always)]
    fn in_groups<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        for (number, states) in self.x.chunks_mut(V::LANES).enumerate() {
            let first = number * V::LANES;
            let member = |lane: usize| lane.min(states.len() - 1);
            let system = F::gather::<V>(|lane| model_of(self.models, first + member(lane)));
            let scheme = self.family.stages::<V>(&system, None)?;
            let x = SVector::from_fn(|k, _| V::from_fn(|lane| states[member(lane)][k]));
            let group = Group {
                first,
                states,
                stopped: self.stopped,
                is_stopped: [false; MOST_LANES],
            };
            group.march(&system, scheme, x, self.grid);
        }
        Ok(())
    }
}

/// Trajectories that take their steps together.
struct Group<'a, T, const N: usize> {
    /// The place of the first among all.
    first: usize,
    /// Where each starts, and then where it ends.
    states: &'a mut [SVector<T, N>],
    stopped: &'a mut Vec<Stopped<T>>,
    is_stopped: [bool; MOST_LANES],
}

impl<T: Float, const N: usize> Group<'_, T, N> {
    /// Goes from the states `x` to the end of the grid.
    #[inline(always)]
    fn march<C, S, V>(mut self, system: &S, mut scheme: C, x: SVector<V, N>, mut grid: Grid<T>)
    where
        C: Scheme<S, V, N>,
        V: Lanes<Scalar = T>,
    {
        let work = &mut Statistics::default();
        let mut t = grid.t0();
        let (mut states, mut others) = (x, x);
        // They change places with each step, where copies would take their time.
        let (mut x, mut x_new) = (&mut states, &mut others);
        let mut all_go = self.stop_where(t, x, |lane| check_state(&in_lane(x, lane)).err());
        if t != grid.t1() {
            let slope = scheme.begin(system, V::splat(t), x, work);
            if !all_finite(&slope, None) {
                let check = |lane| NonFinite::check(&in_lane(&slope, lane));
                all_go = self.stop_where(t, x, |lane| check(lane).err().map(NonFinite::at_start));
            }
        }
        while t != grid.t1() {
            let t_new = grid.next();
            let (start, end) = (V::splat(t), V::splat(t_new));
            let attempt = scheme.attempt(system, (start, x), (end, x_new), work);
            let slope = scheme.arrive(system, (end, x_new), work);
            if !(attempt.is_ok() && all_go && all_finite(x_new, slope)) {
                let h = (t_new - t).to_f64();
                all_go = self.stop_where(t, x, |lane| {
                    let stalled = attempt.err().map(Failure::from);
                    let failure = stalled.or_else(|| first_not_finite(x_new, slope, lane).map(Failure::from));
                    failure.map(|failure| failure.reason(h))
                });
            }
            scheme.accept(system, &Step::new((start, *x), (end, *x_new)), Accepted::All, work);
            std::mem::swap(&mut x, &mut x_new);
            t = t_new;
        }
        for (lane, state) in self.states.iter_mut().enumerate() {
            if !self.is_stopped[lane] {
                *state = in_lane(x, lane);
            }
        }
    }

    /// Stops the trajectories for which there is a reason, in their states `x`: whether all go on.
    #[cold]
    fn stop_where<V: Lanes<Scalar = T>>(
        &mut self,
        t: T,
        x: &SVector<V, N>,
        reason: impl Fn(usize) -> Option<Reason>,
    ) -> bool {
        for (lane, state) in self.states.iter_mut().enumerate() {
            if !self.is_stopped[lane]
                && let Some(reason) = reason(lane)
            {
                let index = self.first + lane;
                self.stopped.push(Stopped { index, t, reason });
                *state = in_lane(x, lane);
                self.is_stopped[lane] = true;
            }
        }
        !self.is_stopped.contains(&true)
    }
}
