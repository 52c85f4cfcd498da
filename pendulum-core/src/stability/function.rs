//! Stability functions of methods.

use nalgebra::Complex;

use crate::linear::{self, Lu};
use crate::method::{Adaptive, Explicit, Fixed, Gauss, PowerSeries, RadauIIA, Rosenbrock};
use crate::tableau::{GaussLegendre, HasGaussTableau, HasRadauTableau, RosenbrockMethod, Tableau};

/// A method with a stability function: a step of size `h` multiplies a solution of `x' = lambda x` by `R(h lambda)`.
///
/// `R(z)` approximates `exp(z)` to the order of the method. On a linear system, and therefore on small motions about an
/// equilibrium, a step multiplies each mode by `R` of `h` times its eigenvalue: modes with `|R| > 1` grow even if the
/// motion decays. This holds for all methods here, also for steps in canonical variables, since a change of
/// variables preserves eigenvalues.
///
/// `R` is evaluated from the coefficients of the method: a polynomial for explicit methods, a rational function for
/// implicit ones. E. Hairer, G. Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.2 (explicit),
/// IV.3 (implicit), IV.7 (Rosenbrock).
///
/// [`Auto`](crate::Auto) has none, since the method of a step depends on the steps before.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::{Complex, StabilityFunction};
///
/// let z = Complex::new(-0.5, 2.0);
/// let polynomial = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
/// assert!((Rk4::new(0.01).stability_function(z) - polynomial).norm() < 1e-15);
/// assert!(Radau5::new().stability_at_infinity() < 1e-15);
/// ```
pub trait StabilityFunction {
    /// Evaluates `R(z)`; not finite at a pole, and NaN if the settings of the method are invalid.
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64>;

    /// Limit of `|R(z)|` for large `|z|`: the amplification per step of modes that decay much faster than the step.
    ///
    /// Stiff components vanish at once if it is 0 and persist as oscillations if it is 1. For explicit methods it is
    /// infinite, and stiff components grow without bound.
    fn stability_at_infinity(&self) -> f64;
}

const ONE: Complex<f64> = Complex::new(1.0, 0.0);

/// `sum_i weights_i stages_i`.
fn combined(weights: &[f64], stages: &[Complex<f64>]) -> Complex<f64> {
    weights.iter().zip(stages).map(|(&weight, stage)| stage * weight).sum()
}

impl<B: Tableau<STAGES>, const STAGES: usize> StabilityFunction for Explicit<B, STAGES> {
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        let tableau = const { &B::TABLEAU };
        let mut stages = [ONE; STAGES];
        for i in 1..STAGES {
            stages[i] = ONE + z * combined(&tableau.a[i][..i], &stages);
        }
        ONE + z * combined(&tableau.b, &stages)
    }

    fn stability_at_infinity(&self) -> f64 {
        f64::INFINITY
    }
}

impl<B: RosenbrockMethod<STAGES>, const STAGES: usize> StabilityFunction for Rosenbrock<B, STAGES> {
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        let tableau = const { &B::TABLEAU };
        let mut stages = [Complex::default(); STAGES];
        for i in 0..STAGES {
            let slope = z * (ONE + combined(&tableau.a[i][..i], &stages));
            stages[i] = (slope + combined(&tableau.c[i][..i], &stages)) / (1.0 / tableau.gamma - z);
        }
        ONE + combined(&tableau.b, &stages)
    }

    fn stability_at_infinity(&self) -> f64 {
        let tableau = const { &B::TABLEAU };
        let mut stages = [Complex::default(); STAGES];
        for i in 0..STAGES {
            stages[i] = -ONE - combined(&tableau.a[i][..i], &stages);
        }
        (ONE + combined(&tableau.b, &stages)).norm()
    }
}

