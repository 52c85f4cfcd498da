//! Brings constants into normal form, so that constants that cancel are exactly zero and equal ones are the same node.

use rustc_hash::FxHashMap;

use crate::expr::{Expr, Graph, Level, Normalizer};

/// Maximum number of products of terms formed for the constants of one scene.
const BUDGET: usize = 100_000;

/// Replaces each constant operand of a varying expression by its normal form.
pub(crate) fn fold<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let mut normalizer = Normalizer::new(g, BUDGET);
    let mut folded = FxHashMap::default();
    for x in g.reachable(roots).into_iter().map(|id| g.expr(id)) {
        if x.level() == Level::Constant {
            continue;
        }
        for operand in x.operands() {
            let is_leaf = operand.operands().next().is_none();
            if is_leaf || operand.level() > Level::Constant || folded.contains_key(&operand) {
                continue;
            }
            if let Ok(normal) = normalizer.normal(operand) {
                folded.insert(operand, normalizer.to_expr(&normal));
            }
        }
    }
    g.substitute(roots, folded)
}
