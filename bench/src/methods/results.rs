//! What was measured, as it goes into `methods.json`.

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
    /// In lanes; times are per trajectory.
    pub together: Vec<Curve>,
}

/// A method over its tolerances.
#[derive(Serialize)]
pub(crate) struct Curve {
    pub by: &'static str,
    pub method: &'static str,
    pub points: Vec<Point>,
    /// Tolerances with which it did not come to the end, and why.
    pub failures: Vec<(f64, String)>,
}

/// A tolerance.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Point {
    pub tolerance: f64,
    /// Of the final state, the largest component.
    pub error: f64,
    /// Of the right-hand side, where the library tells.
    pub evaluations: Option<usize>,
    /// Nanoseconds for a trajectory.
    pub least: f64,
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

    /// The cheapest setting that is at least so accurate.
    pub(crate) fn reaching(&self, error: f64) -> Option<&Point> {
        let good = self.points.iter().filter(|point| point.error <= error);
        good.min_by(|a, b| a.least.total_cmp(&b.least))
    }
}

impl Point {
    /// A setting whose time is to be taken.
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
