//! From dynamics to short code: generates several forms of the same motion, weighs them, and keeps the lightest.

mod adjoint;
mod canonical;
mod chosen;
mod closed;
mod columns;
mod exact;
mod kind;
mod output;
mod response;
mod routines;
mod series;
mod solved;
mod tangents;
mod taylor;
mod written;

use std::cell::OnceCell;

pub(crate) use adjoint::{adjoint, hessian_product};
pub(crate) use chosen::Chosen;
use chosen::{Candidate, choose};
use closed::Closed;
pub(crate) use kind::{Basis, Derivatives, Form};
pub(crate) use output::{as_declared, rates, values, values_and_jacobian, values_and_rates};
pub(crate) use response::{measure_derivatives, measures, response, response_derivative};
pub(crate) use routines::*;
use solved::{ByLinks, of_coordinates};
pub(crate) use tangents::Tangents;
pub(crate) use taylor::Taylor;
use written::{Written, along_bodies, folded};

use crate::dynamics::{Balance, Dynamics, Lagrangian, Reactions, articulated};
use crate::expr::{Expr, Normalizer};
use crate::model::{Body, Dependence, Floating, Model};
use crate::pass::{Products, constants, factor};

/// Maximum number of products of terms in the closed form of a scene. Larger scenes keep the shared graph.
const BUDGET: usize = 20_000;

/// Inverse of the minimum saving for articulated bodies with orientations: they replace the solution by a mass matrix
/// if that is longer by at least one part in `WORTH_OF_LINKS`.
const WORTH_OF_LINKS: usize = 8;

/// All forms of the dynamics of a scene.
#[derive(Debug)]
pub(crate) struct Forms<'g> {
    forms: Vec<Written<'g>>,
    /// The other Lagrangian terms, in the same forms.
    lagrangians: Vec<Lagrangian<'g>>,
    /// Reaction forces of the joints, in the forms that provide them.
    reactions: Vec<(Form, Reactions<'g>)>,
    /// Linear systems that replace `forms` for the accelerations if bodies have orientations: one matrix and one
    /// residual each. The Jacobian is then the derivative of the right-hand side also for quaternions off unit length.
    oriented: Vec<Written<'g>>,
    /// Articulated bodies, which replace both if they are shorter.
    by_links: Option<ByLinks<'g>>,
    /// Floating bodies, whose accelerations are along their own axes.
    floating: Vec<Floating<'g>>,
    /// Accelerations in explicit form: by articulated bodies, and of two coordinates without cancelling terms.
    solved: Vec<Candidate<'g>>,
    /// Cache of the shortest code for the accelerations.
    accelerations: OnceCell<Chosen<'g>>,
    /// Expressions of dependent symbols.
    dependence: Dependence<'g>,
    normalizer: Normalizer<'g>,
}

impl<'g> Forms<'g> {
    /// Builds the forms of a scene.
    pub(crate) fn new(model: &Model<'g>, dynamics: &Dynamics<'g>) -> Self {
        let g = model.graph;
        let mut normalizer = Normalizer::with_angles(g, BUDGET, model.base_angles());
        let (has_orientations, has_wrenches) = (model.has_orientations(), Dynamics::has_wrenches(model));
        let ways: &[bool] = if has_wrenches && !has_orientations {
            &[false, true]
        } else {
            &[false]
        };
        let recursive = ways.iter().map(|&pushed| {
            let dynamics = Dynamics::recursive(model, dynamics.lagrangian.potential, pushed);
            (Form::of(Basis::Recursive).with_wrenches(pushed), dynamics)
        });
        let recursive: Vec<_> = recursive.collect();
        let (mut forms, mut lagrangians, mut solved) = closed_forms(model, &mut normalizer, dynamics);
        // the articulated-body algorithm needs joints that move independently
        let give_way = !model.has_followers() && model.dependents.is_empty();
        if give_way && !has_orientations && forms.is_empty() {
            solved.extend(ways.iter().map(|&pushed| {
                let (accelerations, _) = articulated(model, pushed, &[]);
                let accelerations = constants::fold(g, &accelerations);
                (Form::of(Basis::Articulated).with_wrenches(pushed), accelerations)
            }));
        }
        let shared = (!has_orientations && forms.is_empty()).then(|| (Form::of(Basis::Shared), dynamics.clone()));
        let mut all_reactions = Vec::new();
        for (form, dynamics) in shared.into_iter().chain(recursive) {
            let Dynamics {
                balance,
                lagrangian,
                reactions,
            } = folded(g, dynamics);
            forms.push(Written::new(form, balance));
            lagrangians.push(lagrangian);
            all_reactions.push((form, reactions));
        }
        let floating = model.floating();
        let oriented = if has_orientations && (has_wrenches || !floating.is_empty()) {
            along_bodies(model, &mut normalizer, has_wrenches, &floating)
        } else {
            Vec::new()
        };
        let mut forms = Self {
            forms,
            lagrangians,
            reactions: all_reactions,
            oriented,
            by_links: None,
            floating,
            solved,
            accelerations: OnceCell::new(),
            dependence: model.loops.dependence.clone(),
            normalizer,
        };
        if give_way && has_orientations {
            forms.weigh_links(model, has_wrenches);
        }
        forms
    }

