//! Mechanisms declared in Rust source: generated equations of motion, and methods to integrate them.
//!
//! [`mechanism!`] turns a declaration of rigid bodies ([`language`]) into a model that implements the traits of
//! [`system`]. Models written by hand can implement the same traits. A method is a plain value with settings:
//!
//! ```
//! use pendulum_core::prelude::*;
//!
//! /// A point on a rod of length 1 m; the state is the angle from the vertical and its rate.
//! struct Swing {
//!     gravity: f64,
//! }
//!
//! impl System<f64, 2> for Swing {
//!     fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
//!         SVector::from([x[1], -self.gravity * x[0].sin()])
//!     }
//! }
//!
//! let swing = Swing { gravity: 9.8 };
//! let solution = Rk45::new().rtol(1e-9).atol(1e-9).solve(&swing, 0.0, 10.0, [0.1, 0.0])?;
//! let halfway = solution.at(5.0)?;
//! assert!(halfway[0].abs() <= 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`language`] | the syntax of [`mechanism!`], and the code it generates |
//! | [`system`] | traits of models: right-hand side, Jacobian, energy |
//! | [`hybrid`] | dry friction with sticking, stops and walls |
//! | [`inputs`] | models with inputs, and control laws |
//! | [`layout`] | kind and place of each component of a state |
//! | [`real`], [`dual`] | the number types: scalars, fused ones, lanes and dual numbers |
//! | [`ensemble`] | many trajectories at once, in the lanes of vector registers |
//! | [`batch`] | right-hand sides and other functions of many states at once |
//! | [`method`] | the methods, and the [`Stepper`] beneath them, which uses no heap |
//! | [`tableau`] | Butcher tableaus as data |
//! | [`taylor`] | power series of motions |
//! | [`solution`], [`dense`] | accepted points and the states between them |
//! | [`event`] | events along a trajectory |
//! | [`error`] | errors |
//! | [`sensitivity`] | derivatives of trajectories by initial conditions and parameters |
//! | [`fit`](https://docs.rs/pendulum-core/latest/pendulum_core/fit) | parameters from measurements (feature `fit`) |
//! | [`control`] | linear models, LQR, Kalman filters, controllability; motions of least cost; sampled controllers |
//! | [`stability`] | equilibria, periodic orbits and their bifurcations, chaos, and the limits of methods |
//! | [`accuracy`] | reference solutions, error estimates, the fastest method for an error, work and precision |
//! | [`shapes`] | geometry of a mechanism for drawing |
//! | [`cost`] | counted operations of generated functions |
//!
//! # Without `std`
//!
//! Without the default feature `std` the crate is `no_std` and uses no heap. Generated models and the [`Stepper`] of
//! every method work in this mode, [iterative LQR](control::Ilqr), and [sampled controllers](control::Sampled);
//! trajectories and lists do not. The feature adds [`Method::solve`], [`solution`], [`event`], [`ensemble`],
//! [`sensitivity`], the design of linear [`control`], [`stability`], [`accuracy`], [`shapes`], and the detection of
//! instruction sets at run time. The default feature `macros` re-exports [`mechanism!`].

#![cfg_attr(not(feature = "std"), no_std)]
#![cfg_attr(
    test,
    allow(clippy::disallowed_methods, reason = "references may be those of the platform")
)]

#[cfg(feature = "std")]
pub mod accuracy;
#[cfg(feature = "std")]
pub mod batch;
pub mod control;
pub mod cost;
pub mod dense;
pub mod dual;
#[cfg(feature = "std")]
pub mod ensemble;
pub mod error;
#[cfg(feature = "std")]
pub mod event;
#[cfg(feature = "fit")]
pub mod fit;
pub mod hybrid;
pub mod inputs;
pub mod layout;
pub mod method;
pub mod real;
#[cfg(feature = "std")]
pub mod sensitivity;
#[cfg(feature = "std")]
pub mod shapes;
#[cfg(feature = "std")]
pub mod solution;
#[cfg(feature = "std")]
pub mod stability;
pub mod system;
pub mod tableau;
#[cfg(feature = "std")]
pub mod tape;
pub mod taylor;

