//! The search for the end of a mode within a step.

#[cfg(feature = "std")]
use super::Law;
use super::fired::{BACKWARD, FORWARD, Fired, UPPER, Values, WAYS};
use super::functions::{Place, Scene, resolution};
#[cfg(feature = "std")]
use super::mode::Status;
use super::mode::{Hold, Mode};
use super::resolution::{NOISE, ulps};
use super::sizes::{ForceSizes, Gains};
use super::view::{Seen, View};
use super::{Hybrid, MOST};
use crate::dense::Dense;
use crate::error::Reason;
use crate::real::Float;
#[cfg(feature = "std")]
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;

/// Forces are looked at so closely that none bends by more than this part of its size between three places.
const MOST_BEND: f64 = 0.25;
/// But not in more places of a step.
const MOST_FORCES: usize = 1 << 10;

/// What is known of a mode since it began.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch<T> {
    /// The functions that have been positive.
    positive: Fired,
    /// Whether nothing of the mode has been looked at.
    starts: bool,
    /// How far each constraint has been from its limits since it was held there.
    pub(super) reach: [T; MOST],
    pub(super) gains: Gains<T>,
    /// Where the mode began.
    begun: ForceSizes<T>,
    /// The forces at the end of the last step.
    forces: Option<[T; MOST]>,
    /// How far from each other the places were where forces were seen to be close enough.
    width: T,
    /// The largest of the forces of what is held that were seen in the mode.
    sizes: [T; MOST],
}

impl<T: Float> Watch<T> {
    pub(crate) fn new() -> Self {
        Self {
            positive: Fired::default(),
            starts: true,
            reach: [T::default(); MOST],
            gains: Gains::none(),
            begun: ForceSizes::none(),
            forces: None,
            width: T::from_f64(f64::INFINITY),
            sizes: [T::default(); MOST],
        }
    }

    /// Goes on in another mode.
    pub(crate) fn restart(&mut self, mode: &Mode, gains: Gains<T>, begun: ForceSizes<T>) {
        (self.gains, self.begun) = (gains, begun);
        (self.positive, self.starts, self.forces) = (Fired::default(), true, None);
        (self.width, self.sizes) = (T::from_f64(f64::INFINITY), [T::default(); MOST]);
        for (reach, status) in self.reach.iter_mut().zip(mode.0) {
            if status.touches() {
                *reach = T::default();
            }
        }
    }

    /// Whether all functions of a mode in which nothing is held have been positive: from then on a mode ends only where
    /// one of them reaches zero.
    #[cfg(feature = "std")]
    pub(crate) fn is_settled(&self, laws: &[Law<T>; MOST], mode: &Mode) -> bool {
        (0..MOST).all(|n| {
            let slips = matches!(mode.0[n], Status::Forward | Status::Backward);
            let watched = [
                (FORWARD, slips),
                (BACKWARD, laws[n].low.is_some()),
                (UPPER, laws[n].high.is_some()),
            ];
            watched.into_iter().all(|(way, is)| !is || self.positive.has(n, way))
        })
    }

    /// Notes how far the constraints of a lane are from their limits, as [`look`](Self::look) does.
    #[cfg(feature = "std")]
    pub(crate) fn note<V: Lanes<Scalar = T>>(&mut self, laws: &[Law<V>; MOST], measures: &[[V; 2]; MOST], lane: usize) {
        for (reach, (law, [value, _])) in self.reach.iter_mut().zip(laws.iter().zip(measures)) {
            let none = T::from_f64(f64::INFINITY);
            let low = law.low.map_or(none, |low| value.lane(lane) - low.lane(lane));
            let high = law.high.map_or(none, |high| high.lane(lane) - value.lane(lane));
            note_near(reach, low.min(high));
        }
    }

