//! Writes sums in terms of the sums that they contain.
//!
//! Recursions over the links of a chain extend a sum from link to link. Where terms cancel, or come in another order,
//! this chain of sums is lost. The pass expands every sum into its terms, then rebuilds it as the longest sum that it
//! contains, plus the rest.

use std::collections::BTreeSet;

use num_traits::{One, Signed};
use rustc_hash::FxHashMap;

use super::flat::{Flat, Linear, add_scaled};
use crate::expr::{Binary, Expr, Graph, Level, Node, Rational, multiply};

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
    let mut starting_with: FxHashMap<Expr<'g>, Vec<usize>> = FxHashMap::default();
    for (place, sum) in sums.iter().enumerate() {
        if let Some(first) = varying(sum).next() {
            starting_with.entry(*first.0).or_default().push(place);
        }
    }
    let mut nested = Nested {
        flat,
        sums,
        starting_with,
        built: FxHashMap::default(),
    };
    flat_roots.into_iter().map(|root| nested.build(root)).collect()
}

/// Builder of nested expressions from flat ones.
struct Nested<'g> {
    flat: Flat<'g>,
    /// Flat sums, longest first.
    sums: Vec<Linear<'g>>,
    /// Places of the sums with each first term that varies.
    starting_with: FxHashMap<Expr<'g>, Vec<usize>>,
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
        let places = linear.keys().filter_map(|atom| self.starting_with.get(atom));
        let mut shorter: Vec<usize> = places.flatten().copied().collect();
        shorter.retain(|&place| self.sums[place].len() < linear.len());
        shorter.sort_unstable();
        let mut parts = Vec::new();
        for other in shorter.into_iter().map(|place| &self.sums[place]) {
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
    let fixed = |linear: &Linear<'g>| linear.keys().any(|atom| atom.level() != Level::State);
    let mut varying = varying(part).peekable();
    let (first, factor) = varying.peek()?;
    let own = whole.get(first)?;
    let sign = [Rational::one(), -Rational::one()];
    let sign = sign.into_iter().find(|sign| multiply(factor, sign) == *own)?;
    let agrees = |(atom, factor): (&Expr<'g>, &Rational)| whole.get(atom) == Some(&multiply(factor, &sign));
    let count = varying.clone().count();
    (count > 1 && (!fixed(part) || fixed(whole)) && varying.all(agrees)).then_some(sign)
}

/// Terms that vary with the state.
fn varying<'a, 'g>(linear: &'a Linear<'g>) -> impl Iterator<Item = (&'a Expr<'g>, &'a Rational)> + Clone {
    linear.iter().filter(|(atom, _)| atom.level() == Level::State)
}
