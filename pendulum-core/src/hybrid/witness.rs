//! The functions whose zeros end a mode.

use super::mode::{Mode, Status};
use super::{Law, MAX_CONSTRAINTS};

/// A function of a constraint that is positive as long as a mode lasts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Witness {
    /// The rate of what slips, in the direction of the slip.
    Slip,
    /// The distance from the lower limit.
    Low,
    /// The distance from the upper limit.
    High,
    /// What the force that holds can still take before the constraint gives way forward.
    Forward,
    /// The same backward.
    Backward,
}

impl Witness {
    const ALL: [Self; 5] = [Self::Slip, Self::Low, Self::High, Self::Forward, Self::Backward];

    /// Those of a constraint in a status.
    pub(super) fn of(status: Status) -> &'static [Self] {
        match status {
            Status::Free => &[Self::Low, Self::High],
            Status::Forward | Status::Backward => &[Self::Slip, Self::Low, Self::High],
            Status::Stuck => &[Self::Forward, Self::Backward],
            Status::Low => &[Self::Forward],
            Status::High => &[Self::Backward],
        }
    }

    /// Whether a constraint that has it by its status has it by its law as well.
    pub(super) fn exists<T>(self, law: &Law<T>) -> bool {
        match self {
            Self::Low => law.low.is_some(),
            Self::High => law.high.is_some(),
            _ => true,
        }
    }

    /// Its place among the numbers of a constraint.
    pub(super) fn slot(self) -> usize {
        match self {
            Self::Slip | Self::Forward => 0,
            Self::Low | Self::Backward => 1,
            Self::High => 2,
        }
    }

    /// Whether it is a distance from a limit.
    pub(super) fn is_gap(self) -> bool {
        matches!(self, Self::Low | Self::High)
    }

    /// Whether it is a margin of a force that holds.
    pub(super) fn is_force(self) -> bool {
        matches!(self, Self::Forward | Self::Backward)
    }
}

/// A number for each witness, in the [slots](Witness::slot) of its constraint.
pub(super) type Values<T> = [[T; 3]; MAX_CONSTRAINTS];

/// A set of witnesses, each of a constraint.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Witnesses(u64);

impl Witnesses {
    /// Bits of a constraint.
    const PLACES: usize = u64::BITS as usize / MAX_CONSTRAINTS;

    fn bit(constraint: usize, witness: Witness) -> u64 {
        const { assert!(Witness::ALL.len() <= Self::PLACES) };
        1 << (constraint * Self::PLACES + witness as usize)
    }

    pub(super) fn only(constraint: usize, witness: Witness) -> Self {
        Self(Self::bit(constraint, witness))
    }

    pub(super) fn has(self, constraint: usize, witness: Witness) -> bool {
        self.0 & Self::bit(constraint, witness) != 0
    }

    pub(super) fn insert(&mut self, constraint: usize, witness: Witness) {
        self.0 |= Self::bit(constraint, witness);
    }

    pub(super) fn filter(self, mut holds: impl FnMut(&(usize, Witness)) -> bool) -> Self {
        let mut chosen = Self::default();
        self.pairs()
            .filter(|witness| holds(witness))
            .for_each(|(n, witness)| chosen.insert(n, witness));
        chosen
    }

    pub(crate) fn or(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    pub(super) fn and(self, others: Self) -> Self {
        Self(self.0 & others.0)
    }

    pub(super) fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The first constraint of which one is.
    pub(crate) fn first(self) -> usize {
        self.0.trailing_zeros() as usize / Self::PLACES
    }

    /// The constraints at a limit where these end a mode: those held there, and those whose gaps close.
    pub(crate) fn touching(self, mode: &Mode) -> [Status; MAX_CONSTRAINTS] {
        let mut touching = mode.0;
        for (n, witness) in self.pairs() {
            match witness {
                Witness::Low => touching[n] = Status::Low,
                Witness::High => touching[n] = Status::High,
                _ => {}
            }
        }
        touching
    }

    /// The witnesses with their constraints, in the order of these.
    pub(super) fn pairs(mut self) -> impl Iterator<Item = (usize, Witness)> {
        core::iter::from_fn(move || {
            let bit = self.0.trailing_zeros() as usize;
            self.0 &= self.0.wrapping_sub(1);
            let witness = *Witness::ALL.get(bit % Self::PLACES)?;
            (bit < u64::BITS as usize).then_some((bit / Self::PLACES, witness))
        })
    }
}
