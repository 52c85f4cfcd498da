//! Selects the methods that run in lanes; the others integrate trajectories one by one.

use super::lanes::InLanes;
use super::march::{March, Paced};
use super::watch::Watch;
use crate::error::Reason;
use crate::method::{
    Adaptive, Carried, Estimates, Explicit, Fixed, Gauss, MethodPair, OneStep, PowerSeries, RadauIIA, Rosenbrock,
    Switching, SwitchingFrom,
};
use crate::real::lanes::{Isa, LaneElement};
use crate::system::{Cast, CastJacobian, Jacobian};
use crate::tableau::{HairerWanner4, Steinebach5, Tsitouras5, Verner7, Verner9};

/// A kind of method for ensembles. By default it integrates trajectories one by one; methods [`InLanes`] override this.
pub trait Together<M: Cast<N>, T: LaneElement, const N: usize>: OneStep<M::In<T>, T, N> + Sized {
    /// True if lanes can continue a trajectory of which they have the state and the step size: a step depends on
    /// nothing else.
    #[doc(hidden)]
    const GOES_ON: bool = false;

    /// Integrates with steps controlled by a tolerance.
    #[doc(hidden)]
    fn within_tolerance<W>(_isa: Isa, march: March<'_, Adaptive<Self>, M, T, W, N>) -> Result<(), Reason>
    where
        Self: Estimates,
        W: Watch<T, N>,
    {
        march.one_by_one();
        Ok(())
    }

    /// Integrates with steps of equal size.
    #[doc(hidden)]
    fn on_grid<W>(_isa: Isa, march: March<'_, Fixed<Self>, M, T, W, N>) -> Result<(), Reason>
    where
        W: Watch<T, N>,
    {
        march.one_by_one();
        Ok(())
    }
}

macro_rules! in_lanes {
    ($([$($generics:tt)*] $family:ty;)*) => { $(
        impl<M, T, $($generics)* const N: usize> Together<M, T, N> for $family
        where
            M: Cast<N>,
            T: LaneElement,
            Self: InLanes<M, T, N>,
        {
            const GOES_ON: bool = true;

            fn within_tolerance<W>(isa: Isa, march: March<'_, Adaptive<Self>, M, T, W, N>) -> Result<(), Reason>
            where
                Self: Estimates,
                W: Watch<T, N>,
            {
                isa.run(march)
            }

            fn on_grid<W>(isa: Isa, march: March<'_, Fixed<Self>, M, T, W, N>) -> Result<(), Reason>
            where
                W: Watch<T, N>,
            {
                isa.run(march)
            }
        }
    )* };
}

macro_rules! one_by_one {
    ($([$($generics:tt)*] $family:ty;)*) => { $(
        impl<M, T, $($generics)* const N: usize> Together<M, T, N> for $family
        where
            M: Cast<N>,
            T: LaneElement,
            Self: OneStep<M::In<T>, T, N>,
        {
        }
    )* };
}

in_lanes! {
    [B, const STAGES: usize,] Explicit<B, STAGES>;
    [B, const STAGES: usize,] Rosenbrock<B, STAGES>;
    [] PowerSeries;
    [C, B, const STAGES: usize, const K: usize,] Carried<C, B, STAGES, K>;
}

impl<M, T, const N: usize> Together<M, T, N> for Switching
where
    M: CastJacobian<N>,
    M::In<T>: Jacobian<T, N>,
    T: LaneElement,
{
    fn within_tolerance<W>(isa: Isa, march: March<'_, Adaptive<Self>, M, T, W, N>) -> Result<(), Reason>
    where
        W: Watch<T, N>,
    {
        let method = march.method;
        match MethodPair::within(Some(&method.tolerance::<T>()?)) {
            MethodPair::Tsit5Rodas4 => {
                isa.run(march.by(&method.by(SwitchingFrom::<Tsitouras5, HairerWanner4, 7, 6>::new())))
            }
            MethodPair::Vern7Rodas4 => {
                isa.run(march.by(&method.by(SwitchingFrom::<Verner7, HairerWanner4, 11, 6>::new())))
            }
            MethodPair::Vern7Rodas5P => {
                isa.run(march.by(&method.by(SwitchingFrom::<Verner7, Steinebach5, 11, 8>::new())))
            }
            // what turns stiff with tight tolerances leaves its lane
            MethodPair::Vern9Rodas5P | MethodPair::Vern9Radau13 => {
                isa.run(march.by(&method.by(SwitchingFrom::<Verner9, Steinebach5, 17, 8>::new())))
            }
        }
    }
}

one_by_one! {
    [const STAGES: usize, const PAIRS: usize,] RadauIIA<STAGES, PAIRS>;
    [const STAGES: usize, const PAIRS: usize,] Gauss<STAGES, PAIRS>;
}

/// A method for ensembles.
pub trait Marches<M: Cast<N>, T: LaneElement, const N: usize>: Paced<T> + Sized {
    /// True if lanes can continue trajectories: see [`Together::GOES_ON`].
    const GOES_ON: bool;

    /// Integrates trajectories to their ends.
    fn run<W: Watch<T, N>>(isa: Isa, march: March<'_, Self, M, T, W, N>) -> Result<(), Reason>;
}

impl<M, F, T, const N: usize> Marches<M, T, N> for Adaptive<F>
where
    M: Cast<N>,
    F: Together<M, T, N> + Estimates,
    T: LaneElement,
{
    const GOES_ON: bool = F::GOES_ON;

    fn run<W: Watch<T, N>>(isa: Isa, march: March<'_, Self, M, T, W, N>) -> Result<(), Reason> {
        F::within_tolerance(isa, march)
    }
}

impl<M, F, T, const N: usize> Marches<M, T, N> for Fixed<F>
where
    M: Cast<N>,
    F: Together<M, T, N>,
    T: LaneElement,
{
    const GOES_ON: bool = F::GOES_ON;

    fn run<W: Watch<T, N>>(isa: Isa, march: March<'_, Self, M, T, W, N>) -> Result<(), Reason> {
        F::on_grid(isa, march)
    }
}
