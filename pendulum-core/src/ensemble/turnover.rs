//! Trajectories that enter free lanes, and those that leave theirs.

use nalgebra::SVector;

use super::check::{in_lane, set_lanes};
use super::leave::Leave;
use super::march::{March, Paced, Pacing};
use super::members::Members;
use super::watch::Watch;
use super::{Expanded, InLanes, MOST_LANES, Stopped, model_of};
use crate::error::Reason;
use crate::hybrid::{InMode, Modes};
use crate::method::{Early, Method, NonFinite, Pace, Progress, Scheme, Stepper, jump, place, toggle};
use crate::real::lanes::{LaneElement, Lanes};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::Cast;

impl<A, F, M, T, W, const N: usize> March<'_, A, M, T, W, N>
where
    A: Paced<T, Family = F> + Method<M::In<T>, T, N>,
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
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
        let mut entering = [None; MOST_LANES];
        for (lane, entering) in entering.iter_mut().enumerate().take(V::LANES) {
            if members.index(lane).is_none()
                && let Some(index) = self.next()
            {
                members.enter(lane, index, self.span.0, self.pace(index).unwrap_or(pace));
                *entering = Some(index);
            }
        }
        if entering.iter().all(Option::is_none) {
            return false;
        }
        set_lanes(x, |lane| entering[lane].map(|index| &self.x[index]));
        true
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
            match place(self.checked.by(self.models, index), t0, &self.x[index]) {
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

    /// Initialises the method in all lanes and finds the first steps of trajectories that have just entered.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn begin_all<V, L>(
        &mut self,
        system: &Expanded<M, V, N>,
        (leave, scheme): (&mut L, &mut F::Stages<V>),
        members: &mut Members<T>,
        (steps, x): (&Pacing<T>, &SVector<V, N>),
    ) where
        V: Lanes<Scalar = T>,
        L: Leave<A, M, V, W, N>,
    {
        leave.begin(system);
        let (mode, work) = (InMode::new(system, leave.hold()), &mut Statistics::default());
        let t = V::from_fn(|lane| members.t[lane]);
        if const { L::ASKS } {
            // Each trajectory was initialised by its own stepper.
            scheme.begin(&mode, t, x, work);
            return;
        }
        let enters = |members: &Members<T>, lane: usize| members.steps[lane] == 0;
        for (lane, index) in members.busy(V::LANES).filter(|&(lane, _)| enters(members, lane)) {
            scheme.enter(lane, index);
        }
        let slope = scheme.begin(&mode, t, x, work);
        for (lane, index) in members.busy_at_first(V::LANES) {
            if enters(members, lane) {
                let work = scheme.work_in(lane, work);
                self.begin(steps, members, (lane, index), &in_lane(&slope, lane), work);
            }
        }
    }

    /// Finds a first step if the method proposes none, and starts a trajectory.
    fn begin(
        &mut self,
        steps: &Pacing<T>,
        members: &mut Members<T>,
        (lane, index): (usize, usize),
        slope: &SVector<T, N>,
        mut work: Statistics,
    ) {
        let (t, x) = (members.t[lane], self.x[index]);
        let control = match steps {
            Pacing::Controlled(control) => Some(control),
            Pacing::Equal(_) => None,
        };
        if let Some(control) = control
            && self.pace(index).is_none()
            && const { !<F::Scheme as Scheme<M::In<T>, T, N>>::PROPOSES }
        {
            let model = self.checked.by(self.models, index);
            if let Some(h) = control.first_step(model, (t, &x, slope), self.span.1) {
                members.h[lane] = h;
                work.evaluations += 1;
            }
        }
        if !self.starts(index, (t, x, slope), control.map(|control| control.tolerance), &work) {
            members.leave(lane);
        }
    }

    /// Starts a trajectory at a point with this derivative, after this work. Returns false if it stops there.
    pub(super) fn starts(
        &mut self,
        index: usize,
        (t, x, slope): (T, SVector<T, N>, &SVector<T, N>),
        tolerance: Option<Tolerance<T>>,
        work: &Statistics,
    ) -> bool {
        if let Err(component) = NonFinite::check(slope) {
            let reason = component.at_start();
            self.stopped.push(Stopped { index, t, reason });
            return false;
        }
        let started = self.watch.start(index, (t, &x), tolerance, work);
        if let Err(reason) = started {
            self.stop_at(index, (t, x), reason);
            self.watch.finish(index);
            return false;
        }
        true
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

    /// Removes trajectories that have turned stiff, and integrates them to their ends.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn take_out_stiff<V: Lanes<Scalar = T>>(
        &mut self,
        members: &mut Members<T>,
        scheme: &mut F::Stages<V>,
        steps: &Pacing<T>,
        x: &SVector<V, N>,
    ) {
        for (lane, index) in members.busy_at_first(V::LANES) {
            if F::leaves(scheme, lane) {
                let modes = Modes::none(members.t[lane]);
                self.go_on_alone(index, &members.progress(lane, in_lane(x, lane), modes), steps);
                members.leave(lane);
                // the empty lane requests nothing
                scheme.enter(lane, index);
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

    /// Ends a trajectory in the state `x`.
    pub(super) fn leave(&mut self, members: &mut Members<T>, (lane, index): (usize, usize), x: SVector<T, N>) {
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
        self.stop_at(index, (members.t[lane], x), reason);
        self.leave(members, (lane, index), x);
    }

    /// Reports a trajectory that stops at a point.
    fn stop_at(&mut self, index: usize, (t, x): (T, SVector<T, N>), reason: Reason) {
        let model = model_of(self.models, index).cast::<T>();
        let reason = jump::behind(toggle::behind(reason, &model, t, &x), &model, t, &x);
        self.stopped.push(Stopped { index, t, reason });
    }
}
