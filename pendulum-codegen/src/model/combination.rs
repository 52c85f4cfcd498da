//! Sums of coordinates.

use super::CoordinateId;
use crate::expr::{Expr, Graph};

/// A sum of coordinates with integer factors.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Combination(
    /// Pairs of coordinate and factor, sorted by coordinate; no factor is zero.
    Vec<(CoordinateId, i64)>,
);

impl Combination {
    /// The coordinate itself.
    pub(crate) fn one(coordinate: CoordinateId) -> Self {
        Self(vec![(coordinate, 1)])
    }

    /// The coordinates and their factors, sorted by coordinate.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (CoordinateId, i64)> {
        self.0.iter().copied()
    }

    /// The factor of the first coordinate; 0 for the empty sum.
    pub(crate) fn leading(&self) -> i64 {
        self.0.first().map_or(0, |(_, factor)| *factor)
    }

    /// The factor of a coordinate; 0 where it does not occur.
    pub(crate) fn factor(&self, coordinate: CoordinateId) -> i64 {
        self.0
            .binary_search_by_key(&coordinate, |term| term.0)
            .map_or(0, |at| self.0[at].1)
    }

    /// The sum without one of its coordinates.
    #[must_use]
    pub(crate) fn without(&self, coordinate: CoordinateId) -> Self {
        self.filtered(|k| k != coordinate)
    }

    /// The sum of some of its coordinates.
    #[must_use]
    pub(crate) fn filtered(&self, keeps: impl Fn(CoordinateId) -> bool) -> Self {
        Self(self.terms().filter(|(k, _)| keeps(*k)).collect())
    }

    /// The same sum where coordinates have other numbers, in the same order.
    pub(crate) fn renumbered(&self, number: impl Fn(CoordinateId) -> CoordinateId) -> Self {
        Self(self.terms().map(|(k, factor)| (number(k), factor)).collect())
    }

    /// `factor * self`
    #[must_use]
    pub(crate) fn scaled(&self, factor: i64) -> Self {
        Self::default().plus_scaled(factor, self)
    }

    /// `self + factor * other`
    #[must_use]
    pub(crate) fn plus_scaled(&self, factor: i64, other: &Self) -> Self {
        let mut sum: std::collections::BTreeMap<CoordinateId, i64> = self.terms().collect();
        for (k, f) in other.terms() {
            *sum.entry(k).or_default() += factor * f;
        }
        Self(sum.into_iter().filter(|(_, f)| *f != 0).collect())
    }

    /// The value of the sum, for example of positions or of rates.
    pub(crate) fn of<'g>(&self, graph: &'g Graph, value: impl Fn(CoordinateId) -> Expr<'g>) -> Expr<'g> {
        graph.sum(self.terms().map(|(k, factor)| factor * value(k)))
    }
}
