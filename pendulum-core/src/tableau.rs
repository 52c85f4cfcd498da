//! Butcher tableaus as data, each citing its paper.
//!
//! To add an explicit Runge-Kutta method is to add a tableau here and to name it in [`method`](crate::method).

/// The coefficients of an explicit Runge-Kutta method with `S` stages.
///
/// A step of length `h` from `(t, x)` evaluates `k_i = f(t + c_i h, x + h sum_j a_ij k_j)` for `i = 0..S` and arrives at
/// `x + h sum_i b_i k_i`.
///
/// The last stage must be the derivative at the end of the step: `a[S - 1] == b`, `c[S - 1] == 1`, `b[S - 1] == 0`. It is the
/// first stage of the next step ("first same as last"), so it costs nothing, and dense output wants it. A method that is not
/// made that way is written with one more row, of weight 0.
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
    /// Further stages that dense output alone needs: stage `S + i` is evaluated from the `S + i` before it.
    pub extra: &'static [ExtraStage],
    /// The weights of the dense output as polynomials: at the fraction `theta` of a step,
    /// `b_i(theta) = sum_j dense[j][i] theta^(j + 1)`. Rows are as long as `S + extra.len()`.
    pub dense: &'static [&'static [f64]],
    /// The order of the dense output: within one step its error falls as `h^(dense_order + 1)`.
    pub dense_order: usize,
}

/// A stage that dense output alone needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtraStage {
    /// The coefficients of the stages before it.
    pub a: &'static [f64],
    /// Its time in fractions of a step.
    pub c: f64,
}

impl<const S: usize> ButcherTableau<S> {
    /// `b - b_hat`, the weights of the error estimate; zeros where there is no embedded method.
    #[must_use]
    pub const fn error_weights(&self) -> [f64; S] {
        let Some(b_hat) = self.b_hat else {
            return [0.0; S];
        };
        let mut weights = self.b;
        let mut i = 0;
        while i < S {
            weights[i] -= b_hat[i];
            i += 1;
        }
        weights
    }

    /// Whether the error estimate uses the last stage, the derivative at the end of the step.
    #[must_use]
    pub const fn error_wants_the_last_stage(&self) -> bool {
        self.error_weights()[S - 1] != 0.0
    }

    /// Whether the last stage is the derivative at the end of the step, as the documentation of the type demands.
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

/// A type that stands for a tableau, so that the stepping code is compiled for each one with its coefficients as constants.
pub trait Tableau<const S: usize> {
    /// The coefficients.
    const TABLEAU: ButcherTableau<S>;
}

/// The classical method of order 4, with cubic Hermite interpolation (order 3) between the steps.
///
/// W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", Z. Math. Phys. 46 (1901) 435-453.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kutta4;

impl Tableau<5> for Kutta4 {
    const TABLEAU: ButcherTableau<5> = {
        const B: [f64; 5] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0];
        const DENSE: [[f64; 5]; 4] = hermite(B, [0.0; 5]);
        ButcherTableau {
            a: [
                [0.0; 5],
                [1.0 / 2.0, 0.0, 0.0, 0.0, 0.0],
                [0.0, 1.0 / 2.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0, 0.0],
                B,
            ],
            b: B,
            c: [0.0, 1.0 / 2.0, 1.0 / 2.0, 1.0, 1.0],
            b_hat: None,
            order: 4,
            order_hat: 0,
            extra: &[],
            dense: &[&DENSE[0], &DENSE[1], &DENSE[2]],
            dense_order: 3,
        }
    };
}

/// The pair of orders 5 and 4 with dense output of order 4.
///
/// J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6 (1980) 19-26.
/// Dense output: E. Hairer, S. P. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993), II.6,
/// as in the authors' code DOPRI5; it is the one of L. F. Shampine, "Some practical Runge-Kutta formulas",
/// Math. Comput. 46 (1986) 135-150.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DormandPrince5;

impl Tableau<7> for DormandPrince5 {
    const TABLEAU: ButcherTableau<7> = {
        const B: [f64; 7] = [
            35.0 / 384.0,
            0.0,
            500.0 / 1113.0,
            125.0 / 192.0,
            -2187.0 / 6784.0,
            11.0 / 84.0,
            0.0,
        ];
        const D: [f64; 7] = [
            -12_715_105_075.0 / 11_282_082_432.0,
            0.0,
            87_487_479_700.0 / 32_700_410_799.0,
            -10_690_763_975.0 / 1_880_347_072.0,
            701_980_252_875.0 / 199_316_789_632.0,
            -1_453_857_185.0 / 822_651_844.0,
            69_997_945.0 / 29_380_423.0,
        ];
        const DENSE: [[f64; 7]; 4] = hermite(B, D);
        ButcherTableau {
            a: [
                [0.0; 7],
                [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
                [
                    19372.0 / 6561.0,
                    -25360.0 / 2187.0,
                    64448.0 / 6561.0,
                    -212.0 / 729.0,
                    0.0,
                    0.0,
                    0.0,
                ],
                [
                    9017.0 / 3168.0,
                    -355.0 / 33.0,
                    46732.0 / 5247.0,
                    49.0 / 176.0,
                    -5103.0 / 18656.0,
                    0.0,
                    0.0,
                ],
                B,
            ],
            b: B,
            c: [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
            b_hat: Some([
                5179.0 / 57600.0,
                0.0,
                7571.0 / 16695.0,
                393.0 / 640.0,
                -92097.0 / 339_200.0,
                187.0 / 2100.0,
                1.0 / 40.0,
            ]),
            order: 5,
            order_hat: 4,
            extra: &[],
            dense: &[&DENSE[0], &DENSE[1], &DENSE[2], &DENSE[3]],
            dense_order: 4,
        }
    };
}

/// The polynomials, by ascending power from 1, of the cubic Hermite interpolant of a step with the weights `b`, plus
/// `theta^2 (1 - theta)^2 h sum_i d_i k_i`, which leaves the values and slopes at both ends as they are.
const fn hermite<const S: usize>(b: [f64; S], d: [f64; S]) -> [[f64; S]; 4] {
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
