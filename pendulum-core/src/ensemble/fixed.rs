//! Many trajectories with steps of the same length.

use nalgebra::SVector;

use super::check::{first_not_finite, in_lane};
use super::together::Together;
use super::watch::{Unwatched, Watch, Watched};
use super::{Ensemble, EnsembleError, InLanes, Stopped, alone, check_models, check_observers, conclude, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::event::Event;
use crate::hybrid::{Hold, InMode};
use crate::method::{Accepted, Fixed, Grid, OneStep, Scheme, Stalled, check_span};
use crate::real::lanes::{Isa, Kernel, LaneElement, Lanes};
use crate::solution::Observer;
use crate::statistics::Statistics;
use crate::system::Cast;

impl<M, F, T, const N: usize> Ensemble<M, T, N> for Fixed<F>
where
    M: Cast<N>,
    F: Together<M, T, N>,
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
        run(self, isa, models, (t0, t1), starts, Unwatched)
    }

    fn observe_on<'w, 'e: 'w, O>(
        &self,
        isa: Isa,
        models: &[M],
        span: (T, T),
        starts: &[SVector<T, N>],
        events: impl Fn(usize) -> &'w [Event<'e, T, N>],
        observers: &mut [O],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
    where
        O: Observer<T, N>,
        T: 'w,
    {
        check_observers(observers, starts)?;
        run(self, isa, models, span, starts, Watched::new(observers, events))
    }
}

fn run<M, F, T, W, const N: usize>(
    method: &Fixed<F>,
    isa: Isa,
    models: &[M],
    (t0, t1): (T, T),
    starts: &[SVector<T, N>],
    watch: W,
) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
where
    M: Cast<N>,
    F: Together<M, T, N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    check_span(t0, t1)?;
    let grid = Grid::new(method.h, t0, t1)?;
    check_models(models, starts)?;
    // settings are wrong for all trajectories, or for none
    if let Some(model) = models.first() {
        method.family.scheme(&model.cast(), None)?;
    }
    let mut x = starts.to_vec();
    let mut stopped = Vec::new();
    let march = March {
        method,
        models,
        grid,
        x: &mut x,
        stopped: &mut stopped,
        watch,
    };
    F::on_grid(isa, march)?;
    conclude(x, stopped)
}

/// Trajectories on their way from the states `x`, which are replaced.
pub struct March<'a, F, M, T, W, const N: usize> {
    method: &'a Fixed<F>,
    models: &'a [M],
    grid: Grid<T>,
    x: &'a mut [SVector<T, N>],
    stopped: &'a mut Vec<Stopped<T>>,
    watch: W,
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
        if const { !M::HYBRID && !F::NARROW && !W::WATCHES } {
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
            let member = |lane: usize| lane.min(states.len() - 1);
            let system = F::gather::<V>(|lane| model_of(self.models, first + member(lane)));
            let scheme = self.method.family.stages::<V>(&system, None)?;
            let x = SVector::from_fn(|k, _| V::from_fn(|lane| states[member(lane)][k]));
            let ends = march(&system, scheme, x, self.grid);
            for (lane, state) in states.iter_mut().enumerate() {
                match &ends {
                    Ok((x, slope)) if first_not_finite(x, slope.as_ref(), lane).is_none() => *state = in_lane(x, lane),
                    _ => failed.push(first + lane),
                }
            }
        }
        self.alone(failed);
        Ok(())
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
