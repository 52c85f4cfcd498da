//! Integrations in fused arithmetic, of models, events and states in `f64` or dual numbers.

use core::marker::PhantomData;

use nalgebra::SVector;

use crate::dense::{Dense, Step};
use crate::dual::Dual;
use crate::ensemble::{Ensemble, EnsembleError, Stopped};
use crate::error::{Reason, SolveError};
use crate::event::{Event, Missed, Occurrence};
use crate::hybrid::{Ambiguity, Impact, Mode};
use crate::method::{Adaptive, Fixed, Method, watch};
use crate::real::lanes::LaneElement;
use crate::real::{Float, Fused};
use crate::solution::{Need, Observer, Solution};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::{Cast, IntoState};

/// A method that computes in [`Fused`] arithmetic, for models that can be [cast](Cast); `A` is the method.
///
/// Times, states and events are `f64`, or [dual numbers](Dual) of `f64`; functions of
/// [`sensitivity`](crate::sensitivity) take it like any other method.
///
/// Results are bit-identical on every machine, and differ from those of the method itself in the last bits. Where the
/// processor has fused operations, as most x86-64 processors since 2013 and all ARM processors of 64 bits, the steps of
/// smooth systems take a tenth less time; where it has none, several times longer. On x86-64, code outside the steps,
/// as of [hybrid](crate::hybrid) systems, calls a function for each sum unless it is compiled with
/// `-C target-cpu=native`: motions with dry friction and stops then take up to twice the time.
///
/// It is not a [`Method`], whose numbers are those of its system; [`solve`](Self::solve) and its siblings cast the
/// model.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Swing {
///         gravity: [0, -9.81, 0],
///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
///     }
/// }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let swing = Swing::new(SwingParams {})?;
/// let method = Vern9::new().rtol(1e-10).atol(1e-10);
/// let plain = method.solve(&swing, 0.0, 10.0, [1.0, 0.0])?;
/// let fused = method.fused().solve(&swing, 0.0, 10.0, [1.0, 0.0])?;
/// assert!((fused.end() - plain.end()).amax() < 1e-8);
/// # Ok(())
/// # }
/// ```
///
/// The settings are those of the method: set them before. A [`Stepper`](crate::Stepper) in fused arithmetic is that of
/// the method itself for `model.cast::<Fused<f64>>()`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FusedMethod<A>(A);

impl<F> Adaptive<F> {
    /// The method in fused arithmetic.
    #[must_use]
    pub fn fused(self) -> FusedMethod<Self> {
        FusedMethod(self)
    }
}

impl<F> Fixed<F> {
    /// The method in fused arithmetic.
    #[must_use]
    pub fn fused(self) -> FusedMethod<Self> {
        FusedMethod(self)
    }
}

/// A number that has a [fused](Fused) counterpart: `f64`, or a [dual number](Dual) of `f64`.
pub trait Fusible: Float {
    /// The fused number.
    type Fused: LaneElement;

    /// Converts the number to a fused one.
    fn fused(self) -> Self::Fused;

    /// Converts a fused number back.
    fn plain(fused: Self::Fused) -> Self;
}

impl Fusible for f64 {
    type Fused = Fused<f64>;

    #[inline(always)]
    fn fused(self) -> Fused<f64> {
        Fused(self)
    }

    #[inline(always)]
    fn plain(fused: Fused<f64>) -> f64 {
        fused.0
    }
}

impl<const K: usize> Fusible for Dual<f64, K> {
    type Fused = Dual<Fused<f64>, K>;

    #[inline(always)]
    fn fused(self) -> Self::Fused {
        Dual {
            value: Fused(self.value),
            slopes: self.slopes.map(Fused),
        }
    }

    #[inline(always)]
    fn plain(fused: Self::Fused) -> Self {
        Self {
            value: fused.value.0,
            slopes: fused.slopes.map(|slope| slope.0),
        }
    }
}

