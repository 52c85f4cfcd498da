//! The functions of constraints that end a mode, as a set.

use super::MOST;
use super::mode::{Mode, Status};

/// Number of functions by which a constraint may end a mode: each is positive as long as the mode lasts.
pub(super) const WAYS: usize = 3;
/// The rate while it slips; what friction or a contact can still take before it gives way forward.
pub(super) const FORWARD: usize = 0;
/// The distance from the lower limit; what can still be taken before it gives way backward.
pub(super) const BACKWARD: usize = 1;
/// The distance from the upper limit.
pub(super) const UPPER: usize = 2;

/// The functions of all constraints, those of one after those of the other; infinite where there is none.
pub(super) type Values<T> = [[T; WAYS]; MOST];

/// A set of functions, as bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Fired(u32);

impl Fired {
    pub(super) fn has(self, constraint: usize, way: usize) -> bool {
        self.0 & 1 << (constraint * WAYS + way) != 0
    }

    pub(super) fn insert(&mut self, constraint: usize, way: usize) {
        self.0 |= 1 << (constraint * WAYS + way);
    }

    pub(super) fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The first constraint of which one is.
    pub(crate) fn first(self) -> usize {
        self.0.trailing_zeros() as usize / WAYS
    }

    /// The constraints at a limit where these end a mode: those held there, and those whose gaps close.
    pub(crate) fn touching(self, mode: &Mode) -> [Status; MOST] {
        let mut touching = mode.0;
        for (n, way) in self.pairs().filter(|&(n, way)| way != FORWARD && !mode.is_held(n)) {
            touching[n] = if way == BACKWARD { Status::Low } else { Status::High };
        }
        touching
    }

    pub(super) fn pairs(mut self) -> impl Iterator<Item = (usize, usize)> {
        core::iter::from_fn(move || {
            let slot = self.0.trailing_zeros() as usize;
            self.0 &= self.0.wrapping_sub(1);
            (slot < MOST * WAYS).then_some((slot / WAYS, slot % WAYS))
        })
    }
}
