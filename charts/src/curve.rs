//! Curves.

use crate::line::Line;

/// Some points; outside of the axes the curve is interrupted.
#[derive(Clone)]
pub struct Curve {
    pub line: Line,
    pub points: Vec<(f64, f64)>,
    /// What stands beside the last point; the points of such a curve have dots.
    pub label: Option<String>,
}
