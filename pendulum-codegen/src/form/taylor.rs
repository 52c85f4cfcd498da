//! The power series of the motion: which form of the dynamics gives its coefficients with the fewest products of series.

use std::collections::{HashMap, HashSet};

use super::series::{Recurrences, Symbols};
use super::{Form, Forms, factorings};
use crate::dynamics::{Dynamics, Factored};
use crate::expr::{ExprId, Graph, Level};
use crate::model::Model;
use crate::pass::{Operations, share, trig};

/// Code for the coefficients of a motion `x_0, x_1, ..` in powers of time.
///
/// Order 0 is computed from the state; then each order `k` from the orders before it and from what order 0 has left, in
/// the [`Symbols`].
#[derive(Clone, Debug)]
pub struct Taylor {
    /// What stands for the quantities of order `k`.
    pub symbols: Symbols,
    /// The number of products of series.
    pub slots: usize,
    /// Of order 0: the accelerations, then what [`Symbols::kept`] stands for.
    pub start: Vec<ExprId>,
    /// Of order `k`: the accelerations, then the left sides of all products, then their right sides.
    pub order: Vec<ExprId>,
    /// Operations of one order `k`, without the sums of the products.
    pub operations: Operations,
    /// The form that won.
    pub form: Form,
    /// The best on each other basis: its products, and its operations for each order.
    pub others: Vec<(Form, usize, Operations)>,
}

/// Forms with more products than the fewest by this ratio are not searched for common parts.
const HOPELESS: [usize; 2] = [3, 2];

impl Forms {
    /// The shortest code for the coefficients of the motion.
    pub fn taylor(&self, model: &Model) -> Taylor {
        let mut symbols = Symbols::new(model);
        let mut candidates: Vec<(Form, Dynamics, Option<ExprId>, usize)> = Vec::new();
        for (basis, dynamics, determinant) in &self.forms {
            let slots = slots(model, &mut symbols, dynamics);
            candidates.push((Form::of(*basis), dynamics.clone(), *determinant, slots));
        }
        let fewest = candidates.iter().map(|(.., slots)| *slots).min().unwrap_or(0);
        let mut counted: Vec<Taylor> = Vec::new();
        for (form, dynamics, determinant, slots_before) in candidates {
            let mut ways = vec![dynamics];
            if HOPELESS[1] * slots_before <= HOPELESS[0] * fewest {
                for factor in [false, true] {
                    ways.push(shared(&model.graph, &ways[0], factor));
                }
            }
            for dynamics in ways {
                for (factored, solver) in factorings(&model.graph, &dynamics, determinant) {
                    let form = form.solved_by(solver);
                    counted.push(code(model, symbols.clone(), form, &dynamics, &factored));
                }
            }
        }
        counted.sort_by_key(|taylor| (taylor.slots, taylor.operations.weight()));
        let mut counted = counted.into_iter();
        let mut best = counted.next().expect("there is a form of every scene");
        for taylor in counted {
            let known = best.others.iter().map(|(form, ..)| form.basis).chain([best.form.basis]);
            if !known.into_iter().any(|basis| basis == taylor.form.basis) {
                best.others.push((taylor.form, taylor.slots, taylor.operations));
            }
        }
        best.shorten(&model.graph);
        best
    }
}

/// The dynamics with common parts of the mass matrix and the residual shared.
fn shared(g: &Graph, dynamics: &Dynamics, factor: bool) -> Dynamics {
    let n = dynamics.residual.len();
    let mut roots: Vec<ExprId> = dynamics.mass_matrix.concat();
    roots.extend(&dynamics.residual);
    let roots = share(g, &roots, factor);
    let mut dynamics = dynamics.clone();
    dynamics.mass_matrix = roots[..n * n].chunks(n).map(<[ExprId]>::to_vec).collect();
    dynamics.residual = roots[n * n..].to_vec();
    dynamics
}

/// How many products of series the dynamics take.
fn slots(model: &Model, symbols: &mut Symbols, dynamics: &Dynamics) -> usize {
    let mut recurrences = Recurrences::new(model, symbols);
    balance(model, &mut recurrences, dynamics);
    recurrences.sides(&model.graph);
    recurrences.slots.len()
}

