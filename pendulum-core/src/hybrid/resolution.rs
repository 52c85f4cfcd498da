//! Resolution of positions, forces and times: tolerances, in ulps, below which two values count as equal.

/// Coupling below which two rows of the constraint matrix are independent.
pub(super) const UNCOUPLED: f64 = 8.0;
/// Beyond this distance from a limit, contact is lost. A force larger than its limit by more than this breaks a hold.
pub(super) const NOISE: f64 = 16.0;
/// Distance from a limit within which a constraint touches it where a mode begins. Rates this small count as rest.
pub(super) const AT_LIMIT: f64 = 64.0;
/// Largest contradiction between forces and accelerations of a consistent mode.
pub(super) const CONSISTENT: f64 = 64.0;
/// Difference of rates after impacts, beyond which the order of the impacts matters.
pub(super) const ORDER_MATTERS: f64 = 4096.0;
/// Largest contradiction between impulses and the law of impacts.
pub(super) const LAWFUL: f64 = 8.0;
/// Height below which rebounds are no longer followed.
pub(super) const LOWEST_REBOUND: f64 = 64.0;
/// Duration, in ulps of t, below which rebounds are no longer followed.
pub(super) const SHORTEST_REBOUND: f64 = 1024.0;
/// Spacing within which mode switches are simultaneous.
pub(super) const SIMULTANEOUS: f64 = 64.0;
/// Minimum duration of a mode.
pub(super) const SHORTEST_MODE: f64 = 4.0;

// rebounds that are followed, and contacts that are lost, stand out from rounding errors
const _: () = assert!(UNCOUPLED < NOISE && NOISE < AT_LIMIT && NOISE < LOWEST_REBOUND);
const _: () = assert!(SHORTEST_MODE < SIMULTANEOUS && SIMULTANEOUS < SHORTEST_REBOUND);
