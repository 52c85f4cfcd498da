//! The search for the end of a mode within a step.

use core::cell::Cell;

use nalgebra::SVector;

use super::held::forces;
use super::mode::{Hold, Mode, Status};
use super::{Constraint, Hybrid, Law, MOST};
use crate::dense::Dense;
use crate::error::Reason;
use crate::method::{MAX_DEGREE, dip, first_zero, places, root};
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;
use crate::taylor::MAX_ORDER;

/// How a constraint may end a mode: by each of three functions that are positive as long as the mode lasts.
pub(super) const WAYS: usize = 3;
/// The rate while it slips; what friction or a contact can still take before it gives way forward.
pub(super) const FORWARD: usize = 0;
/// The distance from the lower limit; what can still be taken before it gives way backward.
pub(super) const BACKWARD: usize = 1;
/// The distance from the upper limit.
pub(super) const UPPER: usize = 2;

/// Ends of modes within this many ulps of the time are simultaneous.
const SIMULTANEOUS_ULPS: f64 = 4.0;
/// What leaves a limit has left it beyond this many ulps of the size of all positions.
const NOISE_ULPS: f64 = 16.0;
/// An acceleration that is this part of the one at the end of a step, or less, may be a rounding error.
const LEAST_ACCELERATION: f64 = 1e-6;

/// A step that was taken to the end of a mode is searched so far back from its end, in fractions of it, and beyond it
/// so far as the polynomial is as exact there.
const BACK: [f64; 8] = [1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.99];
const BEYOND: usize = 4;

/// Forces are looked at so closely that none bends by more than this part of its size between three places.
const MOST_BEND: f64 = 0.25;
/// But not in more places of a step.
const MOST_FORCES: usize = 1 << 10;

/// Bounds of polynomials have this part of all their terms to spare.
const SLACK: f64 = 1e-4;

/// The functions of all constraints, those of one after those of the other; infinite where there is none.
type Values<T> = [[T; WAYS]; MOST];

/// A place within a step, in fractions of it, with the functions there and the rates of all constraints.
#[derive(Clone, Copy)]
struct Place<T> {
    theta: T,
    values: Values<T>,
    rates: [T; MOST],
}

/// Which functions, as bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Fired(u32);

impl Fired {
    pub(super) fn has(self, constraint: usize, way: usize) -> bool {
        self.0 & 1 << (constraint * WAYS + way) != 0
    }

    fn insert(&mut self, constraint: usize, way: usize) {
        self.0 |= 1 << (constraint * WAYS + way);
    }

