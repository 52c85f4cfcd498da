//! Recorded trajectories of sampled controllers.

use nalgebra::SVector;

use super::trajectory::{Driven, Witness};
use super::{Commanded, Controller, Outputs, Sample, Sampled};
use crate::dense::Dense;
use crate::error::{Reason, SolveError};
use crate::event::{Event, Missed, Occurrence};
use crate::forward::forward;
use crate::hybrid::{Ambiguity, Impact, Mode};
use crate::inputs::{Controlled, WithInputs};
use crate::method::{Method, Scheme, Search, Stepper, check_start, require};
use crate::real::Float;
use crate::solution::{Need, Observer, Solution};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::{IntoState, System};

/// Maximum number of samples of a record.
const MOST_KEPT: f64 = 1e7;

/// A trajectory under a [`Sampled`] controller.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SampledSolution<T, const N: usize, const P: usize, const M: usize> {
    /// The motion, with dense output; its steps end at each sample and at each change of the inputs.
    pub trajectory: Solution<T, N>,
    /// The samples, in the order of time.
    pub samples: Vec<Sample<T, P, M>>,
    /// Inputs until the first command acts.
    pub start: [T; M],
}

impl<T: Float, const N: usize, const P: usize, const M: usize> SampledSolution<T, N, P, M> {
    /// Inputs that act on the model at the time `t`; where they change, those after the change.
    #[must_use]
    pub fn inputs_at(&self, t: T) -> [T; M] {
        let acting = self.samples.partition_point(|sample| sample.acts_from <= t);
        acting
            .checked_sub(1)
            .map_or(self.start, |last| self.samples[last].inputs)
    }
}

impl<C, W, const P: usize, const M: usize> Sampled<C, W, P, M> {
    /// Integrates `model` under this controller from the state `x0` at `t0` to `t1`, and records the trajectory and the
    /// samples.
    ///
    /// # Errors
    /// Errors of [`end`](Self::end), with the solution up to the last good state.
    pub fn solve<A, S, T, const N: usize>(
        &self,
        method: &A,
        model: &S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<SampledSolution<T, N, P, M>, SolveError<T, N>>
    where
        A: for<'c> Method<WithInputs<S, Commanded<'c, T, M>, M>, T, N>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: Controlled<T, N, M> + Clone,
        T: Float,
    {
        self.solve_with(method, model, t0, t1, x0, &[])
    }

    /// Like [`solve`](Self::solve), but with events, as [`Method::solve_with`] has them: they are located between
    /// samples, on the dense output.
    ///
    /// A terminal event ends the trajectory. Where an event resets the state, the controller keeps its memory, and the
    /// inputs their values. At the time of a sample, the event comes first, and the sample measures the state after it.
    ///
    /// ```
    /// use pendulum_core::control::{Pid, Sampled};
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Cart {
    ///         input push: N,
    ///         body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
    ///     }
    /// }
    ///
    /// let cart = Cart::new(CartParams {})?;
    /// let sampled = Sampled::of_components(Pid::new(20.0, 0.0, 4.0).set_point(1.0), 0.01, [Cart::S]);
    /// let arrives = Event::new(|_t, x: &SVector<f64, 2>| x[Cart::S] - 0.9).rising().terminal();
    /// let motion = sampled.solve_with(&Tsit5::new(), &cart, 0.0, 5.0, [0.0, 0.0], &[arrives])?;
    /// let (t, x) = motion.trajectory.last();
    /// assert!((x[Cart::S] - 0.9).abs() < 1e-12 && t < 1.0);
    /// assert_eq!(motion.samples.len(), (100.0 * t).ceil() as usize);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Errors of [`end`](Self::end), [`Reason::EventNotFinite`], [`Reason::EventsAccumulate`] and
    /// [`Reason::BadReset`], with the solution up to the last good state.
    pub fn solve_with<A, S, T, const N: usize>(
        &self,
        method: &A,
        model: &S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
        events: &[Event<'_, T, N>],
    ) -> Result<SampledSolution<T, N, P, M>, SolveError<T, N>>
    where
        A: for<'c> Method<WithInputs<S, Commanded<'c, T, M>, M>, T, N>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: Controlled<T, N, M> + Clone,
        T: Float,
    {
        let x0 = x0.into_state();
        let count = (t1 - t0).to_f64() / self.period;
        let rule = "more than ten million samples to store; lengthen the period, or use `end`, which stores none";
        check_start(t0, t1, &x0)
            .and_then(|()| self.check((t0, t1)))
            .and_then(|()| require(count <= MOST_KEPT, "period", self.period, rule))
            .map_err(|reason| SolveError::at_start(reason, t0, x0))?;
        let mut trajectory = Solution::start(t0, x0);
        let mut samples = Vec::new();
        let keep = |sample| samples.push(sample);
        match self.follow(method, model, (t0, t1), x0, events, &mut trajectory, keep) {
            Ok(_) => Ok(SampledSolution {
                trajectory,
                samples,
                start: self.start.map(T::from_f64),
            }),
            Err(reason) => Err(SolveError {
                reason,
                solution: Box::new(trajectory),
            }),
        }
    }

    /// Like [`solve_with`](Self::solve_with), but passes the trajectory over `span` to an observer and each sample to a
    /// function, and returns the final state. Only these store anything.
    ///
    /// # Errors
    /// Reasons of [`solve_with`](Self::solve_with), and [`Reason::Cancelled`]. The observer has then received the
    /// trajectory up to the last good state.
    #[allow(clippy::too_many_arguments, reason = "those of `Method::follow`, and the samples")]
    pub fn follow<A, S, T, const N: usize>(
        &self,
        method: &A,
        model: &S,
        span: (T, T),
        x0: impl IntoState<T, N>,
        events: &[Event<'_, T, N>],
        observer: &mut impl Observer<T, N>,
        sample: impl FnMut(Sample<T, P, M>),
    ) -> Result<SVector<T, N>, Reason>
    where
        A: for<'c> Method<WithInputs<S, Commanded<'c, T, M>, M>, T, N>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: Controlled<T, N, M> + Clone,
        T: Float,
    {
        let x0 = x0.into_state();
        method
            .tolerance()
            .into_iter()
            .for_each(|tolerance| observer.within(tolerance));
        let mut recorder = Recorder {
            legs: Legwise {
                observer,
                has_started: false,
                mode: None,
                has_jumped: false,
                is_known: false,
            },
            events,
            search: None,
            end: None,
            sample,
            work: Statistics::default(),
        };
        let ended = self.drive(method, model, span, x0, self.member, &mut recorder);
        let work = recorder.work;
        observer.finish(work);
        ended.map_err(|halt| halt.reason)
    }
}

/// Passes a trajectory and its samples on.
struct Recorder<'o, 'w, 'e, O, F, T, const N: usize> {
    legs: Legwise<'o, O, T>,
    events: &'w [Event<'e, T, N>],
    /// The search for events, from the first leg on.
    search: Option<Search<'w, 'e, T, N>>,
    /// State at a terminal event.
    end: Option<SVector<T, N>>,
    sample: F,
    work: Statistics,
}

impl<'c, S, T, O, F, const N: usize, const P: usize, const M: usize> Witness<Driven<'c, S, T, M>, T, N, P, M>
    for Recorder<'_, '_, '_, O, F, T, N>
where
    S: Controlled<T, N, M>,
    T: Float,
    O: Observer<T, N>,
    F: FnMut(Sample<T, P, M>),
{
    const IS_DENSE: bool = true;

    fn leg<C: Scheme<Driven<'c, S, T, M>, T, N>>(
        &mut self,
        stepper: &mut Stepper<'_, C, Driven<'c, S, T, M>, T, N>,
        x0: SVector<T, N>,
        jump: bool,
    ) -> Result<(), Reason>
    where
        Driven<'c, S, T, M>: System<T, N>,
    {
        if self.legs.has_started {
            // an event at the end of the last leg has restarted the stepper there, where it does not begin
            stepper.begin_anew(jump || stepper.is_at_rest())?;
        }
        let (t, x) = (stepper.t(), stepper.x());
        let search = match &mut self.search {
            Some(search) => {
                if x != x0 {
                    search.restart((t, stepper.t1(), t.abs()), &x, &[])?;
                }
                search
            }
            None => self.search.insert(Search::new(self.events, t, &x)?),
        };
        let ended = stepper.follow_on(x0, search, &mut self.legs);
        self.work = stepper.statistics();
        let (x, is_the_end) = ended.map_err(|early| early.reason)?;
        self.end = is_the_end.then_some(x);
        Ok(())
    }

    fn end(&self) -> Option<SVector<T, N>> {
        self.end
    }

    fn sample(&mut self, sample: Sample<T, P, M>) {
        (self.sample)(sample);
    }
}

/// Observer of a trajectory in parts: it passes on the start of the first one only, and no mode that goes on.
struct Legwise<'o, O, T> {
    observer: &'o mut O,
    has_started: bool,
    /// Last mode that was passed on, and its start.
    mode: Option<(T, Mode)>,
    /// True if the state jumped right before.
    has_jumped: bool,
    /// True if the mode and its impacts were passed on before.
    is_known: bool,
}

