//! What examples share.

pub(crate) mod chart;
mod typeset;
