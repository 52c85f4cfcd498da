//! A step of a system in a mode, and its witnesses.

use core::cell::Cell;

use nalgebra::SVector;

use super::held::forces;
use super::kinematics::Kinematics;
use super::mode::{Mode, Status};
use super::polynomial::{Course, course, stays_positive};
use super::resolution::{SHORTEST_MODE, SIMULTANEOUS};
use super::sizes::rates_at_rest;
use super::witness::Witness;
use super::{Hold, Hybrid, Law, MAX_CONSTRAINTS};
use crate::dense::{ABOUT_THE_END, Dense};
use crate::error::Reason;
use crate::method::{Known, root, root_of_line};
use crate::real::{Float, ulps};

/// Acceleration, relative to the one at the end of the step, below which it may be a rounding error.
const LEAST_ACCELERATION: f64 = 1e-6;

/// Positions, in fractions of a step, at which its polynomial is checked again if it is wrong near the start of the
/// step, before the first of them.
pub(super) const RIGHT_AGAIN: [f64; 2] = [0.01, 0.125];

/// Search distances about the end of a step that was shortened to the end of a mode, in fractions of the step.
const ABOUT: [f64; 4] = [1e-12, 1e-9, 1e-6, ABOUT_THE_END];
/// Search distances back from the end of a step whose witness is negative there, after [`ABOUT`], up to just behind its
/// start: a longer step may have missed a low rebound there.
const BACK: [f64; 9] = [0.1, 0.5, 0.9, 0.99, 0.999, 0.9999, 0.99999, 0.999999, 1.0];

/// A position within a step, in fractions of it, with the value and the rate of each constraint there.
#[derive(Clone, Copy)]
pub(super) struct Place<T> {
    pub(super) theta: T,
    measures: [[T; 2]; MAX_CONSTRAINTS],
}

impl<T: Copy> Place<T> {
    /// Value of a constraint.
    pub(super) fn value(&self, n: usize) -> T {
        self.measures[n][0]
    }
}

/// A step of a system in a mode.
pub(super) struct StepInMode<'a, T, const N: usize> {
    pub(super) system: &'a dyn Hybrid<T, N>,
    pub(super) mode: &'a Mode,
    pub(super) hold: &'a Hold<T>,
    pub(super) laws: [Law<T>; MAX_CONSTRAINTS],
    kinematics: Kinematics<'a>,
    pub(super) dense: &'a Dense<'a, T, N>,
    /// Number of evaluations of the equations of motion.
    pub(super) evaluations: Cell<usize>,
}

