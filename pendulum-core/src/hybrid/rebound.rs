//! Rebounds too low to be followed: they end at once, after the time that they would last.

use super::MAX_CONSTRAINTS;
use super::complementarity::{independent, solve_negated};
use super::held::rhs;
use super::kinematics::Kinematics;
use super::mode::{Status, bits, set_of};
use super::next_mode::Next;
use super::resolution::{CONSISTENT, LOWEST_REBOUND, SHORTEST_REBOUND};
use super::settling::Settling;
use crate::real::{Float, ulps};

/// Height below which rebounds are not followed, relative to the size of the positions, unless rounding errors resolve
/// less.
const LEAST: f64 = 1e-13;
/// Maximum number of rebounds summed up.
const MOST_FOLLOWED: usize = 1000;
/// Duration of the last rebound summed up, relative to the sum.
const LAST_REBOUND: f64 = 1e-9;

/// Motion of a constraint that leaves its limit and falls back.
#[derive(Clone, Copy, Debug)]
struct Rebound<T> {
    /// Index of the constraint.
    of: usize,
    /// Speed away from the limit.
    rate: T,
    /// Acceleration back to the limit.
    fall: T,
}

impl<T: Float> Rebound<T> {
    /// True if it rises no higher than `least`, or returns to its limit within the time `shortest`.
    fn is_low(&self, least: T, shortest: T) -> bool {
        let two = T::from_f64(2.0);
        self.rate * self.rate <= two * self.fall * least || two * self.rate.abs() <= self.fall * shortest
    }

    /// Time of the return to the limit, from a height above it.
    fn time_back(&self, height: T) -> T {
        let square = self.rate * self.rate + T::from_f64(2.0) * self.fall * height;
        (self.rate + square.sqrt()) / self.fall
    }

    /// Change of height within a time.
    fn rise(&self, time: T) -> T {
        time * (self.rate - T::from_f64(0.5) * self.fall * time)
    }
}

/// End of a phase of a flight with constant accelerations.
#[derive(Clone, Copy, Debug)]
enum End {
    /// A constraint is back at its limit.
    Back(usize),
    /// A rate braked by friction reaches zero, as at the top of a flight.
    Stop(usize),
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// Stops some constraints at their limits, together with all that rest there.
    pub(super) fn halt(&mut self, low: u8) {
        self.resting |= low;
        let response = self.system.response(self.t, &self.x, &[T::default(); MAX_CONSTRAINTS]);
        let rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
        let solved = independent(&response.matrix, self.resting & self.touched());
        let impulses = solve_negated(&response.matrix, solved, &rates);
        self.push(&response, solved, &impulses);
    }

    /// Rebounds of those constraints among `of` that fall back.
    fn rebounds(
        &self,
        of: u8,
        accelerations: &[T; MAX_CONSTRAINTS],
    ) -> impl Iterator<Item = Rebound<T>> + Clone + use<T, N> {
        let measures = self.system.measures(self.t, &self.x);
        let motions: [_; MAX_CONSTRAINTS] =
            core::array::from_fn(|n| (self.away(n) * measures[n][1], -self.away(n) * accelerations[n]));
        bits(of).filter_map(move |n| {
            let (rate, fall) = motions[n];
            (fall > T::default()).then_some(Rebound { of: n, rate, fall })
        })
    }

