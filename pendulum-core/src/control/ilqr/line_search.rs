//! The line search along the change of the inputs.

use nalgebra::SVector;

use super::backward::Promise;
use super::{Ilqr, Objective, StepMap};
use crate::real::Float;

/// Maximum number of halvings of the change of the inputs.
const HALVINGS: usize = 8;
/// Share of the promised decrease that a step has to reach.
const SUFFICIENT: f64 = 1e-2;

/// A line search that found no share of the change of the inputs to decrease the cost enough.
#[derive(Clone, Copy, Debug)]
pub(super) struct NoShare<T> {
    /// Cost of the last trial, that of the least share; `None` if its motion ended early.
    pub(super) last: Option<T>,
}

impl<C, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<C, T, N, M, K>
where
    C: Objective<T, N, M>,
{
    /// Takes the largest share of the change of the inputs that decreases the cost enough. Returns the cost and the
    /// share.
    ///
    /// # Errors
    /// If there is none.
    pub(super) fn line_search<S>(
        &mut self,
        model: &S,
        t0: T,
        x0: &SVector<T, N>,
        (cost, promise): (T, Promise<T>),
    ) -> Result<(T, T), NoShare<T>>
    where
        S: StepMap<T, N, M>,
    {
        let (mut share, mut last) = (T::from_f64(1.0), None);
        for _ in 0..=HALVINGS {
            let promised = promise.of(share);
            last = self.forward(model, t0, x0, share).ok();
            if let Some(next) = last
                && promised > T::default()
                && cost - next >= T::from_f64(SUFFICIENT) * promised
            {
                self.plan = self.trial;
                self.change = [[T::default(); M]; K];
                return Ok((next, share));
            }
            share *= T::from_f64(0.5);
        }
        Err(NoShare { last })
    }
}
