//! The Gauss-Legendre methods.

mod order16;

use nalgebra::Complex;

use super::eigenpairs::{Eigenpair, Eigenpairs};
use crate::real::Real;

/// Coefficients of a Gauss-Legendre method.
///
/// With antisymmetric `w`, the coefficients `a_ij = b_j (1/2 + w_ij)` satisfy `b_i a_ij + b_j a_ji = b_i b_j`
/// independently of rounding, which makes the method symplectic (E. Hairer, R. I. McLachlan, A. Razakarivony,
/// "Achieving Brouwer's law with implicit Runge-Kutta methods", BIT 48 (2008) 231-243).
#[derive(Clone, Copy, Debug)]
pub struct GaussTableau<const STAGES: usize, const PAIRS: usize> {
    /// Times of the stages, in fractions of a step.
    pub(crate) c: [f64; STAGES],
    /// Weights of the step.
    pub(crate) b: [f64; STAGES],
    pub(crate) w: [[f64; STAGES]; STAGES],
    pub(crate) modes: Eigenpairs<STAGES, PAIRS>,
    /// Reciprocal products of the differences between start, nodes and end of a step (barycentric weights).
    over: [f64; MOST_POINTS],
    /// Coefficients of the Lagrange polynomials of nodes and end: one row per power from the first on, one column per
    /// point.
    pub(crate) powers: [[f64; MOST_POINTS - 1]; MOST_POINTS - 1],
}

/// Number of interpolation points for eight stages: start, nodes and end of a step.
pub(crate) const MOST_POINTS: usize = 10;

impl<const STAGES: usize, const PAIRS: usize> GaussTableau<STAGES, PAIRS> {
    pub(super) const fn new(
        c: [f64; STAGES],
        b: [f64; STAGES],
        w: [[f64; STAGES]; STAGES],
        modes: Eigenpairs<STAGES, PAIRS>,
    ) -> Self {
        let mut over = [1.0; MOST_POINTS];
        let mut j = 0;
        while j < STAGES + 2 {
            let mut k = 0;
            while k < STAGES + 2 {
                if k != j {
                    over[j] /= point(&c, j) - point(&c, k);
                }
                k += 1;
            }
            j += 1;
        }
        let mut powers = [[0.0; MOST_POINTS - 1]; MOST_POINTS - 1];
        let mut j = 1;
        while j < STAGES + 2 {
            // theta, which vanishes at the start, times the factors of the other points
            let mut polynomial = [0.0; MOST_POINTS];
            polynomial[1] = over[j];
            let mut k = 1;
            while k < STAGES + 2 {
                if k != j {
                    let mut power = STAGES + 1;
                    while power > 0 {
                        polynomial[power] = polynomial[power - 1] - point(&c, k) * polynomial[power];
                        power -= 1;
                    }
                }
                k += 1;
            }
            let mut power = 1;
            while power < STAGES + 2 {
                powers[power - 1][j - 1] = polynomial[power];
                power += 1;
            }
            j += 1;
        }
        Self {
            c,
            b,
            w,
            modes,
            over,
            powers,
        }
    }

    /// Coefficients `a_ij` and weights `b_j`.
    #[cfg(feature = "std")]
    pub(crate) fn coefficients(&self) -> ([[f64; STAGES]; STAGES], [f64; STAGES]) {
        let row = |w: [f64; STAGES]| core::array::from_fn(|j| self.b[j] * (0.5 + w[j]));
        (self.w.map(row), self.b)
    }

    /// Lagrange weights of the values at start, nodes and end of a step, at the fraction `theta` of it. They are not
    /// defined at these points.
    #[inline(always)]
    pub(crate) fn weights<T: Real>(&self, theta: T) -> [T; MOST_POINTS] {
        let (mut weights, mut product) = ([T::default(); MOST_POINTS], T::from_f64(1.0));
        for (j, weight) in weights.iter_mut().enumerate().take(STAGES + 2) {
            let distance = theta - T::from_f64(point(&self.c, j));
            *weight = T::from_f64(self.over[j]) / distance;
            product *= distance;
        }
        for weight in &mut weights[..STAGES + 2] {
            *weight *= product;
        }
        weights
    }
}

/// Interpolation point `k`: start, node or end of a step.
const fn point<const STAGES: usize>(c: &[f64; STAGES], k: usize) -> f64 {
    match k {
        0 => 0.0,
        k if k <= STAGES => c[k - 1],
        _ => 1.0,
    }
}

/// Tableaus of the Gauss-Legendre methods.
#[derive(Clone, Copy, Debug)]
pub struct GaussLegendre;

/// Numbers of stages, and of pairs of complex eigenvalues, with a tableau.
pub trait HasGaussTableau<const STAGES: usize, const PAIRS: usize> {
    /// Tableau.
    const TABLEAU: GaussTableau<STAGES, PAIRS>;
}

impl HasGaussTableau<8, 4> for GaussLegendre {
    const TABLEAU: GaussTableau<8, 4> = order16::TABLEAU;
}

impl HasGaussTableau<2, 1> for GaussLegendre {
    const TABLEAU: GaussTableau<2, 1> = {
        /// Square root of 1/3.
        const W: f64 = 0.577_350_269_189_625_7;
        GaussTableau::new(
            [0.5 - 0.5 * W, 0.5 + 0.5 * W],
            [0.5; 2],
            [[0.0, -W], [W, 0.0]],
            Eigenpairs {
                real: None,
                pairs: [Eigenpair {
                    value: Complex::new(0.25, 0.25 * W),
                    left: [Complex::new(0.5, 0.0), Complex::new(0.0, 0.133_974_596_215_561_35)],
                    right: [Complex::new(1.0, 0.0), Complex::new(0.0, -3.732_050_807_568_877)],
                }],
            },
        )
    };
}

