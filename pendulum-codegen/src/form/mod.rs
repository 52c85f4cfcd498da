//! From dynamics to short code: forms of the same motion are made, weighed, and the lightest is kept.

mod closed;
mod exact;
mod kind;
mod output;
mod response;
mod routines;
mod series;
mod taylor;

use std::cell::OnceCell;

pub(crate) use closed::Closed;
pub(crate) use kind::{Basis, Derivatives, Form};
pub(crate) use output::{rates, values, values_and_jacobian};
pub(crate) use response::{measure_derivatives, measures, response, response_derivative};
pub(crate) use routines::*;
pub(crate) use taylor::Taylor;

use crate::dynamics::{
    Articulation, Dynamics, Factored, Inverse, Solver, articulated, balance, derived, momentum_partials,
    momentum_rates, partials, partials_by_recursion,
};
use crate::expr::{Expr, Graph, Level, Normalizer};
use crate::model::{Body, Floating, Following, Model};
use crate::pass::{Operations, Preference, constants, factor, share, trig};

/// How many products of terms the closed form of a scene may take. Larger scenes keep the shared graph.
const BUDGET: usize = 20_000;

/// A candidate that is longer than another by this ratio, sines and functions aside, which all share, is not searched for common
/// parts: none has been seen to win.
const HOPELESS: [usize; 2] = [9, 4];

/// Where derivatives take more operations on nodes, graphs that are longer than another by that ratio are not derived,
/// and none is whose derivatives are known by recursion.
const MOST_DERIVED: usize = 50_000;

/// How much longer than the shortest the code may be that loses no digits to cancellation: by one part in this many.
const WORTH_OF_DIGITS: usize = 8;

/// Articulated bodies with orientations are taken where what is solved by a mass matrix is longer: by one part in this many at least.
const WORTH_OF_LINKS: usize = 8;

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
    fn with(self, roots: impl FnOnce(Vec<Expr<'g>>) -> Vec<Expr<'g>>) -> Self {
        Self {
            roots: roots(self.roots),
            ..self
        }
    }

    /// The same, with the operations of the kinematics counted as well, where there are any.
    fn counted(mut self, model: &Model<'g>) -> Self {
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
type Candidate<'g> = (Form, Vec<Expr<'g>>);

/// A way to solve for the accelerations and for their derivatives.
struct Way<'a, 'g> {
    form: Form,
    inverse: &'a dyn Inverse<'g>,
    accelerations: &'a [Expr<'g>],
    /// The derivatives, column by column.
    columns: &'a [Expr<'g>],
}

/// Dynamics in some form and, where it is known in a better form, the determinant of the mass matrix.
type Written<'g> = (Form, Dynamics<'g>, Option<Expr<'g>>);

/// Articulated bodies with orientations, and what they are in balance by.
#[derive(Debug)]
struct ByLinks<'g> {
    form: Form,
    accelerations: Vec<Expr<'g>>,
    balance: Vec<Expr<'g>>,
    articulation: Articulation<'g>,
}

/// All forms of the dynamics of a scene.
#[derive(Debug)]
pub(crate) struct Forms<'g> {
    forms: Vec<Written<'g>>,
    /// In place of them what the accelerations are solved from, where bodies have orientations: one matrix and one residual, so that
    /// the Jacobian is that of the right-hand side where a quaternion is not of unit length.
    oriented: Vec<Written<'g>>,
    /// In place of both, where it is shorter.
    by_links: Option<ByLinks<'g>>,
    /// The bodies along whose axes these accelerations are.
    floating: Vec<Floating<'g>>,
    /// The accelerations of two coordinates with all that cancels gone.
    exact: Vec<Candidate<'g>>,
    /// The accelerations by articulated bodies.
    articulated: Vec<Candidate<'g>>,
    /// The accelerations in the shortest form, once they are known.
    solved: OnceCell<Chosen<'g>>,
    /// What symbols stand for that follow from the state.
    following: Following<'g>,
    normalizer: Normalizer<'g>,
}

