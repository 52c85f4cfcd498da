//! Which sines and cosines are called, and which follow from others by the addition theorems.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use num_traits::{One, Signed, ToPrimitive};

use crate::expr::{ExprId, Graph, Level, Node, Normalizer, Rational, SymbolKind, Unary};

/// An angle as a combination of coordinates: pairs of symbol and factor.
type Angle = BTreeMap<ExprId, i64>;

/// Replaces sines and cosines of sums of coordinates by products of others that are there anyway. A call costs as much as
/// dozens of multiplications, the addition theorem three operations.
pub(crate) fn lower(g: &Graph, roots: &[ExprId]) -> Vec<ExprId> {
    let mut needed: BTreeSet<ExprId> = BTreeSet::new();
    for id in g.reachable(roots) {
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = *g.node(id) {
            needed.insert(angle);
        }
    }
    let mut angles: Vec<(Angle, ExprId)> = needed
        .into_iter()
        .filter_map(|id| Some((combination(g, id)?, id)))
        .collect();
    angles.sort_by_key(|(angle, id)| (angle.values().map(|n| n.abs()).sum::<i64>(), *id));
    // sine and cosine of each angle that is available, as expressions
    let mut available: Vec<(Angle, ExprId, ExprId)> = Vec::new();
    let mut replaced = HashMap::new();
    for (angle, id) in angles {
        let (sine, cosine) = (g.unary(Unary::Sin, id), g.unary(Unary::Cos, id));
        let (new_sine, new_cosine) = derived(g, &angle, &available).unwrap_or((sine, cosine));
        replaced.insert(sine, new_sine);
        replaced.insert(cosine, new_cosine);
        available.push((angle, new_sine, new_cosine));
    }
    g.substitute(roots, replaced)
}

/// Sine and cosine of `angle` as a sum or difference of two available angles.
fn derived(g: &Graph, angle: &Angle, available: &[(Angle, ExprId, ExprId)]) -> Option<(ExprId, ExprId)> {
    for (n, (a, sin_a, cos_a)) in available.iter().enumerate() {
        for (b, sin_b, cos_b) in &available[n..] {
            for (first, second) in [(1, 1), (1, -1), (-1, 1)] {
                if scaled_sum(a, first, b, second) != *angle {
                    continue;
                }
                // sin(+-a +- b), cos(+-a +- b)
                let (sc, cs) = (g.mul(*sin_a, *cos_b), g.mul(*cos_a, *sin_b));
                let (cc, ss) = (g.mul(*cos_a, *cos_b), g.mul(*sin_a, *sin_b));
                let sine = match (first, second) {
                    (1, 1) => g.add(sc, cs),
                    (1, _) => g.sub(sc, cs),
                    _ => g.sub(cs, sc),
                };
                let cosine = if first == second { g.sub(cc, ss) } else { g.add(cc, ss) };
                return Some((sine, cosine));
            }
        }
    }
    None
}

fn scaled_sum(a: &Angle, first: i64, b: &Angle, second: i64) -> Angle {
    let mut sum: Angle = a.iter().map(|(&k, n)| (k, n * first)).collect();
    for (&k, n) in b {
        *sum.entry(k).or_default() += n * second;
    }
    sum.retain(|_, n| *n != 0);
    sum
}

/// The angle as a combination of coordinates, if it is one with integer factors.
fn combination(g: &Graph, id: ExprId) -> Option<Angle> {
    const BUDGET: usize = 10_000;
    if g.level(id) != Level::State {
        return None;
    }
    let poly = Normalizer::new(BUDGET).normal(g, id).ok()?;
    let mut angle = Angle::new();
    for (monomial, factor) in poly.terms() {
        let &[(symbol, 1)] = monomial.powers() else { return None };
        let is_coordinate = g
            .as_symbol(symbol)
            .is_some_and(|s| matches!(s.kind, SymbolKind::Coordinate(_)));
        let small: &Rational = factor;
        if !is_coordinate || !small.denom().is_one() || small.abs() > Rational::from_integer(16.into()) {
            return None;
        }
        angle.insert(symbol, small.numer().to_i64()?);
    }
    Some(angle)
}
