//! Models with inputs or constraint forces.

use nalgebra::{SMatrix, SVector};

use super::by_number;
use crate::constraint::{Constraint, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative};
use crate::real::Real;
use crate::real::lanes::Lanes;

/// A model with external inputs, forces along constraints, or both.
///
/// The state is `[q; qd]`, followed by the first-order states if there are any. Arrays of constraints always have the
/// length [`MAX_CONSTRAINTS`]; only the first entries are used. A model with constraints implements all methods, since
/// the defaults panic for it. Without constraints, [`eval`](Self::eval) is sufficient.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with inputs or constraint forces",
    note = "`mechanism!` implements `Plant` for scenes with inputs, dry friction, stops or walls where `generate` \
            has `rhs`; implement it for a model of your own, or `System` if the model has neither"
)]
pub trait Plant<T: Real, const N: usize> {
    /// External actions: the inputs of a [`Controlled`](crate::Controlled) model, the constraint forces of a
    /// [hybrid](crate::hybrid) one, or [`Acting`] for both.
    ///
    /// A constraint force is power-conjugate to the rate of its constraint; positive forces push forward.
    type Given;

    /// Time derivative of the state.
    fn eval(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> SVector<T, N>;

    /// Number of degrees of freedom, and of rates, which follow the positions in the state. There are as many
    /// positions, one more for each orientation, and one more for each dependent coordinate in the state. First-order
    /// states follow the rates. The default is for states that have none of these.
    #[inline(always)]
    fn dof(&self) -> usize {
        N / 2
    }

    /// For each orientation of a model with constraints, in the order of the state: the first component of its unit
    /// quaternion, and that of its angular velocity `w` along the axes of the body, where `dq/dt = q (0, w) / 2`. By
    /// default there are none.
    #[inline(always)]
    fn orientations(&self) -> &[[usize; 2]] {
        &[]
    }

    /// Constraints of the motion, at most [`MAX_CONSTRAINTS`]; none by default.
    #[inline(always)]
    fn constraints(&self) -> &[Constraint<'_>] {
        &[]
    }

    /// Numerical parameters of the constraints.
    #[inline]
    fn laws(&self) -> [Law<T>; MAX_CONSTRAINTS] {
        [Law::default(); MAX_CONSTRAINTS]
    }

    /// Value and rate of each constraint.
    #[inline]
    fn measures(&self, _t: T, _x: &SVector<T, N>) -> [[T; 2]; MAX_CONSTRAINTS] {
        require_none(self.constraints(), "Plant::measures");
        [[T::default(); 2]; MAX_CONSTRAINTS]
    }

    /// [`eval`](Self::eval), and the response to additional constraint forces.
    #[inline]
    fn response(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> Response<T, N> {
        require_none(self.constraints(), "Plant::response");
        Response::new(self.eval(t, x, given))
    }
}

/// Panics if a default method is called on a model with constraints.
#[inline(always)]
#[track_caller]
fn require_none(constraints: &[Constraint], method: &str) {
    assert!(constraints.is_empty(), "a model with constraints implements `{method}`");
}

/// A [`Plant`] with derivatives at fixed external actions.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivatives at given inputs and constraint forces",
    note = "`mechanism!` generates them for scenes with inputs, and for those with dry friction, stops or walls unless \
            `generate` leaves out `jacobian`"
)]
pub trait PlantJacobian<T: Real, const N: usize>: Plant<T, N> {
    /// [`Plant::eval`] and its derivative with respect to the state.
    fn eval_with_jacobian(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> (SVector<T, N>, SMatrix<T, N, N>);

    /// Partial derivative of [`Plant::eval`] with respect to time.
    ///
    /// Generated models compute it exactly. The default is a central difference, as in
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

    /// Derivatives of [`Plant::measures`].
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
    /// [`Canonical::canonical`](crate::Canonical::canonical) with given external actions.
    fn eval_canonical(&self, t: T, x: &SVector<T, N>, given: &Self::Given) -> (SVector<T, N>, SVector<T, N>);

    /// [`Canonical::canonical_jacobian`](crate::Canonical::canonical_jacobian) at fixed external actions.
    fn eval_canonical_jacobian(
        &self,
        t: T,
        x: &SVector<T, N>,
        given: &Self::Given,
    ) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
}

/// A [`Plant`] whose only external actions are constraint forces: a system with any number of modes, see
/// [`hybrid`](crate::hybrid).
pub trait Hybrid<T: Real, const N: usize>: Plant<T, N, Given = [T; MAX_CONSTRAINTS]> {}

impl<T: Real, S: Plant<T, N, Given = [T; MAX_CONSTRAINTS]> + ?Sized, const N: usize> Hybrid<T, N> for S {}

/// A [`Hybrid`] system with derivatives.
pub trait HybridJacobian<T: Real, const N: usize>: Hybrid<T, N> + PlantJacobian<T, N> {}

impl<T: Real, S: PlantJacobian<T, N, Given = [T; MAX_CONSTRAINTS]> + ?Sized, const N: usize> HybridJacobian<T, N>
    for S
{
}

/// Inputs and constraint forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acting<U, T> {
    /// Inputs.
    pub inputs: U,
    /// Constraint forces, in N or N m.
    pub forces: [T; MAX_CONSTRAINTS],
}

/// External actions of a plant with the inputs `U`: `U` itself, or [`Acting`].
pub trait ActsWith<U, T> {
    /// Combines inputs and constraint forces.
    fn with(inputs: U, forces: &[T; MAX_CONSTRAINTS]) -> Self;

    /// Extracts the inputs.
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

/// Constraint forces for friction opposed to the sign of each rate, and no other forces. The right-hand side uses them
/// outside of hybrid integration.
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
