//! Impacts at an instant, sequential or simultaneous.
//!
//! Newton's law of restitution: a contact that approaches with the rate `v` leaves with `-e v`. Resting contacts
//! coupled to it take part, so that none of them approaches afterwards. If others approach after that, their impacts
//! follow at the same instant: impacts of two coupled contacts alternate whatever the gaps are, so the final rates do
//! not depend on the moment at which gaps became too small to be resolved. If coupled contacts approach at once, each
//! order is tried. If the order matters, all of them collide at once with the smallest of their restitutions, so that
//! energy never grows, and an ambiguity is reported.

use nalgebra::SVector;

use super::complementarity::{groups, impulses, solve_negated};
use super::kinematics::Kinematics;
use super::mode::{Status, bits, set_of};
use super::resolution::{AT_LIMIT, CONSISTENT, ORDER_MATTERS};
use super::series::Series;
use super::settling::Settling;
use super::switch::finish;
use super::witness::{Witness, Witnesses};
use super::{MAX_CONSTRAINTS, Response};
use crate::real::{Float, ulps};

/// Contacts at an instant at which some of them approach.
struct Approach<T, const N: usize> {
    /// Approaching contacts.
    set: u8,
    /// Rates of all contacts away from their limits, zero where they rest.
    rates: [T; MAX_CONSTRAINTS],
    /// Changes of these rates by unit impulses away from the limits.
    matrix: [[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
    response: Response<T, N>,
}

/// Simultaneous impacts, one in each group of coupled contacts.
struct Blow<T> {
    /// Contacts that take part.
    members: u8,
    /// Members that push.
    pushing: u8,
    /// Impulses away from the limits.
    impulses: [T; MAX_CONSTRAINTS],
    /// Rates at which the pushing contacts leave.
    leaving: [T; MAX_CONSTRAINTS],
    /// Fastest rate before the impact in the group of each contact.
    fastest: [T; MAX_CONSTRAINTS],
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// Rate of each constraint away from the limit that it touches.
    fn rates_away(&self) -> [T; MAX_CONSTRAINTS] {
        let measures = self.system.measures(self.t, &self.x);
        core::array::from_fn(|n| self.away(n) * measures[n][1])
    }

    /// Like [`rates_away`](Self::rates_away), but zero where a constraint rests.
    fn leaving(&self) -> [T; MAX_CONSTRAINTS] {
        let mut rates = self.rates_away();
        bits(self.resting).for_each(|n| rates[n] = T::default());
        rates
    }

    /// Rounding errors of the rates of contacts, from their terms and from earlier impacts.
    fn noise(&self, response: &Response<T, N>) -> [T; MAX_CONSTRAINTS] {
        let sizes = self.sizes();
        let of_first = |n: usize| (self.series.largest * response.matrix[n][n]).sqrt();
        core::array::from_fn(|n| ulps(AT_LIMIT, sizes.rates[n].max(of_first(n))))
    }

    /// Contacts that approach after an impact. If there are none, contacts that no longer leave come to rest.
    pub(super) fn next(&mut self) -> Witnesses {
        let mut next = Witnesses::default();
        if self.series.is_empty() {
            return next;
        }
        let response = self.system.response(self.t, &self.x, &[T::default(); MAX_CONSTRAINTS]);
        let (leaving, noise) = (self.leaving(), self.noise(&response));
        let touched = self.touched();
        for n in bits(touched).filter(|&n| leaving[n] < -noise[n]) {
            let is_low = self.touching[n] == Status::Low;
            next.insert(n, if is_low { Witness::Low } else { Witness::High });
        }
        if next.is_empty() {
            bits(touched).for_each(|n| self.rest(n, leaving[n].abs() <= noise[n]));
        }
        next
    }

    /// Returns the contacts if some of them approach.
    fn approach(&self) -> Option<Approach<T, N>> {
        let zero = T::default();
        let rates = self.leaving();
        if rates.iter().all(|&rate| rate >= zero) {
            return None;
        }
        let response = self.system.response(self.t, &self.x, &[zero; MAX_CONSTRAINTS]);
        let noise = self.noise(&response);
        let set = set_of(bits(self.touched()).filter(|&n| rates[n] < -noise[n]));
        let entry = |n: usize, m: usize| self.away(n) * self.away(m) * response.matrix[n][m];
        (set != 0).then(|| Approach {
            set,
            rates,
            matrix: core::array::from_fn(|n| core::array::from_fn(|m| entry(n, m))),
            response,
        })
    }

    /// Applies the next impacts of a series: one in each group of coupled contacts.
    pub(super) fn collide(&mut self) {
        let Some(approach) = self.approach() else { return };
        let before = *self;
        let mut blow = Blow::none();
        for group in groups(&approach.matrix, self.touched()) {
            let approaching = group & approach.set;
            if approaching == 0 {
                continue;
            }
            let hit = if self.series.ends_now() {
                group
            } else {
                before.first_of(approaching, &mut self.series)
            };
            // the smallest restitution, so that energy does not grow
            let restitutions = bits(hit & approaching).map(|n| self.restitution(n, -approach.rates[n]));
            let restitution = restitutions.reduce(T::min).filter(|_| !self.series.ends_now());
            blow.add(&approach, hit | group & self.resting, restitution.unwrap_or_default());
            if self.series.is_empty() {
                let energy = |n: usize| approach.rates[n] * approach.rates[n] / approach.matrix[n][n];
                self.series.largest = bits(hit & approaching).map(energy).fold(self.series.largest, T::max);
            }
        }
        self.series.count += 1;
        self.receive(&approach, &blow);
    }

    fn restitution(&self, n: usize, speed: T) -> T {
        let law = &self.laws[n];
        if speed < law.slow {
            T::default()
        } else {
            law.restitution
        }
    }

    /// Converts impulses away from limits into impulses along the constraints.
    fn forward(&self, away: &[T; MAX_CONSTRAINTS]) -> [T; MAX_CONSTRAINTS] {
        core::array::from_fn(|n| self.away(n) * away[n])
    }

    /// Applies the impulses to the rates, and updates the resting constraints.
    fn receive(&mut self, approach: &Approach<T, N>, blow: &Blow<T>) {
        let zero = T::default();
        let rested = self.resting;
        let impulses = self.forward(&blow.impulses);
        for n in 0..self.system.constraints().len() {
            let change = bits(blow.pushing).map(|m| approach.response.matrix[n][m] * impulses[m]);
            let is_moved = blow.pushing & 1 << n != 0 || change.fold(zero, |sum, change| sum + change) != zero;
            self.resting &= !(u8::from(is_moved) << n);
        }
        self.push(&approach.response, blow.pushing, &impulses);
        // a second solve removes the rounding errors of light bodies
        let rates = self.rates_away();
        let surplus = core::array::from_fn(|n| rates[n] - blow.leaving[n]);
        let correction = solve_negated(&approach.matrix, blow.pushing, &surplus);
        self.push(&approach.response, blow.pushing, &self.forward(&correction));
        let rates = self.rates_away();
        for n in bits(blow.members) {
            // unless the impulse failed to have the effect that the matrix predicts
            let obeys = rates[n].abs() <= T::EPSILON.sqrt() * blow.fastest[n];
            let is_stopped = blow.pushing & 1 << n != 0 && blow.leaving[n] == zero && obeys;
            let rests_on = rested & 1 << n != 0 && rates[n].abs() <= ulps(CONSISTENT, blow.fastest[n]);
            self.rest(n, is_stopped || rests_on);
        }
    }

    /// Chooses which of the approaching, coupled contacts collide first: a single one if their order does not matter.
    fn first_of(&self, approaching: u8, series: &mut Series<T, N>) -> u8 {
        if let Some(first) = self.first {
            return approaching & first;
        }
        if approaching.count_ones() == 1 || series.tries == 0 {
            return approaching;
        }
        series.tries -= 1;
        let Some(differences) = self.between_orders(approaching) else {
            return approaching & approaching.wrapping_neg();
        };
        series.ambiguity.get_or_insert((approaching, differences));
        approaching
    }

    /// Differences of the state between the orders of impacts; none if the order does not matter.
    fn between_orders(&self, approaching: u8) -> Option<SVector<T, N>> {
        let (mut least, mut most) = (None, None);
        for first in bits(approaching) {
            let outcome = self.outcome(!approaching | 1 << first);
            least = Some(least.map_or(outcome, |least: SVector<T, N>| least.zip_map(&outcome, T::min)));
            most = Some(most.map_or(outcome, |most: SVector<T, N>| most.zip_map(&outcome, T::max)));
        }
        let (least, most, kinematics) = (least?, most?, Kinematics::of(self.system));
        let sizes = [self.x, least, most].map(|x| self.gains.of_kind(kinematics, &x));
        let size = |k: usize| sizes.iter().fold(T::default(), |size, sizes| size.max(sizes[k]));
        let differences = most - least;
        let matters = kinematics
            .rates()
            .any(|k| differences[k] > ulps(ORDER_MATTERS, size(k)));
        matters.then_some(differences)
    }

    /// State after all impacts, if only some contacts may collide first.
    fn outcome(&self, first: u8) -> SVector<T, N> {
        let mut tried = *self;
        (tried.first, tried.series.tries) = (Some(first), 0);
        finish(self.system, self.t, tried.settle(), &self.reach, &mut |_, _| {}).x
    }

    /// Changes the rates by impulses along some constraints.
    pub(super) fn push(&mut self, response: &Response<T, N>, along: u8, impulses: &[T; MAX_CONSTRAINTS]) {
        super::held::add(&mut self.x, response, along, impulses);
        for n in bits(along) {
            self.impulses[n] += impulses[n];
        }
    }
}

impl<T: Float> Blow<T> {
    fn none() -> Self {
        let none = [T::default(); MAX_CONSTRAINTS];
        Self {
            members: 0,
            pushing: 0,
            impulses: none,
            leaving: none,
            fastest: none,
        }
    }

    /// Adds an impact in one more group, with one restitution.
    fn add<const N: usize>(&mut self, approach: &Approach<T, N>, members: u8, restitution: T) {
        let zero = T::default();
        let impulses = impulses(&approach.matrix, members, &approach.rates, restitution);
        let fastest = bits(members).fold(zero, |fastest, n| fastest.max(approach.rates[n].abs()));
        self.members |= members;
        for n in bits(members) {
            self.pushing |= u8::from(impulses[n] != zero) << n;
            self.impulses[n] = impulses[n];
            self.leaving[n] = -restitution * approach.rates[n];
            self.fastest[n] = fastest;
        }
    }
}
