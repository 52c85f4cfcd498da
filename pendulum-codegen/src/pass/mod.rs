//! From dynamics to short code: forms of the same motion are made, counted, and the shortest is kept.

mod angles;
mod closed;
mod constants;
mod cost;
mod factor;
mod pairs;
mod share;
mod trig;

pub use angles::collect;
pub use closed::Closed;
pub use cost::Operations;
pub use factor::Preference;
pub use share::share;

use crate::dynamics::{Dynamics, Factored, Solver, partials, partials_by_recursion};
use crate::expr::{ExprId, Graph, Normalizer};
use crate::model::Model;

/// How many products of terms the closed form of a scene may take. Larger scenes keep the shared graph.
const BUDGET: usize = 20_000;

/// A candidate that is longer than another by this factor is not worth the search for its common parts.
const HOPELESS: usize = 4;

/// A form of the dynamics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Expanded to normal form, then factored.
    Closed(Preference),
    /// The graph of A, B and C as it was built.
    Shared,
    /// Newton and Euler's recursion and composite bodies, on links in base parameters.
    Recursive,
}

/// The shortest code that was found for one function.
#[derive(Clone, Debug)]
pub struct Chosen {
    /// What the function computes.
    pub roots: Vec<ExprId>,
    /// Its operations.
    pub operations: Operations,
    /// The form that won.
    pub form: Form,
}

/// All forms of the dynamics of a scene.
#[derive(Debug)]
pub struct Forms {
    /// Dynamics and, where it is known in a better form, the determinant of the mass matrix.
    forms: Vec<(Form, Dynamics, Option<ExprId>)>,
    normalizer: Normalizer,
}

impl Forms {
    /// The forms of a scene.
    pub fn new(model: &mut Model, dynamics: &Dynamics) -> Self {
        let angles = model.base_angles();
        let mut normalizer = Normalizer::with_angles(BUDGET, angles);
        let recursive = Dynamics::recursive(model, dynamics.potential);
        let Model {
            graph: g, coordinates, ..
        } = model;
        let mut forms = Vec::new();
        if let Ok(closed) = Closed::new(g, &mut normalizer, dynamics) {
            for preference in Preference::ALL {
                let factored = closed.factored(g, coordinates, preference);
                forms.push((Form::Closed(preference), factored, closed.determinant(g, preference)));
            }
        }
        // constants that are zero, or equal, for a reason that shows in their normal form only
        for (form, dynamics) in [(Form::Shared, dynamics.clone()), (Form::Recursive, recursive)] {
            let folded = constants::fold(g, &dynamics.entries());
            forms.push((form, dynamics.with_entries(folded), None));
        }
        Self { forms, normalizer }
    }

    /// The dynamics in closed form with its products expanded, if the scene is small enough to have it.
    pub fn closed(&self) -> Option<&Dynamics> {
        self.forms
            .iter()
            .find(|(form, ..)| *form == Form::Closed(Preference::Expanded))
            .map(|(_, dynamics, _)| dynamics)
    }

    /// The shortest code for something that every form of the dynamics has.
    pub fn part(&self, g: &mut Graph, part: impl Fn(&Dynamics) -> Vec<ExprId>) -> Chosen {
        let candidates: Vec<_> = self
            .forms
            .iter()
            .map(|(form, dynamics, _)| (*form, part(dynamics)))
            .collect();
        choose(g, candidates)
    }

    /// The shortest code for the accelerations.
    pub fn accelerations(&self, g: &mut Graph) -> Chosen {
        let mut candidates = Vec::new();
        for (form, dynamics, determinant) in &self.forms {
            for (factored, form) in factorings(g, *form, dynamics, *determinant) {
                candidates.push((form, factored.solve_negated(g, &dynamics.residual)));
            }
        }
        choose(g, candidates)
    }

    /// The shortest code for the derivatives of the accelerations by some symbols: column by column.
    pub fn jacobian(&mut self, model: &mut Model, variables: &[ExprId]) -> Chosen {
        let Model {
            graph: g, coordinates, ..
        } = model;
        let mut candidates = Vec::new();
        for (form, dynamics, determinant) in &self.forms {
            let mut columns = vec![partials(g, dynamics, variables)];
            columns.extend(partials_by_recursion(g, dynamics, coordinates, variables));
            if let Form::Closed(preference) = *form {
                columns.extend(expanded(g, &mut self.normalizer, &columns[0], preference));
            }
            for (factored, form) in factorings(g, *form, dynamics, *determinant) {
                let accelerations = factored.solve_negated(g, &dynamics.residual);
                let symbols = coordinates.iter().map(|c| c.acceleration);
                let known: std::collections::HashMap<_, _> = symbols.zip(accelerations).collect();
                for columns in &columns {
                    let solved: Vec<ExprId> = columns
                        .iter()
                        .flat_map(|column| factored.solve_negated(g, column))
                        .collect();
                    candidates.push((form, g.substitute(&solved, known.clone())));
                }
            }
        }
        choose(g, candidates)
    }
}

/// Columns of derivatives in closed form; none if they grow too large.
fn expanded(
    g: &mut Graph,
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
fn factorings(g: &mut Graph, form: Form, dynamics: &Dynamics, determinant: Option<ExprId>) -> Vec<(Factored, Form)> {
    let coupled = dynamics.residual.len() == 2 && !g.is_zero(dynamics.mass_matrix[0][1]);
    let solvers: &[Solver] = if coupled {
        &[Solver::Adjugate, Solver::Inverse]
    } else {
        &[Solver::Ldl]
    };
    let factored = |&solver: &Solver| (Factored::new(g, solver, &dynamics.mass_matrix, determinant), form);
    solvers.iter().map(factored).collect()
}

/// The candidate that takes the fewest operations once its common parts are shared; the first of equals.
fn choose(g: &mut Graph, candidates: Vec<(Form, Vec<ExprId>)>) -> Chosen {
    let lowered: Vec<(Form, Vec<ExprId>, usize)> = candidates
        .into_iter()
        .map(|(form, roots)| {
            let roots = trig::lower(g, &roots);
            let weight = Operations::of(g, &roots).weight();
            (form, roots, weight)
        })
        .collect();
    let least = lowered.iter().map(|(.., weight)| *weight).min().unwrap_or(0);
    let mut best: Option<Chosen> = None;
    for (form, lowered, weight) in lowered {
        if weight > HOPELESS * least {
            continue;
        }
        for factor in [false, true] {
            let roots = share(g, &lowered, factor);
            let operations = Operations::of(g, &roots);
            if best
                .as_ref()
                .is_none_or(|best| operations.weight() < best.operations.weight())
            {
                best = Some(Chosen {
                    roots,
                    operations,
                    form,
                });
            }
        }
    }
    // every scene has at least the form it was built in
    best.unwrap_or(Chosen {
        roots: Vec::new(),
        operations: Operations::default(),
        form: Form::Shared,
    })
}
