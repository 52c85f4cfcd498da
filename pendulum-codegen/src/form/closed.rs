//! Closed form of a small scene: every entry is expanded to normal form, then written as short as possible.

use super::exact::Eliminated;
use crate::dynamics::{Balance, Dynamics, Lagrangian};
use crate::expr::{Expr, Graph, Level, Normalizer, Poly, TooLarge, ratio};
use crate::model::{Coordinate, Model};
use crate::pass::collect;
use crate::pass::factor::{Products, Term, factor, polynomial, terms};

/// Entries as lists of terms.
type Lists<'g> = Vec<Vec<Term<'g>>>;

/// Balance whose entries are lists of terms.
#[derive(Debug)]
pub(super) struct ClosedBalance<'g> {
    mass_matrix: Vec<Lists<'g>>,
    residual: Lists<'g>,
}

/// Dynamics whose entries are lists of terms.
#[derive(Debug)]
pub(super) struct Closed<'g> {
    balance: ClosedBalance<'g>,
    bias: Lists<'g>,
    force: Lists<'g>,
    momentum: Lists<'g>,
    /// Kinetic and potential energy.
    energies: Lists<'g>,
    /// Determinant of a mass matrix with two rows. Its symbolic expansion keeps only the terms left after all exact
    /// cancellations, so it loses no digits where one body is much heavier than the other.
    determinant: Option<Vec<Term<'g>>>,
    /// Residual to go with the determinant, present where terms of the residual cancel.
    eliminated: Option<Eliminated<'g>>,
}

impl<'g> ClosedBalance<'g> {
    pub(super) fn new(normalizer: &mut Normalizer<'g>, balance: &Balance<'g>) -> Result<Self, TooLarge> {
        let mut all = |row: &Vec<Expr<'g>>| all_terms(normalizer, row);
        Ok(Self {
            mass_matrix: balance.mass_matrix.iter().map(&mut all).collect::<Result<_, _>>()?,
            residual: all(&balance.residual)?,
        })
    }

    /// Factors the lists of terms into a balance of expressions.
    pub(super) fn factored(&self, g: &'g Graph, coordinates: &[Coordinate<'g>], products: Products) -> Balance<'g> {
        let all = |lists: &Lists<'g>| lists.iter().map(|terms| factor(g, terms, products)).collect();
        let mass_matrix = self.mass_matrix.iter().map(all).collect();
        Balance::new(coordinates, mass_matrix, all(&self.residual))
    }
}

impl<'g> Closed<'g> {
    /// Expands the dynamics of a scene.
    pub(super) fn new(normalizer: &mut Normalizer<'g>, dynamics: &Dynamics<'g>) -> Result<Self, TooLarge> {
        let Dynamics {
            balance, lagrangian, ..
        } = dynamics;
        let mut all = |row: &[Expr<'g>]| all_terms(normalizer, row);
        let rows = balance.mass_matrix.iter();
        let mass_matrix: Vec<Lists<'g>> = rows.map(|row| all(row)).collect::<Result<_, _>>()?;
        let [bias, force] = [all(&lagrangian.bias)?, all(&lagrangian.force)?];
        let residual = all(&balance.residual)?;
        let momentum = all(&lagrangian.momentum)?;
        let energies = all(&[lagrangian.kinetic, lagrangian.potential])?;
        let determinant = match &mass_matrix[..] {
            [first, second] => Some(determinant(normalizer, &first[0], &first[1], &second[1])?),
            _ => None,
        };
        // a scene with a closed form may still be too large for the elimination
        let eliminated = Eliminated::new(normalizer, balance).ok().flatten();
        Ok(Self {
            balance: ClosedBalance { mass_matrix, residual },
            bias,
            force,
            momentum,
            energies,
            determinant,
            eliminated,
        })
    }

    /// Factors the lists of terms into dynamics of expressions.
    pub(super) fn factored(&self, model: &Model<'g>, products: Products) -> (Balance<'g>, Lagrangian<'g>) {
        let ClosedBalance { mass_matrix, residual } = &self.balance;
        let all = |lists: &Lists<'g>| -> Vec<Expr<'g>> {
            let terms = lists.iter();
            terms.map(|terms| factor(model.graph, terms, products)).collect()
        };
        let mass_matrix = mass_matrix.iter().map(all).collect();
        let [bias, force, residual, momentum, energies] =
            [&self.bias, &self.force, residual, &self.momentum, &self.energies].map(all);
        let lagrangian = Lagrangian {
            bias,
            force,
            momentum,
            kinetic: energies[0],
            potential: energies[1],
        };
        (Balance::new(&model.coordinates, mass_matrix, residual), lagrangian)
    }

    /// Determinant of the mass matrix if it has two rows.
    pub(super) fn determinant(&self, g: &'g Graph, products: Products) -> Option<Expr<'g>> {
        self.determinant.as_ref().map(|terms| factor(g, terms, products))
    }

    /// Accelerations without cancellation, where the other forms would lose digits.
    pub(super) fn exact(&self, g: &'g Graph, factored: &Balance<'g>, products: Products) -> Option<Vec<Expr<'g>>> {
        let determinant = self.determinant(g, products)?;
        let eliminated = self.eliminated.as_ref()?;
        Some(eliminated.accelerations(g, factored, determinant, products))
    }
}

fn all_terms<'g>(normalizer: &mut Normalizer<'g>, entries: &[Expr<'g>]) -> Result<Lists<'g>, TooLarge> {
    entries.iter().map(|&x| short_terms(normalizer, x)).collect()
}

/// Terms of an expression in normal form, with angles collected.
pub(super) fn short_terms<'g>(normalizer: &mut Normalizer<'g>, x: Expr<'g>) -> Result<Vec<Term<'g>>, TooLarge> {
    let normal = normalizer.normal(x)?;
    let collected = collect(normalizer, &normal)?;
    Ok(terms(normalizer, &collected))
}

/// Determinant `a d - b^2`, with `cos^2` of every collected angle replaced by `1 - sin^2`.
fn determinant<'g>(
    normalizer: &mut Normalizer<'g>,
    a: &[Term<'g>],
    b: &[Term<'g>],
    d: &[Term<'g>],
) -> Result<Vec<Term<'g>>, TooLarge> {
    let [a, b, d] = [a, b, d].map(polynomial);
    let mut whole = normalizer.product(&a, &d)?;
    whole.add_scaled(&normalizer.product(&b, &b)?, &ratio(-1, 1));
    // the factor of each product of state quantities is made exact in the parameters
    let mut exact = Poly::default();
    for (state, coefficient) in normalizer.split(&whole, |atom| atom.level() == Level::State) {
        let coefficient = match coefficient.as_term() {
            // keep a product of constants: its factors occur elsewhere too
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
