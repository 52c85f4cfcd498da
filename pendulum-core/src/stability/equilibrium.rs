//! Equilibria and their stability.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::directions::{dimension, directions};
use super::frictionless::Frictionless;
use super::least_squares::shortest_step;
use super::{Spectrum, StabilityError};
use crate::error::Reason;
use crate::layout::StateLayout;
use crate::method::check_loops;
use crate::system::{IntoState, Jacobian, System, close};

/// A state at which the right-hand side vanishes, with the linearisation about it: `d(x - x0)/dt = jacobian (x - x0)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium<const N: usize> {
    /// State.
    pub x: SVector<f64, N>,
    /// Generated Jacobian at the state: the linearisation.
    pub jacobian: SMatrix<f64, N, N>,
    /// Eigenvalues and modes of the Jacobian.
    pub spectrum: Spectrum<N>,
}

/// Stability of an equilibrium according to its linearisation (Lyapunov's indirect method; H. K. Khalil, "Nonlinear
/// Systems", 3rd ed. (2002), 4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stability {
    /// All modes decay.
    AsymptoticallyStable,
    /// At least one mode grows.
    Unstable,
    /// No mode grows to first order, and some do not decay: the linearisation is inconclusive. This includes all
    /// oscillations without friction.
    Undecided,
}

impl Stability {
    /// Stability according to growth rates, each given with its uncertainty.
    pub(super) fn of(growths: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        if growths.clone().any(|(growth, uncertainty)| growth > uncertainty) {
            Self::Unstable
        } else if growths.clone().all(|(growth, uncertainty)| growth < -uncertainty) {
            Self::AsymptoticallyStable
        } else {
            Self::Undecided
        }
    }
}

impl<const N: usize> Equilibrium<N> {
    /// Linearises about a state known to be an equilibrium.
    pub(super) fn at<S>(system: &S, x: SVector<f64, N>) -> Result<Self, StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        let jacobian = system.jacobian(0.0, &x);
        let spectrum = match directions(system, &jacobian) {
            Some(basis) => Spectrum::along(&jacobian, &basis)?,
            None => Spectrum::of(&jacobian)?,
        };
        Ok(Self { x, jacobian, spectrum })
    }

    /// Stability according to the eigenvalues, within rounding errors.
    #[must_use]
    pub fn stability(&self) -> Stability {
        let modes = self.spectrum.modes().iter();
        Stability::of(modes.map(|mode| (mode.growth_rate(), mode.uncertainty)))
    }
}

/// Finds an equilibrium from `seed` by Newton's method.
///
/// The system must not depend on time. If its [layout](System::layout) does not specify this, it is evaluated at the
/// time 0. Each Newton step is halved until the norm of the right-hand side decreases, and limited to a length of 1 or
/// a tenth of the state, so that nearby solutions are not skipped (J. Nocedal, S. J. Wright, "Numerical Optimization",
/// 2nd ed. (2006), 11.2).
///
/// If this ends in a local minimum, the motion is followed with implicit Euler steps, which damp it, until it comes to
/// rest (C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508). If equilibria are not isolated, as for a cart
/// on a level track, a nearby one is returned.
///
/// For a [hybrid](crate::hybrid) system the result is the equilibrium without dry friction and contacts;
/// [`resting`](super::resting) finds states that these hold at rest. If there are more positions than rates, as with
/// quaternions and loops closed by [`System::project`], the search and the modes are restricted to admissible
/// directions.
///
/// # Errors
/// [`StabilityError::TimeDependent`] if the right-hand side may depend on time according to the layout.
/// [`StabilityError::NotFinite`] if the right-hand side is not finite. [`Reason::CannotClose`] or [`Reason::Open`] in
/// [`StabilityError::Integration`] if a loop does not close at the seed. [`StabilityError::NoConvergence`] if no zero
/// of the right-hand side is found.
pub fn equilibrium<S, const N: usize>(
    system: &S,
    seed: impl IntoState<f64, N>,
) -> Result<Equilibrium<N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    require_autonomous(system)?;
    let mut seed = seed.into_state();
    close(system, 0.0, &mut seed);
    check_loops(system, 0.0, &seed).map_err(StabilityError::Integration)?;
    Equilibrium::at(system, settle(system, seed)?)
}

/// Finds an equilibrium from `x`, without dry friction and contacts.
pub(super) fn settle<S, const N: usize>(system: &S, x: SVector<f64, N>) -> Result<SVector<f64, N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let found = match (system.hybrid(), system.hybrid_jacobian()) {
        (_, Some(hybrid)) => come_to_rest(&Frictionless::new(hybrid, system.layout()), x),
        (None, None) => come_to_rest(system, x),
        (Some(_), None) => {
            return Err(StabilityError::Integration(Reason::InvalidInput {
                what: "hybrid_jacobian",
                value: f64::NAN,
                rule: "an equilibrium of a hybrid system requires `Jacobian::hybrid_jacobian`",
            }));
        }
    };
    found.map_err(|(_, error)| error)
}

/// Finds an equilibrium from `x`. An error includes the last iterate.
pub(super) fn come_to_rest<S, const N: usize>(
    system: &S,
    x: SVector<f64, N>,
) -> Result<SVector<f64, N>, (SVector<f64, N>, StabilityError)>
where
    S: Jacobian<f64, N> + ?Sized,
{
    match newton(system, x) {
        Err(StabilityError::NoConvergence { .. }) => {
            let x = brake(system, x).map_err(|error| (x, error))?;
            newton(system, x).map_err(|error| (x, error))
        }
        result => result.map_err(|error| (x, error)),
    }
}

