//! The functions whose zeros end a mode.

use core::cell::Cell;

use nalgebra::SVector;

use super::bounds::least;
use super::fired::{BACKWARD, FORWARD, Fired, UPPER, Values, WAYS};
use super::held::forces;
use super::mode::{Hold, Mode, Status};
use super::resolution::{SHORTEST_MODE, SIMULTANEOUS, ulps};
use super::sizes::rates_at_rest;
use super::{Hybrid, Law, MOST};
use crate::dense::Dense;
use crate::method::{Known, dip, first_zero, root, unseen_bend};
use crate::real::Float;

/// An acceleration that is this part of the one at the end of a step, or less, may be a rounding error.
const LEAST_ACCELERATION: f64 = 1e-6;

/// A step that was taken to the end of a mode is searched so far back from its end, in fractions of it, and beyond it
/// so far as the polynomial is as exact there.
const BACK: [f64; 8] = [1e-12, 1e-9, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.99];
const BEYOND: usize = 4;

/// A place within a step, in fractions of it, with the functions there and the rates of all constraints.
#[derive(Clone, Copy)]
pub(super) struct Place<T> {
    pub(super) theta: T,
    pub(super) values: Values<T>,
    pub(super) rates: [T; MOST],
}

/// A step of a system in a mode.
pub(super) struct Scene<'a, T, const N: usize> {
    pub(super) system: &'a dyn Hybrid<T, N>,
    pub(super) mode: &'a Mode,
    pub(super) hold: &'a Hold<T>,
    pub(super) laws: &'a [Law<T>; MOST],
    pub(super) dense: &'a Dense<'a, T, N>,
    /// How often the equations of motion were evaluated.
    pub(super) evaluations: Cell<usize>,
}

