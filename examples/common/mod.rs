//! What examples share.
#![allow(dead_code, reason = "each example is a crate of its own and uses a part of this")]

pub(crate) mod chart;
pub(crate) mod heat;
mod label;
pub(crate) mod methods;
pub(crate) mod page;
mod palette;
pub(crate) mod reference;
mod typeset;
