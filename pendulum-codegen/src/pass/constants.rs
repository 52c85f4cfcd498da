//! Constants in normal form, so that those which cancel are zero exactly, and equal ones are one.

use rustc_hash::FxHashMap;

use crate::expr::{Expr, Graph, Level, Normalizer};

/// What the constants of one scene may take.
const BUDGET: usize = 100_000;

/// The roots with every constant operand of something that varies replaced by its normal form.
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
