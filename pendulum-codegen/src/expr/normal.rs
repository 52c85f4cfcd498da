//! The normal form: a polynomial in which two expressions are equal exactly when they print the same.
//!
//! Angles are split by the addition theorems into sines and cosines of base angles, and `cos^2` becomes `1 - sin^2`, so
//! what is left are independent atoms. Roots obey `root(x)^k = x`. The form is canonical for polynomials in symbols, sines,
//! cosines and roots; a quotient by a sum, and functions that have no algebraic rule, stand as atoms.

use std::collections::HashMap;
use std::rc::Rc;

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Binary, ExprId, Graph, Monomial, Node, Poly, Rational, Unary, ratio};

/// The polynomial grew beyond the limit of its normaliser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge;

/// How many turns of a base angle are still split into powers of its sine and cosine.
const MOST_TURNS: i64 = 16;

/// Turns expressions of one graph into normal form, and remembers each.
#[derive(Debug)]
pub struct Normalizer {
    known: HashMap<ExprId, Rc<Poly>>,
    /// What each coordinate is, as a sum of base angles with integer factors.
    angles: HashMap<ExprId, Vec<(ExprId, Rational)>>,
    /// How many more products of terms may be formed.
    budget: usize,
}

impl Normalizer {
    /// A normaliser whose base angles are the coordinates themselves.
    pub fn new(budget: usize) -> Self {
        Self {
            known: HashMap::new(),
            angles: HashMap::new(),
            budget,
        }
    }

    /// A normaliser in which `angles` says what each coordinate is in base angles. Any unimodular choice gives a canonical
    /// form; the absolute angles of parallel joints give the shortest one.
    pub fn with_angles(budget: usize, angles: HashMap<ExprId, Vec<(ExprId, Rational)>>) -> Self {
        Self {
            angles,
            ..Self::new(budget)
        }
    }

    /// The normal form of `x`.
    pub fn normal(&mut self, graph: &Graph, x: ExprId) -> Result<Rc<Poly>, TooLarge> {
        if let Some(known) = self.known.get(&x) {
            return Ok(known.clone());
        }
        for id in graph.reachable(&[x]) {
            if !self.known.contains_key(&id) {
                let poly = self.node(graph, id)?;
                self.known.insert(id, Rc::new(poly));
            }
        }
        Ok(self.known[&x].clone())
    }

    /// Whether `x` is zero in value.
    pub fn is_zero(&mut self, graph: &Graph, x: ExprId) -> Result<bool, TooLarge> {
        Ok(self.normal(graph, x)?.is_empty())
    }

    fn node(&mut self, graph: &Graph, id: ExprId) -> Result<Poly, TooLarge> {
        let known = |this: &Self, x: ExprId| this.known[&x].clone();
        Ok(match graph.node(id).clone() {
            Node::Number(n) => Poly::constant(n),
            Node::Pi | Node::Symbol(_) => Poly::atom(id),
            Node::Unary(Unary::Neg, a) => known(self, a).scaled(&ratio(-1, 1)),
            Node::Unary(op @ (Unary::Sin | Unary::Cos), a) => {
                let (sine, cosine) = self.sine_and_cosine(graph, &known(self, a))?;
                if op == Unary::Sin { sine } else { cosine }
            }
            Node::Unary(op, a) => {
                let argument = self.to_expr(graph, &known(self, a));
                let atom = graph.unary(op, argument);
                self.leaf(graph, atom)?
            }
            Node::Binary(Binary::Add, a, b) => {
                let mut sum = (*known(self, a)).clone();
                sum.add_scaled(&known(self, b), &ratio(1, 1));
                sum
            }
            Node::Binary(Binary::Sub, a, b) => {
                let mut difference = (*known(self, a)).clone();
                difference.add_scaled(&known(self, b), &ratio(-1, 1));
                difference
            }
            Node::Binary(Binary::Mul, a, b) => self.product(graph, &known(self, a), &known(self, b))?,
            Node::Binary(Binary::Div, a, b) => {
                let reciprocal = self.reciprocal(graph, &known(self, b))?;
                self.product(graph, &known(self, a), &reciprocal)?
            }
            Node::Binary(op @ Binary::Atan2, a, b) => {
                let (a, b) = (
                    self.to_expr(graph, &known(self, a)),
                    self.to_expr(graph, &known(self, b)),
                );
                let atom = graph.binary(op, a, b);
                Poly::atom(atom)
            }
            Node::Power(a, exponent) => self.power(graph, &known(self, a), &exponent)?,
        })
    }