/// The coefficients of order `k` of `A qdd + bias - force`, but for `A_0 qdd_k`.
fn balance(model: &Model, recurrences: &mut Recurrences<'_>, dynamics: &Dynamics) -> Vec<ExprId> {
    let Model {
        graph: g, coordinates, ..
    } = model;
    // what is not known yet is left out of every product
    for coordinate in coordinates.iter() {
        recurrences.set(coordinate.acceleration, g.zero());
    }
    let rows = dynamics.mass_matrix.iter().zip(&dynamics.residual);
    rows.map(|(row, &residual)| {
        let residual = recurrences.coefficient(g, residual);
        row.iter()
            .zip(coordinates.iter())
            .fold(residual, |sum, (&entry, coordinate)| {
                let known = recurrences.product(g, entry, coordinate.acceleration);
                g.add(sum, known)
            })
    })
    .collect()
}

/// Code for the dynamics in one form. The mass matrix is factored at order 0, and solved with at every order: it is never inverted as
/// a series.
fn code(model: &Model, mut symbols: Symbols, form: Form, dynamics: &Dynamics, factored: &Factored) -> Taylor {
    let mut recurrences = Recurrences::new(model, &mut symbols);
    let balance = balance(model, &mut recurrences, dynamics);
    let Model {
        graph: g, coordinates, ..
    } = model;
    let mut order = factored.solve_negated(g, &balance);
    let unknowns: Vec<ExprId> = coordinates.iter().map(|c| c.acceleration).collect();
    for (&unknown, &solved) in unknowns.iter().zip(&order) {
        recurrences.set(unknown, solved);
    }
    let [left, right] = recurrences.sides(g);
    let slots = left.len();
    order.extend(left.into_iter().chain(right));
    let changing = [symbols.order, symbols.over_order, symbols.time];
    let changing = changing.into_iter().chain(symbols.state.iter().copied());
    let changing: HashSet<ExprId> = changing.chain(symbols.sums[..slots].iter().copied()).collect();
    let kept = kept(g, &order, changing);
    let mut names = HashMap::new();
    for (n, &value) in kept.iter().enumerate() {
        names.insert(value, Symbols::of_list(g, &mut symbols.kept, "kept", n));
    }
    let order = g.substitute(&order, names);
    let mut start = factored.solve_negated(g, &dynamics.residual);
    let solved = unknowns.into_iter().zip(start.iter().copied()).collect();
    start.extend(g.substitute(&kept, solved));
    symbols.sums.truncate(slots);
    symbols.kept.truncate(kept.len());
    Taylor {
        symbols,
        slots,
        operations: Operations::of(g, &order),
        start,
        order,
        form,
        others: Vec::new(),
    }
}

/// The largest expressions of the state within the roots that nothing of order `k` is part of.
fn kept(g: &Graph, roots: &[ExprId], mut changing: HashSet<ExprId>) -> Vec<ExprId> {
    let reachable = g.reachable(roots);
    let mut read: HashSet<ExprId> = roots.iter().copied().collect();
    for &id in &reachable {
        if g.operands(id).any(|operand| changing.contains(&operand)) {
            changing.insert(id);
            read.extend(g.operands(id));
        }
    }
    let is_kept = |id: &ExprId| g.level(*id) == Level::State && read.contains(id) && !changing.contains(id);
    reachable.into_iter().filter(is_kept).collect()
}

impl Taylor {
    /// Shares common parts of what is computed once, and of what is computed at every order.
    fn shorten(&mut self, g: &Graph) {
        self.start = trig::lower(g, &self.start);
        for roots in [&mut self.start, &mut self.order] {
            let original = roots.clone();
            for factor in [false, true] {
                let shared = share(g, &original, factor);
                if Operations::of(g, &shared).weight() < Operations::of(g, roots).weight() {
                    *roots = shared;
                }
            }
        }
        self.operations = Operations::of(g, &self.order);
    }
}
