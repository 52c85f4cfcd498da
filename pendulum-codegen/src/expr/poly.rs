//! Polynomials with rational coefficients over atoms of a graph.

use std::collections::BTreeMap;

use num_traits::{One, Zero};

use super::{ExprId, Rational, add, multiply};

/// A product of integer powers of atoms, sorted by atom; no power is zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Monomial(Vec<(ExprId, i32)>);

impl Monomial {
    /// A single atom.
    pub(crate) fn atom(atom: impl Into<ExprId>) -> Self {
        Self(vec![(atom.into(), 1)])
    }

    /// The atoms and their powers, sorted by atom.
    pub(crate) fn powers(&self) -> &[(ExprId, i32)] {
        &self.0
    }

    /// The power of one atom.
    pub(crate) fn power_of(&self, atom: impl Into<ExprId>) -> i32 {
        let atom = atom.into();
        self.0.binary_search_by_key(&atom, |p| p.0).map_or(0, |at| self.0[at].1)
    }

    /// The product of two monomials.
    #[must_use]
    pub(crate) fn times(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.0.iter().copied().peekable(), other.0.iter().copied().peekable());
        let mut product = Vec::with_capacity(self.0.len() + other.0.len());
        loop {
            match (a.peek(), b.peek()) {
                (Some(x), Some(y)) if x.0 == y.0 => {
                    if x.1 + y.1 != 0 {
                        product.push((x.0, x.1 + y.1));
                    }
                    a.next();
                    b.next();
                }
                (Some(x), Some(y)) if x.0 < y.0 => product.extend(a.next()),
                (_, Some(_)) => product.extend(b.next()),
                (Some(_), None) => product.extend(a.next()),
                (None, None) => return Self(product),
            }
        }
    }

    /// The product with an integer power of one atom.
    #[must_use]
    pub(crate) fn times_power(&self, atom: impl Into<ExprId>, power: i32) -> Self {
        if power == 0 {
            self.clone()
        } else {
            self.times(&Self(vec![(atom.into(), power)]))
        }
    }

    /// The reciprocal.
    #[must_use]
    pub(crate) fn recip(&self) -> Self {
        Self(self.0.iter().map(|&(atom, power)| (atom, -power)).collect())
    }

    /// Splits off the factors for which `keep` holds. Returns them, and the others.
    pub(crate) fn partition(&self, mut keep: impl FnMut(ExprId) -> bool) -> (Self, Self) {
        let (yes, no) = self.0.iter().partition(|(atom, _)| keep(*atom));
        (Self(yes), Self(no))
    }
}

/// A sum of monomials with rational coefficients; no coefficient is zero.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Poly(BTreeMap<Monomial, Rational>);

impl Poly {
    /// The constant polynomial.
    pub(crate) fn constant(value: Rational) -> Self {
        Self::term(Monomial::default(), value)
    }

    /// A single atom.
    pub(crate) fn atom(atom: impl Into<ExprId>) -> Self {
        Self::term(Monomial::atom(atom), Rational::one())
    }

    /// A single term.
    pub(crate) fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let mut poly = Self::default();
        poly.add_term(monomial, coefficient);
        poly
    }

    /// The terms, sorted by monomial.
    pub(crate) fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    /// The number of terms.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Number of terms and of their factors together.
    pub(crate) fn size(&self) -> usize {
        self.0.keys().map(|monomial| 1 + monomial.0.len()).sum()
    }

    /// True if there are no terms, so that the value is zero.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The coefficient of a monomial.
    pub(crate) fn coefficient(&self, monomial: &Monomial) -> Option<&Rational> {
        self.0.get(monomial)
    }

    /// Returns the term, if there is exactly one.
    pub(crate) fn as_term(&self) -> Option<(&Monomial, &Rational)> {
        if self.0.len() == 1 { self.0.iter().next() } else { None }
    }

    /// Adds one term in place.
    pub(crate) fn add_term(&mut self, monomial: Monomial, coefficient: Rational) {
        use std::collections::btree_map::Entry;
        if coefficient.is_zero() {
            return;
        }
        match self.0.entry(monomial) {
            Entry::Vacant(free) => {
                free.insert(coefficient);
            }
            Entry::Occupied(mut sum) => {
                *sum.get_mut() = add(sum.get(), &coefficient);
                if sum.get().is_zero() {
                    sum.remove();
                }
            }
        }
    }

    /// Removes a term and returns its coefficient.
    pub(crate) fn remove(&mut self, monomial: &Monomial) -> Option<Rational> {
        self.0.remove(monomial)
    }

    /// Adds `factor * other` in place.
    pub(crate) fn add_scaled(&mut self, other: &Self, factor: &Rational) {
        for (monomial, coefficient) in &other.0 {
            self.add_term(monomial.clone(), multiply(coefficient, factor));
        }
    }

    /// The product with a number.
    #[must_use]
    pub(crate) fn scaled(&self, factor: &Rational) -> Self {
        let mut scaled = Self::default();
        scaled.add_scaled(self, factor);
        scaled
    }
}
