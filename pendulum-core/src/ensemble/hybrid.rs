//! Trajectories of hybrid systems: side by side while nothing is held, and one by one where a mode ends, until nothing
//! is held again.

use nalgebra::SVector;

use super::adaptive::March;
use super::check::{in_lane, set_lane};
use super::members::Members;
use super::watch::Watch;
use super::{InLanes, Stopped, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode, Law, MOST, Modes, Status, room};
use crate::method::{Estimates, Method, OneStep, Progress, Scheme, StepControl, Stepper};
use crate::real::lanes::{LaneElement, Lanes};
use crate::statistics::Statistics;
use crate::system::{Cast, Plant, System};

impl<F, M, T, W, const N: usize> March<'_, F, M, T, W, N>
where
    F: InLanes<M, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// Whether all rates that may be hindered are sums of components of the state, so that lanes can tell where they
    /// stay away from zero.
    pub(super) fn has_plain_rates(&self) -> bool {
        let model = self.models.first().map(Cast::cast::<T>);
        let constraints = model
            .as_ref()
            .and_then(System::hybrid)
            .map_or(&[][..], Plant::constraints);
        constraints.iter().all(|constraint| !constraint.rate.is_empty())
    }

    #[inline(always)]
    pub(super) fn in_modes<V: Lanes<Scalar = T>>(mut self) -> Result<(), Reason> {
        let (_, t1) = self.span;
        let tolerance = self.method.tolerance()?;
        let mut system = F::gather::<V>(|_| &self.models[0]);
        let mut scheme = self.method.family.stages::<V>(&system, Some(tolerance), true)?;
        let control = self.method.control(tolerance, scheme.error_order(), self.span)?;
        let mut laws = [Law::default(); MOST];
        let mut hold = Hold::default();
        let mut members = Members::none();
        let mut modes: Vec<Option<Modes<T>>> = vec![None; V::LANES];
        let mut ready: Vec<(usize, Progress<T, N>)> = Vec::new();
        let mut x = SVector::from_element(V::default());
        let mut x_new = x;
        let work = &mut Statistics::default();
        loop {
            if members.some_are_free(V::LANES) {
                let mut someone_enters = false;
                for (lane, modes) in modes.iter_mut().enumerate() {
                    if members.index(lane).is_none()
                        && let Some((index, progress)) = ready.pop().or_else(|| self.start(t1))
                    {
                        members.enter(lane, index, progress.t, progress.pace);
                        members.steps[lane] = progress.steps;
                        set_lane(&mut x, lane, &progress.x);
                        *modes = Some(progress.modes);
                        someone_enters = true;
                    }
                }
                if members.busy(V::LANES).next().is_none() {
                    return Ok(());
                }
                if someone_enters {
                    if self.models.len() > 1 {
                        system = F::gather::<V>(|lane| model_of(self.models, members.index(lane).unwrap_or(0)));
                    }
                    if let Some(hybrid) = system.hybrid() {
                        laws = hybrid.laws();
                    }
                    for (n, force) in hold.forces.iter_mut().enumerate() {
                        let of = |lane: usize| modes[lane].as_ref().map_or(T::default(), |modes| modes.hold.forces[n]);
                        *force = V::from_fn(of);
                    }
                    let t = V::from_fn(|lane| members.t[lane]);
                    scheme.begin(&InMode::new(&system, &hold), t, &x, work);
                }
            }
            let in_mode = InMode::new(&system, &hold);
            let t = V::from_fn(|lane| members.t[lane]);
            let proposed = scheme.prepare(&in_mode, t, &x, work);
            self.plan(&mut members, &control, &x, proposed);
            let t_new = V::from_fn(|lane| members.t_new[lane]);
            let attempt = scheme.attempt(&in_mode, (t, &x), (t_new, &mut x_new), work);
            let slope = scheme.arrive(&in_mode, (t_new, &x_new), work).copied();
            let step = Step::new((t, x), (t_new, x_new));
            // those whose mode may end within the step take it again by themselves
            if let (Some(hybrid), Ok(_)) = (system.hybrid(), attempt) {
                let (constraints, measures) = (hybrid.constraints(), hybrid.measures(t, &x));
                let terms = scheme.dense(&in_mode, &step, work);
                let room = room((constraints, &laws), &measures, terms);
                for (lane, own) in modes.iter_mut().enumerate() {
                    let (Some(index), Some(own)) = (members.index(lane), own) else {
                        continue;
                    };
                    let goes_on = (0..constraints.len()).all(|n| {
                        let [rate, gap] = &room[n];
                        let is_slow = rate.lane(lane) <= T::default();
                        !(is_slow && own.mode.0[n] != Status::Free) && gap.lane(lane) > T::default()
                    });
                    if goes_on {
                        own.watch.note(&laws, &measures, lane);
                    } else {
                        let progress = members.progress(lane, in_lane(&x, lane), *own);
                        members.leave(lane);
                        ready.extend(self.go_on(index, progress, &control).map(|progress| (index, progress)));
                    }
                }
            }
            self.judge(&mut members, &control, &x, attempt, (&x_new, slope.as_ref()));
            let lanes = members.accepted::<V>();
            scheme.accept(&in_mode, &step, lanes, work);
            x = lanes.select(&x_new, &x);
            self.take_out(&mut members, &x);
        }
    }

    /// Starts the next trajectory, up to where it can go on beside others; those that never can are brought to their
    /// end.
    fn start(&mut self, t1: T) -> Option<(usize, Progress<T, N>)> {
        loop {
            let index = self.next()?;
            let model = model_of(self.models, index).cast::<T>();
            let x0 = self.x[index];
            let progress = match self.method.stepper(&model, self.span.0, t1, x0) {
                Ok(stepper) => self.go_alone(index, stepper),
                Err(reason) => {
                    let t = self.span.0;
                    self.stopped.push(Stopped { index, t, reason });
                    None
                }
            };
            if let Some(progress) = progress {
                return Some((index, progress));
            }
        }
    }

    /// Goes on alone with a step in which a mode may end.
    #[cold]
    fn go_on(&mut self, index: usize, progress: Progress<T, N>, control: &StepControl<T>) -> Option<Progress<T, N>> {
        let model = model_of(self.models, index).cast::<T>();
        let tolerance = control.tolerance;
        let stepper = OneStep::<M::In<T>, T, N>::scheme(&self.method.family, &model, Some(tolerance))
            .and_then(|scheme| Stepper::resume(&model, scheme, self.span.1, *control, &progress))
            .and_then(|mut stepper| stepper.step_to_a_mode().map(|()| stepper));
        match stepper {
            Ok(stepper) => self.go_alone(index, stepper),
            Err(reason) => {
                self.stopped.push(Stopped {
                    index,
                    t: progress.t,
                    reason,
                });
                self.x[index] = progress.x;
                None
            }
        }
    }

    /// Goes on alone until the trajectory can go on beside others, or to its end.
    fn go_alone(
        &mut self,
        index: usize,
        mut stepper: Stepper<'_, F::Scheme, M::In<T>, T, N>,
    ) -> Option<Progress<T, N>> {
        while stepper.t() != self.span.1 {
            if stepper.is_settled() {
                return stepper.progress();
            }
            if let Err(reason) = stepper.step_to_a_mode() {
                let t = stepper.t();
                self.stopped.push(Stopped { index, t, reason });
                break;
            }
        }
        self.x[index] = stepper.x();
        None
    }
}
