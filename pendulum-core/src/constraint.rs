//! Constraints of a motion, and what forces along them do: the numbers of [hybrid](crate::hybrid) systems.

use nalgebra::{SMatrix, SVector};

use crate::real::Real;

/// The most constraints of a system.
pub const MAX_CONSTRAINTS: usize = 8;

/// A constraint of a motion, by friction or limits: see [`hybrid`](crate::hybrid).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Constraint<'a> {
    /// What it is called, in messages.
    pub name: &'a str,
    /// For a rate that is a sum of components of the state, each with the sign 1 or -1: their places and signs. Such a
    /// rate is exactly zero while it is held: its last component is computed from the others, and so must not occur in
    /// the constraints before. Empty for any other rate.
    pub rate: &'a [(usize, i8)],
}

/// The numbers of a [`Constraint`], forces in N or N m, rates in m/s or rad/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law<T> {
    /// The friction force while it slips; 0 where there is none.
    pub slipping: T,
    /// The largest friction force at rest. It must not be below `slipping`, which is not checked for models written by
    /// hand.
    pub sticking: T,
    /// The least value.
    pub low: Option<T>,
    /// The largest value.
    pub high: Option<T>,
    /// What remains of the rate after an impact at a limit, from 0 to 1.
    pub restitution: T,
    /// Below this rate there is no rebound.
    pub slow: T,
}

/// What equations of motion need to know of a [`Mode`](crate::hybrid::Mode).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hold<T> {
    /// The forces along the constraints that slip, or that rest only with others; 0 along the rest.
    pub forces: [T; MAX_CONSTRAINTS],
    /// The constraints whose rates are held at zero, as bits.
    pub held: u8,
    /// Those of them whose forces are solved for. Where these stand still, so do the others of `held`, which depend on
    /// them.
    pub solved: u8,
}

/// What forces along constraints do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<T, const N: usize> {
    /// The right-hand side under the forces given.
    pub rates: SVector<T, N>,
    /// The second derivatives of the constraints by the time, under these forces.
    pub accelerations: [T; MAX_CONSTRAINTS],
    /// What a unit of further force along each constraint adds to the right-hand side.
    pub columns: [SVector<T, N>; MAX_CONSTRAINTS],
    /// What it adds to the second derivatives: entry `[i][j]` to that of `i` by a force along `j`; symmetric.
    pub matrix: [[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
}

impl<T: Real, const N: usize> Response<T, N> {
    /// With this right-hand side, and zero elsewhere.
    #[inline(always)]
    pub fn new(rates: SVector<T, N>) -> Self {
        let zero = T::default();
        Self {
            rates,
            accelerations: [zero; MAX_CONSTRAINTS],
            columns: [SVector::from([zero; N]); MAX_CONSTRAINTS],
            matrix: [[zero; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
        }
    }
}

/// The derivatives of the value and of the rate of each constraint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasureDerivatives<T, const N: usize> {
    /// With respect to the state.
    pub by_state: [[SVector<T, N>; 2]; MAX_CONSTRAINTS],
    /// With respect to the time.
    pub by_time: [[T; 2]; MAX_CONSTRAINTS],
}

/// A [`Response`] with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResponseDerivative<T, const N: usize> {
    /// The response.
    pub response: Response<T, N>,
    /// The derivative of the right-hand side with respect to the state.
    pub rates: SMatrix<T, N, N>,
    /// Those of the second derivatives of the constraints: a gradient for each.
    pub accelerations: [SVector<T, N>; MAX_CONSTRAINTS],
    /// The derivative of the right-hand side with respect to the time.
    pub rates_by_time: SVector<T, N>,
    /// Those of the second derivatives of the constraints.
    pub accelerations_by_time: [T; MAX_CONSTRAINTS],
}
