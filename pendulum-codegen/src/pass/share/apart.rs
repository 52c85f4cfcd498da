//! Decomposition of expressions into items.

use num_traits::{One, Signed, ToPrimitive};
use rustc_hash::FxHashMap;

use super::parts::{Item, Operand, Parts, Ref};
use crate::expr::{Binary, Expr, Graph, Level, Node, Rational, Unary, ratio};

/// Largest power treated as a product.
const MOST_POWER: i64 = 16;

/// Decomposes the roots. Returns all items, and the operand that stands for each root.
pub(super) fn take_apart<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> (Parts, Vec<Operand>) {
    let mut apart = Apart::new(g, roots);
    let taken = roots.iter().map(|&root| apart.take(root)).collect();
    (apart.parts, taken)
}

/// State of the decomposition.
struct Apart<'g> {
    parts: Parts,
    taken: FxHashMap<Expr<'g>, Operand>,
    /// Number of uses of each expression.
    uses: FxHashMap<Expr<'g>, usize>,
    /// Number of quotients with each divisor.
    divisions: FxHashMap<Expr<'g>, usize>,
}

impl<'g> Apart<'g> {
    fn new(graph: &'g Graph, roots: &[Expr<'g>]) -> Self {
        let (mut uses, mut divisions) = (FxHashMap::default(), FxHashMap::default());
        for x in graph.reachable(roots).into_iter().map(|id| graph.expr(id)) {
            for operand in x.operands() {
                *uses.entry(operand).or_default() += 1;
            }
            if let Node::Binary(Binary::Div, _, divisor) = x.node() {
                *divisions.entry(divisor).or_default() += 1;
            }
        }
        for &root in roots {
            *uses.entry(root).or_default() += 1;
        }
        Self {
            parts: Parts::default(),
            taken: FxHashMap::default(),
            uses,
            divisions,
        }
    }

    /// Decomposes an expression.
    fn take(&mut self, x: Expr<'g>) -> Operand {
        if let Some(&taken) = self.taken.get(&x) {
            return taken;
        }
        let operand = if x.level() < Level::State {
            self.leaf(x)
        } else {
            self.take_state(x)
        };
        self.taken.insert(x, operand);
        operand
    }

    fn leaf(&mut self, x: Expr<'g>) -> Operand {
        let negative = match x.node() {
            Node::Number(n) => n.is_negative(),
            Node::Unary(Unary::Neg, _) => true,
            _ => false,
        };
        let positive = if negative { -x } else { x };
        (self.parts.item(Item::Leaf(positive.id()), true), negative)
    }

    fn take_state(&mut self, x: Expr<'g>) -> Operand {
        match x.node() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => (self.parts.item(Item::Leaf(x.id()), false), false),
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
                self.gather_sum(x, false, true, &mut operands);
                self.parts.sum(operands)
            }
            Node::Binary(Binary::Div, a, b) if a.level() < Level::State || self.divisions[&b] == 1 => {
                let (numerator, negative) = if a.level() < Level::State {
                    (self.parts.item(Item::Leaf(a.id()), true), false)
                } else {
                    self.take(a)
                };
                let divisor = self.unsigned(b);
                (self.parts.item(Item::Quotient(numerator, divisor), false), negative)
            }
            Node::Binary(op @ (Binary::Atan2 | Binary::Max | Binary::Min), a, b) => {
                let (a, b) = (self.unsigned(a), self.unsigned(b));
                (self.parts.item(Item::Function(op, a, b), false), false)
            }
            Node::Power(a, n) if !is_product(n) => self.power(a, n),
            Node::Binary(Binary::Mul | Binary::Div, ..) | Node::Power(..) => {
                let mut factors = Vec::new();
                let negative = self.gather_product(x, true, &mut factors);
                (self.parts.product(factors), negative)
            }
        }
    }

    fn power(&mut self, base: Expr<'g>, exponent: &Rational) -> Operand {
        if exponent.is_negative() {
            let one = base.graph().one();
            let inverse = base.power(-exponent);
            let (one, divisor) = (self.parts.item(Item::Leaf(one.id()), true), self.unsigned(inverse));
            return (self.parts.item(Item::Quotient(one, divisor), false), false);
        }
        let half = ratio(1, 2);
        if *exponent.denom() == 2.into() && *exponent != half {
            let root = base.power(half);
            let (root, _) = self.take(root);
            let count = exponent.numer().to_usize().unwrap_or(1);
            return (self.parts.product(vec![root; count]), false);
        }
        let base = self.unsigned(base);
        (self.parts.item(Item::Power(base, exponent.clone()), false), false)
    }

    /// Item of the value with its sign, for places that take no sign.
    fn unsigned(&mut self, x: Expr<'g>) -> Ref {
        match self.take(x) {
            (item, false) => item,
            (item, true) => {
                let constant = self.parts.constant[item];
                self.parts.item(Item::Sum(vec![(item, true)]), constant)
            }
        }
    }

    fn gather_sum(&mut self, x: Expr<'g>, negative: bool, top: bool, operands: &mut Vec<Operand>) {
        let inside = top || (self.uses[&x] == 1 && x.level() == Level::State);
        match x.node() {
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
                let (item, own) = self.take(x);
                operands.push((item, own != negative));
            }
        }
    }

    /// Collects the factors. Returns true if their product is negated.
    fn gather_product(&mut self, x: Expr<'g>, top: bool, factors: &mut Vec<Ref>) -> bool {
        let inside = top || (self.uses[&x] == 1 && x.level() == Level::State);
        match x.node() {
            Node::Binary(Binary::Mul, a, b) if inside => {
                let left = self.gather_product(a, false, factors);
                self.gather_product(b, false, factors) != left
            }
            Node::Binary(Binary::Div, a, b) if inside && a.level() == Level::State && self.divisions[&b] > 1 => {
                let left = self.gather_product(a, false, factors);
                let (item, own) = self.take(b.graph().one().exactly(Binary::Div, b));
                factors.push(item);
                own != left
            }
            Node::Unary(Unary::Neg, a) if inside => !self.gather_product(a, false, factors),
            Node::Power(a, n) if is_product(n) && x.level() != Level::Constant => {
                let (item, own) = self.take(a);
                let count = n.to_integer().to_usize().unwrap_or(1);
                factors.extend(std::iter::repeat_n(item, count));
                own && count % 2 == 1
            }
            _ => {
                let (item, own) = self.take(x);
                factors.push(item);
                own
            }
        }
    }
}

fn is_product(exponent: &Rational) -> bool {
    exponent.denom().is_one() && (2..=MOST_POWER).contains(&exponent.to_i64().unwrap_or(0))
}
