//! Error types. Each message states the fact and a remedy. `Debug` prints the same message, so that a `main` that
//! returns the error reads well.

mod messages;
mod name;
#[cfg(feature = "std")]
mod sample;
#[cfg(feature = "std")]
mod solve;

use core::convert::Infallible;
use core::error::Error;
use core::fmt;

pub use name::Name;
#[cfg(feature = "std")]
pub use sample::SampleError;
#[cfg(feature = "std")]
pub use solve::SolveError;

pub(crate) use messages::{debug_as_display, messages};

debug_as_display! {
    [] NotAssembled;
    [] ParameterError;
    [] Reason;
}

/// A closed loop that is open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopGap {
    /// The two bodies that close the loop.
    pub bodies: [Name; 2],
    /// Distance between its ends, or the angle between their frames or axes.
    pub by: f64,
    /// Unit of `by`: `m` or `rad`.
    pub unit: &'static str,
}

impl fmt::Display for LoopGap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            bodies: [a, b],
            by,
            unit,
        } = self;
        write!(f, "the loop between `{a}` and `{b}` is open by {by:.1e} {unit}")?;
        if *unit == "rad" {
            f.write_str(", the angle between the connected frames or axes")?;
        }
        Ok(())
    }
}

/// Error: no state near a guess closes the loops of a mechanism.
#[derive(Clone, Copy, PartialEq)]
pub struct NotAssembled {
    /// Last correction of Newton's method, in rad or m; NaN if the equations are singular.
    pub left: f64,
    /// Loop with the largest gap at the last iterate; `None` if the loops are closed, or their gaps not available.
    pub open: Option<LoopGap>,
}

impl fmt::Display for NotAssembled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.left.is_nan() {
            return f.write_str(
                "the loops do not determine the dependent coordinates near this state, a singularity (toggle); \
                 guess another state",
            );
        }
        f.write_str("the loops do not close near this state: ")?;
        match self.open {
            Some(gap) => gap.fmt(f),
            None => write!(
                f,
                "Newton's method did not converge, with a last correction of {:.1e}",
                self.left
            ),
        }?;
        f.write_str("; check lengths, positions and axes, or give a closer guess of the dependent coordinates")
    }
}

impl Error for NotAssembled {}

/// A parameter or a combination of parameters that is invalid for a mechanism.
#[derive(Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ParameterError {
    /// Parameter or combination of parameters that was checked.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// Violated rule: "the mass of `upper` must be positive".
    pub rule: &'static str,
    /// Parameters of a combination with their values; empty if a single parameter violates the rule. Requires the
    /// feature `std`.
    #[cfg(feature = "std")]
    pub given: Vec<(&'static str, f64)>,
}

