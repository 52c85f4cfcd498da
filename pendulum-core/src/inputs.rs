//! Models with inputs, and the laws that their inputs follow.
//!
//! A model with inputs becomes a [`System`](crate::System) with a law for them. A closure is enough for explicit
//! methods; what stiff methods and the analyses of [`stability`](crate::stability) require in addition, the derivative
//! of the law, it gets in one of three ways:
//!
//! | | the law | its derivative |
//! |---|---|---|
//! | `model.with_inputs(law)` | a closure | none |
//! | [`model.with_inputs(law).with_derivative(k)`](WithInputs::with_derivative) | a closure | a closure |
//! | `model.with_law(law)` | an [`InputLaw`], generic over [`Real`] | exact, by [dual numbers](crate::dual) |
//! | [`model.with_inputs(law).by_differences()`](WithInputs::by_differences) | a closure | to about 10 digits |
//!
//! The Jacobian of the model itself is the generated one in each of them. With an [`InputLaw`] the closed loop also
//! runs in other number types, and so in an [`ensemble`](crate::Ensemble).

mod law;
mod with_inputs;

use nalgebra::{SMatrix, SVector};

pub use law::{Generic, InputLaw, Law, LawJacobian};
pub use with_inputs::WithInputs;

use crate::hybrid::{self, Constraint, MOST, MeasureDerivatives, Response, ResponseDerivative};
use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{by_number, forward};

/// A model with `M` inputs (controls), whose values are given at each evaluation.
///
/// With a law for the inputs it becomes a [`System`](crate::System): see [`inputs`](crate::inputs).
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

    /// Both at once, as [`Jacobian::rhs_and_jacobian`](crate::Jacobian::rhs_and_jacobian).
    #[inline]
    fn rhs_and_jacobian_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (self.rhs_with(t, x, u), self.jacobian_with(t, x, u))
    }

    /// The derivative of [`rhs_with`](Controlled::rhs_with) with respect to the inputs: one column for each, in the
    /// order of their declaration.
    fn input_jacobian(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, M>;

    /// The derivative of [`rhs_with`](Controlled::rhs_with) with respect to the time, state and inputs held fixed.
    ///
    /// Generated models know it exactly. By default it is a central difference, as in
    /// [`Jacobian::time_derivative`](crate::Jacobian::time_derivative).
    #[inline]
    fn time_derivative_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SVector<T, N>
    where
        T: Lanes,
    {
        by_number(t, |t| self.rhs_with(t, x, u))
    }

    /// The components of the state, as [`System::layout`](crate::System::layout).
    #[inline]
    fn layout(&self) -> Option<&'static StateLayout> {
        None
    }

    /// Puts a state back onto its constraints, as [`System::project`](crate::System::project): by default there are
    /// none.
    #[inline(always)]
    fn project(&self, _t: T, _x: &mut SVector<T, N>) {}

    /// Tells how far each closed loop is from its toggle, as [`System::margins`](crate::System::margins).
    #[inline(always)]
    fn margins(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&'static str; 2], [T; 2])) {}

    /// Reports the gap of each closed loop, as [`System::gaps`](crate::System::gaps).
    #[inline]
    fn gaps(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&'static str; 2], [T; 3])) {}

    /// Constraints of the motion, as [`Hybrid::constraints`](crate::hybrid::Hybrid::constraints): none by default. A
    /// model that has some implements all that follows as well, and with a law for its inputs it is a
    /// [`Hybrid`](crate::hybrid::Hybrid).
    #[inline(always)]
    fn constraints(&self) -> &'static [Constraint] {
        &[]
    }

    /// [`Hybrid::laws`](crate::hybrid::Hybrid::laws).
    #[inline]
    fn laws(&self) -> [hybrid::Law<T>; MOST] {
        [hybrid::Law::default(); MOST]
    }

    /// [`Hybrid::measures`](crate::hybrid::Hybrid::measures).
    #[inline]
    fn measures(&self, _t: T, _x: &SVector<T, N>) -> [[T; 2]; MOST] {
        [[T::default(); 2]; MOST]
    }

    /// [`System::rhs_under`](crate::System::rhs_under), under the inputs `u`.
    #[inline(always)]
    fn rhs_under_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs, _forces: &[T; MOST]) -> SVector<T, N> {
        self.rhs_with(t, x, u)
    }

    /// [`Hybrid::response`](crate::hybrid::Hybrid::response), under the inputs `u`.
    #[inline]
    fn response_with(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs, forces: &[T; MOST]) -> Response<T, N> {
        Response::new(self.rhs_under_with(t, x, u, forces))
    }

    /// [`HybridJacobian::rhs_and_jacobian_under`](crate::hybrid::HybridJacobian::rhs_and_jacobian_under), the inputs
    /// held fixed.
    #[inline]
    fn rhs_and_jacobian_under_with(
        &self,
        t: T,
        x: &SVector<T, N>,
        u: &Self::Inputs,
        _forces: &[T; MOST],
    ) -> (SVector<T, N>, SMatrix<T, N, N>) {
        self.rhs_and_jacobian_with(t, x, u)
    }

    /// [`HybridJacobian::response_derivative`](crate::hybrid::HybridJacobian::response_derivative), the inputs held
    /// fixed.
    #[inline]
    fn response_derivative_with(
        &self,
        t: T,
        x: &SVector<T, N>,
        u: &Self::Inputs,
        forces: &[T; MOST],
    ) -> ResponseDerivative<T, N>
    where
        T: Lanes,
    {
        let zero = T::default();
        ResponseDerivative {
            response: self.response_with(t, x, u, forces),
            rates: self.rhs_and_jacobian_under_with(t, x, u, forces).1,
            accelerations: [SVector::from([zero; N]); MOST],
            rates_by_time: self.time_derivative_with(t, x, u),
            accelerations_by_time: [zero; MOST],
        }
    }

    /// [`HybridJacobian::measure_derivatives`](crate::hybrid::HybridJacobian::measure_derivatives).
    #[inline]
    fn measure_derivatives(&self, _t: T, _x: &SVector<T, N>) -> MeasureDerivatives<T, N> {
        let zero = T::default();
        MeasureDerivatives {
            by_state: [[SVector::from([zero; N]); 2]; MOST],
            by_time: [[zero; 2]; MOST],
        }
    }
}

