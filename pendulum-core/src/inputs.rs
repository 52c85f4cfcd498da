//! Models with inputs, and the laws that their inputs follow.
//!
//! A model with inputs becomes a [`System`] with a law for them. A closure is enough for explicit methods; what stiff methods and the analyses
//! of [`stability`](crate::stability) require in addition, the derivative of the law, it gets in one of three ways:
//!
//! | | the law | its derivative |
//! |---|---|---|
//! | `model.with_inputs(law)` | a closure | none |
//! | [`model.with_inputs(law).with_derivative(k)`](WithInputs::with_derivative) | a closure | a closure |
//! | `model.with_law(law)` | an [`InputLaw`], generic over [`Real`] | exact, by [dual numbers](crate::dual) |
//! | [`model.with_inputs(law).by_differences()`](WithInputs::by_differences) | a closure | to about 10 digits |
//!
//! The Jacobian of the model itself is the generated one in each of them. With an [`InputLaw`] the closed loop also runs in other number types,
//! and so in an [`ensemble`](crate::Ensemble).

use std::fmt;

use nalgebra::{SMatrix, SVector};

use crate::dual::Dual;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::system::{Cast, Differences, Energy, Jacobian, System, WithJacobian, by_number, by_state};

/// A model with `M` inputs (controls), whose values are given at each evaluation.
///
/// With a law for the inputs it becomes a [`System`]: see [`inputs`](crate::inputs).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model of {N} state components and {M} inputs",
    note = "`mechanism!` implements `Controlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait Controlled<T: Real, const N: usize, const M: usize> {
    /// The inputs by name; as an array they stand in the order of their declaration.
    type Inputs: Copy + From<[T; M]> + Into<[T; M]>;

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

    /// The derivative of [`rhs_with`](Controlled::rhs_with) with respect to the time, state and inputs held fixed.
    ///
    /// Generated models know it exactly. By default it is a central difference, as in [`Jacobian::time_derivative`].
    #[inline]
    fn time_derivative_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SVector<T, N>
    where
        T: Float,
    {
        by_number(t, |t| self.rhs_with(t, x, u))
    }
}

/// A model with `M` inputs that can be converted to any number type; what [`Cast`] is for models without.
///
/// [`mechanism!`](crate::mechanism) implements it for models with inputs, in double precision.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {M} inputs that can be converted to other number types",
    note = "`mechanism!` implements `CastControlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait CastControlled<const N: usize, const M: usize> {
    /// The model in another number type.
    type In<T: Real>: Controlled<T, N, M>;

    /// The same model in another number type; its constants are rounded.
    fn cast<T: Real>(&self) -> Self::In<T>;

    /// One model per lane, as [`Cast::gather`].
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm;
}

/// A law for `M` inputs, from the time and a state of length `N`, in one number type. Closures are laws.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law for {M} inputs of a state of {N} components",
    note = "a law is a closure `|t, x| NameInputs {{ .. }}` of the time and the state"
)]
pub trait Law<T: Real, const N: usize, const M: usize> {
    /// The inputs, in the order of their declaration.
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M];
}

/// A [`Law`] that knows its derivatives, so that the closed loop has a [`Jacobian`].
#[diagnostic::on_unimplemented(
    message = "the law of these inputs has no derivative, so the closed loop has no Jacobian",
    note = "`model.with_inputs(law).with_derivative(|t, x| ..)` states it, `model.with_law(law)` finds it for a law that is generic over `Real`, \
            and `model.with_inputs(law).by_differences()` approximates it"
)]
pub trait LawJacobian<T: Real, const N: usize, const M: usize>: Law<T, N, M> {
    /// The inputs, and their derivative with respect to the state: a row for each input.
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>);

    /// The derivative of the inputs with respect to the time, the state held fixed.
    ///
    /// By default a central difference, for two evaluations of the law: see [`Jacobian::time_derivative`].
    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, M>
    where
        T: Float,
    {
        by_number(t, |t| self.inputs(t, x).into())
    }
}

