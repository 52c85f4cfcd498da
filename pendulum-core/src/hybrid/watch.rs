//! Search for the end of a mode within a step.

use nalgebra::SVector;

#[cfg(feature = "std")]
use super::Law;
use super::kinematics::Kinematics;
use super::mode::Mode;
use super::polynomial::{Course, rate_of, stays_positive};
use super::resolution::NOISE;
use super::sizes::{ForceSizes, Gains};
use super::step::{Place, RIGHT_AGAIN, StepInMode, resolution};
use super::witness::{Values, Witness, Witnesses};
use super::{Constraint, Hold, Hybrid, MAX_CONSTRAINTS};
use crate::dense::{ABOUT_THE_END, Dense};
use crate::error::Reason;
#[cfg(feature = "std")]
use crate::real::lanes::Lanes;
use crate::real::{Float, ulps};
use crate::statistics::Statistics;

/// End of a mode within a step: the fraction of the step, and the witnesses that ended it.
pub(super) type Ended<T> = (T, Witnesses);

/// History of a mode since it began.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModeWatch<T, const N: usize> {
    /// Witnesses of the mode.
    watched: Witnesses,
    /// Witnesses that have been positive.
    pub(super) positive: Witnesses,
    /// True until the first step of the mode is searched.
    starts: bool,
    /// Largest distance of each constraint from its limits since it was held there.
    pub(super) reach: [T; MAX_CONSTRAINTS],
    pub(super) gains: Gains<T, N>,
    /// Sizes of forces and accelerations where the mode began.
    begun: ForceSizes<T>,
    /// Forces at the end of the last step.
    pub(super) forces: Option<[T; MAX_CONSTRAINTS]>,
    /// Spacing of samples, in time, that was fine enough for the forces.
    pub(super) width: T,
    /// Largest holding forces sampled in the mode.
    pub(super) sizes: [T; MAX_CONSTRAINTS],
}

impl<T: Float, const N: usize> ModeWatch<T, N> {
    pub(crate) fn new() -> Self {
        Self {
            watched: Witnesses::default(),
            positive: Witnesses::default(),
            starts: true,
            reach: [T::default(); MAX_CONSTRAINTS],
            gains: Gains::none(),
            begun: ForceSizes::none(),
            forces: None,
            width: T::from_f64(f64::INFINITY),
            sizes: [T::default(); MAX_CONSTRAINTS],
        }
    }

    /// Resets the history for another mode, with its witnesses.
    pub(crate) fn restart(&mut self, (mode, watched): (&Mode, Witnesses), gains: Gains<T, N>, begun: ForceSizes<T>) {
        (self.gains, self.begun, self.watched) = (gains, begun, watched);
        (self.positive, self.starts, self.forces) = (Witnesses::default(), true, None);
        (self.width, self.sizes) = (T::from_f64(f64::INFINITY), [T::default(); MAX_CONSTRAINTS]);
        for (reach, status) in self.reach.iter_mut().zip(mode.0) {
            if status.touches() {
                *reach = T::default();
            }
        }
    }

    /// True if all witnesses of a mode have been positive. If nothing is held, the mode then ends only where one of
    /// them reaches zero.
    pub(crate) fn is_settled(&self) -> bool {
        self.watched.without(self.positive).is_empty()
    }

