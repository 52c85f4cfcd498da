//! Accepted steps and their dense output.

use nalgebra::SVector;

use crate::real::{Float, Real};

/// Distance from the end of a step, in fractions of it, within which its polynomial is as accurate as the end itself.
pub(crate) const ABOUT_THE_END: f64 = 1e-3;

/// An accepted step from `(t0, x0)` to `(t1, x1)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<T, const N: usize> {
    /// Time at the start of the step.
    pub t0: T,
    /// Time at its end.
    pub t1: T,
    /// Length `t1 - t0`; negative backward in time.
    pub h: T,
    /// State at the start.
    pub x0: SVector<T, N>,
    /// State at the end.
    pub x1: SVector<T, N>,
}

impl<T: Real, const N: usize> Step<T, N> {
    #[inline(always)]
    pub(crate) fn new((t0, x0): (T, SVector<T, N>), (t1, x1): (T, SVector<T, N>)) -> Self {
        let h = t1 - t0;
        Self { t0, t1, h, x0, x1 }
    }

    /// Becomes the step from its end to this one. In place: a step that is built elsewhere is copied once more, as
    /// soon as it is written.
    #[inline(always)]
    pub(crate) fn go_on(&mut self, (t1, x1): (T, &SVector<T, N>)) {
        self.h = t1 - self.t1;
        self.t0 = self.t1;
        self.x0 = self.x1;
        self.t1 = t1;
        self.x1 = *x1;
    }

    /// A step of zero length.
    pub(crate) fn at_rest(t: T, x: SVector<T, N>) -> Self {
        Self::new((t, x), (t, x))
    }

    /// Size to which a time within the step is resolved: its own, or the length of the step near zero.
    pub(crate) fn scale(&self, t: T) -> T
    where
        T: Float,
    {
        t.abs().max(self.h.abs())
    }
}

/// Dense output: the states within a step, whose ends are in [`Step`].
#[derive(Clone, Copy, Debug)]
pub struct Dense<'a, T, const N: usize> {
    step: Step<T, N>,
    coefficients: &'a [SVector<T, N>],
    /// Fraction at which the step was cut off.
    cut: T,
    /// True for a step that was retaken up to an event.
    #[cfg(feature = "std")]
    is_retaken: bool,
}

impl<'a, T: Float, const N: usize> Dense<'a, T, N> {
    /// Dense output with the polynomial `x0 + c_1 theta + c_2 theta^2 + ..`, where `coefficients` are the vectors `c_1,
    /// c_2, ..` and `theta` is the fraction of the step.
    pub(crate) fn new(step: Step<T, N>, coefficients: &'a [SVector<T, N>]) -> Self {
        Self::cut_off(step, coefficients, T::from_f64(1.0))
    }

    /// Dense output of a step that was cut off at the fraction `cut` of the step of the coefficients.
    pub(crate) fn cut_off(step: Step<T, N>, coefficients: &'a [SVector<T, N>], cut: T) -> Self {
        Self {
            step,
            coefficients,
            cut,
            #[cfg(feature = "std")]
            is_retaken: false,
        }
    }

    /// The step.
    #[must_use]
    pub fn step(&self) -> &Step<T, N> {
        &self.step
    }

    /// State at the time `t`; extrapolated outside of the step.
    #[must_use]
    pub fn at(&self, t: T) -> SVector<T, N> {
        if t == self.step.t1 || self.coefficients.is_empty() {
            return self.step.x1;
        }
        polynomial(
            &self.step.x0,
            self.coefficients,
            (t - self.step.t0) / self.step.h * self.cut,
        )
    }

    /// State at a fraction of the step.
    pub(crate) fn at_fraction(&self, theta: T) -> SVector<T, N> {
        if theta == T::from_f64(1.0) {
            return self.step.x1;
        }
        if theta.is_zero() {
            return self.step.x0;
        }
        polynomial(&self.step.x0, self.coefficients, theta * self.cut)
    }

    /// State near the end of the step, `by` a fraction of the step after it (before it if negative). Adding a small
    /// change to the end has fewer rounding errors than evaluating the polynomial.
    pub(crate) fn about_end(&self, by: T) -> SVector<T, N> {
        let mut x = self.step.x1;
        let mut change = T::default();
        for coefficient in self.coefficients {
            // (1 + by)^k - 1
            change = change * (T::from_f64(1.0) + by) + by;
            x += coefficient * change;
        }
        x
    }

    /// Dense output of a step that may have been retaken up to an event: [about its end](Self::about_end) it is then as
    /// accurate as the end.
    #[cfg(feature = "std")]
    pub(crate) fn retaken(mut self, is_retaken: bool) -> Self {
        self.is_retaken = is_retaken;
        self
    }

    /// State at a fraction of the step where an event may be.
    #[cfg(feature = "std")]
    pub(crate) fn located(&self, theta: T) -> SVector<T, N> {
        let by = theta - T::from_f64(1.0);
        let is_end = !theta.is_constant() && by == T::default();
        if self.is_retaken && by.abs() <= T::from_f64(ABOUT_THE_END) || is_end {
            self.about_end(by)
        } else {
            self.at_fraction(theta)
        }
    }

