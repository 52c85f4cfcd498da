//! Explicit Runge-Kutta methods with a fixed step.

use std::fmt;
use std::marker::PhantomData;

use nalgebra::SVector;

use crate::error::{Reason, SolveError};
use crate::method::Stepper;
use crate::method::grid::Grid;
use crate::method::input::check_start;
use crate::method::stepper::Pace;
use crate::real::Float;
use crate::solution::Solution;
use crate::system::System;
use crate::tableau::Tableau;

/// The explicit Runge-Kutta method of the tableau `B` with a fixed step; [`Rk4`](crate::Rk4) is one.
///
/// The steps end at the multiples `t0 + i h`, formed without summing up, and the last one is shortened so that it ends at
/// `t1` exactly.
pub struct Fixed<B, const STAGES: usize> {
    pub(crate) h: f64,
    tableau: PhantomData<B>,
}

impl<B: Tableau<STAGES>, const STAGES: usize> Fixed<B, STAGES> {
    /// The method with steps of length `h`, which is positive whatever the direction of time.
    #[must_use]
    pub const fn new(h: f64) -> Self {
        Self {
            h,
            tableau: PhantomData,
        }
    }

    /// Integrates `system` from the state `x0` at `t0` to `t1`, which may lie before `t0`.
    ///
    /// Where `t1 == t0` the solution is the initial point.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if `h` is not positive or not resolved by the time, or if times or state are not finite;
    /// [`Reason::NonFinite`]. The error holds the solution up to the last good state.
    pub fn solve<S, T, const N: usize>(
        &self,
        system: &S,
        t0: T,
        t1: T,
        x0: impl Into<SVector<T, N>>,
    ) -> Result<Solution<N, T>, SolveError<N, T>>
    where
        S: System<T, N> + ?Sized,
        T: Float,
    {
        let x0 = x0.into();
        match self.stepper(system, t0, t1, x0) {
            Ok(stepper) => stepper.collect(),
            Err(reason) => Err(SolveError::at_start(reason, t0, x0)),
        }
    }

    /// The same integration step by step, without a record and without a heap.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn stepper<'s, S, T, const N: usize>(
        &self,
        system: &'s S,
        t0: T,
        t1: T,
        x0: impl Into<SVector<T, N>>,
    ) -> Result<Stepper<'s, S, B, STAGES, N, T>, Reason>
    where
        S: System<T, N> + ?Sized,
        T: Float,
    {
        let x0 = x0.into();
        check_start(t0, t1, &x0)?;
        let grid = Grid::new(self.h, t0, t1)?;
        Stepper::new(system, t0, t1, x0, Pace::Fixed(grid))
    }
}

impl<B, const STAGES: usize> Clone for Fixed<B, STAGES> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<B, const STAGES: usize> Copy for Fixed<B, STAGES> {}

impl<B, const STAGES: usize> fmt::Debug for Fixed<B, STAGES> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Fixed").field("h", &self.h).finish()
    }
}
