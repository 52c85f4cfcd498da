//! Errors of tapes.

use std::error::Error;

use crate::error::messages;

/// A text is not a tape, or not one of this version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TapeError {
    /// Line of the text, from 1.
    pub line: usize,
    /// The mistake there.
    pub fact: String,
}

messages! {
    [] TapeError;
    Self { line, fact } => "line {line} of the tape: {fact}";
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

messages! {
    [] ModelError;
    Self::State { given, length } => "the state has {length} components, not {given}";
    Self::Parameters { given, names } if names.is_empty() => "the model has no parameters, and {given} are given";
    Self::Parameters { given, names } =>
        "the model has the parameters {all}, which are {count}, not {given}",
        all = names.join(", "), count = names.len();
    Self::Parameter(error) => "{error}";
    Self::Shape { name } =>
        "the routine `{name}` of the tape has other arguments or results than its name demands";
    Self::Missing { name } =>
        "the tape has no routine `{name}`: add `rhs` to the `generate` of its declaration";
    Self::Hybrid =>
        "the mechanism has dry friction, stops or walls: ask for a `HybridModel` of its tape";
}

impl Error for ModelError {}
