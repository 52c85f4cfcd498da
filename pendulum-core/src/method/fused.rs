//! Integrations in fused arithmetic, of models, events and states in `f64`.

use nalgebra::SVector;

use crate::dense::{Dense, Step};
use crate::ensemble::{Ensemble, EnsembleError, Stopped};
use crate::error::{Reason, SolveError};
use crate::event::{Event, Missed, Occurrence};
use crate::hybrid::{Ambiguity, Impact, Mode};
use crate::method::{Adaptive, Fixed, Method, watch};
use crate::real::Fused;
use crate::solution::{Need, Observer, Solution};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::{Cast, IntoState};

/// A method that computes in [`Fused`] arithmetic, for models that can be [cast](Cast); `A` is the method.
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

impl<A> FusedMethod<A> {
    /// Like [`Method::solve`].
    ///
    /// # Errors
    /// Errors of [`Method::solve`].
    pub fn solve<M, const N: usize>(
        &self,
        model: &M,
        t0: f64,
        t1: f64,
        x0: impl IntoState<f64, N>,
    ) -> Result<Solution<f64, N>, SolveError<f64, N>>
    where
        A: Method<M::In<Fused<f64>>, Fused<f64>, N>,
        M: Cast<N>,
    {
        self.solve_with(model, t0, t1, x0, &[])
    }

    /// Like [`Method::solve_with`].
    ///
    /// # Errors
    /// Errors of [`Method::solve_with`].
    pub fn solve_with<M, const N: usize>(
        &self,
        model: &M,
        t0: f64,
        t1: f64,
        x0: impl IntoState<f64, N>,
        events: &[Event<'_, f64, N>],
    ) -> Result<Solution<f64, N>, SolveError<f64, N>>
    where
        A: Method<M::In<Fused<f64>>, Fused<f64>, N>,
        M: Cast<N>,
    {
        let x0 = x0.into_state();
        let model = model.cast::<Fused<f64>>();
        let mut stepper = match self.0.stepper(&model, Fused(t0), Fused(t1), fused(&x0)) {
            Ok(stepper) => stepper,
            Err(reason) => return Err(SolveError::at_start(reason, t0, x0)),
        };
        let mut solution = Solution::start(t0, plain(&stepper.start(fused(&x0))));
        let tolerance = self.0.tolerance();
        let observer = &mut Plain(&mut solution);
        let ended = stepper.watched(fused(&x0), &fused_events(events), tolerance, observer);
        watch::concluded(ended, solution)
    }

    /// Like [`Method::follow`].
    ///
    /// # Errors
    /// Errors of [`Method::follow`].
    pub fn follow<M, const N: usize>(
        &self,
        model: &M,
        t0: f64,
        t1: f64,
        x0: impl IntoState<f64, N>,
        events: &[Event<'_, f64, N>],
        observer: &mut impl Observer<f64, N>,
    ) -> Result<SVector<f64, N>, Reason>
    where
        A: Method<M::In<Fused<f64>>, Fused<f64>, N>,
        M: Cast<N>,
    {
        let (model, x0) = (model.cast::<Fused<f64>>(), fused(&x0.into_state()));
        let (events, observer) = (fused_events(events), &mut Plain(observer));
        let end = self.0.follow(&model, Fused(t0), Fused(t1), x0, &events, observer)?;
        Ok(plain(&end))
    }

    /// Like [`Ensemble::ensemble`].
    ///
    /// # Errors
    /// Errors of [`Ensemble::ensemble`].
    pub fn ensemble<M, const N: usize>(
        &self,
        models: &[M],
        t0: f64,
        t1: f64,
        starts: &[SVector<f64, N>],
    ) -> Result<Vec<SVector<f64, N>>, EnsembleError<f64, N>>
    where
        A: Ensemble<M, Fused<f64>, N>,
    {
        let starts: Vec<_> = starts.iter().map(fused).collect();
        let all = |states: Vec<SVector<Fused<f64>, N>>| states.iter().map(plain).collect();
        match self.0.ensemble(models, Fused(t0), Fused(t1), &starts) {
            Ok(ends) => Ok(all(ends)),
            Err(EnsembleError::InvalidInput(reason)) => Err(EnsembleError::InvalidInput(reason)),
            Err(EnsembleError::Stopped { stopped, x }) => {
                let stopped = stopped
                    .into_iter()
                    .map(|Stopped { index, t, reason }| Stopped::new(index, t.0, reason));
                Err(EnsembleError::Stopped {
                    stopped: stopped.collect(),
                    x: all(x),
                })
            }
        }
    }
}

fn fused<const N: usize>(x: &SVector<f64, N>) -> SVector<Fused<f64>, N> {
    x.map(Fused)
}

fn plain<const N: usize>(x: &SVector<Fused<f64>, N>) -> SVector<f64, N> {
    x.map(|x| x.0)
}

fn fused_events<'e, const N: usize>(events: &'e [Event<'_, f64, N>]) -> Vec<Event<'e, Fused<f64>, N>> {
    let function = |event: &'e Event<'_, f64, N>| {
        event.with(
            |t: Fused<f64>, x: &SVector<Fused<f64>, N>| Fused((event.function)(t.0, &plain(x))),
            event
                .reset
                .as_ref()
                .map(|reset| |t: Fused<f64>, x: &SVector<Fused<f64>, N>| fused(&reset(t.0, &plain(x)))),
        )
    };
    events.iter().map(function).collect()
}

/// An observer of an integration in fused arithmetic.
struct Plain<'o, O>(&'o mut O);

impl<O: Observer<f64, N>, const N: usize> Observer<Fused<f64>, N> for Plain<'_, O> {
    fn start(&mut self, t: Fused<f64>, x: &SVector<Fused<f64>, N>) {
        self.0.start(t.0, &plain(x));
    }

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }

