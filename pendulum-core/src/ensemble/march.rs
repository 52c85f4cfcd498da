//! Trajectories on their way, and how long their steps are.

#![allow(private_interfaces, reason = "what is public here is in a private module")]

use std::ops::Range;

use nalgebra::SVector;

use super::watch::Watch;
use super::{Stopped, alone};
use crate::error::Reason;
use crate::method::{Adaptive, Estimates, Fixed, Grid, Method, StepControl};
use crate::real::Float;
use crate::step_size::Tolerance;
use crate::system::Cast;

/// Trajectories on their way from the states `x`, which are replaced, by the method `A`.
pub struct March<'a, A, M, T, W, const N: usize> {
    pub(super) method: &'a A,
    pub(super) models: &'a [M],
    pub(super) span: (T, T),
    pub(super) x: &'a mut [SVector<T, N>],
    /// Those that have not begun.
    pub(super) waiting: Range<usize>,
    pub(super) stopped: &'a mut Vec<Stopped<T>>,
    pub(super) watch: W,
}

impl<A, M, T, W, const N: usize> March<'_, A, M, T, W, N> {
    /// The same by another method.
    pub(super) fn by<'b, B>(self, method: &'b B) -> March<'b, B, M, T, W, N>
    where
        Self: 'b,
    {
        March {
            method,
            models: self.models,
            span: self.span,
            x: self.x,
            waiting: self.waiting,
            stopped: self.stopped,
            watch: self.watch,
        }
    }

    /// Brings all that have not begun to their ends, one after the other.
    pub(super) fn one_by_one(mut self)
    where
        A: Method<M::In<T>, T, N>,
        M: Cast<N>,
        T: Float,
        W: Watch<T, N>,
    {
        let waiting = self.waiting.clone();
        self.alone(waiting);
    }

    /// The same with some of them.
    pub(super) fn alone(&mut self, which: impl IntoIterator<Item = usize>)
    where
        A: Method<M::In<T>, T, N>,
        M: Cast<N>,
        T: Float,
        W: Watch<T, N>,
    {
        let states = (&mut *self.x, &mut self.watch);
        alone(self.method, self.models, self.span, which, states, self.stopped);
    }
}

/// How long the steps of trajectories are.
#[derive(Clone, Copy)]
pub(super) enum Pacing<T> {
    /// As long as the tolerance of each allows.
    Controlled(StepControl<T>),
    /// From one time of a grid to the next, for all of them.
    Equal(Grid<T>),
}

/// What the loops over lanes need to know of a method.
pub trait Paced<T: Float> {
    /// The kind of one-step method.
    type Family;

    /// The one-step method.
    fn family(&self) -> &Self::Family;

    /// The tolerance that its steps keep; `None` where their length is given.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting is out of its range.
    fn within(&self) -> Result<Option<Tolerance<T>>, Reason>;

    /// Checks settings for which no model is needed, and whether all points can be kept if they are to be.
    ///
    /// # Errors
    /// As for [`within`](Self::within).
    fn check(&self, _span: (T, T), _keeps_all: bool) -> Result<(), Reason> {
        Ok(())
    }

    /// How long its steps are.
    ///
    /// # Errors
    /// As for [`within`](Self::within).
    fn steps(&self, error_order: usize, span: (T, T)) -> Result<Pacing<T>, Reason>;
}

impl<F: Estimates, T: Float> Paced<T> for Adaptive<F> {
    type Family = F;

    fn family(&self) -> &F {
        &self.family
    }

    fn within(&self) -> Result<Option<Tolerance<T>>, Reason> {
        self.tolerance().map(Some)
    }

    fn steps(&self, error_order: usize, span: (T, T)) -> Result<Pacing<T>, Reason> {
        let control = self.control(self.tolerance()?, error_order, span)?;
        Ok(Pacing::Controlled(control))
    }
}

impl<F, T: Float> Paced<T> for Fixed<F> {
    type Family = F;

    fn family(&self) -> &F {
        &self.family
    }

    fn within(&self) -> Result<Option<Tolerance<T>>, Reason> {
        Ok(None)
    }

    fn check(&self, (t0, t1): (T, T), keeps_all: bool) -> Result<(), Reason> {
        let grid = Grid::new(self.h, t0, t1)?;
        if keeps_all { grid.check_to_keep() } else { Ok(()) }
    }

    fn steps(&self, _error_order: usize, (t0, t1): (T, T)) -> Result<Pacing<T>, Reason> {
        Grid::new(self.h, t0, t1).map(Pacing::Equal)
    }
}
