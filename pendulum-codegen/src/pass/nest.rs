//! Sums written with the sums that they contain.
//!
//! Recursions over the links of a chain add a little to a sum from link to link. Where some of that cancels, or comes in another order,
//! the chain of sums no longer shows. Here every sum becomes a list of its terms, and then the longest sum that it contains, and the rest.

use std::collections::{BTreeSet, HashMap};

use num_traits::{One, Signed};

use super::flat::{Flat, Linear, add_scaled};
use crate::expr::{Binary, ExprId, Graph, Level, Node, Rational};

/// The roots, in which each sum is written with the longest sum that it contains; as they are, if their sums are too long.
pub fn nest(g: &Graph, roots: &[ExprId]) -> Vec<ExprId> {
    let Some((flat, flat_roots)) = Flat::new(g, roots) else {
        return roots.to_vec();
    };
    let needed: BTreeSet<ExprId> = g.reachable(&flat_roots).into_iter().collect();
    let sums = flat.sums.iter().filter(|(id, _)| needed.contains(id));
    let mut sums: Vec<Linear> = sums.map(|(_, linear)| linear.clone()).collect();
    // the longest first, and those of one length in the order of their terms, whatever the order of the table
    sums.sort_by(|a, b| b.len().cmp(&a.len()).then_with(|| a.cmp(b)));
    let mut nested = Nested {
        flat,
        sums,
        built: HashMap::new(),
    };
    flat_roots.into_iter().map(|root| nested.build(root)).collect()
}

/// Flat expressions on their way to nested ones.
struct Nested<'g> {
    flat: Flat<'g>,
    /// The sums, the longest first.
    sums: Vec<Linear>,
    built: HashMap<ExprId, ExprId>,
}

impl Nested<'_> {
    fn build(&mut self, id: ExprId) -> ExprId {
        if let Some(&built) = self.built.get(&id) {
            return built;
        }
        let g = self.flat.g;
        let built = if let Some(linear) = self.flat.sums.get(&id).cloned() {
            self.sum(&linear)
        } else if g.level(id) < Level::State {
            id
        } else {
            match g.node(id).clone() {
                Node::Number(_) | Node::Pi | Node::Symbol(_) => id,
                Node::Unary(op, a) => g.unary(op, self.build(a)),
                Node::Binary(op, a, b) => g.binary(op, self.build(a), self.build(b)),
                Node::Power(a, n) => g.power(self.build(a), n),
            }
        };
        self.built.insert(id, built);
        built
    }

    fn sum(&mut self, linear: &Linear) -> ExprId {
        let g = self.flat.g;
        let mut rest = linear.clone();
        let inside = self
            .sums
            .iter()
            .position(|other| other.len() < linear.len())
            .unwrap_or(self.sums.len());
        let mut parts = Vec::new();
        for other in &self.sums[inside..] {
            if let Some(factor) = contained(g, other, &rest) {
                add_scaled(&mut rest, other, &-factor.clone());
                parts.push((factor, other.clone()));
            }
        }
        let mut terms: Vec<(Rational, ExprId)> = Vec::new();
        for (factor, part) in parts {
            let part = self.flat.whole(&part);
            terms.push((factor, self.build(part)));
        }
        let mut rest: Vec<(ExprId, Rational)> = rest.into_iter().collect();
        rest.sort_by_key(|(atom, _)| (g.level(*atom), *atom != g.one()));
        for (atom, factor) in rest {
            terms.push((factor, self.build(atom)));
        }
        // a leading term that is subtracted is easily overlooked, and so is a sum after its rest: this order is kept
        terms.sort_by_key(|(factor, _)| factor.is_negative());
        let sum = terms.into_iter().map(|(factor, id)| {
            let size = g.number(factor.abs());
            (factor.is_negative(), g.mul(size, id))
        });
        let sum = sum.reduce(|(negative, sum), (subtracted, term)| {
            let op = if negative == subtracted {
                Binary::Add
            } else {
                Binary::Sub
            };
            (negative, g.exactly(op, sum, term))
        });
        match sum {
            Some((true, sum)) => g.exactly_negated(sum),
            Some((false, sum)) => sum,
            None => g.zero(),
        }
    }
}

/// The sign with which all terms of one sum stand in another. Of terms that do not vary, it is enough that both have some: they are
/// easily mended.
fn contained(g: &Graph, part: &Linear, whole: &Linear) -> Option<Rational> {
    let varies = |atom: &ExprId| g.level(*atom) == Level::State;
    let fixed = |linear: &Linear| linear.keys().any(|atom| !varies(atom));
    let mut varying = part.iter().filter(|(atom, _)| varies(atom)).peekable();
    let (first, factor) = varying.peek()?;
    let ratio = whole.get(first)? / *factor;
    let agrees = |(atom, factor): (&ExprId, &Rational)| whole.get(atom).is_some_and(|own| *own == factor * &ratio);
    let count = varying.clone().count();
    (ratio.abs().is_one() && count > 1 && (!fixed(part) || fixed(whole)) && varying.all(agrees)).then_some(ratio)
}