    /// Time at a fraction of the step.
    pub(crate) fn time(&self, theta: T) -> T {
        let one = T::from_f64(1.0);
        if theta == one {
            return if theta.is_constant() {
                self.step.t1
            } else {
                self.step.t1 + (theta - one) * self.step.h
            };
        }
        self.step.t0 + theta * self.step.h
    }

    /// Coefficients, from the first power on, of the polynomial over the part of the step up to `theta`.
    #[cfg(feature = "std")]
    pub(crate) fn coefficients_to(&self, theta: T) -> impl Iterator<Item = SVector<T, N>> {
        let cut = theta * self.cut;
        let mut power = T::from_f64(1.0);
        self.coefficients.iter().map(move |coefficient| {
            power *= cut;
            coefficient * power
        })
    }

    /// True if the step was cut off.
    #[cfg(feature = "std")]
    pub(crate) fn is_cut_off(&self) -> bool {
        self.cut != T::from_f64(1.0)
    }

    /// Coefficients, from the first power on, of the polynomial over the whole step.
    pub(crate) fn terms(&self) -> &'a [SVector<T, N>] {
        self.coefficients
    }
}

/// Evaluates `x0 + c_1 theta + c_2 theta^2 + ..`. Odd and even powers are summed separately, which shortens the chain
/// of dependent additions.
///
/// Not in fused arithmetic: dense output is evaluated outside of steps, in code for the baseline.
#[inline(always)]
pub(crate) fn polynomial<T: Real, const N: usize>(
    x0: &SVector<T, N>,
    coefficients: &[SVector<T, N>],
    theta: T,
) -> SVector<T, N> {
    evaluate::<false, T, N>(x0, coefficients, theta)
}

/// [`polynomial`] in fused arithmetic, if `T` is fused, for steps.
#[inline(always)]
pub(crate) fn polynomial_of_step<T: Real, const N: usize>(
    x0: &SVector<T, N>,
    coefficients: &[SVector<T, N>],
    h: T,
) -> SVector<T, N> {
    evaluate::<true, T, N>(x0, coefficients, h)
}

#[inline(always)]
fn evaluate<const FUSED: bool, T: Real, const N: usize>(
    x0: &SVector<T, N>,
    coefficients: &[SVector<T, N>],
    theta: T,
) -> SVector<T, N> {
    // usually the position carries no derivatives
    if theta.is_constant() {
        sum::<FUSED, true, T, N>(x0, coefficients, theta)
    } else {
        sum::<FUSED, false, T, N>(x0, coefficients, theta)
    }
}

#[inline(always)]
fn sum<const FUSED: bool, const CONSTANT: bool, T: Real, const N: usize>(
    x0: &SVector<T, N>,
    coefficients: &[SVector<T, N>],
    theta: T,
) -> SVector<T, N> {
    let square = theta * theta;
    let (mut odd, mut even) = ([T::default(); N], [T::default(); N]);
    let (pairs, last) = coefficients.as_chunks::<2>();
    let mut pairs = pairs.iter().rev();
    match (pairs.next(), last) {
        (Some([first, second]), []) => (odd, even) = (first.data.0[0], second.data.0[0]),
        (Some([first, second]), [last, ..]) => {
            (odd, even) = (last.data.0[0], second.data.0[0]);
            onto::<FUSED, CONSTANT, T, N>(square, &mut odd, first);
        }
        (None, [last, ..]) => odd = last.data.0[0],
        (None, []) => {}
    }
    for [first, second] in pairs {
        onto::<FUSED, CONSTANT, T, N>(square, &mut odd, first);
        onto::<FUSED, CONSTANT, T, N>(square, &mut even, second);
    }
    let mut x = *x0;
    for (x, (&odd, &even)) in x.data.0[0].iter_mut().zip(odd.iter().zip(&even)) {
        let slope = add_product::<FUSED, CONSTANT, T>(theta, even, odd);
        *x = add_product::<FUSED, CONSTANT, T>(theta, slope, *x);
    }
    x
}

/// Replaces sums by `factor * sums + next`.
#[inline(always)]
fn onto<const FUSED: bool, const CONSTANT: bool, T: Real, const N: usize>(
    factor: T,
    sums: &mut [T; N],
    next: &SVector<T, N>,
) {
    for (sum, &next) in sums.iter_mut().zip(&next.data.0[0]) {
        *sum = add_product::<FUSED, CONSTANT, T>(factor, *sum, next);
    }
}

/// `factor * a + b`, where a constant factor carries no derivatives.
#[inline(always)]
fn add_product<const FUSED: bool, const CONSTANT: bool, T: Real>(factor: T, a: T, b: T) -> T {
    match (FUSED, CONSTANT) {
        (true, true) => a.scaled_onto(factor, b),
        (true, false) => factor.mul_add(a, b),
        (false, true) => a.scaled(factor) + b,
        (false, false) => factor * a + b,
    }
}
