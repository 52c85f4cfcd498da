//! Stability of motions and of methods, which are separate questions.
//!
//! A motion may be unstable with any method, and a method may be unstable on a stable motion. Both follow from the
//! generated Jacobian. The [`Spectrum`] describes the motion. The [`StabilityFunction`], at the eigenvalues times the
//! step size, describes the method; [`max_stable_step`] derives a limit from it.
//!
//! | of motions | |
//! |---|---|
//! | [`equilibrium`], [`equilibria`] | equilibria, with the eigenvalues and modes of their linearisation |
//! | [`resting`] | states held at rest by dry friction and contacts |
//! | [`Shooting`] | periodic orbits, with their Floquet multipliers |
//! | [`Continuation`] | branches of both in a parameter, and their bifurcations: folds, crossings, Hopf and others |
//! | [`Lyapunov`] | Lyapunov exponents, of many trajectories in lanes |
//! | [`section()`] | Poincare sections |
//! | [`transition`] | the state transition matrix of a trajectory |
//!
//! ```
//! use pendulum_core::prelude::*;
//! use pendulum_core::stability::{Stability, equilibria};
//!
//! mechanism! {
//!     pub Swing {
//!         params { gamma: N m s = 0.1 }
//!         gravity: [0, -9.81, 0],
//!         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: gamma }
//!     }
//! }
//!
//! let swing = Swing::new(SwingParams::default())?;
//! let [hanging, standing] = &equilibria(&swing, [SVector::from([0.1, 0.0])])?[..] else { panic!("there are two") };
//! assert_eq!(hanging.stability(), Stability::AsymptoticallyStable);
//! assert_eq!(standing.stability(), Stability::Unstable);
//! let fastest = standing.spectrum.modes()[0].growth_rate();
//! assert!((fastest - (-0.05 + (9.81_f64 + 0.0025).sqrt())).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod branch;
mod continuation;
mod curve;
mod directions;
mod equilibria;
mod equilibrium;
mod error;
mod families;
mod frictionless;
mod function;
mod least_squares;
mod limits;
mod lyapunov;
mod orbit;
mod resting;
mod section;
mod shooting;
mod spectrum;
mod trace;
mod transition;

pub use branch::{Bifurcation, BifurcationKind, Branch, BranchEnd, BranchPoint};
pub use continuation::Continuation;
pub(crate) use directions::directions_of;
pub use equilibria::{Equilibria, equilibria};
pub use equilibrium::{Equilibrium, Stability, equilibrium};
pub use error::StabilityError;
pub use function::StabilityFunction;
pub use limits::{imaginary_limit, max_stable_step, real_limit};
pub use lyapunov::{Exponents, Lyapunov};
pub use nalgebra::Complex;
pub use orbit::{Multiplier, PeriodicOrbit};
pub use resting::{Resting, resting};
pub use section::section;
pub use shooting::Shooting;
pub use spectrum::{Eigenmode, Spectrum};
pub(crate) use spectrum::{Pair, pairs};
pub use transition::transition;
