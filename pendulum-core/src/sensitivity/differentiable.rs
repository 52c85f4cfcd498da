//! Methods that integrate dual numbers, in fused arithmetic or not.

use nalgebra::SVector;

use super::Seeded;
use crate::dual::Dual;
use crate::ensemble::{Ensemble, EnsembleError};
use crate::error::{Reason, SolveError};
use crate::method::{FusedMethod, Method};
use crate::real::Fused;
use crate::solution::Solution;
use crate::system::{Cast, Parametric};

/// A method that carries the derivatives by `K` variables: a [`Method`] on dual numbers, or a [`FusedMethod`]. `S` is
/// the type of its numbers, `f64` or `Fused<f64>`, which is inferred.
///
/// The trait is public because it bounds public functions.
pub trait Differentiable<S, M, const N: usize, const P: usize, const K: usize> {
    /// Integrates a model, and returns the trajectory.
    #[doc(hidden)]
    fn trajectory(
        &self,
        model: &Seeded<'_, M, N, P, K>,
        span: [Dual<f64, K>; 2],
        x0: SVector<Dual<f64, K>, N>,
    ) -> Result<Solution<Dual<f64, K>, N>, SolveError<Dual<f64, K>, N>>;

    /// Integrates a model, and returns the last state.
    #[doc(hidden)]
    fn last(
        &self,
        model: &Seeded<'_, M, N, P, K>,
        span: [Dual<f64, K>; 2],
        x0: SVector<Dual<f64, K>, N>,
    ) -> Result<SVector<Dual<f64, K>, N>, Reason>;
}

impl<X, M, const N: usize, const P: usize, const K: usize> Differentiable<f64, M, N, P, K> for X
where
    M: Parametric<N, P>,
    X: Method<M::In<Dual<f64, K>>, Dual<f64, K>, N>,
{
    fn trajectory(
        &self,
        model: &Seeded<'_, M, N, P, K>,
        [t0, t1]: [Dual<f64, K>; 2],
        x0: SVector<Dual<f64, K>, N>,
    ) -> Result<Solution<Dual<f64, K>, N>, SolveError<Dual<f64, K>, N>> {
        self.solve(&model.cast(), t0, t1, x0)
    }

    fn last(
        &self,
        model: &Seeded<'_, M, N, P, K>,
        [t0, t1]: [Dual<f64, K>; 2],
        x0: SVector<Dual<f64, K>, N>,
    ) -> Result<SVector<Dual<f64, K>, N>, Reason> {
        self.stepper(&model.cast(), t0, t1, x0)?.run()
    }
}

impl<A, M, const N: usize, const P: usize, const K: usize> Differentiable<Fused<f64>, M, N, P, K> for FusedMethod<A>
where
    M: Parametric<N, P>,
    A: Method<M::In<Dual<Fused<f64>, K>>, Dual<Fused<f64>, K>, N>,
{
    fn trajectory(
        &self,
        model: &Seeded<'_, M, N, P, K>,
        [t0, t1]: [Dual<f64, K>; 2],
        x0: SVector<Dual<f64, K>, N>,
    ) -> Result<Solution<Dual<f64, K>, N>, SolveError<Dual<f64, K>, N>> {
        self.solve(model, t0, t1, x0)
    }

    fn last(
        &self,
        model: &Seeded<'_, M, N, P, K>,
        [t0, t1]: [Dual<f64, K>; 2],
        x0: SVector<Dual<f64, K>, N>,
    ) -> Result<SVector<Dual<f64, K>, N>, Reason> {
        self.end(model, t0, t1, x0)
    }
}

/// A method that carries derivatives in lanes, like [`Differentiable`].
///
/// The trait is public because it bounds a public function.
pub trait DifferentiableEnsemble<S, M, const N: usize, const K: usize> {
    /// Integrates many trajectories.
    #[doc(hidden)]
    #[allow(clippy::type_complexity, reason = "states in dual numbers, or an error with them")]
    fn ends(
        &self,
        models: &[M],
        span: [Dual<f64, K>; 2],
        starts: &[SVector<Dual<f64, K>, N>],
    ) -> Result<Vec<SVector<Dual<f64, K>, N>>, EnsembleError<Dual<f64, K>, N>>;
}

impl<X, M, const N: usize, const K: usize> DifferentiableEnsemble<f64, M, N, K> for X
where
    X: Ensemble<M, Dual<f64, K>, N>,
{
    fn ends(
        &self,
        models: &[M],
        [t0, t1]: [Dual<f64, K>; 2],
        starts: &[SVector<Dual<f64, K>, N>],
    ) -> Result<Vec<SVector<Dual<f64, K>, N>>, EnsembleError<Dual<f64, K>, N>> {
        self.ensemble(models, t0, t1, starts)
    }
}

impl<A, M, const N: usize, const K: usize> DifferentiableEnsemble<Fused<f64>, M, N, K> for FusedMethod<A>
where
    A: Ensemble<M, Dual<Fused<f64>, K>, N>,
{
    fn ends(
        &self,
        models: &[M],
        [t0, t1]: [Dual<f64, K>; 2],
        starts: &[SVector<Dual<f64, K>, N>],
    ) -> Result<Vec<SVector<Dual<f64, K>, N>>, EnsembleError<Dual<f64, K>, N>> {
        self.ensemble(models, t0, t1, starts)
    }
}