impl HasGaussTableau<3, 1> for GaussLegendre {
    const TABLEAU: GaussTableau<3, 1> = {
        /// Square root of 3/5.
        const ROOT: f64 = 0.774_596_669_241_483_4;
        const W: f64 = 0.75 * ROOT;
        const FAR: f64 = 0.6 * ROOT;
        GaussTableau::new(
            [0.5 - 0.5 * ROOT, 0.5, 0.5 + 0.5 * ROOT],
            [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0],
            [[0.0, -W, -FAR], [W, 0.0, -W], [FAR, W, 0.0]],
            Eigenpairs {
                real: Some(Eigenpair {
                    value: 0.215_314_423_116_112_18,
                    left: [
                        0.432_312_113_783_858_36,
                        0.082_196_421_283_245_77,
                        0.031_192_119_675_403_814,
                    ],
                    right: [1.0, 1.646_978_911_232_442, 13.859_658_089_371_628],
                }),
                pairs: [Eigenpair {
                    value: Complex::new(0.142_342_788_441_943_92, 0.135_799_925_708_153_8),
                    left: [
                        Complex::new(0.283_843_943_108_070_8, 0.128_867_600_636_716_23),
                        Complex::new(-0.041_098_210_641_622_88, 0.154_546_015_144_924_58),
                        Complex::new(-0.015_596_059_837_701_907, -0.027_663_137_569_708_934),
                    ],
                    right: [
                        Complex::new(1.0, 0.0),
                        Complex::new(-2.252_297_366_341_166_3, -2.198_353_169_286_191_3),
                        Complex::new(-7.924_480_066_670_396, 5.793_026_094_808_575),
                    ],
                }],
            },
        )
    };
}

#[cfg(test)]
mod tests {
    use super::{GaussLegendre, GaussTableau, HasGaussTableau};

    const TWO: GaussTableau<2, 1> = GaussLegendre::TABLEAU;
    const THREE: GaussTableau<3, 1> = GaussLegendre::TABLEAU;
    const EIGHT: GaussTableau<8, 4> = GaussLegendre::TABLEAU;

    /// Largest error of the identities that hold for exact coefficients.
    fn worst<const STAGES: usize, const PAIRS: usize>(table: &GaussTableau<STAGES, PAIRS>) -> f64 {
        let all = 0..STAGES;
        let (a, _) = table.coefficients();
        let mut errors = Vec::new();
        // collocation: sum_j a_ij c_j^(k-1) = c_i^k / k; the weights integrate exactly up to degree 2 s - 1
        for k in 1..=2 * STAGES as i32 {
            let moment = |weight: &dyn Fn(usize) -> f64| -> f64 {
                all.clone().map(|j| weight(j) * table.c[j].powi(k - 1)).sum()
            };
            errors.push(moment(&|j| table.b[j]) - 1.0 / f64::from(k));
            if k <= STAGES as i32 {
                errors.extend(
                    all.clone()
                        .map(|i| moment(&|j| a[i][j]) - table.c[i].powi(k) / f64::from(k)),
                );
            }
        }
        errors.push(table.modes.residual(&a));
        errors.into_iter().map(f64::abs).fold(0.0, f64::max)
    }

    #[test]
    fn the_coefficients_collocate_and_the_eigenvectors_are_theirs() {
        // some rounding errors of numbers up to 14
        assert!(worst(&TWO) < 4e-16);
        assert!(worst(&THREE) < 4e-15);
        // of eigenvectors up to 1290
        assert!(worst(&EIGHT) < 3e-13);
    }

    #[test]
    fn the_weights_reproduce_a_polynomial() {
        let table = THREE;
        let quartic = |x: f64| 1.0 + x * (2.0 - x * (3.0 - x * (0.5 + x)));
        let values = [0.0, table.c[0], table.c[1], table.c[2], 1.0].map(quartic);
        let terms = table.weights(1.7).into_iter().zip(values);
        let sum: f64 = terms.map(|(weight, value)| weight * value).sum();
        assert!((sum - quartic(1.7)).abs() < 1e-13);
    }

    #[test]
    fn the_powers_are_those_of_lagrange_polynomials() {
        let table = EIGHT;
        let points = [&table.c[..], &[1.0]].concat();
        for (j, _) in points.iter().enumerate() {
            for (i, theta) in points.iter().enumerate() {
                let powers = (1..).zip(&table.powers);
                let value: f64 = powers.map(|(power, row)| row[j] * theta.powi(power)).sum();
                // some rounding errors of the coefficients, which are up to 4e5
                assert!((value - f64::from(u8::from(i == j))).abs() < 1e-9, "{i} {j} {value}");
            }
        }
    }

    #[test]
    fn rounded_coefficients_are_symplectic() {
        fn check<const STAGES: usize, const PAIRS: usize>(table: &GaussTableau<STAGES, PAIRS>) {
            for i in 0..STAGES {
                for j in 0..STAGES {
                    assert_eq!(table.w[i][j], -table.w[j][i]);
                }
            }
        }
        check(&THREE);
        check(&EIGHT);
    }
}
