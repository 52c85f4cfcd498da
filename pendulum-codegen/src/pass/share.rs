//! Common parts of sums and products, found whatever the order and the brackets they were written in.
//!
//! Sums and products are taken apart into their operands; the pair of operands that most of them share becomes a value of
//! its own, again and again until no pair is shared; then what is left is put together. Constants of one product or sum
//! come together, so that they are computed once, when the model is built.

use std::collections::{BTreeMap, HashMap};

use num_traits::{One, Signed, ToPrimitive};

use super::pairs::Extraction;
use crate::expr::{Binary, ExprId, Graph, Level, Node, Rational, Unary, ratio};

/// The number of an item.
pub(super) type Ref = usize;

/// An operand, and whether it counts negative. Factors of a product are never negative: the product is.
pub(super) type Operand = (Ref, bool);

/// A value taken apart.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Item {
    Leaf(ExprId),
    Sum(Vec<Operand>),
    Product(Vec<Operand>),
    Unary(Unary, Ref),
    Quotient(Ref, Ref),
    Atan2(Ref, Ref),
    Power(Ref, Rational),
}

/// The expression of each item that has one already, and whether it counts negative.
type Built = Vec<Option<(ExprId, bool)>>;

/// Powers up to this one are products.
const MOST_POWER: i64 = 16;

/// Rewrites the roots so that common parts are shared. Their values do not change, up to rounding. `factor` says that factors which
/// terms of one sum share are drawn out first: that saves products, and may hide others that sums share.
pub fn share(g: &Graph, roots: &[ExprId], factor: bool) -> Vec<ExprId> {
    let mut parts = Parts::new(g, roots);
    let apart: Vec<Operand> = roots.iter().map(|&root| parts.take(g, root)).collect();
    if factor {
        parts.count_places(&apart);
        parts.factor_sums();
    }
    Extraction::run(&mut parts, false);
    Extraction::run(&mut parts, true);
    parts.count_places(&apart);
    let mut built = vec![None; parts.items.len()];
    apart
        .into_iter()
        .map(|(item, negative)| parts.finish(g, &mut built, item, negative))
        .collect()
}

/// All items, without repetition.
pub(super) struct Parts {
    pub(super) items: Vec<Item>,
    refs: HashMap<Item, Ref>,
    taken: HashMap<ExprId, Operand>,
    /// How often each expression is used.
    uses: HashMap<ExprId, usize>,
    /// How many quotients have this divisor.
    divisions: HashMap<ExprId, usize>,
    /// Items that do not depend on the state.
    pub(super) constant: Vec<bool>,
    /// How often each item is used, once nothing changes any more.
    places: Vec<usize>,
}

impl Parts {
    fn new(g: &Graph, roots: &[ExprId]) -> Self {
        let (mut uses, mut divisions) = (HashMap::new(), HashMap::new());
        for id in g.reachable(roots) {
            for operand in g.operands(id) {
                *uses.entry(operand).or_default() += 1;
            }
            if let Node::Binary(Binary::Div, _, divisor) = *g.node(id) {
                *divisions.entry(divisor).or_default() += 1;
            }
        }
        for &root in roots {
            *uses.entry(root).or_default() += 1;
        }
        Self {
            items: Vec::new(),
            refs: HashMap::new(),
            taken: HashMap::new(),
            uses,
            divisions,
            constant: Vec::new(),
            places: Vec::new(),
        }
    }

    pub(super) fn item(&mut self, item: Item, constant: bool) -> Ref {
        if let Some(&known) = self.refs.get(&item) {
            return known;
        }
        self.items.push(item.clone());
        self.constant.push(constant);
        self.refs.insert(item, self.items.len() - 1);
        self.items.len() - 1
    }

    /// Takes an expression apart.
    fn take(&mut self, g: &Graph, id: ExprId) -> Operand {
        if let Some(&taken) = self.taken.get(&id) {
            return taken;
        }
        let operand = if g.level(id) < Level::State {
            self.leaf(g, id)
        } else {
            self.take_state(g, id)
        };
        self.taken.insert(id, operand);
        operand
    }