    fn without(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The first constraint of which one is.
    pub(crate) fn first(self) -> usize {
        self.0.trailing_zeros() as usize / WAYS
    }

    fn pairs(mut self) -> impl Iterator<Item = (usize, usize)> {
        core::iter::from_fn(move || {
            let slot = self.0.trailing_zeros() as usize;
            self.0 &= self.0.wrapping_sub(1);
            (slot < MOST * WAYS).then_some((slot / WAYS, slot % WAYS))
        })
    }
}

/// What is known of a mode since it began.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch<T> {
    /// The functions that have been positive.
    positive: Fired,
    /// Whether nothing of the mode has been looked at.
    starts: bool,
    /// How far each constraint has been from its limits since it was held there.
    pub(super) reach: [T; MOST],
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
            forces: None,
            width: T::from_f64(f64::INFINITY),
            sizes: [T::default(); MOST],
        }
    }

    /// Goes on in another mode.
    pub(crate) fn restart(&mut self, mode: &Mode) {
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
        (system, mode, hold): (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
        dense: &Dense<'_, T, N>,
        work: &mut Statistics,
    ) -> Result<Option<(T, Fired)>, Reason> {
        let laws = system.laws();
        let scene = Scene::new((system, mode, hold), &laws);
        let found = self.search(&scene, dense);
        work.evaluations += scene.evaluations.get();
        found
    }

    fn search<const N: usize>(
        &mut self,
        scene: &Scene<'_, T, N>,
        dense: &Dense<'_, T, N>,
    ) -> Result<Option<(T, Fired)>, Reason> {
        let step = dense.step();
        let known = core::mem::take(&mut self.forces);
        let known = known.or_else(|| scene.forces(step.t0, &step.x0));
        let start = scene.place(T::default(), step.t0, &step.x0, known);
        self.note_reach(&start.values, scene.mode);
        let live = scene.live(&start.values, self.positive, dense);
        let was_start = core::mem::replace(&mut self.starts, false);
        if live.is_empty() {
            return Ok(None);
        }
        let noise = self.noise(scene, dense);
        for (n, way) in live.pairs() {
            if start.values[n][way] > noise[n] {
                self.positive.insert(n, way);
            }
        }
        // what rebounds may come back at once
        let free = || live.pairs().filter(|&(n, _)| !scene.mode.is_held(n));
        let may_come_back = free().any(|(_, way)| way != FORWARD);
        let places = || places::<T>(was_start && may_come_back).filter(|_| free().next().is_some());
        let mut count = self.count_of_forces(scene, dense);
        loop {
            let (found, bend) = self.pass(scene, dense, live, &noise, start, (places(), count))?;
            if bend <= T::from_f64(MOST_BEND) || count >= MOST_FORCES {
                let width = step.h.abs() / T::from_f64(count as f64);
                self.width = if bend == T::default() {
                    T::from_f64(f64::INFINITY)
                } else {
                    width
                };
                return Ok(found);
            }
            count *= 2;
        }
    }

    /// In how many places of a step forces are looked at: as many as its polynomial can have extrema, and not much
    /// farther from each other than where they were seen to be close enough. A power of two.
    fn count_of_forces<const N: usize>(&self, scene: &Scene<'_, T, N>, dense: &Dense<'_, T, N>) -> usize {
        if scene.hold.held == 0 {
            return 1;
        }
        let least = dense.terms().len().div_ceil(2).next_power_of_two();
        let widest = T::from_f64(2.0) * self.width;
        let wanted = libm::ceil((dense.step().h.abs() / widest).to_f64()) as usize;
        wanted.next_power_of_two().clamp(least.max(2), MOST_FORCES)
    }

    /// Looks for the end of a mode at some places, and at forces in equal distances: what ends it, and how much at most
    /// a force bends between three of these, relative to its limit.
    fn pass<const N: usize>(
        &mut self,
        scene: &Scene<'_, T, N>,
        dense: &Dense<'_, T, N>,
        live: Fired,
        noise: &[T; MOST],
        start: Place<T>,
        (places, count): (impl Iterator<Item = T>, usize),
    ) -> Result<(Option<(T, Fired)>, T), Reason> {
        let (mut of_state, mut of_forces) = (Seen::new(start), Seen::new(start));
        let mut places = places.peekable();
        let mut bend = T::default();
        let mut nth = 1;
        while nth <= count {
            let with_forces = T::from_f64(nth as f64 / count as f64);
            let theta = places.next_if(|&place| place <= with_forces).unwrap_or(with_forces);
            let is_of_forces = theta == with_forces;
            nth += usize::from(is_of_forces);
            let (t, x) = (dense.time(theta), dense.at_fraction(theta));
            let forces = if is_of_forces { scene.forces(t, &x) } else { None };
            let here = scene.place(theta, t, &x, forces);
            self.note_reach(&here.values, scene.mode);
            let mut first = self.first(scene, dense, live, noise, (false, &start, &of_state, &here))?;
            // forces also where something else ends the mode
            let of_held = match first {
                Some((theta, _)) if !is_of_forces => {
                    let (t, x) = (dense.time(theta), dense.at_fraction(theta));
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
                && let Some(by_force) = self.first(scene, dense, live, noise, (true, &start, &of_forces, here))?
                && first.is_none_or(|(first, _)| by_force.0 < first)
            {
                first = Some(by_force);
            }
            if let Some((theta, fired)) = first {
                let fired = self.with_simultaneous(scene, dense, (theta, fired), live);
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
        dense: &Dense<'_, T, N>,
        live: Fired,
        noise: &[T; MOST],
        (of_held, start, seen, here): (bool, &Place<T>, &Seen<T>, &Place<T>),
    ) -> Result<Option<(T, Fired)>, Reason> {
        let zero = T::default();
        let mut first: Option<(T, Fired)> = None;
        for (n, way) in live.pairs().filter(|&(n, _)| scene.mode.is_held(n) == of_held) {
            let at = |place: &Place<T>| (place.theta, place.values[n][way]);
            let (theta, value) = at(here);
            if value.to_f64().is_nan() {
                let constraint = scene.system.constraints()[n].name;
                let t = dense.time(theta).to_f64();
                return Err(Reason::ConstraintNotFinite { constraint, t });
            }
            let is_gap = !of_held && way != FORWARD;
            let outward = if way == UPPER { -dense.step().h } else { dense.step().h };
            let with_slope = |place: &Place<T>| (place.theta, [place.values[n][way], outward * place.rates[n]]);
            let function = |theta: T| scene.value(dense.time(theta), &dense.at_fraction(theta), n, way);
            let place = if !self.positive.has(n, way) {
                if value > noise[n] {
                    self.positive.insert(n, way);
                }
                // what leaves a limit may seem to start beyond it, by the error of the polynomial
                let is_thrown_on = theta * with_slope(start).1[1] < -noise[n];
                let leaves = || {
                    let departs = with_slope(here).1[1] >= zero;
                    departs || !is_thrown_on && !scene.is_pushed_on(dense, theta, (n, way))
                };
                let is_rate = !of_held && way == FORWARD;
                let shifted = |(theta, value): (T, T)| (theta, value + noise[n]);
                let (before, after) = (shifted(at(&seen.last)), shifted(at(here)));
                let ends = after.1 < zero && !(is_gap && theta != T::from_f64(1.0) && leaves());
                ends.then(|| {
                    if is_rate || seen.last.theta == zero && before.1 <= zero {
                        theta
                    } else if before.1 <= zero {
                        // since there it has not seemed to leave
                        seen.last.theta
                    } else {
                        root(|theta| function(theta) + noise[n], before, after)
                    }
                })
            } else if is_gap {
                let function = |theta: T| {
                    let [value, rate] = scene.system.measures(dense.time(theta), &dense.at_fraction(theta))[n];
                    [scene.of(n, [value, rate], zero)[way], outward * rate]
                };
                let places = [seen.earlier.as_ref(), Some(&seen.last), Some(here)].map(|place| place.map(with_slope));
                first_zero(function, places, noise[n])
            } else if value <= zero {
                Some(root(function, at(&seen.last), at(here)))
            } else if let Some(earlier) = &seen.earlier
                && at(earlier).1 > zero
                && let Some(bottom) = dip(function, [at(earlier), at(&seen.last), at(here)])
            {
                Some(root(function, at(earlier), bottom))
            } else {
                None
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
        dense: &Dense<'_, T, N>,
        (theta, mut fired): (T, Fired),
        live: Fired,
    ) -> Fired {
        let shortly = theta + resolution(dense, dense.time(theta));
        let (t, x) = (dense.time(shortly), dense.at_fraction(shortly));
        let values = scene.place(shortly, t, &x, scene.forces(t, &x)).values;
        for (n, way) in live.pairs() {
            if self.positive.has(n, way) && values[n][way] <= T::default() {
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
        (system, mode, hold): (&dyn Hybrid<T, N>, &Mode, &Hold<T>),
        dense: &Dense<'_, T, N>,
        fired: Fired,
        work: &mut Statistics,
    ) -> Option<(T, Fired)> {
        let laws = system.laws();
        let scene = Scene::new((system, mode, hold), &laws);
        let noise = self.noise(&scene, dense);
        let mut first = None;
        for (n, way) in fired.pairs() {
            let place = if self.positive.has(n, way) {
                scene.zero_about_the_end(dense, T::default(), (n, way), noise[n])
            } else {
                Some(T::default())
            };
            first = earlier_of(first, place, (n, way), dense);
        }
        let by = first.map_or(T::default(), |(by, _)| by);
        let there = scene.place(by, dense.step().t1 + by * dense.step().h, &dense.about_end(by), None);
        for (n, way) in self.positive.without(fired).pairs() {
            if !mode.is_held(n) && there.values[n][way] <= T::default() {
                first = earlier_of(
                    first,
                    scene.zero_about_the_end(dense, by, (n, way), noise[n]),
                    (n, way),
                    dense,
                );
            }
        }
        work.evaluations += scene.evaluations.get();
        if first.is_none() {
            self.forces = None;
        }
        first
    }

    /// Within what of zero the functions of each constraint may be rounding errors.
    fn noise<const N: usize>(&self, scene: &Scene<'_, T, N>, dense: &Dense<'_, T, N>) -> [T; MOST] {
        let step = dense.step();
        let sizes = sizes(scene.system, scene.laws, step.t0, &step.x0);
        core::array::from_fn(|n| T::from_f64(NOISE_ULPS) * T::EPSILON * self.reach[n].max(sizes[n]))
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

/// Within what part of a step ends of modes are simultaneous.
fn resolution<T: Float, const N: usize>(dense: &Dense<'_, T, N>, t: T) -> T {
    let h = dense.step().h.abs();
    T::from_f64(SIMULTANEOUS_ULPS) * T::EPSILON * t.abs().max(h) / h
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

/// The size to which the rounding errors of each value are relative: that of all positions and limits, and of the way
/// of what moves by itself, whose place is as exact as the time is.
pub(super) fn sizes<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    laws: &[Law<T>; MOST],
    t: T,
    x: &SVector<T, N>,
) -> [T; MOST] {
    let limits = laws.iter().flat_map(|law| [law.low, law.high]).flatten();
    let positions = x.iter().take(N / 2).copied();
    let size = limits.chain(positions).fold(T::default(), |size, x| size.max(x.abs()));
    let mut at_rest = *x;
    at_rest.iter_mut().skip(N / 2).for_each(|rate| *rate = T::default());
    system.measures(t, &at_rest).map(|[_, rate]| size.max((t * rate).abs()))
}

/// The two places that were looked at last.
struct Seen<T> {
    earlier: Option<Place<T>>,
    last: Place<T>,
}

impl<T: Copy> Seen<T> {
    fn new(start: Place<T>) -> Self {
        Self {
            earlier: None,
            last: start,
        }
    }

    fn go_to(&mut self, here: Place<T>) {
        (self.earlier, self.last) = (Some(self.last), here);
    }
}

/// A system in a mode.
struct Scene<'a, T, const N: usize> {
    system: &'a dyn Hybrid<T, N>,
    mode: &'a Mode,
    hold: &'a Hold<T>,
    laws: &'a [Law<T>; MOST],
    evaluations: Cell<usize>,
}

impl<'a, T: Float, const N: usize> Scene<'a, T, N> {
    fn new((system, mode, hold): (&'a dyn Hybrid<T, N>, &'a Mode, &'a Hold<T>), laws: &'a [Law<T>; MOST]) -> Self {
        Self {
            system,
            mode,
            hold,
            laws,
            evaluations: Cell::new(0),
        }
    }

    /// The functions, those of what is held from its forces.
    fn place(&self, theta: T, t: T, x: &SVector<T, N>, forces: Option<[T; MOST]>) -> Place<T> {
        let (measures, forces) = (self.system.measures(t, x), forces.unwrap_or_default());
        let mut values = [[T::from_f64(f64::INFINITY); WAYS]; MOST];
        for (n, values) in values.iter_mut().enumerate().take(self.system.constraints().len()) {
            *values = self.of(n, measures[n], forces[n]);
        }
        let rates = measures.map(|[_, rate]| rate);
        Place { theta, values, rates }
    }

    /// One of them.
    fn value(&self, t: T, x: &SVector<T, N>, n: usize, way: usize) -> T {
        let forces = if self.mode.is_held(n) { self.forces(t, x) } else { None };
        self.of(n, self.system.measures(t, x)[n], forces.unwrap_or_default()[n])[way]
    }

    /// Where one of them passes zero about a place, in fractions of a step from its end.
    fn zero_about_the_end(&self, dense: &Dense<'_, T, N>, place: T, (n, way): (usize, usize), noise: T) -> Option<T> {
        let (zero, step) = (T::default(), dense.step());
        let function = |by: T| self.value(step.t1 + by * step.h, &dense.about_end(by), n, way);
        let value = function(place);
        if value == zero {
            return Some(place);
        }
        let (count, towards) = if value > zero {
            (BEYOND, 1.0)
        } else {
            (BACK.len(), -1.0)
        };
        let found = BACK[..count].iter().find_map(|about| {
            let other = place + T::from_f64(towards * about);
            let there = function(other);
            ((there > zero) != (value > zero)).then(|| match value > zero {
                true => root(function, (place, value), (other, there)),
                false => root(function, (other, there), (place, value)),
            })
        });
        found.or((value <= noise).then_some(place))
    }

    /// How much the forces of what is held bend between three places in equal distances, relative to their sizes.
    fn bend(&self, [first, middle, last]: [&Place<T>; 3], sizes: &[T; MOST]) -> T {
        let mut most = T::default();
        for n in (0..MOST).filter(|&n| self.mode.is_held(n)) {
            let size = self.laws[n].sticking.max(sizes[n]);
            let way = if self.mode.0[n] == Status::High {
                BACKWARD
            } else {
                FORWARD
            };
            let [a, b, c] = [first, middle, last].map(|place| place.values[n][way]);
            let bend = (a - b - b + c).abs();
            if bend > most * size {
                most = bend / size;
            }
        }
        most
    }

    /// Whether a gap is accelerated towards its limit at a place within a step.
    fn is_pushed_on(&self, dense: &Dense<'_, T, N>, theta: T, (n, way): (usize, usize)) -> bool {
        let towards = T::from_f64(if way == UPPER { 1.0 } else { -1.0 });
        let [here, last] = [theta, T::from_f64(1.0)].map(|theta| {
            let (t, x) = (dense.time(theta), dense.at_fraction(theta));
            let forces = self.forces(t, &x).unwrap_or(self.hold.forces);
            self.evaluations.set(self.evaluations.get() + 1);
            towards * self.system.response(t, &x, &forces).accelerations[n]
        });
        here > T::from_f64(LEAST_ACCELERATION) * last.abs()
    }

    /// The forces along the constraints, where something is held.
    fn forces(&self, t: T, x: &SVector<T, N>) -> Option<[T; MOST]> {
        (self.hold.held != 0).then(|| {
            self.evaluations.set(self.evaluations.get() + 1);
            forces(self.system, self.hold, t, x)
        })
    }

    fn of(&self, n: usize, [value, rate]: [T; 2], force: T) -> [T; WAYS] {
        let (law, status) = (&self.laws[n], self.mode.0[n]);
        let none = T::from_f64(f64::INFINITY);
        let mut values = [none; WAYS];
        if status.is_held() {
            // a push forward that is too large lets it slip backward
            if status != Status::Low {
                values[BACKWARD] = law.sticking - force;
            }
            if status != Status::High {
                values[FORWARD] = force + law.sticking;
            }
            return values;
        }
        match status {
            Status::Forward => values[FORWARD] = rate,
            Status::Backward => values[FORWARD] = -rate,
            _ => {}
        }
        values[BACKWARD] = law.low.map_or(none, |low| value - low);
        values[UPPER] = law.high.map_or(none, |high| high - value);
        values
    }

    /// The functions that may reach zero within a step: not those of which the polynomial of the step shows that they
    /// do not.
    fn live(&self, values: &Values<T>, positive: Fired, dense: &Dense<'_, T, N>) -> Fired {
        let mut live = Fired::default();
        for (n, constraint) in self.system.constraints().iter().enumerate() {
            let is_linear = !self.mode.is_held(n) && !constraint.rate.is_empty();
            for (way, &value) in values[n].iter().enumerate() {
                if value == T::from_f64(f64::INFINITY) {
                    continue;
                }
                let is_negated = way == UPPER || self.mode.0[n] == Status::Backward && way == FORWARD;
                let sign = T::from_f64(if is_negated { -1.0 } else { 1.0 });
                let stays = is_linear
                    && positive.has(n, way)
                    && least((value, sign), (constraint, way), dense.terms()) > T::default();
                if !stays {
                    live.insert(n, way);
                }
            }
        }
        live
    }
}

/// What a step in lanes leaves of each function of [`Watch::look`], at least, in a mode in which nothing is held: where
/// all of a lane are positive, its mode does not end. All rates are sums of components of the state.
#[cfg(feature = "std")]
#[inline(always)]
pub(crate) fn room<V: Lanes, const N: usize>(
    (constraints, laws): (&[Constraint], &[Law<V>; MOST]),
    measures: &[[V; 2]; MOST],
    terms: &[SVector<V, N>],
) -> [[V; WAYS]; MOST] {
    let one = V::from_f64(1.0);
    let mut room = [[one; WAYS]; MOST];
    for (n, constraint) in constraints.iter().enumerate() {
        let [value, rate] = measures[n];
        let least = |way, value, sign| least((value, sign), (constraint, way), terms);
        room[n] = [
            least(FORWARD, rate.abs(), rate.signum()),
            laws[n].low.map_or(one, |low| least(BACKWARD, value - low, one)),
            laws[n].high.map_or(one, |high| least(UPPER, high - value, -one)),
        ];
    }
    room
}

/// What a function of a step stays above: a value, and `sign` times a sum of components of the state, of the polynomial
/// `x0 + c_1 theta + c_2 theta^2 + ..`. It is the least of the coefficients in the basis of Bernstein, between which a
/// polynomial lies (G. Farin, "Curves and Surfaces for CAGD" 2002, Sec. 5.1), less what rounding errors may do.
#[inline(always)]
fn least<V: Lanes, const N: usize>(
    (value, sign): (V, V),
    (constraint, way): (&Constraint, usize),
    terms: &[SVector<V, N>],
) -> V {
    if terms.len() <= MAX_DEGREE {
        least_of::<V, N, { MAX_DEGREE + 1 }>((value, sign), (constraint, way), terms)
    } else {
        least_of::<V, N, { MAX_ORDER + 1 }>((value, sign), (constraint, way), terms)
    }
}

/// [`least`] of a polynomial of so many coefficients at most.
#[inline(always)]
fn least_of<V: Lanes, const N: usize, const MOST_TERMS: usize>(
    (value, sign): (V, V),
    (constraint, way): (&Constraint, usize),
    terms: &[SVector<V, N>],
) -> V {
    let degree = terms.len();
    let back = if way == FORWARD { 0 } else { N / 2 };
    let mut sums = [V::default(); MOST_TERMS];
    sums[0] = value;
    let (mut size, mut choices) = (V::default(), 1.0);
    for (power, term) in terms.iter().enumerate() {
        let mut change = V::default();
        for &(component, its) in constraint.rate {
            change += term[component - back] * V::from_f64(f64::from(its));
        }
        // over the number of ways to choose so many of all
        choices *= (degree - power) as f64 / (power + 1) as f64;
        sums[power + 1] = sign * change * V::from_f64(1.0 / choices);
        size += change.abs();
    }
    let mut least = value;
    for first in 0..degree {
        for n in (first..degree).rev() {
            let sum = sums[n];
            sums[n + 1] += sum;
        }
        least = (least - sums[first + 1]).select(least, sums[first + 1]);
    }
    least - size * V::from_f64(SLACK)
}
