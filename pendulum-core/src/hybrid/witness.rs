//! The functions whose zeros end a mode.

use super::mode::{Mode, Status};
use super::{Law, MAX_CONSTRAINTS};

/// A function of a constraint, positive as long as its mode lasts. A zero ends the mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Witness {
    /// Rate of a slipping constraint, in the direction of slip.
    Slip,
    /// Distance from the lower limit.
    Low,
    /// Distance from the upper limit.
    High,
    /// Margin of the holding force before the constraint gives way forward.
    Forward,
    /// Margin of the holding force before the constraint gives way backward.
    Backward,
}

impl Witness {
    const ALL: [Self; 5] = [Self::Slip, Self::Low, Self::High, Self::Forward, Self::Backward];

    /// Witnesses of a constraint in a status.
    pub(super) fn of(status: Status) -> &'static [Self] {
        match status {
            Status::Free => &[Self::Low, Self::High],
            Status::Forward | Status::Backward => &[Self::Slip, Self::Low, Self::High],
            Status::Stuck => &[Self::Forward, Self::Backward],
            Status::Low => &[Self::Forward],
            Status::High => &[Self::Backward],
        }
    }

    /// Distance from the limit at which a constraint has this status.
    pub(super) fn of_limit(status: Status) -> Self {
        match status {
            Status::Low => Self::Low,
            _ => Self::High,
        }
    }

    /// True if the law of the constraint has the limit that the witness needs.
    pub(super) fn exists<T>(self, law: &Law<T>) -> bool {
        match self {
            Self::Low => law.low.is_some(),
            Self::High => law.high.is_some(),
            _ => true,
        }
    }

    /// Index among the values of a constraint.
    pub(super) fn slot(self) -> usize {
        match self {
            Self::Slip | Self::Forward => 0,
            Self::Low | Self::Backward => 1,
            Self::High => 2,
        }
    }

    /// True for a distance from a limit.
    pub(super) fn is_gap(self) -> bool {
        matches!(self, Self::Low | Self::High)
    }

    /// True for a margin of a holding force.
    pub(super) fn is_force(self) -> bool {
        matches!(self, Self::Forward | Self::Backward)
    }
}

/// A value for each witness, in the [slots](Witness::slot) of its constraint.
pub(super) type Values<T> = [[T; 3]; MAX_CONSTRAINTS];

/// A set of pairs of a constraint and a witness.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Witnesses(u64);

impl Witnesses {
    /// Number of bits for each constraint.
    const PLACES: usize = u64::BITS as usize / MAX_CONSTRAINTS;

    /// Witnesses of all constraints in a mode, without limits that their laws do not have.
    pub(crate) fn of<T>(mode: &Mode, laws: &[Law<T>; MAX_CONSTRAINTS]) -> Self {
        let mut all = Self::default();
        for (n, (status, law)) in mode.0.into_iter().zip(laws).enumerate() {
            let own = Witness::of(status).iter().filter(|witness| witness.exists(law));
            own.for_each(|&witness| all.insert(n, witness));
        }
        all
    }

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

    /// First constraint with a witness in the set.
    pub(crate) fn first(self) -> usize {
        self.0.trailing_zeros() as usize / Self::PLACES
    }

    /// Constraints at a limit after these witnesses ended a mode: those held there before, and those whose gaps close.
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

    /// Pairs of a constraint and a witness, in the order of the constraints.
    pub(super) fn pairs(mut self) -> impl Iterator<Item = (usize, Witness)> {
        core::iter::from_fn(move || {
            let bit = self.0.trailing_zeros() as usize;
            self.0 &= self.0.wrapping_sub(1);
            let witness = *Witness::ALL.get(bit % Self::PLACES)?;
            (bit < u64::BITS as usize).then_some((bit / Self::PLACES, witness))
        })
    }
}