/// A law for `M` inputs, from the time and a state of length `N`, in any number type.
///
/// Its derivatives are found by [dual numbers](crate::dual), to rounding errors, and the closed loop runs wherever a model does: with stiff
/// methods, in [`Auto`](crate::Auto), in [`stability`](crate::stability), and in the lanes of an [`ensemble`](crate::Ensemble). The models
/// of an ensemble share one law; to sweep over gains, make them parameters of the scene and the feedback a `torque`.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::{Stability, equilibrium};
/// use pendulum_core::{InputLaw, Real};
///
/// mechanism! {
///     pub Arm {
///         input motor: N m,
///         gravity: [0, -9.81, 0],
///         body rod on ground { solids: [rod(1, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: angle, torque: motor }
///     }
/// }
///
/// /// Holds the arm upright.
/// #[derive(Clone, PartialEq)]
/// struct Hold {
///     stiffness: f64,
///     damping: f64,
/// }
///
/// impl InputLaw<2, 1> for Hold {
///     fn inputs<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> [T; 1] {
///         let [stiffness, damping, pi] = [self.stiffness, self.damping, std::f64::consts::PI].map(T::from_f64);
///         let motor = stiffness * (pi - x[0]).sin_cos().0 - damping * x[1];
///         ArmInputs { motor }.into()
///     }
/// }
///
/// let held = Arm::new(ArmParams {})?.with_law(Hold { stiffness: 20.0, damping: 2.0 });
/// let upright = equilibrium(&held, [3.0, 0.0])?;
/// assert_eq!(upright.stability(), Stability::AsymptoticallyStable);
/// let x = Auto::new().solve(&held, 0.0, 20.0, [2.5, 0.0])?.end();
/// assert!((x - upright.x).norm() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait InputLaw<const N: usize, const M: usize>: Clone + PartialEq {
    /// The inputs, in the order of their declaration: `NameInputs { .. }.into()` keeps their names.
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, N>) -> [T; M];
}

/// An [`InputLaw`] as a [`Law`] in each number type.
#[derive(Clone, Debug, PartialEq)]
pub struct Generic<L>(L);

impl<F, T, U, const N: usize, const M: usize> Law<T, N, M> for F
where
    T: Real,
    F: Fn(T, &SVector<T, N>) -> U,
    U: Into<[T; M]>,
{
    #[inline]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self(t, x).into()
    }
}

impl<T: Real, F: Law<T, N, M>, K, const N: usize, const M: usize> Law<T, N, M> for WithJacobian<F, K> {
    #[inline]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self.function.inputs(t, x)
    }
}

impl<T, F, K, const N: usize, const M: usize> LawJacobian<T, N, M> for WithJacobian<F, K>
where
    T: Real,
    F: Law<T, N, M>,
    K: Fn(T, &SVector<T, N>) -> SMatrix<T, M, N>,
{
    #[inline]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        (self.inputs(t, x), (self.jacobian)(t, x))
    }
}

impl<T: Real, F: Law<T, N, M>, const N: usize, const M: usize> Law<T, N, M> for Differences<F> {
    #[inline]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self.0.inputs(t, x)
    }
}

impl<T: Float, F: Law<T, N, M>, const N: usize, const M: usize> LawJacobian<T, N, M> for Differences<F> {
    #[inline]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        (self.inputs(t, x), by_state(x, |x| self.inputs(t, x).into()))
    }
}

impl<T: Real, L: InputLaw<N, M>, const N: usize, const M: usize> Law<T, N, M> for Generic<L> {
    #[inline]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self.0.inputs(t, x)
    }
}

impl<T: Real, L: InputLaw<N, M>, const N: usize, const M: usize> LawJacobian<T, N, M> for Generic<L> {
    #[inline]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        let variables = SVector::<Dual<T, N>, N>::from_fn(|n, _| Dual::variable(x[n], n));
        let inputs = self.0.inputs(Dual::constant(t), &variables);
        let jacobian = SMatrix::from_fn(|m, n| inputs[m].slopes[n]);
        (inputs.map(|input| input.value), jacobian)
    }

    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, M> {
        let inputs = self.0.inputs(Dual::<T, 1>::variable(t, 0), &x.map(Dual::constant));
        inputs.map(|input| input.slopes[0]).into()
    }
}

