//! From dynamics to short code: forms of the same motion are made, weighed, and the lightest is kept.

mod closed;
mod exact;
mod kind;
mod routines;
mod series;
mod taylor;

pub use closed::Closed;
pub use kind::{Basis, Derivatives, Form};
pub(crate) use routines::*;
pub use series::Symbols;
pub use taylor::Taylor;

use std::collections::HashMap;

use crate::dynamics::{
    Dynamics, Factored, Solver, derived, momentum_partials, momentum_rates, partials, partials_by_recursion,
};
use crate::expr::{ExprId, Graph, Normalizer};
use crate::model::{Body, Model};
use crate::pass::{Operations, Preference, constants, factor, share, trig};

/// How many products of terms the closed form of a scene may take. Larger scenes keep the shared graph.
const BUDGET: usize = 20_000;

/// A candidate that is longer than another by this ratio, sines and functions aside, which all share, is not searched for common
/// parts: none has been seen to win.
const HOPELESS: [usize; 2] = [9, 4];

/// How much longer than the shortest the code may be that loses no digits to cancellation: by one part in this many.
const WORTH_OF_DIGITS: usize = 8;

/// The shortest code that was found for one function.
#[derive(Clone, Debug)]
pub struct Chosen {
    /// What the function computes.
    pub roots: Vec<ExprId>,
    /// Its operations.
    pub operations: Operations,
    /// The form that won.
    pub form: Form,
    /// What the best form on each other basis takes, from the shortest on.
    pub others: Vec<(Form, Operations)>,
}

impl Chosen {
    /// The same code for more than was chosen by: `roots` makes of the roots those that are returned.
    fn with(self, roots: impl FnOnce(Vec<ExprId>) -> Vec<ExprId>) -> Self {
        Self {
            roots: roots(self.roots),
            ..self
        }
    }
}

/// A form of a function, and what it computes.
type Candidate = (Form, Vec<ExprId>);

/// All forms of the dynamics of a scene.
#[derive(Debug)]
pub struct Forms {
    /// Dynamics and, where it is known in a better form, the determinant of the mass matrix.
    forms: Vec<(Basis, Dynamics, Option<ExprId>)>,
    /// The accelerations of two coordinates with all that cancels gone.
    exact: Vec<Candidate>,
    /// The accelerations by articulated bodies.
    articulated: Vec<ExprId>,
    normalizer: Normalizer,
}

impl Forms {
    /// The forms of a scene.
    pub fn new(model: &Model, dynamics: &Dynamics) -> Self {
        let angles = model.base_angles();
        let mut normalizer = Normalizer::with_angles(BUDGET, angles);
        let recursive = Dynamics::recursive(model, dynamics.potential);
        let articulated = Dynamics::articulated(model);
        let Model {
            graph: g,
            coordinates,
            bodies,
            ..
        } = model;
        let lopsided = is_lopsided(g, bodies);
        let (mut forms, mut exact) = (Vec::new(), Vec::new());
        if let Ok(closed) = Closed::new(g, &mut normalizer, dynamics) {
            for preference in Preference::ALL {
                let factored = closed.factored(g, coordinates, preference);
                let accelerations = lopsided.then(|| closed.exact(g, &factored, preference)).flatten();
                exact.extend(accelerations.map(|x| (Form::of(Basis::Closed(preference)).exactly(), x)));
                let determinant = closed.determinant(g, preference);
                forms.push((Basis::Closed(preference), factored, determinant));
            }
        }
        // constants that are zero, or equal, for a reason that shows in their normal form only
        for (basis, dynamics) in [(Basis::Shared, dynamics.clone()), (Basis::Recursive, recursive)] {
            let folded = constants::fold(g, &dynamics.entries());
            forms.push((basis, dynamics.with_entries(folded), None));
        }
        let articulated = constants::fold(g, &articulated);
        Self {
            forms,
            exact,
            articulated,
            normalizer,
        }
    }

