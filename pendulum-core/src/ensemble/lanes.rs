//! Methods that run in lanes, and the types they need.

use core::cell::Cell;

use nalgebra::{SMatrix, SVector};

use crate::error::Reason;
use crate::forward::{forward, forward_state};
use crate::hybrid::Hybrid;
use crate::layout::StateLayout;
use crate::linear::PerLane;
use crate::method::{
    Bounded, Carried, CarriedStages, Carry, Explicit, OneStep, PowerSeries, Rosenbrock, RosenbrockStages, SHORT,
    Scheme, SwitchInLanes, SwitchingFrom,
};
use crate::real::Real;
use crate::real::lanes::{LaneElement, Lanes};
use crate::step_size::Tolerance;
use crate::system::{Cast, CastJacobian, Jacobian, System};
use crate::tableau::{RosenbrockMethod, Tableau};
use crate::taylor::{CastTaylor, HybridSeries, TaylorSeries};

/// A kind of method whose [`Scheme`] works on lanes like on scalars.
pub trait InLanes<M: Cast<N>, T: LaneElement, const N: usize>: OneStep<M::In<T>, T, N> {
    /// True if a step keeps so many values that several registers per number gain nothing.
    const NARROW: bool;

    /// True if a step keeps little enough for four registers per number of a model that is [`WIDE`](Cast::WIDE).
    const WIDE: bool = false;

    /// True if lanes also integrate hybrid systems, while no constraint is held.
    const IN_MODES: bool = true;

    /// True if trajectories may [leave](Self::leaves) their lanes.
    const LEAVES: bool = false;

    /// Working memory of a step in lanes.
    type Stages<V: Lanes<Scalar = T>>: Scheme<Expanded<M, V, N>, V, N>;

    /// [`OneStep::scheme`] in lanes. `is_dense` is true if dense output will be requested.
    ///
    /// # Errors
    /// See [`OneStep::scheme`].
    fn stages<V: Lanes<Scalar = T>>(
        &self,
        system: &Expanded<M, V, N>,
        tolerance: Option<Tolerance<T>>,
        is_dense: bool,
    ) -> Result<Self::Stages<V>, Reason>;

    /// True if the trajectory in a lane must continue [alone](Self::alone) from its present point.
    #[inline(always)]
    fn leaves<V: Lanes<Scalar = T>>(_stages: &Self::Stages<V>, _lane: usize) -> bool {
        false
    }

    /// Scheme of a trajectory that leaves its lane. It begins anew.
    ///
    /// # Errors
    /// See [`OneStep::scheme`].
    fn alone(&self, system: &M::In<T>, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        self.scheme(system, tolerance)
    }
}

impl<M, B, T, const STAGES: usize, const N: usize> InLanes<M, T, N> for Explicit<B, STAGES>
where
    M: Cast<N>,
    B: Tableau<STAGES>,
    T: LaneElement,
{
    const NARROW: bool = N > SHORT;
    const WIDE: bool = true;
    type Stages<V: Lanes<Scalar = T>> = <Self as OneStep<Expanded<M, V, N>, V, N>>::Scheme;

    #[inline(always)]
    fn stages<V: Lanes<Scalar = T>>(
        &self,
        system: &Expanded<M, V, N>,
        tolerance: Option<Tolerance<T>>,
        is_dense: bool,
    ) -> Result<Self::Stages<V>, Reason> {
        let mut stages = OneStep::<Expanded<M, V, N>, V, N>::scheme(self, system, tolerance)?;
        stages.keep_stages(is_dense);
        Ok(stages)
    }
}

impl<M, T, const N: usize> InLanes<M, T, N> for PowerSeries
where
    M: CastTaylor<N>,
    M::In<T>: TaylorSeries<T, N>,
    T: LaneElement,
{
    const NARROW: bool = true;
    type Stages<V: Lanes<Scalar = T>> = <Self as OneStep<Expanded<M, V, N>, V, N>>::Scheme;

    #[inline(always)]
    fn stages<V: Lanes<Scalar = T>>(
        &self,
        system: &Expanded<M, V, N>,
        tolerance: Option<Tolerance<T>>,
        _is_dense: bool,
    ) -> Result<Self::Stages<V>, Reason> {
        OneStep::<Expanded<M, V, N>, V, N>::scheme(self, system, tolerance)
    }
}

/// A model in the number type `T`, and memory for its right-hand side. Bounds on `M` alone imply that it has its
/// [`TaylorSeries`], or its [`Jacobian`], in all number types.
pub struct Expanded<M: Cast<N>, T: Real, const N: usize>(M::In<T>, Cell<Vec<T>>);

impl<M: Cast<N>, V: Lanes, const N: usize> Expanded<M, V, N> {
    /// Combines one model per lane.
    #[inline(always)]
    pub(super) fn gather<'m>(models: impl Fn(usize) -> &'m M) -> Self
    where
        M: 'm,
    {
        Self(M::gather(models), Cell::default())
    }
}