    /// Uses articulated bodies if they are much shorter. A small saving would be lost again in derivatives.
    fn weigh_links(&mut self, model: &Model<'g>, pushed: bool) {
        let form = Form::of(Basis::Articulated).with_wrenches(pushed);
        let (accelerations, articulation) = articulated(model, pushed, &self.floating);
        let accelerations = constants::fold(model.graph, &accelerations);
        let by_matrix = self.accelerations();
        let by_links = self.choose(vec![(form, of_coordinates(&self.floating, accelerations.clone()))]);
        let [links, matrix] = [&by_links, &by_matrix].map(|chosen| chosen.operations.weight());
        if matrix >= links + links / WORTH_OF_LINKS {
            self.accelerations = OnceCell::from(by_links);
            self.by_links = Some(ByLinks {
                form,
                accelerations,
                balance: Dynamics::balance_of_links(model, pushed, &self.floating),
                articulation,
            });
        }
    }

    /// Balance and Lagrangian terms in closed form with products expanded, if the scene is small enough.
    pub(crate) fn closed(&self) -> Option<(&Balance<'g>, &Lagrangian<'g>)> {
        self.on(Basis::Closed(Products::Expanded))
    }

    /// Balance and Lagrangian terms by recursion over the links.
    pub(crate) fn recursive(&self) -> (&Balance<'g>, &Lagrangian<'g>) {
        self.on(Basis::Recursive).expect("every scene has this form")
    }

    fn on(&self, wanted: Basis) -> Option<(&Balance<'g>, &Lagrangian<'g>)> {
        let at = self.forms.iter().position(|written| written.form.basis == wanted)?;
        Some((&self.forms[at].balance, &self.lagrangians[at]))
    }

    /// Returns the shortest code for `part` of a balance.
    pub(crate) fn of_balance(&self, part: impl Fn(&Balance<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.forms.iter();
        let candidates = candidates.map(|written| (written.form, part(&written.balance)));
        self.choose(candidates.collect())
    }

    /// Returns the shortest code for `part` of the Lagrangian terms.
    pub(crate) fn term(&self, part: impl Fn(&Lagrangian<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.forms.iter().zip(&self.lagrangians);
        let candidates = candidates.map(|(written, lagrangian)| (written.form, part(lagrangian)));
        self.choose(candidates.collect())
    }

    /// Returns the shortest code for `part` of the reaction forces.
    pub(crate) fn of_reactions(&self, part: impl Fn(&Reactions<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.reactions.iter();
        self.choose(candidates.map(|(form, reactions)| (*form, part(reactions))).collect())
    }

    /// Floating bodies, whose accelerations are along their own axes.
    fn floating(&self) -> &[Floating<'g>] {
        &self.floating
    }

    fn choose(&self, candidates: Vec<Candidate<'g>>) -> Chosen<'g> {
        self.choose_of(candidates).0
    }

    /// Returns the shortest code, and the index of its candidate.
    fn choose_of(&self, candidates: Vec<Candidate<'g>>) -> (Chosen<'g>, usize) {
        let graph = self.normalizer.graph();
        let written_out = |(form, roots): Candidate<'g>| (form, self.dependence.written_out(graph, &roots));
        choose(graph, candidates.into_iter().map(written_out).collect())
    }
}

/// Closed forms of a scene, if it is small enough, and its accelerations without cancelling terms.
fn closed_forms<'g>(
    model: &Model<'g>,
    normalizer: &mut Normalizer<'g>,
    dynamics: &Dynamics<'g>,
) -> (Vec<Written<'g>>, Vec<Lagrangian<'g>>, Vec<Candidate<'g>>) {
    let g = model.graph;
    let lopsided = is_lopsided(&model.bodies);
    let (mut forms, mut lagrangians, mut exact) = (Vec::new(), Vec::new(), Vec::new());
    if let Ok(closed) = Closed::new(normalizer, dynamics) {
        for products in Products::ALL {
            let form = Form::of(Basis::Closed(products));
            let (balance, lagrangian) = closed.factored(model, products);
            let accelerations = lopsided.then(|| closed.exact(g, &balance, products)).flatten();
            exact.extend(accelerations.map(|accelerations| (form.exactly(), accelerations)));
            forms.push(Written {
                determinant: closed.determinant(g, products),
                ..Written::new(form, balance)
            });
            lagrangians.push(lagrangian);
        }
    }
    (forms, lagrangians, exact)
}

/// Columns of derivatives as they are, preceded by their expanded form on a closed basis.
fn ways<'g>(
    normalizer: &mut Normalizer<'g>,
    basis: Basis,
    columns: Vec<Vec<Expr<'g>>>,
) -> Vec<(Derivatives, Vec<Vec<Expr<'g>>>)> {
    let expanded = match basis {
        Basis::Closed(products) => expanded(normalizer, &columns, products),
        _ => None,
    };
    let expanded = expanded.map(|columns| (Derivatives::Expanded, columns));
    expanded.into_iter().chain([(Derivatives::Graph, columns)]).collect()
}

/// True if one body may be much heavier than another: their masses are different expressions, or numbers of different
/// magnitude.
fn is_lopsided(bodies: &[Body<'_>]) -> bool {
    /// Maximum ratio of masses of similar magnitude. At this ratio cancellation costs less than two digits.
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

/// Expands columns of expressions to closed form. Returns `None` if they grow too large.
pub(crate) fn expanded<'g>(
    normalizer: &mut Normalizer<'g>,
    columns: &[Vec<Expr<'g>>],
    products: Products,
) -> Option<Vec<Vec<Expr<'g>>>> {
    let g = normalizer.graph();
    let mut short = |x: &Expr<'g>| closed::short_terms(normalizer, *x).map(|terms| factor::factor(g, &terms, products));
    let columns = columns
        .iter()
        .map(|column| column.iter().map(&mut short).collect())
        .collect::<Result<_, _>>();
    columns.ok()
}