impl<'g> Forms<'g> {
    /// The forms of a scene.
    pub(crate) fn new(model: &Model<'g>, dynamics: &Dynamics<'g>) -> Self {
        let g = model.graph;
        let mut normalizer = Normalizer::with_angles(g, BUDGET, model.base_angles());
        let has_orientations = model.has_orientations();
        let ways: &[bool] = if Dynamics::has_wrenches(model) && !has_orientations {
            &[false, true]
        } else {
            &[false]
        };
        let form = |basis, pushed| Form::of(basis).with_wrenches(pushed);
        let recursive = ways.iter().map(|&pushed| {
            let dynamics = Dynamics::recursive(model, dynamics.potential, pushed);
            (form(Basis::Recursive, pushed), dynamics)
        });
        let recursive: Vec<_> = recursive.collect();
        // where joints follow others, each does not give way by itself
        let give_way = !model.has_followers() && model.dependents.is_empty();
        let apart = if give_way && !has_orientations { ways } else { &[] };
        let articulated = apart.iter().map(|&pushed| {
            let (accelerations, _) = articulated(model, pushed, &[]);
            (form(Basis::Articulated, pushed), accelerations)
        });
        let articulated: Vec<Candidate<'g>> = articulated.collect();
        let lopsided = is_lopsided(&model.bodies);
        let (mut forms, mut exact) = (Vec::new(), Vec::new());
        if let Ok(closed) = Closed::new(&mut normalizer, dynamics) {
            for preference in Preference::ALL {
                let factored = closed.factored(g, &model.coordinates, preference);
                let accelerations = lopsided.then(|| closed.exact(g, &factored, preference)).flatten();
                exact.extend(accelerations.map(|x| (Form::of(Basis::Closed(preference)).exactly(), x)));
                let determinant = closed.determinant(g, preference);
                forms.push((Form::of(Basis::Closed(preference)), factored, determinant));
            }
        }
        let shared = (!has_orientations).then(|| (Form::of(Basis::Shared), dynamics.clone()));
        for (form, dynamics) in shared.into_iter().chain(recursive) {
            forms.push(folded(g, form, dynamics));
        }
        let (floating, pushed) = (model.floating(), Dynamics::has_wrenches(model));
        let mut oriented = Vec::new();
        if has_orientations && (pushed || !floating.is_empty()) {
            let dynamics = Dynamics::along_bodies(model, pushed, &floating);
            let divided = divided(model, &dynamics);
            for dynamics in [dynamics].into_iter().chain(divided) {
                if let Ok(closed) = Closed::new(&mut normalizer, &dynamics) {
                    let written = Preference::ALL.map(|preference| {
                        let factored = closed.factored(g, &model.coordinates, preference);
                        (form(Basis::Closed(preference), pushed), factored, None)
                    });
                    oriented.extend(written);
                }
                oriented.push(folded(g, form(Basis::Recursive, pushed), dynamics));
            }
        }
        let articulated = articulated.into_iter();
        let articulated = articulated.map(|(form, accelerations)| (form, constants::fold(g, &accelerations)));
        let articulated = articulated.collect();
        let mut forms = Self {
            forms,
            oriented,
            by_links: None,
            floating,
            exact,
            articulated,
            solved: OnceCell::new(),
            following: model.following.clone(),
            normalizer,
        };
        if give_way && has_orientations {
            forms.weigh_links(model, pushed);
        }
        forms
    }

    /// Takes articulated bodies where these are much shorter: a little is lost again in the Jacobian.
    fn weigh_links(&mut self, model: &Model<'g>, pushed: bool) {
        let (accelerations, articulation) = articulated(model, pushed, &self.floating);
        let by_matrix = self.accelerations();
        self.by_links = Some(ByLinks {
            form: Form::of(Basis::Articulated).with_wrenches(pushed),
            accelerations: constants::fold(model.graph, &accelerations),
            balance: Dynamics::balance_of_links(model, pushed, &self.floating),
            articulation,
        });
        let by_links = self.solve(&[]);
        let [links, matrix] = [&by_links, &by_matrix].map(|chosen| chosen.operations.weight());
        if matrix < links + links / WORTH_OF_LINKS {
            self.by_links = None;
        } else {
            self.solved = OnceCell::from(by_links);
        }
    }

