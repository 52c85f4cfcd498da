//! Results of a method over its tolerances.

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
    pub(crate) fn reaching(&self, measure: Measure, error: f64) -> Option<&Point> {
        let good = self.points.iter().filter(|point| point.error(measure) <= error);
        good.min_by(|a, b| a.least.total_cmp(&b.least))
    }
}

impl Point {
    /// A point whose times are not measured yet.
    pub(crate) fn new(tolerance: f64, errors: [f64; MEASURES.len()], evaluations: Option<usize>) -> Self {
        Self {
            tolerance,
            errors,
            evaluations,
            least: f64::NAN,
            median: f64::NAN,
        }
    }

    pub(crate) fn error(&self, measure: Measure) -> f64 {
        self.errors[measure as usize]
    }
}
