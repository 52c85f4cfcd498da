//! Models on which something acts from outside.

use nalgebra::{SMatrix, SVector};

use super::by_number;
use crate::constraint::{Constraint, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative};
use crate::real::Real;
use crate::real::lanes::Lanes;

/// A model on which something acts from outside: inputs, or forces along constraints, or both.
///
/// The state is `[q; qd]`. [`MAX_CONSTRAINTS`] constraints are passed everywhere, of which only the first are used. A model that
/// has some implements all methods: the defaults panic where there are any. Without, [`eval`](Self::eval) is enough.
#[diagnostic::on_unimplemented(
    message = "nothing acts on `{Self}` from outside, or it cannot be told what",
    note = "`mechanism!` implements `Plant` for scenes with inputs, dry friction, stops or walls where `generate` has \
            `rhs`; a model by hand implements it itself, and is a `System` if nothing acts on it"
)]
pub trait Plant<T: Real, const N: usize> {
    /// What acts: the inputs of a [`Controlled`](crate::Controlled) model, the forces along the constraints of a
    /// [hybrid](crate::hybrid) one, or [`Acting`] where there are both.
    ///
    /// Forces along constraints are those that do work with their rates: positive ones push forward.
    type Given;

    /// The time derivative of the state.
    fn eval(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> SVector<T, N>;

    /// The constraints of the motion, [`MAX_CONSTRAINTS`] of them at most: none by default.
    #[inline(always)]
    fn constraints(&self) -> &[Constraint<'_>] {
        &[]
    }

    /// Their numbers.
    #[inline]
    fn laws(&self) -> [Law<T>; MAX_CONSTRAINTS] {
        [Law::default(); MAX_CONSTRAINTS]
    }

    /// The value and the rate of each constraint.
    #[inline]
    fn measures(&self, _t: T, _x: &SVector<T, N>) -> [[T; 2]; MAX_CONSTRAINTS] {
        require_none(self.constraints(), "Plant::measures");
        [[T::default(); 2]; MAX_CONSTRAINTS]
    }

    /// [`eval`](Self::eval), and what more force along the constraints would change.
    #[inline]
    fn response(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> Response<T, N> {
        require_none(self.constraints(), "Plant::response");
        Response::new(self.eval(t, x, given))
    }
}

/// A default is for models without constraints.
#[inline(always)]
#[track_caller]
fn require_none(constraints: &[Constraint], method: &str) {
    assert!(constraints.is_empty(), "a model with constraints implements `{method}`");
}

/// A [`Plant`] that knows its derivatives, what acts held fixed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivatives given what acts on it",
    note = "`mechanism!` generates them for scenes with inputs, and for those with dry friction, stops or walls unless \
            `generate` leaves out `jacobian`"
)]
pub trait PlantJacobian<T: Real, const N: usize>: Plant<T, N> {
    /// [`Plant::eval`], and its derivative with respect to the state.
    fn eval_with_jacobian(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> (SVector<T, N>, SMatrix<T, N, N>);

    /// The derivative of [`Plant::eval`] with respect to the time.
    ///
    /// Generated models know it exactly. By default it is a central difference, as in
    /// [`Jacobian::time_derivative`](crate::Jacobian::time_derivative).
    #[inline]
    fn eval_time_derivative(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> SVector<T, N>
    where
        T: Lanes,
    {
        by_number(t, |t| self.eval(t, x, given))
    }

    /// [`Plant::response`] with its derivatives.
    #[inline]
    fn response_derivative(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> ResponseDerivative<T, N>
    where
        T: Lanes,
    {
        require_none(self.constraints(), "PlantJacobian::response_derivative");
        let zero = T::default();
        ResponseDerivative {
            response: self.response(t, x, given),
            rates: self.eval_with_jacobian(t, x, given).1,
            accelerations: [SVector::from([zero; N]); MAX_CONSTRAINTS],
            rates_by_time: self.eval_time_derivative(t, x, given),
            accelerations_by_time: [zero; MAX_CONSTRAINTS],
        }
    }

    /// The derivatives of [`Plant::measures`].
    #[inline]
    fn measure_derivatives(&self, _t: T, _x: &SVector<T, N>) -> MeasureDerivatives<T, N> {
        require_none(self.constraints(), "PlantJacobian::measure_derivatives");
        let zero = T::default();
        MeasureDerivatives {
            by_state: [[SVector::from([zero; N]); 2]; MAX_CONSTRAINTS],
            by_time: [[zero; 2]; MAX_CONSTRAINTS],
        }
    }
}

/// A [`Plant`] with [canonical](crate::Canonical) equations.
pub trait PlantCanonical<T: Real, const N: usize>: Plant<T, N> {
    /// [`Canonical::canonical`](crate::Canonical::canonical).
    fn eval_canonical(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> (SVector<T, N>, SVector<T, N>);

    /// [`Canonical::canonical_jacobian`](crate::Canonical::canonical_jacobian), what acts held fixed.
    fn eval_canonical_jacobian(
        &self,
        t: T,
        x: &SVector<T, N>,
        given: &Self::Given,
    ) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
}

/// A [`Plant`] on which nothing but the forces along its constraints acts: a system in any number of modes, see
/// [`hybrid`](crate::hybrid).
pub trait Hybrid<T: Real, const N: usize>: Plant<T, N, Given = [T; MAX_CONSTRAINTS]> {}

impl<T: Real, S: Plant<T, N, Given = [T; MAX_CONSTRAINTS]> + ?Sized, const N: usize> Hybrid<T, N> for S {}

/// A [`Hybrid`] that knows its derivatives.
pub trait HybridJacobian<T: Real, const N: usize>: Hybrid<T, N> + PlantJacobian<T, N> {}

impl<T: Real, S: PlantJacobian<T, N, Given = [T; MAX_CONSTRAINTS]> + ?Sized, const N: usize> HybridJacobian<T, N>
    for S
{
}

/// Inputs, and forces along constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acting<U, T> {
    /// The inputs.
    pub inputs: U,
    /// The forces, in N or N m.
    pub forces: [T; MAX_CONSTRAINTS],
}

/// What acts on a plant with the inputs `U`: these alone, or [`Acting`].
pub trait ActsWith<U, T> {
    /// From the inputs, and the forces along its constraints.
    fn with(inputs: U, forces: &[T; MAX_CONSTRAINTS]) -> Self;

    /// The inputs of what acts.
    fn inputs_of(given: &Self) -> &U;
}

impl<U, T> ActsWith<U, T> for U {
    #[inline(always)]
    fn with(inputs: U, _forces: &[T; MAX_CONSTRAINTS]) -> U {
        inputs
    }

    #[inline(always)]
    fn inputs_of(given: &Self) -> &U {
        given
    }
}

impl<U, T: Copy> ActsWith<U, T> for Acting<U, T> {
    #[inline(always)]
    fn with(inputs: U, forces: &[T; MAX_CONSTRAINTS]) -> Self {
        Self {
            inputs,
            forces: *forces,
        }
    }

    #[inline(always)]
    fn inputs_of(given: &Self) -> &U {
        &given.inputs
    }
}

/// The forces along the constraints where friction acts by the sign of each rate, and nothing else does: those of a
/// right-hand side by itself.
#[inline(always)]
pub fn by_sign<T: Real, const N: usize>(
    plant: &(impl Plant<T, N> + ?Sized),
    t: T,
    x: &SVector<T, N>,
) -> [T; MAX_CONSTRAINTS] {
    let mut forces = [T::default(); MAX_CONSTRAINTS];
    if plant.constraints().is_empty() {
        return forces;
    }
    let (laws, measures) = (plant.laws(), plant.measures(t, x));
    for n in 0..plant.constraints().len() {
        forces[n] = -laws[n].slipping * measures[n][1].signum();
    }
    forces
}
