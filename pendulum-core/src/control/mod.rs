//! Design of controllers: linear models, linear-quadratic regulators, Kalman filters, controllability, observability;
//! motions of least cost, and controllers that sample.
//!
//! A mechanism with inputs is linearized about an equilibrium, and weights of state and inputs give the law:
//!
//! ```
//! use pendulum_core::control::linearize;
//! use pendulum_core::prelude::*;
//!
//! mechanism! {
//!     /// A pole on a cart; the angle is 0 upright.
//!     pub CartPole {
//!         input push: N,
//!         gravity: [0, -9.81, 0],
//!         body slider on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
//!         body rod on slider {
//!             solids: [rod(0.2, [0, 0, 0], [0, 0.6, 0])], joint: revolute(z), coordinate: theta,
//!         }
//!     }
//! }
//!
//! let model = CartPole::new(CartPoleParams {})?;
//! let weights = SMatrix::from_diagonal(&[1.0, 10.0, 1.0, 1.0].into());
//! let regulator = linearize(&model, 0.0, [0.0; 4], [0.0])?.lqr(&weights, &SMatrix::from([[0.1]]))?;
//! let balanced = model.with_law(regulator.law);
//! let end = Vern7::new().solve(&balanced, 0.0, 20.0, [0.0, 0.5, 0.0, 0.0])?.end();
//! assert!(end.amax() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | | |
//! |---|---|
//! | [`linearize`] | `A`, `B` by the generated derivatives, `C`, `D` of [any outputs](StateSpace::with_outputs) |
//! | [`StateSpace::discretize`] | the model from sample to sample, with inputs held between them |
//! | [`StateSpace::lqr`] | the linear-quadratic regulator, continuous or sampled |
//! | [`StateSpace::kalman`] | the stationary Kalman filter, continuous or sampled |
//! | [`StateSpace::controllability`], [`StateSpace::observability`] | the margin of each mode, and what is lost |
//! | [`Ilqr`] | iterative LQR: motions of least cost within limits of the inputs, held by their gains or planned anew |
//! | [`Quadratic`], [`LeastSquares`] | costs about a goal: of the state, or of outputs of the model |
//! | [`Integrated`] | models for `Ilqr` with dry friction, stops and walls |
//! | [`Sampled`] | runs a [`Controller`] at the times of a clock: delay, limits, resolution, noise |
//! | [`Pid`], [`StateSpace::output_feedback`] | ready controllers: PID without windup, a law on an estimate |
//!
//! A model that cannot be stabilized is an error with each mode that the inputs do not reach: its eigenvalue, and its
//! direction in the names of the model.
//!
//! Without the feature `std`, the module has [`Ilqr`], [`Sampled`] and its controllers alone.

#[cfg(feature = "std")]
mod error;
#[cfg(feature = "std")]
mod estimator;
#[cfg(feature = "std")]
mod exponential;
mod ilqr;
#[cfg(feature = "std")]
mod modes;
#[cfg(feature = "std")]
mod output_feedback;
#[cfg(feature = "std")]
mod reach;
#[cfg(feature = "std")]
mod regulator;
#[cfg(feature = "std")]
mod riccati;
mod sampled;
#[cfg(feature = "std")]
mod schur;
#[cfg(feature = "std")]
mod state_space;
#[cfg(feature = "std")]
mod weights;

#[cfg(feature = "std")]
pub use error::ControlError;
#[cfg(feature = "std")]
pub use estimator::Estimator;
pub use ilqr::{
    CostDerivatives, Ilqr, IlqrError, Integrated, LeastSquares, Objective, Pass, Predictive, PredictiveState,
    Quadratic, Residuals, Solved, StepDerivatives, StepMap, Tracker, TrackerState,
};
#[cfg(feature = "std")]
pub use modes::{LostMode, LostModes, ModeMargin, PbhTest};
#[cfg(feature = "std")]
pub use output_feedback::{Estimate, OutputFeedback};
#[cfg(feature = "std")]
pub use regulator::{LinearLaw, Regulator};
pub use sampled::{
    Commanded, Components, Controller, Held, MAX_DELAY, Outputs, Pid, PidState, Sample, Sampled, WholeState,
};
#[cfg(feature = "std")]
pub use sampled::{SampledMethod, SampledSolution};
#[cfg(feature = "std")]
pub use state_space::{StateSpace, linearize};
