//! Models as functions of their parameters.

use crate::real::Real;

/// A model with `P` parameters, which may be numbers of any type. With [dual numbers](crate::dual::Dual) the right-hand
/// side, energies, friction and all else that the model computes carry derivatives with respect to the parameters; see
/// [`sensitivity`](crate::sensitivity).
///
/// [`mechanism!`](crate::mechanism) implements it for scenes with a right-hand side. A model with inputs implements it
/// together with a law that is generic over [`Real`], too.
#[diagnostic::on_unimplemented(
    message = "the parameters of `{Self}` cannot be numbers of another type",
    note = "`mechanism!` implements `Parametric` where `generate` has `rhs`; a model with inputs has it as \
            `model.with_law(law)`, with a law that is generic over `Real`"
)]
pub trait Parametric<const P: usize> {
    /// The model in another number type.
    type Of<T: Real>;

    /// Values of the parameters, in the order of their declaration.
    fn parameters(&self) -> [f64; P];

    /// Returns the model with other parameters, in the order of their declaration, which are not checked.
    fn with_parameters<T: Real>(&self, parameters: [T; P]) -> Self::Of<T>;
}
