//! Expressions taken apart into items.

use std::collections::HashMap;

use num_traits::{One, Signed, ToPrimitive};

use super::parts::{Item, Operand, Parts, Ref};
use crate::expr::{Binary, ExprId, Graph, Level, Node, Rational, Unary, ratio};

/// Powers up to this one are products.
const MOST_POWER: i64 = 16;

/// Takes the roots apart: all items, and the one that each root is.
pub(super) fn take_apart(g: &Graph, roots: &[ExprId]) -> (Parts, Vec<Operand>) {
    let mut apart = Apart::new(g, roots);
    let taken = roots.iter().map(|&root| apart.take(root)).collect();
    (apart.parts, taken)
}

/// The state of taking apart.
struct Apart<'g> {
    graph: &'g Graph,
    parts: Parts,
    taken: HashMap<ExprId, Operand>,
    /// How often each expression is used.
    uses: HashMap<ExprId, usize>,
    /// How many quotients have this divisor.
    divisions: HashMap<ExprId, usize>,
}

impl<'g> Apart<'g> {
    fn new(graph: &'g Graph, roots: &[ExprId]) -> Self {
        let (mut uses, mut divisions) = (HashMap::new(), HashMap::new());
        for id in graph.reachable(roots) {
            for operand in graph.operands(id) {
                *uses.entry(operand).or_default() += 1;
            }
            if let Node::Binary(Binary::Div, _, divisor) = *graph.node(id) {
                *divisions.entry(divisor).or_default() += 1;
            }
        }
        for &root in roots {
            *uses.entry(root).or_default() += 1;
        }
        Self {
            graph,
            parts: Parts::default(),
            taken: HashMap::new(),
            uses,
            divisions,
        }
    }

    /// Takes an expression apart.
    fn take(&mut self, id: ExprId) -> Operand {
        let g = self.graph;
        if let Some(&taken) = self.taken.get(&id) {
            return taken;
        }
        let operand = if g.level(id) < Level::State {
            self.leaf(id)
        } else {
            self.take_state(id)
        };
        self.taken.insert(id, operand);
        operand
    }

    fn leaf(&mut self, id: ExprId) -> Operand {
        let g = self.graph;
        let negative = match g.node(id) {
            Node::Number(n) => n.is_negative(),
            Node::Unary(Unary::Neg, _) => true,
            _ => false,
        };
        let positive = if negative { g.neg(id) } else { id };
        (self.parts.item(Item::Leaf(positive), true), negative)
    }

    fn take_state(&mut self, id: ExprId) -> Operand {
        let g = self.graph;
        match g.node(id).clone() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => (self.parts.item(Item::Leaf(id), false), false),
            Node::Unary(Unary::Neg, a) => {
                let (item, negative) = self.take(a);
                (item, !negative)
            }
            Node::Unary(op, a) => {
                let a = self.unsigned(a);
                (self.parts.item(Item::Unary(op, a), false), false)
            }
            Node::Binary(Binary::Add | Binary::Sub, ..) => {
                let mut operands = Vec::new();
                self.gather_sum(id, false, true, &mut operands);
                self.parts.sum(operands)
            }
            Node::Binary(Binary::Div, a, b) if g.level(a) < Level::State || self.divisions[&b] == 1 => {
                let (numerator, negative) = if g.level(a) < Level::State {
                    (self.parts.item(Item::Leaf(a), true), false)
                } else {
                    self.take(a)
                };
                let divisor = self.unsigned(b);
                (self.parts.item(Item::Quotient(numerator, divisor), false), negative)
            }
            Node::Binary(Binary::Atan2, a, b) => {
                let (a, b) = (self.unsigned(a), self.unsigned(b));
                (self.parts.item(Item::Atan2(a, b), false), false)
            }
            Node::Power(a, n) if !is_product(&n) => self.power(a, &n),
            Node::Binary(Binary::Mul | Binary::Div, ..) | Node::Power(..) => {
                let mut factors = Vec::new();
                let negative = self.gather_product(id, true, &mut factors);
                (self.parts.product(factors), negative)
            }
        }
    }

    fn power(&mut self, base: ExprId, exponent: &Rational) -> Operand {
        let g = self.graph;
        if exponent.is_negative() {
            let one = g.one();
            let inverse = g.power(base, -exponent);
            let (one, divisor) = (self.parts.item(Item::Leaf(one), true), self.unsigned(inverse));
            return (self.parts.item(Item::Quotient(one, divisor), false), false);
        }
        let half = ratio(1, 2);
        if *exponent.denom() == 2.into() && *exponent != half {
            let root = g.power(base, half);
            let (root, _) = self.take(root);
            let count = exponent.numer().to_usize().unwrap_or(1);
            return (self.parts.product(vec![root; count]), false);
        }
        let base = self.unsigned(base);
        (self.parts.item(Item::Power(base, exponent.clone()), false), false)
    }

    /// An item of the value itself, its sign included.
    fn unsigned(&mut self, id: ExprId) -> Ref {
        match self.take(id) {
            (item, false) => item,
            (item, true) => {
                let constant = self.parts.constant[item];
                self.parts.item(Item::Sum(vec![(item, true)]), constant)
            }
        }
    }

    fn gather_sum(&mut self, id: ExprId, negative: bool, top: bool, operands: &mut Vec<Operand>) {
        let g = self.graph;
        let inside = top || (self.uses[&id] == 1 && g.level(id) == Level::State);
        match *g.node(id) {
            Node::Binary(Binary::Add, a, b) if inside => {
                self.gather_sum(a, negative, false, operands);
                self.gather_sum(b, negative, false, operands);
            }
            Node::Binary(Binary::Sub, a, b) if inside => {
                self.gather_sum(a, negative, false, operands);
                self.gather_sum(b, !negative, false, operands);
            }
            Node::Unary(Unary::Neg, a) if inside => self.gather_sum(a, !negative, false, operands),
            _ => {
                let (item, own) = self.take(id);
                operands.push((item, own != negative));
            }
        }
    }

    /// Collects the factors, and tells whether their product counts negative.
    fn gather_product(&mut self, id: ExprId, top: bool, factors: &mut Vec<Ref>) -> bool {
        let g = self.graph;
        let inside = top || (self.uses[&id] == 1 && g.level(id) == Level::State);
        match g.node(id).clone() {
            Node::Binary(Binary::Mul, a, b) if inside => {
                let left = self.gather_product(a, false, factors);
                self.gather_product(b, false, factors) != left
            }
            Node::Binary(Binary::Div, a, b) if inside && g.level(a) == Level::State && self.divisions[&b] > 1 => {
                let left = self.gather_product(a, false, factors);
                let one = g.one();
                let reciprocal = g.exactly(Binary::Div, one, b);
                let (item, own) = self.take(reciprocal);
                factors.push(item);
                own != left
            }
            Node::Unary(Unary::Neg, a) if inside => !self.gather_product(a, false, factors),
            Node::Power(a, n) if is_product(&n) && g.level(id) != Level::Constant => {
                let (item, own) = self.take(a);
                let count = n.to_integer().to_usize().unwrap_or(1);
                factors.extend(std::iter::repeat_n(item, count));
                own && count % 2 == 1
            }
            _ => {
                let (item, own) = self.take(id);
                factors.push(item);
                own
            }
        }
    }
}

fn is_product(exponent: &Rational) -> bool {
    exponent.denom().is_one() && (2..=MOST_POWER).contains(&exponent.to_i64().unwrap_or(0))
}
