//! The checks of settings and arguments that all methods share.

use nalgebra::SVector;

use crate::error::Reason;
use crate::real::Float;

/// An error unless `holds`.
pub(crate) fn require(holds: bool, what: &'static str, value: f64, rule: &'static str) -> Result<(), Reason> {
    if holds {
        Ok(())
    } else {
        Err(Reason::InvalidInput { what, value, rule })
    }
}

/// Checks the span of time.
pub(crate) fn check_span<T: Float>(t0: T, t1: T) -> Result<(), Reason> {
    let finite = "a time must be finite";
    require(t0.is_finite(), "t0", t0.to_f64(), finite)?;
    require(t1.is_finite(), "t1", t1.to_f64(), finite)?;
    let span = t1 - t0;
    let rule = "the span of time must be finite; integrate it in several parts";
    require(span.is_finite(), "t1 - t0", span.to_f64(), rule)
}

/// Checks the span of time and the initial state.
pub(super) fn check_start<T: Float, const N: usize>(t0: T, t1: T, x0: &SVector<T, N>) -> Result<(), Reason> {
    const { assert!(N > 0, "a state has at least one component") };
    check_span(t0, t1)?;
    check_state(x0)
}

/// Checks a state to start from.
pub(crate) fn check_state<T: Float, const N: usize>(x: &SVector<T, N>) -> Result<(), Reason> {
    for x in x.iter() {
        let rule = "the initial state must be finite";
        require(x.is_finite(), "x0", x.to_f64(), rule)?;
    }
    Ok(())
}