    /// The dynamics in closed form with its products expanded, if the scene is small enough to have it.
    pub(crate) fn closed(&self) -> Option<&Dynamics<'g>> {
        self.on(Basis::Closed(Preference::Expanded))
    }

    /// The dynamics by recursion over the links.
    pub(crate) fn recursive(&self) -> Option<&Dynamics<'g>> {
        self.on(Basis::Recursive)
    }

    fn on(&self, wanted: Basis) -> Option<&Dynamics<'g>> {
        let mut forms = self.forms.iter();
        let found = forms.find(|(form, ..)| form.basis == wanted);
        found.map(|(_, dynamics, _)| dynamics)
    }

    /// The shortest code for something that every form of the dynamics has.
    pub(crate) fn part(&self, part: impl Fn(&Dynamics<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.forms.iter();
        let candidates = candidates.map(|(form, dynamics, _)| (*form, part(dynamics)));
        self.choose(candidates.collect())
    }

    /// The shortest code for something that is not known in closed form.
    fn part_of_graphs(&self, part: impl Fn(&Dynamics<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let graphs = self
            .forms
            .iter()
            .filter(|(form, ..)| !matches!(form.basis, Basis::Closed(_)));
        self.choose(graphs.map(|(form, dynamics, _)| (*form, part(dynamics))).collect())
    }

    /// The shortest code for the accelerations.
    pub(crate) fn accelerations(&self) -> Chosen<'g> {
        self.solved.get_or_init(|| self.solve(&[])).clone()
    }

    /// The shortest code for the accelerations, and for what is computed beside them.
    fn accelerations_and(&self, beside: &[Expr<'g>]) -> Chosen<'g> {
        if beside.is_empty() {
            self.accelerations()
        } else {
            self.solve(beside)
        }
    }

    fn solve(&self, beside: &[Expr<'g>]) -> Chosen<'g> {
        let mut candidates = Vec::new();
        if let Some(by_links) = &self.by_links {
            let solved = by_links.accelerations.clone();
            candidates.push((by_links.form, of_coordinates(&self.floating, solved)));
        }
        for (own, dynamics, determinant) in solved_from(&self.by_links, &self.oriented, &self.forms) {
            for (factored, solver) in factorings(dynamics, *determinant) {
                let form = own.solved_by(solver);
                let solved = factored.solve_negated(&dynamics.residual);
                candidates.push((form, of_coordinates(&self.floating, solved)));
            }
        }
        candidates.extend(self.exact.iter().cloned());
        candidates.extend(self.articulated.iter().cloned());
        for (_, roots) in &mut candidates {
            roots.extend(beside);
        }
        self.choose(candidates)
    }

    /// The shortest code for the derivatives of the accelerations by some symbols: column by column, and before them the accelerations
    /// themselves if these are wanted too. After them comes what is computed beside them.
    pub(crate) fn jacobian(
        &mut self,
        model: &Model<'g>,
        variables: &[Expr<'g>],
        with_accelerations: bool,
        beside: &[Expr<'g>],
    ) -> Chosen<'g> {
        self.solutions(model, variables, |way| {
            let accelerations = way.accelerations.iter().filter(|_| with_accelerations);
            accelerations.chain(way.columns).chain(beside).copied().collect()
        })
    }

    /// The shortest code for something that is made of the accelerations, and of their derivatives by some symbols.
    fn solutions(
        &mut self,
        model: &Model<'g>,
        variables: &[Expr<'g>],
        roots: impl Fn(&Way<'_, 'g>) -> Vec<Expr<'g>>,
    ) -> Chosen<'g> {
        let symbols: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
        // how the accelerations change where what is solved for stays as it is
        let beside = derived(&of_coordinates(&self.floating, symbols.clone()), variables);
        let floating = self.floating.clone();
        // the columns that an inverse leaves, for each way to the accelerations
        let derive = |inverse: &dyn Inverse<'g>,
                      ways: &[Candidate<'g>],
                      (derivatives, columns): &(Derivatives, Vec<Vec<Expr<'g>>>)| {
            let solved = columns.iter().zip(&beside).flat_map(|(column, beside)| {
                let mut column = inverse.solve_negated(column);
                floating
                    .iter()
                    .for_each(|joint| joint.differentiate(&mut column, beside));
                column
            });
            let solved = model.with_drives(&solved.collect::<Vec<_>>());
            let candidate = |(form, accelerations): &Candidate<'g>| {
                let known = symbols.iter().copied().zip(accelerations.iter().copied());
                let columns = model.graph.substitute(&solved, known.collect());
                let way = Way {
                    form: form.derived_by(*derivatives),
                    inverse,
                    accelerations: &of_coordinates(&floating, accelerations.clone()),
                    columns: &columns,
                };
                (way.form, roots(&way))
            };
            ways.iter().map(candidate).collect::<Vec<_>>()
        };
        let mut candidates = Vec::new();
        if let Some(by_links) = &self.by_links {
            let ways = [(by_links.form, by_links.accelerations.clone())];
            let columns = (Derivatives::Graph, derived(&by_links.balance, variables));
            candidates.extend(derive(&by_links.articulation, &ways, &columns));
        }
        let forms = solved_from(&self.by_links, &self.oriented, &self.forms);
        let sizes = forms.iter();
        let sizes = sizes.map(|(_, dynamics, _)| variables.len() * model.graph.reachable(&dynamics.entries()).len());
        let sizes: Vec<usize> = sizes.collect();
        let least = sizes.iter().copied().min().unwrap_or(0);
        for ((own, dynamics, determinant), size) in forms.iter().zip(sizes) {
            let is_large = size > MOST_DERIVED;
            if is_large && HOPELESS[1] * size > HOPELESS[0] * least {
                continue;
            }
            let by_recursion = partials_by_recursion(dynamics, &model.coordinates, variables);
            let mut columns = Vec::new();
            if !is_large || by_recursion.is_none() {
                columns = ways(&mut self.normalizer, own.basis, partials(dynamics, variables));
            }
            columns.extend(by_recursion.map(|columns| (Derivatives::Recursion, columns)));
            let exact = self.exact.iter().filter(|(form, _)| form.basis == own.basis);
            for (factored, solver) in factorings(dynamics, *determinant) {
                let form = own.solved_by(solver);
                let mut ways = vec![(form, factored.solve_negated(&dynamics.residual))];
                ways.extend(
                    exact
                        .clone()
                        .map(|(_, accelerations)| (form.exactly(), accelerations.clone())),
                );
                for columns in &columns {
                    candidates.extend(derive(&factored, &ways, columns));
                }
            }
        }
        self.choose(candidates)
    }

    /// The shortest code for the momenta and, behind them, their rates.
    pub(crate) fn canonical(&mut self, model: &Model<'g>) -> Chosen<'g> {
        let mut candidates = Vec::new();
        for (form, dynamics, _) in &self.forms {
            let rates = vec![momentum_rates(dynamics, model)];
            for (derivatives, rates) in ways(&mut self.normalizer, form.basis, rates) {
                let roots = dynamics.momentum.iter().copied().chain(rates.into_iter().flatten());
                candidates.push((form.derived_by(derivatives), roots.collect()));
            }
        }
        self.choose(candidates)
    }

    /// The shortest code for the derivatives of the momenta by the state, column by column, and behind them those of their rates.
    pub(crate) fn canonical_jacobian(&mut self, model: &Model<'g>) -> Chosen<'g> {
        let state = model.state();
        let mut candidates = Vec::new();
        for (form, dynamics, _) in &self.forms {
            let rates = vec![momentum_rates(dynamics, model)];
            let momenta = momentum_partials(dynamics, &model.coordinates);
            for (_, rates) in ways(&mut self.normalizer, form.basis, rates) {
                let columns = momenta.iter().cloned().chain(derived(&rates[0], &state)).collect();
                for (derivatives, columns) in ways(&mut self.normalizer, form.basis, columns) {
                    let roots = columns.into_iter().flatten().collect();
                    candidates.push((form.derived_by(derivatives), roots));
                }
            }
        }
        self.choose(candidates)
    }

    fn choose(&self, candidates: Vec<Candidate<'g>>) -> Chosen<'g> {
        let graph = self.normalizer.graph();
        let written_out = |(form, roots): Candidate<'g>| (form, self.following.written_out(graph, &roots));
        choose(graph, candidates.into_iter().map(written_out).collect())
    }
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

/// The forms with a mass matrix that the accelerations are solved from.
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

/// The accelerations of the coordinates, from what is solved for.
fn of_coordinates<'g>(floating: &[Floating<'g>], mut solved: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
    floating.iter().for_each(|joint| joint.accelerate(&mut solved));
    solved
}

/// Dynamics with constants that are zero, or equal, for a reason that shows in their normal form only.
fn folded<'g>(g: &'g Graph, form: Form, dynamics: Dynamics<'g>) -> Written<'g> {
    let folded = constants::fold(g, &dynamics.entries());
    (form, dynamics.with_entries(folded), None)
}

/// Columns of derivatives as they are, and in closed form where that is the basis.
fn ways<'g>(
    normalizer: &mut Normalizer<'g>,
    basis: Basis,
    columns: Vec<Vec<Expr<'g>>>,
) -> Vec<(Derivatives, Vec<Vec<Expr<'g>>>)> {
    let expanded = match basis {
        Basis::Closed(preference) => expanded(normalizer, &columns, preference),
        _ => None,
    };
    let expanded = expanded.map(|columns| (Derivatives::Expanded, columns));
    expanded.into_iter().chain([(Derivatives::Graph, columns)]).collect()
}

/// Whether one body may be much heavier than another: their masses are different expressions, other than numbers of one size.
fn is_lopsided(bodies: &[Body<'_>]) -> bool {
    /// Less than two digits can cancel between masses of this ratio.
    const EVEN: f64 = 100.0;
    let size = |mass: Expr<'_>| mass.constant().map(f64::abs);
    let uneven = |a: Expr<'_>, b: Expr<'_>| match (size(a), size(b)) {
        (Some(a), Some(b)) => a.max(b) > EVEN * a.min(b),
        _ => a != b,
    };
    let masses = bodies.iter().map(|body| body.inertia.mass);
    let masses: Vec<Expr<'_>> = masses.filter(|mass| !mass.is_zero()).collect();
    masses.iter().any(|&mass| uneven(mass, masses[0]))
}

/// Columns of expressions in closed form; none if they grow too large.
pub(crate) fn expanded<'g>(
    normalizer: &mut Normalizer<'g>,
    columns: &[Vec<Expr<'g>>],
    preference: Preference,
) -> Option<Vec<Vec<Expr<'g>>>> {
    let g = normalizer.graph();
    let mut short =
        |x: &Expr<'g>| closed::short_terms(normalizer, *x).map(|terms| factor::factor(g, &terms, preference));
    let columns = columns
        .iter()
        .map(|column| column.iter().map(&mut short).collect())
        .collect::<Result<_, _>>();
    columns.ok()
}

/// The factorings of the mass matrix that may be shortest.
fn factorings<'g>(dynamics: &Dynamics<'g>, determinant: Option<Expr<'g>>) -> Vec<(Factored<'g>, Solver)> {
    let coupled = dynamics.residual.len() == 2 && !dynamics.mass_matrix[0][1].is_zero();
    let solvers: &[Solver] = if coupled {
        &[Solver::Adjugate, Solver::Inverse, Solver::Ldl]
    } else {
        &[Solver::Ldl]
    };
    let factored = |&solver: &Solver| (Factored::new(solver, &dynamics.mass_matrix, determinant), solver);
    solvers.iter().map(factored).collect()
}

/// The candidate of the least weight once its common parts are shared; the first of equals. There is at least one.
/// An exact one may take a few more.
fn choose<'g>(g: &'g Graph, candidates: Vec<Candidate<'g>>) -> Chosen<'g> {
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
