//! The matrix exponential.

use nalgebra::DMatrix;
use nalgebra::linalg::balancing::balance_parlett_reinsch;

/// Numerator coefficients of the Pade approximant of order 13.
const PADE: [f64; 14] = [
    64_764_752_532_480_000.0,
    32_382_376_266_240_000.0,
    7_771_770_303_897_600.0,
    1_187_353_796_428_800.0,
    129_060_195_264_000.0,
    10_559_470_521_600.0,
    670_442_572_800.0,
    33_522_128_640.0,
    1_323_241_920.0,
    40_840_800.0,
    960_960.0,
    16_380.0,
    182.0,
    1.0,
];
/// 1-norm up to which the approximant is exact to rounding errors.
const REACH: f64 = 5.371_920_351_148_152;
/// Halvings after which an exponential overflows or vanishes in any case.
const HALVINGS: f64 = 64.0;

/// Exponential of a square matrix, not finite if it overflows: scaling and squaring of a balanced matrix.
///
/// N. J. Higham, SIAM J. Matrix Anal. Appl. 26 (2005) 1179. `None` if a linear system is singular, or squares of
/// the entries overflow.
pub(super) fn exponential(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = matrix.nrows();
    // The balance of a matrix with an infinite norm does not end.
    if !matrix.norm_squared().is_finite() {
        return None;
    }
    let mut balanced = matrix.clone();
    let scales = balance_parlett_reinsch(&mut balanced);
    let norm = balanced
        .column_iter()
        .map(|column| column.lp_norm(1))
        .fold(0.0, f64::max);
    let halvings = libm::ceil(libm::log2(norm / REACH)).clamp(0.0, HALVINGS);
    let a = balanced * libm::exp2(-halvings);
    let one = DMatrix::<f64>::identity(n, n);
    let a2 = &a * &a;
    let a4 = &a2 * &a2;
    let a6 = &a4 * &a2;
    let part = |[c0, c2, c4, c6]: [f64; 4]| &one * c0 + &a2 * c2 + &a4 * c4 + &a6 * c6;
    let high = |[c2, c4, c6]: [f64; 3]| &a6 * (&a2 * c2 + &a4 * c4 + &a6 * c6);
    let odd = part([PADE[1], PADE[3], PADE[5], PADE[7]]) + high([PADE[9], PADE[11], PADE[13]]);
    let even = part([PADE[0], PADE[2], PADE[4], PADE[6]]) + high([PADE[8], PADE[10], PADE[12]]);
    let odd = a * odd;
    let mut result = (&even - &odd).lu().solve(&(even + odd))?;
    for _ in 0..halvings as usize {
        result = &result * &result;
    }
    Some(DMatrix::from_fn(n, n, |i, j| result[(i, j)] * scales[i] / scales[j]))
}

/// Solution of `x' = A x + B u` after the time `h` with constant `u`: the matrices of `x(h) = F x(0) + G u`.
///
/// They are blocks of the exponential of `[A, B; 0, 0] h` (C. F. Van Loan, IEEE Trans. Autom. Control 23 (1978) 395).
/// The columns of `B` are scaled to the norm of `A`, since more halvings than `A` needs would cost digits of `F`.
pub(super) fn held(a: &DMatrix<f64>, b: &DMatrix<f64>, h: f64) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
    let (n, m) = b.shape();
    let size = if a.norm() > 0.0 { a.norm() } else { 1.0 / h };
    let scales: Vec<f64> = b
        .column_iter()
        .map(|column| column.norm() / size)
        .map(|scale| if scale > 0.0 { scale } else { 1.0 })
        .collect();
    let mut rates = DMatrix::zeros(n + m, n + m);
    rates.view_mut((0, 0), (n, n)).copy_from(a);
    for (j, scale) in scales.iter().enumerate() {
        rates.view_mut((0, n + j), (n, 1)).copy_from(&(b.column(j) / *scale));
    }
    let change = exponential(&(rates * h))?;
    let by_inputs = DMatrix::from_fn(n, m, |i, j| change[(i, n + j)] * scales[j]);
    Some((change.view((0, 0), (n, n)).into_owned(), by_inputs))
}
