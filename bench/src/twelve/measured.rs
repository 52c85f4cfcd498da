//! Results on a problem.

use twelve::Problem;

use super::cells::Cell;
use super::results::Curve;
use super::sweep::Setting;

/// Results of all methods on a problem.
pub(crate) struct Measured {
    pub problem: Problem,
    pub curves: Vec<Curve>,
    pub settings: Vec<Setting>,
    pub cells: Vec<Cell>,
    /// Cells of the errors over time.
    pub cells_along: Vec<Cell>,
}
