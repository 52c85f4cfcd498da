//! The impacts at an instant.

use nalgebra::SVector;

use crate::real::Float;

/// Impacts that follow each other at once; after these, contacts that still approach stay together.
const MOST_IMPACTS: usize = 1 << 12;
/// Tries of all orders at an instant: each follows the impacts to their end.
const MOST_TRIES: usize = 4;

/// The impacts at an instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series<T, const N: usize> {
    pub(super) count: usize,
    /// The largest energy that was lost or turned back in one of the first.
    pub(super) largest: T,
    /// The tries of all orders that are left; none where one order is followed, to be compared with others.
    pub(super) tries: usize,
    /// The contacts whose order mattered, with the differences that it makes to the state.
    pub(super) ambiguity: Option<(u8, SVector<T, N>)>,
}

impl<T: Float, const N: usize> Series<T, N> {
    pub(super) fn none() -> Self {
        Self {
            count: 0,
            largest: T::default(),
            tries: MOST_TRIES,
            ambiguity: None,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Tries no other orders.
    pub(super) fn follow_one_order(&mut self) {
        self.tries = 0;
    }

    /// Returns true if there are too many of them, as where contacts contradict each other.
    pub(super) fn is_too_long(&self) -> bool {
        self.count > MOST_IMPACTS
    }

    /// From now on contacts that still approach stay together.
    pub(super) fn ends_now(&self) -> bool {
        self.count == MOST_IMPACTS
    }

    /// Begins anew, at another instant.
    pub(super) fn begin(&mut self) {
        (self.count, self.largest) = (0, T::default());
    }
}
