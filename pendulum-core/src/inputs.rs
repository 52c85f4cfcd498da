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

pub use law::{ControlLaw, Generic, InputLaw, LawJacobian};
pub use with_inputs::WithInputs;

use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{ActsWith, PlantJacobian};

/// A model with `M` inputs (controls), whose values are given at each evaluation.
///
/// The right-hand side and its derivatives are those of a [`Plant`](crate::Plant), given the inputs. With a law for
/// these it becomes a [`System`](crate::System): see [`inputs`](crate::inputs).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model of {N} state components and {M} inputs",
    note = "`mechanism!` implements `Controlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait Controlled<T: Real, const N: usize, const M: usize>:
    PlantJacobian<T, N, Given: ActsWith<Self::Inputs, T>>
{
    /// The inputs by name; as an array they stand in the order of their declaration.
    type Inputs: Copy + From<[T; M]> + Into<[T; M]>;

    /// The derivative of the right-hand side with respect to the inputs `u`: one column for each, in the order of their
    /// declaration.
    fn input_jacobian(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, M>;

    /// The components of the state, as [`System::layout`](crate::System::layout).
    #[inline]
    fn layout(&self) -> Option<StateLayout<'_>> {
        None
    }

    /// Puts a state back onto its constraints, as [`System::project`](crate::System::project): by default there are
    /// none.
    #[inline(always)]
    fn project(&self, _t: T, _x: &mut SVector<T, N>) {}

    /// Tells how far each closed loop is from its toggle, as [`System::margins`](crate::System::margins).
    #[inline(always)]
    fn margins(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 2])) {}

    /// Reports the gap of each closed loop, as [`System::gaps`](crate::System::gaps).
    #[inline]
    fn gaps(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 3])) {}

    /// The model with a law for its inputs: a [`System`](crate::System).
    ///
    /// The law depends on the time and the state alone, so its closure cannot change what it captures: what a controller
    /// remembers, such as an integral, is no part of the state. Its Jacobian requires the derivative of the law: see
    /// [`WithInputs`].
    #[inline]
    fn with_inputs<F>(&self, inputs: F) -> WithInputs<Self, F, M>
    where
        Self: Copy,
        F: Fn(T, &SVector<T, N>) -> Self::Inputs,
    {
        WithInputs::new(*self, inputs)
    }

    /// The model with a law for its inputs that is generic over the number type: a [`System`](crate::System) with a
    /// [`Jacobian`](crate::Jacobian).
    #[inline]
    fn with_law<L>(&self, law: L) -> WithInputs<Self, Generic<L>, M>
    where
        Self: Copy,
        L: InputLaw<N, M>,
    {
        WithInputs::with_law(*self, law)
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
