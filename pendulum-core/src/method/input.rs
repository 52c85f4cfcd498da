//! Validation of settings and arguments, common to all methods.

use nalgebra::SVector;

use crate::error::{Name, Reason};
use crate::layout::StateLayout;
use crate::real::Float;
use crate::system::{System, close, open};

/// Returns an error unless `holds`.
pub(crate) fn require(holds: bool, what: &'static str, value: f64, rule: &'static str) -> Result<(), Reason> {
    if holds {
        Ok(())
    } else {
        Err(Reason::InvalidInput { what, value, rule })
    }
}

/// Checks that the time span is finite.
pub(crate) fn check_span<T: Float>(t0: T, t1: T) -> Result<(), Reason> {
    let finite = "a time must be finite";
    require(t0.is_finite(), "t0", t0.to_f64(), finite)?;
    require(t1.is_finite(), "t1", t1.to_f64(), finite)?;
    let span = t1 - t0;
    let rule = "the span of time must be finite; integrate it in several parts";
    require(span.is_finite(), "t1 - t0", span.to_f64(), rule)
}

/// Checks the time span and the initial condition.
pub(crate) fn check_start<T: Float, const N: usize>(t0: T, t1: T, x0: &SVector<T, N>) -> Result<(), Reason> {
    const { assert!(N > 0, "a state has at least one component") };
    check_span(t0, t1)?;
    check_state(x0)
}

/// Largest distance of an initial condition from the constraints of its system. A larger one is an error of the caller,
/// not a rounding error.
const FAR: f64 = 1e-3;

/// Names of checked quantities: in an initial condition, and in a state returned by a reset.
const COMPONENT: [&str; 2] = ["x0", "a component"];
const QUATERNION: [&str; 2] = ["length of a quaternion in x0", "the length of a quaternion"];
const DISTANCE: [&str; 2] = [
    "distance of x0 from the constraints",
    "its distance from the constraints",
];

/// Converts the reason that rejects a state returned by an event at the time `t`.
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

/// Projects an initial condition onto the constraints of its system. Rejects it if it is far from them.
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
            "the loops do not close near this state: start from a closed one, as `assemble` returns, away from a \
             singularity (toggle)"
        } else {
            "it must be at most 1e-3: quaternions have unit length, and `assemble` closes loops"
        };
        require(by <= FAR, DISTANCE[0], by, rule)?;
    }
    check_loops(system, t, &x)?;
    Ok(x)
}

/// Checks that the closed loops can be closed, and that they are.
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

/// Checks that an initial condition is finite.
pub(crate) fn check_state<T: Float, const N: usize>(x: &SVector<T, N>) -> Result<(), Reason> {
    for x in x.iter() {
        // a value that is finite itself has derivatives that are not
        let rule = if x.to_f64().is_finite() {
            "its derivatives must be finite: where a motion only touches the zero of an event, the time of the event \
             has none"
        } else {
            "the state must be finite"
        };
        require(x.is_finite(), COMPONENT[0], x.to_f64(), rule)?;
    }
    Ok(())
}
