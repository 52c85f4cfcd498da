//! What can go wrong, as types: every error says what the fact is and what to do.

use std::error::Error;
use std::fmt;

use nalgebra::SVector;

use crate::real::Float;
use crate::solution::Solution;

/// A parameter that no mechanism can have.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ParameterError {
    /// The name of the parameter.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The rule it breaks, as a sentence: "the mass of `upper` must be positive".
    pub rule: &'static str,
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "parameter `{}` is {}: {}", self.name, self.value, self.rule)
    }
}

impl Error for ParameterError {}

/// Why an integration ended before its time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// A setting or an argument makes no sense; nothing was integrated.
    InvalidInput {
        /// The name of the setting or argument.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The rule it breaks, as a sentence.
        rule: &'static str,
    },
    /// The state or its derivative is infinite or not a number, and smaller steps did not help where the method may choose them.
    NonFinite {
        /// The first component of the state, or of its derivative, that is not finite.
        component: usize,
        /// The length of the step in which it appeared; `None` if it did where the integration starts, or goes on after a reset.
        h: Option<f64>,
    },
    /// The tolerance asks for a step shorter than the time can resolve, or shorter than the least one allowed.
    StepUnderflow {
        /// The length of the step that was asked for.
        h: f64,
        /// The least length that is allowed.
        least: f64,
    },
    /// The equations of an implicit step could not be solved, and smaller steps did not help where the method may choose them.
    NoConvergence {
        /// The length of the step.
        h: f64,
    },
    /// The function of an event is infinite or not a number.
    EventNotFinite {
        /// The place of the event among those given.
        event: usize,
        /// The time at which that was seen.
        t: f64,
    },
    /// An event resets the state again and again within the resolution of time, as the rebounds of a ball that comes to rest.
    EventsAccumulate {
        /// The place of the event among those given.
        event: usize,
    },
    /// The steps allowed were taken, rejected ones included, and the end was not reached.
    TooManySteps {
        /// The number of steps allowed.
        max_steps: usize,
    },
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::InvalidInput { what, value, rule } => write!(f, "`{what}` is {value:?}: {rule}"),
            Self::NonFinite { component, h: None } => write!(
                f,
                "component {component} of the state, or of its derivative, is not finite where the integration starts or goes on after a reset; \
                 check the parameters, the initial state, and what a reset returns"
            ),
            Self::NonFinite { component, h: Some(h) } => write!(
                f,
                "component {component} of the state or of its derivative is not finite after a step of {h:.3e}; \
                 look for a singularity or a domain error of the right-hand side there, or end the integration earlier"
            ),
            Self::StepUnderflow { h, least } => write!(
                f,
                "the tolerance asks for a step of {h:.3e}, below the least of {least:.3e}; the solution is singular or jumps \
                 there, or the tolerance is too tight for the noise of the right-hand side: loosen it or end earlier"
            ),
            Self::NoConvergence { h } => write!(
                f,
                "the equations of an implicit step of {h:.3e} have no solution that the iteration finds; take shorter steps, or look \
                 for a jump of the right-hand side there"
            ),
            Self::EventNotFinite { event, t } => write!(
                f,
                "the function of event {event} is not finite at t = {t}; extend its domain, or end the integration before"
            ),
            Self::EventsAccumulate { event } => write!(
                f,
                "event {event} occurs again and again and time stands still, as where rebounds come to rest; make it terminal below some \
                 speed, and go on with a model of the contact"
            ),
            Self::TooManySteps { max_steps } => write!(
                f,
                "{max_steps} steps did not reach the end; raise `max_steps` or loosen the tolerance, and if the steps are \
                 far shorter than the motion asks for, the system is stiff and wants an implicit method"
            ),
        }
    }
}

impl Error for Reason {}

/// An integration that ended before its time, with all that it had reached.
#[derive(Clone, Debug, PartialEq)]
pub struct SolveError<T, const N: usize> {
    /// Why it ended.
    pub reason: Reason,
    /// The solution up to the last good state; the initial point alone if no step succeeded.
    ///
    /// For [`Reason::InvalidInput`] that is the initial point as it was given, good or not.
    pub solution: Box<Solution<T, N>>,
}

impl<T: Float, const N: usize> SolveError<T, N> {
    /// An integration that did not come to its first step.
    pub(crate) fn at_start(reason: Reason, t0: T, x0: SVector<T, N>) -> Self {
        Self {
            reason,
            solution: Box::new(Solution::start(t0, x0)),
        }
    }

    /// The last good time.
    #[must_use]
    pub fn t(&self) -> T {
        self.solution.last().0
    }

    /// The last good state.
    #[must_use]
    pub fn x(&self) -> SVector<T, N> {
        self.solution.end()
    }
}

impl<T: Float, const N: usize> fmt::Display for SolveError<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.reason {
            Reason::InvalidInput { .. } => self.reason.fmt(f),
            _ => write!(f, "stopped at t = {}: {}", self.t().to_f64(), self.reason),
        }
    }
}

impl<T: Float, const N: usize> Error for SolveError<T, N> {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parameter_error_names_value_and_rule() {
        const ERROR: ParameterError = ParameterError {
            name: "m",
            value: -1.0,
            rule: "the mass of `upper` must be positive",
        };
        assert_eq!(
            ERROR.to_string(),
            "parameter `m` is -1: the mass of `upper` must be positive"
        );
    }
}