    /// An expression whose operands are normal already: an atom, unless it has folded to something simpler.
    fn leaf(&mut self, graph: &Graph, x: ExprId) -> Result<Poly, TooLarge> {
        match graph.node(x) {
            Node::Unary(Unary::Neg, y) => {
                let y = *y;
                Ok(self.leaf(graph, y)?.scaled(&ratio(-1, 1)))
            }
            Node::Number(n) => Ok(Poly::constant(n.clone())),
            Node::Power(base, exponent) if !exponent.is_integer() && !exponent.numer().is_one() => {
                let (base, exponent) = (Poly::atom(*base), exponent.clone());
                self.power(graph, &base, &exponent)
            }
            Node::Binary(Binary::Mul, a, b) => {
                let (a, b) = (*a, *b);
                let (a, b) = (self.leaf(graph, a)?, self.leaf(graph, b)?);
                self.product(graph, &a, &b)
            }
            _ => Ok(Poly::atom(x)),
        }
    }

    fn power(&mut self, graph: &Graph, base: &Poly, exponent: &Rational) -> Result<Poly, TooLarge> {
        let (n, k) = (exponent.numer().to_i64(), exponent.denom().to_i64());
        match (n, k) {
            (Some(n), Some(1)) if n.abs() <= 64 => {
                let base = if n < 0 {
                    self.reciprocal(graph, base)?
                } else {
                    base.clone()
                };
                let mut power = Poly::constant(Rational::one());
                for _ in 0..n.abs() {
                    power = self.product(graph, &power, &base)?;
                }
                Ok(power)
            }
            (Some(n), Some(k)) if n.abs() <= 64 => {
                let base = self.to_expr(graph, base);
                let root = graph.power(base, ratio(1, k));
                let root = self.leaf(graph, root)?;
                self.power(graph, &root, &ratio(n, 1))
            }
            _ => {
                let base = self.to_expr(graph, base);
                Ok(Poly::atom(graph.power(base, exponent.clone())))
            }
        }
    }

    fn reciprocal(&mut self, graph: &Graph, x: &Poly) -> Result<Poly, TooLarge> {
        if let Some((monomial, coefficient)) = x.as_term() {
            let mut reciprocal = Poly::default();
            self.add_reduced(graph, &mut reciprocal, monomial.recip(), coefficient.recip())?;
            return Ok(reciprocal);
        }
        let Some((_, leading)) = x.terms().next() else {
            // 1/0 is left for the value to show
            let zero = graph.zero();
            return Ok(Poly::term(Monomial::atom(zero).recip(), Rational::one()));
        };
        let leading = leading.recip();
        let sum = self.to_expr(graph, &x.scaled(&leading));
        Ok(Poly::term(Monomial::atom(sum).recip(), leading))
    }

    /// The product of two normal forms.
    pub fn product(&mut self, graph: &Graph, a: &Poly, b: &Poly) -> Result<Poly, TooLarge> {
        self.budget = self.budget.checked_sub(a.len() * b.len()).ok_or(TooLarge)?;
        let mut product = Poly::default();
        for (u, x) in a.terms() {
            for (v, y) in b.terms() {
                self.add_reduced(graph, &mut product, u.times(v), x * y)?;
            }
        }
        Ok(product)
    }

