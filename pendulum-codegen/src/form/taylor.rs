//! Power series of the motion, from the form of the dynamics that needs the fewest products of series.

use rustc_hash::{FxHashMap, FxHashSet};

use super::response::Rows;
use super::series::{Recurrences, Slot, Symbols};
use super::solved::of_coordinates;
use super::tangents::Tangents;
use super::written::Written;
use super::{Form, Forms};
use crate::dynamics::{Balance, Factored, Inverse};
use crate::expr::{Expr, Graph, Level};
use crate::model::Model;
use crate::pass::{Operations, share, trig};

/// Code for the coefficients of a motion `x_0, x_1, ..` in powers of time.
///
/// Order 0 is computed from the state. Each order `k` is then computed from the lower orders and from the kept values
/// of order 0, all as [`Symbols`].
#[derive(Clone, Debug)]
pub(crate) struct Taylor<'g> {
    /// Symbols for the quantities of order `k`.
    pub symbols: Symbols<'g>,
    /// Products of series.
    pub slots: Vec<Slot<'g>>,
    /// Roots of order 0: the right-hand side, then the values of [`Symbols::kept`].
    pub start: Vec<Expr<'g>>,
    /// Roots of order `k`: the right-hand side, the left factors of all products, their right factors, then the second
    /// derivatives of the constraints without the forces of this order.
    pub order: Vec<Expr<'g>>,
    /// Operations of one order `k`, without the sums of the products.
    pub operations: Operations,
    /// Form with the fewest products, then the fewest operations.
    pub form: Form,
    /// Best candidate on each other basis: its products, and its operations at each order.
    pub others: Vec<(Form, usize, Operations)>,
    /// Series of derivatives of the motion, if they are shorter than those of dual numbers.
    pub tangents: Option<Box<Tangents<'g>>>,
}

/// Maximum ratio, as a fraction, of products to the fewest products; forms beyond it skip the search for common
/// subexpressions.
const HOPELESS: [usize; 2] = [3, 2];

