//! Results as written to `peers.json`.

use pendulum_core::Operations;
use serde::Serialize;

use super::candidate::{Candidate, Function, Order};
use crate::timing::Times;

#[derive(Serialize)]
pub(crate) struct Results {
    /// Date, machine, compilers, versions.
    pub header: Vec<String>,
    /// Left-out items, with the reason.
    pub notes: Vec<String>,
    pub rows: Vec<Row>,
}

/// Results of a candidate, with the times of all rounds.
#[derive(Serialize)]
pub(crate) struct Row {
    pub model: String,
    pub function: Function,
    pub order: Order,
    pub peer: String,
    pub form: String,
    /// Number of additions and multiplications.
    pub flops: Option<usize>,
    pub divisions: Option<usize>,
    pub sine_cosine_pairs: Option<usize>,
    pub times: Times,
    /// Times with cheap sines and cosines.
    pub without: Option<Times>,
    /// Times of the sines and cosines alone, as many as in the generated code.
    pub sines: Option<Times>,
    /// True if another form of the same peer was faster. Rounds of rows without this mark are the same.
    pub heat: bool,
}

impl Row {
    pub(crate) fn new(candidate: &Candidate, times: Times) -> Self {
        let count = |of: fn(&Operations) -> usize| candidate.operations.as_ref().map(of);
        Self {
            model: candidate.model.clone(),
            function: candidate.function,
            order: candidate.order,
            peer: candidate.peer.clone(),
            form: candidate.form.clone(),
            flops: count(Operations::flops),
            divisions: count(|operations| operations.divisions),
            sine_cosine_pairs: count(|operations| operations.sincos),
            times,
            without: None,
            sines: None,
            heat: false,
        }
    }
}