    /// True if only slips may end a settled mode, and the values of a step prove that none does: its start and the
    /// terms of its polynomial.
    pub(crate) fn outlasts(
        &self,
        (constraints, mode): (&[Constraint<'_>], &Mode),
        (x0, terms): (&SVector<T, N>, &[SVector<T, N>]),
    ) -> bool {
        let goes_on = |(n, witness): (usize, Witness)| {
            let (constraint, sign) = (&constraints[n], mode.0[n].slip());
            witness == Witness::Slip && !constraint.rate.is_empty() && {
                let start = (sign * rate_of(constraint, x0), sign);
                stays_positive(start, (constraint, witness, Kinematics::default()), terms)
            }
        };
        self.is_settled() && self.watched.pairs().all(goes_on)
    }

    /// Updates the distances from the limits for a lane, as [`look`](Self::look) does for a scalar trajectory.
    #[cfg(feature = "std")]
    pub(crate) fn note_lane<V: Lanes<Scalar = T>>(
        &mut self,
        laws: &[Law<V>; MAX_CONSTRAINTS],
        measures: &[[V; 2]; MAX_CONSTRAINTS],
        lane: usize,
    ) {
        for (reach, (law, [value, _])) in self.reach.iter_mut().zip(laws.iter().zip(measures)) {
            if law.low.is_some() || law.high.is_some() {
                let limits = [law.low, law.high].map(|limit| limit.map(|limit| limit.lane(lane)));
                note(reach, nearest(value.lane(lane), limits));
            }
        }
    }

    /// Finds the end of the mode within a step, and counts the evaluations in `work`. Witnesses that are
    /// [`disproved`](disproves) do not end the mode at the start of the step.
    pub(crate) fn look(
        &mut self,
        system: (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
        dense: &Dense<'_, T, N>,
        disproved: Witnesses,
        work: &mut Statistics,
    ) -> Result<Option<Ended<T>>, Reason> {
        let step = StepInMode::new(system, dense);
        let found = self.search(&step, disproved);
        work.evaluations += step.evaluations.get();
        found
    }

    /// Searches polynomials first, then samples the other witnesses of the state up to the zero found, then the forces.
    fn search(&mut self, step: &StepInMode<'_, T, N>, disproved: Witnesses) -> Result<Option<Ended<T>>, Reason> {
        let start = step.place(T::default());
        self.note_reach(step, &start);
        let is_first = core::mem::replace(&mut self.starts, false);
        let mut live = Witnesses::default();
        for (n, witness) in self.watched.pairs() {
            let is_positive = || self.positive.has(n, witness) && step.stays_positive(&start, (n, witness));
            if disproved.has(n, witness) || !is_positive() {
                live.insert(n, witness);
            }
        }
        if live.is_empty() {
            return Ok(None);
        }
        let of_forces = live.filter(|(_, witness)| witness.is_force());
        let of_states = live.without(of_forces).without(disproved);
        let mut ended = None;
        if !of_states.is_empty() {
            let noise = self.noise(step, of_states);
            let (first, unclear) = self.courses(step, &start, (of_states, &noise));
            ended = self.sample_states(step, (&start, is_first), (unclear, &noise), first)?;
        }
        self.positive = self.positive.or(disproved);
        for (n, witness) in disproved.pairs() {
            let only = Witnesses::only(n, witness);
            if let Some(from) = right_again(step, only) {
                let noise = self.noise(step, only);
                ended = self.sample_states(step, (&from, false), (only, &noise), ended)?;
            }
        }
        if !of_forces.is_empty() {
            ended = self.sample_forces(step, of_forces, ended)?;
        }
        Ok(ended.map(|ended| self.with_simultaneous(step, ended, live)))
    }

    /// Finds the first zero among the witnesses of the state that are polynomials of the dense output. Also returns the
    /// witnesses whose course is unclear.
    fn courses(
        &mut self,
        step: &StepInMode<'_, T, N>,
        start: &Place<T>,
        (live, noise): (Witnesses, &Values<T>),
    ) -> (Option<Ended<T>>, Witnesses) {
        let (mut first, mut unclear) = (None, Witnesses::default());
        for (n, witness) in live.pairs() {
            let noise = noise[n][witness.slot()];
            if step.value(start, (n, witness)) > noise {
                self.positive.insert(n, witness);
            }
            let is_positive = self.positive.has(n, witness);
            let passed = if is_positive && !witness.is_gap() {
                T::default()
            } else {
                noise
            };
            match step.course(start, (n, witness), (is_positive, passed)) {
                Course::Unclear => unclear.insert(n, witness),
                Course::Positive { end } if end > noise => self.positive.insert(n, witness),
                Course::Positive { .. } => {}
                Course::Zero { theta, halfway } => {
                    self.positive.insert(n, witness);
                    if witness.is_gap() {
                        note(&mut self.reach[n], halfway);
                    }
                    first = sooner(first, Some((theta, Witnesses::only(n, witness))));
                }
            }
        }
        (first, unclear)
    }

    /// Adds all witnesses that end the mode at the same time.
    fn with_simultaneous(&self, step: &StepInMode<'_, T, N>, (theta, fired): Ended<T>, live: Witnesses) -> Ended<T> {
        let others = live.and(self.positive).without(fired);
        if others.is_empty() {
            return (theta, fired);
        }
        let shortly = theta + resolution(step.dense, step.dense.time(theta));
        let there = step.place(shortly);
        let mut forces = None;
        let is_negative = |&(n, witness): &(usize, Witness)| {
            if witness.is_force() {
                let forces = forces.get_or_insert_with(|| step.forces(shortly));
                return step.margin(forces, (n, witness)) <= -self.noise_of_force(step, n);
            }
            step.value(&there, (n, witness)) <= T::default()
        };
        (theta, fired.or(others.filter(is_negative)))
    }

    /// Locates the end of the mode near the end of a step that was shortened to it. Returns its position, in fractions
    /// of the step from the step's end, and the witnesses. Besides those that fired, others may pass zero before them,
    /// since two close zeros may have come in another order. Beyond [`ABOUT_THE_END`] the position is an estimate. None
    /// if the step shows that no witness that fired ends the mode.
    pub(crate) fn locate(
        &mut self,
        system: (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
        dense: &Dense<'_, T, N>,
        fired: Witnesses,
        work: &mut Statistics,
    ) -> Option<Ended<T>> {
        let step = StepInMode::new(system, dense);
        let about = |place: T, (n, witness): (usize, Witness)| {
            step.zero_about_the_end(place, (n, witness), || {
                if witness.is_force() {
                    return self.noise_of_force(&step, n);
                }
                self.noise(&step, Witnesses::only(n, witness))[n][witness.slot()]
            })
        };
        let mut first = None;
        for (n, witness) in fired.pairs() {
            let place = if self.positive.has(n, witness) {
                about(T::default(), (n, witness))
            } else {
                Some(T::default())
            };
            first = sooner_or_together(first, place, (n, witness), dense);
        }
        let by = first.map_or(T::default(), |(by, _)| by);
        let others = self.positive.without(fired).pairs();
        let mut others = others.filter(|(_, witness)| !witness.is_force()).peekable();
        // the polynomial of the step is not accurate farther on
        if by <= T::from_f64(ABOUT_THE_END) && others.peek().is_some() {
            let there = step.about_end(by);
            for (n, witness) in others {
                if step.value(&there, (n, witness)) <= T::default() {
                    first = sooner_or_together(first, about(by, (n, witness)), (n, witness), dense);
                }
            }
        }
        work.evaluations += step.evaluations.get();
        if first.is_none() {
            self.forces = None;
        }
        first
    }

    /// Rounding error of a holding force near its limit.
    pub(super) fn noise_of_force(&self, step: &StepInMode<'_, T, N>, n: usize) -> T {
        ulps(
            NOISE,
            step.laws[n].sticking.max(self.sizes[n]).max(self.begun.forces[n]),
        )
    }

    /// Rounding errors of some witnesses of the state near zero; 0 for a slip that has been positive.
    fn noise(&self, step: &StepInMode<'_, T, N>, of: Witnesses) -> Values<T> {
        let ends = step.dense.step();
        let mut noise = [[T::default(); 3]; MAX_CONSTRAINTS];
        let mut sizes = None;
        for (n, witness) in of.pairs() {
            if witness == Witness::Slip && self.positive.has(n, witness) {
                continue;
            }
            let (law, noise) = (&step.laws[n], &mut noise[n]);
            let sizes = sizes.get_or_insert_with(|| self.gains.sizes(step.system, ends.t0, &ends.x0));
            let value = self.reach[n].max(sizes.values[n]);
            let beside = |limit: Option<T>| ulps(NOISE, limit.map_or(value, |limit| value.max(limit.abs())));
            let acceleration = self.begun.accelerations[n];
            // a constraint that breaks loose has no rate yet: take its rate after the step, or after the length of the
            // scene
            let speed = (acceleration * ends.h.abs()).max((acceleration * value).sqrt());
            *noise = [
                ulps(NOISE, sizes.rates[n].max(speed)),
                beside(law.low),
                beside(law.high),
            ];
        }
        noise
    }

    /// Updates the largest distances of the constraints from their limits.
    pub(super) fn note_reach(&mut self, step: &StepInMode<'_, T, N>, place: &Place<T>) {
        for (n, law) in step.laws.iter().enumerate().take(step.system.constraints().len()) {
            if !step.mode.is_held(n) {
                note(&mut self.reach[n], nearest(place.value(n), [law.low, law.high]));
            }
        }
    }
}

/// Returns true if a step disproves that witnesses of the state end its mode at its start, at the time `t`: its
/// polynomial is [positive again](right_again) later on.
pub(crate) fn disproves<T: Float, const N: usize>(
    system: (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
    dense: &Dense<'_, T, N>,
    (t, fired): (T, Witnesses),
) -> bool {
    let is_at_the_start = t - dense.step().t0 < T::from_f64(RIGHT_AGAIN[0]) * dense.step().h;
    let is_of_states = fired.pairs().all(|(_, witness)| !witness.is_force());
    is_at_the_start && is_of_states && right_again(&StepInMode::new(system, dense), fired).is_some()
}

/// First of the [`RIGHT_AGAIN`] positions at which all of some witnesses are positive.
fn right_again<T: Float, const N: usize>(step: &StepInMode<'_, T, N>, of: Witnesses) -> Option<Place<T>> {
    let places = RIGHT_AGAIN.map(|theta| step.place(T::from_f64(theta)));
    let is_right = |place: &Place<T>| of.pairs().all(|witness| step.value(place, witness) > T::default());
    places.into_iter().find(is_right)
}

/// Distance from the nearer of two limits; infinite if there is none.
fn nearest<T: Float>(value: T, [low, high]: [Option<T>; 2]) -> T {
    let none = T::from_f64(f64::INFINITY);
    low.map_or(none, |low| value - low)
        .min(high.map_or(none, |high| high - value))
}

/// Updates the largest finite distance from a limit.
fn note<T: Float>(reach: &mut T, near: T) {
    if near > *reach && near < T::from_f64(f64::INFINITY) {
        *reach = near;
    }
}

/// Earlier of two ends of a mode; the first if they coincide.
pub(super) fn sooner<T: Float>(first: Option<Ended<T>>, other: Option<Ended<T>>) -> Option<Ended<T>> {
    match (first, other) {
        (Some(first), Some(other)) if other.0 < first.0 => Some(other),
        _ => first.or(other),
    }
}

/// Adds the zero of one more witness to the first end of a mode so far: it replaces later ones, and joins simultaneous
/// ones.
fn sooner_or_together<T: Float, const N: usize>(
    first: Option<(T, Witnesses)>,
    place: Option<T>,
    (n, witness): (usize, Witness),
    dense: &Dense<'_, T, N>,
) -> Option<(T, Witnesses)> {
    let Some(place) = place else { return first };
    let (earliest, mut fired) = first.unwrap_or((place, Witnesses::default()));
    let resolution = resolution(dense, dense.step().t1);
    if place < earliest - resolution {
        fired = Witnesses::default();
    }
    if place <= earliest + resolution {
        fired.insert(n, witness);
    }
    Some((earliest.min(place), fired))
}
