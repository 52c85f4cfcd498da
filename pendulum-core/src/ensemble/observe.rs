//! Observers of lanes: counts of their work, and their steps.

use nalgebra::SVector;

use super::check::{End, in_lane};
use super::judge::stalls;
use super::march::{March, Paced, Pacing};
use super::members::Members;
use super::watch::{Watch, show_lane};
use super::{Expanded, InLanes, MOST_LANES};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::method::{Method, Scheme, Stalled, is_within_tolerance};
use crate::real::lanes::{LaneElement, Lanes};
use crate::solution::Need;
use crate::statistics::Statistics;
use crate::system::Cast;

impl<A, F, M, T, W, const N: usize> March<'_, A, M, T, W, N>
where
    A: Paced<T, Family = F> + Method<M::In<T>, T, N>,
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Counts the work of an attempt.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn count_attempt<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        (scheme, steps): (&F::Stages<V>, &Pacing<T>),
        work: &Statistics,
    ) {
        if let Pacing::Equal(_) = steps {
            return members.count_alike(work);
        }
        for (lane, index) in members.busy(V::LANES) {
            self.watch.work(index, &scheme.work_in(lane, work));
        }
    }

    /// Counts the evaluations at the ends of steps, for the lanes whose error is within the tolerance. Returns true if
    /// the step is one of a common grid, and all trajectories accept it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn count<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        (scheme, steps): (&F::Stages<V>, &Pacing<T>),
        attempt: Result<V, Stalled>,
        end: &End<'_, V, N>,
        at_end: &Statistics,
    ) -> bool {
        let all_are_finite = end.sum.all_finite();
        if matches!(steps, Pacing::Equal(_)) && all_are_finite && attempt.is_ok_and(|error| !stalls(error)) {
            members.count_alike(at_end);
            members.count_alike(&Statistics {
                accepted: 1,
                ..Statistics::default()
            });
            return true;
        }
        for (lane, index) in members.busy(V::LANES) {
            let is_finite = |v: &SVector<V, N>| all_are_finite || v.iter().all(|v| v.lane(lane).is_finite());
            let is_within = attempt.is_ok_and(|mean_square| is_within_tolerance(mean_square.lane(lane)));
            let arrives = is_within && is_finite(end.x);
            let is_accepted = arrives && end.slope.is_none_or(is_finite);
            let mut work = Statistics::default();
            if arrives {
                work = scheme.work_in(lane, at_end);
            }
            (work.accepted, work.rejected) = (usize::from(is_accepted), usize::from(!is_accepted));
            work.stiff *= work.accepted;
            self.watch.work(index, &work);
        }
        false
    }

    /// Passes the accepted steps to the observers. Trajectories that an event ends leave their lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn show<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        scheme: &mut F::Stages<V>,
        system: &InMode<'_, Expanded<M, V, N>, V>,
        step: &Step<V, N>,
        within: &mut Vec<SVector<T, N>>,
    ) {
        let span = |lane: usize| (step.t0.lane(lane), step.t1.lane(lane));
        let (mut needs, mut some_need) = ([Need::Nothing; MOST_LANES], false);
        for (lane, index) in members.busy(V::LANES) {
            if members.is_accepted(lane) {
                needs[lane] = self.watch.needs(index, span(lane));
                some_need |= needs[lane] != Need::Nothing || self.watch.is_cancelled(index);
            }
        }
        if !some_need {
            return;
        }
        let mut work = Statistics::default();
        if needs[..V::LANES].contains(&Need::Inside) {
            scheme.dense(system, step, &mut work);
        }
        for (lane, index) in members.busy_at_first(V::LANES) {
            if !members.is_accepted(lane) {
                continue;
            }
            let inside = || (scheme.coefficients_in(lane), scheme.work_in(lane, &work));
            let seen = match needs[lane] {
                Need::Nothing => Ok(None),
                Need::Ends => show_lane(&mut self.watch, (lane, index), step, None, within),
                Need::Inside => show_lane(&mut self.watch, (lane, index), step, Some(inside()), within),
            };
            match seen {
                Ok(None) if self.watch.is_cancelled(index) => {
                    self.stop(members, (lane, index), in_lane(&step.x1, lane), Reason::Cancelled);
                }
                Ok(None) => {}
                Ok(Some(x)) => self.leave(members, (lane, index), x),
                Err(early) => {
                    members.t[lane] = early.t;
                    self.stop(members, (lane, index), early.x, early.reason);
                }
            }
        }
    }
}
