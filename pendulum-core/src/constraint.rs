//! Constraints of a motion, and the response to forces along them: the quantities of [hybrid](crate::hybrid) systems.

use nalgebra::{SMatrix, SVector};

use crate::real::Real;

/// Maximum number of constraints of a system.
pub const MAX_CONSTRAINTS: usize = 8;

/// A constraint of a motion, by friction or limits: see [`hybrid`](crate::hybrid).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Constraint<'a> {
    /// Name in messages.
    pub name: &'a str,
    /// Components and signs, 1 or -1, of a rate that is a sum of components of the state. Such a rate is exactly zero
    /// while it is held: its last component is computed from the others, so it must not occur in earlier constraints.
    /// Empty for any other rate.
    pub rate: &'a [(usize, i8)],
}

/// Parameters of a [`Constraint`], with forces in N or N m and rates in m/s or rad/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law<T> {
    /// Friction force while it slips; 0 without friction.
    pub slipping: T,
    /// Maximum friction force at rest. It must not be below `slipping`, which is not checked for models written by
    /// hand.
    pub sticking: T,
    /// Lower limit.
    pub low: Option<T>,
    /// Upper limit.
    pub high: Option<T>,
    /// Coefficient of restitution of impacts at a limit, from 0 to 1.
    pub restitution: T,
    /// Rate of approach below which there is no rebound.
    pub slow: T,
}

/// Forces and held constraints of a [`Mode`](crate::hybrid::Mode), for the equations of motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hold<T> {
    /// Forces along the constraints that slip, or that rest only with others; 0 along the others.
    pub forces: [T; MAX_CONSTRAINTS],
    /// Bit set of the constraints whose rates are held at zero.
    pub held: u8,
    /// Subset of `held` whose forces are solved for. The other held constraints depend on these, and rest if they do.
    pub solved: u8,
}

/// Response of the motion to forces along constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<T, const N: usize> {
    /// Right-hand side under the given forces.
    pub rates: SVector<T, N>,
    /// Second time derivatives of the constraints, under these forces.
    pub accelerations: [T; MAX_CONSTRAINTS],
    /// Change of the right-hand side by an additional unit force along each constraint.
    pub columns: [SVector<T, N>; MAX_CONSTRAINTS],
    /// Change of the second derivatives by such a force: entry `[i][j]` is the change of constraint `i` by a force
    /// along `j`; symmetric.
    pub matrix: [[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
}

impl<T: Real, const N: usize> Response<T, N> {
    /// Response with this right-hand side, and zeros otherwise.
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

/// Derivatives of the value and of the rate of each constraint.
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
    /// Derivative of the right-hand side with respect to the state.
    pub rates: SMatrix<T, N, N>,
    /// Gradients of the second derivatives of the constraints with respect to the state.
    pub accelerations: [SVector<T, N>; MAX_CONSTRAINTS],
    /// Derivative of the right-hand side with respect to the time.
    pub rates_by_time: SVector<T, N>,
    /// Derivatives of the second derivatives of the constraints with respect to the time.
    pub accelerations_by_time: [T; MAX_CONSTRAINTS],
}
