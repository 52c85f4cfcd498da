//! Tolerances and step-size selection.

use nalgebra::SVector;

use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::system::System;

/// Error tolerance `atol + rtol |x|` of each component.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tolerance<T> {
    /// Relative tolerance.
    pub rtol: T,
    /// Absolute tolerance.
    pub atol: T,
}

impl<T: Real> Tolerance<T> {
    /// True if the errors of derivatives do not count.
    #[inline(always)]
    pub(crate) fn is_of_values(&self) -> bool {
        T::HAS_SLOPES && self.rtol.is_constant()
    }

    /// Mean square of `error / (atol + rtol (|x0| + |x1|) / 2)`; the error is within the tolerance if it is at most 1.
    ///
    /// This is the norm of Hairer, Nørsett, Wanner I, II.4, with the mean of both states in place of the larger one,
    /// which also works in lanes. Its square root is not taken, since the controller works on logarithms. If the
    /// relative tolerance has derivatives, it bounds the errors of derivatives as well. `active` is that of the
    /// [system](System::active).
    #[inline(always)]
    pub(crate) fn mean_square<const N: usize>(
        &self,
        error: &SVector<T, N>,
        [x0, x1]: [&SVector<T, N>; 2],
        active: usize,
    ) -> T {
        let half = self.rtol * T::from_f64(0.5);
        let mut sum = T::default();
        for i in 0..active.min(N) {
            let size = x0.data.0[0][i].without_slopes().abs() + x1.data.0[0][i].without_slopes().abs();
            let ratio = error.data.0[0][i].without_slopes() / (self.atol + half * size);
            sum += ratio * ratio;
        }
        let mean = (sum * T::from_f64(1.0 / active as f64)).without_slopes();
        if const { T::HAS_SLOPES }
            && let Some(ratio) = self.ratio_of_slopes(error, x0, x1)
        {
            return mean.at_least(ratio * ratio);
        }
        mean
    }

    /// [`mean_square`](Self::mean_square) of `v`, and the mean square of its ratio to `other`, at most 1, to which
    /// components count by their parts of the former; NaN if `v` is zero.
    #[inline(always)]
    pub(crate) fn mean_square_and_ratio<const N: usize>(
        &self,
        [v, other]: [&SVector<T, N>; 2],
        [x0, x1]: [&SVector<T, N>; 2],
        active: usize,
    ) -> [T; 2] {
        let half = self.rtol * T::from_f64(0.5);
        let [mut sum, mut of_v, mut of_other] = [T::default(); 3];
        for i in 0..active.min(N) {
            let [v, other, x0, x1] = [v, other, x0, x1].map(|all| all.data.0[0][i].without_slopes());
            let ratio = v / (self.atol + half * (x0.abs() + x1.abs()));
            let part = ratio * ratio;
            sum += part;
            of_v += part * (v * v);
            of_other += part * (other * other);
        }
        let mut mean = (sum * T::from_f64(1.0 / active as f64)).without_slopes();
        if const { T::HAS_SLOPES }
            && let Some(ratio) = self.ratio_of_slopes(v, x0, x1)
        {
            mean = mean.at_least(ratio * ratio);
        }
        [mean, (of_v / of_other).at_most(T::from_f64(1.0))]
    }

    /// Means of `|v| / (atol + rtol |x|)`, of several `v`. They are not squared: the coefficients of a fast motion grow
    /// with the order, and would leave the range of `f32`.
    #[inline(always)]
    pub(crate) fn mean_sizes<const M: usize, const N: usize>(
        &self,
        v: [&SVector<T, N>; M],
        x: &SVector<T, N>,
        active: usize,
    ) -> [T; M] {
        let mut sums = [T::default(); M];
        for i in 0..active.min(N) {
            let size = x.data.0[0][i].without_slopes().abs();
            let weight = T::from_f64(1.0) / (self.atol + self.rtol * size);
            for (sum, v) in sums.iter_mut().zip(v) {
                *sum += v.data.0[0][i].without_slopes().abs() * weight;
            }
        }
        let mut means = sums.map(|sum| (sum * T::from_f64(1.0 / active as f64)).without_slopes());
        if const { T::HAS_SLOPES } {
            for (mean, v) in means.iter_mut().zip(v) {
                if let Some(ratio) = self.ratio_of_slopes(v, x, x) {
                    *mean = mean.at_least(ratio);
                }
            }
        }
        means
    }

