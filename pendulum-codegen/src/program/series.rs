//! Power series of the motion.

use rustc_hash::FxHashMap;

use super::block::{Block, Coefficient, Variable};
use super::build::{NotFinite, block};
use super::routine::Cost;
use crate::expr::ExprId;
use crate::form::Taylor;
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
}

impl Series {
    /// Series in the chosen form. `known` maps expressions to the variables that routines may read.
    pub(super) fn new<'g>(
        model: &Model<'g>,
        taylor: Taylor<'g>,
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
        Ok(Self {
            products: taylor.slots,
            kept: symbols.kept.len(),
            start: block(g, &taylor.start, known)?,
            before,
            order,
            cost: Cost {
                others: others.collect(),
                ..cost(taylor.form, taylor.slots, taylor.operations)
            },
        })
    }
}
