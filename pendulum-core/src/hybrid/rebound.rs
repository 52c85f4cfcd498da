//! Rebounds that are too low to be followed: they end at once, after the time for which they would last.

use super::MOST;
use super::complementarity::{Factored, independent};
use super::held::called;
use super::mode::{Status, bits, set_of};
use super::next_mode::Next;
use super::resolution::{CONSISTENT, LOWEST_REBOUND, SHORTEST_REBOUND, ulps};
use super::settling::Settling;
use crate::real::Float;

/// Rebounds that are lower than this part of the size of all positions are not followed, should it resolve lower ones.
const LEAST: f64 = 1e-13;
/// How many rebounds are summed at most, and up to which part of their sum.
const MOST_FOLLOWED: usize = 1000;
const LAST_REBOUND: f64 = 1e-9;

/// How a constraint leaves its limit, and how fast it falls back.
#[derive(Clone, Copy, Debug)]
struct Rebound<T> {
    /// The constraint.
    of: usize,
    /// Its speed away from the limit.
    rate: T,
    /// Its acceleration back to it.
    fall: T,
}

impl<T: Float> Rebound<T> {
    /// Whether it rises no further than `least`, or is back at its limit within the time `shortest`.
    fn is_low(&self, least: T, shortest: T) -> bool {
        let two = T::from_f64(2.0);
        self.rate * self.rate <= two * self.fall * least || two * self.rate.abs() <= self.fall * shortest
    }

    /// The time until it is back at its limit, from a height above it.
    fn time_back(&self, height: T) -> T {
        let square = self.rate * self.rate + T::from_f64(2.0) * self.fall * height;
        (self.rate + square.sqrt()) / self.fall
    }

    /// How far it rises within a time.
    fn rise(&self, time: T) -> T {
        time * (self.rate - T::from_f64(0.5) * self.fall * time)
    }
}

/// The end of a part of a flight in which accelerations are constant.
#[derive(Clone, Copy, Debug)]
enum End {
    /// A constraint is back at its limit.
    Back(usize),
    /// A rate that friction brakes is zero, as at the top of a flight.
    Stop(usize),
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// Stops some constraints that touch their limits, together with all that rests there.
    pub(super) fn halt(&mut self, low: u8) {
        self.resting |= low;
        let response = self.system.response(self.t, &self.x, &[T::default(); MOST]);
        let rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
        let solved = independent(&response.matrix, self.resting & self.touched());
        let impulses = Factored::of(&response.matrix, solved).solve_negated(&rates);
        self.push(&response, solved, &impulses);
    }

    /// How those of some constraints rebound that fall back.
    fn rebounds(&self, of: u8, accelerations: &[T; MOST]) -> impl Iterator<Item = Rebound<T>> + Clone {
        let measures = self.system.measures(self.t, &self.x);
        bits(of).filter_map(move |n| {
            let (rate, fall) = (self.away(n) * measures[n][1], -self.away(n) * accelerations[n]);
            (fall > T::default()).then_some(Rebound { of: n, rate, fall })
        })
    }

    /// The constraints that leave their limits in rebounds too low to be followed.
    pub(super) fn low_rebounds(&self, accelerations: &[T; MOST]) -> u8 {
        let leaving = self.touched() & !self.resting;
        if leaving == 0 {
            return 0;
        }
        let sizes = self.sizes();
        let shortest = ulps(SHORTEST_REBOUND, self.t.abs());
        let least = T::from_f64(LEAST).max(ulps(LOWEST_REBOUND, T::from_f64(1.0)));
        let is_low = |rebound: &Rebound<T>| {
            let (law, n) = (&self.laws[rebound.of], rebound.of);
            let limit = if self.touching[n] == Status::Low {
                law.low
            } else {
                law.high
            };
            let size = limit.map_or(self.reach[n], |limit| self.reach[n].max(limit.abs()));
            rebound.is_low(least * size.max(sizes.values[n]), shortest)
        };
        set_of(
            self.rebounds(leaving, accelerations)
                .filter(is_low)
                .map(|rebound| rebound.of),
        )
    }

