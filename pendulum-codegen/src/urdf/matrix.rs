//! Numeric 3x3 matrices.

pub(super) type Vector = [f64; 3];
/// Rows of a 3x3 matrix.
pub(super) type Matrix = [Vector; 3];

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn sum(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| add(a[i], b[i]))
}

pub(super) fn scaled(a: &Matrix, factor: f64) -> Matrix {
    a.map(|row| row.map(|x| factor * x))
}

pub(super) fn times(a: &Matrix, x: Vector) -> Vector {
    a.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
}

pub(super) fn transpose(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| a.map(|row| row[i]))
}

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transpose(b).map(|column| times(a, column));
    transpose(&columns)
}

pub(super) fn outer(a: Vector, b: Vector) -> Matrix {
    a.map(|x| b.map(|y| x * y))
}

pub(super) fn trace(a: &Matrix) -> f64 {
    a[0][0] + a[1][1] + a[2][2]
}

/// Returns the rotation by roll, pitch and yaw: about the fixed x, then y, then z axis.
pub(super) fn rotation([roll, pitch, yaw]: Vector) -> Matrix {
    let [(sr, cr), (sp, cp), (sy, cy)] = [roll, pitch, yaw].map(f64::sin_cos);
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

/// Returns the eigenvalues and eigenvectors of a symmetric matrix, by Jacobi rotations.
pub(super) fn eigen(matrix: &Matrix) -> (Vector, [Vector; 3]) {
    /// Number of sweeps, far more than needed: each sweep doubles the correct digits.
    const SWEEPS: usize = 30;
    let (mut a, mut axes) = (*matrix, rotation([0.0; 3]));
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let angle = 0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p]);
            let (s, c) = angle.sin_cos();
            let mut turn = rotation([0.0; 3]);
            (turn[p][p], turn[q][q], turn[p][q], turn[q][p]) = (c, c, s, -s);
            a = product(&transpose(&turn), &product(&a, &turn));
            axes = product(&axes, &turn);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], transpose(&axes))
}

#[cfg(test)]
mod tests {
    use super::{eigen, outer, product, rotation, scaled, sum, transpose};

    #[test]
    fn eigenvalues_and_axes_make_the_matrix_again() {
        let turn = rotation([0.3, -1.1, 2.0]);
        for values in [[3.0, -1.0, 0.5], [2.0, 2.0, 1.0], [1.0, 1e-9, 0.0]] {
            let diagonal = [[values[0], 0.0, 0.0], [0.0, values[1], 0.0], [0.0, 0.0, values[2]]];
            let matrix = product(&turn, &product(&diagonal, &transpose(&turn)));
            let (mut found, axes) = eigen(&matrix);
            let again = (0..3).map(|n| scaled(&outer(axes[n], axes[n]), found[n]));
            let again = again.fold([[0.0; 3]; 3], |before, one| sum(&before, &one));
            for (row, of_matrix) in again.iter().zip(&matrix) {
                assert!(
                    row.iter().zip(of_matrix).all(|(a, b)| (a - b).abs() < 1e-14),
                    "{again:?}"
                );
            }
            found.sort_by(|a, b| b.total_cmp(a));
            let mut expected = values;
            expected.sort_by(|a, b| b.total_cmp(a));
            assert!(
                found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14),
                "{found:?}"
            );
        }
    }
}
