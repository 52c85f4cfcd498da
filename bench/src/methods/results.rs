//! Results as written to `methods.json`.

use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Results {
    pub header: Vec<String>,
    pub notes: Vec<String>,
    pub scenes: Vec<SceneResults>,
}

#[derive(Serialize)]
pub(crate) struct SceneResults {
    pub name: &'static str,
    pub title: &'static str,
    pub alone: Vec<Curve>,
    /// Results in lanes; times are per trajectory.
    pub together: Vec<Curve>,
}

/// Results of a method over its tolerances.
#[derive(Serialize)]
pub(crate) struct Curve {
    pub by: &'static str,
    pub method: &'static str,
    pub points: Vec<Point>,
    /// Tolerances at which the method failed, with the reason.
    pub failures: Vec<(f64, String)>,
}

/// Results at one tolerance.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Point {
    pub tolerance: f64,
    /// Largest component of the error of the final state.
    pub error: f64,
    /// Evaluations of the right-hand side, if the library reports them.
    pub evaluations: Option<usize>,
    /// Minimum time per trajectory, in nanoseconds.
    pub least: f64,
    /// Median time per trajectory, in nanoseconds.
    pub median: f64,
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
    pub(crate) fn reaching(&self, error: f64) -> Option<&Point> {
        let good = self.points.iter().filter(|point| point.error <= error);
        good.min_by(|a, b| a.least.total_cmp(&b.least))
    }
}

impl Point {
    /// A point whose times are not measured yet.
    pub(crate) fn new(tolerance: f64, error: f64, evaluations: Option<usize>) -> Self {
        Self {
            tolerance,
            error,
            evaluations,
            least: f64::NAN,
            median: f64::NAN,
        }
    }
}
