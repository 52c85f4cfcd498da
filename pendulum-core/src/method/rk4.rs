//! The classical Runge-Kutta method.

use crate::method::Fixed;
use crate::tableau::Kutta4;

/// The classical Runge-Kutta method of order 4 with a fixed step; see [`Fixed`] for what it takes.
///
/// Four evaluations a step; the states between the steps are of order 3.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let solution = Rk4::new(0.01).solve(&swing, 0.0, 1.0, [0.5, 0.0])?;
/// assert_eq!(solution.t().len(), 101);
/// # Ok::<(), SolveError<2>>(())
/// ```
pub type Rk4 = Fixed<Kutta4, 5>;
