//! Poincare sections.

use super::StabilityError;
use crate::event::{Event, Occurrence};
use crate::method::Method;
use crate::system::{IntoState, System};

/// Computes the Poincare section of a trajectory from the state `x0` at `t0` to `t1`: the points at which it crosses a
/// surface.
///
/// The surface is the zero set of the function of `surface`, which should count crossings in one direction only. Each
/// point is computed on the dense output of the method, and has its errors. The trajectory between the points is not
/// stored. For a system with periodic forcing, `Event::new(|t, _x| (PI * t / period).sin())` has its roots at multiples
/// of the period.
///
/// H. Poincare, "Les methodes nouvelles de la mecanique celeste" III (1899), ch. 27; M. Henon, Physica D 5 (1982) 412.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::section;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let upward = Event::new(|_t, x: &SVector<f64, 2>| x[0]).rising();
/// let points = section(&Vern9::new().rtol(1e-12).atol(1e-12), &swing, 0.0, 100.0, [1.0, 0.0], &upward)?;
/// let period = points[1].t - points[0].t;
/// assert!((period - 6.699_975_664).abs() < 1e-9); // 4 K(sin(1 / 2))
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`StabilityError::Integration`] if the trajectory stops early.
pub fn section<M, S, const N: usize>(
    method: &M,
    system: &S,
    t0: f64,
    t1: f64,
    x0: impl IntoState<f64, N>,
    surface: &Event<'_, f64, N>,
) -> Result<Vec<Occurrence<f64, N>>, StabilityError>
where
    M: Method<S, f64, N>,
    S: System<f64, N> + ?Sized,
{
    let (x0, mut points) = (x0.into_state(), Vec::new());
    let stepper = &mut method.stepper(system, t0, t1, x0)?;
    let ended = stepper.follow(x0, std::slice::from_ref(surface), &mut points);
    ended.map_err(|early| early.reason)?;
    Ok(points)
}
