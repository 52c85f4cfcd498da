//! State transition matrices: dependence of a trajectory on its initial condition.

use nalgebra::{SMatrix, SVector};

use crate::error::Reason;
use crate::method::{Adaptive, Method, Tangent};
use crate::system::{IntoState, Jacobian};
use crate::tableau::Verner9;

/// Verner's method of order 9 with `K` tangents.
pub(super) type Flow<const K: usize> = Adaptive<Tangent<Verner9, 17, K>>;

/// This method with a tolerance, and without a limit on the number of steps.
pub(super) fn flow<const K: usize>(tolerance: f64) -> Flow<K> {
    Flow::new().rtol(tolerance).atol(tolerance).max_steps(usize::MAX)
}

/// Computes the state at `t1` from the state `x0` at `t0`, and its derivative with respect to `x0`: the state
/// transition matrix.
///
/// Entry `(i, j)` is the derivative of component `i` at `t1` with respect to component `j` at `t0`. The matrix solves
/// the variational equations `V' = J(t, x) V` with `V = I` at `t0` and the generated Jacobian, in the same steps as the
/// state (Verner's method of order 9). The relative and absolute tolerance bounds the error per step of the state, and
/// of each column of the matrix relative to its length.
///
/// E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993), I.14.
///
/// # Errors
/// See [`Vern9`](crate::Vern9).
pub fn transition<S, const N: usize>(
    system: &S,
    t0: f64,
    t1: f64,
    x0: impl IntoState<f64, N>,
    tolerance: f64,
) -> Result<(SVector<f64, N>, SMatrix<f64, N, N>), Reason>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let mut stepper = flow::<N>(tolerance).stepper(system, t0, t1, x0)?;
    let x = stepper.run()?;
    Ok((x, SMatrix::from_columns(&stepper.scheme_mut().tangents)))
}
