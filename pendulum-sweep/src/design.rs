//! Designs: the points of a sweep.

use std::ops::Range;

use pendulum_core::real::Real;
use serde_json::{Value, json};

use crate::error::SweepError;
use crate::table::Column;

/// Points of `K` numbers each; see the [crate](crate).
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep<const K: usize> {
    pub(crate) name: String,
    design: Design<K>,
}

#[derive(Clone, Debug, PartialEq)]
enum Design<const K: usize> {
    Grid([Axis; K]),
    List([Column; K], Vec<[f64; K]>),
    Random([Draw; K], usize, u64),
}

impl<const K: usize> Sweep<K> {
    /// All combinations of the values of the axes. The last axis varies fastest.
    #[must_use]
    pub fn grid(name: &str, axes: [Axis; K]) -> Self {
        Self::new(name, Design::Grid(axes))
    }

    /// Explicit points, with the names and units of their numbers.
    #[must_use]
    pub fn list(name: &str, columns: [(&str, &str); K], points: Vec<[f64; K]>) -> Self {
        let columns = columns.map(|(name, unit)| Column::new(name, unit));
        Self::new(name, Design::List(columns, points))
    }

    /// Random points. Each number depends only on the seed, its row and its column (the counter-based `SplitMix64`: G.
    /// L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014), so a longer
    /// sweep begins with the points of a shorter one.
    #[must_use]
    pub fn random(name: &str, draws: [Draw; K], points: usize, seed: u64) -> Self {
        Self::new(name, Design::Random(draws, points, seed))
    }

    fn new(name: &str, design: Design<K>) -> Self {
        let name = name.to_owned();
        Self { name, design }
    }

    /// Number of points; `usize::MAX` on overflow.
    #[must_use]
    pub fn points(&self) -> usize {
        match &self.design {
            Design::Grid(axes) => axes
                .iter()
                .fold(1, |points: usize, axis| points.saturating_mul(axis.spacing.count())),
            Design::List(_, points) => points.len(),
            Design::Random(_, points, _) => *points,
        }
    }

    /// Returns the point of a row.
    ///
    /// # Panics
    /// If `row` is not below [`points`](Self::points).
    #[must_use]
    pub fn point(&self, row: usize) -> [f64; K] {
        assert!(row < self.points(), "row {row} of a sweep of {} points", self.points());
        self.points_of(row..row + 1)[0]
    }

    /// Returns the points of a range of rows.
    pub(crate) fn points_of(&self, rows: Range<usize>) -> Vec<[f64; K]> {
        let mut points = vec![[0.0; K]; rows.len()];
        match &self.design {
            Design::Grid(axes) => {
                for (point, mut left) in points.iter_mut().zip(rows) {
                    for (number, axis) in point.iter_mut().zip(axes).rev() {
                        let count = axis.spacing.count();
                        *number = axis.spacing.at(left % count);
                        left /= count;
                    }
                }
            }
            Design::List(_, list) => points.copy_from_slice(&list[rows]),
            Design::Random(draws, _, seed) => {
                for (column, draw) in draws.iter().enumerate() {
                    for (point, row) in points.iter_mut().zip(rows.clone()) {
                        let counter = (row as u64).wrapping_mul(K as u64).wrapping_add(column as u64);
                        point[column] = draw.at(*seed, counter);
                    }
                }
            }
        }
        points
    }

    /// Rejects axes and draws with numbers that are not finite, such as a logarithmic axis from -1 to 1. Lists may hold
    /// any numbers.
    pub(crate) fn check(&self) -> Result<(), SweepError> {
        let wrong = match &self.design {
            Design::Grid(axes) => {
                let mut wrong = axes.iter().filter(|axis| !axis.spacing.is_finite());
                wrong
                    .next()
                    .map(|axis| (&axis.column, axis.spacing.declaration().to_string()))
            }
            Design::List(..) => None,
            Design::Random(draws, ..) => {
                let mut wrong = draws.iter().filter(|draw| !draw.law.is_finite());
                wrong.next().map(|draw| (&draw.column, format!("{:?}", draw.law)))
            }
        };
        wrong.map_or(Ok(()), |(column, law)| {
            let reason = format!("`{}` has numbers that are not finite: {law}", column.name);
            Err(SweepError::Invalid(reason))
        })
    }

    /// Names and units of the numbers of a point.
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        match &self.design {
            Design::Grid(axes) => axes.iter().map(|axis| axis.column.clone()).collect(),
            Design::List(columns, _) => columns.to_vec(),
            Design::Random(draws, ..) => draws.iter().map(|draw| draw.column.clone()).collect(),
        }
    }

    /// Full description of the design, from which each point can be recomputed.
    pub(crate) fn declaration(&self) -> Value {
        match &self.design {
            Design::Grid(axes) => {
                let axis = |axis: &Axis| {
                    json!({
                        "name": axis.column.name, "unit": axis.column.unit, "values": axis.spacing.declaration(),
                    })
                };
                json!({ "grid": axes.iter().map(axis).collect::<Vec<_>>() })
            }
            Design::List(columns, points) => {
                let bits = points.iter().flatten().map(|number| number.to_bits());
                // the points themselves are in the table
                json!({
                    "list": columns
                        .iter()
                        .map(|column| json!({ "name": column.name, "unit": column.unit }))
                        .collect::<Vec<_>>(),
                    "points": points.len(),
                    "digest": bits.fold(0, |digest, bits| mixed(digest ^ bits)),
                })
            }
            Design::Random(draws, points, seed) => {
                let draw = |draw: &Draw| {
                    json!({
                        "name": draw.column.name, "unit": draw.column.unit, "law": format!("{:?}", draw.law),
                    })
                };
                json!({ "random": draws.iter().map(draw).collect::<Vec<_>>(), "points": points, "seed": seed })
            }
        }
    }
}

