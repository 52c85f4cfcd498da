//! The generator behind `mechanism!`, as a library.

pub mod ast;
pub mod check;
pub mod dynamics;
mod emit;
pub mod error;
pub mod expr;
pub mod lower;
pub mod model;
pub mod parse;
pub mod pass;
mod pipeline;
pub mod screw;
pub mod units;

pub use pipeline::{Function, Program, expand, model, program};
