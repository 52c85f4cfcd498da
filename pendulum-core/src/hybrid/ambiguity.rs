//! Impacts whose order is not known.

use super::mode::bits;

/// Impacts at the same time whose order decides how the motion goes on, where times and states do not resolve which
/// comes first: see [`hybrid`](crate::hybrid).
///
/// The motion goes on from all of them at once, with the least of their restitutions. A start that differs by less than
/// rounding errors may end elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ambiguity<T> {
    /// The time, in s.
    pub t: T,
    /// The largest difference that the order makes to a rate, in rad/s or m/s.
    pub difference: T,
    /// The constraints, as bits.
    pub(crate) set: u8,
}

impl<T> Ambiguity<T> {
    /// The constraints that reach their limits, in the order of their declaration.
    pub fn constraints(&self) -> impl Iterator<Item = usize> + use<T> {
        bits(self.set)
    }
}