impl<A> FusedMethod<A> {
    /// Like [`Method::solve`].
    ///
    /// # Errors
    /// Errors of [`Method::solve`].
    pub fn solve<M, T: Fusible, const N: usize>(
        &self,
        model: &M,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<Solution<T, N>, SolveError<T, N>>
    where
        A: Method<M::In<T::Fused>, T::Fused, N>,
        M: Cast<N>,
    {
        self.solve_with(model, t0, t1, x0, &[])
    }

    /// Like [`Method::solve_with`].
    ///
    /// # Errors
    /// Errors of [`Method::solve_with`].
    pub fn solve_with<M, T: Fusible, const N: usize>(
        &self,
        model: &M,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
        events: &[Event<'_, T, N>],
    ) -> Result<Solution<T, N>, SolveError<T, N>>
    where
        A: Method<M::In<T::Fused>, T::Fused, N>,
        M: Cast<N>,
    {
        let x0 = x0.into_state();
        let model = model.cast::<T::Fused>();
        let mut stepper = match self.0.stepper(&model, t0.fused(), t1.fused(), fused(&x0)) {
            Ok(stepper) => stepper,
            Err(reason) => return Err(SolveError::at_start(reason, t0, x0)),
        };
        let mut solution = Solution::start(t0, plain(&stepper.start(fused(&x0))));
        let tolerance = self.0.tolerance();
        let observer = &mut Plain::new(&mut solution);
        let ended = stepper.watched(fused(&x0), &fused_events(events), tolerance, observer);
        watch::concluded(ended, solution)
    }

    /// Like [`Method::follow`].
    ///
    /// # Errors
    /// Errors of [`Method::follow`].
    pub fn follow<M, T: Fusible, const N: usize>(
        &self,
        model: &M,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
        events: &[Event<'_, T, N>],
        observer: &mut impl Observer<T, N>,
    ) -> Result<SVector<T, N>, Reason>
    where
        A: Method<M::In<T::Fused>, T::Fused, N>,
        M: Cast<N>,
    {
        let (model, x0) = (model.cast::<T::Fused>(), fused(&x0.into_state()));
        let (events, observer) = (fused_events(events), &mut Plain::new(observer));
        let end = self.0.follow(&model, t0.fused(), t1.fused(), x0, &events, observer)?;
        Ok(plain(&end))
    }

    /// Like [`Method::stepper`] and [`Stepper::run`](crate::Stepper::run): the last state, without a heap.
    ///
    /// # Errors
    /// Errors of [`Method::stepper`] and of [`Stepper::run`](crate::Stepper::run).
    pub fn end<M, T: Fusible, const N: usize>(
        &self,
        model: &M,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<SVector<T, N>, Reason>
    where
        A: Method<M::In<T::Fused>, T::Fused, N>,
        M: Cast<N>,
    {
        let model = model.cast::<T::Fused>();
        let mut stepper = self
            .0
            .stepper(&model, t0.fused(), t1.fused(), fused(&x0.into_state()))?;
        Ok(plain(&stepper.run()?))
    }

    /// Like [`Ensemble::ensemble`].
    ///
    /// # Errors
    /// Errors of [`Ensemble::ensemble`].
    pub fn ensemble<M, T: Fusible, const N: usize>(
        &self,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
    where
        A: Ensemble<M, T::Fused, N>,
    {
        let starts: Vec<_> = starts.iter().map(fused).collect();
        let all = |states: Vec<SVector<T::Fused, N>>| states.iter().map(plain).collect();
        match self.0.ensemble(models, t0.fused(), t1.fused(), &starts) {
            Ok(ends) => Ok(all(ends)),
            Err(EnsembleError::InvalidInput(reason)) => Err(EnsembleError::InvalidInput(reason)),
            Err(EnsembleError::Stopped { stopped, x }) => {
                let stopped = stopped
                    .into_iter()
                    .map(|Stopped { index, t, reason }| Stopped::new(index, T::plain(t), reason));
                Err(EnsembleError::Stopped {
                    stopped: stopped.collect(),
                    x: all(x),
                })
            }
        }
    }
}

fn fused<T: Fusible, const N: usize>(x: &SVector<T, N>) -> SVector<T::Fused, N> {
    x.map(T::fused)
}

fn plain<T: Fusible, const N: usize>(x: &SVector<T::Fused, N>) -> SVector<T, N> {
    x.map(T::plain)
}

fn fused_events<'e, T: Fusible, const N: usize>(events: &'e [Event<'_, T, N>]) -> Vec<Event<'e, T::Fused, N>> {
    let function = |event: &'e Event<'_, T, N>| {
        event.with(
            |t: T::Fused, x: &SVector<T::Fused, N>| (event.function)(T::plain(t), &plain(x)).fused(),
            event
                .reset
                .as_ref()
                .map(|reset| |t: T::Fused, x: &SVector<T::Fused, N>| fused(&reset(T::plain(t), &plain(x)))),
        )
    };
    events.iter().map(function).collect()
}

/// An observer of an integration in fused arithmetic, which receives numbers of type `T`.
struct Plain<'o, O, T> {
    observer: &'o mut O,
    numbers: PhantomData<T>,
}

impl<'o, O, T> Plain<'o, O, T> {
    fn new(observer: &'o mut O) -> Self {
        Self {
            observer,
            numbers: PhantomData,
        }
    }
}

impl<O: Observer<T, N>, T: Fusible, const N: usize> Observer<T::Fused, N> for Plain<'_, O, T> {
    fn start(&mut self, t: T::Fused, x: &SVector<T::Fused, N>) {
        self.observer.start(T::plain(t), &plain(x));
    }

    fn is_cancelled(&self) -> bool {
        self.observer.is_cancelled()
    }

    fn needs(&self, t0: T::Fused, t1: T::Fused) -> Need {
        self.observer.needs(T::plain(t0), T::plain(t1))
    }

    fn keeps_all(&self) -> bool {
        self.observer.keeps_all()
    }

    fn within(&mut self, tolerance: Tolerance<T::Fused>) {
        self.observer.within(Tolerance {
            rtol: T::plain(tolerance.rtol),
            atol: T::plain(tolerance.atol),
        });
    }

    fn step(&mut self, dense: &Dense<'_, T::Fused, N>) {
        let step = dense.step();
        let step = Step::new(
            (T::plain(step.t0), plain(&step.x0)),
            (T::plain(step.t1), plain(&step.x1)),
        );
        let terms: Vec<_> = dense.terms().iter().map(plain).collect();
        self.observer.step(&Dense::new(step, &terms));
    }

    fn jump(&mut self, t: T::Fused, x: SVector<T::Fused, N>) {
        self.observer.jump(T::plain(t), plain(&x));
    }

    fn event(&mut self, event: Occurrence<T::Fused, N>) {
        let Occurrence { index, t, x } = event;
        self.observer.event(Occurrence {
            index,
            t: T::plain(t),
            x: plain(&x),
        });
    }

    fn missed(&mut self, missed: Missed<T::Fused>) {
        let Missed { index, from, to } = missed;
        self.observer.missed(Missed {
            index,
            from: T::plain(from),
            to: T::plain(to),
        });
    }

    fn mode(&mut self, from: T::Fused, mode: Mode) {
        self.observer.mode(T::plain(from), mode);
    }

    fn finish(&mut self, statistics: Statistics) {
        self.observer.finish(statistics);
    }

    fn impact(&mut self, impact: Impact<T::Fused, N>) {
        self.observer.impact(Impact {
            t: T::plain(impact.t),
            impulses: impact.impulses.map(T::plain),
            before: plain(&impact.before),
            after: plain(&impact.after),
        });
    }

    fn ambiguity(&mut self, ambiguity: Ambiguity<T::Fused>) {
        let Ambiguity { t, difference, set } = ambiguity;
        self.observer.ambiguity(Ambiguity {
            t: T::plain(t),
            difference: T::plain(difference),
            set,
        });
    }
}
