//! Products of weights with the derivatives of a right-hand side.

use nalgebra::SVector;

use super::System;
use crate::inputs::Controlled;
use crate::real::Real;

/// A [`System`] with the products of weights and the derivatives of its right-hand side, for gradients of trajectories
/// by the [adjoint](crate::sensitivity::gradient).
///
/// `N` is the length of the state, `P` the number of parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `adjoint`",
    note = "`mechanism!` generates it for scenes where `generate` has `rhs` and `adjoint`, without dry friction, \
            stops, walls and loops without a closed form; a model with inputs has it as `model.with_law(law)`",
    note = "derivatives of the others are computed forward, by `sensitivity::solve`"
)]
pub trait Adjoint<T: Real, const N: usize, const P: usize>: System<T, N> {
    /// The transposed derivatives of the right-hand side with respect to the state and to the parameters, times
    /// `weights` of its components.
    fn adjoint(&self, t: T, x: &SVector<T, N>, weights: &SVector<T, N>) -> (SVector<T, N>, SVector<T, P>);

    /// Multiplies `weights` by the transposed derivative of [`System::project`] at a state before the projection. The
    /// default is for a projection that normalises the quaternions of the [layout](System::layout).
    #[inline]
    fn project_adjoint(&self, _t: T, x: &SVector<T, N>, weights: &mut SVector<T, N>) {
        let quaternions = self.layout().into_iter().flat_map(|layout| layout.quaternions());
        for quaternion in quaternions {
            // the derivative of x/|x| is (I - x x^T/x^2)/|x|
            let dot = |a: &SVector<T, N>| quaternion.clone().fold(T::default(), |sum, n| sum + a[n] * x[n]);
            let (square, along) = (dot(x), dot(weights));
            let (over, share) = (T::from_f64(1.0) / square.sqrt(), along / square);
            for n in quaternion.clone() {
                weights[n] = (weights[n] - share * x[n]) * over;
            }
        }
    }
}

/// A [`Controlled`] model with the products of weights and the derivatives of its right-hand side, at given inputs.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `adjoint`",
    note = "`mechanism!` generates it where `generate` has `rhs` and `adjoint`"
)]
pub trait ControlledAdjoint<T: Real, const N: usize, const M: usize, const P: usize>: Controlled<T, N, M> {
    /// The transposed derivatives of the right-hand side with respect to the state, the parameters and the inputs,
    /// times `weights` of its components.
    #[allow(clippy::type_complexity, reason = "three vectors")]
    fn controlled_adjoint(
        &self,
        t: T,
        x: &SVector<T, N>,
        inputs: &Self::Inputs,
        weights: &SVector<T, N>,
    ) -> (SVector<T, N>, SVector<T, P>, SVector<T, M>);
}
