//! Accuracy and cost of integrators: reference solutions, error norms, and work-precision measurements on your own
//! system.
//!
//! [`with_error`](Refine::with_error) estimates the error of a solution, and [`tune`] finds the fastest method and
//! setting for a stated error. A sweep measures everything:
//!
//! ```
//! use pendulum_core::accuracy::{Errors, Problem, Reference, Sweep};
//! use pendulum_core::prelude::*;
//!
//! mechanism! {
//!     pub Swing {
//!         params { l: m = 1.0 }
//!         gravity: [0, -9.81, 0],
//!         generate: [rhs, energy, taylor],
//!         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
//!     }
//! }
//!
//! let swing = Swing::new(SwingParams::default())?;
//! let start = [2.0, 0.0];
//!
//! // A solution with an estimate of its error.
//! let reference = Reference::integrate(&swing, 0.0, 10.0, start)?;
//! assert!(reference.uncertainty(10.0) < 1e-11);
//!
//! // The errors of one solution ..
//! let solution = Rk45::new().rtol(1e-8).atol(1e-8).solve(&swing, 0.0, 10.0, start)?;
//! let errors = Errors::of(&solution, &reference).expect("the reference covers all of it");
//! assert!(errors.last < 1e-5);
//!
//! // .. and the errors, times and evaluations of whole methods; energies in units of 10 J.
//! let problem = Problem::new(&swing, 0.0, 10.0, start, &reference).energy(10.0);
//! let tolerances = [1e-4, 1e-6, 1e-8, 1e-10];
//! let report = Sweep::new(problem)
//!     .rounds(3)
//!     .method("Rk4", [0.1, 0.01, 0.001], Rk4::new)
//!     .method("Rk45", tolerances, |tol| Rk45::new().rtol(tol).atol(tol))
//!     .method("Taylor", tolerances, |tol| Taylor::new().rtol(tol).atol(tol))
//!     .run();
//! println!("{report}");
//! for (name, cheapest) in report.time_to_reach(1e-6) {
//!     if let Some((setting, measured)) = cheapest {
//!         println!("{name} at {setting:.0e}: {:.1} us", 1e6 * measured.minimum);
//!     }
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Errors are the maximum over the components of the state, in their units; those of [`tune`] are relative. Compare
//! times only within one run of a sweep, and only in release builds.

mod errors;
mod problem;
mod reference;
mod report;
mod sweep;
mod timing;
mod tune;
mod with_error;

pub use errors::Errors;
pub use problem::Problem;
pub use reference::Reference;
pub use report::{Failure, Measured, MethodRuns, Report, Run};
pub use sweep::Sweep;
pub use tune::{Alternative, Setting, TuneError, Tuned, Tuning, tune};
pub use with_error::{Refine, SolutionWithError, WithError};
