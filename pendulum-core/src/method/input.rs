//! The checks of settings and arguments that all methods share.

use nalgebra::SVector;

use crate::error::{Name, Reason};
use crate::layout::StateLayout;
use crate::real::Float;
use crate::system::{System, close, open};

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

/// What may be wrong with a state to start from, and how it is called in one that a reset returns.
const COMPONENT: [&str; 2] = ["x0", "a component"];
const QUATERNION: [&str; 2] = ["length of a quaternion in x0", "the length of a quaternion"];
const DISTANCE: [&str; 2] = [
    "distance of x0 from the constraints",
    "its distance from the constraints",
];

/// Why a state that an event returned at the time `t` is none to go on from.
#[cfg(feature = "std")]
pub(crate) fn of_reset(reason: Reason, event: usize, t: f64) -> Reason {
    let Reason::InvalidInput { what, value, rule } = reason else {
        return reason;
    };
    let known = [COMPONENT, QUATERNION, DISTANCE]
        .into_iter()
        .find(|[start, _]| *start == what);
    Reason::BadReset {
        event,
        t,
        what: known.map_or(what, |[_, reset]| reset),
        value,
        rule,
    }
}

/// A state to start from on the constraints of its system, close to the one that is given.
pub(crate) fn place<S, T, const N: usize>(system: &S, t: T, given: &SVector<T, N>) -> Result<SVector<T, N>, Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    check_state(given)?;
    for orientation in system.layout().into_iter().flat_map(StateLayout::quaternions) {
        let size = orientation.map(|n| given[n].to_f64() * given[n].to_f64()).sum::<f64>();
        let size = libm::sqrt(size);
        let rule = "it must be 1, to three digits";
        require((size - 1.0).abs() <= FAR, QUATERNION[0], size, rule)?;
    }
    let mut x = *given;
    close(system, t, &mut x);
    let moved = x
        .iter()
        .zip(given.iter())
        .map(|(&x, &given)| (x - given).abs().to_f64());
    for by in moved {
        let rule = if by.is_nan() {
            "the loops do not close from here: start nearer to where they do, as by `assemble`, and not at a toggle position"
        } else {
            "it must be at most 1e-3: quaternions have unit length, and `assemble` closes loops"
        };
        require(by <= FAR, DISTANCE[0], by, rule)?;
    }
    check_loops(system, t, &x)?;
    Ok(x)
}

/// Checks that closed loops can close, and that they are closed.
pub(crate) fn check_loops<S, T, const N: usize>(system: &S, t: T, x: &SVector<T, N>) -> Result<(), Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    let mut wrong = open(system, t, x).map(Reason::Open);
    system.margins(t, x, &mut |bodies, [margin, _]| {
        if !margin.is_finite() {
            wrong = Some(Reason::CannotClose {
                bodies: bodies.map(Name::from),
            });
        }
    });
    wrong.map_or(Ok(()), Err)
}

/// Checks a state to start from.
pub(crate) fn check_state<T: Float, const N: usize>(x: &SVector<T, N>) -> Result<(), Reason> {
    for x in x.iter() {
        require(x.is_finite(), COMPONENT[0], x.to_f64(), "the state must be finite")?;
    }
    Ok(())
}
