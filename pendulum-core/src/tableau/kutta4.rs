//! The method of Kutta.

use super::hermite::hermite;
use super::{ButcherTableau, Tableau};

/// The classical method of order 4, with cubic Hermite interpolation (order 3) between the steps.
///
/// W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", Z. Math. Phys. 46 (1901)
/// 435-453.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kutta4;

impl Tableau<5> for Kutta4 {
    const TABLEAU: ButcherTableau<5> = {
        const B: [f64; 5] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0];
        const ROWS: [[f64; 5]; 4] = hermite(B, [0.0; 5]);
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
            dense: &[&ROWS[0], &ROWS[1], &ROWS[2]],
            dense_order: 3,
        }
    };
}
