//! Results of a method over its tolerances.

use twelve::End;

pub(crate) struct Curve {
    pub by: &'static str,
    pub method: &'static str,
    pub points: Vec<Point>,
    /// Tolerances without a result, with the reason.
    pub failures: Vec<(f64, String)>,
}

/// Results at one tolerance.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    pub tolerance: f64,
    /// Errors by each [`Measure`]; infinite where the method has no dense output.
    pub errors: [f64; MEASURES.len()],
    /// Evaluations of the right-hand side, if the library reports them.
    pub evaluations: Option<usize>,
    /// Additions and multiplications of the model, if the library counts its calls.
    pub operations: Option<f64>,
    /// Minimum time per trajectory, in nanoseconds.
    pub least: f64,
    /// Median time per trajectory, in nanoseconds.
    pub median: f64,
}

/// Measure of an error, relative to the largest component.
#[derive(Clone, Copy)]
pub(crate) enum Measure {
    /// Largest component at the end.
    End,
    /// Largest component at the output times, by dense output.
    Along,
}

pub(crate) const MEASURES: [Measure; 2] = [Measure::End, Measure::Along];

/// Cost of a trajectory.
#[derive(Clone, Copy)]
pub(crate) enum Cost {
    Time,
    Operations,
}

impl Curve {
    pub(crate) fn new(by: &'static str, method: &'static str) -> Self {
        Self {
            by,
            method,
            points: Vec::new(),
            failures: Vec::new(),
        }
    }

    /// The cheapest setting with at most this error.
    pub(crate) fn reaching(&self, measure: Measure, cost: Cost, error: f64) -> Option<&Point> {
        let good = self.points.iter().filter(|point| point.error(measure) <= error);
        good.min_by(|a, b| a.cost(cost).total_cmp(&b.cost(cost)))
    }
}

impl Point {
    /// A point whose times are not measured yet.
    pub(crate) fn new(tolerance: f64, errors: [f64; MEASURES.len()], end: &End) -> Self {
        Self {
            tolerance,
            errors,
            evaluations: end.evaluations,
            operations: end.operations,
            least: f64::NAN,
            median: f64::NAN,
        }
    }

    /// Nanoseconds, or operations; infinite where they are not known.
    pub(crate) fn cost(&self, cost: Cost) -> f64 {
        match cost {
            Cost::Time => self.least,
            Cost::Operations => self.operations.unwrap_or(f64::INFINITY),
        }
    }

    pub(crate) fn error(&self, measure: Measure) -> f64 {
        self.errors[measure as usize]
    }
}