impl ParameterError {
    /// Creates an error for the `value` of `name`, which violates the `rule`. The value of a combination follows from
    /// the parameters in `given`.
    #[must_use]
    pub fn new(name: &'static str, value: f64, rule: &'static str, given: &[(&'static str, f64)]) -> Self {
        #[cfg(not(feature = "std"))]
        let _ = given;
        Self {
            name,
            value,
            rule,
            #[cfg(feature = "std")]
            given: given.to_vec(),
        }
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        #[cfg(feature = "std")]
        if let [(first, value), rest @ ..] = &self.given[..] {
            write!(f, "{}; the parameters are {first} = {value}", self.rule)?;
            return rest
                .iter()
                .try_for_each(|(name, value)| write!(f, ", {name} = {value}"));
        }
        write!(f, "parameter `{}` is {}: {}", self.name, self.value, self.rule)
    }
}

impl Error for ParameterError {}

/// Reason why an integration stopped early.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// A setting or an argument is invalid; nothing was integrated.
    InvalidInput {
        /// Name of the setting or argument.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Violated rule.
        rule: &'static str,
    },
    /// The state or its derivative is infinite or NaN, even with the shortest step that the method can take.
    NonFinite {
        /// First such component of the state, or else of its derivative.
        component: usize,
        /// Length of the step in which it appeared; `None` at the start of the integration, or after a reset.
        h: Option<f64>,
    },
    /// A closed loop cannot close in the initial state, or in the state after a reset.
    CannotClose {
        /// The two bodies that close the loop.
        bodies: [Name; 2],
    },
    /// A closed loop is open in the initial state, or in the state after a reset: see
    /// [`System::gaps`](crate::System::gaps).
    Open(LoopGap),
    /// A closed loop reaches its toggle, a singularity where it is flat: the motion cannot continue there. Or a step is
    /// so long that the loop may reach it.
    Toggle {
        /// The two bodies that close the loop.
        bodies: [Name; 2],
        /// Remaining distance from the toggle, as `margin` in the declaration.
        margin: f64,
    },
    /// An angle determined by closed loops reaches half a turn from its `near`, or may within one step, and a force
    /// depends on its turns, which the state does not determine.
    HalfTurn {
        /// Name of the angle.
        coordinate: Name,
    },
    /// The tolerance requires a step shorter than the minimum, or shorter than the resolution of the time.
    StepUnderflow {
        /// Length of the required step.
        h: f64,
        /// Minimum step.
        least: f64,
    },
    /// The equations of an implicit step could not be solved, even with the shortest step that the method can take.
    NoConvergence {
        /// Length of the step.
        h: f64,
    },
    /// The function of an event is infinite or NaN.
    EventNotFinite {
        /// Index of the event among those given.
        event: usize,
        /// Time of the failure.
        t: f64,
    },
    /// A [cost](crate::sensitivity::Cost) or one of its derivatives is infinite or NaN.
    CostNotFinite,
    /// An event resets the state to one that is not finite, or that violates the constraints of the system: its
    /// quaternions are not of unit length, or its loops are open.
    BadReset {
        /// Index of the event among those given.
        event: usize,
        /// Time of the reset.
        t: f64,
        /// Quantity of the new state that violates a rule.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Violated rule.
        rule: &'static str,
    },
    /// An event resets the state repeatedly within the resolution of the time, like a bouncing ball that comes to rest,
    /// or a thousand times in a row at such short intervals that the integration would never end.
    EventsAccumulate {
        /// Index of the event among those given.
        event: usize,
    },
    /// A constraint of a [hybrid](crate::hybrid) system starts beyond its limit, or an event resets it to there.
    BeyondLimit {
        /// Name of the constraint.
        constraint: Name,
        /// Its value.
        value: f64,
        /// Its limit.
        limit: f64,
    },
    /// The value, the rate or the force of a constraint is infinite or NaN.
    ConstraintNotFinite {
        /// Name of the constraint.
        constraint: Name,
        /// Time of the failure.
        t: f64,
    },
    /// The modes of a hybrid system switch without time advancing, or almost.
    ModesAccumulate {
        /// Name of a constraint whose status changes.
        constraint: Name,
    },
    /// Derivatives of the motion do not exist: contacts close at the same time, but would not if the variables were
    /// slightly different, or a limit is only touched. See [`sensitivity`](crate::sensitivity).
    NotDifferentiable {
        /// Name of a constraint whose status changes.
        constraint: Name,
    },
    /// The right-hand side jumps, or is noisy, so that steps become too short or too many.
    Jump {
        /// Component of the derivative of the state that jumps the most.
        component: usize,
        /// Size of the jump, in the unit of the component.
        by: f64,
    },
    /// The inputs before the first command of a [`Sampled`](crate::control::Sampled) controller exceed its limits.
    StartBeyondLimits {
        /// Index of the input.
        input: usize,
        /// Its value before the first command.
        start: f64,
        /// Its limits.
        limits: [f64; 2],
    },
    /// A command of a [`Sampled`](crate::control::Sampled) controller is infinite or NaN.
    CommandNotFinite {
        /// Index of the input.
        input: usize,
        /// Time of the sample.
        t: f64,
    },
    /// The [observer](crate::Observer::is_cancelled) ended the integration.
    Cancelled,
    /// The end was not reached within the maximum number of steps, including rejected ones.
    TooManySteps {
        /// Maximum number of steps.
        max_steps: usize,
    },
}

/// Margin of a loop below which a failure of the equations is attributed to its toggle.
pub(crate) const AT_TOGGLE: f64 = 0.1;

/// For steps that cannot fail.
impl From<Infallible> for Reason {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

messages! {
    [] Reason;
    // functions of the system have no value
    Self::InvalidInput { what: what @ "hybrid_jacobian", rule, .. } => "no `{what}`: {rule}";
    Self::InvalidInput { what, value, rule } => "`{what}` is {value:?}: {rule}";
    Self::NonFinite { component, h: None } =>
        "component {component} of the state or its derivative is not finite at the start of the integration, or after \
         a reset; check the parameters, the initial state, and the state that a reset returns";
    Self::NonFinite { component, h: Some(h) } =>
        "component {component} of the state or its derivative is not finite after a step of {h:.3e}; if the step is \
         fixed, try a shorter one; otherwise the right-hand side is singular or undefined there";
    Self::CannotClose { bodies: [a, b] } =>
        "the loop between `{a}` and `{b}` cannot close, or is singular (flat), in the initial state or after a reset; \
         check the state, and the lengths if they are not the defaults";
    Self::Open(gap) =>
        "{gap} in the initial state, or after a reset; close it by `assemble` from a nearby guess, and check lengths, \
         positions and axes";
    Self::Toggle { bodies: [a, b], margin } if *margin < AT_TOGGLE =>
        "the loop between `{a}` and `{b}` reaches its singularity (toggle): its margin is {margin:.1e}; end the motion \
         earlier by an event on `margin({a}, {b})`, or, to pass through, mark another coordinate `depends`";
    Self::Toggle { bodies: [a, b], margin } =>
        "the loop between `{a}` and `{b}` may reach its singularity (toggle) within one step, from a margin of \
         {margin:.1e}; take shorter steps";
    Self::HalfTurn { coordinate } =>
        "`{coordinate}` reaches half a turn from its `near`, or may within one step, and a force depends on its number \
         of turns, which the state does not determine; make `{coordinate}` independent and mark another coordinate of \
         its loop `depends`, or take shorter steps";
    Self::StepUnderflow { h, least } =>
        "the tolerance requires a step of {h:.3e}, below the minimum of {least:.3e}; the solution may be singular or \
         jump there: loosen the tolerance or end the integration earlier";
    Self::NoConvergence { h } =>
        "the equations of an implicit step of {h:.3e} did not converge; take shorter steps, or check the right-hand \
         side for a discontinuity there";
    Self::CostNotFinite =>
        "the cost of the trajectory or one of its derivatives is not finite: check the cost where a square root or a \
         logarithm reaches zero, and shorten trajectories whose derivatives grow without bound";
    Self::EventNotFinite { event, t } =>
        "the function of event {event} is not finite at t = {t}; extend its domain or end the integration earlier";
    Self::BadReset { event, t, what, value, rule } =>
        "event {event} resets the state at t = {t:?} to an invalid one: {what} is {value:?}; {rule}";
    Self::EventsAccumulate { event } =>
        "event {event} repeats without time advancing, like a bouncing ball that comes to rest; declare a `stop` or a \
         `wall` instead, at which motion can come to rest, or reset to a state further from the event";
    Self::BeyondLimit { constraint, value, limit } =>
        "`{constraint}` starts at {value:?}, beyond its limit of {limit:?}; start within the limits, and reset states \
         to within them";
    Self::ConstraintNotFinite { constraint, t } =>
        "the value, the rate or the force of `{constraint}` is not finite at t = {t}; check its gap, and that the mass \
         it acts on is not zero";
    Self::ModesAccumulate { constraint } =>
        "`{constraint}` switches modes repeatedly without time advancing; if a moving wall presses against an \
         immovable body, let one of the two yield; if its rebounds are too fast, set or raise `slow`; if it has dry \
         friction, check that the friction is larger than rounding errors";
    Self::NotDifferentiable { constraint } =>
        "`{constraint}` and another contact close at the same time, but not for other values of the variables, or it \
         only touches its limit, so that whether it closes depends on rounding errors: the motion has no derivatives \
         there; choose a slightly different initial condition, or fewer variables";
    Self::Jump { component, by } =>
        "component {component} of the derivative of the state jumps by {by:.3e} near here, and no step across a jump \
         meets the tolerance; if a law is sampled or noisy, run it by `control::Sampled`, which steps from sample to \
         sample; if it switches, make it continuous, as by `clamp` or `tanh`; for dry friction, declare \
         `dry_friction`";
    Self::StartBeyondLimits { input, start, limits: [low, high] } =>
        "input {input} is {start:?} before the first command, beyond its limits of {low:?} and {high:?}; pass inputs \
         within them to `start`, or check the limits";
    Self::CommandNotFinite { input, t } =>
        "the command for input {input} is not finite at t = {t:?}; check the controller, its gains, and that the \
         motion does not diverge";
    Self::Cancelled => "the integration was cancelled";
    Self::TooManySteps { max_steps } =>
        "{max_steps} steps did not reach the end; raise `max_steps` or loosen the tolerance; if the steps are much \
         shorter than the motion requires, run a law that samples by `control::Sampled`, or use a method for stiff \
         systems, such as `Auto`";
}

impl Error for Reason {}

#[cfg(test)]
mod tests {
    use super::{ParameterError, Reason};

    #[test]
    fn a_parameter_error_names_value_and_rule() {
        let rule = "the mass of `upper` must be positive";
        assert_eq!(
            ParameterError::new("m", -1.0, rule, &[]).to_string(),
            "parameter `m` is -1: the mass of `upper` must be positive"
        );
        assert_eq!(
            ParameterError::new("m - n", -1.0, rule, &[("m", 1.0), ("n", 2.0)]).to_string(),
            "the mass of `upper` must be positive; the parameters are m = 1, n = 2"
        );
    }

    #[test]
    fn debug_reads_as_display() {
        let reason = Reason::NonFinite {
            component: 1,
            h: Some(0.3),
        };
        assert_eq!(format!("{reason:?}"), reason.to_string());
        assert!(
            reason
                .to_string()
                .contains("after a step of 3.000e-1; if the step is fixed, try a shorter one")
        );
    }
}
