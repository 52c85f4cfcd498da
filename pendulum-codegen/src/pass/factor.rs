//! Converts polynomials to short expressions: collects coefficients of parameters into one constant each, then extracts
//! common factors.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Signed};

use crate::expr::{Expr, Graph, Level, Monomial, Normalizer, Poly, Rational};

/// A product with a sign; factors may repeat.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Term<'g> {
    negative: bool,
    factors: Vec<Expr<'g>>,
}

/// Form of sums of products.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Products {
    /// Common factors extracted, state factors first.
    Factored,
    /// Unchanged.
    Expanded,
}

impl Products {
    /// Both forms.
    pub(crate) const ALL: [Self; 2] = [Self::Factored, Self::Expanded];
}

/// Returns the terms of a polynomial, one for each product of state quantities. Its coefficient becomes one constant,
/// up to a rational factor, so that equal combinations of parameters are the same constant everywhere.
pub(crate) fn terms<'g>(normalizer: &Normalizer<'g>, poly: &Poly) -> Vec<Term<'g>> {
    let g = normalizer.graph();
    normalizer
        .split(poly, |atom| atom.level() == Level::State)
        .into_iter()
        .map(|(state, coefficient)| {
            let content = content(&coefficient);
            let constant = normalizer.to_expr(&coefficient.scaled(&content.recip()));
            let number = g.number(content.abs());
            let mut factors: Vec<Expr<'g>> = [number, constant]
                .into_iter()
                .filter(|factor| !factor.is_one())
                .collect();
            for &(atom, power) in state.powers() {
                let atom = g.expr(atom);
                let factor = if power < 0 { atom.powi(-1) } else { atom };
                factors.extend(std::iter::repeat_n(factor, power.unsigned_abs() as usize));
            }
            Term {
                negative: content.is_negative(),
                factors,
            }
        })
        .collect()
}

/// Number to extract from a sum: its sign, times the greatest common divisor of its coefficients unless one of them is
/// already 1 or -1.
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

/// Converts terms to a polynomial; constants become atoms.
pub(crate) fn polynomial(terms: &[Term<'_>]) -> Poly {
    let mut poly = Poly::default();
    for term in terms {
        let mut coefficient = if term.negative {
            -Rational::one()
        } else {
            Rational::one()
        };
        let mut monomial = Monomial::default();
        for &factor in &term.factors {
            match factor.as_number() {
                Some(number) => coefficient *= number,
                None => monomial = monomial.times(&Monomial::atom(factor)),
            }
        }
        poly.add_term(monomial, coefficient);
    }
    poly
}

/// Converts terms to an expression.
pub(crate) fn factor<'g>(g: &'g Graph, terms: &[Term<'g>], products: Products) -> Expr<'g> {
    let common = match products {
        Products::Factored if terms.len() > 1 => most_frequent(terms),
        _ => None,
    };
    let Some(common) = common else {
        return terms.iter().fold(g.zero(), |sum, term| {
            let product = term.factors.iter().fold(g.one(), |product, &factor| product * factor);
            if term.negative { sum - product } else { sum + product }
        });
    };
    let (with, without): (Vec<Term<'g>>, Vec<Term<'g>>) =
        terms.iter().cloned().partition(|term| term.factors.contains(&common));
    let reduced: Vec<Term<'g>> = with
        .into_iter()
        .map(|mut term| {
            let at = term.factors.iter().position(|&factor| factor == common);
            at.map(|at| term.factors.remove(at));
            term
        })
        .collect();
    let inside = factor(g, &reduced, products);
    let rest = factor(g, &without, products);
    common * inside + rest
}

/// Returns the most frequent factor, if it occurs in at least two terms; a factor of the state wins a tie. Terms
/// without state cost nothing and are not counted.
fn most_frequent<'g>(terms: &[Term<'g>]) -> Option<Expr<'g>> {
    let mut counts: BTreeMap<Expr<'g>, usize> = BTreeMap::new();
    for term in terms {
        if term.factors.iter().all(|factor| factor.level() != Level::State) {
            continue;
        }
        let mut distinct = term.factors.clone();
        distinct.sort_unstable();
        distinct.dedup();
        for factor in distinct {
            *counts.entry(factor).or_default() += 1;
        }
    }
    let is_of_state = |factor: Expr<'g>| factor.level() == Level::State;
    let best = counts
        .into_iter()
        .max_by_key(|&(factor, count)| (count, is_of_state(factor), std::cmp::Reverse(factor)));
    best.filter(|&(_, count)| count >= 2).map(|(factor, _)| factor)
}
