//! Reconstruction of expressions from items.

use num_traits::Signed;

use super::parts::{Item, Operand, Parts, Ref};
use crate::expr::{Binary, Expr, Graph, Level, Node, Unary};

/// Expressions of the roots.
pub(super) fn rebuild<'g>(g: &'g Graph, parts: &Parts, roots: &[Operand]) -> Vec<Expr<'g>> {
    let mut rebuilding = Rebuilding {
        graph: g,
        parts,
        places: parts.count_places(roots),
        built: vec![None; parts.items.len()],
    };
    roots
        .iter()
        .map(|&(item, negative)| rebuilding.finish(item, negative))
        .collect()
}

/// State of the reconstruction.
struct Rebuilding<'g, 'p> {
    graph: &'g Graph,
    parts: &'p Parts,
    /// Number of uses of each item.
    places: Vec<usize>,
    /// Expression of each item built so far; the flag is true if the item is its negation.
    built: Vec<Option<(Expr<'g>, bool)>>,
}

impl<'g> Rebuilding<'g, '_> {
    /// Expression of an item, or of its negation, with the sign included.
    fn finish(&mut self, item: Ref, negative: bool) -> Expr<'g> {
        let (x, own) = self.build(item);
        if own == negative {
            return x;
        }
        if x.level() < Level::State {
            return -x;
        }
        match x.node() {
            // a constant factor absorbs the sign at no cost
            Node::Binary(op @ (Binary::Mul | Binary::Div), a, b) if a.level() < Level::State => (-a).exactly(op, b),
            Node::Binary(Binary::Sub, a, b) => b.exactly(Binary::Sub, a),
            _ => x.exactly_negated(),
        }
    }

    /// Expression of an item; the flag is true if the item is its negation.
    fn build(&mut self, item: Ref) -> (Expr<'g>, bool) {
        let (graph, parts) = (self.graph, self.parts);
        if let Some(known) = self.built[item] {
            return known;
        }
        let mut value = |item: &Ref| self.finish(*item, false);
        let result = match &parts.items[item] {
            Item::Leaf(id) => (graph.expr(*id), false),
            Item::Unary(op, a) => (value(a).apply(*op), false),
            Item::Quotient(a, b) => (value(a).exactly(Binary::Div, value(b)), false),
            Item::Function(op, a, b) => (value(a).combine(*op, value(b)), false),
            Item::Power(a, n) => (value(a).power(n.clone()), false),
            Item::Sum(operands) => self.build_sum(operands),
            Item::Product(factors) => self.build_product(factors),
        };
        self.built[item] = Some(result);
        result
    }

    fn build_sum(&mut self, operands: &[Operand]) -> (Expr<'g>, bool) {
        let mut terms = Vec::new();
        for &(item, minus) in operands {
            let (x, own) = self.build(item);
            terms.push((x, minus != own));
        }
        self.join(terms)
    }

    /// Sum of signed terms; the flag is true if the sum is the negation of the expression.
    fn join(&self, terms: Vec<(Expr<'g>, bool)>) -> (Expr<'g>, bool) {
        let (mut constant, mut positive, mut negative) = (self.graph.zero(), Vec::new(), Vec::new());
        for (x, minus) in terms {
            match (x.level() < Level::State, minus) {
                (true, false) => constant += x,
                (true, true) => constant -= x,
                (false, false) => positive.push(x),
                (false, true) => negative.push(x),
            }
        }
        match constant.node() {
            _ if constant.is_zero() => {}
            Node::Unary(Unary::Neg, opposite) if !positive.is_empty() => negative.push(opposite),
            Node::Number(number) if !positive.is_empty() && number.is_negative() => negative.push(-constant),
            // a constant in front avoids a leading minus, whatever its own sign
            _ => positive.insert(0, constant),
        }
        let all_negative = positive.is_empty();
        let (first, then) = if all_negative {
            (negative, Vec::new())
        } else {
            (positive, negative)
        };
        let Some(sum) = first.into_iter().reduce(|a, b| a.exactly(Binary::Add, b)) else {
            return (self.graph.zero(), false);
        };
        (
            then.into_iter().fold(sum, |a, b| a.exactly(Binary::Sub, b)),
            all_negative,
        )
    }

    fn build_product(&mut self, factors: &[Operand]) -> (Expr<'g>, bool) {
        if let Some(sum) = self.distributed(factors) {
            return sum;
        }
        let (mut constant, mut state, mut negative) = (self.graph.one(), Vec::new(), false);
        for &(item, _) in factors {
            let (x, own) = self.build(item);
            negative ^= own;
            if x.level() < Level::State {
                constant = constant * x;
            } else {
                state.push(x);
            }
        }
        if let Node::Unary(Unary::Neg, positive) = constant.node() {
            (constant, negative) = (positive, !negative);
        }
        let first = (!constant.is_one()).then_some(constant);
        let product = first.into_iter().chain(state).reduce(|a, b| a.exactly(Binary::Mul, b));
        (product.unwrap_or(self.graph.one()), negative)
    }

    /// Expands `k (k1 x + k2 y)` to `(k k1) x + (k k2) y`, where this saves the multiplication by `k`.
    fn distributed(&mut self, factors: &[Operand]) -> Option<(Expr<'g>, bool)> {
        let parts = self.parts;
        let (constants, state): (Vec<Operand>, Vec<Operand>) =
            factors.iter().partition(|(item, _)| parts.constant[*item]);
        let &[(sum, _)] = &state[..] else { return None };
        let Item::Sum(terms) = &parts.items[sum] else {
            return None;
        };
        let takes_it = |&(term, _): &Operand| match &parts.items[term] {
            Item::Product(factors) => self.places[term] == 1 && factors.iter().any(|(item, _)| parts.constant[*item]),
            _ => parts.constant[term],
        };
        if constants.is_empty() || self.places[sum] > 1 || !terms.iter().all(takes_it) {
            return None;
        }
        let mut products = Vec::new();
        for &(term, minus) in terms {
            let own = match &parts.items[term] {
                Item::Product(factors) => factors.clone(),
                _ => vec![(term, false)],
            };
            let (product, negative) = self.build_product(&[constants.clone(), own].concat());
            products.push((product, negative != minus));
        }
        Some(self.join(products))
    }
}
