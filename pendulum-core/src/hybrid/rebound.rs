//! Rebounds that are too low to be followed: they end at once, after the time for which they would last.

use super::MOST;
use super::complementarity::{Factored, independent};
use super::held::called;
use super::mode::{Hold, Status, bits, set_of};
use super::resolution::{LOWEST_REBOUND, SHORTEST_REBOUND, ulps};
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

    /// Those of some constraints whose rebounds are too low to be followed, for the sizes of their values.
    pub(super) fn low_rebounds(&self, of: u8, accelerations: &[T; MOST], sizes: &[T; MOST]) -> u8 {
        let shortest = ulps(SHORTEST_REBOUND, self.t.abs());
        let least = T::from_f64(LEAST).max(ulps(LOWEST_REBOUND, T::from_f64(1.0)));
        let low = self
            .rebounds(of, accelerations)
            .filter(|rebound| rebound.is_low(least * sizes[rebound.of], shortest));
        set_of(low.map(|rebound| rebound.of))
    }

    /// How long rebounds last that are so low that accelerations change by contacts alone, with all that follow them.
    ///
    /// They shrink to nothing: where one contact takes off alone and comes to do so again, in a fixed ratio.
    pub(super) fn lasting(&self, low: u8, mut hold: Hold<T>, mut accelerations: [T; MOST]) -> T {
        let zero = T::default();
        let (mut after, mut flying, mut heights) = (*self, low, [zero; MOST]);
        let (mut lasted, mut alone) = (zero, None);
        for _ in 0..MOST_FOLLOWED {
            let rebounds = after.rebounds(flying, &accelerations);
            let takes_off = |of: &Rebound<T>| flying == 1 << of.of && heights[of.of] == zero;
            if let Some(rebound) = rebounds.clone().next().filter(takes_off) {
                match alone {
                    Some((of, rate, since)) if of == rebound.of => {
                        // where no energy is lost there is no limit
                        let lost = T::from_f64(1.0) - rebound.rate / rate;
                        return if lost > zero {
                            since + (lasted - since) / lost
                        } else {
                            zero
                        };
                    }
                    Some(_) => {}
                    None => alone = Some((rebound.of, rebound.rate, lasted)),
                }
            }
            let times = rebounds
                .clone()
                .map(|rebound| (rebound.of, rebound.time_back(heights[rebound.of])));
            let first = times.reduce(|a, b| if b.1 < a.1 { b } else { a });
            let Some((hit, time)) = first.filter(|(_, time)| *time > T::from_f64(LAST_REBOUND) * lasted) else {
                return lasted;
            };
            lasted += time;
            rebounds.for_each(|rebound| heights[rebound.of] += rebound.rise(time));
            heights[hit] = zero;
            let rates = called::rhs(self.system, &hold, self.t, &after.x);
            for k in N / 2..N {
                after.x[k] += time * rates[k];
            }
            let thrown_off = after.hit(hit, flying);
            after.stand();
            (_, hold, accelerations) = after.next_mode();
            let again = after
                .rebounds(thrown_off & !after.resting, &accelerations)
                .filter(|rebound| rebound.rate > zero);
            flying = flying & !(1 << hit) | set_of(again.map(|rebound| rebound.of));
        }
        lasted
    }

    /// The impact where one of the constraints that fly is back at its limit: those that leave theirs.
    fn hit(&mut self, back: usize, flying: u8) -> u8 {
        let touching = self.touching;
        for n in bits(flying).filter(|&n| n != back) {
            self.touching[n] = Status::Free;
        }
        let thrown_off = self.collide();
        self.touching = touching;
        thrown_off
    }
}
