//! Butcher tableaus as data, each with its source.
//!
//! A new explicit Runge-Kutta method requires a tableau in this module and a name in [`method`](crate::method).
//!
//! | tableau | order | embedded | dense output | evaluations per step | additional for dense output |
//! |---|---|---|---|---|---|
//! | [`Kutta4`] | 4 | | 3 | 4 | |
//! | [`DormandPrince5`] | 5 | 4 | 4 | 6 | |
//! | [`Tsitouras5`] | 5 | 4 | 4 | 6 | |
//! | [`Verner7`] | 7 | 6 | 7 | 10 | 5 |
//! | [`Verner9`] | 9 | 8 | 9 | 16 | 9 |
//!
//! Rosenbrock methods, for stiff systems, have separate tableaus: [`HairerWanner4`] of order 4(3) in 6 stages with
//! dense output of order 3, and [`Steinebach5`] of order 5(4) in 8 stages with dense output of order 4.

mod dormand_prince5;
mod eigenpairs;
mod gauss_legendre;
mod hairer_wanner4;
mod hermite;
mod kutta4;
mod radau_iia;
mod rosenbrock;
mod steinebach5;
mod tsitouras5;
mod verner7;
mod verner9;

pub use dormand_prince5::DormandPrince5;
pub use hairer_wanner4::HairerWanner4;
pub use kutta4::Kutta4;
pub use rosenbrock::{RosenbrockMethod, RosenbrockTableau};
pub use steinebach5::Steinebach5;
pub use tsitouras5::Tsitouras5;
pub use verner7::Verner7;
pub use verner9::Verner9;

pub(crate) use eigenpairs::Eigenpairs;
pub(crate) use gauss_legendre::{GaussLegendre, GaussTableau, HasGaussTableau, MOST_POINTS};
pub(crate) use radau_iia::{HasRadauTableau, RADAU_IIA_5, RADAU_IIA_9, RADAU_IIA_13, RadauTableau};

/// Coefficients of an explicit Runge-Kutta method with `S` stages.
///
/// A step of size `h` from `(t, x)` evaluates `k_i = f(t + c_i h, x + h sum_j a_ij k_j)` for `i = 0..S` and ends at
/// `x + h sum_i b_i k_i`.
///
/// The last stage must be the derivative at the end of the step: `a[S - 1] == b`, `c[S - 1] == 1`, `b[S - 1] == 0`. It
/// is reused as the first stage of the next step ("first same as last") and by dense output. A method without this
/// property gets one more row, of weight 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ButcherTableau<const S: usize> {
    /// Stage coefficients: strictly lower triangular.
    pub a: [[f64; S]; S],
    /// Weights of the step.
    pub b: [f64; S],
    /// Times of the stages, in fractions of a step: the row sums of `a`.
    pub c: [f64; S],
    /// Weights of the embedded method. The difference from `b` gives the error estimate of a step.
    pub b_hat: Option<[f64; S]>,
    /// Order of the method: its global error decreases as `h^order`.
    pub order: usize,
    /// Order of the embedded method; 0 without one.
    pub order_hat: usize,
    /// Additional stages for dense output: stage `S + i` depends on the `S + i` stages before it.
    pub extra: &'static [ExtraStage],
    /// Weights of the dense output as polynomials. At the fraction `theta` of a step, the state is
    /// `x + h sum_i b_i(theta) k_i` with `b_i(theta) = sum_j dense[j][i] theta^(j + 1)`. Each row has one entry per
    /// stage, including the extra stages.
    pub dense: &'static [&'static [f64]],
    /// Order of the dense output: its error within a step decreases as `h^(dense_order + 1)`.
    pub dense_order: usize,
}

/// A stage used only for dense output: `k = f(t + c h, x + h sum_j a_j k_j)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtraStage {
    /// Coefficients of all preceding stages.
    pub a: &'static [f64],
    /// Time of the stage, in fractions of a step: the sum of `a`.
    pub c: f64,
}

impl<const S: usize> ButcherTableau<S> {
    /// Weights of the error estimate, `b - b_hat`; zero without an embedded method.
    #[must_use]
    pub const fn error_weights(&self) -> [f64; S] {
        let Some(b_hat) = self.b_hat else {
            return [0.0; S];
        };
        difference(self.b, b_hat)
    }

    /// True if the error estimate uses the last stage, the derivative at the end of the step.
    #[must_use]
    pub const fn error_uses_last_stage(&self) -> bool {
        self.error_weights()[S - 1] != 0.0
    }

    /// Checks that the last stage is the derivative at the end of the step, as required.
    #[must_use]
    pub const fn ends_in_the_next_first_stage(&self) -> bool {
        let mut i = 0;
        while i < S {
            if self.a[S - 1][i] != self.b[i] {
                return false;
            }
            i += 1;
        }
        self.c[S - 1] == 1.0 && self.b[S - 1] == 0.0
    }
}

/// Componentwise `a - b`.
pub(crate) const fn difference<const S: usize>(mut a: [f64; S], b: [f64; S]) -> [f64; S] {
    let mut i = 0;
    while i < S {
        a[i] -= b[i];
        i += 1;
    }
    a
}

/// A type that represents a tableau, so that the stepping code is compiled separately for each tableau with constant
/// coefficients.
pub trait Tableau<const S: usize>: Clone {
    /// Coefficients.
    const TABLEAU: ButcherTableau<S>;
}

/// Builds a square matrix from rows without their trailing zeros.
const fn rows<const S: usize>(rows: [&[f64]; S]) -> [[f64; S]; S] {
    let mut matrix = [[0.0; S]; S];
    let mut i = 0;
    while i < S {
        let mut j = 0;
        while j < rows[i].len() {
            matrix[i][j] = rows[i][j];
            j += 1;
        }
        i += 1;
    }
    matrix
}
