//! Power series of the derivatives of a motion, by the series of the linearized equations of motion.
//!
//! Derivatives of the states by initial conditions and parameters are tangents. The equations of motion `r_i = 0`, rows
//! of a balance, are differentiated: `sum_j (dr_i/ds_j) s_j' + sum_c (dr_i/dc) c' = 0`, over the state and the
//! accelerations `s` and the constants `c`. The series of all `dr_i/ds_j` and `dr_i/dc` are the same for all tangents.
//! Rates and accelerations are derivatives of the coordinates, so that each tangent takes one product of series for
//! each equation and coordinate. Dual numbers, through the recurrences of the motion, take two for each product of two
//! series.
//!
//! E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993), section I.14, has
//! the linearized equations.

use rustc_hash::{FxHashMap, FxHashSet};

use super::series::{Recurrences, Side, Slot, Symbols};
use super::taylor::{Taylor, kept, shorter};
use crate::dynamics::{Factored, Inverse};
use crate::expr::{Binary, Derivative, Expr, Graph, Level, Node, SymbolKind, Unary};
use crate::model::Model;
use crate::pass::trig;

/// Maximum number of products of a motion whose derivatives get series of their own.
const MOST_PRODUCTS: usize = 64;

/// Number of tangents for which the series must pay.
const TANGENTS: usize = 4;

/// Maximum ratio, as a fraction, of their products to those of dual numbers.
const WORTH: [usize; 2] = [3, 4];

/// Code for the coefficients of tangents.
#[derive(Clone, Debug)]
pub(crate) struct Tangents<'g> {
    /// Symbols for the quantities of order `k`.
    pub symbols: Symbols<'g>,
    /// Symbols for the accelerations of order `k`.
    pub accelerations: Vec<Expr<'g>>,
    /// Symbols for the factors of the products of the motion, of order `k`: the left ones, then the right ones.
    pub sides: Vec<Expr<'g>>,
    /// Constants that have derivatives.
    pub constants: Vec<Expr<'g>>,
    /// Symbols for their values.
    pub values: Vec<Expr<'g>>,
    /// Symbols for their tangents.
    pub slopes: Vec<Expr<'g>>,
    /// Symbols for the distinct entries by constants, of order `k`.
    pub by_constants: Vec<Expr<'g>>,
    /// Symbols for the sums of the products with tangents of the motion, for each row.
    pub rows: Vec<Expr<'g>>,
    /// Number of products of series.
    pub slots: usize,
    /// Roots of order 0: the matrices of entries by coordinates, by rates and by accelerations, row by row, the entries
    /// by constants, then the values of [`Symbols::kept`].
    pub start: Vec<Expr<'g>>,
    /// Roots of order `k`: the matrices, the entries by constants, the left factors of all products, then their right
    /// factors.
    pub order: Vec<Expr<'g>>,
    /// Tangents of the accelerations at order `k`, given the sums of the products.
    pub step: Vec<Expr<'g>>,
}

