//! Models as functions of their parameters.

use super::Cast;
use crate::error::ParameterError;
use crate::inputs::CastControlled;
use crate::real::Real;

/// A [`Cast`] with `P` parameters, which may be numbers of any type. With [dual numbers](crate::dual::Dual) the
/// right-hand side, energies, friction and all else that the model computes carry derivatives with respect to the
/// parameters; see [`sensitivity`](crate::sensitivity). `N` is the length of the state.
///
/// [`mechanism!`](crate::mechanism) implements it for scenes without inputs that have a right-hand side. A model with
/// inputs implements it together with a law that is generic over [`Real`].
#[diagnostic::on_unimplemented(
    message = "the parameters of `{Self}` cannot be numbers of another type",
    note = "`mechanism!` implements `Parametric` where `generate` has `rhs`; a model with inputs has it as \
            `model.with_law(law)`, with a law that is generic over `Real`"
)]
pub trait Parametric<const N: usize, const P: usize>: Cast<N> {
    /// Values of the parameters, in the order of their declaration.
    fn parameters(&self) -> [f64; P];

    /// Names of the parameters, in the order of their declaration.
    fn parameter_names(&self) -> [&str; P];

    /// Checks that the model can have these parameters.
    ///
    /// # Errors
    /// The first parameter, or combination of parameters, that is impossible.
    fn check_parameters(&self, parameters: &[f64; P]) -> Result<(), ParameterError>;

    /// Returns the model with other parameters, in the order of their declaration, which are not checked.
    fn with_parameters<T: Real>(&self, parameters: [T; P]) -> Self::In<T>;

    /// True if two models that [share lanes](Cast::shares_lanes) differ in parameters alone.
    #[doc(hidden)]
    fn differs_in_parameters(&self, _other: &Self) -> bool {
        true
    }
}

/// [`Parametric`] for a model with `M` inputs.
pub trait ParametricControlled<const N: usize, const M: usize, const P: usize>: CastControlled<N, M> {
    /// See [`Parametric::parameters`].
    fn parameters(&self) -> [f64; P];

    /// See [`Parametric::parameter_names`].
    fn parameter_names(&self) -> [&str; P];

    /// See [`Parametric::check_parameters`].
    ///
    /// # Errors
    /// The first parameter, or combination of parameters, that is impossible.
    fn check_parameters(&self, parameters: &[f64; P]) -> Result<(), ParameterError>;

    /// See [`Parametric::with_parameters`].
    fn with_parameters<T: Real>(&self, parameters: [T; P]) -> Self::In<T>;
}
