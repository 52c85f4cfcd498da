//! Results as written to `scaling.json`.

use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Results {
    pub header: Vec<String>,
    pub rows: Vec<Row>,
    pub robots: Vec<Robot>,
}

/// Results of one function of one chain; times are minima.
#[derive(Serialize)]
pub(crate) struct Row {
    pub chain: &'static str,
    pub joints: usize,
    pub function: &'static str,
    /// Form that was chosen.
    pub form: String,
    /// Number of its additions and multiplications.
    pub operations: usize,
    pub divisions: usize,
    /// The best form on each basis, the shortest first.
    pub bases: Vec<Counted>,
    /// Expansion from tokens to tokens of all functions of the chain, in seconds.
    pub expansion: f64,
    /// Time of `rustc` on these tokens, in seconds.
    pub compilation: f64,
    /// Time of one evaluation.
    pub nanoseconds: f64,
}

/// Number of additions and multiplications on one basis.
#[derive(Serialize)]
pub(crate) struct Counted {
    pub basis: &'static str,
    pub operations: usize,
}

/// Times of a robot with Jacobian, in seconds.
#[derive(Serialize)]
pub(crate) struct Robot {
    pub name: &'static str,
    pub expansion: f64,
    pub compilation: f64,
    /// One call of `rustc` on the declaration, including the expansion.
    pub together: f64,
}
