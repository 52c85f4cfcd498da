//! Integration in lanes: one trajectory per lane, each replaced by the next when it ends.

use nalgebra::SVector;

use super::check::{End, sum};
use super::hybrid::AtModes;
use super::leave::Leave;
use super::march::{March, Paced, Pacing};
use super::members::Members;
use super::ready::{Enter, Entrance, Ready};
use super::watch::Watch;
use super::{Expanded, InLanes, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode};
use crate::method::{Adaptive, Estimates, Method, Scheme};
use crate::real::lanes::{Kernel, LaneElement, Lanes};
use crate::statistics::Statistics;
use crate::system::{Cast, System};

/// No trajectory leaves its lane early.
pub(super) struct Never<V>(Hold<V>);

impl<A, F, M, V, W, const N: usize> Leave<A, M, V, W, N> for Never<V>
where
    A: Paced<V::Scalar, Family = F> + Method<M::In<V::Scalar>, V::Scalar, N>,
    F: InLanes<M, V::Scalar, N>,
    M: Cast<N>,
    V: Lanes,
    V::Scalar: LaneElement,
    W: Watch<V::Scalar, N>,
{
    const ASKS: bool = false;

    fn none() -> Self {
        Self(Hold::default())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn enter(
        &mut self,
        march: &mut March<'_, A, M, V::Scalar, W, N>,
        members: &mut Members<V::Scalar>,
        x: &mut SVector<V, N>,
        steps: (&mut Pacing<V::Scalar>, &Pacing<V::Scalar>),
    ) -> bool {
        march.enter(members, x, steps)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn hold(&self) -> &Hold<V> {
        &self.0
    }
}

impl<F, M, T, W, const N: usize> Kernel<T> for March<'_, Adaptive<F>, M, T, W, N>
where
    F: InLanes<M, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    type Output = Result<(), Reason>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        if const { M::HYBRID && F::IN_MODES && !W::WATCHES && V::LANES > 1 } && self.has_plain_rates() {
            self.in_lanes::<V, AtModes<V, N>>()
        } else if const { !M::HYBRID && M::WIDE && F::WIDE && V::LANES > 1 } {
            self.in_lanes::<<V::Double as Lanes>::Double, Never<<V::Double as Lanes>::Double>>()
        } else if const { !M::HYBRID && (M::WIDE || !F::NARROW) } {
            self.in_lanes::<V::Double, Never<V::Double>>()
        } else if const { !M::HYBRID && V::LANES > 1 } {
            self.in_lanes::<V, Never<V>>()
        } else {
            self.one_by_one();
            Ok(())
        }
    }
}

impl<A, F, M, T, W, const N: usize> March<'_, A, M, T, W, N>
where
    A: Paced<T, Family = F> + Method<M::In<T>, T, N>,
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Integrates all waiting trajectories, as many at once as there are lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn in_lanes<V, L>(mut self) -> Result<(), Reason>
    where
        V: Lanes<Scalar = T>,
        L: Leave<A, M, V, W, N>,
    {
        if self.models.is_empty() {
            return Ok(());
        }
        let mut system = Expanded::<M, V, N>::gather(|_| &self.models[0]);
        let (family, tolerance) = (self.method.family(), self.method.within()?);
        let mut scheme = family.stages::<V>(&system, tolerance, W::WATCHES || L::ASKS)?;
        let mut start = self.method.steps(scheme.error_order(), self.span)?;
        if let Pacing::Controlled(control) = &mut start {
            control.keeps_pace = self.paces.is_some();
        }
        let mut steps = start;
        let mut leave = L::none();
        let mut members = Members::none();
        let mut ready = Ready::none();
        // in place, since states in lanes are large: from `x0` to `x1`
        let mut step = Step::at_rest(V::default(), SVector::from_element(V::default()));
        let work = &mut Statistics::default();
        let mut within = Vec::new();
        loop {
            if members.some_are_free(V::LANES) {
                let mut begins = true;
                let someone_enters = match (&start, scheme.slope_at_start()) {
                    (Pacing::Controlled(control), Some(slope)) if const { !L::ASKS } => {
                        begins = false;
                        let mut entrance = Entrance {
                            march: &mut self,
                            ready: &mut ready,
                            members: &mut members,
                            x: step.x0,
                            slope: *slope,
                        };
                        let someone_enters = V::call(Enter, &mut entrance, control);
                        (step.x0, *slope) = (entrance.x, entrance.slope);
                        someone_enters
                    }
                    _ => leave.enter(&mut self, &mut members, &mut step.x0, (&mut steps, &start)),
                };
                if members.busy(V::LANES).next().is_none() {
                    return Ok(());
                }
                if someone_enters {
                    if self.models.len() > 1 {
                        system =
                            Expanded::<M, V, N>::gather(|lane| model_of(self.models, members.index(lane).unwrap_or(0)));
                    }
                    if begins {
                        self.begin_all(&system, (&mut leave, &mut scheme), &mut members, (&steps, &step.x0));
                    }
                }
            }
            let mode = InMode::new(&system, leave.hold());
            step.t0 = V::from_fn(|lane| members.t[lane]);
            *work = Statistics::default();
            let proposed = scheme.prepare(&mode, step.t0, &step.x0, work);
            if const { F::Stages::<V>::ORDERS_DIFFER } {
                for (lane, _) in members.busy_at_first(V::LANES) {
                    members.set_order(lane, scheme.error_order_in(lane));
                }
            }
            self.plan(&mut members, &mut steps, &step.x0, proposed);
            step.t1 = V::from_fn(|lane| members.t_new[lane]);
            step.h = step.t1 - step.t0;
            let attempt = scheme.attempt(&mode, (step.t0, &step.x0), (step.t1, &mut step.x1), work);
            if const { W::WATCHES } {
                self.count_attempt(&mut members, (&scheme, &steps), work);
            }
            *work = Statistics::default();
            let slope = scheme.arrive(&mode, (step.t1, &step.x1), work);
            let sum = sum(&step.x1, slope);
            // which of them is not finite matters only if one is
            let slope = if sum.all_finite() { None } else { slope.copied() };
            let end = End {
                x: &step.x1,
                slope: slope.as_ref(),
                sum,
            };
            let mut all_are_accepted = false;
            if const { W::WATCHES } {
                all_are_accepted = self.count(&mut members, (&scheme, &steps), attempt, &end, work);
            }
            if const { L::ASKS }
                && attempt.is_ok()
                && let Some(hybrid) = system.hybrid()
            {
                let terms = scheme.dense(&mode, &step, work);
                leave.check(&mut self, &mut members, &steps, (hybrid, &step, terms));
            }
            if all_are_accepted {
                members.accept_all();
            } else {
                self.judge(&mut members, &steps, &step.x0, attempt, &end);
            }
            let mode = InMode::new(&system, leave.hold());
            let lanes = members.accepted::<V>();
            if const { W::WATCHES } {
                self.show(&mut members, &mut scheme, &mode, &step, &mut within);
            }
            scheme.accept(&mode, &step, lanes, work);
            lanes.replace(&mut step.x0, &step.x1);
            self.take_out(&mut members, &step.x0);
            if const { F::LEAVES } {
                self.take_out_stiff(&mut members, &mut scheme, &steps, &step.x0);
            }
        }
    }
}
