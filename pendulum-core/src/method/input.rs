//! The checks of settings and arguments that all methods share.

use nalgebra::SVector;

use crate::error::Reason;
use crate::real::Float;
use crate::system::System;

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

/// A state to start from that is this far from the constraints of its system is an error, not one of rounding.
const FAR: f64 = 1e-3;

/// A state to start from on the constraints of its system, close to the one that is given.
pub(crate) fn place<S, T, const N: usize>(system: &S, t: T, given: &SVector<T, N>) -> Result<SVector<T, N>, Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    check_state(given)?;
    let mut x = *given;
    system.project(t, &mut x);
    for (&x, &given) in x.iter().zip(given.iter()) {
        let rule = "the state must be close to the constraints of the system: a quaternion has unit length, \
                    and loops are closed, as `assemble` makes them";
        require((x - given).abs() <= T::from_f64(FAR), "x0", given.to_f64(), rule)?;
    }
    Ok(x)
}

/// Checks a state to start from.
pub(crate) fn check_state<T: Float, const N: usize>(x: &SVector<T, N>) -> Result<(), Reason> {
    for x in x.iter() {
        let rule = "the initial state must be finite";
        require(x.is_finite(), "x0", x.to_f64(), rule)?;
    }
    Ok(())
}