    fn needs(&self, t0: Fused<f64>, t1: Fused<f64>) -> Need {
        self.0.needs(t0.0, t1.0)
    }

    fn keeps_all(&self) -> bool {
        self.0.keeps_all()
    }

    fn within(&mut self, tolerance: Tolerance<Fused<f64>>) {
        self.0.within(Tolerance {
            rtol: tolerance.rtol.0,
            atol: tolerance.atol.0,
        });
    }

    fn step(&mut self, dense: &Dense<'_, Fused<f64>, N>) {
        let step = dense.step();
        let step = Step::new((step.t0.0, plain(&step.x0)), (step.t1.0, plain(&step.x1)));
        let terms: Vec<_> = dense.terms().iter().map(plain).collect();
        self.0.step(&Dense::new(step, &terms));
    }

    fn jump(&mut self, t: Fused<f64>, x: SVector<Fused<f64>, N>) {
        self.0.jump(t.0, plain(&x));
    }

    fn event(&mut self, event: Occurrence<Fused<f64>, N>) {
        let Occurrence { index, t, x } = event;
        self.0.event(Occurrence {
            index,
            t: t.0,
            x: plain(&x),
        });
    }

    fn missed(&mut self, missed: Missed<Fused<f64>>) {
        let Missed { index, from, to } = missed;
        self.0.missed(Missed {
            index,
            from: from.0,
            to: to.0,
        });
    }

    fn mode(&mut self, from: Fused<f64>, mode: Mode) {
        self.0.mode(from.0, mode);
    }

    fn finish(&mut self, statistics: Statistics) {
        self.0.finish(statistics);
    }

    fn impact(&mut self, impact: Impact<Fused<f64>, N>) {
        self.0.impact(Impact {
            t: impact.t.0,
            impulses: impact.impulses.map(|impulse| impulse.0),
            before: plain(&impact.before),
            after: plain(&impact.after),
        });
    }

    fn ambiguity(&mut self, ambiguity: Ambiguity<Fused<f64>>) {
        let Ambiguity { t, difference, set } = ambiguity;
        self.0.ambiguity(Ambiguity {
            t: t.0,
            difference: difference.0,
            set,
        });
    }
}
