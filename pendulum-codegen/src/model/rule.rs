//! Conditions on parameters.

use crate::expr::Expr;

/// A condition on parameters, checked by `new`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Rule<'g> {
    /// Value to check.
    pub value: Expr<'g>,
    /// Condition on the value.
    pub requirement: Requirement<'g>,
    /// Text of the parameter, or of the expression of parameters.
    pub name: String,
    /// Rule as a sentence: ``the mass of `upper` must be positive``.
    pub text: String,
}

/// Condition on a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement<'g> {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero or above, within the rounding error of a difference of numbers of this size.
    NonNegativeWithin(Expr<'g>),
}

/// Rounding error of a difference, relative to the size of its terms.
pub(crate) const ROUNDING: f64 = 1e-12;

impl<'g> Requirement<'g> {
    /// Number whose size the rounding error is relative to.
    pub(crate) fn scale(self) -> Option<Expr<'g>> {
        match self {
            Self::NonNegativeWithin(scale) => Some(scale),
            Self::Positive | Self::NonNegative => None,
        }
    }

    /// True if a value satisfies the condition; `scale` is the size that the rounding error is relative to.
    pub(crate) fn allows(self, value: f64, scale: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::NonNegativeWithin(_) => value >= -ROUNDING * scale,
        }
    }
}
