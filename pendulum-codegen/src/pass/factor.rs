//! Polynomials to short expressions: coefficients of parameters as one constant each, then common factors drawn out.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Signed};

use crate::expr::{ExprId, Graph, Level, Monomial, Normalizer, Poly, Rational};

/// A product with a sign: factors may repeat.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Term {
    negative: bool,
    factors: Vec<ExprId>,
}

/// Which common factor is drawn out first, where several stand in equally many terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preference {
    /// Factors of the state.
    State,
    /// Constants.
    Parameter,
    /// None: products stay expanded.
    Expanded,
}

impl Preference {
    /// Every preference.
    pub const ALL: [Self; 3] = [Self::State, Self::Parameter, Self::Expanded];
}

/// The terms of a polynomial, one for each product of state quantities. What multiplies it becomes one constant, up to a
/// rational factor, so that equal combinations of parameters are the same constant everywhere.
pub(crate) fn terms(g: &Graph, normalizer: &Normalizer, poly: &Poly) -> Vec<Term> {
    let mut by_state: BTreeMap<Monomial, Poly> = BTreeMap::new();
    for (monomial, coefficient) in poly.terms() {
        let (state, parameters) = monomial.partition(|atom| g.level(atom) == Level::State);
        by_state
            .entry(state)
            .or_default()
            .add_term(parameters, coefficient.clone());
    }
    by_state
        .into_iter()
        .map(|(state, coefficient)| {
            let content = content(&coefficient);
            let constant = normalizer.to_expr(g, &coefficient.scaled(&content.recip()));
            let number = g.number(content.abs());
            let mut factors: Vec<ExprId> = [number, constant]
                .into_iter()
                .filter(|&factor| factor != g.one())
                .collect();
            for &(atom, power) in state.powers() {
                let factor = if power < 0 { g.powi(atom, -1) } else { atom };
                factors.extend(std::iter::repeat_n(factor, power.unsigned_abs() as usize));
            }
            Term {
                negative: content.is_negative(),
                factors,
            }
        })
        .collect()
}

/// The number to draw out of a sum: its sign, and the common factor of its coefficients unless one of them is 1 already.
fn content(poly: &Poly) -> Rational {
    let coefficients = || poly.terms().map(|(_, coefficient)| coefficient);
    let negative = coefficients().next().is_some_and(Signed::is_negative);
    let content = if coefficients().any(|coefficient| coefficient.abs().is_one()) {
        Rational::one()
    } else {
        let numerator = coefficients().fold(num_bigint::BigInt::ZERO, |gcd, c| gcd.gcd(c.numer()));
        let denominator = coefficients().fold(num_bigint::BigInt::one(), |lcm, c| lcm.lcm(c.denom()));
        Rational::new(numerator, denominator)
    };
    if negative { -content } else { content }
}

/// The polynomial of terms, in which constants are atoms.
pub(crate) fn polynomial(g: &Graph, terms: &[Term]) -> Poly {
    let mut poly = Poly::default();
    for term in terms {
        let mut coefficient = if term.negative {
            -Rational::one()
        } else {
            Rational::one()
        };
        let mut monomial = Monomial::default();
        for &factor in &term.factors {
            match g.as_number(factor) {
                Some(number) => coefficient *= number,
                None => monomial = monomial.times(&Monomial::atom(factor)),
            }
        }
        poly.add_term(monomial, coefficient);
    }
    poly
}

/// The expression of terms, with the most frequent factors drawn out.
pub(crate) fn factor(g: &Graph, terms: &[Term], preference: Preference) -> ExprId {
    let common = match preference {
        Preference::Expanded => None,
        _ if terms.len() < 2 => None,
        _ => most_frequent(g, terms, preference),
    };
    let Some(common) = common else {
        return terms.iter().fold(g.zero(), |sum, term| {
            let product = term
                .factors
                .iter()
                .fold(g.one(), |product, &factor| g.mul(product, factor));
            if term.negative {
                g.sub(sum, product)
            } else {
                g.add(sum, product)
            }
        });
    };
    let (with, without): (Vec<Term>, Vec<Term>) =
        terms.iter().cloned().partition(|term| term.factors.contains(&common));
    let reduced: Vec<Term> = with
        .into_iter()
        .map(|mut term| {
            let at = term.factors.iter().position(|&factor| factor == common);
            at.map(|at| term.factors.remove(at));
            term
        })
        .collect();
    let inside = factor(g, &reduced, preference);
    let rest = factor(g, &without, preference);
    let product = g.mul(common, inside);
    g.add(product, rest)
}

/// The factor that stands in most terms, if it stands in two or more. Terms without state cost nothing, so they do not count.
fn most_frequent(g: &Graph, terms: &[Term], preference: Preference) -> Option<ExprId> {
    let mut counts: BTreeMap<ExprId, usize> = BTreeMap::new();
    for term in terms {
        if term.factors.iter().all(|&factor| g.level(factor) != Level::State) {
            continue;
        }
        let mut distinct = term.factors.clone();
        distinct.sort_unstable();
        distinct.dedup();
        for factor in distinct {
            *counts.entry(factor).or_default() += 1;
        }
    }
    let preferred = |factor: ExprId| (g.level(factor) == Level::State) == (preference == Preference::State);
    let best = counts
        .into_iter()
        .max_by_key(|&(factor, count)| (count, preferred(factor), std::cmp::Reverse(factor)));
    best.filter(|&(_, count)| count >= 2).map(|(factor, _)| factor)
}
