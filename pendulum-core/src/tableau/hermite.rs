//! Interpolation from the values and slopes at both ends of a step.

/// Coefficients, in ascending powers from 1, of the cubic Hermite interpolant of a step with the weights `b`, plus the
/// term `theta^2 (1 - theta)^2 h sum_i d_i k_i`, which preserves values and slopes at both ends.
pub(super) const fn hermite<const S: usize>(b: [f64; S], d: [f64; S]) -> [[f64; S]; 4] {
    let mut rows = [[0.0; S]; 4];
    let mut i = 0;
    while i < S {
        let first = if i == 0 { 1.0 } else { 0.0 };
        let last = if i == S - 1 { 1.0 } else { 0.0 };
        rows[0][i] = first;
        rows[1][i] = 3.0 * b[i] - 2.0 * first - last + d[i];
        rows[2][i] = first + last - 2.0 * b[i] - 2.0 * d[i];
        rows[3][i] = d[i];
        i += 1;
    }
    rows
}
