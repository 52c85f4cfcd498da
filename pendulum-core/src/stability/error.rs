//! Errors of stability analyses.

use std::error::Error;

use crate::error::{ParameterError, Reason, debug_as_display, messages};

/// Reason why an analysis has no result.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum StabilityError {
    /// An integration stopped early, or a setting is invalid.
    Integration(Reason),
    /// An entry of a matrix or of the right-hand side is infinite or NaN.
    NotFinite,
    /// The iteration did not converge.
    NoConvergence {
        /// Maximum number of iterations.
        iterations: usize,
        /// Largest component of the residual at the best point.
        residual: f64,
    },
    /// The analysis requires an autonomous system, but the right-hand side depends on time.
    TimeDependent,
    /// The system has more positions than rates, as with quaternions and some closed loops, and the analysis is not
    /// restricted to admissible directions.
    MorePositions,
    /// The periodic orbit is, or shrank to, an equilibrium, which is periodic with any period.
    AtRest,
    /// A family of systems has no member at the requested parameter.
    Build(ParameterError),
}

debug_as_display! { [] StabilityError; }

messages! {
    [] StabilityError;
    Self::Integration(reason) => "{reason}";
    Self::NotFinite =>
        "the right-hand side or a matrix is not finite; check the parameters and the state, which may be singular";
    Self::NoConvergence { iterations, residual } =>
        "no convergence: after {iterations} iterations the residual is {residual:.3e}; start closer to the solution, \
         or check that one exists";
    Self::TimeDependent =>
        "the right-hand side depends on time, so the system has no equilibria or autonomous periodic orbits; search \
         for motions with the period of the drive by `Shooting::forced`";
    Self::MorePositions =>
        "periodic orbits and families are not supported for systems with quaternions, or with dependent coordinates in \
         the state; replace a ball joint by three revolute joints, or mark coordinates `depends` so that each loop is \
         a triangle";
    Self::AtRest =>
        "the orbit shrank to a steady state; start farther from it, or with a period closer to that of the orbit";
    Self::Build(error) => "{error}";
}

impl Error for StabilityError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Integration(reason) => Some(reason),
            Self::Build(error) => Some(error),
            Self::NotFinite | Self::NoConvergence { .. } | Self::TimeDependent | Self::MorePositions | Self::AtRest => {
                None
            }
        }
    }
}

impl From<Reason> for StabilityError {
    fn from(reason: Reason) -> Self {
        Self::Integration(reason)
    }
}

impl From<ParameterError> for StabilityError {
    fn from(error: ParameterError) -> Self {
        Self::Build(error)
    }
}
