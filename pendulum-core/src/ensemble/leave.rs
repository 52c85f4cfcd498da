//! Trajectories that leave their lanes early.

use nalgebra::SVector;

use super::march::{March, Pacing};
use super::members::Members;
use crate::dense::Step;
use crate::hybrid::{Hold, Hybrid};
use crate::real::lanes::Lanes;
use crate::system::{Cast, System};

/// Strategy for trajectories to leave their lanes early and continue alone for a while.
pub(super) trait Leave<A, M: Cast<N>, V: Lanes, W, const N: usize> {
    /// True if trajectories may leave early.
    const ASKS: bool;

    /// Initial state, before any trajectory has entered.
    fn none() -> Self;

    /// Fills free lanes. Returns true if any trajectory entered.
    fn enter(
        &mut self,
        march: &mut March<'_, A, M, V::Scalar, W, N>,
        members: &mut Members<V::Scalar>,
        x: &mut SVector<V, N>,
        steps: (&mut Pacing<V::Scalar>, &Pacing<V::Scalar>),
    ) -> bool;

    /// Prepares for the trajectories that have entered.
    fn begin<S: System<V, N>>(&mut self, _system: &S) {}

    /// Held constraints of the lanes.
    fn hold(&self) -> &Hold<V>;

    /// Removes trajectories that must retake the step alone.
    fn check(
        &mut self,
        _march: &mut March<'_, A, M, V::Scalar, W, N>,
        _members: &mut Members<V::Scalar>,
        _steps: &Pacing<V::Scalar>,
        _step: (&dyn Hybrid<V, N>, &Step<V, N>, &[SVector<V, N>]),
    ) {
    }
}
