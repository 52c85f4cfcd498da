//! Constants in normal form, so that those which cancel are zero exactly, and equal ones are one.

use std::collections::HashMap;

use crate::expr::{ExprId, Graph, Level, Normalizer};

/// What the constants of one scene may take.
const BUDGET: usize = 100_000;

/// The roots with every constant operand of something that varies replaced by its normal form.
pub(crate) fn fold(g: &Graph, roots: &[ExprId]) -> Vec<ExprId> {
    let mut normalizer = Normalizer::new(BUDGET);
    let mut folded = HashMap::new();
    for id in g.reachable(roots) {
        if g.level(id) == Level::Constant {
            continue;
        }
        for operand in g.operands(id) {
            let is_leaf = g.operands(operand).next().is_none();
            if is_leaf || g.level(operand) > Level::Constant || folded.contains_key(&operand) {
                continue;
            }
            if let Ok(normal) = normalizer.normal(g, operand) {
                folded.insert(operand, normalizer.to_expr(g, &normal));
            }
        }
    }
    g.substitute(roots, folded)
}
