//! Sums written with the sums that they contain.
//!
//! Recursions over the links of a chain add a little to a sum from link to link. Where the little things cancel each other, or come
//! in another order, the chain of sums no longer shows. Here every sum becomes a list of its terms, like terms together, and then the
//! longest sum that is contained in it, and the rest.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::expr::{Binary, ExprId, Graph, Level, Node, Normalizer, Rational, Unary};

/// What constants may take to be brought into normal form.
const BUDGET: usize = 100_000;

/// Terms with their factors: the number 1 stands for a term that is a number.
type Linear = BTreeMap<ExprId, Rational>;

/// The roots, in which each sum is written with the longest sum that it contains.
pub fn nest(g: &Graph, roots: &[ExprId]) -> Vec<ExprId> {
    let mut flat = Flat {
        g,
        normalizer: Normalizer::new(BUDGET),
        linear: HashMap::new(),
        sums: HashMap::new(),
    };
    for id in g.reachable(roots) {
        let linear = flat.take_apart(id);
        flat.linear.insert(id, linear);
    }
    let flat_roots: Vec<ExprId> = roots
        .iter()
        .map(|root| flat.whole(&flat.linear[root].clone()))
        .collect();
    let mut sums: Vec<Linear> = {
        let needed: BTreeSet<ExprId> = g.reachable(&flat_roots).into_iter().collect();
        flat.sums
            .iter()
            .filter(|(id, _)| needed.contains(id))
            .map(|(_, linear)| linear.clone())
            .collect()
    };
    // the longest first, and each after those of its length in the order of their terms, whatever the order of the table
    sums.sort_by(|a, b| b.len().cmp(&a.len()).then_with(|| a.cmp(b)));
    let mut nested = Nested {
        flat,
        sums,
        built: HashMap::new(),
    };
    flat_roots.into_iter().map(|root| nested.build(root)).collect()
}

/// Expressions whose sums are flat.
struct Flat<'g> {
    g: &'g Graph,
    normalizer: Normalizer,
    /// The terms of each expression of the original.
    linear: HashMap<ExprId, Linear>,
    /// The terms of each flat sum.
    sums: HashMap<ExprId, Linear>,
}

impl Flat<'_> {
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
                let [a, b] = [a, b].map(|x| self.whole(&self.linear[&x].clone()));
                self.term(g.binary(op, a, b), Rational::one())
            }
            Node::Unary(op, a) => {
                let a = self.whole(&self.linear[&a].clone());
                self.term(g.unary(op, a), Rational::one())
            }
            Node::Power(a, n) if n.is_integer() => {
                let (factor, x) = self.one_term(a);
                let factor = num_traits::Pow::pow(factor, n.numer());
                let n = n.to_i64().unwrap_or_default();
                let raised = factors(g, x).into_iter().map(|(atom, power)| (atom, power * n));
                self.term(self.times(g.one(), &raised.collect()), factor)
            }
            Node::Power(a, n) => {
                let a = self.whole(&self.linear[&a].clone());
                self.term(g.power(a, n), Rational::one())
            }
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
            let factors = monomial
                .powers()
                .iter()
                .map(|&(atom, power)| self.g.powi(atom, power.into()));
            let product = factors.fold(self.g.one(), |product, factor| self.g.mul(product, factor));
            linear.insert(product, coefficient.clone());
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
    fn whole(&mut self, linear: &Linear) -> ExprId {
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

/// Factors of a product and their powers.
type Factors = BTreeMap<ExprId, i64>;

/// The factors of a product with whole powers.
fn factors(g: &Graph, id: ExprId) -> Factors {
    let mut factors = Factors::new();
    let mut stack = vec![id];
    while let Some(id) = stack.pop() {
        match g.node(id) {
            Node::Binary(Binary::Mul, a, b) => stack.extend([*a, *b]),
            Node::Power(base, power) if power.is_integer() => {
                *factors.entry(*base).or_default() += power.to_i64().unwrap_or_default();
            }
            _ if id == g.one() => {}
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

fn scaled(linear: &Linear, factor: &Rational) -> Linear {
    linear.iter().map(|(&atom, own)| (atom, own * factor)).collect()
}

fn add_scaled(sum: &mut Linear, other: &Linear, factor: &Rational) {
    for (&atom, own) in other {
        let entry = sum.entry(atom).or_insert_with(Rational::zero);
        *entry += own * factor;
        if entry.is_zero() {
            sum.remove(&atom);
        }
    }
}
