//! Results as written to `peers.json`.

use pendulum_core::Operations;
use serde::Serialize;

use super::candidate::{Candidate, Function};
use crate::timing::Times;

#[derive(Serialize)]
pub(crate) struct Results {
    /// Date, machine, compilers, versions.
    pub header: Vec<String>,
    /// Left-out items, with the reason.
    pub notes: Vec<String>,
    pub rows: Vec<Row>,
}

/// Results of a candidate; times in nanoseconds per evaluation.
#[derive(Serialize)]
pub(crate) struct Row {
    pub model: String,
    pub function: Function,
    pub peer: String,
    pub form: String,
    /// Number of additions and multiplications.
    pub flops: Option<usize>,
    pub divisions: Option<usize>,
    pub sine_cosine_pairs: Option<usize>,
    pub least: f64,
    pub median: f64,
    /// Minimum time with cheap sines and cosines.
    pub least_without: Option<f64>,
    /// Minimum time of the sines and cosines alone, as many as in the generated code.
    pub sines: Option<f64>,
    /// Ratio of the time of the generated code to this one: median over pairs of the same round.
    pub ratio: Option<f64>,
    /// Ratio of the minimum times.
    pub ratio_of_least: Option<f64>,
    /// Ratio of the minimum times without sine and cosine.
    pub ratio_without: Option<f64>,
    /// True if another form of the same peer was faster.
    pub heat: bool,
}

impl Row {
    pub(crate) fn new(candidate: &Candidate, times: &Times) -> Self {
        let count = |of: fn(&Operations) -> usize| candidate.operations.as_ref().map(of);
        Self {
            model: candidate.model.clone(),
            function: candidate.function,
            peer: candidate.peer.clone(),
            form: candidate.form.clone(),
            flops: count(Operations::flops),
            divisions: count(|operations| operations.divisions),
            sine_cosine_pairs: count(|operations| operations.sincos),
            least: times.least(),
            median: times.median(),
            least_without: None,
            sines: None,
            ratio: None,
            ratio_of_least: None,
            ratio_without: None,
            heat: false,
        }
    }
}
