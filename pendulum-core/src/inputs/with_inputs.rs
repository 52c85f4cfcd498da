//! Closed loops: a model with inputs and its control law.

use core::fmt;

use nalgebra::{SMatrix, SVector};

use super::{CastControlled, ControlLaw, Controlled, Generic, InputLaw, LawJacobian};
use crate::error::ParameterError;
use crate::forward::forward;
use crate::hybrid::{Constraint, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative};
use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;
#[cfg(feature = "std")]
use crate::shapes::{Shape, Shapes};
use crate::system::{
    ActsWith, Adjoint, Cast, CastJacobian, ControlledAdjoint, Differences, Energy, Hybrid, HybridJacobian, Jacobian,
    Parametric, ParametricControlled, Plant, PlantJacobian, System, WithJacobian, by_sign,
};

/// A [`Controlled`] model whose `M` inputs follow the [`ControlLaw`] `L`: a [`System`] that can be integrated.
///
/// Its Jacobian is the one of the model plus `input_jacobian * K`, with the derivative `K` of the law: see
/// [`inputs`](crate::inputs) for the ways to provide `K`.
#[derive(Clone, Copy)]
pub struct WithInputs<S, L, const M: usize> {
    system: S,
    law: L,
}

#[cfg(feature = "std")]
impl<S: Shapes<N>, L, const N: usize, const M: usize> Shapes<N> for WithInputs<S, L, M> {
    fn shapes(&self, t: f64, x: &SVector<f64, N>) -> Vec<Shape<'_>> {
        self.system.shapes(t, x)
    }
}

impl<S, F, const M: usize> WithInputs<S, F, M> {
    /// Combines the model `system` with the inputs `inputs(t, x)`. Generated models have a method `with_inputs` for
    /// this.
    #[inline]
    pub fn new<T, const N: usize>(system: S, inputs: F) -> Self
    where
        T: Real,
        S: Controlled<T, N, M>,
        F: Fn(T, &SVector<T, N>) -> S::Inputs,
    {
        Self { system, law: inputs }
    }

    /// Adds the derivative `derivative(t, x)` of the law with respect to the state: one row per input.
    ///
    /// The derivative with respect to time is a central difference, at the cost of two evaluations of the law. It is
    /// accurate to about 10 digits if the law varies on a time scale of about 1 s, and zero if the law does not depend
    /// on time.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Cart {
    ///         input push: N,
    ///         body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push }
    ///     }
    /// }
    ///
    /// // brakes hard: a stiff closed loop
    /// let braked = Cart::new(CartParams {})?
    ///     .with_inputs(|_t, x| CartInputs { push: -2e4 * x[1] })
    ///     .with_derivative(|_t, _x| SMatrix::from([[0.0], [-2e4]]));
    /// let solution = Rodas5P::new().solve(&braked, 0.0, 10.0, [0.0, 1.0])?;
    /// assert!(solution.end()[1].abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    pub fn with_derivative<T, K, const N: usize>(self, derivative: K) -> WithInputs<S, WithJacobian<F, K>, M>
    where
        T: Real,
        S: Controlled<T, N, M>,
        K: Fn(T, &SVector<T, N>) -> SMatrix<T, M, N>,
    {
        WithInputs {
            system: self.system,
            law: WithJacobian::new(self.law, derivative),
        }
    }

    /// Differentiates the law by central differences: see [`Differences`] for their error.
    ///
    /// A Jacobian takes two evaluations of the law for each component of the state, and no evaluations of the model
    /// beyond its own Jacobians.
    #[inline]
    pub fn by_differences(self) -> WithInputs<S, Differences<F>, M> {
        WithInputs {
            system: self.system,
            law: Differences(self.law),
        }
    }
}

impl<S, L, const M: usize> WithInputs<S, Generic<L>, M> {
    /// Combines the model `system` with a law in any number type. Generated models have a method `with_law` for this.
    #[inline]
    pub const fn with_law<const N: usize>(system: S, law: L) -> Self
    where
        L: InputLaw<N, M>,
    {
        Self {
            system,
            law: Generic(law),
        }
    }
}

impl<S, L, const M: usize> WithInputs<S, L, M> {
    /// Combines a model with a law in one number type.
    pub(crate) const fn of(system: S, law: L) -> Self {
        Self { system, law }
    }
}

