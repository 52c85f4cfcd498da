//! The error of an integration whose points are stored.

use std::error::Error;
use std::fmt;

use nalgebra::SVector;

use super::{Reason, debug_as_display};
use crate::real::Float;
use crate::solution::Solution;

debug_as_display! { [T: Float, const N: usize] SolveError<T, N>; }

/// An integration that stopped early, with the solution up to there.
#[derive(Clone, PartialEq)]
pub struct SolveError<T, const N: usize> {
    /// Reason why it stopped.
    pub reason: Reason,
    /// Solution up to the last good state; the initial point alone if no step succeeded.
    ///
    /// For [`Reason::InvalidInput`] it is the initial point as given, valid or not.
    pub solution: Box<Solution<T, N>>,
}

impl<T: Float, const N: usize> SolveError<T, N> {
    /// Error of an integration that stopped before its first step.
    pub(crate) fn at_start(reason: Reason, t0: T, x0: SVector<T, N>) -> Self {
        Self {
            reason,
            solution: Box::new(Solution::start(t0, x0)),
        }
    }

    /// Last good time.
    #[must_use]
    pub fn t(&self) -> T {
        self.solution.last().0
    }

    /// Last good state.
    #[must_use]
    pub fn x(&self) -> SVector<T, N> {
        self.solution.end()
    }
}

impl<T: Float, const N: usize> fmt::Display for SolveError<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.reason {
            // an invalid input precedes the integration, and a bad reset contains its time
            Reason::InvalidInput { .. } | Reason::BadReset { .. } => self.reason.fmt(f),
            _ => write!(f, "stopped at t = {:?}: {}", self.t().to_f64(), self.reason),
        }
    }
}

impl<T: Float, const N: usize> Error for SolveError<T, N> {}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{Reason, SolveError};

    #[test]
    fn debug_reads_as_display() {
        let reason = Reason::NoConvergence { h: 0.3 };
        let error = SolveError::at_start(reason, 0.5, SVector::from([1.0]));
        assert_eq!(format!("{error:?}"), format!("stopped at t = 0.5: {reason}"));
    }
}
