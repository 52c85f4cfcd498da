//! Mechanisms that are declared at run time.
//!
//! [`Model::parse`] takes the text of a declaration, in the language of `mechanism!`, and [`Model::urdf`] the file of a
//! robot. No compiler is needed. Functions, trajectories and ensembles have the bits of the code that `mechanism!`
//! generates.
//!
//! ```
//! use pendulum_runtime::{Method, Model};
//!
//! let model = Model::parse("pub Pendulum {
//!     params { l: m = 0.5 }
//!     gravity: [0, -9.81, 0],
//!     body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
//! }")?;
//! let start = model.state(&[("theta", 0.4)])?;
//! let motion = model.solve(&Method::new("Vern9")?.rtol(1e-10), [0.0, 10.0], &start)?;
//! assert_eq!(motion.t().last(), Some(&10.0));
//!
//! let longer = model.with(&[("l", 2.0)])?;
//! assert!(longer.rhs(0.0, &start)?[1].abs() < model.rhs(0.0, &start)?[1].abs());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! States are slices, with the components of [`Model::components`]. Inside they are padded to 4, 8, 16, 32 or 64
//! components, so that each method exists for five lengths; longer states are refused.
//!
//! # Features
//! - `full`, on by default: all methods, states of up to 64 components, stability, sensitivities, fits and tuning.
//!   Without it a build is small, as in a web page: `Rk4`, `Gauss6`, `Vern9`, `Taylor`, `Rodas5P` and `Auto`, of which
//!   `Rk4` integrates ensembles in lanes, and 32 components.

#![forbid(unsafe_code)]

mod declaration;
mod engine;
mod ensemble;
mod error;
mod event;
#[cfg(feature = "full")]
mod fit;
mod method;
mod model;
mod motion;
mod padded;
mod sampler;
#[cfg(feature = "full")]
mod sensitivity;
#[cfg(feature = "full")]
mod simplest;
mod solve;
#[cfg(feature = "full")]
mod stability;
#[cfg(feature = "full")]
mod tune;
mod worker;

pub use declaration::{Declaration, DeclarationError, Problem, Robot};
pub use ensemble::{Ensemble, Members};
pub use error::Error;
pub use event::Event;
#[cfg(feature = "full")]
pub use fit::{Experiment, Fit, Fitted};
pub use method::Method;
pub use model::{Component, Function, Model, Quantity};
pub use motion::{Impact, Motion, Occurrence, Stopped};
#[cfg(feature = "full")]
pub use sensitivity::Sensitivity;
#[cfg(feature = "full")]
pub use simplest::{Answer, Cost, Question, Refused, Simpler, simplest, simplest_unless};
pub use solve::Options;
#[cfg(feature = "full")]
pub use stability::{Equilibrium, Exponents, Lyapunov, Resting};
#[cfg(feature = "full")]
pub use tune::Choice;
pub use worker::while_waiting;

pub use nalgebra;
pub use pendulum_codegen::Sources;
#[cfg(feature = "full")]
pub use pendulum_core::fit::{Estimate, Loss, Measurement};
pub use pendulum_core::inputs::TimeTable;
pub use pendulum_core::shapes::{Shape, ShapeKind};
#[cfg(feature = "full")]
pub use pendulum_core::stability::{Stability, StabilityError};
pub use pendulum_core::tape::Shape as ResultShape;
pub use pendulum_core::{SampleError, Slot, SlotKind, StateLayout, Statistics};
