//! Where an ensemble begins: its arguments are checked, and its trajectories sent on their way.

use nalgebra::SVector;

use super::march::{March, Paced, Steps};
use super::together::Together;
use super::watch::{Unwatched, Watch, Watched};
use super::{Ensemble, EnsembleError, ObservedEnsemble, check_models, check_observers, conclude};
use crate::error::Reason;
use crate::event::Event;
use crate::method::{Adaptive, Estimates, Fixed, OneStep, Scheme, check_span};
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
        send(self, models, (t0, t1), starts, Unwatched, |march| {
            F::within_tolerance(isa, march)
        })
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
        let watch = Watched::new(observers, events);
        send(self, models, span, starts, watch, |march| {
            F::within_tolerance(isa, march)
        })
    }
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
        send(self, models, (t0, t1), starts, Unwatched, |march| {
            F::on_grid(isa, march)
        })
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
        let watch = Watched::new(observers, events);
        send(self, models, span, starts, watch, |march| F::on_grid(isa, march))
    }
}

/// Checks what is given, and sends the trajectories on their way.
fn send<A, M, T, W, const N: usize>(
    method: &A,
    models: &[M],
    span: (T, T),
    starts: &[SVector<T, N>],
    watch: W,
    on_their_way: impl FnOnce(March<'_, A, M, T, W, N>) -> Result<(), Reason>,
) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
where
    A: Paced<T>,
    A::Family: OneStep<M::In<T>, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    check_span(span.0, span.1)?;
    check_models(models, starts)?;
    // settings are wrong for all trajectories, or for none
    if let Some(model) = models.first() {
        let scheme = method.family().scheme(&model.cast(), method.within()?)?;
        let steps = method.steps(scheme.error_order(), span)?;
        if let Steps::Equal(grid) = steps
            && watch.keeps_all()
        {
            grid.check_to_keep()?;
        }
    }
    let mut x = starts.to_vec();
    let mut stopped = Vec::new();
    on_their_way(March {
        method,
        models,
        span,
        waiting: 0..x.len(),
        x: &mut x,
        stopped: &mut stopped,
        watch,
    })?;
    conclude(x, stopped)
}
