//! The normal form: a polynomial in which two expressions are equal exactly when they print the same.
//!
//! Angles are split by the addition theorems into sines and cosines of base angles, and `cos^2` becomes `1 - sin^2`, so
//! what is left are independent atoms. Roots obey `root(x)^k = x`. The form is canonical for polynomials in symbols,
//! sines, cosines and roots; a quotient by a sum, and functions that have no algebraic rule, stand as atoms.

use std::collections::BTreeMap;
use std::rc::Rc;

use num_traits::{One, Signed, ToPrimitive, Zero};
use rustc_hash::{FxHashMap, FxHashSet};

use super::{
    Binary, Expr, ExprId, Graph, Level, MOST_POWER, Monomial, Node, Poly, Rational, SymbolKind, Unary, is_short,
    multiply, ratio,
};

/// The polynomial grew beyond the limit of its normaliser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TooLarge;

/// How many turns of a base angle are still split into powers of its sine and cosine.
const MOST_TURNS: i64 = 16;

/// How many factors are copied for each product of terms, at most: long monomials and long sums take time as well.
const COPIES: usize = 64;

/// Constants of more terms are atoms. They are numbers in the end, and so are those of bodies that are fixed to others
/// in a row, which would grow without end.
const LONGEST_CONSTANT: usize = 12;

/// Values of parameters with more operations in one another are atoms: numbers in them grow with each.
const DEEPEST_CONSTANT: usize = 50;

/// The most terms of a constant of which a power is written out.
const LONGEST_BASE: usize = 3;

/// What each coordinate is, as a sum of base angles.
pub(crate) type BaseAngles<'g> = FxHashMap<Expr<'g>, Vec<(Expr<'g>, Rational)>>;

/// Turns expressions of one graph into normal form, and remembers each.
#[derive(Debug)]
pub(crate) struct Normalizer<'g> {
    graph: &'g Graph,
    known: FxHashMap<ExprId, Rc<Poly>>,
    angles: BaseAngles<'g>,
    /// What was found to be too large.
    too_large: FxHashSet<ExprId>,
    /// How many more products of terms may be formed.
    budget: usize,
    /// How many more factors of terms may be copied on the way.
    copies: usize,
}

impl<'g> Normalizer<'g> {
    /// A normaliser whose base angles are the coordinates themselves.
    pub(crate) fn new(graph: &'g Graph, budget: usize) -> Self {
        Self {
            graph,
            known: FxHashMap::default(),
            angles: FxHashMap::default(),
            too_large: FxHashSet::default(),
            budget,
            copies: COPIES * budget,
        }
    }

    /// A normaliser in which `angles` says what each coordinate is in base angles. Any unimodular choice gives a
    /// canonical form; the absolute angles of parallel joints give the shortest one.
    pub(crate) fn with_angles(graph: &'g Graph, budget: usize, angles: BaseAngles<'g>) -> Self {
        Self {
            angles,
            ..Self::new(graph, budget)
        }
    }

