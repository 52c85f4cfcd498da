//! What can be told apart: below these many ulps, places, forces and times are the same.

use crate::real::Float;

/// Rows of which one acts on the other by no more than this are independent.
pub(super) const UNCOUPLED: f64 = 8.0;
/// What has left a limit by more than this has left it, and a force that is above its limit by more than this is too
/// large.
pub(super) const NOISE: f64 = 16.0;
/// What is this close to a limit where a mode begins is at it, and rests there if it is as slow.
pub(super) const AT_LIMIT: f64 = 64.0;
/// Forces and accelerations contradict each other no more than this.
pub(super) const CONSISTENT: f64 = 64.0;
/// Rates after impacts depend on their order if these differ by more than this.
pub(super) const ORDER_MATTERS: f64 = 4096.0;
/// Impulses contradict a law of impacts no more than this.
pub(super) const LAWFUL: f64 = 8.0;
/// Rebounds are followed while they are higher than this,
pub(super) const LOWEST_REBOUND: f64 = 64.0;
/// and last longer than so much of the time.
pub(super) const SHORTEST_REBOUND: f64 = 1024.0;
/// Modes that end this close to each other end at once.
pub(super) const SIMULTANEOUS: f64 = 64.0;
/// A mode lasts at least so long.
pub(super) const SHORTEST_MODE: f64 = 4.0;

// what is followed, or has left, is told from noise
const _: () = assert!(UNCOUPLED < NOISE && NOISE < AT_LIMIT && NOISE < LOWEST_REBOUND);
const _: () = assert!(SHORTEST_MODE < SIMULTANEOUS && SIMULTANEOUS < SHORTEST_REBOUND);

/// So many ulps of a size.
#[inline(always)]
pub(super) fn ulps<T: Float>(count: f64, size: T) -> T {
    T::from_f64(count) * T::EPSILON * size
}
