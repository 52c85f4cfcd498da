//! Accelerations of two coordinates without cancellation: terms cancel in symbols, before any number is substituted.
//!
//! Where one body is much heavier than another, the rows of the mass matrix are nearly multiples of each other, and so
//! are the weights on a straight chain. In `a11 r0 - a01 r1`, the determinant times the first acceleration, the largest
//! products then cancel and leave their rounding errors.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::One;

use crate::dynamics::Balance;
use crate::expr::{Expr, Graph, Level, Monomial, Node, Normalizer, Poly, Rational, TooLarge, Unary, ratio};
use crate::pass::factor::{Products, Term, factor, terms};
use crate::pass::{collect, collect_squares_first};

/// Residual of two coordinates, split into terms that cancel when the second is eliminated and the others.
#[derive(Debug)]
pub(super) struct Eliminated<'g> {
    /// Result of `(a11 r0 - a01 r1) / a11` for the cancelling terms.
    left: Vec<Term<'g>>,
    /// Cancelling terms of `r1`.
    gone: Vec<Term<'g>>,
    /// Other terms of `r0` and of `r1`.
    others: [Vec<Term<'g>>; 2],
}

impl<'g> Eliminated<'g> {
    /// Eliminates the second of two coordinates. Returns `None` if its diagonal entry depends on the state or if the
    /// two are not coupled.
    pub(super) fn new(normalizer: &mut Normalizer<'g>, balance: &Balance<'g>) -> Result<Option<Self>, TooLarge> {
        let ([_, row], &[first, last]) = (&balance.mass_matrix[..], &balance.residual[..]) else {
            return Ok(None);
        };
        // sums of angles hide some cancellations; base angles lengthen the products that do not cancel
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

    /// Accelerations, for a determinant that is itself free of cancellation.
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

/// Difference `a11 r0 - a01 r1`, and the number of terms in its two products. The matrix begins with `a11` and `a01`.
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

/// Shortest way to write two equal polynomials, chosen separately for each product of parameters.
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

/// True if an atom varies and is not the sine or cosine of an angle.
fn is_rate(atom: Expr<'_>) -> bool {
    atom.level() == Level::State && !matches!(atom.node(), Node::Unary(Unary::Sin | Unary::Cos, _))
}
