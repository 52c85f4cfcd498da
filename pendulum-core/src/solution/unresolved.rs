//! Detection of motion that fixed steps are too long to resolve.

use std::fmt;

use nalgebra::SVector;

use super::Solution;
use crate::real::Float;

/// Least ratio of the last coefficient of the dense output to the first, both as means over the steps, above which
/// steps are too long: for `Rk4` and an oscillation of angular frequency `w` it is exceeded from `w h = 1.3` on.
const NOT_SMALL: f64 = 0.25;
/// Relative size, compared with the largest component, below which changes per step count as rounding errors.
const ROUNDING: f64 = 1e-12;

/// A component of the state that changes faster than fixed steps resolve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unresolved<T = f64> {
    /// Index in the state.
    pub component: usize,
    /// Longest step of the solution.
    pub h: T,
}

impl<T: Float> fmt::Display for Unresolved<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (n, h) = (self.component, self.h.to_f64());
        write!(
            f,
            "x[{n}] changes faster than steps of {h} resolve, so that its values are wrong; \
             use shorter steps, or an adaptive method"
        )
    }
}

impl<T: Float, const N: usize> Solution<T, N> {
    /// Components that change faster than fixed steps resolve, so that their values are wrong. Empty if there are none,
    /// and for adaptive methods, which choose their steps.
    ///
    /// A component is listed if its rate varies within a step about as much as over the whole motion, on average over
    /// the steps. This finds steps that are far too long, not inaccurate ones: to estimate the error, compare with half
    /// the step.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// let pendulum = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -9.81 * x[0].sin()]));
    /// let solution = Rk4::new(50.0).solve(&pendulum, 0.0, 1000.0, [1.0, 0.0])?;
    /// for unresolved in solution.unresolved() {
    ///     println!("{unresolved}");
    /// }
    /// assert!(!solution.unresolved().is_empty());
    /// let solution = Rk4::new(0.05).solve(&pendulum, 0.0, 1000.0, [1.0, 0.0])?;
    /// assert!(solution.unresolved().is_empty());
    /// # Ok::<(), pendulum_core::SolveError<f64, 2>>(())
    /// ```
    #[must_use]
    pub fn unresolved(&self) -> Vec<Unresolved<T>> {
        if self.tolerance.is_some() {
            return Vec::new();
        }
        let steps = || {
            let starts = std::iter::once(0).chain(self.ends.iter().copied());
            starts
                .zip(&self.ends)
                .map(|(start, &end)| &self.coefficients[start..end])
        };
        // sums over the steps, of the same number of terms
        let sum = |of: fn(&[SVector<T, N>]) -> Option<&SVector<T, N>>, n: usize| {
            steps().filter_map(of).fold(T::default(), |sum, x| sum + x[n].abs())
        };
        let most = self
            .x
            .iter()
            .fold(T::default(), |most, x| x.iter().fold(most, |most, x| most.max(x.abs())));
        let count = T::from_f64(self.ends.len() as f64);
        let is_unresolved = |n: usize| {
            let first = sum(<[_]>::first, n);
            first > T::from_f64(ROUNDING) * most * count && sum(<[_]>::last, n) > T::from_f64(NOT_SMALL) * first
        };
        let lengths = self.t.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let h = lengths.fold(T::default(), T::max);
        let components = (0..N).filter(|&n| is_unresolved(n));
        components.map(|component| Unresolved { component, h }).collect()
    }
}
