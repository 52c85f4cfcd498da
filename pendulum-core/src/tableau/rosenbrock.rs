//! Coefficients of Rosenbrock methods.

/// Coefficients of a Rosenbrock method with `S` stages, for systems `x' = f(t, x)` with the Jacobian `J` of `f`.
///
/// In its first form the method solves, for `i = 0..S`,
/// `k_i = h f(t + alpha_i h, x + sum_j alpha_ij k_j) + h J sum_j gamma_ij k_j + h^2 gamma_i f_t`.
/// Here `gamma_ii = gamma`, `alpha_i = sum_j alpha_ij`, `gamma_i = sum_j gamma_ij`, and `J` and the time derivative
/// `f_t` are evaluated at `(t, x)`.
///
/// The coefficients here are those of the second form, in `u = Gamma k`, which avoids products with `J`:
/// `(I / (h gamma) - J) u_i = f(t + alpha_i h, x + sum_j a_ij u_j) + sum_j (c_ij / h) u_j + h gamma_i f_t`,
/// where `a = (alpha_ij) Gamma^-1` and `c = I / gamma - Gamma^-1`. A step ends at `x + sum_i b_i u_i`.
///
/// E. Hairer, G. Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.7.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RosenbrockTableau<const S: usize> {
    /// Diagonal of `Gamma`; equal entries, so that all stages share one matrix.
    pub gamma: f64,
    /// Stage coefficients: strictly lower triangular.
    pub a: [[f64; S]; S],
    /// Coefficients of the coupling terms with the factor `1 / h`: strictly lower triangular.
    pub c: [[f64; S]; S],
    /// Times of the stages, in fractions of a step.
    pub alpha: [f64; S],
    /// Factors `gamma_i` of the derivative with respect to time.
    pub gamma_sums: [f64; S],
    /// Weights of the step.
    pub b: [f64; S],
    /// Weights of the embedded method.
    pub b_hat: [f64; S],
    /// Order of the method.
    pub order: usize,
    /// Order of the embedded method.
    pub order_hat: usize,
    /// Weights of the dense output as polynomials. At the fraction `theta` of a step, the state is
    /// `x + sum_i b_i(theta) u_i` with `b_i(theta) = sum_j dense[j][i] theta^(j + 1)`.
    pub dense: &'static [&'static [f64]],
    /// Order of the dense output: its error within a step decreases as `h^(dense_order + 1)`.
    pub dense_order: usize,
}

/// A type that represents a tableau, so that the stepping code is compiled separately for each tableau with constant
/// coefficients.
pub trait RosenbrockMethod<const S: usize>: Clone {
    /// Coefficients.
    const TABLEAU: RosenbrockTableau<S>;
}

/// Coefficients, in ascending powers from 1, of `theta b + theta (1 - theta) (h_0 + theta h_1 + ..)`, the form in which
/// dense output is published.
pub(super) const fn continuous<const S: usize, const H: usize, const D: usize>(
    b: [f64; S],
    h: [[f64; S]; H],
) -> [[f64; S]; D] {
    assert!(D == H + 1);
    let mut rows = [[0.0; S]; D];
    rows[0] = b;
    let mut j = 0;
    while j < H {
        let mut i = 0;
        while i < S {
            rows[j][i] += h[j][i];
            rows[j + 1][i] -= h[j][i];
            i += 1;
        }
        j += 1;
    }
    rows
}
