//! Choice of the shortest form of a function.

use super::{Basis, Form};
use crate::expr::{Expr, Graph};
use crate::model::Model;
use crate::pass::{Operations, share, trig};

/// Maximum ratio, as a fraction, of arithmetic operations to the fewest of any candidate. Sines and other functions do
/// not count, since all candidates share them. Candidates beyond the ratio skip the search for common subexpressions:
/// none was observed to win.
pub(super) const HOPELESS: [usize; 2] = [9, 4];

/// Inverse of the extra length allowed to code without cancellation: one part in `WORTH_OF_DIGITS` of the shortest.
const WORTH_OF_DIGITS: usize = 8;

/// Code of the least weight found for one function.
#[derive(Clone, Debug)]
pub(crate) struct Chosen<'g> {
    /// Expressions that the function computes.
    pub roots: Vec<Expr<'g>>,
    /// Linear systems whose solutions the roots read, if any.
    pub columns: Option<Columns<'g>>,
    /// Number of operations.
    pub operations: Operations,
    /// Form of the code.
    pub form: Form,
    /// Operations of the best form on each other basis, in ascending order of weight.
    pub others: Vec<(Form, Operations)>,
}

/// Linear systems with the same matrix, one for each of several columns.
#[derive(Clone, Debug)]
pub(crate) struct Columns<'g> {
    /// Number of columns.
    pub(crate) count: usize,
    /// Right-hand sides, column by column, followed by the entries of the factored matrix.
    pub(crate) given: Vec<Expr<'g>>,
    /// Solution of one system, in symbols for the entries of its column and of the matrix.
    pub(crate) solution: Vec<Expr<'g>>,
}

impl<'g> Chosen<'g> {
    /// Replaces the roots by `roots` of them, which may add expressions that the choice did not weigh.
    pub(super) fn with(self, roots: impl FnOnce(Vec<Expr<'g>>) -> Vec<Expr<'g>>) -> Self {
        Self {
            roots: roots(self.roots),
            ..self
        }
    }

    /// True if the best form on a basis has at most `ratio`, a fraction, of the operations of the shortest form.
    pub(super) fn is_within(&self, ratio: [usize; 2], basis: Basis) -> bool {
        let own = [(self.form, self.operations)];
        let all = own.iter().chain(&self.others);
        let arithmetic = |(_, operations): &(Form, Operations)| operations.arithmetic();
        let least = all.clone().map(arithmetic).min().unwrap_or(0);
        let best = all.filter(|(form, _)| form.basis == basis).map(arithmetic).next();
        best.is_none_or(|best| ratio[1] * best <= ratio[0] * least)
    }

    /// Adds the operations of the kinematics, if the model has more positions than rates.
    pub(super) fn counted(mut self, model: &Model<'g>) -> Self {
        if model.has_more_positions() {
            let whole = Operations::of(model.graph, &self.roots);
            let own = std::mem::replace(&mut self.operations, whole);
            for (_, other) in &mut self.others {
                other.additions += whole.additions.saturating_sub(own.additions);
                other.multiplications += whole.multiplications.saturating_sub(own.multiplications);
            }
        }
        self
    }
}

/// Form of a function, and its roots.
pub(super) type Candidate<'g> = (Form, Vec<Expr<'g>>);

/// Returns the candidate of the least weight after sharing common subexpressions, and its index; the first wins a tie.
/// An exact candidate may be slightly longer. There must be at least one candidate.
pub(super) fn choose<'g>(g: &'g Graph, candidates: Vec<Candidate<'g>>) -> (Chosen<'g>, usize) {
    let lowered = candidates.into_iter().map(|(form, roots)| {
        let roots = trig::lower(g, &roots);
        let operations = Operations::of(g, &roots);
        (form, roots, operations)
    });
    let lowered: Vec<(Form, Vec<Expr<'g>>, Operations)> = lowered.collect();
    let least = lowered
        .iter()
        .map(|(.., operations)| operations.arithmetic())
        .min()
        .unwrap_or(0);
    let mut counted: Vec<(usize, Form, Vec<Expr<'g>>, Operations)> = Vec::new();
    for (index, (form, mut roots, mut operations)) in lowered.into_iter().enumerate() {
        if HOPELESS[1] * operations.arithmetic() <= HOPELESS[0] * least {
            let original = roots.clone();
            for factor in [false, true] {
                let shared = share(g, &original, factor);
                let count = Operations::of(g, &shared);
                if count.weight() < operations.weight() {
                    (roots, operations) = (shared, count);
                }
            }
        }
        counted.push((index, form, roots, operations));
    }
    counted.sort_by_key(|(.., operations)| operations.weight());
    let least = counted.first().map_or(0, |(.., operations)| operations.weight());
    let exact = counted
        .iter()
        .position(|(_, form, _, operations)| form.exact && operations.weight() <= least + least / WORTH_OF_DIGITS);
    if let Some(at) = exact {
        counted[..=at].rotate_right(1);
    }
    let mut counted = counted.into_iter();
    let (index, form, roots, operations) = counted.next().unwrap_or_default();
    let mut others: Vec<(Form, Operations)> = Vec::new();
    for (_, other, _, operations) in counted {
        let known = others.iter().map(|(form, _)| form.basis).chain([form.basis]);
        if !known.into_iter().any(|basis| basis == other.basis) {
            others.push((other, operations));
        }
    }
    let chosen = Chosen {
        roots,
        columns: None,
        operations,
        form,
        others,
    };
    (chosen, index)
}