    fn leaf(&mut self, g: &Graph, id: ExprId) -> Operand {
        let negative = match g.node(id) {
            Node::Number(n) => n.is_negative(),
            Node::Unary(Unary::Neg, _) => true,
            _ => false,
        };
        let positive = if negative { g.neg(id) } else { id };
        (self.item(Item::Leaf(positive), true), negative)
    }

    fn take_state(&mut self, g: &Graph, id: ExprId) -> Operand {
        match g.node(id).clone() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => (self.item(Item::Leaf(id), false), false),
            Node::Unary(Unary::Neg, a) => {
                let (item, negative) = self.take(g, a);
                (item, !negative)
            }
            Node::Unary(op, a) => {
                let a = self.unsigned(g, a);
                (self.item(Item::Unary(op, a), false), false)
            }
            Node::Binary(Binary::Add | Binary::Sub, ..) => {
                let mut operands = Vec::new();
                self.gather_sum(g, id, false, true, &mut operands);
                self.sum(operands)
            }
            Node::Binary(Binary::Div, a, b) if g.level(a) < Level::State || self.divisions[&b] == 1 => {
                let (numerator, negative) = if g.level(a) < Level::State {
                    (self.item(Item::Leaf(a), true), false)
                } else {
                    self.take(g, a)
                };
                let divisor = self.unsigned(g, b);
                (self.item(Item::Quotient(numerator, divisor), false), negative)
            }
            Node::Binary(Binary::Atan2, a, b) => {
                let (a, b) = (self.unsigned(g, a), self.unsigned(g, b));
                (self.item(Item::Atan2(a, b), false), false)
            }
            Node::Power(a, n) if !is_product(&n) => self.power(g, a, &n),
            Node::Binary(Binary::Mul | Binary::Div, ..) | Node::Power(..) => {
                let mut factors = Vec::new();
                let negative = self.gather_product(g, id, true, &mut factors);
                (self.product(factors), negative)
            }
        }
    }

    fn power(&mut self, g: &Graph, base: ExprId, exponent: &Rational) -> Operand {
        if exponent.is_negative() {
            let one = g.one();
            let inverse = g.power(base, -exponent);
            let (one, divisor) = (self.item(Item::Leaf(one), true), self.unsigned(g, inverse));
            return (self.item(Item::Quotient(one, divisor), false), false);
        }
        let half = ratio(1, 2);
        if *exponent.denom() == 2.into() && *exponent != half {
            let root = g.power(base, half);
            let (root, _) = self.take(g, root);
            let count = exponent.numer().to_usize().unwrap_or(1);
            return (self.product(vec![root; count]), false);
        }
        let base = self.unsigned(g, base);
        (self.item(Item::Power(base, exponent.clone()), false), false)
    }

    /// An item of the value itself, its sign included.
    fn unsigned(&mut self, g: &Graph, id: ExprId) -> Ref {
        match self.take(g, id) {
            (item, false) => item,
            (item, true) => {
                let constant = self.constant[item];
                self.item(Item::Sum(vec![(item, true)]), constant)
            }
        }
    }

    fn gather_sum(&mut self, g: &Graph, id: ExprId, negative: bool, top: bool, operands: &mut Vec<Operand>) {
        let inside = top || (self.uses[&id] == 1 && g.level(id) == Level::State);
        match *g.node(id) {
            Node::Binary(Binary::Add, a, b) if inside => {
                self.gather_sum(g, a, negative, false, operands);
                self.gather_sum(g, b, negative, false, operands);
            }
            Node::Binary(Binary::Sub, a, b) if inside => {
                self.gather_sum(g, a, negative, false, operands);
                self.gather_sum(g, b, !negative, false, operands);
            }
            Node::Unary(Unary::Neg, a) if inside => self.gather_sum(g, a, !negative, false, operands),
            _ => {
                let (item, own) = self.take(g, id);
                operands.push((item, own != negative));
            }
        }
    }

    /// Collects the factors, and tells whether their product counts negative.
    fn gather_product(&mut self, g: &Graph, id: ExprId, top: bool, factors: &mut Vec<Ref>) -> bool {
        let inside = top || (self.uses[&id] == 1 && g.level(id) == Level::State);
        match g.node(id).clone() {
            Node::Binary(Binary::Mul, a, b) if inside => {
                let left = self.gather_product(g, a, false, factors);
                self.gather_product(g, b, false, factors) != left
            }
            Node::Binary(Binary::Div, a, b) if inside && g.level(a) == Level::State && self.divisions[&b] > 1 => {
                let left = self.gather_product(g, a, false, factors);
                let one = g.one();
                let reciprocal = g.exactly(Binary::Div, one, b);
                let (item, own) = self.take(g, reciprocal);
                factors.push(item);
                own != left
            }
            Node::Unary(Unary::Neg, a) if inside => !self.gather_product(g, a, false, factors),
            Node::Power(a, n) if is_product(&n) && g.level(id) != Level::Constant => {
                let (item, own) = self.take(g, a);
                let count = n.to_integer().to_usize().unwrap_or(1);
                factors.extend(std::iter::repeat_n(item, count));
                own && count % 2 == 1
            }
            _ => {
                let (item, own) = self.take(g, id);
                factors.push(item);
                own
            }
        }
    }

    fn sum(&mut self, mut operands: Vec<Operand>) -> Operand {
        operands.sort_unstable();
        match operands[..] {
            [only] => only,
            _ => {
                let constant = operands.iter().all(|(item, _)| self.constant[*item]);
                (self.item(Item::Sum(operands), constant), false)
            }
        }
    }

    fn product(&mut self, mut factors: Vec<Ref>) -> Ref {
        factors.sort_unstable();
        match factors[..] {
            [only] => only,
            _ => {
                let constant = factors.iter().all(|item| self.constant[*item]);
                self.item(
                    Item::Product(factors.into_iter().map(|item| (item, false)).collect()),
                    constant,
                )
            }
        }
    }

    /// The expression of an item with the sign put somewhere.
    fn finish(&self, g: &Graph, built: &mut Built, item: Ref, negative: bool) -> ExprId {
        let (id, own) = self.build(g, built, item);
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
    fn build(&self, g: &Graph, built: &mut Built, item: Ref) -> (ExprId, bool) {
        if let Some(known) = built[item] {
            return known;
        }
        let mut value = |g: &Graph, item: Ref| self.finish(g, built, item, false);
        let result = match &self.items[item] {
            Item::Leaf(id) => (*id, false),
            Item::Unary(op, a) => {
                let a = value(g, *a);
                (g.unary(*op, a), false)
            }
            Item::Quotient(a, b) => {
                let (a, b) = (value(g, *a), value(g, *b));
                (g.exactly(Binary::Div, a, b), false)
            }
            Item::Atan2(a, b) => {
                let (a, b) = (value(g, *a), value(g, *b));
                (g.binary(Binary::Atan2, a, b), false)
            }
            Item::Power(a, n) => {
                let a = value(g, *a);
                (g.power(a, n.clone()), false)
            }
            Item::Sum(operands) => self.build_sum(g, built, operands),
            Item::Product(factors) => self.build_product(g, built, factors),
        };
        built[item] = Some(result);
        result
    }

    fn build_sum(&self, g: &Graph, built: &mut Built, operands: &[Operand]) -> (ExprId, bool) {
        let mut terms = Vec::new();
        for &(item, minus) in operands {
            let (id, own) = self.build(g, built, item);
            terms.push((id, minus != own));
        }
        self.join(g, terms)
    }

    /// A sum of terms with signs: its value, and whether it counts negative.
    fn join(&self, g: &Graph, terms: Vec<(ExprId, bool)>) -> (ExprId, bool) {
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

    fn build_product(&self, g: &Graph, built: &mut Built, factors: &[Operand]) -> (ExprId, bool) {
        if let Some(sum) = self.distributed(g, built, factors) {
            return sum;
        }
        let (mut constant, mut state, mut negative) = (g.one(), Vec::new(), false);
        for &(item, _) in factors {
            let (id, own) = self.build(g, built, item);
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
}

impl Parts {
    fn count_places(&mut self, roots: &[Operand]) {
        self.places = vec![0; self.items.len()];
        let mut seen = vec![false; self.items.len()];
        let mut stack: Vec<Ref> = roots.iter().map(|(item, _)| *item).collect();
        while let Some(item) = stack.pop() {
            self.places[item] += 1;
            if !std::mem::replace(&mut seen[item], true) {
                match &self.items[item] {
                    Item::Leaf(_) => {}
                    Item::Sum(operands) | Item::Product(operands) => {
                        stack.extend(operands.iter().map(|(item, _)| *item))
                    }
                    Item::Unary(_, a) | Item::Power(a, _) => stack.push(*a),
                    Item::Quotient(a, b) | Item::Atan2(a, b) => stack.extend([*a, *b]),
                }
            }
        }
    }

    /// `f x + f y + z` as `f (x + y) + z` in every sum, the most frequent factor first, where the products are used nowhere else.
    fn factor_sums(&mut self) {
        let mut item = 0;
        while item < self.items.len() {
            while let Item::Sum(operands) = &self.items[item]
                && let Some(factor) = self.most_frequent_factor(operands)
            {
                let (with, mut rest): (Vec<Operand>, Vec<Operand>) = operands
                    .iter()
                    .partition(|(operand, _)| self.own_factors(*operand).contains(&(factor, false)));
                let mut inside = Vec::new();
                for (operand, minus) in with {
                    let mut others: Vec<Ref> = self.own_factors(operand).iter().map(|(other, _)| *other).collect();
                    if let Some(at) = others.iter().position(|other| *other == factor) {
                        others.remove(at);
                    }
                    inside.push((self.product(others), minus));
                }
                let (inside, minus) = self.sum(inside);
                rest.push((self.product(vec![factor, inside]), minus));
                rest.sort_unstable();
                self.items[item] = Item::Sum(rest);
            }
            item += 1;
        }
    }

    /// The factors of a product that is used once; none for anything else.
    fn own_factors(&self, item: Ref) -> &[Operand] {
        match &self.items[item] {
            Item::Product(factors) if self.places.get(item).is_none_or(|&places| places == 1) => factors,
            _ => &[],
        }
    }

    fn most_frequent_factor(&self, operands: &[Operand]) -> Option<Ref> {
        let mut counts: BTreeMap<Ref, usize> = BTreeMap::new();
        for (operand, _) in operands {
            let mut factors: Vec<Ref> = self.own_factors(*operand).iter().map(|(factor, _)| *factor).collect();
            factors.dedup();
            for factor in factors {
                *counts.entry(factor).or_default() += 1;
            }
        }
        let best = counts
            .into_iter()
            .max_by_key(|&(factor, count)| (count, std::cmp::Reverse(factor)));
        best.filter(|&(_, count)| count >= 2).map(|(factor, _)| factor)
    }

    /// `k (k1 x + k2 y)` as `(k k1) x + (k k2) y`, where that saves the multiplication by `k`.
    fn distributed(&self, g: &Graph, built: &mut Built, factors: &[Operand]) -> Option<(ExprId, bool)> {
        let (constants, state): (Vec<Operand>, Vec<Operand>) =
            factors.iter().partition(|(item, _)| self.constant[*item]);
        let &[(sum, _)] = &state[..] else { return None };
        let Item::Sum(terms) = &self.items[sum] else {
            return None;
        };
        let takes_it = |&(term, _): &Operand| match &self.items[term] {
            Item::Product(factors) => self.places[term] == 1 && factors.iter().any(|(item, _)| self.constant[*item]),
            _ => self.constant[term],
        };
        if constants.is_empty() || self.places[sum] > 1 || !terms.iter().all(takes_it) {
            return None;
        }
        let mut products = Vec::new();
        for &(term, minus) in terms {
            let own = match &self.items[term] {
                Item::Product(factors) => factors.clone(),
                _ => vec![(term, false)],
            };
            let (id, negative) = self.build_product(g, built, &[constants.clone(), own].concat());
            products.push((id, negative != minus));
        }
        Some(self.join(g, products))
    }
}

fn is_product(exponent: &Rational) -> bool {
    exponent.denom().is_one() && (2..=MOST_POWER).contains(&exponent.to_i64().unwrap_or(0))
}