    /// Adds a term, after the rules `cos^2 = 1 - sin^2` and `root(x)^k = x`.
    fn add_reduced(
        &mut self,
        graph: &Graph,
        sum: &mut Poly,
        monomial: Monomial,
        coefficient: Rational,
    ) -> Result<(), TooLarge> {
        for &(atom, power) in monomial.powers() {
            let (excess, replacement) = match graph.node(atom) {
                Node::Unary(Unary::Cos, angle) if power >= 2 => {
                    let angle = *angle;
                    let sine = graph.unary(Unary::Sin, angle);
                    let mut square = Poly::constant(Rational::one());
                    square.add_term(Monomial::default().times_power(sine, 2), ratio(-1, 1));
                    (2, square)
                }
                Node::Power(base, root) if !root.is_integer() => {
                    let k = root.denom().to_i32().ok_or(TooLarge)?;
                    if (0..k).contains(&power) {
                        continue;
                    }
                    let base = *base;
                    let base = self.normal(graph, base)?;
                    if power < 0 {
                        (-k, self.reciprocal(graph, &base)?)
                    } else {
                        (k, (*base).clone())
                    }
                }
                _ => continue,
            };
            let rest = Poly::term(monomial.times_power(atom, -excess), coefficient);
            let reduced = self.product(graph, &rest, &replacement)?;
            sum.add_scaled(&reduced, &Rational::one());
            return Ok(());
        }
        sum.add_term(monomial, coefficient);
        Ok(())
    }

    /// Sine and cosine of an angle in normal form, by the addition theorems over base angles.
    fn sine_and_cosine(&mut self, graph: &Graph, angle: &Poly) -> Result<(Poly, Poly), TooLarge> {
        let mut turns: Vec<(ExprId, Rational)> = Vec::new();
        let mut rest = angle.clone();
        for (monomial, factor) in angle.terms() {
            let &[(symbol, 1)] = monomial.powers() else { continue };
            if !matches!(graph.as_symbol(symbol), Some(s) if matches!(s.kind, super::SymbolKind::Coordinate(_))) {
                continue;
            }
            rest.remove(monomial);
            let own = [(symbol, Rational::one())];
            for (base, share) in self.angles.get(&symbol).map_or(&own[..], |list| list) {
                match turns.iter_mut().find(|(known, _)| known == base) {
                    Some((_, sum)) => *sum += share * factor,
                    None => turns.push((*base, share * factor)),
                }
            }
        }
        let splits = turns
            .iter()
            .all(|(_, n)| n.is_integer() && n.abs() <= ratio(MOST_TURNS, 1));
        if !splits {
            (turns, rest) = (Vec::new(), angle.clone());
        }
        if !rest.is_empty() {
            let base = self.to_expr(graph, &rest);
            turns.push((base, Rational::one()));
        }
        turns.retain(|(_, n)| !n.is_zero());
        turns.sort();
        let (mut sine, mut cosine) = (Poly::default(), Poly::constant(Rational::one()));
        for (base, n) in turns {
            let (s, c) = (graph.unary(Unary::Sin, base), graph.unary(Unary::Cos, base));
            let s = self.leaf(graph, s)?.scaled(&n.signum());
            let c = self.leaf(graph, c)?;
            for _ in 0..n.abs().to_usize().ok_or(TooLarge)? {
                let mut next_sine = self.product(graph, &sine, &c)?;
                next_sine.add_scaled(&self.product(graph, &cosine, &s)?, &ratio(1, 1));
                let mut next_cosine = self.product(graph, &cosine, &c)?;
                next_cosine.add_scaled(&self.product(graph, &sine, &s)?, &ratio(-1, 1));
                (sine, cosine) = (next_sine, next_cosine);
            }
        }
        Ok((sine, cosine))
    }

    /// The expression of a polynomial: the same one for equal polynomials.
    pub fn to_expr(&self, graph: &Graph, poly: &Poly) -> ExprId {
        let mut sum = graph.zero();
        for (monomial, coefficient) in poly.terms() {
            let mut product = graph.number(coefficient.clone());
            for &(atom, power) in monomial.powers() {
                let factor = graph.powi(atom, power.into());
                product = graph.mul(product, factor);
            }
            sum = graph.add(sum, product);
        }
        sum
    }
}
