//! Which sines and cosines are called, and which follow from others by the addition theorems.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{One, Signed, ToPrimitive};
use rustc_hash::FxHashMap;

use crate::expr::{Expr, Graph, Level, Node, Normalizer, Rational, SymbolKind, Unary};

/// An angle as a combination of coordinates, and of what else it depends on: pairs of expression and factor.
type Angle<'g> = BTreeMap<Expr<'g>, i64>;

/// Replaces sines and cosines of sums of coordinates by products of others that are there anyway. A call costs as much as
/// dozens of multiplications, the addition theorem three operations.
pub(crate) fn lower<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let mut needed: BTreeSet<Expr<'g>> = BTreeSet::new();
    for id in g.reachable(roots) {
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = *g.node(id) {
            needed.insert(g.expr(angle));
        }
    }
    let mut angles: Vec<(Angle<'g>, Expr<'g>)> =
        needed.into_iter().filter_map(|x| Some((combination(x)?, x))).collect();
    angles.sort_by_key(|(angle, x)| (angle.values().map(|n| n.abs()).sum::<i64>(), *x));
    let mut available: Vec<Available<'g>> = Vec::new();
    let mut replaced = FxHashMap::default();
    for (angle, x) in angles {
        let [sin, cos] = [x.sin(), x.cos()];
        let known = derived(&angle, &available).unwrap_or(Available { angle, sin, cos });
        replaced.insert(sin, known.sin);
        replaced.insert(cos, known.cos);
        available.push(known);
    }
    g.substitute(roots, replaced)
}

/// An angle with expressions of its sine and cosine.
struct Available<'g> {
    angle: Angle<'g>,
    sin: Expr<'g>,
    cos: Expr<'g>,
}

/// Sine and cosine of `angle` as a sum or difference of two available angles.
fn derived<'g>(angle: &Angle<'g>, available: &[Available<'g>]) -> Option<Available<'g>> {
    for (n, a) in available.iter().enumerate() {
        for b in &available[n..] {
            for (first, second) in [(1, 1), (1, -1), (-1, 1)] {
                let angle_of_both = scaled_sum(&a.angle, first, &b.angle, second);
                if angle_of_both != *angle {
                    continue;
                }
                // sin(+-a +- b), cos(+-a +- b)
                let (sc, cs) = (a.sin * b.cos, a.cos * b.sin);
                let (cc, ss) = (a.cos * b.cos, a.sin * b.sin);
                let sin = match (first, second) {
                    (1, 1) => sc + cs,
                    (1, _) => sc - cs,
                    _ => cs - sc,
                };
                let cos = if first == second { cc - ss } else { cc + ss };
                let angle = angle_of_both;
                return Some(Available { angle, sin, cos });
            }
        }
    }
    None
}

fn scaled_sum<'g>(a: &Angle<'g>, first: i64, b: &Angle<'g>, second: i64) -> Angle<'g> {
    let mut sum: Angle<'g> = a.iter().map(|(&k, n)| (k, n * first)).collect();
    for (&k, n) in b {
        *sum.entry(k).or_default() += n * second;
    }
    sum.retain(|_, n| *n != 0);
    sum
}

/// The angle as a combination, if it is one with integer factors. What is not a coordinate, such as the angle of a drive, is one part of it.
fn combination(x: Expr<'_>) -> Option<Angle<'_>> {
    const BUDGET: usize = 10_000;
    if x.level() != Level::State {
        return None;
    }
    let mut normalizer = Normalizer::new(x.graph(), BUDGET);
    let poly = normalizer.normal(x).ok()?;
    let mut angle = Angle::new();
    let mut rest = (*poly).clone();
    for (monomial, factor) in poly.terms() {
        let &[(symbol, 1)] = monomial.powers() else { continue };
        let symbol = x.graph().expr(symbol);
        let is_coordinate = symbol
            .as_symbol()
            .is_some_and(|s| matches!(s.kind, SymbolKind::Coordinate(_)));
        if !is_coordinate {
            continue;
        }
        let small: &Rational = factor;
        if !small.denom().is_one() || small.abs() > Rational::from_integer(16.into()) {
            return None;
        }
        angle.insert(symbol, small.numer().to_i64()?);
        rest.remove(monomial);
    }
    if let Some((_, leading)) = rest.terms().next() {
        let sign = leading.signum();
        angle.insert(normalizer.to_expr(&rest.scaled(&sign)), sign.to_integer().to_i64()?);
    }
    Some(angle)
}
