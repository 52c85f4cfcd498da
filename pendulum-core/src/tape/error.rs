//! Errors of tapes.

use std::error::Error;
use std::fmt;

/// A text is not a tape, or not one of this version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TapeError {
    /// Line of the text, from 1.
    pub line: usize,
    /// The mistake there.
    pub fact: String,
}

impl fmt::Display for TapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {} of the tape: {}", self.line, self.fact)
    }
}

impl Error for TapeError {}

/// A tape has no model with the requested state and parameters.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ModelError {
    /// The state of the model has another length than the requested one.
    State {
        /// Requested length.
        given: usize,
        /// Length of the state.
        length: usize,
    },
    /// Another number of parameters was given than the model has.
    Parameters {
        /// Number of the given ones.
        given: usize,
        /// Names of the parameters.
        names: Vec<String>,
    },
    /// A parameter or a combination of parameters is invalid.
    Parameter(crate::ParameterError),
    /// A routine has other arguments or results than its name demands.
    Shape {
        /// Name of the routine.
        name: String,
    },
    /// The tape lacks the routine of this name, without which there is no motion.
    Missing {
        /// Name of the routine.
        name: String,
    },
    /// The mechanism has dry friction, stops or walls.
    Hybrid,
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::State { given, length } => write!(f, "the state has {length} components, not {given}"),
            Self::Parameters { given, names } if names.is_empty() => {
                write!(f, "the model has no parameters, and {given} are given")
            }
            Self::Parameters { given, names } => write!(
                f,
                "the model has the parameters {}, which are {}, not {given}",
                names.join(", "),
                names.len()
            ),
            Self::Parameter(error) => error.fmt(f),
            Self::Shape { name } => {
                write!(
                    f,
                    "the routine `{name}` of the tape has other arguments or results than its name demands"
                )
            }
            Self::Missing { name } => {
                write!(
                    f,
                    "the tape has no routine `{name}`: add `rhs` to the `generate` of its declaration"
                )
            }
            Self::Hybrid => {
                f.write_str("the mechanism has dry friction, stops or walls: ask for a `HybridModel` of its tape")
            }
        }
    }
}

impl Error for ModelError {}
