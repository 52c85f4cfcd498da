//! Many trajectories, each with steps of its own lengths.

use std::ops::Range;

use nalgebra::SVector;

use super::check::{first_not_finite, in_lane, set_lane, sum};
use super::members::Members;
use super::watch::{Watch, show_lane};
use super::{InLanes, MOST_LANES, Stopped, alone, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode};
use crate::method::{
    Adaptive, Estimates, Failure, NonFinite, OneStep, Scheme, Stalled, StepControl, is_within_tolerance, place, toggle,
};
use crate::real::lanes::{Kernel, LaneElement, Lanes};
use crate::statistics::Statistics;
use crate::system::Cast;

/// Trajectories on their way from the states `x`, which are replaced.
pub struct March<'a, F, M, T, W, const N: usize> {
    pub(super) method: &'a Adaptive<F>,
    pub(super) models: &'a [M],
    pub(super) span: (T, T),
    pub(super) x: &'a mut [SVector<T, N>],
    /// Those that have not begun.
    pub(super) waiting: Range<usize>,
    pub(super) stopped: &'a mut Vec<Stopped<T>>,
    pub(super) watch: W,
}

impl<F, M, T, W, const N: usize> March<'_, F, M, T, W, N> {
    /// The same by another method.
    pub(super) fn by<'b, G>(self, method: &'b Adaptive<G>) -> March<'b, G, M, T, W, N>
    where
        Self: 'b,
    {
        March {
            method,
            models: self.models,
            span: self.span,
            x: self.x,
            waiting: self.waiting,
            stopped: self.stopped,
            watch: self.watch,
        }
    }
}

impl<F, M, T, W, const N: usize> March<'_, F, M, T, W, N>
where
    F: OneStep<M::In<T>, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Brings all that have not begun to their ends, one after the other.
    pub(super) fn one_by_one(mut self) {
        let waiting = self.waiting.clone();
        self.alone(waiting);
    }

    fn alone(&mut self, which: Range<usize>) {
        let states = (&mut *self.x, &mut self.watch);
        alone(self.method, self.models, self.span, which, states, self.stopped);
    }
}

impl<F, M, T, W, const N: usize> Kernel<T> for March<'_, F, M, T, W, N>
where
    F: InLanes<M, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    type Output = Result<(), Reason>;

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        if const { M::HYBRID && F::IN_MODES && !W::WATCHES && V::LANES > 1 } && self.has_plain_rates() {
            self.in_modes::<V>()
        } else if const { !M::HYBRID && !F::NARROW } {
            self.in_lanes::<V::Double>()
        } else if const { !M::HYBRID && V::LANES > 1 } {
            self.in_lanes::<V>()
        } else {
            self.one_by_one();
            Ok(())
        }
    }
}

