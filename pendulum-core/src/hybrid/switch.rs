//! What happens where a mode ends, and which one begins.

use nalgebra::SVector;

use super::complementarity::{Factored, depends, impulses, independent, subsets};
use super::functions::{BACKWARD, FORWARD, Fired, UPPER, sizes};
use super::held::{add, called, pin};
use super::mode::{Hold, Mode, Status, bits, set_of};
use super::watch::Watch;
use super::{Hybrid, Law, MOST, Response};
use crate::error::Reason;
use crate::real::Float;
#[cfg(feature = "std")]
use crate::system::System;

/// Values this many ulps of the state's size about a limit are at it, where an integration starts.
const AT_LIMIT_ULPS: f64 = 64.0;
/// Rebounds that are lower than this part of the size of all positions are not followed.
const LEAST_REBOUND: f64 = 1e-13;
/// How many of them are summed at most, and up to which part of their sum.
const MOST_FOLLOWED: usize = 1000;
const LAST_REBOUND: f64 = 1e-9;
/// Nor are those followed that last no longer than so many ulps of the time.
const LEAST_ULPS: f64 = 1024.0;
/// Forces and accelerations are consistent to this many ulps of theirs.
const CONSISTENT_ULPS: f64 = 64.0;
/// What gave way is pushed on by this part of what acts on it: shortly after, it is.
const PUSHED_ON: f64 = 1e-6;

/// The state and the mode from which to go on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settled<T, const N: usize> {
    pub(crate) x: SVector<T, N>,
    pub(crate) mode: Mode,
    pub(crate) hold: Hold<T>,
    /// How long rebounds that are not followed would still last.
    pub(crate) delay: T,
    /// The impulses along the constraints.
    pub(crate) impulses: [T; MOST],
}

/// The mode in which to start from a state.
pub(crate) fn start<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    t: T,
    x: &SVector<T, N>,
) -> Result<Settled<T, N>, Reason> {
    let mut settling = Settling::new(system, t, x);
    let size = x.iter().fold(T::from_f64(1.0), |size, x| size.max(x.abs()));
    let slack = T::from_f64(AT_LIMIT_ULPS) * T::EPSILON * size;
    let measures = system.measures(t, x);
    for (n, constraint) in system.constraints().iter().enumerate() {
        for (distance, limit, status) in settling.distances(n, &measures) {
            if distance.to_f64().is_nan() || distance < -slack {
                let (value, limit) = (measures[n][0].to_f64(), limit.to_f64());
                let constraint = constraint.name;
                return Err(Reason::BeyondLimit {
                    constraint,
                    value,
                    limit,
                });
            }
            settling.touch(n, status, distance <= slack, measures[n][1].abs() <= slack);
        }
        settling.rest(n, measures[n][1] == T::default());
    }
    Ok(settling.settle(&[T::default(); MOST]))
}

/// The right-hand side at a state, in the mode in which a hybrid system starts from it.
#[cfg(feature = "std")]
pub(crate) fn rate<S, T, const N: usize>(system: &S, t: T, x: &SVector<T, N>) -> Result<SVector<T, N>, Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    match system.hybrid() {
        Some(hybrid) => Ok(system.rhs_in(&start(hybrid, t, x)?.hold, t, x)),
        None => Ok(system.rhs(t, x)),
    }
}

/// The mode after the one that ended.
pub(crate) fn switch<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    (t, x): (T, &SVector<T, N>),
    mode: &Mode,
    fired: Fired,
    watch: &Watch<T>,
) -> Settled<T, N> {
    let mut settling = Settling::new(system, t, x);
    let measures = system.measures(t, x);
    let sizes = sizes(system, &settling.laws, t, x);
    for n in 0..system.constraints().len() {
        let status = mode.0[n];
        if status.touches() {
            settling.touching[n] = status;
        }
        settling.rest(n, status.is_held());
        if status.is_held() {
            for (way, next) in [(FORWARD, Status::Forward), (BACKWARD, Status::Backward)] {
                if fired.has(n, way) {
                    settling.forced[n] = Some(next);
                }
            }
        } else {
            settling.rest(n, fired.has(n, FORWARD));
            let slack = T::from_f64(AT_LIMIT_ULPS) * T::EPSILON * sizes[n];
            // what stands at a limit because something else holds it there, or arrives at the same time
            for (distance, _, status) in settling.distances(n, &measures) {
                let rate = measures[n][1];
                let leaving = if status == Status::Low { rate } else { -rate };
                settling.touch(
                    n,
                    status,
                    distance.abs() <= slack && leaving <= slack,
                    rate.abs() <= slack,
                );
            }
            for (way, next) in [(BACKWARD, Status::Low), (UPPER, Status::High)] {
                if fired.has(n, way) {
                    settling.touching[n] = next;
                }
            }
        }
    }
    settling.settle(&watch.reach)
}

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

