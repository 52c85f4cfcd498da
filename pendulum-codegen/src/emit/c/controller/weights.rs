//! Checks of weights, those of `Quadratic` in the core.

use super::NoController;

/// Difference of mirrored entries of a matrix with a unit diagonal that is put down to rounding, in ulps.
const ASYMMETRY_ULPS: f64 = 1e4;
/// Eigenvalue of a matrix with a unit diagonal, per row, that is put down to rounding, in ulps.
const INDEFINITE_ULPS: f64 = 64.0;

/// Checks that a matrix of finite numbers is symmetric and positive semidefinite, or definite, in its precision.
///
/// The matrix is judged after scaling to a unit diagonal, so that the units of its components do not matter.
pub(super) fn check(
    what: &'static str,
    matrix: &[f64],
    rows: usize,
    strictly: bool,
    is_single: bool,
) -> Result<(), NoController> {
    let (real, epsilon): (fn(f64) -> f64, f64) = match is_single {
        true => (|number| f64::from(number as f32), f64::from(f32::EPSILON)),
        false => (|number| number, f64::EPSILON),
    };
    let entry = |i: usize, j: usize| real(matrix[i + rows * j]);
    let not_positive = Err(NoController::NotPositive { what, strictly });
    if (0..rows).any(|i| entry(i, i) < 0.0 || strictly && entry(i, i) == 0.0) {
        return not_positive;
    }
    let scale = |i| if entry(i, i) > 0.0 { entry(i, i).sqrt() } else { 1.0 };
    let unit = |i: usize, j: usize| entry(i, j) / scale(i) / scale(j);
    for (i, j) in (0..rows).flat_map(|i| (0..i).map(move |j| (i, j))) {
        if (unit(i, j) - unit(j, i)).abs() > ASYMMETRY_ULPS * epsilon {
            let (entry, values) = ([i, j], [matrix[i + rows * j], matrix[j + rows * i]]);
            return Err(NoController::NotSymmetric { what, entry, values });
        }
    }
    let rounding = INDEFINITE_ULPS * rows as f64 * epsilon;
    let shift = if strictly { -rounding } else { rounding };
    match is_definite(rows, |i, j| unit(i, j) + if i == j { shift } else { 0.0 }) {
        true => Ok(()),
        false => not_positive,
    }
}

/// True if the matrix of a lower triangle is positive definite: if it has a Cholesky factor.
fn is_definite(rows: usize, matrix: impl Fn(usize, usize) -> f64) -> bool {
    let mut factor = vec![vec![0.0; rows]; rows];
    for i in 0..rows {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = matrix(i, j) - known;
            // false for NaN as well
            let may_divide = i != j || (rest > 0.0 && rest.is_finite());
            if !may_divide {
                return false;
            }
            factor[i][j] = if i == j { rest.sqrt() } else { rest / factor[j][j] };
        }
    }
    true
}