    /// See [`Real::ratio_of_slopes`].
    #[inline(always)]
    fn ratio_of_slopes<const N: usize>(&self, v: &SVector<T, N>, x0: &SVector<T, N>, x1: &SVector<T, N>) -> Option<T> {
        let [v, x0, x1] = [v, x0, x1].map(|vector| &vector.data.0[0]);
        T::ratio_of_slopes([self.rtol, self.atol], v, [x0, x1])
    }
}

impl<T: Float> Tolerance<T> {
    /// Broadcasts the tolerance to all lanes.
    #[inline(always)]
    pub(crate) fn in_lanes<V: Lanes<Scalar = T>>(self) -> Tolerance<V> {
        Tolerance {
            rtol: V::splat(self.rtol),
            atol: V::splat(self.atol),
        }
    }

    /// Chooses a first step such that an explicit Euler step is accurate to a hundredth, judged by the change of the
    /// slope along it.
    ///
    /// Hairer, Nørsett, Wanner I, II.4, "Starting step size". `order` is the order of the error estimate, `h_max`
    /// bounds the result, `direction` is 1 or -1. One evaluation of the right-hand side.
    pub(crate) fn first_step<S, const N: usize>(
        &self,
        system: &S,
        (t0, x0, f0): (T, &SVector<T, N>, &SVector<T, N>),
        (order, h_max, direction): (usize, T, T),
    ) -> T
    where
        S: System<T, N> + ?Sized,
    {
        let trial = self.trial((x0, f0), system.active(), h_max);
        let signed = trial.length * direction;
        let f1 = system.rhs(t0 + signed, &(x0 + f0 * signed));
        self.first_after(trial, (x0, f0, &f1), system.active(), (order, h_max))
    }

    /// Chooses the trial step of [`first_step`](Self::first_step), from the initial state and its derivative.
    pub(crate) fn trial<const N: usize>(
        &self,
        (x0, f0): (&SVector<T, N>, &SVector<T, N>),
        active: usize,
        h_max: T,
    ) -> Trial<T> {
        let [size, rate] = [x0, f0].map(|v| self.mean_square(v, [x0, x0], active).sqrt().to_f64());
        let length = if size < 1e-5 || rate < 1e-5 {
            1e-6
        } else {
            0.01 * size / rate
        };
        Trial {
            length: T::from_f64(length).min(h_max),
            rate,
        }
    }

    /// Chooses the [first step](Self::first_step) by the derivative `f1` after the trial step.
    pub(crate) fn first_after<const N: usize>(
        &self,
        trial: Trial<T>,
        (x0, f0, f1): (&SVector<T, N>, &SVector<T, N>, &SVector<T, N>),
        active: usize,
        (order, h_max): (usize, T),
    ) -> T {
        let change = self.mean_square(&(f1 - f0), [x0, x0], active).sqrt();
        let (curvature, length) = ((change / trial.length).to_f64(), trial.length.to_f64());
        let steepest = trial.rate.max(curvature);
        let h = if !curvature.is_finite() {
            length * 1e-3
        } else if steepest <= 1e-15 {
            (length * 1e-3).max(1e-6)
        } else {
            libm::pow(0.01 / steepest, 1.0 / (order as f64 + 1.0))
        };
        T::from_f64(h.min(100.0 * length)).min(h_max)
    }
}

/// Trial step from an initial point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Trial<T> {
    pub(crate) length: T,
    /// Size of the derivative at the point, in units of the tolerance.
    rate: f64,
}

/// A kind of method that estimates the error of each step, so that it can keep a tolerance; also a tableau of one.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not estimate its error, so it cannot keep a tolerance",
    label = "has no error estimate",
    note = "use fixed steps, as in `Rk4`, `Gauss4`, `Gauss6` and `Gauss16`, or a method with an error estimate: \
            `Rk45`, `Tsit5`, `Vern7`, `Vern9`, `Taylor`, `Auto`, and for stiff systems `Rodas4`, `Rodas5P` or `Radau5`"
)]
pub trait Estimates {}

