//! The closed form of a small scene: every entry expanded to normal form, then written as short as it goes.

use super::exact::Eliminated;
use crate::dynamics::{Dynamics, balance};
use crate::expr::{Expr, Graph, Level, Normalizer, Poly, TooLarge, ratio};
use crate::model::Coordinate;
use crate::pass::collect;
use crate::pass::factor::{Products, Term, factor, polynomial, terms};

/// Dynamics whose entries are lists of terms.
#[derive(Debug)]
pub(crate) struct Closed<'g> {
    mass_matrix: Vec<Vec<Vec<Term<'g>>>>,
    bias: Vec<Vec<Term<'g>>>,
    force: Vec<Vec<Term<'g>>>,
    residual: Vec<Vec<Term<'g>>>,
    momentum: Vec<Vec<Term<'g>>>,
    kinetic: Vec<Term<'g>>,
    potential: Vec<Term<'g>>,
    /// The determinant of a mass matrix of two rows. Expanded in symbols it is a sum of the terms that are left after
    /// all exact cancellations, so no digits are lost where one body is much heavier than the other.
    determinant: Option<Vec<Term<'g>>>,
    /// The residual for that determinant, where anything cancels in it.
    eliminated: Option<Eliminated<'g>>,
}

impl<'g> Closed<'g> {
    /// Expands the dynamics of a scene.
    pub(crate) fn new(normalizer: &mut Normalizer<'g>, dynamics: &Dynamics<'g>) -> Result<Self, TooLarge> {
        let mut list = |x: Expr<'g>| short_terms(normalizer, x);
        let mut all = |row: &[Expr<'g>]| row.iter().map(|&x| list(x)).collect::<Result<Vec<_>, _>>();
        let mass_matrix: Vec<Vec<_>> = dynamics
            .mass_matrix
            .iter()
            .map(|row| all(row))
            .collect::<Result<_, _>>()?;
        let bias = all(&dynamics.bias)?;
        let force = all(&dynamics.force)?;
        let residual = all(&dynamics.residual)?;
        let momentum = all(&dynamics.momentum)?;
        let [kinetic, potential] = [dynamics.kinetic, dynamics.potential].map(list);
        let determinant = match &mass_matrix[..] {
            [first, second] => Some(determinant(normalizer, &first[0], &first[1], &second[1])?),
            _ => None,
        };
        // a scene may be too large for this and have a closed form
        let eliminated = Eliminated::new(normalizer, dynamics).ok().flatten();
        Ok(Self {
            mass_matrix,
            bias,
            force,
            residual,
            momentum,
            kinetic: kinetic?,
            potential: potential?,
            determinant,
            eliminated,
        })
    }

    /// The dynamics as expressions, with common factors drawn out.
    pub(crate) fn factored(&self, g: &'g Graph, coordinates: &[Coordinate<'g>], products: Products) -> Dynamics<'g> {
        let mut short = |terms: &Vec<Term<'g>>| factor(g, terms, products);
        let mut all = |lists: &[Vec<Term<'g>>]| -> Vec<Expr<'g>> { lists.iter().map(&mut short).collect() };
        let mass_matrix: Vec<Vec<Expr<'g>>> = self.mass_matrix.iter().map(|row| all(row)).collect();
        let [bias, force, residual, momentum] =
            [&self.bias, &self.force, &self.residual, &self.momentum].map(|lists| all(lists));
        let [kinetic, potential] = [&self.kinetic, &self.potential].map(&mut short);
        let balance = balance(coordinates, &mass_matrix, &residual);
        Dynamics {
            mass_matrix,
            bias,
            force,
            residual,
            balance,
            drive: Vec::new(),
            held: Vec::new(),
            tangent: None,
            momentum,
            kinetic,
            potential,
        }
    }

    /// The determinant of the mass matrix, where it has two rows.
    pub(crate) fn determinant(&self, g: &'g Graph, products: Products) -> Option<Expr<'g>> {
        self.determinant.as_ref().map(|terms| factor(g, terms, products))
    }

    /// The accelerations without the loss of digits, where other forms have it.
    pub(crate) fn exact(&self, g: &'g Graph, factored: &Dynamics<'g>, products: Products) -> Option<Vec<Expr<'g>>> {
        let determinant = self.determinant(g, products)?;
        let eliminated = self.eliminated.as_ref()?;
        Some(eliminated.accelerations(g, factored, determinant, products))
    }
}

/// The terms of an expression in normal form, with angles collected.
pub(super) fn short_terms<'g>(normalizer: &mut Normalizer<'g>, x: Expr<'g>) -> Result<Vec<Term<'g>>, TooLarge> {
    let normal = normalizer.normal(x)?;
    let collected = collect(normalizer, &normal)?;
    Ok(terms(normalizer, &collected))
}

/// `a d - b^2`, with `cos^2` of every collected angle as `1 - sin^2`.
fn determinant<'g>(
    normalizer: &mut Normalizer<'g>,
    a: &[Term<'g>],
    b: &[Term<'g>],
    d: &[Term<'g>],
) -> Result<Vec<Term<'g>>, TooLarge> {
    let [a, b, d] = [a, b, d].map(polynomial);
    let mut whole = normalizer.product(&a, &d)?;
    whole.add_scaled(&normalizer.product(&b, &b)?, &ratio(-1, 1));
    // what multiplies each product of state quantities is exact in the parameters themselves
    let mut exact = Poly::default();
    for (state, coefficient) in normalizer.split(&whole, |atom| atom.level() == Level::State) {
        let coefficient = match coefficient.as_term() {
            // a product of constants stays one: its factors stand elsewhere too
            Some(_) => coefficient,
            None => {
                let sum = normalizer.to_expr(&coefficient);
                (*normalizer.normal(sum)?).clone()
            }
        };
        let state = Poly::term(state, ratio(1, 1));
        exact.add_scaled(&normalizer.product(&state, &coefficient)?, &ratio(1, 1));
    }
    let exact = collect(normalizer, &exact)?;
    Ok(terms(normalizer, &exact))
}
