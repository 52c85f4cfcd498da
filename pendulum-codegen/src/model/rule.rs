//! Conditions on parameters.

use crate::expr::Expr;

/// A condition on parameters that `new` checks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Rule<'g> {
    /// What is checked.
    pub value: Expr<'g>,
    /// What it must be.
    pub requirement: Requirement<'g>,
    /// The parameter, or the expression of parameters, as text.
    pub name: String,
    /// The rule as a sentence: `the mass of `upper` must be positive`.
    pub text: String,
}

/// What a checked value must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement<'g> {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero or above, up to rounding of a difference of numbers of this size.
    NonNegativeWithin(Expr<'g>),
}

/// How much of a difference is rounding.
pub(crate) const ROUNDING: f64 = 1e-12;

impl<'g> Requirement<'g> {
    /// The number by whose size the rounding is measured.
    pub(crate) fn scale(self) -> Option<Expr<'g>> {
        match self {
            Self::NonNegativeWithin(scale) => Some(scale),
            Self::Positive | Self::NonNegative => None,
        }
    }

    /// Whether a value obeys, where `scale` is the size that the rounding is measured by.
    pub(crate) fn allows(self, value: f64, scale: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::NonNegativeWithin(_) => value >= -ROUNDING * scale,
        }
    }
}
