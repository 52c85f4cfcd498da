//! Two accelerations whose digits do not cancel: what cancels does so in symbols, before any number is known.
//!
//! Where one body is much heavier than another, the rows of the mass matrix are nearly multiples of each other, and so are the
//! weights on a straight chain. In `a11 r0 - a01 r1`, the determinant times the first acceleration, the largest products then
//! cancel, and leave their rounding.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::One;

use crate::dynamics::Dynamics;
use crate::expr::{ExprId, Graph, Level, Monomial, Node, Normalizer, Poly, Rational, TooLarge, Unary, ratio};
use crate::pass::factor::{Preference, Term, factor, terms};
use crate::pass::{collect, collect_squares_first};

/// The residual of two coordinates, in what cancels when the second is eliminated and what does not.
#[derive(Debug)]
pub(super) struct Eliminated {
    /// What is left of `(a11 r0 - a01 r1) / a11` for the terms that cancel.
    left: Vec<Term>,
    /// The terms of `r1` among those.
    gone: Vec<Term>,
    /// The other terms of `r0` and of `r1`.
    others: [Vec<Term>; 2],
}

impl Eliminated {
    /// Eliminates the second of two coordinates, whose own inertia is constant; none if it is not, or if they are not coupled.
    pub(super) fn new(g: &Graph, normalizer: &mut Normalizer, dynamics: &Dynamics) -> Result<Option<Self>, TooLarge> {
        let ([_, row], &[first, last]) = (&dynamics.mass_matrix[..], &dynamics.residual[..]) else {
            return Ok(None);
        };
        // sums of angles hide some cancellations, and base angles make longer products of what does not cancel
        let mut base = Vec::new();
        for x in [row[1], row[0], first, last] {
            base.push((*normalizer.normal(g, x)?).clone());
        }
        let sums: Vec<Poly> = base
            .iter()
            .map(|poly| collect(g, normalizer, poly))
            .collect::<Result<_, _>>()?;
        let own = normalizer.to_expr(g, &base[0]);
        if g.level(own) == Level::State || g.is_zero(row[0]) {
            return Ok(None);
        }
        let [mut left, mut gone, mut other_first, mut other_last] = [(); 4].map(|()| Poly::default());
        let [first_base, last_base, first, last] =
            [&base[2], &base[3], &sums[2], &sums[3]].map(|poly| split(poly, |atom| is_rate(g, atom)));
        let rates: BTreeSet<&Monomial> = first.keys().chain(last.keys()).collect();
        for rate in rates {
            let of = |parts: &BTreeMap<Monomial, Poly>| parts.get(rate).cloned().unwrap_or_default();
            let (of_first, of_last) = (of(&first), of(&last));
            let (sum, count) = difference(g, normalizer, &sums, &of_first, &of_last)?;
            let (normal, _) = difference(g, normalizer, &base, &of(&first_base), &of(&last_base))?;
            let short = shortest(g, normalizer, &normal, &sum)?;
            let parts = if short.len() < count {
                [(&mut left, &short), (&mut gone, &of_last)]
            } else {
                [(&mut other_first, &of_first), (&mut other_last, &of_last)]
            };
            let rate = Poly::term(rate.clone(), Rational::one());
            for (sum, part) in parts {
                sum.add_scaled(&normalizer.product(g, &rate, part)?, &Rational::one());
            }
        }
        let own = Poly::term(Monomial::atom(own).recip(), Rational::one());
        let left = normalizer.product(g, &left, &own)?;
        let [left, gone, first, last] = [left, gone, other_first, other_last].map(|poly| terms(g, normalizer, &poly));
        Ok(Some(Self {
            left,
            gone,
            others: [first, last],
        }))
    }

    /// The accelerations, for a determinant in which nothing cancels either.
    pub(super) fn accelerations(
        &self,
        g: &Graph,
        dynamics: &Dynamics,
        determinant: ExprId,
        preference: Preference,
    ) -> Vec<ExprId> {
        let [left, gone, first, last] =
            [&self.left, &self.gone, &self.others[0], &self.others[1]].map(|terms| factor(g, terms, preference));
        let (row, minus_one) = (&dynamics.mass_matrix[1], g.integer(-1));
        let pivot = g.div(minus_one, row[1]);
        let lower = g.mul(row[0], pivot);
        let carried = g.mul(lower, last);
        let sum = g.add(first, carried);
        let sum = g.add(sum, left);
        let inverse = g.neg(row[1]);
        let inverse = g.div(inverse, determinant);
        let x = g.mul(sum, inverse);
        let right = g.add(last, gone);
        let own = g.mul(right, pivot);
        let coupled = g.mul(lower, x);
        vec![x, g.add(own, coupled)]
    }
}

/// `a11 r0 - a01 r1`, and how many terms the two products have; the matrix begins with `a11` and `a01`.
fn difference(
    g: &Graph,
    normalizer: &mut Normalizer,
    matrix: &[Poly],
    first: &Poly,
    last: &Poly,
) -> Result<(Poly, usize), TooLarge> {
    let mut difference = normalizer.product(g, &matrix[0], first)?;
    let subtracted = normalizer.product(g, &matrix[1], last)?;
    let count = difference.len() + subtracted.len();
    difference.add_scaled(&subtracted, &ratio(-1, 1));
    Ok((difference, count))
}

/// For each product of parameters the shortest way to write what two equal polynomials have.
fn shortest(g: &Graph, normalizer: &mut Normalizer, base: &Poly, sums: &Poly) -> Result<Poly, TooLarge> {
    let [base, sums] = [base, sums].map(|poly| split(poly, |atom| g.level(atom) != Level::State));
    let mut whole = Poly::default();
    for (coefficient, angles) in base {
        let written = [
            collect(g, normalizer, sums.get(&coefficient).unwrap_or(&angles))?,
            collect(g, normalizer, &angles)?,
            collect_squares_first(g, normalizer, &angles)?,
        ];
        let shortest = written.iter().min_by_key(|poly| poly.len()).unwrap_or(&angles);
        let coefficient = Poly::term(coefficient, Rational::one());
        whole.add_scaled(&normalizer.product(g, &coefficient, shortest)?, &Rational::one());
    }
    Ok(whole)
}

/// What is multiplied by each product of the atoms for which `of` holds.
fn split(poly: &Poly, of: impl Fn(ExprId) -> bool) -> BTreeMap<Monomial, Poly> {
    let mut parts: BTreeMap<Monomial, Poly> = BTreeMap::new();
    for (monomial, number) in poly.terms() {
        let (key, rest) = monomial.partition(&of);
        parts.entry(key).or_default().add_term(rest, number.clone());
    }
    parts
}

/// Whether an atom varies, and is not the sine or cosine of an angle.
fn is_rate(g: &Graph, atom: ExprId) -> bool {
    g.level(atom) == Level::State && !matches!(g.node(atom), Node::Unary(Unary::Sin | Unary::Cos, _))
}
