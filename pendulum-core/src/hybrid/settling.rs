//! A state on its way to the next mode: what touches its limit collides, what rests stands, and low rebounds end.

use nalgebra::SVector;

use super::complementarity::{depends, groups, impulses, independent};
use super::functions::sizes;
use super::held::{add, pin};
use super::mode::{Status, bits, set_of};
use super::project::{apart, shift};
use super::resolution::{AT_LIMIT, CONSISTENT, ulps};
use super::switch::Settled;
use super::{Hybrid, Law, MOST, Response};
use crate::real::Float;

/// A state on its way to the next mode.
#[derive(Clone, Copy)]
pub(super) struct Settling<'a, T, const N: usize> {
    pub(super) system: &'a dyn Hybrid<T, N>,
    pub(super) laws: [Law<T>; MOST],
    pub(super) t: T,
    pub(super) x: SVector<T, N>,
    /// The limits that constraints touch: `Low`, `High`, or else `Free`.
    pub(super) touching: [Status; MOST],
    /// The constraints whose rates are zero.
    pub(super) resting: u8,
    /// What those must do that gave way.
    pub(super) forced: [Option<Status>; MOST],
    /// The impulses so far.
    pub(super) impulses: [T; MOST],
    /// By how much more than positions the constraints change, where the integration began: only the order matters.
    pub(super) slopes: [T; MOST],
}

impl<'a, T: Float, const N: usize> Settling<'a, T, N> {
    pub(super) fn new(system: &'a dyn Hybrid<T, N>, t: T, x: &SVector<T, N>, slopes: [T; MOST]) -> Self {
        Self {
            system,
            laws: system.laws(),
            t,
            x: *x,
            touching: [Status::Free; MOST],
            resting: 0,
            forced: [None; MOST],
            impulses: [T::default(); MOST],
            slopes,
        }
    }

    /// The size of each constraint, to which its rounding errors are relative.
    pub(super) fn sizes(&self) -> [T; MOST] {
        let sizes = sizes(self.system, &self.laws, self.t, &self.x);
        core::array::from_fn(|n| sizes[n] * self.slopes[n])
    }

    pub(super) fn rest(&mut self, n: usize, rests: bool) {
        self.resting |= u8::from(rests) << n;
    }

    /// How far from each of its limits a constraint is, the limit, and what it is there.
    pub(super) fn distances(
        &self,
        n: usize,
        measures: &[[T; 2]; MOST],
    ) -> impl Iterator<Item = (T, T, Status)> + use<T, N> {
        let (law, value) = (&self.laws[n], measures[n][0]);
        let low = law.low.map(|low| (value - low, low, Status::Low));
        let high = law.high.map(|high| (high - value, high, Status::High));
        [low, high].into_iter().flatten()
    }

    pub(super) fn touch(&mut self, n: usize, status: Status, touches: bool, rests: bool) {
        if touches {
            self.touching[n] = status;
            self.rest(n, rests);
        }
    }

    /// 1 at a lower limit, -1 at an upper one, 0 elsewhere: the direction away from it.
    pub(super) fn away(&self, n: usize) -> T {
        T::from_f64(match self.touching[n] {
            Status::Low => 1.0,
            Status::High => -1.0,
            _ => 0.0,
        })
    }

    pub(super) fn has_friction(&self, n: usize) -> bool {
        self.laws[n].sticking > T::default()
    }

    pub(super) fn settle(mut self, reach: &[T; MOST]) -> Settled<T, N> {
        self.place_at_limits();
        self.stand();
        let thrown_off = self.collide();
        let mut delay = T::default();
        let sizes = self.sizes();
        let sizes = core::array::from_fn(|n| reach[n].max(sizes[n]));
        loop {
            self.stand();
            let (mode, hold, accelerations) = self.next_mode();
            let low = self.low_rebounds(thrown_off & !self.resting, &accelerations, &sizes);
            if low == 0 {
                return Settled {
                    x: self.x,
                    mode,
                    hold,
                    delay,
                    impulses: self.impulses,
                    slopes: self.slopes,
                };
            }
            delay = delay.max(self.lasting(low, hold, accelerations));
            self.halt(low);
        }
    }

