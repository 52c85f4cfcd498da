//! Choice of the next mode by trying combinations of held and moving constraints, beginning with the most held ones.

use super::complementarity::{depends, independent, solve_negated, subsets};
use super::kinematics::Kinematics;
use super::mode::{Mode, Status, bits, set_of};
use super::resolution::CONSISTENT;
use super::settling::Settling;
use super::sizes::ForceSizes;
use super::{Hold, MAX_CONSTRAINTS, Response};
use crate::real::{Float, ulps};

/// Push on a constraint that gave way, relative to the forces on it: it stands for the growth of the force shortly
/// after.
const PUSHED_ON: f64 = 1e-6;

/// The next mode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Next<T> {
    pub(super) mode: Mode,
    pub(super) hold: Hold<T>,
    /// Accelerations of the constraints.
    pub(super) accelerations: [T; MAX_CONSTRAINTS],
    pub(super) sizes: ForceSizes<T>,
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// Finds the mode consistent with the rates and accelerations.
    pub(super) fn next_mode(&self) -> Next<T> {
        let choice = ModeChoice::of(self);
        let consistent = ulps(CONSISTENT, T::from_f64(1.0));
        let gave_way = set_of((0..MAX_CONSTRAINTS).filter(|&n| self.forced[n].is_some()));
        let nothing_held = (choice.mode, choice.holding_nothing());
        let mut best = (T::from_f64(f64::INFINITY), nothing_held, choice.response.accelerations);
        'all: for held in subsets(choice.candidates & !gave_way) {
            for forward in subsets(choice.candidates & !held) {
                let Some(tried) = choice.with(held, forward) else {
                    continue;
                };
                let (violation, accelerations) = choice.violation(&tried.0, &tried.1);
                if violation < best.0 {
                    best = (violation, tried, accelerations);
                }
                if violation <= consistent {
                    break 'all;
                }
            }
        }
        let (_, (mut mode, mut hold), accelerations) = best;
        // friction that depends on held constraints rests with them, under its present force, unless it is about to
        // slip
        for n in bits(choice.candidates & !hold.held).filter(|&n| self.has_friction(n)) {
            let (mut with, mut holds) = (mode, hold);
            with.0[n] = self.holding(n);
            holds.held |= 1 << n;
            if depends(&choice.response.matrix, n, hold.solved) && choice.violation(&with, &holds).0 <= consistent {
                (mode, hold) = (with, holds);
            }
        }
        Next {
            mode,
            hold,
            accelerations,
            sizes: choice.force_sizes(),
        }
    }

    /// Status of a constraint while it is held.
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

    /// Sizes of the terms that sum up to the accelerations of the constraints.
    pub(super) fn sizes_of_accelerations(&self, response: &Response<T, N>) -> [T; MAX_CONSTRAINTS] {
        let mut of_accelerations = self.x;
        for k in Kinematics::of(self.system).rates() {
            of_accelerations[k] = response.rates[k];
        }
        self.gains.sizes(self.system, self.t, &of_accelerations).rates
    }
}

/// Data for the choice of the next mode.
struct ModeChoice<'a, 'b, T, const N: usize> {
    of: &'a Settling<'b, T, N>,
    /// Resting constraints: each may be held, or start to move.
    candidates: u8,
    /// Statuses of all other constraints, with their forces.
    mode: Mode,
    forces: [T; MAX_CONSTRAINTS],
    /// Response to these forces.
    response: Response<T, N>,
    /// Sizes of the terms that sum up to its accelerations.
    sizes: [T; MAX_CONSTRAINTS],
}

impl<'a, 'b, T: Float, const N: usize> ModeChoice<'a, 'b, T, N> {
    fn of(of: &'a Settling<'b, T, N>) -> Self {
        let zero = T::default();
        let measures = of.system.measures(of.t, &of.x);
        let (mut mode, mut candidates, mut forces) = (Mode::default(), 0, [zero; MAX_CONSTRAINTS]);
        for n in 0..of.system.constraints().len() {
            let rate = measures[n][1];
            let rests = of.resting & 1 << n != 0 || rate == zero;
            if rests && (of.has_friction(n) || of.touching[n].touches()) {
                candidates |= 1 << n;
            } else if of.has_friction(n) {
                mode.0[n] = if rate > zero { Status::Forward } else { Status::Backward };
                forces[n] = of.slipping(n, mode.0[n]);
            }
        }
        let response = of.system.response(of.t, &of.x, &forces);
        let terms = of.sizes_of_accelerations(&response);
        Self {
            of,
            candidates,
            mode,
            forces,
            sizes: core::array::from_fn(|n| terms[n].max(response.accelerations[n].abs())),
            response,
        }
    }

