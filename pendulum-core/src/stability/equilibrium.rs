//! States of rest, and whether they last.

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

/// A state at which the right-hand side vanishes, with the small motions about it: `d(x - x0)/dt = jacobian (x - x0)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium<const N: usize> {
    /// The state.
    pub x: SVector<f64, N>,
    /// The generated Jacobian there: the linearisation.
    pub jacobian: SMatrix<f64, N, N>,
    /// Its eigenvalues and modes.
    pub spectrum: Spectrum<N>,
}

/// What the linearisation tells of an equilibrium (Lyapunov's indirect method; H. K. Khalil, "Nonlinear Systems", 3rd ed. (2002), 4.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stability {
    /// All small motions decay.
    AsymptoticallyStable,
    /// Some small motion grows.
    Unstable,
    /// No small motion grows to first order, and some do not decay: the linearisation does not decide. Such is all that swings without friction.
    Undecided,
}

impl Stability {
    /// What the growths of small motions tell, each given with its uncertainty.
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
    /// The linearisation at a state that is known to be one of rest.
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

    /// What the eigenvalues tell, as far as rounding errors allow.
    #[must_use]
    pub fn stability(&self) -> Stability {
        let modes = self.spectrum.modes().iter();
        Stability::of(modes.map(|mode| (mode.growth_rate(), mode.uncertainty)))
    }
}

/// The equilibrium that is found from `seed`, by Newton's method.
///
/// The system must not depend on time; where its [layout](System::layout) does not say, it is evaluated at the time 0. Each step goes down the size of the right-hand side: it is halved until
/// it does, and no longer than 1, or a tenth of the state, so that it does not leap over what is near (J. Nocedal, S. J. Wright, "Numerical
/// Optimization", 2nd ed. (2006), 11.2). Where that leads into a valley without a zero, the motion itself is followed with implicit Euler steps,
/// which brake it, until it hangs (C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508). Where equilibria are
/// not isolated, as for a cart on a level track, it is one nearby. Of a [hybrid](crate::hybrid) system it is that without
/// dry friction and contacts; [`resting`](super::resting) tells where these hold it. Where positions outnumber rates, as
/// those of quaternions and of loops that are closed by [`System::project`] do, the search and the modes keep to the
/// directions in which a state can move.
///
/// # Errors
/// [`StabilityError::TimeDependent`] if the layout says that time may occur, [`StabilityError::NotFinite`] where the
/// right-hand side is not finite, [`Reason::CannotClose`] or [`Reason::Open`] in [`StabilityError::Integration`] where
/// a loop does not close at the seed, and [`StabilityError::NoConvergence`] if no zero of it is found.
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

/// Where the search from `x` comes to rest.
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
                rule: "a hybrid system must have its derivatives in each mode to be at rest in one",
            }));
        }
    };
    found.map_err(|(_, error)| error)
}

/// Where the search from `x` comes to rest, or how far it came.
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

/// The size of a right-hand side that rounding errors leave where it is zero.
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
            // Rounding errors are all that is left, or a valley.
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

/// Where implicit Euler steps lead, each of one iteration. They grow as the motion comes to rest.
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

/// The step, shortened to what is near `x`.
fn within_reach<const N: usize>(step: SVector<f64, N>, x: &SVector<f64, N>) -> SVector<f64, N> {
    step.cap_magnitude(f64::max(1.0, 0.1 * x.norm()))
}

pub(super) const ITERATIONS: usize = 100;
/// A step so short, in parts of the state, is the last.
const SETTLED: f64 = 1e-12;
/// Equilibria so close are the same.
pub(super) const SAME: f64 = 1e-6;
/// Singular values below so much of the largest are zero.
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

/// The shortest `step` with the least `|rhs + matrix step|`, both as far as a state with this `jacobian` can move.
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

/// Where the right-hand side is smaller than `size`, along the step.
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

/// The components of the state that are angles with the period 2 pi.
pub(super) fn angles<const N: usize>(system: &(impl System<f64, N> + ?Sized)) -> Vec<usize> {
    system.layout().into_iter().flat_map(StateLayout::angles).collect()
}

/// Refuses a system in which time may occur, as far as that is known.
pub(super) fn require_autonomous<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
) -> Result<(), StabilityError> {
    match system.is_autonomous() {
        Some(false) => Err(StabilityError::TimeDependent),
        _ => Ok(()),
    }
}

/// Refuses a system whose positions outnumber its rates.
pub(super) fn require_as_many_rates<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
) -> Result<(), StabilityError> {
    if dimension(system) < N {
        return Err(StabilityError::MorePositions);
    }
    Ok(())
}

/// The angle in (-pi, pi]; just above -pi counts as pi.
pub(super) fn within_a_turn(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned < -PI + SAME { turned + TAU } else { turned }
}
