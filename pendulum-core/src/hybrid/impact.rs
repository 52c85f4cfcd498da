//! Impacts of a hybrid system.

use nalgebra::SVector;

use super::MAX_CONSTRAINTS;
use crate::real::Float;

/// An impact of a [hybrid](crate::hybrid) system: an instantaneous change of the rates, at one or more limits.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Impact<T, const N: usize> {
    /// Time, in s.
    pub t: T,
    /// Integral of the force along each constraint, positive forward: in N s, or in N m s for rates in rad/s. It is 0
    /// along constraints that take no part.
    pub impulses: [T; MAX_CONSTRAINTS],
    /// State before.
    pub before: SVector<T, N>,
    /// State after. Constraints are moved onto the limits that they hit, so positions may change in their last digits.
    pub after: SVector<T, N>,
}

impl<T: Float, const N: usize> Impact<T, N> {
    /// Constraints that take part, in the order of their declaration, with their impulses.
    pub fn pushes(&self) -> impl Iterator<Item = (usize, T)> {
        let impulses = self.impulses.into_iter().enumerate();
        impulses.filter(|&(_, impulse)| impulse != T::default())
    }
}