impl<'a, T: Float, const N: usize> StepInMode<'a, T, N> {
    pub(super) fn new(
        (system, mode, hold): (&'a dyn Hybrid<T, N>, &'a Mode, &'a Hold<T>),
        dense: &'a Dense<'a, T, N>,
    ) -> Self {
        Self {
            system,
            mode,
            hold,
            laws: system.laws(),
            kinematics: Kinematics::of(system),
            dense,
            evaluations: Cell::new(0),
        }
    }

    /// Time and state at a position within the step.
    fn at(&self, theta: T) -> (T, SVector<T, N>) {
        (self.dense.time(theta), self.dense.at_fraction(theta))
    }

    pub(super) fn place(&self, theta: T) -> Place<T> {
        let (t, x) = self.at(theta);
        let measures = self.system.measures(t, &x);
        Place { theta, measures }
    }

    /// Place at `by` steps after the end of the step (before it if negative): see [`Dense::about_end`].
    pub(super) fn about_end(&self, by: T) -> Place<T> {
        let step = self.dense.step();
        let measures = self.system.measures(step.t1 + by * step.h, &self.dense.about_end(by));
        let theta = T::from_f64(1.0) + by;
        Place { theta, measures }
    }

    /// Forces along the constraints at a position within the step, where something is held.
    pub(super) fn forces(&self, theta: T) -> [T; MAX_CONSTRAINTS] {
        let (t, x) = self.at(theta);
        self.forces_at(t, &x)
    }

    fn forces_at(&self, t: T, x: &SVector<T, N>) -> [T; MAX_CONSTRAINTS] {
        self.evaluations.set(self.evaluations.get() + 1);
        forces(self.system, self.hold, t, x)
    }

    /// Value of a witness of the state.
    pub(super) fn value(&self, place: &Place<T>, (n, witness): (usize, Witness)) -> T {
        let ([value, rate], law) = (place.measures[n], &self.laws[n]);
        match witness {
            Witness::Low => law.low.map_or(T::default(), |low| value - low),
            Witness::High => law.high.map_or(T::default(), |high| high - value),
            _ if self.mode.0[n] == Status::Backward => -rate,
            _ => rate,
        }
    }

    /// A gap and its slope.
    pub(super) fn known(&self, place: &Place<T>, (n, gap): (usize, Witness)) -> Known<T> {
        let h = self.dense.step().h;
        let slope = (if gap == Witness::High { -h } else { h }) * place.measures[n][1];
        (place.theta, [self.value(place, (n, gap)), slope])
    }

    /// Returns `number`, or an error if it is NaN.
    pub(super) fn number(&self, theta: T, n: usize, number: T) -> Result<T, Reason> {
        if number.to_f64().is_nan() {
            let constraint = self.system.constraints()[n].name.into();
            let t = self.dense.time(theta).to_f64();
            return Err(Reason::ConstraintNotFinite { constraint, t });
        }
        Ok(number)
    }

    /// Margin of a holding force.
    pub(super) fn margin(&self, forces: &[T; MAX_CONSTRAINTS], (n, witness): (usize, Witness)) -> T {
        let sticking = self.laws[n].sticking;
        // a forward force beyond its limit lets the constraint slip backward
        if witness == Witness::Backward {
            sticking - forces[n]
        } else {
            forces[n] + sticking
        }
    }

    /// Finds where a witness of the state that has not been positive since the mode began ends the mode, between the
    /// last two samples. The first sample is the start of the step.
    pub(super) fn end_at_the_start(
        &self,
        (n, witness): (usize, Witness),
        noise: T,
        [start, last, here]: [&Place<T>; 3],
    ) -> Option<T> {
        let at = |place: &Place<T>| (place.theta, self.value(place, (n, witness)) + noise);
        let (before, after) = (at(last), at(here));
        if after.1 >= T::default() {
            return None;
        }
        let within = here.theta != T::from_f64(1.0);
        if witness == Witness::Slip {
            // where the equations accelerate the slip, the apparent reversal is an error of the polynomial
            return (!(within && self.slips_on(here.theta, n))).then_some(here.theta);
        }
        if within && self.leaves((n, witness), noise, [start, here]) {
            return None;
        }
        if last.theta == T::default() && before.1 <= T::default() {
            return Some(here.theta);
        }
        let value = |theta| self.value(&self.place(theta), (n, witness)) + noise;
        Some(self.end_since(value, before, after))
    }

    /// End of the mode by a witness, with its noise added: the root between a positive and a negative value, or the
    /// first place if the value there is not positive.
    pub(super) fn end_since(&self, value: impl Fn(T) -> T, before: (T, T), after: (T, T)) -> T {
        if before.1 > T::default() {
            return root(value, before, after);
        }
        // the constraint has given way, or passed its limit, since that place
        before.0.max(part_of(self.dense, self.dense.step().t0, SHORTEST_MODE))
    }

    /// Checks that a gap apparently beyond its limit opens: it may start there by the error of the polynomial.
    fn leaves(&self, (n, gap): (usize, Witness), noise: T, [start, here]: [&Place<T>; 2]) -> bool {
        let [thrown, departs] = [start, here].map(|place| self.known(place, (n, gap)).1[1]);
        let is_thrown_on = here.theta * thrown < -noise;
        departs >= T::default() || !is_thrown_on && !self.is_pushed_on(here.theta, (n, gap))
    }

    /// Finds where a witness passes zero near a place, in fractions of a step from the step's end. Without a sign
    /// change it returns the place itself if the witness is zero within its `noise`, and otherwise extrapolates
    /// linearly.
    pub(super) fn zero_about_the_end(
        &self,
        place: T,
        witness: (usize, Witness),
        noise: impl FnOnce() -> T,
    ) -> Option<T> {
        let (zero, step) = (T::default(), self.dense.step());
        let function = |by: T| match witness.1.is_force() {
            true => self.margin(
                &self.forces_at(step.t1 + by * step.h, &self.dense.about_end(by)),
                witness,
            ),
            false => self.value(&self.about_end(by), witness),
        };
        let value = function(place);
        if value == zero {
            return Some(place);
        }
        // resolve forces, which take an evaluation each, no finer than the step
        let one = T::from_f64(1.0);
        let origin = if witness.1.is_force() { one } else { zero };
        let shifted = |place: T| function(place - origin);
        let (towards, farther): (_, &[f64]) = if value > zero { (1.0, &[]) } else { (-1.0, &BACK) };
        for &about in ABOUT.iter().chain(farther) {
            let other = place + T::from_f64(towards * about);
            let there = function(other);
            if (there > zero) != (value > zero) {
                let [near, far] = [(place, value), (other, there)].map(|(place, value)| (origin + place, value));
                let (from, to) = if value > zero { (near, far) } else { (far, near) };
                return Some(root_of_line(shifted, from, to) - origin);
            }
        }
        if value <= noise() {
            return Some(place);
        }
        let falls = match witness.1.is_gap() {
            true => -self.known(&self.about_end(place), witness).1[1],
            false => value - function(place + one),
        };
        // near the end it is already known to be positive
        (falls > zero).then(|| place + (value / falls).max(T::from_f64(2.0 * ABOUT_THE_END)))
    }

    /// True if the constraint moves at zero rates of the state.
    pub(super) fn moves_by_itself(&self, n: usize) -> bool {
        let step = self.dense.step();
        let mut ends = [(step.t0, &step.x0), (step.t1, &step.x1)].into_iter();
        ends.any(|(t, x)| rates_at_rest(self.system, t, x)[n] != T::default())
    }

    /// True if a gap is accelerated towards its limit at a place within a step.
    fn is_pushed_on(&self, theta: T, (n, gap): (usize, Witness)) -> bool {
        let towards = T::from_f64(if gap == Witness::High { 1.0 } else { -1.0 });
        let [here, last] = [theta, T::from_f64(1.0)].map(|theta| towards * self.acceleration(theta, n));
        here > T::from_f64(LEAST_ACCELERATION) * last.abs()
    }

    /// True if a slipping constraint is accelerated in its direction of slip at a place within a step.
    fn slips_on(&self, theta: T, n: usize) -> bool {
        let acceleration = self.acceleration(theta, n);
        (acceleration > T::default()) == (self.mode.0[n] == Status::Forward)
    }

    /// Second derivative of a constraint at a place within a step.
    fn acceleration(&self, theta: T, n: usize) -> T {
        let (t, x) = self.at(theta);
        let forces = self.forces_at(t, &x);
        self.system.response(t, &x, &forces).accelerations[n]
    }

    /// Sign of a witness relative to its constraint, if it is a polynomial of the dense output.
    fn sign(&self, (n, witness): (usize, Witness)) -> Option<f64> {
        let is_polynomial = !witness.is_force() && !self.system.constraints()[n].rate.is_empty();
        is_polynomial.then(|| match witness {
            Witness::Slip => self.mode.0[n].slip(),
            Witness::High => -1.0,
            _ => 1.0,
        })
    }

    /// True if the dense output proves that a positive witness stays positive.
    pub(super) fn stays_positive(&self, start: &Place<T>, (n, witness): (usize, Witness)) -> bool {
        self.sign((n, witness)).is_some_and(|sign| {
            let (start, constraint) = (self.value(start, (n, witness)), &self.system.constraints()[n]);
            let start = (start.to_f64(), sign);
            stays_positive(start, (constraint, witness, self.kinematics), self.dense.terms())
        })
    }

    /// Course of a witness that is a polynomial of the dense output: see [`course`]. Unclear for others.
    pub(super) fn course(&self, start: &Place<T>, (n, witness): (usize, Witness), known: (bool, T)) -> Course<T> {
        self.sign((n, witness)).map_or(Course::Unclear, |sign| {
            let (start, constraint) = (self.value(start, (n, witness)), &self.system.constraints()[n]);
            course(
                (start, T::from_f64(sign)),
                (constraint, witness, self.kinematics),
                self.dense.terms(),
                known,
            )
        })
    }
}

/// Fraction of a step within which ends of modes are simultaneous.
pub(super) fn resolution<T: Float, const N: usize>(dense: &Dense<'_, T, N>, t: T) -> T {
    part_of(dense, t, SIMULTANEOUS)
}

/// Converts `count` ulps of a time into a fraction of a step.
fn part_of<T: Float, const N: usize>(dense: &Dense<'_, T, N>, t: T, count: f64) -> T {
    let step = dense.step();
    ulps(count, step.scale(t)) / step.h.abs()
}
