//! Checks of weights and covariances.

use nalgebra::{DMatrix, SMatrix};

use super::ControlError;

/// Difference of mirrored entries of a matrix with a unit diagonal that is put down to rounding errors.
const ASYMMETRY: f64 = 1e-10;
/// Eigenvalue of a matrix with a unit diagonal, per row, that is put down to rounding errors.
const INDEFINITE: f64 = 1e-12;
/// Entry of a matrix with a unit diagonal above which its eigenvalues are not computed, since squares may overflow.
const LARGE: f64 = 1e100;

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
    if K == 0 {
        return Ok(matrix);
    }
    let largest = matrix.amax();
    let scales = matrix.diagonal().map(|entry| match (entry.abs(), largest) {
        (0.0, 0.0) => 1.0,
        (0.0, largest) => largest.sqrt(),
        (size, _) => size.sqrt(),
    });
    // Divided one by one, since the product of two scales may vanish.
    let scaled = DMatrix::from_fn(K, K, |i, j| matrix[(i, j)] / scales[i] / scales[j]);
    for (i, j) in (0..K).flat_map(|i| (0..i).map(move |j| (i, j))) {
        if (scaled[(i, j)] - scaled[(j, i)]).abs() > ASYMMETRY {
            let (entry, values) = ([i, j], [matrix[(i, j)], matrix[(j, i)]]);
            return Err(ControlError::NotSymmetric { what, entry, values });
        }
    }
    let symmetric_part = |matrix: &DMatrix<f64>| (matrix + matrix.transpose()) * 0.5;
    let crossed = scaled.amax();
    let eigenvalue = if crossed < LARGE {
        symmetric_part(&scaled).symmetric_eigenvalues().min()
    } else {
        // that of the two rows of the entry
        1.0 - crossed
    };
    let rounding = INDEFINITE * K as f64;
    if eigenvalue < -rounding || strictly && eigenvalue <= rounding {
        return Err(ControlError::NotPositive {
            what,
            strictly,
            eigenvalue,
        });
    }
    Ok(symmetric_part(&matrix))
}
