//! Model-predictive control: a pass at each sample.

use nalgebra::SVector;

use super::{Ilqr, IlqrError, Objective, StepMap};
use crate::control::Controller;
use crate::real::Float;

/// A [`Controller`] that plans anew at each sample, by [`Ilqr::pass`], and commands the first inputs of its plan:
/// [`Ilqr::controller`] makes it.
///
/// Measurements are the whole state. The plan moves on with the time, by whole steps, so that the period of the samples
/// is best that of the steps. A command that cannot be computed is NaN, at which [`Sampled`](crate::control::Sampled)
/// stops. [`Ilqr::pass`] from the last state of its solution returns the reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Predictive<S, I> {
    model: S,
    ilqr: I,
}

/// Memory of a [`Predictive`] controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PredictiveState<T, I> {
    /// Its plan.
    pub ilqr: I,
    /// Time of the start of the plan; `None` before the first sample.
    pub t: Option<T>,
    /// Reason why the last command was not computed.
    pub failure: Option<IlqrError>,
}

impl<C, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<C, T, N, M, K>
where
    C: Objective<T, N, M>,
{
    /// A controller that repeats [`pass`](Self::pass) at each sample, beginning with this motion.
    ///
    /// # Errors
    /// Settings out of range.
    pub fn controller<S>(self, model: S) -> Result<Predictive<S, Self>, IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        self.check(&model, T::default(), &self.plan.x[0])?;
        Ok(Predictive { model, ilqr: self })
    }
}

impl<S, C, T, const N: usize, const M: usize, const K: usize> Controller<T, N, M> for Predictive<S, Ilqr<C, T, N, M, K>>
where
    S: StepMap<T, N, M>,
    C: Objective<T, N, M> + Copy,
    T: Float,
{
    type State = PredictiveState<T, Ilqr<C, T, N, M, K>>;

    fn start(&self, _period: T) -> Self::State {
        PredictiveState {
            ilqr: self.ilqr,
            t: None,
            failure: None,
        }
    }

    fn sample(&self, t: T, measured: &SVector<T, N>, state: &mut Self::State) -> [T; M] {
        // before the plan moves on: a time that is not finite would spoil its clock
        if let Err(failure) = state.ilqr.check(&self.model, t, measured) {
            state.failure = Some(failure);
            return [T::from_f64(f64::NAN); M];
        }
        let h = state.ilqr.h;
        let mut start = state.t.unwrap_or(t);
        // At most one plan: what follows its end repeats its last inputs.
        for _ in 0..K {
            if t - start < T::from_f64(0.5) * h {
                break;
            }
            state.ilqr.shift();
            start += h;
        }
        if t - start >= h {
            start = t;
        }
        state.t = Some(start);
        match state.ilqr.checked_pass(&self.model, t, measured) {
            Ok(_) => {
                state.failure = None;
                state.ilqr.plan.u[0]
            }
            Err(failure) => {
                state.failure = Some(failure);
                [T::from_f64(f64::NAN); M]
            }
        }
    }
}
