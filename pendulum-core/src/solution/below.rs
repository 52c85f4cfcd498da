//! Components that are so small that the absolute tolerance hides them.

use std::fmt;

use super::Solution;
use crate::real::Float;

/// An absolute tolerance above this part of the largest size of a component is coarse: three digits in a step,
const COARSE: f64 = 1e-3;
/// unless the relative tolerance asks for no more than this many times better.
const FAR_FROM_ASKED: f64 = 100.0;
/// Components below this part of the largest one are what rounding errors leave of zero.
const ROUNDING: f64 = 1e-12;

/// A component of the state that moved, and was never larger than the absolute tolerance by enough to be accurate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BelowTolerance<T = f64> {
    /// Its index in the state.
    pub component: usize,
    /// Its largest size.
    pub largest: T,
    /// The absolute tolerance that would suit it: the relative tolerance times its largest size.
    pub atol: T,
}

impl<T: Float> fmt::Display for BelowTolerance<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (n, largest, atol) = (self.component, self.largest.to_f64(), self.atol.to_f64());
        write!(
            f,
            "x[{n}] is {largest:e} at most, and the absolute tolerance leaves it less than three digits; set `atol({atol:.0e})`, \
             or choose units in which it is larger"
        )
    }
}

impl<T: Float, const N: usize> Solution<T, N> {
    /// The components that are inaccurate because they are small: during the whole motion the error that `atol` allows
    /// in a step was more than a thousandth of their largest size, and more than 100 times what `rtol` allows of it.
    /// Empty where all is well, and for steps of given length.
    ///
    /// A component is listed if it moves, and either does not start at zero or is beside components all of which are
    /// that small or at rest. What starts at zero beside larger motions and stays small is a disturbance by those,
    /// for which absolute accuracy is meant; so is what is less than 1e-12 of the largest component.
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
