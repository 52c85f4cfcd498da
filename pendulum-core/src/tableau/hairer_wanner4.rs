//! The method RODAS of Hairer and Wanner.

use super::rosenbrock::{RosenbrockMethod, RosenbrockTableau, continuous};
use super::rows;

/// RODAS: orders 4 and 3, stiffly accurate and L-stable, with dense output of order 3, in 6 stages.
///
/// E. Hairer, G. Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.7 and VI.4; the coefficients
/// are the first set of the authors' code RODAS.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HairerWanner4;

impl RosenbrockMethod<6> for HairerWanner4 {
    const TABLEAU: RosenbrockTableau<6> = RosenbrockTableau {
        gamma: 0.25,
        a: rows(A),
        c: rows(C),
        alpha: ALPHA,
        gamma_sums: GAMMA_SUMS,
        b: B,
        b_hat: B_HAT,
        order: 4,
        order_hat: 3,
        dense: &[&DENSE[0], &DENSE[1], &DENSE[2]],
        dense_order: 3,
    };
}

#[rustfmt::skip]
const A: [&[f64]; 6] = [
    &[],
    &[1.544],
    &[0.946_678_528_081_582_6, 0.255_701_169_898_328_4],
    &[3.314_825_187_068_521, 2.896_124_015_972_201, 0.998_641_913_997_781_7],
    &[1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895],
    &[1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895, 1.0],
];

#[rustfmt::skip]
const C: [&[f64]; 6] = [
    &[],
    &[-5.6688],
    &[-2.430_093_356_833_875, -0.206_359_915_709_191_5],
    &[-0.107_352_905_815_137_5, -9.594_562_251_023_355, -20.470_286_148_096_16],
    &[7.496_443_313_967_647, -10.246_804_314_643_52, -33.999_903_528_199_05, 11.708_908_932_061_6],
    &[
        8.083_246_795_921_522, -7.981_132_988_064_893, -31.521_594_328_743_71, 16.319_305_431_231_36,
        -6.058_818_238_834_054,
    ],
];

#[rustfmt::skip]
const ALPHA: [f64; 6] = [0.0, 0.386, 0.21, 0.63, 1.0, 1.0];

#[rustfmt::skip]
const GAMMA_SUMS: [f64; 6] = [0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0];

#[rustfmt::skip]
const B: [f64; 6] = [
    1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895, 1.0, 1.0,
];

#[rustfmt::skip]
const B_HAT: [f64; 6] = [
    1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895, 1.0, 0.0,
];

const DENSE: [[f64; 6]; 3] = continuous(B, H);

#[rustfmt::skip]
const H: [[f64; 6]; 2] = [
    [
        10.126_235_083_445_86, -7.487_995_877_610_167, -34.800_918_615_557_47, -7.992_771_707_568_823,
        1.025_137_723_295_662, 0.0,
    ],
    [
        -0.676_280_339_280_125_3, 6.087_714_651_680_015, 16.430_843_208_924_78, 24.767_225_114_183_86,
        -6.594_389_125_716_872, 0.0,
    ],
];
