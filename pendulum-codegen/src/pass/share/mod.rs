//! Common subexpressions of sums and products, found regardless of the order and bracketing of operands.
//!
//! Sums and products are decomposed into their operands. The pair of operands shared by most of them becomes an item of
//! its own, and this repeats until no pair is shared; then the items are put together again. Constants of one product
//! or sum are combined, so that they are computed once, when the model is built.

mod apart;
mod factor;
mod pairs;
mod parts;
mod rebuild;

use crate::expr::{Expr, Graph};
use pairs::Of;

/// Rewrites the roots so that common subexpressions are shared. Values are unchanged up to rounding. If `factor` is
/// set, common factors of the terms of a sum are extracted first: this saves products, but may hide subexpressions
/// shared by several sums.
pub(crate) fn share<'g>(g: &'g Graph, roots: &[Expr<'g>], factor: bool) -> Vec<Expr<'g>> {
    let (mut parts, roots) = apart::take_apart(g, roots);
    if factor {
        factor::factor_sums(&mut parts, &roots);
    }
    pairs::share_pairs(&mut parts, Of::Products);
    pairs::share_pairs(&mut parts, Of::Sums);
    rebuild::rebuild(g, &parts, &roots)
}
