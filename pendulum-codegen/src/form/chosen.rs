//! The shortest of the forms in which a function is written.

use super::Form;
use crate::expr::{Expr, Graph};
use crate::model::Model;
use crate::pass::{Operations, share, trig};

/// A candidate that is longer than another by this ratio, sines and functions aside, which all share, is not searched
/// for common parts: none has been seen to win.
pub(super) const HOPELESS: [usize; 2] = [9, 4];

/// How much longer than the shortest the code may be that loses no digits to cancellation: by one part in this many.
const WORTH_OF_DIGITS: usize = 8;

/// The code of the least weight that was found for one function.
#[derive(Clone, Debug)]
pub(crate) struct Chosen<'g> {
    /// What the function computes.
    pub roots: Vec<Expr<'g>>,
    /// Its operations.
    pub operations: Operations,
    /// The form that won.
    pub form: Form,
    /// What the best form on each other basis takes, from the shortest on.
    pub others: Vec<(Form, Operations)>,
}

impl<'g> Chosen<'g> {
    /// The same code for more than was chosen by: `roots` makes of the roots those that are returned.
    pub(super) fn with(self, roots: impl FnOnce(Vec<Expr<'g>>) -> Vec<Expr<'g>>) -> Self {
        Self {
            roots: roots(self.roots),
            ..self
        }
    }

    /// The same, with the operations of the kinematics counted as well, where there are any.
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

/// A form of a function, and what it computes.
pub(super) type Candidate<'g> = (Form, Vec<Expr<'g>>);

/// The candidate of the least weight once its common parts are shared; the first of equals. There is at least one.
/// An exact one may take a few more.
pub(super) fn choose<'g>(g: &'g Graph, candidates: Vec<Candidate<'g>>) -> Chosen<'g> {
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
    let mut counted: Vec<(Form, Vec<Expr<'g>>, Operations)> = Vec::new();
    for (form, mut roots, mut operations) in lowered {
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
        counted.push((form, roots, operations));
    }
    counted.sort_by_key(|(.., operations)| operations.weight());
    let least = counted.first().map_or(0, |(.., operations)| operations.weight());
    let exact = counted
        .iter()
        .position(|(form, _, operations)| form.exact && operations.weight() <= least + least / WORTH_OF_DIGITS);
    if let Some(at) = exact {
        counted[..=at].rotate_right(1);
    }
    let mut counted = counted.into_iter();
    let (form, roots, operations) = counted.next().unwrap_or_default();
    let mut others: Vec<(Form, Operations)> = Vec::new();
    for (other, _, operations) in counted {
        let known = others.iter().map(|(form, _)| form.basis).chain([form.basis]);
        if !known.into_iter().any(|basis| basis == other.basis) {
            others.push((other, operations));
        }
    }
    Chosen {
        roots,
        operations,
        form,
        others,
    }
}
