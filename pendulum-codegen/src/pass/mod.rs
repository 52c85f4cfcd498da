//! Rewrites expressions into shorter forms of equal value. Nothing here depends on mechanics.

mod angles;
pub(crate) mod constants;
pub(crate) mod cost;
pub(crate) mod factor;
mod flat;
mod nest;
mod share;
pub(crate) mod trig;

pub(crate) use angles::collect;
pub(crate) use angles::collect_squares_first;
pub use cost::Operations;
pub(crate) use factor::Products;
pub(crate) use nest::nest;
pub(crate) use share::share;
