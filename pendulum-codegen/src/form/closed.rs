//! The closed form of a small scene: every entry expanded to normal form, then written as short as it goes.

use super::exact::Eliminated;
use crate::dynamics::{Dynamics, balance};
use crate::expr::{ExprId, Graph, Level, Normalizer, Poly, TooLarge};
use crate::model::Coordinate;
use crate::pass::collect;
use crate::pass::factor::{Preference, Term, factor, polynomial, terms};

/// Dynamics whose entries are lists of terms.
#[derive(Debug)]
pub struct Closed {
    mass_matrix: Vec<Vec<Vec<Term>>>,
    bias: Vec<Vec<Term>>,
    force: Vec<Vec<Term>>,
    residual: Vec<Vec<Term>>,
    momentum: Vec<Vec<Term>>,
    kinetic: Vec<Term>,
    potential: Vec<Term>,
    /// The determinant of a mass matrix of two rows. Expanded in symbols it is a sum of the terms that are left after all
    /// exact cancellations, so no digits are lost where one body is much heavier than the other.
    determinant: Option<Vec<Term>>,
    /// The residual for that determinant, where anything cancels in it.
    eliminated: Option<Eliminated>,
}

impl Closed {
    /// Expands the dynamics of a scene.
    pub fn new(g: &Graph, normalizer: &mut Normalizer, dynamics: &Dynamics) -> Result<Self, TooLarge> {
        let mut list = |g: &Graph, x: ExprId| short_terms(g, normalizer, x);
        let mut all = |g: &Graph, row: &[ExprId]| row.iter().map(|&x| list(g, x)).collect::<Result<Vec<_>, _>>();
        let mass_matrix: Vec<Vec<_>> = dynamics
            .mass_matrix
            .iter()
            .map(|row| all(g, row))
            .collect::<Result<_, _>>()?;
        let bias = all(g, &dynamics.bias)?;
        let force = all(g, &dynamics.force)?;
        let residual = all(g, &dynamics.residual)?;
        let momentum = all(g, &dynamics.momentum)?;
        let [kinetic, potential] = [dynamics.kinetic, dynamics.potential].map(|x| list(g, x));
        let determinant = match &mass_matrix[..] {
            [first, second] => Some(determinant(g, normalizer, &first[0], &first[1], &second[1])?),
            _ => None,
        };
        // a scene may be too large for this and have a closed form
        let eliminated = Eliminated::new(g, normalizer, dynamics).ok().flatten();
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
    pub fn factored(&self, g: &Graph, coordinates: &[Coordinate], preference: Preference) -> Dynamics {
        let mut short = |terms: &Vec<Term>| factor(g, terms, preference);
        let mut all = |lists: &[Vec<Term>]| -> Vec<ExprId> { lists.iter().map(&mut short).collect() };
        let mass_matrix: Vec<Vec<ExprId>> = self.mass_matrix.iter().map(|row| all(row)).collect();
        let [bias, force, residual, momentum] =
            [&self.bias, &self.force, &self.residual, &self.momentum].map(|lists| all(lists));
        let [kinetic, potential] = [&self.kinetic, &self.potential].map(&mut short);
        let balance = balance(g, &mass_matrix, &residual, coordinates);
        Dynamics {
            mass_matrix,
            bias,
            force,
            residual,
            balance,
            tangent: None,
            momentum,
            kinetic,
            potential,
        }
    }

    /// The determinant of the mass matrix, where it has two rows.
    pub fn determinant(&self, g: &Graph, preference: Preference) -> Option<ExprId> {
        self.determinant.as_ref().map(|terms| factor(g, terms, preference))
    }

    /// The accelerations without the loss of digits, where other forms have it.
    pub fn exact(&self, g: &Graph, factored: &Dynamics, preference: Preference) -> Option<Vec<ExprId>> {
        let determinant = self.determinant(g, preference)?;
        let eliminated = self.eliminated.as_ref()?;
        Some(eliminated.accelerations(g, factored, determinant, preference))
    }
}

/// The terms of an expression in normal form, with angles collected.
pub(super) fn short_terms(g: &Graph, normalizer: &mut Normalizer, x: ExprId) -> Result<Vec<Term>, TooLarge> {
    let normal = normalizer.normal(g, x)?;
    let collected = collect(g, normalizer, &normal)?;
    Ok(terms(g, normalizer, &collected))
}

/// `a d - b^2`, with `cos^2` of every collected angle as `1 - sin^2`.
fn determinant(
    g: &Graph,
    normalizer: &mut Normalizer,
    a: &[Term],
    b: &[Term],
    d: &[Term],
) -> Result<Vec<Term>, TooLarge> {
    let [a, b, d] = [a, b, d].map(|terms| polynomial(g, terms));
    let mut whole = normalizer.product(g, &a, &d)?;
    whole.add_scaled(&normalizer.product(g, &b, &b)?, &crate::expr::ratio(-1, 1));
    // what multiplies each product of state quantities is exact in the parameters themselves
    let mut by_state: std::collections::BTreeMap<_, Poly> = Default::default();
    for (monomial, coefficient) in whole.terms() {
        let (state, constants) = monomial.partition(|atom| g.level(atom) == Level::State);
        by_state
            .entry(state)
            .or_default()
            .add_term(constants, coefficient.clone());
    }
    let mut exact = Poly::default();
    for (state, coefficient) in by_state {
        let coefficient = match coefficient.as_term() {
            // a product of constants stays one: its factors stand elsewhere too
            Some(_) => coefficient,
            None => {
                let sum = normalizer.to_expr(g, &coefficient);
                (*normalizer.normal(g, sum)?).clone()
            }
        };
        let state = Poly::term(state, crate::expr::ratio(1, 1));
        exact.add_scaled(&normalizer.product(g, &state, &coefficient)?, &crate::expr::ratio(1, 1));
    }
    let exact = collect(g, normalizer, &exact)?;
    Ok(terms(g, normalizer, &exact))
}
