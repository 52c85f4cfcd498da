//! Linear combinations of coordinates.

use std::collections::BTreeMap;

use num_traits::{One, Signed, Zero};

use super::CoordinateId;
use crate::expr::{Expr, Graph, Rational, ratio};

/// A linear combination of coordinates with rational factors.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Combination(
    /// Pairs of coordinate and factor, sorted by coordinate; no factor is zero.
    Vec<(CoordinateId, Rational)>,
);

impl Combination {
    /// The combination of a single coordinate with factor 1.
    pub(crate) fn one(coordinate: CoordinateId) -> Self {
        Self(vec![(coordinate, Rational::one())])
    }

    /// Coordinates and their factors, sorted by coordinate.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (CoordinateId, &Rational)> {
        self.0.iter().map(|(k, factor)| (*k, factor))
    }

    /// Sign of the factor of the first coordinate; 0 for the empty sum.
    pub(crate) fn leading_sign(&self) -> i64 {
        match self.0.first() {
            None => 0,
            Some((_, factor)) if factor.is_negative() => -1,
            Some(_) => 1,
        }
    }

    /// Factor of a coordinate; 0 if it does not occur.
    pub(crate) fn factor(&self, coordinate: CoordinateId) -> Rational {
        self.0
            .binary_search_by_key(&coordinate, |term| term.0)
            .map_or(Rational::zero(), |at| self.0[at].1.clone())
    }

    /// The sum without one coordinate.
    #[must_use]
    pub(crate) fn without(&self, coordinate: CoordinateId) -> Self {
        self.filtered(|k| k != coordinate)
    }

    /// The terms whose coordinates satisfy a predicate.
    #[must_use]
    pub(crate) fn filtered(&self, keeps: impl Fn(CoordinateId) -> bool) -> Self {
        Self(self.0.iter().filter(|(k, _)| keeps(*k)).cloned().collect())
    }

    /// The sum with its coordinates renumbered. The new numbers must be in the same order.
    pub(crate) fn renumbered(&self, number: impl Fn(CoordinateId) -> CoordinateId) -> Self {
        Self(self.terms().map(|(k, factor)| (number(k), factor.clone())).collect())
    }

    /// `factor * self`
    #[must_use]
    pub(crate) fn scaled(&self, factor: i64) -> Self {
        Self::default().plus_scaled(factor, self)
    }

    /// `self + factor * other`
    #[must_use]
    pub(crate) fn plus_scaled(&self, factor: i64, other: &Self) -> Self {
        self.plus_multiple(&ratio(factor, 1), other)
    }

    /// `self + factor * other` for a rational factor
    #[must_use]
    pub(crate) fn plus_multiple(&self, factor: &Rational, other: &Self) -> Self {
        let mut sum: BTreeMap<CoordinateId, Rational> = self.0.iter().cloned().collect();
        for (k, f) in other.terms() {
            *sum.entry(k).or_default() += factor * f;
        }
        Self(sum.into_iter().filter(|(_, f)| !f.is_zero()).collect())
    }

    /// Value of the sum for given values of the coordinates, for example positions or rates.
    pub(crate) fn of<'g>(&self, graph: &'g Graph, value: impl Fn(CoordinateId) -> Expr<'g>) -> Expr<'g> {
        graph.sum(self.terms().map(|(k, factor)| factor * value(k)))
    }
}