/// The PI controller of DOPRI5 (Hairer, Nørsett, Wanner I, 2nd ed., II.4 and IV.2), after K. Gustafsson, "Control
/// theoretic techniques for stepsize selection in explicit Runge-Kutta methods", ACM Trans. Math. Softw. 17 (1991)
/// 533-554.
///
/// After a step with the error `e_n`, in units of the tolerance, the next one is longer by `0.9 e_n^-alpha
/// e_(n-1)^beta`, within 0.2 and 3; `beta = 0.04` damps the steps of mildly stiff systems, and `alpha = 1 / (order + 1)
/// - 0.75 beta`.
///
/// DOPRI5 lets steps grow tenfold. But between two jumps of a right-hand side errors may vanish, so growth is blind: a
/// step ten times as long as the last one, nine times the time since the jump, can pass several more jumps with stages
/// that happen to agree. A step three times as long as the last one is twice as long as that time, and has stages in
/// between.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PiController {
    pub(crate) alpha: f64,
    /// Binary logarithm of the last accepted error.
    pub(crate) last: f64,
    /// Maximum of the next factor.
    pub(crate) most: f64,
}

impl PiController {
    const BETA: f64 = 0.04;
    const SAFETY: f64 = 0.9;
    const SHRINK: f64 = 0.2;
    const GROW: f64 = 3.0;
    /// Factor after a failed attempt, without an error.
    const FAILED: f64 = 0.25;
    /// Binary logarithm of 1e-4. Smaller errors are stored as this one, since they predict little about the next.
    const SMALLEST_LOG: f64 = -13.287_712_379_549_449;

    /// Creates a controller for an error estimate of this `order`.
    pub(crate) fn new(order: usize) -> Self {
        let mut controller = Self {
            alpha: 0.0,
            last: Self::SMALLEST_LOG,
            most: Self::GROW,
        };
        controller.set_order(order);
        controller
    }

    /// Continues with an estimate of another order.
    #[inline]
    pub(crate) fn set_order(&mut self, order: usize) {
        self.alpha = 1.0 / (order as f64 + 1.0) - 0.75 * Self::BETA;
    }

    /// Returns the factor for the next attempt, after one with this mean square error, which was accepted if it is at
    /// most 1. NaN stands for a failed attempt.
    ///
    /// Without branches, so that it vectorizes over lanes. After a rejection a step does not grow.
    #[inline(always)]
    pub(crate) fn next(&mut self, mean_square: f64) -> f64 {
        let is_accepted = mean_square <= 1.0;
        let error = 0.5 * log2(mean_square);
        let memory = if is_accepted { Self::BETA * self.last } else { 0.0 };
        let factor = Self::SAFETY * exp2(memory - self.alpha * error);
        let factor = factor.min(self.most).max(Self::SHRINK);
        let remembered = error.max(Self::SMALLEST_LOG);
        self.last = if is_accepted { remembered } else { self.last };
        self.most = if is_accepted { Self::GROW } else { 1.0 };
        if mean_square.is_nan() { Self::FAILED } else { factor }
    }
}

/// Binary logarithm of a positive normal number, to 1.2e-4; far below 0 at 0.
///
/// The length of a step needs no higher accuracy, and every step waits for the result: these functions take a third of
/// the time of the platform's. They also give the same steps on every machine. Both polynomials interpolate in
/// Chebyshev points.
#[inline(always)]
pub(crate) fn log2(x: f64) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    // With these leading bits, an integer below 2^52 is 2^52 more as a number: a conversion available in all registers.
    const INTEGER: f64 = 4_503_599_627_370_496.0;
    let bits = x.to_bits();
    let m = f64::from_bits(bits & MANTISSA | 1.0_f64.to_bits());
    let exponent = f64::from_bits((bits >> 52) | INTEGER.to_bits()) - (INTEGER + 1023.0);
    let square = m * m;
    let low = -2.498_353_15 + 4.029_211_39 * m;
    let high = -2.078_335_17 + 0.626_032_18 * m - 0.078_440_68 * square;
    exponent + (low + square * high)
}

