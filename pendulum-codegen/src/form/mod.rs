//! From dynamics to short code: forms of the same motion are made, weighed, and the lightest is kept.

mod canonical;
mod chosen;
mod closed;
mod exact;
mod kind;
mod output;
mod response;
mod routines;
mod series;
mod solved;
mod taylor;
mod written;

use std::cell::OnceCell;

pub(crate) use chosen::Chosen;
use chosen::{Candidate, choose};
use closed::Closed;
pub(crate) use kind::{Basis, Derivatives, Form};
pub(crate) use output::{as_declared, rates, values, values_and_jacobian, values_and_rates};
pub(crate) use response::{measure_derivatives, measures, response, response_derivative};
pub(crate) use routines::*;
use solved::{ByLinks, of_coordinates};
pub(crate) use taylor::Taylor;
use written::{Written, along_bodies, folded};

use crate::dynamics::{Balance, Dynamics, Lagrangian, Reactions, articulated};
use crate::expr::{Expr, Normalizer};
use crate::model::{Body, Dependence, Floating, Model};
use crate::pass::{Products, constants, factor};

/// How many products of terms the closed form of a scene may take. Larger scenes keep the shared graph.
const BUDGET: usize = 20_000;

/// Articulated bodies with orientations are taken where what is solved by a mass matrix is longer: by one part in this
/// many at least.
const WORTH_OF_LINKS: usize = 8;

/// All forms of the dynamics of a scene.
#[derive(Debug)]
pub(crate) struct Forms<'g> {
    forms: Vec<Written<'g>>,
    /// The other terms in the same forms.
    lagrangians: Vec<Lagrangian<'g>>,
    /// What joints supply, in those of the forms that have it.
    reactions: Vec<(Form, Reactions<'g>)>,
    /// In place of them what the accelerations are solved from, where bodies have orientations: one matrix and one
    /// residual, so that the Jacobian is that of the right-hand side where a quaternion is not of unit length.
    oriented: Vec<Written<'g>>,
    /// In place of both, where it is shorter.
    by_links: Option<ByLinks<'g>>,
    /// The bodies along whose axes these accelerations are.
    floating: Vec<Floating<'g>>,
    /// Accelerations that need not be solved for: by articulated bodies, and those of two coordinates with all that
    /// cancels gone.
    solved: Vec<Candidate<'g>>,
    /// The accelerations in the shortest form, once they are known.
    accelerations: OnceCell<Chosen<'g>>,
    /// What symbols stand for that depend on the state.
    dependence: Dependence<'g>,
    normalizer: Normalizer<'g>,
}

impl<'g> Forms<'g> {
    /// The forms of a scene.
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
        // where joints follow others, each does not give way by itself
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

    /// Takes articulated bodies where these are much shorter: a little is lost again in the Jacobian.
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

    /// The balance and the other terms in closed form with products expanded, if the scene is small enough to have it.
    pub(crate) fn closed(&self) -> Option<(&Balance<'g>, &Lagrangian<'g>)> {
        self.on(Basis::Closed(Products::Expanded))
    }

    /// The same by recursion over the links.
    pub(crate) fn recursive(&self) -> (&Balance<'g>, &Lagrangian<'g>) {
        self.on(Basis::Recursive).expect("every scene has this form")
    }

    fn on(&self, wanted: Basis) -> Option<(&Balance<'g>, &Lagrangian<'g>)> {
        let at = self.forms.iter().position(|written| written.form.basis == wanted)?;
        Some((&self.forms[at].balance, &self.lagrangians[at]))
    }

    /// The shortest code for something that every balance has.
    pub(crate) fn of_balance(&self, part: impl Fn(&Balance<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.forms.iter();
        let candidates = candidates.map(|written| (written.form, part(&written.balance)));
        self.choose(candidates.collect())
    }

    /// The shortest code for something that is made of the other terms.
    pub(crate) fn term(&self, part: impl Fn(&Lagrangian<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.forms.iter().zip(&self.lagrangians);
        let candidates = candidates.map(|(written, lagrangian)| (written.form, part(lagrangian)));
        self.choose(candidates.collect())
    }

    /// The shortest code for something that is made of what joints supply.
    pub(crate) fn of_reactions(&self, part: impl Fn(&Reactions<'g>) -> Vec<Expr<'g>>) -> Chosen<'g> {
        let candidates = self.reactions.iter();
        self.choose(candidates.map(|(form, reactions)| (*form, part(reactions))).collect())
    }

    fn choose(&self, candidates: Vec<Candidate<'g>>) -> Chosen<'g> {
        let graph = self.normalizer.graph();
        let written_out = |(form, roots): Candidate<'g>| (form, self.dependence.written_out(graph, &roots));
        choose(graph, candidates.into_iter().map(written_out).collect())
    }
}

/// The closed forms of a scene that is small enough, and its accelerations with all that cancels gone.
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

/// Columns of derivatives as they are, and in closed form where that is the basis.
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

/// Whether one body may be much heavier than another: their masses are different expressions, other than numbers of one
/// size.
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
