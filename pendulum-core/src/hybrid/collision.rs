//! Impacts at an instant, one after the other or at once.
//!
//! Newton's law: a contact that approaches with the rate `v` leaves with `-e v`; those that it acts on and that rest
//! take part, so that none of them approaches then. Where others approach after that, with no time in between, theirs
//! follow: of two contacts that act on each other they alternate, whatever the gaps are, so the rates at which such a
//! series ends do not depend on when gaps became too small to be resolved. Where contacts that act on each other
//! approach at once, each order is tried. If it matters, all of them collide at once with the least of their
//! restitutions, so that energy never grows, and that is reported.

use nalgebra::SVector;

use super::complementarity::{groups, impulses};
use super::functions::{BACKWARD, Fired, UPPER};
use super::mode::{Status, bits, set_of};
use super::resolution::{AT_LIMIT, CONSISTENT, ulps};
use super::settling::Settling;
use super::switch::finish;
use super::{MOST, Response};
use crate::real::Float;

/// Impacts that follow each other at once; after these, contacts that still approach stay together.
const MOST_IMPACTS: usize = 1 << 12;
/// How often all orders are tried at an instant: each try follows the impacts to their end.
const MOST_TRIES: usize = 4;

/// The impacts at an instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series<T, const N: usize> {
    count: usize,
    /// The largest energy that was lost or turned back in one of the first.
    largest: T,
    /// How often orders may still be tried; not where one is followed, to be compared with others.
    tries: usize,
    /// The contacts whose order mattered, with the differences that it makes to the state.
    pub(super) ambiguity: Option<(u8, SVector<T, N>)>,
}

