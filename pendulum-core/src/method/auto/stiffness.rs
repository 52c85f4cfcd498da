//! Detection of stiffness.

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::linear::{image, square};
use crate::method::operations as count;
use crate::real::{Float, Real};

/// Fraction of the stability limit at which it limits the explicit steps: error estimates grow before the errors do
/// (with Verner's method of order 9 the fraction hovers about 0.6).
const AT_THE_LIMIT: f64 = 0.55;
/// Ratio of the error estimate to the bound of a smooth solution, as mean squares, above which stability limits the
/// steps. Where nothing is stiff, the median is at most 4e-4 with Tsitouras' method and 2e-5 with those of Verner; the
/// ratio exceeds 0.01 in single steps, as where friction turns.
const NOT_SMOOTH: f64 = 0.01;
/// Mean square of an error that does not limit the steps.
const NEGLIGIBLE: f64 = 1e-4;
/// Multiple of the stability limit from which a rejected first step is unstable rather than inaccurate. Later steps are
/// at most three times as long as stable ones.
const UNSTABLE: f64 = 10.0;
/// Number of steps per test.
const STEPS: usize = 2;
/// Number of steps at the limit that make a system stiff, without [`FREE`] others in a row between them. At the start
/// of a trajectory one is enough with loose tolerances.
const STIFF: usize = 8;
/// Number of steps in a row below the limit that reset the count, or that return to the explicit method.
const FREE: usize = 4;

/// Limits of `|h lambda|` for an explicit method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Limit of stability on the negative real axis.
    pub(crate) stable: f64,
    /// Limit up to which an implicit step could as well be explicit.
    pub(crate) free: f64,
}

/// Detection of stiffness from the steps so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stiffness {
    /// True while one step at the limit of stability is enough: at the start, with loose tolerances.
    is_eager: bool,
    /// True if the implicit method is active.
    pub(crate) is_stiff: bool,
    /// True if the other method takes the next step.
    pub(crate) changes: bool,
    /// True if the active method has not accepted a step.
    at_start: bool,
    /// True if the next step is tested.
    is_due: bool,
    /// Number of steps that stability limits.
    at_limit: usize,
    /// Number of steps in a row that are not.
    free: usize,
}

impl Stiffness {
    /// Detection from the start of a trajectory.
    pub(crate) fn new(is_eager: bool) -> Self {
        Self {
            is_eager,
            ..Self::default()
        }
    }

    /// Restarts the counts for the active method.
    pub(crate) fn begin(&mut self) {
        self.is_due = !self.is_stiff;
        (self.changes, self.at_start, self.at_limit, self.free) = (false, true, 0, 0);
    }

    /// Takes the step that was accepted last as tested, and returns true, for every second step, which then counts for
    /// two.
    #[inline(always)]
    pub(crate) fn takes_test(&mut self) -> bool {
        let is_tested = self.is_due;
        (self.is_due, self.at_start) = (!is_tested, false);
        is_tested
    }

    /// True if [`after_rejected`](Self::after_rejected) is to judge a rejected step.
    pub(crate) fn doubts_rejected(&self) -> bool {
        self.at_start && !self.is_stiff
    }

    /// Requests the implicit method if a rejected explicit step was far beyond the limit of stability.
    pub(crate) fn after_rejected(&mut self, measured: f64, limits: Limits) {
        self.changes = measured > UNSTABLE * limits.stable;
    }

    /// Counts tested explicit steps, and requests a switch after enough of them that stability limits. It does if
    /// `|h lambda|` is at the limit, or if the error estimate is larger than along a smooth solution: with fast modes
    /// that oscillate or are driven, estimates grow far below the limit. Errors are mean squares.
    pub(crate) fn after_explicit(&mut self, measured: f64, limits: Limits, [error, if_smooth]: [f64; 2]) {
        let is_unstable = measured > AT_THE_LIMIT * limits.stable;
        let is_not_smooth = if_smooth > 0.0 && error > NOT_SMOOTH * if_smooth;
        if is_unstable || is_not_smooth && error > NEGLIGIBLE {
            self.at_limit += STEPS;
            self.free = 0;
        } else {
            self.free += STEPS;
            if self.free >= FREE {
                self.at_limit = 0;
            }
        }
        self.is_eager &= is_unstable;
        self.changes = self.is_eager || self.at_limit >= STIFF;
    }

