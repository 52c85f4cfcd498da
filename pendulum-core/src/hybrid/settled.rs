//! State and mode after a mode switch.

use nalgebra::SVector;

use super::mode::Mode;
use super::series::Series;
use super::sizes::{ForceSizes, Gains};
use super::witness::Witnesses;
use super::{Hold, MAX_CONSTRAINTS};
use crate::real::Float;

/// State and mode after a mode switch, from which the integration continues.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settled<T, const N: usize> {
    pub(crate) x: SVector<T, N>,
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// Duration of the rebounds that are not followed.
    pub(crate) delay: T,
    /// Impulses along the constraints.
    pub(crate) impulses: [T; MAX_CONSTRAINTS],
    pub(crate) gains: Gains<T, N>,
    pub(crate) sizes: ForceSizes<T>,
    /// Impacts so far at this instant.
    pub(super) series: Series<T, N>,
    /// Contacts that approach again: their impacts follow at once.
    pub(super) next: Witnesses,
}

impl<T: Float, const N: usize> Settled<T, N> {
    /// Contacts whose order mattered and was not resolved, with the differences of the state that it makes.
    pub(crate) fn ambiguity(&self) -> Option<(u8, SVector<T, N>)> {
        self.series.ambiguity
    }

    /// First contact that still approaches after all impacts: the contacts contradict each other.
    pub(crate) fn contradiction(&self) -> Option<usize> {
        (!self.next.is_empty()).then(|| self.next.first())
    }
}
