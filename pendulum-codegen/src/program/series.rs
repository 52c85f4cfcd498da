//! Power series of the motion.

use rustc_hash::FxHashMap;

use super::block::{Block, Coefficient, Variable};
use super::build::{NotFinite, block};
use super::routine::Cost;
use crate::expr::{Expr, ExprId};
use crate::form;
use crate::model::Model;

/// Code for the coefficients of a motion in powers of time: order 0 from the state, then each order from lower ones.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// Number of products of series.
    pub products: usize,
    /// Number of values of order 0 read by the other orders.
    pub kept: usize,
    /// Order 0: the right-hand side, then the kept values.
    pub start: Block,
    /// Order `k`, before the forces along the constraints are known: the second derivatives of the constraints without
    /// the forces of this order, then further values read by `order`.
    pub before: Block,
    /// Order `k`: the right-hand side, then the left factors of all products, then their right factors.
    pub order: Block,
    /// Cost of one order `k`, without the sums of the products.
    pub cost: Cost,
    /// Code for the derivatives of the motion, if it is shorter than that of the motion in dual numbers.
    pub tangents: Option<Tangents>,
}

/// Code for the coefficients of tangents: derivatives of a motion by initial conditions and parameters.
///
/// Entries are derivatives of the equations of motion. Those by coordinates, rates and accelerations are a square
/// matrix each. Those by constants are [`Variable::Factor`], the tangents of constants [`Variable::Weight`].
#[derive(Clone, Debug)]
pub struct Tangents {
    /// Number of products of series.
    pub products: usize,
    /// Number of entries by constants.
    pub by_constants: usize,
    /// Number of values of order 0 read by the other orders.
    pub kept: usize,
    /// Order 0, given the accelerations: the three matrices, row by row, the entries by constants, then the kept
    /// values.
    pub start: Block,
    /// Order `k`, given the accelerations of this order and factors of the motion: the matrices, the entries by
    /// constants, then the left factors of all products, then their right factors.
    pub order: Block,
    /// Tangents of the accelerations at order `k`, given the sums of the products of matrices and tangents, as
    /// [`Coefficient::Sum`].
    pub step: Block,
}

impl Tangents {
    fn new<'g>(
        model: &Model<'g>,
        tangents: &form::Tangents<'g>,
        known: &FxHashMap<ExprId, Variable>,
    ) -> Result<Self, NotFinite> {
        let (g, symbols) = (model.graph, &tangents.symbols);
        let numbered = |list: &[Expr<'g>], kind: fn(usize) -> Variable| -> Vec<(ExprId, Variable)> {
            list.iter().enumerate().map(|(n, x)| (x.id(), kind(n))).collect()
        };
        let constants = tangents.constants.iter().map(|constant| known[&constant.id()]);
        let values = tangents.values.iter().map(|value| value.id()).zip(constants.clone());
        let slopes = constants.map(|constant| match constant {
            Variable::Constant(n) => Variable::Weight(n),
            other => other,
        });
        let slopes = tangents.slopes.iter().map(|slope| slope.id()).zip(slopes);
        let variables = |lists: Vec<Vec<(ExprId, Variable)>>| -> FxHashMap<ExprId, Variable> {
            let of_lists = lists.into_iter().flatten();
            known
                .iter()
                .map(|(&id, &variable)| (id, variable))
                .chain(values.clone())
                .chain(of_lists)
                .collect()
        };
        let kept = numbered(&symbols.kept, |n| Variable::Series(Coefficient::Kept(n)));
        let of_order = variables(vec![
            numbered(&symbols.state, |n| Variable::Series(Coefficient::State(n))),
            numbered(&symbols.sums, |n| Variable::Series(Coefficient::Sum(n))),
            numbered(&tangents.accelerations, Variable::Acceleration),
            numbered(&tangents.sides, |n| Variable::Series(Coefficient::Side(n))),
            vec![
                (symbols.order.id(), Variable::Series(Coefficient::Order)),
                (symbols.over_order.id(), Variable::Series(Coefficient::OverOrder)),
            ],
            kept.clone(),
        ]);
        let of_tangents = variables(vec![
            numbered(&tangents.by_constants, Variable::Factor),
            numbered(&tangents.rows, |n| Variable::Series(Coefficient::Sum(n))),
            slopes.collect(),
            kept,
        ]);
        Ok(Self {
            products: tangents.slots,
            by_constants: tangents.by_constants.len(),
            kept: symbols.kept.len(),
            start: block(g, &tangents.start, &variables(Vec::new()))?,
            order: block(g, &tangents.order, &of_order)?,
            step: block(g, &tangents.step, &of_tangents)?,
        })
    }
}

impl Series {
    /// Series in the chosen form. `known` maps expressions to the variables that routines may read.
    pub(super) fn new<'g>(
        model: &Model<'g>,
        taylor: form::Taylor<'g>,
        known: &FxHashMap<ExprId, Variable>,
    ) -> Result<Self, NotFinite> {
        let (g, symbols) = (model.graph, &taylor.symbols);
        let mut of_order = known.clone();
        let lists = [
            (&symbols.state, Coefficient::State as fn(usize) -> Coefficient),
            (&symbols.sums, Coefficient::Sum),
            (&symbols.kept, Coefficient::Kept),
            (&symbols.forces, Coefficient::Force),
        ];
        let single = [
            (symbols.order, Coefficient::Order),
            (symbols.over_order, Coefficient::OverOrder),
            (symbols.time, Coefficient::Time),
        ];
        let of_lists = lists
            .iter()
            .flat_map(|(ids, kind)| ids.iter().enumerate().map(|(n, &id)| (id, kind(n))));
        of_order.extend(
            of_lists
                .chain(single)
                .map(|(id, coefficient)| (id.id(), Variable::Series(coefficient))),
        );
        let cost = |form, products, operations| Cost {
            products: Some(products),
            ..Cost::new(form, operations)
        };
        let others = taylor
            .others
            .iter()
            .map(|&(form, products, operations)| cost(form, products, operations));
        let is_force = |variable| matches!(variable, Variable::Series(Coefficient::Force(_)));
        let order = block(g, &taylor.order, &of_order)?;
        let [before, order] = if model.is_hybrid() {
            order.split(model.constraints.len(), is_force)
        } else {
            [Block::default(), order]
        };
        let tangents = taylor.tangents.as_deref();
        Ok(Self {
            tangents: tangents
                .map(|tangents| Tangents::new(model, tangents, known))
                .transpose()?,
            products: taylor.slots.len(),
            kept: symbols.kept.len(),
            start: block(g, &taylor.start, known)?,
            before,
            order,
            cost: Cost {
                others: others.collect(),
                ..cost(taylor.form, taylor.slots.len(), taylor.operations)
            },
        })
    }
}