/// Axis of a grid: a number and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    column: Column,
    spacing: Spacing,
}

#[derive(Clone, Debug, PartialEq)]
enum Spacing {
    Linear([f64; 2], usize),
    Logarithmic([f64; 2], usize),
    Cells([f64; 2], usize),
    Values(Vec<f64>),
}

impl Axis {
    /// `count` evenly spaced values from `from` to `to`, both included; only `from` if `count` is 1.
    #[must_use]
    pub fn linear(name: &str, unit: &str, from: f64, to: f64, count: usize) -> Self {
        Self::new(name, unit, Spacing::Linear([from, to], count))
    }

    /// `count` values in a constant ratio from `from` to `to`, both included; only `from` if `count` is 1. Both ends
    /// must be nonzero and have the same sign.
    #[must_use]
    pub fn logarithmic(name: &str, unit: &str, from: f64, to: f64, count: usize) -> Self {
        Self::new(name, unit, Spacing::Logarithmic([from, to], count))
    }

    /// Centres of `count` cells of equal size between `from` and `to`, as for a map.
    #[must_use]
    pub fn cells(name: &str, unit: &str, from: f64, to: f64, count: usize) -> Self {
        Self::new(name, unit, Spacing::Cells([from, to], count))
    }

    /// Explicit values.
    #[must_use]
    pub fn values(name: &str, unit: &str, values: impl Into<Vec<f64>>) -> Self {
        Self::new(name, unit, Spacing::Values(values.into()))
    }

    fn new(name: &str, unit: &str, spacing: Spacing) -> Self {
        let column = Column::new(name, unit);
        Self { column, spacing }
    }
}

impl Spacing {
    fn count(&self) -> usize {
        match self {
            Self::Linear(_, count) | Self::Logarithmic(_, count) | Self::Cells(_, count) => *count,
            Self::Values(values) => values.len(),
        }
    }

    /// Returns value number `n`, which is below [`count`](Self::count).
    fn at(&self, n: usize) -> f64 {
        match *self {
            Self::Linear([from, _], _) | Self::Logarithmic([from, _], _) if n == 0 => from,
            Self::Linear([_, to], count) | Self::Logarithmic([_, to], count) if n + 1 == count => to,
            Self::Linear([from, to], count) => from + (to - from) * (n as f64 / (count - 1) as f64),
            Self::Logarithmic([from, to], count) => {
                from * Real::exp(Real::ln(to / from) * (n as f64 / (count - 1) as f64))
            }
            Self::Cells([from, to], count) => from + (to - from) * ((2 * n + 1) as f64 / (2 * count) as f64),
            Self::Values(ref values) => values[n],
        }
    }

    fn is_finite(&self) -> bool {
        match self {
            Self::Linear(ends, _) | Self::Cells(ends, _) => is_finite_between(*ends),
            Self::Logarithmic(ends, _) => have_a_ratio(*ends),
            Self::Values(values) => values.iter().all(|value| value.is_finite()),
        }
    }

    fn declaration(&self) -> Value {
        match self {
            Self::Linear(ends, count) => json!({ "linear": ends, "count": count }),
            Self::Logarithmic(ends, count) => json!({ "logarithmic": ends, "count": count }),
            Self::Cells(ends, count) => json!({ "cells": ends, "count": count }),
            Self::Values(values) => json!({ "values": values }),
        }
    }
}

/// Checks that both numbers and their difference are finite.
fn is_finite_between([from, to]: [f64; 2]) -> bool {
    from.is_finite() && to.is_finite() && (to - from).is_finite()
}

/// Checks that a logarithmic axis can connect two numbers.
fn have_a_ratio([from, to]: [f64; 2]) -> bool {
    let ratio = to / from;
    from.is_finite() && to.is_finite() && ratio > 0.0 && ratio.is_finite()
}

/// Random number, independent of the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    column: Column,
    law: Law,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Law {
    Uniform { from: f64, to: f64 },
    Logarithmic { from: f64, to: f64 },
    Normal { mean: f64, deviation: f64 },
}

impl Draw {
    /// Uniform distribution from `from` up to `to`.
    #[must_use]
    pub fn uniform(name: &str, unit: &str, from: f64, to: f64) -> Self {
        Self::new(name, unit, Law::Uniform { from, to })
    }

