//! The Runge-Kutta pair of Dormand and Prince.

use crate::method::Adaptive;
use crate::tableau::DormandPrince5;

/// The Runge-Kutta pair 5(4) of Dormand and Prince with step-size control; see [`Adaptive`] for its settings.
///
/// Six evaluations a step; the states between the steps are of order 4.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let solution = Rk45::new().rtol(1e-9).atol(1e-9).solve(&swing, 0.0, 10.0, [0.5, 0.0])?;
/// let (t, x) = solution.last();
/// let energy = |x: &SVector<f64, 2>| 0.5 * x[1] * x[1] - x[0].cos();
/// assert_eq!(t, 10.0);
/// assert!((energy(&x) - energy(&solution.at(0.0)?)).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Rk45 = Adaptive<DormandPrince5, 7>;