impl<const STAGES: usize, const PAIRS: usize> StabilityFunction for RadauIIA<STAGES, PAIRS>
where
    Self: HasRadauTableau<STAGES, PAIRS>,
{
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        let a = const { &Self::TABLEAU.a };
        implicit(a, &a[STAGES - 1], z)
    }

    fn stability_at_infinity(&self) -> f64 {
        let a = const { &Self::TABLEAU.a };
        implicit_at_infinity(a, &a[STAGES - 1])
    }
}

impl<const STAGES: usize, const PAIRS: usize> StabilityFunction for Gauss<STAGES, PAIRS>
where
    GaussLegendre: HasGaussTableau<STAGES, PAIRS>,
{
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        let (a, b) = <GaussLegendre as HasGaussTableau<STAGES, PAIRS>>::TABLEAU.coefficients();
        implicit(&a, &b, z)
    }

    fn stability_at_infinity(&self) -> f64 {
        let (a, b) = <GaussLegendre as HasGaussTableau<STAGES, PAIRS>>::TABLEAU.coefficients();
        implicit_at_infinity(&a, &b)
    }
}

/// `1 + z b (I - z A)^-1 1`.
fn implicit<const STAGES: usize>(a: &[[f64; STAGES]; STAGES], b: &[f64; STAGES], z: Complex<f64>) -> Complex<f64> {
    let entry = |i: usize, j: usize| {
        let identity = if i == j { 1.0 } else { 0.0 };
        linear::Complex::new(identity - z.re * a[i][j], -z.im * a[i][j])
    };
    match Lu::new(std::array::from_fn(|j| std::array::from_fn(|i| entry(i, j))), STAGES) {
        Ok(lu) => {
            let stages = lu.solve(&[linear::Complex::new(1.0, 0.0); STAGES], STAGES);
            ONE + z * combined(b, &stages.map(|stage| Complex::new(stage.re, stage.im)))
        }
        Err(linear::Singular) => Complex::new(f64::INFINITY, 0.0),
    }
}

/// `|1 - b A^-1 1|`.
fn implicit_at_infinity<const STAGES: usize>(a: &[[f64; STAGES]; STAGES], b: &[f64; STAGES]) -> f64 {
    let columns = std::array::from_fn(|j| std::array::from_fn(|i| a[i][j]));
    Lu::new(columns, STAGES).map_or(f64::INFINITY, |lu| {
        let stages = lu.solve(&[1.0; STAGES], STAGES);
        b.iter().zip(stages).fold(1.0, |sum, (b, stage)| sum - b * stage).abs()
    })
}

impl<F: StabilityFunction> StabilityFunction for Fixed<F> {
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        self.family.stability_function(z)
    }

    fn stability_at_infinity(&self) -> f64 {
        self.family.stability_at_infinity()
    }
}

impl<F: StabilityFunction> StabilityFunction for Adaptive<F> {
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        self.family.stability_function(z)
    }

    fn stability_at_infinity(&self) -> f64 {
        self.family.stability_at_infinity()
    }
}

/// Exponential series up to the order for fixed steps.
impl StabilityFunction for Fixed<PowerSeries> {
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        let order = self.family.order_within::<f64>(None);
        order.map_or(Complex::from(f64::NAN), |order| exponential(order, z))
    }

    fn stability_at_infinity(&self) -> f64 {
        f64::INFINITY
    }
}

/// Exponential series up to the order that follows from the tolerance in `f64`.
impl StabilityFunction for Adaptive<PowerSeries> {
    fn stability_function(&self, z: Complex<f64>) -> Complex<f64> {
        let tolerance = self.tolerance::<f64>();
        let order = tolerance.and_then(|tolerance| self.family.order_within(Some(tolerance)));
        order.map_or(Complex::from(f64::NAN), |order| exponential(order, z))
    }

    fn stability_at_infinity(&self) -> f64 {
        f64::INFINITY
    }
}

/// `sum_(k <= order) z^k / k!`.
fn exponential(order: usize, z: Complex<f64>) -> Complex<f64> {
    (1..=order).rev().fold(ONE, |sum, k| ONE + z * sum / k as f64)
}