/// Norm of a right-hand side that rounding errors leave at a zero.
pub(super) fn resolution<const N: usize>(jacobian: &SMatrix<f64, N, N>, x: &SVector<f64, N>) -> f64 {
    100.0 * f64::EPSILON * jacobian.norm() * (1.0 + x.norm())
}

fn newton<S, const N: usize>(system: &S, mut x: SVector<f64, N>) -> Result<SVector<f64, N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let (mut rhs, mut jacobian) = evaluate(system, &x)?;
    for _ in 0..ITERATIONS {
        let step = within_reach(newton_step(system, &jacobian, &jacobian, &rhs)?, &x);
        let settled = step.norm() <= SETTLED * (1.0 + x.norm());
        let Some(next) = descend(system, &x, &step, rhs.norm()) else {
            // Either only rounding errors are left, or this is a local minimum.
            break;
        };
        x = next;
        (rhs, jacobian) = evaluate(system, &x)?;
        if settled {
            break;
        }
    }
    if rhs.norm() > resolution(&jacobian, &x) {
        return Err(StabilityError::NoConvergence {
            iterations: ITERATIONS,
            residual: rhs.amax(),
        });
    }
    Ok(x)
}

/// Integrates with implicit Euler steps of one Newton iteration each. Their size grows as the motion comes to rest.
pub(super) fn brake<S, const N: usize>(system: &S, mut x: SVector<f64, N>) -> Result<SVector<f64, N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let (mut rhs, mut jacobian) = evaluate(system, &x)?;
    let mut h = 1.0 / (f64::MIN_POSITIVE + jacobian.norm());
    for _ in 0..ITERATIONS {
        let matrix = SMatrix::<f64, N, N>::identity() / h - jacobian;
        x += within_reach(newton_step(system, &-matrix, &jacobian, &rhs)?, &x);
        system.project(0.0, &mut x);
        let before = rhs.norm();
        (rhs, jacobian) = evaluate(system, &x)?;
        if rhs.norm() == 0.0 {
            break;
        }
        h *= (before / rhs.norm()).clamp(0.5, 2.0);
    }
    Ok(x)
}

/// Limits a step so that it stays near `x`.
fn within_reach<const N: usize>(step: SVector<f64, N>, x: &SVector<f64, N>) -> SVector<f64, N> {
    step.cap_magnitude(f64::max(1.0, 0.1 * x.norm()))
}

pub(super) const ITERATIONS: usize = 100;
/// Relative step length of the last iteration, in units of the state.
const SETTLED: f64 = 1e-12;
/// Relative distance below which equilibria are identical.
pub(super) const SAME: f64 = 1e-6;
/// Ratio to the largest singular value below which singular values count as zero.
const SINGULAR: f64 = 1e-12;

fn evaluate<S, const N: usize>(
    system: &S,
    x: &SVector<f64, N>,
) -> Result<(SVector<f64, N>, SMatrix<f64, N, N>), StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let (rhs, jacobian) = system.rhs_and_jacobian(0.0, x);
    if rhs.iter().chain(jacobian.iter()).all(|entry| entry.is_finite()) {
        Ok((rhs, jacobian))
    } else {
        Err(StabilityError::NotFinite)
    }
}

/// Shortest `step` that minimises `|rhs + matrix step|`, both restricted to admissible directions for this `jacobian`.
fn newton_step<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
    matrix: &SMatrix<f64, N, N>,
    jacobian: &SMatrix<f64, N, N>,
    rhs: &SVector<f64, N>,
) -> Result<SVector<f64, N>, StabilityError> {
    let rhs = DVector::from_column_slice(rhs.as_slice());
    let matrix = DMatrix::from_column_slice(N, N, matrix.as_slice());
    let step = match directions(system, jacobian) {
        Some(basis) => {
            let along = basis.transpose();
            &basis * shortest_step(&along * matrix * &basis, &(along * rhs), SINGULAR)?
        }
        None => shortest_step(matrix, &rhs, SINGULAR)?,
    };
    Ok(SVector::from_column_slice(step.as_slice()))
}

/// Line search along the step for a right-hand side smaller than `size`.
fn descend<S, const N: usize>(
    system: &S,
    x: &SVector<f64, N>,
    step: &SVector<f64, N>,
    size: f64,
) -> Option<SVector<f64, N>>
where
    S: Jacobian<f64, N> + ?Sized,
{
    let mut part = 1.0;
    while part > 1e-9 {
        let mut next = x + step * part;
        system.project(0.0, &mut next);
        if system.rhs(0.0, &next).norm() < (1.0 - 1e-4 * part) * size {
            return Some(next);
        }
        part *= 0.5;
    }
    None
}

/// Components of the state that are angles with the period 2 pi.
pub(super) fn angles<const N: usize>(system: &(impl System<f64, N> + ?Sized)) -> Vec<usize> {
    system.layout().into_iter().flat_map(StateLayout::angles).collect()
}

/// Rejects a system known to depend on time.
pub(super) fn require_autonomous<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
) -> Result<(), StabilityError> {
    match system.is_autonomous() {
        Some(false) => Err(StabilityError::TimeDependent),
        _ => Ok(()),
    }
}

/// Rejects a system with more positions than rates.
pub(super) fn require_as_many_rates<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
) -> Result<(), StabilityError> {
    if dimension(system) < N {
        return Err(StabilityError::MorePositions);
    }
    Ok(())
}

/// Reduces an angle to (-pi, pi]; values just above -pi become pi.
pub(super) fn within_a_turn(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned < -PI + SAME { turned + TAU } else { turned }
}