impl<'g> Tangents<'g> {
    /// Derives the series of tangents of a motion, given its mass matrix, the rest of its balance, and the factored
    /// matrix. `None` if they are no shorter than those of dual numbers, or if the equations depend on the time or have
    /// functions without derivatives.
    pub(super) fn new(
        model: &Model<'g>,
        taylor: &Taylor<'g>,
        (mass_matrix, residual): (&[Vec<Expr<'g>>], &[Expr<'g>]),
        factored: &Factored<'g>,
    ) -> Option<Self> {
        let g = model.graph;
        let rates: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.rate).collect();
        let is_plain = !model.is_hybrid() && model.states.is_empty() && model.dependents.is_empty();
        if !is_plain || model.kinematics() != rates || taylor.slots.len() > MOST_PRODUCTS {
            return None;
        }
        let symbols = |name: &str, count: usize| -> Vec<Expr<'g>> {
            (0..count).map(|n| g.symbol(name, SymbolKind::Coefficient(n))).collect()
        };
        let unknowns: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
        let sums = symbols("row", unknowns.len());
        let rows = mass_matrix.iter().zip(residual).map(|(row, &residual)| {
            let products = row.iter().zip(&unknowns);
            products.fold(residual, |sum, (&entry, &unknown)| sum + entry * unknown)
        });
        let rows: Vec<Expr<'g>> = rows.collect();
        if !is_smooth(model, &rows) {
            return None;
        }
        let roots = [rows, factored.solve_negated(&sums)].concat();
        let constants = constants(g, &roots);
        let numbered = (model.parameters.len()..).take(constants.len());
        let values: Vec<Expr<'g>> = numbered
            .map(|n| g.symbol("constant", SymbolKind::Parameter(n)))
            .collect();
        let of_motion =
            [|slot: &Slot<'g>| slot.left, |slot: &Slot<'g>| slot.right].map(|side| taylor.slots.iter().map(side));
        let of_motion: Vec<Side<'g>> = of_motion.into_iter().flatten().collect();
        let roots = roots.into_iter().chain(of_motion.iter().map(|side| side.value));
        let roots: Vec<Expr<'g>> = roots.collect();
        let mut roots = g.substitute(&roots, constants.iter().copied().zip(values.iter().copied()).collect());
        let factors = roots.split_off(2 * unknowns.len());
        let (rows, solved) = roots.split_at(unknowns.len());

        let mut own = Symbols::new(model);
        let slopes = symbols("dc", constants.len());
        let derivatives = |symbols: &[Expr<'g>]| -> Vec<Derivative<'g>> {
            symbols.iter().map(|&symbol| Derivative::by(symbol)).collect()
        };
        let mut all = Vec::new();
        for mut derivatives in [derivatives(&model.state()), derivatives(&unknowns)] {
            for derivatives in derivatives.chunks_mut(unknowns.len().max(1)) {
                for &row in rows {
                    all.extend(derivatives.iter_mut().map(|derivative| derivative.of(row)));
                }
            }
        }
        let mut by_constants = Entries::new(g, "slope");
        let mut of_constants = derivatives(&values);
        let right_sides = rows.iter().zip(&sums).map(|(&row, &sum)| {
            let products = of_constants.iter_mut().zip(&slopes);
            let products = products.fold(g.zero(), |products, (derivative, &slope)| {
                let entry = derivative.of(row);
                if entry.is_zero() {
                    products
                } else {
                    products + by_constants.symbol(entry) * slope
                }
            });
            // the sum is known last
            products + sum
        });
        let right_sides: Vec<Expr<'g>> = right_sides.collect();
        let step = g.substitute(solved, sums.iter().copied().zip(right_sides).collect());

        let accelerations = symbols("a[k]", unknowns.len());
        let mut recurrences = Recurrences::new(model, &mut own);
        let sides = symbols("side", factors.len());
        for ((&factor, side), &symbol) in factors.iter().zip(&of_motion).zip(&sides) {
            if !side.weighted {
                recurrences.set_first(factor, symbol);
                recurrences.set_first(-factor, -symbol);
            }
        }
        for (&unknown, &acceleration) in unknowns.iter().zip(&accelerations) {
            recurrences.set(unknown, acceleration);
        }
        all.extend(&by_constants.values);
        let mut order: Vec<Expr<'g>> = all.iter().map(|&entry| recurrences.coefficient(entry)).collect();
        let [left, right] = recurrences.sides();
        let slots = left.len();
        let [products, of_duals] = [
            taylor.slots.len() + slots + unknowns.len() * unknowns.len() * TANGENTS,
            taylor.slots.len() * (1 + 2 * TANGENTS),
        ];
        if WORTH[1] * products > WORTH[0] * of_duals {
            return None;
        }
        order.extend(left.into_iter().chain(right));
        let changing = [own.order, own.over_order].into_iter().chain(own.state.iter().copied());
        let changing = changing
            .chain(own.sums[..slots].iter().copied())
            .chain(accelerations.iter().chain(&sides).copied());
        let changing = changing.chain(slopes.iter().copied()).chain(sums.iter().copied());
        let changing: FxHashSet<Expr<'g>> = changing.chain(by_constants.symbols.iter().copied()).collect();
        let of_order = order.len();
        let roots = [order, step].concat();
        let kept = kept(g, &roots, changing);
        let mut names = FxHashMap::default();
        for (n, &value) in kept.iter().enumerate() {
            names.insert(value, Symbols::of_list(g, &mut own.kept, "kept", n));
        }
        let mut order = g.substitute(&roots, names);
        let step = order.split_off(of_order);
        own.sums.truncate(slots);
        own.kept.truncate(kept.len());
        Some(Self {
            symbols: own,
            accelerations,
            sides,
            constants,
            values,
            slopes,
            by_constants: by_constants.symbols,
            rows: sums,
            slots,
            start: shorter(g, trig::lower(g, &[all, kept].concat())),
            order: shorter(g, order),
            step: shorter(g, step),
        })
    }
}

/// Distinct entries, with a symbol for each.
struct Entries<'g> {
    graph: &'g Graph,
    name: &'static str,
    values: Vec<Expr<'g>>,
    symbols: Vec<Expr<'g>>,
}

impl<'g> Entries<'g> {
    fn new(graph: &'g Graph, name: &'static str) -> Self {
        Self {
            graph,
            name,
            values: Vec::new(),
            symbols: Vec::new(),
        }
    }

    fn symbol(&mut self, entry: Expr<'g>) -> Expr<'g> {
        let known = self.values.iter().position(|&known| known == entry);
        let n = known.unwrap_or_else(|| {
            self.values.push(entry);
            self.values.len() - 1
        });
        Symbols::of_list(self.graph, &mut self.symbols, self.name, n)
    }
}

/// Largest expressions of parameters in the roots.
fn constants<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let of_state = g.reachable(roots).into_iter().map(|id| g.expr(id));
    let of_state = of_state.filter(|x| x.level() == Level::State);
    let read = of_state.flat_map(Expr::operands).chain(roots.iter().copied());
    let mut constants: Vec<Expr<'g>> = read.filter(|x| x.level() == Level::Parameter).collect();
    constants.sort();
    constants.dedup();
    constants
}

/// True if the expressions do not depend on the time, and have derivatives wherever they have a value.
fn is_smooth<'g>(model: &Model<'g>, roots: &[Expr<'g>]) -> bool {
    let g = model.graph;
    g.reachable(roots)
        .into_iter()
        .map(|id| g.expr(id))
        .all(|x| match x.node() {
            Node::Unary(Unary::Abs | Unary::Sign, _) | Node::Binary(Binary::Atan2 | Binary::Max | Binary::Min, ..) => {
                false
            }
            Node::Power(_, n) => n.is_integer(),
            _ => x != model.time,
        })
}
