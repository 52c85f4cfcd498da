//! Routines that a model may lack. Calling one is an error whose message explains how to generate it.

use super::Plant;
use crate::real::Real;

macro_rules! absent {
    ($($routine:ident($($argument:ident),*): $bound:ident, $message:literal, $note:literal;)*) => {
        /// Placeholders for optional routines. Models that have a routine define it as an inherent function, which
        /// hides the placeholder.
        #[expect(missing_docs, reason = "no model has them")]
        pub trait Absent<T: Real, const N: usize> {
            $(
                fn $routine<$($argument),*>(&self, _: T $(, _: $argument)*)
                where
                    Self: $bound,
                {
                }
            )*
        }

        $(
            /// Implemented by no model.
            #[diagnostic::on_unimplemented(message = $message, label = "not generated", note = $note)]
            pub trait $bound {}
        )*
    };
}

absent! {
    mass_matrix(X): MassMatrix,
        "`{Self}` has no `mass_matrix`",
        "write `generate: [rhs, jacobian, energy, mass_matrix],` in its declaration";
    bias(X): Bias,
        "`{Self}` has no `bias`",
        "write `generate: [rhs, jacobian, energy, bias],` in its declaration";
    momentum(X): Momentum,
        "`{Self}` has no `momentum`",
        "write `generate: [rhs, jacobian, energy, momentum],` in its declaration";
    inverse_dynamics(X, A): InverseDynamics,
        "`{Self}` has no `inverse_dynamics`",
        "write `generate: [rhs, jacobian, energy, inverse_dynamics],` in its declaration";
    parameter_jacobian(X): ParameterJacobian,
        "`{Self}` has no `parameter_jacobian`",
        "write `generate: [rhs, jacobian, energy, parameter_jacobian],` in its declaration";
    adjoint(X, W): Adjoint,
        "`{Self}` has no `adjoint`",
        "write `generate: [rhs, jacobian, energy, adjoint],` in its declaration";
    hessian_product(X, W, D): HessianProduct,
        "`{Self}` has no `hessian_product`",
        "write `generate: [rhs, jacobian, energy, hessian_product],` in its declaration";
    drive_forces(X): DriveForces,
        "`{Self}` has no `drive_forces`",
        "write `generate: [rhs, jacobian, energy, drive_forces],` in its declaration";
    loop_wrenches(X): LoopWrenches,
        "`{Self}` has no `loop_wrenches`",
        "write `generate: [rhs, jacobian, energy, loop_wrenches],` in its declaration";
}

// models with inputs are plants too, and only models are
impl<M: Plant<T, N>, T: Real, const N: usize> Absent<T, N> for M {}
