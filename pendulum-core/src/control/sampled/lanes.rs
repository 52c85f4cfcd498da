//! Sampled controllers of many trajectories at once, in lanes.

use nalgebra::SVector;

use super::held::Holding;
use super::legs::{Leg, Legs};
use super::run::Run;
use super::trajectory::{Halt, Unseen};
use super::{Commanded, Controller, Outputs, Sampled};
use crate::ensemble::{EnsembleError, Marches, Stopped, check_models, check_number, conclude, go_on, model_of};
use crate::error::Reason;
use crate::inputs::{CastControlled, WithInputs};
use crate::method::{Method, Pace, check_span, place};
use crate::real::lanes::LaneElement;
use crate::system::Cast;

/// A method that integrates models `S` of type `T` under [`Sampled`] controllers, in lanes if it can.
///
/// It is implemented for all methods but `Taylor` and the Gauss methods, which take no inputs.
pub trait SampledMethod<S, T, const N: usize, const M: usize>:
    Marches<Holding<S, M>, T, N> + for<'c> Method<WithInputs<S::In<T>, Commanded<'c, T, M>, M>, T, N>
where
    S: CastControlled<N, M>,
    T: LaneElement,
{
}

impl<A, S, T, const N: usize, const M: usize> SampledMethod<S, T, N, M> for A
where
    A: Marches<Holding<S, M>, T, N> + for<'c> Method<WithInputs<S::In<T>, Commanded<'c, T, M>, M>, T, N>,
    S: CastControlled<N, M>,
    T: LaneElement,
{
}