/// A state on its way to the next mode.
#[derive(Clone, Copy)]
struct Settling<'a, T, const N: usize> {
    system: &'a dyn Hybrid<T, N>,
    laws: [Law<T>; MOST],
    t: T,
    x: SVector<T, N>,
    /// The limits that constraints touch: `Low`, `High`, or else `Free`.
    touching: [Status; MOST],
    /// The constraints whose rates are zero.
    resting: u8,
    /// What those must do that gave way.
    forced: [Option<Status>; MOST],
    /// The impulses so far.
    impulses: [T; MOST],
}

impl<'a, T: Float, const N: usize> Settling<'a, T, N> {
    fn new(system: &'a dyn Hybrid<T, N>, t: T, x: &SVector<T, N>) -> Self {
        Self {
            system,
            laws: system.laws(),
            t,
            x: *x,
            touching: [Status::Free; MOST],
            resting: 0,
            forced: [None; MOST],
            impulses: [T::default(); MOST],
        }
    }

    fn rest(&mut self, n: usize, rests: bool) {
        self.resting |= u8::from(rests) << n;
    }

    /// How far from each of its limits a constraint is, the limit, and what it is there.
    fn distances(&self, n: usize, measures: &[[T; 2]; MOST]) -> impl Iterator<Item = (T, T, Status)> + use<T, N> {
        let (law, value) = (&self.laws[n], measures[n][0]);
        let low = law.low.map(|low| (value - low, low, Status::Low));
        let high = law.high.map(|high| (high - value, high, Status::High));
        [low, high].into_iter().flatten()
    }

    fn touch(&mut self, n: usize, status: Status, touches: bool, rests: bool) {
        if touches {
            self.touching[n] = status;
            self.rest(n, rests);
        }
    }

    /// 1 at a lower limit, -1 at an upper one, 0 elsewhere: the direction away from it.
    fn away(&self, n: usize) -> T {
        T::from_f64(match self.touching[n] {
            Status::Low => 1.0,
            Status::High => -1.0,
            _ => 0.0,
        })
    }

    fn has_friction(&self, n: usize) -> bool {
        self.laws[n].sticking > T::default()
    }

    fn settle(mut self, reach: &[T; MOST]) -> Settled<T, N> {
        self.place_at_limits();
        self.stand();
        let thrown_off = self.collide();
        let mut delay = T::default();
        let sizes = sizes(self.system, &self.laws, self.t, &self.x);
        loop {
            self.stand();
            let (mode, hold, accelerations) = self.next_mode();
            // rebounds too low to be followed, of their own or where another contact was hit
            let shortest = T::from_f64(LEAST_ULPS) * T::EPSILON * self.t.abs();
            let low = self
                .rebounds(thrown_off & !self.resting, &accelerations)
                .filter(|rebound| {
                    let least = T::from_f64(LEAST_REBOUND) * reach[rebound.of].max(sizes[rebound.of]);
                    rebound.is_low(least, shortest)
                });
            let low = set_of(low.map(|rebound| rebound.of));
            if low == 0 {
                return Settled {
                    x: self.x,
                    mode,
                    hold,
                    delay,
                    impulses: self.impulses,
                };
            }
            delay = delay.max(self.lasting(low, hold, accelerations));
            self.halt(low);
        }
    }