impl<F, M, T, W, const N: usize> March<'_, F, M, T, W, N>
where
    F: InLanes<M, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    #[inline(always)]
    fn in_lanes<V: Lanes<Scalar = T>>(mut self) -> Result<(), Reason> {
        if self.models.is_empty() {
            return Ok(());
        }
        let tolerance = self.method.tolerance()?;
        let mut system = F::gather::<V>(|_| &self.models[0]);
        let mut scheme = self.method.family.stages::<V>(&system, Some(tolerance), W::WATCHES)?;
        let control = self.method.control(tolerance, scheme.error_order(), self.span)?;
        let hold = Hold::default();
        let mut members = Members::none();
        let mut x = SVector::from_element(V::default());
        let mut x_new = x;
        let work = &mut Statistics::default();
        let mut within = Vec::new();
        loop {
            if members.some_are_free(V::LANES) {
                let someone_enters = self.enter(&mut members, &mut x, &control);
                if members.busy(V::LANES).next().is_none() {
                    return Ok(());
                }
                if someone_enters {
                    if self.models.len() > 1 {
                        system = F::gather::<V>(|lane| model_of(self.models, members.index(lane).unwrap_or(0)));
                    }
                    let t = V::from_fn(|lane| members.t[lane]);
                    for (lane, index) in members.busy(V::LANES) {
                        if members.steps[lane] == 0 {
                            scheme.enter(lane, index);
                        }
                    }
                    *work = Statistics::default();
                    let slope = scheme.begin(&InMode::new(&system, &hold), t, &x, work);
                    for (lane, index) in members.busy(V::LANES) {
                        if members.steps[lane] == 0 {
                            let work = scheme.work_in(lane, work);
                            self.begin(&control, &mut members, (lane, index), &in_lane(&slope, lane), work);
                        }
                    }
                }
            }
            let t = V::from_fn(|lane| members.t[lane]);
            *work = Statistics::default();
            let proposed = scheme.prepare(&InMode::new(&system, &hold), t, &x, work);
            if const { F::Stages::<V>::ORDERS_DIFFER } {
                for (lane, _) in members.busy(V::LANES) {
                    members.set_order(lane, scheme.error_order_in(lane));
                }
            }
            self.plan(&mut members, &control, &x, proposed);
            let t_new = V::from_fn(|lane| members.t_new[lane]);
            let attempt = scheme.attempt(&InMode::new(&system, &hold), (t, &x), (t_new, &mut x_new), work);
            if const { W::WATCHES } {
                for (lane, index) in members.busy(V::LANES) {
                    self.watch.work(index, &scheme.work_in(lane, work));
                }
            }
            *work = Statistics::default();
            let slope = scheme
                .arrive(&InMode::new(&system, &hold), (t_new, &x_new), work)
                .copied();
            let slope = slope.as_ref();
            if const { W::WATCHES } {
                self.count(&members, &scheme, attempt, (&x_new, slope), work);
            }
            self.judge(&mut members, &control, &x, attempt, (&x_new, slope));
            let lanes = members.accepted::<V>();
            let step = Step::new((t, x), (t_new, x_new));
            if const { W::WATCHES } {
                self.show(
                    &mut members,
                    &mut scheme,
                    &InMode::new(&system, &hold),
                    &step,
                    &mut within,
                );
            }
            scheme.accept(&InMode::new(&system, &hold), &step, lanes, work);
            x = lanes.select(&x_new, &x);
            self.take_out(&mut members, &x);
        }
    }

    /// Counts the work at the ends of steps, where they arrive.
    #[inline(always)]
    fn count<V: Lanes<Scalar = T>>(
        &mut self,
        members: &Members<T>,
        scheme: &F::Stages<V>,
        attempt: Result<V, Stalled>,
        (x_new, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
        at_end: &Statistics,
    ) {
        for (lane, index) in members.busy(V::LANES) {
            let is_finite = |v: &SVector<V, N>| v.iter().all(|v| v.lane(lane).is_finite());
            let is_within = attempt.is_ok_and(|mean_square| is_within_tolerance(mean_square.lane(lane)));
            let arrives = is_within && is_finite(x_new);
            let is_accepted = arrives && slope.is_none_or(is_finite);
            let mut work = Statistics::default();
            if arrives {
                work = scheme.work_in(lane, at_end);
            }
            (work.accepted, work.rejected) = (usize::from(is_accepted), usize::from(!is_accepted));
            work.stiff *= work.accepted;
            self.watch.work(index, &work);
        }
    }

    /// Shows the steps that are accepted; takes those out of their lanes which an event ends.
    #[inline(always)]
    fn show<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        scheme: &mut F::Stages<V>,
        system: &InMode<'_, F::System<V>, V>,
        step: &Step<V, N>,
        within: &mut Vec<SVector<T, N>>,
    ) {
        let span = |lane: usize| (step.t0.lane(lane), step.t1.lane(lane));
        let mut looks = [false; MOST_LANES];
        for (lane, index) in members.busy(V::LANES) {
            looks[lane] = members.is_accepted(lane) && self.watch.looks_into(index, span(lane));
        }
        let mut work = Statistics::default();
        if looks[..V::LANES].contains(&true) {
            scheme.dense(system, step, &mut work);
        }
        for (lane, index) in members.busy(V::LANES) {
            if !members.is_accepted(lane) {
                continue;
            }
            let looks_into = looks[lane].then(|| (scheme.coefficients_in(lane), scheme.work_in(lane, &work)));
            match show_lane(&mut self.watch, (lane, index), step, looks_into, within) {
                Ok(None) => {}
                Ok(Some(x)) => self.leave(members, (lane, index), x),
                Err(early) => {
                    members.t[lane] = early.t;
                    self.stop(members, (lane, index), early.x, early.reason);
                }
            }
        }
    }

    /// Plans the next steps; stops those that may take none.
    #[inline(always)]
    pub(super) fn plan<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        control: &StepControl<T>,
        x: &SVector<V, N>,
        proposed: Option<V>,
    ) {
        let (_, t1) = self.span;
        if !members.plan(control, t1, proposed) {
            for (lane, index) in members.busy(V::LANES) {
                let (mut h, at) = (members.h[lane], members.t[lane]);
                let proposed = members.proposal(lane, &proposed);
                if let Err(reason) = control.plan(&mut h, (at, t1), members.steps[lane], proposed) {
                    self.stop(members, (lane, index), in_lane(x, lane), reason);
                }
            }
        }
    }

    /// Judges steps from the states `x` by what came of the attempt; stops those that may take no shorter one.
    #[inline(always)]
    pub(super) fn judge<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        control: &StepControl<T>,
        x: &SVector<V, N>,
        attempt: Result<V, Stalled>,
        (x_new, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
    ) {
        let sum = sum(x_new, slope);
        let outcome = |lane| match attempt {
            Err(stalled) => Err(Failure::from(stalled)),
            Ok(mean_square) if sum.lane(lane).is_finite() => Ok(mean_square.lane(lane)),
            Ok(mean_square) => outcome((x_new, slope), mean_square.lane(lane), lane),
        };
        let mean_squares = match attempt {
            Ok(mean_square) if sum.all_finite() => mean_square,
            _ => V::from_fn(|lane| outcome(lane).unwrap_or(T::from_f64(f64::NAN))),
        };
        let all_arrived = attempt.is_ok() && sum.all_finite();
        if !members.judge(control, &mean_squares, F::Stages::<V>::PROPOSES) || !all_arrived {
            for (lane, index) in members.busy(V::LANES) {
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

    /// Takes those out of their lanes that are at the end.
    #[inline(always)]
    pub(super) fn take_out<V: Lanes<Scalar = T>>(&mut self, members: &mut Members<T>, x: &SVector<V, N>) {
        let (_, t1) = self.span;
        if members.some_arrive(V::LANES, t1) {
            for (lane, index) in members.busy(V::LANES) {
                if members.t[lane] == t1 {
                    self.leave(members, (lane, index), in_lane(x, lane));
                }
            }
        }
    }

    /// Those that wait take the lanes that are free: whether there were any.
    #[inline(always)]
    fn enter<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        x: &mut SVector<V, N>,
        control: &StepControl<T>,
    ) -> bool {
        let mut someone_enters = false;
        for lane in 0..V::LANES {
            if members.index(lane).is_none()
                && let Some(index) = self.next()
            {
                members.enter(lane, index, self.span.0, control.start());
                set_lane(x, lane, &self.x[index]);
                someone_enters = true;
            }
        }
        someone_enters
    }

    /// The next trajectory, if one waits that has a way to go; those are brought to their ends that must go alone.
    pub(super) fn next(&mut self) -> Option<usize> {
        let (t0, t1) = self.span;
        loop {
            let index = self.waiting.next()?;
            if const { W::WATCHES } && (t0 == t1 || self.watch.is_alone(index)) {
                self.alone(index..index + 1);
                continue;
            }
            let model = model_of(self.models, index).cast::<T>();
            match place(&model, t0, &self.x[index]) {
                Ok(x) => {
                    self.x[index] = x;
                    if t0 != t1 {
                        return Some(index);
                    }
                }
                Err(reason) => self.stopped.push(Stopped { index, t: t0, reason }),
            }
        }
    }

    /// Begins a trajectory with the derivative at its start: finds a first step, where the method does not propose it.
    fn begin(
        &mut self,
        control: &StepControl<T>,
        members: &mut Members<T>,
        (lane, index): (usize, usize),
        slope: &SVector<T, N>,
        mut work: Statistics,
    ) {
        let x = self.x[index];
        if let Err(component) = NonFinite::check(slope) {
            let t = members.t[lane];
            let reason = component.at_start();
            self.stopped.push(Stopped { index, t, reason });
            return members.leave(lane);
        }
        if const { !<F::Scheme as Scheme<M::In<T>, T, N>>::PROPOSES } {
            let model = model_of(self.models, index).cast::<T>();
            if let Some(h) = control.first_step(&model, (members.t[lane], &x, slope), self.span.1) {
                members.h[lane] = h;
                work.evaluations += 1;
            }
        }
        if let Err(reason) = self
            .watch
            .start(index, (members.t[lane], &x), Some(control.tolerance), &work)
        {
            self.stop(members, (lane, index), x, reason);
        }
    }

    /// Ends a trajectory in a state.
    fn leave(&mut self, members: &mut Members<T>, (lane, index): (usize, usize), x: SVector<T, N>) {
        self.x[index] = x;
        members.leave(lane);
        self.watch.finish(index);
    }

    /// Ends a trajectory before its time, in its last good state.
    #[cold]
    pub(super) fn stop(
        &mut self,
        members: &mut Members<T>,
        (lane, index): (usize, usize),
        x: SVector<T, N>,
        reason: Reason,
    ) {
        let t = members.t[lane];
        let reason = toggle::behind(reason, &model_of(self.models, index).cast::<T>(), t, &x);
        self.stopped.push(Stopped { index, t, reason });
        self.leave(members, (lane, index), x);
    }
}

/// What a step brings in a lane where not all is finite, or which [stalls](Scheme::attempt). The derivative at its end
/// does not matter if its error is too large.
#[cold]
pub(super) fn outcome<V: Lanes, const N: usize>(
    (x, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
    mean_square: V::Scalar,
    lane: usize,
) -> Result<V::Scalar, Failure> {
    if mean_square < V::Scalar::default() {
        return Err(Stalled.into());
    }
    let slope = slope.filter(|_| is_within_tolerance(mean_square));
    match first_not_finite(x, slope, lane) {
        Some(component) => Err(component.into()),
        None => Ok(mean_square),
    }
}