impl<M: Cast<N>, T: Real, const N: usize> System<T, N> for Expanded<M, T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rhs_into(&self, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        if const { !M::WIDE } {
            return self.0.rhs_into(t, x, rates);
        }
        // memory of its own: a lock would wait until everything before it is stored
        let mut memory = self.1.take();
        self.0.rhs_with(&mut memory, t, x, rates);
        self.1.set(memory);
    }

    forward! { self => self.0;
        rhs(t: T, x: &SVector<T, N>) -> SVector<T, N>;
        hybrid() -> Option<&dyn Hybrid<T, N>>;
    }
    forward_state!(self => self.0);
}

impl<M: CastTaylor<N>, T: Real, const N: usize> TaylorSeries<T, N> for Expanded<M, T, N> {
    type Workspace = M::Workspace<T>;

    forward! { self => M::with_series(&self.0);
        workspace() -> Self::Workspace;
        series(t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace);
        hybrid_series() -> Option<&dyn HybridSeries<T, N, Workspace = Self::Workspace>>;
    }
}

impl<M, B, T, const STAGES: usize, const N: usize> InLanes<M, T, N> for Rosenbrock<B, STAGES>
where
    M: CastJacobian<N>,
    M::In<T>: Jacobian<T, N>,
    B: RosenbrockMethod<STAGES>,
    T: LaneElement,
{
    const NARROW: bool = true;
    // The generated derivatives in modes are never inlined.
    const IN_MODES: bool = false;
    type Stages<V: Lanes<Scalar = T>> = RosenbrockStages<B, V, STAGES, N, PerLane<V, N>>;

    #[inline(always)]
    fn stages<V: Lanes<Scalar = T>>(
        &self,
        _system: &Expanded<M, V, N>,
        tolerance: Option<Tolerance<T>>,
        _is_dense: bool,
    ) -> Result<Self::Stages<V>, Reason> {
        Ok(RosenbrockStages::new(tolerance))
    }
}

impl<M: CastJacobian<N>, T: Real, const N: usize> Jacobian<T, N> for Expanded<M, T, N> {
    #[inline(always)]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        // The Jacobian alone need not be inlined.
        self.rhs_and_jacobian(t, x).1
    }

    forward! { self => M::with_jacobian(&self.0);
        rhs_and_jacobian(t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>);
        time_derivative(t: T, x: &SVector<T, N>) -> SVector<T, N> where T: Lanes;
    }
}

impl<M, B, I, T, const STAGES: usize, const STIFF: usize, const N: usize> InLanes<M, T, N>
    for SwitchingFrom<B, I, STAGES, STIFF>
where
    M: CastJacobian<N>,
    B: Bounded<STAGES>,
    I: RosenbrockMethod<STIFF>,
    M::In<T>: Jacobian<T, N>,
    T: LaneElement,
{
    const NARROW: bool = true;
    const IN_MODES: bool = false;
    const LEAVES: bool = true;
    type Stages<V: Lanes<Scalar = T>> = SwitchInLanes<B, I, V, STAGES, STIFF, N>;

    #[inline(always)]
    fn stages<V: Lanes<Scalar = T>>(
        &self,
        system: &Expanded<M, V, N>,
        tolerance: Option<Tolerance<T>>,
        _is_dense: bool,
    ) -> Result<Self::Stages<V>, Reason> {
        SwitchInLanes::new(system, tolerance)
    }

    #[inline(always)]
    fn leaves<V: Lanes<Scalar = T>>(stages: &Self::Stages<V>, lane: usize) -> bool {
        stages.leaves(lane)
    }

    fn alone(&self, system: &M::In<T>, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        Self::stiff(system, tolerance)
    }
}

impl<M, C, B, T, const STAGES: usize, const K: usize, const N: usize> InLanes<M, T, N> for Carried<C, B, STAGES, K>
where
    M: CastJacobian<N>,
    M::In<T>: Jacobian<T, N>,
    C: Carry<T, K, N>,
    B: Tableau<STAGES>,
    T: LaneElement,
{
    const NARROW: bool = true;
    const IN_MODES: bool = false;
    type Stages<V: Lanes<Scalar = T>> = CarriedStages<C, B, V, STAGES, K, N>;

    #[inline(always)]
    fn stages<V: Lanes<Scalar = T>>(
        &self,
        system: &Expanded<M, V, N>,
        tolerance: Option<Tolerance<T>>,
        _is_dense: bool,
    ) -> Result<CarriedStages<C, B, V, STAGES, K, N>, Reason> {
        let state = Explicit::<B, STAGES>::new().scheme(system, tolerance)?;
        Ok(CarriedStages::new(state, tolerance, self.carry))
    }
}