    /// The dynamics in closed form with its products expanded, if the scene is small enough to have it.
    pub fn closed(&self) -> Option<&Dynamics> {
        self.forms
            .iter()
            .find(|(basis, ..)| *basis == Basis::Closed(Preference::Expanded))
            .map(|(_, dynamics, _)| dynamics)
    }

    /// The shortest code for something that every form of the dynamics has.
    pub fn part(&self, g: &Graph, part: impl Fn(&Graph, &Dynamics) -> Vec<ExprId>) -> Chosen {
        let candidates = self.forms.iter();
        let candidates = candidates.map(|(basis, dynamics, _)| (Form::of(*basis), part(g, dynamics)));
        let candidates = candidates.collect();
        choose(g, candidates)
    }

    /// The shortest code for the accelerations.
    pub fn accelerations(&self, g: &Graph) -> Chosen {
        let mut candidates = Vec::new();
        for (basis, dynamics, determinant) in &self.forms {
            for (factored, solver) in factorings(g, dynamics, *determinant) {
                let form = Form::of(*basis).solved_by(solver);
                candidates.push((form, factored.solve_negated(g, &dynamics.residual)));
            }
        }
        candidates.extend(self.exact.iter().cloned());
        candidates.push((Form::of(Basis::Articulated), self.articulated.clone()));
        choose(g, candidates)
    }

    /// The shortest code for the derivatives of the accelerations by some symbols: column by column, and before them the accelerations
    /// themselves if these are wanted too.
    pub fn jacobian(&mut self, model: &Model, variables: &[ExprId], with_accelerations: bool) -> Chosen {
        let Model {
            graph: g, coordinates, ..
        } = model;
        let mut candidates = Vec::new();
        for (basis, dynamics, determinant) in &self.forms {
            let derived = partials(g, dynamics, variables);
            let mut columns = ways(g, &mut self.normalizer, *basis, derived);
            let by_recursion = partials_by_recursion(g, dynamics, coordinates, variables);
            columns.extend(by_recursion.map(|columns| (Derivatives::Recursion, columns)));
            let exact = self.exact.iter().filter(|(form, _)| form.basis == *basis);
            for (factored, solver) in factorings(g, dynamics, *determinant) {
                let form = Form::of(*basis).solved_by(solver);
                let mut ways = vec![(form, factored.solve_negated(g, &dynamics.residual))];
                ways.extend(
                    exact
                        .clone()
                        .map(|(_, accelerations)| (form.exactly(), accelerations.clone())),
                );
                for (derivatives, columns) in &columns {
                    let solved = columns.iter().flat_map(|column| factored.solve_negated(g, column));
                    let solved: Vec<ExprId> = solved.collect();
                    for (form, accelerations) in &ways {
                        let symbols = coordinates.iter().map(|c| c.acceleration);
                        let known: HashMap<_, _> = symbols.zip(accelerations.iter().copied()).collect();
                        let mut roots = g.substitute(&solved, known);
                        if with_accelerations {
                            roots.splice(0..0, accelerations.iter().copied());
                        }
                        candidates.push((form.derived_by(*derivatives), roots));
                    }
                }
            }
        }
        choose(g, candidates)
    }

    /// The shortest code for the momenta and, behind them, their rates.
    pub fn canonical(&mut self, model: &Model) -> Chosen {
        let Model {
            graph: g, coordinates, ..
        } = model;
        let mut candidates = Vec::new();
        for (basis, dynamics, _) in &self.forms {
            let rates = vec![momentum_rates(g, dynamics, coordinates)];
            for (derivatives, rates) in ways(g, &mut self.normalizer, *basis, rates) {
                let roots = dynamics.momentum.iter().copied().chain(rates.into_iter().flatten());
                candidates.push((Form::of(*basis).derived_by(derivatives), roots.collect()));
            }
        }
        choose(g, candidates)
    }

