//! Periodic orbits by shooting.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::equilibrium::{angles, require_as_many_rates, require_autonomous, within_a_turn};
use super::least_squares::shortest_step;
use super::orbit::{NOISE, PeriodicOrbit};
use super::transition::flow;
use super::{StabilityError, transition};
use crate::error::Reason;
use crate::hybrid::rate;
use crate::method::{Method, require};
use crate::settings::settings;
use crate::system::{IntoState, Jacobian};

/// Computation of periodic orbits by shooting: a plain value with settings.
///
/// Newton's method solves for a state that equals itself after one period. The derivative of the final with respect to
/// the initial state, the monodromy matrix, comes from the variational equations with the generated Jacobian. Its
/// eigenvalues determine the stability of the orbit. Each step is the shortest solution of the linear equations, halved
/// until the distance of the two states decreases. Of the many points of an orbit, and of a family of orbits in
/// conservative systems, the iteration therefore converges to a nearby one.
///
/// Angles may make full turns in a period, which do not count as a distance, if the [layout](crate::System::layout)
/// marks them as [periodic](crate::Slot::periodic). A multiple of the period is a period as well; the search finds the
/// one closest to the guess.
///
/// H. B. Keller, "Numerical Methods for Two-Point Boundary-Value Problems" (1968); R. Seydel, "Practical Bifurcation
/// and Stability Analysis", 3rd ed. (2010), ch. 7.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::{Shooting, Stability};
///
/// mechanism! {
///     /// A pendulum whose pivot shakes up and down, upright: P. L. Kapitza (1951).
///     pub Kapitza {
///         params { a: m, omega: rad/s }
///         gravity: [0, -9.81, 0],
///         body bob on ground {
///             mass: 1, com: [0, 1, 0], joint: revolute(z), coordinate: tilt,
///             torque: -1 kg m * a * omega^2 * cos(omega * t) * sin(q),
///         }
///     }
/// }
///
/// let upright = |omega| {
///     let shaken = Kapitza::new(KapitzaParams { a: 0.05, omega })?;
///     Ok::<_, Box<dyn std::error::Error>>(Shooting::new().forced(&shaken, [0.0, 0.0], std::f64::consts::TAU / omega)?)
/// };
/// // It stands while a omega stays above sqrt(2 g l) = 4.43 m/s or thereabouts.
/// assert_eq!(upright(80.0)?.stability(), Stability::Unstable);
/// assert_ne!(upright(100.0)?.stability(), Stability::Unstable);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shooting {
    tolerance: f64,
}

impl Default for Shooting {
    fn default() -> Self {
        Self::new()
    }
}

impl Shooting {
    /// Default settings.
    #[must_use]
    pub const fn new() -> Self {
        Self { tolerance: 1e-12 }
    }

    settings! {
        /// Sets the relative and absolute tolerance of the integration. Default: 1e-12.
        ///
        /// The final distance is about a hundred times the tolerance, times the norm of the monodromy matrix.
        tolerance: f64;
    }

    /// Finds the periodic orbit near the state `x0` of an autonomous system, and its period in s. `period` is a guess.
    ///
    /// Phase condition: steps of the state are orthogonal to the motion.
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if a setting or the guess of the period is invalid, or if a trajectory stops
    /// early. [`StabilityError::TimeDependent`] if the right-hand side may depend on time according to the layout.
    /// [`StabilityError::MorePositions`] if there are more positions than rates. [`StabilityError::AtRest`] if the
    /// search converges to an equilibrium. [`StabilityError::NoConvergence`] if it finds no orbit.
    pub fn autonomous<const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
        period: f64,
    ) -> Result<PeriodicOrbit<N>, StabilityError> {
        require_autonomous(system)?;
        self.search(system, (x0.into_state(), period), true)
    }

    /// Finds the motion near the state `x0` at the time 0 with the given period, in s. For a driven system this is the
    /// period of the drive or a multiple of it; for a conservative system, the period of any of its orbits.
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if a setting or the period is invalid, or if a trajectory stops early.
    /// [`StabilityError::MorePositions`] if there are more positions than rates. [`StabilityError::NoConvergence`] if
    /// the search finds no orbit.
    pub fn forced<const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
        period: f64,
    ) -> Result<PeriodicOrbit<N>, StabilityError> {
        self.search(system, (x0.into_state(), period), false)
    }

    fn search<S, const N: usize>(
        &self,
        system: &S,
        (mut x, mut period): (SVector<f64, N>, f64),
        autonomous: bool,
    ) -> Result<PeriodicOrbit<N>, StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        check_period(period)?;
        let angles = angles(system);
        let mut lap = Lap::run(system, (x, period), self.tolerance, &angles)?;
        for _ in 0..ITERATIONS {
            let columns = if autonomous { N + 1 } else { N };
            let matrix = DMatrix::from_fn(N, columns, |i, j| match j {
                j if j == N => lap.velocity[i],
                j if i == j => lap.monodromy[(i, j)] - 1.0,
                j => lap.monodromy[(i, j)],
            });
            let residual = DVector::from_column_slice(lap.gap.as_slice());
            let step = shortest_step(matrix, &residual, NOISE * self.tolerance)?;
            // The convergence is quadratic: the error after a step is of the order of its square.
            let settled = step.norm() <= 0.1 * self.tolerance.sqrt() * (1.0 + x.norm());
            let ahead = |part: f64| {
                let change = SVector::from_fn(|i, _| part * step[i]);
                (x + change, if autonomous { period + part * step[N] } else { period })
            };
            let Some(part) = self.descend(system, &ahead, lap.gap.norm(), &angles) else {
                // Either only integration errors are left, or this is a local minimum of the distance.
                break;
            };
            (x, period) = ahead(part);
            lap = Lap::run(system, (x, period), self.tolerance, &angles)?;
            if settled {
                break;
            }
        }
        if lap.gap.norm() > resolution(&lap.monodromy, &x, self.tolerance) {
            return Err(StabilityError::NoConvergence {
                iterations: ITERATIONS,
                residual: lap.gap.amax(),
            });
        }
        let along = autonomous
            .then(|| direction(system, &x, period, self.tolerance))
            .transpose()?;
        PeriodicOrbit::new((x, period, lap.turns), lap.monodromy, along, self.tolerance)
    }

    /// Line search: the fraction of the step after which the distance of the ends is less than `distance`.
    fn descend<S, const N: usize>(
        &self,
        system: &S,
        ahead: &impl Fn(f64) -> (SVector<f64, N>, f64),
        distance: f64,
        angles: &[usize],
    ) -> Option<f64>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        let (_, whole) = ahead(0.0);
        let mut part = 1.0;
        while part > 1e-6 {
            let (x, period) = ahead(part);
            // A step to less than half or more than twice the period would lead to another orbit, if any.
            if (0.5 * whole..=2.0 * whole).contains(&period)
                && let Ok(end) = after(system, (x, period), self.tolerance)
                && gap(&x, &end, angles).0.norm() < (1.0 - 1e-4 * part) * distance
            {
                return Some(part);
            }
            part *= 0.5;
        }
        None
    }
}

