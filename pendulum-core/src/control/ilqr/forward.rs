//! The forward pass: the motion under the changed inputs, and its cost.

use nalgebra::SVector;

use super::{Ilqr, IlqrError, Objective, StepMap};
use crate::real::Float;
use crate::real::lanes::Routine;

/// The motion from the state `x0` at `t0`, into `trial`: the inputs of the plan, plus a share of their change, plus the
/// gains times the deviation from the plan.
///
/// Returns its cost.
pub(super) struct Forward<T, const N: usize> {
    pub(super) t0: T,
    pub(super) x0: SVector<T, N>,
    pub(super) share: T,
}

impl<C, S, T, const N: usize, const M: usize, const K: usize> Routine<Ilqr<C, T, N, M, K>, S> for Forward<T, N>
where
    C: Objective<T, N, M>,
    S: StepMap<T, N, M>,
    T: Float,
{
    type Output = Result<T, IlqrError>;

    #[inline(always)]
    fn run(self, ilqr: &mut Ilqr<C, T, N, M, K>, model: &S) -> Self::Output {
        let (mut x, mut cost) = (self.x0, T::default());
        for k in 0..K {
            let t = ilqr.time(self.t0, k);
            let u = ilqr.law(k, self.share, &x);
            (ilqr.trial.x[k], ilqr.trial.u[k]) = (x, u);
            cost += ilqr.h * ilqr.cost.running(t, &x, &u);
            x = match model.step(t, ilqr.h, &x, &u) {
                Ok(end) => end,
                Err(reason) => {
                    return Err(IlqrError::StepFailed {
                        node: k,
                        reason: reason.into(),
                    });
                }
            };
            let is_finite = x.data.0[0].iter().all(|component| component.is_finite());
            if !is_finite {
                return Err(IlqrError::Diverged { node: k, t: t.to_f64() });
            }
        }
        ilqr.trial.end = x;
        let t = ilqr.time(self.t0, K);
        cost += ilqr.cost.end(t, &x);
        match cost.is_finite() {
            true => Ok(cost),
            false => Err(IlqrError::Diverged { node: K, t: t.to_f64() }),
        }
    }
}
