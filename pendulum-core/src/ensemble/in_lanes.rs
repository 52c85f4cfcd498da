//! Integration in lanes: one trajectory per lane, each replaced by the next when it ends.

use nalgebra::SVector;

use super::check::{first_not_finite, in_lane, set_lane, sum};
use super::hybrid::AtModes;
use super::leave::Leave;
use super::march::{March, Paced, Pacing};
use super::members::Members;
use super::watch::{Watch, show_lane};
use super::{Expanded, InLanes, MOST_LANES, Stopped, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode, Modes};
use crate::method::{
    Adaptive, Early, Estimates, Method, NonFinite, Pace, Progress, Scheme, Stalled, StepControl, StepFailure, Stepper,
    is_within_tolerance, jump, place, toggle,
};
use crate::real::lanes::{Kernel, LaneElement, Lanes};
use crate::solution::Need;
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
        let mut x = SVector::from_element(V::default());
        let mut x_new = x;
        let work = &mut Statistics::default();
        let mut within = Vec::new();
        loop {
            if members.some_are_free(V::LANES) {
                let someone_enters = leave.enter(&mut self, &mut members, &mut x, (&mut steps, &start));
                if members.busy(V::LANES).next().is_none() {
                    return Ok(());
                }
                if someone_enters {
                    if self.models.len() > 1 {
                        system =
                            Expanded::<M, V, N>::gather(|lane| model_of(self.models, members.index(lane).unwrap_or(0)));
                    }
                    leave.begin(&system);
                    if const { L::ASKS } {
                        // Each trajectory was initialised by its own stepper.
                        let t = V::from_fn(|lane| members.t[lane]);
                        scheme.begin(&InMode::new(&system, leave.hold()), t, &x, work);
                    } else {
                        self.begin_all((&system, leave.hold()), &mut scheme, &mut members, (&steps, &x));
                    }
                }
            }
            let t = V::from_fn(|lane| members.t[lane]);
            *work = Statistics::default();
            let proposed = scheme.prepare(&InMode::new(&system, leave.hold()), t, &x, work);
            if const { F::Stages::<V>::ORDERS_DIFFER } {
                for (lane, _) in members.busy_at_first(V::LANES) {
                    members.set_order(lane, scheme.error_order_in(lane));
                }
            }
            self.plan(&mut members, &mut steps, &x, proposed);
            let t_new = V::from_fn(|lane| members.t_new[lane]);
            let attempt = scheme.attempt(&InMode::new(&system, leave.hold()), (t, &x), (t_new, &mut x_new), work);
            if const { W::WATCHES } {
                match steps {
                    Pacing::Equal(_) => members.count_alike(work),
                    Pacing::Controlled(_) => {
                        for (lane, index) in members.busy(V::LANES) {
                            self.watch.work(index, &scheme.work_in(lane, work));
                        }
                    }
                }
            }
            *work = Statistics::default();
            let slope = scheme
                .arrive(&InMode::new(&system, leave.hold()), (t_new, &x_new), work)
                .copied();
            let slope = slope.as_ref();
            let mut all_are_accepted = false;
            if const { W::WATCHES } {
                all_are_accepted = self.count(&mut members, (&scheme, &steps), attempt, (&x_new, slope), work);
            }
            let step = Step::new((t, x), (t_new, x_new));
            if const { L::ASKS }
                && attempt.is_ok()
                && let Some(hybrid) = system.hybrid()
            {
                let terms = scheme.dense(&InMode::new(&system, leave.hold()), &step, work);
                leave.check(&mut self, &mut members, &steps, (hybrid, &step, terms));
            }
            if all_are_accepted {
                members.accept_all();
            } else {
                self.judge(&mut members, &steps, &x, attempt, (&x_new, slope));
            }
            let lanes = members.accepted::<V>();
            if const { W::WATCHES } {
                self.show(
                    &mut members,
                    &mut scheme,
                    &InMode::new(&system, leave.hold()),
                    &step,
                    &mut within,
                );
            }
            scheme.accept(&InMode::new(&system, leave.hold()), &step, lanes, work);
            x = lanes.select(&x_new, &x);
            self.take_out(&mut members, &x);
            if const { F::LEAVES } {
                for (lane, index) in members.busy_at_first(V::LANES) {
                    if F::leaves(&scheme, lane) {
                        let modes = Modes::none(members.t[lane]);
                        self.go_on_alone(index, &members.progress(lane, in_lane(&x, lane), modes), &steps);
                        members.leave(lane);
                        // the empty lane requests nothing
                        scheme.enter(lane, index);
                    }
                }
            }
        }
    }

    /// Initialises the method in all lanes and finds the first steps of trajectories that have just entered.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin_all<V: Lanes<Scalar = T>>(
        &mut self,
        (system, hold): (&Expanded<M, V, N>, &Hold<V>),
        scheme: &mut F::Stages<V>,
        members: &mut Members<T>,
        (steps, x): (&Pacing<T>, &SVector<V, N>),
    ) {
        let (t, work) = (V::from_fn(|lane| members.t[lane]), &mut Statistics::default());
        let enters = |members: &Members<T>, lane: usize| members.steps[lane] == 0;
        for (lane, index) in members.busy(V::LANES).filter(|&(lane, _)| enters(members, lane)) {
            scheme.enter(lane, index);
        }
        let slope = scheme.begin(&InMode::new(system, hold), t, x, work);
        for (lane, index) in members.busy_at_first(V::LANES) {
            if enters(members, lane) {
                let work = scheme.work_in(lane, work);
                self.begin(steps, members, (lane, index), &in_lane(&slope, lane), work);
            }
        }
    }

    /// Counts the evaluations at the ends of steps, for the lanes whose error is within the tolerance. Returns true if
    /// the step is one of a common grid, and all trajectories accept it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn count<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        (scheme, steps): (&F::Stages<V>, &Pacing<T>),
        attempt: Result<V, Stalled>,
        (x_new, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
        at_end: &Statistics,
    ) -> bool {
        let all_are_finite = sum(x_new, slope).all_finite();
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
        false
    }

    /// Passes the accepted steps to the observers. Trajectories that an event ends leave their lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn show<V: Lanes<Scalar = T>>(
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

    /// Plans the next steps. Trajectories whose steps become too short are stopped.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plan<V: Lanes<Scalar = T>>(
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
    pub(super) fn plan_controlled<V: Lanes<Scalar = T>>(
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
    fn judge<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        steps: &Pacing<T>,
        x: &SVector<V, N>,
        attempt: Result<V, Stalled>,
        ends: (&SVector<V, N>, Option<&SVector<V, N>>),
    ) {
        if let Pacing::Controlled(control) = steps {
            return self.judge_controlled(members, control, x, attempt, ends);
        }
        let (x_new, slope) = ends;
        if attempt.is_ok_and(|error| !stalls(error)) && sum(x_new, slope).all_finite() {
            return members.accept_all();
        }
        for (lane, index) in members.busy_at_first(V::LANES) {
            let outcome = attempt.map_err(StepFailure::from);
            if let Err(failure) = outcome.and_then(|error| outcome_of(ends, error.lane(lane), lane)) {
                let h = members.t_new[lane] - members.t[lane];
                self.stop(members, (lane, index), in_lane(x, lane), failure.reason(h.to_f64()));
            }
        }
        members.accept_all();
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn judge_controlled<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        control: &StepControl<T>,
        x: &SVector<V, N>,
        attempt: Result<V, Stalled>,
        (x_new, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
    ) {
        let sum = sum(x_new, slope);
        let outcome = |lane| match attempt {
            Err(stalled) => Err(StepFailure::from(stalled)),
            Ok(mean_square) if sum.lane(lane).is_finite() => Ok(mean_square.lane(lane)),
            Ok(mean_square) => outcome_of((x_new, slope), mean_square.lane(lane), lane),
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

    /// Removes trajectories that have reached the end of the span.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn take_out<V: Lanes<Scalar = T>>(&mut self, members: &mut Members<T>, x: &SVector<V, N>) {
        let (_, t1) = self.span;
        if members.some_arrive(V::LANES, t1) {
            for (lane, index) in members.busy_at_first(V::LANES) {
                if members.t[lane] == t1 {
                    self.leave(members, (lane, index), in_lane(x, lane));
                }
            }
        }
    }

    /// Integrates a trajectory that leaves its lane to its end.
    #[cold]
    fn go_on_alone(&mut self, index: usize, progress: &Progress<T, N>, steps: &Pacing<T>) {
        let Pacing::Controlled(control) = steps else { return };
        let model = model_of(self.models, index).cast::<T>();
        let scheme = self.method.family().alone(&model, Some(control.tolerance));
        let stepper = scheme.and_then(|scheme| Stepper::resume(&model, scheme, self.span.1, *control, progress));
        let ended = match stepper {
            Ok(mut stepper) => self.watch.go_on(index, &mut stepper, progress.steps),
            Err(reason) => Err(Early::at((progress.t, progress.x))(reason)),
        };
        self.x[index] = ended.unwrap_or_else(|Early { reason, t, x }| {
            self.stopped.push(Stopped { index, t, reason });
            x
        });
        self.watch.finish(index);
    }

    /// Fills free lanes with waiting trajectories; with equal steps, only once all lanes are free. Returns true if any
    /// entered.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn enter<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        x: &mut SVector<V, N>,
        (steps, start): (&mut Pacing<T>, &Pacing<T>),
    ) -> bool {
        let pace = match start {
            Pacing::Controlled(control) => control.start(),
            Pacing::Equal(_) if members.busy(V::LANES).next().is_some() => return false,
            Pacing::Equal(grid) => Pace::of_length(grid.h()),
        };
        *steps = *start;
        members.forget_work();
        let mut someone_enters = false;
        for lane in 0..V::LANES {
            if members.index(lane).is_none()
                && let Some(index) = self.next()
            {
                members.enter(lane, index, self.span.0, self.pace(index).unwrap_or(pace));
                set_lane(x, lane, &self.x[index]);
                someone_enters = true;
            }
        }
        someone_enters
    }

    /// Returns the next waiting trajectory with a nonempty span. Trajectories that must be integrated alone are
    /// completed on the way.
    pub(super) fn next(&mut self) -> Option<usize> {
        let (t0, t1) = self.span;
        loop {
            let index = self.waiting.next()?;
            if const { W::WATCHES } && (t0 == t1 || self.watch.is_alone(index)) {
                self.alone(index..index + 1);
                continue;
            }
            if self.goes_on && t0 != t1 {
                return Some(index);
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

    /// Checks the derivative at the start, and finds a first step if the method proposes none.
    fn begin(
        &mut self,
        steps: &Pacing<T>,
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
        let control = match steps {
            Pacing::Controlled(control) => Some(control),
            Pacing::Equal(_) => None,
        };
        if let Some(control) = control
            && self.pace(index).is_none()
            && const { !<F::Scheme as Scheme<M::In<T>, T, N>>::PROPOSES }
        {
            let model = model_of(self.models, index).cast::<T>();
            if let Some(h) = control.first_step(&model, (members.t[lane], &x, slope), self.span.1) {
                members.h[lane] = h;
                work.evaluations += 1;
            }
        }
        if let Err(reason) = self.watch.start(
            index,
            (members.t[lane], &x),
            control.map(|control| control.tolerance),
            &work,
        ) {
            self.stop(members, (lane, index), x, reason);
        }
    }

    /// Ends a trajectory in the state `x`.
    fn leave(&mut self, members: &mut Members<T>, (lane, index): (usize, usize), x: SVector<T, N>) {
        self.x[index] = x;
        if let Some(paces) = &mut self.paces {
            paces[index] = Some(members.pace(lane));
        }
        members.leave(lane);
        if const { W::WATCHES } {
            self.watch.work(index, members.work_of_each());
        }
        self.watch.finish(index);
    }

    /// Stops a trajectory early, in its last valid state.
    #[cold]
    pub(super) fn stop(
        &mut self,
        members: &mut Members<T>,
        (lane, index): (usize, usize),
        x: SVector<T, N>,
        reason: Reason,
    ) {
        let t = members.t[lane];
        let model = model_of(self.models, index).cast::<T>();
        let reason = jump::behind(toggle::behind(reason, &model, t, &x), &model, t, &x);
        self.stopped.push(Stopped { index, t, reason });
        self.leave(members, (lane, index), x);
    }
}

/// True if some lane [stalls](Scheme::attempt).
#[inline(always)]
fn stalls<V: Lanes>(error: V) -> bool {
    (0..V::LANES).fold(false, |some, lane| some | (error.lane(lane) < V::Scalar::default()))
}

/// Outcome of a step in a lane with non-finite numbers, or in a lane that [stalls](Scheme::attempt). The derivative at
/// the end of the step is checked only if the error is within the tolerance.
#[cold]
fn outcome_of<V: Lanes, const N: usize>(
    (x, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
    mean_square: V::Scalar,
    lane: usize,
) -> Result<V::Scalar, StepFailure> {
    if mean_square < V::Scalar::default() {
        return Err(Stalled.into());
    }
    let slope = slope.filter(|_| is_within_tolerance(mean_square));
    match first_not_finite(x, slope, lane) {
        Some(component) => Err(component.into()),
        None => Ok(mean_square),
    }
}
