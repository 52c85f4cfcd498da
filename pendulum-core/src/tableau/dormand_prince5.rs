//! The pair of Dormand and Prince.

use super::hermite::hermite;
use super::{ButcherTableau, Tableau};
use crate::step_size::Estimates;

/// Pair of orders 5 and 4 with dense output of order 4.
///
/// J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6 (1980) 19-26.
/// Dense output: E. Hairer, S. P. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.6, as in the authors' code DOPRI5; originally by L. F. Shampine, "Some practical Runge-Kutta formulas", Math.
/// Comput. 46 (1986) 135-150.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DormandPrince5;

impl Estimates for DormandPrince5 {}

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
        const ROWS: [[f64; 7]; 4] = hermite(B, D);
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
            dense: &[&ROWS[0], &ROWS[1], &ROWS[2], &ROWS[3]],
            dense_order: 4,
        }
    };
}
