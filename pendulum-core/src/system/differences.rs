//! Derivatives by central differences.

use nalgebra::{SMatrix, SVector};

use super::{Energy, Hybrid, Jacobian, System, forward, forward_system};
use crate::layout::StateLayout;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};

/// A [`System`], or a [law](crate::inputs::ControlLaw) for inputs, whose derivatives are central differences: the last resort
/// where nobody knows them.
///
/// A Jacobian takes two evaluations for each of the `N` components of the state, and two more for the derivative with
/// respect to time where that may occur. The component `x` is moved by `cbrt(EPSILON) max(|x|, 1)` to either side, so
/// where the function varies over changes of about 1, some 10 of its 16 digits are right, in `f32` 4 of 7. That is
/// enough for the iteration of [`Radau5`](crate::Radau5); [`Rodas5P`](crate::Rodas5P) keeps its order down to about the
/// same digits. Equilibria and exponents are as exact as the Jacobian. Of a [hybrid](crate::hybrid) system each mode is
/// derived; analyses that pass its changes need exact derivatives, and refuse it.
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

/// The derivative of `f` with respect to the state at `x`.
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

/// The derivative of `f` with respect to the time; zero where that does not occur in a system.
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

/// The derivative of `f` at the number `at`.
pub(crate) fn by_number<T: Lanes, const M: usize>(at: T, f: impl Fn(T) -> SVector<T, M>) -> SVector<T, M> {
    let size = at.abs();
    let size = T::from_fn(|lane| size.lane(lane).max(T::Scalar::from_f64(1.0)));
    let reach = T::from_f64(libm::cbrt(T::Scalar::EPSILON.to_f64())) * size;
    let (before, after) = (at - reach, at + reach);
    (f(after) - f(before)) / (after - before)
}
