//! Two accelerations whose digits do not cancel: what cancels does so in symbols, before any number is known.
//!
//! Where one body is much heavier than another, the rows of the mass matrix are nearly multiples of each other, and so
//! are the weights on a straight chain. In `a11 r0 - a01 r1`, the determinant times the first acceleration, the largest
//! products then cancel, and leave their rounding.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::One;

use crate::dynamics::Balance;
use crate::expr::{Expr, Graph, Level, Monomial, Node, Normalizer, Poly, Rational, TooLarge, Unary, ratio};
use crate::pass::factor::{Products, Term, factor, terms};
use crate::pass::{collect, collect_squares_first};

/// The residual of two coordinates, in what cancels when the second is eliminated and what does not.
#[derive(Debug)]
pub(super) struct Eliminated<'g> {
    /// What is left of `(a11 r0 - a01 r1) / a11` for the terms that cancel.
    left: Vec<Term<'g>>,
    /// The terms of `r1` among those.
    gone: Vec<Term<'g>>,
    /// The other terms of `r0` and of `r1`.
    others: [Vec<Term<'g>>; 2],
}

impl<'g> Eliminated<'g> {
    /// Eliminates the second of two coordinates, whose own inertia is constant; none if it is not, or if they are not
    /// coupled.
    pub(super) fn new(normalizer: &mut Normalizer<'g>, balance: &Balance<'g>) -> Result<Option<Self>, TooLarge> {
        let ([_, row], &[first, last]) = (&balance.mass_matrix[..], &balance.residual[..]) else {
            return Ok(None);
        };
        // sums of angles hide some cancellations, and base angles make longer products of what does not cancel
        let mut base = Vec::new();
        for x in [row[1], row[0], first, last] {
            base.push((*normalizer.normal(x)?).clone());
        }
        let sums: Vec<Poly> = base
            .iter()
            .map(|poly| collect(normalizer, poly))
            .collect::<Result<_, _>>()?;
        let own = normalizer.to_expr(&base[0]);
        if own.level() == Level::State || row[0].is_zero() {
            return Ok(None);
        }
        let [mut left, mut gone, mut other_first, mut other_last] = [(); 4].map(|()| Poly::default());
        let [first_base, last_base, first, last] =
            [&base[2], &base[3], &sums[2], &sums[3]].map(|poly| normalizer.split(poly, is_rate));
        let rates: BTreeSet<&Monomial> = first.keys().chain(last.keys()).collect();
        for rate in rates {
            let of = |parts: &BTreeMap<Monomial, Poly>| parts.get(rate).cloned().unwrap_or_default();
            let (of_first, of_last) = (of(&first), of(&last));
            let (sum, count) = difference(normalizer, &sums, &of_first, &of_last)?;
            let (normal, _) = difference(normalizer, &base, &of(&first_base), &of(&last_base))?;
            let short = shortest(normalizer, &normal, &sum)?;
            let parts = if short.len() < count {
                [(&mut left, &short), (&mut gone, &of_last)]
            } else {
                [(&mut other_first, &of_first), (&mut other_last, &of_last)]
            };
            let rate = Poly::term(rate.clone(), Rational::one());
            for (sum, part) in parts {
                sum.add_scaled(&normalizer.product(&rate, part)?, &Rational::one());
            }
        }
        let own = Poly::term(Monomial::atom(own).recip(), Rational::one());
        let left = normalizer.product(&left, &own)?;
        let [left, gone, first, last] = [left, gone, other_first, other_last].map(|poly| terms(normalizer, &poly));
        Ok(Some(Self {
            left,
            gone,
            others: [first, last],
        }))
    }

    /// The accelerations, for a determinant in which nothing cancels either.
    pub(super) fn accelerations(
        &self,
        g: &'g Graph,
        balance: &Balance<'g>,
        determinant: Expr<'g>,
        products: Products,
    ) -> Vec<Expr<'g>> {
        let [left, gone, first, last] =
            [&self.left, &self.gone, &self.others[0], &self.others[1]].map(|terms| factor(g, terms, products));
        let [coupling, own] = [0, 1].map(|k| balance.mass_matrix[1][k]);
        let pivot = -1 / own;
        let lower = coupling * pivot;
        let x = (first + lower * last + left) * (-own / determinant);
        vec![x, (last + gone) * pivot + lower * x]
    }
}

/// `a11 r0 - a01 r1`, and how many terms the two products have; the matrix begins with `a11` and `a01`.
fn difference(
    normalizer: &mut Normalizer<'_>,
    matrix: &[Poly],
    first: &Poly,
    last: &Poly,
) -> Result<(Poly, usize), TooLarge> {
    let mut difference = normalizer.product(&matrix[0], first)?;
    let subtracted = normalizer.product(&matrix[1], last)?;
    let count = difference.len() + subtracted.len();
    difference.add_scaled(&subtracted, &ratio(-1, 1));
    Ok((difference, count))
}

/// For each product of parameters the shortest way to write what two equal polynomials have.
fn shortest(normalizer: &mut Normalizer<'_>, base: &Poly, sums: &Poly) -> Result<Poly, TooLarge> {
    let [base, sums] = [base, sums].map(|poly| normalizer.split(poly, |atom| atom.level() != Level::State));
    let mut whole = Poly::default();
    for (coefficient, angles) in base {
        let written = [
            collect(normalizer, sums.get(&coefficient).unwrap_or(&angles))?,
            collect(normalizer, &angles)?,
            collect_squares_first(normalizer, &angles)?,
        ];
        let shortest = written.iter().min_by_key(|poly| poly.len()).unwrap_or(&angles);
        let coefficient = Poly::term(coefficient, Rational::one());
        whole.add_scaled(&normalizer.product(&coefficient, shortest)?, &Rational::one());
    }
    Ok(whole)
}

/// Whether an atom varies, and is not the sine or cosine of an angle.
fn is_rate(atom: Expr<'_>) -> bool {
    atom.level() == Level::State && !matches!(atom.node(), Node::Unary(Unary::Sin | Unary::Cos, _))
}
