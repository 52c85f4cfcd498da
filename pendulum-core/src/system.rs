//! What a model offers: traits that the generated code implements, and that hand-written models can implement as well.
//!
//! Everywhere `x` is the state, `[q; qd]` for a mechanism: the coordinates first, then their rates, in the order of
//! declaration and in SI units (m, rad, s). `N` is the length of the state, twice the number of degrees of freedom.

use std::fmt;

use nalgebra::{SMatrix, SVector};

use crate::layout::StateLayout;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};

/// A system of first-order ordinary differential equations, `dx/dt = rhs(t, x)`.
pub trait System<T: Real, const N: usize> {
    /// The time derivative of the state; `[qd; qdd]` for a mechanism.
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>;

    /// What each component of the state is, and whether time occurs; `None` where that is not known, as by default.
    #[inline]
    fn layout(&self) -> Option<&'static StateLayout> {
        None
    }
}

/// A model that can be converted to any number type, vectors of lanes included; `N` is the length of its state.
///
/// [`mechanism!`](crate::mechanism) implements it for models without inputs, in double precision.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be converted to other number types",
    note = "`mechanism!` implements `Cast` for scenes without inputs whose `generate` has `rhs`"
)]
pub trait Cast<const N: usize> {
    /// The model in another number type.
    type In<T: Real>: System<T, N>;

    /// The same model in another number type; its constants are rounded.
    fn cast<T: Real>(&self) -> Self::In<T>;

    /// One model per lane, so that parameters may differ: lane `i` takes its constants from `models(i)`.
    ///
    /// Everything except the constants, such as the parameters by name, is taken from model 0.
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm;
}

/// A [`System`] that knows the derivative of its right-hand side.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know its Jacobian",
    note = "`mechanism!` writes that of a scene without inputs whose `generate` has `jacobian`, as it does unless told otherwise; implement \
            `Jacobian` for systems of your own, or take an explicit method such as `Vern9`"
)]
pub trait Jacobian<T: Real, const N: usize>: System<T, N> {
    /// Entry `(i, j)` is the derivative of component `i` of the right-hand side with respect to component `j` of the state.
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Both at once. Generated models compute their common parts once, and give the right-hand side of [`System::rhs`] up to rounding.
    #[inline]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (self.rhs(t, x), self.jacobian(t, x))
    }

    /// The derivative of the right-hand side with respect to the time, the state held fixed; Rosenbrock methods want it.
    ///
    /// Generated models know it exactly. By default it is a central difference over `cbrt(EPSILON) max(|t|, 1)` to either side, for two
    /// evaluations of the right-hand side: where that varies over times of about 1 s, it is right to about 10 digits, in `f32` to 4.
    /// Zero, without evaluations, where the [layout](System::layout) says that time does not occur.
    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        if self.layout().is_some_and(|layout| layout.autonomous) {
            return SVector::from_element(T::default());
        }
        let one = T::from_f64(1.0);
        let reach = T::from_f64(T::EPSILON.to_f64().cbrt()) * t.abs().max(one);
        let (before, after) = (t - reach, t + reach);
        (self.rhs(after, x) - self.rhs(before, x)) / (after - before)
    }
}

/// A mechanism in canonical variables: its coordinates and their momenta, `y = [q; p]` with `p = A(q) qd`.
///
/// Both `y` and its rate are functions of the state `x = [q; qd]`, so nothing is divided by: `dp/dt = dL/dq + Q`, with the Lagrangian `L`
/// and the forces `Q` that have no potential. A momentum has the unit of energy times time over that of its coordinate. Structure-preserving
/// methods such as [`Gauss4`](crate::Gauss4) step in these variables, in which the motion without friction is a canonical map.
///
/// [`mechanism!`](crate::mechanism) implements it for scenes without inputs whose `generate` has `canonical`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no canonical equations",
    note = "`mechanism!` writes those of a scene without inputs whose `generate` has `canonical`"
)]
pub trait Canonical<T: Real, const N: usize>: System<T, N> {
    /// The variables `y = [q; p]`, and their rates `dy/dt = [qd; dp/dt]`.
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>);

    /// The derivatives of both with respect to the state.
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
}

/// A model that knows its energy, in joules.
pub trait Energy<T: Real, const N: usize> {
    /// Kinetic energy.
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T;

    /// Potential energy, up to the constant that its declaration leaves open.
    fn potential(&self, t: T, x: &SVector<T, N>) -> T;

    /// Kinetic and potential energy together; constant in time where nothing drives or brakes the model.
    #[inline]
    fn energy(&self, t: T, x: &SVector<T, N>) -> T {
        self.kinetic(t, x) + self.potential(t, x)
    }
}

/// A model with `M` inputs (controls), whose values are given at each evaluation.
///
/// With a law for the inputs it becomes a [`System`]: see [`WithInputs`].
pub trait Controlled<T: Real, const N: usize, const M: usize> {
    /// The inputs by name.
    type Inputs: Copy;

    /// The time derivative of the state under the inputs `u`.
    fn rhs_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SVector<T, N>;

    /// The derivative of [`rhs_with`](Controlled::rhs_with) with respect to the state, the inputs held fixed.
    fn jacobian_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, N>;

