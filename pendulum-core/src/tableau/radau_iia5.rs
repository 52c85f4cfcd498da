//! Radau IIA with three stages, of order 5.
//!
//! E. Hairer, G. Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.5 and IV.8.

use nalgebra::Complex;

use super::eigenpairs::{Eigenpair, Eigenpairs};

/// Number of stages.
pub(crate) const STAGES: usize = 3;
/// Times of the stages, in fractions of a step: `(4 -+ sqrt(6)) / 10` and 1.
pub(crate) const C: [f64; STAGES] = [0.155_051_025_721_682_2, 0.644_948_974_278_317_8, 1.0];
/// Stage coefficients; the last row contains the weights of the step.
pub(crate) const A: [[f64; STAGES]; STAGES] = [
    [
        0.196_815_477_223_660_4,
        -0.065_535_425_850_198_39,
        0.023_770_974_348_220_15,
    ],
    [
        0.394_424_314_739_087_3,
        0.292_073_411_665_228_5,
        -0.041_548_752_125_997_93,
    ],
    [0.376_403_062_700_467_25, 0.512_485_826_188_421_6, 1.0 / 9.0],
];
/// Real eigenvalue of `A`.
pub(crate) const MU: f64 = 0.274_888_829_595_677_34;
/// Eigenvectors of `A`.
pub(crate) const MODES: Eigenpairs<STAGES> = Eigenpairs {
    real: Some(Eigenpair {
        value: MU,
        left: [4.178_718_591_551_905, 0.327_682_820_761_062_37, 0.523_376_445_499_449_5],
        right: [0.094_438_762_488_975_24, 0.250_213_122_965_333_3, 1.0],
    }),
    pair: Eigenpair {
        value: Complex::new(0.162_555_585_202_161_32, 0.184_949_324_407_140_8),
        left: [
            Complex::new(-2.089_359_295_775_952_6, 0.251_436_317_472_893_4),
            Complex::new(-0.163_841_410_380_531_18, -1.285_963_474_927_802_6),
            Complex::new(0.238_311_777_250_275_22, 0.298_019_602_414_112_46),
        ],
        right: [
            Complex::new(-0.141_255_295_020_954_2, -0.030_029_194_105_147_424),
            Complex::new(0.204_129_352_293_799_94, 0.382_942_112_757_261_9),
            Complex::new(1.0, 0.0),
        ],
    },
};
/// Coefficients of the Lagrange polynomials without constant term, which are 1 at one of the times and 0 at the others:
/// one row per power, one column per time.
pub(crate) const POWERS: [[f64; STAGES]; STAGES] = [
    [10.048_809_399_827_416, -1.382_142_733_160_749, 1.0 / 3.0],
    [-25.629_591_447_076_64, 10.296_258_113_743_306, -8.0 / 3.0],
    [15.580_782_047_249_224, -8.914_115_380_582_556, 10.0 / 3.0],
];

#[cfg(test)]
mod tests {
    use super::{A, C, MODES, POWERS};

    #[test]
    fn the_coefficients_collocate_and_the_eigenvectors_are_theirs() {
        for (row, c) in A.iter().zip(C) {
            for k in 1..=3 {
                let moment: f64 = row.iter().zip(C).map(|(a, c)| a * c.powi(k - 1)).sum();
                assert!((moment - c.powi(k) / f64::from(k)).abs() < 1e-16);
            }
        }
        // some rounding errors of numbers up to 4
        assert!(MODES.residual(&A) < 2e-15, "{}", MODES.residual(&A));
    }

    #[test]
    fn the_polynomials_are_one_at_their_time_and_zero_at_the_others() {
        for (i, c) in C.into_iter().enumerate() {
            for j in 0..3 {
                let powers = [c, c * c, c * c * c];
                let value: f64 = POWERS.iter().zip(powers).map(|(row, power)| row[j] * power).sum();
                // some rounding errors of numbers up to 26
                assert!((value - f64::from(i == j)).abs() < 2e-14, "{value}");
            }
        }
    }
}
