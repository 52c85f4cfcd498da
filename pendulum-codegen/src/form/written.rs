//! Balances with an explicit mass matrix.

use super::closed::ClosedBalance;
use super::{Basis, Candidate, Form};
use crate::dynamics::{Balance, Dynamics, Entries, Factored, Inverse, Solver};
use crate::expr::{Expr, Graph, Level, Normalizer};
use crate::model::{Floating, Model};
use crate::pass::{Products, constants};

/// Balance in one form.
#[derive(Clone, Debug)]
pub(super) struct Written<'g> {
    pub(super) form: Form,
    pub(super) balance: Balance<'g>,
    /// Determinant of the mass matrix, if a better form than its expansion is available.
    pub(super) determinant: Option<Expr<'g>>,
    /// Factored mass matrix by which the balance is divided, so that its own one is the unit matrix.
    pub(super) divided_by: Option<Factored<'g>>,
}

impl<'g> Written<'g> {
    pub(super) fn new(form: Form, balance: Balance<'g>) -> Self {
        Self {
            form,
            balance,
            determinant: None,
            divided_by: None,
        }
    }

    /// Copy with dependent symbols replaced by their expressions of the state.
    pub(super) fn written_out(&self, model: &Model<'g>) -> Self {
        let entries = model.written_out(&self.balance.entries());
        Self {
            form: self.form,
            balance: self.balance.clone().with_entries(entries),
            determinant: self.determinant.map(|determinant| model.written_out(&[determinant])[0]),
            divided_by: self.divided_by.clone(),
        }
    }

    /// Candidate factorisations of the mass matrix, each with the form of what it solves for.
    pub(super) fn factorings(&self) -> Vec<(Factored<'g>, Form)> {
        let matrix = &self.balance.mass_matrix;
        let coupled = matrix.len() == 2 && !matrix[0][1].is_zero();
        let solvers: &[Solver] = if coupled {
            &[Solver::Adjugate, Solver::Inverse, Solver::Ldl]
        } else {
            &[Solver::Ldl]
        };
        let factored = |&solver: &Solver| {
            let factored = Factored::new(solver, matrix, self.determinant);
            (factored, self.form.solved_by(solver))
        };
        solvers.iter().map(factored).collect()
    }

    /// Solutions by each factorisation. Those in `explicit` form on the same basis follow each.
    pub(super) fn solutions<'a>(&'a self, explicit: &'a [Candidate<'g>]) -> impl Iterator<Item = Solutions<'g>> + 'a {
        self.factorings().into_iter().map(move |(factored, form)| {
            let explicit = explicit.iter().filter(|(of, _)| of.basis == form.basis);
            let explicit = explicit.map(|(_, accelerations)| (form.exactly(), accelerations.clone()));
            let own = (form, factored.solve_negated(&self.balance.residual));
            Solutions {
                solved: [own].into_iter().chain(explicit).collect(),
                factored,
            }
        })
    }
}

/// Solutions of a balance by a factored mass matrix.
pub(super) struct Solutions<'g> {
    pub(super) factored: Factored<'g>,
    /// Unknowns of the balance, in several forms.
    pub(super) solved: Vec<Candidate<'g>>,
}

/// Linear systems for the accelerations of a scene with orientations: one matrix and one residual each. Accelerations
/// of `floating` bodies are along their own axes. If `pushed`, forces at points act as wrenches on the links.
pub(super) fn along_bodies<'g>(
    model: &Model<'g>,
    normalizer: &mut Normalizer<'g>,
    pushed: bool,
    floating: &[Floating<'g>],
) -> Vec<Written<'g>> {
    let g = model.graph;
    let form = |basis| Form::of(basis).with_wrenches(pushed);
    let balance = Dynamics::along_bodies(model, pushed, floating);
    let divided = divided(model, &balance).map(|(balance, matrix)| (balance, Some(matrix)));
    let mut all = Vec::new();
    for (balance, divided_by) in [(balance, None)].into_iter().chain(divided) {
        let first = all.len();
        if let Ok(closed) = ClosedBalance::new(normalizer, &balance) {
            all.extend(Products::ALL.map(|products| {
                let balance = closed.factored(g, &model.coordinates, products);
                Written::new(form(Basis::Closed(products)), balance)
            }));
        }
        all.push(Written::new(form(Basis::Recursive), folded(g, balance)));
        for written in &mut all[first..] {
            written.divided_by.clone_from(&divided_by);
        }
    }
    all
}

/// Folds expressions that are zero or equal only in normal form into constants.
pub(super) fn folded<'g, T: Entries<'g>>(g: &'g Graph, of: T) -> T {
    let entries = constants::fold(g, &of.entries());
    of.with_entries(entries)
}

/// Balance premultiplied by the inverse of its mass matrix, and that matrix, if it does not depend on the state.
fn divided<'g>(model: &Model<'g>, balance: &Balance<'g>) -> Option<(Balance<'g>, Factored<'g>)> {
    let mut entries = balance.mass_matrix.iter().flatten();
    if entries.any(|entry| entry.level() >= Level::State) {
        return None;
    }
    let g = model.graph;
    let factored = Factored::new(Solver::Ldl, &balance.mass_matrix, None);
    let solved = factored.solve_negated(&balance.residual);
    let residual: Vec<Expr<'g>> = solved.into_iter().map(|x| -x).collect();
    let n = residual.len();
    let unit = |i: usize| (0..n).map(|j| g.integer(i64::from(i == j))).collect();
    let balance = Balance::new(&model.coordinates, (0..n).map(unit).collect(), residual);
    Some((balance, factored))
}
