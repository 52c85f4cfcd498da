//! The state and the mode from which to go on.

use nalgebra::SVector;

use super::mode::Mode;
use super::series::Series;
use super::sizes::{ForceSizes, Gains};
use super::witness::Witnesses;
use super::{Hold, MAX_CONSTRAINTS};
use crate::real::Float;

/// The state and the mode from which to go on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settled<T, const N: usize> {
    pub(crate) x: SVector<T, N>,
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// Duration of the rebounds that are not followed.
    pub(crate) delay: T,
    /// The impulses along the constraints.
    pub(crate) impulses: [T; MAX_CONSTRAINTS],
    pub(crate) gains: Gains<T, N>,
    pub(crate) sizes: ForceSizes<T>,
    /// The impacts so far, and the contacts that approach again: theirs follow at once.
    pub(super) series: Series<T, N>,
    pub(super) next: Witnesses,
}

impl<T: Float, const N: usize> Settled<T, N> {
    /// The contacts whose order mattered and was not resolved, with the differences that it makes to the state.
    pub(crate) fn ambiguity(&self) -> Option<(u8, SVector<T, N>)> {
        self.series.ambiguity
    }

    /// The first of the contacts that approach after all impacts: they contradict each other.
    pub(crate) fn contradiction(&self) -> Option<usize> {
        (!self.next.is_empty()).then(|| self.next.first())
    }
}
