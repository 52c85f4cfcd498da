//! Errors of tuning.

use std::error::Error;

use crate::accuracy::Failure;
use crate::error::{Reason, debug_as_display, messages};

/// Reason why no method was chosen.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum TuneError {
    /// A setting or an argument is invalid.
    InvalidInput(Reason),
    /// Fewer than two methods reached the end of the span.
    TooFewSucceeded {
        /// Each of the others with its failure.
        failures: Vec<(&'static str, Failure)>,
    },
    /// The search was [cancelled](crate::accuracy::Tuning::cancel).
    Cancelled,
    /// The error is smaller than what is known of the motion: two methods with the smallest tolerances differ by more.
    BelowUncertainty {
        /// The stated error.
        error: f64,
        /// Their largest relative difference at the end, of a pilot run.
        uncertainty: f64,
        /// The two methods.
        methods: [&'static str; 2],
    },
    /// No method reaches the error with any setting.
    NotReached {
        /// The stated error.
        error: f64,
        /// Largest error allowed in pilot runs, below `error` because other starts may err more.
        most: f64,
        /// The smallest one that was reached, and by which method.
        least: (f64, &'static str),
    },
}

debug_as_display! { [] TuneError; }

messages! {
    [] TuneError;
    Self::InvalidInput(reason) => "{reason}";
    Self::TooFewSucceeded { failures } =>
        "fewer than two methods reached the end of the span from each start, and two have to agree on it: {list}",
        list = listed(failures);
    Self::Cancelled => "the search for a method was cancelled";
    Self::BelowUncertainty { error, uncertainty, methods: [a, b] } =>
        "an error of {error:.1e} is not reached in `f64`: `{a}` and `{b}` with the smallest tolerances differ by \
         {uncertainty:.1e} at the end; state an error well above that, or shorten the span if the motion is chaotic";
    Self::NotReached { error, most, least: (least, name) } =>
        "no method reaches an error of {error:.1e}, for which pilot runs have to keep within {most:.2e}; the smallest \
         error was {least:.2e}, by `{name}`: state a larger error, or add methods of higher order";
}

impl Error for TuneError {}

impl From<Reason> for TuneError {
    fn from(reason: Reason) -> Self {
        Self::InvalidInput(reason)
    }
}

fn listed(failures: &[(&'static str, Failure)]) -> String {
    let each = failures.iter().map(|(name, failure)| format!("`{name}` {failure}"));
    each.collect::<Vec<_>>().join("; ")
}
