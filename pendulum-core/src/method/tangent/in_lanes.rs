//! Tangents in lanes.

use nalgebra::SVector;

use super::{Bundle, Tangent};
use crate::dense::Step;
use crate::ensemble::{MOST_LANES, in_lane, set_lane};
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::method::explicit::ExplicitStages;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled, stall};
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::Jacobian;
use crate::tableau::Tableau;

/// Treatment of the tangents of each trajectory.
pub(crate) trait Carry<T, const K: usize, const N: usize>: Copy {
    /// Returns the tangents with which a trajectory starts.
    fn start(self) -> [SVector<T, N>; K];

    /// Updates the tangents after a step of trajectory `index` from `t` over `h`.
    fn step(self, index: usize, step: (T, T), tangents: &mut [SVector<T, N>; K]);
}

/// Like [`Tangent`], for many trajectories without modes, whose tangents are treated by `C`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carried<C, B, const STAGES: usize, const K: usize> {
    tangent: Tangent<B, STAGES, K>,
    pub(crate) carry: C,
}

impl<C, B, const STAGES: usize, const K: usize> Carried<C, B, STAGES, K> {
    pub(crate) fn new(tangent: Tangent<B, STAGES, K>, carry: C) -> Self {
        Self { tangent, carry }
    }
}

impl<C, B, S, T, const STAGES: usize, const K: usize, const N: usize> OneStep<S, T, N> for Carried<C, B, STAGES, K>
where
    B: Tableau<STAGES>,
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = Bundle<B, T, STAGES, K, N>;

    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        self.tangent.scheme(system, tolerance)
    }
}

impl<C, B: Estimates, const STAGES: usize, const K: usize> Estimates for Carried<C, B, STAGES, K> {}

/// States and their tangents in lanes.
#[derive(Clone, Debug)]
pub(crate) struct CarriedStages<C, B, V, const STAGES: usize, const K: usize, const N: usize> {
    bundle: Bundle<B, V, STAGES, K, N>,
    carry: C,
    /// Index of the trajectory in each lane.
    index: [usize; MOST_LANES],
}

impl<C, B, V, const STAGES: usize, const K: usize, const N: usize> CarriedStages<C, B, V, STAGES, K, N>
where
    B: Tableau<STAGES>,
    V: Lanes,
{
    pub(crate) fn new(
        state: ExplicitStages<B, V, STAGES, N>,
        tolerance: Option<Tolerance<V::Scalar>>,
        carry: C,
    ) -> Self {
        Self {
            bundle: Bundle::new(state, tolerance.map(Tolerance::in_lanes)),
            carry,
            index: [0; MOST_LANES],
        }
    }
}

impl<C, B, S, V, const STAGES: usize, const K: usize, const N: usize> Scheme<S, V, N>
    for CarriedStages<C, B, V, STAGES, K, N>
where
    C: Carry<V::Scalar, K, N>,
    B: Tableau<STAGES>,
    S: Jacobian<V, N> + ?Sized,
    V: Lanes,
{
    fn error_order(&self) -> usize {
        Scheme::<S, V, N>::error_order(&self.bundle.state)
    }

    fn enter(&mut self, lane: usize, index: usize) {
        self.index[lane] = index;
        for (tangent, own) in self.bundle.tangents.iter_mut().zip(self.carry.start()) {
            set_lane(tangent, lane, &own);
        }
    }

    #[inline(always)]
    fn begin(&mut self, system: &InMode<'_, S, V>, t: V, x: &SVector<V, N>, work: &mut Statistics) -> SVector<V, N> {
        self.bundle.begin_both(system, t, x, work)
    }

    #[inline(always)]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, V>,
        (t, x): (V, &SVector<V, N>),
        (t_new, x_new): (V, &mut SVector<V, N>),
        work: &mut Statistics,
    ) -> Result<V, Stalled> {
        let mean_square = self.bundle.attempt_both(system, (t, x), (t_new, x_new), work);
        let mut sum = V::default();
        for tangent in &self.bundle.tried {
            tangent.data.0[0].iter().for_each(|&component| sum += component);
        }
        if sum.all_finite() {
            return Ok(mean_square);
        }
        let tried = &self.bundle.tried;
        let is_finite = |lane: usize| tried.iter().flatten().all(|component| component.lane(lane).is_finite());
        let defect = V::from_fn(|lane| V::Scalar::from_f64(if is_finite(lane) { 0.0 } else { f64::NAN }));
        Ok(stall(defect, x_new, mean_square))
    }

    #[inline(always)]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, V>,
        end: (V, &SVector<V, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<V, N>> {
        Some(self.bundle.arrive_both(system, end, work))
    }

    #[inline(always)]
    fn accept(&mut self, system: &InMode<'_, S, V>, step: &Step<V, N>, lanes: Accepted<V>, work: &mut Statistics) {
        let Self { bundle, carry, index } = self;
        bundle.accept_both(system, step, lanes, work);
        for (lane, &index) in index.iter().enumerate().take(V::LANES) {
            let (t, h) = (step.t0.lane(lane), step.h.lane(lane));
            // lanes without a trajectory do not move
            if lanes.is_in(lane) && h != V::Scalar::default() {
                let mut own = bundle.tangents.map(|tangent| in_lane(&tangent, lane));
                carry.step(index, (t, h), &mut own);
                for (tangent, own) in bundle.tangents.iter_mut().zip(&own) {
                    set_lane(tangent, lane, own);
                }
            }
        }
    }

    fn dense(&mut self, system: &InMode<'_, S, V>, step: &Step<V, N>, work: &mut Statistics) -> &[SVector<V, N>] {
        self.bundle.state.dense(system, step, work)
    }

    fn coefficients(&self) -> &[SVector<V, N>] {
        Scheme::<S, V, N>::coefficients(&self.bundle.state)
    }
}
