//! States that dry friction holds at rest.

use nalgebra::SVector;

use super::StabilityError;
use super::equilibrium::{ITERATIONS, brake, come_to_rest, require_autonomous, resolution};
use super::frictionless::Frictionless;
use crate::error::Reason;
use crate::hybrid::{Hybrid, InMode, Kinematics, MAX_CONSTRAINTS, Mode, Settled, Status, forces, rate, start};
use crate::method::require;
use crate::system::{IntoState, Jacobian};

/// A state of rest of a [hybrid](crate::hybrid) system, held by friction and contacts: one of a set, in general not
/// isolated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resting<const N: usize> {
    /// State; its rates are zero.
    pub x: SVector<f64, N>,
    /// Constraints that stick or touch.
    pub mode: Mode,
    /// Smallest relative reserve of any friction force: 1 without load, 0 at the limit of sticking.
    pub margin: f64,
}

/// Finds a state of rest near `seed`: `seed` itself if friction and contacts hold it, otherwise a state that needs no
/// friction. This is an equilibrium without friction, or at rest against a stop or a wall if the equilibrium lies
/// beyond it.
///
/// The rates of `seed` are ignored.
///
/// # Errors
/// [`StabilityError::TimeDependent`] if the right-hand side may depend on time according to the layout.
/// [`StabilityError::Integration`] if the seed is not finite or beyond a limit, or if the system is not hybrid or has
/// no [`HybridJacobian`](crate::hybrid::HybridJacobian). [`StabilityError::NoConvergence`] if no state of rest is
/// found.
pub fn resting<S, const N: usize>(system: &S, seed: impl IntoState<f64, N>) -> Result<Resting<N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    require_autonomous(system)?;
    let rule = "only a hybrid system with `Jacobian::hybrid_jacobian` can rest by friction; use `equilibrium` for \
                others";
    let hybrid = system.hybrid_jacobian().ok_or(Reason::InvalidInput {
        what: "hybrid_jacobian",
        value: f64::NAN,
        rule,
    })?;
    let mut x = seed.into_state();
    Kinematics::of(hybrid).rates().for_each(|n| x[n] = 0.0);
    if let Some(&value) = x.iter().find(|x| !x.is_finite()) {
        require(false, "seed", value, "its components must be finite")?;
    }
    if let Some(resting) = Resting::at(system, x)? {
        return Ok(resting);
    }
    let (mut from, mut mode) = (x, Mode::default());
    for _ in 0..CHANGES {
        let frictionless = Frictionless::new(hybrid, system.layout()).at_limits(mode, &from);
        let (found, failure) = match come_to_rest(&frictionless, from) {
            Ok(x) => (x, None),
            // the iteration may have crossed a limit on its way
            Err((x, failure)) => (x, Some(failure)),
        };
        x = frictionless.place(found);
        if let Some((n, limit)) = frictionless.beyond(&x) {
            mode.0[n] = limit;
            continue;
        }
        if let Some(failure) = failure {
            return Err(failure);
        }
        let slack = resolution(&frictionless.jacobian(0.0, &x), &x);
        let Some(n) = frictionless.pulled(&x, slack) else { break };
        mode.0[n] = Status::Free;
        // Newton's method might cross the limit again; the damped motion does not
        from = brake(&Frictionless::new(hybrid, system.layout()).at_limits(mode, &x), x)?;
    }
    let nothing = StabilityError::NoConvergence {
        iterations: ITERATIONS,
        residual: rate(system, 0.0, &x)?.amax(),
    };
    Resting::at(system, x)?.ok_or(nothing)
}

impl<const N: usize> Resting<N> {
    /// Returns the state if the system is at rest there.
    fn at<S>(system: &S, x: SVector<f64, N>) -> Result<Option<Self>, StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        let Some(hybrid) = system.hybrid() else { return Ok(None) };
        let (_, Settled { x, mode, hold, .. }) = start((hybrid, system.layout()), 0.0, &x, |_| {})?;
        let (rates, jacobian) = InMode::new(system, &hold).rhs_and_jacobian(0.0, &x);
        // free coordinates are at rest within rounding errors
        let rests = rates.norm() <= resolution(&jacobian, &x);
        Ok(rests.then(|| Self {
            x,
            mode,
            margin: margin(hybrid, &mode, &forces(hybrid, &hold, 0.0, &x)),
        }))
    }

    /// Interval of a coordinate over which the system stays at rest, with all other coordinates fixed.
    ///
    /// The search covers a distance `reach` on both sides, in the unit of the coordinate (m or rad). An end is infinite
    /// if the system is at rest up to that distance. Gaps shorter than `reach / 256` may be missed. If the system is at
    /// rest only at this position, as in a joint without friction, both ends equal the position up to rounding errors.
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if `coordinate` is not the index of a coordinate in the state (for example, of a
    /// rate), or if `reach` is not finite and positive.
    pub fn interval<S>(&self, system: &S, coordinate: usize, reach: f64) -> Result<[f64; 2], StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        let rule = "it must be the index of a coordinate in the state, where coordinates come before rates";
        let is_coordinate = system
            .hybrid()
            .is_some_and(|hybrid| Kinematics::of(hybrid).is_coordinate(coordinate));
        require(is_coordinate, "coordinate", coordinate as f64, rule)?;
        let rule = "the search distance must be finite and positive";
        require(reach.is_finite() && reach > 0.0, "reach", reach, rule)?;
        let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
        for (end, direction) in ends.iter_mut().zip([-1.0, 1.0]) {
            let rests = |by: f64| {
                let mut x = self.x;
                x[coordinate] += direction * by;
                // states beyond a limit are rejected
                Self::at(system, x).ok().flatten().is_some()
            };
            let mut inside = 0.0;
            let steps = (1..=STEPS).map(|step| reach * step as f64 / STEPS as f64);
            let Some(mut outside) = steps.into_iter().find(|&by| {
                let holds = rests(by);
                if holds {
                    inside = by;
                }
                !holds
            }) else {
                continue;
            };
            while outside - inside > f64::EPSILON * (self.x[coordinate].abs() + reach) {
                let middle = 0.5 * (inside + outside);
                *(if rests(middle) { &mut inside } else { &mut outside }) = middle;
            }
            *end = self.x[coordinate] + direction * inside;
        }
        Ok(ends)
    }
}

/// Smallest relative reserve of any friction force.
fn margin<const N: usize>(system: &dyn Hybrid<f64, N>, mode: &Mode, forces: &[f64; MAX_CONSTRAINTS]) -> f64 {
    let laws = system.laws();
    let stuck = (0..system.constraints().len()).filter(|&n| mode.0[n] == Status::Stuck);
    stuck
        .map(|n| 1.0 - forces[n].abs() / laws[n].sticking)
        .fold(1.0, f64::min)
}

/// Maximum number of changes of the constraints held at limits in a search.
const CHANGES: usize = 4 * MAX_CONSTRAINTS;
/// Number of samples in the search for each end of an interval.
const STEPS: usize = 256;
