//! Dynamics as they are written, with a mass matrix.

use super::{Basis, Closed, Form};
use crate::dynamics::{Dynamics, Factored, Inverse, Solver, balance};
use crate::expr::{Expr, Graph, Level, Normalizer};
use crate::model::{Floating, Model};
use crate::pass::{Products, constants};

/// Dynamics in some form.
#[derive(Clone, Debug)]
pub(super) struct Written<'g> {
    pub(super) form: Form,
    pub(super) dynamics: Dynamics<'g>,
    /// The determinant of the mass matrix, where it is known in a better form.
    pub(super) determinant: Option<Expr<'g>>,
}

impl<'g> Written<'g> {
    /// Dynamics with constants that are zero, or equal, for a reason that shows in their normal form only.
    pub(super) fn folded(g: &'g Graph, form: Form, dynamics: Dynamics<'g>) -> Self {
        let folded = constants::fold(g, &dynamics.entries());
        Self {
            form,
            dynamics: dynamics.with_entries(folded),
            determinant: None,
        }
    }

    /// The same with what depends on the state written out.
    pub(super) fn written_out(&self, model: &Model<'g>) -> Self {
        let entries = model.written_out(&self.dynamics.entries());
        Self {
            form: self.form,
            dynamics: self.dynamics.clone().with_entries(entries),
            determinant: self.determinant.map(|determinant| model.written_out(&[determinant])[0]),
        }
    }

    /// The factorings of the mass matrix that may be shortest.
    pub(super) fn factorings(&self) -> Vec<(Factored<'g>, Solver)> {
        let matrix = &self.dynamics.mass_matrix;
        let coupled = matrix.len() == 2 && !matrix[0][1].is_zero();
        let solvers: &[Solver] = if coupled {
            &[Solver::Adjugate, Solver::Inverse, Solver::Ldl]
        } else {
            &[Solver::Ldl]
        };
        let factored = |&solver: &Solver| (Factored::new(solver, matrix, self.determinant), solver);
        solvers.iter().map(factored).collect()
    }
}

/// What the accelerations of a scene with orientations are solved from, those of `floating` bodies along their own
/// axes: one matrix and one residual. Where `pushed`, forces at points are wrenches on the links.
pub(super) fn along_bodies<'g>(
    model: &Model<'g>,
    normalizer: &mut Normalizer<'g>,
    pushed: bool,
    floating: &[Floating<'g>],
) -> Vec<Written<'g>> {
    let g = model.graph;
    let form = |basis| Form::of(basis).with_wrenches(pushed);
    let dynamics = Dynamics::along_bodies(model, pushed, floating);
    let divided = divided(model, &dynamics);
    let mut all = Vec::new();
    for dynamics in [dynamics].into_iter().chain(divided) {
        if let Ok(closed) = Closed::new(normalizer, &dynamics) {
            all.extend(Products::ALL.map(|products| Written {
                form: form(Basis::Closed(products)),
                dynamics: closed.factored(g, &model.coordinates, products),
                determinant: None,
            }));
        }
        all.push(Written::folded(g, form(Basis::Recursive), dynamics));
    }
    all
}

/// The dynamics with a mass matrix that does not depend on the state divided out.
fn divided<'g>(model: &Model<'g>, dynamics: &Dynamics<'g>) -> Option<Dynamics<'g>> {
    let mut entries = dynamics.mass_matrix.iter().flatten();
    if entries.any(|entry| entry.level() >= Level::State) {
        return None;
    }
    let g = model.graph;
    let solved = Factored::new(Solver::Ldl, &dynamics.mass_matrix, None).solve_negated(&dynamics.residual);
    let residual: Vec<Expr<'g>> = solved.into_iter().map(|x| -x).collect();
    let n = residual.len();
    let unit = |i: usize| (0..n).map(|j| g.integer(i64::from(i == j))).collect();
    let mass_matrix: Vec<Vec<Expr<'g>>> = (0..n).map(unit).collect();
    Some(Dynamics {
        balance: balance(&model.coordinates, &mass_matrix, &residual),
        mass_matrix,
        residual,
        ..dynamics.clone()
    })
}
