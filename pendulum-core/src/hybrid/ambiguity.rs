//! Impacts whose order is ambiguous.

use super::mode::bits;

/// Simultaneous impacts whose order affects the motion afterwards, but is not resolved by times and states: see
/// [`hybrid`](crate::hybrid).
///
/// The integration continues with all of them at once, with the smallest of their restitutions. An initial condition
/// that differs by less than rounding errors may lead to another motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ambiguity<T> {
    /// Time, in s.
    pub t: T,
    /// Largest difference of a rate between the orders, in rad/s or m/s.
    pub difference: T,
    /// Bit set of the constraints.
    pub(crate) set: u8,
}

impl<T> Ambiguity<T> {
    /// Constraints that reach their limits, in the order of their declaration.
    pub fn constraints(&self) -> impl Iterator<Item = usize> + use<T> {
        bits(self.set)
    }
}
