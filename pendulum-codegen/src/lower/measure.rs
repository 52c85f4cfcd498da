//! Measures: dimensions of values, as far as they are known.

use std::fmt::Display;

use crate::expr::Expr;
use crate::units::{Dimension, Power, Unit};

/// A value and its measure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity<'g> {
    pub(super) value: Expr<'g>,
    pub(super) measure: Measure,
}

/// Dimension of a value, as far as its expression determines it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// Bare numbers only, which stand for any quantity in SI units.
    Number,
    /// A dimension, and true if a bare number is among the factors. If the product has no unit otherwise, as in
    /// `0.3*sin(theta)`, this number may stand for any quantity.
    Of(Dimension, bool),
    /// Unknown after an error.
    Unknown,
}

impl Measure {
    /// Measure of plain numbers and angles.
    pub(super) const ONE: Self = Self::Of(Dimension::ONE, false);
    /// Measure of a bare number times a factor without unit.
    const SCALED: Self = Self::Of(Dimension::ONE, true);

    /// Measure of a unit, by its name in the language.
    pub(super) fn of(unit: &str) -> Self {
        Unit::of(unit).map_or(Self::Unknown, |unit| Self::in_dimension(unit.dimension))
    }

    /// Measure of a dimension, without a bare number.
    pub(super) fn in_dimension(dimension: Dimension) -> Self {
        Self::Of(dimension, false)
    }

    /// Measure of `self * other^n`.
    pub(super) fn times(self, other: Self, n: Power) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (Self::Number, Self::Number) => Self::Number,
            (a, b) => {
                let product = a.dimension().times(b.dimension(), n);
                product.map_or(Self::Unknown, |product| {
                    Self::Of(product, a.has_number() || b.has_number())
                })
            }
        }
    }

    /// Measure of the rate.
    pub(super) fn rate(self) -> Self {
        match self {
            open if open.is_open() => Self::SCALED,
            known => known.times(Self::in_dimension(Dimension::TIME), Power::from(-1)),
        }
    }

    /// Measure of a power.
    pub(super) fn power(self, n: Power) -> Self {
        match self {
            Self::Of(..) => Self::ONE.times(self, n),
            other => other,
        }
    }

    /// Common measure of two values that must agree in dimension; none if they do not.
    pub(super) fn alike(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Some(Self::Unknown),
            (Self::Number, known) | (known, Self::Number) => Some(known),
            (Self::Of(a, x), Self::Of(b, y)) if a == b => Some(Self::Of(a, x && y)),
            (scaled, known) | (known, scaled) if scaled == Self::SCALED => Some(known),
            _ => None,
        }
    }

    /// True if the value adopts whatever unit is required.
    pub(super) fn is_open(self) -> bool {
        self == Self::Number || self == Self::SCALED
    }

    /// True if a bare number is among the factors.
    fn has_number(self) -> bool {
        matches!(self, Self::Number | Self::Of(_, true))
    }

    /// Dimension, with bare numbers taken as dimensionless.
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Self::Of(dimension, _) => dimension,
            _ => Dimension::ONE,
        }
    }
}

impl Display for Measure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let dimension = self.dimension();
        if dimension.is_one() {
            f.write_str("has no unit")
        } else {
            write!(f, "is in {dimension}")
        }
    }
}
