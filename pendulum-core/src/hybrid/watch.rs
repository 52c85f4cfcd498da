//! The search for the end of a mode within a step.

#[cfg(feature = "std")]
use super::Law;
use super::mode::Mode;
use super::polynomial::Course;
use super::resolution::{NOISE, ulps};
use super::sizes::{ForceSizes, Gains};
use super::step::{ABOUT_THE_END, Place, RIGHT_AGAIN, StepInMode, resolution};
use super::witness::{Values, Witness, Witnesses};
use super::{Hold, Hybrid, MAX_CONSTRAINTS};
use crate::dense::Dense;
use crate::error::Reason;
use crate::real::Float;
#[cfg(feature = "std")]
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;

/// Where a mode ends within a step, in fractions of it, and by which witnesses.
pub(super) type Ended<T> = (T, Witnesses);

/// What is known of a mode since it began.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModeWatch<T, const N: usize> {
    /// The witnesses that have been positive.
    pub(super) positive: Witnesses,
    /// Whether nothing of the mode has been looked at.
    starts: bool,
    /// How far each constraint has been from its limits since it was held there.
    pub(super) reach: [T; MAX_CONSTRAINTS],
    pub(super) gains: Gains<T, N>,
    /// Where the mode began.
    begun: ForceSizes<T>,
    /// The forces at the end of the last step.
    pub(super) forces: Option<[T; MAX_CONSTRAINTS]>,
    /// How far from each other the places were where forces were seen to be close enough.
    pub(super) width: T,
    /// The largest of the forces of what is held that were seen in the mode.
    pub(super) sizes: [T; MAX_CONSTRAINTS],
}

impl<T: Float, const N: usize> ModeWatch<T, N> {
    pub(crate) fn new() -> Self {
        Self {
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

    /// Goes on in another mode.
    pub(crate) fn restart(&mut self, mode: &Mode, gains: Gains<T, N>, begun: ForceSizes<T>) {
        (self.gains, self.begun) = (gains, begun);
        (self.positive, self.starts, self.forces) = (Witnesses::default(), true, None);
        (self.width, self.sizes) = (T::from_f64(f64::INFINITY), [T::default(); MAX_CONSTRAINTS]);
        for (reach, status) in self.reach.iter_mut().zip(mode.0) {
            if status.touches() {
                *reach = T::default();
            }
        }
    }

    /// Whether all witnesses of a mode in which nothing is held have been positive: from then on a mode ends only where
    /// one of them reaches zero.
    #[cfg(feature = "std")]
    pub(crate) fn is_settled(&self, laws: &[Law<T>; MAX_CONSTRAINTS], mode: &Mode) -> bool {
        let is_positive = |n, &witness: &Witness| !witness.exists(&laws[n]) || self.positive.has(n, witness);
        (0..MAX_CONSTRAINTS).all(|n| Witness::of(mode.0[n]).iter().all(|witness| is_positive(n, witness)))
    }

    /// Notes how far the constraints of a lane are from their limits, as [`look`](Self::look) does.
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

    /// Where the mode ends within a step; the work of looking is counted. Where the step starts, those that are
    /// [`disproved`](disproves) do not end it.
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

    /// Polynomials first, then what is looked at in places up to where these end the mode, then the forces.
    fn search(&mut self, step: &StepInMode<'_, T, N>, disproved: Witnesses) -> Result<Option<Ended<T>>, Reason> {
        let start = step.place(T::default());
        self.note_reach(step, &start);
        let is_first = core::mem::replace(&mut self.starts, false);
        let mut live = Witnesses::default();
        for (n, witness) in step.witnesses() {
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

    /// Where the first of some witnesses of the state ends the mode that are polynomials of the dense output; and those
    /// of which the course is unclear.
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

    /// What ends a mode, with all that does so at the same time.
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

    /// Where the mode ends about the end of a step that was taken to there, in fractions of the step from its end, and
    /// by which witnesses: those that fired, or others that pass zero before them, since two that are near to each
    /// other may have come in another order. Farther than [`ABOUT_THE_END`] it is a guess. None where the step shows
    /// that none of those that fired ends it.
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
        // farther on the polynomial of the step does not show them
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

    /// Within what of its limit the force of what is held may be rounding errors.
    pub(super) fn noise_of_force(&self, step: &StepInMode<'_, T, N>, n: usize) -> T {
        ulps(
            NOISE,
            step.laws[n].sticking.max(self.sizes[n]).max(self.begun.forces[n]),
        )
    }

    /// Within what of zero some witnesses of the state may be rounding errors; not of what slips for long.
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
            // what breaks loose from rest has no rate yet: that after the step, or over the length of the scene, counts
            let speed = (acceleration * ends.h.abs()).max((acceleration * value).sqrt());
            *noise = [
                ulps(NOISE, sizes.rates[n].max(speed)),
                beside(law.low),
                beside(law.high),
            ];
        }
        noise
    }

    /// Notes how far the constraints are from their limits.
    pub(super) fn note_reach(&mut self, step: &StepInMode<'_, T, N>, place: &Place<T>) {
        for (n, law) in step.laws.iter().enumerate().take(step.system.constraints().len()) {
            if !step.mode.is_held(n) {
                note(&mut self.reach[n], nearest(place.value(n), [law.low, law.high]));
            }
        }
    }
}

/// A step disproves that witnesses of the state end its mode where it starts, at the time `t`, if its polynomial is
/// [right again](right_again) later on.
pub(crate) fn disproves<T: Float, const N: usize>(
    system: (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
    dense: &Dense<'_, T, N>,
    (t, fired): (T, Witnesses),
) -> bool {
    let is_at_the_start = t - dense.step().t0 < T::from_f64(RIGHT_AGAIN[0]) * dense.step().h;
    let is_of_states = fired.pairs().all(|(_, witness)| !witness.is_force());
    is_at_the_start && is_of_states && right_again(&StepInMode::new(system, dense), fired).is_some()
}

/// From where on the polynomial of a step may be right about witnesses again: where they are positive.
fn right_again<T: Float, const N: usize>(step: &StepInMode<'_, T, N>, of: Witnesses) -> Option<Place<T>> {
    let places = RIGHT_AGAIN.map(|theta| step.place(T::from_f64(theta)));
    let is_right = |place: &Place<T>| of.pairs().all(|witness| step.value(place, witness) > T::default());
    places.into_iter().find(is_right)
}

/// The distance from the nearer of two limits; infinite where there is none.
fn nearest<T: Float>(value: T, [low, high]: [Option<T>; 2]) -> T {
    let none = T::from_f64(f64::INFINITY);
    low.map_or(none, |low| value - low)
        .min(high.map_or(none, |high| high - value))
}

/// Notes a distance from a limit.
fn note<T: Float>(reach: &mut T, near: T) {
    if near > *reach && near < T::from_f64(f64::INFINITY) {
        *reach = near;
    }
}

/// The earlier of two ends of a mode, the first if they are at the same place.
pub(super) fn sooner<T: Float>(first: Option<Ended<T>>, other: Option<Ended<T>>) -> Option<Ended<T>> {
    match (first, other) {
        (Some(first), Some(other)) if other.0 < first.0 => Some(other),
        _ => first.or(other),
    }
}

/// What ends a mode first, and where in fractions of the step, after one more that may.
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
