//! Functions as systems.

use core::fmt;

use nalgebra::{SMatrix, SVector};

use super::{Hybrid, Jacobian, System};
use crate::forward::{forward, forward_system};
use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;

/// A function `f(t, x)` as a [`System`].
///
/// It is a separate type because an implementation for all closures would rule out every other generic implementation.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::SolveError;
///
/// let decay = FnSystem(|_t: f64, x: &SVector<f64, 1>| -x);
/// let solution = Rk45::new().solve(&decay, 0.0, 1.0, [1.0])?;
/// assert!((solution.end()[0] - (-1.0_f64).exp()).abs() < 1e-6);
/// # Ok::<(), SolveError<f64, 1>>(())
/// ```
///
/// Stiff methods require a Jacobian: see [`with_jacobian`](Self::with_jacobian) and
/// [`Differences`](super::Differences).
#[derive(Clone, Copy)]
pub struct FnSystem<F>(pub F);

impl<F> FnSystem<F> {
    /// Creates the system of the function `f(t, x)`, whose derivative with respect to `x` is `jacobian(t, x)`.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::SolveError;
    ///
    /// let follower = FnSystem::with_jacobian(
    ///     |t: f64, x: &SVector<f64, 1>| SVector::from([-1e6 * (x[0] - t.cos())]),
    ///     |_t, _x| SMatrix::from([[-1e6]]),
    /// );
    /// let solution = Rodas5P::new().solve(&follower, 0.0, 10.0, [2.0])?;
    /// assert!((solution.end()[0] - 10.0_f64.cos()).abs() < 1e-5);
    /// # Ok::<(), SolveError<f64, 1>>(())
    /// ```
    #[inline]
    pub fn with_jacobian<T, J, const N: usize>(f: F, jacobian: J) -> WithJacobian<Self, J>
    where
        T: Real,
        F: Fn(T, &SVector<T, N>) -> SVector<T, N>,
        J: Fn(T, &SVector<T, N>) -> SMatrix<T, N, N>,
    {
        WithJacobian::new(Self(f), jacobian)
    }
}

impl<T, F, const N: usize> System<T, N> for FnSystem<F>
where
    T: Real,
    F: Fn(T, &SVector<T, N>) -> SVector<T, N>,
{
    #[inline]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        (self.0)(t, x)
    }
}

impl<F> fmt::Debug for FnSystem<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FnSystem").finish_non_exhaustive()
    }
}

/// A [`System`] or a [law](crate::inputs::ControlLaw) for inputs, with its derivative with respect to the state as a
/// function `jacobian(t, x)`.
///
/// [`FnSystem::with_jacobian`] and [`WithInputs::with_derivative`](crate::WithInputs::with_derivative) create it. The
/// derivative with respect to time is a central difference, as in [`Jacobian::time_derivative`], unless provided by
/// [`with_time_derivative`](Self::with_time_derivative).
#[derive(Clone, Copy)]
pub struct WithJacobian<F, J> {
    pub(crate) function: F,
    pub(crate) jacobian: J,
}

impl<F, J> WithJacobian<F, J> {
    /// Combines `function` with its derivative `jacobian`.
    #[inline]
    pub const fn new(function: F, jacobian: J) -> Self {
        Self { function, jacobian }
    }

    /// Adds the derivative of the right-hand side with respect to time, `derivative(t, x)`.
    ///
    /// Rosenbrock methods use it. The default central difference assumes that the right-hand side varies on a time
    /// scale of about 1 s. Provide the derivative for faster variation, such as a drive of 1e5 rad/s:
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::SolveError;
    ///
    /// let omega = 1e5;
    /// let driven = FnSystem::with_jacobian(
    ///     move |t: f64, x: &SVector<f64, 1>| SVector::from([-x[0] + (omega * t).cos()]),
    ///     |_t, _x| SMatrix::from([[-1.0]]),
    /// )
    /// .with_time_derivative(move |t, _x| SVector::from([-omega * (omega * t).sin()]));
    /// let solution = Rodas5P::new().rtol(1e-8).atol(1e-8).solve(&driven, 0.0, 1e-3, [0.0])?;
    /// assert!((solution.end()[0] - (omega * 1e-3).sin() / omega).abs() < 1e-7);
    /// # Ok::<(), SolveError<f64, 1>>(())
    /// ```
    #[inline]
    pub fn with_time_derivative<T, D, const N: usize>(self, derivative: D) -> WithTimeDerivative<Self, D>
    where
        T: Real,
        Self: Jacobian<T, N>,
        D: Fn(T, &SVector<T, N>) -> SVector<T, N>,
    {
        WithTimeDerivative {
            system: self,
            derivative,
        }
    }
}

impl<T: Real, F: System<T, N>, J, const N: usize> System<T, N> for WithJacobian<F, J> {
    forward_system!(self => self.function);
}

impl<T, F, J, const N: usize> Jacobian<T, N> for WithJacobian<F, J>
where
    T: Real,
    F: System<T, N>,
    J: Fn(T, &SVector<T, N>) -> SMatrix<T, N, N>,
{
    #[inline]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        (self.jacobian)(t, x)
    }
}

impl<F: fmt::Debug, J> fmt::Debug for WithJacobian<F, J> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WithJacobian")
            .field("function", &self.function)
            .finish_non_exhaustive()
    }
}

/// A [`System`] with its derivative with respect to time as a function, created by
/// [`WithJacobian::with_time_derivative`].
#[derive(Clone, Copy)]
pub struct WithTimeDerivative<S, D> {
    system: S,
    derivative: D,
}

impl<T: Real, S: System<T, N>, D, const N: usize> System<T, N> for WithTimeDerivative<S, D> {
    forward_system!(self => self.system);
}

impl<T, S, D, const N: usize> Jacobian<T, N> for WithTimeDerivative<S, D>
where
    T: Real,
    S: Jacobian<T, N>,
    D: Fn(T, &SVector<T, N>) -> SVector<T, N>,
{
    forward! { self => self.system;
        jacobian(t: T, x: &SVector<T, N>) -> SMatrix<T, N, N>;
        rhs_and_jacobian(t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>);
    }

    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        (self.derivative)(t, x)
    }
}

impl<S: fmt::Debug, D> fmt::Debug for WithTimeDerivative<S, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WithTimeDerivative")
            .field("system", &self.system)
            .finish_non_exhaustive()
    }
}
