//! The generator behind `mechanism!`, as a library: from a declared mechanism to flat equations of motion.
//!
//! ```
//! let declaration = "pub Pendulum {
//!     params { m: kg, l: m, g: m/s^2 = 9.81 }
//!     gravity: [0, -g, 0],
//!     body bob on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
//! }";
//! let program = pendulum_codegen::program(declaration.parse()?)?;
//! assert!(program.equations.contains("A[theta, theta] = m*l^2"));
//!
//! // the items that the macro emits; prettyplease formats them for reading
//! let items = pendulum_codegen::expand(declaration.parse()?);
//! assert!(items.to_string().contains("fn rhs"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! One way through, no way back: tokens ([`parse`], [`ast`], [`units`]) to a typed scene ([`lower`], [`mod@model`], [`check`]) to expressions of
//! its motion ([`screw`], [`dynamics`], on the graph of [`expr`]) to the shortest forms of them ([`pass`]) to Rust, or to [C](c()). Spans stop at the
//! model; what lies behind it knows nothing of syntax. The same declaration gives the same code, byte for byte.

pub mod ast;
pub mod check;
pub mod dynamics;
mod emit;
pub mod error;
pub mod expr;
pub mod form;
pub mod lower;
pub mod model;
pub mod parse;
pub mod pass;
mod pipeline;
pub mod program;
pub mod screw;
pub mod units;

pub use emit::c::{Sources, c};
pub use pipeline::{expand, model, program};
