//! Derivatives by central differences.

use nalgebra::{SMatrix, SVector};

use super::{Energy, Hybrid, Jacobian, System};
use crate::forward::{forward, forward_system};
use crate::layout::StateLayout;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};

/// A [`System`] or a [law](crate::inputs::ControlLaw) for inputs, differentiated by central differences: a fallback if
/// exact derivatives are not available.
///
/// A Jacobian takes two evaluations for each of the `N` components of the state, and two for the derivative with
/// respect to time unless the system is autonomous. A component `x` is varied by `cbrt(EPSILON) max(|x|, 1)` in both
/// directions. The result is accurate to about 10 of 16 digits (4 of 7 in `f32`) if the function varies on a scale of
/// about 1. This suffices for the iteration of [`Radau5`](crate::Radau5). [`Rodas5P`](crate::Rodas5P) keeps its order
/// down to about this accuracy. Equilibria and exponents are as accurate as the Jacobian. In a [hybrid](crate::hybrid)
/// system each mode is differentiated; analyses across mode switches require exact derivatives, and reject it.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::SolveError;
/// use pendulum_core::system::Differences;
///
/// let van_der_pol = FnSystem(|_t: f64, x: &SVector<f64, 2>| {
///     SVector::from([x[1], 1e3 * (1.0 - x[0] * x[0]) * x[1] - x[0]])
/// });
/// let solution = Radau5::new().solve(&Differences(van_der_pol), 0.0, 100.0, [2.0, 0.0])?;
/// assert!(solution.statistics().accepted < 100);
/// # Ok::<(), SolveError<f64, 2>>(())
/// ```
///
/// J. Nocedal, S. J. Wright, "Numerical Optimization", 2nd ed. (2006), 8.1.
#[derive(Clone, Copy, Debug)]
pub struct Differences<F>(pub F);

impl<T: Real, S: System<T, N>, const N: usize> System<T, N> for Differences<S> {
    forward_system!(self => self.0);
}

impl<T: Lanes, S: System<T, N>, const N: usize> Jacobian<T, N> for Differences<S> {
    #[inline]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        by_state(x, |x| self.0.rhs(t, x))
    }
}

impl<T: Real, S: Energy<T, N>, const N: usize> Energy<T, N> for Differences<S> {
    forward! { self => self.0;
        kinetic(t: T, x: &SVector<T, N>) -> T;
        potential(t: T, x: &SVector<T, N>) -> T;
    }
}

/// Derivative of `f` with respect to the state at `x`.
pub(crate) fn by_state<T: Lanes, const N: usize, const M: usize>(
    x: &SVector<T, N>,
    f: impl Fn(&SVector<T, N>) -> SVector<T, M>,
) -> SMatrix<T, M, N> {
    let mut jacobian = SMatrix::<T, M, N>::from_element(T::default());
    for (j, mut column) in jacobian.column_iter_mut().enumerate() {
        column.copy_from(&by_number(x[j], |moved| {
            let mut x = *x;
            x[j] = moved;
            f(&x)
        }));
    }
    jacobian
}

/// Derivative of `f` with respect to time; zero for an autonomous system.
pub(crate) fn by_time<T: Lanes, const N: usize>(
    system: &(impl System<T, N> + ?Sized),
    t: T,
    f: impl Fn(T) -> SVector<T, N>,
) -> SVector<T, N> {
    match system.is_autonomous() {
        Some(true) => SVector::from_element(T::default()),
        _ => by_number(t, f),
    }
}

/// Derivative of `f` at the number `at`.
pub(crate) fn by_number<T: Lanes, const M: usize>(at: T, f: impl Fn(T) -> SVector<T, M>) -> SVector<T, M> {
    let size = at.abs();
    let size = T::from_fn(|lane| size.lane(lane).max(T::Scalar::from_f64(1.0)));
    let reach = T::from_f64(libm::cbrt(T::Scalar::EPSILON.to_f64())) * size;
    let (before, after) = (at - reach, at + reach);
    (f(after) - f(before)) / (after - before)
}
