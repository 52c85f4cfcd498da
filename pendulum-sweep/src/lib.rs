//! Sweeps over millions of trajectories, on all cores. A killed sweep resumes where it stopped.
//!
//! A [`Sweep`] is a design: a [grid](Sweep::grid), a [list](Sweep::list) or [random](Sweep::random) points. The task at
//! each point is one of
//!
//! - [`ends`](Sweep::ends): final states, in the SIMD lanes;
//! - [`sampled`](Sweep::sampled): final states under controllers that sample, over their gains, in lanes as well;
//! - [`trajectories`](Sweep::trajectories): states at given times, extrema and events, with every method, and
//!   [in lanes](Job::in_lanes) where possible;
//! - [`exponents`](Sweep::exponents): Lyapunov exponents, in lanes as well;
//! - [`each`](Sweep::each): numbers computed by a function of your own.
//!
//! The resulting [`Job`] runs on all cores. [`Job::run`] returns a [`Table`]; [`Job::run_to`] writes a Parquet file in
//! shards, each of which is complete or absent. Every number has the same bits for any number of threads and shares,
//! and the file has the same bytes, interrupted or not.
//!
//! ```
//! use pendulum_core::prelude::*;
//! use pendulum_sweep::{Axis, Sweep};
//!
//! mechanism! {
//!     pub Swing {
//!         params { gamma: N m s }
//!         gravity: [0, -9.81, 0],
//!         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: gamma }
//!     }
//! }
//!
//! let sweep = Sweep::grid("swing", [
//!     Axis::linear("start", "rad", -3.0, 3.0, 61),
//!     Axis::logarithmic("gamma", "N m s", 1e-3, 1.0, 4),
//! ]);
//! let table = sweep
//!     .ends(Tsit5::new(), (0.0, 10.0), |[start, gamma]| Ok((Swing::new(SwingParams { gamma })?, [start, 0.0])))
//!     .value("energy", "J", |swing, t, x| swing.energy(t, x))
//!     .quiet()
//!     .run()?;
//! assert_eq!(table.rows(), 244);
//! assert_eq!(table["start"][4], -2.9);
//! assert!(table["angle"][0].abs() < 3.0 && table["energy"][0] < 9.8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod checksum;
mod command_line;
mod design;
mod differences;
mod ends;
mod error;
mod exponents;
mod file;
mod job;
#[cfg(feature = "opencl")]
pub mod opencl;
mod page;
#[cfg(feature = "mpi")]
mod ranks;
mod sampled;
mod shards;
mod table;
mod trajectories;

pub use command_line::Arguments;
pub use design::{Axis, Draw, Sweep};
pub use ends::Ends;
pub use error::SweepError;
pub use exponents::Exponents;
pub use job::{Chunk, Each, Failure, Job, Summary, Task};
pub use sampled::SampledEnds;
pub use table::{Column, Table};
pub use trajectories::Trajectories;

/// Programs of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
