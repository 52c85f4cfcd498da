//! Butcher tableaus as data, each citing its paper.
//!
//! A new explicit Runge-Kutta method is a tableau here and a name in [`method`](crate::method).
//!
//! | tableau | order | embedded | dense output | evaluations a step | more for dense output |
//! |---|---|---|---|---|---|
//! | [`Kutta4`] | 4 | | 3 | 4 | |
//! | [`DormandPrince5`] | 5 | 4 | 4 | 6 | |
//! | [`Tsitouras5`] | 5 | 4 | 4 | 6 | |
//! | [`Verner7`] | 7 | 6 | 7 | 10 | 5 |
//! | [`Verner9`] | 9 | 8 | 9 | 16 | 9 |
//!
//! Rosenbrock methods, for stiff systems, have tableaus of their own: [`HairerWanner4`] of order 4(3) in 6 stages, with
//! dense output of order 3, and [`Steinebach5`] of order 5(4) in 8, with dense output of order 4.

mod dormand_prince5;
mod eigenpairs;
mod gauss_legendre;
mod hairer_wanner4;
mod hermite;
mod kutta4;
pub(crate) mod radau_iia5;
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

pub(crate) use eigenpairs::{Eigenpair, Eigenpairs};
pub(crate) use gauss_legendre::{GaussLegendre, GaussTableau, HasTableau};

/// The coefficients of an explicit Runge-Kutta method with `S` stages.
///
/// A step of length `h` from `(t, x)` evaluates `k_i = f(t + c_i h, x + h sum_j a_ij k_j)` for `i = 0..S` and arrives
/// at `x + h sum_i b_i k_i`.
///
/// The last stage must be the derivative at the end of the step: `a[S - 1] == b`, `c[S - 1] == 1`, `b[S - 1] == 0`. It
/// is the first stage of the next step ("first same as last"), so it costs nothing, and dense output uses it. A method
/// without that property is written with one more row, of weight 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ButcherTableau<const S: usize> {
    /// The stage coefficients: strictly lower triangular.
    pub a: [[f64; S]; S],
    /// The weights of the step.
    pub b: [f64; S],
    /// The times of the stages in fractions of a step, the row sums of `a`.
    pub c: [f64; S],
    /// The weights of the embedded method, whose difference from `b` estimates the error of a step.
    pub b_hat: Option<[f64; S]>,
    /// The order of the method: its error in time falls as `h^order`.
    pub order: usize,
    /// The order of the embedded method; 0 where there is none.
    pub order_hat: usize,
    /// Further stages for dense output alone: stage `S + i` is evaluated from the `S + i` before it.
    pub extra: &'static [ExtraStage],
    /// The weights of the dense output as polynomials: at the fraction `theta` of a step, the state is
    /// `x + h sum_i b_i(theta) k_i` with `b_i(theta) = sum_j dense[j][i] theta^(j + 1)`. The rows are as long as there
    /// are stages, the extra ones included.
    pub dense: &'static [&'static [f64]],
    /// The order of the dense output: within one step its error falls as `h^(dense_order + 1)`.
    pub dense_order: usize,
}

/// A stage that the step itself does not need: `k = f(t + c h, x + h sum_j a_j k_j)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtraStage {
    /// The coefficients of all stages before this one.
    pub a: &'static [f64],
    /// The time of the stage in fractions of a step, the sum of `a`.
    pub c: f64,
}

impl<const S: usize> ButcherTableau<S> {
    /// `b - b_hat`, the weights of the error estimate; zeros where there is no embedded method.
    #[must_use]
    pub const fn error_weights(&self) -> [f64; S] {
        let Some(b_hat) = self.b_hat else {
            return [0.0; S];
        };
        difference(self.b, b_hat)
    }

    /// Whether the error estimate uses the last stage, the derivative at the end of the step.
    #[must_use]
    pub const fn error_uses_last_stage(&self) -> bool {
        self.error_weights()[S - 1] != 0.0
    }

    /// Whether the last stage is the derivative at the end of the step, as the type requires.
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

/// `a - b`.
pub(crate) const fn difference<const S: usize>(mut a: [f64; S], b: [f64; S]) -> [f64; S] {
    let mut i = 0;
    while i < S {
        a[i] -= b[i];
        i += 1;
    }
    a
}

/// A type that stands for a tableau, so that the stepping code is compiled for each one with its coefficients as
/// constants.
pub trait Tableau<const S: usize>: Clone {
    /// The coefficients.
    const TABLEAU: ButcherTableau<S>;
}

/// The matrix of these rows, which end where zeros follow.
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
