//! Detection of components too small for the absolute tolerance.

use std::fmt;

use super::Solution;
use crate::real::Float;

/// Largest acceptable ratio of `atol` to the size of a component, per step: three digits.
const COARSE: f64 = 1e-3;
/// Least ratio of `atol` to the error allowed by `rtol` for a component to be reported.
const FAR_FROM_ASKED: f64 = 100.0;
/// Relative size, compared with the largest component, below which a component counts as rounding error of zero.
const ROUNDING: f64 = 1e-12;

/// A component of the state that moves, but is too small for the absolute tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BelowTolerance<T = f64> {
    /// Index in the state.
    pub component: usize,
    /// Largest magnitude.
    pub largest: T,
    /// Suitable absolute tolerance: the relative tolerance times the largest magnitude.
    pub atol: T,
}

impl<T: Float> fmt::Display for BelowTolerance<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (n, largest, atol) = (self.component, self.largest.to_f64(), self.atol.to_f64());
        write!(
            f,
            "x[{n}] is {largest:e} at most, and the absolute tolerance leaves it less than three digits; \
             set `atol({atol:.0e})`, or choose units in which it is larger"
        )
    }
}

impl<T: Float, const N: usize> Solution<T, N> {
    /// Components that are inaccurate because they are too small for `atol`. During the whole motion, the error per
    /// step that `atol` allows exceeds a thousandth of their largest magnitude, and 100 times the error that `rtol`
    /// allows. Empty if there are none, and for fixed steps.
    ///
    /// A component is listed if it moves, and either starts away from zero or all moving components are too small. A
    /// component that starts at zero beside larger motions and stays small is a perturbation caused by them; `atol` is
    /// meant for it. The same applies to components below 1e-12 of the largest one.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// let spring = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    /// let solution = Rk45::new().solve(&spring, 0.0, 10.0, [1e-9, 0.0])?;
    /// for below in solution.below_tolerance() {
    ///     println!("{below}");
    /// }
    /// assert_eq!(solution.below_tolerance().len(), 2);
    /// let solution = Rk45::new().atol(1e-15).solve(&spring, 0.0, 10.0, [1e-9, 0.0])?;
    /// assert!(solution.below_tolerance().is_empty());
    /// # Ok::<(), pendulum_core::SolveError<f64, 2>>(())
    /// ```
    #[must_use]
    pub fn below_tolerance(&self) -> Vec<BelowTolerance<T>> {
        let Some(tolerance) = self.tolerance else {
            return Vec::new();
        };
        let start = &self.x[0];
        let largest = |n: usize| self.x.iter().fold(T::default(), |largest, x| largest.max(x[n].abs()));
        let moves = |n: usize| self.x.iter().any(|x| x[n] != start[n]);
        let coarse = T::from_f64(COARSE).max(T::from_f64(FAR_FROM_ASKED) * tolerance.rtol);
        let bound = tolerance.atol / coarse;
        let moving: Vec<(usize, T)> = (0..N).filter(|&n| moves(n)).map(|n| (n, largest(n))).collect();
        let most = (0..N).map(largest).fold(T::default(), T::max);
        let all_are_small = moving.iter().all(|&(_, largest)| largest < bound);
        let is_meant = |n: usize| all_are_small || start[n] != T::default();
        moving
            .into_iter()
            .filter(|&(n, largest)| largest < bound && largest > T::from_f64(ROUNDING) * most && is_meant(n))
            .map(|(component, largest)| BelowTolerance {
                component,
                largest,
                atol: (tolerance.rtol * largest).max(T::MIN_POSITIVE),
            })
            .collect()
    }
}