impl<O: Observer<T, N>, T: Float, const N: usize> Observer<T, N> for Legwise<'_, O, T> {
    fn start(&mut self, t: T, x: &SVector<T, N>) {
        if !self.has_started {
            self.observer.start(t, x);
        }
        self.has_started = true;
    }

    fn needs(&self, t0: T, t1: T) -> Need {
        // `step` notes that no jump is left to announce
        self.observer.needs(t0, t1).max(Need::Ends)
    }

    forward! { self => self.observer;
        keeps_all() -> bool;
        is_cancelled() -> bool;
        [mut] within(tolerance: Tolerance<T>);
        [mut] event(event: Occurrence<T, N>);
        [mut] missed(missed: Missed<T>);
    }

    fn step(&mut self, dense: &Dense<'_, T, N>) {
        self.observer.step(dense);
        (self.has_jumped, self.is_known) = (false, false);
    }

    fn jump(&mut self, t: T, x: SVector<T, N>) {
        self.observer.jump(t, x);
        self.has_jumped = true;
    }

    fn mode(&mut self, from: T, mode: Mode) {
        self.is_known = !self.has_jumped && self.mode.is_some_and(|(_, before)| before == mode);
        if !self.is_known {
            self.observer.mode(from, mode);
            self.mode = Some((from, mode));
        }
        self.has_jumped = false;
    }

    fn impact(&mut self, impact: Impact<T, N>) {
        if !self.is_known {
            self.observer.impact(impact);
        }
    }

    fn ambiguity(&mut self, ambiguity: Ambiguity<T>) {
        if !self.is_known {
            self.observer.ambiguity(ambiguity);
        }
    }
}
