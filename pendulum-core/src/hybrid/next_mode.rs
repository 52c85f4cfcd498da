//! Which mode begins: combinations of what holds and what goes are tried, those that hold most first.

use super::complementarity::{Factored, depends, independent, subsets};
use super::mode::{Hold, Mode, Status, bits, set_of};
use super::resolution::{CONSISTENT, ulps};
use super::settling::Settling;
use super::{MOST, Response};
use crate::real::Float;

/// What gave way is pushed on by this part of what acts on it: shortly after, it is.
const PUSHED_ON: f64 = 1e-6;

/// A mode that begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Next<T> {
    pub(super) mode: Mode,
    pub(super) hold: Hold<T>,
    /// The accelerations of the constraints.
    pub(super) accelerations: [T; MOST],
    /// The sizes of the terms of which these are sums.
    pub(super) sizes: [T; MOST],
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// The mode that the rates and accelerations ask for.
    pub(super) fn next_mode(&self) -> Next<T> {
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
        let consistent = ulps(CONSISTENT, T::from_f64(1.0));
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
        let size = |n: usize| {
            let under = |m: usize| response.matrix[n][m].abs() * self.laws[m].sticking;
            bits(candidates).fold(response.accelerations[n].abs(), |sum, m| sum + under(m))
        };
        Next {
            mode,
            hold,
            accelerations,
            sizes: core::array::from_fn(size),
        }
    }

    /// What a constraint does that is held.
    fn holding(&self, n: usize) -> Status {
        if self.touching[n].touches() {
            self.touching[n]
        } else {
            Status::Stuck
        }
    }

    pub(super) fn slipping(&self, n: usize, status: Status) -> T {
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
