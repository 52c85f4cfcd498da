//! Trajectories of hybrid systems: in lanes while no constraint is held. At a mode switch a trajectory continues alone
//! until no constraint is held again.

use nalgebra::SVector;

use super::check::{in_lane, set_lane};
use super::leave::Leave;
use super::march::{March, Pacing};
use super::members::Members;
use super::watch::Watch;
use super::{InLanes, Stopped, model_of};
use crate::dense::Step;
use crate::hybrid::{Hold, Hybrid, Kinematics, Law, MAX_CONSTRAINTS, Modes, Status, room};
use crate::method::{Adaptive, Estimates, Method, OneStep, Progress, StepControl, Stepper};
use crate::real::lanes::{LaneElement, Lanes};
use crate::system::{Cast, Plant, System};

impl<F, M, T, W, const N: usize> March<'_, Adaptive<F>, M, T, W, N>
where
    F: InLanes<M, T, N> + Estimates,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// True if the rate of every constraint is a sum of components of the state, so that lanes can bound it away from
    /// zero.
    pub(super) fn has_plain_rates(&self) -> bool {
        let model = self.models.first().map(Cast::cast::<T>);
        let constraints = model
            .as_ref()
            .and_then(System::hybrid)
            .map_or(&[][..], Plant::constraints);
        constraints.iter().all(|constraint| !constraint.rate.is_empty())
    }

    /// Starts the next trajectory and advances it to a point where it can continue in a lane. Trajectories without such
    /// a point are integrated to their end.
    fn start(&mut self) -> Option<(usize, Progress<T, N>)> {
        let t1 = self.span.1;
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

    /// Retakes a step that may contain a mode switch, outside the lanes.
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

    /// Integrates one trajectory until it can continue in a lane, or to its end.
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

/// Trajectories leave their lanes for steps that may contain a mode switch, and return once no constraint is held.
pub(super) struct AtModes<V: Lanes, const N: usize> {
    modes: Vec<Option<Modes<V::Scalar, N>>>,
    /// Trajectories ready to enter a lane.
    ready: Vec<(usize, Progress<V::Scalar, N>)>,
    hold: Hold<V>,
    laws: [Law<V>; MAX_CONSTRAINTS],
}

impl<F, M, V, W, const N: usize> Leave<Adaptive<F>, M, V, W, N> for AtModes<V, N>
where
    F: InLanes<M, V::Scalar, N> + Estimates,
    M: Cast<N>,
    V: Lanes,
    V::Scalar: LaneElement,
    W: Watch<V::Scalar, N>,
{
    const ASKS: bool = true;

    fn none() -> Self {
        Self {
            modes: vec![None; V::LANES],
            ready: Vec::new(),
            hold: Hold::default(),
            laws: [Law::default(); MAX_CONSTRAINTS],
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn enter(
        &mut self,
        march: &mut March<'_, Adaptive<F>, M, V::Scalar, W, N>,
        members: &mut Members<V::Scalar>,
        x: &mut SVector<V, N>,
        _steps: (&mut Pacing<V::Scalar>, &Pacing<V::Scalar>),
    ) -> bool {
        let mut someone_enters = false;
        for (lane, modes) in self.modes.iter_mut().enumerate() {
            if members.index(lane).is_none()
                && let Some((index, progress)) = self.ready.pop().or_else(|| march.start())
            {
                members.enter(lane, index, progress.t, progress.pace);
                members.steps[lane] = progress.steps;
                set_lane(x, lane, &progress.x);
                *modes = Some(progress.modes);
                someone_enters = true;
            }
        }
        someone_enters
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin<S: System<V, N>>(&mut self, system: &S) {
        if let Some(hybrid) = system.hybrid() {
            self.laws = hybrid.laws();
        }
        for (n, force) in self.hold.forces.iter_mut().enumerate() {
            let zero = V::Scalar::default();
            let of = |lane: usize| self.modes[lane].as_ref().map_or(zero, |modes| modes.hold.forces[n]);
            *force = V::from_fn(of);
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn hold(&self) -> &Hold<V> {
        &self.hold
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn check(
        &mut self,
        march: &mut March<'_, Adaptive<F>, M, V::Scalar, W, N>,
        members: &mut Members<V::Scalar>,
        steps: &Pacing<V::Scalar>,
        (hybrid, step, terms): (&dyn Hybrid<V, N>, &Step<V, N>, &[SVector<V, N>]),
    ) {
        let Pacing::Controlled(control) = steps else { return };
        let zero = V::Scalar::default();
        let (constraints, measures) = (hybrid.constraints(), hybrid.measures(step.t0, &step.x0));
        let room = room((constraints, &self.laws, Kinematics::of(hybrid)), &measures, terms);
        for (lane, own) in self.modes.iter_mut().enumerate() {
            let (Some(index), Some(own)) = (members.index(lane), own) else {
                continue;
            };
            let goes_on = (0..constraints.len()).all(|n| {
                let [rate, gap] = &room[n];
                let is_slow = rate.lane(lane) <= zero;
                !(is_slow && own.mode.0[n] != Status::Free) && gap.lane(lane) > zero
            });
            if goes_on {
                own.watch.note_lane(&self.laws, &measures, lane);
            } else {
                let progress = members.progress(lane, in_lane(&step.x0, lane), *own);
                members.leave(lane);
                let went_on = march.go_on(index, progress, control);
                self.ready.extend(went_on.map(|progress| (index, progress)));
            }
        }
    }
}