    /// How long rebounds last that are so low that accelerations change by contacts and by friction alone, with all that
    /// follow them.
    ///
    /// They shrink to nothing: where one contact takes off alone and comes to do so again, in a fixed ratio.
    pub(super) fn lasting(&self, low: u8, mut next: Next<T>) -> T {
        let zero = T::default();
        let (limits, sizes) = (*self, self.sizes());
        let (mut after, mut flying, mut heights) = (*self, low, [zero; MOST]);
        after.series.follow_one_order();
        let (mut lasted, mut alone) = (zero, None);
        for _ in 0..MOST_FOLLOWED {
            let rebounds = Settling { x: after.x, ..limits };
            let rebounds = rebounds.rebounds(flying, &next.accelerations);
            let takes_off = |of: &Rebound<T>| flying == 1 << of.of && heights[of.of] == zero;
            if let Some(rebound) = rebounds.clone().next().filter(takes_off) {
                match alone {
                    Some((of, rate, since)) if of == rebound.of => {
                        let lost = T::from_f64(1.0) - rebound.rate / rate;
                        // where no energy is lost there is no limit
                        let is_some = lost * rate > ulps(CONSISTENT, sizes.rates[of]);
                        return if is_some { since + (lasted - since) / lost } else { zero };
                    }
                    Some(_) => {}
                    None => alone = Some((rebound.of, rebound.rate, lasted)),
                }
            }
            let back = rebounds
                .clone()
                .map(|rebound| (rebound.time_back(heights[rebound.of]), End::Back(rebound.of)));
            let first = back.reduce(|a, b| if b.0 < a.0 { b } else { a });
            let Some(first) = first.filter(|(time, _)| *time > T::from_f64(LAST_REBOUND) * lasted) else {
                return lasted;
            };
            let stops = after.stops(&next);
            let (time, end) = stops.fold(first, |a, b| if b.0 < a.0 { b } else { a });
            lasted += time;
            rebounds.for_each(|rebound| heights[rebound.of] += rebound.rise(time));
            let rates = called::rhs(self.system, &next.hold, self.t, &after.x);
            for k in N / 2..N {
                after.x[k] += time * rates[k];
            }
            for n in bits(flying) {
                after.touching[n] = Status::Free;
            }
            match end {
                End::Back(n) => {
                    heights[n] = zero;
                    after.touching[n] = limits.touching[n];
                    after.collide_to_the_end();
                }
                End::Stop(n) => after.rest(n, true),
            }
            after.stand();
            next = after.next_mode();
            after.resting = next.hold.held;
            let rates = self.system.measures(self.t, &after.x).map(|[_, rate]| rate);
            let leaves = |&n: &usize| limits.away(n) * rates[n] > zero;
            let again = bits(after.touched() & !after.resting).filter(leaves);
            flying = set_of(bits(flying).filter(|&n| heights[n] != zero)) | set_of(again);
        }
        lasted
    }

    /// When rates that friction brakes come to rest under constant accelerations.
    fn stops(&self, next: &Next<T>) -> impl Iterator<Item = (T, End)> {
        let measures = self.system.measures(self.t, &self.x);
        let slips = |status: Status| matches!(status, Status::Forward | Status::Backward);
        let slipping = (0..MOST).filter(move |&n| slips(next.mode.0[n]));
        slipping.filter_map(move |n| {
            let time = -measures[n][1] / next.accelerations[n];
            (time > T::default()).then_some((time, End::Stop(n)))
        })
    }

    /// All impacts that follow each other at once.
    fn collide_to_the_end(&mut self) {
        self.series.begin();
        loop {
            self.collide();
            self.stand();
            if self.next().is_empty() || self.series.is_too_long() {
                return;
            }
        }
    }
}