    /// Constraints that leave their limits in rebounds too low to be followed.
    pub(super) fn low_rebounds(&self, accelerations: &[T; MAX_CONSTRAINTS]) -> u8 {
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

    /// Duration of low rebounds and of all rebounds after them. They are so low that only contacts and friction change
    /// the accelerations.
    ///
    /// Rebounds shrink to nothing, in a fixed ratio once one contact repeatedly takes off alone: that gives a geometric
    /// series.
    pub(super) fn lasting(&self, low: u8, next: Next<T>) -> T {
        let mut flight = Flight::of(self, low, next);
        let mut alone: Option<(Rebound<T>, T)> = None;
        for _ in 0..MOST_FOLLOWED {
            let rebounds = flight.rebounds();
            match (flight.takes_off_alone(rebounds.clone()), alone) {
                (Some(again), Some((first, since))) if again.of == first.of => {
                    let lost = T::from_f64(1.0) - again.rate / first.rate;
                    // without a loss of energy the series has no limit
                    let is_some = lost * first.rate > ulps(CONSISTENT, self.sizes().rates[first.of]);
                    let sum = since + (flight.lasted - since) / lost;
                    return if is_some { sum } else { T::default() };
                }
                (Some(first), None) => alone = Some((first, flight.lasted)),
                _ => {}
            }
            if !flight.goes_on(rebounds) {
                break;
            }
        }
        flight.lasted
    }

    /// Times at which rates braked by friction reach zero under constant accelerations.
    fn stops(&self, next: &Next<T>) -> impl Iterator<Item = (T, End)> {
        let measures = self.system.measures(self.t, &self.x);
        let slips = |status: Status| matches!(status, Status::Forward | Status::Backward);
        let slipping = (0..MAX_CONSTRAINTS).filter(move |&n| slips(next.mode.0[n]));
        slipping.filter_map(move |n| {
            let time = -measures[n][1] / next.accelerations[n];
            (time > T::default()).then_some((time, End::Stop(n)))
        })
    }

    /// Applies all impacts that follow each other at once.
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

/// Low rebounds in progress.
struct Flight<'a, T, const N: usize> {
    /// State at the beginning, with all limits of the rebounds.
    limits: Settling<'a, T, N>,
    now: Settling<'a, T, N>,
    next: Next<T>,
    /// Constraints above their limits.
    flying: u8,
    /// Heights above the limits.
    heights: [T; MAX_CONSTRAINTS],
    /// Time since the beginning.
    lasted: T,
}

impl<'a, T: Float, const N: usize> Flight<'a, T, N> {
    fn of(limits: &Settling<'a, T, N>, flying: u8, next: Next<T>) -> Self {
        let mut now = *limits;
        now.series.follow_one_order();
        Self {
            limits: *limits,
            now,
            next,
            flying,
            heights: [T::default(); MAX_CONSTRAINTS],
            lasted: T::default(),
        }
    }

    fn rebounds(&self) -> impl Iterator<Item = Rebound<T>> + Clone + use<T, N> {
        let now = Settling {
            x: self.now.x,
            ..self.limits
        };
        now.rebounds(self.flying, &self.next.accelerations)
    }

    /// The rebound that begins, if it is the only one.
    fn takes_off_alone(&self, mut rebounds: impl Iterator<Item = Rebound<T>>) -> Option<Rebound<T>> {
        let first = rebounds.next()?;
        (self.flying == 1 << first.of && self.heights[first.of] == T::default()).then_some(first)
    }

    /// Follows the rebounds until a constraint returns to its limit or a rate comes to rest. Returns false if nothing
    /// returns, or in no time.
    fn goes_on(&mut self, rebounds: impl Iterator<Item = Rebound<T>> + Clone) -> bool {
        let zero = T::default();
        let back = rebounds
            .clone()
            .map(|rebound| (rebound.time_back(self.heights[rebound.of]), End::Back(rebound.of)));
        let earlier = |a: (T, End), b: (T, End)| if b.0 < a.0 { b } else { a };
        let first = back.reduce(earlier);
        let Some(first) = first.filter(|(time, _)| *time > T::from_f64(LAST_REBOUND) * self.lasted) else {
            return false;
        };
        let (time, end) = self.now.stops(&self.next).fold(first, earlier);
        self.lasted += time;
        rebounds.for_each(|rebound| self.heights[rebound.of] += rebound.rise(time));
        let now = &mut self.now;
        let rates = rhs(now.system, &self.next.hold, now.t, &now.x);
        for k in Kinematics::of(now.system).rates() {
            now.x[k] += time * rates[k];
        }
        for n in bits(self.flying) {
            now.touching[n] = Status::Free;
        }
        match end {
            End::Back(n) => {
                self.heights[n] = zero;
                now.touching[n] = self.limits.touching[n];
                now.collide_to_the_end();
            }
            End::Stop(n) => now.rest(n, true),
        }
        now.stand();
        self.next = now.next_mode();
        now.resting = self.next.hold.held;
        let rates = now.system.measures(now.t, &now.x).map(|[_, rate]| rate);
        let leaves = |&n: &usize| self.limits.away(n) * rates[n] > zero;
        let again = bits(now.touched() & !now.resting).filter(leaves);
        self.flying = set_of(bits(self.flying).filter(|&n| self.heights[n] != zero)) | set_of(again);
        true
    }
}
