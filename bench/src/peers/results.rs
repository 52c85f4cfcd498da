//! What was measured, as it goes into `peers.json`.

use pendulum_core::Operations;
use serde::Serialize;

use super::candidate::{Candidate, Function};
use crate::timing::Times;

#[derive(Serialize)]
pub(crate) struct Results {
    /// Date, machine, compilers, versions.
    pub header: Vec<String>,
    /// What was left out, and why.
    pub notes: Vec<String>,
    pub rows: Vec<Row>,
}

/// One candidate; times in nanoseconds per evaluation.
#[derive(Serialize)]
pub(crate) struct Row {
    pub model: String,
    pub function: Function,
    pub peer: String,
    pub form: String,
    /// Additions and multiplications.
    pub flops: Option<usize>,
    pub divisions: Option<usize>,
    pub sine_cosine_pairs: Option<usize>,
    pub least: f64,
    pub median: f64,
    /// The least time with hardly any sine and cosine.
    pub least_without: Option<f64>,
    /// The least time of as many sines and cosines as the generated code has, on their own.
    pub sines: Option<f64>,
    /// The generated code's time over this one's: the median over pairs of the same round, and from the least times.
    pub ratio: Option<f64>,
    pub ratio_of_least: Option<f64>,
    /// The same from the least times without sine and cosine.
    pub ratio_without: Option<f64>,
    /// Another form of the same peer was faster.
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
