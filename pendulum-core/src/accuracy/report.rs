//! Results of a sweep.

use std::error::Error;
use std::fmt;

use crate::accuracy::Errors;
use crate::error::{Reason, debug_as_display};
use crate::statistics::Statistics;

/// Measurements of all methods.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Report {
    /// One entry per method, in the order of insertion.
    pub methods: Vec<MethodRuns>,
    /// Uncertainty of the reference at the end of the span.
    pub uncertainty: f64,
}

/// Measurements of one method.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct MethodRuns {
    /// Name of the method.
    pub name: String,
    /// One entry per setting.
    pub runs: Vec<Run>,
}

/// Result of one setting.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Run {
    /// Tolerance or step size.
    pub setting: f64,
    /// Measurements if the integration reached its end, otherwise the failure.
    pub outcome: Result<Measured, Failure>,
}

/// Accuracy and cost of an integration that reached its end.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Measured {
    /// Errors with respect to the reference.
    pub errors: Errors,
    /// Shortest run time, in seconds per trajectory.
    pub minimum: f64,
    /// Median run time, in seconds per trajectory.
    pub median: f64,
    /// Evaluations and steps, excluding those for dense output. `None` for ensembles and other solvers, which do not
    /// report them.
    pub work: Option<Statistics>,
}

debug_as_display! { [] Failure; }

/// Time and reason of an early stop.
#[derive(Clone, Copy, PartialEq)]
pub struct Failure {
    /// Last valid time.
    pub t: f64,
    /// Reason of the stop.
    pub reason: Reason,
}

impl Report {
    /// Returns the name of each method with the fastest setting whose error at the end ([`Errors::last`]) is at most
    /// `error`. The setting is `None` if none qualifies, or if the uncertainty of the reference exceeds `error`.
    pub fn time_to_reach(&self, error: f64) -> impl Iterator<Item = (&str, Option<(f64, &Measured)>)> {
        let known = self.uncertainty <= error;
        self.methods
            .iter()
            .map(move |method| (&*method.name, method.cheapest(error).filter(|_| known)))
    }
}

impl MethodRuns {
    /// Iterates over the settings that reached the end, with their measurements.
    pub fn measured(&self) -> impl Iterator<Item = (f64, &Measured)> {
        self.runs
            .iter()
            .filter_map(|run| Some((run.setting, run.outcome.as_ref().ok()?)))
    }

    fn cheapest(&self, error: f64) -> Option<(f64, &Measured)> {
        self.measured()
            .filter(|(_, measured)| measured.errors.last <= error)
            .min_by(|(_, a), (_, b)| a.minimum.total_cmp(&b.minimum))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "stopped at t = {:?}: {}", self.t, self.reason)
    }
}

impl Error for Failure {}

/// A table of all runs, with times in microseconds.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |method: &MethodRuns| method.name.chars().count();
        let width = self.methods.iter().map(name).fold(12, usize::max);
        write!(
            f,
            "{:<width$} {:>8}  {:>8} {:>8} {:>8} {:>8}  {:>9} {:>9}  {:>8} {:>8} {:>8}",
            "method",
            "setting",
            "last",
            "largest",
            "dense",
            "energy",
            "min us",
            "median us",
            "evals",
            "accepted",
            "rejected"
        )?;
        for MethodRuns { name, runs } in &self.methods {
            for Run { setting, outcome } in runs {
                write!(f, "\n{name:<width$} {setting:>8.1e}  ")?;
                match outcome {
                    Ok(measured) => measured.fmt(f)?,
                    Err(failure) => failure.fmt(f)?,
                }
            }
        }
        Ok(())
    }
}

/// One row of the table.
impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Errors {
            last,
            largest,
            dense,
            energy,
        } = self.errors;
        write!(f, "{last:>8.1e}")?;
        for error in [largest, dense, energy] {
            match error {
                Some(error) => write!(f, " {error:>8.1e}")?,
                None => write!(f, " {:>8}", "-")?,
            }
        }
        write!(f, "  {:>9.2} {:>9.2}", 1e6 * self.minimum, 1e6 * self.median)?;
        match self.work {
            Some(work) => write!(f, "  {:>8} {:>8} {:>8}", work.evaluations, work.accepted, work.rejected),
            None => Ok(()),
        }
    }
}
