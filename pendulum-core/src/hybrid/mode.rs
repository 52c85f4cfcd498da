//! What each constraint of a hybrid system does.

use core::fmt;

use super::{Constraint, MAX_CONSTRAINTS};

/// What a constraint does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Status {
    /// Nothing: it has no friction, and is away from its limits.
    #[default]
    Free,
    /// It slips with a positive rate.
    Forward,
    /// It slips with a negative rate.
    Backward,
    /// Friction holds it.
    Stuck,
    /// It is held at its least value.
    Low,
    /// It is held at its largest value.
    High,
}

impl Status {
    /// Whether its rate is held at zero.
    #[must_use]
    pub fn is_held(self) -> bool {
        matches!(self, Self::Stuck | Self::Low | Self::High)
    }

    /// Whether it touches a limit.
    #[must_use]
    pub fn touches(self) -> bool {
        matches!(self, Self::Low | Self::High)
    }

    /// The direction in which friction acts.
    pub(super) fn friction(self) -> i8 {
        match self {
            Self::Forward => -1,
            Self::Backward => 1,
            _ => 0,
        }
    }
}

/// What all constraints of a system do, in the order of their declaration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mode(pub [Status; MAX_CONSTRAINTS]);

impl Mode {
    /// Whether a constraint is held.
    #[must_use]
    pub fn is_held(&self, constraint: usize) -> bool {
        self.0[constraint].is_held()
    }

    /// In words: "upper slips forward, lower sticks".
    pub fn describe<'a>(self, constraints: &'a [Constraint<'a>]) -> impl fmt::Display + 'a {
        Described(self, constraints)
    }
}

struct Described<'a>(Mode, &'a [Constraint<'a>]);

impl fmt::Display for Described<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(mode, constraints) = self;
        for (n, (constraint, status)) in constraints.iter().zip(mode.0).enumerate() {
            let does = match status {
                Status::Free => "is free",
                Status::Forward => "slips forward",
                Status::Backward => "slips backward",
                Status::Stuck => "sticks",
                Status::Low if constraint.rate.is_empty() => "touches",
                Status::Low => "is at its lower stop",
                Status::High => "is at its upper stop",
            };
            let separator = if n == 0 { "" } else { ", " };
            write!(f, "{separator}{} {does}", constraint.name)?;
        }
        Ok(())
    }
}

/// The number in which these bits are set.
#[inline(always)]
pub(crate) fn set_of(bits: impl Iterator<Item = usize>) -> u8 {
    bits.fold(0, |set, n| set | 1 << n)
}

/// The places of the bits of a number that are set.
#[inline(always)]
pub(super) fn bits(mut set: u8) -> impl Iterator<Item = usize> + Clone {
    core::iter::from_fn(move || {
        let place = set.trailing_zeros() as usize;
        set &= set.wrapping_sub(1);
        (place < MAX_CONSTRAINTS).then_some(place)
    })
}
