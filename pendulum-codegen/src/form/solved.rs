//! Accelerations and their derivatives.

use super::chosen::{Candidate, Chosen, HOPELESS};
use super::columns::{Unsolved, in_loop, is_long};
use super::written::{Solutions, Written};
use super::{Basis, Derivatives, Form, Forms, ways};
use crate::dynamics::{
    ArticulatedTangent, Articulation, Balance, Entries, Inverse, derived, partials, partials_by_recursion,
};
use crate::expr::{Expr, Normalizer};
use crate::model::{Floating, Model};

/// Maximum size of a balance that is differentiated in the graph, in graph nodes times variables.
///
/// A larger balance is differentiated only if it is within the `HOPELESS` ratio of the smallest and has no derivatives
/// by recursion.
const MOST_DERIVED: usize = 50_000;

/// Maximum number of entries in a row of the mass matrix, on average, up to which derivatives by the matrix are tried
/// beside those of articulated bodies. Each column of derivatives takes as many operations in each row, and a constant
/// number with articulated bodies. Planar chains of 8 links take as many operations with either.
const MOST_IN_ROW: usize = 16;

/// Maximum ratio, as a fraction, of the accelerations on a closed basis to the shortest ones up to which their
/// derivatives are expanded, with a margin: in the examples and tests of this repository, none beyond 5/4 won.
const MOST_EXPANDED: [usize; 2] = [4, 3];

/// Accelerations by the articulated-body algorithm for scenes with orientations, and the balance that they satisfy.
#[derive(Debug)]
pub(super) struct ByLinks<'g> {
    pub(super) form: Form,
    pub(super) accelerations: Vec<Expr<'g>>,
    pub(super) balance: Balance<'g>,
    pub(super) articulation: Articulation<'g>,
}

/// Linear system for the accelerations in one form, with a factored matrix.
pub(super) struct System<'a, 'g> {
    pub(super) form: Form,
    /// Inverse of the matrix of the rows.
    pub(super) inverse: &'a dyn Inverse<'g>,
    /// Inverse of the mass matrix. The rows may be divided by it.
    pub(super) mobility: &'a dyn Inverse<'g>,
    /// Equations of motion, zero for the solution, whose unknowns are the acceleration symbols.
    pub(super) rows: &'a [Expr<'g>],
    /// Solution.
    pub(super) solved: Vec<Expr<'g>>,
}

/// One way to solve for the accelerations and their derivatives.
pub(super) struct Way<'a, 'g> {
    pub(super) form: Form,
    /// Inverse of the mass matrix.
    pub(super) mobility: &'a dyn Inverse<'g>,
    pub(super) accelerations: Vec<Expr<'g>>,
    /// Derivatives of the accelerations, column by column.
    pub(super) columns: Vec<Expr<'g>>,
}

/// Converts derivatives of a balance to derivatives of the accelerations.
struct Derived<'a, 'g> {
    model: &'a Model<'g>,
    floating: &'a [Floating<'g>],
    variables: &'a [Expr<'g>],
    /// Accelerations as symbols.
    symbols: Vec<Expr<'g>>,
    /// Derivatives of the coordinate accelerations at fixed unknowns of the linear system, one column for each
    /// variable.
    beside: Vec<Vec<Expr<'g>>>,
}

impl<'g> Forms<'g> {
    /// Passes each linear system for the accelerations to `f`.
    pub(super) fn each_system(&self, mut f: impl FnMut(System<'_, 'g>)) {
        if let Some(by_links) = &self.by_links {
            f(System {
                form: by_links.form,
                inverse: &by_links.articulation,
                mobility: &by_links.articulation,
                rows: &by_links.balance.rows,
                solved: by_links.accelerations.clone(),
            });
        }
        for written in solved_from(&self.by_links, &self.oriented, &self.forms) {
            for Solutions { factored, solved } in written.solutions(&self.solved) {
                for (form, solved) in solved {
                    f(System {
                        form,
                        inverse: &factored,
                        mobility: written.divided_by.as_ref().unwrap_or(&factored),
                        rows: &written.balance.rows,
                        solved,
                    });
                }
            }
        }
    }

