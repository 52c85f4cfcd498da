//! What happened at an impact.

use nalgebra::SVector;

use super::MAX_CONSTRAINTS;
use crate::real::Float;

/// An impact of a [hybrid](crate::hybrid) system: the rates change at once, at one limit or at several.
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
    /// The time, in s.
    pub t: T,
    /// The integral of the force along each constraint, positive forward: in N s, for rates in rad/s in N m s. It is 0
    /// along those that take no part.
    pub impulses: [T; MAX_CONSTRAINTS],
    /// The state before.
    pub before: SVector<T, N>,
    /// The state after. What has hit a limit is moved to it, so positions may change in their last digits.
    pub after: SVector<T, N>,
}

impl<T: Float, const N: usize> Impact<T, N> {
    /// The constraints that take part, in the order of their declaration, each with its impulse.
    pub fn pushes(&self) -> impl Iterator<Item = (usize, T)> {
        let impulses = self.impulses.into_iter().enumerate();
        impulses.filter(|&(_, impulse)| impulse != T::default())
    }
}
