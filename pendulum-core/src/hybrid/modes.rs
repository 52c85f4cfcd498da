//! Mode of a system during an integration.

use nalgebra::SVector;

use super::ambiguity::Ambiguity;
use super::mode::Mode;
use super::project::project;
use super::watch::ModeWatch;
use super::witness::Witnesses;
use super::{Hold, MAX_CONSTRAINTS};
use crate::real::Float;
use crate::system::System;

/// Mode of a hybrid system. Meaningless for other systems.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Modes<T, const N: usize> {
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// Time at which the mode began.
    pub(crate) from: T,
    /// Impulses along the constraints at the beginning of the mode.
    pub(crate) impulses: [T; MAX_CONSTRAINTS],
    /// Impacts at the beginning whose order is ambiguous.
    pub(crate) ambiguity: Option<Ambiguity<T>>,
    pub(crate) watch: ModeWatch<T, N>,
    /// Witnesses that ended the mode where the last step ended.
    pub(crate) fired: Witnesses,
    /// Length of the last step as a fraction of the integrated one: less than 1 if a mode ended in it.
    pub(crate) cut: T,
    /// True if the dense output of the last step is available.
    pub(crate) is_dense: bool,
    /// Number of mode switches since some time, and that time.
    pub(crate) changes: (usize, T),
}

impl<T: Float, const N: usize> Modes<T, N> {
    /// Placeholder before the first mode is determined.
    pub(crate) fn none(t: T) -> Self {
        Self {
            mode: Mode::default(),
            hold: Hold::default(),
            from: t,
            impulses: [T::default(); MAX_CONSTRAINTS],
            ambiguity: None,
            watch: ModeWatch::new(),
            fired: Witnesses::default(),
            cut: T::from_f64(1.0),
            is_dense: false,
            changes: (0, t),
        }
    }

    /// Projects a state onto the constraints held by the mode.
    #[inline]
    pub(crate) fn place<S>(&self, system: &S, t: T, x: &mut SVector<T, N>)
    where
        S: System<T, N> + ?Sized,
    {
        if let Some(hybrid) = system.hybrid()
            && self.hold.held != 0
        {
            project(hybrid, &self.hold, &self.mode.0, t, x);
        }
    }
}