    /// Returns the shortest code for the accelerations.
    pub(crate) fn accelerations(&self) -> Chosen<'g> {
        self.accelerations.get_or_init(|| self.solve(&[])).clone()
    }

    /// Returns the shortest code for the accelerations together with the expressions `beside`.
    pub(super) fn accelerations_and(&self, beside: &[Expr<'g>]) -> Chosen<'g> {
        if beside.is_empty() {
            self.accelerations()
        } else {
            self.solve(beside)
        }
    }

    /// Accelerations of articulated bodies, and the balance that they satisfy, unless closed forms are shorter anyway.
    fn articulated(&self) -> Option<(Vec<Candidate<'g>>, &Balance<'g>)> {
        if let Some(by_links) = &self.by_links {
            return Some((vec![(by_links.form, by_links.accelerations.clone())], &by_links.balance));
        }
        let solved = self.solved.iter().filter(|(form, _)| form.basis == Basis::Articulated);
        let solved: Vec<Candidate<'g>> = solved.cloned().collect();
        let recursive = self
            .forms
            .iter()
            .find(|written| written.form.basis == Basis::Recursive)?;
        (!solved.is_empty()).then_some((solved, &recursive.balance))
    }

    pub(super) fn solve(&self, beside: &[Expr<'g>]) -> Chosen<'g> {
        let of_coordinates = |solved| of_coordinates(&self.floating, solved);
        let mut candidates: Vec<Candidate<'g>> = Vec::new();
        if let Some(by_links) = &self.by_links {
            candidates.push((by_links.form, of_coordinates(by_links.accelerations.clone())));
        }
        for written in solved_from(&self.by_links, &self.oriented, &self.forms) {
            let solved = written.solutions(&[]).flat_map(|solutions| solutions.solved);
            candidates.extend(solved.map(|(form, solved)| (form, of_coordinates(solved))));
        }
        candidates.extend(self.solved.iter().cloned());
        for (_, roots) in &mut candidates {
            roots.extend(beside);
        }
        self.choose(candidates)
    }

    /// Returns the shortest code for the derivatives of the accelerations with respect to `variables`, column by
    /// column. The accelerations precede them if requested; the expressions `beside` follow them.
    pub(crate) fn jacobian(
        &mut self,
        model: &Model<'g>,
        variables: &[Expr<'g>],
        with_accelerations: bool,
        beside: &[Expr<'g>],
    ) -> Chosen<'g> {
        let roots = |way: &Way<'_, 'g>| {
            let accelerations = way.accelerations.iter().filter(|_| with_accelerations);
            accelerations.chain(&way.columns).chain(beside).copied().collect()
        };
        let (chosen, unsolved) = self.solutions_and_systems(model, variables, roots);
        // entries of solutions must be results as they are
        let is_plain = self.floating.is_empty() && model.drives.is_empty() && !model.has_orientations();
        let Some(unsolved) = unsolved.filter(|_| is_plain && is_long(&chosen)) else {
            return chosen;
        };
        let (mut columns, solved) = unsolved.systems(model.graph);
        let derived_from = Derived::new(model, &[], variables);
        let candidate = [(unsolved.form, unsolved.accelerations)];
        columns.given = derived_from.known(&columns.given, &candidate[0].1);
        let mut ways = derived_from.ways(&unsolved.factored, &candidate, unsolved.derivatives, solved);
        let roots = roots(&ways.next().expect("one candidate"));
        in_loop(model.graph, chosen, columns, roots, |candidates| {
            self.choose(candidates)
        })
    }

    /// Returns the shortest code for `roots`, a function of the accelerations and their derivatives with respect to
    /// `variables`.
    pub(super) fn solutions(
        &mut self,
        model: &Model<'g>,
        variables: &[Expr<'g>],
        roots: impl Fn(&Way<'_, 'g>) -> Vec<Expr<'g>>,
    ) -> Chosen<'g> {
        self.solutions_and_systems(model, variables, roots).0
    }

    /// Like [`solutions`](Self::solutions), with the linear systems that the code solves, if it solves any by the mass
    /// matrix.
    fn solutions_and_systems(
        &mut self,
        model: &Model<'g>,
        variables: &[Expr<'g>],
        roots: impl Fn(&Way<'_, 'g>) -> Vec<Expr<'g>>,
    ) -> (Chosen<'g>, Option<Unsolved<'g>>) {
        let floating = self.floating.clone();
        let derived_from = Derived::new(model, &floating, variables);
        let candidate = |way: Way<'_, 'g>| (way.form, roots(&way));
        let mut candidates = self.by_tangent(&derived_from, candidate);
        let accelerations = self.accelerations();
        if let Some(by_links) = &self.by_links
            && (candidates.is_empty() || derived_from.size(&by_links.balance) <= MOST_DERIVED)
        {
            let solved = [(by_links.form, by_links.accelerations.clone())];
            let basis = by_links.form.basis;
            for columns in derived_from.columns(&mut self.normalizer, (basis, &by_links.balance), &accelerations) {
                let inverse = &by_links.articulation;
                let ways = derived_from.ways(inverse, &solved, columns.0, inverse.solve_each_negated(&columns.1));
                candidates.extend(ways.map(candidate));
            }
        }
        let mut unsolved: Vec<Option<Unsolved<'g>>> = candidates.iter().map(|_| None).collect();
        let mut forms = solved_from(&self.by_links, &self.oriented, &self.forms);
        if !candidates.is_empty() && forms.iter().any(|written| is_dense(written, model.dof())) {
            forms = &[];
        }
        let sizes: Vec<usize> = forms
            .iter()
            .map(|written| derived_from.size(&written.balance))
            .collect();
        let least = sizes.iter().copied().min().unwrap_or(0);
        for (written, size) in forms.iter().zip(sizes) {
            let Written { form, balance, .. } = written;
            let is_large = size > MOST_DERIVED && HOPELESS[1] * size > HOPELESS[0] * least;
            let is_hopeless = form.basis == Basis::Shared && !accelerations.is_within(HOPELESS, form.basis);
            if is_large || is_hopeless {
                continue;
            }
            let columns = derived_from.columns(&mut self.normalizer, (form.basis, balance), &accelerations);
            for Solutions { factored, solved } in written.solutions(&self.solved) {
                for (derivatives, columns) in &columns {
                    let solved_columns = factored.solve_each_negated(columns);
                    let mobility = written.divided_by.as_ref().unwrap_or(&factored);
                    let ways = derived_from.ways(mobility, &solved, *derivatives, solved_columns);
                    candidates.extend(ways.map(candidate));
                    unsolved.extend(solved.iter().map(|(form, accelerations)| {
                        Some(Unsolved {
                            form: *form,
                            derivatives: *derivatives,
                            factored: factored.clone(),
                            accelerations: accelerations.clone(),
                            columns: columns.clone(),
                        })
                    }));
                }
            }
        }
        let (chosen, index) = self.choose_of(candidates);
        (chosen, unsolved.into_iter().nth(index).flatten())
    }

    /// Candidates by the derivative of the articulated-body algorithm, for derivatives by the state.
    fn by_tangent(
        &self,
        derived_from: &Derived<'_, 'g>,
        candidate: impl Fn(Way<'_, 'g>) -> Candidate<'g>,
    ) -> Vec<Candidate<'g>> {
        let Derived { model, variables, .. } = derived_from;
        let state = model.state();
        if !variables.iter().any(|variable| state.contains(variable)) {
            return Vec::new();
        }
        let Some((solved, balance)) = self.articulated() else {
            return Vec::new();
        };
        let tangent = ArticulatedTangent::new(model, &self.floating);
        let Some(columns) = tangent.columns(balance, &model.coordinates, variables) else {
            return Vec::new();
        };
        let ways = derived_from.ways(tangent.articulation(), &solved, Derivatives::Links, columns);
        ways.map(candidate).collect()
    }
}

impl<'a, 'g> Derived<'a, 'g> {
    fn new(model: &'a Model<'g>, floating: &'a [Floating<'g>], variables: &'a [Expr<'g>]) -> Self {
        let symbols: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
        Self {
            model,
            floating,
            variables,
            beside: derived(&of_coordinates(floating, symbols.clone()), variables),
            symbols,
        }
    }

    /// Size of a balance, in graph nodes times variables.
    fn size(&self, balance: &Balance<'g>) -> usize {
        self.variables.len() * self.model.graph.reachable(&balance.entries()).len()
    }

    /// Derivatives of a balance, column by column, in several forms. The shortest code for the accelerations decides
    /// if they are expanded.
    fn columns(
        &self,
        normalizer: &mut Normalizer<'g>,
        (basis, balance): (Basis, &Balance<'g>),
        accelerations: &Chosen<'g>,
    ) -> Vec<(Derivatives, Vec<Vec<Expr<'g>>>)> {
        let by_recursion = partials_by_recursion(balance, &self.model.coordinates, self.variables);
        let mut columns = Vec::new();
        if self.size(balance) <= MOST_DERIVED || by_recursion.is_none() {
            let graph = partials(balance, self.variables);
            columns = match accelerations.is_within(MOST_EXPANDED, basis) {
                true => ways(normalizer, basis, graph),
                false => vec![(Derivatives::Graph, graph)],
            };
        }
        columns.extend(by_recursion.map(|columns| (Derivatives::Recursion, columns)));
        columns
    }

    /// Inserts the unknowns of the linear system into derivatives.
    fn known(&self, derivatives: &[Expr<'g>], solved: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let known = self.symbols.iter().copied().zip(solved.iter().copied());
        self.model.graph.substitute(derivatives, known.collect())
    }

    /// Ways by solved columns of derivatives, for each candidate form of the unknowns.
    fn ways<'w>(
        &'w self,
        mobility: &'w dyn Inverse<'g>,
        solved: &'w [Candidate<'g>],
        derivatives: Derivatives,
        solved_columns: Vec<Vec<Expr<'g>>>,
    ) -> impl Iterator<Item = Way<'w, 'g>> {
        let of_coordinate = solved_columns
            .into_iter()
            .zip(&self.beside)
            .flat_map(|(mut column, beside)| {
                let joints = self.floating.iter();
                joints.for_each(|joint| joint.differentiate(&mut column, beside));
                column
            });
        let columns = self.model.with_drives(&of_coordinate.collect::<Vec<_>>());
        solved.iter().map(move |(form, solved)| Way {
            form: form.derived_by(derivatives),
            mobility,
            columns: self.known(&columns, solved),
            accelerations: of_coordinates(self.floating, solved.clone()),
        })
    }
}

/// True if derivatives by the mass matrix take more operations than those of articulated bodies.
fn is_dense(written: &Written<'_>, dof: usize) -> bool {
    let entries = written.balance.mass_matrix.iter().flatten();
    entries.filter(|entry| !entry.is_zero()).count() > MOST_IN_ROW * dof
}

/// Forms with a mass matrix from which the accelerations are solved.
fn solved_from<'a, 'g>(
    by_links: &Option<ByLinks<'g>>,
    oriented: &'a [Written<'g>],
    forms: &'a [Written<'g>],
) -> &'a [Written<'g>] {
    match (by_links, oriented) {
        (Some(_), _) => &[],
        (None, []) => forms,
        (None, oriented) => oriented,
    }
}

/// Converts the unknowns of the linear system to accelerations of the coordinates.
pub(super) fn of_coordinates<'g>(floating: &[Floating<'g>], mut solved: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
    floating.iter().for_each(|joint| joint.accelerate(&mut solved));
    solved
}