impl<'a, T: Float, const N: usize> Scene<'a, T, N> {
    pub(super) fn new(
        (system, mode, hold): (&'a dyn Hybrid<T, N>, &'a Mode, &'a Hold<T>),
        laws: &'a [Law<T>; MOST],
        dense: &'a Dense<'a, T, N>,
    ) -> Self {
        Self {
            system,
            mode,
            hold,
            laws,
            dense,
            evaluations: Cell::new(0),
        }
    }

    /// The time and the state at a place.
    pub(super) fn at(&self, theta: T) -> (T, SVector<T, N>) {
        (self.dense.time(theta), self.dense.at_fraction(theta))
    }

    /// The functions, those of what is held from its forces.
    pub(super) fn place(&self, theta: T, t: T, x: &SVector<T, N>, forces: Option<[T; MOST]>) -> Place<T> {
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

    /// One of them that is a gap, with its slope, at a place.
    pub(super) fn known(&self, place: &Place<T>, (n, way): (usize, usize)) -> Known<T> {
        (place.theta, [place.values[n][way], self.slope(way, place.rates[n])])
    }

    /// The slope of a gap over a step, from the rate of what it is of.
    fn slope(&self, way: usize, rate: T) -> T {
        let h = self.dense.step().h;
        (if way == UPPER { -h } else { h }) * rate
    }

    /// Where a function that has not been positive since the mode began ends it, from the last place but one to the
    /// last.
    pub(super) fn end_at_the_start(
        &self,
        (n, way): (usize, usize),
        noise: T,
        [start, last, here]: [&Place<T>; 3],
    ) -> Option<T> {
        let (zero, one) = (T::default(), T::from_f64(1.0));
        let [before, after] = [last, here].map(|place| (place.theta, place.values[n][way] + noise));
        if after.1 >= zero {
            return None;
        }
        match (self.mode.is_held(n), way) {
            // where the equations push it on, it is the polynomial that goes back
            (false, FORWARD) if here.theta != one && self.slips_on(here.theta, n) => None,
            (false, FORWARD) => Some(here.theta),
            (false, _) if here.theta != one && self.leaves((n, way), noise, [start, here]) => None,
            (false, _) if before.1 <= zero && last.theta == zero => Some(here.theta),
            // since there it has not seemed to leave, or gives way
            _ if before.1 <= zero => Some(last.theta.max(part_of(self.dense, self.dense.step().t0, SHORTEST_MODE))),
            _ => {
                let function = |theta: T| {
                    let (t, x) = self.at(theta);
                    self.value(t, &x, n, way) + noise
                };
                Some(root(function, before, after))
            }
        }
    }

    /// Whether a gap that seems to be beyond its limit leaves it: it may start there, by the error of the polynomial.
    fn leaves(&self, (n, way): (usize, usize), noise: T, [start, here]: [&Place<T>; 2]) -> bool {
        let [thrown, departs] = [start, here].map(|place| self.slope(way, place.rates[n]));
        let is_thrown_on = here.theta * thrown < -noise;
        departs >= T::default() || !is_thrown_on && !self.is_pushed_on(here.theta, (n, way))
    }

    /// Where one of them that was positive first reaches zero, up to the last of three places, of which the first need
    /// not be known. What stays within the noise of zero has not passed it.
    pub(super) fn zero(
        &self,
        (n, way): (usize, usize),
        noise: T,
        earlier: Option<&Place<T>>,
        last_two: [&Place<T>; 2],
    ) -> Option<T> {
        let zero = T::default();
        let at = |place: &Place<T>| (place.theta, place.values[n][way]);
        let function = |theta: T| {
            let (t, x) = self.at(theta);
            self.value(t, &x, n, way)
        };
        let [last, here] = last_two.map(at);
        if here.1 < -noise || here.1 <= zero && noise == zero {
            let raised = if last.1 > zero { zero } else { noise };
            let raise = |(theta, value): (T, T)| (theta, value + raised);
            return Some(root(|theta| function(theta) + raised, raise(last), raise(here)));
        }
        let earlier = earlier.map(at).filter(|earlier| earlier.1 > zero)?;
        let bottom = dip(function, [earlier, last, here])?;
        (bottom.1 < -noise || noise == zero).then(|| root(function, earlier, bottom))
    }

    /// The same of a gap; `bend` is how much it bends between places, as far as was seen.
    pub(super) fn zero_of_gap(
        &self,
        (n, way): (usize, usize),
        earlier: Option<&Place<T>>,
        last_two: [&Place<T>; 2],
        (bend, noise): (&mut T, T),
    ) -> Option<T> {
        let function = |theta: T| {
            let (t, x) = self.at(theta);
            let [value, rate] = self.system.measures(t, &x)[n];
            [self.of(n, [value, rate], T::default())[way], self.slope(way, rate)]
        };
        let at = |place: &Place<T>| self.known(place, (n, way));
        let [last, here] = last_two.map(at);
        let Some(earlier) = earlier.map(at).filter(|(_, [value, _])| *value > T::default()) else {
            return first_zero(&function, (last, here), bend, noise);
        };
        *bend = bend.max(unseen_bend([earlier, last, here], noise));
        first_zero(&function, (earlier, last), bend, noise).or_else(|| first_zero(&function, (last, here), bend, noise))
    }

    /// Where one of them passes zero about a place, in fractions of a step from its end.
    pub(super) fn zero_about_the_end(&self, place: T, (n, way): (usize, usize), noise: T) -> Option<T> {
        let (zero, step) = (T::default(), self.dense.step());
        let function = |by: T| self.value(step.t1 + by * step.h, &self.dense.about_end(by), n, way);
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
    pub(super) fn bend(&self, [first, middle, last]: [&Place<T>; 3], sizes: &[T; MOST]) -> T {
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

    /// Whether a constraint moves where the state does not.
    pub(super) fn moves_by_itself(&self, n: usize) -> bool {
        let step = self.dense.step();
        let mut ends = [(step.t0, &step.x0), (step.t1, &step.x1)].into_iter();
        ends.any(|(t, x)| rates_at_rest(self.system, t, x)[n] != T::default())
    }

    /// Whether a gap is accelerated towards its limit at a place within a step.
    fn is_pushed_on(&self, theta: T, (n, way): (usize, usize)) -> bool {
        let towards = T::from_f64(if way == UPPER { 1.0 } else { -1.0 });
        let [here, last] = [theta, T::from_f64(1.0)].map(|theta| towards * self.acceleration(theta, n));
        here > T::from_f64(LEAST_ACCELERATION) * last.abs()
    }

    /// Whether what slips is accelerated in its direction at a place within a step.
    fn slips_on(&self, theta: T, n: usize) -> bool {
        let acceleration = self.acceleration(theta, n);
        (acceleration > T::default()) == (self.mode.0[n] == Status::Forward)
    }

    /// The second derivative of a constraint at a place within a step.
    fn acceleration(&self, theta: T, n: usize) -> T {
        let (t, x) = self.at(theta);
        let forces = self.forces(t, &x).unwrap_or(self.hold.forces);
        self.evaluations.set(self.evaluations.get() + 1);
        self.system.response(t, &x, &forces).accelerations[n]
    }

    /// The forces along the constraints, where something is held.
    pub(super) fn forces(&self, t: T, x: &SVector<T, N>) -> Option<[T; MOST]> {
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
    pub(super) fn live(&self, values: &Values<T>, positive: Fired) -> Fired {
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
                    && least((value, sign), (constraint, way), self.dense.terms()) > T::default();
                if !stays {
                    live.insert(n, way);
                }
            }
        }
        live
    }
}

/// Within what part of a step ends of modes are simultaneous.
pub(super) fn resolution<T: Float, const N: usize>(dense: &Dense<'_, T, N>, t: T) -> T {
    part_of(dense, t, SIMULTANEOUS)
}

/// What part of a step some ulps of a time are.
fn part_of<T: Float, const N: usize>(dense: &Dense<'_, T, N>, t: T, count: f64) -> T {
    let h = dense.step().h.abs();
    ulps(count, t.abs().max(h)) / h
}
