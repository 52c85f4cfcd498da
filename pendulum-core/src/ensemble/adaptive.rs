//! Many trajectories, each with steps of its own lengths.

use std::ops::Range;

use nalgebra::SVector;

use super::check::{first_not_finite, in_lane, sum};
use super::{Ensemble, EnsembleError, InLanes, MOST_LANES, Stopped, alone, check_models, conclude, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::method::{
    Accepted, Adaptive, Estimates, Failure, NonFinite, Pace, Scheme, StepControl, check_span, check_state,
    is_within_tolerance,
};
use crate::real::lanes::{Isa, Kernel, LaneElement, Lanes};
use crate::solution::Statistics;
use crate::system::Cast;

impl<M, F, T, const N: usize> Ensemble<M, T, N> for Adaptive<F>
where
    M: Cast<N>,
    F: InLanes<M, T, N> + Estimates,
    T: LaneElement,
{
    fn ensemble_on(
        &self,
        isa: Isa,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>> {
        check_span(t0, t1)?;
        check_models(models, starts)?;
        let mut x = starts.to_vec();
        let mut stopped = Vec::new();
        isa.run(March {
            method: self,
            models,
            span: (t0, t1),
            waiting: 0..x.len(),
            x: &mut x,
            stopped: &mut stopped,
        })?;
        conclude(x, stopped)
    }
}

/// Trajectories on their way from the states `x`, which are replaced.
struct March<'a, F, M, T, const N: usize> {
    method: &'a Adaptive<F>,
    models: &'a [M],
    span: (T, T),
    x: &'a mut [SVector<T, N>],
    /// Those that have not begun.
    waiting: Range<usize>,
    stopped: &'a mut Vec<Stopped<T>>,
}

impl<F, M, T, const N: usize> Kernel<T> for March<'_, F, M, T, N>
where
    F: InLanes<M, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
{
    type Output = Result<(), Reason>;

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        if const { !F::NARROW } {
            self.in_lanes::<V::Double>()
        } else if const { V::LANES > 1 } {
            self.in_lanes::<V>()
        } else {
            alone(self.method, self.models, self.span, self.x, self.stopped);
            Ok(())
        }
    }
}

/// A lane, and the trajectory in it.
#[derive(Clone, Copy)]
struct Member<T> {
    /// Which; none where the lane is free.
    index: Option<usize>,
    t: T,
    t_new: T,
    pace: Pace<T>,
    steps: usize,
    /// Whether the last attempt was rejected, so that the length of the next one is known.
    retries: bool,
}