impl<T, S, L, const N: usize, const M: usize> System<T, N> for WithInputs<S, L, M>
where
    T: Real,
    S: Controlled<T, N, M>,
    L: ControlLaw<T, N, M>,
{
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        self.eval(t, x, &by_sign(self, t, x))
    }

    forward! { self => self.system;
        layout() -> Option<StateLayout<'_>>;
        project(t: T, x: &mut SVector<T, N>);
        margins(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 2]));
        gaps(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 3]));
        each_output(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut(&str, T));
    }

    /// Unknown, since the law may depend on time.
    #[inline(always)]
    fn is_autonomous(&self) -> Option<bool> {
        None
    }

    #[inline(always)]
    fn hybrid(&self) -> Option<&dyn Hybrid<T, N>> {
        (!self.system.constraints().is_empty()).then_some(self)
    }
}

impl<T, S, L, const N: usize, const M: usize> Jacobian<T, N> for WithInputs<S, L, M>
where
    T: Real,
    S: Controlled<T, N, M>,
    L: LawJacobian<T, N, M>,
{
    #[inline]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.rhs_and_jacobian(t, x).1
    }

    #[inline(always)]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        self.eval_with_jacobian(t, x, &by_sign(self, t, x))
    }

    #[inline(always)]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        self.eval_time_derivative(t, x, &by_sign(self, t, x))
    }

    #[inline(always)]
    fn hybrid_jacobian(&self) -> Option<&dyn HybridJacobian<T, N>> {
        (!self.system.constraints().is_empty()).then_some(self)
    }
}

