//! What was measured, as it goes into `scaling.json`.

use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Results {
    pub header: Vec<String>,
    pub rows: Vec<Row>,
    pub robots: Vec<Robot>,
}

/// One function of one chain; the times are the least.
#[derive(Serialize)]
pub(crate) struct Row {
    pub chain: &'static str,
    pub joints: usize,
    pub function: &'static str,
    /// The form that was chosen.
    pub form: String,
    /// Its additions and multiplications.
    pub operations: usize,
    pub divisions: usize,
    /// The best form on each basis, from the shortest on.
    pub bases: Vec<Counted>,
    /// Seconds from tokens to tokens, of all that the chain generates.
    pub expansion: f64,
    /// Seconds of `rustc` on these tokens.
    pub compilation: f64,
    /// Of one evaluation.
    pub nanoseconds: f64,
}

/// Additions and multiplications on one basis.
#[derive(Serialize)]
pub(crate) struct Counted {
    pub basis: &'static str,
    pub operations: usize,
}

/// Seconds for a robot with Jacobian.
#[derive(Serialize)]
pub(crate) struct Robot {
    pub name: &'static str,
    pub expansion: f64,
    pub compilation: f64,
    /// One call of `rustc` on the declaration, expansion included.
    pub together: f64,
}
