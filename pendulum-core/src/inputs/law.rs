//! Control laws and their derivatives.

use nalgebra::{SMatrix, SVector};

use crate::dual::{Dual, variables};
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{Differences, WithJacobian, by_number, by_state};

/// A law for `M` inputs as a function of time and a state of length `N`, in one number type. Closures implement it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law for {M} inputs of a state of {N} components",
    note = "a law is a closure `|t, x| NameInputs {{ .. }}` of the time and the state"
)]
pub trait ControlLaw<T: Real, const N: usize, const M: usize> {
    /// Computes the inputs, in the order of declaration.
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M];
}

/// A [`ControlLaw`] with derivatives, which gives the closed loop a [`Jacobian`](crate::Jacobian).
#[diagnostic::on_unimplemented(
    message = "the law of these inputs has no derivative, so the closed loop has no Jacobian",
    note = "`model.with_inputs(law).with_derivative(|t, x| ..)` states it, `model.with_law(law)` finds it for \
            a law that is generic over `Real`, and `model.with_inputs(law).by_differences()` approximates it"
)]
pub trait LawJacobian<T: Real, const N: usize, const M: usize>: ControlLaw<T, N, M> {
    /// Computes the inputs and their derivative with respect to the state, one row per input.
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>);

    /// Partial derivative of the inputs with respect to time.
    ///
    /// The default is a central difference, at the cost of two evaluations of the law: see
    /// [`Jacobian::time_derivative`](crate::Jacobian::time_derivative).
    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, M>
    where
        T: Lanes,
    {
        by_number(t, |t| self.inputs(t, x).into())
    }
}

/// A law for `M` inputs as a function of time and a state of length `N`, in any number type.
///
/// Its derivatives come from [dual numbers](crate::dual) and are exact to rounding errors. The closed loop runs with
/// stiff methods, in [`Auto`](crate::Auto), in [`stability`](crate::stability), and in the lanes of an
/// [`ensemble`](crate::Ensemble). The models of an ensemble share one law; to sweep over gains, make them parameters of
/// the scene and write the feedback as a `torque`. Mark `inputs` as `#[inline(always)]` for ensembles: a function that
/// is called does not use the instructions of the lanes.
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
///         body rod on ground {
///             solids: [rod(1, [0, 0, 0], [0, -1, 0])],
///             joint: revolute(z),
///             coordinate: angle,
///             torque: motor,
///         }
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
    /// Computes the inputs, in the order of declaration. `NameInputs { .. }.into()` converts from named inputs.
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, N>) -> [T; M];
}

/// Adapter from an [`InputLaw`] to a [`ControlLaw`] in each number type.
#[derive(Clone, Debug, PartialEq)]
pub struct Generic<L>(pub(super) L);

impl<F, T, U, const N: usize, const M: usize> ControlLaw<T, N, M> for F
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

impl<T: Real, F: ControlLaw<T, N, M>, K, const N: usize, const M: usize> ControlLaw<T, N, M> for WithJacobian<F, K> {
    #[inline]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self.function.inputs(t, x)
    }
}

impl<T, F, K, const N: usize, const M: usize> LawJacobian<T, N, M> for WithJacobian<F, K>
where
    T: Real,
    F: ControlLaw<T, N, M>,
    K: Fn(T, &SVector<T, N>) -> SMatrix<T, M, N>,
{
    #[inline]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        (self.inputs(t, x), (self.jacobian)(t, x))
    }
}

impl<T: Real, F: ControlLaw<T, N, M>, const N: usize, const M: usize> ControlLaw<T, N, M> for Differences<F> {
    #[inline]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self.0.inputs(t, x)
    }
}

impl<T: Lanes, F: ControlLaw<T, N, M>, const N: usize, const M: usize> LawJacobian<T, N, M> for Differences<F> {
    #[inline]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        (self.inputs(t, x), by_state(x, |x| self.inputs(t, x).into()))
    }
}

impl<T: Real, L: InputLaw<N, M>, const N: usize, const M: usize> ControlLaw<T, N, M> for Generic<L> {
    #[inline(always)]
    fn inputs(&self, t: T, x: &SVector<T, N>) -> [T; M] {
        self.0.inputs(t, x)
    }
}

impl<T: Real, L: InputLaw<N, M>, const N: usize, const M: usize> LawJacobian<T, N, M> for Generic<L> {
    #[inline(always)]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        let inputs = self.0.inputs(Dual::constant(t), &variables(x));
        let jacobian = SMatrix::from_fn(|m, n| inputs[m].slopes[n]);
        (inputs.map(|input| input.value), jacobian)
    }

    #[inline(always)]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, M> {
        let inputs = self.0.inputs(Dual::<T, 1>::variable(t, 0), &x.map(Dual::constant));
        inputs.map(|input| input.slopes[0]).into()
    }
}