impl<T: Real, S: Controlled<T, N, M> + ?Sized, const N: usize, const M: usize> Controlled<T, N, M> for &S {
    type Inputs = S::Inputs;

    forward! { self => (**self);
        rhs_with(t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SVector<T, N>;
        jacobian_with(t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, N>;
        rhs_and_jacobian_with(t: T, x: &SVector<T, N>, u: &Self::Inputs) -> (SVector<T, N>, SMatrix<T, N, N>);
        input_jacobian(t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, M>;
        layout() -> Option<&'static StateLayout>;
        project(t: T, x: &mut SVector<T, N>);
        margins(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&'static str; 2], [T; 2]));
        gaps(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&'static str; 2], [T; 3]));
        time_derivative_with(t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SVector<T, N> where T: Lanes;
        constraints() -> &'static [Constraint];
        laws() -> [hybrid::Law<T>; MOST];
        measures(t: T, x: &SVector<T, N>) -> [[T; 2]; MOST];
        rhs_under_with(t: T, x: &SVector<T, N>, u: &Self::Inputs, forces: &[T; MOST]) -> SVector<T, N>;
        response_with(t: T, x: &SVector<T, N>, u: &Self::Inputs, forces: &[T; MOST]) -> Response<T, N>;
        rhs_and_jacobian_under_with(t: T, x: &SVector<T, N>, u: &Self::Inputs, forces: &[T; MOST])
            -> (SVector<T, N>, SMatrix<T, N, N>);
        response_derivative_with(t: T, x: &SVector<T, N>, u: &Self::Inputs, forces: &[T; MOST])
            -> ResponseDerivative<T, N> where T: Lanes;
        measure_derivatives(t: T, x: &SVector<T, N>) -> MeasureDerivatives<T, N>;
    }
}

/// A model with `M` inputs that can be converted to any number type; what [`Cast`](crate::Cast) is for models without.
///
/// [`mechanism!`](crate::mechanism) implements it for models with inputs, in double precision.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {M} inputs that can be converted to other number types",
    note = "`mechanism!` implements `CastControlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait CastControlled<const N: usize, const M: usize> {
    /// Models with constraints: see [`Cast::HYBRID`](crate::Cast::HYBRID).
    const HYBRID: bool = false;

    /// The model in another number type.
    type In<T: Real>: Controlled<T, N, M>;

    /// The same model in another number type; its constants are rounded.
    fn cast<T: Real>(&self) -> Self::In<T>;

    /// One model per lane, as [`Cast::gather`](crate::Cast::gather).
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm;
}
