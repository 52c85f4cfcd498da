//! The pair of Tsitouras.

use super::{ButcherTableau, Tableau, rows};
use crate::step_size::Estimates;

/// Pair of orders 5 and 4 with dense output of order 4 without further stages.
///
/// Ch. Tsitouras, "Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption", Comput.
/// Math. Appl. 62 (2011) 770-775. The paper prints the coefficients to 16 digits; here they are rounded from more
/// digits, computed from the order conditions. The dense output has two free weights, the second and the last. They are
/// taken from the paper, and the conditions of order 4 determine the others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tsitouras5;

impl Estimates for Tsitouras5 {}

impl Tableau<7> for Tsitouras5 {
    const TABLEAU: ButcherTableau<7> = ButcherTableau {
        a: rows(A),
        b: B,
        c: C,
        b_hat: Some(B_HAT),
        order: 5,
        order_hat: 4,
        extra: &[],
        dense: DENSE,
        dense_order: 4,
    };
}

#[rustfmt::skip]
const A: [&[f64]; 7] = [
    &[],
    &[0.161],
    &[-0.008_480_655_492_356_989, 0.335_480_655_492_357],
    &[2.897_153_057_105_493_5, -6.359_448_489_975_075, 4.362_295_432_869_581_5],
    &[5.325_864_828_439_257, -11.748_883_564_062_828, 7.495_539_342_889_836_5, -0.092_495_066_361_755_25],
    &[
        5.861_455_442_946_42, -12.920_969_317_847_11, 8.159_367_898_576_159, -0.071_584_973_281_401,
        -0.028_269_050_394_068_383,
    ],
    &B,
];

#[rustfmt::skip]
const B: [f64; 7] = [
    0.096_460_766_818_065_23, 0.01, 0.479_889_650_414_499_6, 1.379_008_574_103_742, -3.290_069_515_436_081,
    2.324_710_524_099_774, 0.0,
];

#[rustfmt::skip]
const B_HAT: [f64; 7] = [
    0.094_680_755_765_839_45, 0.009_183_565_540_343_254, 0.487_770_528_424_761_6, 1.234_297_566_930_479,
    -2.707_712_349_983_525_6, 1.866_628_418_170_587, 0.015_151_515_151_515_152,
];

#[rustfmt::skip]
const C: [f64; 7] = [
    0.0, 0.161, 0.327, 0.9, 0.980_025_540_904_509_7, 1.0, 1.0,
];

#[rustfmt::skip]
const DENSE: &[&[f64]] = &[
    &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    &[
        -2.763_706_197_274_826, 0.1317, 3.930_296_236_894_751_6, -12.411_077_166_933_676, 37.509_313_416_511_04,
        -27.896_526_289_197_286, 1.5,
    ],
    &[
        2.913_255_461_821_912_6, -0.2234, -5.941_033_872_131_505, 30.338_188_630_282_32, -88.178_904_894_766_4,
        65.091_894_674_793_66, -4.0,
    ],
    &[
        -1.053_088_497_729_021_6, 0.1017, 2.490_627_285_651_253, -16.548_102_889_244_902, 47.379_521_962_819_28,
        -34.870_657_861_496_61, 2.5,
    ],
];
