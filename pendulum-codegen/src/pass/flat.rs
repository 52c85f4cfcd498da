//! Expressions as sums of terms, with like terms collected.

use std::collections::BTreeMap;

use num_traits::{One, ToPrimitive, Zero};
use rustc_hash::FxHashMap;

use crate::expr::{
    Binary, Expr, Graph, LONGEST_CONSTANT, Level, MOST_BITS, Node, Normalizer, Rational, Unary, add, is_short, multiply,
};

/// Maximum number of products of terms formed to bring constants into normal form.
const BUDGET: usize = 100_000;

/// Maximum number of terms of all sums together.
const MOST_TERMS: usize = 200_000;

/// Terms with their rational factors; a purely numerical term is a multiple of the number 1.
pub(super) type Linear<'g> = BTreeMap<Expr<'g>, Rational>;

/// Expressions with flat sums.
pub(super) struct Flat<'g> {
    pub(super) g: &'g Graph,
    normalizer: Normalizer<'g>,
    /// Terms of each original expression.
    linear: FxHashMap<Expr<'g>, Linear<'g>>,
    /// Terms of each flat sum.
    pub(super) sums: FxHashMap<Expr<'g>, Linear<'g>>,
}

impl<'g> Flat<'g> {
    /// Flattens the sums of the roots. Returns `None` if they have too many terms.
    pub(super) fn new(g: &'g Graph, roots: &[Expr<'g>]) -> Option<(Self, Vec<Expr<'g>>)> {
        let mut flat = Self {
            g,
            normalizer: Normalizer::new(g, BUDGET),
            linear: FxHashMap::default(),
            sums: FxHashMap::default(),
        };
        let mut count = 0;
        for id in g.reachable(roots).into_iter().map(|id| g.expr(id)) {
            let linear = flat.take_apart(id);
            count += linear.len();
            if count > MOST_TERMS {
                return None;
            }
            flat.linear.insert(id, linear);
        }
        let roots = roots.iter().map(|root| flat.sum_of(*root)).collect();
        Some((flat, roots))
    }

    /// Flat sum of an expression in `linear`.
    fn sum_of(&mut self, id: Expr<'g>) -> Expr<'g> {
        let linear = self.linear[&id].clone();
        self.whole(&linear)
    }

    /// Terms of an expression; its operands must be in `linear`.
    fn take_apart(&mut self, id: Expr<'g>) -> Linear<'g> {
        let g = self.g;
        if id.level() < Level::State {
            return self.constant(id);
        }
        match id.node() {
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                let mut sum = self.linear[&a].clone();
                let sign = if op == Binary::Sub {
                    -Rational::one()
                } else {
                    Rational::one()
                };
                add_scaled(&mut sum, &self.linear[&b], &sign);
                sum
            }
            Node::Unary(Unary::Neg, a) => scaled(&self.linear[&a], &-Rational::one()),
            Node::Binary(Binary::Mul, a, b) => self.product(a, b),
            Node::Binary(Binary::Div, a, b) => {
                let ((above, x), (below, y)) = (self.one_term(a), self.one_term(b));
                self.term(x / y, above / below)
            }
            Node::Binary(op, a, b) => {
                let [a, b] = [a, b].map(|x| self.sum_of(x));
                self.term(a.combine(op, b), Rational::one())
            }
            Node::Unary(op, a) => {
                let a = self.sum_of(a);
                self.term(a.apply(op), Rational::one())
            }
            Node::Power(a, n) => match whole_number(n) {
                Some(n) if is_short_power(&self.one_term(a).0, n) => {
                    let (factor, x) = self.one_term(a);
                    let raised = factors(x).into_iter().map(|(atom, power)| (atom, power * i64::from(n)));
                    let product = self.times(g.one(), &raised.collect());
                    self.term(product, num_traits::Pow::pow(factor, n))
                }
                _ => {
                    let a = self.sum_of(a);
                    self.term(a.power(n.clone()), Rational::one())
                }
            },
            Node::Number(_) | Node::Pi | Node::Symbol(_) => self.term(id, Rational::one()),
        }
    }

    /// Terms of the normal form of a constant.
    fn constant(&mut self, id: Expr<'g>) -> Linear<'g> {
        // a long constant is printed as its value
        let is_long = id.level() == Level::Constant && id.length() > LONGEST_CONSTANT;
        let Some(normal) = (!is_long).then(|| self.normalizer.normal(id).ok()).flatten() else {
            return self.term(id, Rational::one());
        };
        let mut linear = Linear::new();
        for (monomial, coefficient) in normal.terms() {
            let factors = monomial.powers().iter();
            let factors = factors
                .map(|&(atom, power)| (self.g.expr(atom), power.into()))
                .collect();
            let product = self.times(self.g.one(), &factors);
            add_scaled(&mut linear, &self.term(product, coefficient.clone()), &Rational::one());
        }
        linear
    }

    fn product(&mut self, a: Expr<'g>, b: Expr<'g>) -> Linear<'g> {
        let one = self.g.one();
        for (x, y) in [(a, b), (b, a)] {
            if let Some((&atom, number)) = self.linear[&x].first_key_value()
                && atom == one
                && self.linear[&x].len() == 1
            {
                return scaled(&self.linear[&y], number);
            }
        }
        let ((p, x), (q, y)) = (self.one_term(a), self.one_term(b));
        let factor = multiply(&p, &q);
        if !is_short(&factor) {
            let [a, b] = [a, b].map(|x| self.sum_of(x));
            return self.term(a * b, Rational::one());
        }
        let mut merged = factors(x);
        for (atom, power) in factors(y) {
            *merged.entry(atom).or_default() += power;
        }
        self.term(self.times(self.g.one(), &merged), factor)
    }

    /// Writes an expression as a number times another expression.
    fn one_term(&mut self, id: Expr<'g>) -> (Rational, Expr<'g>) {
        let linear = self.linear[&id].clone();
        let Some((&first, factor)) = linear.first_key_value() else {
            return (Rational::one(), self.g.zero());
        };
        if linear.len() == 1 {
            return (factor.clone(), first);
        }
        if id.level() == Level::State {
            return (Rational::one(), self.whole(&linear));
        }
        let common = common_factor(&linear);
        let rest = linear
            .iter()
            .map(|(&atom, factor)| (self.over(atom, &common), factor.clone()))
            .collect();
        let rest = self.whole(&rest);
        (Rational::one(), self.times(rest, &common))
    }

    fn over(&self, id: Expr<'g>, divisor: &Factors<'g>) -> Expr<'g> {
        let mut factors = factors(id);
        for (atom, power) in divisor {
            *factors.entry(*atom).or_default() -= power;
        }
        self.times(self.g.one(), &factors)
    }

    fn times(&self, id: Expr<'g>, factors: &Factors<'g>) -> Expr<'g> {
        factors
            .iter()
            .fold(id, |product, (&atom, &power)| product * atom.powi(power))
    }

    /// Terms of a number times an expression, which simplification may have turned into a number or a negation.
    fn term(&self, id: Expr<'g>, factor: Rational) -> Linear<'g> {
        let (g, mut linear) = (self.g, Linear::new());
        match id.node() {
            Node::Number(n) => _ = linear.insert(g.one(), multiply(n, &factor)),
            Node::Unary(Unary::Neg, a) => return self.term(a, -factor),
            Node::Binary(Binary::Mul, a, b) => match a.as_number() {
                Some(n) => return self.term(b, multiply(n, &factor)),
                None => _ = linear.insert(id, factor),
            },
            _ => _ = linear.insert(id, factor),
        }
        linear.retain(|_, factor| !factor.is_zero());
        linear
    }

    /// Sum of terms.
    pub(super) fn whole(&mut self, linear: &Linear<'g>) -> Expr<'g> {
        let id = linear.iter().fold(self.g.zero(), |sum, (&atom, factor)| {
            let term = factor.clone() * atom;
            sum + term
        });
        if linear.len() > 1 {
            self.sums.insert(id, linear.clone());
        }
        id
    }
}

/// Factors of a product and their powers.
type Factors<'g> = BTreeMap<Expr<'g>, i64>;

/// Factors of a product, with integer powers.
fn factors(x: Expr<'_>) -> Factors<'_> {
    let mut factors = Factors::new();
    let mut stack = vec![x];
    while let Some(x) = stack.pop() {
        match x.node() {
            Node::Binary(Binary::Mul, a, b) => stack.extend([a, b]),
            _ if x.is_one() => {}
            Node::Power(base, power) => match whole_number(power) {
                Some(power) => *factors.entry(base).or_default() += i64::from(power),
                None => *factors.entry(x).or_default() += 1,
            },
            _ => *factors.entry(x).or_default() += 1,
        }
    }
    factors
}

/// Factors common to all terms.
fn common_factor<'g>(linear: &Linear<'g>) -> Factors<'g> {
    let mut terms = linear.keys().map(|&atom| factors(atom));
    let mut common = terms.next().unwrap_or_default();
    common.retain(|_, power| *power > 0);
    for term in terms {
        common.retain(|atom, power| {
            *power = term.get(atom).map_or(0, |own| *own.min(power));
            *power > 0
        });
    }
    common
}

/// Returns the power as an integer, if it is one and fits an `i32`.
fn whole_number(power: &Rational) -> Option<i32> {
    power.is_integer().then(|| power.to_i32()).flatten()
}

/// True if a power of a number is short enough to be computed.
fn is_short_power(x: &Rational, n: i32) -> bool {
    let bits = |n: &num_bigint::BigInt| n.bits().saturating_sub(1);
    x.is_one() || (bits(x.numer()) + bits(x.denom())).saturating_mul(n.unsigned_abs().into()) <= MOST_BITS
}

/// Multiplies terms by a number.
fn scaled<'g>(linear: &Linear<'g>, factor: &Rational) -> Linear<'g> {
    linear
        .iter()
        .map(|(&atom, own)| (atom, multiply(own, factor)))
        .collect()
}

/// Adds `other` times a number to `sum`.
pub(super) fn add_scaled<'g>(sum: &mut Linear<'g>, other: &Linear<'g>, factor: &Rational) {
    for (&atom, own) in other {
        let entry = sum.entry(atom).or_insert_with(Rational::zero);
        *entry = add(entry, &multiply(own, factor));
        if entry.is_zero() {
            sum.remove(&atom);
        }
    }
}
