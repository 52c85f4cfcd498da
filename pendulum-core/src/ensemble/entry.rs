//! Entry points of ensembles: they check the arguments and start the trajectories.

use nalgebra::SVector;

use super::march::{Checked, March};
use super::together::Marches;
use super::watch::{Unwatched, Watch, Watched};
use super::{Ensemble, EnsembleError, ObservedEnsemble, Stopped, check_models, check_observers, conclude};
use crate::error::Reason;
use crate::event::Event;
use crate::method::{OneStep, Pace, Scheme, check_span};
use crate::real::lanes::{Isa, LaneElement};
use crate::solution::Observer;
use crate::system::Cast;

impl<A, M, T, const N: usize> Ensemble<M, T, N> for A
where
    A: Marches<M, T, N>,
    A::Family: OneStep<M::In<T>, T, N>,
    M: Cast<N>,
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
        send(self, isa, models, (t0, t1), starts, Unwatched)
    }
}

impl<A, M, T, const N: usize> ObservedEnsemble<M, T, N> for A
where
    A: Marches<M, T, N>,
    A::Family: OneStep<M::In<T>, T, N>,
    M: Cast<N>,
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
        send(self, isa, models, span, starts, Watched::new(observers, events))
    }
}

/// Checks the arguments and integrates the trajectories.
fn send<A, M, T, W, const N: usize>(
    method: &A,
    isa: Isa,
    models: &[M],
    span: (T, T),
    starts: &[SVector<T, N>],
    watch: W,
) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
where
    A: Marches<M, T, N>,
    A::Family: OneStep<M::In<T>, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    // Invalid settings are invalid for every trajectory, so one check covers all.
    check_span(span.0, span.1)?;
    method.check(span, watch.keeps_all())?;
    check_models(models, starts)?;
    if let Some(model) = models.first() {
        let scheme = method.family().scheme(&model.cast(), method.within()?)?;
        method.steps(scheme.error_order(), span)?;
    }
    let mut x = starts.to_vec();
    let mut stopped = Vec::new();
    let march = March {
        method,
        models,
        checked: Checked::none(),
        span,
        waiting: 0..x.len(),
        x: &mut x,
        stopped: &mut stopped,
        watch,
        paces: None,
        goes_on: false,
    };
    A::run(isa, march)?;
    conclude(x, stopped)
}

/// Integrates trajectories over a part of their span, with steps as long as those before: `paces` has them, and
/// receives those at the end. The final states replace `x`. `goes_on` is false for the first part.
pub(crate) fn go_on<A, M, T, const N: usize>(
    method: &A,
    models: &[M],
    span: (T, T),
    (x, paces): (&mut [SVector<T, N>], &mut [Option<Pace<T>>]),
    goes_on: bool,
    stopped: &mut Vec<Stopped<T>>,
) -> Result<(), Reason>
where
    A: Marches<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
{
    let march = March {
        method,
        models,
        checked: Checked::none(),
        span,
        waiting: 0..x.len(),
        x,
        stopped,
        watch: Unwatched,
        paces: Some(paces),
        goes_on,
    };
    A::run(Isa::widest(), march)
}
