//! Trajectories of sampled controllers, one at a time.

use core::cell::Cell;

use nalgebra::SVector;

use super::legs::Legs;
use super::{Commanded, Controller, Outputs, Sample, Sampled};
use crate::error::Reason;
use crate::inputs::{Controlled, WithInputs};
use crate::method::{Method, Scheme, Stepper, check_start, place};
use crate::real::Float;
use crate::system::{IntoState, System};

/// A model with commanded inputs.
pub(super) type Driven<'c, S, T, const M: usize> = WithInputs<S, Commanded<'c, T, M>, M>;

/// Premature end of a trajectory.
#[cfg_attr(not(feature = "std"), allow(dead_code, reason = "only ensembles return the place"))]
pub(super) struct Halt<T, const N: usize> {
    pub(super) reason: Reason,
    pub(super) t: T,
    pub(super) x: SVector<T, N>,
}

/// Receives the parts of a trajectory.
pub(super) trait Witness<S, T: Float, const N: usize, const P: usize, const M: usize> {
    /// True if the dense output of a step may be requested.
    const IS_DENSE: bool;

    /// Integrates a leg to its end, from the state `x0` that the stepper has reached, and where the inputs may `jump`.
    fn leg<C: Scheme<S, T, N>>(
        &mut self,
        stepper: &mut Stepper<'_, C, S, T, N>,
        x0: SVector<T, N>,
        jump: bool,
    ) -> Result<(), Reason>
    where
        S: System<T, N>;

    /// The state at a terminal event, if one has ended the trajectory.
    #[inline]
    fn end(&self) -> Option<SVector<T, N>> {
        None
    }

    /// Receives a sample.
    fn sample(&mut self, _sample: Sample<T, P, M>) {}
}

/// Records nothing.
pub(super) struct Unseen;

impl<S, T: Float, const N: usize, const P: usize, const M: usize> Witness<S, T, N, P, M> for Unseen {
    const IS_DENSE: bool = false;

    #[inline]
    fn leg<C: Scheme<S, T, N>>(
        &mut self,
        stepper: &mut Stepper<'_, C, S, T, N>,
        _x0: SVector<T, N>,
        jump: bool,
    ) -> Result<(), Reason>
    where
        S: System<T, N>,
    {
        // on the first leg this repeats the evaluation at the start
        stepper.run_anew(jump)
    }
}

impl<C, W, const P: usize, const M: usize> Sampled<C, W, P, M> {
    /// Integrates `model` under this controller from the state `x0` at `t0` to `t1`, and returns the final state.
    /// Records nothing, and allocates nothing on the heap.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] and [`Reason::StartBeyondLimits`] for settings out of range,
    /// [`Reason::CommandNotFinite`], and errors of [`Stepper::step`].
    pub fn end<A, S, T, const N: usize>(
        &self,
        method: &A,
        model: &S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<SVector<T, N>, Reason>
    where
        A: for<'c> Method<WithInputs<S, Commanded<'c, T, M>, M>, T, N>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: Controlled<T, N, M> + Clone,
        T: Float,
    {
        self.drive(method, model, (t0, t1), x0.into_state(), self.member, &mut Unseen)
            .map_err(|halt| halt.reason)
    }

    /// Integrates leg by leg. Returns the final state.
    pub(super) fn drive<A, S, T, O, const N: usize>(
        &self,
        method: &A,
        model: &S,
        span: (T, T),
        x0: SVector<T, N>,
        member: u64,
        witness: &mut O,
    ) -> Result<SVector<T, N>, Halt<T, N>>
    where
        A: for<'c> Method<Driven<'c, S, T, M>, T, N>,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
        S: Controlled<T, N, M> + Clone,
        T: Float,
        O: for<'c> Witness<Driven<'c, S, T, M>, T, N, P, M>,
    {
        let halt = |t, x| move |reason| Halt { reason, t, x };
        let held = Cell::new(self.start.map(T::from_f64));
        let system = WithInputs::of(model.clone(), Commanded(&held));
        let placed = self.check_start(span, &x0).and_then(|()| place(&system, span.0, &x0));
        let mut x = placed.map_err(halt(span.0, x0))?;
        let mut run = self.run(member);
        let mut legs = Legs::new(span, self.period, self.delay);
        let mut stepper: Option<Stepper<'_, _, _, T, N>> = None;
        while let Some(leg) = legs.next() {
            if leg.samples {
                self.sample(&mut run, (&leg, &legs), &x, |sample| witness.sample(sample))
                    .map_err(halt(leg.from, x))?;
            }
            if leg.from == leg.to {
                continue;
            }
            let (inputs, before) = (run.inputs(&leg), held.get());
            let differs = |m: usize| inputs[m] != before[m] || !inputs[m].has_same_slopes(&before[m]);
            let jump = stepper.is_some() && (0..M).any(differs);
            held.set(inputs);
            let stepper = match &mut stepper {
                Some(stepper) => stepper.move_end(leg.to).map(|()| stepper),
                None => {
                    let first = method.stepper(&system, leg.from, leg.to, x);
                    first.map(|first| {
                        let first = stepper.insert(first);
                        first.keep_pace();
                        first
                    })
                }
            };
            let stepper = stepper.map_err(halt(leg.from, x))?;
            stepper.leave_end(leg.to != span.1 && !O::IS_DENSE);
            let ended = witness.leg(stepper, x, jump);
            x = stepper.x();
            ended.map_err(halt(stepper.t(), x))?;
            if let Some(end) = witness.end() {
                return Ok(end);
            }
        }
        Ok(x)
    }

    /// Checks the settings, the span and the initial state.
    fn check_start<T: Float, const N: usize>(&self, span: (T, T), x0: &SVector<T, N>) -> Result<(), Reason>
    where
        W: Outputs<T, N, P>,
    {
        check_start(span.0, span.1, x0)?;
        self.check(span)?;
        self.outputs.check()
    }
}
