//! Operation counts of code common to methods, each named after that code.
//!
//! `n` is the number of state components. Comparisons and moves are not counted; computations in `f64` are, whatever
//! the type of the state.

use crate::cost::Operations;

/// One addition for each component.
pub(super) const fn added(n: usize) -> Operations {
    Operations::new(n, 0, 0, 0, 0, 1)
}

/// One multiplication for each component.
pub(super) const fn multiplied(n: usize) -> Operations {
    Operations::new(0, n, 0, 0, 0, 1)
}

/// The time of a stage, `t + c h`.
pub(super) const TIME: Operations = Operations::new(1, 1, 0, 0, 0, 0);

/// `Grid::next`, and the lengths of the attempted and of the accepted step.
pub(super) const ON_GRID: Operations = Operations::new(4, 5, 0, 0, 2, 10);

/// `StepControl` with `PiController`, and the lengths of the attempted and of the accepted step.
pub(super) const CONTROLLED: Operations = Operations::new(22, 24, 1, 0, 4, 62);

/// `Tolerance::mean_square`.
pub(super) const fn mean_square(n: usize) -> Operations {
    Operations::new(3 * n, 2 * n + 2, n, 0, 2 * n, n + 18)
}

/// `weighted_sum` of the vectors with these weights.
pub(super) const fn weighted_sum(weights: &[f64], n: usize) -> Operations {
    let (mut i, mut terms) = (0, 0);
    while i < weights.len() {
        terms += (weights[i] != 0.0) as usize;
        i += 1;
    }
    Operations::new(terms.saturating_sub(1) * n, terms * (n + 1), 0, 0, 0, terms + 2)
}

/// `shifted` by the `weighted_sum` with these weights.
pub(super) const fn shifted(weights: &[f64], n: usize) -> Operations {
    weighted_sum(weights, n).and(added(n))
}

/// `linear::square`.
pub(super) const fn square(n: usize) -> Operations {
    Operations::new(n, n, 0, 0, 0, n + 1)
}