mod constraint;
#[cfg(feature = "std")]
mod csv;
mod forward;
mod linear;
mod settings;
mod statistics;
mod step_size;

pub use cost::{Cost, FunctionCost, Operations};
pub use dense::{Dense, Step};
#[cfg(feature = "std")]
pub use ensemble::{Ensemble, EnsembleError, ObservedEnsemble};
pub use error::{LoopGap, Name, NotAssembled, ParameterError, Reason};
#[cfg(feature = "std")]
pub use error::{SampleError, SolveError};
#[cfg(feature = "std")]
pub use event::{Direction, Event, Missed, Occurrence};
pub use inputs::{CastControlled, Controlled, InputLaw, WithInputs};
#[cfg(feature = "std")]
pub use layout::WrongLength;
pub use layout::{Slot, SlotKind, StateLayout, StateVariable};
pub use method::{
    Auto, Gauss4, Gauss6, Gauss16, Method, Radau5, Radau9, Radau13, Rk4, Rk45, Rodas4, Rodas5P, Stepper, Taylor, Tsit5,
    Vern7, Vern9,
};
pub use real::{Float, Real};
#[cfg(feature = "std")]
pub use solution::{BelowTolerance, Need, Observer, OutsideSpan, Solution, Unresolved};
pub use statistics::Statistics;
pub use system::{
    Acting, Adjoint, Canonical, Cast, CastJacobian, ControlledAdjoint, Energy, FnSystem, IntoState, Jacobian,
    Parametric, ParametricControlled, Plant, PlantCanonical, PlantJacobian, System,
};
pub use taylor::{CastTaylor, TaylorSeries};

/// Declares a mechanism and generates its equations of motion: see [`language`].
#[cfg(feature = "macros")]
pub use pendulum_macros::mechanism;

#[doc = include_str!("language.md")]
pub mod language {}

/// The version of `nalgebra` in the interface of this crate, built without its feature `std`.
pub use nalgebra;
#[cfg(feature = "serde")]
#[doc(hidden)]
pub use serde;

/// Passes generated items that require `std` through, and drops them without the feature. This crate decides, not the
/// macro crate, because cargo may build the macro crate once for several copies of this one.
#[cfg(feature = "std")]
#[doc(hidden)]
#[macro_export]
macro_rules! with_std {
    ($($items:tt)*) => { $($items)* };
}
#[cfg(not(feature = "std"))]
#[doc(hidden)]
#[macro_export]
macro_rules! with_std {
    ($($items:tt)*) => {};
}

/// Items that most programs need: `use pendulum_core::prelude::*;`.
pub mod prelude {
    #[cfg(feature = "std")]
    pub use crate::accuracy::Refine as _;
    #[cfg(feature = "macros")]
    pub use crate::mechanism;
    pub use crate::{
        Auto, Gauss4, Gauss6, Gauss16, Radau5, Radau9, Radau13, Rk4, Rk45, Rodas4, Rodas5P, Taylor, Tsit5, Vern7, Vern9,
    };
    pub use crate::{Controlled, Energy, FnSystem, Jacobian, Method, System};
    #[cfg(feature = "std")]
    pub use crate::{Ensemble, Event, ObservedEnsemble, Solution, shapes::Shapes as _};
    // Only the methods of these traits are imported; their names stay free.
    #[doc(hidden)]
    pub use crate::system::Absent as _;
    pub use crate::{
        Adjoint as _, Canonical as _, Cast as _, Float as _, Parametric as _, Real as _, TaylorSeries as _,
    };
    pub use crate::{Plant as _, PlantCanonical as _, PlantJacobian as _, taylor::HybridSeries as _};
    pub use nalgebra::{SMatrix, SVector};
}
