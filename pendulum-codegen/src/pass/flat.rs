//! Expressions as sums of terms, like terms together.

use std::collections::{BTreeMap, HashMap};

use num_traits::{One, ToPrimitive, Zero};

use crate::expr::{Binary, ExprId, Graph, Level, Node, Normalizer, Rational, Unary};

/// What constants may take to be brought into normal form.
const BUDGET: usize = 100_000;

/// How many terms all sums together may have.
const MOST_TERMS: usize = 200_000;

/// Terms with their factors: the number 1 stands for a term that is a number.
pub(super) type Linear = BTreeMap<ExprId, Rational>;

/// Expressions whose sums are flat.
pub(super) struct Flat<'g> {
    pub(super) g: &'g Graph,
    normalizer: Normalizer,
    /// The terms of each expression of the original.
    linear: HashMap<ExprId, Linear>,
    /// The terms of each flat sum.
    pub(super) sums: HashMap<ExprId, Linear>,
}

impl<'g> Flat<'g> {
    /// The roots with flat sums; none if these have too many terms.
    pub(super) fn new(g: &'g Graph, roots: &[ExprId]) -> Option<(Self, Vec<ExprId>)> {
        let mut flat = Self {
            g,
            normalizer: Normalizer::new(BUDGET),
            linear: HashMap::new(),
            sums: HashMap::new(),
        };
        let mut count = 0;
        for id in g.reachable(roots) {
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

    /// The flat sum of an expression that has been taken apart.
    fn sum_of(&mut self, id: ExprId) -> ExprId {
        let linear = self.linear[&id].clone();
        self.whole(&linear)
    }

    /// The terms of an expression, whose operands have been taken apart.
    fn take_apart(&mut self, id: ExprId) -> Linear {
        let g = self.g;
        if g.level(id) < Level::State {
            return self.constant(id);
        }
        match g.node(id).clone() {
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
                self.term(g.div(x, y), above / below)
            }
            Node::Binary(op, a, b) => {
                let [a, b] = [a, b].map(|x| self.sum_of(x));
                self.term(g.binary(op, a, b), Rational::one())
            }
            Node::Unary(op, a) => {
                let a = self.sum_of(a);
                self.term(g.unary(op, a), Rational::one())
            }
            Node::Power(a, n) => match whole_number(&n) {
                Some(n) => {
                    let (factor, x) = self.one_term(a);
                    let raised = factors(g, x)
                        .into_iter()
                        .map(|(atom, power)| (atom, power * i64::from(n)));
                    let product = self.times(g.one(), &raised.collect());
                    self.term(product, num_traits::Pow::pow(factor, n))
                }
                None => {
                    let a = self.sum_of(a);
                    self.term(g.power(a, n), Rational::one())
                }
            },
            Node::Number(_) | Node::Pi | Node::Symbol(_) => self.term(id, Rational::one()),
        }
    }

    /// The terms of a constant: those of its normal form.
    fn constant(&mut self, id: ExprId) -> Linear {
        let Ok(normal) = self.normalizer.normal(self.g, id) else {
            return self.term(id, Rational::one());
        };
        let mut linear = Linear::new();
        for (monomial, coefficient) in normal.terms() {
            let factors = monomial.powers().iter();
            let factors = factors.map(|&(atom, power)| (atom, power.into())).collect();
            let product = self.times(self.g.one(), &factors);
            add_scaled(&mut linear, &self.term(product, coefficient.clone()), &Rational::one());
        }
        linear
    }

    fn product(&mut self, a: ExprId, b: ExprId) -> Linear {
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
        let mut merged = factors(self.g, x);
        for (atom, power) in factors(self.g, y) {
            *merged.entry(atom).or_default() += power;
        }
        self.term(self.times(self.g.one(), &merged), p * q)
    }

    /// An expression as a number times another.
    fn one_term(&mut self, id: ExprId) -> (Rational, ExprId) {
        let linear = self.linear[&id].clone();
        let Some((&first, factor)) = linear.first_key_value() else {
            return (Rational::one(), self.g.zero());
        };
        if linear.len() == 1 {
            return (factor.clone(), first);
        }
        if self.g.level(id) == Level::State {
            return (Rational::one(), self.whole(&linear));
        }
        let common = common_factor(self.g, &linear);
        let rest = linear
            .iter()
            .map(|(&atom, factor)| (self.over(atom, &common), factor.clone()))
            .collect();
        let rest = self.whole(&rest);
        (Rational::one(), self.times(rest, &common))
    }

    fn over(&self, id: ExprId, divisor: &Factors) -> ExprId {
        let mut factors = factors(self.g, id);
        for (atom, power) in divisor {
            *factors.entry(*atom).or_default() -= power;
        }
        self.times(self.g.one(), &factors)
    }

    fn times(&self, id: ExprId, factors: &Factors) -> ExprId {
        factors.iter().fold(id, |product, (&atom, &power)| {
            self.g.mul(product, self.g.powi(atom, power))
        })
    }

    /// A number times an expression, which may have been simplified to a number or to its opposite.
    fn term(&self, id: ExprId, factor: Rational) -> Linear {
        let (g, mut linear) = (self.g, Linear::new());
        match g.node(id) {
            Node::Number(n) => _ = linear.insert(g.one(), n * factor),
            Node::Unary(Unary::Neg, a) => return self.term(*a, -factor),
            Node::Binary(Binary::Mul, a, b) => match g.as_number(*a) {
                Some(n) => return self.term(*b, n * factor),
                None => _ = linear.insert(id, factor),
            },
            _ => _ = linear.insert(id, factor),
        }
        linear.retain(|_, factor| !factor.is_zero());
        linear
    }

    /// The sum of terms.
    pub(super) fn whole(&mut self, linear: &Linear) -> ExprId {
        let id = linear.iter().fold(self.g.zero(), |sum, (&atom, factor)| {
            let term = self.g.mul(self.g.number(factor.clone()), atom);
            self.g.add(sum, term)
        });
        if linear.len() > 1 {
            self.sums.insert(id, linear.clone());
        }
        id
    }
}

/// Factors of a product and their powers.
type Factors = BTreeMap<ExprId, i64>;

/// The factors of a product with whole powers.
fn factors(g: &Graph, id: ExprId) -> Factors {
    let mut factors = Factors::new();
    let mut stack = vec![id];
    while let Some(id) = stack.pop() {
        match g.node(id) {
            Node::Binary(Binary::Mul, a, b) => stack.extend([*a, *b]),
            _ if id == g.one() => {}
            Node::Power(base, power) => match whole_number(power) {
                Some(power) => *factors.entry(*base).or_default() += i64::from(power),
                None => *factors.entry(id).or_default() += 1,
            },
            _ => *factors.entry(id).or_default() += 1,
        }
    }
    factors
}

/// The factors that all terms share.
fn common_factor(g: &Graph, linear: &Linear) -> Factors {
    let mut terms = linear.keys().map(|&atom| factors(g, atom));
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

/// The power, if it is whole and of a size that declarations have.
fn whole_number(power: &Rational) -> Option<i32> {
    power.is_integer().then(|| power.to_i32()).flatten()
}

/// Terms times a number.
fn scaled(linear: &Linear, factor: &Rational) -> Linear {
    linear.iter().map(|(&atom, own)| (atom, own * factor)).collect()
}

/// Adds terms times a number.
pub(super) fn add_scaled(sum: &mut Linear, other: &Linear, factor: &Rational) {
    for (&atom, own) in other {
        let entry = sum.entry(atom).or_insert_with(Rational::zero);
        *entry += own * factor;
        if entry.is_zero() {
            sum.remove(&atom);
        }
    }
}