    /// Log-uniform distribution between `from` and `to`, which must be nonzero and have the same sign.
    #[must_use]
    pub fn logarithmic(name: &str, unit: &str, from: f64, to: f64) -> Self {
        Self::new(name, unit, Law::Logarithmic { from, to })
    }

    /// Normal distribution with a mean and a standard deviation, which must not be negative.
    #[must_use]
    pub fn normal(name: &str, unit: &str, mean: f64, deviation: f64) -> Self {
        Self::new(name, unit, Law::Normal { mean, deviation })
    }

    fn new(name: &str, unit: &str, law: Law) -> Self {
        let column = Column::new(name, unit);
        Self { column, law }
    }

    /// Returns the number at a counter. The core's own logarithms and sines give the same bits on every machine.
    #[inline(always)]
    fn at(&self, seed: u64, counter: u64) -> f64 {
        let share = |half: u64| {
            let bits = mixed(seed.wrapping_add(GOLDEN.wrapping_mul(2 * counter + half + 1)));
            // an odd multiple of 2^-54, so neither 0 nor 1
            (2.0 * (bits >> 11) as f64 + 1.0) * 2.0_f64.powi(-54)
        };
        match self.law {
            Law::Uniform { from, to } => from + (to - from) * share(0),
            Law::Logarithmic { from, to } => from * Real::exp(Real::ln(to / from) * share(0)),
            Law::Normal { mean, deviation } => {
                // G. E. P. Box, M. E. Muller, Ann. Math. Statist. 29 (1958) 610-611
                let (radius, angle) = ((-2.0 * Real::ln(share(0))).sqrt(), std::f64::consts::TAU * share(1));
                mean + deviation * radius * Real::sin_cos(angle).1
            }
        }
    }
}

impl Law {
    /// Checks that all numbers this can yield are finite.
    fn is_finite(self) -> bool {
        match self {
            Self::Uniform { from, to } => is_finite_between([from, to]),
            Self::Logarithmic { from, to } => have_a_ratio([from, to]),
            // no number is farther from the mean than nine standard deviations
            Self::Normal { mean, deviation } => deviation >= 0.0 && (mean.abs() + 9.0 * deviation).is_finite(),
        }
    }
}

/// 2^64 divided by the golden ratio, odd.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The output function of `SplitMix64`.
fn mixed(state: u64) -> u64 {
    let state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    state ^ (state >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_axis_runs_fastest_and_ends_are_exact() {
        let sweep = Sweep::grid(
            "s",
            [Axis::values("a", "1", [1.0, 2.0]), Axis::linear("b", "m", 0.1, 0.7, 3)],
        );
        assert_eq!(sweep.points(), 6);
        assert_eq!(
            [0, 1, 2, 3].map(|row| sweep.point(row)),
            [[1.0, 0.1], [1.0, 0.4], [1.0, 0.7], [2.0, 0.1]]
        );
        let decades = Sweep::grid("s", [Axis::logarithmic("c", "1", 1e-3, 1.0, 4)]);
        assert_eq!((decades.point(0), decades.point(3)), ([1e-3], [1.0]));
        assert!((decades.point(1)[0] - 1e-2).abs() < 1e-16);
        let map = Sweep::grid("s", [Axis::cells("d", "1", 0.0, 1.0, 2)]);
        assert_eq!([0, 1].map(|row| map.point(row)), [[0.25], [0.75]]);
    }

    /// Compares with the first three outputs of the authors' C code for the seed 1234567.
    #[test]
    fn the_generator_is_splitmix64() {
        let seed = 1_234_567_u64;
        let outputs = [1, 2, 3].map(|n| mixed(seed.wrapping_add(GOLDEN.wrapping_mul(n))));
        assert_eq!(
            outputs,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }

    #[test]
    fn draws_have_their_means_and_deviations() {
        let draws = [
            Draw::uniform("a", "1", 2.0, 4.0),
            Draw::normal("b", "1", -1.0, 0.5),
            Draw::logarithmic("c", "1", 1e-2, 1e2),
        ];
        let sweep = Sweep::random("s", draws, 20_000, 7);
        let column = |n: usize, f: fn(f64) -> f64| {
            let numbers: Vec<f64> = (0..sweep.points()).map(|row| f(sweep.point(row)[n])).collect();
            let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
            let square = numbers.iter().map(|number| (number - mean).powi(2)).sum::<f64>() / numbers.len() as f64;
            (mean, square.sqrt())
        };
        // tolerance: at least four standard errors of each
        let near = |(mean, deviation): (f64, f64), (m, d): (f64, f64)| {
            assert!(
                (mean - m).abs() < 0.03 * d && (deviation - d).abs() < 0.03 * d,
                "{mean} {deviation}"
            );
        };
        near(column(0, |x| x), (3.0, 1.0 / 3.0_f64.sqrt()));
        near(column(1, |x| x), (-1.0, 0.5));
        near(column(2, f64::log10), (0.0, 2.0 / 3.0_f64.sqrt()));
        assert_eq!(
            Sweep::random("s", [Draw::uniform("a", "1", 2.0, 4.0)], 10, 7).points(),
            10
        );
    }
}