impl<C, W, const P: usize, const M: usize> Sampled<C, W, P, M> {
    /// Integrates from each of the states `starts` at `t0` to `t1` under this controller, in lanes, and returns the
    /// final states.
    ///
    /// Pass one model per start, or a single model for all. Each trajectory has its own noise, that of the
    /// [`member`](Self::member) with its index. Each final state is bit for bit that of [`end`](Self::end). Explicit
    /// methods and Rosenbrock methods run in lanes; others, and all methods for [hybrid](crate::hybrid) systems,
    /// integrate one trajectory after the other, as [`solve_with`](Self::solve_with) does where there are events.
    ///
    /// ```
    /// use pendulum_core::control::{Pid, Sampled};
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Cart {
    ///         params { m: kg = 2 }
    ///         input push: N,
    ///         body cart on ground { mass: m, joint: prismatic(x), coordinate: s, torque: push }
    ///     }
    /// }
    ///
    /// let carts = [1.0, 2.0, 3.0].map(|m| Cart::new(CartParams { m }).unwrap());
    /// let sampled = Sampled::of_components(Pid::new(20.0, 0.0, 10.0), 0.01, [Cart::S]).noise([1e-3]);
    /// let starts = [SVector::from([1.0, 0.0]); 3];
    /// let ends = sampled.ensemble(&Tsit5::new(), &carts, 0.0, 10.0, &starts)?;
    /// assert_eq!(ends[1], sampled.member(1).end(&Tsit5::new(), &carts[1], 0.0, 10.0, starts[1])?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EnsembleError::InvalidInput`] if there is neither one model nor one for each start, or if times or settings
    /// are invalid. [`EnsembleError::Stopped`] lists the trajectories that stopped early, and holds the final states of
    /// the others.
    pub fn ensemble<A, S, T, const N: usize>(
        &self,
        method: &A,
        models: &[S],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
    where
        A: SampledMethod<S, T, N, M>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: CastControlled<N, M, In<T>: Clone> + Clone,
        T: LaneElement,
    {
        self.check((t0, t1))?;
        self.outputs.check()?;
        Self::ensemble_of(core::slice::from_ref(self), method, models, t0, t1, starts)
    }

    /// Like [`ensemble`](Self::ensemble), with one controller per start, such as those of different gains, or a single
    /// one for all.
    ///
    /// The final state of trajectory `i` is bit for bit that of `controllers[i].end`, with the noise of that
    /// controller: give each a [member](Self::member) of its own if their noise shall differ. A single controller
    /// counts on from its member, as in [`ensemble`](Self::ensemble). Trajectories share lanes if all controllers have
    /// one period and one delay; otherwise they are integrated one after the other.
    ///
    /// # Errors
    /// Errors of [`ensemble`](Self::ensemble), and [`EnsembleError::InvalidInput`] if there is neither one controller
    /// nor one for each start. Trajectories whose controller has invalid settings are among those that stopped.
    pub fn ensemble_of<A, S, T, const N: usize>(
        controllers: &[Self],
        method: &A,
        models: &[S],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
    where
        A: SampledMethod<S, T, N, M>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: CastControlled<N, M, In<T>: Clone> + Clone,
        T: LaneElement,
    {
        const {
            assert!(
                !T::HAS_SLOPES,
                "`Sampled::end` carries derivatives, one trajectory after the other"
            )
        };
        check_span(t0, t1)?;
        method.check((t0, t1), false)?;
        let holding = models.iter().cloned().map(|system| Holding {
            system,
            inputs: [0.0; M],
        });
        let holding: Vec<_> = holding.collect();
        check_models(&holding, starts)?;
        let rule = "an ensemble takes one controller for all starts, or one for each";
        check_number("controllers", controllers, starts, rule)?;
        let mut ends = starts.to_vec();
        let [first, ..] = controllers else {
            return Ok(ends);
        };
        let mut stopped = Vec::new();
        let shares_clock = |other: &Self| (other.period, other.delay) == (first.period, first.delay);
        if S::HYBRID || !A::GOES_ON || !controllers.iter().all(shares_clock) {
            for (index, x) in ends.iter_mut().enumerate() {
                let model = model_of(models, index).cast();
                let (controller, member) = Self::of(controllers, index);
                let end = controller.drive(method, &model, (t0, t1), *x, member, &mut Unseen);
                *x = end.unwrap_or_else(|Halt { reason, t, x }| {
                    stopped.push(Stopped::new(index, t, reason));
                    x
                });
            }
            return conclude(ends, stopped);
        }
        let mut flock = Flock::start(controllers, holding, (t0, t1), &mut ends, &mut stopped);
        let mut legs = Legs::new((t0, t1), first.period, first.delay);
        while !flock.index.is_empty()
            && let Some(leg) = legs.next()
        {
            flock.command(controllers, (&leg, &legs), &mut ends, &mut stopped);
            if leg.from != leg.to {
                flock.integrate(method, &leg, &mut ends, &mut stopped)?;
            }
        }
        flock.leave(|_| true, &mut ends);
        conclude(ends, stopped)
    }

    /// The controller of a trajectory, and the member whose noise it has.
    fn of(controllers: &[Self], index: usize) -> (&Self, u64) {
        match controllers {
            [controller] => (controller, controller.member.wrapping_add(index as u64)),
            _ => (&controllers[index], controllers[index].member),
        }
    }
}

/// The trajectories that have not stopped, each at the same place of all lists.
struct Flock<S, T, B, const N: usize, const M: usize> {
    /// Index of the trajectory.
    index: Vec<usize>,
    models: Vec<Holding<S, M>>,
    x: Vec<SVector<T, N>>,
    paces: Vec<Option<Pace<T>>>,
    runs: Vec<Run<T, B, M>>,
    /// True after the first leg.
    goes_on: bool,
}

impl<S, T, B, const N: usize, const M: usize> Flock<S, T, B, N, M>
where
    S: CastControlled<N, M> + Clone,
    T: LaneElement,
    B: Copy,
{
    /// All trajectories whose start is valid. The others stop.
    fn start<C, W, const P: usize>(
        controllers: &[Sampled<C, W, P, M>],
        models: Vec<Holding<S, M>>,
        span: (T, T),
        ends: &mut [SVector<T, N>],
        stopped: &mut Vec<Stopped<T>>,
    ) -> Self
    where
        C: Controller<T, P, M, State = B>,
        W: Outputs<T, N, P>,
    {
        let mut flock = Self {
            index: Vec::new(),
            models: Vec::new(),
            x: Vec::new(),
            paces: Vec::new(),
            runs: Vec::new(),
            goes_on: false,
        };
        for (index, start) in ends.iter().enumerate() {
            let model = model_of(&models, index);
            let (controller, member) = Sampled::of(controllers, index);
            let checked = controller.check(span).and_then(|()| controller.outputs.check());
            match checked.and_then(|()| place(&Cast::cast::<T>(model), span.0, start)) {
                Ok(x) => {
                    flock.index.push(index);
                    flock.models.push(model.clone());
                    flock.x.push(x);
                    flock.paces.push(None);
                    flock.runs.push(controller.run(member));
                }
                Err(reason) => stopped.push(Stopped::new(index, span.0, reason)),
            }
        }
        flock
    }

    /// Takes the samples at the start of a leg, and sets the inputs during it.
    fn command<C, W, const P: usize>(
        &mut self,
        controllers: &[Sampled<C, W, P, M>],
        (leg, legs): (&Leg<T>, &Legs<T>),
        ends: &mut [SVector<T, N>],
        stopped: &mut Vec<Stopped<T>>,
    ) where
        C: Controller<T, P, M, State = B>,
        W: Outputs<T, N, P>,
    {
        let before = stopped.len();
        for (place, run) in self.runs.iter_mut().enumerate() {
            if leg.samples
                && let (sampled, _) = Sampled::of(controllers, self.index[place])
                && let Err(reason) = sampled.sample(run, (leg, legs), &self.x[place], drop)
            {
                stopped.push(Stopped::new(self.index[place], leg.from, reason));
            }
            self.models[place].inputs = run.inputs(leg).map(|input| input.to_f64());
        }
        self.remove(&stopped[before..], ends);
    }

    /// Integrates over a leg.
    fn integrate<A>(
        &mut self,
        method: &A,
        leg: &Leg<T>,
        ends: &mut [SVector<T, N>],
        stopped: &mut Vec<Stopped<T>>,
    ) -> Result<(), Reason>
    where
        A: Marches<Holding<S, M>, T, N>,
    {
        let before = stopped.len();
        let going = (&mut self.x[..], &mut self.paces[..]);
        go_on(method, &self.models, (leg.from, leg.to), going, self.goes_on, stopped)?;
        self.goes_on = true;
        for stopped in &mut stopped[before..] {
            stopped.index = self.index[stopped.index];
        }
        self.remove(&stopped[before..], ends);
        Ok(())
    }

    fn remove(&mut self, stopped: &[Stopped<T>], ends: &mut [SVector<T, N>]) {
        if !stopped.is_empty() {
            self.leave(|index| stopped.iter().any(|stopped| stopped.index == index), ends);
        }
    }

    /// Ends the trajectories whose index `leaves`, in their states.
    fn leave(&mut self, leaves: impl Fn(usize) -> bool, ends: &mut [SVector<T, N>]) {
        for place in (0..self.index.len()).rev() {
            if leaves(self.index[place]) {
                ends[self.index[place]] = self.x[place];
                self.index.swap_remove(place);
                self.models.swap_remove(place);
                self.x.swap_remove(place);
                self.paces.swap_remove(place);
                self.runs.swap_remove(place);
            }
        }
    }
}
