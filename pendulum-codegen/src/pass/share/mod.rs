//! Common parts of sums and products, found whatever the order and the brackets they were written in.
//!
//! Sums and products are taken apart into their operands; the pair of operands that most of them share becomes a value
//! of its own, again and again until no pair is shared; then what is left is put together. Constants of one product or
//! sum come together, so that they are computed once, when the model is built.

mod apart;
mod factor;
mod pairs;
mod parts;
mod rebuild;

use crate::expr::{Expr, Graph};
use pairs::Of;

/// Rewrites the roots so that common parts are shared. Their values do not change, up to rounding. `factor` says that
/// factors which terms of one sum share are drawn out first: that saves products, and may hide others that sums share.
pub(crate) fn share<'g>(g: &'g Graph, roots: &[Expr<'g>], factor: bool) -> Vec<Expr<'g>> {
    let (mut parts, roots) = apart::take_apart(g, roots);
    if factor {
        factor::factor_sums(&mut parts, &roots);
    }
    pairs::share_pairs(&mut parts, Of::Products);
    pairs::share_pairs(&mut parts, Of::Sums);
    rebuild::rebuild(g, &parts, &roots)
}
