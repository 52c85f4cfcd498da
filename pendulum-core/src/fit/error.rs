//! Errors of fits.

use std::error::Error;

use crate::error::{Reason, debug_as_display, messages};

/// A reason why a fit cannot begin.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// There is no experiment.
    NoExperiment,
    /// A measurement has no output.
    NoOutput {
        /// Index of the experiment.
        experiment: usize,
    },
    /// A column is neither an output of the scene nor a component of its state.
    UnknownOutput {
        /// Name of the column.
        name: String,
        /// The most similar name, if one is similar.
        nearest: Option<String>,
        /// Names of all outputs and components.
        outputs: Vec<String>,
    },
    /// The scene has no parameter of this name.
    UnknownParameter {
        /// The name.
        name: String,
        /// The most similar name, if one is similar.
        nearest: Option<String>,
        /// Names of all parameters.
        parameters: Vec<String>,
    },
    /// There are no more values than unknowns.
    TooFewValues {
        /// Number of measured values that are not missing.
        values: usize,
        /// Number of free parameters and of unknown components of starts.
        unknowns: usize,
    },
    /// A parameter begins outside of its bounds.
    OutsideBounds {
        /// Name of the parameter.
        parameter: String,
        /// Its value in the model.
        value: f64,
        /// Its bounds.
        bounds: [f64; 2],
    },
    /// The bounds of a parameter are not two numbers in ascending order.
    Bounds {
        /// Name of the parameter.
        parameter: String,
        /// The bounds.
        bounds: [f64; 2],
    },
    /// All values of an output are missing.
    NoValues {
        /// Name of the output.
        output: String,
    },
    /// An output, or its derivative, is infinite or NaN at the parameters of the model.
    NotFinite {
        /// Name of the output.
        output: String,
        /// Index of the experiment.
        experiment: usize,
        /// Time of the sample.
        t: f64,
    },
    /// A setting is invalid.
    Setting {
        /// Name of the setting.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Violated rule.
        rule: &'static str,
    },
    /// The state of an experiment is known at a time after its first sample.
    StartsLate {
        /// Index of the experiment.
        experiment: usize,
        /// Time of the known state.
        t: f64,
        /// Time of the first sample.
        first: f64,
    },
    /// No output depends on a free parameter, at the values of the model.
    NoInfluence {
        /// Name of the parameter.
        parameter: String,
    },
    /// The model cannot be integrated with its parameters.
    Integration {
        /// Index of the experiment.
        experiment: usize,
        /// Time at the start of the window.
        from: f64,
        /// Reason why the integration stopped.
        reason: Box<Reason>,
    },
}

debug_as_display! { [] FitError; }

messages! {
    [] FitError;
    Self::NoExperiment => "there is no experiment: a fit needs at least one";
    Self::NoOutput { experiment } =>
        "the measurement of experiment {experiment} has no outputs: add them by `Measurement::output`";
    Self::UnknownOutput { name, nearest, outputs } =>
        "the scene has no output or component of the state `{name}`; {suggestion}",
        suggestion = suggestion(nearest.as_deref(), outputs);
    Self::UnknownParameter { name, nearest, parameters } =>
        "the scene has no parameter `{name}`; {suggestion}",
        suggestion = suggestion(nearest.as_deref(), parameters);
    Self::TooFewValues { values, unknowns } =>
        "{values} measured values for {unknowns} unknowns: measure more, or fix parameters or starts";
    Self::OutsideBounds { parameter, value, bounds: [low, high] } =>
        "`{parameter}` is {value} in the model, outside of its bounds {low} and {high}: begin inside";
    Self::Bounds { parameter, bounds: [low, high] } =>
        "the bounds of `{parameter}` are {low} and {high}: give the lower one first";
    Self::NoValues { output } => "all values of `{output}` are missing: leave the output out of the measurement";
    Self::NotFinite { output, experiment, t } =>
        "`{output}` or its derivative is not finite at t = {t} in experiment {experiment}, with the parameters of the \
         model: begin at other parameters, or from another state";
    Self::Setting { what, value, rule } => "{what} is {value}: {rule}";
    Self::StartsLate { experiment, t, first } =>
        "the state of experiment {experiment} is known at t = {t}, after its first sample at t = {first}: leave out \
         the samples before by `Measurement::between`";
    Self::NoInfluence { parameter } =>
        "no measured output depends on `{parameter}` at its value in the model: fix it, begin at another value or from \
         another state (`Experiment::from_guess`), or measure a motion that depends on it";
    Self::Integration { experiment, from, reason } =>
        "experiment {experiment} cannot be integrated from t = {from} with the parameters of the model: {reason}";
}

impl Error for FitError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Integration { reason, .. } => Some(reason),
            _ => None,
        }
    }
}

/// Suggests the nearest of some names, or else lists all of them.
fn suggestion(nearest: Option<&str>, all: &[String]) -> String {
    match nearest {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None if all.is_empty() => "it has none".to_owned(),
        None => format!("it has `{}`", all.join("`, `")),
    }
}