impl<F, M, T, const N: usize> March<'_, F, M, T, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
{
    #[inline(always)]
    fn in_lanes<V: Lanes<Scalar = T>>(mut self) -> Result<(), Reason> {
        if self.models.is_empty() {
            return Ok(());
        }
        let (t0, t1) = self.span;
        let tolerance = self.method.tolerance()?;
        let mut system = F::gather::<V>(|_| &self.models[0]);
        let mut scheme = self.method.family.stages::<V>(&system, Some(tolerance))?;
        let control = self.method.control(tolerance, scheme.error_order(), self.span)?;
        let member = |index| Member {
            index,
            t: t0,
            t_new: t0,
            pace: control.start(),
            steps: 0,
            retries: false,
        };
        let mut members = [member(None); MOST_LANES];
        let members = &mut members[..V::LANES];
        let mut x = SVector::from_element(V::default());
        let mut x_new = x;
        let work = &mut Statistics::default();
        loop {
            // Those that wait take the lanes that are free.
            let mut someone_enters = false;
            for (lane, free) in members.iter_mut().enumerate() {
                if free.index.is_none()
                    && let Some(index) = self.next()
                {
                    *free = member(Some(index));
                    set_lane(&mut x, lane, &self.x[index]);
                    someone_enters = true;
                }
            }
            if members.iter().all(|member| member.index.is_none()) {
                return Ok(());
            }
            let t = V::from_fn(|lane| members[lane].t);
            if someone_enters {
                if self.models.len() > 1 {
                    system = F::gather::<V>(|lane| model_of(self.models, members[lane].index.unwrap_or(0)));
                }
                let slope = scheme.begin(&system, t, &x, work);
                for (lane, member) in members.iter_mut().enumerate() {
                    if let (Some(index), 0) = (member.index, member.steps) {
                        self.begin(&control, member, index, &in_lane(&slope, lane));
                    }
                }
            }
            let proposed = scheme.prepare(&system, t, &x, work);
            for (lane, member) in members.iter_mut().enumerate() {
                if let Some(index) = member.index {
                    let proposed = proposed.filter(|_| !member.retries).map(|h| h.lane(lane));
                    match control.plan(&mut member.pace, (member.t, t1), member.steps, proposed) {
                        Ok(t_new) => member.t_new = t_new,
                        Err(reason) => self.stop(member, index, in_lane(&x, lane), reason),
                    }
                }
            }
            let t_new = V::from_fn(|lane| members[lane].t_new);
            let attempt = scheme.attempt(&system, (t, &x), (t_new, &mut x_new), work);
            let slope = scheme.arrive(&system, (t_new, &x_new), work);
            let sum = sum(&x_new, slope);
            let mut accepted = [true; MOST_LANES];
            for (lane, member) in members.iter_mut().enumerate() {
                let Some(index) = member.index else { continue };
                let outcome = match attempt {
                    Err(stalled) => Err(Failure::from(stalled)),
                    Ok(mean_square) if sum.lane(lane).is_finite() => Ok(mean_square.lane(lane)),
                    Ok(mean_square) => outcome((&x_new, slope), mean_square.lane(lane), lane),
                };
                let proposes = const { <F::Stages<V> as Scheme<F::System<V>, V, N>>::PROPOSES };
                let verdict = control.judge(&mut member.pace, (member.t, member.t_new), outcome, proposes);
                accepted[lane] = matches!(verdict, Ok(true));
                member.steps += 1;
                member.retries = !accepted[lane];
                if accepted[lane] {
                    member.t = member.t_new;
                }
                if let Err(reason) = verdict {
                    self.stop(member, index, in_lane(&x, lane), reason);
                }
            }
            let lanes = if accepted[..V::LANES].contains(&false) {
                Accepted::Lanes(&accepted)
            } else {
                Accepted::All
            };
            scheme.accept(&system, &Step::new((t, x), (t_new, x_new)), lanes, work);
            x = lanes.select(&x_new, &x);
            for (lane, member) in members.iter_mut().enumerate() {
                if member.t == t1
                    && let Some(index) = member.index.take()
                {
                    self.x[index] = in_lane(&x, lane);
                }
            }
        }
    }

    /// The next trajectory, if one waits that has a way to go.
    fn next(&mut self) -> Option<usize> {
        let (t0, t1) = self.span;
        loop {
            let index = self.waiting.next()?;
            match check_state(&self.x[index]) {
                Ok(()) if t0 == t1 => {}
                Ok(()) => return Some(index),
                Err(reason) => self.stopped.push(Stopped { index, t: t0, reason }),
            }
        }
    }

    /// Begins a trajectory with the derivative at its start: finds a first step, where the method does not propose it.
    fn begin(&mut self, control: &StepControl<T>, member: &mut Member<T>, index: usize, slope: &SVector<T, N>) {
        let x = self.x[index];
        if let Err(component) = NonFinite::check(slope) {
            self.stop(member, index, x, component.at_start());
        } else if const { !<F::Scheme as Scheme<M::In<T>, T, N>>::PROPOSES } {
            let model = model_of(self.models, index).cast::<T>();
            control.find_first_step(&mut member.pace, &model, (member.t, &x, slope), self.span.1);
        }
    }

    /// Ends a trajectory before its time, in its last good state.
    #[cold]
    fn stop(&mut self, member: &mut Member<T>, index: usize, x: SVector<T, N>, reason: Reason) {
        let t = member.t;
        self.stopped.push(Stopped { index, t, reason });
        self.x[index] = x;
        (member.index, member.t_new) = (None, t);
    }
}

/// What a step brings in a lane where not all is finite. The derivative at its end does not matter if its error is too
/// large.
#[cold]
fn outcome<V: Lanes, const N: usize>(
    (x, slope): (&SVector<V, N>, Option<&SVector<V, N>>),
    mean_square: V::Scalar,
    lane: usize,
) -> Result<V::Scalar, Failure> {
    let slope = slope.filter(|_| is_within_tolerance(mean_square));
    match first_not_finite(x, slope, lane) {
        Some(component) => Err(component.into()),
        None => Ok(mean_square),
    }
}

/// Replaces the state of a lane.
fn set_lane<V: Lanes, const N: usize>(x: &mut SVector<V, N>, lane: usize, state: &SVector<V::Scalar, N>) {
    for (x, state) in x.iter_mut().zip(state.iter()) {
        *x = V::from_fn(|other| if other == lane { *state } else { x.lane(other) });
    }
}