/// One period of a motion that may not close.
pub(super) struct Lap<const N: usize> {
    /// Difference from start to end, modulo full turns.
    pub(super) gap: SVector<f64, N>,
    pub(super) turns: [i32; N],
    /// Derivative of the final with respect to the initial state.
    pub(super) monodromy: SMatrix<f64, N, N>,
    /// Rate at the end: the derivative of the final state with respect to the period.
    pub(super) velocity: SVector<f64, N>,
}

impl<const N: usize> Lap<N> {
    pub(super) fn run<S>(
        system: &S,
        (x, period): (SVector<f64, N>, f64),
        tolerance: f64,
        angles: &[usize],
    ) -> Result<Self, StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        require_as_many_rates(system)?;
        let (end, monodromy) = transition(system, 0.0, period, x, tolerance)?;
        let (gap, turns) = gap(&x, &end, angles);
        Ok(Self {
            gap,
            turns,
            monodromy,
            velocity: rate(system, period, &end)?,
        })
    }
}

/// Distance between the ends of a period attributable to integration and rounding errors.
pub(super) fn resolution<const N: usize>(monodromy: &SMatrix<f64, N, N>, x: &SVector<f64, N>, tolerance: f64) -> f64 {
    (NOISE * tolerance * monodromy.norm()).max(f64::EPSILON) * (1.0 + x.norm())
}

/// Difference from `start` to `end` modulo full turns, and the number of turns.
fn gap<const N: usize>(
    start: &SVector<f64, N>,
    end: &SVector<f64, N>,
    angles: &[usize],
) -> (SVector<f64, N>, [i32; N]) {
    let mut gap = end - start;
    let mut turns = [0; N];
    for &angle in angles {
        let rest = within_a_turn(gap[angle]);
        turns[angle] = ((gap[angle] - rest) / TAU).round() as i32;
        gap[angle] = rest;
    }
    (gap, turns)
}

/// State after a period.
pub(super) fn after<S, const N: usize>(
    system: &S,
    (x, period): (SVector<f64, N>, f64),
    tolerance: f64,
) -> Result<SVector<f64, N>, Reason>
where
    S: Jacobian<f64, N> + ?Sized,
{
    flow::<0>(tolerance).stepper(system, 0.0, period, x)?.run()
}

/// Rate at `x`, or an error if `x` is an equilibrium within the tolerance.
pub(super) fn direction<S, const N: usize>(
    system: &S,
    x: &SVector<f64, N>,
    period: f64,
    tolerance: f64,
) -> Result<SVector<f64, N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let velocity = rate(system, 0.0, x)?;
    if period * velocity.norm() > tolerance.sqrt() * (1.0 + x.norm()) {
        Ok(velocity)
    } else {
        Err(StabilityError::AtRest)
    }
}

pub(super) fn check_period(period: f64) -> Result<(), Reason> {
    let rule = "a period must be finite and positive";
    require(period.is_finite() && period > 0.0, "period", period, rule)
}

const ITERATIONS: usize = 50;
