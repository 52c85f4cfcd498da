//! The mode of a system on its way.

use nalgebra::SVector;

use super::ambiguity::Ambiguity;
use super::mode::Mode;
use super::project::project;
use super::watch::ModeWatch;
use super::witness::Witnesses;
use super::{Hold, MAX_CONSTRAINTS};
use crate::real::Float;
use crate::system::System;

/// The mode of a hybrid system; of no meaning for others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Modes<T, const N: usize> {
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// From when on it holds.
    pub(crate) from: T,
    /// The impulses along the constraints with which it began.
    pub(crate) impulses: [T; MAX_CONSTRAINTS],
    /// The impacts among these whose order is not known.
    pub(crate) ambiguity: Option<Ambiguity<T>>,
    pub(crate) watch: ModeWatch<T, N>,
    /// What ended it, where the last step ended.
    pub(crate) fired: Witnesses,
    /// Of the last step, the fraction of what was integrated: less than one where a mode ended.
    pub(crate) cut: T,
    /// Whether the dense output of the last step is known.
    pub(crate) is_dense: bool,
    /// How often modes have changed since some time, and that time.
    pub(crate) changes: (usize, T),
}

impl<T: Float, const N: usize> Modes<T, N> {
    /// Before the first mode is known.
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

    /// Puts a state to where the mode holds it.
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