    /// Counts tested implicit steps, and requests a switch if explicit steps could have been as long for a while.
    pub(crate) fn after_implicit(&mut self, measured: f64, limits: Limits) {
        if measured <= limits.free {
            self.free += STEPS;
        } else {
            self.free = 0;
        }
        self.changes = self.free >= FREE;
        self.is_eager &= !self.changes;
    }
}

/// First vector of a power iteration, of length 1 and without padding.
pub(crate) fn even<T: Real, const N: usize>(active: usize) -> SVector<T, N> {
    let component = 1.0 / libm::sqrt(active as f64);
    SVector::from_fn(|n, _| T::from_f64(if n < active { component } else { 0.0 }))
}

/// Magnitude of the largest eigenvalue of a matrix, by two power iterations from `v` of length 1, which converges to
/// its eigenvector.
///
/// A complex pair makes `v` rotate; the mean over both iterations smooths its effect.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fastest_rate<T: Float, const N: usize>(
    matrix: &SMatrix<T, N, N>,
    v: &mut SVector<T, N>,
    active: usize,
) -> T {
    let mut product = T::from_f64(1.0);
    for _ in 0..2 {
        let image = image(matrix, v);
        let growth = square(&image).sqrt();
        if !(growth.is_finite() && growth > T::default()) {
            *v = even(active);
            return T::default();
        }
        product *= growth;
        *v = image * (T::from_f64(1.0) / growth);
    }
    product.sqrt()
}

/// Operations of [`fastest_rate`], and of its product with the length of a step.
pub(super) const fn of_fastest_rate(n: usize) -> Operations {
    let image = Operations::new(n * n, n * n, 0, 0, 0, n + 1);
    let growth = count::square(n).and(Operations::new(0, 0, 0, 0, 1, 20));
    let iteration = image
        .and(growth)
        .and(count::multiplied(n))
        .and(Operations::new(0, 1, 1, 0, 0, 5));
    iteration.times(2).and(Operations::new(0, 1, 0, 0, 2, 21))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};

    use super::{even, fastest_rate};

    #[test]
    fn the_fastest_rate_is_that_of_the_largest_eigenvalue() {
        let symmetric = SMatrix::<f64, 2, 2>::new(-3.0, 1.0, 1.0, -3.0);
        // almost the eigenvector of -2
        let mut v = SVector::from([1.0, 0.999]).normalize();
        for _ in 0..40 {
            fastest_rate(&symmetric, &mut v, 2);
        }
        assert!((fastest_rate(&symmetric, &mut v, 2) - 4.0).abs() < 1e-9);
        assert!((v.norm() - 1.0).abs() < 1e-12 && (v[0] + v[1]).abs() < 1e-9, "{v}");
        // a pair +-5 i: over two iterations the vector grows by 25 and makes half a turn
        let turning = SMatrix::<f64, 2, 2>::new(0.0, 50.0, -0.5, 0.0);
        assert!((fastest_rate(&turning, &mut v, 2) - 5.0).abs() < 1e-9);
    }

    #[test]
    fn what_shows_no_rate_is_left_for_another_direction() {
        let second = SMatrix::<f64, 2, 2>::new(0.0, 0.0, 0.0, -7.0);
        for mut v in [[1.0, 0.0], [0.0, 0.0], [f64::NAN, 1.0]].map(SVector::from) {
            assert_eq!(fastest_rate(&second, &mut v, 2), 0.0);
            assert_eq!(v, even::<f64, 2>(2));
            // 7 / sqrt(2), then 7
            assert!((fastest_rate(&second, &mut v, 2).powi(4) - 7.0_f64.powi(4) / 2.0).abs() < 1e-9);
            assert!((fastest_rate(&second, &mut v, 2) - 7.0).abs() < 1e-12);
        }
    }
}
