//! What happens where a mode ends, and which one begins.

use nalgebra::SVector;

use super::functions::{BACKWARD, FORWARD, Fired, UPPER, slopes};
use super::mode::{Hold, Mode, Status};
use super::resolution::{AT_LIMIT, ulps};
use super::settling::Settling;
use super::watch::Watch;
use super::{Hybrid, MOST};
use crate::error::Reason;
use crate::real::Float;
#[cfg(feature = "std")]
use crate::system::System;

/// The state and the mode from which to go on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settled<T, const N: usize> {
    pub(crate) x: SVector<T, N>,
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// How long rebounds that are not followed would still last.
    pub(crate) delay: T,
    /// The impulses along the constraints.
    pub(crate) impulses: [T; MOST],
    /// By how much more than positions the constraints change, where the integration began.
    pub(crate) slopes: [T; MOST],
}

/// The mode in which to start from a state.
pub(crate) fn start<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    t: T,
    x: &SVector<T, N>,
) -> Result<Settled<T, N>, Reason> {
    let mut settling = Settling::new(system, t, x, slopes(system, t, x));
    let size = x.iter().fold(T::from_f64(1.0), |size, x| size.max(x.abs()));
    let measures = system.measures(t, x);
    for (n, constraint) in system.constraints().iter().enumerate() {
        let slack = ulps(AT_LIMIT, size * settling.slopes[n]);
        for (distance, limit, status) in settling.distances(n, &measures) {
            if distance.to_f64().is_nan() || distance < -slack {
                let (value, limit) = (measures[n][0].to_f64(), limit.to_f64());
                let constraint = constraint.name;
                return Err(Reason::BeyondLimit {
                    constraint,
                    value,
                    limit,
                });
            }
            settling.touch(n, status, distance <= slack, measures[n][1].abs() <= slack);
        }
        settling.rest(n, measures[n][1] == T::default());
    }
    Ok(settling.settle(&[T::default(); MOST]))
}

/// The right-hand side at a state, in the mode in which a hybrid system starts from it.
#[cfg(feature = "std")]
pub(crate) fn rate<S, T, const N: usize>(system: &S, t: T, x: &SVector<T, N>) -> Result<SVector<T, N>, Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    match system.hybrid() {
        Some(hybrid) => Ok(system.rhs_in(&start(hybrid, t, x)?.hold, t, x)),
        None => Ok(system.rhs(t, x)),
    }
}

/// The mode after the one that ended.
pub(crate) fn switch<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    (t, x): (T, &SVector<T, N>),
    mode: &Mode,
    fired: Fired,
    watch: &Watch<T>,
) -> Settled<T, N> {
    let mut settling = Settling::new(system, t, x, watch.slopes);
    let measures = system.measures(t, x);
    let sizes = settling.sizes();
    for n in 0..system.constraints().len() {
        let status = mode.0[n];
        if status.touches() {
            settling.touching[n] = status;
        }
        settling.rest(n, status.is_held());
        if status.is_held() {
            for (way, next) in [(FORWARD, Status::Forward), (BACKWARD, Status::Backward)] {
                if fired.has(n, way) {
                    settling.forced[n] = Some(next);
                }
            }
        } else {
            settling.rest(n, fired.has(n, FORWARD));
            let slack = ulps(AT_LIMIT, sizes[n]);
            // what stands at a limit because something else holds it there, or arrives at the same time
            for (distance, _, status) in settling.distances(n, &measures) {
                let rate = measures[n][1];
                let leaving = if status == Status::Low { rate } else { -rate };
                settling.touch(
                    n,
                    status,
                    distance.abs() <= slack && leaving <= slack,
                    rate.abs() <= slack,
                );
            }
            for (way, next) in [(BACKWARD, Status::Low), (UPPER, Status::High)] {
                if fired.has(n, way) {
                    settling.touching[n] = next;
                }
            }
        }
    }
    settling.settle(&watch.reach)
}
