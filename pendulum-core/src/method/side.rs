//! Side of zero on which a function lies, along its samples.

use crate::event::Direction;
use crate::real::Float;

/// Side of zero on which an event function was sampled last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Side<T> {
    /// At zero at the start of the integration: an event, if the function leaves zero in its direction.
    AtStart,
    /// At zero, after an event: the side is determined by the next sample more than `noise` away.
    Leaving {
        noise: T,
        /// Side that the next sample must not lie on, since it was there twice within no time.
        far: Option<Passage>,
    },
    Below,
    Above,
}

/// Direction in which a function passes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Passage {
    Rising,
    Falling,
    /// The function starts at zero and stays there.
    Resting,
}

/// Change between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Change {
    /// No event: the function is at zero, or left it after an event.
    None,
    /// The function stays on its side, but may have touched zero in between.
    SameSide,
    /// The function left zero, at the start of the integration.
    Left(Passage),
    /// The function passed zero, or reached it.
    Passed(Passage),
    /// The function lies on the far side after two events within no time, and will pass zero again and again.
    Accumulated,
}

impl<T: Float> Side<T> {
    /// Side of a value; zero is [`Leaving`](Self::Leaving) without noise.
    pub(super) fn of(value: T) -> Self {
        if value > T::default() {
            Self::Above
        } else if value < T::default() {
            Self::Below
        } else {
            Self::at_zero()
        }
    }

    /// At zero, without noise.
    pub(super) fn at_zero() -> Self {
        Self::Leaving {
            noise: T::default(),
            far: None,
        }
    }

    /// Returns the side after a finite sample, and the change since the last one.
    pub(super) fn advance(self, value: T) -> (Self, Change) {
        let side = Self::of(value);
        let change = match self {
            Self::AtStart if value == T::default() => return (self, Change::None),
            // counts as if it came from the other side
            Self::AtStart => Change::Left(side.reached()),
            Self::Leaving { noise, .. } if value.abs() <= noise => return (self, Change::None),
            Self::Leaving { far, .. } if far == Some(side.reached()) => Change::Accumulated,
            Self::Leaving { .. } => Change::None,
            Self::Below | Self::Above if side == self => Change::SameSide,
            Self::Below | Self::Above => Change::Passed(self.left()),
        };
        (side, change)
    }

    /// The passage to this side.
    fn reached(self) -> Passage {
        match self {
            Self::Above => Passage::Rising,
            Self::Below => Passage::Falling,
            Self::AtStart | Self::Leaving { .. } => Passage::Resting,
        }
    }

    /// The passage from this side.
    pub(super) fn left(self) -> Passage {
        match self {
            Self::Above => Passage::Falling,
            Self::Below => Passage::Rising,
            Self::AtStart | Self::Leaving { .. } => Passage::Resting,
        }
    }
}

impl Passage {
    /// True if it is an event in this direction.
    pub(super) fn counts(self, direction: Direction) -> bool {
        match self {
            Self::Resting => direction == Direction::Either,
            _ => direction.includes(self == Self::Rising),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Change, Passage, Side};

    /// Changes along a row of values.
    fn changes(mut side: Side<f64>, values: &[f64]) -> Vec<Change> {
        let step = |&value| {
            let change;
            (side, change) = side.advance(value);
            change
        };
        values.iter().map(step).collect()
    }

    #[test]
    fn zero_is_passed_once_in_a_place_or_between_two() {
        use Change::{None, Passed, SameSide};
        use Passage::{Falling, Rising};
        let between = changes(Side::Above, &[1.0, -1.0, -2.0, 3.0]);
        assert_eq!(between, [SameSide, Passed(Falling), SameSide, Passed(Rising)]);
        let in_a_place = changes(Side::Above, &[1.0, 0.0, -1.0, -2.0]);
        assert_eq!(in_a_place, [SameSide, Passed(Falling), None, SameSide]);
    }

    #[test]
    fn a_start_at_zero_counts_in_the_direction_in_which_it_is_left() {
        let rises = changes(Side::AtStart, &[0.0, -0.0, 1.0, 2.0]);
        assert_eq!(
            rises,
            [
                Change::None,
                Change::None,
                Change::Left(Passage::Rising),
                Change::SameSide
            ]
        );
        let falls = changes(Side::AtStart, &[-1.0]);
        assert_eq!(falls, [Change::Left(Passage::Falling)]);
    }

    #[test]
    fn noise_about_an_event_does_not_count() {
        let leaving = Side::Leaving { noise: 0.1, far: None };
        let noisy = changes(leaving, &[-0.1, 0.05, 0.2, 0.05]);
        assert_eq!(noisy, [Change::None, Change::None, Change::None, Change::SameSide]);
    }

    #[test]
    fn the_far_side_after_hurried_events_is_told() {
        let far = Some(Passage::Rising);
        let leaving = Side::Leaving { noise: 0.1, far };
        assert_eq!(changes(leaving, &[0.05, 0.2]), [Change::None, Change::Accumulated]);
        assert_eq!(changes(leaving, &[0.05, -0.2]), [Change::None, Change::None]);
    }
}
