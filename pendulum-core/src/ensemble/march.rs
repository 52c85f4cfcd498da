//! Trajectories of an ensemble and their step sizes.

#![allow(private_interfaces, reason = "what is public here is in a private module")]

use std::ops::Range;

use nalgebra::SVector;

use super::watch::Watch;
use super::{Stopped, alone, model_of};
use crate::error::Reason;
use crate::method::{Adaptive, Estimates, Fixed, Grid, Method, Pace, StepControl};
use crate::real::{Float, Real};
use crate::step_size::Tolerance;
use crate::system::Cast;

/// Integration of trajectories from the states `x` by the method `A`. Their final states replace `x`.
pub struct March<'a, A, M: Cast<N>, T: Real, W, const N: usize> {
    pub(super) method: &'a A,
    pub(super) models: &'a [M],
    pub(super) checked: Checked<M, T, N>,
    pub(super) span: (T, T),
    pub(super) x: &'a mut [SVector<T, N>],
    /// Trajectories that have not started.
    pub(super) waiting: Range<usize>,
    pub(super) stopped: &'a mut Vec<Stopped<T>>,
    pub(super) watch: W,
    /// Step sizes at which the trajectories start and end, if they go on after the end of the span: `None` before their
    /// first step.
    pub(super) paces: Option<&'a mut [Option<Pace<T>>]>,
    /// True if the trajectories come from an earlier span.
    pub(super) goes_on: bool,
}

impl<A, M: Cast<N>, T: Real, W, const N: usize> March<'_, A, M, T, W, N> {
    /// Returns the same march with another method.
    pub(super) fn by<'b, B>(self, method: &'b B) -> March<'b, B, M, T, W, N>
    where
        Self: 'b,
    {
        March {
            method,
            models: self.models,
            checked: self.checked,
            span: self.span,
            x: self.x,
            waiting: self.waiting,
            stopped: self.stopped,
            watch: self.watch,
            paces: self.paces,
            goes_on: self.goes_on,
        }
    }

    /// Step size at which a trajectory goes on, if it has begun in an earlier span.
    pub(super) fn pace(&self, index: usize) -> Option<Pace<T>>
    where
        T: Copy,
    {
        self.paces.as_ref().and_then(|paces| paces[index])
    }

    /// Integrates all waiting trajectories to their ends, one by one.
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

    /// Integrates the trajectories `which` to their ends, one by one.
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

/// Model by which the start of a trajectory was checked last. All may have the same, and to convert it takes longer
/// than the check.
pub(super) struct Checked<M: Cast<N>, T: Real, const N: usize>(Option<(usize, M::In<T>)>);

impl<M: Cast<N>, T: Real, const N: usize> Checked<M, T, N> {
    /// Returns a place for a model.
    pub(super) fn none() -> Self {
        Self(None)
    }

    /// Returns the model of a trajectory.
    pub(super) fn by(&mut self, models: &[M], index: usize) -> &M::In<T> {
        let number = if models.len() == 1 { 0 } else { index };
        self.0.take_if(|last| last.0 != number);
        &self.0.get_or_insert_with(|| (number, model_of(models, index).cast())).1
    }
}

/// Step sizes of the trajectories.
#[derive(Clone, Copy)]
pub(super) enum Pacing<T> {
    /// Step sizes controlled by the error, separately for each trajectory.
    Controlled(StepControl<T>),
    /// Step sizes of a common grid.
    Equal(Grid<T>),
}

/// Properties of a method used by the loops over lanes.
pub trait Paced<T: Float> {
    /// The kind of one-step method.
    type Family;

    /// The one-step method.
    fn family(&self) -> &Self::Family;

    /// Tolerance of the step size control; `None` for fixed steps.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting is out of its range.
    fn within(&self) -> Result<Option<Tolerance<T>>, Reason>;

    /// Checks the settings that do not depend on the model. If `_keeps_all` is set, also checks that all points fit in
    /// memory.
    ///
    /// # Errors
    /// See [`within`](Self::within).
    fn check(&self, _span: (T, T), _keeps_all: bool) -> Result<(), Reason> {
        Ok(())
    }

    /// Step sizes over `span`.
    ///
    /// # Errors
    /// See [`within`](Self::within).
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