    /// Stops some constraints that touch their limits, together with all that rests there.
    fn halt(&mut self, low: u8) {
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

    /// How long rebounds last that are so low that accelerations change by contacts alone, with all that follow them.
    ///
    /// They shrink to nothing: where one contact takes off alone and comes to do so again, in a fixed ratio.
    fn lasting(&self, low: u8, mut hold: Hold<T>, mut accelerations: [T; MOST]) -> T {
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

    /// The constraints that touch a limit.
    fn touched(&self) -> u8 {
        set_of((0..MOST).filter(|&n| self.touching[n].touches()))
    }

    /// Moves what touches a limit to it, coordinates to the last bit; what rests stays.
    fn place_at_limits(&mut self) {
        let constraints = self.system.constraints();
        if bits(self.touched()).any(|n| constraints[n].rate.is_empty()) {
            let response = self.system.response(self.t, &self.x, &[T::default(); MOST]);
            let solved = independent(&response.matrix, self.touched() | self.resting);
            let apart = self.apart();
            shift(&mut self.x, N / 2, &response, solved, &apart);
        }
        let apart = self.apart();
        for n in bits(self.touched()) {
            if let Some(&(component, sign)) = constraints[n].rate.last() {
                self.x[component - N / 2] -= T::from_f64(f64::from(sign)) * apart[n];
            }
        }
    }

    /// How far from its limit each constraint is that touches one.
    fn apart(&self) -> [T; MOST] {
        apart(&self.laws, &self.touching, &self.system.measures(self.t, &self.x))
    }

    /// Makes the rates of all that rests zero: whichever of it is held next, none of the rest moves by that.
    fn stand(&mut self) {
        pin(self.system, self.resting, &mut self.x);
        let constraints = self.system.constraints();
        if bits(self.resting).any(|n| constraints[n].rate.is_empty()) {
            let response = self.system.response(self.t, &self.x, &[T::default(); MOST]);
            let solved = independent(&response.matrix, self.resting);
            let rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
            shift(&mut self.x, 0, &response, solved, &rates);
            // what the rest of it holds rests too
            let sizes = sizes(self.system, &self.laws, self.t, &self.x);
            for (n, [_, rate]) in self.system.measures(self.t, &self.x).into_iter().enumerate() {
                let slack = T::from_f64(AT_LIMIT_ULPS) * T::EPSILON * sizes[n];
                let rests = n < constraints.len() && rate.abs() <= slack;
                self.rest(n, rests && depends(&response.matrix, n, solved));
            }
            pin(self.system, self.resting, &mut self.x);
        }
    }

    /// Impacts at the limits that are touched: the constraints that leave theirs.
    fn collide(&mut self) -> u8 {
        let zero = T::default();
        let count = self.system.constraints().len();
        let touching = self.touched();
        let mut rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
        for n in bits(self.resting) {
            rates[n] = zero;
        }
        let leaving: [T; MOST] = core::array::from_fn(|n| self.away(n) * rates[n]);
        let approaching = bits(touching).filter(|&n| leaving[n] < zero);
        let restitution = approaching.map(|n| {
            let law = &self.laws[n];
            if -leaving[n] < law.slow { zero } else { law.restitution }
        });
        // the least, so that energy does not grow
        let Some(restitution) = restitution.reduce(T::min) else {
            return 0;
        };
        let response = self.system.response(self.t, &self.x, &[zero; MOST]);
        let mut matrix = response.matrix;
        for (n, row) in matrix.iter_mut().enumerate() {
            for (m, entry) in row.iter_mut().enumerate() {
                *entry *= self.away(n) * self.away(m);
            }
        }
        let pushes = impulses(&matrix, touching, &leaving, restitution);
        let pushes: [T; MOST] = core::array::from_fn(|n| self.away(n) * pushes[n]);
        self.push(&response, touching, &pushes);
        for n in 0..count {
            let change = bits(touching).fold(zero, |sum, m| sum + response.matrix[n][m] * pushes[m]);
            if pushes[n] != zero && restitution == zero {
                self.resting |= 1 << n;
            } else if pushes[n] != zero || change != zero {
                self.resting &= !(1 << n);
            }
        }
        // what an impulse has only held keeps a rate of rounding
        let fastest = bits(touching).fold(zero, |fastest, n| fastest.max(leaving[n].abs()));
        let slack = T::from_f64(CONSISTENT_ULPS) * T::EPSILON * fastest;
        let measures = self.system.measures(self.t, &self.x);
        for n in bits(touching).filter(|&n| pushes[n] != zero) {
            self.rest(n, measures[n][1].abs() <= slack);
        }
        touching & !self.resting
    }

    /// Changes the rates by impulses along some constraints.
    fn push(&mut self, response: &Response<T, N>, along: u8, impulses: &[T; MOST]) {
        add(&mut self.x, response, along, impulses);
        for n in bits(along) {
            self.impulses[n] += impulses[n];
        }
    }

    /// The mode that the rates and accelerations ask for, and the accelerations in it.
    fn next_mode(&self) -> (Mode, Hold<T>, [T; MOST]) {
        let zero = T::default();
        let count = self.system.constraints().len();
        let measures = self.system.measures(self.t, &self.x);
        let (mut mode, mut candidates) = (Mode::default(), 0);
        let mut forces = [zero; MOST];
        for n in 0..count {
            let (friction, touches) = (self.has_friction(n), self.touching[n].touches());
            let rate = measures[n][1];
            let rests = self.resting & 1 << n != 0 || rate == zero;
            if rests && (friction || touches) {
                candidates |= 1 << n;
            } else if friction {
                mode.0[n] = if rate > zero { Status::Forward } else { Status::Backward };
                forces[n] = self.slipping(n, mode.0[n]);
            }
        }
        let response = self.system.response(self.t, &self.x, &forces);
        let gave_way = set_of((0..count).filter(|&n| self.forced[n].is_some()));
        let without_any = Hold {
            forces,
            ..Hold::default()
        };
        let consistent = T::from_f64(CONSISTENT_ULPS) * T::EPSILON;
        let mut best = (T::from_f64(f64::INFINITY), mode, without_any, response.accelerations);
        'all: for held in subsets(candidates & !gave_way) {
            let released = candidates & !held;
            for forward in subsets(released) {
                let Some((mode, hold)) = self.released(mode, forces, (held, released, forward), &response) else {
                    continue;
                };
                let (violation, accelerations) = self.violation(&mode, &hold, candidates, &response, &forces);
                if violation < best.0 {
                    best = (violation, mode, hold, accelerations);
                }
                if violation <= consistent {
                    break 'all;
                }
            }
        }
        let (_, mut mode, mut hold, accelerations) = best;
        // friction that depends on what is held rests with it, under the force that it has, unless all is about to move
        for n in bits(candidates & !hold.held).filter(|&n| self.has_friction(n)) {
            let (mut with, mut holds) = (mode, hold);
            with.0[n] = self.holding(n);
            holds.held |= 1 << n;
            if depends(&response.matrix, n, hold.solved)
                && self.violation(&with, &holds, candidates, &response, &forces).0 <= consistent
            {
                (mode, hold) = (with, holds);
            }
        }
        (mode, hold, accelerations)
    }

    /// What a constraint does that is held.
    fn holding(&self, n: usize) -> Status {
        if self.touching[n].touches() {
            self.touching[n]
        } else {
            Status::Stuck
        }
    }

    fn slipping(&self, n: usize, status: Status) -> T {
        T::from_f64(f64::from(status.friction())) * self.laws[n].slipping
    }

    /// A mode in which some of the candidates are held, and others go forward or backward; none where a limit is in
    /// the way.
    fn released(
        &self,
        mut mode: Mode,
        mut forces: [T; MOST],
        (held, released, forward): (u8, u8, u8),
        response: &Response<T, N>,
    ) -> Option<(Mode, Hold<T>)> {
        for n in bits(held) {
            mode.0[n] = self.holding(n);
        }
        for n in bits(released) {
            let goes = if forward & 1 << n != 0 {
                Status::Forward
            } else {
                Status::Backward
            };
            let blocked = match goes {
                Status::Forward => Status::High,
                _ => Status::Low,
            };
            if self.touching[n] == blocked || self.forced[n].is_some_and(|forced| forced != goes) {
                return None;
            }
            mode.0[n] = if self.has_friction(n) { goes } else { Status::Free };
            forces[n] = self.slipping(n, mode.0[n]);
        }
        let solved = independent(&response.matrix, held);
        Some((mode, Hold { forces, held, solved }))
    }

    /// How far a mode is from being consistent, relative to the forces and accelerations at hand; the accelerations.
    fn violation(
        &self,
        mode: &Mode,
        hold: &Hold<T>,
        candidates: u8,
        response: &Response<T, N>,
        before: &[T; MOST],
    ) -> (T, [T; MOST]) {
        let zero = T::default();
        let matrix = &response.matrix;
        let mut accelerations = response.accelerations;
        let mut sizes = accelerations.map(|a| a.abs());
        let mut under = |accelerations: &mut [T; MOST], forces: &dyn Fn(usize) -> T| {
            for n in 0..MOST {
                for m in bits(candidates) {
                    let change = matrix[n][m] * forces(m);
                    accelerations[n] += change;
                    sizes[n] += change.abs();
                }
            }
        };
        let pushed_on = |m: usize| {
            let size = (response.accelerations[m].abs() / matrix[m][m]).max(self.laws[m].sticking);
            let on = size * T::from_f64(PUSHED_ON);
            self.forced[m].map_or(zero, |way| if way == Status::Forward { on } else { -on })
        };
        under(&mut accelerations, &|m| hold.forces[m] - before[m] + pushed_on(m));
        let unknown = Factored::of(matrix, hold.solved).solve_negated(&accelerations);
        under(&mut accelerations, &|m| unknown[m]);
        let mut worst = zero;
        for n in bits(candidates) {
            let (law, force) = (&self.laws[n], unknown[n]);
            let of_acceleration = sizes[n].max(T::MIN_POSITIVE);
            // the force that such accelerations take
            let of_force = (sizes[n] / matrix[n][n]).max(law.sticking).max(T::MIN_POSITIVE);
            let violation = match mode.0[n] {
                status if status.is_held() => {
                    let beyond = |excess: T| excess / of_force;
                    let forward = if status == Status::Low {
                        zero
                    } else {
                        beyond(force - law.sticking)
                    };
                    let backward = if status == Status::High {
                        zero
                    } else {
                        beyond(-force - law.sticking)
                    };
                    forward.max(backward).max(accelerations[n].abs() / of_acceleration)
                }
                Status::Forward => -accelerations[n] / of_acceleration,
                Status::Backward => accelerations[n] / of_acceleration,
                _ => -self.away(n) * accelerations[n] / of_acceleration,
            };
            worst = worst.max(violation);
        }
        (worst, accelerations)
    }
}

/// Moves a state to where it is held: each position to its limit, each rate to zero.
pub(crate) fn project<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    hold: &Hold<T>,
    mode: &Mode,
    t: T,
    x: &mut SVector<T, N>,
) {
    pin(system, hold.held, x);
    let constraints = system.constraints();
    if bits(hold.held).all(|n| !constraints[n].rate.is_empty()) {
        return;
    }
    let laws = system.laws();
    let response = system.response(t, x, &hold.forces);
    // the second time for what is quadratic in the first
    for _ in 0..2 {
        let measures = system.measures(t, x);
        shift(x, N / 2, &response, hold.solved, &apart(&laws, &mode.0, &measures));
        let rates = system.measures(t, x).map(|[_, rate]| rate);
        shift(x, 0, &response, hold.solved, &rates);
    }
    pin(system, hold.held, x);
}

/// How far from its limit each constraint is that touches one.
pub(crate) fn apart<T: Float>(
    laws: &[Law<T>; MOST],
    touching: &[Status; MOST],
    measures: &[[T; 2]; MOST],
) -> [T; MOST] {
    core::array::from_fn(|n| {
        let limit = match touching[n] {
            Status::Low => laws[n].low,
            Status::High => laws[n].high,
            _ => None,
        };
        limit.map_or(T::default(), |limit| measures[n][0] - limit)
    })
}

/// Takes what some constraints have off positions or rates, which stand so far `before` the rates: a column holds what
/// a force does to the rates, and along it the least kinetic energy moves.
fn shift<T: Float, const N: usize>(
    x: &mut SVector<T, N>,
    before: usize,
    response: &Response<T, N>,
    solved: u8,
    surplus: &[T; MOST],
) {
    let moves = Factored::of(&response.matrix, solved).solve_negated(surplus);
    for n in bits(solved) {
        for component in N / 2..N {
            x[component - before] += response.columns[n][component] * moves[n];
        }
    }
}
