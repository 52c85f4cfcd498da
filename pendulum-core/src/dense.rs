//! One accepted step, and the states within it.

use nalgebra::SVector;

use crate::real::{Float, Real};

/// An accepted step from `(t0, x0)` to `(t1, x1)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<T, const N: usize> {
    /// The time at which the step starts.
    pub t0: T,
    /// The time at which it ends.
    pub t1: T,
    /// Its length `t1 - t0`; negative backward in time.
    pub h: T,
    /// The state at its start.
    pub x0: SVector<T, N>,
    /// The state at its end.
    pub x1: SVector<T, N>,
}

impl<T: Real, const N: usize> Step<T, N> {
    #[inline(always)]
    pub(crate) fn new((t0, x0): (T, SVector<T, N>), (t1, x1): (T, SVector<T, N>)) -> Self {
        let h = t1 - t0;
        Self { t0, t1, h, x0, x1 }
    }

    /// A step of no length.
    pub(crate) fn at_rest(t: T, x: SVector<T, N>) -> Self {
        Self::new((t, x), (t, x))
    }
}

/// The states within a step: dense output, of which [`Step`] holds the ends.
#[derive(Clone, Copy, Debug)]
pub struct Dense<'a, T, const N: usize> {
    step: Step<T, N>,
    coefficients: &'a [SVector<T, N>],
    /// The fraction at which the step was cut off.
    cut: T,
}

impl<'a, T: Float, const N: usize> Dense<'a, T, N> {
    /// `coefficients` are the vectors `c_1, c_2, ..` of `x0 + c_1 theta + c_2 theta^2 + ..`, `theta` the fraction of
    /// the step.
    pub(crate) fn new(step: Step<T, N>, coefficients: &'a [SVector<T, N>]) -> Self {
        Self {
            step,
            coefficients,
            cut: T::from_f64(1.0),
        }
    }

    /// Of a step that was cut off at the fraction `cut` of the one that the coefficients are for.
    pub(crate) fn cut_off(step: Step<T, N>, coefficients: &'a [SVector<T, N>], cut: T) -> Self {
        Self {
            step,
            coefficients,
            cut,
        }
    }

    /// The step.
    #[must_use]
    pub fn step(&self) -> &Step<T, N> {
        &self.step
    }

    /// The state at the time `t`; outside of the step it is extrapolated.
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

    /// The state at a fraction of the step.
    pub(crate) fn at_fraction(&self, theta: T) -> SVector<T, N> {
        if theta == T::from_f64(1.0) {
            return self.step.x1;
        }
        polynomial(&self.step.x0, self.coefficients, theta * self.cut)
    }

    /// The state shortly after the end of the step, or before it, by a fraction of the step: the end and a small change,
    /// which has fewer rounding errors than the polynomial there.
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

    /// The time at a fraction of the step.
    pub(crate) fn time(&self, theta: T) -> T {
        if theta == T::from_f64(1.0) {
            return self.step.t1;
        }
        self.step.t0 + theta * self.step.h
    }

    /// The coefficients of the polynomial in the fraction of the part of the step up to `theta`, from the first power on.
    #[cfg(feature = "std")]
    pub(crate) fn coefficients_to(&self, theta: T) -> impl Iterator<Item = SVector<T, N>> {
        let cut = theta * self.cut;
        let mut power = T::from_f64(1.0);
        self.coefficients.iter().map(move |coefficient| {
            power *= cut;
            coefficient * power
        })
    }

    /// Whether it is a part of the step that the coefficients are for.
    #[cfg(feature = "std")]
    pub(crate) fn is_cut_off(&self) -> bool {
        self.cut != T::from_f64(1.0)
    }

    /// The coefficients of the polynomial in the fraction of the whole step, from the first power on.
    pub(crate) fn terms(&self) -> &'a [SVector<T, N>] {
        self.coefficients
    }
}

/// `x0 + c_1 theta + c_2 theta^2 + ..`; the odd and the even powers by themselves, since each step of a sum waits for
/// the one before.
#[inline(always)]
pub(crate) fn polynomial<T: Real, const N: usize>(
    x0: &SVector<T, N>,
    coefficients: &[SVector<T, N>],
    theta: T,
) -> SVector<T, N> {
    let square = theta * theta;
    let (mut odd, mut even) = ([T::default(); N], [T::default(); N]);
    for pair in coefficients.chunks(2).rev() {
        for (odd, &coefficient) in odd.iter_mut().zip(&pair[0].data.0[0]) {
            *odd = *odd * square + coefficient;
        }
        for (even, &coefficient) in even.iter_mut().zip(pair.get(1).iter().flat_map(|pair| &pair.data.0[0])) {
            *even = *even * square + coefficient;
        }
    }
    let mut x = *x0;
    for (x, (&odd, &even)) in x.data.0[0].iter_mut().zip(odd.iter().zip(&even)) {
        *x += theta * (odd + theta * even);
    }
    x
}