impl<'g> Forms<'g> {
    /// Returns the shortest code for the coefficients of the motion.
    pub(crate) fn taylor(&self, model: &Model<'g>) -> Taylor<'g> {
        let mut symbols = Symbols::new(model);
        let rows = model.is_hybrid().then(|| Rows::new(model));
        let unknowns: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
        let in_flight = model.written_out(&of_coordinates(&self.floating, unknowns.clone()));
        let forms = self.forms.iter().map(|written| (written, &unknowns));
        let forms = forms.chain(self.oriented.iter().map(|written| (written, &in_flight)));
        let mut candidates: Vec<(Unknown<'g>, usize)> = Vec::new();
        for (written, accelerations) in forms {
            let unknown = Unknown {
                written: written.written_out(model),
                accelerations: accelerations.clone(),
                of_constraints: rows
                    .as_ref()
                    .map_or_else(Vec::new, |rows| model.written_out(&rows.accelerations(accelerations))),
            };
            let slots = slots(model, &mut symbols, &unknown);
            candidates.push((unknown, slots));
        }
        let fewest = candidates.iter().map(|(_, slots)| *slots).min().unwrap_or(0);
        let mut counted: Vec<(Taylor<'g>, Balance<'g>, Factored<'g>)> = Vec::new();
        for (unknown, slots_before) in candidates {
            let mut ways = vec![unknown];
            if HOPELESS[1] * slots_before <= HOPELESS[0] * fewest {
                for factor in [false, true] {
                    ways.push(ways[0].shared(model.graph, factor));
                }
            }
            for unknown in ways {
                for (factored, form) in unknown.written.factorings() {
                    let taylor = code(model, symbols.clone(), form, (&unknown, &factored));
                    counted.push((taylor, unknown.written.balance.clone(), factored));
                }
            }
        }
        counted.sort_by_key(|(taylor, ..)| (taylor.slots.len(), taylor.operations.weight()));
        let mut counted = counted.into_iter();
        let (mut best, balance, factored) = counted.next().expect("there is a form of every scene");
        for (taylor, ..) in counted {
            let known = best.others.iter().map(|(form, ..)| form.basis).chain([best.form.basis]);
            if !known.into_iter().any(|basis| basis == taylor.form.basis) {
                best.others.push((taylor.form, taylor.slots.len(), taylor.operations));
            }
        }
        best.shorten(model.graph);
        let balance = (&balance.mass_matrix[..], &balance.residual[..]);
        best.tangents = Tangents::new(model, &best, balance, &factored).map(Box::new);
        best.with_kinematics(model)
    }
}

/// Linear system solved at every order, and the coordinate accelerations in terms of its unknowns. The two differ only
/// for floating bodies.
#[derive(Clone, Debug)]
struct Unknown<'g> {
    written: Written<'g>,
    accelerations: Vec<Expr<'g>>,
    /// Second derivatives of the constraints, in terms of the unknowns as well.
    of_constraints: Vec<Expr<'g>>,
}

impl<'g> Unknown<'g> {
    /// Copy in which the mass matrix and the residual share common subexpressions.
    fn shared(&self, g: &'g Graph, factor: bool) -> Self {
        let mut shared = self.clone();
        let Balance {
            mass_matrix, residual, ..
        } = &mut shared.written.balance;
        let n = residual.len();
        let roots = share(g, &[&mass_matrix.concat()[..], residual].concat(), factor);
        *mass_matrix = roots[..n * n].chunks(n.max(1)).map(<[Expr<'g>]>::to_vec).collect();
        *residual = roots[n * n..].to_vec();
        shared
    }
}

/// Number of products of series in the dynamics.
fn slots<'g>(model: &Model<'g>, symbols: &mut Symbols<'g>, unknown: &Unknown<'g>) -> usize {
    let mut recurrences = Recurrences::new(model, symbols);
    of_order(model, &mut recurrences, &unknown.written.balance);
    let known = model.written_out(&[model.kinematics(), model.state_rates()].concat());
    for &row in known
        .iter()
        .chain(&unknown.accelerations)
        .chain(&unknown.of_constraints)
    {
        recurrences.coefficient(row);
    }
    recurrences.sides();
    recurrences.slots.len()
}

/// Coefficients of order `k` of `A qdd + bias - force`, without the term `A_0 qdd_k`.
fn of_order<'g>(model: &Model<'g>, recurrences: &mut Recurrences<'g, '_>, balance: &Balance<'g>) -> Vec<Expr<'g>> {
    // the unknown `qdd_k` counts as zero, which leaves `A_0 qdd_k` out of every product
    for coordinate in &model.coordinates {
        recurrences.set(coordinate.acceleration, model.graph.zero());
    }
    let rows = balance.mass_matrix.iter().zip(&balance.residual);
    rows.map(|(row, &residual)| {
        let residual = recurrences.coefficient(residual);
        let products = row.iter().zip(&model.coordinates);
        products.fold(residual, |sum, (&entry, coordinate)| {
            sum + recurrences.product(entry, coordinate.acceleration)
        })
    })
    .collect()
}

/// Code for the dynamics in one form. The mass matrix is factored once, at order 0, and its factors are used at every
/// order: it is never inverted as a series.
fn code<'g>(
    model: &Model<'g>,
    mut symbols: Symbols<'g>,
    form: Form,
    (unknown, factored): (&Unknown<'g>, &Factored<'g>),
) -> Taylor<'g> {
    let g = model.graph;
    let Unknown {
        written,
        accelerations,
        of_constraints,
    } = unknown;
    let mut recurrences = Recurrences::new(model, &mut symbols);
    let balance = of_order(model, &mut recurrences, &written.balance);
    let unknowns: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
    for (&unknown, solved) in unknowns.iter().zip(factored.solve_negated(&balance)) {
        recurrences.set(unknown, solved);
    }
    let of_order = |&acceleration: &Expr<'g>| recurrences.coefficient(acceleration);
    let mut order: Vec<Expr<'g>> = accelerations.iter().map(of_order).collect();
    let rows: Vec<Expr<'g>> = of_constraints.iter().map(|&row| recurrences.coefficient(row)).collect();
    let kinematics = model.written_out(&model.kinematics());
    let kinematics: Vec<Expr<'g>> = kinematics.iter().map(|&rate| recurrences.coefficient(rate)).collect();
    order.splice(0..0, kinematics);
    let of_states = model.written_out(&model.state_rates());
    order.extend(of_states.iter().map(|&rate| recurrences.coefficient(rate)));
    let [left, right] = recurrences.sides();
    let slots = recurrences.slots;
    order.extend(left.into_iter().chain(right));
    let newest = symbols.forces.iter().map(|&force| (force, g.zero()));
    order.extend(g.substitute(&rows, newest.collect()));
    let changing = [symbols.order, symbols.over_order, symbols.time];
    let changing = changing.into_iter().chain(symbols.state.iter().copied());
    let changing = changing.chain(symbols.forces.iter().copied());
    let changing: FxHashSet<Expr<'g>> = changing.chain(symbols.sums[..slots.len()].iter().copied()).collect();
    let kept = kept(g, &order, changing);
    let mut names = FxHashMap::default();
    for (n, &value) in kept.iter().enumerate() {
        names.insert(value, Symbols::of_list(g, &mut symbols.kept, "kept", n));
    }
    let order = g.substitute(&order, names);
    let solved = factored.solve_negated(&written.balance.residual);
    let solved = unknowns.into_iter().zip(solved).collect();
    let start = g.substitute(&[&accelerations[..], &of_states, &kept].concat(), solved);
    symbols.sums.truncate(slots.len());
    symbols.kept.truncate(kept.len());
    Taylor {
        symbols,
        slots,
        operations: Operations::of(g, &order),
        start,
        order,
        form,
        others: Vec::new(),
        tangents: None,
    }
}

/// Largest subexpressions of the roots that depend on the state but on no quantity of order `k`.
pub(super) fn kept<'g>(g: &'g Graph, roots: &[Expr<'g>], mut changing: FxHashSet<Expr<'g>>) -> Vec<Expr<'g>> {
    let reachable: Vec<Expr<'g>> = g.reachable(roots).into_iter().map(|id| g.expr(id)).collect();
    let mut read: FxHashSet<Expr<'g>> = roots.iter().copied().collect();
    for &x in &reachable {
        if x.operands().any(|operand| changing.contains(&operand)) {
            changing.insert(x);
            read.extend(x.operands());
        }
    }
    let is_kept = |x: &Expr<'g>| x.level() == Level::State && read.contains(x) && !changing.contains(x);
    reachable.into_iter().filter(is_kept).collect()
}

/// The roots with common subexpressions shared, if this makes them shorter.
pub(super) fn shorter<'g>(g: &'g Graph, original: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
    let mut roots = original.clone();
    for factor in [false, true] {
        let shared = share(g, &original, factor);
        if Operations::of(g, &shared).weight() < Operations::of(g, &roots).weight() {
            roots = shared;
        }
    }
    roots
}

impl<'g> Taylor<'g> {
    /// Shares common subexpressions within the roots of order 0 and within those of order `k`.
    fn shorten(&mut self, g: &'g Graph) {
        self.start = shorter(g, trig::lower(g, &self.start));
        self.order = shorter(g, self.order.clone());
        self.operations = Operations::of(g, &self.order);
    }

    /// Prepends the rates of the positions to order 0; those of order `k` are already there.
    fn with_kinematics(mut self, model: &Model<'g>) -> Self {
        self.start.splice(0..0, model.written_out(&model.kinematics()));
        self
    }
}
