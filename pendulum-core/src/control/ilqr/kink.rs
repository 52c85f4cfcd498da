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
use super::matrix::{plus_product, product, scaled, transposed, zeros};
use super::{Ilqr, Objective, StepDerivatives, StepMap};
use crate::real::Float;

/// Least weight of a gradient that is worth another direction.
const LEAST_WEIGHT: f64 = 1e-3;

impl<C, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<C, T, N, M, K>
where
    C: Objective<T, N, M>,
{
    /// A line search along the change of the inputs that the linear motion has. Where an impact moves across a node,
    /// the state there jumps, and the gains would answer to that.
    pub(super) fn line_search_without_gains<S>(
        &mut self,
        model: &S,
        t0: T,
        x0: &SVector<T, N>,
        promise: (T, Promise<T>),
    ) -> Result<(T, T), bool>
    where
        S: StepMap<T, N, M>,
    {
        let mut dx = zeros();
        for k in 0..K {
            let (t, x, u) = (self.time(t0, k), &self.plan.x[k], &self.plan.u[k]);
            let StepDerivatives { a, b } = model.step_derivatives(t, self.h, x, u).map_err(|_| false)?;
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
    /// weight of the other gradient, apart from limits of the inputs, and given by three weights.
    pub(super) fn tilt<S>(&mut self, model: &S, t0: T, tilt: &mut Option<[[T; M]; K]>, promised: T) -> bool
    where
        S: StepMap<T, N, M>,
    {
        let across = self.gradient(model, t0);
        self.trial = self.plan;
        let (Some(across), Some(here)) = (across, self.gradient(model, t0)) else {
            return false;
        };
        let before = tilt.unwrap_or([[T::default(); M]; K]);
        let tilted = |weight: T| {
            core::array::from_fn(|k| {
                core::array::from_fn(|m| before[k][m] + weight * (across[k][m] - here[k][m] - before[k][m]))
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
        let weight = (promised - last + bend) / (two * bend);
        // false for NaN as well
        let is_useful = bend > T::default() && weight > T::from_f64(LEAST_WEIGHT);
        *tilt = Some(tilted(weight.min(one)));
        is_useful
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