    /// The shortest code for the derivatives of the momenta by the state, column by column, and behind them those of their rates.
    pub fn canonical_jacobian(&mut self, model: &Model) -> Chosen {
        let state = model.state();
        let Model {
            graph: g, coordinates, ..
        } = model;
        let mut candidates = Vec::new();
        for (basis, dynamics, _) in &self.forms {
            let rates = vec![momentum_rates(g, dynamics, coordinates)];
            let momenta = momentum_partials(g, dynamics, coordinates);
            for (_, rates) in ways(g, &mut self.normalizer, *basis, rates) {
                let columns = momenta.iter().cloned().chain(derived(g, &rates[0], &state)).collect();
                for (derivatives, columns) in ways(g, &mut self.normalizer, *basis, columns) {
                    let roots = columns.into_iter().flatten().collect();
                    candidates.push((Form::of(*basis).derived_by(derivatives), roots));
                }
            }
        }
        choose(g, candidates)
    }
}

/// Columns of derivatives as they are, and in closed form where that is the basis.
fn ways(
    g: &Graph,
    normalizer: &mut Normalizer,
    basis: Basis,
    columns: Vec<Vec<ExprId>>,
) -> Vec<(Derivatives, Vec<Vec<ExprId>>)> {
    let expanded = match basis {
        Basis::Closed(preference) => expanded(g, normalizer, &columns, preference),
        _ => None,
    };
    let expanded = expanded.map(|columns| (Derivatives::Expanded, columns));
    expanded.into_iter().chain([(Derivatives::Graph, columns)]).collect()
}

/// Whether one body may be much heavier than another: their masses are different expressions, other than numbers of one size.
fn is_lopsided(g: &Graph, bodies: &[Body]) -> bool {
    /// Less than two digits can cancel between masses of this ratio.
    const EVEN: f64 = 100.0;
    let size = |id| g.constant(id).map(f64::abs);
    let uneven = |a: ExprId, b: ExprId| match (size(a), size(b)) {
        (Some(a), Some(b)) => a.max(b) > EVEN * a.min(b),
        _ => a != b,
    };
    let masses = bodies.iter().map(|body| body.inertia.mass);
    let masses: Vec<ExprId> = masses.filter(|&mass| !g.is_zero(mass)).collect();
    masses.iter().any(|&mass| uneven(mass, masses[0]))
}

/// Columns of expressions in closed form; none if they grow too large.
pub(crate) fn expanded(
    g: &Graph,
    normalizer: &mut Normalizer,
    columns: &[Vec<ExprId>],
    preference: Preference,
) -> Option<Vec<Vec<ExprId>>> {
    let mut short =
        |x: &ExprId| closed::short_terms(g, normalizer, *x).map(|terms| factor::factor(g, &terms, preference));
    let columns = columns
        .iter()
        .map(|column| column.iter().map(&mut short).collect())
        .collect::<Result<_, _>>();
    columns.ok()
}

/// The factorings of the mass matrix that may be shortest.
fn factorings(g: &Graph, dynamics: &Dynamics, determinant: Option<ExprId>) -> Vec<(Factored, Solver)> {
    let coupled = dynamics.residual.len() == 2 && !g.is_zero(dynamics.mass_matrix[0][1]);
    let solvers: &[Solver] = if coupled {
        &[Solver::Adjugate, Solver::Inverse, Solver::Ldl]
    } else {
        &[Solver::Ldl]
    };
    let factored = |&solver: &Solver| (Factored::new(g, solver, &dynamics.mass_matrix, determinant), solver);
    solvers.iter().map(factored).collect()
}

/// The candidate of the least weight once its common parts are shared; the first of equals. There is at least one.
/// An exact one may take a few more.
fn choose(g: &Graph, candidates: Vec<Candidate>) -> Chosen {
    let lowered = candidates.into_iter().map(|(form, roots)| {
        let roots = trig::lower(g, &roots);
        let operations = Operations::of(g, &roots);
        (form, roots, operations)
    });
    let lowered: Vec<(Form, Vec<ExprId>, Operations)> = lowered.collect();
    let least = lowered
        .iter()
        .map(|(.., operations)| operations.arithmetic())
        .min()
        .unwrap_or(0);
    let mut counted: Vec<(Form, Vec<ExprId>, Operations)> = Vec::new();
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
