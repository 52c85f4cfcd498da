//! Lists of values that code reads.

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

/// Lists with their values, those that most code reads first; others are empty.
pub(super) type Lists<'a, T> = [(Source, &'a [T])];

/// Values of a list.
#[inline(always)]
pub(super) fn values<'a, T>(lists: &Lists<'a, T>, source: Source) -> &'a [T] {
    lists.iter().find(|list| list.0 == source).map_or(&[], |list| list.1)
}
