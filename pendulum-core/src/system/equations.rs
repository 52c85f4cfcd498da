//! Equations by hand, in every number type.

use nalgebra::{SMatrix, SVector};

use super::{Cast, CastJacobian, Jacobian, System};
use crate::dual::{Dual, variables};
use crate::real::Real;
use crate::real::lanes::Lanes;

/// Equations of first order that are written by hand for every number type. [`EquationsSystem`] makes a system of them,
/// with exact derivatives, for stiff methods, analyses and lanes, and with power series for [`Taylor`](crate::Taylor).
///
/// All models of an ensemble have equal equations.
///
/// A series takes three to six times as long as the one that [`mechanism!`](crate::mechanism) generates, which needs no
/// bodies: `state x { rate: .. }`. By hand, `Taylor` takes 0.5 to 0.9 times as long as [`Vern9`](crate::Vern9) for the
/// few products of Hénon and Heiles at tolerances of 1e-12 and 1e-10, but 1.5 to 1.8 times as long on the orbit of
/// Arenstorf, and 4 to 5 times with seven stars (AMD EPYC with AVX-512, rustc 1.95).
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::real::Real;
/// use pendulum_core::system::{Equations, EquationsSystem};
///
/// /// Relaxation oscillations.
/// #[derive(Clone, PartialEq)]
/// struct VanDerPol {
///     epsilon: f64,
/// }
///
/// impl Equations<2> for VanDerPol {
///     fn rhs<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
///         let [one, epsilon] = [1.0, self.epsilon].map(T::from_f64);
///         SVector::from([x[1], ((one - x[0] * x[0]) * x[1] - x[0]) / epsilon])
///     }
/// }
///
/// let stiff = EquationsSystem(VanDerPol { epsilon: 1e-6 });
/// let solution = Radau9::new().rtol(1e-9).atol(1e-9).solve(&stiff, 0.0, 2.0, [2.0, 0.0])?;
/// assert!((solution.end()[0] - 1.706_167_732_170_469).abs() < 1e-6);
///
/// // many starts at once, in lanes
/// let starts = [0.5, 1.0, 1.5, 2.0].map(|x| SVector::from([x, 0.0]));
/// let ends = Rodas5P::new().ensemble(&[stiff], 0.0, 2.0, &starts)?;
/// assert_eq!(ends.len(), 4);
///
/// // a tight tolerance, by power series
/// let gentle = EquationsSystem(VanDerPol { epsilon: 1.0 });
/// let taylor = Taylor::new().rtol(1e-13).atol(1e-13).solve(&gentle, 0.0, 20.0, [2.0, 0.0])?;
/// let vern9 = Vern9::new().rtol(1e-13).atol(1e-13).solve(&gentle, 0.0, 20.0, [2.0, 0.0])?;
/// assert!((taylor.end() - vern9.end()).amax() < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Equations<const N: usize>: Clone + PartialEq {
    /// Time derivative of the state `x`. Constants are converted by [`Real::from_f64`].
    fn rhs<T: Real>(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>;
}

/// [`Equations`] as a [`System`] in each number type, with a [`Jacobian`] and a derivative by time from
/// [dual numbers](crate::dual).
///
/// With the feature `std` it has [power series](crate::TaylorSeries). The right-hand side is called once for each
/// series, with numbers that record the operations on them. Branches are those of the values at the start of the
/// series: of comparisons, [`piecewise`](Real::piecewise), [`abs`](Real::abs), which is constant at 0,
/// [`signum`](Real::signum), [`at_least`](Real::at_least) and [`at_most`](Real::at_most), which are the mean of two
/// equal numbers. Memory is allocated for the first series of a trajectory.
///
/// A type of its own, as [`FnSystem`](super::FnSystem), because an implementation for all equations would rule out
/// every other generic implementation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquationsSystem<E>(pub E);

impl<T: Real, E: Equations<N>, const N: usize> System<T, N> for EquationsSystem<E> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        self.0.rhs(t, x)
    }
}

impl<T: Real, E: Equations<N>, const N: usize> Jacobian<T, N> for EquationsSystem<E> {
    #[inline(always)]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.rhs_and_jacobian(t, x).1
    }

    #[inline(always)]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        let rates = self.0.rhs(Dual::constant(t), &variables(x));
        let jacobian = SMatrix::from_fn(|m, n| rates[m].slopes[n]);
        (rates.map(|rate| rate.value), jacobian)
    }

    #[inline(always)]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        let rates = self.0.rhs(Dual::<T, 1>::variable(t, 0), &x.map(Dual::constant));
        rates.map(|rate| rate.slopes[0])
    }
}

impl<E: Equations<N>, const N: usize> Cast<N> for EquationsSystem<E> {
    type In<T: Real> = Self;

    fn cast<T: Real>(&self) -> Self {
        self.clone()
    }

    #[inline]
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self
    where
        Self: 'm,
    {
        models(0).clone()
    }

    fn shares_lanes(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<E: Equations<N>, const N: usize> CastJacobian<N> for EquationsSystem<E> {
    fn with_jacobian<T: Real>(model: &Self) -> &impl Jacobian<T, N> {
        model
    }
}
