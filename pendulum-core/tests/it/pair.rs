//! What several tests of this crate share.

use pendulum_core::prelude::*;

/// A right-hand side with its Jacobian.
pub(crate) struct Pair<F, G>(pub(crate) F, pub(crate) G);

impl<F: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>, G, const N: usize> System<f64, N> for Pair<F, G> {
    fn rhs(&self, t: f64, x: &SVector<f64, N>) -> SVector<f64, N> {
        (self.0)(t, x)
    }
}

impl<F, G, const N: usize> Jacobian<f64, N> for Pair<F, G>
where
    F: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>,
    G: Fn(f64, &SVector<f64, N>) -> SMatrix<f64, N, N>,
{
    fn jacobian(&self, t: f64, x: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        (self.1)(t, x)
    }
}
