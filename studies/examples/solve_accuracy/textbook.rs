//! Textbook solutions for the double pendulum of point masses.

use nalgebra::{Matrix2, Vector2};
use pendulum_core::ParameterError;
use pendulum_core::prelude::*;

use testbed::lopsided::{Points, PointsParams};
use testbed::ratios::Sample;

/// Mass matrix and right-hand side of `A qdd = r`.
fn system(sample: &Sample) -> Result<(Matrix2<f64>, Vector2<f64>), ParameterError> {
    let [m1, m2, l1, l2, g] = ["m1", "m2", "l1", "l2", "g"].map(|name| sample.parameters.get(name));
    let model = Points::new(PointsParams { m1, m2, l1, l2, g })?;
    let x = SVector::<f64, 4>::from_column_slice(&sample.state);
    Ok((model.mass_matrix(0.0, &x), -model.bias(0.0, &x)))
}

/// Solves by nalgebra's Cholesky factorisation; infinite if rounding has made the mass matrix indefinite.
pub(crate) fn cholesky(sample: &Sample) -> Result<Vec<f64>, ParameterError> {
    let (matrix, right) = system(sample)?;
    let solved = matrix.cholesky().map(|factor| factor.solve(&right));
    Ok(solved.map_or(vec![f64::INFINITY; 2], |x| x.as_slice().to_vec()))
}

/// Solves by Cramer's rule, with each determinant as a difference of two products.
pub(crate) fn cramer(sample: &Sample) -> Result<Vec<f64>, ParameterError> {
    let (a, r) = system(sample)?;
    let determinant = a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(1, 0)];
    Ok(vec![
        (a[(1, 1)] * r[0] - a[(0, 1)] * r[1]) / determinant,
        (a[(0, 0)] * r[1] - a[(1, 0)] * r[0]) / determinant,
    ])
}