    /// The graph of the expressions.
    pub(crate) fn graph(&self) -> &'g Graph {
        self.graph
    }

    /// The normal form of `x`.
    pub(crate) fn normal(&mut self, x: Expr<'g>) -> Result<Rc<Poly>, TooLarge> {
        if let Some(known) = self.known.get(&x.id()) {
            return Ok(known.clone());
        }
        if self.too_large.contains(&x.id()) {
            return Err(TooLarge);
        }
        for id in self.graph.reachable(&[x]) {
            if self.known.contains_key(&id) {
                continue;
            }
            // what was too large once has not become smaller, nor has what is built of it
            let poly = match self.too_large.contains(&id) {
                true => Err(TooLarge),
                false if self.is_long_constant(id) => Ok(Poly::atom(id)),
                false => self.node(self.graph.expr(id)),
            };
            let poly = poly.inspect_err(|_| self.too_large.extend([id, x.id()]))?;
            self.known.insert(id, Rc::new(poly));
        }
        Ok(self.known[&x.id()].clone())
    }

    /// Whether `x` is zero in value.
    pub(crate) fn is_zero(&mut self, x: Expr<'g>) -> Result<bool, TooLarge> {
        Ok(self.normal(x)?.is_empty())
    }

    /// Whether a constant is a sum or a product of so many terms, or a value of parameters so deep, that nothing is
    /// gained by writing it out.
    fn is_long_constant(&self, id: ExprId) -> bool {
        let terms = |x: ExprId| self.known[&x].len();
        match self.graph.level(id) {
            Level::State => false,
            Level::Parameter => self.graph.depth(id) > DEEPEST_CONSTANT,
            Level::Constant => match *self.graph.node(id) {
                Node::Binary(Binary::Add | Binary::Sub, a, b) => terms(a) + terms(b) > LONGEST_CONSTANT,
                Node::Binary(Binary::Mul | Binary::Div, a, b) => terms(a) * terms(b) > LONGEST_CONSTANT,
                Node::Power(a, _) => terms(a) > LONGEST_BASE,
                _ => false,
            },
        }
    }

    fn node(&mut self, x: Expr<'g>) -> Result<Poly, TooLarge> {
        let known = |this: &Self, x: Expr<'g>| this.known[&x.id()].clone();
        Ok(match x.node() {
            Node::Number(n) => Poly::constant(n.clone()),
            Node::Pi | Node::Symbol(_) => Poly::atom(x),
            Node::Unary(Unary::Neg, a) => known(self, a).scaled(&ratio(-1, 1)),
            Node::Unary(op @ (Unary::Sin | Unary::Cos), a) => {
                let (sine, cosine) = self.sine_and_cosine(&known(self, a))?;
                if op == Unary::Sin { sine } else { cosine }
            }
            Node::Unary(op, a) => {
                let argument = self.written(&known(self, a))?;
                self.leaf(argument.apply(op))?
            }
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                let (a, b) = (known(self, a), known(self, b));
                self.copy(a.size() + b.size())?;
                let mut sum = (*a).clone();
                sum.add_scaled(&b, &ratio(if op == Binary::Add { 1 } else { -1 }, 1));
                sum
            }
            Node::Binary(Binary::Mul, a, b) => self.product(&known(self, a), &known(self, b))?,
            Node::Binary(Binary::Div, a, b) => {
                let reciprocal = self.reciprocal(&known(self, b))?;
                self.product(&known(self, a), &reciprocal)?
            }
            Node::Binary(op @ (Binary::Atan2 | Binary::Max | Binary::Min), a, b) => {
                let (a, b) = (self.written(&known(self, a))?, self.written(&known(self, b))?);
                self.leaf(a.combine(op, b))?
            }
            Node::Power(a, exponent) => self.power(&known(self, a), exponent)?,
        })
    }

    /// An expression whose operands are normal already: an atom, unless it has folded to something simpler.
    fn leaf(&mut self, x: Expr<'g>) -> Result<Poly, TooLarge> {
        match x.node() {
            Node::Unary(Unary::Neg, y) => Ok(self.leaf(y)?.scaled(&ratio(-1, 1))),
            Node::Number(n) => Ok(Poly::constant(n.clone())),
            Node::Power(base, exponent) if !exponent.is_integer() && !exponent.numer().is_one() => {
                self.power(&Poly::atom(base), exponent)
            }
            Node::Binary(Binary::Mul, a, b) => {
                let (a, b) = (self.leaf(a)?, self.leaf(b)?);
                self.product(&a, &b)
            }
            _ => Ok(Poly::atom(x)),
        }
    }

    fn power(&mut self, base: &Poly, exponent: &Rational) -> Result<Poly, TooLarge> {
        let (n, k) = (exponent.numer().to_i64(), exponent.denom().to_i64());
        match (n, k) {
            (Some(n), Some(1)) if n.abs() <= MOST_POWER => {
                let base = if n < 0 { self.reciprocal(base)? } else { base.clone() };
                let mut power = Poly::constant(Rational::one());
                for _ in 0..n.abs() {
                    power = self.product(&power, &base)?;
                }
                Ok(power)
            }
            (Some(n), Some(k)) if n.abs() <= MOST_POWER => {
                let root = self.written(base)?.power(ratio(1, k));
                let root = self.leaf(root)?;
                self.power(&root, &ratio(n, 1))
            }
            _ => Ok(Poly::atom(self.written(base)?.power(exponent.clone()))),
        }
    }

    fn reciprocal(&mut self, x: &Poly) -> Result<Poly, TooLarge> {
        if let Some((monomial, coefficient)) = x.as_term() {
            let mut reciprocal = Poly::default();
            self.add_reduced(&mut reciprocal, monomial.recip(), coefficient.recip())?;
            return Ok(reciprocal);
        }
        let Some((_, leading)) = x.terms().next() else {
            // 1/0 is left for the value to show
            return Ok(Poly::term(Monomial::atom(self.graph.zero()).recip(), Rational::one()));
        };
        let leading = leading.recip();
        let sum = self.written(&x.scaled(&leading))?;
        Ok(Poly::term(Monomial::atom(sum).recip(), leading))
    }

    fn copy(&mut self, factors: usize) -> Result<(), TooLarge> {
        self.copies = self.copies.checked_sub(factors).ok_or(TooLarge)?;
        Ok(())
    }

    /// The product of two normal forms.
    pub(crate) fn product(&mut self, a: &Poly, b: &Poly) -> Result<Poly, TooLarge> {
        self.budget = self.budget.checked_sub(a.len() * b.len()).ok_or(TooLarge)?;
        self.copy(a.size() * b.len() + a.len() * b.size())?;
        let mut product = Poly::default();
        for (u, x) in a.terms() {
            for (v, y) in b.terms() {
                self.add_reduced(&mut product, u.times(v), multiply(x, y))?;
            }
        }
        Ok(product)
    }

    /// Adds a term, after the rules `cos^2 = 1 - sin^2` and `root(x)^k = x`.
    fn add_reduced(&mut self, sum: &mut Poly, monomial: Monomial, coefficient: Rational) -> Result<(), TooLarge> {
        if !is_short(&coefficient) {
            return Err(TooLarge);
        }
        for &(atom, power) in monomial.powers() {
            if i64::from(power.abs()) > MOST_POWER {
                return Err(TooLarge);
            }
            let (excess, replacement) = match self.graph.expr(atom).node() {
                Node::Unary(Unary::Cos, angle) if power >= 2 => {
                    let mut square = Poly::constant(Rational::one());
                    square.add_term(Monomial::default().times_power(angle.sin(), 2), ratio(-1, 1));
                    (2, square)
                }
                Node::Power(base, root) if !root.is_integer() => {
                    let k = root.denom().to_i32().ok_or(TooLarge)?;
                    if (0..k).contains(&power) {
                        continue;
                    }
                    let base = self.normal(base)?;
                    if power < 0 {
                        (-k, self.reciprocal(&base)?)
                    } else {
                        (k, (*base).clone())
                    }
                }
                _ => continue,
            };
            let rest = Poly::term(monomial.times_power(atom, -excess), coefficient);
            let reduced = self.product(&rest, &replacement)?;
            sum.add_scaled(&reduced, &Rational::one());
            return Ok(());
        }
        sum.add_term(monomial, coefficient);
        Ok(())
    }

    /// Sine and cosine of an angle in normal form, by the addition theorems over base angles.
    fn sine_and_cosine(&mut self, angle: &Poly) -> Result<(Poly, Poly), TooLarge> {
        let mut turns: Vec<(Expr<'g>, Rational)> = Vec::new();
        let mut rest = angle.clone();
        for (monomial, factor) in angle.terms() {
            let &[(symbol, 1)] = monomial.powers() else { continue };
            let symbol = self.graph.expr(symbol);
            if !matches!(symbol.as_symbol(), Some(s) if matches!(s.kind, SymbolKind::Coordinate(_))) {
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
        // a part of a turn stands for itself
        let splits = |n: &Rational| n.is_integer() && n.abs() <= ratio(MOST_TURNS, 1);
        for (base, n) in turns.extract_if(.., |(_, n)| !splits(n)) {
            rest.add_scaled(&*self.normal(base)?, &n);
        }
        if !rest.is_empty() {
            turns.push((self.written(&rest)?, Rational::one()));
        }
        turns.retain(|(_, n)| !n.is_zero());
        turns.sort();
        let (mut sine, mut cosine) = (Poly::default(), Poly::constant(Rational::one()));
        for (base, n) in turns {
            let (s, c) = (base.sin(), base.cos());
            let s = self.leaf(s)?.scaled(&n.signum());
            let c = self.leaf(c)?;
            for _ in 0..n.abs().to_usize().ok_or(TooLarge)? {
                let mut next_sine = self.product(&sine, &c)?;
                next_sine.add_scaled(&self.product(&cosine, &s)?, &ratio(1, 1));
                let mut next_cosine = self.product(&cosine, &c)?;
                next_cosine.add_scaled(&self.product(&sine, &s)?, &ratio(-1, 1));
                (sine, cosine) = (next_sine, next_cosine);
            }
        }
        Ok((sine, cosine))
    }

    /// The expression of a polynomial within another.
    fn written(&mut self, poly: &Poly) -> Result<Expr<'g>, TooLarge> {
        /// How many factors are copied in the time in which a node is found in the graph.
        const NODE: usize = 16;
        self.copy(NODE * poly.size())?;
        Ok(self.to_expr(poly))
    }

    /// The expression of a polynomial: the same one for equal polynomials.
    pub(crate) fn to_expr(&self, poly: &Poly) -> Expr<'g> {
        let mut sum = self.graph.zero();
        for (monomial, coefficient) in poly.terms() {
            let mut product = self.graph.number(coefficient.clone());
            for &(atom, power) in monomial.powers() {
                product = product * self.graph.expr(atom).powi(power.into());
            }
            sum += product;
        }
        sum
    }

    /// What is multiplied by each product of the atoms for which `of` holds.
    pub(crate) fn split(&self, poly: &Poly, of: impl Fn(Expr<'g>) -> bool) -> BTreeMap<Monomial, Poly> {
        let mut parts: BTreeMap<Monomial, Poly> = BTreeMap::new();
        for (monomial, coefficient) in poly.terms() {
            let (key, rest) = monomial.partition(|atom| of(self.graph.expr(atom)));
            parts.entry(key).or_default().add_term(rest, coefficient.clone());
        }
        parts
    }
}