    fn holding_nothing(&self) -> Hold<T> {
        Hold {
            forces: self.forces,
            ..Hold::default()
        }
    }

    /// Mode in which some of the candidates are held, and some of the others move forward. None if a limit blocks a
    /// motion.
    fn with(&self, held: u8, forward: u8) -> Option<(Mode, Hold<T>)> {
        let (of, mut mode, mut hold) = (self.of, self.mode, self.holding_nothing());
        for n in bits(held) {
            mode.0[n] = of.holding(n);
        }
        for n in bits(self.candidates & !held) {
            let (goes, blocked) = if forward & 1 << n != 0 {
                (Status::Forward, Status::High)
            } else {
                (Status::Backward, Status::Low)
            };
            if of.touching[n] == blocked || of.forced[n].is_some_and(|forced| forced != goes) {
                return None;
            }
            mode.0[n] = if of.has_friction(n) { goes } else { Status::Free };
            hold.forces[n] = of.slipping(n, mode.0[n]);
        }
        (hold.held, hold.solved) = (held, independent(&self.response.matrix, held));
        Some((mode, hold))
    }

    /// Violation of the consistency conditions by a mode, relative to the forces and accelerations, and the
    /// accelerations.
    fn violation(&self, mode: &Mode, hold: &Hold<T>) -> (T, [T; MAX_CONSTRAINTS]) {
        let zero = T::default();
        let (of, matrix) = (self.of, &self.response.matrix);
        let (mut accelerations, mut sizes) = (self.response.accelerations, self.sizes);
        let mut under = |accelerations: &mut [T; MAX_CONSTRAINTS], forces: &dyn Fn(usize) -> T| {
            for n in 0..of.system.constraints().len() {
                for m in bits(self.candidates) {
                    let change = matrix[n][m] * forces(m);
                    accelerations[n] += change;
                    sizes[n] += change.abs();
                }
            }
        };
        let pushed_on = |m: usize| {
            let size = (self.response.accelerations[m].abs() / matrix[m][m]).max(of.laws[m].sticking);
            let on = size * T::from_f64(PUSHED_ON);
            of.forced[m].map_or(zero, |way| if way == Status::Forward { on } else { -on })
        };
        under(&mut accelerations, &|m| hold.forces[m] - self.forces[m] + pushed_on(m));
        let unknown = solve_negated(matrix, hold.solved, &accelerations);
        under(&mut accelerations, &|m| unknown[m]);
        let mut worst = zero;
        for n in bits(self.candidates) {
            let (law, force) = (&of.laws[n], unknown[n]);
            let of_acceleration = sizes[n].max(T::MIN_POSITIVE);
            let of_force = (sizes[n] / matrix[n][n]).max(law.sticking).max(T::MIN_POSITIVE);
            let violation = match mode.0[n] {
                status if status.is_held() => {
                    // a limit pushes without bound
                    let forward = if status == Status::Low {
                        zero
                    } else {
                        force - law.sticking
                    };
                    let backward = if status == Status::High {
                        zero
                    } else {
                        -force - law.sticking
                    };
                    (forward.max(backward) / of_force).max(accelerations[n].abs() / of_acceleration)
                }
                Status::Forward => -accelerations[n] / of_acceleration,
                Status::Backward => accelerations[n] / of_acceleration,
                _ => -of.away(n) * accelerations[n] / of_acceleration,
            };
            worst = worst.max(violation);
        }
        (worst, accelerations)
    }

    /// Sizes of accelerations and forces, including possible friction.
    fn force_sizes(&self) -> ForceSizes<T> {
        let matrix = &self.response.matrix;
        let of_friction = |n: usize, m: usize| matrix[n][m].abs() * self.of.laws[m].sticking;
        let size = |n: usize| bits(self.candidates).fold(self.sizes[n], |sum, m| sum + of_friction(n, m));
        let accelerations = core::array::from_fn(size);
        ForceSizes {
            accelerations,
            forces: core::array::from_fn(|n| match matrix[n][n] {
                inverse_mass if inverse_mass > T::default() => accelerations[n] / inverse_mass,
                _ => T::default(),
            }),
        }
    }
}
