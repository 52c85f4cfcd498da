//! Charts in one style, written as SVG and as PNG.
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
mod scale;
mod typeset;
