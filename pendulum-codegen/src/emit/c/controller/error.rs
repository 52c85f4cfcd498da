//! Errors of controllers.

use std::error::Error;
use std::fmt::{Display, Formatter};

/// Reason why a program has no controller in C.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoController {
    /// The model has no inputs.
    NoInputs,
    /// The model switches between modes: the names of its constraints.
    SwitchesModes(Vec<String>),
    /// The model has no right-hand side.
    NoRightHandSide,
    /// The model has a loop without a closed form: the bodies that close it.
    ClosedLoop([String; 2]),
    /// A list does not have the length that the scene requires.
    Length {
        /// Name of the list.
        what: &'static str,
        /// Its length.
        length: usize,
        /// The length required.
        expected: usize,
    },
    /// A list has a number that is infinite or NaN, or too large for single precision.
    NotFinite {
        /// Name of the list.
        what: &'static str,
    },
    /// A weight is not symmetric.
    NotSymmetric {
        /// Name of the matrix.
        what: &'static str,
        /// Row and column of an entry that differs from its mirror image.
        entry: [usize; 2],
        /// The entry and its mirror image.
        values: [f64; 2],
    },
    /// A weight is not positive semidefinite, or not definite where it has to be.
    NotPositive {
        /// Name of the matrix.
        what: &'static str,
        /// True if it has to be definite.
        strictly: bool,
    },
    /// The limits of an input are reversed, or not numbers.
    Limits {
        /// Name of the input.
        input: String,
        /// Its limits.
        limits: [f64; 2],
    },
    /// An input of the first plan is beyond its limits.
    StartBeyondLimits {
        /// Name of the input.
        input: String,
        /// Index of the step.
        step: usize,
        /// Value of the input.
        value: f64,
        /// Its limits.
        limits: [f64; 2],
    },
    /// The length of a step is not a positive number.
    Step(f64),
    /// A plan has no steps.
    NoSteps,
}

impl Display for NoController {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoInputs => f.write_str(
                "a controller needs inputs, and the scene declares none\nhelp: declare one, such as `input push: N,`, \
                 and use it in a `torque` or a force",
            ),
            Self::SwitchesModes(names) => {
                let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
                write!(
                    f,
                    "steps of fixed length do not switch modes, as at {}\nhelp: print a copy of the scene without dry \
                     friction, stops and walls, such as with smooth friction, `torque: -f*tanh(qd/w)`",
                    names.join(", ")
                )
            }
            Self::NoRightHandSide => f.write_str(
                "a controller needs equations of motion\nhelp: write `generate: [rhs, jacobian]`, or leave `generate` \
                 out",
            ),
            Self::ClosedLoop([a, b]) => write!(
                f,
                "the loop of `{a}` and `{b}` has no closed form, and its closure no derivatives\nhelp: plan with a \
                 scene whose loops have closed forms"
            ),
            Self::Length { what, length, expected } => write!(
                f,
                "{what} has {length} numbers, and the scene requires {expected}\nhelp: pass all entries, column by \
                 column, such as `matrix.as_slice()`"
            ),
            Self::NotFinite { what } => write!(
                f,
                "{what} has a number that is infinite or NaN, or too large for the precision\nhelp: pass finite \
                 numbers; limits alone may be infinite"
            ),
            Self::NotSymmetric {
                what,
                entry: [i, j],
                values: [value, mirrored],
            } => write!(
                f,
                "{what} is not symmetric: entry ({i}, {j}) is {value}, and entry ({j}, {i}) is {mirrored}\nhelp: use \
                 ({what} + {what}^T) / 2"
            ),
            Self::NotPositive { what, strictly } => {
                let (kind, least) = if *strictly { ("", "> 0") } else { ("semi", ">= 0") };
                write!(
                    f,
                    "{what} is not positive {kind}definite\nhelp: use a diagonal matrix with entries {least}, or \
                     C^T W C with such a W"
                )
            }
            Self::Limits {
                input,
                limits: [low, high],
            } => write!(
                f,
                "the limits of `{input}` are {low} and {high}\nhelp: pass the lower one first, `limits(low, high)`; \
                 without a limit, infinity"
            ),
            Self::StartBeyondLimits {
                input,
                step,
                value,
                limits: [low, high],
            } => write!(
                f,
                "the plan starts with {value} for `{input}` at step {step}, beyond its limits {low} and {high}\nhelp: \
                 pass inputs within the limits by `start_from`"
            ),
            Self::Step(h) => write!(
                f,
                "the length of a step is {h} s\nhelp: use a positive and finite one, such as 0.02"
            ),
            Self::NoSteps => f.write_str("a plan has no steps\nhelp: pass a number of steps, such as 50"),
        }
    }
}

impl Error for NoController {}
