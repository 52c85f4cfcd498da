//! Curves.

use crate::line::Line;

/// Points joined by a line, which is interrupted outside of the axes.
#[derive(Clone)]
pub struct Curve {
    pub line: Line,
    pub points: Vec<(f64, f64)>,
    /// Text beside the last point.
    pub label: Option<String>,
}
