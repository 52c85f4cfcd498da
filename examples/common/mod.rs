//! What examples share.

pub(crate) mod chart;
pub(crate) mod page;
mod typeset;
