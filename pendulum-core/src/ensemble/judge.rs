//! Lengths of the steps in lanes, and verdicts on them.

use nalgebra::SVector;

use super::check::{End, first_not_finite, in_lane};
use super::march::{March, Paced, Pacing};
use super::members::Members;
use super::watch::Watch;
use super::{InLanes, model_of};
use crate::method::{Method, Scheme, Stalled, StepControl, StepFailure, is_within_tolerance, toggle};
use crate::real::lanes::{LaneElement, Lanes};
use crate::system::Cast;

impl<A, F, M, T, W, const N: usize> March<'_, A, M, T, W, N>
where
    A: Paced<T, Family = F> + Method<M::In<T>, T, N>,
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Plans the next steps. Trajectories whose steps become too short are stopped.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn plan<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        steps: &mut Pacing<T>,
        x: &SVector<V, N>,
        proposed: Option<V>,
    ) {
        match steps {
            Pacing::Controlled(control) => self.plan_controlled(members, control, x, proposed),
            Pacing::Equal(grid) => members.go_to(grid.next()),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plan_controlled<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        control: &StepControl<T>,
        x: &SVector<V, N>,
        proposed: Option<V>,
    ) {
        let (_, t1) = self.span;
        if !members.plan(control, t1, proposed) {
            for (lane, index) in members.busy_at_first(V::LANES) {
                let (mut h, at) = (members.h[lane], members.t[lane]);
                let proposed = members.proposal(lane, &proposed);
                if let Err(reason) = control.plan(&mut h, (at, t1), members.steps[lane], proposed) {
                    self.stop(members, (lane, index), in_lane(x, lane), reason);
                }
            }
        }
    }

    /// Accepts or rejects the steps from the states `x`. Trajectories that cannot take a shorter step are stopped.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn judge<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        steps: &Pacing<T>,
        x: &SVector<V, N>,
        attempt: Result<V, Stalled>,
        end: &End<'_, V, N>,
    ) {
        if let Pacing::Controlled(control) = steps {
            return self.judge_controlled(members, control, x, attempt, end);
        }
        if attempt.is_ok_and(|error| !stalls(error)) && end.sum.all_finite() {
            return members.accept_all();
        }
        for (lane, index) in members.busy_at_first(V::LANES) {
            let outcome = attempt.map_err(StepFailure::from);
            if let Err(failure) = outcome.and_then(|error| outcome_of(end, error.lane(lane), lane)) {
                let h = members.t_new[lane] - members.t[lane];
                self.stop(members, (lane, index), in_lane(x, lane), failure.reason(h.to_f64()));
            }
        }
        members.accept_all();
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn judge_controlled<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        control: &StepControl<T>,
        x: &SVector<V, N>,
        attempt: Result<V, Stalled>,
        end: &End<'_, V, N>,
    ) {
        let sum = &end.sum;
        let outcome = |lane| match attempt {
            Err(stalled) => Err(StepFailure::from(stalled)),
            Ok(mean_square) if sum.lane(lane).is_finite() => Ok(mean_square.lane(lane)),
            Ok(mean_square) => outcome_of(end, mean_square.lane(lane), lane),
        };
        let mean_squares = match attempt {
            Ok(mean_square) if sum.all_finite() => mean_square,
            _ => V::from_fn(|lane| outcome(lane).unwrap_or(T::from_f64(f64::NAN))),
        };
        let all_arrived = attempt.is_ok() && sum.all_finite();
        if !members.judge(control, &mean_squares, F::Stages::<V>::PROPOSES) || !all_arrived {
            for (lane, index) in members.busy_at_first(V::LANES) {
                let (h, step) = (members.h[lane], (members.t[lane], members.t_new[lane]));
                if members.is_accepted(lane) {
                    continue;
                }
                let x = in_lane(x, lane);
                if h < control.least(step.0) {
                    let reason = control.hopeless(outcome(lane), step, h);
                    self.stop(members, (lane, index), x, reason);
                } else if let Err(failure) = outcome(lane)
                    && toggle::creeps(h, step.0)
                    && let Err(reason) = toggle::reached(failure, &model_of(self.models, index).cast::<T>(), step, &x)
                {
                    self.stop(members, (lane, index), x, reason);
                }
            }
        }
    }
}

/// True if some lane [stalls](Scheme::attempt).
#[inline(always)]
pub(super) fn stalls<V: Lanes>(error: V) -> bool {
    (0..V::LANES).fold(false, |some, lane| some | (error.lane(lane) < V::Scalar::default()))
}

/// Outcome of a step in a lane with non-finite numbers, or in a lane that [stalls](Scheme::attempt). The derivative at
/// the end of the step is checked only if the error is within the tolerance.
#[cold]
fn outcome_of<V: Lanes, const N: usize>(
    end: &End<'_, V, N>,
    mean_square: V::Scalar,
    lane: usize,
) -> Result<V::Scalar, StepFailure> {
    if mean_square < V::Scalar::default() {
        return Err(Stalled.into());
    }
    let slope = end.slope.filter(|_| is_within_tolerance(mean_square));
    match first_not_finite(end.x, slope, lane) {
        Some(component) => Err(component.into()),
        None => Ok(mean_square),
    }
}
