//! The backward pass: the best change of each input, as a law of the change of the state.
//!
//! Y. Tassa, T. Erez, E. Todorov, "Synthesis and stabilization of complex behaviors through online trajectory
//! optimization", IROS (2012) 4906, for the recursion; Y. Tassa, N. Mansard, E. Todorov, ICRA (2014) 1168, for limits.

use nalgebra::{SMatrix, SVector};

use super::boxed::{Factor, Minimum, minimize};
use super::cost::dot;
use super::matrix::{plus, plus_product, product, scaled, transposed};
use super::{Ilqr, IlqrError, Objective, StepDerivatives, StepMap};
use crate::real::Float;
use crate::real::lanes::Routine;

/// Damping of a node above which the cost counts as not convex.
const LARGEST_DAMPING: f64 = 1e10;
/// Damping with which a node begins whose cost is not convex without.
const LEAST_DAMPING: f64 = 1e-6;

/// Decrease of the cost that the derivatives promise for a share `s` of the change of the inputs:
/// `-(s slope + s^2 bend)`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Promise<T> {
    slope: T,
    bend: T,
}

impl<T: Float> Promise<T> {
    pub(super) fn of(self, share: T) -> T {
        -share * (self.slope + share * self.bend)
    }
}

/// The backward pass of the motion in `trial`, which starts at the time `t0`. The diagonal of the second derivatives by
/// the inputs grows by the factor `1 + damping` (D. W. Marquardt, SIAM J. Appl. Math. 11 (1963) 431), whatever their
/// units.
pub(super) struct Backward<'t, T, const M: usize, const K: usize> {
    pub(super) t0: T,
    pub(super) damping: T,
    /// Difference of the gradient by the inputs from that of `trial`, at a kink of the cost.
    pub(super) tilt: Option<&'t [[T; M]; K]>,
}

impl<C, S, T, const N: usize, const M: usize, const K: usize> Routine<Ilqr<C, T, N, M, K>, S> for Backward<'_, T, M, K>
where
    C: Objective<T, N, M>,
    S: StepMap<T, N, M>,
    T: Float,
{
    type Output = Result<Promise<T>, IlqrError>;

    #[inline(always)]
    fn run(self, ilqr: &mut Ilqr<C, T, N, M, K>, model: &S) -> Self::Output {
        let h = ilqr.h;
        let mut promise = Promise::default();
        let (mut gradient, mut hessian) = ilqr.cost.end_derivatives(ilqr.time(self.t0, K), &ilqr.trial.end);
        let mut guess = [T::default(); M];
        for k in (0..K).rev() {
            let (t, x, u) = (ilqr.time(self.t0, k), &ilqr.trial.x[k], &ilqr.trial.u[k]);
            let StepDerivatives { a, b } = &match model.step_derivatives(t, h, x, u) {
                Ok(derivatives) => derivatives,
                Err(reason) => {
                    let reason = reason.into();
                    return Err(IlqrError::StepFailed { node: k, reason });
                }
            };
            let of_cost = ilqr.cost.running_derivatives(t, x, u);
            // Damping would hide it, and the search run away.
            if Factor::new(&of_cost.uu, [true; M]).is_none() {
                return Err(IlqrError::NotConvex { node: k });
            }

            let (to_a, to_b) = (transposed(a), transposed(b));
            let by_b = product(&hessian, b);
            let by_x = plus_product(scaled(h, &of_cost.x), &to_a, &gradient);
            let mut by_u = plus_product(scaled(h, &of_cost.u), &to_b, &gradient);
            if const { S::HAS_KINKS }
                && let Some(tilt) = self.tilt
            {
                by_u = plus(&by_u, &tilt[k].into());
            }
            let xx = plus_product(scaled(h, &of_cost.xx), &to_a, &product(&hessian, a));
            let xu = plus_product(scaled(h, &of_cost.xu), &to_a, &by_b);
            let uu = plus_product(scaled(h, &of_cost.uu), &to_b, &by_b);

            let (mut low, mut high) = (ilqr.low, ilqr.high);
            for m in 0..M {
                low[m] -= u[m];
                high[m] -= u[m];
            }
            let Some(minimum) = damped_minimum(&uu, &by_u.data.0[0], [&low, &high], &guess, self.damping) else {
                return Err(IlqrError::NotConvex { node: k });
            };
            guess = minimum.at;
            let change = SVector::from(minimum.at);
            let gain = minimum.factor.minus_solved(&xu);

            // The minimum of the quadratic model of the cost to go with these inputs, which damping moves.
            let bent = product(&uu, &change);
            promise.slope += dot(&by_u, &change);
            promise.bend += T::from_f64(0.5) * dot(&change, &bent);
            gradient = plus_product(by_x, &gain, &plus(&by_u, &bent));
            gradient = plus_product(gradient, &xu, &change);
            // Derivatives by the state alone that are not finite, as at a kink, reach the gains and not the minimum.
            if !gradient.iter().all(|entry| entry.is_finite()) {
                return Err(IlqrError::NotConvex { node: k });
            }
            let half = plus_product(xu, &gain, &scaled(T::from_f64(0.5), &uu));
            hessian = plus_symmetric(&xx, &product(&gain, &transposed(&half)));

            ilqr.change[k] = minimum.at;
            ilqr.gain[k] = gain;
        }
        Ok(promise)
    }
}

/// Minimum of a quadratic function within limits, as [`minimize`] finds it. The damping grows until the function is
/// convex; `None` if it does not become so.
#[inline(always)]
fn damped_minimum<T: Float, const M: usize>(
    matrix: &SMatrix<T, M, M>,
    slope: &[T; M],
    limits: [&[T; M]; 2],
    start: &[T; M],
    mut damping: T,
) -> Option<Minimum<T, M>> {
    loop {
        let mut damped = *matrix;
        for m in 0..M {
            damped.data.0[m][m] += damping * matrix.data.0[m][m].abs();
        }
        if let Some(minimum) = minimize(&damped, slope, limits, start) {
            return Some(minimum);
        }
        damping = T::from_f64(LEAST_DAMPING).max(T::from_f64(10.0) * damping);
        // false for NaN as well
        let may_grow = damping < T::from_f64(LARGEST_DAMPING);
        if !may_grow {
            return None;
        }
    }
}

/// `(matrix + matrix^T) / 2 + part + part^T`.
#[inline(always)]
fn plus_symmetric<T: Float, const N: usize>(matrix: &SMatrix<T, N, N>, part: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
    let half = plus(&scaled(T::from_f64(0.5), matrix), part);
    plus(&half, &transposed(&half))
}
