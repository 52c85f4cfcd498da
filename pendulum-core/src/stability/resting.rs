//! Where dry friction lets a system rest.

use nalgebra::SVector;

use super::StabilityError;
use super::equilibrium::{require_autonomous, settle};
use crate::hybrid::{Hybrid, MOST, Mode, Settled, Status, forces, rate, start};
use crate::system::{IntoState, Jacobian};

/// A state of rest of a [hybrid](crate::hybrid) system that friction and contacts hold: one of a set, not of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resting<const N: usize> {
    /// The state; its rates are zero.
    pub x: SVector<f64, N>,
    /// What sticks, and what touches.
    pub mode: Mode,
    /// The least part of what any friction can take that is left: 1 without load, 0 where it is about to give way.
    pub margin: f64,
}

/// A state of rest near `seed`, which is that itself if friction holds it, and else the equilibrium that it would have
/// without friction.
///
/// # Errors
/// [`StabilityError::TimeDependent`] if the layout says that time may occur, [`StabilityError::Integration`] if the
/// seed is beyond a limit, and [`StabilityError::NoConvergence`] if nothing there rests, or if the system is not hybrid.
pub fn resting<S, const N: usize>(system: &S, seed: impl IntoState<f64, N>) -> Result<Resting<N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    require_autonomous(system)?;
    let mut x = seed.into_state();
    (N / 2..N).for_each(|n| x[n] = 0.0);
    if let Some(resting) = Resting::at(system, x)? {
        return Ok(resting);
    }
    let x = settle(system, x)?;
    let nothing = StabilityError::NoConvergence {
        iterations: 0,
        residual: rate(system, 0.0, &x)?.amax(),
    };
    Resting::at(system, x)?.ok_or(nothing)
}

impl<const N: usize> Resting<N> {
    /// The state, if the system rests there.
    fn at<S>(system: &S, x: SVector<f64, N>) -> Result<Option<Self>, StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        let Some(hybrid) = system.hybrid() else { return Ok(None) };
        let Settled { x, mode, hold, .. } = start(hybrid, 0.0, &x)?;
        let rests = system.rhs_in(&hold, 0.0, &x).iter().all(|&rate| rate == 0.0);
        Ok(rests.then(|| Self {
            x,
            mode,
            margin: margin(hybrid, &mode, &forces(hybrid, &hold, 0.0, &x)),
        }))
    }

    /// The interval of one coordinate over which the system rests, the others as they are: infinite where a motion of
    /// `reach` to that side, in m or rad, still rests.
    ///
    /// # Errors
    /// As [`resting`].
    pub fn interval<S>(&self, system: &S, coordinate: usize, reach: f64) -> Result<[f64; 2], StabilityError>
    where
        S: Jacobian<f64, N> + ?Sized,
    {
        let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
        for (end, direction) in ends.iter_mut().zip([-1.0, 1.0]) {
            let rests = |by: f64| {
                let mut x = self.x;
                x[coordinate] += direction * by;
                // beyond a limit is beyond the set
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
            while outside - inside > f64::EPSILON * (self.x[coordinate].abs() + outside) {
                let middle = 0.5 * (inside + outside);
                *(if rests(middle) { &mut inside } else { &mut outside }) = middle;
            }
            *end = self.x[coordinate] + direction * inside;
        }
        Ok(ends)
    }
}

/// The least part of what a friction force can take that is left.
fn margin<const N: usize>(system: &dyn Hybrid<f64, N>, mode: &Mode, forces: &[f64; MOST]) -> f64 {
    let laws = system.laws();
    let stuck = (0..system.constraints().len()).filter(|&n| mode.0[n] == Status::Stuck);
    stuck
        .map(|n| 1.0 - forces[n].abs() / laws[n].sticking)
        .fold(1.0, f64::min)
}

/// The places at which an interval is looked for.
const STEPS: usize = 256;
