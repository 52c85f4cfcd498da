//! Least-squares solution of linear equations that may be over- or underdetermined.

use nalgebra::{DMatrix, DVector};

use super::StabilityError;

/// Shortest `step` that minimises `|residual + matrix step|`. Singular values below `least` times the largest count as
/// zero.
///
/// G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th ed. (2013), 5.5.
pub(super) fn shortest_step(
    matrix: DMatrix<f64>,
    residual: &DVector<f64>,
    least: f64,
) -> Result<DVector<f64>, StabilityError> {
    if matrix.iter().chain(residual.iter()).any(|entry| !entry.is_finite()) {
        return Err(StabilityError::NotFinite);
    }
    let svd = matrix.svd(true, true);
    let least = least * svd.singular_values.max();
    svd.solve(&-residual, least).map_err(|_| StabilityError::NotFinite)
}
