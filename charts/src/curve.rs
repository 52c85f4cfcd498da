//! Curves.

use crate::line::Line;

/// Points joined by a line, which is interrupted outside of the axes.
#[derive(Clone)]
pub struct Curve {
    pub line: Line,
    pub points: Vec<(f64, f64)>,
    /// Text beside the last point.
    pub label: Option<String>,
    /// Name in a report; without one it is the label, or the text of the line in the legend.
    pub name: Option<String>,
    /// Text of each point in a report, such as the setting of a method; may be empty.
    pub notes: Vec<String>,
}