    /// Both at once, as [`Jacobian::rhs_and_jacobian`].
    #[inline]
    fn rhs_and_jacobian_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (self.rhs_with(t, x, u), self.jacobian_with(t, x, u))
    }

    /// The derivative of [`rhs_with`](Controlled::rhs_with) with respect to the inputs: one column for each, in the order of
    /// their declaration.
    fn input_jacobian(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, M>;

    /// The layout of the state under any law for the inputs, which may depend on time and on turns: see [`System::layout`].
    #[inline]
    fn layout(&self) -> Option<&'static StateLayout> {
        None
    }
}

/// A [`Controlled`] model whose inputs follow a law: a [`System`] that can be integrated.
///
/// The law may use the state (feedback). There is no [`Jacobian`] here for that reason: the closed loop's is
/// `jacobian_with + input_jacobian * K`, where only the author of the law knows its derivative `K` with respect to the state.
///
/// `M`, the number of inputs, is found by inference.
pub struct WithInputs<'a, S: ?Sized, F, const M: usize> {
    system: &'a S,
    inputs: F,
}

impl<'a, S: ?Sized, F, const M: usize> WithInputs<'a, S, F, M> {
    /// The model `system` with the inputs `inputs(t, x)`.
    #[inline]
    pub fn new<T, const N: usize>(system: &'a S, inputs: F) -> Self
    where
        T: Real,
        S: Controlled<T, N, M>,
        F: Fn(T, &SVector<T, N>) -> S::Inputs,
    {
        Self { system, inputs }
    }
}

impl<T, S, F, const N: usize, const M: usize> System<T, N> for WithInputs<'_, S, F, M>
where
    T: Real,
    S: Controlled<T, N, M> + ?Sized,
    F: Fn(T, &SVector<T, N>) -> S::Inputs,
{
    #[inline]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        self.system.rhs_with(t, x, &(self.inputs)(t, x))
    }

    #[inline]
    fn layout(&self) -> Option<&'static StateLayout> {
        self.system.layout()
    }
}

impl<T, S, F, const N: usize, const M: usize> Energy<T, N> for WithInputs<'_, S, F, M>
where
    T: Real,
    S: Energy<T, N> + ?Sized,
{
    #[inline]
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T {
        self.system.kinetic(t, x)
    }

    #[inline]
    fn potential(&self, t: T, x: &SVector<T, N>) -> T {
        self.system.potential(t, x)
    }
}

impl<S: ?Sized, F: Clone, const M: usize> Clone for WithInputs<'_, S, F, M> {
    fn clone(&self) -> Self {
        Self {
            system: self.system,
            inputs: self.inputs.clone(),
        }
    }
}

impl<S: ?Sized, F: Copy, const M: usize> Copy for WithInputs<'_, S, F, M> {}

impl<S: fmt::Debug + ?Sized, F, const M: usize> fmt::Debug for WithInputs<'_, S, F, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WithInputs")
            .field("system", &self.system)
            .finish_non_exhaustive()
    }
}

/// A function `f(t, x)` as a [`System`].
///
/// A type of its own, since closures that were systems themselves would forbid every other general implementation.
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
#[derive(Clone, Copy)]
pub struct FnSystem<F>(pub F);

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

impl<T: Real, S: System<T, N> + ?Sized, const N: usize> System<T, N> for &S {
    #[inline]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        (**self).rhs(t, x)
    }

    #[inline]
    fn layout(&self) -> Option<&'static StateLayout> {
        (**self).layout()
    }
}

impl<T: Real, S: Jacobian<T, N> + ?Sized, const N: usize> Jacobian<T, N> for &S {
    #[inline]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        (**self).jacobian(t, x)
    }

    #[inline]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (**self).rhs_and_jacobian(t, x)
    }

    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        (**self).time_derivative(t, x)
    }
}

impl<T: Real, S: Canonical<T, N> + ?Sized, const N: usize> Canonical<T, N> for &S {
    #[inline]
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>) {
        (**self).canonical(t, x)
    }

    #[inline]
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>) {
        (**self).canonical_jacobian(t, x)
    }
}

impl<T: Real, S: Energy<T, N> + ?Sized, const N: usize> Energy<T, N> for &S {
    #[inline]
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T {
        (**self).kinetic(t, x)
    }

    #[inline]
    fn potential(&self, t: T, x: &SVector<T, N>) -> T {
        (**self).potential(t, x)
    }

    #[inline]
    fn energy(&self, t: T, x: &SVector<T, N>) -> T {
        (**self).energy(t, x)
    }
}

impl<T: Real, S, const N: usize, const M: usize> Controlled<T, N, M> for &S
where
    S: Controlled<T, N, M> + ?Sized,
{
    type Inputs = S::Inputs;

    #[inline]
    fn rhs_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SVector<T, N> {
        (**self).rhs_with(t, x, u)
    }

    #[inline]
    fn jacobian_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, N> {
        (**self).jacobian_with(t, x, u)
    }

    #[inline]
    fn rhs_and_jacobian_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (**self).rhs_and_jacobian_with(t, x, u)
    }

    #[inline]
    fn input_jacobian(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, M> {
        (**self).input_jacobian(t, x, u)
    }

    #[inline]
    fn layout(&self) -> Option<&'static StateLayout> {
        (**self).layout()
    }
}