/// A [`Controlled`] model whose `M` inputs follow the [`Law`] `L`: a [`System`] that can be integrated.
///
/// Its Jacobian is `jacobian_with + input_jacobian * K`, with the derivative `K` of the law: see [`inputs`](crate::inputs) for the ways to have one.
#[derive(Clone, Copy)]
pub struct WithInputs<S, L, const M: usize> {
    system: S,
    law: L,
}

impl<S, F, const M: usize> WithInputs<S, F, M> {
    /// The model `system` with the inputs `inputs(t, x)`; generated models have it as their method `with_inputs`.
    #[inline]
    pub fn new<T, const N: usize>(system: S, inputs: F) -> Self
    where
        T: Real,
        S: Controlled<T, N, M>,
        F: Fn(T, &SVector<T, N>) -> S::Inputs,
    {
        Self { system, law: inputs }
    }

    /// The same closed loop, whose law has the derivative `derivative(t, x)` with respect to the state: a row for each input.
    ///
    /// Its derivative with respect to time is a central difference of the law, for two evaluations of that: right to about 10 digits where
    /// the law varies over times of about 1 s, and zero where time does not occur.
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

    /// The same closed loop, with the derivatives of the law by central differences: see [`Differences`] for their error.
    ///
    /// A Jacobian takes two evaluations of the law for each component of the state, and none of the model beyond its own Jacobians.
    #[inline]
    pub fn by_differences(self) -> WithInputs<S, Differences<F>, M> {
        WithInputs {
            system: self.system,
            law: Differences(self.law),
        }
    }
}

impl<S, L, const M: usize> WithInputs<S, Generic<L>, M> {
    /// The model `system` with a law in any number type; generated models have it as their method `with_law`.
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

impl<T, S, L, const N: usize, const M: usize> System<T, N> for WithInputs<S, L, M>
where
    T: Real,
    S: Controlled<T, N, M>,
    L: Law<T, N, M>,
{
    #[inline]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        self.system.rhs_with(t, x, &self.law.inputs(t, x).into())
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

    #[inline]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        let (inputs, by_state) = self.law.inputs_and_jacobian(t, x);
        let inputs = inputs.into();
        let (rhs, mut jacobian) = self.system.rhs_and_jacobian_with(t, x, &inputs);
        let by_inputs = self.system.input_jacobian(t, x, &inputs);
        for (j, mut column) in jacobian.column_iter_mut().enumerate() {
            for m in 0..M {
                for (i, entry) in column.iter_mut().enumerate() {
                    *entry += by_inputs[(i, m)] * by_state[(m, j)];
                }
            }
        }
        (rhs, jacobian)
    }

    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Float,
    {
        let inputs = self.law.inputs(t, x).into();
        let by_inputs = self.system.input_jacobian(t, x, &inputs);
        let mut derivative = self.system.time_derivative_with(t, x, &inputs);
        for (by_input, &rate) in by_inputs.column_iter().zip(&self.law.time_derivative(t, x)) {
            for (entry, &by_input) in derivative.iter_mut().zip(&by_input) {
                *entry += by_input * rate;
            }
        }
        derivative
    }
}

impl<T: Real, S: Energy<T, N>, L, const N: usize, const M: usize> Energy<T, N> for WithInputs<S, L, M> {
    #[inline]
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T {
        self.system.kinetic(t, x)
    }

    #[inline]
    fn potential(&self, t: T, x: &SVector<T, N>) -> T {
        self.system.potential(t, x)
    }
}

/// The models may differ in their constants, and share the law.
impl<S, L, const N: usize, const M: usize> Cast<N> for WithInputs<S, Generic<L>, M>
where
    S: CastControlled<N, M>,
    L: InputLaw<N, M>,
{
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

impl<S: fmt::Debug, L, const M: usize> fmt::Debug for WithInputs<S, L, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("WithInputs")
            .field("system", &self.system)
            .finish_non_exhaustive()
    }
}