    /// The constraints that touch a limit.
    pub(super) fn touched(&self) -> u8 {
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
    pub(super) fn stand(&mut self) {
        pin(self.system, self.resting, &mut self.x);
        let constraints = self.system.constraints();
        if bits(self.resting).any(|n| constraints[n].rate.is_empty()) {
            let response = self.system.response(self.t, &self.x, &[T::default(); MOST]);
            let solved = independent(&response.matrix, self.resting);
            let rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
            shift(&mut self.x, 0, &response, solved, &rates);
            // what the rest of it holds rests too
            let sizes = self.sizes();
            for (n, [_, rate]) in self.system.measures(self.t, &self.x).into_iter().enumerate() {
                let slack = ulps(AT_LIMIT, sizes[n]);
                let rests = n < constraints.len() && rate.abs() <= slack;
                self.rest(n, rests && depends(&response.matrix, n, solved));
            }
            pin(self.system, self.resting, &mut self.x);
        }
    }

    /// Impacts at the limits that are touched: the constraints that leave theirs.
    pub(super) fn collide(&mut self) -> u8 {
        let zero = T::default();
        let count = self.system.constraints().len();
        let touching = self.touched();
        let mut rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
        for n in bits(self.resting) {
            rates[n] = zero;
        }
        let leaving: [T; MOST] = core::array::from_fn(|n| self.away(n) * rates[n]);
        let approaching = set_of(bits(touching).filter(|&n| leaving[n] < zero));
        if approaching == 0 {
            return 0;
        }
        let response = self.system.response(self.t, &self.x, &[zero; MOST]);
        let mut matrix = response.matrix;
        for (n, row) in matrix.iter_mut().enumerate() {
            for (m, entry) in row.iter_mut().enumerate() {
                *entry *= self.away(n) * self.away(m);
            }
        }
        let (mut pushes, mut slack) = ([zero; MOST], [zero; MOST]);
        let (mut collided, mut stopped) = (0, 0);
        for group in groups(&matrix, touching) {
            let restitution = bits(group & approaching).map(|n| {
                let law = &self.laws[n];
                if -leaving[n] < law.slow { zero } else { law.restitution }
            });
            // the least, so that energy does not grow
            let Some(restitution) = restitution.reduce(T::min) else {
                continue;
            };
            collided |= group;
            let of_group = impulses(&matrix, group, &leaving, restitution);
            let fastest = bits(group).fold(zero, |fastest, n| fastest.max(leaving[n].abs()));
            for n in bits(group).filter(|&n| of_group[n] != zero) {
                pushes[n] = self.away(n) * of_group[n];
                stopped |= u8::from(restitution == zero) << n;
                slack[n] = ulps(CONSISTENT, fastest);
            }
        }
        self.push(&response, collided, &pushes);
        for n in 0..count {
            let change = bits(collided).fold(zero, |sum, m| sum + response.matrix[n][m] * pushes[m]);
            if stopped & 1 << n != 0 {
                self.resting |= 1 << n;
            } else if pushes[n] != zero || change != zero {
                self.resting &= !(1 << n);
            }
        }
        // what an impulse has only held keeps a rate of rounding
        let measures = self.system.measures(self.t, &self.x);
        for n in bits(collided).filter(|&n| pushes[n] != zero) {
            self.rest(n, measures[n][1].abs() <= slack[n]);
        }
        collided & !self.resting
    }

    /// Changes the rates by impulses along some constraints.
    pub(super) fn push(&mut self, response: &Response<T, N>, along: u8, impulses: &[T; MOST]) {
        add(&mut self.x, response, along, impulses);
        for n in bits(along) {
            self.impulses[n] += impulses[n];
        }
    }
}
