//! The generator behind `mechanism!`, as a library: from a declared mechanism to flat equations of motion.
//!
//! ```
//! let declaration = "pub Pendulum {
//!     params { m: kg, l: m, g: m/s^2 = 9.81 }
//!     gravity: [0, -g, 0],
//!     body bob on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
//! }";
//! let program = pendulum_codegen::program(declaration.parse()?)?;
//! assert!(program.equations.to_string().contains("A[theta, theta] = m*l^2"));
//!
//! // the items that the macro emits; prettyplease formats them for reading
//! let items = pendulum_codegen::expand(declaration.parse()?);
//! assert!(items.to_string().contains("fn rhs"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The compilation is a pipeline without back edges: tokens to a syntax tree (`parse`, `ast`, `units`, `urdf`), to a
//! typed model (`lower`, `model`, `check`), to expressions of the equations of motion (`screw`, `dynamics`, on the
//! graph of `expr`), to simplified expressions (`form`, `pass`), to a language-independent [`mod@program`], to Rust,
//! [C](c()) or [FMUs](fmu()) (`emit`). Spans of items are not used after `check`; of the syntax tree, only the head
//! with the name and visibility of the model reaches the Rust printer. The output is deterministic: the same
//! declaration gives the same code, byte for byte.
#![forbid(unsafe_code)]

mod ast;
mod check;
mod dynamics;
mod emit;
mod error;
mod expr;
mod files;
mod form;
mod loops;
mod lower;
mod model;
mod parse;
mod pass;
mod pipeline;
pub mod program;
mod screw;
#[cfg(test)]
mod tests;
mod units;
mod urdf;
mod words;

pub use emit::c::{Controller, Ilqr, NoController, Sources, c, c_fused, opencl};
pub use emit::fmi::{Fmu, NoFmu, fmu};
pub use emit::tape::tape;
pub use error::{Code, Errors};
pub use files::{expand, expand_in, expand_with, program, program_in, program_with};
pub use pipeline::Wanted;
pub use urdf::{Files, Unreadable, robot_bodies};
