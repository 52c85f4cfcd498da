//! Status of each constraint of a hybrid system.

use core::fmt;

use super::{Constraint, MAX_CONSTRAINTS};

/// Status of a constraint.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Status {
    /// Without friction, and away from its limits.
    #[default]
    Free,
    /// Slips with a positive rate.
    Forward,
    /// Slips with a negative rate.
    Backward,
    /// Held by friction.
    Stuck,
    /// Held at its lower limit.
    Low,
    /// Held at its upper limit.
    High,
}

impl Status {
    /// True if the rate is held at zero.
    #[must_use]
    pub fn is_held(self) -> bool {
        matches!(self, Self::Stuck | Self::Low | Self::High)
    }

    /// True if the constraint touches a limit.
    #[must_use]
    pub fn touches(self) -> bool {
        matches!(self, Self::Low | Self::High)
    }

    /// Sign of the rate of a slip: -1 backward, otherwise 1.
    pub(super) fn slip(self) -> f64 {
        if self == Self::Backward { -1.0 } else { 1.0 }
    }

    /// Direction in which friction acts: 1 forward, -1 backward, 0 for none.
    pub(super) fn friction(self) -> i8 {
        match self {
            Self::Forward => -1,
            Self::Backward => 1,
            _ => 0,
        }
    }
}

/// Status of all constraints of a system, in the order of their declaration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mode(pub [Status; MAX_CONSTRAINTS]);

impl Mode {
    /// True if a constraint is held.
    #[must_use]
    pub fn is_held(&self, constraint: usize) -> bool {
        self.0[constraint].is_held()
    }

    /// Describes the mode in words: "upper slips forward, lower sticks".
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

/// Returns the bit set of these indices.
#[inline(always)]
pub(crate) fn set_of(bits: impl Iterator<Item = usize>) -> u8 {
    bits.fold(0, |set, n| set | 1 << n)
}

/// Indices of the set bits of a number, in ascending order.
#[inline(always)]
pub(super) fn bits(mut set: u8) -> impl Iterator<Item = usize> + Clone {
    core::iter::from_fn(move || {
        let place = set.trailing_zeros() as usize;
        set &= set.wrapping_sub(1);
        (place < MAX_CONSTRAINTS).then_some(place)
    })
}