impl<T: Float, const N: usize> Series<T, N> {
    pub(super) fn none() -> Self {
        Self {
            count: 0,
            largest: T::default(),
            tries: MOST_TRIES,
            ambiguity: None,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Tries no other orders.
    pub(super) fn follow_one_order(&mut self) {
        self.tries = 0;
    }

    /// Whether they go on for too long, as where contacts contradict each other.
    pub(super) fn is_too_long(&self) -> bool {
        self.count > MOST_IMPACTS
    }

    /// Begins anew, at another instant.
    pub(super) fn begin(&mut self) {
        (self.count, self.largest) = (0, T::default());
    }
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// The rate of each constraint away from the limit that it touches, zero where it rests.
    fn leaving(&self) -> [T; MOST] {
        let measures = self.system.measures(self.t, &self.x);
        let rate = |n: usize| {
            if self.resting & 1 << n == 0 {
                self.away(n) * measures[n][1]
            } else {
                T::default()
            }
        };
        core::array::from_fn(rate)
    }

    /// Up to which rates those of contacts may be rounding errors, of their own and of the impacts before.
    fn noise(&self, response: &Response<T, N>) -> [T; MOST] {
        let sizes = self.sizes();
        let of_first = |n: usize| (self.series.largest * response.matrix[n][n]).sqrt();
        core::array::from_fn(|n| ulps(AT_LIMIT, sizes.rates[n].max(of_first(n))))
    }

    /// The contacts that approach after an impact. Where there are none, those rest that no longer leave.
    pub(super) fn next(&mut self) -> Fired {
        let mut next = Fired::default();
        if self.series.is_empty() {
            return next;
        }
        let response = self.system.response(self.t, &self.x, &[T::default(); MOST]);
        let (leaving, noise) = (self.leaving(), self.noise(&response));
        let touched = self.touched();
        for n in bits(touched).filter(|&n| leaving[n] < -noise[n]) {
            next.insert(
                n,
                if self.touching[n] == Status::Low {
                    BACKWARD
                } else {
                    UPPER
                },
            );
        }
        if next.is_empty() {
            bits(touched).for_each(|n| self.rest(n, leaving[n].abs() <= noise[n]));
        }
        next
    }

    /// The impacts with which a series begins or goes on: one in each group of contacts that act on each other.
    pub(super) fn collide(&mut self) {
        let zero = T::default();
        let leaving = self.leaving();
        if leaving.iter().all(|&leaving| leaving >= zero) {
            return;
        }
        let response = self.system.response(self.t, &self.x, &[zero; MOST]);
        let noise = self.noise(&response);
        let approaching = set_of(bits(self.touched()).filter(|&n| leaving[n] < -noise[n]));
        if approaching == 0 {
            return;
        }
        let mut matrix = response.matrix;
        for (n, row) in matrix.iter_mut().enumerate() {
            for (m, entry) in row.iter_mut().enumerate() {
                *entry *= self.away(n) * self.away(m);
            }
        }
        let (mut pushes, mut fastest) = ([zero; MOST], [zero; MOST]);
        let (mut collided, mut stopped) = (0, 0);
        let before = *self;
        for group in groups(&matrix, self.touched()) {
            let hit = match (group & approaching, self.series.count < MOST_IMPACTS) {
                (0, _) => continue,
                (hit, true) => before.first_of(hit, &mut self.series),
                (_, false) => group,
            };
            let members = hit | group & self.resting;
            // the least, so that energy does not grow
            let restitution = bits(hit & approaching).map(|n| self.restitution(n, -leaving[n]));
            let restitution = match restitution.reduce(T::min) {
                Some(restitution) if self.series.count < MOST_IMPACTS => restitution,
                _ => zero,
            };
            let of_group = impulses(&matrix, members, &leaving, restitution);
            let of_all = bits(members).fold(zero, |fastest, n| fastest.max(leaving[n].abs()));
            collided |= members;
            for n in bits(members).filter(|&n| of_group[n] != zero) {
                pushes[n] = self.away(n) * of_group[n];
                stopped |= u8::from(restitution == zero) << n;
                fastest[n] = of_all;
            }
            if before.series.is_empty() {
                let energies = bits(hit & approaching).map(|n| leaving[n] * leaving[n] / matrix[n][n]);
                self.series.largest = energies.fold(self.series.largest, T::max);
            }
        }
        self.series.count += 1;
        self.push(&response, collided, &pushes);
        self.note_rest(collided, stopped, (&response, &pushes, &fastest));
    }

    fn restitution(&self, n: usize, speed: T) -> T {
        let law = &self.laws[n];
        if speed < law.slow {
            T::default()
        } else {
            law.restitution
        }
    }

    /// Notes what impulses have stopped, and what they have moved.
    fn note_rest(
        &mut self,
        collided: u8,
        stopped: u8,
        (response, pushes, fastest): (&Response<T, N>, &[T; MOST], &[T; MOST]),
    ) {
        let zero = T::default();
        let measures = self.system.measures(self.t, &self.x);
        for n in 0..self.system.constraints().len() {
            let rate = measures[n][1].abs();
            let change = bits(collided).fold(zero, |sum, m| sum + response.matrix[n][m] * pushes[m]);
            if pushes[n] != zero || change != zero {
                self.resting &= !(1 << n);
            }
            // what an impulse has stopped, or only held, keeps a rate of rounding
            let is_stopped = stopped & 1 << n != 0 && rate <= T::EPSILON.sqrt() * fastest[n];
            let is_held = pushes[n] != zero && rate <= ulps(CONSISTENT, fastest[n]);
            self.rest(n, is_stopped || is_held);
        }
    }

    /// Those of the contacts that approach, and act on each other, that collide first: one of them if their order does
    /// not matter.
    fn first_of(&self, approaching: u8, series: &mut Series<T, N>) -> u8 {
        if let Some(first) = self.first {
            return approaching & first;
        }
        if approaching.count_ones() == 1 || series.tries == 0 {
            return approaching;
        }
        series.tries -= 1;
        let mut outcomes = bits(approaching).map(|n| self.outcome(!approaching | 1 << n));
        let Some(one) = outcomes.next() else { return approaching };
        let mut differences = SVector::from([T::default(); N]);
        let mut matters = false;
        let noise = T::EPSILON.sqrt() * T::EPSILON.sqrt().sqrt();
        for other in outcomes {
            for k in N / 2..N {
                let difference = (one[k] - other[k]).abs();
                let size = (one[k] - self.x[k]).abs().max(self.x[k].abs());
                matters |= difference > noise * size;
                differences[k] = differences[k].max(difference);
            }
        }
        if !matters {
            return approaching & approaching.wrapping_neg();
        }
        if series.ambiguity.is_none() {
            series.ambiguity = Some((approaching, differences));
        }
        approaching
    }

    /// The state after all impacts where only some contacts may collide first.
    fn outcome(&self, first: u8) -> SVector<T, N> {
        let mut tried = *self;
        (tried.first, tried.series.tries) = (Some(first), 0);
        finish(self.system, self.t, tried.settle(), &self.reach, &mut |_, _| {}).x
    }

    /// Changes the rates by impulses along some constraints.
    pub(super) fn push(&mut self, response: &Response<T, N>, along: u8, impulses: &[T; MOST]) {
        super::held::add(&mut self.x, response, along, impulses);
        for n in bits(along) {
            self.impulses[n] += impulses[n];
        }
    }
}
