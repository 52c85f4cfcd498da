//! Hybrid systems: dry friction that sticks, stops, and walls.
//!
//! A [`Constraint`] is a scalar function of the state, such as the coordinate of a joint or the gap to a wall. Friction
//! may brake its rate, and it may have limits. In each [`Mode`] (a status of every constraint: free, slipping,
//! sticking, in contact) the equations are smooth, and methods integrate them like any others. A mode ends where a
//! friction force reaches its limit, a rate or a gap passes zero, or a contact would have to pull. The mode switch is
//! located on the dense output, the step ends there, and the next step starts in another mode.
//!
//! - A rate that reaches zero stays exactly zero as long as friction can hold it. One complementarity problem decides
//!   for all constraints together which of them stick and which slip, such that all forces are within their limits and
//!   every slip opposes its friction. It is solved by trying combinations, beginning with the most held constraints.
//! - At a limit there is an impact: by Newton's law of restitution, a constraint that approaches with the rate `v`
//!   leaves with `-e v`. Resting constraints coupled to it take part, and do not approach afterwards. Friction forces
//!   are finite, so they take no part in impacts.
//! - If another constraint at its limit approaches after that, its impact follows at the same instant. Impacts of two
//!   coupled constraints alternate, and may accumulate while rates are still finite. The rates at which the series ends
//!   depend on the order of the impacts, not on the times between them.
//! - If coupled constraints approach at the same instant, each order is tried. If the order affects the motion
//!   afterwards, they collide simultaneously with the smallest of their restitutions, so that energy never grows, and
//!   an [`Ambiguity`] reports it.
//! - Rebounds lower than 1e-13 of the size of the positions (64 ulps of it in `f32`) end at once, at the limit of the
//!   series of their times. Friction changes its direction where they turn.
//! - No size is absolute: rounding errors are relative to the lengths, angles and rates of the system.
//!
//! Generated models get all this from `dry_friction`, `stop` and `wall` in their declaration. A model written by hand
//! implements [`Plant`](crate::Plant), given the forces along its constraints:
//!
//! ```
//! use pendulum_core::Plant;
//! use pendulum_core::hybrid::{Constraint, Hybrid, Law, MAX_CONSTRAINTS, Response};
//! use pendulum_core::prelude::*;
//!
//! /// A ball of 1 kg above a floor; the state is the height and its rate.
//! struct Ball;
//!
//! impl System<f64, 2> for Ball {
//!     fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
//!         self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
//!     }
//!
//!     fn hybrid(&self) -> Option<&dyn Hybrid<f64, 2>> {
//!         Some(self)
//!     }
//! }
//!
//! impl Plant<f64, 2> for Ball {
//!     type Given = [f64; MAX_CONSTRAINTS];
//!
//!     fn eval(&self, _t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 2> {
//!         SVector::from([x[1], forces[0] - 9.81])
//!     }
//!
//!     fn constraints(&self) -> &[Constraint<'_>] {
//!         const { &[Constraint { name: "floor", rate: &[(1, 1)] }] }
//!     }
//!
//!     fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
//!         let mut laws = [Law::default(); MAX_CONSTRAINTS];
//!         laws[0] = Law { low: Some(0.0), restitution: 0.8, ..Law::default() };
//!         laws
//!     }
//!
//!     fn measures(&self, _t: f64, x: &SVector<f64, 2>) -> [[f64; 2]; MAX_CONSTRAINTS] {
//!         let mut measures = [[0.0; 2]; MAX_CONSTRAINTS];
//!         measures[0] = [x[0], x[1]];
//!         measures
//!     }
//!
//!     fn response(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 2> {
//!         let mut response = Response::new(self.eval(t, x, forces));
//!         response.accelerations[0] = response.rates[1];
//!         response.columns[0] = SVector::from([0.0, 1.0]);
//!         response.matrix[0][0] = 1.0;
//!         response
//!     }
//! }
//!
//! let solution = Tsit5::new().rtol(1e-12).atol(1e-12).solve(&Ball, 0.0, 5.0, [1.0, 0.0])?;
//! // falls, and rebounds in times that shrink by a factor of 0.8
//! let fall = (2.0_f64 / 9.81).sqrt();
//! let (rests, mode) = *solution.modes().last().unwrap();
//! assert!((rests - fall * (1.0 + 2.0 * 0.8 / (1.0 - 0.8))).abs() < 1e-12 && mode.is_held(0));
//! assert_eq!(solution.end(), SVector::from([0.0, 0.0]));
//! # Ok::<(), pendulum_core::SolveError<f64, 2>>(())
//! ```

mod ambiguity;
mod collision;
mod complementarity;
mod held;
mod impact;
mod in_mode;
mod kinematics;
mod mode;
mod modes;
mod next_mode;
mod polynomial;
mod project;
mod rebound;
mod resolution;
#[cfg(feature = "std")]
mod saltation;
mod sample;
mod series;
mod settled;
mod settling;
mod sizes;
mod step;
mod switch;
mod watch;
mod witness;

pub use crate::constraint::{Constraint, Hold, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative};
pub use crate::system::{Hybrid, HybridJacobian, by_sign};
pub use ambiguity::Ambiguity;
#[cfg(feature = "std")]
pub(crate) use complementarity::independent;
pub use held::HeldSeries;
#[cfg(feature = "std")]
pub(crate) use held::{forces, rhs, rhs_and_jacobian};
pub use impact::Impact;
pub use in_mode::{InMode, ModeSwitch};
pub(crate) use kinematics::Kinematics;
#[cfg(feature = "std")]
pub(crate) use mode::set_of;
pub use mode::{Mode, Status};
pub(crate) use modes::Modes;
#[cfg(feature = "std")]
pub(crate) use polynomial::room;
#[cfg(feature = "fit")]
pub(crate) use project::place_inside;
pub(crate) use project::project;
#[cfg(feature = "std")]
pub(crate) use project::{apart, place_coordinates};
#[cfg(feature = "std")]
pub(crate) use saltation::{hold_tangents, saltation};
pub(crate) use settled::Settled;
#[cfg(feature = "std")]
pub(crate) use switch::rate;
pub(crate) use switch::{start, switch, without_derivatives};
pub(crate) use watch::disproves;
pub(crate) use witness::Witnesses;
