//! Normal form: a polynomial that prints the same for two expressions exactly when they are equal.
//!
//! Angles are split by the addition theorems into sines and cosines of base angles, and `cos^2` becomes `1 - sin^2`, so
//! that the remaining atoms are independent. Roots obey `root(x)^k = x`. The form is canonical for polynomials in
//! symbols, sines, cosines and roots; a quotient by a sum, and functions without an algebraic rule, are atoms.

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

/// Largest multiple of a base angle that is split into powers of its sine and cosine.
const MOST_TURNS: i64 = 16;

/// Number of factors that may be copied for each product of terms in the budget: long monomials and long sums take time
/// as well.
const COPIES: usize = 64;

/// Maximum number of terms of a constant that is written out. Longer constants are atoms: they are numbers in the end,
/// and the constants of bodies fixed to one another in a row would grow without bound.
const LONGEST_CONSTANT: usize = 12;

/// Maximum nesting depth of values of parameters that are written out. Deeper ones are atoms, since the numbers in them
/// grow with each operation.
const DEEPEST_CONSTANT: usize = 50;

/// Maximum number of terms of a constant whose power is written out.
const LONGEST_BASE: usize = 3;

/// Each coordinate as a sum of base angles.
pub(crate) type BaseAngles<'g> = FxHashMap<Expr<'g>, Vec<(Expr<'g>, Rational)>>;

/// Brings expressions of one graph into normal form, and caches the results.
#[derive(Debug)]
pub(crate) struct Normalizer<'g> {
    graph: &'g Graph,
    known: FxHashMap<ExprId, Rc<Poly>>,
    angles: BaseAngles<'g>,
    /// Expressions found to be too large.
    too_large: FxHashSet<ExprId>,
    /// Number of products of terms that may still be formed.
    budget: usize,
    /// Number of factors of terms that may still be copied.
    copies: usize,
}

impl<'g> Normalizer<'g> {
    /// Creates a normaliser with the coordinates themselves as base angles.
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

    /// Creates a normaliser with each coordinate given as a sum of base angles. Any unimodular choice gives a canonical
    /// form; the absolute angles of parallel joints give the shortest one.
    pub(crate) fn with_angles(graph: &'g Graph, budget: usize, angles: BaseAngles<'g>) -> Self {
        Self {
            angles,
            ..Self::new(graph, budget)
        }
    }

    /// Graph of the expressions.
    pub(crate) fn graph(&self) -> &'g Graph {
        self.graph
    }

    /// Normal form of `x`.
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
            // an expression that was too large stays too large, and so does every expression built of it
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

    /// True if `x` is zero in value.
    pub(crate) fn is_zero(&mut self, x: Expr<'g>) -> Result<bool, TooLarge> {
        Ok(self.normal(x)?.is_empty())
    }

    /// True if writing out a constant gains nothing: a sum or product with too many terms, or a value of parameters
    /// nested too deeply.
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

    /// Polynomial of an expression with operands in normal form: an atom, unless it has folded to something simpler.
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
            // 1/0 is kept, and shows as a non-finite value
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

    /// Product of two normal forms.
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

    /// Adds a term, reduced by the rules `cos^2 = 1 - sin^2` and `root(x)^k = x`.
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
        // fractions and large multiples of a base angle are not split
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

    /// Expression of a polynomial within another, charged to the copies.
    fn written(&mut self, poly: &Poly) -> Result<Expr<'g>, TooLarge> {
        /// Cost of finding a node in the graph, in copied factors.
        const NODE: usize = 16;
        self.copy(NODE * poly.size())?;
        Ok(self.to_expr(poly))
    }

    /// Expression of a polynomial; equal polynomials give the same expression.
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

    /// Coefficient of each product of the atoms for which `of` holds.
    pub(crate) fn split(&self, poly: &Poly, of: impl Fn(Expr<'g>) -> bool) -> BTreeMap<Monomial, Poly> {
        let mut parts: BTreeMap<Monomial, Poly> = BTreeMap::new();
        for (monomial, coefficient) in poly.terms() {
            let (key, rest) = monomial.partition(|atom| of(self.graph.expr(atom)));
            parts.entry(key).or_default().add_term(rest, coefficient.clone());
        }
        parts
    }
}
