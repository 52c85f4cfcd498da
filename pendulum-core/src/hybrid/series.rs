//! Impacts at an instant.

use nalgebra::SVector;

use crate::real::Float;

/// Maximum number of impacts at an instant; after these, contacts that still approach stay together.
const MOST_IMPACTS: usize = 1 << 12;
/// Number of times per instant that all orders of impacts are tried, each followed to its end.
const MOST_TRIES: usize = 4;

/// A series of impacts at an instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series<T, const N: usize> {
    pub(super) count: usize,
    /// Largest energy lost or turned back in one of the first impacts.
    pub(super) largest: T,
    /// Remaining tries of all orders. Zero while a single order is followed, for comparison with others.
    pub(super) tries: usize,
    /// Contacts whose order mattered, with the differences of the state that it makes.
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

    /// Disables tries of other orders.
    pub(super) fn follow_one_order(&mut self) {
        self.tries = 0;
    }

    /// Returns true if there are too many impacts, as where contacts contradict each other.
    pub(super) fn is_too_long(&self) -> bool {
        self.count > MOST_IMPACTS
    }

    /// True if contacts that still approach stay together from now on.
    pub(super) fn ends_now(&self) -> bool {
        self.count == MOST_IMPACTS
    }

    /// Restarts the series at another instant.
    pub(super) fn begin(&mut self) {
        (self.count, self.largest) = (0, T::default());
    }
}
