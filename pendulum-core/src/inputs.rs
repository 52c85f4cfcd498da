//! Models with inputs, and control laws.
//!
//! A model with inputs and a control law form a closed loop, which is a [`System`](crate::System). Explicit methods
//! accept any closure as the law. Stiff methods and the analyses of [`stability`](crate::stability) also need the
//! derivative of the law, which is provided in one of three ways:
//!
//! | | the law | its derivative |
//! |---|---|---|
//! | `model.with_inputs(law)` | a closure | none |
//! | [`model.with_inputs(law).with_derivative(k)`](WithInputs::with_derivative) | a closure | a closure |
//! | `model.with_law(law)` | an [`InputLaw`], generic over [`Real`] | exact, by [dual numbers](crate::dual) |
//! | [`model.with_inputs(law).by_differences()`](WithInputs::by_differences) | a closure | to about 10 digits |
//!
//! The Jacobian of the model itself is the generated one in every case. With an [`InputLaw`] the closed loop also runs
//! in other number types, and therefore in an [`ensemble`](crate::Ensemble).
//!
//! A law that samples, and holds its values, jumps at each sample. [`control::Sampled`](crate::control::Sampled) runs
//! it with steps that end there.

mod law;
#[cfg(feature = "std")]
mod time_table;
mod with_inputs;

use nalgebra::{SMatrix, SVector};

pub use law::{ControlLaw, Generic, InputLaw, LawJacobian};
#[cfg(feature = "std")]
pub use time_table::TimeTable;
pub use with_inputs::WithInputs;

use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{ActsWith, PlantJacobian};

/// A model with `M` inputs (controls), whose values are passed to each evaluation.
///
/// The right-hand side and its derivatives are those of a [`Plant`](crate::Plant) with given inputs. Together with a
/// control law the model becomes a [`System`](crate::System): see [`inputs`](crate::inputs).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model of {N} state components and {M} inputs",
    note = "`mechanism!` implements `Controlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait Controlled<T: Real, const N: usize, const M: usize>:
    PlantJacobian<T, N, Given: ActsWith<Self::Inputs, T>>
{
    /// The inputs by name. The array form lists them in the order of declaration.
    type Inputs: Copy + From<[T; M]> + Into<[T; M]>;

    /// Derivative of the right-hand side with respect to the inputs `u`: one column per input, in the order of
    /// declaration.
    fn input_jacobian(&self, t: T, x: &SVector<T, N>, u: &Self::Inputs) -> SMatrix<T, N, M>;

    /// Components of the state, as for [`System::layout`](crate::System::layout).
    #[inline]
    fn layout(&self) -> Option<StateLayout<'_>> {
        None
    }

    /// Projects a state onto its constraints, as for [`System::project`](crate::System::project). The default has no
    /// constraints.
    #[inline(always)]
    fn project(&self, _t: T, _x: &mut SVector<T, N>) {}

    /// Reports the distance of each closed loop from its toggle, as for [`System::margins`](crate::System::margins).
    #[inline(always)]
    fn margins(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 2])) {}

    /// Reports the gap of each closed loop, as for [`System::gaps`](crate::System::gaps).
    #[inline]
    fn gaps(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 3])) {}

    /// Reports each component of each output, as for [`System::each_output`](crate::System::each_output).
    #[inline]
    fn each_output(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut(&str, T)) {}

    /// Closes the loop with a law for the inputs. The result is a [`System`](crate::System).
    ///
    /// The law is a function of time and state only: its closure cannot modify its captures. A controller with a state
    /// of its own runs by [`Sampled`](crate::control::Sampled), and the integral of a continuous one is a `state` of
    /// the scene. The Jacobian of the closed loop requires the derivative of the law: see [`WithInputs`].
    #[inline]
    fn with_inputs<F>(&self, inputs: F) -> WithInputs<Self, F, M>
    where
        Self: Copy,
        F: Fn(T, &SVector<T, N>) -> Self::Inputs,
    {
        WithInputs::new(*self, inputs)
    }

    /// Closes the loop with a law generic over the number type. The result is a [`System`](crate::System) with a
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

/// A model with `M` inputs that can be converted to any number type: the counterpart of [`Cast`](crate::Cast) for
/// models with inputs.
///
/// [`mechanism!`](crate::mechanism) implements it for models with inputs, in double precision.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {M} inputs that can be converted to other number types",
    note = "`mechanism!` implements `CastControlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait CastControlled<const N: usize, const M: usize> {
    /// True for models with constraints: see [`Cast::HYBRID`](crate::Cast::HYBRID).
    const HYBRID: bool = false;

    /// The model in another number type.
    type In<T: Real>: Controlled<T, N, M>;

    /// Converts the model to another number type. Its constants are rounded.
    fn cast<T: Real>(&self) -> Self::In<T>;

    /// Combines one model per lane, as [`Cast::gather`](crate::Cast::gather).
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm;
}
