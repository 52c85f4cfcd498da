//! Where an ensemble begins: its arguments are checked, and its trajectories sent on their way.

use nalgebra::SVector;

use super::together::Together;
use super::watch::{Unwatched, Watch, Watched};
use super::{Ensemble, EnsembleError, ObservedEnsemble, adaptive, check_models, check_observers, conclude, fixed};
use crate::event::Event;
use crate::method::{Adaptive, Estimates, Fixed, Grid, Scheme, check_span};
use crate::real::lanes::{Isa, LaneElement};
use crate::solution::Observer;
use crate::system::Cast;

impl<M, F, T, const N: usize> Ensemble<M, T, N> for Adaptive<F>
where
    M: Cast<N>,
    F: Together<M, T, N> + Estimates,
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
        within_tolerance(self, isa, models, (t0, t1), starts, Unwatched)
    }
}

impl<M, F, T, const N: usize> ObservedEnsemble<M, T, N> for Adaptive<F>
where
    M: Cast<N>,
    F: Together<M, T, N> + Estimates,
    T: LaneElement,
{
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
        within_tolerance(self, isa, models, span, starts, Watched::new(observers, events))
    }
}

fn within_tolerance<M, F, T, W, const N: usize>(
    method: &Adaptive<F>,
    isa: Isa,
    models: &[M],
    (t0, t1): (T, T),
    starts: &[SVector<T, N>],
    watch: W,
) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
where
    M: Cast<N>,
    F: Together<M, T, N> + Estimates,
    T: LaneElement,
    W: Watch<T, N>,
{
    check_span(t0, t1)?;
    check_models(models, starts)?;
    // settings are wrong for all trajectories, or for none
    if let Some(model) = models.first() {
        let tolerance = method.tolerance()?;
        let scheme = method.family.scheme(&model.cast(), Some(tolerance))?;
        method.control(tolerance, scheme.error_order(), (t0, t1))?;
    }
    let mut x = starts.to_vec();
    let mut stopped = Vec::new();
    let march = adaptive::March {
        method,
        models,
        span: (t0, t1),
        waiting: 0..x.len(),
        x: &mut x,
        stopped: &mut stopped,
        watch,
    };
    F::within_tolerance(isa, march)?;
    conclude(x, stopped)
}

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
        on_grid(self, isa, models, (t0, t1), starts, Unwatched)
    }
}

impl<M, F, T, const N: usize> ObservedEnsemble<M, T, N> for Fixed<F>
where
    M: Cast<N>,
    F: Together<M, T, N>,
    T: LaneElement,
{
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
        on_grid(self, isa, models, span, starts, Watched::new(observers, events))
    }
}

fn on_grid<M, F, T, W, const N: usize>(
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
    if watch.keeps_all() {
        grid.check_to_keep()?;
    }
    check_models(models, starts)?;
    // settings are wrong for all trajectories, or for none
    if let Some(model) = models.first() {
        method.family.scheme(&model.cast(), None)?;
    }
    let mut x = starts.to_vec();
    let mut stopped = Vec::new();
    let march = fixed::March {
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