    /// Where the mode ends within a step, in fractions of it, and by which functions; the work of looking is counted.
    ///
    /// Forces take an evaluation each time.
    pub(crate) fn look<const N: usize>(
        &mut self,
        system: (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
        dense: &Dense<'_, T, N>,
        work: &mut Statistics,
    ) -> Result<Option<(T, Fired)>, Reason> {
        let laws = system.0.laws();
        let scene = Scene::new(system, &laws, dense);
        let found = self.search(&scene);
        work.evaluations += scene.evaluations.get();
        found
    }

    fn search<const N: usize>(&mut self, scene: &Scene<'_, T, N>) -> Result<Option<(T, Fired)>, Reason> {
        let step = scene.dense.step();
        let known = core::mem::take(&mut self.forces);
        let known = known.or_else(|| scene.forces(step.t0, &step.x0));
        let start = scene.place(T::default(), step.t0, &step.x0, known);
        self.note_reach(&start.values, scene.mode);
        let live = scene.live(&start.values, self.positive);
        let starts = core::mem::replace(&mut self.starts, false);
        if live.is_empty() {
            return Ok(None);
        }
        let noise = self.noise(scene);
        for (n, way) in live.pairs() {
            if start.values[n][way] > noise[n][way] {
                self.positive.insert(n, way);
            }
        }
        let mut view = View {
            start,
            starts,
            live,
            noise,
            bends: [T::default(); MOST],
            count: self.count_of_forces(scene),
        };
        let positive = self.positive;
        let mut is_first = true;
        loop {
            let bends = view.bends;
            let (found, bend) = self.pass(scene, &mut view)?;
            if bend > T::from_f64(MOST_BEND) && view.count < MOST_FORCES {
                (view.count, self.positive) = (2 * view.count, positive);
                continue;
            }
            // what moves by itself may do so faster than could be seen up to there
            if is_first
                && let Some((_, fired)) = found
                && view.look_ahead(scene, fired, &bends)
            {
                (is_first, self.positive) = (false, positive);
                continue;
            }
            let width = step.h.abs() / T::from_f64(view.count as f64);
            self.width = if bend == T::default() {
                T::from_f64(f64::INFINITY)
            } else {
                width
            };
            return Ok(found);
        }
    }

    /// In how many places of a step forces are looked at: as many as its polynomial can have extrema, and not much
    /// farther from each other than where they were seen to be close enough. A power of two.
    fn count_of_forces<const N: usize>(&self, scene: &Scene<'_, T, N>) -> usize {
        if scene.hold.held == 0 {
            return 1;
        }
        let least = scene.dense.terms().len().div_ceil(2).next_power_of_two();
        let widest = T::from_f64(2.0) * self.width;
        let wanted = libm::ceil((scene.dense.step().h.abs() / widest).to_f64()) as usize;
        wanted.next_power_of_two().clamp(least.max(2), MOST_FORCES)
    }

    /// Looks for the end of a mode at some places, and at forces in equal distances: what ends it, and how much at most
    /// a force bends between three of these, relative to its limit.
    fn pass<const N: usize>(
        &mut self,
        scene: &Scene<'_, T, N>,
        view: &mut View<T>,
    ) -> Result<(Option<(T, Fired)>, T), Reason> {
        let (mut of_state, mut of_forces) = (Seen::new(view.start), Seen::new(view.start));
        let mut places = view.places(scene.mode).peekable();
        let mut bend = T::default();
        let mut nth = 1;
        while nth <= view.count {
            let with_forces = T::from_f64(nth as f64 / view.count as f64);
            let theta = places.next_if(|&place| place <= with_forces).unwrap_or(with_forces);
            let is_of_forces = theta == with_forces;
            nth += usize::from(is_of_forces);
            let (t, x) = scene.at(theta);
            let forces = if is_of_forces { scene.forces(t, &x) } else { None };
            let here = scene.place(theta, t, &x, forces);
            self.note_reach(&here.values, scene.mode);
            let mut first = self.first(scene, view, false, (&of_state, &here))?;
            // forces also where something else ends the mode
            let of_held = match first {
                Some((theta, _)) if !is_of_forces => {
                    let (t, x) = scene.at(theta);
                    Some(scene.place(theta, t, &x, scene.forces(t, &x)))
                }
                _ => is_of_forces.then_some(here),
            };
            if let Some(forces) = &forces {
                let sizes = self.sizes.iter_mut().zip(forces);
                sizes.for_each(|(size, force)| *size = size.max(force.abs()));
                if let Some(earlier) = &of_forces.earlier {
                    bend = bend.max(scene.bend([earlier, &of_forces.last, &here], &self.sizes));
                }
            }
            if let Some(here) = &of_held
                && let Some(by_force) = self.first(scene, view, true, (&of_forces, here))?
                && first.is_none_or(|(first, _)| by_force.0 < first)
            {
                first = Some(by_force);
            }
            if let Some((theta, fired)) = first {
                let fired = self.with_simultaneous(scene, (theta, fired), (view.live, &view.noise));
                return Ok((Some((theta, fired)), bend));
            }
            of_state.go_to(here);
            if is_of_forces {
                of_forces.go_to(here);
                self.forces = forces;
            }
        }
        Ok((None, bend))
    }

    /// Where the first of the functions, of what is held or of what is not, ends the mode up to the place `here`.
    fn first<const N: usize>(
        &mut self,
        scene: &Scene<'_, T, N>,
        view: &mut View<T>,
        of_held: bool,
        (seen, here): (&Seen<Place<T>>, &Place<T>),
    ) -> Result<Option<(T, Fired)>, Reason> {
        let mut first: Option<(T, Fired)> = None;
        for (n, way) in view.live.pairs().filter(|&(n, _)| scene.mode.is_held(n) == of_held) {
            let value = here.values[n][way];
            if value.to_f64().is_nan() {
                let constraint = scene.system.constraints()[n].name;
                let t = scene.dense.time(here.theta).to_f64();
                return Err(Reason::ConstraintNotFinite { constraint, t });
            }
            let (earlier, last_two) = (seen.earlier.as_ref(), [&seen.last, here]);
            let place = if !self.positive.has(n, way) {
                if value > view.noise[n][way] {
                    self.positive.insert(n, way);
                }
                scene.end_at_the_start((n, way), view.noise[n][way], [&view.start, &seen.last, here])
            } else if of_held || way == FORWARD {
                let noise = if of_held { view.noise[n][way] } else { T::default() };
                scene.zero((n, way), noise, earlier, last_two)
            } else {
                let known = (&mut view.bends[n], view.noise[n][way]);
                scene.zero_of_gap((n, way), earlier, last_two, known)
            };
            if let Some(place) = place
                && first.is_none_or(|(first, _)| place < first)
            {
                let mut fired = Fired::default();
                fired.insert(n, way);
                first = Some((place, fired));
            }
        }
        Ok(first)
    }

    /// What ends a mode, with all that does so at the same time.
    fn with_simultaneous<const N: usize>(
        &self,
        scene: &Scene<'_, T, N>,
        (theta, mut fired): (T, Fired),
        (live, noise): (Fired, &Values<T>),
    ) -> Fired {
        let shortly = theta + resolution(scene.dense, scene.dense.time(theta));
        let (t, x) = scene.at(shortly);
        let values = scene.place(shortly, t, &x, scene.forces(t, &x)).values;
        for (n, way) in live.pairs() {
            let noise = if scene.mode.is_held(n) {
                noise[n][way]
            } else {
                T::default()
            };
            if self.positive.has(n, way) && values[n][way] <= -noise {
                fired.insert(n, way);
            }
        }
        fired
    }

    /// Where the mode ends about the end of a step that was taken to there, in fractions of the step from its end, and
    /// by which functions: those that fired, or others that pass zero before them, since two that are near to each
    /// other may have come in another order. None where the step shows that none of those that fired ends it.
    pub(crate) fn locate<const N: usize>(
        &mut self,
        system: (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
        dense: &Dense<'_, T, N>,
        fired: Fired,
        work: &mut Statistics,
    ) -> Option<(T, Fired)> {
        let laws = system.0.laws();
        let scene = Scene::new(system, &laws, dense);
        let noise = self.noise(&scene);
        let mut first = None;
        for (n, way) in fired.pairs() {
            let place = if self.positive.has(n, way) {
                scene.zero_about_the_end(T::default(), (n, way), noise[n][way])
            } else {
                Some(T::default())
            };
            first = earlier_of(first, place, (n, way), dense);
        }
        let by = first.map_or(T::default(), |(by, _)| by);
        let there = scene.place(by, dense.step().t1 + by * dense.step().h, &dense.about_end(by), None);
        for (n, way) in self.positive.without(fired).pairs() {
            if !scene.mode.is_held(n) && there.values[n][way] <= T::default() {
                let place = scene.zero_about_the_end(by, (n, way), noise[n][way]);
                first = earlier_of(first, place, (n, way), dense);
            }
        }
        work.evaluations += scene.evaluations.get();
        if first.is_none() {
            self.forces = None;
        }
        first
    }

    /// Within what of zero the functions may be rounding errors.
    fn noise<const N: usize>(&self, scene: &Scene<'_, T, N>) -> Values<T> {
        let step = scene.dense.step();
        let sizes = self.gains.sizes(scene.system, step.t0, &step.x0);
        let mut noise = [[T::default(); WAYS]; MOST];
        for (n, noise) in noise.iter_mut().enumerate().take(scene.system.constraints().len()) {
            let law = &scene.laws[n];
            if scene.mode.is_held(n) {
                let force = law.sticking.max(self.sizes[n]).max(self.begun.forces[n]);
                *noise = [ulps(NOISE, force); WAYS];
                continue;
            }
            let value = self.reach[n].max(sizes.values[n]);
            let beside = |limit: Option<T>| ulps(NOISE, limit.map_or(value, |limit| value.max(limit.abs())));
            let acceleration = self.begun.accelerations[n];
            // what breaks loose from rest has no rate yet: that after the step, or over the length of the scene, counts
            let speed = (acceleration * step.h.abs()).max((acceleration * value).sqrt());
            noise[FORWARD] = ulps(NOISE, sizes.rates[n].max(speed));
            (noise[BACKWARD], noise[UPPER]) = (beside(law.low), beside(law.high));
        }
        noise
    }

    fn note_reach(&mut self, values: &Values<T>, mode: &Mode) {
        for ((reach, values), status) in self.reach.iter_mut().zip(values).zip(mode.0) {
            if !status.is_held() {
                note_near(reach, values[BACKWARD].min(values[UPPER]));
            }
        }
    }
}

/// Notes a distance from a limit; it is infinite where there is none.
fn note_near<T: Float>(reach: &mut T, near: T) {
    if near > *reach && near < T::from_f64(f64::INFINITY) {
        *reach = near;
    }
}

/// What ends a mode first, and where in fractions of the step, after one more that may.
fn earlier_of<T: Float, const N: usize>(
    first: Option<(T, Fired)>,
    place: Option<T>,
    (n, way): (usize, usize),
    dense: &Dense<'_, T, N>,
) -> Option<(T, Fired)> {
    let Some(place) = place else { return first };
    let (earliest, mut fired) = first.unwrap_or((place, Fired::default()));
    let resolution = resolution(dense, dense.step().t1);
    if place < earliest - resolution {
        fired = Fired::default();
    }
    if place <= earliest + resolution {
        fired.insert(n, way);
    }
    Some((earliest.min(place), fired))
}