/// 2 to the power of `x`, to 1e-4; `x` is clamped to the range of exponents.
#[inline(always)]
pub(crate) fn exp2(x: f64) -> f64 {
    let x = x.clamp(-1022.0, 1023.0);
    // Adding 1.5 * 2^52 rounds to the nearest integer, and places it in the lowest bits.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let rounded = x + ROUND;
    let y = x - (rounded - ROUND);
    let power = (0.999_924_56 + 0.693_136_73 * y) + y * y * (0.242_639_48 + 0.055_838_28 * y);
    power * f64::from_bits(rounded.to_bits().wrapping_add(1023) << 52)
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{PiController, Tolerance, exp2, log2};
    use crate::system::FnSystem;

    #[test]
    fn errors_are_measured_against_the_mean_of_both_states() {
        let tolerance = Tolerance { rtol: 0.1, atol: 0.01 };
        let (x0, x1) = (SVector::from([1.0, -2.0]), SVector::from([-3.0, 4.0]));
        // 0.01 + 0.1 * 2 and 0.01 + 0.1 * 3
        let expected = ((0.3_f64 / 0.21).powi(2) + (0.4_f64 / 0.31).powi(2)) / 2.0;
        let found = tolerance.mean_square(&SVector::from([0.3, -0.4]), [&x0, &x1], 2);
        assert!((found / expected - 1.0).abs() < 1e-15, "{found} {expected}");
    }

    #[test]
    fn sizes_are_measured_against_the_state() {
        let tolerance = Tolerance { rtol: 0.5, atol: 0.25 };
        let [a, b] = [SVector::from([1.0, -2.0]), SVector::from([-5.0, 0.0])];
        let found = tolerance.mean_sizes([&a, &b], &SVector::from([-3.0, 4.0]), 2);
        // 0.25 + 0.5 * 3 and 0.25 + 0.5 * 4
        let expected = [(1.0 / 1.75 + 2.0 / 2.25) / 2.0, 5.0 / 1.75 / 2.0];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0_f64).abs() < 1e-15, "{found} {expected}");
        }
    }

    /// First step of `x' = f(t, x)` from `x0` at 1.
    fn first_step(f: fn(f64, f64) -> f64, x0: f64, (rtol, atol): (f64, f64), order: usize, h_max: f64) -> f64 {
        let system = FnSystem(|t: f64, x: &SVector<f64, 1>| SVector::from([f(t, x[0])]));
        let (x0, f0) = (SVector::from([x0]), SVector::from([f(1.0, x0)]));
        let (direction, h_max) = (h_max.signum(), h_max.abs());
        Tolerance { rtol, atol }.first_step(&system, (1.0, &x0, &f0), (order, h_max, direction))
    }

    fn assert_is(found: f64, expected: f64) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found:e} {expected:e}");
    }

    #[test]
    fn the_first_step_is_that_of_hairer() {
        // x' = 5 t - x^2 from 3: -4; atol + rtol |x| is 0.013. The trial step is 0.01 |x| / |x'| = 0.0075, with the
        // derivatives 5 * 1.0075 - 2.97^2 = -3.7834 forward, and 5 * 0.9925 - 3.03^2 = -4.2184 backward.
        let f = |t: f64, x: f64| 5.0 * t - x * x;
        let tolerance = (1e-3, 0.01);
        for (h_max, apart) in [(10.0, 4.0 - 3.7834), (-10.0, 4.2184 - 4.0)] {
            let slope: f64 = 4.0 / 0.013;
            let curvature: f64 = apart / 0.013 / 0.0075;
            assert!(curvature > slope);
            for order in [4, 8] {
                let expected = (0.01 / curvature).powf(1.0 / (order as f64 + 1.0));
                assert_is(first_step(f, 3.0, tolerance, order, h_max), expected);
            }
        }
        // at most h_max
        assert_is(first_step(f, 3.0, tolerance, 4, 0.001), 0.001);
        // an almost constant slope counts itself
        assert_is(
            first_step(|_, _| -7.0, 3.0, tolerance, 4, 10.0),
            (0.01_f64 * 0.013 / 7.0).powf(0.2),
        );
    }

    #[test]
    fn the_first_step_where_a_size_says_nothing() {
        let absolute = (0.0, 1.0);
        // from zero, or almost without slope, the trial step is 1e-6, and the first at most a hundred times as long
        assert_is(first_step(|_, _| 3.0, 0.0, absolute, 4, 10.0), 1e-4);
        assert_is(first_step(|_, _| 0.9e-5, 1.0, absolute, 4, 10.0), 1e-4);
        // sizes count from 1e-5 on: the trial step is 0.01 d0 / d1, the first (0.01 / d1)^(1/5) or 100 trial steps
        assert_is(first_step(|_, _| 1.0, 1e-5, absolute, 4, 10.0), 1e-5);
        assert_is(first_step(|_, _| 1e-5, 1.0, absolute, 4, 10.0), 1e3_f64.powf(0.2));
        // at rest, or almost
        assert_is(first_step(|_, _| 0.0, 1.0, absolute, 4, 10.0), 1e-6);
        assert_is(first_step(|_, _| 1e-15, 1.0, absolute, 4, 10.0), 1e-6);
        // where the trial step leaves the domain: a thousandth of it, which is 0.01
        assert_is(
            first_step(|t, _| if t > 1.0 { f64::NAN } else { 1.0 }, 1.0, absolute, 4, 10.0),
            1e-5,
        );
    }

    #[test]
    fn logarithm_and_power_are_good_enough() {
        for i in -3000..3000 {
            let x = 1.007_f64.powi(i) * 1.3;
            assert!((log2(x) - x.log2()).abs() < 1.2e-4, "{x}");
            let y = f64::from(i) * 0.0717;
            assert!((exp2(y) / y.exp2() - 1.0).abs() < 1.01e-4, "{y}");
        }
        assert!(log2(0.0) < -1000.0 && log2(f64::INFINITY) > 1000.0);
        assert!(exp2(f64::NAN).is_nan());
        // clamped to the range of exponents
        assert!((exp2(-1e9) / f64::MIN_POSITIVE - 1.0).abs() < 1.01e-4);
        assert!((exp2(1e9) / 1023.0_f64.exp2() - 1.0).abs() < 1.01e-4);
    }

    /// Factor after a step with the error `e`.
    fn next(controller: &mut PiController, e: f64) -> f64 {
        controller.next(e * e)
    }

    fn assert_near(found: f64, expected: f64) {
        // the accuracy of logarithm and power
        assert!((found / expected - 1.0).abs() < 2e-4, "{found} {expected}");
    }

    #[test]
    fn the_factor_is_that_of_gustafsson_with_the_constants_of_dopri5() {
        // 0.9 e^-alpha before^beta, with beta = 0.04 and alpha = 1/5 - 0.03
        let mut controller = PiController::new(4);
        assert_near(
            next(&mut controller, 0.5),
            0.9 * 0.5_f64.powf(-0.17) * 1e-4_f64.powf(0.04),
        );
        assert_near(
            next(&mut controller, 0.3),
            0.9 * 0.3_f64.powf(-0.17) * 0.5_f64.powf(0.04),
        );
        // a rejected step neither uses nor updates the last error
        assert_near(next(&mut controller, 4.0), 0.9 * 4.0_f64.powf(-0.17));
        assert_near(
            next(&mut controller, 0.9),
            0.9 * 0.9_f64.powf(-0.17) * 0.3_f64.powf(0.04),
        );
        // an error below 1e-4 counts as 1e-4 afterwards
        assert_near(
            next(&mut controller, 1e-3),
            0.9 * 1e-3_f64.powf(-0.17) * 0.9_f64.powf(0.04),
        );
        assert_near(next(&mut controller, 1e-6), 3.0);
        assert_near(
            next(&mut controller, 0.8),
            0.9 * 0.8_f64.powf(-0.17) * 1e-4_f64.powf(0.04),
        );
        controller.set_order(9);
        assert_near(
            next(&mut controller, 0.8),
            0.9 * 0.8_f64.powf(-0.07) * 0.8_f64.powf(0.04),
        );
    }

    #[test]
    fn an_error_of_one_is_accepted_and_shrinks_the_step_a_little() {
        let mut controller = PiController::new(4);
        controller.last = 0.0;
        assert_near(next(&mut controller, 1.0), 0.9);
        assert_eq!(controller.next(0.0), 3.0, "growth after a step that was accepted");
    }

    #[test]
    fn the_factor_keeps_its_bounds() {
        let mut controller = PiController::new(4);
        assert_eq!(controller.next(0.0), 3.0);
        assert_eq!(controller.next(1e300), 0.2);
        assert_eq!(controller.next(0.0), 1.0, "no growth after a rejection");
        assert_eq!(controller.next(0.0), 3.0);
        assert_eq!(controller.next(f64::NAN), 0.25);
        assert_eq!(controller.next(0.0), 1.0, "no growth after a failure");
    }
}
