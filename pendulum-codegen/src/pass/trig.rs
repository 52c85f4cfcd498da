//! Selects the sines and cosines to call, and derives the others by the addition theorems.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, Zero};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::expr::{Expr, Graph, Level, Node, Normalizer, Rational, SymbolKind, Unary, ratio};

/// An angle as a linear combination of coordinates and of other expressions: the factor of each.
type Angle<'g> = BTreeMap<Expr<'g>, Rational>;

/// Maximum number of products of terms formed for the normal forms of all angles.
const BUDGET: usize = 100_000;

/// Replaces sines and cosines of sums of coordinates by products of others that are needed anyway. A call costs as much
/// as dozens of multiplications, the addition theorem three operations.
pub(crate) fn lower<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let mut needed: BTreeSet<Expr<'g>> = BTreeSet::new();
    for id in g.reachable(roots) {
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = *g.node(id) {
            needed.insert(g.expr(angle));
        }
    }
    let mut normalizer = Normalizer::new(g, BUDGET);
    let angles = needed.into_iter();
    let mut angles: Vec<(Angle<'g>, Expr<'g>)> = angles
        .filter_map(|x| Some((combination(&mut normalizer, x)?, x)))
        .collect();
    angles.sort_by_key(|(angle, x)| (angle.values().map(Signed::abs).sum::<Rational>(), *x));
    let mut available = Available::default();
    let mut replaced = FxHashMap::default();
    for (angle, x) in angles {
        let [sin, cos] = [x.sin(), x.cos()];
        let known = available.derived(&angle).unwrap_or([sin, cos]);
        replaced.insert(sin, known[0]);
        replaced.insert(cos, known[1]);
        available.push(angle, known);
    }
    g.substitute(roots, replaced)
}

/// Angles with expressions of their sines and cosines.
#[derive(Default)]
struct Available<'g> {
    angles: Vec<(Angle<'g>, [Expr<'g>; 2])>,
    /// Indices of each angle in `angles`, ascending.
    places: FxHashMap<Angle<'g>, Vec<usize>>,
    /// Expressions that the angles are combinations of.
    parts: FxHashSet<Expr<'g>>,
}

impl<'g> Available<'g> {
    fn push(&mut self, angle: Angle<'g>, sine_and_cosine: [Expr<'g>; 2]) {
        self.places.entry(angle.clone()).or_default().push(self.angles.len());
        self.parts.extend(angle.keys());
        self.angles.push((angle, sine_and_cosine));
    }

    /// Sine and cosine of `angle`, if it is a sum or difference of two available angles.
    fn derived(&self, angle: &Angle<'g>) -> Option<[Expr<'g>; 2]> {
        if !angle.keys().all(|part| self.parts.contains(part)) {
            return None;
        }
        for (n, (first, [sin_a, cos_a])) in self.angles.iter().enumerate() {
            // a + b, a - b, -a + b
            let others = [
                scaled_sum(angle, 1, first, -1),
                scaled_sum(first, 1, angle, -1),
                scaled_sum(angle, 1, first, 1),
            ];
            let place = |other: &Angle<'g>| self.places.get(other)?.iter().copied().find(|&place| place >= n);
            let places = others.iter().enumerate();
            let first = places.filter_map(|(way, other)| Some((place(other)?, way))).min();
            let Some((place, way)) = first else { continue };
            let [sin_b, cos_b] = self.angles[place].1;
            let (sc, cs) = (*sin_a * cos_b, *cos_a * sin_b);
            let (cc, ss) = (*cos_a * cos_b, *sin_a * sin_b);
            return Some(match way {
                0 => [sc + cs, cc - ss],
                1 => [sc - cs, cc + ss],
                _ => [cs - sc, cc + ss],
            });
        }
        None
    }
}

fn scaled_sum<'g>(a: &Angle<'g>, first: i64, b: &Angle<'g>, second: i64) -> Angle<'g> {
    let mut sum: Angle<'g> = a.iter().map(|(&k, n)| (k, n * ratio(first, 1))).collect();
    for (&k, n) in b {
        *sum.entry(k).or_default() += n * ratio(second, 1);
    }
    sum.retain(|_, n| !n.is_zero());
    sum
}

/// Writes an angle as a linear combination of coordinates, if their factors are small. The remainder, such as the angle
/// of a drive, is one part of the combination.
fn combination<'g>(normalizer: &mut Normalizer<'g>, x: Expr<'g>) -> Option<Angle<'g>> {
    if x.level() != Level::State {
        return None;
    }
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
        if factor.abs() > ratio(16, 1) {
            return None;
        }
        angle.insert(symbol, factor.clone());
        rest.remove(monomial);
    }
    if let Some((_, leading)) = rest.terms().next() {
        let sign = leading.signum();
        angle.insert(normalizer.to_expr(&rest.scaled(&sign)), sign);
    }
    Some(angle)
}