impl<T, S, L, const N: usize, const M: usize> Plant<T, N> for WithInputs<S, L, M>
where
    T: Real,
    S: Controlled<T, N, M>,
    L: ControlLaw<T, N, M>,
{
    type Given = [T; MAX_CONSTRAINTS];

    #[inline(always)]
    fn eval(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> SVector<T, N> {
        self.system
            .eval(t, x, &S::Given::with(self.law.inputs(t, x).into(), forces))
    }

    forward! { self => self.system;
        dof() -> usize;
        orientations() -> &[[usize; 2]];
        constraints() -> &[Constraint<'_>];
        laws() -> [Law<T>; MAX_CONSTRAINTS];
        measures(t: T, x: &SVector<T, N>) -> [[T; 2]; MAX_CONSTRAINTS];
    }

    #[inline]
    fn response(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> Response<T, N> {
        let given = S::Given::with(self.law.inputs(t, x).into(), forces);
        self.system.response(t, x, &given)
    }
}

/// Constraint forces do not change the derivative with respect to the inputs.
impl<T, S, L, const N: usize, const M: usize> PlantJacobian<T, N> for WithInputs<S, L, M>
where
    T: Real,
    S: Controlled<T, N, M>,
    L: LawJacobian<T, N, M>,
{
    #[inline(always)]
    fn eval_with_jacobian(
        &self,
        t: T,
        x: &SVector<T, N>,
        forces: &[T; MAX_CONSTRAINTS],
    ) -> (SVector<T, N>, SMatrix<T, N, N>) {
        let (inputs, by_state) = self.law.inputs_and_jacobian(t, x);
        let given = S::Given::with(inputs.into(), forces);
        let (rhs, mut jacobian) = self.system.eval_with_jacobian(t, x, &given);
        let by_inputs = self.system.input_jacobian(t, x, S::Given::inputs_of(&given));
        add_product(&mut jacobian, &by_inputs, &by_state);
        (rhs, jacobian)
    }

    #[inline(always)]
    fn eval_time_derivative(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> SVector<T, N>
    where
        T: Lanes,
    {
        let given = S::Given::with(self.law.inputs(t, x).into(), forces);
        let mut derivative = self.system.eval_time_derivative(t, x, &given);
        let by_inputs = self.system.input_jacobian(t, x, S::Given::inputs_of(&given));
        add_product(&mut derivative, &by_inputs, &self.law.time_derivative(t, x));
        derivative
    }

    #[inline]
    fn response_derivative(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> ResponseDerivative<T, N>
    where
        T: Lanes,
    {
        let (inputs, by_state) = self.law.inputs_and_jacobian(t, x);
        let given = S::Given::with(inputs.into(), forces);
        let mut derivative = self.system.response_derivative(t, x, &given);
        let by_inputs = self.system.input_jacobian(t, x, S::Given::inputs_of(&given));
        let by_time = self.law.time_derivative(t, x);
        add_product(&mut derivative.rates, &by_inputs, &by_state);
        add_product(&mut derivative.rates_by_time, &by_inputs, &by_time);
        // The rates of constraints, and therefore their accelerations, are linear in the rates of the state.
        let measures = self.system.measure_derivatives(t, x);
        for (n, [_, slopes]) in measures.by_state[..self.system.constraints().len()].iter().enumerate() {
            for m in 0..M {
                let by_input = (0..N).fold(T::default(), |sum, i| sum + slopes[i] * by_inputs[(i, m)]);
                for j in 0..N {
                    derivative.accelerations[n][j] += by_input * by_state[(m, j)];
                }
                derivative.accelerations_by_time[n] += by_input * by_time[m];
            }
        }
        derivative
    }

    forward! { self => self.system;
        measure_derivatives(t: T, x: &SVector<T, N>) -> MeasureDerivatives<T, N>;
    }
}

impl<T, S, L, const N: usize, const M: usize, const P: usize> Adjoint<T, N, P> for WithInputs<S, L, M>
where
    T: Real,
    S: ControlledAdjoint<T, N, M, P>,
    L: LawJacobian<T, N, M>,
{
    #[inline]
    fn adjoint(&self, t: T, x: &SVector<T, N>, weights: &SVector<T, N>) -> (SVector<T, N>, SVector<T, P>) {
        let (inputs, jacobian) = self.law.inputs_and_jacobian(t, x);
        let (mut by_state, by_parameters, by_inputs) = self.system.controlled_adjoint(t, x, &inputs.into(), weights);
        for (n, product) in by_state.iter_mut().enumerate() {
            for m in 0..M {
                *product += jacobian[(m, n)] * by_inputs[m];
            }
        }
        (by_state, by_parameters)
    }
}

impl<T: Real, S: Energy<T, N>, L, const N: usize, const M: usize> Energy<T, N> for WithInputs<S, L, M> {
    forward! { self => self.system;
        kinetic(t: T, x: &SVector<T, N>) -> T;
        potential(t: T, x: &SVector<T, N>) -> T;
    }
}

/// The models may differ in their constants, but share the law.
impl<S, L, const N: usize, const M: usize, const P: usize> Parametric<N, P> for WithInputs<S, Generic<L>, M>
where
    S: ParametricControlled<N, M, P>,
    L: InputLaw<N, M>,
{
    forward! { self => self.system;
        parameters() -> [f64; P];
        parameter_names() -> [&str; P];
        check_parameters(parameters: &[f64; P]) -> Result<(), ParameterError>;
    }

    fn with_parameters<T: Real>(&self, parameters: [T; P]) -> Self::In<T> {
        WithInputs {
            system: self.system.with_parameters(parameters),
            law: self.law.clone(),
        }
    }
}

impl<S, L, const N: usize, const M: usize> Cast<N> for WithInputs<S, Generic<L>, M>
where
    S: CastControlled<N, M>,
    L: InputLaw<N, M>,
{
    const HYBRID: bool = S::HYBRID;

    type In<T: Real> = WithInputs<S::In<T>, Generic<L>, M>;

    fn cast<T: Real>(&self) -> Self::In<T> {
        WithInputs {
            system: self.system.cast(),
            law: self.law.clone(),
        }
    }

    #[inline]
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm,
    {
        WithInputs {
            system: S::gather(|lane| &models(lane).system),
            law: models(0).law.clone(),
        }
    }

    fn shares_lanes(&self, other: &Self) -> bool {
        self.law == other.law
    }
}

impl<S, L, const N: usize, const M: usize> CastJacobian<N> for WithInputs<S, Generic<L>, M>
where
    S: CastControlled<N, M>,
    L: InputLaw<N, M>,
{
    fn with_jacobian<T: Real>(model: &Self::In<T>) -> &impl Jacobian<T, N> {
        model
    }
}

/// Adds the product of the derivative with respect to the inputs and the derivative of the inputs (chain rule).
#[inline(always)]
fn add_product<T: Real, const N: usize, const M: usize, const K: usize>(
    sum: &mut SMatrix<T, N, K>,
    by_inputs: &SMatrix<T, N, M>,
    of_inputs: &SMatrix<T, M, K>,
) {
    for (j, mut column) in sum.column_iter_mut().enumerate() {
        for m in 0..M {
            for (i, entry) in column.iter_mut().enumerate() {
                *entry += by_inputs[(i, m)] * of_inputs[(m, j)];
            }
        }
    }
}

impl<S: fmt::Debug, L, const M: usize> fmt::Debug for WithInputs<S, L, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WithInputs")
            .field("system", &self.system)
            .finish_non_exhaustive()
    }
}
