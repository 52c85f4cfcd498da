//! Items back to expressions.

use num_traits::Signed;

use super::parts::{Item, Operand, Parts, Ref};
use crate::expr::{Binary, ExprId, Graph, Level, Node, Unary};

/// The expressions of the roots.
pub(super) fn rebuild(g: &Graph, parts: &Parts, roots: &[Operand]) -> Vec<ExprId> {
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

/// The state of putting items together.
struct Rebuilding<'a> {
    graph: &'a Graph,
    parts: &'a Parts,
    /// How often each item is used.
    places: Vec<usize>,
    /// The expression of each item that has one already, and whether it counts negative.
    built: Vec<Option<(ExprId, bool)>>,
}

impl Rebuilding<'_> {
    /// The expression of an item with the sign put somewhere.
    fn finish(&mut self, item: Ref, negative: bool) -> ExprId {
        let g = self.graph;
        let (id, own) = self.build(item);
        if own == negative {
            return id;
        }
        if g.level(id) < Level::State {
            return g.neg(id);
        }
        match *g.node(id) {
            // a constant factor takes the sign for nothing
            Node::Binary(op @ (Binary::Mul | Binary::Div), a, b) if g.level(a) < Level::State => {
                let a = g.neg(a);
                g.exactly(op, a, b)
            }
            Node::Binary(Binary::Sub, a, b) => g.exactly(Binary::Sub, b, a),
            _ => g.exactly_negated(id),
        }
    }

    /// The expression of an item, and whether it counts negative.
    fn build(&mut self, item: Ref) -> (ExprId, bool) {
        let (g, parts) = (self.graph, self.parts);
        if let Some(known) = self.built[item] {
            return known;
        }
        let mut value = |item: &Ref| self.finish(*item, false);
        let result = match &parts.items[item] {
            Item::Leaf(id) => (*id, false),
            Item::Unary(op, a) => (g.unary(*op, value(a)), false),
            Item::Quotient(a, b) => (g.exactly(Binary::Div, value(a), value(b)), false),
            Item::Atan2(a, b) => (g.binary(Binary::Atan2, value(a), value(b)), false),
            Item::Power(a, n) => (g.power(value(a), n.clone()), false),
            Item::Sum(operands) => self.build_sum(operands),
            Item::Product(factors) => self.build_product(factors),
        };
        self.built[item] = Some(result);
        result
    }

    fn build_sum(&mut self, operands: &[Operand]) -> (ExprId, bool) {
        let mut terms = Vec::new();
        for &(item, minus) in operands {
            let (id, own) = self.build(item);
            terms.push((id, minus != own));
        }
        self.join(terms)
    }

    /// A sum of terms with signs: its value, and whether it counts negative.
    fn join(&self, terms: Vec<(ExprId, bool)>) -> (ExprId, bool) {
        let g = self.graph;
        let (mut constant, mut positive, mut negative) = (g.zero(), Vec::new(), Vec::new());
        for (id, minus) in terms {
            match (g.level(id) < Level::State, minus) {
                (true, false) => constant = g.add(constant, id),
                (true, true) => constant = g.sub(constant, id),
                (false, false) => positive.push(id),
                (false, true) => negative.push(id),
            }
        }
        match *g.node(constant) {
            _ if g.is_zero(constant) => {}
            Node::Unary(Unary::Neg, opposite) if !positive.is_empty() => negative.push(opposite),
            Node::Number(_) if !positive.is_empty() && g.as_number(constant).is_some_and(Signed::is_negative) => {
                negative.push(g.neg(constant));
            }
            // as a first operand it makes a leading minus unnecessary, whatever its own sign
            _ => positive.insert(0, constant),
        }
        let all_negative = positive.is_empty();
        let (first, then) = if all_negative {
            (negative, Vec::new())
        } else {
            (positive, negative)
        };
        let Some(sum) = first.into_iter().reduce(|a, b| g.exactly(Binary::Add, a, b)) else {
            return (g.zero(), false);
        };
        (
            then.into_iter().fold(sum, |a, b| g.exactly(Binary::Sub, a, b)),
            all_negative,
        )
    }

    fn build_product(&mut self, factors: &[Operand]) -> (ExprId, bool) {
        let g = self.graph;
        if let Some(sum) = self.distributed(factors) {
            return sum;
        }
        let (mut constant, mut state, mut negative) = (g.one(), Vec::new(), false);
        for &(item, _) in factors {
            let (id, own) = self.build(item);
            negative ^= own;
            if g.level(id) < Level::State {
                constant = g.mul(constant, id);
            } else {
                state.push(id);
            }
        }
        if let Node::Unary(Unary::Neg, positive) = *g.node(constant) {
            (constant, negative) = (positive, !negative);
        }
        let first = (constant != g.one()).then_some(constant);
        let product = first
            .into_iter()
            .chain(state)
            .reduce(|a, b| g.exactly(Binary::Mul, a, b));
        (product.unwrap_or(g.one()), negative)
    }

    /// `k (k1 x + k2 y)` as `(k k1) x + (k k2) y`, where that saves the multiplication by `k`.
    fn distributed(&mut self, factors: &[Operand]) -> Option<(ExprId, bool)> {
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
            let (id, negative) = self.build_product(&[constants.clone(), own].concat());
            products.push((id, negative != minus));
        }
        Some(self.join(products))
    }
}
