//! What a sweep found.

use std::error::Error;
use std::fmt;

use crate::accuracy::Errors;
use crate::error::{Reason, debug_as_display};
use crate::statistics::Statistics;

/// The measurements of all methods.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Report {
    /// One for each method, in the order in which they were added.
    pub methods: Vec<MethodRuns>,
    /// The uncertainty of the reference at the end of the span.
    pub uncertainty: f64,
}

/// The measurements of one method.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct MethodRuns {
    /// Its name.
    pub name: String,
    /// One for each setting.
    pub runs: Vec<Run>,
}

/// What became of one setting.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Run {
    /// The tolerance or the step.
    pub setting: f64,
    /// The measurements, if the integration came to its end.
    pub outcome: Result<Measured, Failure>,
}

/// What an integration that came to its end achieved, and what it took.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Measured {
    /// How accurate it is.
    pub errors: Errors,
    /// The shortest time it took, in seconds for one trajectory.
    pub minimum: f64,
    /// The median of the times, in the same units.
    pub median: f64,
    /// Evaluations and steps, without those for dense output; `None` for ensembles and other solvers, which do not
    /// report them.
    pub work: Option<Statistics>,
}

debug_as_display! { [] Failure; }

/// Where and why an integration stopped early.
#[derive(Clone, Copy, PartialEq)]
pub struct Failure {
    /// The last good time.
    pub t: f64,
    /// Why.
    pub reason: Reason,
}

impl Report {
    /// For each method its name, and the fastest of the settings whose [last](Errors::last) error is no more than
    /// `error`; `None` where there is no such setting, or where the reference is less certain than that.
    pub fn time_to_reach(&self, error: f64) -> impl Iterator<Item = (&str, Option<(f64, &Measured)>)> {
        let known = self.uncertainty <= error;
        self.methods
            .iter()
            .map(move |method| (&*method.name, method.cheapest(error).filter(|_| known)))
    }
}

impl MethodRuns {
    /// The settings that came to their end, with what was measured.
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

/// A table of all, with times in microseconds.
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

/// A line of the table.
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
