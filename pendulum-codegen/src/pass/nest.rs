//! Sums written with the sums that they contain.
//!
//! Recursions over the links of a chain add a little to a sum from link to link. Where some of that cancels, or comes
//! in another order, the chain of sums no longer shows. Here every sum becomes a list of its terms, and then the
//! longest sum that it contains, and the rest.

use std::collections::BTreeSet;

use num_traits::{One, Signed};
use rustc_hash::FxHashMap;

use super::flat::{Flat, Linear, add_scaled};
use crate::expr::{Binary, Expr, Graph, Level, Node, Rational};

/// The roots, in which each sum is written with the longest sum that it contains; as they are, if their sums are too
/// long.
pub(crate) fn nest<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let Some((flat, flat_roots)) = Flat::new(g, roots) else {
        return roots.to_vec();
    };
    let needed: BTreeSet<Expr<'g>> = g.reachable(&flat_roots).into_iter().map(|id| g.expr(id)).collect();
    let sums = flat.sums.iter().filter(|(id, _)| needed.contains(id));
    let mut sums: Vec<Linear<'g>> = sums.map(|(_, linear)| linear.clone()).collect();
    // the longest first, and those of one length in the order of their terms, whatever the order of the table
    sums.sort_by(|a, b| b.len().cmp(&a.len()).then_with(|| a.cmp(b)));
    let mut nested = Nested {
        flat,
        sums,
        built: FxHashMap::default(),
    };
    flat_roots.into_iter().map(|root| nested.build(root)).collect()
}

/// Flat expressions on their way to nested ones.
struct Nested<'g> {
    flat: Flat<'g>,
    /// The sums, the longest first.
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
        // a leading term that is subtracted is easily overlooked, and so is a sum after its rest: this order is kept
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

/// The sign with which all terms of one sum stand in another. Of terms that do not vary, it is enough that both have
/// some: they are easily mended.
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
