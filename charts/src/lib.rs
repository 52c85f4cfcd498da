//! Charts in one style, written as SVG and as PNG, and in reports as pages whose charts show values.
#![forbid(unsafe_code)]
#![allow(missing_docs, reason = "fields and functions whose names say what they are")]

pub mod animation;
pub mod bars;
pub mod chart;
pub mod contour;
mod curve;
pub mod heat;
mod label;
mod line;
pub mod methods;
pub mod page;
mod palette;
pub mod panels;
pub mod report;
mod scale;
mod typeset;
