//! Trajectories that leave their lanes before they end.

use nalgebra::SVector;

use super::march::{March, Pacing};
use super::members::Members;
use crate::dense::Step;
use crate::hybrid::{Hold, Hybrid};
use crate::real::lanes::Lanes;
use crate::system::System;

/// Which trajectories leave their lanes before they end, to go on alone for a while.
pub(super) trait Leave<A, M, V: Lanes, W, const N: usize> {
    /// Whether any does.
    const ASKS: bool;

    /// Before any has entered.
    fn none() -> Self;

    /// Trajectories take the lanes that are free: whether there were any.
    fn enter(
        &mut self,
        march: &mut March<'_, A, M, V::Scalar, W, N>,
        members: &mut Members<V::Scalar>,
        x: &mut SVector<V, N>,
        steps: (&mut Pacing<V::Scalar>, &Pacing<V::Scalar>),
    ) -> bool;

    /// Goes on with those that have entered.
    fn begin<S: System<V, N>>(&mut self, _system: &S) {}

    /// What is held in the lanes.
    fn hold(&self) -> &Hold<V>;

    /// Takes those out of their lanes that must take the step again alone.
    fn check(
        &mut self,
        _march: &mut March<'_, A, M, V::Scalar, W, N>,
        _members: &mut Members<V::Scalar>,
        _steps: &Pacing<V::Scalar>,
        _step: (&dyn Hybrid<V, N>, &Step<V, N>, &[SVector<V, N>]),
    ) {
    }
}
