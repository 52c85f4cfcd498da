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
    /// Of state, time, inputs and forces, which most code reads: to write down all would take as long as some
    /// operations.
    first: [&'a [T]; 4],
    others: &'a [(Source, &'a [T])],
    /// Laws of inputs, which replace those of the list.
    laws: Option<&'a Laws>,
}

impl<'a, T> Lists<'a, T> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            first: [&[]; 4],
            others: &[],
            laws: None,
        }
    }

    /// Adds one of the first lists.
    #[inline(always)]
    pub(super) fn with(mut self, source: Source, values: &'a [T]) -> Self {
        self.first[source as usize] = values;
        self
    }

    /// Adds others, and no more.
    #[inline(always)]
    pub(super) fn and(mut self, others: &'a [(Source, &'a [T])]) -> Self {
        self.others = others;
        self
    }

    #[inline(always)]
    pub(super) fn following(mut self, laws: Option<&'a Laws>) -> Self {
        self.laws = laws;
        self
    }

    #[inline(always)]
    pub(super) fn of(&self, source: Source) -> &'a [T] {
        let other = || self.others.iter().find(|other| other.0 == source);
        let first = self.first.get(source as usize).copied();
        first.or_else(|| other().map(|other| other.1)).unwrap_or(&[])
    }

    /// Laws of inputs, with the time.
    #[inline(always)]
    pub(super) fn laws(&self) -> Option<(&'a Laws, &'a T)> {
        self.laws.zip(self.of(Source::Time).first())
    }
}
