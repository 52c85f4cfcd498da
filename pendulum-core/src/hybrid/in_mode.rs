//! A system in one of its modes, and mode switches.

use nalgebra::{SMatrix, SVector};

use super::held::{self, pin, pressing, reduced};
use super::mode::Mode;
use super::witness::Witnesses;
use super::{Hold, MAX_CONSTRAINTS};
use crate::forward::forward_state;
use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{Canonical, Jacobian, System, by_state, by_time};
use crate::taylor::TaylorSeries;

/// A system restricted to one of its modes, as a smooth system that a [`Scheme`](crate::method::Scheme) integrates.
/// Systems that are not [hybrid](crate::hybrid) have only one mode.
#[derive(Debug)]
pub struct InMode<'a, S: ?Sized, T> {
    system: &'a S,
    hold: &'a Hold<T>,
}

impl<'a, S: ?Sized, T> InMode<'a, S, T> {
    /// Restricts `system` to the mode described by `hold`.
    #[inline(always)]
    pub fn new(system: &'a S, hold: &'a Hold<T>) -> Self {
        Self { system, hold }
    }

    /// The system and its hold.
    #[cfg(feature = "std")]
    #[inline(always)]
    pub(crate) fn parts(&self) -> (&'a S, &'a Hold<T>) {
        (self.system, self.hold)
    }
}

impl<S: ?Sized, T: Real> InMode<'_, S, T> {
    /// Sets the rates of held constraints to exactly zero in a state.
    #[inline(always)]
    pub(crate) fn pin<const N: usize>(&self, x: &mut SVector<T, N>)
    where
        S: System<T, N>,
    {
        if let Some(hybrid) = self.system.hybrid() {
            pin(hybrid, self.hold.held, x);
        }
    }
}

/// A mode switch: the point at which a mode ends and another begins.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    not(feature = "std"),
    expect(dead_code, reason = "analyses, which need std, read it")
)]
pub struct ModeSwitch<T, const N: usize> {
    pub(crate) t: T,
    /// State before, and the mode that ended.
    pub(crate) before: (SVector<T, N>, Mode, Hold<T>),
    /// Witnesses that ended it.
    pub(crate) fired: Witnesses,
    /// Impulses along the constraints.
    pub(crate) impulses: [T; MAX_CONSTRAINTS],
    /// State after, and the constraints held there.
    pub(crate) after: (SVector<T, N>, Hold<T>),
}

impl<S: System<T, N> + ?Sized, T: Real, const N: usize> System<T, N> for InMode<'_, S, T> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        let Some(hybrid) = self.system.hybrid() else {
            return self.system.rhs(t, x);
        };
        if T::LANES > 1 || self.hold.held == 0 {
            return hybrid.eval(t, x, &self.hold.forces);
        }
        held::rhs(hybrid, self.hold, t, x)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rhs_into(&self, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        match self.system.hybrid() {
            None => self.system.rhs_into(t, x, rates),
            Some(_) => *rates = self.rhs(t, x),
        }
    }

    #[inline(always)]
    fn is_apart(&self) -> bool {
        self.system.hybrid().is_none() && self.system.is_apart()
    }

    forward_state!(self => self.system);
}

impl<S: Jacobian<T, N> + ?Sized, T: Lanes, const N: usize> Jacobian<T, N> for InMode<'_, S, T> {
    #[inline(always)]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        match (self.system.hybrid(), self.system.hybrid_jacobian()) {
            (None, _) => self.system.jacobian(t, x),
            (_, Some(hybrid)) => held::rhs_and_jacobian(hybrid, self.hold, t, x).1,
            (_, None) => by_state(x, |x| self.rhs(t, x)),
        }
    }

    #[inline(always)]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        match (self.system.hybrid(), self.system.hybrid_jacobian()) {
            (None, _) => self.system.rhs_and_jacobian(t, x),
            (_, Some(hybrid)) => held::rhs_and_jacobian(hybrid, self.hold, t, x),
            (_, None) => (self.rhs(t, x), self.jacobian(t, x)),
        }
    }

    #[inline(always)]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        match (self.system.hybrid(), self.system.hybrid_jacobian()) {
            (None, _) => self.system.time_derivative(t, x),
            (_, Some(hybrid)) => held::time_derivative(hybrid, self.hold, t, x),
            (_, None) => by_time(self, t, |t| self.rhs(t, x)),
        }
    }
}

/// Holding a rate that is a sum of components removes a coordinate. The canonical variables are then the momenta of the
/// remaining coordinates, which holding forces do not enter, and the held rate, which stays zero, replaces the leftover
/// momentum. Forces along the constraints are held constant in the derivatives.
impl<S: Canonical<T, N> + ?Sized, T: Real, const N: usize> Canonical<T, N> for InMode<'_, S, T> {
    #[inline(always)]
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>) {
        let (Some(hybrid), Some(plant)) = (self.system.hybrid(), self.system.hybrid_canonical()) else {
            return self.system.canonical(t, x);
        };
        let forces = pressing(hybrid, self.hold, t, x);
        reduced(hybrid, self.hold.held, x, plant.eval_canonical(t, x, &forces))
    }

    #[inline(always)]
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>) {
        let (Some(hybrid), Some(plant)) = (self.system.hybrid(), self.system.hybrid_canonical()) else {
            return self.system.canonical_jacobian(t, x);
        };
        let forces = pressing(hybrid, self.hold, t, x);
        let identity = SMatrix::from_fn(|i, j| T::from_f64(f64::from(u8::from(i == j))));
        let both = plant.eval_canonical_jacobian(t, x, &forces);
        reduced(hybrid, self.hold.held, &identity, both)
    }
}

impl<S: TaylorSeries<T, N> + ?Sized, T: Real, const N: usize> TaylorSeries<T, N> for InMode<'_, S, T> {
    type Workspace = S::Workspace;

    #[inline(always)]
    fn workspace(&self) -> Self::Workspace {
        self.system.workspace()
    }

    #[inline(always)]
    fn series(&self, t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace) {
        match self.system.hybrid_series() {
            Some(hybrid) => hybrid.eval_series(self.hold, t, x, work),
            None => self.system.series(t, x, work),
        }
    }
}
