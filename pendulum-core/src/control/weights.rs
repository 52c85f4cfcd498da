//! Checks of weights and covariances.

use nalgebra::{DMatrix, SMatrix};

use super::ControlError;

/// Difference of mirrored entries, relative to the largest, that is put down to rounding errors.
const ASYMMETRY: f64 = 1e-10;
/// Eigenvalue of a matrix with a unit diagonal, per row, that is put down to rounding errors.
const INDEFINITE: f64 = 1e-12;

/// The symmetric part of a matrix that has to be symmetric and positive semidefinite, or definite.
///
/// The matrix is judged after scaling to a unit diagonal, so that the units of its components do not matter.
pub(super) fn weights<const N: usize, const K: usize>(
    what: &'static str,
    matrix: &SMatrix<f64, K, K>,
    strictly: bool,
) -> Result<DMatrix<f64>, ControlError<N>> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return Err(ControlError::NotFinite { what });
    }
    let matrix = DMatrix::from_column_slice(K, K, matrix.as_slice());
    let largest = matrix.amax();
    for (i, j) in (0..K).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let values = [matrix[(i, j)], matrix[(j, i)]];
        if (values[0] - values[1]).abs() > ASYMMETRY * largest {
            let entry = [i, j];
            return Err(ControlError::NotSymmetric { what, entry, values });
        }
    }
    let symmetric = (&matrix + matrix.transpose()) * 0.5;
    let scales = symmetric.diagonal().map(|entry| {
        let size = entry.abs().sqrt();
        if size > 0.0 { size } else { largest.max(1.0).sqrt() }
    });
    let scaled = DMatrix::from_fn(K, K, |i, j| symmetric[(i, j)] / (scales[i] * scales[j]));
    let eigenvalue = scaled
        .symmetric_eigenvalues()
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let rounding = INDEFINITE * K as f64;
    if eigenvalue < -rounding || strictly && eigenvalue <= rounding {
        return Err(ControlError::NotPositive {
            what,
            strictly,
            eigenvalue,
        });
    }
    Ok(symmetric)
}
