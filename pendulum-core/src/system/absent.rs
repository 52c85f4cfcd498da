//! Routines that a model may lack. Calling one is an error whose message explains how to generate it.

use super::Plant;
use crate::real::Real;

/// Placeholders for optional routines. Models that have a routine define it as an inherent function, which hides the
/// placeholder.
#[expect(missing_docs, reason = "no model has them")]
pub trait Absent<T: Real, const N: usize> {
    fn mass_matrix<X>(&self, _: T, _: X)
    where
        Self: MassMatrix,
    {
    }

    fn bias<X>(&self, _: T, _: X)
    where
        Self: Bias,
    {
    }

    fn momentum<X>(&self, _: T, _: X)
    where
        Self: Momentum,
    {
    }

    fn inverse_dynamics<X, A>(&self, _: T, _: X, _: A)
    where
        Self: InverseDynamics,
    {
    }

    fn parameter_jacobian<X>(&self, _: T, _: X)
    where
        Self: ParameterJacobian,
    {
    }

    fn drive_forces<X>(&self, _: T, _: X)
    where
        Self: DriveForces,
    {
    }

    fn loop_wrenches<X>(&self, _: T, _: X)
    where
        Self: LoopWrenches,
    {
    }
}

// models with inputs are plants too, and only models are
impl<M: Plant<T, N>, T: Real, const N: usize> Absent<T, N> for M {}

macro_rules! never {
    ($($bound:ident: $message:literal, $word:literal;)*) => { $(
        /// Implemented by no model.
        #[diagnostic::on_unimplemented(message = $message, label = "not generated", note = $word)]
        pub trait $bound {}
    )* };
}

never! {
    MassMatrix: "`{Self}` has no `mass_matrix`",
        "write `generate: [rhs, jacobian, energy, mass_matrix],` in its declaration";
    Bias: "`{Self}` has no `bias`",
        "write `generate: [rhs, jacobian, energy, bias],` in its declaration";
    Momentum: "`{Self}` has no `momentum`",
        "write `generate: [rhs, jacobian, energy, momentum],` in its declaration";
    InverseDynamics: "`{Self}` has no `inverse_dynamics`",
        "write `generate: [rhs, jacobian, energy, inverse_dynamics],` in its declaration";
    ParameterJacobian: "`{Self}` has no `parameter_jacobian`",
        "write `generate: [rhs, jacobian, energy, parameter_jacobian],` in its declaration";
    DriveForces: "`{Self}` has no `drive_forces`",
        "write `generate: [rhs, jacobian, energy, drive_forces],` in its declaration";
    LoopWrenches: "`{Self}` has no `loop_wrenches`",
        "write `generate: [rhs, jacobian, energy, loop_wrenches],` in its declaration";
}
