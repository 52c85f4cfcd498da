//! Lists of values that code reads.

use super::laws::Laws;

/// List of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Source {
    State,
    Time,
    Input,
    Force,
    Acceleration,
    Weight,
    Direction,
    Order,
    OverOrder,
    TimeCoefficient,
    StateCoefficient,
    Sum,
    Kept,
    ForceCoefficient,
    Carried,
    Parameter,
    Constant,
}

impl Source {
    /// All lists with their names in a tape, in order.
    pub(super) const ALL: [(&'static str, Self); 17] = [
        ("state", Self::State),
        ("time", Self::Time),
        ("input", Self::Input),
        ("force", Self::Force),
        ("acceleration", Self::Acceleration),
        ("weight", Self::Weight),
        ("direction", Self::Direction),
        ("order", Self::Order),
        ("over_order", Self::OverOrder),
        ("time_coefficient", Self::TimeCoefficient),
        ("state_coefficient", Self::StateCoefficient),
        ("sum", Self::Sum),
        ("kept", Self::Kept),
        ("force_coefficient", Self::ForceCoefficient),
        ("carried", Self::Carried),
        ("parameter", Self::Parameter),
        ("constant", Self::Constant),
    ];
}

/// Values of all lists; those not given are empty.
#[derive(Clone, Copy)]
pub(super) struct Lists<'a, T> {
    values: [&'a [T]; Source::ALL.len()],
    /// Laws of inputs, which replace those of the list.
    laws: Option<&'a Laws>,
}

impl<'a, T> Lists<'a, T> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            values: [&[]; Source::ALL.len()],
            laws: None,
        }
    }

    #[inline(always)]
    pub(super) fn with(mut self, source: Source, values: &'a [T]) -> Self {
        self.values[source as usize] = values;
        self
    }

    #[inline(always)]
    pub(super) fn following(mut self, laws: Option<&'a Laws>) -> Self {
        self.laws = laws;
        self
    }

    #[inline(always)]
    pub(super) fn of(&self, source: Source) -> &'a [T] {
        self.values[source as usize]
    }

    /// Laws of inputs, with the time.
    #[inline(always)]
    pub(super) fn laws(&self) -> Option<(&'a Laws, &'a T)> {
        self.laws.zip(self.of(Source::Time).first())
    }
}
