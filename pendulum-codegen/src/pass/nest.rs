//! Sums written with the sums that they contain.
//!
//! Recursions over the links of a chain add a little to a sum from link to link. Where the little things cancel each other, or come
//! in another order, the chain of sums no longer shows. Here every sum becomes a list of its terms, like terms together, and then the
//! longest sum that is contained in it, and the rest.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::expr::{Binary, Expr, Graph, Level, Node, Normalizer, Rational, Unary};

/// What constants may take to be brought into normal form.
const BUDGET: usize = 100_000;

/// Terms with their factors: the number 1 stands for a term that is a number.
type Linear<'g> = BTreeMap<Expr<'g>, Rational>;

/// The roots, in which each sum is written with the longest sum that it contains.
pub fn nest<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let mut flat = Flat {
        g,
        normalizer: Normalizer::new(g, BUDGET),
        linear: HashMap::new(),
        sums: HashMap::new(),
    };
    for id in g.reachable(roots).into_iter().map(|id| g.expr(id)) {
        let linear = flat.take_apart(id);
        flat.linear.insert(id, linear);
    }
    let flat_roots: Vec<Expr<'g>> = roots
        .iter()
        .map(|root| flat.whole(&flat.linear[root].clone()))
        .collect();
    let mut sums: Vec<Linear<'g>> = {
        let needed: BTreeSet<Expr<'g>> = g.reachable(&flat_roots).into_iter().map(|id| g.expr(id)).collect();
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
    normalizer: Normalizer<'g>,
    /// The terms of each expression of the original.
    linear: HashMap<Expr<'g>, Linear<'g>>,
    /// The terms of each flat sum.
    sums: HashMap<Expr<'g>, Linear<'g>>,
}

impl<'g> Flat<'g> {
    /// The terms of an expression, whose operands have been taken apart.
    fn take_apart(&mut self, x: Expr<'g>) -> Linear<'g> {
        let g = self.g;
        if x.level() < Level::State {
            return self.constant(x);
        }
        match x.node() {
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
                let [a, b] = [a, b].map(|x| self.whole(&self.linear[&x].clone()));
                self.term(a.combine(op, b), Rational::one())
            }
            Node::Unary(op, a) => {
                let a = self.whole(&self.linear[&a].clone());
                self.term(a.apply(op), Rational::one())
            }
            Node::Power(a, n) if n.is_integer() => {
                let (factor, x) = self.one_term(a);
                let factor = num_traits::Pow::pow(factor, n.numer());
                let n = n.to_i64().unwrap_or_default();
                let raised = factors(x).into_iter().map(|(atom, power)| (atom, power * n));
                self.term(self.times(g.one(), &raised.collect()), factor)
            }
            Node::Power(a, n) => {
                let a = self.whole(&self.linear[&a].clone());
                self.term(a.power(n.clone()), Rational::one())
            }
            Node::Number(_) | Node::Pi | Node::Symbol(_) => self.term(x, Rational::one()),
        }
    }

    /// The terms of a constant: those of its normal form.
    fn constant(&mut self, x: Expr<'g>) -> Linear<'g> {
        let Ok(normal) = self.normalizer.normal(x) else {
            return self.term(x, Rational::one());
        };
        let mut linear = Linear::new();
        for (monomial, coefficient) in normal.terms() {
            let factors = monomial
                .powers()
                .iter()
                .map(|&(atom, power)| self.g.expr(atom).powi(power.into()));
            let product = factors.fold(self.g.one(), std::ops::Mul::mul);
            linear.insert(product, coefficient.clone());
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
        let mut merged = factors(x);
        for (atom, power) in factors(y) {
            *merged.entry(atom).or_default() += power;
        }
        self.term(self.times(self.g.one(), &merged), p * q)
    }

    /// An expression as a number times another.
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

    /// A number times an expression, which may have been simplified to a number or to its opposite.
    fn term(&self, id: Expr<'g>, factor: Rational) -> Linear<'g> {
        let (g, mut linear) = (self.g, Linear::new());
        match id.node() {
            Node::Number(n) => _ = linear.insert(g.one(), n * factor),
            Node::Unary(Unary::Neg, a) => return self.term(a, -factor),
            Node::Binary(Binary::Mul, a, b) => match a.as_number() {
                Some(n) => return self.term(b, n * factor),
                None => _ = linear.insert(id, factor),
            },
            _ => _ = linear.insert(id, factor),
        }
        linear.retain(|_, factor| !factor.is_zero());
        linear
    }

    /// The sum of terms.
    fn whole(&mut self, linear: &Linear<'g>) -> Expr<'g> {
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

/// Flat expressions on their way to nested ones.
struct Nested<'g> {
    flat: Flat<'g>,
    /// The sums, the longest first.
    sums: Vec<Linear<'g>>,
    built: HashMap<Expr<'g>, Expr<'g>>,
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

/// Factors of a product and their powers.
type Factors<'g> = BTreeMap<Expr<'g>, i64>;

/// The factors of a product with whole powers.
fn factors(x: Expr<'_>) -> Factors<'_> {
    let mut factors = Factors::new();
    let mut stack = vec![x];
    while let Some(x) = stack.pop() {
        match x.node() {
            Node::Binary(Binary::Mul, a, b) => stack.extend([a, b]),
            Node::Power(base, power) if power.is_integer() => {
                *factors.entry(base).or_default() += power.to_i64().unwrap_or_default();
            }
            _ if x.is_one() => {}
            _ => *factors.entry(x).or_default() += 1,
        }
    }
    factors
}

/// The factors that all terms share.
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

/// The sign with which all terms of one sum stand in another. Of terms that do not vary, it is enough that both have some: they are
/// easily mended.
fn contained(part: &Linear<'_>, whole: &Linear<'_>) -> Option<Rational> {
    let varies = |atom: &Expr<'_>| atom.level() == Level::State;
    let fixed = |linear: &Linear<'_>| linear.keys().any(|atom| !varies(atom));
    let mut varying = part.iter().filter(|(atom, _)| varies(atom)).peekable();
    let (first, factor) = varying.peek()?;
    let ratio = whole.get(first)? / *factor;
    let agrees = |(atom, factor): (&Expr<'_>, &Rational)| whole.get(atom).is_some_and(|own| *own == factor * &ratio);
    let count = varying.clone().count();
    (ratio.abs().is_one() && count > 1 && (!fixed(part) || fixed(whole)) && varying.all(agrees)).then_some(ratio)
}

fn scaled<'g>(linear: &Linear<'g>, factor: &Rational) -> Linear<'g> {
    linear.iter().map(|(&atom, own)| (atom, own * factor)).collect()
}

fn add_scaled<'g>(sum: &mut Linear<'g>, other: &Linear<'g>, factor: &Rational) {
    for (&atom, own) in other {
        let entry = sum.entry(atom).or_insert_with(Rational::zero);
        *entry += own * factor;
        if entry.is_zero() {
            sum.remove(&atom);
        }
    }
}
