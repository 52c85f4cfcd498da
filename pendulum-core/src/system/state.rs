//! Conversion to state vectors.

use nalgebra::SVector;

/// A state or another vector: an array of `N` numbers, or an [`SVector`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a state of {N} components",
    label = "{N} numbers of type `{T}` expected",
    note = "the state of a mechanism is `[q; qd]`: the coordinates, then their rates; `LAYOUT` of the model lists \
            them, as `DoublePendulum::LAYOUT`"
)]
pub trait IntoState<T, const N: usize> {
    /// Converts to a state vector.
    fn into_state(self) -> SVector<T, N>;
}

impl<T, const N: usize> IntoState<T, N> for SVector<T, N> {
    #[inline]
    fn into_state(self) -> SVector<T, N> {
        self
    }
}

impl<T: nalgebra::Scalar, const N: usize> IntoState<T, N> for [T; N] {
    #[inline]
    fn into_state(self) -> SVector<T, N> {
        SVector::from(self)
    }
}
