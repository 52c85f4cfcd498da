//! Writes sums in terms of the sums that they contain.
//!
//! Recursions over the links of a chain extend a sum from link to link. Where terms cancel, or come in another order,
//! this chain of sums is lost. The pass expands every sum into its terms, then rebuilds it as the longest sum that it
//! contains, plus the rest.

use std::collections::BTreeSet;

use num_traits::{One, Signed};
use rustc_hash::FxHashMap;

use super::flat::{Flat, Linear, add_scaled};
use crate::expr::{Binary, Expr, Graph, Level, Node, Rational};

/// Writes each sum in the roots with the longest sum that it contains. Returns the roots unchanged if their sums are
/// too long.
pub(crate) fn nest<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let Some((flat, flat_roots)) = Flat::new(g, roots) else {
        return roots.to_vec();
    };
    let needed: BTreeSet<Expr<'g>> = g.reachable(&flat_roots).into_iter().map(|id| g.expr(id)).collect();
    let sums = flat.sums.iter().filter(|(id, _)| needed.contains(id));
    let mut sums: Vec<Linear<'g>> = sums.map(|(_, linear)| linear.clone()).collect();
    // longest first, and sums of equal length in the order of their terms, independent of the order of the table
    sums.sort_by(|a, b| b.len().cmp(&a.len()).then_with(|| a.cmp(b)));
    let mut nested = Nested {
        flat,
        sums,
        built: FxHashMap::default(),
    };
    flat_roots.into_iter().map(|root| nested.build(root)).collect()
}

/// Builder of nested expressions from flat ones.
struct Nested<'g> {
    flat: Flat<'g>,
    /// Flat sums, longest first.
    sums: Vec<Linear<'g>>,
    built: FxHashMap<Expr<'g>, Expr<'g>>,
}

impl<'g> Nested<'g> {
    fn build(&mut self, id: Expr<'g>) -> Expr<'g> {
        if let Some(&built) = self.built.get(&id) {
            return built;
        }
        let built = if let Some(linear) = self.flat.sums.get(&id).cloned() {
            self.sum(&linear)
        } else if id.level() < Level::State {
            id
        } else {
            match id.node() {
                Node::Number(_) | Node::Pi | Node::Symbol(_) => id,
                Node::Unary(op, a) => self.build(a).apply(op),
                Node::Binary(op, a, b) => {
                    let a = self.build(a);
                    a.combine(op, self.build(b))
                }
                Node::Power(a, n) => self.build(a).power(n.clone()),
            }
        };
        self.built.insert(id, built);
        built
    }

    fn sum(&mut self, linear: &Linear<'g>) -> Expr<'g> {
        let g = self.flat.g;
        let mut rest = linear.clone();
        let inside = self
            .sums
            .iter()
            .position(|other| other.len() < linear.len())
            .unwrap_or(self.sums.len());
        let mut parts = Vec::new();
        for other in &self.sums[inside..] {
            if let Some(factor) = contained(other, &rest) {
                add_scaled(&mut rest, other, &-factor.clone());
                parts.push((factor, other.clone()));
            }
        }
        let mut terms: Vec<(Rational, Expr<'g>)> = Vec::new();
        for (factor, part) in parts {
            let part = self.flat.whole(&part);
            terms.push((factor, self.build(part)));
        }
        let mut rest: Vec<(Expr<'g>, Rational)> = rest.into_iter().collect();
        rest.sort_by_key(|(atom, _)| (atom.level(), !atom.is_one()));
        for (atom, factor) in rest {
            terms.push((factor, self.build(atom)));
        }
        // keep this order (the sort is stable): a leading minus is easily overlooked, and so is a sum behind its rest
        terms.sort_by_key(|(factor, _)| factor.is_negative());
        let sum = terms
            .into_iter()
            .map(|(factor, id)| (factor.is_negative(), factor.abs() * id));
        let sum = sum.reduce(|(negative, sum), (subtracted, term)| {
            let op = if negative == subtracted {
                Binary::Add
            } else {
                Binary::Sub
            };
            (negative, sum.exactly(op, term))
        });
        match sum {
            Some((true, sum)) => sum.exactly_negated(),
            Some((false, sum)) => sum,
            None => g.zero(),
        }
    }
}

/// Returns the sign with which all terms of `part` occur in `whole`. Terms that do not vary need not match, since a
/// difference in them is easily corrected; if `part` has any of them, `whole` must have one too.
fn contained<'g>(part: &Linear<'g>, whole: &Linear<'g>) -> Option<Rational> {
    let varies = |atom: &Expr<'g>| atom.level() == Level::State;
    let fixed = |linear: &Linear<'g>| linear.keys().any(|atom| !varies(atom));
    let mut varying = part.iter().filter(|(atom, _)| varies(atom)).peekable();
    let (first, factor) = varying.peek()?;
    let ratio = whole.get(first)? / *factor;
    let agrees = |(atom, factor): (&Expr<'g>, &Rational)| whole.get(atom).is_some_and(|own| *own == factor * &ratio);
    let count = varying.clone().count();
    (ratio.abs().is_one() && count > 1 && (!fixed(part) || fixed(whole)) && varying.all(agrees)).then_some(ratio)
}
