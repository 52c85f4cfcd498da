//! What examples share.
#![allow(dead_code, reason = "each example is a crate of its own and uses a part of this")]

pub(crate) mod chart;
mod label;
pub(crate) mod page;
pub(crate) mod reference;
mod typeset;
