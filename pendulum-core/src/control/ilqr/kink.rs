//! Search at a kink of the cost, where an impact or another mode switch comes to a node.
//!
//! The gradients by the inputs differ on both sides. A direction that crosses the kink decreases the cost on neither,
//! so that the line search fails. Their convex combination of least norm, in the metric of the backward pass, gives the
//! direction along the kink, and vanishes at a minimum.
//!
//! C. Lemaréchal, "Nondifferentiable optimization", Handbooks in OR and MS 1 (1989) 529; K. C. Kiwiel, Math. Program.
//! 27 (1983) 320, for combinations that replace what they combine.

use nalgebra::SVector;

use super::backward::Promise;
use super::line_search::NoShare;
use super::matrix::{plus_product, product, scaled, transposed, zeros};
use super::{Ilqr, Objective, StepDerivatives, StepMap};
use crate::real::Float;

/// Least weight of a gradient that is worth another direction.
const LEAST_WEIGHT: f64 = 1e-3;

/// Combination of the gradients on both sides of a kink.
pub(super) struct Tilt<T, const M: usize, const K: usize> {
    /// Its difference from the gradient of the plan.
    pub(super) by_inputs: [[T; M]; K],
    /// Gradient of the plan.
    here: [[T; M]; K],
    /// Error, at the plan, of the linear model of the cost with this combination as its gradient.
    pub(super) error: T,
}

impl<C, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<C, T, N, M, K>
where
    C: Objective<T, N, M>,
{
    /// A line search along the change of the inputs that the linear motion has. Where an impact moves across a node,
    /// the state there jumps, and the gains would answer to that.
    ///
    /// Derivatives of the plan are computed again: those of the backward pass would take `K N (N + M)` numbers.
    pub(super) fn line_search_without_gains<S>(
        &mut self,
        model: &S,
        t0: T,
        x0: &SVector<T, N>,
        promise: (T, Promise<T>),
    ) -> Result<(T, T), NoShare<T>>
    where
        S: StepMap<T, N, M>,
    {
        let mut dx = zeros();
        for k in 0..K {
            let (t, x, u) = (self.time(t0, k), &self.plan.x[k], &self.plan.u[k]);
            let StepDerivatives { a, b } = model
                .step_derivatives(t, self.h, x, u)
                .map_err(|_| NoShare { last: None })?;
            let du = plus_product(self.change[k].into(), &transposed(&self.gain[k]), &dx);
            dx = plus_product(product(&a, &dx), &b, &du);
            self.change[k] = du.into();
        }
        let gain = core::mem::replace(&mut self.gain, [zeros(); K]);
        let found = self.line_search(model, t0, x0, promise);
        self.gain = gain;
        found
    }

    /// Tilts the gradient of the plan towards that of `trial`, on the other side of a kink, so that it has the least
    /// norm. False if it is least without, or has no derivatives.
    ///
    /// `promised` is the decrease promised with the `tilt` so far: half the square of the norm. It is quadratic in the
    /// weight of the other gradient, apart from limits of the inputs, and given by three weights. `decrease` is that of
    /// the cost from the plan to the trial. It differs from the linear one by the error of the other gradient at the
    /// plan, which counts against it: this gradient vanishes from the combination where the trial is far from the plan,
    /// or beyond a jump of the cost.
    pub(super) fn tilt<S>(
        &mut self,
        model: &S,
        t0: T,
        tilt: &mut Option<Tilt<T, M, K>>,
        promised: T,
        decrease: T,
    ) -> bool
    where
        S: StepMap<T, N, M>,
    {
        let Some(across) = self.gradient(model, t0) else {
            return false;
        };
        let error = (decrease - self.linear_decrease(&across)).abs();
        self.trial = self.plan;
        let before = match tilt.take() {
            Some(tilt) => tilt,
            None => match self.gradient(model, t0) {
                Some(here) => Tilt {
                    by_inputs: [[T::default(); M]; K],
                    here,
                    error: T::default(),
                },
                None => return false,
            },
        };
        let tilted = |weight: T| {
            core::array::from_fn(|k| {
                core::array::from_fn(|m| {
                    let from = before.by_inputs[k][m];
                    from + weight * (across[k][m] - before.here[k][m] - from)
                })
            })
        };
        let [half, one, two] = [0.5, 1.0, 2.0].map(T::from_f64);
        let mut promised_at = |weight| {
            self.backward(model, t0, Some(&tilted(weight)))
                .map(|promise| promise.of(one))
        };
        let (Ok(middle), Ok(last)) = (promised_at(half), promised_at(one)) else {
            return false;
        };
        let bend = two * (promised + last) - (two + two) * middle;
        let further = error - before.error;
        let weight = (promised - last + bend - further) / (two * bend);
        // false for NaN as well
        let is_useful = bend > T::default() && weight > T::from_f64(LEAST_WEIGHT);
        let weight = weight.min(one);
        *tilt = is_useful.then(|| Tilt {
            by_inputs: tilted(weight),
            here: before.here,
            error: before.error + weight * further,
        });
        is_useful
    }

    /// Decrease of the cost from the plan to `trial` by a gradient alone.
    fn linear_decrease(&self, gradient: &[[T; M]; K]) -> T {
        let mut linear = T::default();
        for (k, slopes) in gradient.iter().enumerate() {
            for (m, &slope) in slopes.iter().enumerate() {
                linear += slope * (self.plan.u[k][m] - self.trial.u[k][m]);
            }
        }
        linear
    }

    /// Gradient of the cost of `trial` by the inputs.
    fn gradient<S>(&self, model: &S, t0: T) -> Option<[[T; M]; K]>
    where
        S: StepMap<T, N, M>,
    {
        let mut by_inputs = [[T::default(); M]; K];
        let (mut by_state, _) = self.cost.end_derivatives(self.time(t0, K), &self.trial.end);
        for k in (0..K).rev() {
            let (t, x, u) = (self.time(t0, k), &self.trial.x[k], &self.trial.u[k]);
            let StepDerivatives { a, b } = model.step_derivatives(t, self.h, x, u).ok()?;
            let of_cost = self.cost.running_derivatives(t, x, u);
            by_inputs[k] = plus_product(scaled(self.h, &of_cost.u), &transposed(&b), &by_state).into();
            by_state = plus_product(scaled(self.h, &of_cost.x), &transposed(&a), &by_state);
        }
        Some(by_inputs)
    }
}
